//! The loop of all kernels over slices.

use crate::batch;
use crate::dispatch::{Backend, Kernel};
use crate::error::ShapeError;
use crate::place::{Layout, Number, Place, Register, Step};
use dq8_simd::Level;

/// What becomes of the elements of a slice, lanes at a time.
pub(super) trait Operation<Q: Place<D>, const D: usize> {
    /// Whether it is in place.
    fn reads_output(&self) -> bool {
        false
    }

    /// What belongs to a step, see [`Place`]; `output` is what the slice holds so far.
    fn compute<V: Level>(
        &self,
        level: V,
        output: &[Q],
        step: Step,
    ) -> Option<[Register<Q, V, D>; D]>;
}

/// From this size on, in bytes, an output is written past the caches: a line that is written whole need
/// not be read first. Products of 16-lane blocks, ns each, on a server with 2 MiB of L2 cache:
///
/// | output | AVX-512 | past the caches | AVX2 | past the caches |
/// |---|---|---|---|---|
/// | 2 MiB | 3.22 | 3.25 | 3.24 | 4.12 |
/// | 16 MiB | 3.29 | 3.34 | 3.31 | 4.21 |
/// | 64 MiB | 4.97 | 3.69 | 5.28 | 4.80 |
/// | 256 MiB | 5.96 | 4.69 | 6.46 | 5.80 |
const BEYOND_CACHES: usize = 64 << 20;

/// Writes `operation` over `output`.
#[inline]
pub(super) fn sweep<Q: Place<D>, O: Operation<Q, D>, const D: usize>(
    backend: Backend,
    output: &mut [Q],
    operation: O,
) {
    let backend = backend.min(Q::Layout::MOST);
    if size_of_val(output) >= BEYOND_CACHES && !operation.reads_output() {
        backend.run(Stream { output, operation });
    } else {
        backend.run(Sweep { output, operation });
    }
}

struct Sweep<'s, Q, O, const D: usize> {
    output: &'s mut [Q],
    operation: O,
}

impl<Q: Place<D>, O: Operation<Q, D>, const D: usize> Kernel for Sweep<'_, Q, O, D> {
    type Output = ();

    #[inline(always)]
    fn run<V: Level>(self, level: V) {
        for turn in 0..Q::turns::<V>(self.output.len()) {
            for part in 0..Q::parts::<V>() {
                let step = Step { turn, part };
                // The lengths were checked, so this always is something; the compiler need not know.
                let Some(components) = self.operation.compute(level, self.output, step) else {
                    return;
                };
                Q::scatter(components, self.output, step);
            }
        }
    }
}

/// [`Sweep`] past the caches. A kernel of its own, so that neither loop costs the other registers.
struct Stream<'s, Q, O, const D: usize> {
    output: &'s mut [Q],
    operation: O,
}

impl<Q: Place<D>, O: Operation<Q, D>, const D: usize> Kernel for Stream<'_, Q, O, D> {
    type Output = ();

    #[inline(always)]
    fn run<V: Level>(self, level: V) {
        let Self { output, operation } = self;
        Q::stream(
            level,
            output,
            #[inline(always)]
            |step| operation.compute(level, &[], step),
        );
    }
}

/// The motions of a step; the identity in lanes beyond the end of `slice`.
#[inline(always)]
pub(super) fn motions<P: Place<8>, V: Level>(
    level: V,
    slice: &[P],
    step: Step,
) -> Option<batch::DualQuat<Register<P, V, 8>>> {
    let (zero, one) = (Number::<P, 8>::default(), Number::<P, 8>::from(1.0));
    let identity = [zero, zero, zero, one, zero, zero, zero, zero];
    Some(batch::DualQuat::from_array(P::gather(level, slice, step, identity)?))
}

/// The vectors of a step; zero in lanes beyond the end of `slice`.
#[inline(always)]
pub(super) fn vectors<P: Place<3>, V: Level>(
    level: V,
    slice: &[P],
    step: Step,
) -> Option<[Register<P, V, 3>; 3]> {
    let zero = [Number::<P, 3>::default(); 3];
    P::gather(level, slice, step, zero)
}

pub(super) fn same_length(
    what: &'static str,
    length: usize,
    expected: usize,
) -> Result<(), ShapeError> {
    if length == expected { Ok(()) } else { Err(ShapeError::Length { what, length, expected }) }
}

//! The loop of all kernels over slices.

use crate::batch;
use crate::dispatch::{Backend, Kernel};
use crate::error::ShapeError;
use crate::place::{Lanes, Number, Place};
use dq8_simd::Level;

/// What becomes of the elements of a slice, lanes at a time.
pub(super) trait Operation<Q: Place<D>, const D: usize> {
    /// The elements from `at` on, as many as fill the lanes; `output` is what the slice holds so far.
    fn compute<V: Level>(&self, level: V, output: &[Q], at: usize) -> [Lanes<Q, V, D>; D];
}

/// Writes `operation` over `output`.
#[inline]
pub(super) fn sweep<Q: Place<D>, O: Operation<Q, D>, const D: usize>(
    backend: Backend,
    output: &mut [Q],
    operation: O,
) {
    backend.run(Sweep { output, operation });
}

struct Sweep<'s, Q, O, const D: usize> {
    output: &'s mut [Q],
    operation: O,
}

impl<Q: Place<D>, O: Operation<Q, D>, const D: usize> Kernel for Sweep<'_, Q, O, D> {
    type Output = ();

    #[inline(always)]
    fn run<V: Level>(self, level: V) {
        let mut at = 0;
        while at < self.output.len() {
            let components = self.operation.compute(level, self.output, at);
            Q::scatter(components, self.output.get_mut(at..).unwrap_or_default());
            at += Q::step::<V>();
        }
    }
}

/// The motions of `slice` from `at` on, as many as fill the lanes; the identity beyond its end.
#[inline(always)]
pub(super) fn motions<P: Place<8>, V: Level>(
    level: V,
    slice: &[P],
    at: usize,
) -> batch::DualQuat<Lanes<P, V, 8>> {
    let (zero, one) = (Number::<P, 8>::default(), Number::<P, 8>::from(1.0));
    let identity = [zero, zero, zero, one, zero, zero, zero, zero];
    batch::DualQuat::from_array(P::gather(level, slice.get(at..).unwrap_or_default(), identity))
}

/// The vectors of `slice` from `at` on; zero beyond its end.
#[inline(always)]
pub(super) fn vectors<P: Place<3>, V: Level>(
    level: V,
    slice: &[P],
    at: usize,
) -> [Lanes<P, V, 3>; 3] {
    let zero = [Number::<P, 3>::default(); 3];
    P::gather(level, slice.get(at..).unwrap_or_default(), zero)
}

pub(super) fn same_length(
    what: &'static str,
    length: usize,
    expected: usize,
) -> Result<(), ShapeError> {
    if length == expected { Ok(()) } else { Err(ShapeError::Length { what, length, expected }) }
}

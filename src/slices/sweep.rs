//! The loop of all kernels over slices.

use crate::backend::{Backend, Kernel};
use crate::storage::{Element, Layout, Register, Tile};
use core::ops::Range;
use dq8_simd::Level;

/// The things of a tile, a register for each component; `None` if an input ends before.
pub(super) type Things<Q, V, const D: usize> = Option<[Register<Q, V, D>; D]>;

/// A computation for each element of a slice, lanes at a time.
pub(super) trait SliceKernel<Q: Element<D>, const D: usize>: Sized + Sync {
    /// `true` if it works in place.
    fn reads_output(&self) -> bool {
        false
    }

    /// The things of a tile; `output` is what the slice holds so far.
    fn compute<V: Level>(&self, level: V, output: &[Q], tile: Tile) -> Things<Q, V, D>;

    /// The same computation for some of the elements.
    fn part(&self, elements: Range<usize>) -> Self;
}

/// Some of the elements of an input.
pub(super) fn part<T>(slice: &[T], elements: Range<usize>) -> &[T] {
    slice.get(elements).unwrap_or_default()
}

/// The fewest elements in a task: some microseconds of work, where starting a task takes a fraction
/// of one.
pub(super) const GRAIN: usize = 2048;

/// From this size on, in bytes, an output is written past the caches: a line that is written whole
/// need not be read first. Products of 16-lane blocks, ns each, on a server with 2 MiB of L2 cache:
///
/// | output | AVX-512 | past the caches | AVX2 | past the caches |
/// |---|---|---|---|---|
/// | 2 MiB | 3.22 | 3.25 | 3.24 | 4.12 |
/// | 16 MiB | 3.29 | 3.34 | 3.31 | 4.21 |
/// | 64 MiB | 4.97 | 3.69 | 5.28 | 4.80 |
/// | 256 MiB | 5.96 | 4.69 | 6.46 | 5.80 |
const BEYOND_CACHES: usize = 64 << 20;

/// Writes what `kernel` computes over `output`.
#[inline]
pub(super) fn sweep<Q: Element<D>, const D: usize>(
    backend: Backend,
    output: &mut [Q],
    kernel: impl SliceKernel<Q, D>,
) {
    let past_caches =
        Q::Layout::STREAMS && size_of_val(output) >= BEYOND_CACHES && !kernel.reads_output();
    backend.share(GRAIN, (output, 1), &|first, (output, _): (&mut [Q], usize)| {
        let kernel = kernel.part(first..first + output.len());
        // A constant too, so that there is no such kernel where none is run.
        if const { Q::Layout::STREAMS } && past_caches {
            backend.run(Stream { output, kernel });
        } else {
            backend.run(Sweep { output, kernel });
        }
    });
}

struct Sweep<'s, Q, K, const D: usize> {
    output: &'s mut [Q],
    kernel: K,
}

impl<Q: Element<D>, K: SliceKernel<Q, D>, const D: usize> Kernel for Sweep<'_, Q, K, D> {
    type Output = ();
    const WIDE: bool = Q::Layout::WIDE;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) {
        let Self { output, kernel } = self;
        let (records, registers) = (Q::Layout::records::<V>(), Q::Layout::registers::<V>());
        // Two plain loops, which the compiler unrolls over the registers of a block;
        // `storage::tiles` is one, and 5 % slower where a block has two registers.
        for i in 0..output.len().div_ceil(records) {
            for register in 0..registers {
                let tile = Tile::at(i * records, register);
                // The lengths were checked, so this always is something; the compiler need not
                // know.
                let Some(components) = kernel.compute(level, output, tile) else { return };
                Q::store(components, output, tile);
            }
        }
    }
}

/// [`Sweep`] past the caches. A kernel of its own, so that neither loop costs the other registers.
struct Stream<'s, Q, K, const D: usize> {
    output: &'s mut [Q],
    kernel: K,
}

impl<Q: Element<D>, K: SliceKernel<Q, D>, const D: usize> Kernel for Stream<'_, Q, K, D> {
    type Output = ();
    const WIDE: bool = Q::Layout::WIDE;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) {
        let Self { output, kernel } = self;
        Q::stream(
            level,
            output,
            #[cfg_attr(not(opt_level_0), inline(always))]
            |tile| kernel.compute(level, &[], tile),
        );
    }
}

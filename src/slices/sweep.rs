//! The loop that all kernels over slices share.

use crate::backend::{Backend, Kernel};
use crate::storage::{Element, Layout, Register, Tile};
use core::ops::Range;
use dq8_simd::Level;

/// The records of a tile, with a register for each of their `D` components; `None` if an input ends
/// before the tile.
pub(super) type Things<Q, V, const D: usize> = Option<[Register<Q, V, D>; D]>;

/// A computation of each element of a slice, on as many elements at a time as there are lanes.
pub(super) trait SliceKernel<Q: Element<D>, const D: usize>: Sized + Sync {
    /// The number of tiles of plain records that are computed for one test of all lengths. A loop
    /// over more than one tile is compiled beside the loop that ends a slice, so it is worth its
    /// size only where the tests are a large part of the work: for points on NEON, which loads and
    /// stores them by one instruction each, they are a fifth of all instructions.
    const TILES: usize = if D <= 3 && cfg!(target_arch = "aarch64") { 2 } else { 1 };
    /// `true` if the kernel works in place, so that `compute` reads `output`.
    fn reads_output(&self) -> bool {
        false
    }

    /// Computes the records of a tile. A kernel that works in place reads its input from `output`,
    /// the output slice, in which earlier tiles are already written.
    fn compute<V: Level>(&self, level: V, output: &[Q], tile: Tile) -> Things<Q, V, D>;

    /// Returns the same computation for the elements of a range alone; `None` if an input ends
    /// before the range does.
    fn part(&self, elements: Range<usize>) -> Option<Self>;
}

/// The fewest elements in a task. They are some microseconds of work, and starting a task takes a
/// fraction of a microsecond.
pub(super) const GRAIN: usize = 2048;

/// The size in bytes from which an output is written past the caches. A cache line that is written
/// whole need not be read first. The table has the nanoseconds of a product in 16-lane blocks, on a
/// server with 2 MiB of L2 cache:
///
/// | output | AVX-512 | past the caches | AVX2 | past the caches |
/// |---|---|---|---|---|
/// | 2 MiB | 3.22 | 3.25 | 3.24 | 4.12 |
/// | 16 MiB | 3.29 | 3.34 | 3.31 | 4.21 |
/// | 64 MiB | 4.97 | 3.69 | 5.28 | 4.80 |
/// | 256 MiB | 5.96 | 4.69 | 6.46 | 5.80 |
const BEYOND_CACHES: usize = 64 << 20;

/// Computes every element of `output` by `kernel`, on the threads of `backend`.
#[inline]
pub(super) fn sweep<Q: Element<D>, const D: usize>(
    backend: Backend,
    output: &mut [Q],
    kernel: impl SliceKernel<Q, D>,
) {
    let past_caches =
        Q::Layout::STREAMS && size_of_val(output) >= BEYOND_CACHES && !kernel.reads_output();
    backend.share(GRAIN, (output, 1), &|first, (output, _): (&mut [Q], usize)| {
        let Some(kernel) = kernel.part(first..first + output.len()) else { return };
        // `STREAMS` is tested as a constant too, so that layouts that cannot be written past the
        // caches compile no second kernel.
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
        let Self { mut output, kernel } = self;
        let (records, registers) = (Q::Layout::records::<V>(), Q::Layout::registers::<V>());
        // The inputs are as long as the output, as the callers check, but the compiler sees no
        // check here. It sees that the parts have the length of the output, and therefore tests one
        // length for each tile instead of one for each slice. On a single lane the parts would take
        // more code than the tests. In blocks the tests keep all loads before the stores: without
        // them the compiler mixes both, and spills.
        let mut kernel = if Q::Layout::transposes::<V>() {
            let Some(kernel) = kernel.part(0..output.len()) else { return };
            kernel
        } else {
            kernel
        };
        if const { K::TILES > 1 } && Q::Layout::transposes::<V>() {
            let several = const { K::TILES } * records;
            // The output must be longer than these tiles, because a load of points may read the
            // number after the last point.
            while output.len() > several {
                for i in 0..const { K::TILES } {
                    let tile = Tile::at(i * records, 0);
                    let Some(components) = kernel.compute(level, output, tile) else { return };
                    Q::store(components, output, tile);
                }
                let Some(rest) = kernel.part(several..output.len()) else { return };
                (output, kernel) = (output.split_at_mut(several).1, rest);
            }
        }
        // Two plain loops, because the compiler unrolls the inner one over the registers of a
        // block. The iterator `storage::tiles` is a single loop, which is 5 % slower where a block
        // has two registers.
        for i in 0..output.len().div_ceil(records) {
            for register in 0..registers {
                let tile = Tile::at(i * records, register);
                let Some(components) = kernel.compute(level, output, tile) else { return };
                Q::store(components, output, tile);
            }
        }
    }
}

/// [`Sweep`] with writes past the caches. It is a kernel of its own, so that neither loop takes
/// registers from the other.
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

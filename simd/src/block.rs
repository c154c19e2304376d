//! [`Block`]: a block of AoSoA memory, with one row per component.
//!
//! A block needs no transpose: one load reads component `c` of all lanes. Kernels over blocks are
//! therefore the fastest. If a row is longer than a register, a kernel computes one part of the
//! block after the other. A part is one register of each component ([`Native`]), so that all
//! components of a part fit into the registers together.

use crate::lanes::{Float, Lanes, Level};
use bytemuck::{Pod, Zeroable};
use core::fmt::Debug;

/// A block of `C` components for each of [`Row::LANES`] lanes: row `c` holds component `c` of all
/// lanes.
///
/// ```text
///              lane 0  lane 1  …  lane 7
/// component 0    x₀      x₁          x₇
/// component 1    y₀      y₁          y₇
///     …
/// ```
///
/// Eight components of eight `f32` are 256 bytes, which are exactly four cache lines. A block is
/// aligned to a cache line, so no load of a register crosses from one cache line to the next.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C, align(64))]
pub struct Block<A, const C: usize>(
    /// The rows, one per component.
    pub [A; C],
);

// SAFETY: `Zeroable` needs zero bytes to be a valid value. `A: Row` implies `A: Pod`, so zeros are
// a valid row. The padding that the alignment adds after the rows may have any bytes.
unsafe impl<A: Row, const C: usize> Zeroable for Block<A, C> {}

/// Implements `Pod` for blocks without padding, so that they can be cast to slices of `f32` or
/// `f64` (for a GPU, say). Rows have 16, 32 or 64 bytes, so 4, 8, 12 or 16 rows of any length fill
/// whole cache lines. Other counts of rows fill them only if the rows are long enough.
macro_rules! without_padding {
    ($($count:literal of any;)*) => {$(
        without_padding! { $count of f32 4, f32 8, f32 16, f64 2, f64 4, f64 8; }
    )*};
    ($($count:literal of $($real:ident $lanes:literal),*;)*) => {$($(
        const _: () = assert!(
            size_of::<Block<[$real; $lanes], $count>>() == $count * size_of::<[$real; $lanes]>()
        );
        // SAFETY: the block is an array of floats, for which any bits are valid, and the assertion
        // above shows that the alignment adds no padding.
        unsafe impl Pod for Block<[$real; $lanes], $count> {}
    )*)*};
}
without_padding! { 4 of any; 12 of any; 16 of any; }
without_padding! {
    1 of f32 16, f64 8;
    2 of f32 8, f32 16, f64 4, f64 8;
    3 of f32 16, f64 8;
    6 of f32 8, f32 16, f64 4, f64 8;
    7 of f32 16, f64 8;
}

// SAFETY: `Row` is sealed, and its implementors are arrays of floats, of 16, 32 or 64 bytes. Eight
// rows fill whole cache lines, so the alignment adds no padding, and any bits are valid floats.
unsafe impl<A: Row> Pod for Block<A, 8> {}

impl<A: Row, const C: usize> Block<A, C> {
    /// Makes a block with `record`, one value per component, in every lane.
    #[inline]
    #[must_use]
    pub fn splat(record: [A::Real; C]) -> Self {
        Self(record.map(|value| {
            let mut row = A::zeroed();
            row.as_mut().fill(value);
            row
        }))
    }

    /// Returns the `C` components of `lane`, or `None` if the block has no such lane.
    #[inline]
    #[must_use]
    pub fn get(&self, lane: usize) -> Option<[A::Real; C]> {
        (lane < A::LANES).then(|| self.0.map(|row| row.as_ref()[lane]))
    }

    /// Writes the `C` components of `lane`.
    ///
    /// # Errors
    /// Returns `record` if the block has no such lane.
    #[inline]
    pub fn set(&mut self, lane: usize, record: [A::Real; C]) -> Result<(), [A::Real; C]> {
        if lane >= A::LANES {
            return Err(record);
        }
        for (row, value) in self.0.iter_mut().zip(record) {
            row.as_mut()[lane] = value;
        }
        Ok(())
    }

    /// Loads all lanes of every component.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn load<V: Level>(&self, level: V) -> [A::Lanes<V>; C] {
        // This is a loop and not a call of `map`: a closure that is not inlined would be compiled
        // without the instructions of the level.
        let mut components = [A::Lanes::<V>::splat(level, A::Real::default()); C];
        for (component, row) in components.iter_mut().zip(&self.0) {
            *component = A::Lanes::<V>::load(level, row);
        }
        components
    }

    /// Returns the count of registers that a row fills, which is the count of parts of the block.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn parts<V: Level>() -> usize {
        A::LANES / Native::<A, V>::LANES
    }

    /// Loads one register of each component: the lanes of part `part`. They are zeros if the block
    /// has no such part.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn load_part<V: Level>(&self, level: V, part: usize) -> [Native<A, V>; C] {
        let mut components = [Native::<A, V>::splat(level, A::Real::default()); C];
        for (component, row) in components.iter_mut().zip(&self.0) {
            let parts: &[<Native<A, V> as Lanes>::Array] =
                bytemuck::cast_slice(core::slice::from_ref(row));
            if let Some(array) = parts.get(part) {
                *component = Native::<A, V>::load(level, array);
            }
        }
        components
    }

    /// Stores one register of each component to part `part`. Does nothing if the block has no such
    /// part.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn store_part<V: Level>(&mut self, components: [Native<A, V>; C], part: usize) {
        // The two loops do the same, but the first consumes `components` and the second borrows it.
        // In the first loop the compiler would keep registers of 16 bytes on the stack. With the
        // second loop it would schedule the code before the loop worse if registers are larger.
        if size_of::<Native<A, V>>() > 16 {
            for (row, component) in self.0.iter_mut().zip(components) {
                if let Some(array) = part_of::<A, V>(row, part) {
                    component.store(array);
                }
            }
        } else {
            for (row, component) in self.0.iter_mut().zip(&components) {
                if let Some(array) = part_of::<A, V>(row, part) {
                    component.store(array);
                }
            }
        }
    }

    /// Copies `rows`, one array per component, to part `part`. Does nothing if the block has no
    /// such part.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn copy_part<V: Level>(&mut self, rows: &[<Native<A, V> as Lanes>::Array], part: usize) {
        for (row, from) in self.0.iter_mut().zip(rows) {
            if let Some(array) = part_of::<A, V>(row, part) {
                *array = *from;
            }
        }
    }

    /// Fills the blocks of `to` with non-temporal stores, which bypass the caches.
    /// `each(block, part)` computes part `part` of the block with index `block`, and its first
    /// `None` ends the loop. This is faster than [`store_part`](Self::store_part) if `to` is larger
    /// than the caches, and slower if `to` fits in them.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn stream<V: Level>(
        level: V,
        to: &mut [Self],
        mut each: impl FnMut(usize, usize) -> Option<[Native<A, V>; C]>,
    ) {
        /// A guard that calls [`Level::fence`] when it is dropped, and so also when `each` panics.
        struct Fence<V: Level>(V);
        impl<V: Level> Drop for Fence<V> {
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn drop(&mut self) {
                self.0.fence();
            }
        }
        let _fence = Fence(level);
        for (index, block) in to.iter_mut().enumerate() {
            for part in 0..Self::parts::<V>() {
                let Some(components) = each(index, part) else { return };
                for (row, component) in block.0.iter_mut().zip(components) {
                    if let Some(array) = part_of::<A, V>(row, part) {
                        // SAFETY: `stream` needs a fence before other code uses the memory. `to` is
                        // mutably borrowed until `_fence` is dropped, which runs the fence.
                        unsafe { component.stream(array) };
                    }
                }
            }
        }
    }

    /// Stores all lanes of every component.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn store<V: Level>(&mut self, components: [A::Lanes<V>; C]) {
        for (row, component) in self.0.iter_mut().zip(components) {
            component.store(row);
        }
    }
}

/// Returns the memory of one register in a row: part `part`, or `None` if the row has no such part.
#[cfg_attr(not(opt_level_0), inline(always))]
fn part_of<A: Row, V: Level>(
    row: &mut A,
    part: usize,
) -> Option<&mut <Native<A, V> as Lanes>::Array> {
    let parts: &mut [_] = bytemuck::cast_slice_mut(core::slice::from_mut(row));
    parts.get_mut(part)
}

/// A row of a [`Block`], `[f32; N]` or `[f64; N]`, with the lanes that load it.
///
/// The trait is sealed, because the unsafe implementations of `Pod` for blocks rely on rows being
/// arrays of floats of at least 16 bytes.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no row of a block",
    note = "a row has 4, 8 or 16 numbers of `f32`, or 2, 4 or 8 of `f64`: as in `Block<f32, 8>` and `Crowd::<f64, 4>`"
)]
pub trait Row:
    Pod + Send + Sync + AsRef<[Self::Real]> + AsMut<[Self::Real]> + Debug + sealed::Sealed
{
    /// The element type.
    type Real: Float;
    /// The lanes of the level `V` that hold one row.
    type Lanes<V: Level>: Lanes<Real = Self::Real, Level = V, Array = Self>;
    /// The length of a row, which is its lane count.
    const LANES: usize;
}

/// The lanes of one register of the level `V`: all lanes of a row, or one part of them if the row
/// fills several registers.
pub type Native<A, V> = <<A as Row>::Lanes<V> as Lanes>::Native;

mod sealed {
    pub trait Sealed {}
}

/// Rows of four are implemented for every [`Float`], so that the package `proofs` can make blocks
/// of its own element type.
impl<R: Float> sealed::Sealed for [R; 4] {}
impl<R: Float> Row for [R; 4] {
    type Real = R;
    type Lanes<V: Level> = R::Half<V>;
    const LANES: usize = 4;
}

/// Implements [`Row`] for rows of 2, 8 and 16 elements. This is a macro, because each length of
/// rows needs another associated type of [`Level`], which no generic `impl` can name.
macro_rules! rows {
    ($($real:ty, $lanes:literal => $lane:ident;)*) => {$(
        impl sealed::Sealed for [$real; $lanes] {}
        impl Row for [$real; $lanes] {
            type Real = $real;
            type Lanes<V: Level> = V::$lane;
            const LANES: usize = $lanes;
        }
    )*};
}
rows! {
    f32, 8 => F32x8;
    f32, 16 => F32x16;
    f64, 2 => F64x2;
    f64, 8 => F64x8;
}

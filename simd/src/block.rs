//! [`Block`]: structure-of-arrays memory, one row of numbers per component.

use crate::lanes::{Float, Lanes, Level};
use bytemuck::{Pod, Zeroable};
use core::fmt::Debug;

/// `C` components of [`Row::LANES`] things: row `c` holds component `c` of all of them.
///
/// ```text
///              lane 0  lane 1  …  lane 7
/// component 0    x₀      x₁          x₇
/// component 1    y₀      y₁          y₇
///     …
/// ```
///
/// Eight components of eight `f32` are 256 bytes: four cache lines, each full of use. The alignment
/// is that of a cache line, so that no vector load ever crosses one.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C, align(64))]
pub struct Block<A, const C: usize>(
    /// The rows.
    pub [A; C],
);

// SAFETY: an array of zeroable rows, and every padding byte (there may be some for small C) may be
// zero as well.
unsafe impl<A: Row, const C: usize> Zeroable for Block<A, C> {}

/// Blocks without padding, for casts to slices of numbers (to a GPU, say). Rows are 16, 32 or 64
/// bytes, so four, eight, twelve or sixteen of any fill whole cache lines; of the longer rows,
/// other counts do as well.
macro_rules! plain {
    ($($count:literal of any;)*) => {$(
        plain! { $count of f32 4, f32 8, f32 16, f64 2, f64 4, f64 8; }
    )*};
    ($($count:literal of $($real:ident $lanes:literal),*;)*) => {$($(
        const _: () = assert!(
            size_of::<Block<[$real; $lanes], $count>>() == $count * size_of::<[$real; $lanes]>()
        );
        // SAFETY: an array of plain numbers, of which any bits are valid, and the assertion above
        // shows that the alignment adds no padding.
        unsafe impl Pod for Block<[$real; $lanes], $count> {}
    )*)*};
}
plain! { 4 of any; 12 of any; 16 of any; }
plain! {
    1 of f32 16, f64 8;
    2 of f32 8, f32 16, f64 4, f64 8;
    3 of f32 16, f64 8;
    6 of f32 8, f32 16, f64 4, f64 8;
    7 of f32 16, f64 8;
}

// SAFETY: `Row` is sealed, its implementors are plain numbers of 16, 32 or 64 bytes, so eight of
// them fill whole cache lines and the alignment adds no padding. Any bits are valid numbers.
unsafe impl<A: Row> Pod for Block<A, 8> {}

impl<A: Row, const C: usize> Block<A, C> {
    /// The same record in every lane.
    #[inline]
    #[must_use]
    pub fn splat(record: [A::Real; C]) -> Self {
        Self(record.map(|value| {
            let mut row = A::zeroed();
            row.as_mut().fill(value);
            row
        }))
    }

    /// The record in `lane`, or `None` beyond the last lane.
    #[inline]
    #[must_use]
    pub fn get(&self, lane: usize) -> Option<[A::Real; C]> {
        (lane < A::LANES).then(|| self.0.map(|row| row.as_ref()[lane]))
    }

    /// Writes the record in `lane`; gives the record back if the block has no such lane.
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

    /// All lanes of every component.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn load<V: Level>(&self, level: V) -> [A::Lanes<V>; C] {
        // No closure: one inside an inlined kernel is compiled without the kernel's instructions.
        let mut components = [A::Lanes::<V>::splat(level, A::Real::default()); C];
        for (component, row) in components.iter_mut().zip(&self.0) {
            *component = A::Lanes::<V>::load(level, row);
        }
        components
    }

    /// How many [`Native`]s a row has.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn parts<V: Level>() -> usize {
        A::LANES / Native::<A, V>::LANES
    }

    /// One part of every component; zero beyond the last part.
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

    /// One part of every component; nothing beyond the last part.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn store_part<V: Level>(&mut self, components: [Native<A, V>; C], part: usize) {
        // A loop that is handed registers of 16 bytes by value keeps them in memory; handed larger
        // ones by reference, the compiler orders what was before it worse.
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

    /// One part of every component, from memory; nothing beyond the last part.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn copy_part<V: Level>(&mut self, rows: &[<Native<A, V> as Lanes>::Array], part: usize) {
        for (row, from) in self.0.iter_mut().zip(rows) {
            if let Some(array) = part_of::<A, V>(row, part) {
                *array = *from;
            }
        }
    }

    /// Fills `to` past the caches: `each` computes one part of a block, and its first `None` ends
    /// the loop. Faster where the caches could not hold `to` anyway, slower where they could.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn stream<V: Level>(
        level: V,
        to: &mut [Self],
        mut each: impl FnMut(usize, usize) -> Option<[Native<A, V>; C]>,
    ) {
        /// Fences also if `each` panics.
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
                        // SAFETY: `to` is borrowed until the fence.
                        unsafe { component.stream(array) };
                    }
                }
            }
        }
    }

    /// All lanes of every component.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn store<V: Level>(&mut self, components: [A::Lanes<V>; C]) {
        for (row, component) in self.0.iter_mut().zip(components) {
            component.store(row);
        }
    }
}

/// A part of a row: the memory of one register.
#[cfg_attr(not(opt_level_0), inline(always))]
fn part_of<A: Row, V: Level>(
    row: &mut A,
    part: usize,
) -> Option<&mut <Native<A, V> as Lanes>::Array> {
    let parts: &mut [_] = bytemuck::cast_slice_mut(core::slice::from_mut(row));
    parts.get_mut(part)
}

/// A row of numbers in memory, `[f32; N]` or `[f64; N]`, and the lanes that read it.
///
/// Sealed: blocks rely on a row being plain numbers of at least sixteen bytes.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no row of a block",
    note = "a row has 4, 8 or 16 numbers of `f32`, or 2, 4 or 8 of `f64`: as in `Block<f32, 8>` and `Crowd::<f64, 4>`"
)]
pub trait Row:
    Pod + Send + Sync + AsRef<[Self::Real]> + AsMut<[Self::Real]> + Debug + sealed::Sealed
{
    /// The number.
    type Real: Float;
    /// The lane type of `V` that holds one row.
    type Lanes<V: Level>: Lanes<Real = Self::Real, Level = V, Array = Self>;
    /// How many numbers.
    const LANES: usize;
}

/// The lanes of one register that read a row, or a part of it.
pub type Native<A, V> = <<A as Row>::Lanes<V> as Lanes>::Native;

mod sealed {
    pub trait Sealed {}
}

/// Half a record: of every number alike, so that proofs can have blocks of numbers of their own.
impl<R: Float> sealed::Sealed for [R; 4] {}
impl<R: Float> Row for [R; 4] {
    type Real = R;
    type Lanes<V: Level> = R::Half<V>;
    const LANES: usize = 4;
}

/// One line per row type; the others have nothing in common that a generic `impl` could name.
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

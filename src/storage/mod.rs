//! How things lie in memory, and the way from there into registers and back: the only one there is.
//!
//! A *record* is the `C` numbers of one thing: a motion has 8, a point 3. A slice holds records one
//! after the other ([`Aos`], array of structures), or in [`Block`]s of `N` ([`AoSoA`], array of
//! structures of arrays): row `c` of a block holds component `c` of `N` things. Kernels compute with a
//! register for each component, a thing in each lane. So a block is read as it is, the fastest way, and
//! plain records are transposed in registers.
//!
//! | `C` | what | one record | `N` in a block |
//! |---|---|---|---|
//! | 1 | a number | `R` | [`NumberBlock`] |
//! | 3 | a point or a vector | `[R; 3]` | [`PointBlock`] |
//! | 4 | a rotation, `[x, y, z, w]` | [`Quat<R>`](crate::Quat) | [`RotationBlock`] |
//! | 6 | a twist, `[ωx, ωy, ωz, vx, vy, vz]` | [`Twist<R>`](crate::Twist) | [`TwistBlock`] |
//! | 7 | rotation and translation, `[x, y, z, w, tx, ty, tz]` | `[R; 7]` | [`RotationTranslationBlock`] |
//! | 8 | a motion, `[px, py, pz, pw, qx, qy, qz, qw]` | [`DualQuat<R>`](crate::DualQuat) | [`Block`] |
//! | 12 | a 3×4 matrix | `[[R; 4]; 3]` | [`MatrixBlock`] |
//! | 16 | a 4×4 matrix | `[[R; 4]; 4]` | `Block` of 16 rows |
//!
//! `[R; C]` is a record of any number of components. [`Element<C>`](Element) is the one bound that
//! generic code needs: it says what a slice is made of, and reads and writes it by [`Tile`]s, a register
//! for each component at a time. [`Kernel`](crate::Kernel) has an example.
//!
//! ```
//! use dq8::storage::{Element, Number};
//! use dq8::{Backend, DualQuat, ShapeError};
//!
//! /// steps[i] ← unit(steps[i])², in any layout.
//! fn twice<E: Element<8>>(steps: &mut [E]) -> Result<(), ShapeError> {
//!     let backend = Backend::best();
//!     backend.normalize_in_place(steps);
//!     let once = steps.to_vec();
//!     backend.mul_in_place(steps, &once)
//! }
//! let mut steps = [DualQuat::from_translation([1.0_f32, 0.0, 0.0]).scale(3.0); 5];
//! twice(&mut steps)?;
//! assert_eq!(steps[4].translation(), [2.0, 0.0, 0.0]);
//! # Ok::<(), ShapeError>(())
//! ```

pub(crate) mod aos;
mod blocks;
mod element;
mod packing;
mod source;

pub use aos::Aos;
pub use blocks::{
    AoSoA, Block, MatrixBlock, NumberBlock, PointBlock, RotationBlock, RotationTranslationBlock,
    TwistBlock,
};
pub use element::{Element, Number, Register};
#[cfg(feature = "alloc")]
pub(crate) use packing::{blocks_for, pack_lanes, unpack_lanes};
pub use packing::{pack, pack_chain, unpack, unpack_chain};
pub(crate) use source::Source;

use crate::real::Scalar;
use core::fmt::Debug;
use core::marker::PhantomData;
use dq8_simd::{Lanes, Level};

/// How things of any number of components lie in memory, and which registers read them: [`Aos`] or
/// [`AoSoA`]. Sealed.
///
/// A layout whose numbers in memory are not those in registers, say 16 bits each, would be another
/// implementation; no kernel would change.
pub trait Layout: Copy + Debug + sealed::Sealed {
    /// The number in a register.
    type Real: Scalar;
    /// What a slice is made of where nothing says more than the number of components: `[R; C]`, or a
    /// block.
    type Record<const C: usize>: Element<C, Layout = Self>;
    /// One register of `V`.
    type Register<V: Level>: Lanes<Real = Self::Real, Level = V>;
    /// How many things a [`Record`](Self::Record) holds.
    const THINGS: usize;
    /// Whether kernels over this layout gain from AVX-512.
    const WIDE: bool;
    /// Whether it can be written past the caches, on targets that may have more memory than caches.
    const STREAMS: bool;

    /// How many registers it takes to read one component of a record.
    #[must_use]
    #[inline(always)]
    fn registers<V: Level>() -> usize {
        (Self::THINGS / Self::Register::<V>::LANES).max(1)
    }
    /// How many records a register reads.
    #[must_use]
    #[inline(always)]
    fn records<V: Level>() -> usize {
        (Self::Register::<V>::LANES / Self::THINGS).max(1)
    }
}

/// The things that a register reads: register `register` of the block `element`; or, where a record is
/// one thing, those at `element`, `element + stride`, `element + 2·stride`, … one in each lane.
#[derive(Clone, Copy, Debug)]
pub struct Tile {
    pub(crate) element: usize,
    pub(crate) register: usize,
    /// `None` is 1, which the compiler can see.
    pub(crate) stride: Option<usize>,
}

impl Tile {
    /// The lanes of one register of the block `element`, or as many records as it reads from there on.
    #[inline(always)]
    pub(crate) fn at(element: usize, register: usize) -> Self {
        Self { element, register, stride: None }
    }
}

/// The tiles of a slice of `length` elements, in order: each is a register for each component.
#[inline(always)]
pub fn tiles<E: Element<C>, V: Level, const C: usize>(length: usize) -> impl Iterator<Item = Tile> {
    Tiles {
        next: Tile::at(0, 0),
        length,
        records: E::Layout::records::<V>(),
        registers: E::Layout::registers::<V>(),
    }
}

struct Tiles {
    next: Tile,
    length: usize,
    records: usize,
    registers: usize,
}

impl Iterator for Tiles {
    type Item = Tile;

    #[inline(always)]
    fn next(&mut self) -> Option<Tile> {
        let tile = self.next;
        if tile.element >= self.length {
            return None;
        }
        self.next.register += 1;
        if self.next.register == self.registers {
            self.next = Tile::at(tile.element + self.records, 0);
        }
        Some(tile)
    }
}

/// What fills lanes without a thing: the motion, rotation or matrix that changes nothing, and zero for
/// vectors and numbers. Computing with it is never slow, as it is with garbage.
#[inline(always)]
#[must_use]
pub fn identity<R: Scalar, const C: usize>() -> [R; C] {
    Identity::<R, C>::RECORD
}

/// A constant, so that nothing is built where it is passed on.
struct Identity<R, const C: usize>(PhantomData<R>);

impl<R: Scalar, const C: usize> Identity<R, C> {
    const RECORD: [R; C] = {
        // Ones lie this far apart, from this place on.
        let (mut one, apart) = match C {
            4 | 7 | 8 => (3, C),
            12 | 16 => (0, 5),
            _ => (C, 1),
        };
        let mut record = [R::ZERO; C];
        while one < C {
            record[one] = R::ONE;
            one += apart;
        }
        record
    };
}

mod sealed {
    pub trait Sealed {}
}

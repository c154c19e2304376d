//! Layouts of things in memory, and the traits by which kernels load things into registers and
//! store them.
//!
//! A *thing* is a motion, a point or any other object of `C` components: a motion has 8, a point
//! has 3. A *record* is the form of a thing in memory. A slice holds records one after the other
//! ([`Aos`], array of structures), or in [`Block`]s of `N` things ([`AoSoA`], array of structures
//! of arrays): row `c` of a block holds component `c` of `N` things. Kernels compute with a
//! register for each component and a thing in each lane. So blocks are loaded without a transpose,
//! which is the fastest way, and plain records are transposed in registers.
//!
#![doc = include_str!("blocks.svg")]
//!
//! | `C` | thing | type of a record |
//! |---|---|---|
//! | 1 | a scalar | `R` |
//! | 3 | a point or a vector | `[R; 3]` |
//! | 4 | a rotation, `[x, y, z, w]` | [`Quat<R>`](crate::Quat) |
//! | 4 | a plane, `[nx, ny, nz, d]` | [`Plane<R>`](crate::Plane) |
//! | 6 | a line, `[lx, ly, lz, mx, my, mz]` | [`Line<R>`](crate::Line) |
//! | 6 | a twist, `[ωx, ωy, ωz, vx, vy, vz]` | [`Twist<R>`](crate::Twist) |
//! | 6 | a twist, `[vx, vy, vz, ωx, ωy, ωz]` | [`LinearFirst<R>`](LinearFirst) |
//! | 7 | rotation and translation, `[x, y, z, w, tx, ty, tz]` | [`RotationTranslation<R>`] |
//! | 8 | a motion, `[px, py, pz, pw, qx, qy, qz, qw]` | [`DualQuat<R>`](crate::DualQuat) |
//! | 12 | a 3×4 matrix | `[[R; 4]; 3]` |
//! | 16 | a 4×4 matrix | `[[R; 4]; 4]` |
//! | 36 | a 6×6 matrix of twists, a covariance, angular first | `[[R; 6]; 6]` |
//! | 36 | a 6×6 matrix of twists, linear first | `[`[`LinearFirst<R>`](LinearFirst)`; 6]` |
//!
//! [`RotationTranslation<R>`]: crate::representation::RotationTranslation
//!
//! `[R; C]` is a record of any number of components, and [`Block<R, N, C>`](Block) holds `N` of
//! them. [`Element<C>`](Element) is the only bound that generic code needs. It names the layout of
//! a slice, and loads and stores a [`Tile`] at a time, with a register for each component.
//! [`Kernel`](crate::Kernel) has an example.
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
pub(crate) mod palette_entry;
pub(crate) mod shape;
mod source;

pub use aos::{Aos, LinearFirst};
pub use blocks::{AoSoA, Block};
pub use element::{Element, Layout, Number, Register, Tile, identity, tiles};
#[cfg(feature = "alloc")]
pub(crate) use packing::{Pack, Unpack, blocks_for};
pub use packing::{pack, pack_chain, unpack, unpack_chain};
pub(crate) use palette_entry::{MatrixOrder, PaletteEntry};
pub use shape::{same_length, whole_instances};
pub(crate) use source::{Motions, Source, motions};

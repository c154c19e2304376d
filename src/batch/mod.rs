//! Many motions at a time: the operations of the scalar reference on SIMD lanes.
//!
//! Everything is written once, generic over [`Lanes`](dq8_simd::Lanes), and every lane is computed
//! by the same operations: if a formula has cases, all cases are computed and
//! [`select`](dq8_simd::Lanes::select) picks one case per lane. If a case is rare and expensive, a
//! branch first tests whether *any* lane needs it. The value of a lane never depends on the other
//! lanes.
//!
//! ```
//! use dq8::batch::{DualQuat, Quat};
//! use dq8::{simd::{Portable, f32x8}};
//! // Eight robots, each turned by its own angle about z and moved by its own x.
//! let angle = f32x8::new([0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7]);
//! let (zero, one) = (f32x8::splat(0.0), f32x8::splat(1.0));
//! let turn = Quat::from_axis_angle([zero, zero, one], angle);
//! let pose = DualQuat::from_rotation_translation(turn, [angle, zero, zero]);
//! let sensor = (pose * pose).transform_point([one, zero, zero]);
//! assert!((sensor[1].to_array()[5] - (1.0_f32.sin() + 0.5 * 0.5_f32.sin())).abs() < 1e-6);
//! ```

mod blend;
mod contract;
mod derivative;
mod dual;
mod dual_quat;
#[cfg(not(dq8_record))]
#[expect(unreachable_pub, reason = "open to numbers that record")]
pub(crate) mod even;
#[cfg(dq8_record)]
pub mod even;
mod jacobian;
mod slerp;
#[rustfmt::skip]
pub(crate) mod even_coefficients;
mod directions;
mod exponential;
mod length;
mod matrix;
mod metric;
mod norm;
pub(crate) mod polar;
mod quat;
mod rigid;
mod screw;
mod transform;
mod trigonometry;
pub(crate) mod two_bone;
pub mod vector;

pub use dual::Dual;
pub use dual_quat::DualQuat;
pub use even::{cos_sin, farthest, half_turns};
pub use jacobian::lie_bracket;
pub use quat::Quat;
pub use trigonometry::atan2;
pub use two_bone::TwoBone;

//! Inverse kinematics, without allocation: which joint values bring the end where it should be.
//!
//! | item | what it solves | how |
//! |---|---|---|
//! | [`TwoBone`] | hip, knee and ankle to a point | the triangle of the two bones and the way to the target |
//! | [`Arm`] | up to six degrees of freedom of the end, any number of joints, limits | damped least squares |
//!
//! An [`Arm`] is a product of exponentials (Brockett 1984): the screws of its [`Joint`]s and the pose
//! of the end where all joints are zero, so that no frames have to be laid into the links. It is
//! solved for one target ([`Arm::reach`]) or for a slice of targets with the best instructions of the CPU
//! ([`Backend::reach`]), by the same code: that of [`mechanism::Reach`](crate::mechanism::Reach), which an
//! arm lays its own frames for. The result is a [`Report`].
//!
//! ```
//! use dq8::ik::{Arm, Joint, Options, Outcome};
//! use dq8::{DualQuat, Quat};
//! // Two links of length 1 in a plane, and a wrist.
//! let up = [0.0, 0.0, 1.0_f64];
//! let joints = [0.0, 1.0, 2.0].map(|x| Joint::revolute(up, [x, 0.0, 0.0]));
//! let arm = Arm::new(joints, DualQuat::from_translation([2.0, 0.0, 0.0]))?;
//! let turn = Quat::from_axis_angle(up, 1.0);
//! let target = DualQuat::from_rotation_translation(turn, [1.2, 0.8, 0.0]);
//! let mut angles = [0.1, 0.2, 0.3];
//! let report = arm.reach(target, &mut angles, &Options::default());
//! assert_eq!(report.outcome, Outcome::Converged);
//! assert!(arm.forward(&angles).distance_to(target) < 1e-5);
//! # Ok::<(), dq8::ik::ArmError>(())
//! ```

mod arm;
mod error;
mod jacobian;
mod joint;
mod reach;
mod two_bone;

#[cfg(doc)]
use crate::Backend;
pub use crate::mechanism::reach::{Options, Outcome, Report};
pub use arm::Arm;
pub use error::{ArmError, LimbError};
pub use joint::Joint;
pub use two_bone::{Span, TwoBone};

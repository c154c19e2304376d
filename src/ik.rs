//! Inverse kinematics of limbs of two bones, such as hip, knee and ankle. The two bones and the
//! line from the root to the target form a triangle, whose sides give the angles. For robots and
//! other chains of joints, the crate `dq8-robot` has `Reach`.

pub use crate::scalar::two_bone::{LimbError, Span, TwoBone};

use crate::batch;
use crate::macros::errors;
use crate::number::{Real, Scalar};
use crate::storage::shape::ShapeError;
use dq8_simd::{Lanes, Mask};

/// Three joints of a skeleton that are a limb: hip, knee and ankle, or shoulder, elbow and wrist.
///
/// [`Job::two_bone`](crate::Job::two_bone) bends such a limb.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limb<R> {
    /// The indices of the joint at the root, of its child, and of the child of that child.
    pub joints: [usize; 3],
    /// The axis of the hinge in the frame of the second joint, of any length. A positive turn about
    /// it bends the limb. If a character looks along z with y up, and its joints have the same
    /// axes, the axis of a knee is x. A component of the axis along a bone is ignored.
    pub hinge: [R; 3],
}

impl<R: Real> Limb<R> {
    /// Checks that the second joint is a child of the first, and the third a child of the second.
    pub(crate) fn check(&self, parent: impl Fn(usize) -> Option<usize>) -> Result<(), LimbsError> {
        let [hip, knee, foot] = self.joints;
        for (joint, before) in [(knee, hip), (foot, knee)] {
            if parent(joint) != Some(before) {
                return Err(LimbsError::NotChild { joint, parent: before });
            }
        }
        for (index, value) in self.hinge.into_iter().enumerate() {
            if !value.is_finite() {
                return Err(LimbsError::Hinge { index, value: value.into() });
            }
        }
        Ok(())
    }
}

/// The root, the lengths of the two bones, the target and the pole of a limb, for one limb in each
/// lane.
pub(crate) type Asked<L> = ([L; 3], [L; 2], [L; 3], [L; 3]);

/// Returns the error of the first limb that cannot be bent. `first` is the index of the limb in the
/// first lane. A check on lanes tells whether such a limb exists. Only if it exists are the limbs
/// checked one by one to find the error.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(crate) fn fault<L: Lanes<Real: Scalar>>(asked: Asked<L>, first: usize) -> Option<LimbsError> {
    let (root, lengths, target, pole) = asked;
    if !batch::TwoBone::refuses(root, lengths, target, pole).any() {
        return None;
    }
    let numbers = [
        root[0], root[1], root[2], lengths[0], lengths[1], target[0], target[1], target[2],
        pole[0], pole[1], pole[2],
    ];
    one_by_one(numbers.map(Lanes::to_array), first)
}

#[cold]
#[inline(never)]
fn one_by_one<R: Real, A: AsRef<[R]>>(lanes: [A; 11], first: usize) -> Option<LimbsError> {
    (0..dq8_simd::MAX_LANES).find_map(|lane| {
        let mut numbers = [R::ZERO; 11];
        for (number, lanes) in numbers.iter_mut().zip(&lanes) {
            *number = *lanes.as_ref().get(lane)?;
        }
        let [rx, ry, rz, a, b, x, y, z, px, py, pz] = numbers;
        let error: LimbError =
            TwoBone::check([rx, ry, rz], [a, b], [x, y, z], [px, py, pz]).err()?;
        Some(LimbsError::Limb { limb: first + lane, error })
    })
}

errors! {
    /// The error of limbs that cannot be bent, or of slices whose lengths do not match. No output
    /// has been written.
    #[derive(Clone, Debug, PartialEq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    LimbsError {
        /// The lengths of the slices do not match.
        Shape(error: ShapeError) => "{error}";
        /// A limb cannot be bent.
        Limb {
            /// The index of the first limb that cannot be bent. In blocks, limbs are counted block
            /// after block.
            limb: usize,
            /// The reason.
            error: LimbError,
        } from error => "limb {limb}: {error}";
        /// The joints of a skeleton do not form a limb.
        NotChild {
            /// The index of the joint.
            joint: usize,
            /// The index of the joint that should be its parent.
            parent: usize,
        } => "joint {joint} is not a child of joint {parent}";
        /// A hinge has a coordinate that is not finite.
        Hinge {
            /// The index of the coordinate.
            index: usize,
            /// The value of the coordinate.
            value: f64,
        } => "the hinge is not finite: coordinate {index} is {value}";
    }
}

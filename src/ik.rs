//! Inverse kinematics of limbs of two bones, such as hip, knee and ankle. The two bones and the
//! line from the root to the target form a triangle, which gives the angles. For robots and other
//! chains of joints there is `Reach` of the crate `dq8-robot`.

pub use crate::scalar::two_bone::{LimbError, Span, TwoBone};

use crate::batch;
use crate::macros::errors;
use crate::number::{Real, Scalar};
use crate::storage::shape::ShapeError;
use dq8_simd::{Lanes, Mask};

/// Three joints of a skeleton that are a limb: hip, knee and ankle, or shoulder, elbow and wrist.
///
/// [`Job::two_bone`](crate::Job::two_bone) bends it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limb<R> {
    /// The joint at the root, its child, and the child of that.
    pub joints: [usize; 3],
    /// The axis of the hinge, in the frame of the second joint, of any length: a positive turn
    /// about it bends the limb. Of a character that looks along z and stands on y up, with joints
    /// that have these axes too, it is x for a knee. What of it is along a bone does not count.
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

/// The roots, lengths of bones, targets and poles of limbs, one limb in each lane.
pub(crate) type Asked<L> = ([L; 3], [L; 2], [L; 3], [L; 3]);

/// Returns the error of the first limb that cannot be bent. `first` is the index of the limb in the
/// first lane. The check on lanes finds out whether there is such a limb; then the limbs are
/// checked again one by one to find the error.
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
    /// Limbs that cannot be bent, or slices that do not fit. Nothing has been written.
    #[derive(Clone, Debug, PartialEq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    LimbsError {
        /// The slices do not fit each other.
        Shape(error: ShapeError) => "{error}";
        /// A limb cannot be bent.
        Limb {
            /// The number of the first such limb; in blocks, things count one after the other.
            limb: usize,
            /// The fault.
            error: LimbError,
        } from error => "limb {limb}: {error}";
        /// Joints of a skeleton that are no limb.
        NotChild {
            /// The joint.
            joint: usize,
            /// The joint that should be its parent.
            parent: usize,
        } => "joint {joint} is not a child of joint {parent}";
        /// A hinge that is no axis.
        Hinge {
            /// The coordinate.
            index: usize,
            /// Its value.
            value: f64,
        } => "the hinge is not finite: coordinate {index} is {value}";
    }
}

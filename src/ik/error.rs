use crate::errors::errors;
use crate::scalar::two_bone::LimbError;
use crate::storage::shape::ShapeError;

errors! {
    /// Limbs that cannot be bent, or slices that do not fit. Nothing has been written.
    #[derive(Clone, Debug, PartialEq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    LimbsError {
        /// The slices do not fit each other.
        Shape(error: ShapeError) => "{error}";
        /// A limb cannot be bent.
        Limb {
            limb: usize = "Which, the first one; in blocks, things are counted one after the other.",
            error: LimbError = "The fault."
        } from error
            => "limb {limb}: {error}";
        /// Joints of a skeleton that are no limb.
        NotChild { joint: usize = "The joint.", parent: usize = "The joint that should be its parent." }
            => "joint {joint} is no child of joint {parent}";
        /// A hinge that is no axis.
        Hinge { index: usize = "The coordinate.", value: f64 = "Its value." }
            => "the hinge is not finite: coordinate {index} is {value}";
    }
}

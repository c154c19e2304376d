use super::step::Step;
use dq8::internal::errors;

errors! {
    /// Two trajectories that cannot be compared in this way.
    #[derive(Clone, Copy, Debug, PartialEq)]
    CompareError {
        /// The tolerance is negative or NaN.
        Tolerance { value: f64 = "Its value in seconds." } => "the tolerance is {value} s: it must not be negative";
        /// No pose of one is near enough in time to one of the other.
        NoPairs {
            reference: [f64; 2] = "The first stamp of the reference and its last one, in seconds.",
            estimate: [f64; 2] = "Those of the estimate."
        }
            => "no pose has a partner: the reference goes from {} s to {} s, the estimate from {} s to {} s", reference[0], reference[1], estimate[0], estimate[1];
        /// A pose is not finite.
        NotFinite {
            what: &'static str = "`reference` or `estimate`.",
            index: usize = "The number of the pose in that trajectory."
        }
            => "pose {index} of the {what} is not finite";
        /// Many rotations align the positions equally well: they lie on a line or in a point, or
        /// above each other where only the yaw is looked for.
        Ambiguous { pairs: usize = "The number of pairs." }
            => "{pairs} pairs do not say how to align them: the positions lie on a line, or in a point";
        /// A step is not positive.
        Step { step: Step = "The step." } => "{step:?}: a step must be positive";
        /// The trajectories are shorter than a step.
        NoSteps { step: Step = "The step.", pairs: usize = "The number of pairs." }
            => "no two of {pairs} pairs are {step:?} apart";
    }
}

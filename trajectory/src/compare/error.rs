use super::step::Step;
use dq8::internal::errors;

errors! {
    /// Two trajectories that cannot be compared in this way.
    #[derive(Clone, Copy, Debug, PartialEq)]
    CompareError {
        /// The tolerance is negative or NaN.
        Tolerance {
            /// Its value in seconds.
            value: f64,
        } => "the tolerance is {value} s: it must not be negative";
        /// No pose of one is near enough in time to one of the other.
        NoPairs {
            /// The first stamp of the reference and its last one, in seconds.
            reference: [f64; 2],
            /// Those of the estimate.
            estimate: [f64; 2],
        } => "no pose has a partner: the reference goes from {} s to {} s, the estimate from {} s to {} s", reference[0], reference[1], estimate[0], estimate[1];
        /// A pose is not finite.
        NotFinite {
            /// `reference` or `estimate`.
            what: &'static str,
            /// The number of the pose in that trajectory.
            index: usize,
        } => "pose {index} of the {what} is not finite";
        /// Many rotations align the positions equally well: they lie on a line or in a point, or
        /// above each other where only the yaw is looked for.
        Ambiguous {
            /// The number of pairs.
            pairs: usize,
        } => "{pairs} pairs do not say how to align them: the positions lie on a line, or in a point";
        /// A step is not positive.
        Step {
            /// The step.
            step: Step,
        } => "{step:?}: a step must be positive";
        /// The trajectories are shorter than a step.
        NoSteps {
            /// The step.
            step: Step,
            /// The number of pairs.
            pairs: usize,
        } => "no two of {pairs} pairs are {step:?} apart";
    }
}

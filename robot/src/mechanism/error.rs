use dq8::seams::errors;

errors! {
    /// Joints that make no mechanism. All name the joint.
    #[derive(Clone, Copy, Debug, PartialEq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    MechanismError {
        /// A joint whose parent does not come before it: itself, a later one (which a circle
        /// needs), or none that there is.
        Parent { joint: usize = "The joint.", parent: usize = "Its parent." }
            => "the parent of joint {joint} is {parent}, which does not come before it";
        /// A placement whose rotation is not unit.
        Placement { joint: usize = "The joint.", norm: f64 = "The norm of the real part." }
            => "the placement of joint {joint} is not unit: the norm of the real part is {norm}";
        /// A placement whose dual part is not a translation's.
        DualPart {
            joint: usize = "The joint.",
            along: f64 = "How much of the dual part lies along the real part, where a motion has none."
        }
            => "the placement of joint {joint} is not a motion: {along} of its dual part lies along the real part";
        /// A number that is infinite or NaN.
        NotFinite {
            joint: usize = "The joint.", what: &'static str = "What the number belongs to.", value: f64 = "The number."
        }
            => "the {what} of joint {joint} is not finite: {value}";
        /// An axis or normal that is not of length 1.
        Axis { joint: usize = "The joint.", length: f64 = "The length." }
            => "the axis of joint {joint} has length {length}, not 1";
        /// A screw that is none of a joint, whose angle is 1 and slide finite, or whose angle is 0
        /// and slide 1.
        Screw { joint: usize = "The joint.", angle: f64 = "The angle of the screw.", slide: f64 = "Its slide." }
            => "joint {joint} cannot turn by {angle} and slide by {slide} for a value of 1: a hinge or a thread turns by \
                1, and what only slides, by 1";
        /// Limits that are not in order, or NaN, or of a joint that has not one value.
        Limits { joint: usize = "The joint.", low: f64 = "The lower limit.", high: f64 = "The upper limit." }
            => "joint {joint} cannot have the limits {low} and {high}: they must be in order, and the joint must have \
                one value";
        /// A joint that cannot mimic that one: there is none, it is the joint itself or mimics too,
        /// or one of the two has not exactly one value.
        Mimic { joint: usize = "The joint.", other: usize = "The joint that it should mimic." }
            => "joint {joint} cannot mimic joint {other}: both must have one value, and the other one of its own";
        /// Too little room for the steps, or more joints than can be counted.
        Steps {
            steps: usize = "How many steps there is room for.",
            joints: usize = "How many joints there are: joint number `joints` has no room."
        }
            => "there is room for {steps} steps where {joints} joints need one each";
    }
}

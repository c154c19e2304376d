use dq8::ShapeError;
use dq8::seams::errors;

errors! {
    /// What cannot be asked of a mechanism.
    #[derive(Clone, Copy, Debug, PartialEq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    ReachError {
        /// There is no goal.
        NoGoals => "there is no goal";
        /// A goal for a link that there is not.
        Link {
            goal: usize = "The goal.", link: usize = "The link that it names.", links: usize = "How many links there are."
        }
            => "goal {goal} is for link {link}, and there are {links} links";
        /// A weight that is neither zero nor between 10⁻⁶ and 10⁶.
        Weight {
            goal: usize = "The goal.",
            component: usize = "The component: 0 to 2 of the rotation, 3 to 5 of the position.",
            value: f64 = "The weight."
        }
            => "component {component} of goal {goal} cannot weigh {value}: weights are zero, or from 1e-6 to 1e6";
        /// A point of a goal that is not finite.
        Point { goal: usize = "The goal.", component: usize = "The component.", value: f64 = "What it is." }
            => "component {component} of the point of goal {goal} is not finite: {value}";
        /// All weights of a goal are zero.
        NoWeight { goal: usize = "The goal." } => "all weights of goal {goal} are zero";
        /// A goal for a link that nothing moves: only fixed joints carry it, and such that mimic
        /// others zero times.
        Unmoved { goal: usize = "The goal.", link: usize = "The link that it names." }
            => "goal {goal} is for link {link}, and no joint that carries it moves";
        /// Too little room for the freedoms.
        Freedoms { freedoms: usize = "How many there is room for.", rates: usize = "How many rates the mechanism has." }
            => "there is room for {freedoms} freedoms where {rates} rates need one each";
        /// No value is within the limits of a joint and those of the joints that mimic it, or the
        /// limits are angles beyond what a float tells (2¹⁷ radians for `f32`, 2⁴⁶ for
        /// `f64`).
        Limits { joint: usize = "The joint.", low: f64 = "The lower limit.", high: f64 = "The upper limit." }
            => "joint {joint} cannot move between {low} and {high}: limits, also of what mimics it, must leave a value, and \
                be angles that a float tells apart";
        /// A posture of another length than a configuration.
        PostureLength { length: usize = "How many values it has.", expected: usize = "How many a configuration has." }
            => "the posture has {length} values where {expected} are needed";
        /// A value of a posture that is not finite.
        Posture { index: usize = "The value.", value: f64 = "What it is." }
            => "value {index} of the posture is not finite: {value}";
    }
}

errors! {
    /// What rates cannot be asked for.
    #[derive(Clone, Debug, PartialEq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    RatesError {
        /// Lengths that do not fit.
        Shape(error: ShapeError) => "{error}";
        /// A damping that is negative or not finite.
        Damping { value: f64 = "What it is." } => "the damping is negative or not finite: {value}";
        /// A joint value that is not finite.
        Value { index: usize = "Which one.", value: f64 = "What it is." } => "value {index} is not finite: {value}";
        /// A velocity that is not finite.
        Twist { index: usize = "Which one.", value: f64 = "The number in it." } => "twist {index} is not finite: {value}";
    }
}

errors! {
    /// What has no solutions to be asked for.
    #[derive(Clone, Debug, PartialEq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    SolutionsError {
        /// Lengths that do not fit.
        Shape(error: ShapeError) => "{error}";
        /// More goals than one.
        Goals { goals: usize = "How many there are." } => "there are {goals} goals, and one link has solutions";
        /// A goal that leaves some of rotation and position free.
        NoPose => "the goal leaves some of rotation and position free";
        /// A joint that carries the link and is neither fixed nor a hinge with a value of its own.
        Joint { joint: usize = "The joint." }
            => "joint {joint} carries the link, and is no hinge with a value of its own";
        /// More or fewer hinges than six that carry the link.
        Hinges { hinges: usize = "How many there are." } => "{hinges} hinges carry the link, not six";
        /// A target with a number that is not finite.
        Target { index: usize = "The target.", value: f64 = "The number in it." }
            => "target {index} is not finite: {value}";
        /// A target that is farther than 10⁻³ from a unit motion.
        NotUnit { index: usize = "The target.", norm: f64 = "The norm of its real part." }
            => "target {index} is not a unit motion: the norm of its real part is {norm}";
        /// A value of a start that is not finite.
        Start { index: usize = "The start.", hinge: usize = "The hinge.", value: f64 = "What it is." }
            => "value {hinge} of start {index} is not finite: {value}";
    }
}

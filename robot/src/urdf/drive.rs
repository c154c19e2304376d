use super::element::Element;

/// How fast and how hard a joint may move, as `velocity` and `effort` of its `<limit>` say;
/// infinite where they say nothing, or no number from zero on. Poses and inverse kinematics do not
/// ask for it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drive {
    /// The greatest speed: radians, or the unit of length, in a second.
    pub velocity: f64,
    /// The greatest torque or force: newton metres or newtons.
    pub effort: f64,
}

impl Drive {
    /// Without limits.
    pub const FREE: Self = Self { velocity: f64::INFINITY, effort: f64::INFINITY };

    pub(super) fn of(limit: Element<'_>) -> Self {
        let greatest = |name| {
            let number = limit.node.attribute(name).and_then(|text| text.trim().parse().ok());
            number.filter(|&number| number >= 0.0).unwrap_or(f64::INFINITY)
        };
        Self { velocity: greatest("velocity"), effort: greatest("effort") }
    }
}

//! A serial arm: a product of exponentials of joint screws.

use dq8::{DualQuat, Line, Quat, Real, Twist, geometry::Screw};

/// A joint with one degree of freedom, as it lies when the arm is at rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint {
    /// The line that it turns about and slides along, in the frame of the base.
    pub axis: Line<f64>,
    /// Radians of turn for one unit of the joint's variable.
    pub turn: f64,
    /// Length of slide for one unit of the joint's variable.
    pub slide: f64,
}

impl Joint {
    /// A hinge about the line through `point` along `direction`, of length 1.
    pub fn hinge(point: [f64; 3], direction: [f64; 3]) -> Self {
        let ([x, y, z], [a, b, c]) = (point, direction);
        let moment = [y * c - z * b, z * a - x * c, x * b - y * a];
        Self { axis: Line { direction, moment }, turn: 1.0, slide: 0.0 }
    }

    /// The joint's own motion. Through its screw, not its exponential: that begins with a length,
    /// which has no derivative at rest.
    pub fn motion<R: Real>(&self, variable: R) -> DualQuat<R> {
        let axis = Line {
            direction: self.axis.direction.map(R::from_f64),
            moment: self.axis.moment.map(R::from_f64),
        };
        let angle = variable * R::from_f64(self.turn);
        DualQuat::from_screw(Screw { axis, angle, slide: variable * R::from_f64(self.slide) })
    }

    /// The twist ξ for one unit of the joint's variable per unit of time: θl + ε(θm + dl).
    pub fn twist(&self) -> Twist<f64> {
        let Line { direction, moment } = self.axis;
        let linear = core::array::from_fn(|i| self.turn * moment[i] + self.slide * direction[i]);
        Twist { angular: direction.map(|c| self.turn * c), linear }
    }
}

/// Six joints in a row, and where the effector is at rest.
///
/// Its pose is exp(½q₁ξ₁) ⋯ exp(½q₆ξ₆) M (Brockett 1984; Murray, Li, Sastry 1994,
/// §3.2), written for every [`Real`], so that dual and hyper-dual numbers differentiate it.
///
/// ```
/// use lab::Arm;
/// let [x, y, z] = Arm::example().pose([0.0_f64; 6]).translation();
/// assert!((x - 0.82).abs() + y.abs() + (z - 0.83).abs() < 1e-15);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Arm {
    /// From the base on.
    pub joints: [Joint; 6],
    /// M, the pose of the effector at rest.
    pub rest: DualQuat<f64>,
}

impl Arm {
    /// An industrial arm in metres: three joints that place the wrist and three that meet in it,
    /// the fifth a lead screw as well (5 cm a turn), so that no derivative is that of hinges alone.
    pub fn example() -> Self {
        let ([x, y, z], height) = ([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], 0.83);
        let fifth = Joint::hinge([0.72, 0.0, height], y);
        let lead = 0.05 / core::f64::consts::TAU;
        Self {
            joints: [
                Joint::hinge([0.0; 3], z),
                Joint::hinge([0.1, 0.0, 0.35], y),
                Joint::hinge([0.1, 0.0, height], y),
                Joint::hinge([0.4, 0.0, height], x),
                Joint { slide: lead, ..fifth },
                Joint::hinge([0.72, 0.0, height], x),
            ],
            rest: DualQuat::from_rotation_translation(
                Quat::from_axis_angle(y, core::f64::consts::FRAC_PI_2),
                [0.82, 0.0, height],
            ),
        }
    }

    /// The pose of the effector.
    pub fn pose<R: Real>(&self, variables: [R; 6]) -> DualQuat<R> {
        let rest = DualQuat::from_array(self.rest.to_array().map(R::from_f64));
        let joints = self.joints.iter().zip(variables);
        let moved = joints
            .fold(DualQuat::IDENTITY, |before, (joint, variable)| before * joint.motion(variable));
        moved * rest
    }
}

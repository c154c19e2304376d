use super::representation::Representation;
use crate::matrix::{self, Matrix};
use dq8::Real;

/// Joints, each with a link of length 1 behind it.
pub const LINKS: usize = 10;

/// A small turn of every joint: vectors along the axis, as long as the angle in radians.
pub type Steps = [[f32; 3]; LINKS];

/// On which side of the state of a joint a step is multiplied.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// state · step, the state being translation · rotation: the joint turns about itself, and
    /// its translation is multiplied by nothing.
    StateStep,
    /// step · state, the state being rotation · translation: the step carries the link with it.
    StepState,
}

impl Order {
    /// Where the end effector is in the frame of the last joint.
    pub fn tip(self) -> [f64; 3] {
        match self {
            Self::StateStep => [1.0, 0.0, 0.0],
            Self::StepState => [0.0; 3],
        }
    }

    /// The end effector on the frame of the last joint.
    pub(super) fn end(self, last: Matrix<f64, 3, 4>) -> Matrix<f64, 3, 4> {
        let mut end = last;
        let tip = matrix::affine_apply(last, self.tip());
        for (row, t) in end.iter_mut().zip(tip) {
            row[3] = t;
        }
        end
    }

    /// How far the joint is from its parent: the first has none to be away from.
    fn offset(self, joint: usize) -> f32 {
        if self == Self::StateStep && joint == 0 { 0.0 } else { 1.0 }
    }
}

/// A linked chain whose joints hold their state as an `S`.
#[derive(Clone, Debug)]
pub struct Chain<S> {
    /// How a step is multiplied.
    pub order: Order,
    joints: [S; LINKS],
}

impl<S: Representation> Chain<S> {
    /// At the start: a chain along x, bent a little in every joint, this way and that.
    pub fn bent(order: Order) -> Self {
        let zero = S::Real::ZERO;
        let joints = core::array::from_fn(|joint| {
            let shift = S::shift([S::Real::from(order.offset(joint)), zero, zero]);
            let axis = if joint % 2 == 0 { [0.0, 0.6, 0.8] } else { [0.8, 0.6, 0.0] };
            let bend = S::turn(axis.map(S::Real::from_f64), S::Real::from_f64(0.3));
            match order {
                Order::StateStep => shift.times(bend),
                Order::StepState => bend.times(shift),
            }
        });
        Self { order, joints }
    }

    /// Multiplies the step onto the state of every joint.
    pub fn advance(&mut self, steps: &Steps) {
        for (state, step) in self.joints.iter_mut().zip(steps) {
            let step = turn(*step);
            *state = match self.order {
                Order::StateStep => state.times(step),
                Order::StepState => step.times(*state),
            };
        }
    }

    /// Puts the state of every joint in order.
    pub fn keep(&mut self, upkeep: impl Fn(S) -> S) {
        self.joints = self.joints.map(upkeep);
    }

    /// The joints from the root, in model space.
    pub fn models(&self) -> [S; LINKS] {
        self.levels(|model| model)
    }

    /// The joints from the root, in model space, each put in order before the next is multiplied
    /// onto it.
    pub fn levels(&self, upkeep: impl Fn(S) -> S) -> [S; LINKS] {
        let mut model = S::identity();
        self.joints.each_ref().map(|joint| {
            model = upkeep(model.times(*joint));
            model
        })
    }

    /// The end effector, the rows of `[A | t]`.
    pub fn end(&self) -> Matrix<f64, 3, 4> {
        let [.., last] = self.models();
        self.order.end(last.to_matrix())
    }

    /// The largest error of the length of a link, relative.
    pub fn link_error(&self) -> f64 {
        let errors = self.joints.iter().enumerate().map(|(joint, state)| {
            let [[.., x], [.., y], [.., z]] = state.to_matrix();
            ((x * x + y * y + z * z).sqrt() - f64::from(self.order.offset(joint))).abs()
        });
        errors.fold(0.0, f64::max)
    }
}

/// A step in the arithmetic of `S`.
fn turn<S: Representation>(step: [f32; 3]) -> S {
    let vector = step.map(S::Real::from);
    let [x, y, z] = vector;
    let angle = (x * x + y * y + z * z).sqrt();
    if angle == S::Real::ZERO { S::identity() } else { S::turn(vector.map(|c| c / angle), angle) }
}

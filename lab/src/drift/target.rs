//! The steps that make a chain follow a target.

use super::chain::{Chain, LINKS, Order, Steps};
use crate::matrix::Matrix;
use dq8::{DualQuat, Quat};
use nalgebra::{Matrix6, SMatrix, Vector3, Vector6};

/// Damping of the least squares, in links: a joint never turns by much even where the chain is
/// stretched.
const DAMPING: f64 = 0.1;
/// What is asked for in one frame at most, links and radians together: the start is away from the
/// target.
const LONGEST: f64 = 0.1;

/// Where the target is in a frame, with position and orientation, if it goes round in so many
/// frames: within the reach of the chain. It turns in other times, so that poses do not repeat.
fn target(frame: usize, round: usize) -> DualQuat<f64> {
    let phase = core::f64::consts::TAU * frame as f64 / round as f64;
    let position = [4.0 + 2.0 * phase.cos(), 2.5 * phase.sin(), 2.0 * (0.61 * phase).sin()];
    let tilt = Quat::from_axis_angle([0.0, 0.6, 0.8], 0.9 * (0.37 * phase).sin());
    let roll = Quat::from_axis_angle([1.0, 0.0, 0.0], 1.2 * (0.23 * phase).sin());
    DualQuat::from_rotation_translation(tilt * roll, position)
}

/// By how much the end of a chain is not where its target is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Miss {
    /// Links.
    pub position: f64,
    /// Radians.
    pub angle: f64,
}

impl Miss {
    /// Of the end, the rows of `[A | t]`, from the target in this frame.
    pub(super) fn of(end: Matrix<f64, 3, 4>, frame: usize, round: usize) -> Self {
        let (end, target) = (DualQuat::from_matrix3x4(end), target(frame, round));
        Self { position: end.distance_to(target), angle: end.angle_to(target) }
    }

    /// The larger of each.
    pub fn max(self, other: Self) -> Self {
        Self { position: self.position.max(other.position), angle: self.angle.max(other.angle) }
    }
}

/// Frames in which the end comes from the start to the target; after them it follows.
pub const ARRIVAL: usize = 400;

/// The turns of the joints in every frame that make the chain follow a target which goes round in
/// `round` frames; and by how much the end of the chain misses it at worst, in any frame after
/// [`ARRIVAL`].
///
/// By damped least squares on the geometric Jacobian (Wampler 1986), in double precision; the steps
/// are then rounded to single precision, exactly the same for every representation.
pub fn follow(frames: usize, round: usize, order: Order) -> (Vec<Steps>, Miss) {
    let mut chain = Chain::<DualQuat<f64>>::bent(order);
    let mut steps = Vec::with_capacity(frames);
    let mut missed = Miss::default();
    for frame in 0..frames {
        let step = towards(&chain.models().map(DualQuat::to_matrix3x4), order, frame, round);
        chain.advance(&step);
        chain.keep(DualQuat::normalize);
        if frame >= ARRIVAL {
            missed = missed.max(Miss::of(chain.end(), frame, round));
        }
        steps.push(step);
    }
    (steps, missed)
}

/// One step of all joints together, whose frames in model space are the rows of `[A | t]`, towards
/// where the target is in a frame.
pub(super) fn towards(
    models: &[Matrix<f64, 3, 4>; LINKS],
    order: Order,
    frame: usize,
    round: usize,
) -> Steps {
    const STILL: Matrix<f64, 3, 4> =
        [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];
    let target = target(frame, round);
    let column = |rows: Matrix<f64, 3, 4>, j: usize| Vector3::from(rows.map(|row| row[j]));
    let end = order.end(models[LINKS - 1]);
    let reached = column(end, 3);
    let mut jacobian = SMatrix::<f64, 6, { 3 * LINKS }>::zeros();
    for joint in 0..LINKS {
        let frame = match (order, joint.checked_sub(1)) {
            (Order::StateStep, _) => models[joint],
            (Order::StepState, Some(parent)) => models[parent],
            (Order::StepState, None) => STILL,
        };
        let arm = reached - column(frame, 3);
        for axis in 0..3 {
            let direction = column(frame, axis);
            let mut column = jacobian.fixed_view_mut::<6, 1>(0, 3 * joint + axis);
            column.fixed_rows_mut::<3>(0).copy_from(&direction);
            column.fixed_rows_mut::<3>(3).copy_from(&direction.cross(&arm));
        }
    }
    let end = DualQuat::from_matrix3x4(end);
    let turn = DualQuat::from_rotation(target.rotation() * end.rotation().conjugate());
    let turn = turn.log().real.map(|half| 2.0 * half);
    let reach = Vector3::from(target.translation()) - reached;
    let missing = Vector6::new(turn[0], turn[1], turn[2], reach.x, reach.y, reach.z);
    let wanted = missing.cap_magnitude(LONGEST);
    let normal = jacobian * jacobian.transpose() + Matrix6::identity() * (DAMPING * DAMPING);
    // Damped, the matrix is positive definite unless something is not finite.
    let forces = normal.cholesky().map_or(Vector6::zeros(), |solver| solver.solve(&wanted));
    let turns = jacobian.transpose() * forces;
    core::array::from_fn(|joint| core::array::from_fn(|axis| turns[3 * joint + axis] as f32))
}

//! The steps that make a chain follow a target.

use super::chain::{Chain, LINKS, Order, Steps};
use dq8::{DualQuat, Quat};
use nalgebra::{Matrix6, SMatrix, Vector3, Vector6};

/// Damping of the least squares, in links: a joint never turns by much even where the chain is stretched.
const DAMPING: f64 = 0.1;
/// What is asked for in one frame at most, links and radians together: the start is away from the target.
const LONGEST: f64 = 0.1;

/// Where the target is in a frame, with position and orientation, if it goes round in so many frames:
/// within the reach of the chain. It turns in other times, so that poses do not repeat.
fn target(frame: usize, round: usize) -> DualQuat<f64> {
    let phase = core::f64::consts::TAU * frame as f64 / round as f64;
    let position = [4.0 + 2.0 * phase.cos(), 2.5 * phase.sin(), 2.0 * (0.61 * phase).sin()];
    let tilt = Quat::from_axis_angle([0.0, 0.6, 0.8], 0.9 * (0.37 * phase).sin());
    let roll = Quat::from_axis_angle([1.0, 0.0, 0.0], 1.2 * (0.23 * phase).sin());
    DualQuat::from_rotation_translation(tilt * roll, position)
}

/// The turns of the joints in every frame that make the chain follow a target which goes round in
/// `round` frames; and how far the end of the chain is from it in the last frame, in links.
///
/// By damped least squares on the geometric Jacobian (Wampler 1986), in double precision; the steps
/// are then rounded to single precision, exactly the same for every representation.
#[must_use]
pub fn follow(frames: usize, round: usize, order: Order) -> (Vec<Steps>, f64) {
    let mut chain = Chain::<DualQuat<f64>>::bent(order);
    let mut steps = Vec::with_capacity(frames);
    for frame in 0..frames {
        let step = towards(&chain, target(frame, round));
        chain.advance(&step);
        chain.keep(DualQuat::normalize);
        steps.push(step);
    }
    let missed =
        frames.checked_sub(1).map_or(0.0, |last| end(&chain).distance_to(target(last, round)));
    (steps, missed)
}

/// The end effector.
fn end(chain: &Chain<DualQuat<f64>>) -> DualQuat<f64> {
    let [.., last] = chain.models();
    last * DualQuat::from_translation(chain.order.tip())
}

/// One step of all joints together towards the target.
fn towards(chain: &Chain<DualQuat<f64>>, target: DualQuat<f64>) -> Steps {
    let models = chain.models();
    let end = end(chain);
    let reached = Vector3::from(end.translation());
    let mut jacobian = SMatrix::<f64, 6, { 3 * LINKS }>::zeros();
    for joint in 0..LINKS {
        let frame = match (chain.order, joint.checked_sub(1)) {
            (Order::StateStep, _) => models[joint],
            (Order::StepState, Some(parent)) => models[parent],
            (Order::StepState, None) => DualQuat::IDENTITY,
        };
        let arm = reached - Vector3::from(frame.translation());
        for axis in 0..3 {
            let mut unit = [0.0; 3];
            unit[axis] = 1.0;
            let direction = Vector3::from(frame.transform_vector(unit));
            let mut column = jacobian.fixed_view_mut::<6, 1>(0, 3 * joint + axis);
            column.fixed_rows_mut::<3>(0).copy_from(&direction);
            column.fixed_rows_mut::<3>(3).copy_from(&direction.cross(&arm));
        }
    }
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

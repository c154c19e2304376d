//! Inverse kinematics of mechanisms. What a report says is held to the poses of the values that are
//! returned, one product after the other.

mod beyond;
mod floating;
mod free;
mod honest;
mod kinds;
mod limits;
mod outcomes;
mod owned;
mod posture;
mod rates;
mod refused;
mod shape;
mod tracking;
mod turns;
mod units;

use dq8::{Backend, DualQuat, Quat, Real, Scalar};
use dq8_fixtures::random::Random;
use dq8_robot::Joint;
use dq8_robot::ik::{Goal, Options, OwnedReach, Report};

pub(crate) use super::tree::mechanism;
pub(crate) use dq8_arms::{X, Y, Z};

/// The tolerance of [`Options::default`] in radians and lengths, with the rounding of its
/// measurement.
pub(crate) const REACHED: f64 = 1.001e-5;
/// A pose of ten products or so in `f64`, of links of about a length, and what is measured of it.
pub(crate) const ROUNDING: f64 = 1e-13;
/// A value that nothing but its limits decides.
pub(crate) const LAST_BITS: f64 = 1e-15;
/// The length of a step at which a search for a posture ends.
pub(crate) const SETTLED: f64 = 1e-4;

pub(crate) fn at(x: f64, y: f64, z: f64) -> DualQuat<f64> {
    DualQuat::from_translation([x, y, z])
}

pub(crate) fn turned(axis: [f64; 3], angle: f64, translation: [f64; 3]) -> DualQuat<f64> {
    DualQuat::from_rotation_translation(Quat::from_axis_angle(axis, angle), translation)
}

/// Links of these lengths in a plane, all about z.
pub(crate) fn planar(lengths: &[f64]) -> Vec<Joint<f64>> {
    let mut joints = vec![Joint::revolute(None, DualQuat::IDENTITY, Z)];
    for (index, &length) in lengths.iter().enumerate() {
        let last = index + 1 == lengths.len();
        let out = at(length, 0.0, 0.0);
        joints.push(if last {
            Joint::fixed(Some(index), out)
        } else {
            Joint::revolute(Some(index), out, Z)
        });
    }
    joints
}

/// Seven axes of our own dimensions: shoulder, elbow and wrist, with limits.
pub(crate) fn seven() -> Vec<Joint<f64>> {
    let quarter = core::f64::consts::FRAC_PI_2;
    let frames = [
        (turned(X, 0.0, [0.0, 0.0, 0.34]), [-2.8, 2.8]),
        (turned(X, -quarter, [0.0, 0.0, 0.0]), [-1.7, 1.7]),
        (turned(X, quarter, [0.0, -0.32, 0.0]), [-2.8, 2.8]),
        (turned(X, quarter, [0.08, 0.0, 0.0]), [-3.0, -0.1]),
        (turned(X, -quarter, [-0.08, 0.39, 0.0]), [-2.8, 2.8]),
        (turned(X, quarter, [0.0, 0.0, 0.0]), [0.0, 3.7]),
        (turned(X, quarter, [0.09, 0.0, 0.0]), [-2.8, 2.8]),
    ];
    let mut joints: Vec<_> = frames
        .into_iter()
        .enumerate()
        .map(|(index, (placement, limits))| {
            Joint::revolute(index.checked_sub(1), placement, Z).with_limits(limits)
        })
        .collect();
    joints.push(Joint::fixed(Some(6), at(0.0, 0.0, 0.11)));
    joints
}

/// Values of the seven, and others to start from.
pub(crate) const THERE: [f64; 7] = [0.5, -0.6, 0.7, -1.4, 0.3, 1.8, -0.4];
pub(crate) const START: [f64; 7] = [0.0, 0.2, 0.0, -1.0, 0.0, 1.2, 0.0];

/// Values within the limits; within ±3 where there are none.
pub(crate) fn draw(random: &mut Random, joints: &[Joint<f64>]) -> Vec<f64> {
    let mut values = Vec::new();
    for joint in joints.iter().filter(|joint| joint.mimic.is_none()) {
        let [low, high] = joint.limits.unwrap_or([-3.0, 3.0]);
        values.extend((0..joint.kind.values()).map(|_| random.between(low, high)));
    }
    values
}

/// The problem of these goals, with a mechanism of its own.
pub(crate) fn problem<R: Real>(
    joints: &[Joint<f64>],
    goals: impl Into<Vec<Goal<R>>>,
) -> OwnedReach<R> {
    OwnedReach::new(mechanism(joints), goals).expect("a problem")
}

/// The pose of a link.
pub(crate) fn pose<R: Real>(reach: &OwnedReach<R>, values: &[R], link: usize) -> DualQuat<R> {
    reach.view().mechanism().link_pose(values, link).expect("a link")
}

/// One configuration: what its values become, and the report.
pub(crate) fn solve_with<const N: usize>(
    reach: &OwnedReach<f64>,
    targets: &[DualQuat<f64>],
    start: [f64; N],
    options: &Options<f64>,
) -> ([f64; N], Report<f64>) {
    // What is in it must not matter.
    let (mut values, mut scratch) = (start, vec![f64::NAN; reach.view().scratch_len()]);
    let report = reach.view().solve(targets, &mut values, &mut scratch, options);
    (values, report.expect("lengths fit"))
}

/// With default options.
pub(crate) fn solve<const N: usize>(
    reach: &OwnedReach<f64>,
    target: DualQuat<f64>,
    start: [f64; N],
) -> ([f64; N], Report<f64>) {
    solve_with(reach, &[target], start, &Options::default())
}

/// `true` if all numbers are nearer to each other than `bound`.
pub(crate) fn near(a: &[f64], b: &[f64], bound: f64) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() < bound)
}

/// The values and reports that a backend returns.
pub(crate) type Solved<R> = (Backend, Vec<R>, Vec<Report<R>>);

/// The same on all backends.
pub(crate) fn solved<R: Scalar>(
    reach: &OwnedReach<R>,
    targets: &[DualQuat<R>],
    starts: &[R],
    options: &Options<R>,
) -> Vec<Solved<R>> {
    let reach = reach.view();
    let configurations = targets.len() / reach.goals().len();
    let mut scratch = vec![R::NAN; reach.batch_scratch_len()];
    Backend::available()
        .map(|backend| {
            let mut values = starts.to_vec();
            let mut reports = vec![Report::default(); configurations];
            let job = reach.job().backend(backend);
            job.solve_in(&mut scratch, targets, &mut values, &mut reports, options)
                .expect("lengths fit");
            (backend, values, reports)
        })
        .collect()
}

/// The turn and the distance between two poses.
pub(crate) fn apart<R: Real>(a: DualQuat<R>, b: DualQuat<R>) -> [f64; 2] {
    let turn = (a.rotation() * b.rotation().conjugate()).to_array().map(Into::<f64>::into);
    let [x, y, z, w] = turn;
    let angle = 2.0 * x.hypot(y).hypot(z).atan2(w.abs());
    let (a, b) = (a.translation().map(Into::<f64>::into), b.translation().map(Into::<f64>::into));
    let distance = (a[0] - b[0]).hypot(a[1] - b[1]).hypot(a[2] - b[2]);
    [angle, distance]
}

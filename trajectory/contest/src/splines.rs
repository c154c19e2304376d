//! A cumulative cubic B-spline, sampled with its body twist.

use crate::peers::Number;
use crate::sizes::{CONTROL, POINTS};
use crate::table::{Contender, Goal, Table};
use crate::{array, array_mut, drive, numbers, sevens};
use dq8::{DualQuat, Quat};
use dq8_fixtures::random::Random;
use dq8_trajectory::{Basis, Spline};

pub(crate) fn rows(table: &Table) {
    let control = drive(3, CONTROL, 0.05, 1.0);
    let spline = Spline::new(0.0, 1.0, &control, Basis::Smooth).expect("a spline");
    let control = sevens(&control);
    let mut random = Random(4);
    let mut times: Vec<_> = (0..POINTS).map(|_| random.between(0.0, 997.0) as f32).collect();
    times.sort_by(f32::total_cmp);
    let double: Vec<_> = times.iter().map(|&time| f64::from(time)).collect();
    let every = "logarithms at every time, f64";
    let contenders = vec![
        own::<f64>(&spline, &double),
        peer::<f64>(every, 40.0, &control, false, &double, 1e-10),
        peer::<f64>("logarithms kept, f64", 16.0, &control, true, &double, 1e-10),
    ];
    table.contest("spline with body twist, f64", POINTS, contenders);
    let contenders = vec![
        own::<f32>(&spline, &times),
        peer::<f64>(every, 80.0, &control, false, &double, 1e-2),
        peer::<f32>("logarithms kept, f32", 0.0, &control, true, &times, 1e-2),
    ];
    table.contest("spline with body twist, f32", POINTS, contenders);
}

fn own<'a, R: Number>(spline: &'a Spline, times: &'a [R]) -> Contender<'a> {
    let pass = |(poses, twists): &mut (Vec<DualQuat<R>>, Vec<[R; 6]>)| {
        spline.job().sample_with_twists(times, poses, twists).expect("times");
    };
    let output = (vec![DualQuat::IDENTITY; POINTS], vec![[R::NAN; 6]; POINTS]);
    let answer = |(poses, twists): &(Vec<DualQuat<R>>, Vec<_>)| {
        let mut found = matrices(poses.iter().map(|pose| pose.cast()));
        found.extend(numbers(twists));
        found
    };
    Contender::new("dq8", Goal::None, Some(0.0), output, pass, answer)
}

fn peer<'a, R: Number>(
    name: &'static str,
    goal: f64,
    control: &'a [[f64; 7]],
    keeps: bool,
    times: &'a [R],
    tolerance: f64,
) -> Contender<'a> {
    let pass = move |(poses, twists): &mut (Vec<[R; 7]>, Vec<[R; 6]>)| {
        R::SPLINE(array(control), keeps, array(times), array_mut(poses), array_mut(twists));
    };
    let output = (vec![[R::NAN; 7]; POINTS], vec![[R::NAN; 6]; POINTS]);
    let answer = |(poses, twists): &(Vec<[R; 7]>, Vec<_>)| {
        let mut found = matrices(poses.iter().map(|seven| motion(seven.map(Into::into))));
        found.extend(numbers(twists));
        found
    };
    let goal = if goal > 0.0 { Goal::Peer(goal) } else { Goal::None };
    Contender::new(name, goal, Some(tolerance), output, pass, answer)
}

/// The motion of a peer's pose.
pub(crate) fn motion([x, y, z, w, a, b, c]: [f64; 7]) -> DualQuat<f64> {
    DualQuat::from_rotation_translation(Quat::from_parts([x, y, z], w), [a, b, c])
}

/// Their matrices, which are the same whatever sign a quaternion has.
pub(crate) fn matrices(poses: impl Iterator<Item = DualQuat<f64>>) -> Vec<f64> {
    poses.flat_map(|pose| pose.to_matrix3x4().concat()).collect()
}

//! Angles so far that nobody knows them: alone and on lanes.

use crate::jobs::{Scene, alone, cast, drawn, on_lanes, plain, slices};
use crate::tree::{mechanism, tree};
use dq8::storage::{Aos, Element};
use dq8::{Backend, DualQuat, Real, Scalar};
use dq8_fixtures::random::Random;
use dq8_robot::{Joint, JointKind, JointValues};

/// A configuration with an angle so far, alone and among others: where a number is NaN in one, it
/// is in the other, and so are all of its link, and nothing of the others nor of the links before
/// it; elsewhere they are the same but for hundredths of a radian, to which such an angle is known.
/// Whether something is NaN.
fn is_nowhere<R>(
    joints: &[Joint<f64>],
    [link, angle]: [usize; 2],
    far: f64,
    random: &mut Random,
) -> Vec<bool>
where
    R: Scalar + Element<1, Layout = Aos<R>> + JointValues<Aos<R>>,
{
    const AT: usize = 6;
    let (owned, count) = (mechanism::<R>(joints), 17);
    let robot = owned.view();
    let mut numbers = cast::<R>(&drawn(random, joints, robot.rates(), count));
    numbers[0][AT * robot.values() + angle] = <R as Real>::from_f64(far);
    let counts = [robot.values(), robot.rates(), robot.rates()];
    let own = [0, 1, 2].map(|which| &numbers[which][AT * counts[which]..][..counts[which]]);
    let own = alone(&Scene::new(robot, 1), own);
    let mut nowhere = Vec::new();
    for backend in Backend::available() {
        let job = robot.job().backend(backend);
        let scene = Scene::new(robot, count);
        for (own, all) in own.iter().zip(on_lanes(&scene, job, slices(&numbers), plain())) {
            // Only where it fails: to write out the joints takes most of the time else.
            let what = || format!("{backend}, {}, angle {angle} at {far}: {joints:?}", own.what);
            let each = (all.numbers.len() / count).max(1);
            for (index, found) in all.numbers.chunks(each).enumerate() {
                assert!(index == AT || found.iter().all(|c| c.is_finite()), "{}, {index}", what());
            }
            let found = all.numbers.chunks(each).nth(AT).unwrap_or_default();
            let size = own.numbers.iter().filter(|c| !c.is_nan()).fold(1.0, |m, c| c.abs().max(m));
            for (a, b) in own.numbers.iter().zip(found) {
                let same = a.is_nan() && b.is_nan() || (a - b).abs() <= 0.1 * size;
                assert!(same, "{}: {a} alone, {b} among others", what());
            }
            if own.what == "poses" {
                let before = &own.numbers[..8 * link];
                assert!(before.iter().all(|c| c.is_finite()), "{}: {before:?}", what());
            }
            let is_of_links = !["world", "body", "aligned"].contains(&own.what);
            for link in own.numbers.chunks(own.width).filter(|_| is_of_links) {
                let is_nan = link[0].is_nan();
                assert!(link.iter().all(|c| c.is_nan() == is_nan), "{}: {link:?}", what());
            }
        }
        nowhere.push(own.iter().any(|own| own.numbers.iter().any(|c| c.is_nan())));
    }
    nowhere
}

fn far_angles<R>()
where
    R: Scalar + Element<1, Layout = Aos<R>> + JointValues<Aos<R>>,
{
    let mut random = Random(46);
    // The largest angle, radians.
    let limit = 2f64.powi(if R::EPSILON.into() > 1e-10 { 17 } else { 46 });
    let turn = |on| Joint::revolute(on, DualQuat::IDENTITY, [0.0, 1.0, 0.0]);
    for far in [f64::INFINITY, f64::NAN] {
        let nowhere = is_nowhere::<R>(&[turn(None), turn(Some(0))], [1, 1], far, &mut random);
        assert!(nowhere.iter().all(|&nan| nan), "{far}");
    }
    for links in [1, 2, 4, 7, 11] {
        let joints = tree(&mut random, links);
        let robot = mechanism::<R>(&joints);
        for (link, joint) in joints.iter().enumerate().filter(|(_, joint)| joint.mimic.is_none()) {
            let first = robot.view().values_of(link).unwrap().start;
            let angle = match joint.kind {
                JointKind::Revolute { .. } | JointKind::Screw { .. } => first,
                JointKind::Planar { .. } => first + 2,
                _ => continue,
            };
            // The screw slides as far as it turns, and what mimics turns less.
            for far in [0.99_f64, -0.99, 1.01, -3.0, 20.0] {
                let nowhere = is_nowhere::<R>(&joints, [link, angle], far * limit, &mut random);
                let is_far = far.abs() > 1.0;
                assert!(nowhere.iter().all(|&nan| nan == is_far), "{far} of the limit, {joint:?}");
            }
        }
    }
}

#[test]
fn far_angles_have_one_answer_alone_and_on_lanes_and_leave_other_configurations_alone() {
    far_angles::<f64>();
    far_angles::<f32>();
}

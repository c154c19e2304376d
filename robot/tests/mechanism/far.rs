//! Angles as far as numbers go: one configuration and lanes give the same answer, which is NaN in the same places
//! beyond the documented limit.

use crate::tree::{mechanism, tree, values};
use dq8::storage::{Aos, Element};
use dq8::{Backend, DualQuat, Real, Scalar, Twist};
use dq8_fixtures::random::Random;
use dq8_robot::{Body, Joint, JointKind, Mechanism, World, WorldAligned};

/// The largest angle, radians.
fn limit<R: Real>() -> f64 {
    2f64.powi(if R::EPSILON.into() > 1e-10 { 17 } else { 46 })
}

/// Numbers of poses and twists, and what they are called.
type Numbers = Vec<(&'static str, Vec<f64>)>;

fn flat<R: Real, const C: usize>(rows: impl IntoIterator<Item = [R; C]>) -> Vec<f64> {
    rows.into_iter().flatten().map(Into::into).collect()
}

fn of_poses<R: Real>(poses: &[DualQuat<R>]) -> Vec<f64> {
    flat(poses.iter().map(|pose| pose.to_array()))
}

fn of_twists<R: Real>(twists: &[Twist<R>]) -> Vec<f64> {
    flat(twists.iter().map(|twist| twist.to_array()))
}

/// Every way to ask for one configuration.
fn alone<R: Real>(robot: Mechanism<'_, R>, values: &[R], rates: &[R]) -> Numbers {
    let (links, nothing) = (robot.links(), Twist::from_array([R::ZERO; 6]));
    let mut poses = vec![DualQuat::IDENTITY; links];
    robot.link_poses(values, &mut poses).unwrap();
    let chosen: Vec<_> = (0..links).map(|link| robot.link_pose(values, link).unwrap()).collect();
    let mut all = vec![("poses", of_poses(&poses)), ("chosen", of_poses(&chosen))];
    let (mut twists, mut accelerations) = (vec![nothing; links], vec![nothing; links]);
    robot.link_velocities(values, rates, &mut poses, &mut twists).unwrap();
    all.push(("velocities", of_twists(&twists)));
    robot
        .link_accelerations(values, rates, rates, &mut poses, &mut twists, &mut accelerations)
        .unwrap();
    all.push(("accelerations", of_twists(&accelerations)));
    macro_rules! jacobian {
        ($($what:literal $frame:expr),*) => {$(
            let mut columns = vec![nothing; robot.rates()];
            robot.link_jacobian($frame, values, links - 1, &mut columns).unwrap();
            all.push(($what, of_twists(&columns)));
        )*};
    }
    jacobian! { "world" World, "body" Body, "aligned" WorldAligned }
    all
}

/// The same of one of many configurations, the others of which are near.
fn among<R>(backend: Backend, robot: Mechanism<'_, R>, values: &[R], rates: &[R]) -> Numbers
where
    R: Scalar + Element<1, Layout = Aos<R>>,
    R: dq8_robot::JointValues<Aos<R>>,
{
    const AT: usize = 6;
    let (links, count) = (robot.links(), 17);
    let mut many = vec![R::HALF; count * robot.values()];
    many[AT * robot.values()..][..robot.values()].copy_from_slice(values);
    let rates = rates.repeat(count);
    let mut poses = vec![DualQuat::IDENTITY; count * links];
    let mut twists = vec![Twist::from_array([R::ZERO; 6]); count * links];
    let mut accelerations = twists.clone();
    let job = robot.job().backend(backend);
    job.poses(&many, &mut poses).unwrap();
    let mut all = vec![("poses", of_poses(&poses[AT * links..][..links]))];
    let every: Vec<usize> = (0..links).collect();
    job.links(&every).poses(&many, &mut poses).unwrap();
    all.push(("chosen", of_poses(&poses[AT * links..][..links])));
    job.velocities(&many, &rates, &mut poses, &mut twists).unwrap();
    all.push(("velocities", of_twists(&twists[AT * links..][..links])));
    job.accelerations(&many, &rates, &rates, &mut poses, &mut twists, &mut accelerations).unwrap();
    all.push(("accelerations", of_twists(&accelerations[AT * links..][..links])));
    macro_rules! jacobian {
        ($($what:literal $frame:expr),*) => {$(
            let mut columns = vec![Twist::from_array([R::ZERO; 6]); count * robot.rates()];
            let mut tools = vec![DualQuat::IDENTITY; count];
            job.links(&[links - 1]).jacobians($frame, &many, &mut tools, &mut columns).unwrap();
            all.push(($what, of_twists(&columns[AT * robot.rates()..][..robot.rates()])));
        )*};
    }
    jacobian! { "world" World, "body" Body, "aligned" WorldAligned }
    all
}

/// Where a number is NaN in one, it is in the other, and elsewhere they are the same to rounding; says whether
/// anything was NaN.
fn agree(what: &str, alone: &Numbers, among: &Numbers, bound: f64) -> bool {
    let mut nan = false;
    for ((name, a), (_, b)) in alone.iter().zip(among) {
        assert_eq!(a.len(), b.len());
        let size = a.iter().copied().filter(|c| !c.is_nan()).fold(1.0, |m, c| c.abs().max(m));
        for (index, (a, b)) in a.iter().zip(b).enumerate() {
            nan |= a.is_nan();
            let same = a.is_nan() && b.is_nan() || (a - b).abs() <= bound * size;
            assert!(same, "{what}: number {index} of {name}: {a} alone, {b} among others");
        }
    }
    for (name, numbers) in alone.iter().take(4) {
        let of_a_link = if numbers.len() % 8 == 0 && !name.ends_with("ons") && *name != "velocities"
        {
            8
        } else {
            6
        };
        for link in numbers.chunks(of_a_link) {
            let count = link.iter().filter(|number| number.is_nan()).count();
            assert!(count == 0 || count == link.len(), "{what}: {name} {link:?}");
        }
    }
    nan
}

fn one_answer<R>()
where
    R: Scalar + Element<1, Layout = Aos<R>> + dq8_robot::JointValues<Aos<R>>,
{
    let mut random = Random(46);
    for count in 1..12 {
        let joints = tree(&mut random, count);
        let near = values(&mut random, &joints);
        let owned = mechanism::<R>(&joints);
        let robot = owned.view();
        let rates: Vec<R> = (0..robot.rates()).map(|_| R::from(random.signed() as f32)).collect();
        // Of every joint with an angle, the value that is one.
        let mut first = 0;
        for joint in joints.iter().filter(|joint| joint.mimic.is_none()) {
            let angle = match joint.kind {
                JointKind::Revolute { .. } | JointKind::Screw { .. } => Some(first),
                JointKind::Planar { .. } => Some(first + 2),
                _ => None,
            };
            first += joint.kind.values();
            let Some(angle) = angle else { continue };
            // The screw slides as far as it turns, and what mimics turns less.
            for (far, is_far) in
                [(0.99, false), (-0.99, false), (1.01, true), (-3.0, true), (20.0, true)]
            {
                let mut values: Vec<R> = near.iter().map(|&v| <R as Real>::from_f64(v)).collect();
                values[angle] = <R as Real>::from_f64(far * limit::<R>());
                let own = alone(robot, &values, &rates);
                for backend in Backend::available() {
                    let what = format!("{backend}, {count} joints, {far} of the limit, {joint:?}");
                    // At the limit, an angle is rounded by hundredths of a radian.
                    let nan = agree(&what, &own, &among(backend, robot, &values, &rates), 0.1);
                    assert_eq!(nan, is_far, "{what}");
                }
            }
        }
    }
}

#[test]
fn far_angles_have_one_answer_alone_and_on_lanes() {
    one_answer::<f64>();
    one_answer::<f32>();
}

/// The documented example, written out.
#[test]
fn a_link_a_thousand_billion_turns_away_is_nowhere() {
    let joints = [Joint::revolute(None, DualQuat::IDENTITY, [0.0, 0.0, 1.0])];
    let owned = mechanism::<f64>(&joints);
    for far in [1e15, f64::INFINITY, f64::NAN] {
        let pose = owned.view().link_pose(&[far], 0).unwrap();
        assert!(pose.to_array().iter().all(|c| c.is_nan()), "{pose:?}");
    }
}

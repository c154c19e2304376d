//! The number of solutions.

use super::{Poses, families, free, irb6640};
use dq8::{Backend, Scalar};
use dq8_arms::{Axis, Plan, Random, X, Y, exact, puma, rounded, turning, ur5};
use dq8_robot::ik::{Family, Options, Solutions};
use nalgebra::{Isometry3, Vector3};

/// The number of solutions without limits, by the geometry of the arm in space, and the distance
/// of the nearest pose at which two of them coincide.
type Counted = fn(&Isometry3<f64>) -> (usize, f64);

/// The upper and lower arm of a UR5 in the plane at the distance of the shoulder's offset, for both
/// directions of axis 5.
fn ur5_by_hand(tool: &Isometry3<f64>) -> (usize, f64) {
    let last = tool.rotation * Vector3::z();
    let at = tool.translation.vector - last * 0.0823;
    let radius = at.xy().norm();
    let (mut count, mut margin) = (0, (radius - 0.10915).abs());
    if radius < 0.10915 {
        return (0, margin);
    }
    for side in [1.0, -1.0] {
        // Where a point at this angle is to the left of the arm by the offset.
        let angle = at.y.atan2(at.x) + side * (0.10915 / radius).acos();
        let normal = Vector3::new(angle.cos(), angle.sin(), 0.0);
        for fifth in [1.0, -1.0] {
            let fifth = normal.cross(&last).normalize() * fifth;
            let reach = at - fifth * 0.09465 - Vector3::z() * 0.089159;
            let length = (reach - normal * normal.dot(&reach)).norm();
            let (inner, outer) = (length - (0.425 - 0.39225), 0.81725 - length);
            margin = margin.min(inner.abs()).min(outer.abs());
            count += if inner > 0.0 && outer > 0.0 { 2 } else { 0 };
        }
    }
    (count, margin)
}

/// Of arms with spherical wrists: the two links reach the centre, which is so far from the base, by
/// both shoulders, both elbows and both wrists.
fn by_links(
    tool: &Isometry3<f64>,
    [back, height, before, beside]: [f64; 4],
    last: Vector3<f64>,
    links: [f64; 2],
) -> (usize, f64) {
    let at = tool.translation.vector - tool.rotation * last * back;
    let radius = at.xy().norm();
    let (mut count, mut margin) = (0, (radius - beside).abs());
    if radius < beside {
        return (0, margin);
    }
    for side in [1.0, -1.0] {
        let forward = side * (radius * radius - beside * beside).sqrt() - before;
        let length = forward.hypot(at.z - height);
        let (inner, outer) = (length - (links[0] - links[1]).abs(), links[0] + links[1] - length);
        margin = margin.min(inner.abs()).min(outer.abs());
        count += if inner > 0.0 && outer > 0.0 { 4 } else { 0 };
    }
    (count, margin)
}

fn puma_by_hand(tool: &Isometry3<f64>) -> (usize, f64) {
    let lower = 0.0203_f64.hypot(0.4331);
    by_links(tool, [0.0563, 0.0, 0.0, 0.1501], Vector3::z(), [0.4318, lower])
}

fn irb6640_by_hand(tool: &Isometry3<f64>) -> (usize, f64) {
    let lower = 1.1425_f64.hypot(0.2);
    by_links(tool, [0.2, 0.78, 0.32, 0.0], Vector3::x(), [1.075, lower])
}

fn by_hand() -> [(&'static str, Plan<6>, Counted); 3] {
    [
        ("UR5", ur5(), ur5_by_hand),
        ("PUMA", free(puma()), puma_by_hand),
        ("IRB 6640", irb6640(), irb6640_by_hand),
    ]
}

/// How many poses are nearer than `margin` to where two solutions are one. The others have as many
/// solutions as there are, and the values that they were made of are one.
fn near<R: Scalar>(count: usize, margin: f64, at_start: f64) -> usize {
    let mut near = 0;
    for (name, plan, counted) in by_hand() {
        let poses = Poses::<R>::random(&plan, count);
        for ((values, target), found) in poses.values.iter().zip(&poses.targets).zip(poses.solve())
        {
            let (expected, gap) = counted(&plan.isometry(values));
            if gap < margin {
                near += 1;
                continue;
            }
            assert_eq!(found.len(), expected, "{name}: {values:?}, {gap:e}, {target:?}");
            let first: f64 = found[0].distance.into();
            assert!(found.is_complete && first < at_start, "{name}: {first:e}, {values:?}");
        }
    }
    near
}

#[test]
fn of_10_000_random_poses_each_has_as_many_as_geometry_says() {
    assert_eq!(near::<f64>(10_000, 1e-13, 1e-7), 0);
}

/// In `f32` a pose is where it is to 10⁻⁶, and angles there to the root of that where two
/// solutions are one.
#[test]
fn in_f32_too_but_where_two_are_one_to_its_rounding() {
    let near = near::<f32>(1_000, 3e-5, 0.03);
    assert!((1..60).contains(&near), "{near}");
}

/// The turns between two sets of values.
fn apart(a: &[f64; 6], b: &[f64; 6]) -> f64 {
    let turns = a.iter().zip(b).map(|(a, b)| (0.5 * (a - b)).sin().abs());
    turns.fold(0.0, f64::max)
}

/// Within the limits, which the PUMA has, and on arms that no formula of the other test is for.
#[test]
fn searches_from_1_024_starts_find_these_and_no_others() {
    let options = Options {
        angular_tolerance: 1e-12,
        linear_tolerance: 1e-12,
        restarts: false,
        ..Options::default()
    };
    for (name, plan, _) in families() {
        let poses = Poses::<f64>::random(&plan, 2);
        for (&target, found) in poses.targets.iter().zip(poses.solve()) {
            let mut random = Random(1024);
            let mut values: Vec<[f64; 6]> = (0..1024).map(|_| plan.draw(&mut random)).collect();
            let targets = vec![target; values.len()];
            let reports = poses.arm.reach_all(Backend::best(), &targets, &mut values, &options);
            let mut seen = vec![false; found.len()];
            for (values, report) in values.iter().zip(&reports) {
                if !report.is_converged() {
                    continue;
                }
                let known = found.iter().position(|known| apart(&known.values, values) < 1e-4);
                seen[known.unwrap_or_else(|| panic!("{name}: {values:?} is not found"))] = true;
            }
            assert!(seen.iter().all(|&seen| seen), "{name}: {seen:?} of {found:?}");
        }
    }
}

/// The arm's size times this is what poses are rounded by.
fn at_targets<R: Scalar>(rounding: f64) {
    for (name, plan, family) in families() {
        let poses = Poses::<R>::random(&plan, 100);
        assert_eq!(poses.six().family(), family, "{name}");
        for (target, found) in poses.targets.iter().zip(poses.solve()) {
            for solution in found.iter() {
                let values = exact(solution.values);
                for (value, axis) in solution.values.iter().zip(&plan.axes) {
                    let [low, high] = rounded::<R, 2>(axis.limits);
                    assert!(low <= *value && *value <= high, "{name}: {values:?}");
                }
                let there = plan.isometry(&values);
                let [x, y, z, w] = exact(target.rotation().to_array());
                let turn = nalgebra::Quaternion::new(w, x, y, z);
                let turn = nalgebra::UnitQuaternion::from_quaternion(turn);
                let way = there.translation.vector - Vector3::from(exact(target.translation()));
                let error = there.rotation.angle_to(&turn).max(way.norm() / 4.0);
                assert!(error < rounding, "{name}: {error:e} at {values:?}");
            }
            let order = found.windows(2).all(|pair| pair[0].distance <= pair[1].distance);
            assert!(order, "{name}: {found:?}");
        }
    }
}

#[test]
fn families_are_recognised_and_every_solution_is_at_the_target_to_the_rounding_of_poses_and_within_limits()
 {
    at_targets::<f64>(1e-14);
    at_targets::<f32>(4e-6);
}

/// Arms of each kind of which no two axes that follow each other are square or parallel, but for
/// those that must be.
fn oblique() -> [(&'static str, Plan<6>, Family); 3] {
    let (home, wrist) = ((X, 0.4, [1.0, 0.3, 0.9]), [0.7, 0.2, 0.9]);
    let [a, b, c] = [[0.0, 0.6, 0.8], [0.6, 0.8, 0.0], [0.8, 0.0, 0.6]];
    let arm = [(a, [0.0; 3]), (Y, [0.2, 0.1, 0.3]), (Y, [0.1, 0.0, 0.9])];
    let bent = [(a, [0.0; 3]), (b, [0.0; 3]), (c, [0.1, 0.2, 0.5])];
    let hand = [(b, wrist), (c, wrist), (a, wrist)];
    let plane = [(Y, [0.6, 0.0, 0.8]), (c, wrist), (a, wrist)];
    let plan = |[a, b, c]: [_; 3], [d, e, f]: [_; 3]| turning([a, b, c, d, e, f], home);
    [
        ("bending", plan(arm, hand), Family::SphericalWrist),
        ("crossing", plan(bent, hand), Family::SphericalWrist),
        ("parallel", plan(arm, plane), Family::ThreeParallel),
    ]
}

/// The values that a pose is made of, which is all that is known of it.
#[test]
fn oblique_arms_have_the_values_of_every_pose_among_their_solutions() {
    for (name, plan, family) in oblique() {
        let poses = Poses::<f64>::random(&plan, 300);
        assert_eq!(poses.six().family(), family, "{name}");
        let mut count = 0;
        for (values, found) in poses.values.iter().zip(poses.solve()) {
            let is_there = found.iter().any(|one| apart(&one.values, values) < 1e-7);
            assert!(is_there && found.is_complete, "{name}: {values:?} of {found:?}");
            count += found.len();
        }
        assert!(count > 700, "{name}: {count}");
    }
}

/// An axis that points the other way has negated values, and nothing else changes.
#[test]
fn an_axis_the_other_way_has_the_negated_values() {
    for (name, plan, family) in families() {
        let poses = Poses::<f64>::random(&plan, 20);
        let all = poses.solve();
        for turned in 0..6 {
            let mut other = plan;
            let Axis { direction, limits: [low, high], .. } = plan.axes[turned];
            other.axes[turned].direction = direction.map(|c| -c);
            other.axes[turned].limits = [-high, -low];
            let negated = |mut values: [f64; 6]| {
                values[turned] = -values[turned];
                values
            };
            let starts = poses.values.iter().map(|&values| negated(values)).collect();
            let others = Poses::<f64>::at(&other, starts);
            assert_eq!(others.six().family(), family, "{name}");
            for (found, others) in all.iter().zip(others.solve()) {
                assert_eq!(found.len(), others.len(), "{name}, axis {turned}");
                for one in found.iter() {
                    let wanted = negated(one.values);
                    let is_there = others.iter().any(|other| apart(&other.values, &wanted) < 1e-9);
                    assert!(is_there, "{name}, axis {turned}: {wanted:?} of {others:?}");
                }
            }
        }
    }
}

/// On lanes of every kind, whatever is left over; and one by one.
#[test]
fn lanes_find_what_one_target_at_a_time_finds() {
    fn check<R>(name: &str, plan: &Plan<6>, near: f64)
    where
        R: Scalar + dq8::Lanes<Real = R, Level = dq8::simd::Portable, Mask = bool>,
    {
        let poses = Poses::<R>::random(plan, 19);
        let start = rounded([0.3, -0.4, 0.5, -0.6, 0.7, -0.8]);
        let six = poses.six();
        let alone = poses.targets.iter().map(|&target| six.solutions(target, &start, &mut []));
        let alone: Vec<Solutions<R>> = alone.map(|found| found.expect("a target")).collect();
        for backend in Backend::available() {
            for count in [0, 1, 3, 8, 19] {
                let job = six.job().backend(backend);
                let mut found = vec![Solutions::default(); count];
                let starts = vec![start; count];
                job.solutions(&poses.targets[..count], &starts, &mut found).expect("lengths fit");
                for (found, alone) in found.iter().zip(&alone) {
                    assert_eq!(found.len(), alone.len(), "{name}, {backend}");
                    for (a, b) in found.iter().zip(alone.iter()) {
                        let apart = apart(&exact(a.values), &exact(b.values));
                        assert!(apart < near, "{name}, {backend}: {a:?}, {b:?}");
                    }
                }
            }
        }
    }
    for (name, plan, _) in families() {
        check::<f64>(name, &plan, 1e-11);
        check::<f32>(name, &plan, 1e-2);
    }
}

//! Singular poses, limits, and targets out of reach.

use super::{Poses, free, iiwa_held};
use dq8::{Backend, DualQuat};
use dq8_arms::{Axis, Plan, Random, X, Y, Z, puma, six_of_any_kind, turning, ur5};
use dq8_robot::ik::{Family, Solution, Solutions};
use std::f64::consts::{PI, TAU};

/// Poses with one joint at a value, and what is found of them.
fn with(plan: &Plan<6>, fixed: &[(usize, f64)]) -> (Poses<f64>, Vec<Solutions<f64>>) {
    let mut random = Random(8);
    let draw = |_| {
        let mut values = plan.draw(&mut random);
        for &(joint, value) in fixed {
            values[joint] = value;
        }
        values
    };
    let poses = Poses::at(plan, (0..200).map(draw).collect());
    let found = poses.solve();
    (poses, found)
}

#[test]
fn where_the_last_axis_is_along_the_fourth_one_solution_has_the_angle_of_the_start() {
    let (poses, found) = with(&free(puma()), &[(4, 0.0)]);
    let mut ones = 0;
    for (values, found) in poses.values.iter().zip(&found) {
        let singular = found.iter().filter(|solution| solution.singular.wrist);
        assert!((1..=2).contains(&singular.count()), "{found:?}");
        // With seven, the two of the wrist are one.
        if found.len() == 7 {
            let nearest = &found[0];
            assert!(nearest.singular.wrist && nearest.values[4].abs() < 1e-13);
            assert!((nearest.values[3] - values[3]).abs() < 1e-14);
            assert!(nearest.distance < 1e-6, "{nearest:?}, {values:?}");
            ones += 1;
        }
    }
    assert!(ones > 160, "{ones}");
}

#[test]
fn where_four_axes_are_parallel_the_last_has_the_angle_of_the_start() {
    let (poses, found) = with(&ur5(), &[(4, 0.0)]);
    let mut ones = 0;
    for (values, found) in poses.values.iter().zip(&found) {
        assert!(found.iter().any(|solution| solution.singular.wrist), "{found:?}");
        let singular = found.iter().filter(|solution| solution.singular.wrist);
        ones += usize::from(singular.clone().any(|one| (one.values[5] - values[5]).abs() < 1e-14));
    }
    assert!(ones > 160, "{ones}");
}

/// With an upper arm longer than the lower one, which folds back on it.
#[test]
fn a_stretched_or_folded_arm_is_singular_at_the_elbow() {
    for straight in [0.0, PI] {
        let (_, found) = with(&ur5(), &[(2, straight)]);
        let mut beyond = 0;
        for found in &found {
            let singular = || found.iter().filter(|one| one.singular.elbow);
            let is_straight = |value: f64| (value.abs() - straight).abs() < 1e-6;
            assert!(singular().all(|one| is_straight(one.values[2])), "{found:?}");
            assert!(singular().all(|one| one.singular.any()), "{found:?}");
            beyond += usize::from(singular().count() == 0);
        }
        // Poses that are rounded by more than a solution may be.
        assert!(beyond < 4, "{straight}: {beyond}");
    }
}

#[test]
fn a_wrist_on_the_first_axis_leaves_that_the_angle_of_the_start() {
    let (poses, found) = with(&iiwa_held(), &[(1, 0.0), (2, 0.0)]);
    for (values, found) in poses.values.iter().zip(&found) {
        assert_eq!(found.len(), 2, "{found:?}");
        for solution in found.iter() {
            assert!(solution.singular.shoulder && solution.singular.elbow);
            assert!((solution.values[0] - values[0]).abs() < 1e-14);
        }
    }
    // The same where the second and third axis are parallel, and nothing is beside the first.
    let up = [0.0, 0.0, 1.0];
    let elbow = turning(
        [
            (Z, [0.0; 3]),
            (Y, [0.0; 3]),
            (Y, up),
            (X, [1.0, 0.0, 1.0]),
            (Y, [1.0, 0.0, 1.0]),
            (X, up),
        ],
        (X, 0.0, [1.25, 0.0, 1.0]),
    );
    let (poses, found) = with(&elbow, &[(1, -PI / 4.0), (2, 0.0)]);
    for (values, found) in poses.values.iter().zip(&found) {
        assert!(found.iter().all(|one| one.singular.shoulder), "{found:?}");
        assert!(found.iter().any(|one| (one.values[0] - values[0]).abs() < 1e-14), "{found:?}");
    }
    // Links of one length, folded: then the second axis too, which the wrist is on.
    let (poses, found) = with(&elbow, &[(2, PI / 2.0)]);
    for (values, found) in poses.values.iter().zip(&found) {
        assert!(found.iter().all(|one| one.singular.elbow), "{found:?}");
        let keeps = |one: &Solution<f64>| (0..2).all(|i| (one.values[i] - values[i]).abs() < 1e-14);
        assert!(found.iter().any(keeps), "{values:?}: {found:?}");
    }
}

#[test]
fn out_of_reach_there_are_none() {
    for plan in [ur5(), puma(), iiwa_held()] {
        let mut poses = Poses::<f64>::random(&plan, 5);
        for target in &mut poses.targets {
            *target = DualQuat::from_translation([0.0, 9.0, 0.0]) * *target;
        }
        for found in poses.solve() {
            assert!(found.is_empty() && found.is_complete);
        }
        // Too near to the first axis for the offset of the shoulder, but for the last arm.
        poses.targets.fill(DualQuat::from_translation([0.01, 0.0, 0.3]));
        let offset = plan.axes[5].through[1].abs() > 0.0 || plan.axes[4].through[1].abs() > 0.0;
        assert!(!offset || poses.solve().iter().all(|found| found.is_empty()));
    }
}

#[test]
fn of_the_turns_within_limits_the_nearest_to_the_start_is_given() {
    let wide = ur5().with_axes(|axis| Axis { limits: [-TAU, TAU], ..axis });
    let mut turned = 0;
    let poses = Poses::<f64>::random(&wide, 300);
    for (start, found) in poses.values.iter().zip(poses.solve()) {
        for (value, start) in found.iter().flat_map(|one| one.values.iter().zip(start)) {
            for other in [value - TAU, value + TAU] {
                let is_within = (-TAU..=TAU).contains(&other);
                let nearer = (other - start).abs() < (value - start).abs() - 1e-9;
                assert!(!(is_within && nearer), "{other} is nearer to {start} than {value}");
            }
            turned += usize::from(value.abs() > PI);
        }
    }
    assert!(turned > 1000, "{turned}");
}

#[test]
fn what_limits_leave_are_the_solutions_without_them_that_are_within() {
    let (limited, all) = (puma(), free(puma()));
    let poses = Poses::<f64>::random(&limited, 500);
    let free = Poses::<f64>::at(&all, poses.values.clone());
    let mut fewer = 0;
    for (found, all) in poses.solve().iter().zip(free.solve()) {
        let within = all.iter().filter(|one| {
            one.values.iter().zip(&limited.axes).all(|(value, axis)| {
                let [low, high] = axis.limits;
                [-TAU, 0.0, TAU].iter().any(|turn| (low..=high).contains(&(value + turn)))
            })
        });
        assert_eq!(found.len(), within.count());
        fewer += usize::from(found.len() < all.len());
    }
    assert!(fewer > 400, "{fewer}");
}

/// Values at a limit are within it, though the formula may be off by a rounding.
#[test]
fn solutions_at_a_limit_are_within_it() {
    let (at, mut random) = (1.234_567, Random(5));
    let plan = ur5().with_axes(|axis| Axis { limits: [-at, at], ..axis });
    let ends = (0..100).map(|_| core::array::from_fn(|_| at * random.one_of(&[-1.0, 1.0])));
    let poses = Poses::<f64>::at(&plan, ends.collect());
    for (values, found) in poses.values.iter().zip(poses.solve()) {
        let first = found.first().expect("the values themselves");
        assert!(first.distance < 1e-9, "{values:?}, {found:?}");
    }
}

/// Values at a limit are no solution if only those beyond it reach the target.
#[test]
fn just_beyond_a_limit_nothing_stops_at_it() {
    let (at, by, mut random) = (1.234_567, 5e-8, Random(6));
    let beyond = (0..200).map(|index| {
        let mut values: [f64; 6] = core::array::from_fn(|_| random.between(-at, at));
        values[index % 6] = (at + by) * random.one_of(&[-1.0, 1.0]);
        values
    });
    let beyond: Vec<_> = beyond.collect();
    let solve = |end: f64| {
        let plan = ur5().with_axes(|axis| Axis { limits: [-end, end], ..axis });
        Poses::<f64>::at(&plan, beyond.clone()).solve()
    };
    for ((values, found), wider) in beyond.iter().zip(solve(at)).zip(solve(at + 2.0 * by)) {
        for one in found.iter() {
            let [turn, way] = ur5().apart(&one.values, values);
            assert!(turn < 1e-12 && way < 1e-12, "{one:?} for {values:?}");
        }
        assert!(wider.len() > found.len(), "{values:?}: {wider:?} {found:?}");
    }
}

#[test]
fn other_arms_are_searched_for_and_what_is_found_may_not_be_all() {
    let mut random = Random(4);
    let plan = six_of_any_kind(&mut random);
    let poses = Poses::<f64>::random(&plan, 3);
    let six = poses.six();
    assert_eq!(six.family(), Family::Other);
    let mut scratch = vec![f64::NAN; six.scratch_len()];
    let found = poses.solve();
    for ((found, &target), values) in found.iter().zip(&poses.targets).zip(&poses.values) {
        assert!(!found.is_complete && found[0].distance < 1e-9, "{found:?}");
        let alone = six.solutions(target, values, &mut scratch).expect("a target");
        assert_eq!(alone.len(), found.len());
        for one in found.iter() {
            let [turn, way] = plan.apart(&one.values, values);
            assert!(turn < 1e-9 && way < 1e-9, "{one:?}");
        }
    }
    let mut again = vec![Solutions::default(); found.len()];
    let mut memory = vec![f64::NAN; six.batch_scratch_len()];
    let job = six.job().backend(Backend::best());
    job.solutions_in(&mut memory, &poses.targets, &poses.values, &mut again).expect("lengths fit");
    assert_eq!(again, found);
}

#[cfg(feature = "rayon")]
#[test]
fn all_cores_find_every_bit_of_what_one_finds() {
    for (plan, count) in [(ur5(), 2000), (six_of_any_kind(&mut Random(4)), 3)] {
        let poses = Poses::<f64>::random(&plan, count);
        let mut all = vec![Solutions::default(); count];
        let job = poses.six().job().threads(usize::MAX);
        job.solutions(&poses.targets, &poses.values, &mut all).expect("lengths fit");
        assert!(poses.solve() == all);
    }
}

//! Many targets at once against one at a time, on every backend.

use super::arms::{Plan, Random, puma, rounded, ur5};
use dq8::ik::{Arm, Options, Outcome, Report};
use dq8::{
    Backend, DualQuat, Lanes, Real, Scalar, ShapeError,
    simd::{Portable, f64x8},
};

/// Targets, and values to start from.
fn drawn<R: Scalar>(plan: &Plan<6>, count: usize) -> (Vec<DualQuat<R>>, Vec<[R; 6]>) {
    let (arm, mut random) = (plan.arm::<R>(), Random(10));
    (0..count)
        .map(|i| {
            let target = arm.forward(&rounded(plan.draw(&mut random)));
            // Every seventh is out of reach, every eleventh nothing.
            let target = match i {
                _ if i % 7 == 6 => DualQuat::from_translation(rounded([9.0, 0.0, 1.0])) * target,
                _ if i % 11 == 10 => target.scale(R::NAN),
                _ => target,
            };
            (target, rounded(plan.draw(&mut random)))
        })
        .unzip()
}

/// Whether the portable lanes round a multiply-add once, as the instructions of the build target may.
fn portable_lanes_fuse() -> bool {
    let x = <f64x8 as Lanes>::splat(Portable, 1.1);
    let rest = Lanes::to_array(Lanes::mul_add(x, x, -(x * x)));
    rest.as_ref().iter().any(|&rest| rest != 0.0)
}

/// Lanes that round a multiply-add once come to other last bits than plain numbers that round twice, and near
/// singular poses the last bit becomes another way to the target: all but a few searches are the same, and what
/// is called reached is.
fn many_are_as_one<R>()
where
    R: Scalar + Lanes<Real = R, Level = Portable, Mask = bool>,
{
    let options = Options::default();
    for plan in [ur5(), puma()] {
        let arm = plan.arm::<R>();
        let (targets, starts) = drawn::<R>(&plan, 64);
        for backend in Backend::available() {
            let (mut values, mut reports) = (starts.clone(), vec![Report::default(); 64]);
            backend
                .reach(&arm, &targets, &mut values, &mut reports, &options)
                .expect("lengths fit");
            let (mut differ, mut other_way) = (0, 0);
            for (index, (together, in_lane)) in values.iter().zip(&reports).enumerate() {
                let mut alone = starts[index];
                let report = arm.reach(targets[index], &mut alone, &options);
                differ += u32::from(in_lane.outcome != report.outcome);
                for (values, report) in [(&alone, &report), (together, in_lane)] {
                    if report.outcome == Outcome::Converged {
                        assert_reached(&arm, targets[index], values);
                    }
                }
                let tolerance = if size_of::<R>() == 4 { 2e-4 } else { 1e-12 };
                let same_way = (in_lane.iterations, in_lane.restarts)
                    == (report.iterations, report.restarts)
                    && alone.iter().zip(together).all(|(&alone, &together)| {
                        Into::<f64>::into(alone - together).abs() < tolerance
                            || alone.is_nan() && together.is_nan()
                    });
                other_way += u32::from(!same_way);
            }
            assert!(differ <= 2, "{backend}: {differ} of 64");
            let rounds_alike = backend == Backend::PORTABLE && !portable_lanes_fuse();
            let most = if rounds_alike { 0 } else { 6 };
            assert!(other_way <= most, "{backend}: {other_way} of 64");
        }
    }
}

fn assert_reached<R: Scalar>(arm: &Arm<R, 6>, target: DualQuat<R>, values: &[R; 6]) {
    let pose = arm.forward(values);
    let most = 1e-5 + 32.0 * Into::<f64>::into(<R as Real>::EPSILON);
    assert!(pose.distance_to(target).into() < most && pose.angle_to(target).into() < most);
}

#[test]
fn targets_on_lanes_are_reached_as_one_at_a_time() {
    many_are_as_one::<f64>();
    many_are_as_one::<f32>();
}

/// The best backend's lanes in another order, and another number of them.
fn neighbours_do_not_matter<R: Scalar>() {
    let plan = puma();
    let arm = plan.arm::<R>();
    let (targets, starts) = drawn::<R>(&plan, 37);
    let options = Options::default();
    for backend in Backend::available() {
        let mut values = starts.clone();
        let mut reports = vec![Report::default(); 37];
        backend.reach(&arm, &targets, &mut values, &mut reports, &options).expect("lengths fit");
        for from in [1, 5, 36] {
            let (mut again, mut second) =
                (starts[from..].to_vec(), vec![Report::default(); 37 - from]);
            backend
                .reach(&arm, &targets[from..], &mut again, &mut second, &options)
                .expect("lengths fit");
            let bits = |values: &[[R; 6]]| -> Vec<u64> {
                values.as_flattened().iter().map(|&v| Into::<f64>::into(v).to_bits()).collect()
            };
            assert_eq!(bits(&values[from..]), bits(&again), "{backend} from {from}");
            for (a, b) in reports[from..].iter().zip(&second) {
                assert_eq!(
                    (a.outcome, a.iterations, a.restarts),
                    (b.outcome, b.iterations, b.restarts)
                );
            }
        }
    }
}

#[test]
fn what_comes_does_not_depend_on_the_neighbours() {
    neighbours_do_not_matter::<f64>();
    neighbours_do_not_matter::<f32>();
}

/// Backends round differently, and a search that begins again takes another turn; but what they call
/// reached is, and each reaches as much.
fn every_backend_agrees<R: Scalar>() {
    let plan = ur5();
    let arm = plan.arm::<R>();
    let (targets, starts) = drawn::<R>(&plan, 151);
    let mut all = Vec::new();
    for backend in Backend::available() {
        let mut values = starts.clone();
        let mut reports = vec![Report::default(); targets.len()];
        backend
            .reach(&arm, &targets, &mut values, &mut reports, &Options::default())
            .expect("lengths fit");
        for ((target, values), report) in targets.iter().zip(&values).zip(&reports) {
            if report.outcome == Outcome::Converged {
                assert_reached(&arm, *target, values);
            }
        }
        all.push((backend, reports));
    }
    let (_, first) = &all[0];
    for (backend, reports) in &all {
        let mut differ = 0;
        for (a, b) in first.iter().zip(reports) {
            let impossible = [Outcome::OutOfReach, Outcome::Invalid];
            if impossible.contains(&a.outcome) || a.restarts == 0 {
                assert_eq!((a.outcome, a.restarts), (b.outcome, b.restarts), "{backend}");
            }
            differ += u32::from(a.outcome != b.outcome);
        }
        assert!(differ <= 2, "{backend}: {differ}");
    }
}

#[test]
fn every_backend_reaches_as_much() {
    every_backend_agrees::<f64>();
    every_backend_agrees::<f32>();
}

#[test]
fn slices_that_do_not_fit_are_refused() {
    let arm = ur5().arm::<f32>();
    let target = DualQuat::IDENTITY;
    let (mut values, mut reports) = ([[7.0; 6]; 3], [Report::default(); 3]);
    let options = Options::default();
    let backend = Backend::best();
    let refused = |what, length| Err(ShapeError::Length { what, length, expected: 2 });
    assert_eq!(
        backend.reach(&arm, &[target; 2], &mut values, &mut reports[..2], &options),
        refused("values", 3)
    );
    assert_eq!(
        backend.reach(&arm, &[target; 2], &mut values[..2], &mut reports, &options),
        refused("reports", 3)
    );
    assert_eq!((values, reports), ([[7.0; 6]; 3], [Report::default(); 3]));
    assert_eq!(backend.reach(&arm, &[], &mut [], &mut [], &options), Ok(()));
}

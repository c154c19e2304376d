//! Many targets at once against one at a time, on every backend.

use super::arms::{Plan, Random, puma, rounded, ur5};
use dq8::ik::{Arm, Options, Outcome, Report};
use dq8::simd::Records;
use dq8::{
    Backend, DualQuat, Lanes, Real, ShapeError, batch,
    simd::{Float, Portable, f32x8, f64x8},
};

/// Targets, and values to start from.
fn drawn<R: Real + Float>(plan: &Plan<6>, count: usize) -> (Vec<DualQuat<R>>, Vec<[R; 6]>) {
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

/// Whether these lanes round a multiply-add once. Plain numbers round twice, and near singular poses the
/// last bit becomes another way to the target.
fn fuses<L: Lanes<Level = Portable>>() -> bool {
    let x = L::splat(Portable, <L::Real as Float>::from_f64(1.1));
    let rest = x.mul_add(x, -(x * x)).to_array();
    rest.as_ref().iter().any(|&rest| rest != L::Real::default())
}

fn eight_are_as_one<L: Lanes<Level = Portable, Real: Real>>()
where
    L::Real: Lanes<Real = L::Real, Level = Portable, Mask = bool>,
{
    for plan in [ur5(), puma()] {
        let arm = plan.arm::<L::Real>();
        let (targets, starts) = drawn::<L::Real>(&plan, 64);
        let options = Options::default();
        let mut differ = 0;
        for (targets, starts) in targets.chunks(8).zip(starts.chunks(8)) {
            let records: Vec<_> = targets.iter().map(|target| target.to_array()).collect();
            let target = batch::DualQuat::<L>::load_records(Portable, &records);
            let mut values = L::load_records(Portable, starts, [L::Real::ZERO; 6]);
            let mut reports = [Report::default(); 8];
            arm.reach_lanes(target, &mut values, &options).store(&mut reports);
            let mut together = [[L::Real::ZERO; 6]; 8];
            L::store_records(values, &mut together);

            for lane in 0..8 {
                let mut alone = starts[lane];
                let mut report = arm.reach(targets[lane], &mut alone, &options);
                let in_lane = reports[lane];
                if fuses::<L>() {
                    differ += u32::from(in_lane.outcome != report.outcome);
                    if in_lane.outcome == Outcome::Converged {
                        assert_reached(&arm, targets[lane], &together[lane]);
                    }
                    (alone, report) = in_every_lane::<L>(&arm, targets[lane], starts[lane]);
                }
                assert_eq!(in_lane.outcome, report.outcome, "lane {lane}");
                assert_eq!(in_lane.iterations, report.iterations, "lane {lane}");
                assert_eq!(in_lane.restarts, report.restarts, "lane {lane}");
                let tolerance = if L::Real::SINGLE { 2e-4 } else { 1e-12 };
                for (alone, together) in alone.into_iter().zip(together[lane]) {
                    let apart: f64 = (alone - together).into();
                    assert!(apart.abs() < tolerance, "lane {lane}: {apart:e}");
                }
            }
        }
        assert!(differ <= 2, "{differ} of 64");
    }
}

/// One target in all lanes: alone, and rounded as among others.
fn in_every_lane<L: Lanes<Level = Portable, Real: Real>>(
    arm: &Arm<L::Real, 6>,
    target: DualQuat<L::Real>,
    start: [L::Real; 6],
) -> ([L::Real; 6], Report<L::Real, Outcome>) {
    let target = batch::DualQuat::<L>::splat(Portable, target.to_array());
    let mut values = start.map(|value| L::splat(Portable, value));
    let mut reports = [Report::default(); 8];
    arm.reach_lanes(target, &mut values, &Options::default()).store(&mut reports);
    (values.map(|value| value.to_array().as_ref()[0]), reports[0])
}

fn assert_reached<R: Real + Float>(arm: &Arm<R, 6>, target: DualQuat<R>, values: &[R; 6]) {
    let pose = arm.forward(values);
    let most = 1e-5 + 32.0 * Into::<f64>::into(<R as Real>::EPSILON);
    assert!(pose.distance_to(target).into() < most && pose.angle_to(target).into() < most);
}

#[test]
fn eight_targets_at_once_are_reached_as_one_at_a_time() {
    eight_are_as_one::<f64x8>();
    eight_are_as_one::<f32x8>();
}

/// The best backend's lanes in another order, and another number of them.
fn neighbours_do_not_matter<R: Real + Float>() {
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
fn every_backend_agrees<R: Real + Float>() {
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
            if impossible.contains(&a.outcome) || a.restarts == <R as Real>::ZERO {
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

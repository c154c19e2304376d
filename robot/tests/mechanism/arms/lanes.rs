//! Many targets at once against one at a time, on every backend.

use dq8::simd::{Portable, f64x8};
use dq8::{Backend, DualQuat, Lanes, Real, Scalar};
use dq8_arms::{Plan, Random, puma, rounded, ur5};
use dq8_robot::ik::{Options, Report};

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

/// Whether the portable lanes round a multiply-add once, as the instructions of the build target
/// may.
fn portable_lanes_fuse() -> bool {
    let x = <f64x8 as Lanes>::splat(Portable, 1.1);
    let rest = Lanes::to_array(Lanes::mul_add(x, x, -(x * x)));
    rest.as_ref().iter().any(|&rest| rest != 0.0)
}

/// Lanes that round a multiply-add once come to other last bits than plain numbers that round
/// twice, and near singular poses the last bit becomes another way to the target: all but a few
/// searches are the same, and what is called reached is.
fn many_are_as_one<R>()
where
    R: Scalar + Lanes<Real = R, Level = Portable, Mask = bool>,
{
    let options = Options::default();
    for plan in [ur5(), puma()] {
        let arm = plan.arm::<R>();
        let (targets, starts) = drawn::<R>(&plan, 64);
        for backend in Backend::available() {
            let mut values = starts.clone();
            let reports = arm.reach_all(backend, &targets, &mut values, &options);
            let (mut differ, mut other_way) = (0, 0);
            for (index, (together, in_lane)) in values.iter().zip(&reports).enumerate() {
                let mut alone = starts[index];
                let report = arm.reach(targets[index], &mut alone, &options);
                differ += u32::from(in_lane.outcome != report.outcome);
                for (values, report) in [(&alone, &report), (together, in_lane)] {
                    let (pose, target) = (arm.forward(values), targets[index]);
                    let apart = [pose.distance_to(target), pose.angle_to(target)].map(Into::into);
                    let most = 1e-5 + 32.0 * Into::<f64>::into(<R as Real>::EPSILON);
                    assert!(
                        !report.is_converged() || apart.iter().all(|&apart: &f64| apart < most)
                    );
                }
                let tolerance = if size_of::<R>() == 4 { 2e-4 } else { 1e-12 };
                let same = |(a, b): (&R, &R)| {
                    Into::<f64>::into(*a - *b).abs() < tolerance || a.is_nan() && b.is_nan()
                };
                let steps = |report: &Report<R>| (report.iterations, report.restarts);
                let same_way = steps(in_lane) == steps(&report);
                other_way += u32::from(!(same_way && alone.iter().zip(together).all(same)));
            }
            assert!(differ <= 2, "{backend}: {differ} of 64");
            let rounds_alike = backend == Backend::PORTABLE && !portable_lanes_fuse();
            let most = if rounds_alike { 0 } else { 6 };
            assert!(other_way <= most, "{backend}: {other_way} of 64");
        }
    }
}

#[test]
fn targets_on_lanes_are_reached_as_one_at_a_time() {
    many_are_as_one::<f64>();
    many_are_as_one::<f32>();
}

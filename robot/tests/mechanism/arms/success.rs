//! How often a reachable target is reached, and in how many iterations.

use dq8::{Backend, DualQuat, Real, Scalar};
use dq8_arms::{Plan, Random, exact, gantry, puma, rounded, seven, ur5};
use dq8_robot::ik::{Options, Outcome};

/// What came of random targets from random starts.
struct Rate {
    reached: f64,
    iterations: f64,
}

/// What is asked of an arm of six axes.
fn in_fewer_than_30<R: Real>() -> Options<R> {
    Options { max_iterations: 29, ..Options::default() }
}

/// Targets from joint values within the limits, starts within them. What is called reached must be so
/// for nalgebra, in `f64`.
fn rate<R: Scalar, const N: usize>(plan: &Plan<N>, targets: usize, options: &Options<R>) -> Rate {
    let arm = plan.arm::<R>();
    let mut random = Random(2026);
    let goals: Vec<[f64; N]> = (0..targets).map(|_| plan.draw(&mut random)).collect();
    let poses: Vec<DualQuat<R>> = goals.iter().map(|&goal| arm.forward(&rounded(goal))).collect();
    let mut values: Vec<[R; N]> = (0..targets).map(|_| rounded(plan.draw(&mut random))).collect();
    let reports = arm.reach_all(Backend::best(), &poses, &mut values, options);

    // What the poses themselves are rounded by.
    let rounding = if size_of::<R>() == 4 { 2e-6 } else { 2e-14 };
    let (mut reached, mut iterations) = (0.0, 0.0);
    for ((goal, value), report) in goals.iter().zip(&values).zip(&reports) {
        for ((&value, axis), [low, high]) in
            value.iter().zip(&plan.axes).zip(plan.axes.map(|axis| rounded::<R, 2>(axis.limits)))
        {
            assert!(low <= value && value <= high, "{value} is not within {:?}", axis.limits);
        }
        let apart = plan.apart(&exact(*value), goal);
        let errors = [report.angular_error, report.linear_error].map(Into::<f64>::into);
        for (error, apart) in errors.into_iter().zip(apart) {
            assert!((error - apart).abs() < rounding, "{error} is {apart}");
        }
        if report.outcome == Outcome::Converged {
            assert!(apart.iter().all(|&apart| apart < 1e-5 + rounding), "{apart:?}");
            let count: f64 = report.iterations.into();
            assert!(count <= f64::from(options.max_iterations));
            reached += 1.0;
            iterations += count;
        }
    }
    Rate { reached: reached / targets as f64, iterations: iterations / reached }
}

#[test]
fn an_arm_of_six_axes_reaches_99_of_100_random_targets_in_fewer_than_30_iterations() {
    let double = rate::<f64, 6>(&ur5(), 500, &in_fewer_than_30());
    let single = rate::<f32, 6>(&ur5(), 500, &in_fewer_than_30());
    for (name, rate) in [("f64", double), ("f32", single)] {
        assert!(rate.reached >= 0.99, "{name}: {}", rate.reached);
        assert!(rate.iterations < 7.0, "{name}: {}", rate.iterations);
    }
}

/// With half of the space of its joints forbidden, an arm has fewer solutions for a target.
#[test]
fn narrow_limits_leave_97_of_100() {
    let double = rate::<f64, 6>(&puma(), 500, &in_fewer_than_30());
    let single = rate::<f32, 6>(&puma(), 500, &in_fewer_than_30());
    for (name, rate) in [("f64", double), ("f32", single)] {
        assert!(rate.reached >= 0.97, "{name}: {}", rate.reached);
        assert!(rate.iterations < 9.0, "{name}: {}", rate.iterations);
    }
}

#[test]
fn slides_and_screws_and_more_joints_than_degrees_of_freedom_are_no_harder() {
    let double = rate::<f64, 8>(&gantry(), 400, &in_fewer_than_30());
    assert!(double.reached >= 0.99, "{}", double.reached);
    assert!(double.iterations < 7.0, "{}", double.iterations);
}

#[test]
fn with_default_options_an_arm_of_seven_axes_reaches_998_of_1000_random_targets() {
    let options = Options::default();
    for (name, rate) in [
        ("f64", rate::<f64, 7>(&seven(), 1000, &options)),
        ("f32", rate::<f32, 7>(&seven(), 1000, &Options::default())),
        ("narrow limits", rate::<f64, 6>(&puma(), 500, &options)),
    ] {
        assert!(rate.reached >= 0.998, "{name}: {}", rate.reached);
        assert!(rate.iterations < 9.0, "{name}: {}", rate.iterations);
    }
}

/// What restarts and steps of second order are worth is in the numbers.
#[test]
fn without_restarts_nine_of_ten_starts_lead_there() {
    let once = Options { restarts: false, ..in_fewer_than_30() };
    let rate = rate::<f64, 6>(&ur5(), 500, &once);
    assert!((0.86..0.95).contains(&rate.reached), "{}", rate.reached);
}

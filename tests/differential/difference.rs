//! Central differences in `f64`, on every implementation that has it.

use dq8::{DualQuat, Quat, Twist};
use dq8_contract::case::{Arguments, Case};
use dq8_contract::implementation::{On, implementations};
use dq8_contract::inputs::twist_case as case;
use dq8_contract::lanes::{Motions, Reals};
use dq8_contract::random::Random;

/// The step of a difference, and the error that its square and rounding leave of numbers below 10.
const STEP: f64 = 1e-5;
const TOLERANCE: f64 = 3e-8;

/// A test for each: two ways to the same numbers, on every implementation in `f64`, |ω| up to a limit.
macro_rules! differences {
    ($($name:ident, $limit:literal, |$a:ident| $body:block)*) => {$(
        #[test]
        fn $name() {
            fn sides($a: &Arguments) -> [Vec<Reals>; 2] $body
            implementations().into_iter().filter(|on| !on.single).for_each(|on| check(on, $limit, sides));
        }
    )*};
}

fn check(on: On, limit: f64, sides: fn(&Arguments) -> [Vec<Reals>; 2]) {
    for chunk in up_to(limit).chunks(on.lanes) {
        let [got, wanted] = sides(&Arguments::new(on, chunk));
        assert_eq!(got.len(), wanted.len());
        for (i, (got, wanted)) in got.into_iter().zip(wanted).enumerate() {
            let pairs = got.lanes().into_iter().zip(wanted.lanes());
            for ((got, wanted), case) in pairs.zip(chunk) {
                let close = (got - wanted).abs() < TOLERANCE;
                assert!(close, "{on:?}, {i}: {got:e}, not {wanted:e}, at {case:?}");
            }
        }
    }
}

fn up_to(limit: f64) -> Vec<Case> {
    let mut random = Random(4);
    let spread = (0..40).map(|i| limit * f64::from(i) / 40.0);
    spread.chain([1e-30, 1e-9, 1e-4, 0.9999, 1.0001]).map(|a| case(&mut random, a, 2.0)).collect()
}

/// (after − before)/2h, a number that is as large as a motion's.
fn difference(after: Motions, before: Motions) -> Motions {
    let factor = after.on().splat(0.5 / STEP);
    (after - before).scale(factor)
}

/// The twist that takes `before` to `after`, over 2h.
fn change(step: Motions) -> Vec<Reals> {
    let factor = step.on().splat(0.5 / STEP);
    step.to_twist().scale(factor).to_array().to_vec()
}

/// Motions that differ by ±h times the twist.
fn steps(a: &Arguments, twist: Twist<Reals>) -> (Motions, Motions) {
    let on = a.on;
    let step = twist.scale(on.splat(STEP));
    (on.from_twist(step), on.from_twist(-step))
}

differences! {
    a_derivative_in_the_fixed_frame, 3.0, |a| {
        let (after, before) = steps(a, a.x);
        let got = difference(after * a.a, before * a.a).components();
        [got.to_vec(), a.a.derivative_spatial(a.x).components().to_vec()]
    }

    a_derivative_in_the_moving_frame, 3.0, |a| {
        let (after, before) = steps(a, a.x);
        let got = difference(a.a * after, a.a * before).components();
        [got.to_vec(), a.a.derivative_body(a.x).components().to_vec()]
    }

    integration_starts_with_the_derivative, 3.0, |a| {
        let (h, back) = (a.on.splat(STEP), a.on.splat(-STEP));
        let spatial = (a.a.integrate_spatial(a.x, h), a.a.integrate_spatial(a.x, back));
        let body = (a.a.integrate_body(a.x, h), a.a.integrate_body(a.x, back));
        let got = [difference(spatial.0, spatial.1), difference(body.0, body.1)];
        let wanted = [a.a.derivative_spatial(a.x), a.a.derivative_body(a.x)];
        let flat = |motions: [Motions; 2]| motions.map(Motions::components).concat();
        [flat(got), flat(wanted)]
    }

    left_jacobian, 9.0, |a| {
        let step = a.y.scale(a.on.splat(STEP));
        let (after, before) = (a.on.from_twist(a.x + step), a.on.from_twist(a.x - step));
        [change(after * before.conjugate()), a.on.left_jacobian(a.x, a.y).to_array().to_vec()]
    }

    right_jacobian, 9.0, |a| {
        let step = a.y.scale(a.on.splat(STEP));
        let (after, before) = (a.on.from_twist(a.x + step), a.on.from_twist(a.x - step));
        [change(before.conjugate() * after), a.on.right_jacobian(a.x, a.y).to_array().to_vec()]
    }

    // The logarithm gives the short way only, below π.
    inverse_of_the_left_jacobian, 3.1, |a| {
        let (after, before) = steps(a, a.y);
        let middle = a.on.from_twist(a.x);
        let got = (after * middle).to_twist() - (before * middle).to_twist();
        let got = got.scale(a.on.splat(0.5 / STEP)).to_array().to_vec();
        [got, a.on.left_jacobian_inverse(a.x, a.y).to_array().to_vec()]
    }

    inverse_of_the_right_jacobian, 3.1, |a| {
        let (after, before) = steps(a, a.y);
        let middle = a.on.from_twist(a.x);
        let got = (middle * after).to_twist() - (middle * before).to_twist();
        let got = got.scale(a.on.splat(0.5 / STEP)).to_array().to_vec();
        [got, a.on.right_jacobian_inverse(a.x, a.y).to_array().to_vec()]
    }

    the_velocity_of_a_point, 3.0, |a| {
        let (h, point) = (a.on.splat(STEP), a.wrench.force);
        let body_point = a.a.conjugate().transform_point(point);
        let after = a.a.integrate_spatial(a.x, h).transform_point(body_point);
        let before = a.a.integrate_spatial(a.x, -h).transform_point(body_point);
        let over = a.on.splat(0.5 / STEP);
        let got = (0..3).map(|i| (after[i] - before[i]) * over).collect();
        [got, a.x.velocity_at(point).to_vec()]
    }
}

/// A path whose velocity is known in closed form: two turns about different axes, one after the
/// other, and a cubic.
struct Path {
    first: [f64; 3],
    second: [f64; 3],
}

impl Path {
    fn rotation(&self, s: f64) -> Quat<f64> {
        Quat::from_axis_angle(self.first, s + 0.5 * s * s)
            * Quat::from_axis_angle(self.second, 0.7 - 2.0 * s)
    }

    fn at(&self, s: f64) -> DualQuat<f64> {
        let translation = [3.0 * s, 1.0 - s * s, 2.0 + s * s * s];
        DualQuat::from_rotation_translation(self.rotation(s), translation)
    }

    /// ω = φ̇₁n₁ + φ̇₂R₁n₂, and ṫ.
    fn velocity(&self, s: f64) -> ([f64; 3], [f64; 3]) {
        let turned = Quat::from_axis_angle(self.first, s + 0.5 * s * s).rotate(self.second);
        let angular = std::array::from_fn(|i| (1.0 + s) * self.first[i] - 2.0 * turned[i]);
        (angular, [3.0, -2.0 * s, 3.0 * s * s])
    }
}

#[test]
fn velocities_along_a_known_path() {
    let mut random = Random(5);
    for i in 0..50 {
        let path = Path { first: random.direction(), second: random.direction() };
        let s = f64::from(i) / 25.0 - 1.0;
        let (pose, (angular, linear)) = (path.at(s), path.velocity(s));
        let rate = (path.at(s + STEP) - path.at(s - STEP)).scale(0.5 / STEP);
        let [x, y, z] = pose.translation();
        let [wx, wy, wz] = angular;
        // ω × t
        let carried = [wy * z - wz * y, wz * x - wx * z, wx * y - wy * x];
        let at_origin = std::array::from_fn(|i| linear[i] - carried[i]);

        let close = |got: &[f64], wanted: &[f64], what: &str| {
            let pairs = got.iter().zip(wanted);
            let error = pairs.fold(0.0, |worst: f64, (a, b)| worst.max((a - b).abs()));
            assert!(error < 3e-8, "{what} at {s}: {got:?}, not {wanted:?}");
        };
        let (got_angular, got_linear) = pose.velocity(rate);
        close(&got_angular, &angular, "ω");
        close(&got_linear, &linear, "ṫ");
        let jia = pose.derivative_from_velocity(angular, linear);
        close(&jia.to_array(), &rate.to_array(), "σ̇ after Jia");
        let spatial = Twist { angular, linear: at_origin };
        close(&pose.spatial_twist(rate).to_array(), &spatial.to_array(), "spatial twist");
        close(&pose.derivative_spatial(spatial).to_array(), &rate.to_array(), "½ξσ");
        let back = pose.rotation().conjugate();
        let body = Twist { angular: back.rotate(angular), linear: back.rotate(linear) };
        close(&pose.body_twist(rate).to_array(), &body.to_array(), "body twist");
        close(&pose.derivative_body(body).to_array(), &rate.to_array(), "½σξ");
        close(&pose.adjoint(body).to_array(), &spatial.to_array(), "Ad");
    }
}

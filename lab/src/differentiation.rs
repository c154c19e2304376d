//! Dual numbers differentiate interpolations: what moves at constant speed, and what does not.

use crate::report::{Chart, Section, Series, Table, scientific};
use crate::{HyperDual, hyper_dual};
use dq8::{Dual, DualQuat, Quat, Real, Twist};
use nalgebra::Vector3;
use std::error::Error;

/// A way from one pose to another, for the number types that differentiate it.
struct Way {
    name: &'static str,
    first: Path<Dual<f64>>,
    second: Path<HyperDual<f64>>,
}

/// The pose at t between two.
type Path<R> = fn([DualQuat<R>; 2], R) -> DualQuat<R>;

/// Each written once, for every number.
const WAYS: [Way; 3] = [
    Way { name: "ScLERP", first: sclerp, second: sclerp },
    Way { name: "NLERP", first: nlerp, second: nlerp },
    Way { name: "SLERP and LERP", first: slerp_lerp, second: slerp_lerp },
];

fn sclerp<R: Real>([a, b]: [DualQuat<R>; 2], t: R) -> DualQuat<R> {
    a.sclerp(b, t)
}

fn nlerp<R: Real>([a, b]: [DualQuat<R>; 2], t: R) -> DualQuat<R> {
    a.nlerp(b, t).normalize()
}

fn slerp_lerp<R: Real>([a, b]: [DualQuat<R>; 2], t: R) -> DualQuat<R> {
    a.slerp_lerp(b, t)
}

/// What is measured at a time.
#[derive(Clone, Copy)]
struct Speed {
    t: f64,
    /// The body twist.
    twist: Twist<f64>,
    /// |σ̈ − ½σ̇ξ|, zero where the body twist does not change.
    change: f64,
}

/// Runs the experiment and writes it up.
///
/// # Errors
/// If the chart cannot be drawn.
pub fn section() -> Result<Section, Box<dyn Error>> {
    let keys = keys();
    let whole = (keys[0].conjugate() * keys[1]).to_twist();
    let mut table = Table::new(
        "Twists on the way, by dual numbers; second derivatives by hyper-dual numbers",
        &[
            "way",
            "slowest turning, rad",
            "fastest turning, rad",
            "largest difference from 2 log(a*b)",
            "largest |σ̈ − ½σ̇ξ|",
        ],
    );
    let (mut found, mut series) = (Vec::new(), Vec::new());
    for way in &WAYS {
        let speeds = speeds(way, keys);
        let turning = |speed: &Speed| Vector3::from(speed.twist.angular).norm();
        let largest =
            |of: &dyn Fn(&Speed) -> f64| speeds.iter().map(of).fold(0.0, Real::max_or_nan);
        let slowest = speeds.iter().map(turning).fold(f64::INFINITY, f64::min);
        let fastest = largest(&turning);
        let off = largest(&|speed| {
            (speed.twist - whole)
                .to_array()
                .into_iter()
                .fold(0.0, |most: f64, c| most.max_or_nan(c.abs()))
        });
        let change = largest(&|speed| speed.change);
        table.row([
            way.name.to_owned(),
            format!("{slowest:.4}"),
            format!("{fastest:.4}"),
            scientific(off),
            scientific(change),
        ]);
        found.push(format!(
            "{}: the body twist differs from 2 log(a*b) by at most {}.",
            way.name,
            scientific(off)
        ));
        let points = speeds.iter().map(|speed| (speed.t, turning(speed))).collect();
        series.push(Series { name: way.name.to_owned(), points });
    }
    let chart = Chart {
        title: "Speed of turning on the way, by dual numbers".to_owned(),
        x: "t".to_owned(),
        y: "radians per unit of t".to_owned(),
        logarithmic: false,
        series,
    };
    Ok(Section {
        title: "Dual numbers differentiate",
        tried:
            "Interpolations of dq8, written for every number type, computed with t + ε and with \
                t + ε₁ + ε₂: velocities and accelerations of the motion between two poses."
                .to_owned(),
        claimed: vec![
            "Jia §2 (eq. 10), Kenwright §5.1 (Taylor series): f(a + εb) = f(a) + ε b f′(a).",
            "Jia §10: ScLERP moves with constant rotation and translation speeds.",
        ],
        found,
        verdict: "Right. The derivative of ScLERP by t is the constant twist 2 log(a*b) at every t, and \
                  the second derivative is negligible compared with it. NLERP is fastest in the middle; SLERP \
                  with LERP turns evenly but its twist is not constant, because the translation is not \
                  that of the screw. One limit: at t = 0 itself the power of the screw has no turn and so \
                  no axis, and dual numbers give no number.",
        body: table.to_html() + &chart.to_svg()?,
    })
}

/// 140° apart about a skew axis, and some way.
fn keys() -> [DualQuat<f64>; 2] {
    let turn = Quat::from_axis_angle([2.0 / 7.0, 6.0 / 7.0, -3.0 / 7.0], 140_f64.to_radians());
    let start = Quat::from_axis_angle([0.6, 0.0, 0.8], 0.5);
    let from = DualQuat::from_rotation_translation(start, [1.0, 0.0, -0.5]);
    [from, from * DualQuat::from_rotation_translation(turn, [0.5, 1.0, 2.0])]
}

fn speeds(way: &Way, keys: [DualQuat<f64>; 2]) -> Vec<Speed> {
    let times = (1..=50).map(|step| f64::from(step) / 50.0);
    times
        .map(|t| {
            let first = (way.first)(keys.map(lifted), Dual::new(t, 1.0)).to_array();
            let sigma = DualQuat::from_array(first.map(|c| c.real));
            let rate = DualQuat::from_array(first.map(|c| c.dual));
            let twist = sigma.body_twist(rate);
            let second = (way.second)(keys.map(lifted), hyper_dual(t, 1.0, 1.0, 0.0));
            let acceleration = DualQuat::from_array(second.to_array().map(|c| c.dual.dual));
            let rest = acceleration - rate.derivative_body(twist);
            let change =
                rest.to_array().into_iter().fold(0.0, |most: f64, c| most.max_or_nan(c.abs()));
            Speed { t, twist, change }
        })
        .collect()
}

/// Constants of another number type.
fn lifted<R: Real>(sigma: DualQuat<f64>) -> DualQuat<R> {
    DualQuat::from_array(sigma.to_array().map(R::from_f64))
}

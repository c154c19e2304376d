//! Laws, on every implementation: two ways to the same numbers.

use crate::case::{Arguments, Case, cases, length};
use dq8::{Twist, Wrench};
use dq8_contract::for_every_implementation;
use dq8_contract::sample::Sample;
use dq8_contract::tolerance::unit_roundoff;

/// A bound in units of u · scale, about one and a half times what was measured, and the two sides.
struct Law<M: Sample> {
    name: &'static str,
    units: f64,
    /// The largest |ω| it holds for.
    limit: f64,
    sides: fn(&Arguments<M>) -> [Vec<M::Real>; 2],
    scale: fn(&Case) -> f64,
}

fn flat<M: Sample>(twist: Twist<M::Real>) -> Vec<M::Real> {
    twist.to_array().to_vec()
}

fn motion<M: Sample>(motion: M) -> Vec<M::Real> {
    motion.components().to_vec()
}

fn wrench<M: Sample>(wrench: Wrench<M::Real>) -> Vec<M::Real> {
    [wrench.force, wrench.torque].concat()
}

/// How large lengths are in a case.
fn far(case: &Case) -> f64 {
    let translation = |c: &[f64; 8]| 1.0 + 2.0 * length(&c[4..]);
    translation(&case.pose) * translation(&case.other) * (1.0 + length(&case.x[3..]))
}

fn step(case: &Case) -> f64 {
    far(case) * (1.0 + case.angle()) * (1.0 + case.dt.abs())
}

fn at_twist(case: &Case) -> f64 {
    (1.0 + case.angle()).powi(2) * (1.0 + length(&case.x[3..])) * (1.0 + length(&case.y))
}

/// (θ/2)/sin(θ/2) grows without end towards 2π.
fn inverse(case: &Case) -> f64 {
    let half = case.angle() / 2.0;
    let grows = if half < 1e-3 { 1.0 } else { (half / half.sin()).abs().max(1.0) };
    at_twist(case) * grows.powi(3)
}

fn laws<M: Sample>() -> Vec<Law<M>> {
    let law = |name, units, limit, sides, scale| Law { name, units, limit, sides, scale };
    vec![
        law(
            "the twist of ½ξσ is ξ, spatial",
            5.0,
            99.0,
            |a| [flat::<M>(a.pose.spatial_twist(a.pose.derivative_spatial(a.x))), flat::<M>(a.x)],
            step,
        ),
        law(
            "the twist of ½σξ is ξ, body",
            5.5,
            99.0,
            |a| [flat::<M>(a.pose.body_twist(a.pose.derivative_body(a.x))), flat::<M>(a.x)],
            step,
        ),
        law(
            "spatial = Ad body",
            9.0,
            99.0,
            |a| {
                [
                    flat::<M>(a.pose.spatial_twist(a.derivative)),
                    flat::<M>(a.pose.adjoint(a.pose.body_twist(a.derivative))),
                ]
            },
            |c| far(c) * (1.0 + length(&c.derivative)),
        ),
        law(
            "½ξσ = ½σ Ad⁻¹ξ",
            5.0,
            99.0,
            |a| {
                [
                    motion(a.pose.derivative_spatial(a.x)),
                    motion(a.pose.derivative_body(a.pose.conjugate().adjoint(a.x))),
                ]
            },
            step,
        ),
        law(
            "Jia's σ̇ = ½ξσ with v = ṫ − ω × t",
            0.25,
            99.0,
            |a| {
                let at_origin = Twist {
                    angular: a.x.angular,
                    linear: a.x.velocity_at(a.pose.translation().map(|c| -c)),
                };
                [
                    motion(a.pose.derivative_from_velocity(a.x.angular, a.x.linear)),
                    motion(a.pose.derivative_spatial(at_origin)),
                ]
            },
            step,
        ),
        law(
            "(ω, ṫ) of Jia's σ̇",
            5.0,
            99.0,
            |a| {
                let (angular, linear) =
                    a.pose.velocity(a.pose.derivative_from_velocity(a.x.angular, a.x.linear));
                [flat::<M>(Twist { angular, linear }), flat::<M>(a.x)]
            },
            step,
        ),
        law(
            "the motion of the twist of a motion",
            8.0,
            99.0,
            |a| [motion(M::from_twist(a.pose.to_twist())), motion(a.pose.canonical())],
            far,
        ),
        law(
            "a twist for dt twice is for 2 dt, spatial",
            4.5,
            99.0,
            |a| {
                [
                    motion(a.pose.integrate_spatial(a.x, a.dt).integrate_spatial(a.x, a.dt)),
                    motion(a.pose.integrate_spatial(a.x, a.dt + a.dt)),
                ]
            },
            step,
        ),
        law(
            "a twist for dt twice is for 2 dt, body",
            4.5,
            99.0,
            |a| {
                [
                    motion(a.pose.integrate_body(a.x, a.dt).integrate_body(a.x, a.dt)),
                    motion(a.pose.integrate_body(a.x, a.dt + a.dt)),
                ]
            },
            step,
        ),
        law(
            "integration in either frame",
            1.6,
            99.0,
            |a| {
                [
                    motion(a.pose.integrate_body(a.x, a.dt)),
                    motion(a.pose.integrate_spatial(a.pose.adjoint(a.x), a.dt)),
                ]
            },
            step,
        ),
        law(
            "Ad of a product",
            8.5,
            99.0,
            |a| {
                [
                    flat::<M>((a.pose * a.other).adjoint(a.x)),
                    flat::<M>(a.pose.adjoint(a.other.adjoint(a.x))),
                ]
            },
            step,
        ),
        law(
            "Ad* of a product",
            9.5,
            99.0,
            |a| {
                [
                    wrench::<M>((a.pose * a.other).coadjoint(a.wrench)),
                    wrench::<M>(a.pose.coadjoint(a.other.coadjoint(a.wrench))),
                ]
            },
            |c| far(c) * (1.0 + length(&c.wrench)),
        ),
        law(
            "Ad of the inverse",
            20.0,
            99.0,
            |a| [flat::<M>(a.pose.conjugate().adjoint(a.pose.adjoint(a.x))), flat::<M>(a.x)],
            step,
        ),
        law(
            "power is the same in both frames",
            0.6,
            99.0,
            |a| {
                [
                    vec![a.pose.coadjoint(a.wrench).power(a.pose.adjoint(a.x))],
                    vec![a.wrench.power(a.x)],
                ]
            },
            |c| step(c) * (1.0 + length(&c.wrench)),
        ),
        law(
            "J_l(x) = Ad J_r(x)",
            2.3,
            99.0,
            |a| {
                [
                    flat::<M>(M::left_jacobian(a.x, a.y)),
                    flat::<M>(M::from_twist(a.x).adjoint(M::right_jacobian(a.x, a.y))),
                ]
            },
            at_twist,
        ),
        law(
            "J(x) x = x",
            0.25,
            99.0,
            |a| {
                [
                    [flat::<M>(M::left_jacobian(a.x, a.x)), flat::<M>(M::right_jacobian(a.x, a.x))]
                        .concat(),
                    [flat::<M>(a.x), flat::<M>(a.x)].concat(),
                ]
            },
            |c| (1.0 + c.angle()).powi(2) * (1.0 + length(&c.x[3..])),
        ),
        law(
            "J_l J_l⁻¹ = 1",
            0.8,
            6.25,
            |a| {
                [
                    flat::<M>(M::left_jacobian(a.x, M::left_jacobian_inverse(a.x, a.y))),
                    flat::<M>(a.y),
                ]
            },
            inverse,
        ),
        law(
            "J_r⁻¹ J_r = 1",
            0.9,
            6.25,
            |a| {
                [
                    flat::<M>(M::right_jacobian_inverse(a.x, M::right_jacobian(a.x, a.y))),
                    flat::<M>(a.y),
                ]
            },
            inverse,
        ),
    ]
}

#[test]
fn laws_hold_on_every_implementation() {
    let cases = cases();
    let (mut broken, mut implementations) = (Vec::new(), 0);
    let mut measured = std::collections::BTreeMap::new();
    for_every_implementation!(|implementation, M| {
        for law in laws::<M>() {
            let cases: Vec<_> =
                cases.iter().filter(|case| case.angle() < law.limit).copied().collect();
            let mut worst = (0.0, cases[0]);
            for chunk in cases.chunks(M::LANES) {
                let arguments = Arguments::<M>::new(chunk);
                // Rounded motions are unit to their last place only.
                let (pose, other) = (arguments.pose.normalize(), arguments.other.normalize());
                let sides = (law.sides)(&Arguments { pose, other, ..arguments });
                let [left, right] = sides.map(|side| side.into_iter().map(M::lanes));
                for (left, right) in left.zip(right) {
                    for ((left, right), case) in left.into_iter().zip(right).zip(chunk) {
                        let error = (left - right).abs() / (law.scale)(case);
                        if error.is_nan() || error > worst.0 {
                            worst = (error, *case);
                        }
                    }
                }
            }
            let units = worst.0 / unit_roundoff(M::SINGLE);
            let so_far = measured.entry(law.name).or_insert(0.0);
            *so_far = units.max(*so_far);
            if units.is_nan() || units > law.units {
                broken.push(format!("{implementation}, {}: {units:.2} at {:?}", law.name, worst.1));
            }
        }
        implementations += 1;
    });
    for (name, units) in measured {
        println!("{name:50} {units:.2}");
    }
    assert!(broken.is_empty(), "{}", broken.join("\n"));
    assert_eq!(implementations, dq8_contract::sample::implementations(), "something did not run");
}

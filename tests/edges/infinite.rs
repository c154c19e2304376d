//! Infinities in one component and finite numbers in all others.

use dq8::{
    Line,
    geometry::{DualVector, Screw},
};
use dq8_contract::implementation::{On, implementations};
use dq8_contract::inputs::turn_and_move;
use dq8_contract::lanes::{Motions, Reals};

const ORDINARY: [f64; 8] = [0.5, -0.5, 0.5, 0.5, 1.0, -1.0, 0.25, -1.75];

/// Only its lane 0 is spoilt; the others hold the motion as it was.
fn spoilt(on: On, motion: [f64; 8], component: usize, value: f64) -> Motions {
    let mut lanes = vec![motion; on.lanes];
    lanes[0][component] = value;
    on.gather(&lanes)
}

fn operations(on: On, sigma: Motions) -> Vec<(&'static str, Vec<Reals>)> {
    let other = on.gather(&vec![turn_and_move([1.0, 2.0, 2.0], 0.5, [1.0, 2.0, 3.0]); on.lanes]);
    let quarter = on.splat(0.25);
    let [x, y, z, w, a, b, c, d] = sigma.components();
    let (real, dual) = ([x, y, z], [w, a, b]);
    let axis = Line { direction: real, moment: dual };
    let (log, screw, twist) = (sigma.log(), sigma.to_screw(), sigma.to_twist());
    let motion = |motion: Motions| motion.components().to_vec();
    vec![
        ("log", [log.real, log.dual].concat()),
        ("to_twist", twist.to_array().to_vec()),
        (
            "to_screw",
            [&screw.axis.direction[..], &screw.axis.moment, &[screw.angle, screw.slide]].concat(),
        ),
        ("pow", motion(sigma.pow(quarter))),
        ("sqrt", motion(sigma.sqrt())),
        ("sclerp from", motion(sigma.sclerp(other, quarter))),
        ("sclerp to", motion(other.sclerp(sigma, quarter))),
        ("sclerp_long from", motion(sigma.sclerp_long(other, quarter))),
        ("sclerp_long to", motion(other.sclerp_long(sigma, quarter))),
        ("slerp_lerp", motion(other.slerp_lerp(sigma, quarter))),
        // These take other numbers than eight of a motion, or fewer.
        ("exp", [motion(on.exp(DualVector { real, dual })), vec![c, d]].concat()),
        ("from_screw", motion(on.from_screw(Screw { axis, angle: c, slide: d }))),
    ]
}

#[test]
fn no_screw_operation_answers_an_infinity_with_finite_numbers() {
    for on in implementations() {
        // A turn, a half turn, a translation, and nothing at all.
        let half_turn = turn_and_move([0.0, 0.0, 1.0], std::f64::consts::PI, [1.0, 0.0, 2.0]);
        let translation = [0.0, 0.0, 0.0, 1.0, 1.0, -2.0, 0.5, 0.0];
        let identity = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
        for motion in [ORDINARY, half_turn, translation, identity] {
            let untouched = operations(on, on.same(motion));
            for component in 0..8 {
                for value in [f64::INFINITY, f64::NEG_INFINITY] {
                    let answers = operations(on, spoilt(on, motion, component, value));
                    for ((operation, answer), (_, wanted)) in answers.into_iter().zip(&untouched) {
                        let what = format!("{on:?}, {operation}, {value} in {component}");
                        let answer: Vec<_> = answer.into_iter().map(|c| c.lanes()).collect();
                        let found = answer.iter().any(|lanes| !lanes[0].is_finite());
                        assert!(found, "{what} of {motion:?}: {answer:?}");
                        for (got, wanted) in answer.iter().zip(wanted) {
                            for (got, wanted) in got.iter().zip(wanted.lanes()).skip(1) {
                                let same = got.to_bits() == wanted.to_bits();
                                assert!(same || got.is_nan() && wanted.is_nan(), "{what}: {got}");
                            }
                        }
                    }
                }
            }
        }
    }
}

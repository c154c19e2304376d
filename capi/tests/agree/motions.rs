//! Operations on one motion.

use crate::sample::{COUNT, motions, numbers, rotation, same, vector, wave};
use dq8::DualQuat;
use dq8_capi::Status::Ok as Done;
use dq8_capi::{motion, screw};
use std::slice::from_ref;

macro_rules! agree {
    ($test:ident, $R:ident, $of:ident) => {
        mod $test {
            use super::*;

            type Motion = DualQuat<$R>;

            #[test]
            fn one_motion() {
                use {motion::$of as m, screw::$of as c};
                let (a, b) = (motions(0.0)[1], motions(1.0)[2]);
                let v = vector(3, 4.0);
                let turn = rotation(5, 6.0);
                let (pa, pb, pv, none) =
                    (numbers(from_ref(&a)), numbers(from_ref(&b)), numbers(&v), [Motion::ZERO]);
                let (scaled, log, screw) = (a.scale(3.0), a.log(), a.to_screw());
                let (three, four) = (a.to_matrix3x4(), a.to_matrix4());
                let axis = screw.axis;
                // SAFETY: each argument has as many numbers as it should.
                unsafe {
                    same("identity", &none, |o| m::identity(o), |o| o[0] = Motion::IDENTITY);
                    same(
                        "from parts",
                        &none,
                        |o| m::from_rotation_translation(numbers(&[turn]), pv, o),
                        |o| o[0] = DualQuat::from_rotation_translation(turn, v),
                    );
                    same("mul", &none, |o| m::mul(pa, pb, o), |o| o[0] = a * b);
                    same("mul over b", &[b], |o| m::mul(pa, o, o), |o| o[0] = a * b);
                    same("conjugate", &none, |o| m::conjugate(pa, o), |o| o[0] = a.conjugate());
                    same(
                        "inverse",
                        &none,
                        |o| m::inverse(numbers(&[scaled]), o),
                        |o| o[0] = scaled.inverse(),
                    );
                    same(
                        "normalize",
                        &[scaled],
                        |o| m::normalize(o, o),
                        |o| o[0] = scaled.normalize(),
                    );
                    same("point", &[v], |o| m::point(pa, o, o), |o| o[0] = a.transform_point(v));
                    same(
                        "vector",
                        &[[0.0; 3]],
                        |o| m::vector(pa, pv, o),
                        |o| o[0] = a.transform_vector(v),
                    );
                    same("to 3x4", &[[[9.0; 4]; 3]], |o| m::to_matrix_3x4(pa, o), |o| o[0] = three);
                    same("to 4x4", &[[[9.0; 4]; 4]], |o| m::to_matrix_4x4(pa, o), |o| o[0] = four);
                    same(
                        "from 3x4",
                        &none,
                        |o| m::from_matrix_3x4(numbers(&three), 1e-5, o),
                        |o| o[0] = DualQuat::from_matrix3x4(three),
                    );
                    same(
                        "from 4x4",
                        &none,
                        |o| m::from_matrix_4x4(numbers(&four), 1e-5, o),
                        |o| o[0] = DualQuat::from_matrix3x4(three),
                    );
                    same("nlerp", &none, |o| c::nlerp(pa, pb, 0.3, o), |o| o[0] = a.nlerp(b, 0.3));
                    same(
                        "sclerp",
                        &none,
                        |o| c::sclerp(pa, pb, 0.3, o),
                        |o| o[0] = a.sclerp(b, 0.3),
                    );
                    same(
                        "log",
                        &[[[9.0; 3]; 2]],
                        |o| c::log(pa, o),
                        |o| o[0] = [log.real, log.dual],
                    );
                    same(
                        "exp",
                        &none,
                        |o| c::exp(numbers(&[log.real, log.dual]), o),
                        |o| o[0] = DualQuat::exp(log),
                    );
                    same("pow", &none, |o| c::pow(pa, 0.3, o), |o| o[0] = a.pow(0.3));
                    let ([x, y, z], [u, v, w]) = (axis.direction, axis.moment);
                    let eight = [[x, y, z, u, v, w, screw.angle, screw.slide]];
                    same("to screw", &[[9.0; 8]], |o| c::to_screw(pa, o), |o| o[0] = eight[0]);
                    same(
                        "from screw",
                        &none,
                        |o| c::from_screw(numbers(&eight), o),
                        |o| o[0] = DualQuat::from_screw(screw),
                    );
                    assert_eq!(m::check_unit(pa, 1e-5), Done);
                    let (mut r, mut t) = ([0.0; 4], [0.0; 3]);
                    assert_eq!(
                        m::to_rotation_translation(pa, r.as_mut_ptr(), t.as_mut_ptr()),
                        Done
                    );
                    assert_eq!((r, t), (a.rotation().to_array(), a.translation()));
                    let some = motions(7.0);
                    let weights: Vec<$R> =
                        (0..COUNT).map(|i| 0.5 + wave::<$R>(i, 8.0).abs()).collect();
                    let pairs: Vec<_> = some.iter().copied().zip(weights.iter().copied()).collect();
                    same(
                        "blend",
                        &none,
                        |o| c::blend(numbers(&some), numbers(&weights), COUNT, o),
                        |o| o[0] = DualQuat::dlb(&pairs).unwrap(),
                    );
                }
            }
        }
    };
}
agree!(of_floats, f32, single);
agree!(of_doubles, f64, double);

//! Operations on one motion.

use crate::sample::{COUNT, motions, numbers, rotation, same, vector, wave};
use dq8::DualQuat;
use dq8_capi::Status::Ok as Done;
use dq8_capi::{mean, motion, screw};
use std::slice::from_ref;

macro_rules! agree {
    ($test:ident, $R:ident, $of:ident) => {
        mod $test {
            use super::*;

            type Motion = DualQuat<$R>;

            #[test]
            fn one_motion() {
                use {mean::$of::mean, motion::$of as m, screw::$of as c};
                let (a, b) = (motions(0.0)[1], motions(1.0)[2]);
                let (point, turn, none) = (vector(3, 4.0), rotation(5, 6.0), [Motion::ZERO]);
                let (pa, pb, pv) = (numbers(from_ref(&a)), numbers(from_ref(&b)), numbers(&point));
                let (scaled, log, screw) = (a.scale(3.0), a.log(), a.to_screw());
                let (three, four) = (a.to_matrix3x4(), a.to_matrix4());
                let ([x, y, z], [u, v, w]) = (screw.axis.direction, screw.axis.moment);
                let eight = [x, y, z, u, v, w, screw.angle, screw.slide];
                let some = motions(7.0);
                let weights: Vec<$R> = (0..COUNT).map(|i| 0.5 + wave::<$R>(i, 8.0).abs()).collect();
                let pairs: Vec<_> = some.iter().copied().zip(weights.iter().copied()).collect();
                let mut arrived = -1;
                // SAFETY: each argument has as many numbers as it should.
                unsafe {
                    same! { |o|
                        &none, m::identity(o) => o[0] = Motion::IDENTITY;
                        &none, m::from_rotation_translation(numbers(&[turn]), pv, o)
                            => o[0] = DualQuat::from_rotation_translation(turn, point);
                        &none, m::mul(pa, pb, o) => o[0] = a * b;
                        &[b], m::mul(pa, o, o) => o[0] = a * b;
                        &none, m::conjugate(pa, o) => o[0] = a.conjugate();
                        &none, m::inverse(numbers(&[scaled]), o) => o[0] = scaled.inverse();
                        &[scaled], m::normalize(o, o) => o[0] = scaled.normalize();
                        &[point], m::point(pa, o, o) => o[0] = a.transform_point(point);
                        &[[0.0; 3]], m::vector(pa, pv, o) => o[0] = a.transform_vector(point);
                        &[[[9.0; 4]; 3]], m::to_matrix_3x4(pa, o) => o[0] = three;
                        &[[[9.0; 4]; 4]], m::to_matrix_4x4(pa, o) => o[0] = four;
                        &none, m::from_matrix_3x4(numbers(&three), 1e-5, o)
                            => o[0] = DualQuat::from_matrix3x4(three);
                        &none, m::from_matrix_4x4(numbers(&four), 1e-5, o)
                            => o[0] = DualQuat::from_matrix3x4(three);
                        &none, c::nlerp(pa, pb, 0.3, o) => o[0] = a.nlerp(b, 0.3);
                        &none, c::sclerp(pa, pb, 0.3, o) => o[0] = a.sclerp(b, 0.3);
                        &[[[9.0; 3]; 2]], c::log(pa, o) => o[0] = [log.real, log.dual];
                        &none, c::exp(numbers(&[log.real, log.dual]), o)
                            => o[0] = DualQuat::exp(log);
                        &none, c::pow(pa, 0.3, o) => o[0] = a.pow(0.3);
                        &[[9.0; 8]], c::to_screw(pa, o) => o[0] = eight;
                        &none, c::from_screw(numbers(&eight), o)
                            => o[0] = DualQuat::from_screw(screw);
                        &none, c::blend(numbers(&some), numbers(&weights), COUNT, o)
                            => o[0] = DualQuat::dlb(&pairs).unwrap();
                    }
                    let (to, equal) = (
                        &raw mut arrived,
                        some.clone().into_iter().map(|motion| (motion, 1.0)).collect::<Vec<_>>(),
                    );
                    for (weights, pairs, most, wanted) in [
                        (weights.as_ptr(), &pairs[..], 64, 1),
                        (std::ptr::null(), &equal[..], 64, 1),
                        (weights.as_ptr(), &pairs, 1, 0),
                    ] {
                        same! { |o|
                            &none, mean(numbers(&some), weights, COUNT, 1e-5, most, o, to)
                                => o[0] = DualQuat::dib(pairs, 1e-5, most).unwrap().motion;
                        }
                        assert_eq!(arrived, wanted, "{most} steps");
                    }
                    assert_eq!(m::check_unit(pa, 1e-5), Done);
                    let (mut r, mut t) = ([0.0; 4], [0.0; 3]);
                    let status = m::to_rotation_translation(pa, r.as_mut_ptr(), t.as_mut_ptr());
                    assert_eq!(status, Done);
                    assert_eq!((r, t), (a.rotation().to_array(), a.translation()));
                }
            }
        }
    };
}
agree!(of_floats, f32, single);
agree!(of_doubles, f64, double);

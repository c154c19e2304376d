//! Lines, planes, twists, logarithms and metrics: of one motion, of arrays, of blocks.

use crate::sample::{COUNT, block, motions, numbers, same, vector, wave};
use dq8::simd;
use dq8::storage::Block;
use dq8::{Backend, DualQuat, Line, Plane, Twist};
use dq8_capi::{geometry, lines, metric, slices, twists};
use std::slice::from_ref;

macro_rules! agree {
    ($test:ident, $R:ident, $of:ident, $lanes:literal) => {
        mod $test {
            use super::*;
            use {geometry::$of as g, lines::$of as l, metric::$of as m, twists::$of as t};

            type Motion = DualQuat<$R>;
            type Numbers<const C: usize> = simd::Block<[$R; $lanes], C>;

            fn six(i: usize) -> [$R; 6] {
                let ([a, b, c], [d, e, f]) = (vector(i, 2.0), vector(i, 3.0));
                [a, b, c, d, e, f]
            }

            fn four(i: usize) -> [$R; 4] {
                [2.0, 3.0, 4.0, 5.0].map(|seed| wave(i, seed))
            }

            #[test]
            fn one() {
                let (a, b) = (motions::<$R>(0.0)[1], motions::<$R>(1.0)[2]);
                let (pa, pb, six, four) =
                    (numbers(from_ref(&a)), numbers(from_ref(&b)), six(3), four(4));
                let [x, y, z, u, v, w] = six;
                let twist = Twist::from_array(six);
                let line = a.transform_line(Line { direction: [x, y, z], moment: [u, v, w] });
                let [nx, ny, nz, offset] = four;
                let plane = a.transform_plane(Plane { normal: [nx, ny, nz], offset });
                // SAFETY: each argument has as many numbers as it should.
                unsafe {
                    same(
                        "line",
                        &[six],
                        |o| g::line(pa, o, o),
                        |o| {
                            let ([x, y, z], [u, v, w]) = (line.direction, line.moment);
                            o[0] = [x, y, z, u, v, w];
                        },
                    );
                    same(
                        "plane",
                        &[four],
                        |o| g::plane(pa, o, o),
                        |o| {
                            let [x, y, z] = plane.normal;
                            o[0] = [x, y, z, plane.offset];
                        },
                    );
                    same("twist", &[twist], |o| g::twist(pa, o, o), |o| o[0] = a.adjoint(twist));
                    same("to twist", &[twist], |o| g::to_twist(pa, o), |o| o[0] = a.to_twist());
                    same(
                        "integrate",
                        &[a],
                        |o| g::integrate_body(o, numbers(&six), 0.3, o),
                        |o| o[0] = a.integrate_body(twist, 0.3),
                    );
                    same("angle", &[9.0], |o| g::angle_to(pa, pb, o), |o| o[0] = a.angle_to(b));
                    same(
                        "distance",
                        &[9.0],
                        |o| g::distance_to(pa, pb, o),
                        |o| o[0] = a.distance_to(b),
                    );
                }
            }

            #[test]
            fn plain() {
                const N: usize = COUNT;
                let (a, b) = (motions::<$R>(0.0), motions::<$R>(1.0));
                let sixes: Vec<_> = (0..N).map(six).collect();
                let fours: Vec<_> = (0..N).map(four).collect();
                let times: Vec<$R> = (0..N).map(|i| wave(i, 7.0)).collect();
                let (pa, pb, ps, pf) = (numbers(&a), numbers(&b), numbers(&sixes), numbers(&fours));
                let (pt, none, best) = (numbers(&times), [Motion::ZERO; N], Backend::best());
                let nowhere: [$R; N] = [9.0; N];
                // SAFETY: all arrays have N elements.
                unsafe {
                    same(
                        "conjugate",
                        &none,
                        |o| slices::$of::conjugate(pa, o, N),
                        |o| best.conjugate(&a, o).unwrap(),
                    );
                    same(
                        "conjugate in place",
                        &a,
                        |o| slices::$of::conjugate(o, o, N),
                        |o| best.conjugate_in_place(o),
                    );
                    same(
                        "lines",
                        &[[9.0; 6]; N],
                        |o| l::lines_each(pa, ps, o, N),
                        |o| best.transform_lines_each(&a, &sixes, o).unwrap(),
                    );
                    same(
                        "planes",
                        &[[9.0; 4]; N],
                        |o| l::planes_each(pa, pf, o, N),
                        |o| best.transform_planes_each(&a, &fours, o).unwrap(),
                    );
                    same(
                        "twists",
                        &[[9.0; 6]; N],
                        |o| t::twists_each(pa, ps, o, N),
                        |o| best.transform_twists_each(&a, &sixes, o).unwrap(),
                    );
                    same(
                        "integrate",
                        &none,
                        |o| t::integrate_body(pa, ps, 0.3, o, N),
                        |o| best.integrate_body(&a, &sixes, 0.3, o).unwrap(),
                    );
                    same("log", &[[9.0; 6]; N], |o| t::log(pa, o, N), |o| best.log(&a, o).unwrap());
                    same("exp", &none, |o| t::exp(ps, o, N), |o| best.exp(&sixes, o).unwrap());
                    same(
                        "pow",
                        &none,
                        |o| t::pow_each(pa, pt, o, N),
                        |o| best.pow_each(&a, &times, o).unwrap(),
                    );
                    same(
                        "angles",
                        &nowhere,
                        |o| m::angles(pa, pb, o, N),
                        |o| best.angles(&a, &b, o).unwrap(),
                    );
                    same(
                        "distances",
                        &nowhere,
                        |o| m::distances(pa, pb, o, N),
                        |o| best.distances(&a, &b, o).unwrap(),
                    );
                }
            }

            #[test]
            fn in_blocks() {
                let all = |seed| {
                    let of: Vec<Motion> = motions(seed);
                    [0, 1].map(|k| block(|i| of[(i + k) % COUNT].to_array()))
                };
                let (a, b): ([Block<$R, $lanes>; 2], [Block<$R, $lanes>; 2]) = (all(0.0), all(1.0));
                let sixes: [Numbers<6>; 2] = [0, 5].map(|k| block(|i| six(i + k)));
                let fours: [Numbers<4>; 2] = [0, 5].map(|k| block(|i| four(i + k)));
                let times: [Numbers<1>; 2] = [7.0, 8.0].map(|seed| block(|i| [wave(i, seed)]));
                let (pa, pb, ps, pf) = (numbers(&a), numbers(&b), numbers(&sixes), numbers(&fours));
                let (pt, best) = (numbers(&times), Backend::best());
                let (none, no_six) = ([Block::splat([9.0; 8]); 2], [Numbers::splat([9.0; 6]); 2]);
                let (no_four, no_one) = ([Numbers::splat([9.0; 4]); 2], [Numbers::splat([9.0]); 2]);
                // SAFETY: all arrays have two blocks.
                unsafe {
                    same(
                        "conjugate",
                        &none,
                        |o| slices::$of::blocks_conjugate($lanes, pa, o, 2),
                        |o| best.conjugate(&a, o).unwrap(),
                    );
                    same(
                        "lines",
                        &no_six,
                        |o| l::blocks_lines_each($lanes, pa, ps, o, 2),
                        |o| best.transform_lines_each(&a, &sixes, o).unwrap(),
                    );
                    same(
                        "planes",
                        &no_four,
                        |o| l::blocks_planes_each($lanes, pa, pf, o, 2),
                        |o| best.transform_planes_each(&a, &fours, o).unwrap(),
                    );
                    same(
                        "twists",
                        &no_six,
                        |o| t::blocks_twists_each($lanes, pa, ps, o, 2),
                        |o| best.transform_twists_each(&a, &sixes, o).unwrap(),
                    );
                    same(
                        "integrate",
                        &none,
                        |o| t::blocks_integrate_body($lanes, pa, ps, 0.3, o, 2),
                        |o| best.integrate_body(&a, &sixes, 0.3, o).unwrap(),
                    );
                    same(
                        "log",
                        &no_six,
                        |o| t::blocks_log($lanes, pa, o, 2),
                        |o| best.log(&a, o).unwrap(),
                    );
                    same(
                        "exp",
                        &none,
                        |o| t::blocks_exp($lanes, ps, o, 2),
                        |o| best.exp(&sixes, o).unwrap(),
                    );
                    same(
                        "pow",
                        &none,
                        |o| t::blocks_pow_each($lanes, pa, pt, o, 2),
                        |o| best.pow_each(&a, &times, o).unwrap(),
                    );
                    same(
                        "angles",
                        &no_one,
                        |o| m::blocks_angles($lanes, pa, pb, o, 2),
                        |o| best.angles(&a, &b, o).unwrap(),
                    );
                    same(
                        "distances",
                        &no_one,
                        |o| m::blocks_distances($lanes, pa, pb, o, 2),
                        |o| best.distances(&a, &b, o).unwrap(),
                    );
                }
            }
        }
    };
}
agree!(single_eight, f32, single, 8);
agree!(single_sixteen, f32, single, 16);
agree!(double_four, f64, double, 4);
agree!(double_eight, f64, double, 8);

//! Lines, planes, twists, logarithms and metrics: of one motion, of arrays, of blocks.

use crate::sample::{COUNT, block, for_all_lanes, motions, numbers, same, vector, wave};
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
            type Numbers<const C: usize> = Block<$R, $lanes, C>;

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
                let ([x, y, z], [u, v, w]) = (line.direction, line.moment);
                let line = [x, y, z, u, v, w];
                let [x, y, z, offset] = four;
                let plane = a.transform_plane(Plane { normal: [x, y, z], offset });
                let [x, y, z] = plane.normal;
                let plane = [x, y, z, plane.offset];
                // SAFETY: each argument has as many numbers as it should.
                unsafe {
                    same! { |o|
                        &[six], g::line(pa, o, o) => o[0] = line;
                        &[four], g::plane(pa, o, o) => o[0] = plane;
                        &[twist], g::twist(pa, o, o) => o[0] = a.adjoint(twist);
                        &[twist], g::to_twist(pa, o) => o[0] = a.to_twist();
                        &[a], g::integrate_body(o, numbers(&six), 0.3, o)
                            => o[0] = a.integrate_body(twist, 0.3);
                        &[9.0], g::angle_to(pa, pb, o) => o[0] = a.angle_to(b);
                        &[9.0], g::distance_to(pa, pb, o) => o[0] = a.distance_to(b);
                    }
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
                    same! { |o|
                        &none, slices::$of::conjugate(pa, o, N) => best.conjugate(&a, o).unwrap();
                        &a, slices::$of::conjugate(o, o, N) => best.conjugate_in_place(o);
                        &[[9.0; 6]; N], l::lines_each(pa, ps, o, N)
                            => best.transform_lines_each(&a, &sixes, o).unwrap();
                        &[[9.0; 4]; N], l::planes_each(pa, pf, o, N)
                            => best.transform_planes_each(&a, &fours, o).unwrap();
                        &[[9.0; 6]; N], t::twists_each(pa, ps, o, N)
                            => best.transform_twists_each(&a, &sixes, o).unwrap();
                        &none, t::integrate_body(pa, ps, 0.3, o, N)
                            => best.integrate_body(&a, &sixes, 0.3, o).unwrap();
                        &[[9.0; 6]; N], t::log(pa, o, N) => best.log(&a, o).unwrap();
                        &none, t::exp(ps, o, N) => best.exp(&sixes, o).unwrap();
                        &none, t::pow_each(pa, pt, o, N) => best.pow_each(&a, &times, o).unwrap();
                        &nowhere, m::angles(pa, pb, o, N) => best.angles(&a, &b, o).unwrap();
                        &nowhere, m::distances(pa, pb, o, N) => best.distances(&a, &b, o).unwrap();
                    }
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
                    same! { |o|
                        &none, slices::$of::blocks_conjugate($lanes, pa, o, 2)
                            => best.conjugate(&a, o).unwrap();
                        &no_six, l::blocks_lines_each($lanes, pa, ps, o, 2)
                            => best.transform_lines_each(&a, &sixes, o).unwrap();
                        &no_four, l::blocks_planes_each($lanes, pa, pf, o, 2)
                            => best.transform_planes_each(&a, &fours, o).unwrap();
                        &no_six, t::blocks_twists_each($lanes, pa, ps, o, 2)
                            => best.transform_twists_each(&a, &sixes, o).unwrap();
                        &none, t::blocks_integrate_body($lanes, pa, ps, 0.3, o, 2)
                            => best.integrate_body(&a, &sixes, 0.3, o).unwrap();
                        &no_six, t::blocks_log($lanes, pa, o, 2) => best.log(&a, o).unwrap();
                        &none, t::blocks_exp($lanes, ps, o, 2) => best.exp(&sixes, o).unwrap();
                        &none, t::blocks_pow_each($lanes, pa, pt, o, 2)
                            => best.pow_each(&a, &times, o).unwrap();
                        &no_one, m::blocks_angles($lanes, pa, pb, o, 2)
                            => best.angles(&a, &b, o).unwrap();
                        &no_one, m::blocks_distances($lanes, pa, pb, o, 2)
                            => best.distances(&a, &b, o).unwrap();
                    }
                }
            }
        }
    };
}
for_all_lanes!(agree);

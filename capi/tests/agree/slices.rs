//! Kernels over arrays, plain and in blocks.

use crate::sample::{COUNT, block, for_all_lanes, motions, numbers, same, vector, wave};
use dq8::{Backend, Block, DualQuat, hierarchy::MatrixOrder};
use dq8_capi::{packing, slices};

macro_rules! agree {
    ($test:ident, $R:ident, $of:ident, $lanes:literal) => {
        mod $test {
            use super::*;

            type Motion = DualQuat<$R>;

            #[test]
            fn slices_plain() {
                use slices::$of as s;
                let (a, b) = (motions(0.0), motions(1.0));
                let scaled: Vec<_> = a.iter().map(|motion| motion.scale(3.0)).collect();
                let t: Vec<$R> = (0..COUNT).map(|i| wave(i, 2.0)).collect();
                let points: Vec<[$R; 3]> = (0..COUNT).map(|i| vector(i, 3.0)).collect();
                let (pa, pb, ps, pt) = (numbers(&a), numbers(&b), numbers(&scaled), numbers(&t));
                let (pv, n) = (numbers(&points), COUNT);
                let best = Backend::best();
                let none = [Motion::ZERO; COUNT];
                let nowhere = [[9.0; 3]; COUNT];
                // SAFETY: all arrays have COUNT elements.
                unsafe {
                    same! { |o|
                        &none, s::mul(pa, pb, o, n) => best.mul(&a, &b, o).unwrap();
                        &a, s::mul(o, pb, o, n) => best.mul_in_place(o, &b).unwrap();
                        &none, s::normalize(ps, o, n) => best.normalize(&scaled, o).unwrap();
                        &scaled, s::normalize(o, o, n) => best.normalize_in_place(o);
                        &none, s::inverse(ps, o, n) => best.inverse(&scaled, o).unwrap();
                        &a, s::inverse(o, o, n) => best.inverse_in_place(o);
                        &none, s::nlerp(pa, pb, 0.3, o, n) => best.nlerp(&a, &b, 0.3, o).unwrap();
                        &none, s::sclerp(pa, pb, 0.3, o, n) => best.sclerp(&a, &b, 0.3, o).unwrap();
                        &none, s::nlerp_each(pa, pb, pt, o, n)
                            => best.nlerp_each(&a, &b, &t, o).unwrap();
                        &none, s::sclerp_each(pa, pb, pt, o, n)
                            => best.sclerp_each(&a, &b, &t, o).unwrap();
                        &nowhere, s::points(pa, pv, o, n)
                            => best.transform_points(a[0], &points, o).unwrap();
                        &points, s::points(pb, o, o, n) => best.transform_points_in_place(b[0], o);
                        &nowhere, s::vectors(pa, pv, o, n)
                            => best.transform_vectors(a[0], &points, o).unwrap();
                        &points, s::vectors(pb, o, o, n)
                            => best.transform_vectors_in_place(b[0], o);
                        &nowhere, s::points_each(pa, pv, o, n)
                            => best.transform_points_each(&a, &points, o).unwrap();
                        &nowhere, s::vectors_each(pa, pv, o, n)
                            => best.transform_vectors_each(&a, &points, o).unwrap();
                        &[[[9.0; 4]; 3]; COUNT], s::matrices_3x4(pa, 0, o, n)
                            => best.matrices(&a, MatrixOrder::Rows, o).unwrap();
                        &[[[9.0; 4]; 4]; COUNT], s::matrices_4x4(pa, 1, o, n)
                            => best.matrices(&a, MatrixOrder::Columns, o).unwrap();
                    }
                }
            }

            #[test]
            fn slices_in_blocks() {
                use slices::$of as s;
                let (a, b) = (motions(0.0), motions(1.0));
                let a: [Block<$R, $lanes>; 2] =
                    [0, 1].map(|k| block(|i| a[(i + k) % COUNT].to_array()));
                let b: [Block<$R, $lanes>; 2] =
                    [0, 1].map(|k| block(|i| b[(i + k) % COUNT].to_array()));
                let t: [Block<$R, $lanes, 1>; 2] =
                    [2.0, 3.0].map(|seed| block(|i| [wave(i, seed)]));
                let points: [Block<$R, $lanes, 3>; 2] =
                    [4.0, 5.0].map(|seed| block(|i| vector(i, seed)));
                let by = motions(6.0)[0];
                let (pa, pb, pt, pv) = (numbers(&a), numbers(&b), numbers(&t), numbers(&points));
                let none = [Block::splat([9.0; 8]); 2];
                let nowhere = [Block::splat([9.0; 3]); 2];
                let matrices = [Block::<$R, $lanes, 16>::splat([9.0; 16]); 2];
                let best = Backend::best();
                // SAFETY: all arrays have two blocks.
                unsafe {
                    same! { |o|
                        &none, s::blocks_mul($lanes, pa, pb, o, 2) => best.mul(&a, &b, o).unwrap();
                        &none, s::blocks_normalize($lanes, pa, o, 2)
                            => best.normalize(&a, o).unwrap();
                        &none, s::blocks_inverse($lanes, pa, o, 2) => best.inverse(&a, o).unwrap();
                        &none, s::blocks_nlerp($lanes, pa, pb, 0.3, o, 2)
                            => best.nlerp(&a, &b, 0.3, o).unwrap();
                        &none, s::blocks_sclerp_each($lanes, pa, pb, pt, o, 2)
                            => best.sclerp_each(&a, &b, &t, o).unwrap();
                        &nowhere, s::blocks_points($lanes, numbers(&[by]), pv, o, 2)
                            => best.transform_points(by, &points, o).unwrap();
                        &nowhere, s::blocks_vectors_each($lanes, pa, pv, o, 2)
                            => best.transform_vectors_each(&a, &points, o).unwrap();
                        &matrices, s::blocks_matrices_4x4($lanes, pa, 0, o, 2)
                            => best.matrices(&a, MatrixOrder::Rows, o).unwrap();
                    }
                }
                let size =
                    |components| packing::$of::block_size($lanes, components) * size_of::<$R>();
                assert_eq!(size(8), size_of_val(&a[0]));
                assert_eq!(size(3), size_of_val(&points[0]));
                assert_eq!(size(1), size_of_val(&t[0]));
                assert_eq!(size(4), size_of::<Block<$R, $lanes, 4>>());
                assert_eq!(size(7), size_of::<Block<$R, $lanes, 7>>());
                assert_eq!(size(12), size_of::<Block<$R, $lanes, 12>>());
            }
        }
    };
}
for_all_lanes!(agree);

//! Kernels over arrays of motions and points, plain or in blocks.

use crate::memory::{Input, Output, from_to};
use crate::span::disjoint;
use crate::status::{Done, Status};
use dq8::storage::{AoSoA, Aos, Layout};
use dq8::{Backend, hierarchy::MatrixOrder};

/// In which order the numbers of a matrix lie in memory.
#[repr(i32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// Row after row: C arrays.
    Rows = 0,
    /// Column after column: OpenGL, GPU buffers.
    Columns = 1,
}

impl Order {
    /// What a number from C stands for.
    pub(crate) fn known(order: i32) -> Result<MatrixOrder, Status> {
        match order {
            rows if rows == Self::Rows as i32 => Ok(MatrixOrder::Rows),
            columns if columns == Self::Columns as i32 => Ok(MatrixOrder::Columns),
            _ => Err(Status::UnknownValue),
        }
    }
}

/// # Safety
/// As for [`from_to`], `b` as [`Input::slice`].
unsafe fn mul<L: Layout>(
    a: *const L::Real,
    b: *const L::Real,
    out: *mut L::Real,
    count: usize,
) -> Done {
    let best = Backend::best();
    let b = Input::<L::Record<8>>::new(b, count)?;
    disjoint(&[Output::<L::Record<8>>::new(out, count)?.span], &[b.span])?;
    // SAFETY: promised, and apart.
    let b = unsafe { b.slice() };
    let elsewhere = |a: &[_], to: &mut [_]| best.mul(a, b, to);
    // SAFETY: promised.
    unsafe { from_to(a, out, count, elsewhere, |a| best.mul_in_place(a, b)) }
}

kernel_or_in_place! { normalize(motions: 8) by normalize, normalize_in_place }
kernel_or_in_place! { inverse(motions: 8) by inverse, inverse_in_place }
kernel_or_in_place! { conjugate(motions: 8) by conjugate, conjugate_in_place }
kernel! { nlerp(a: 8, b: 8; t: L::Real) -> 8 by nlerp }
kernel! { nlerp_each(a: 8, b: 8, t: 1) -> 8 by nlerp_each }
kernel! { sclerp(a: 8, b: 8; t: L::Real) -> 8 by sclerp }
kernel! { sclerp_each(a: 8, b: 8, t: 1) -> 8 by sclerp_each }
kernel_or_in_place! {
    points(points: 3) of one motion by transform_points, transform_points_in_place
}
kernel_or_in_place! {
    vectors(vectors: 3) of one motion by transform_vectors, transform_vectors_in_place
}
kernel! { points_each(motions: 8, points: 3) -> 3 by transform_points_each }
kernel! { vectors_each(motions: 8, vectors: 3) -> 3 by transform_vectors_each }
kernel! { matrices_3x4(motions: 8; order: i32 = Order::known(order)?) -> 12 by matrices }
kernel! { matrices_4x4(motions: 8; order: i32 = Order::known(order)?) -> 16 by matrices }

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export! { $R $lanes
            /// `out[i] = a[i] * b[i]`: b acts first. `out` may be `a`.
            mul, blocks_mul(a: *const $R, b: *const $R, out: *mut $R)
        }
        export! { $R $lanes
            /// The unit motions beside `motions`, NaN where there is none; dq8_motion_normalize
            /// tells so. `out` may be `motions`.
            normalize, blocks_normalize(motions: *const $R, out: *mut $R)
        }
        export! { $R $lanes
            /// The inverses of `motions`, unit or not; NaN or infinite where there is none;
            /// dq8_motion_inverse tells so. `out` may be `motions`.
            inverse, blocks_inverse(motions: *const $R, out: *mut $R)
        }
        export! { $R $lanes
            /// The inverses of unit `motions`, which cost nothing but signs. `out` may be
            /// `motions`.
            conjugate, blocks_conjugate(motions: *const $R, out: *mut $R)
        }
        export! { $R $lanes
            /// From `a[i]` to `b[i]` by the shorter way, `t` of it: linear and normalized.
            nlerp, blocks_nlerp(a: *const $R, b: *const $R, t: $R, out: *mut $R)
        }
        export! { $R $lanes
            /// As dq8_nlerp with a number `t[i]` for each.
            nlerp_each, blocks_nlerp_each(
                a: *const $R, b: *const $R, t: *const $R, out: *mut $R
            )
        }
        export! { $R $lanes
            /// From unit `a[i]` to unit `b[i]` by the shorter way, `t` of it, along one screw at
            /// constant speed.
            sclerp, blocks_sclerp(a: *const $R, b: *const $R, t: $R, out: *mut $R)
        }
        export! { $R $lanes
            /// As dq8_sclerp with a number `t[i]` for each.
            sclerp_each, blocks_sclerp_each(
                a: *const $R, b: *const $R, t: *const $R, out: *mut $R
            )
        }
        export! { $R $lanes
            /// `points`, three numbers each, moved by the one unit `motion`. `out` may be `points`.
            points, blocks_points(motion: *const $R, points: *const $R, out: *mut $R)
        }
        export! { $R $lanes
            /// `vectors`, three numbers each, turned by the one unit `motion`: directions do not
            /// translate. `out` may be `vectors`.
            vectors, blocks_vectors(motion: *const $R, vectors: *const $R, out: *mut $R)
        }
        export! { $R $lanes
            /// `points[i]`, three numbers each, moved by the unit `motions[i]`.
            points_each, blocks_points_each(
                motions: *const $R, points: *const $R, out: *mut $R
            )
        }
        export! { $R $lanes
            /// `vectors[i]`, three numbers each, turned by the unit `motions[i]`.
            vectors_each, blocks_vectors_each(
                motions: *const $R, vectors: *const $R, out: *mut $R
            )
        }
        export! { $R $lanes
            /// The matrices `[R | t]` of unit `motions`, twelve numbers each; `order` is one of
            /// enum dq8_matrix_order.
            matrices_3x4, blocks_matrices_3x4(motions: *const $R, order: i32, out: *mut $R)
        }
        export! { $R $lanes
            /// The matrices of unit `motions` with the row 0 0 0 1, sixteen numbers each; `order`
            /// is one of enum dq8_matrix_order.
            matrices_4x4, blocks_matrices_4x4(motions: *const $R, order: i32, out: *mut $R)
        }
    };
}
for_both_numbers!(functions);

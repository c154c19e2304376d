//! Kernels over arrays of motions and points, plain or in blocks.

use crate::memory::{Input, Output, from_to, one_to, read, two_to};
use crate::status::{Done, Status};
use dq8::storage::{AoSoA, Aos, Layout};
use dq8::{Backend, DualQuat, hierarchy::MatrixOrder};

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
    Output::<L::Record<8>>::new(out, count)?.apart_from(&b)?;
    // SAFETY: promised, and apart.
    let b = unsafe { b.slice() };
    let apart = |a: &[_], to: &mut [_]| best.mul(a, b, to);
    // SAFETY: promised.
    unsafe { from_to(a, out, count, apart, |a| best.mul_in_place(a, b)) }
}

/// # Safety
/// As for [`from_to`].
unsafe fn normalize<L: Layout>(motions: *const L::Real, out: *mut L::Real, count: usize) -> Done {
    let best = Backend::best();
    let in_place = |all: &mut [L::Record<8>]| {
        best.normalize_in_place(all);
        Ok(())
    };
    // SAFETY: promised.
    unsafe { from_to(motions, out, count, |from, to| best.normalize(from, to), in_place) }
}

/// # Safety
/// As for [`from_to`].
unsafe fn inverse<L: Layout>(motions: *const L::Real, out: *mut L::Real, count: usize) -> Done {
    let best = Backend::best();
    let in_place = |all: &mut [L::Record<8>]| {
        best.inverse_in_place(all);
        Ok(())
    };
    // SAFETY: promised.
    unsafe { from_to(motions, out, count, |from, to| best.inverse(from, to), in_place) }
}

/// # Safety
/// As for [`from_to`].
unsafe fn conjugate<L: Layout>(motions: *const L::Real, out: *mut L::Real, count: usize) -> Done {
    let best = Backend::best();
    let in_place = |all: &mut [L::Record<8>]| {
        best.conjugate_in_place(all);
        Ok(())
    };
    // SAFETY: promised.
    unsafe { from_to(motions, out, count, |from, to| best.conjugate(from, to), in_place) }
}

from_two! { nlerp: 8, 8 -> 8 by nlerp, t }

/// # Safety
/// As for [`two_to`], `t` as `a`.
unsafe fn nlerp_each<L: Layout>(
    a: *const L::Real,
    b: *const L::Real,
    t: *const L::Real,
    out: *mut L::Real,
    count: usize,
) -> Done {
    let t = Input::<L::Record<1>>::new(t, count)?;
    Output::<L::Record<8>>::new(out, count)?.apart_from(&t)?;
    // SAFETY: promised, and apart.
    let t = unsafe { t.slice() };
    let run = |a: &[L::Record<8>], b: &[L::Record<8>], to: &mut [_]| {
        Backend::best().nlerp_each(a, b, t, to)
    };
    // SAFETY: promised.
    unsafe { two_to(a, b, out, count, run) }
}

from_two! { sclerp: 8, 8 -> 8 by sclerp, t }

/// # Safety
/// As for [`two_to`], `t` as `a`.
unsafe fn sclerp_each<L: Layout>(
    a: *const L::Real,
    b: *const L::Real,
    t: *const L::Real,
    out: *mut L::Real,
    count: usize,
) -> Done {
    let t = Input::<L::Record<1>>::new(t, count)?;
    Output::<L::Record<8>>::new(out, count)?.apart_from(&t)?;
    // SAFETY: promised, and apart.
    let t = unsafe { t.slice() };
    let run = |a: &[L::Record<8>], b: &[L::Record<8>], to: &mut [_]| {
        Backend::best().sclerp_each(a, b, t, to)
    };
    // SAFETY: promised.
    unsafe { two_to(a, b, out, count, run) }
}

/// # Safety
/// As for [`read`] and [`from_to`].
unsafe fn points<L: Layout>(
    motion: *const L::Real,
    points: *const L::Real,
    out: *mut L::Real,
    count: usize,
) -> Done {
    let best = Backend::best();
    // SAFETY: promised.
    let motion: DualQuat<L::Real> = unsafe { read(motion)? };
    let in_place = |all: &mut [L::Record<3>]| {
        best.transform_points_in_place(motion, all);
        Ok(())
    };
    let apart = |from: &[_], to: &mut [_]| best.transform_points(motion, from, to);
    // SAFETY: promised.
    unsafe { from_to(points, out, count, apart, in_place) }
}

/// # Safety
/// As for [`read`] and [`from_to`].
unsafe fn vectors<L: Layout>(
    motion: *const L::Real,
    vectors: *const L::Real,
    out: *mut L::Real,
    count: usize,
) -> Done {
    let best = Backend::best();
    // SAFETY: promised.
    let motion: DualQuat<L::Real> = unsafe { read(motion)? };
    let in_place = |all: &mut [L::Record<3>]| {
        best.transform_vectors_in_place(motion, all);
        Ok(())
    };
    let apart = |from: &[_], to: &mut [_]| best.transform_vectors(motion, from, to);
    // SAFETY: promised.
    unsafe { from_to(vectors, out, count, apart, in_place) }
}

from_two! { points_each: 8, 3 -> 3 by transform_points_each }
from_two! { vectors_each: 8, 3 -> 3 by transform_vectors_each }

/// # Safety
/// As for [`one_to`].
unsafe fn matrices_3x4<L: Layout>(
    motions: *const L::Real,
    order: i32,
    out: *mut L::Real,
    count: usize,
) -> Done {
    let order = Order::known(order)?;
    let run =
        |from: &[L::Record<8>], to: &mut [L::Record<12>]| Backend::best().matrices(from, order, to);
    // SAFETY: promised.
    unsafe { one_to(motions, out, count, run) }
}

/// # Safety
/// As for [`one_to`].
unsafe fn matrices_4x4<L: Layout>(
    motions: *const L::Real,
    order: i32,
    out: *mut L::Real,
    count: usize,
) -> Done {
    let order = Order::known(order)?;
    let run =
        |from: &[L::Record<8>], to: &mut [L::Record<16>]| Backend::best().matrices(from, order, to);
    // SAFETY: promised.
    unsafe { one_to(motions, out, count, run) }
}

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export! { $R $lanes
            /// `out[i] = a[i] * b[i]`: b acts first. `out` may be `a`.
            mul, blocks_mul(a: *const $R, b: *const $R, out: *mut $R)
        }
        export! { $R $lanes
            /// The unit motions beside `motions`, NaN where there is none; dq8_motion_normalize tells
            /// so. `out` may be `motions`.
            normalize, blocks_normalize(motions: *const $R, out: *mut $R)
        }
        export! { $R $lanes
            /// The inverses of `motions`, unit or not; NaN or infinite where there is none;
            /// dq8_motion_inverse tells so. `out` may be `motions`.
            inverse, blocks_inverse(motions: *const $R, out: *mut $R)
        }
        export! { $R $lanes
            /// The inverses of unit `motions`, which cost nothing but signs. `out` may be `motions`.
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
            /// From unit `a[i]` to unit `b[i]` by the shorter way, `t` of it, along one screw at constant
            /// speed.
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
            /// The matrices `[R | t]` of unit `motions`, twelve numbers each; `order` is one of enum
            /// dq8_matrix_order.
            matrices_3x4, blocks_matrices_3x4(motions: *const $R, order: i32, out: *mut $R)
        }
        export! { $R $lanes
            /// The matrices of unit `motions` with the row 0 0 0 1, sixteen numbers each; `order` is one
            /// of enum dq8_matrix_order.
            matrices_4x4, blocks_matrices_4x4(motions: *const $R, order: i32, out: *mut $R)
        }
    };
}
for_both_numbers!(functions);

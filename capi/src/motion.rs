//! Operations on one motion. The functions read all inputs before they write, so outputs may be
//! inputs.

use crate::memory::{Output, one, read, two};
use crate::span::disjoint;
use crate::status::{Done, Status};
use dq8::{DualQuat, Quat, Real};

/// # Safety
/// `out` must point to memory for a motion, which no other thread uses during the call.
unsafe fn identity<R: Real>(out: *mut R) -> Done {
    let out = Output::new(out, 1)?;
    // SAFETY: the caller guarantees that `out` points to memory for a motion that no other thread
    // uses.
    unsafe { out.write(DualQuat::<R>::IDENTITY) };
    Ok(())
}

/// # Safety
/// `motion` must point to a motion, and `rotation` and `translation` to memory for the outputs. No
/// other thread may use the outputs or write the motion during the call.
unsafe fn to_rotation_translation<R: Real>(
    motion: *const R,
    rotation: *mut R,
    translation: *mut R,
) -> Done {
    let (rotation, translation) = (Output::new(rotation, 1)?, Output::new(translation, 1)?);
    disjoint(&[rotation.span, translation.span], &[])?;
    // SAFETY: the caller guarantees that all three pointers point to a motion or to memory for an
    // output. The motion is read before the outputs are written, and `disjoint` has checked that
    // the outputs do not overlap each other.
    unsafe {
        let motion: DualQuat<R> = read(motion)?;
        rotation.write(motion.rotation());
        translation.write(motion.translation());
    }
    Ok(())
}

/// # Safety
/// `motion` must point to a motion that no other thread writes during the call.
unsafe fn check_unit<R: Real>(motion: *const R, tolerance: R) -> Done {
    // SAFETY: the caller guarantees that `motion` points to a motion that no other thread writes.
    let motion: DualQuat<R> = unsafe { read(motion)? };
    if motion.is_unit(tolerance) { Ok(()) } else { Err(Status::NotUnit) }
}

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export_one! { $R
            /// Writes the identity: the motion that moves nothing.
            motion::identity(out: *mut $R) = super::identity(out)
        }
        export_one! { $R
            /// Makes the motion that rotates by the unit quaternion `rotation` (x, y, z, w), and
            /// then moves by `translation` (x, y, z).
            motion::from_rotation_translation(rotation: *const $R, translation: *const $R, out: *mut $R) =
                two(rotation, translation, out, |rotation: Quat<$R>, translation| {
                    Ok(DualQuat::from_rotation_translation(rotation, translation))
                })
        }
        export_one! { $R
            /// Writes the parts of a unit motion: the quaternion `rotation` (x, y, z, w) and
            /// `translation` (x, y, z), which must not overlap each other.
            motion::to_rotation_translation(
                motion: *const $R, rotation: *mut $R, translation: *mut $R
            ) = super::to_rotation_translation(motion, rotation, translation)
        }
        export_one! { $R
            /// Makes the motion of a matrix of three rows and four columns. `matrix` has twelve
            /// components, row by row. The rows of its rotation must be orthonormal: their dot
            /// products may differ from 0 and 1 by at most `tolerance`.
            ///
            /// Returns DQ8_STATUS_NOT_ORTHONORMAL, _MIRRORS or _NOT_FINITE if the matrix is no
            /// rigid motion.
            motion::from_matrix_3x4(matrix: *const $R, tolerance: $R, out: *mut $R) =
                one(matrix, out, |rows| Ok(DualQuat::try_from_matrix3x4(rows, tolerance)?))
        }
        export_one! { $R
            /// Makes the motion of a matrix of four rows and four columns. `matrix` has sixteen
            /// components, row by row. Returns DQ8_STATUS_NOT_AFFINE if the last row is not 0 0
            /// 0 1. Other arguments and errors are those of dq8_motion_from_matrix_3x4.
            motion::from_matrix_4x4(matrix: *const $R, tolerance: $R, out: *mut $R) =
                one(matrix, out, |rows| Ok(DualQuat::try_from_matrix4(rows, tolerance)?))
        }
        export_one! { $R
            /// Writes the matrix `[R | t]` of a unit motion: twelve components, row by row.
            motion::to_matrix_3x4(motion: *const $R, matrix: *mut $R) =
                one(motion, matrix, |motion: DualQuat<$R>| Ok(motion.to_matrix3x4()))
        }
        export_one! { $R
            /// Writes the 4x4 matrix of a unit motion, with the last row 0 0 0 1: sixteen
            /// components, row by row.
            motion::to_matrix_4x4(motion: *const $R, matrix: *mut $R) =
                one(motion, matrix, |motion: DualQuat<$R>| Ok(motion.to_matrix4()))
        }
        export_one! { $R
            /// Computes the product `a * b`, in which b acts first.
            motion::mul(a: *const $R, b: *const $R, out: *mut $R) =
                two(a, b, out, |a: DualQuat<$R>, b: DualQuat<$R>| Ok(a * b))
        }
        export_one! { $R
            /// Computes the inverse of a unit motion, which only flips signs.
            motion::conjugate(motion: *const $R, out: *mut $R) =
                one(motion, out, |motion: DualQuat<$R>| Ok(motion.conjugate()))
        }
        export_one! { $R
            /// Computes the inverse of a motion that need not be unit. Returns
            /// DQ8_STATUS_NO_INVERSE if the motion has no inverse.
            motion::inverse(motion: *const $R, out: *mut $R) =
                one(motion, out, |motion: DualQuat<$R>| Ok(motion.try_inverse()?))
        }
        export_one! { $R
            /// Normalizes a dual quaternion to a unit motion. Returns DQ8_STATUS_NOT_NORMALIZABLE
            /// if its real part is zero or a component is not finite.
            motion::normalize(motion: *const $R, out: *mut $R) =
                one(motion, out, |motion: DualQuat<$R>| Ok(motion.try_normalize()?))
        }
        export_one! { $R
            /// Checks that a motion is unit. Returns DQ8_STATUS_NOT_UNIT if its norm differs from 1
            /// by more than `tolerance`.
            motion::check_unit(motion: *const $R, tolerance: $R) = super::check_unit(motion, tolerance)
        }
        export_one! { $R
            /// Moves a point (x, y, z) by a unit motion.
            motion::point(motion: *const $R, point: *const $R, out: *mut $R) =
                two(motion, point, out, |motion: DualQuat<$R>, point| {
                    Ok(motion.transform_point(point))
                })
        }
        export_one! { $R
            /// Turns a direction (x, y, z) by a unit motion, which does not translate it.
            motion::vector(motion: *const $R, vector: *const $R, out: *mut $R) =
                two(motion, vector, out, |motion: DualQuat<$R>, vector| {
                    Ok(motion.transform_vector(vector))
                })
        }
    };
}
for_both_numbers!(functions);

//! Operations on one motion. Inputs are read before anything is written, so outputs may be inputs.

use crate::memory::{Output, one, read, two};
use crate::span::apart;
use crate::status::{Done, Status};
use dq8::{DualQuat, Quat, Real};

/// # Safety
/// As for [`Output::write`].
unsafe fn identity<R: Real>(out: *mut R) -> Done {
    let out = Output::new(out, 1)?;
    // SAFETY: promised.
    unsafe { out.write(DualQuat::<R>::IDENTITY) };
    Ok(())
}

/// # Safety
/// As for [`read`] and [`Output::write`].
unsafe fn to_rotation_translation<R: Real>(
    motion: *const R,
    rotation: *mut R,
    translation: *mut R,
) -> Done {
    let (rotation, translation) = (Output::new(rotation, 1)?, Output::new(translation, 1)?);
    apart(&[rotation.span, translation.span], &[])?;
    // SAFETY: promised, and apart.
    unsafe {
        let motion: DualQuat<R> = read(motion)?;
        rotation.write(motion.rotation());
        translation.write(motion.translation());
    }
    Ok(())
}

/// # Safety
/// As for [`read`].
unsafe fn check_unit<R: Real>(motion: *const R, tolerance: R) -> Done {
    // SAFETY: promised.
    let motion: DualQuat<R> = unsafe { read(motion)? };
    if motion.is_unit(tolerance) { Ok(()) } else { Err(Status::NotUnit) }
}

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export_one! { $R
            /// The motion that moves nothing.
            motion::identity(out: *mut $R) = super::identity(out)
        }
        export_one! { $R
            /// Rotate by the unit quaternion `rotation` (x, y, z, w), then move by `translation`
            /// (x, y, z).
            motion::from_rotation_translation(rotation: *const $R, translation: *const $R, out: *mut $R) =
                two(rotation, translation, out, |rotation: Quat<$R>, translation| {
                    Ok(DualQuat::from_rotation_translation(rotation, translation))
                })
        }
        export_one! { $R
            /// The parts of a unit motion: `rotation` four numbers, `translation` three, which must
            /// not overlap each other.
            motion::to_rotation_translation(
                motion: *const $R, rotation: *mut $R, translation: *mut $R
            ) = super::to_rotation_translation(motion, rotation, translation)
        }
        export_one! { $R
            /// The motion of a matrix, twelve numbers, row after row. `tolerance` is how far
            /// products of rows of the rotation may be from 0 and 1.
            ///
            /// DQ8_STATUS_NOT_ORTHONORMAL, _MIRRORS or _NOT_FINITE if it is no rigid motion.
            motion::from_matrix_3x4(matrix: *const $R, tolerance: $R, out: *mut $R) =
                one(matrix, out, |rows| Ok(DualQuat::try_from_matrix3x4(rows, tolerance)?))
        }
        export_one! { $R
            /// As dq8_motion_from_matrix_3x4, of sixteen numbers; DQ8_STATUS_NOT_AFFINE if the last
            /// row is not 0 0 0 1.
            motion::from_matrix_4x4(matrix: *const $R, tolerance: $R, out: *mut $R) =
                one(matrix, out, |rows| Ok(DualQuat::try_from_matrix4(rows, tolerance)?))
        }
        export_one! { $R
            /// The matrix `[R | t]` of a unit motion: twelve numbers, row after row.
            motion::to_matrix_3x4(motion: *const $R, matrix: *mut $R) =
                one(motion, matrix, |motion: DualQuat<$R>| Ok(motion.to_matrix3x4()))
        }
        export_one! { $R
            /// The matrix of a unit motion with the row 0 0 0 1: sixteen numbers, row after row.
            motion::to_matrix_4x4(motion: *const $R, matrix: *mut $R) =
                one(motion, matrix, |motion: DualQuat<$R>| Ok(motion.to_matrix4()))
        }
        export_one! { $R
            /// a * b: b acts first.
            motion::mul(a: *const $R, b: *const $R, out: *mut $R) =
                two(a, b, out, |a: DualQuat<$R>, b: DualQuat<$R>| Ok(a * b))
        }
        export_one! { $R
            /// The inverse of a unit motion, which costs nothing but signs.
            motion::conjugate(motion: *const $R, out: *mut $R) =
                one(motion, out, |motion: DualQuat<$R>| Ok(motion.conjugate()))
        }
        export_one! { $R
            /// The inverse of a motion, unit or not; DQ8_STATUS_NO_INVERSE if there is none.
            motion::inverse(motion: *const $R, out: *mut $R) =
                one(motion, out, |motion: DualQuat<$R>| Ok(motion.try_inverse()?))
        }
        export_one! { $R
            /// The unit motion beside a dual quaternion, exactly; DQ8_STATUS_NOT_NORMALIZABLE if
            /// there is none.
            motion::normalize(motion: *const $R, out: *mut $R) =
                one(motion, out, |motion: DualQuat<$R>| Ok(motion.try_normalize()?))
        }
        export_one! { $R
            /// DQ8_STATUS_NOT_UNIT if the norm of the motion is further from 1 than `tolerance`.
            motion::check_unit(motion: *const $R, tolerance: $R) = super::check_unit(motion, tolerance)
        }
        export_one! { $R
            /// A point, three numbers, moved by a unit motion.
            motion::point(motion: *const $R, point: *const $R, out: *mut $R) =
                two(motion, point, out, |motion: DualQuat<$R>, point| {
                    Ok(motion.transform_point(point))
                })
        }
        export_one! { $R
            /// A direction, three numbers, turned by a unit motion.
            motion::vector(motion: *const $R, vector: *const $R, out: *mut $R) =
                two(motion, vector, out, |motion: DualQuat<$R>, vector| {
                    Ok(motion.transform_vector(vector))
                })
        }
    };
}
for_both_numbers!(functions);

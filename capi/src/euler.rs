//! Rotations from Euler angles, and Euler angles of motions.

use crate::memory::{Output, read};
use crate::span::{Span, disjoint};
use crate::status::{Done, Status};
use core::ffi::c_char;
use dq8::representation::{EulerAngles, EulerAxes, EulerFrame, EulerOrder};
use dq8::{DualQuat, Real};

/// Reads an order: three letters and a zero.
///
/// # Safety
/// `letters` must point to a string that ends in a zero, which no other thread writes during the
/// call.
unsafe fn known(letters: *const c_char) -> Result<EulerOrder, Status> {
    Span::of(letters, 1)?;
    let (mut indices, mut frames) = ([0; 3], [EulerFrame::Extrinsic; 3]);
    for (at, (index, frame)) in indices.iter_mut().zip(&mut frames).enumerate() {
        // SAFETY: the letters before this one are not zero, so the string has this byte.
        let letter = unsafe { letters.add(at).cast::<u8>().read() };
        (*index, *frame) = match letter {
            b'x'..=b'z' => (usize::from(letter - b'x'), EulerFrame::Extrinsic),
            b'X'..=b'Z' => (usize::from(letter - b'X'), EulerFrame::Intrinsic),
            _ => return Err(Status::UnknownValue),
        };
    }
    // SAFETY: the string has three letters before this byte.
    let ends = unsafe { letters.add(3).read() } == 0;
    let axes = EulerAxes::ALL.into_iter().find(|axes| axes.indices() == indices);
    let [frame, ..] = frames;
    match axes {
        Some(axes) if ends && frames == [frame; 3] => Ok(EulerOrder { axes, frame }),
        _ => Err(Status::UnknownValue),
    }
}

/// # Safety
/// `order` must be a string, `angles` must point to three numbers, and `out` to memory for a
/// motion. No other thread may use the output or write the inputs during the call.
unsafe fn from_euler<R: Real>(order: *const c_char, angles: *const R, out: *mut R) -> Done {
    let out = Output::new(out, 1)?;
    // SAFETY: the caller guarantees a string, three angles and memory for a motion. All inputs are
    // read before the output is written.
    unsafe {
        let (order, angles) = (known(order)?, read::<[R; 3], _>(angles)?);
        out.write(DualQuat::from_rotation(EulerAngles { angles, order }.to_quat()));
    }
    Ok(())
}

/// # Safety
/// `motion` must point to a motion, `order` must be a string, `angles` must point to memory for
/// three numbers, and `gimbal_lock` must be null or point to an `i32`. No other thread may use the
/// outputs or write the inputs during the call.
unsafe fn to_euler<R: Real>(
    motion: *const R,
    order: *const c_char,
    angles: *mut R,
    gimbal_lock: *mut i32,
) -> Done {
    let to = Output::<[R; 3]>::new(angles, 1)?;
    let gimbal_lock = Output::<i32>::unless_null(gimbal_lock)?;
    disjoint(&[to.span, gimbal_lock.span], &[])?;
    // SAFETY: the caller guarantees a motion, a string and memory for the outputs, which `disjoint`
    // has checked not to overlap each other. All inputs are read before an output is written.
    unsafe {
        let (order, motion) = (known(order)?, read::<DualQuat<R>, _>(motion)?);
        let found = motion.rotation().to_euler(order);
        to.write(found.angles.angles);
        gimbal_lock.write(found.gimbal_lock.into());
    }
    Ok(())
}

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export_one! { $R
            /// Makes the rotation about the origin of three turns about coordinate axes, the first
            /// turn first. `angles` holds three angles in radians. `order` is a string of three
            /// letters, the axis of the first turn first, and no axis twice in a row. Small letters
            /// such as "xyz" are axes that stay fixed, and capitals such as "ZYX" are axes that
            /// turn with the body. Returns DQ8_STATUS_UNKNOWN_VALUE for any other string.
            motion::from_euler(order: *const c_char, angles: *const $R, out: *mut $R) =
                super::from_euler(order, angles, out)
        }
        export_one! { $R
            /// Writes the three Euler angles of the rotation of a unit motion, in radians, in the
            /// `order` of dq8_motion_from_euler. The middle angle is from -pi/2 to pi/2 if the
            /// three axes differ, and otherwise from 0 to pi. `gimbal_lock`, which may be null, is
            /// set to 1 if the first and the last axis coincide, so that other angles give the same
            /// rotation, and otherwise to 0. The last angle is then 0.
            motion::to_euler(
                motion: *const $R, order: *const c_char, angles: *mut $R, gimbal_lock: *mut i32,
            ) = super::to_euler(motion, order, angles, gimbal_lock)
        }
    };
}
for_both_numbers!(functions);

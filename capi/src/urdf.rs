//! Robots from URDF files, read into joints. This takes the heap, and the feature `urdf`.

use crate::joint::{Joint, JointKind as Kind};
use crate::memory::{Input, Output};
use crate::span::{Span, disjoint};
use crate::status::{Done, Status};
use core::ffi::c_char;
use dq8::Real;
use dq8_robot::JointKind;
use dq8_robot::urdf::Robot;

/// The text of a file, and the memory for the message of an error, as C passes them.
struct File {
    text: *const u8,
    length: usize,
    message: *mut c_char,
    message_size: usize,
}

/// The names of all links, then of all values, each with a zero after it.
fn names(robot: &Robot) -> Vec<u8> {
    let all = robot.link_names().iter().chain(robot.value_names());
    // No name has a zero in it, for XML has no such character.
    all.flat_map(|name| name.bytes().chain([0])).collect()
}

/// The joint in C. Numbers that its kind does not have are 0.
fn described<R: Real>(joint: &dq8_robot::Joint<R>) -> Option<Joint<R>> {
    let none = [R::ZERO; 3];
    let (kind, axis, pitch) = match joint.kind {
        JointKind::Fixed => (Kind::Fixed, none, R::ZERO),
        JointKind::Revolute { axis } => (Kind::Revolute, axis, R::ZERO),
        JointKind::Prismatic { axis } => (Kind::Prismatic, axis, R::ZERO),
        JointKind::Screw { axis, pitch } => (Kind::Screw, axis, pitch),
        JointKind::Planar { normal } => (Kind::Planar, normal, R::ZERO),
        JointKind::Floating => (Kind::Floating, none, R::ZERO),
        // The enum is `non_exhaustive`: a newer `dq8_robot` may have more kinds.
        _ => return None,
    };
    let leader = joint.mimic.map(|mimic| i32::try_from(mimic.joint)).transpose().ok()?;
    Some(Joint {
        parent: joint.parent.map_or(Ok(-1), i32::try_from).ok()?,
        kind: kind as i32,
        placement: joint.placement.to_array(),
        axis,
        pitch,
        mimics: joint.mimic.is_some().into(),
        leader: leader.unwrap_or(0),
        multiplier: joint.mimic.map_or(R::ZERO, |mimic| mimic.multiplier),
        offset: joint.mimic.map_or(R::ZERO, |mimic| mimic.offset),
        limited: joint.limits.is_some().into(),
        limits: joint.limits.unwrap_or([R::ZERO; 2]),
    })
}

/// Reads the robot of a file, and has `write` write what is asked of it. If the text is no robot,
/// the message of the error is written.
///
/// # Safety
/// The arrays of `file` must have their elements. No other thread may use the message or write the
/// text during the call.
unsafe fn read(file: &File, outputs: &[Span], write: impl FnOnce(&Robot) -> Done) -> Done {
    let text = Input::<u8>::new(file.text, file.length)?;
    let message = Output::<u8>::new(file.message, file.message_size)?;
    disjoint(outputs, &[text.span, message.span])?;
    disjoint(&[message.span], &[text.span])?;
    // SAFETY: the caller guarantees that the text has its bytes, and `disjoint` has checked that no
    // output overlaps them.
    match Robot::from_bytes(unsafe { text.slice() }) {
        Ok(robot) => write(&robot),
        Err(error) => {
            let said = error.to_string();
            // SAFETY: the caller guarantees that the message has its bytes, and `disjoint` has
            // checked that they overlap no other array.
            let room = unsafe { message.slice() };
            // The text is cut where it does not fit, and ends with a zero.
            let fits = room.len().saturating_sub(1);
            for (to, from) in room.iter_mut().zip(said.bytes().take(fits).chain([0])) {
                *to = from;
            }
            Err(Status::Urdf)
        }
    }
}

/// Reads a URDF file, of which `text` holds `length` bytes, and writes how large its robot is:
/// `link_count` gets the number of links, and `names_size` the number of bytes that dq8_urdf_joints
/// writes to `names`.
///
/// Returns DQ8_STATUS_URDF if the file describes no robot. Then `message`, which has room for
/// `message_size` bytes, gets a text that says which line is wrong and why, with a zero at the end.
/// It may be null if `message_size` is 0.
///
/// # Safety
/// `text` must hold `length` bytes, and `message` must hold `message_size` bytes. No other thread
/// may use the outputs or write the text during the call.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dq8_urdf_size(
    text: *const u8,
    length: usize,
    link_count: *mut usize,
    names_size: *mut usize,
    message: *mut c_char,
    message_size: usize,
) -> Status {
    // SAFETY: `size` needs arrays of the stated lengths that no other thread uses, which the caller
    // guarantees.
    Status::of(unsafe {
        size(&File { text, length, message, message_size }, link_count, names_size)
    })
}

/// # Safety
/// The arrays of `file` and both outputs must have their elements, which no other thread may use
/// during the call.
unsafe fn size(file: &File, link_count: *mut usize, names_size: *mut usize) -> Done {
    let (links, size) = (Output::<usize>::new(link_count, 1)?, Output::new(names_size, 1)?);
    // SAFETY: the caller guarantees that all arrays have their elements, and `read` checks that the
    // outputs overlap no other array.
    unsafe {
        read(file, &[links.span, size.span], |robot| {
            links.write(robot.joints().len());
            size.write(names(robot).len());
            Ok(())
        })
    }
}

/// The outputs of [`joints`], as C passes them.
struct Results<R> {
    joints: *mut Joint<R>,
    link_count: usize,
    names: *mut c_char,
    names_size: usize,
}

/// # Safety
/// The arrays must have the elements that their counts say. No other thread may use the outputs or
/// write the text during the call.
unsafe fn joints<R: Real>(file: &File, results: Results<R>) -> Done {
    let joints = Output::<Joint<R>>::new(results.joints, results.link_count)?;
    let to_names = Output::<u8>::new(results.names, results.names_size)?;
    // SAFETY: the caller guarantees that all arrays have their elements, and `read` checks that the
    // outputs overlap no other array.
    unsafe {
        read(file, &[joints.span, to_names.span], |robot| {
            let known = robot.joints().iter().map(|joint| described(&joint.cast::<R>()));
            let known: Vec<_> = known.collect::<Option<_>>().ok_or(Status::UnknownValue)?;
            let names = names(robot);
            if known.len() != results.link_count {
                return Err(Status::LengthJoints);
            }
            if !matches!(results.names_size, size if size == 0 || size == names.len()) {
                return Err(Status::LengthNames);
            }
            joints.slice().copy_from_slice(&known);
            if results.names_size > 0 {
                to_names.slice().copy_from_slice(&names);
            }
            Ok(())
        })
    }
}

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export_one! { $R
            /// Reads the joints of a URDF file, of which `text` holds `length` bytes. `joints` gets
            /// `link_count` joints, for dq8_mechanism_make; joint j carries link j, and link 0 is
            /// the root of the file. `names` gets the names of all links, then of all values, each
            /// with a zero after it, and holds `names_size` bytes. `names` may be null if
            /// `names_size` is zero. Both numbers are those that dq8_urdf_size writes, and the
            /// errors are the same.
            ///
            /// Returns DQ8_STATUS_LENGTH_JOINTS or _LENGTH_NAMES if `link_count` or `names_size` is
            /// not the number that dq8_urdf_size has written.
            urdf::joints(
                text: *const u8, length: usize, joints: *mut Joint<$R>, link_count: usize,
                names: *mut c_char, names_size: usize, message: *mut c_char, message_size: usize,
            ) = super::joints(
                &File { text, length, message, message_size },
                Results { joints, link_count, names, names_size },
            )
        }
    };
}
for_both_numbers!(functions);

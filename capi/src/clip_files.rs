//! Files of packed clips, written from frames. This takes the heap.

use crate::memory::{Input, Output};
use crate::span::{Span, disjoint};
use crate::status::{Done, Status};
use dq8::hierarchy::{Clip, PackedClip, PackedError, Tolerance};

/// The frames of a clip, as dq8_clips_pack reads them.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct Frames {
    /// Local poses `[frame][joint]`, of seven components each: a unit quaternion (x, y, z, w), then
    /// a translation (x, y, z).
    pub keys: *const f32,
    /// The number of frames.
    pub count: usize,
    /// The number of frames a second, so that times are in seconds. 0 for times in frames.
    pub rate: f64,
    /// 1 if the clip begins again where it ends, and 0 otherwise.
    pub loops: u32,
}

/// The arguments of [`pack`], as C passes them.
struct Query {
    clips: *const Frames,
    clip_count: usize,
    joint_count: usize,
    tolerance: Tolerance,
    bytes: *mut u8,
    capacity: usize,
    length: *mut usize,
    bad_key: *mut usize,
}

/// Writes a number of bytes that the file of these clips does not exceed, to `bound`. A program
/// that gives dq8_clips_pack so much memory need not call it twice. The arguments are those of
/// dq8_clips_pack, and so are the errors, except that translations are not looked at.
///
/// # Safety
/// `clips` must hold `clip_count` clips, whose keys have the lengths that they state. No other
/// thread may use the outputs or write the inputs during the call.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dq8_clips_bound(
    clips: *const Frames,
    clip_count: usize,
    joint_count: usize,
    bound: *mut usize,
    bad_key: *mut usize,
) -> Status {
    // SAFETY: `bound_of` needs arrays of the stated lengths that no other thread uses, which the
    // caller guarantees.
    Status::of(unsafe { bound_of(clips, clip_count, joint_count, bound, bad_key) })
}

/// # Safety
/// `clips` must hold `clip_count` clips, whose keys have the lengths that they state. No other
/// thread may use the outputs or write the inputs during the call.
unsafe fn bound_of(
    clips: *const Frames,
    clip_count: usize,
    joints: usize,
    bound: *mut usize,
    bad_key: *mut usize,
) -> Done {
    let bound = Output::<usize>::new(bound, 1)?;
    let bad_key = Output::<usize>::unless_null(bad_key)?;
    // SAFETY: the caller guarantees that `clips` and its keys have the stated lengths.
    let (frames, known) = unsafe { known(clips, clip_count, joints, &[bound.span, bad_key.span])? };
    let bytes =
        PackedClip::bound(&known).map_err(|error| fault(&error, frames, joints, &bad_key))?;
    // SAFETY: the caller guarantees that `bound` points to a `usize`, and `known` has checked that
    // it overlaps no other array.
    unsafe { bound.write(bytes) };
    Ok(())
}

/// Checks the clips, and that no output overlaps them or another output. Returns them as C has them
/// and as Rust has them.
///
/// # Safety
/// `clips` must hold `clip_count` clips, whose keys have the lengths that they state, and which no
/// other code writes while `'a` lasts.
#[expect(clippy::type_complexity, reason = "two slices of the same clips")]
unsafe fn known<'a>(
    clips: *const Frames,
    clip_count: usize,
    joints: usize,
    outputs: &[Span],
) -> Result<(&'a [Frames], Vec<Clip<'a, [f32; 7]>>), Status> {
    let clips = Input::<Frames>::new(clips, clip_count)?;
    disjoint(outputs, &[clips.span])?;
    let mut known = Vec::new();
    // SAFETY: the caller guarantees that `clips` holds its elements, and `disjoint` has checked
    // that no output overlaps them.
    let frames = unsafe { clips.slice() };
    for &Frames { keys, count, rate, loops } in frames {
        let keys =
            Input::<[f32; 7]>::new(keys, count.checked_mul(joints).ok_or(Status::TooLarge)?)?;
        disjoint(outputs, &[keys.span])?;
        // SAFETY: the caller guarantees that each clip holds its keys, and `disjoint` has checked
        // that no output overlaps them.
        let clip = Clip::new(joints, unsafe { keys.slice() }).or(Err(Status::NoFrames))?;
        let clip = if rate == 0.0 { clip } else { clip.with_rate(rate) };
        known.push(match loops {
            0 => clip,
            1 => clip.looping(),
            _ => return Err(Status::UnknownValue),
        });
    }
    Ok((frames, known))
}

/// Returns the status of an error, and writes the index of the key that it names.
fn fault(error: &PackedError, frames: &[Frames], joints: usize, bad_key: &Output<usize>) -> Status {
    let (status, place) = match *error {
        PackedError::NotUnit { clip, frame, joint, .. } => {
            (Status::NotUnit, Some((clip, frame, joint)))
        }
        PackedError::Beyond { clip, frame, joint, .. } => {
            (Status::NotFinite, Some((clip, frame, joint)))
        }
        PackedError::Rate { .. } => (Status::UnknownValue, None),
        PackedError::TooLarge => (Status::TooLarge, None),
        _ => (Status::NoFrames, None),
    };
    if let Some((clip, frame, joint)) = place {
        let before: usize = frames.iter().take(clip).map(|clip| clip.count * joints).sum();
        // SAFETY: the caller of the function in C guarantees that `bad_key` is null or points to a
        // `usize`, and `disjoint` has checked that it overlaps no other array.
        unsafe { bad_key.write(before + frame * joints + joint) };
    }
    status
}

/// Packs clips of one skeleton into a file, which dq8_clips_make reads. `clips` holds `clip_count`
/// clips of `joint_count` joints. The file takes about a quarter of the memory of the frames. A
/// rotation is off by at most 5.4e-5 radians, and each coordinate of a translation by at most
/// 1/131068 of the longest side of the box in which its joint moves in all clips, and by the
/// rounding of floats.
///
/// The rotations of a joint in a clip that are all within `angle` radians of the first are kept as
/// the first alone, and its translations that are all within `length_tolerance` of the first along
/// each axis likewise, so they are off by up to this limit more: 2e-5 and 1e-5 suit metres.
/// `bytes` has room for `capacity` bytes, and `length` gets the length of the file. If `capacity`
/// is 0, only `length` is written. dq8_clips_bound tells enough room for less time.
///
/// Returns DQ8_STATUS_LENGTH_BYTES if the file is longer than `capacity`, DQ8_STATUS_NO_FRAMES
/// if there is no clip, frame or joint, and DQ8_STATUS_UNKNOWN_VALUE for a wrong rate or `loops`.
/// Returns DQ8_STATUS_NOT_UNIT or _NOT_FINITE for a wrong local pose, and sets `bad_key`, which may
/// be null, to its index, counted through all clips.
///
/// # Safety
/// `clips` must hold `clip_count` clips, whose keys have the lengths that they state, and `bytes`
/// must hold `capacity` bytes. No other thread may use the outputs or write the inputs during the
/// call.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dq8_clips_pack(
    clips: *const Frames,
    clip_count: usize,
    joint_count: usize,
    angle: f32,
    length_tolerance: f32,
    bytes: *mut u8,
    capacity: usize,
    length: *mut usize,
    bad_key: *mut usize,
) -> Status {
    let tolerance = Tolerance { angle, length: length_tolerance };
    let query =
        Query { clips, clip_count, joint_count, tolerance, bytes, capacity, length, bad_key };
    // SAFETY: `pack` needs arrays of the stated lengths that no other thread uses, which the caller
    // guarantees.
    Status::of(unsafe { pack(&query) })
}

/// # Safety
/// The arrays must have the lengths that the query states. No other thread may use the outputs or
/// write the inputs during the call.
unsafe fn pack(query: &Query) -> Done {
    let bytes = Output::<u8>::new(query.bytes, query.capacity)?;
    let length = Output::<usize>::new(query.length, 1)?;
    let bad_key = Output::<usize>::unless_null(query.bad_key)?;
    let outputs = [bytes.span, length.span, bad_key.span];
    // SAFETY: the caller guarantees that `clips` and its keys have the stated lengths.
    let (frames, known) =
        unsafe { known(query.clips, query.clip_count, query.joint_count, &outputs)? };
    let packed = PackedClip::library(&known, query.tolerance)
        .map_err(|error| fault(&error, frames, query.joint_count, &bad_key))?;
    let file = packed.as_bytes();
    // SAFETY: the caller guarantees `capacity` bytes and a `usize`, and `disjoint` has checked that
    // they overlap no other array.
    unsafe {
        if query.capacity > 0 {
            let room = bytes.slice().get_mut(..file.len()).ok_or(Status::LengthBytes)?;
            room.copy_from_slice(file);
        }
        length.write(file.len());
    }
    Ok(())
}

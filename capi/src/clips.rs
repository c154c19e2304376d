//! Packed clips: functions that find the frame of a time, and compute the model poses there.

use crate::memory::{Input, Output};
use crate::span::{Span, disjoint};
use crate::status::{Done, Status};
use core::mem::MaybeUninit;
use core::ptr;
use dq8::hierarchy::{PackedClips, PackedError, Sampled, TrackPlace};
use dq8::law::NlerpLerp;
use dq8::{DualQuat, Hierarchy, Scalar, hierarchy::Root};

/// Packed clips of one skeleton, made by dq8_clips_make. This struct may be copied and moved. It
/// points to the bytes of the file, which must stay where they are and must not change.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct Clips {
    /// The number of joints of the skeleton. It is 0 in a zeroed struct that dq8_clips_make has not
    /// filled in.
    pub joints: usize,
    /// The number of clips.
    pub clips: usize,
    /// Private to the library.
    // The bytes of a `Known`, if `joints` is not 0.
    opaque: [MaybeUninit<*const u8>; 13],
}

/// The content of [`Clips`]: the clips as the type of `dq8`, and the range of the file's bytes in
/// memory.
#[derive(Clone, Copy)]
struct Known {
    clips: PackedClips<'static>,
    bytes: Span,
}
const _: () = assert!(size_of::<Known>() <= 13 * size_of::<*const ()>());
const _: () = assert!(align_of::<Known>() <= align_of::<*const ()>());

/// A place in a clip: a frame, found by dq8_clips_place. It is valid for the same clips only.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct Place {
    /// Private to the library.
    pub numbers: [u32; 6],
}

/// Makes `clips` from the `length` bytes of a packed clip file. dq8_clips_pack, the Rust
/// package and the Python package write such files. The function reads and checks all bytes once,
/// and copies none.
///
/// Returns DQ8_STATUS_NOT_CLIPS if the bytes are no packed clips. It then sets `bad_offset`, which
/// may be null, to the offset of the first wrong byte.
///
/// # Safety
/// `bytes` must hold `length` bytes, which must not change while the clips are used. No other
/// thread may use the outputs during the call.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dq8_clips_make(
    bytes: *const u8,
    length: usize,
    clips: *mut Clips,
    bad_offset: *mut usize,
) -> Status {
    // SAFETY: `make` needs `length` bytes that do not change, and outputs that no other thread
    // uses, which the caller guarantees.
    Status::of(unsafe { make(bytes, length, clips, bad_offset) })
}

/// # Safety
/// `bytes` must hold `length` bytes, which must not change while the clips are used. No other
/// thread may use the outputs during the call.
unsafe fn make(bytes: *const u8, length: usize, clips: *mut Clips, bad_offset: *mut usize) -> Done {
    let bytes = Input::<u8>::new(bytes, length)?;
    let (made, bad_offset) = (Output::<Clips>::new(clips, 1)?, Output::unless_null(bad_offset)?);
    disjoint(&[made.span, bad_offset.span], &[bytes.span])?;
    // SAFETY: the caller guarantees `length` bytes that do not change while the clips are used, so
    // they may be borrowed for `'static`.
    let known = match PackedClips::from_bytes(unsafe { bytes.slice() }) {
        Ok(clips) => Known { clips, bytes: bytes.span },
        Err(error) => {
            if let PackedError::Bytes { offset, .. } = error {
                // SAFETY: `bad_offset` is null or points to a `usize`, as the caller guarantees,
                // and `disjoint` has checked that it overlaps no other array.
                unsafe { bad_offset.write(offset) };
            }
            return Err(Status::NotClips);
        }
    };
    let opaque = [const { MaybeUninit::uninit() }; 13];
    // SAFETY: `clips` points to a `Clips`, as the caller guarantees, and `disjoint` has checked
    // that it overlaps no other array. `opaque` has the size and alignment of a `Known`, by the
    // assertions above.
    unsafe {
        made.write(Clips { joints: known.clips.joints(), clips: known.clips.clips(), opaque });
        ptr::addr_of_mut!((*clips).opaque).cast::<Known>().write(known);
    }
    Ok(())
}

/// # Safety
/// The clips must be zeroed, or made by dq8_clips_make from bytes that have not changed since.
unsafe fn known(clips: *const Clips) -> Result<(Known, Span), Status> {
    let span = Span::of(clips, 1)?;
    // SAFETY: `Span::of` has checked that the pointer is neither null nor misaligned, and the
    // caller guarantees that the clips are zeroed or made. If `joints` is not 0, they have been
    // made, so `opaque` holds a `Known`.
    unsafe {
        if ptr::addr_of!((*clips).joints).read() == 0 {
            return Err(Status::NoClips);
        }
        Ok((ptr::addr_of!((*clips).opaque).cast::<Known>().read(), span))
    }
}

/// Writes the time from the first to the last frame of a clip. The time is in seconds if the clip
/// has a rate, and in frames otherwise. `clip` is the index of the clip. Returns
/// DQ8_STATUS_UNKNOWN_VALUE if there is no such clip.
///
/// # Safety
/// The clips must be zeroed, or made by dq8_clips_make from bytes that have not changed since. No
/// other thread may use `duration` during the call.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dq8_clips_duration(
    clips: *const Clips,
    clip: usize,
    duration: *mut f64,
) -> Status {
    // SAFETY: `write_duration` needs clips that are zeroed or made, and an output that no other
    // thread uses, which the caller guarantees.
    Status::of(unsafe { write_duration(clips, clip, duration) })
}

/// # Safety
/// The clips must be zeroed, or made from bytes that have not changed since. No other thread may
/// use `duration` during the call.
unsafe fn write_duration(clips: *const Clips, clip: usize, duration: *mut f64) -> Done {
    // SAFETY: the caller guarantees that the clips are zeroed, or made from bytes that have not
    // changed.
    let (Known { clips, bytes }, span) = unsafe { known(clips)? };
    let duration = Output::<f64>::new(duration, 1)?;
    disjoint(&[duration.span], &[span, bytes])?;
    // SAFETY: `duration` points to an `f64`, as the caller guarantees, and `disjoint` has checked
    // that it overlaps neither the clips nor their bytes.
    unsafe { duration.write(clips.duration(clip).ok_or(Status::UnknownValue)?) };
    Ok(())
}

/// # Safety
/// The clips must be zeroed, or made from bytes that have not changed since. No other thread may
/// use `place` and `t` during the call.
unsafe fn place<R: Scalar>(
    clips: *const Clips,
    clip: usize,
    at: R,
    place: *mut Place,
    t: *mut R,
) -> Done {
    // SAFETY: the caller guarantees that the clips are zeroed, or made from bytes that have not
    // changed.
    let (Known { clips, bytes }, span) = unsafe { known(clips)? };
    let (place, to) = (Output::<TrackPlace>::new(place, 1)?, Output::<R>::new(t, 1)?);
    disjoint(&[place.span, to.span], &[span, bytes])?;
    let (found, t) = clips.place(clip, at).ok_or(Status::UnknownValue)?;
    // The time is NaN, or infinite in a clip that loops.
    if t.is_nan() {
        return Err(Status::NotFinite);
    }
    // SAFETY: `place` and `t` point to a `Place` and a float, as the caller guarantees, and
    // `disjoint` has checked that they overlap neither each other nor the clips.
    unsafe {
        place.write(found);
        to.write(t);
    }
    Ok(())
}

/// # Safety
/// The clips must be zeroed, or made from bytes that have not changed since. Each array must have
/// as many elements as its count says. No other thread may use the output or write the inputs
/// during the call.
#[expect(clippy::too_many_arguments, reason = "one per line of the C function")]
unsafe fn to_model<R: Scalar>(
    parents: *const i32,
    joints: usize,
    root: *const R,
    clips: *const Clips,
    places: *const Place,
    t: *const R,
    instances: usize,
    models: *mut R,
) -> Done {
    let parents = crate::hierarchy::parents(parents, joints)?;
    let root = Input::<DualQuat<R>>::unless_null(root)?;
    let (places, t) =
        (Input::<TrackPlace>::new(places, instances)?, Input::<R>::new(t, instances)?);
    // SAFETY: the caller guarantees that the clips are zeroed, or made from bytes that have not
    // changed.
    let (Known { clips, bytes }, span) = unsafe { known(clips)? };
    let count = instances.checked_mul(joints).ok_or(Status::TooLarge)?;
    let models = Output::<DualQuat<R>>::new(models, count)?;
    disjoint(&[models.span], &[parents.span, root.span, places.span, t.span, span, bytes])?;
    // SAFETY: the caller guarantees that each array has as many elements as its count says, and
    // `disjoint` has checked that `models` overlaps no input.
    unsafe {
        let root = root.slice().first().copied().map_or(Root::None, Root::Same);
        let hierarchy = Hierarchy::new(parents.slice())?;
        let sampled = Sampled::new(NlerpLerp, clips, places.slice(), t.slice())?;
        Ok(hierarchy.job().on(root).locals_to_model(sampled, models.slice())?)
    }
}

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export_one! { $R
            /// Finds the time `at` in a clip. It writes the frame before this time to `place`, and
            /// to `t` the fraction of the way from this frame to the next frame, from 0 to 1. Times
            /// are in seconds if the clip has a rate, and in frames otherwise. A time before the
            /// first frame counts as the first frame, and a time after the last frame as the last
            /// frame, unless the clip loops. Returns DQ8_STATUS_UNKNOWN_VALUE if there is no such
            /// clip, and DQ8_STATUS_NOT_FINITE if `at` is NaN, or infinite in a clip that loops.
            clips::place(
                clips: *const Clips, clip: usize, at: $R, place: *mut Place, t: *mut $R,
            ) = super::place(clips, clip, at, place, t)
        }
        export_one! { $R
            /// Computes the model poses of instances that play packed clips. The local poses of
            /// instance i are at the fraction `t[i]` of the way from the frame `places[i]` to the
            /// next frame. `t` is clamped to [0, 1], and NaN gives model poses of NaN. `parents`
            /// and `root` are those of dq8_local_to_model. `models` is `[instance][joint]` and
            /// holds `joint_count` times `instances` motions. Returns DQ8_STATUS_LENGTH_JOINTS if
            /// the clips do not have `joint_count` joints, and DQ8_STATUS_OTHER_CLIPS if a place
            /// belongs to other clips.
            clips::to_model(
                parents: *const i32, joint_count: usize, root: *const $R, clips: *const Clips,
                places: *const Place, t: *const $R, instances: usize, models: *mut $R,
            ) = super::to_model(parents, joint_count, root, clips, places, t, instances, models)
        }
    };
}
for_both_numbers!(functions);

//! Packed clips: places in them, and the model poses at these places.

use crate::memory::{Input, Output};
use crate::span::{Span, disjoint};
use crate::status::{Done, Status};
use core::mem::MaybeUninit;
use core::ptr;
use dq8::hierarchy::{PackedClips, PackedError, Sampled, TrackPlace};
use dq8::law::NlerpLerp;
use dq8::{DualQuat, Hierarchy, Scalar, hierarchy::Root};

/// Packed clips of one skeleton, made by dq8_clips_make. This struct may be copied and moved. The
/// bytes that it was made of must stay where they are and must not change.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct Clips {
    /// The number of joints of the skeleton. It is 0 in a zeroed struct that no clips have been
    /// made in.
    pub joints: usize,
    /// The number of clips.
    pub clips: usize,
    /// Private to the library.
    // A `Known`.
    opaque: [MaybeUninit<*const u8>; 13],
}

/// The content of [`Clips`]: the clips, and the memory of their bytes.
#[derive(Clone, Copy)]
struct Known {
    clips: PackedClips<'static>,
    bytes: Span,
}
const _: () = assert!(size_of::<Known>() <= 13 * size_of::<*const ()>());
const _: () = assert!(align_of::<Known>() <= align_of::<*const ()>());

/// A frame of a clip, made by dq8_clips_place, for use with the same clips.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct Place {
    /// Private to the library.
    pub numbers: [u32; 6],
}

/// Makes `clips` of `length` bytes of a packed clip file, which the Rust package, the Python
/// package and the example mocap write. It reads and checks all bytes once, and copies none.
///
/// Returns DQ8_STATUS_NOT_CLIPS if the bytes are no packed clips, and sets `bad_offset`, which may
/// be null, to the offset of the first wrong byte.
///
/// # Safety
/// Arrays must have the lengths that are named.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dq8_clips_make(
    bytes: *const u8,
    length: usize,
    clips: *mut Clips,
    bad_offset: *mut usize,
) -> Status {
    // SAFETY: the caller keeps the conditions under `# Safety`, which are those of the functions
    // called here.
    Status::of(unsafe { make(bytes, length, clips, bad_offset) })
}

/// # Safety
/// The caller must keep the conditions of [`Input::slice`] and [`Output::write`], and the bytes
/// must not change later.
unsafe fn make(bytes: *const u8, length: usize, clips: *mut Clips, bad_offset: *mut usize) -> Done {
    let bytes = Input::<u8>::new(bytes, length)?;
    let (made, bad_offset) = (Output::<Clips>::new(clips, 1)?, Output::unless_null(bad_offset)?);
    disjoint(&[made.span, bad_offset.span], &[bytes.span])?;
    // SAFETY: the caller guarantees that the bytes are valid and do not change while the clips are
    // used.
    let known = match PackedClips::from_bytes(unsafe { bytes.slice() }) {
        Ok(clips) => Known { clips, bytes: bytes.span },
        Err(error) => {
            if let PackedError::Bytes { offset, .. } = error {
                // SAFETY: the caller guarantees that the memory is valid, and the outputs have been
                // checked to overlap nothing.
                unsafe { bad_offset.write(offset) };
            }
            return Err(Status::NotClips);
        }
    };
    let opaque = [const { MaybeUninit::uninit() }; 13];
    // SAFETY: the caller guarantees that the memory is valid, the outputs have been checked to
    // overlap nothing, and `opaque` has room for the clips, by the assertion above.
    unsafe {
        made.write(Clips { joints: known.clips.joints(), clips: known.clips.clips(), opaque });
        ptr::addr_of_mut!((*clips).opaque).cast::<Known>().write(known);
    }
    Ok(())
}

/// # Safety
/// The clips must be zeroed or made, and their bytes must be what they were then.
unsafe fn known(clips: *const Clips) -> Result<(Known, Span), Status> {
    let span = Span::of(clips, 1)?;
    // SAFETY: `Span::of` has checked that the pointer is neither null nor misaligned. If `joints`
    // is not 0, the clips have been made, so `opaque` was written.
    unsafe {
        if ptr::addr_of!((*clips).joints).read() == 0 {
            return Err(Status::NoClips);
        }
        Ok((ptr::addr_of!((*clips).opaque).cast::<Known>().read(), span))
    }
}

/// Writes the time from the first frame of a clip to its last frame, in seconds if the clip has a
/// rate, and in frames otherwise. Returns DQ8_STATUS_UNKNOWN_VALUE if there is no such clip.
///
/// # Safety
/// Arrays must have the lengths that are named.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dq8_clips_duration(
    clips: *const Clips,
    clip: usize,
    duration: *mut f64,
) -> Status {
    // SAFETY: the caller keeps the conditions under `# Safety`, which are those of the functions
    // called here.
    Status::of(unsafe { write_duration(clips, clip, duration) })
}

/// # Safety
/// The caller must keep the conditions of [`known`] and [`Output::write`].
unsafe fn write_duration(clips: *const Clips, clip: usize, duration: *mut f64) -> Done {
    // SAFETY: the caller keeps the conditions under `# Safety`, which are those of the functions
    // called here.
    let (Known { clips, bytes }, span) = unsafe { known(clips)? };
    let duration = Output::<f64>::new(duration, 1)?;
    disjoint(&[duration.span], &[span, bytes])?;
    // SAFETY: the caller guarantees that the memory is valid, and the outputs have been checked to
    // overlap nothing.
    unsafe { duration.write(clips.duration(clip).ok_or(Status::UnknownValue)?) };
    Ok(())
}

/// # Safety
/// The caller must keep the conditions of [`known`] and [`Output::write`].
unsafe fn place<R: Scalar>(
    clips: *const Clips,
    clip: usize,
    at: R,
    place: *mut Place,
    t: *mut R,
) -> Done {
    // SAFETY: the caller keeps the conditions under `# Safety`, which are those of the functions
    // called here.
    let (Known { clips, bytes }, span) = unsafe { known(clips)? };
    let (place, to) = (Output::<TrackPlace>::new(place, 1)?, Output::<R>::new(t, 1)?);
    disjoint(&[place.span, to.span], &[span, bytes])?;
    let (found, t) = clips.place(clip, at).ok_or(Status::UnknownValue)?;
    // SAFETY: the caller guarantees that the memory is valid, and the outputs have been checked to
    // overlap nothing.
    unsafe {
        place.write(found);
        to.write(t);
    }
    Ok(())
}

/// # Safety
/// The caller must keep the conditions of [`known`], [`Input::slice`] and [`Output::slice`].
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
    // SAFETY: the caller keeps the conditions under `# Safety`, which are those of the functions
    // called here.
    let (Known { clips, bytes }, span) = unsafe { known(clips)? };
    let count = instances.checked_mul(joints).ok_or(Status::TooLarge)?;
    let models = Output::<DualQuat<R>>::new(models, count)?;
    disjoint(&[models.span], &[parents.span, root.span, places.span, t.span, span, bytes])?;
    // SAFETY: the caller guarantees that the memory is valid, and the outputs have been checked to
    // overlap nothing.
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
            /// Finds the time `at` in a clip: writes the frame before it to `place`, and the
            /// fraction of the way from that frame to the next, from 0 to 1, to `t`. Times are
            /// seconds if the clip has a rate, and frames otherwise. A time before the first frame
            /// or after the last one is at that frame, unless the clip loops. Returns
            /// DQ8_STATUS_UNKNOWN_VALUE if there is no such clip.
            clips::place(
                clips: *const Clips, clip: usize, at: $R, place: *mut Place, t: *mut $R,
            ) = super::place(clips, clip, at, place, t)
        }
        export_one! { $R
            /// Computes the model poses of many instances that play packed clips, like
            /// dq8_local_to_model. The local poses of instance i are at the fraction `t[i]` of the
            /// way from the frame `places[i]` to the next one. `t` is clamped to [0, 1], and NaN
            /// gives model poses of NaN. `models` is `[instance][joint]`, with `joint_count` times
            /// `instances` motions. Returns DQ8_STATUS_LENGTH if the clips have another number of
            /// joints, or if a place belongs to other clips.
            clips::to_model(
                parents: *const i32, joint_count: usize, root: *const $R, clips: *const Clips,
                places: *const Place, t: *const $R, instances: usize, models: *mut $R,
            ) = super::to_model(parents, joint_count, root, clips, places, t, instances, models)
        }
    };
}
for_both_numbers!(functions);

//! Packed clips: where an instance is in them, and its models.

use crate::memory::{Input, Output};
use crate::span::{Span, apart};
use crate::status::{Done, Status};
use core::mem::MaybeUninit;
use core::ptr;
use dq8::hierarchy::{PackedClips, PackedError, Sampled, TrackPlace};
use dq8::law::NlerpLerp;
use dq8::{DualQuat, Hierarchy, Scalar, hierarchy::Root};

/// Clips of one skeleton, checked once. It may be copied and moved; the bytes that it was made of
/// must stay where they are, as they are.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct Clips {
    /// How many joints the skeleton has. 0 in clips that have not been made, if they were zeroed.
    pub joints: usize,
    /// How many clips there are.
    pub clips: usize,
    /// Not for you.
    // A `Known`.
    opaque: [MaybeUninit<*const u8>; 13],
}

/// What C keeps, and where its bytes lie.
#[derive(Clone, Copy)]
struct Known {
    clips: PackedClips<'static>,
    bytes: Span,
}
const _: () = assert!(size_of::<Known>() <= 13 * size_of::<*const ()>());
const _: () = assert!(align_of::<Known>() <= align_of::<*const ()>());

/// A clip, and the frame after which an instance is: made by dq8_clips_place, and good for the same
/// clips.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct Place {
    /// Not for you.
    pub numbers: [u32; 6],
}

/// Finds packed clips in bytes of dq8's form, which the Rust and the Python package and the example
/// mocap write. Reads all of them once.
///
/// DQ8_STATUS_NOT_CLIPS if they are none; `bad_offset` is set to the first byte that is wrong, and
/// may be null.
///
/// # Safety
/// Arrays have the lengths named.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dq8_clips_make(
    bytes: *const u8,
    length: usize,
    clips: *mut Clips,
    bad_offset: *mut usize,
) -> Status {
    // SAFETY: promised.
    Status::of(unsafe { make(bytes, length, clips, bad_offset) })
}

/// # Safety
/// As for [`Input::slice`] and [`Output::write`]; the bytes stay as they are.
unsafe fn make(bytes: *const u8, length: usize, clips: *mut Clips, bad_offset: *mut usize) -> Done {
    let bytes = Input::<u8>::new(bytes, length)?;
    let (made, bad_offset) = (Output::<Clips>::new(clips, 1)?, Output::unless_null(bad_offset)?);
    apart(&[made.span, bad_offset.span], &[bytes.span])?;
    // SAFETY: promised; what is made lives as long as C keeps the bytes.
    let known = match PackedClips::from_bytes(unsafe { bytes.slice() }) {
        Ok(clips) => Known { clips, bytes: bytes.span },
        Err(error) => {
            if let PackedError::Bytes { offset, .. } = error {
                // SAFETY: promised, and apart.
                unsafe { bad_offset.write(offset) };
            }
            return Err(Status::NotClips);
        }
    };
    let opaque = [const { MaybeUninit::uninit() }; 13];
    // SAFETY: promised, and apart; clips of the library fit, by the assertion.
    unsafe {
        made.write(Clips { joints: known.clips.joints(), clips: known.clips.clips(), opaque });
        ptr::addr_of_mut!((*clips).opaque).cast::<Known>().write(known);
    }
    Ok(())
}

/// # Safety
/// The clips are zero, or have been made, and their bytes are as they were.
unsafe fn known(clips: *const Clips) -> Result<(Known, Span), Status> {
    let span = Span::of(clips, 1)?;
    // SAFETY: neither null nor misaligned, by `Span::of`; if they have been made, their inside was
    // written.
    unsafe {
        if ptr::addr_of!((*clips).joints).read() == 0 {
            return Err(Status::NoClips);
        }
        Ok((ptr::addr_of!((*clips).opaque).cast::<Known>().read(), span))
    }
}

/// The time from the first frame of a clip to the last: in seconds if the clip has a rate,
/// otherwise in frames. DQ8_STATUS_UNKNOWN_VALUE if there is no such clip.
///
/// # Safety
/// Arrays have the lengths named.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dq8_clips_duration(
    clips: *const Clips,
    clip: usize,
    duration: *mut f64,
) -> Status {
    // SAFETY: promised.
    Status::of(unsafe { write_duration(clips, clip, duration) })
}

/// # Safety
/// As for [`known`] and [`Output::write`].
unsafe fn write_duration(clips: *const Clips, clip: usize, duration: *mut f64) -> Done {
    // SAFETY: promised.
    let (Known { clips, bytes }, span) = unsafe { known(clips)? };
    let duration = Output::<f64>::new(duration, 1)?;
    apart(&[duration.span], &[span, bytes])?;
    // SAFETY: promised, and apart.
    unsafe { duration.write(clips.duration(clip).ok_or(Status::UnknownValue)?) };
    Ok(())
}

/// # Safety
/// As for [`known`] and [`Output::write`].
unsafe fn place<R: Scalar>(
    clips: *const Clips,
    clip: usize,
    at: R,
    place: *mut Place,
    t: *mut R,
) -> Done {
    // SAFETY: promised.
    let (Known { clips, bytes }, span) = unsafe { known(clips)? };
    let (place, to) = (Output::<TrackPlace>::new(place, 1)?, Output::<R>::new(t, 1)?);
    apart(&[place.span, to.span], &[span, bytes])?;
    let (found, t) = clips.place(clip, at).ok_or(Status::UnknownValue)?;
    // SAFETY: promised, and apart.
    unsafe {
        place.write(found);
        to.write(t);
    }
    Ok(())
}

/// # Safety
/// As for [`known`], [`Input::slice`] and [`Output::slice`].
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
    // SAFETY: promised.
    let (Known { clips, bytes }, span) = unsafe { known(clips)? };
    let count = instances.checked_mul(joints).ok_or(Status::TooLarge)?;
    let models = Output::<DualQuat<R>>::new(models, count)?;
    apart(&[models.span], &[parents.span, root.span, places.span, t.span, span, bytes])?;
    // SAFETY: promised, and apart.
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
            /// The frame of a clip before the time `at`, and how far it is from that frame to the
            /// next, from 0 to 1. Times are seconds if the clip has a rate, and frames if it has
            /// none. Before its first frame and after its last one a clip stays there, or is in
            /// another round if it loops. DQ8_STATUS_UNKNOWN_VALUE if there is no such clip.
            clips::place(
                clips: *const Clips, clip: usize, at: $R, place: *mut Place, t: *mut $R,
            ) = super::place(clips, clip, at, place, t)
        }
        export_one! { $R
            /// As dq8_local_to_model, of what lies `t[i]` of the way from the frame of `places[i]`
            /// to the next one: t is cut to [0, 1], and NaN makes models of NaN. `models` are
            /// `[instance][joint]`, `joint_count` times `instances` in all. DQ8_STATUS_LENGTH if
            /// the clips have another number of joints, or a place is one of other clips.
            clips::to_model(
                parents: *const i32, joint_count: usize, root: *const $R, clips: *const Clips,
                places: *const Place, t: *const $R, instances: usize, models: *mut $R,
            ) = super::to_model(parents, joint_count, root, clips, places, t, instances, models)
        }
    };
}
for_both_numbers!(functions);

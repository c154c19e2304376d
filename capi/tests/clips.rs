//! Packed clips: the models are those of Rust, and what is none is refused and writes nothing.

use dq8::hierarchy::{PackedClip, Sampled, Tolerance};
use dq8::law::NlerpLerp;
use dq8::{DualQuat, Hierarchy};
use dq8_capi::Status;
use dq8_capi::clips::{Clips, Place, dq8_clips_make as make, single};
use std::mem::MaybeUninit;
use std::ptr;

const PARENTS: [i32; 3] = [-1, 0, 1];

fn packed() -> PackedClip {
    let key = |i: usize| {
        let angle = 0.2 * (i / 3) as f32 + 0.1 * (i % 3) as f32;
        [angle.sin(), 0.0, 0.0, angle.cos(), 0.0, (i % 3) as f32, 0.1 * (i / 3) as f32]
    };
    let keys: Vec<_> = (0..15).map(key).collect();
    PackedClip::new(3, &keys, Tolerance::default()).unwrap()
}

fn made(bytes: &[u8]) -> (Status, Clips, usize) {
    // SAFETY: all zero bits are clips that have not been made.
    let mut clips: Clips = unsafe { MaybeUninit::zeroed().assume_init() };
    let mut offset = 77;
    // SAFETY: as many bytes, and room for the rest.
    let status = unsafe { make(bytes.as_ptr(), bytes.len(), &raw mut clips, &raw mut offset) };
    (status, clips, offset)
}

#[test]
fn the_models_are_those_of_rust() {
    let packed = packed();
    let (status, clips, _) = made(packed.as_bytes());
    assert_eq!((status, clips.joints, clips.clips), (Status::Ok, 3, 1));
    let (mut places, mut t) = ([Place::default(); 2], [0.0_f32; 2]);
    for (i, at) in [0.5, 3.25].into_iter().enumerate() {
        // SAFETY: there is room for each.
        let status = unsafe { single::place(&clips, 0, at, &raw mut places[i], &raw mut t[i]) };
        assert_eq!(status, Status::Ok);
    }
    let mut models = [DualQuat::<f32>::ZERO; 6];
    let to = models.as_mut_ptr().cast();
    // SAFETY: arrays have as many numbers as they should.
    let status = unsafe {
        single::to_model(
            PARENTS.as_ptr(),
            3,
            ptr::null(),
            &clips,
            places.as_ptr(),
            t.as_ptr(),
            2,
            to,
        )
    };
    assert_eq!(status, Status::Ok);
    let view = packed.clips();
    let (places, t): (Vec<_>, Vec<_>) =
        [0.5_f32, 3.25].iter().filter_map(|&at| view.place(0, at)).unzip();
    let mut wanted = [DualQuat::ZERO; 6];
    let parents = [Hierarchy::ROOT, 0, 1];
    let sampled = Sampled::new(NlerpLerp, view, &places, &t).unwrap();
    Hierarchy::new(&parents).unwrap().job().locals_to_model(sampled, &mut wanted).unwrap();
    assert_eq!(models, wanted);
}

#[test]
fn what_does_not_fit_is_refused_and_nothing_is_written() {
    let packed = packed();
    let mut bytes = packed.as_bytes().to_vec();
    let (_, clips, _) = made(packed.as_bytes());
    bytes[8] = 9;
    let (status, none, offset) = made(&bytes);
    assert_eq!((status, none.joints, offset), (Status::NotClips, 0, 8));
    let (mut place, mut t) = (Place::default(), 5.0_f32);
    let mut models = [DualQuat::<f32>::ZERO; 3];
    let to: *mut f32 = models.as_mut_ptr().cast();
    let at = PARENTS.as_ptr();
    // SAFETY: arrays have as many numbers as they should, or are null.
    unsafe {
        assert_eq!(single::place(&none, 0, 0.0, &raw mut place, &raw mut t), Status::NoClips);
        assert_eq!(single::place(&clips, 1, 0.0, &raw mut place, &raw mut t), Status::UnknownValue);
        assert_eq!(single::place(&clips, 0, 0.0, ptr::null_mut(), &raw mut t), Status::NullPointer);
        assert_eq!((place.numbers, t), ([0; 6], 5.0));
        // No such place: clip 0 has a step.
        let status = single::to_model(at, 3, ptr::null(), &clips, &place, &t, 1, to);
        assert_eq!(status, Status::Length);
        assert_eq!(single::place(&clips, 0, 0.0, &raw mut place, &raw mut t), Status::Ok);
        let status = single::to_model(at, 2, ptr::null(), &clips, &place, &t, 1, to);
        assert_eq!(status, Status::Length);
        let status = single::to_model(at, 3, to, &clips, &place, &t, 1, to);
        assert_eq!(status, Status::Overlap);
    }
    assert_eq!(models, [DualQuat::ZERO; 3]);
}

//! Packed clips.

use super::hierarchies::{parents, unsigned};
use super::memory;
use crate::argument::{Of, Read, count, names, passes, reads, writes};
use crate::element::{wave, zeroed};
use crate::function::Function;
use crate::shape::Shape;
use dq8::hierarchy::{Clip, PackedClip, Root, Sampled, Tolerance, TrackPlace};
use dq8::law::NlerpLerp;
use dq8::{DualQuat, Hierarchy};
use dq8_capi::Status;
use dq8_capi::clip_files::{Frames, dq8_clips_bound, dq8_clips_pack};
use dq8_capi::clips::{Clips, Place, double, dq8_clips_duration, dq8_clips_make, single};
use std::rc::Rc;

/// Clips in C and in Rust.
struct Scene {
    packed: PackedClip,
    made: Clips,
}

/// A clip of five frames. Clips have joints, so it has one if `joints` is 0.
fn scene(joints: usize) -> Rc<Scene> {
    let joints = joints.max(1);
    let key = |at: usize| {
        let (frame, joint) = (at as f32 / joints as f32, wave::<f32>(at % joints, 3));
        let angle = 0.1 * frame + joint;
        [angle.sin(), 0.0, 0.0, angle.cos(), frame, joint, 0.5]
    };
    let keys: Vec<_> = (0..5 * joints).map(key).collect();
    let clip = Clip::new(joints, &keys).expect("frames").with_rate(2.0).looping();
    let packed = PackedClip::new(clip, Tolerance::default()).expect("keys");
    let mut made = zeroed();
    let bytes = packed.as_bytes();
    // SAFETY: the pointer and the length are those of a slice.
    let status =
        unsafe { dq8_clips_make(bytes.as_ptr(), bytes.len(), &raw mut made, std::ptr::null_mut()) };
    assert_eq!(status, Status::Ok);
    Rc::new(Scene { packed, made })
}

/// Adds the function that packs two clips, of which the second loops.
fn add_packing(joints: usize, to: &mut Vec<Function>) {
    let joints = joints.max(1);
    let keys = Rc::new([5, 3].map(|frames| -> Vec<[f32; 7]> {
        let key = |at: usize| {
            let joint = at as f32 / joints as f32;
            [(0.1 * joint).sin(), 0.0, 0.0, (0.1 * joint).cos(), joint, 0.5, -joint]
        };
        (0..frames * joints).map(key).collect()
    }));
    let [first, second] = keys.each_ref().map(|keys| Clip::new(joints, keys).expect("frames"));
    let all = [first, second.with_rate(2.0).looping()];
    let tolerance = Tolerance { angle: 1e-3, length: 1e-4 };
    let file = PackedClip::library(&all, tolerance).expect("keys").as_bytes().to_vec();
    let (length, most) = (file.len(), PackedClip::bound(&all).expect("keys"));
    assert!(length <= most, "{length} {most}");
    let of_c = move |keys: &[Vec<[f32; 7]>; 2], at: usize| {
        let (rate, loops) = [(0.0, 0), (2.0, 1)][at];
        Frames { keys: keys[at].as_ptr().cast(), count: keys[at].len() / joints, rate, loops }
    };
    let wrong = |joint: usize, component: usize, number: f32| {
        let mut wrong = (*keys).clone();
        wrong[1][joints + joint][component] = number;
        let wrong = Rc::new(wrong);
        move |clips: &mut [Frames]| clips[1] = of_c(&wrong, 1)
    };
    let bad = joints - 1;
    let clips = || {
        let given = Rc::clone(&keys);
        reads::<Frames>(2)
            .only(move |at| of_c(&given, at))
            .keeps(keys.iter().map(|keys| memory(keys)).collect())
            .fault(Status::NullPointer, None, |clips| clips[1].keys = std::ptr::null())
            .fault(Status::NoFrames, None, |clips| clips[1].count = 0)
            .fault(Status::UnknownValue, None, |clips| clips[0].loops = 2)
            .fault(Status::UnknownValue, None, |clips| clips[0].rate = -1.0)
            .fault_through(Status::NotUnit, 6 * joints + bad, wrong(bad, 3, 2.0))
    };
    functions! { to:
        "dq8_clips_bound", dq8_clips_bound = (
            clips: clips(),
            clip_count: passes(2).wrong(0, Status::NoFrames).wrong(usize::MAX, Status::TooLarge),
            joint_count: passes(joints).wrong(0, Status::NoFrames),
            bound: writes::<usize>(1), bad_key: names(),
        ) => bound[0] = most;
        "dq8_clips_pack", dq8_clips_pack = (
            clips: clips().fault_through(Status::NotFinite, 6 * joints + bad, wrong(bad, 5, f32::NAN)),
            clip_count: passes(2).wrong(0, Status::NoFrames).wrong(usize::MAX, Status::TooLarge),
            joint_count: passes(joints).wrong(0, Status::NoFrames),
            angle: passes(1e-3_f32), length_tolerance: passes(1e-4_f32),
            bytes: writes::<u8>(length), capacity: passes(length).wrong(length - 1, Status::LengthBytes),
            length: writes::<usize>(1), bad_key: names(),
        ) => {
            bytes.copy_from_slice(&file);
            length[0] = file.len();
        };
    }
}

/// The place in C.
fn place(place: TrackPlace) -> Place {
    // SAFETY: both are six numbers.
    Place { numbers: unsafe { std::mem::transmute::<TrackPlace, [u32; 6]>(place) } }
}

fn known(place: &Place) -> TrackPlace {
    // SAFETY: as above; any numbers may be one.
    unsafe { std::mem::transmute::<[u32; 6], TrackPlace>(place.numbers) }
}

/// The clips, which must have been made.
fn made(scene: &Rc<Scene>) -> Of<Clips, Read> {
    let scene = Rc::clone(scene);
    reads::<Clips>(1).keeps(vec![memory(scene.packed.as_bytes())]).only(move |_| scene.made).fault(
        Status::NoClips,
        None,
        |made| made[0] = zeroed(),
    )
}

macro_rules! add {
    ($shape:ident $to:ident $scene:ident $R:ident $of:ident) => {{
        let (joints, n) = ($shape.parents.len(), if $shape.parents.is_empty() { 0 } else { $shape.instances });
        let [of_place, of_places, of_models] = [(); 3].map(|()| Rc::clone(&$scene));
        functions! { $to:
            concat!("dq8_clips_place_", stringify!($R)), $of::place = (
                clips: made(&$scene), clip: passes(0).wrong(1, Status::UnknownValue),
                at: passes(3.25).wrong(<$R>::NAN, Status::NotFinite).wrong(<$R>::INFINITY, Status::NotFinite),
                found: writes::<Place>(1), t: writes::<$R>(1),
            ) => {
                let (frame, rest) = of_place.packed.clips().place::<$R>(clip, at).ok_or(Status::UnknownValue)?;
                (found[0], t[0]) = (place(frame), rest);
                let _ = clips;
            };
            concat!("dq8_clips_to_model_", stringify!($R)), $of::to_model = (
                parents: parents($shape),
                joints: count(joints).wrong_if(joints > 1 && n > 0, joints.saturating_sub(1), Status::LengthJoints),
                root: reads::<DualQuat<$R>>(1).unless_null(0), clips: made(&$scene),
                places: reads::<Place>(n)
                    .only(move |at| {
                        let at = wave::<$R>(at, 1).abs() * 3.0;
                        place(of_places.packed.clips().place(0, at).expect("a clip").0)
                    })
                    .fault(Status::OtherClips, None, |places| places[0] = Place::default()),
                t: reads::<$R>(n), instances: count(n), models: writes::<DualQuat<$R>>(n * joints),
            ) => {
                let (parents, view) = (unsigned(parents), of_models.packed.clips());
                let root = root.first().map_or(Root::None, |root| Root::Same(*root));
                let places: Vec<_> = places.iter().map(known).collect();
                let sampled = Sampled::new(NlerpLerp, view, &places, t)?;
                Hierarchy::new(&parents)?.job().on(root).locals_to_model(sampled, models)
            };
        }
    }};
}

pub(super) fn add(shape: &Shape, to: &mut Vec<Function>) {
    let scene = scene(shape.parents.len());
    let [again, of_duration] = [(); 2].map(|()| Rc::clone(&scene));
    let bytes = scene.packed.as_bytes().to_vec();
    let length = bytes.len();
    functions! { to:
        "dq8_clips_make", dq8_clips_make = (
            bytes: reads::<u8>(length).only(move |at| bytes[at])
                .fault(Status::NotClips, Some(8), |bytes| bytes[8] = 9),
            length: passes(length).wrong(usize::MAX, Status::TooLarge),
            clips: writes::<Clips>(1), bad_offset: names(),
        ) => clips[0] = again.made;
        "dq8_clips_duration", dq8_clips_duration = (
            clips: made(&scene), clip: passes(0).wrong(1, Status::UnknownValue), duration: writes::<f64>(1),
        ) => {
            duration[0] = of_duration.packed.clips().duration(clip).ok_or(Status::UnknownValue)?;
            let _ = clips;
        };
    }
    add_packing(shape.parents.len(), to);
    add!(shape to scene f32 single);
    add!(shape to scene f64 double);
}

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
                at: passes(3.25).wrong($R::NAN, Status::NotFinite).wrong($R::INFINITY, Status::NotFinite),
                found: writes::<Place>(1), t: writes::<$R>(1),
            ) => {
                let (frame, rest) = of_place.packed.clips().place::<$R>(clip, at).ok_or(Status::UnknownValue)?;
                (found[0], t[0]) = (place(frame), rest);
                let _ = clips;
            };
            concat!("dq8_clips_to_model_", stringify!($R)), $of::to_model = (
                parents: parents($shape),
                joints: count(joints).wrong_if(joints > 1 && n > 0, joints.saturating_sub(1), Status::Length),
                root: reads::<DualQuat<$R>>(1).unless_null(0), clips: made(&$scene),
                places: reads::<Place>(n)
                    .only(move |at| {
                        let at = wave::<$R>(at, 1).abs() * 3.0;
                        place(of_places.packed.clips().place(0, at).expect("a clip").0)
                    })
                    .fault(Status::Length, None, |places| places[0] = Place::default()),
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
    add!(shape to scene f32 single);
    add!(shape to scene f64 double);
}

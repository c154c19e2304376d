//! A packed clip is played at the same times as the clip that it was made of.

use super::{FRAMES, JOINTS, PARENTS, frames};
use dq8::hierarchy::{Clip, PackedClip, Sampled, Tolerance};
use dq8::law::NlerpLerp;
use dq8::{Backend, Crowd, DualQuat, Hierarchy, Quat};
use dq8_contract::random::Random;

/// A clip with a rate that loops, one that counts frames, a pose that loops, and one with a rate.
fn clips(keys: &[Vec<[f32; 7]>]) -> Vec<Clip<'_, [f32; 7]>> {
    let clip = |number: usize| Clip::new(JOINTS, &keys[number]).unwrap();
    vec![clip(0).with_rate(29.97).looping(), clip(1), clip(2).looping(), clip(3).with_rate(2.5)]
}

fn angle_to(a: DualQuat<f32>, b: DualQuat<f32>) -> f64 {
    a.cast::<f64>().angle_to(b.cast())
}

#[test]
fn a_packed_clip_has_the_times_of_the_clip_that_it_was_made_of() {
    let keys: Vec<_> = (0..4).map(|clip| frames(clip, FRAMES[clip])).collect();
    let clips = clips(&keys);
    let packed = PackedClip::library(&clips, Tolerance::default()).unwrap();
    let packed = packed.clips();
    let mut random = Random(11);
    for (number, clip) in clips.iter().enumerate() {
        assert_eq!(packed.frames(number), Some(clip.frames()));
        let close = |a: Option<f64>, b: f64| (a.unwrap() - b).abs() < 1e-14 * b;
        assert!(close(packed.rate(number), clip.rate()));
        assert_eq!(packed.loops(number), Some(clip.loops()));
        assert!(clip.duration() == 0.0 || close(packed.duration(number), clip.duration()));
        let length = clip.duration().max(1.0);
        for _ in 0..500 {
            let at = random.between(-3.0 * length, 4.0 * length) as f32;
            let (frame, t) = clip.place(at);
            let (place, share) = packed.place(number, at).unwrap();
            // Rounded in `f64` and in `f32`, most of all where rounds end.
            let same = packed.place(number, f64::from(frame) / clip.rate()).unwrap().0 == place;
            let round = clip.loops() && (frame == 0 || frame + 2 == clip.frames() as u32);
            assert!(same && (share - t).abs() < 1e-3 || round, "clip {number} at {at}");
            let joint = random.below(JOINTS);
            let (one, other) =
                (packed.pose(number, joint, at), clip.pose(NlerpLerp, joint, at).unwrap());
            let off = angle_to(one.unwrap(), other);
            assert!(off < 1e-4, "clip {number}, joint {joint} at {at}: {off} rad");
            let to = random.between(-3.0 * length, 4.0 * length) as f32;
            let (one, other) =
                (packed.between(number, joint, at, to), clip.between(NlerpLerp, joint, at, to));
            let off = angle_to(one.unwrap(), other.unwrap());
            assert!(off < 2e-3, "clip {number}, joint {joint} from {at} to {to}: {off} rad");
        }
        assert!(packed.pose(number, JOINTS, 0.0_f32).is_none());
    }
    assert!(packed.pose(4, 0, 0.0_f64).is_none() && packed.between(4, 0, 0.0, 1.0_f64).is_none());
    assert_eq!(packed.place(0, 1.0_f64).unwrap().1 as f32, clips[0].place(1.0_f64).1 as f32);
    assert_eq!((packed.rate(4), packed.loops(4), packed.duration(4)), (None, None, None));
    // Two seconds and a half after the end of a looping clip are two rounds and a half of a second.
    let looping = Clip::new(JOINTS, &keys[1]).unwrap().with_rate(4.0).looping();
    let looping = PackedClip::new(looping, Tolerance::default()).unwrap();
    let looping = looping.clips();
    assert_eq!(looping.place(0, 2.5_f32), looping.place(0, 0.5_f32));
}

#[test]
fn nan_is_nan_in_all_eight_numbers_on_every_backend() {
    let keys = frames(0, 5);
    let clip = Clip::new(JOINTS, &keys).unwrap();
    let packed = PackedClip::new(clip, Tolerance::default()).unwrap();
    let hierarchy = Hierarchy::new(&PARENTS).unwrap();
    let at = [1.25, f32::NAN, 3.0];
    let (places, t): (Vec<_>, Vec<_>) =
        at.iter().filter_map(|&at| packed.clips().place(0, at)).unzip();
    let sampled = Sampled::new(NlerpLerp, packed.clips(), &places, &t).unwrap();
    for backend in Backend::available() {
        let job = hierarchy.job().backend(backend);
        let mut models = vec![DualQuat::IDENTITY; 3 * JOINTS];
        job.locals_to_model(sampled, &mut models).unwrap();
        let mut crowd = Crowd::<f32, 8>::new(JOINTS, 3);
        job.locals_to_model(sampled, crowd.blocks_mut()).unwrap();
        let mut alone = vec![DualQuat::IDENTITY; JOINTS];
        let one = Sampled::new(NlerpLerp, packed.clips(), &places[1..2], &t[1..2]).unwrap();
        job.locals_to_model(one, &mut alone).unwrap();
        for (joint, model) in alone.iter().enumerate() {
            let all = [*model, models[JOINTS + joint], crowd.get(1, joint).unwrap()];
            for model in all {
                assert!(model.to_array().iter().all(|c| c.is_nan()), "{backend}: {model:?}");
            }
        }
        for (index, model) in models.iter().enumerate().filter(|(index, _)| index / JOINTS != 1) {
            assert!(model.to_array().iter().all(|c| c.is_finite()), "{backend}: {index}");
        }
    }
    for joint in 0..JOINTS {
        let pose = packed.clips().pose(0, joint, f32::NAN).unwrap();
        let clip = clip.pose(NlerpLerp, joint, f32::NAN).unwrap();
        assert!(pose.to_array().iter().chain(&clip.to_array()).all(|c| c.is_nan()));
    }
}

/// A clip of two joints, whose first turns about an axis from frame to frame by so many degrees.
fn turning(axis: [f64; 3], degrees: &[f64]) -> Vec<[f32; 7]> {
    let (mut turn, mut keys) = (Quat::IDENTITY, Vec::new());
    for (frame, degrees) in degrees.iter().enumerate() {
        turn = turn * Quat::from_axis_angle(axis, degrees.to_radians());
        let [x, y, z, w] = turn.to_array();
        // The sign of a quaternion means nothing.
        let sign = if frame % 3 == 1 { -1.0 } else { 1.0 };
        let slide = 0.1 * frame as f64;
        keys.push([sign * x, sign * y, sign * z, sign * w, slide, 0.3, 0.0].map(|c| c as f32));
        keys.push([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]);
    }
    keys
}

/// The packed clip has frames between those of the clip. At these it is where the clip is, and
/// between them on the same arc: both slow down toward the frames, the clip by up to 2.6° more.
#[test]
fn turns_of_60_degrees_and_more_are_packed_with_frames_between() {
    let mut random = Random(7);
    let leg = [Hierarchy::ROOT, 0];
    let leg = Hierarchy::new(&leg).unwrap();
    let most = [(59.0, 1), (61.0, 2), (119.0, 2), (121.0, 3), (154.0, 3), (156.0, 4), (180.0, 4)];
    for (degrees, pieces) in most.into_iter().cycle().take(70) {
        let axis = random.direction::<3>();
        let turns: Vec<_> = std::iter::once(degrees)
            .chain((0..6).map(|_| random.between(-degrees, degrees)))
            .collect();
        // The first turn leads to the first frame: it counts in the second as well.
        let turns = [&[0.0], &turns[..]].concat();
        let keys = turning(axis, &turns);
        let clip = Clip::new(2, &keys).unwrap().with_rate(30.0).looping();
        let packed = PackedClip::new(clip, Tolerance::default()).unwrap();
        let view = packed.clips();
        let (frames, rate) = (clip.frames(), clip.rate());
        assert_eq!((view.frames(0), view.rate(0)), (Some(frames), Some(rate)), "{degrees}°");
        // As many bytes as the documentation says: one key for the other joint, and two for the
        // first in each frame.
        let size = 32 + 2 * 16 + 16 + 12 + 2 * 4 + 8 * (1 + 2 * (7 * pieces + 1));
        assert_eq!(packed.as_bytes().len(), size, "{degrees}°");
        let short = packed.deviation(&leg, 0, &keys[..2 * 2], 1.0);
        assert!(short.is_err(), "{degrees}°");
        assert!((view.duration(0).unwrap() - clip.duration()).abs() < 1e-12);
        let deviation = packed.deviation(&leg, 0, &keys, 1.0).unwrap();
        assert!(deviation.worst < 1e-4, "{degrees}°: {deviation:?}");
        for step in 0..7 * 16 {
            let at = (step as f32 + 0.5) / 16.0 / 30.0;
            let (a, b) = (clip.pose(NlerpLerp, 0, at).unwrap(), view.pose(0, 0, at).unwrap());
            let off = angle_to(a, b).to_degrees();
            let bound = if pieces == 1 { 0.01 } else { 2.6 };
            assert!(off < bound, "{degrees}° at {at}: {off}°");
            let [x, y, z] = (a.rotation().conjugate() * b.rotation()).cast::<f64>().log();
            let along = x * axis[0] + y * axis[1] + z * axis[2];
            let across = (x * x + y * y + z * z - along * along).max(0.0).sqrt();
            assert!(across < 2e-4, "{degrees}° at {at}: {across} rad off the arc");
        }
    }
}

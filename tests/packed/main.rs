//! Packed clips: what is played is what their bytes say, on every backend; what an encoder keeps;
//! what it refuses, and what bytes are no clips.

mod book;
mod hostile;
mod time;

use book::{Book, Key};
use dq8::hierarchy::{
    Clip, Either, Layered, Locals, PackedClip, PackedError, Sampled, Tolerance, TrackPlace,
};
use dq8::law::NlerpLerp;
use dq8::{Backend, Crowd, DualQuat, Hierarchy, Quat, Scalar, ShapeError};
use dq8_contract::random::Random;

/// Two trees, so that a joint is no root and one that moves stands between others.
pub(crate) const PARENTS: [u32; 19] =
    [u32::MAX, 0, 1, 2, 0, 4, 5, u32::MAX, 7, 8, 9, 10, 0, 12, 13, 14, 15, 15, 15];
pub(crate) const JOINTS: usize = PARENTS.len();
/// Their frames; the third clip is a pose.
const FRAMES: [usize; 4] = [17, 5, 1, 24];

/// Rotations swing; every third joint keeps still, another every third in one clip alone; roots
/// walk, and joint 13 slides.
pub(crate) fn frames(clip: usize, count: usize) -> Vec<[f32; 7]> {
    let mut random = Random(3);
    let tracks: Vec<_> = (0..JOINTS)
        .map(|_| (random.direction::<3>(), random.between(0.2, 3.0), random.vector::<3>()))
        .collect();
    let pose = |frame: usize, joint: usize| {
        let (axis, size, offset) = tracks[joint];
        let still = joint % 3 == 1 || (joint % 3 == 2 && clip == 1);
        let time = if still { clip as f64 } else { frame as f64 * 0.2 + clip as f64 };
        let turn = Quat::from_axis_angle(axis, size * time.sin());
        let slide =
            if [0, 7, 13].contains(&joint) { 0.4 * (0.3 * frame as f64).cos() } else { 0.0 };
        // The sign of a quaternion means nothing.
        let [x, y, z, w] = turn.to_array().map(|c| if frame % 2 == 1 { -c } else { c });
        let [a, b, c] = offset.map(|c| 0.3 * c + slide);
        [x, y, z, w, a, b, c].map(|number| number as f32)
    };
    (0..count)
        .flat_map(|frame| (0..JOINTS).map(move |joint| (frame, joint)))
        .map(|(f, j)| pose(f, j))
        .collect()
}

pub(crate) fn library() -> PackedClip {
    let clips: Vec<_> =
        FRAMES.into_iter().enumerate().map(|(clip, count)| frames(clip, count)).collect();
    let clips: Vec<_> = clips.iter().map(|keys| Clip::new(JOINTS, keys).unwrap()).collect();
    PackedClip::library(&clips, Tolerance::default()).expect("they can be packed")
}

/// Where so many instances are.
fn places<R: Scalar>(
    packed: &PackedClip,
    count: usize,
) -> (Vec<(usize, f64)>, Vec<TrackPlace>, Vec<R>) {
    let mut random = Random(count as u64);
    let at: Vec<_> = (0..count)
        .map(|_| {
            let clip = random.below(4);
            (clip, random.between(0.0, FRAMES[clip] as f64 - 0.9))
        })
        .collect();
    let places = at.iter().map(|&(clip, at)| {
        packed.clips().place(clip, <R as dq8::Real>::from_f64(at)).expect("a clip")
    });
    let (places, t) = places.unzip();
    (at, places, t)
}

fn all_layouts_play_what_the_bytes_say<R: Scalar>(bound: f64)
where
    [R; 4]: dq8::simd::Row<Real = R>,
    [R; 8]: dq8::simd::Row<Real = R>,
{
    let packed = library();
    let book = Book::new(packed.as_bytes());
    let hierarchy = Hierarchy::new(&PARENTS).unwrap();
    for (backend, count) in Backend::available().flat_map(|b| [1, 3, 8, 21].map(|count| (b, count)))
    {
        let (at, places, t) = places::<R>(&packed, count);
        let sampled = Sampled::new(NlerpLerp, packed.clips(), &places, &t).unwrap();
        let job = hierarchy.job().backend(backend);
        let mut models = vec![DualQuat::<R>::IDENTITY; count * JOINTS];
        job.locals_to_model(sampled, &mut models).unwrap();
        for (instance, &(clip, at)) in at.iter().enumerate() {
            let frame = (at as usize).min(FRAMES[clip].saturating_sub(2));
            let share = t[instance].into();
            let locals: Vec<_> =
                (0..JOINTS).map(|joint| book.pose(clip, joint, frame, share)).collect();
            let wanted = book::models(&PARENTS, &locals);
            for (joint, wanted) in wanted.iter().enumerate() {
                let model = models[instance * JOINTS + joint].cast::<f64>();
                let unit = model.rotation().to_array().iter().map(|c| c * c).sum::<f64>();
                assert!((unit - 1.0).abs() < 2e-6, "{unit} off unit");
                let point = [0.3, -0.2, 0.5];
                let (got, wanted) = (model.transform_point(point), book::point(*wanted, point));
                let off = (0..3).map(|i| (got[i] - wanted[i]).abs()).fold(0.0, f64::max);
                assert!(
                    off < bound,
                    "{backend} {count}, instance {instance}, joint {joint}: {off}"
                );
            }
            // One by one and many at once have the same bits.
            let mut own = [DualQuat::IDENTITY; JOINTS];
            let own_t = &t[instance..=instance];
            let alone = &places[instance..=instance];
            let alone = Sampled::new(NlerpLerp, packed.clips(), alone, own_t).unwrap();
            job.locals_to_model(alone, &mut own).unwrap();
            assert_eq!(own, models[instance * JOINTS..][..JOINTS], "{backend} {count} {instance}");
        }
        macro_rules! blocks {
            ($($lanes:literal)*) => {$(
                let mut crowd = Crowd::<R, $lanes>::new(JOINTS, count);
                job.locals_to_model(sampled, crowd.blocks_mut()).unwrap();
                // Blocks round in another order.
                for (index, model) in models.iter().enumerate() {
                    let own = crowd.get(index / JOINTS, index % JOINTS).unwrap();
                    let off = own.to_array().into_iter().zip(model.to_array()).map(|(a, b)| (a - b).into().abs());
                    assert!(off.fold(0.0, f64::max) < bound, "{backend} {count} blocks of {}: {index}", $lanes);
                }
            )*};
        }
        blocks! { 4 8 }
    }
}

#[test]
fn every_backend_plays_what_the_bytes_say() {
    all_layouts_play_what_the_bytes_say::<f32>(4e-6);
    all_layouts_play_what_the_bytes_say::<f64>(1e-6);
}

/// The figures of the encoder against matrices of `f64`, over the bytes.
#[test]
fn an_encoder_measures_its_own_error_as_it_is() {
    let packed = library();
    let (book, hierarchy) = (Book::new(packed.as_bytes()), Hierarchy::new(&PARENTS).unwrap());
    for (clip, &count) in FRAMES.iter().enumerate() {
        let frames = frames(clip, count);
        for distance in [0.03, 1.0] {
            let mut distances = Vec::new();
            for (frame, keys) in frames.chunks(JOINTS).enumerate() {
                let (place, t) =
                    if frame + 1 < count || count == 1 { (frame, 0.0) } else { (frame - 1, 1.0) };
                let decoded: Vec<_> =
                    (0..JOINTS).map(|joint| book.pose(clip, joint, place, t)).collect();
                let exact: Vec<Key> = keys.iter().map(|key| key.map(f64::from)).collect();
                let models = [decoded, exact].map(|locals| book::models(&PARENTS, &locals));
                for joint in 0..JOINTS {
                    for axis in 0..3 {
                        let mut v = [0.0; 3];
                        v[axis] = distance;
                        let [a, b] = models.each_ref().map(|models| book::point(models[joint], v));
                        distances.push((0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt());
                    }
                }
            }
            distances.sort_by(f64::total_cmp);
            let got = packed.deviation(&hierarchy, clip, &frames, distance).unwrap();
            let close = |a: f64, b: f64| (a - b).abs() < 1e-6 * (1.0 + distance);
            let (worst, p99) =
                (distances[distances.len() - 1], distances[distances.len() * 99 / 100]);
            assert!(close(got.worst, worst) && close(got.p99, p99), "{got:?}, not {worst} {p99}");
            assert!(got.worst > 1e-6, "quantised");
            // Metres: the goal is 0.015 cm at 3 cm and 0.035 cm at 100 cm.
            assert!(got.worst < if distance < 0.1 { 1.5e-4 } else { 3.5e-4 }, "{clip}: {got:?}");
        }
        let short = &frames[JOINTS..];
        assert!(packed.deviation(&hierarchy, clip, short, 1.0).is_err());
    }
}

#[test]
fn what_keeps_still_takes_no_frames() {
    let packed = library();
    let clips = packed.clips();
    assert_eq!(
        (clips.joints(), clips.clips(), clips.frames(3), clips.frames(4)),
        (JOINTS, 4, Some(24), None)
    );
    let moving = [0, 1, 2, 3].map(|clip| clips.moving(clip).unwrap());
    // 13 of 19 rotations, 7 in the second clip; three translations; a pose moves nothing.
    assert_eq!(moving, [16, 10, 0, 16]);
    let of_frames: usize =
        moving.iter().zip(FRAMES).map(|(moving, frames)| 8 * moving * frames).sum();
    let constant: usize = moving.iter().map(|moving| 8 * (JOINTS + 3 - moving)).sum();
    // The first and the last clip move the same, and have one row.
    let fixed = 32 + 16 * JOINTS + 4 * (16 + 12) + 3 * 4 * JOINTS;
    assert_eq!(packed.as_bytes().len(), of_frames + constant + fixed);
    let loose = Tolerance { angle: 7.0, length: 100.0 };
    let none = PackedClip::new(Clip::new(JOINTS, &frames(0, 17)).unwrap(), loose).unwrap();
    assert_eq!(none.clips().moving(0), Some(0));
}

#[test]
fn no_track_keeps_still_within_a_limit_that_is_not_a_number() {
    let frames = frames(0, 17);
    let moving = |angle, length| {
        let clip = Clip::new(JOINTS, &frames).unwrap();
        PackedClip::new(clip, Tolerance { angle, length }).unwrap().clips().moving(0).unwrap()
    };
    let usual = Tolerance::default();
    assert!(moving(usual.angle, f32::NAN) >= moving(usual.angle, usual.length));
    assert!(moving(f32::NAN, usual.length) >= moving(usual.angle, usual.length));
}

/// The same on every target: this text was written on one with the other byte order than some that
/// run it.
#[test]
fn bytes_are_those_of_the_documentation_on_every_target() {
    let turn = [0.6_f32, 0.0, 0.0, 0.8, 1.0, 2.0, 3.0];
    let keys = [turn, turn, turn.map(|c| -c), turn];
    let clip = Clip::new(2, &keys).unwrap().with_rate(29.97).looping();
    let packed = PackedClip::new(clip, Tolerance::default()).unwrap();
    let step = 6.0 / (65534.0 * 16384.0_f32);
    let key =
        |numbers: [i16; 4]| numbers.into_iter().flat_map(i16::to_le_bytes).collect::<Vec<_>>();
    let words =
        |words: &[u32]| words.iter().flat_map(|word| word.to_le_bytes()).collect::<Vec<_>>();
    let wanted = [
        b"dq8clips".to_vec(),
        words(&[3, 2, 1, 4, 1, 0]),
        key([19659, 0, 0, 26212]),
        key([19659, 0, 0, 26212]),
        key([10922, 21845, 32767, 0]),
        key([-10922, -21845, -32767, 0]),
    ];
    let bytes = packed.as_bytes();
    assert_eq!(bytes[..32 + 16], wanted[..4].concat()[..32 + 16]);
    assert_eq!(bytes[48..64], wanted[4..6].concat());
    assert_eq!(
        bytes[64..96],
        words(&[
            0,
            0,
            0,
            step.to_bits(),
            1.0_f32.to_bits(),
            2.0_f32.to_bits(),
            3.0_f32.to_bits(),
            0
        ])
    );
    assert_eq!(bytes[96..112], words(&[0, 2, 1, 0]));
    let rest = (29.97 - f64::from(29.97_f32)) as f32;
    assert_eq!(bytes[112..124], words(&[29.97_f32.to_bits(), rest.to_bits(), 1 + (1 << 16)]));
    assert_eq!(bytes[124..], [0, 2, 2 * 2 + 1, 0].map(u16::to_le_bytes).concat());
    assert_eq!(PackedClip::from_bytes(bytes.into()).unwrap().as_bytes(), bytes);
}

#[test]
fn what_cannot_be_held_is_refused_by_clip_frame_and_joint() {
    let good = frames(0, 5);
    let with = |place: usize, key: [f32; 7]| {
        let mut bad = good.clone();
        bad[place] = key;
        let clips = [&good, &bad].map(|keys| Clip::new(JOINTS, keys).unwrap());
        PackedClip::library(&clips, Tolerance::default()).map(|_| ()).unwrap_err()
    };
    let place = 2 * JOINTS + 4;
    let mut key = good[place];
    key[..4].fill(0.0);
    assert_eq!(with(place, key), PackedError::NotUnit { clip: 1, frame: 2, joint: 4, length: 0.0 });
    key[..4].fill(f32::NAN);
    assert!(
        matches!(with(place, key), PackedError::NotUnit { clip: 1, frame: 2, joint: 4, length } if length.is_nan())
    );
    let mut key = good[place];
    key[5] = f32::INFINITY;
    assert_eq!(
        with(place, key),
        PackedError::Beyond { clip: 1, frame: 2, joint: 4, value: f32::INFINITY }
    );
    let one = Clip::new(JOINTS, &good).unwrap();
    let refused = |clips: &[_]| PackedClip::library(clips, Tolerance::default()).unwrap_err();
    for rate in [0.0, -30.0, f64::INFINITY] {
        let error = refused(&[one, one.with_rate(rate)]);
        assert_eq!(error, PackedError::Rate { clip: 1, rate });
    }
    let (what, length, expected) = ("each frame of a clip", 5, JOINTS);
    let other = Clip::new(length, &good).unwrap();
    assert_eq!(refused(&[one, other]), ShapeError::Length { what, length, expected }.into());
    assert_eq!(refused(&[]), ShapeError::Empty { what: "clips" }.into());
}

#[test]
fn outside_two_frames_is_the_nearer_one() {
    let packed = library();
    let (place, _) = packed.clips().place(0, 4.0).unwrap();
    let hierarchy = Hierarchy::new(&PARENTS).unwrap();
    let play = |t: f32| {
        let (places, t) = ([place], [t]);
        let mut models = [DualQuat::IDENTITY; JOINTS];
        let sampled = Sampled::new(NlerpLerp, packed.clips(), &places, &t).unwrap();
        hierarchy.job().locals_to_model(sampled, &mut models).unwrap();
        models
    };
    for (t, same) in [(-0.5, 0.0), (f32::NEG_INFINITY, 0.0), (1.5, 1.0), (f32::INFINITY, 1.0)] {
        assert_eq!(play(t), play(same), "{t}");
    }
    assert_ne!(play(0.0), play(1.0));
}

fn on_roots(
    backend: Backend,
    roots: &[DualQuat<f32>],
    locals: impl Locals<DualQuat<f32>>,
) -> Vec<DualQuat<f32>> {
    let mut palette = vec![DualQuat::IDENTITY; roots.len() * JOINTS];
    let (mut scratch, binds) = ([DualQuat::IDENTITY; 16 * JOINTS], [DualQuat::IDENTITY; JOINTS]);
    let hierarchy = Hierarchy::new(&PARENTS).unwrap();
    let job = hierarchy.job().backend(backend).roots(roots);
    job.palette(locals, &mut scratch, &binds, &mut palette).unwrap();
    palette
}

/// Sources nest: packed clips under a layer, plain ones beside them, and into a palette by way of
/// scratch.
#[test]
fn packed_clips_are_layered_and_make_palettes_as_others_do() {
    let packed = library();
    let hierarchy = Hierarchy::new(&PARENTS).unwrap();
    let plain = frames(0, 24);
    let count = 19;
    let (_, places, t) = places::<f32>(&packed, count);
    let one = Sampled::new(NlerpLerp, packed.clips(), &places, &t).unwrap();
    let at: Vec<u32> = (0..count as u32).collect();
    let other = Sampled::new(NlerpLerp, Clip::new(JOINTS, &plain).unwrap(), &at, &t).unwrap();
    let weights: Vec<_> = (0..count).map(|i| i as f32 / 20.0).collect();
    let layered = Layered::blend(NlerpLerp, other, one, &weights);
    let binds = [DualQuat::IDENTITY; JOINTS];
    for backend in Backend::available() {
        let job = hierarchy.job().backend(backend);
        let mut models = vec![DualQuat::IDENTITY; count * JOINTS];
        job.locals_to_model(layered, &mut models).unwrap();
        let mut scratch = vec![DualQuat::IDENTITY; 16 * JOINTS];
        let mut palette = models.clone();
        palette.fill(DualQuat::IDENTITY);
        job.palette(layered, &mut scratch, &binds, &mut palette).unwrap();
        assert_eq!(palette, models, "{backend}");
    }
    // Forms that a program chooses as it runs have the bits of each.
    let job = hierarchy.job();
    let mut models = [(); 6].map(|()| vec![DualQuat::IDENTITY; count * JOINTS]);
    let [a, b, c, d, e, f] = &mut models;
    let [first, second] = [Either::One(one), Either::Other(other)];
    job.locals_to_model(one, a).unwrap();
    job.locals_to_model(first, b).unwrap();
    job.locals_to_model(other, c).unwrap();
    job.locals_to_model(second, d).unwrap();
    job.locals_to_model(layered, e).unwrap();
    job.locals_to_model(Layered::blend(NlerpLerp, second, first, &weights), f).unwrap();
    assert!(a == b && c == d && e == f && a != c);
    let roots: Vec<_> =
        (0..count).map(|i| DualQuat::from_translation([i as f32, 1.0, 0.5])).collect();
    let mask: Vec<_> = (0..JOINTS).map(|joint| joint as f32 / 20.0).collect();
    let masked = layered.mask(&mask);
    // What the other form would be gives the type its name.
    let both = if count > 1 { Either::One(masked) } else { Either::Other(other) };
    for backend in Backend::available() {
        assert_eq!(on_roots(backend, &roots, first), on_roots(backend, &roots, one), "{backend}");
        assert_eq!(on_roots(backend, &roots, both), on_roots(backend, &roots, masked), "{backend}");
    }
    let mut crowds = [(); 2].map(|()| Crowd::<f32, 8>::new(JOINTS, count));
    job.locals_to_model(one, crowds[0].blocks_mut()).unwrap();
    job.locals_to_model(first, crowds[1].blocks_mut()).unwrap();
    assert_eq!(crowds[0].to_vec(), crowds[1].to_vec());
    // What does not fit is refused before anything is written.
    let others = Clip::new(JOINTS, &plain).unwrap();
    let others = PackedClip::new(others, Tolerance::default()).unwrap();
    let refused = Sampled::new(NlerpLerp, others.clips(), &places[..1], &t[..1]).map(|_| ());
    assert_eq!(refused, Err(ShapeError::NoPlace { instance: 0 }));
    let length = |what, length, expected| Err(ShapeError::Length { what, length, expected });
    assert_eq!(
        Sampled::new(NlerpLerp, packed.clips(), &places, &t[1..]).map(|_| ()),
        length("t", 18, 19)
    );
    let short = Hierarchy::new(&PARENTS[..18]).unwrap();
    let mut models = vec![DualQuat::<f32>::IDENTITY; count * 18];
    assert_eq!(
        short.job().locals_to_model(one, &mut models),
        length("each frame of the clip", JOINTS, 18)
    );
}

//! Times of clips, single poses, and how a joint moves between two times.

use dq8::hierarchy::{Clip, OwnedClip, Sampled};
use dq8::law::{Nlerp, NlerpLerp, Sclerp};
use dq8::{DualQuat, Hierarchy, Quat};

/// A few products and powers of motions near 1 and some lengths away.
const ROUNDING: f64 = 1e-12;

/// Five frames of two joints; the root turns and walks from where it stands, 0.5 lengths and 0.3
/// radians a frame.
fn keys() -> [DualQuat<f64>; 10] {
    core::array::from_fn(|i| {
        let (frame, joint) = ((i / 2) as f64, i % 2);
        let step = DualQuat::from_rotation_translation(
            Quat::from_axis_angle([0.0, 0.0, 1.0], 0.3),
            [0.5, 0.1, 0.0],
        );
        let begin = DualQuat::from_rotation_translation(
            Quat::from_axis_angle([0.6, 0.0, 0.8], -1.1),
            [2.0, -1.0, 0.5],
        );
        if joint == 0 {
            begin * step.pow(frame)
        } else {
            DualQuat::from_translation([0.0, frame, 0.0])
        }
    })
}

#[test]
fn times_are_seconds_of_a_rate_and_rounds_of_a_clip_that_loops() {
    let keys = keys();
    let clip = Clip::new(2, &keys).expect("whole frames");
    assert_eq!((clip.duration(), clip.with_rate(8.0).duration()), (4.0, 0.5));
    assert_eq!(clip.with_rate(8.0).place(0.15625), clip.place(1.25));
    let looping = clip.with_rate(8.0).looping();
    for rounds in [-3.0, -1.0, 0.0, 1.0, 7.0] {
        assert_eq!(looping.place(0.15625 + 0.5 * rounds), (1, 0.25), "{rounds} rounds");
        assert_eq!(looping.place(0.5 * rounds), (0, 0.0), "the end of a round is its beginning");
    }
    for at in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(looping.place(at).1.is_nan(), "no place of a round is {at}");
    }
    assert_eq!(clip.place(f64::INFINITY), (3, 1.0));
    let one = Clip::new(2, &keys[..2]).expect("one frame").looping();
    assert_eq!(one.pose(Nlerp, 1, 3.5), Some(keys[1]), "of one frame every time is that frame");
    let still = one.between(Nlerp, 0, -3.0, 4.5).expect("a root");
    assert!(still.abs_diff_eq(DualQuat::IDENTITY, ROUNDING), "and nothing moves: {still}");
}

#[test]
fn a_pose_of_a_clip_is_that_of_its_samples() {
    let keys = keys();
    let clip = Clip::new(2, &keys).expect("whole frames").with_rate(30.0).looping();
    let pair = [Hierarchy::ROOT, 0];
    let pair = Hierarchy::new(&pair).expect("a hierarchy");
    for at in [-0.2, 0.0, 0.01, 0.1, 0.13, 2.0] {
        let (frame, t) = clip.place(at);
        let mut locals = [DualQuat::IDENTITY; 2];
        let place = ([frame], [t]);
        let pose = Sampled::new(Sclerp, clip, &place.0, &place.1).expect("a frame");
        pair.job().locals(pose, &mut locals).expect("they fit");
        for (joint, local) in locals.into_iter().enumerate() {
            let pose = clip.pose(Sclerp, joint, at).expect("a joint");
            assert!(pose.abs_diff_eq(local, ROUNDING), "joint {joint} at {at} s: {pose} {local}");
        }
    }
    assert_eq!(clip.pose(Nlerp, 2, 0.0), None, "there is no third joint");
    assert_eq!(clip.between(Nlerp, 2, 0.0, 1.0), None, "there is no third joint");
    let sevens = keys.map(|key| {
        let ([x, y, z, w], [a, b, c]) = (key.rotation().to_array(), key.translation());
        [x, y, z, w, a, b, c]
    });
    let apart = Clip::new(2, &sevens).expect("whole frames");
    let pose = apart.pose(NlerpLerp, 0, 3.0).expect("a joint");
    assert!(pose.abs_diff_eq(keys[6], ROUNDING));
}

/// The root's steps are all the same, so that what lies between two times depends on their
/// difference alone, rounds included.
#[test]
fn root_motion_goes_on_where_a_clip_begins_again() {
    let keys = keys();
    let clip = Clip::new(2, &keys).expect("whole frames").with_rate(10.0).looping();
    let step = keys[0].conjugate() * keys[2];
    for (from, to) in
        [(0.0, 0.1), (0.05, 0.35), (0.35, 0.45), (-1.23, 2.0), (0.1, 8.17), (2.0, 0.3)]
    {
        let moved = clip.between(Sclerp, 0, from, to).expect("a root");
        let wanted = step.pow(10.0 * (to - from));
        let wanted = if moved.real().dot(wanted.real()) < 0.0 { -wanted } else { wanted };
        assert!(moved.abs_diff_eq(wanted, ROUNDING), "{from} to {to}: {moved} {wanted}");
    }
    let once = Clip::new(2, &keys).expect("whole frames").with_rate(10.0);
    let all = once.between(Sclerp, 0, -5.0, 5.0).expect("a root");
    assert!(all.abs_diff_eq(step.pow(4.0), ROUNDING), "what does not loop stands still outside");
}

#[test]
fn a_clip_with_memory_of_its_own_is_the_borrowed_one() {
    let keys = keys();
    let owned = OwnedClip::new(2, keys).expect("whole frames").with_rate(24.0).looping();
    let borrowed = Clip::new(2, &keys).expect("whole frames").with_rate(24.0).looping();
    assert_eq!(format!("{:?}", owned.view()), format!("{borrowed:?}"));
    assert!(OwnedClip::new(3, keys).is_err(), "ten keys are no whole frames of three joints");
}

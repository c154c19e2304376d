//! Limbs of two bones on lanes: what single ones are, and what the limbs of a skeleton become.

use crate::memory::{Memory, lay, read, round};
use crate::records::assert_same_bits;
use crate::scene::step;
use dq8::ik::{Limb, LimbError, LimbsError, TwoBone};
use dq8::simd::Float;
use dq8::storage::{AoSoA, Aos};
use dq8::{Backend, DualQuat, Hierarchy, Quat, Real, ShapeError};
use dq8_contract::bound::unit_roundoff;
use dq8_contract::fusing::PORTABLE_FUSES;
use dq8_contract::random::Random;

/// Root, lengths, target, pole.
type Asked = ([f64; 3], [f64; 2], [f64; 3], [f64; 3]);

/// Rounded to `f32`: within reach, too far, too near, at the root, straight, along the pole,
/// without one, without length, and of any size.
fn asked(count: usize) -> Vec<Asked> {
    let mut random = Random(50);
    let mut one = |i: usize| {
        let mut vector =
            |size: f64| -> [f64; 3] { core::array::from_fn(|_| size * random.signed()) };
        let (mut root, target, mut pole) = (vector(1.0), vector(1.0), vector(1.0));
        let mut lengths = [random.between(0.6, 1.2), random.between(0.6, 1.2)];
        let way: [f64; 3] = core::array::from_fn(|axis| target[axis] - root[axis]);
        match i % 16 {
            1 => lengths = lengths.map(|length| length * 1e-2),
            2 => lengths[0] *= 20.0,
            3 => lengths[1] *= 20.0,
            4 => root = target,
            5 => (root, lengths) = (target, [0.5, 0.5]),
            6 => pole = way,
            7 => pole = way.map(|c| -3.0 * c),
            8 => pole = [0.0; 3],
            9 => lengths = [0.0, 0.7],
            10 => lengths = [0.7, 0.0],
            11 => {
                root = [target[0] - 1.0, target[1], target[2]];
                lengths = [0.25, 0.75];
            }
            12 => pole = pole.map(|c| c * 1e30),
            _ => {}
        }
        let mut asked = (root, lengths, target, pole);
        if i % 16 == 13 {
            for number in asked.0.iter_mut().chain(&mut asked.1).chain(&mut asked.2) {
                *number *= 1e-25;
            }
        }
        asked
    };
    let single = |(root, lengths, target, pole): Asked| {
        let [root, target, pole] = [root, target, pole].map(|p| p.map(|c| f64::from(c as f32)));
        (root, lengths.map(|c| f64::from(c as f32)), target, pole)
    };
    (0..count).map(|i| single(one(i))).collect()
}

/// Both rotations of each limb, by a backend.
fn bent<L: Memory>(asked: &[Asked], backend: Backend) -> [Vec<[f64; 4]>; 2] {
    let three =
        |of: fn(&Asked) -> [f64; 3]| lay::<L, 3>(1, &asked.iter().map(of).collect::<Vec<_>>());
    let lengths = lay::<L, 2>(1, &asked.iter().map(|limb| limb.1).collect::<Vec<_>>());
    let (roots, targets, poles) =
        (three(|limb| limb.0), three(|limb| limb.2), three(|limb| limb.3));
    let mut uppers = vec![L::filled::<4>(L::Real::ZERO); roots.len()];
    let mut lowers = uppers.clone();
    backend
        .two_bone(&roots, &lengths, &targets, &poles, &mut uppers, &mut lowers)
        .expect("limbs that bend");
    [uppers, lowers].map(|turns| {
        let mut turns = read::<L, 4>(1, &turns);
        turns.truncate(asked.len());
        turns
    })
}

/// Those of single limbs.
fn alone<R: Real>(asked: &[Asked]) -> [Vec<[f64; 4]>; 2] {
    let limbs = asked.iter().map(|&(root, lengths, target, pole)| {
        let limb = TwoBone::<R>::reach(round(root), round(lengths), round(target), round(pole));
        let limb = limb.expect("limbs that bend");
        [limb.upper, limb.lower].map(|turn| turn.to_array().map(Into::into))
    });
    let (uppers, lowers) = limbs.map(|[upper, lower]| (upper, lower)).unzip();
    [uppers, lowers]
}

fn check<L: Memory>() {
    // No limb, one, some that fill no lanes, and more than fill two registers.
    for count in [0, 1, 3, 16, 35] {
        let asked = asked(count);
        let wanted = alone::<L::Real>(&asked);
        for backend in Backend::available() {
            let got = bent::<L>(&asked, backend);
            #[cfg(feature = "reproducible")]
            for (got, wanted) in bent::<L>(&asked, backend.unfused()).iter().zip(&wanted) {
                let what = format!("{} {backend}, nothing fused", L::name());
                assert_same_bits(got, wanted, &what);
            }
            for (got, wanted) in got.iter().zip(&wanted) {
                if backend == Backend::PORTABLE && !PORTABLE_FUSES {
                    assert_same_bits(got, wanted, &format!("{} {backend}", L::name()));
                }
                // A fused product moves an almost stretched knee by the root of a rounding.
                let bound = 4.0 * unit_roundoff(L::Real::SINGLE).sqrt();
                for (i, (got, wanted)) in got.iter().zip(wanted).enumerate() {
                    let close = got.iter().zip(wanted).all(|(a, b)| (a - b).abs() <= bound);
                    // A knee at the side that any will do for may go to another one.
                    let any_side = matches!(i % 16, 6 | 7);
                    assert!(close || any_side, "{i} {} {backend}: {got:?} {wanted:?}", L::name());
                }
            }
        }
    }
}

#[test]
fn plain_limbs_are_the_single_ones() {
    check::<Aos<f32>>();
    check::<Aos<f64>>();
}

#[test]
fn limbs_in_blocks_are_the_single_ones() {
    check::<AoSoA<[f32; 8]>>();
    check::<AoSoA<[f32; 16]>>();
    check::<AoSoA<[f64; 4]>>();
}

#[test]
fn what_cannot_be_bent_is_named_and_nothing_is_written() {
    let good = [[0.0_f32, 0.25, 0.5]; 19];
    let (mut uppers, mut lowers) = ([Quat::IDENTITY; 19], [Quat::IDENTITY; 19]);
    let mut run = |lengths: &[[f32; 2]], targets: &[[f32; 3]], poles: &[[f32; 3]]| {
        let backend = Backend::best();
        let error = backend.two_bone(&good, lengths, targets, poles, &mut uppers, &mut lowers);
        assert_eq!((uppers, lowers), ([Quat::IDENTITY; 19], [Quat::IDENTITY; 19]));
        error.unwrap_err()
    };
    let lengths = [[1.0, 1.0]; 19];
    let mut targets = good;
    (targets[17][2], targets[18][0]) = (f32::NAN, f32::INFINITY);
    let LimbsError::Limb { limb: 17, error: LimbError::NotFinite { what, index: 2, value } } =
        run(&lengths, &targets, &good)
    else {
        panic!()
    };
    assert!(what == "target" && value.is_nan());
    let mut negative = lengths;
    negative[18][1] = -0.5;
    let error = run(&negative, &good, &good);
    assert_eq!(error.to_string(), "limb 18: bone 1 cannot have the length -0.5");
    let length = |what, length| ShapeError::Length { what, length, expected: 19 }.into();
    assert_eq!(run(&lengths[1..], &good, &good), length("lengths", 18));
    assert_eq!(run(&lengths, &good[1..], &good), length("targets", 18));
    assert_eq!(run(&lengths, &good, &good[1..]), length("poles", 18));
}

/// A torso, a leg with a toe and a bone between hip and thigh that is no part of the limb, and a
/// second root.
const PARENTS: [u32; 8] = [Hierarchy::ROOT, 0, 0, 2, 3, 4, 5, Hierarchy::ROOT];
const JOINTS: usize = PARENTS.len();
const LEG: [usize; 3] = [3, 4, 5];
const ROOT: usize = Hierarchy::ROOT as usize;

/// Bends the legs of a crowd, and checks where their ends are, and that nothing else has changed.
fn bends<L: Memory>(instances: usize, joints: [usize; 3], roots: bool) {
    let mut random = Random(7);
    let single = |c: f64| round::<L::Real, 1>([c])[0].into();
    let mut motion = || step(&mut random).motion().map(single);
    let hinge = [0.6, 0.0, -0.8].map(single);
    let mut locals: Vec<[f64; 8]> = (0..instances * JOINTS).map(|_| motion()).collect();
    // The second joint turns about its hinge alone, as knees do.
    for i in 0..instances {
        let (at, t) = (i * JOINTS + joints[1], 0.1 * i as f64);
        let offset = DualQuat::from_array(locals[at]).translation();
        let turn = Quat::from_axis_angle(hinge, t);
        locals[at] = DualQuat::from_rotation_translation(turn, offset).to_array().map(single);
    }
    let bases: Vec<[f64; 8]> = (0..instances).map(|_| motion()).collect();
    let mut points = || -> Vec<[f64; 3]> {
        let mut point = || core::array::from_fn(|_| single(3.0 * random.signed()));
        (0..instances).map(|_| point()).collect()
    };
    let (targets, poles) = (points(), points());
    let hierarchy = Hierarchy::new(&PARENTS).expect("a hierarchy");
    let laid = (lay::<L, 8>(JOINTS, &locals), lay::<L, 8>(1, &bases));
    let (aims, sides) = (lay::<L, 3>(1, &targets), lay::<L, 3>(1, &poles));
    let limb = Limb { joints, hinge: round(hinge) };
    let bound = 4000.0 * unit_roundoff(L::Real::SINGLE);
    for backend in Backend::available() {
        let base = if roots {
            dq8::hierarchy::Root::Each(&laid.1[..])
        } else {
            dq8::hierarchy::Root::None
        };
        let job = hierarchy.job().backend(backend).on(base);
        let (mut new, mut models) = (laid.0.clone(), laid.0.clone());
        job.local_to_model(&laid.0, &mut models).expect("they fit");
        let before = read::<L, 8>(JOINTS, &models);
        job.two_bone(&limb, &models, &aims, &sides, &mut new).expect("a limb");
        job.local_to_model(&new, &mut models).expect("they fit");
        let (new, after) = (read::<L, 8>(JOINTS, &new), read::<L, 8>(JOINTS, &models));
        let motion =
            |of: &[[f64; 8]], i: usize, joint: usize| DualQuat::from_array(of[i * JOINTS + joint]);
        let away =
            |a: [f64; 3], b: [f64; 3]| (0..3).map(|c| (a[c] - b[c]).powi(2)).sum::<f64>().sqrt();
        let mut within = 0;
        for i in 0..instances {
            let what = format!("{} {backend} {i} of {instances}", L::name());
            for joint in 0..JOINTS {
                let [was, is] = [&locals, &new].map(|of| motion(of, i, joint));
                if !joints.contains(&joint) {
                    assert_eq!(was, is, "{what}: joint {joint}");
                }
                assert!(away(was.translation(), is.translation()) < bound, "{what}: {joint}");
            }
            let [hip, knee, foot] = joints.map(|joint| motion(&after, i, joint).translation());
            let lengths = [away(hip, knee), away(knee, foot)];
            let wanted = TwoBone::reach(hip, lengths, targets[i], poles[i]).expect("a limb");
            assert!((away(foot, targets[i]) - wanted.missed).abs() < bound, "{what}");
            within += usize::from(wanted.missed == 0.0);
            // On the side of the pole.
            let turned = wanted.upper.rotate([lengths[0], 0.0, 0.0]);
            let there = core::array::from_fn(|c| hip[c] + turned[c]);
            assert!(away(knee, there) < bound.sqrt(), "{what}: {knee:?} {there:?}");
            // The end keeps its turn, and the hinge turns as it did, and no other way.
            let [was, is] = [&before, &after].map(|of| motion(of, i, joints[2]).rotation());
            assert!((was.dot(is).abs() - 1.0).abs() < bound, "{what}: {was} {is}");
            let of_shin = motion(&locals, i, joints[2]).translation();
            let of_thigh = motion(&locals, i, joints[1]).translation();
            let normal = |bone: [f64; 3], axis: [f64; 3]| {
                let [x, y, z] = bone;
                let [a, b, c] = axis;
                let share = (x * a + y * b + z * c) / (x * x + y * y + z * z);
                let across = [a - share * x, b - share * y, c - share * z];
                let size = away(across, [0.0; 3]);
                across.map(|c| c / size)
            };
            // The part of the hinge across the shin, and the part of that across the thigh, as the
            // old knee had it, are the normal of the limb's plane: one vector in model space.
            let across_shin = normal(of_shin, hinge);
            let of_old_knee = motion(&locals, i, joints[1]).rotation().rotate(across_shin);
            let of_hip = motion(&after, i, joints[0]).rotation();
            let of_knee = motion(&after, i, joints[1]).rotation();
            let [a, b] =
                [of_hip.rotate(normal(of_thigh, of_old_knee)), of_knee.rotate(across_shin)];
            assert!(away(a, b) < bound, "{what}: {a:?} {b:?}");
        }
        assert!(instances < 9 || (1..instances).contains(&within), "{within} within reach");
    }
}

#[test]
fn legs_of_a_crowd_reach_their_targets_and_nothing_else_moves() {
    for instances in [0, 1, 3, 16, 35] {
        bends::<Aos<f32>>(instances, LEG, false);
        bends::<Aos<f64>>(instances, LEG, true);
        bends::<AoSoA<[f32; 8]>>(instances, LEG, true);
        bends::<AoSoA<[f32; 16]>>(instances, LEG, false);
        bends::<AoSoA<[f64; 4]>>(instances, LEG, false);
    }
    // A limb that begins at a root, with a base and without.
    for roots in [false, true] {
        bends::<Aos<f32>>(17, [0, 2, 3], roots);
        bends::<AoSoA<[f32; 8]>>(17, [0, 2, 3], roots);
    }
}

/// Bent to the same target once more, a limb stays as it is, however its hinge lies: what of it is
/// along a bone does not count.
#[test]
fn a_limb_that_is_bent_again_stays() {
    let hierarchy = Hierarchy::new(&PARENTS).expect("a hierarchy");
    let mut random = Random(17);
    for _ in 0..200 {
        let mut locals: [DualQuat<f64>; JOINTS] =
            core::array::from_fn(|_| DualQuat::from_array(step(&mut random).motion()));
        let hinge = core::array::from_fn(|_| random.signed());
        let limb = Limb { joints: LEG, hinge };
        let target = [core::array::from_fn(|_| random.signed())];
        let pole = [core::array::from_fn(|_| random.signed())];
        let bend = |locals: &mut [DualQuat<f64>; JOINTS]| {
            let mut models = *locals;
            hierarchy.job().local_to_model_in_place(&mut models).expect("they fit");
            hierarchy.job().two_bone(&limb, &models, &target, &pole, locals).expect("a limb");
        };
        bend(&mut locals);
        let once = locals;
        bend(&mut locals);
        for (joint, (a, b)) in once.iter().zip(&locals).enumerate() {
            assert!(a.angle_to(*b) < 1e-6, "joint {joint} of {hinge:?}: {}", a.angle_to(*b));
        }
    }
}

#[test]
fn what_is_no_limb_is_named_and_no_local_is_written() {
    let hierarchy = Hierarchy::new(&PARENTS).expect("a hierarchy");
    let down = DualQuat::from_translation([0.0_f32, -1.0, 0.0]);
    let (locals, targets) = ([down; 2 * JOINTS], [[0.0_f32, -4.0, 0.5]; 2]);
    let run = |joints, models: &[DualQuat<f32>], targets: &[[f32; 3]], poles: &[[f32; 3]]| {
        let mut new = locals;
        let limb = Limb { joints, hinge: [1.0, 0.0, 0.0] };
        let error = hierarchy.job().two_bone(&limb, models, targets, poles, &mut new).unwrap_err();
        assert_eq!(new, locals);
        error
    };
    let mut models = locals;
    hierarchy.job().local_to_model_in_place(&mut models).expect("they fit");
    for (joints, joint, parent) in [
        ([2, 4, 5], 4, 2),
        ([3, 4, 6], 6, 4),
        ([3, 4, 99], 99, 4),
        ([99, 4, 5], 4, 99),
        ([ROOT, 0, 1], 0, ROOT),
    ] {
        let error = run(joints, &models, &targets, &targets);
        assert_eq!(error, LimbsError::NotChild { joint, parent });
    }
    let length = |what, length, expected| ShapeError::Length { what, length, expected }.into();
    assert_eq!(run(LEG, &models, &targets[1..], &targets), length("targets", 1, 2));
    assert_eq!(run(LEG, &models, &targets, &targets[1..]), length("poles", 1, 2));
    assert_eq!(run(LEG, &models[JOINTS..], &targets, &targets), length("locals", 16, 8));
    let mut aside = targets;
    aside[1][0] = f32::NAN;
    let error = run(LEG, &models, &aside, &targets);
    assert_eq!(error.to_string(), "limb 1: the target is not finite: coordinate 0 is NaN");
    let mut lost = models;
    lost[JOINTS + 2] = DualQuat::from_translation([f32::INFINITY, 0.0, 0.0]);
    let error = run(LEG, &lost, &targets, &targets);
    assert!(error.to_string().starts_with("limb 1: the root is not finite"), "{error}");
    let limb = Limb { joints: LEG, hinge: [0.0, f32::NAN, 0.0] };
    let mut new = locals;
    let error = hierarchy.job().two_bone(&limb, &models, &targets, &targets, &mut new).unwrap_err();
    assert_eq!(error.to_string(), "the hinge is not finite: coordinate 1 is NaN");
}

#[cfg(feature = "rayon")]
#[test]
fn all_cores_bend_limbs_as_one_does() {
    let hierarchy = Hierarchy::new(&PARENTS).expect("a hierarchy");
    let mut random = Random(8);
    for instances in [0, 1, 100, 9001] {
        let asked = asked(instances);
        let [one, all] = [1, usize::MAX]
            .map(|threads| bent::<AoSoA<[f32; 16]>>(&asked, Backend::best().threads(threads)));
        assert_eq!(one, all);
        let motion = |_| DualQuat::from_array(step(&mut random).motion().map(|c| c as f32));
        let locals: Vec<_> = (0..instances * JOINTS).map(motion).collect();
        let point = |(_, _, target, _): &Asked| target.map(|c| c as f32);
        let targets: Vec<_> = asked.iter().map(point).collect();
        let mut models = locals.clone();
        hierarchy.job().local_to_model_in_place(&mut models).expect("they fit");
        let limb = Limb { joints: LEG, hinge: [1.0, 0.0, 0.0] };
        let roots: Vec<_> = locals.iter().step_by(JOINTS).copied().collect();
        let [one, all] = [1, usize::MAX].map(|threads| {
            let (mut new, job) = (locals.clone(), hierarchy.job().threads(threads).roots(&roots));
            job.two_bone(&limb, &models, &targets, &targets, &mut new).expect("a limb");
            new
        });
        assert!(one == all && (instances == 0 || one != locals), "{instances}");
    }
}

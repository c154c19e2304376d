//! Locals that are sampled from clips, blended and masked on their way into registers.

use crate::laws::Reference;
use crate::memory::{Memory, lay, read, round};
use crate::records::assert_same_bits;
use crate::scene::{motions, walk};
use dq8::hierarchy::{Clip, Layered, Sampled};
use dq8::storage::{AoSoA, Aos};
use dq8::{
    Backend, DualQuat, Hierarchy, Real, Scalar, ShapeError,
    hierarchy::Poses,
    law::{Nlerp, NlerpLerp, Sclerp, SlerpLerp},
    simd::Float,
};
use dq8_contract::bound::{unit_roundoff, within};
use dq8_contract::random::Random;

/// More joints than are made ahead at a time, in lanes too that are joints; three deep, with a
/// second root in the second group.
const PARENTS: [u32; JOINTS] = {
    let (mut parents, mut joint) = ([Hierarchy::ROOT; JOINTS], 1);
    while joint < JOINTS {
        if joint != 20 {
            parents[joint] = (joint as u32 - 1) / 8;
        }
        joint += 1;
    }
    parents
};
const JOINTS: usize = 70;
const FRAMES: usize = 5;

/// Two clips, where each of so many instances is in them, and how they are layered.
struct Animation<const C: usize> {
    instances: usize,
    keys: [Vec<[f64; C]>; 2],
    frames: [Vec<u32>; 2],
    t: [Vec<f64>; 2],
    weights: Vec<f64>,
    mask: Vec<f64>,
}

/// Numbers in [0, 1] that `f32` holds exactly.
fn eighths(random: &mut Random, count: usize) -> Vec<f64> {
    (0..count).map(|_| random.below(9) as f64 / 8.0).collect()
}

impl<const C: usize> Animation<C> {
    /// The keys are rounded to what the layout holds.
    fn new<W: Reference<C>, R: Scalar>(instances: usize) -> Self {
        let mut random = Random(instances as u64 + 1);
        let mut many = || -> Vec<[f64; C]> {
            let key = |_| round::<R, C>(W::key(&mut random)).map(Into::into);
            (0..JOINTS * FRAMES).map(key).collect()
        };
        let keys = [many(), many()];
        let mut frames = || -> Vec<u32> {
            let frame = |_| random.below(FRAMES - 1) as u32;
            (0..instances).map(frame).collect()
        };
        let frames = [frames(), frames()];
        let t = [eighths(&mut random, instances), eighths(&mut random, instances)];
        let weights = eighths(&mut random, instances);
        Self { instances, keys, frames, t, weights, mask: eighths(&mut random, JOINTS) }
    }

    /// What the keys of a clip come to, `[instance][joint]`.
    fn sampled<W: Reference<C>>(&self, clip: usize) -> Vec<[f64; C]> {
        let at = |index: usize| {
            let (instance, joint) = (index / JOINTS, index % JOINTS);
            let key = self.frames[clip][instance] as usize * JOINTS + joint;
            let (a, b) = (self.keys[clip][key], self.keys[clip][key + JOINTS]);
            W::between_by_the_book(a, b, self.t[clip][instance])
        };
        (0..self.instances * JOINTS).map(at).collect()
    }

    /// What `combine` makes of each pose, of two layers and the weight.
    fn layered(
        &self,
        [base, layer]: [&[[f64; C]]; 2],
        combine: impl Fn([f64; C], [f64; C], f64) -> [f64; C],
    ) -> Vec<[f64; C]> {
        let pair = base.iter().zip(layer).enumerate();
        pair.map(|(i, (a, b))| combine(*a, *b, self.weights[i / JOINTS] * self.mask[i % JOINTS]))
            .collect()
    }
}

/// The models of both layers, sampled, blended and added, against the scalar reference, on every
/// backend.
fn check<L: Memory, W: Reference<C>, const C: usize>(instances: usize) {
    let animation = Animation::<C>::new::<W, L::Real>(instances);
    let hierarchy = Hierarchy::new(&PARENTS).expect("parents come first");
    let keys = animation
        .keys
        .each_ref()
        .map(|keys| -> Vec<[L::Real; C]> { keys.iter().map(|key| round(*key)).collect() });
    let number = |number: &f64| round::<L::Real, 1>([*number])[0];
    let t = animation.t.each_ref().map(|t| -> Vec<_> { t.iter().map(number).collect() });
    let weights: Vec<_> = animation.weights.iter().map(number).collect();
    let mask: Vec<_> = animation.mask.iter().map(number).collect();
    let [one, other] = [0, 1].map(|i| {
        let clip = Clip::new(JOINTS, &keys[i]).expect("whole frames");
        Sampled::new(W::LAW, clip, &animation.frames[i], &t[i]).expect("frames of the clip")
    });
    let [first, second] = [0, 1].map(|i| animation.sampled::<W>(i));
    let stored = lay::<L, C>(JOINTS, &first);
    let wanted = |locals: &[[f64; C]]| -> Vec<[f64; 8]> {
        let locals: Vec<_> = locals.iter().map(|pose| W::as_motion(*pose)).collect();
        locals.chunks(JOINTS).flat_map(|of_one| walk(&PARENTS, of_one)).collect()
    };
    let layered = |combine: fn(_, _, _) -> _| animation.layered([&first, &second], combine);
    let of_blend = wanted(&layered(W::between_by_the_book));
    let of_sum = wanted(&layered(W::add_by_the_book));
    let of_first = wanted(&first);
    let blend = Layered::blend(W::LAW, one, other, &weights).mask(&mask);
    // A stored base, and the layer of a clip added to it.
    let sum = Layered::add(W::LAW, W::stored::<L>(&stored), other, &weights).mask(&mask);
    for backend in Backend::available() {
        let job = hierarchy.job().backend(backend);
        let blank = || vec![L::filled::<8>(L::Real::ZERO); stored.len()];
        let holds = |what: &str, models: &[L::Record<8>], wanted: &[[f64; 8]]| {
            let why = "three joints deep; each an interpolation, a layer, a product";
            let allowed = within(24.0, why).units * unit_roundoff(L::Real::SINGLE) * 12.0;
            for (i, (got, wanted)) in read::<L, 8>(JOINTS, models).iter().zip(wanted).enumerate() {
                let dot: f64 = got.iter().zip(wanted).take(4).map(|(a, b)| a * b).sum();
                for (a, b) in got.iter().zip(wanted) {
                    assert!(
                        (a - b * dot.signum()).abs() <= allowed,
                        "{} {backend} {what}, {instances} instances: {} {}: {got:?} {wanted:?}",
                        L::name(),
                        i / JOINTS,
                        i % JOINTS
                    );
                }
            }
        };

        let mut models = blank();
        job.locals_to_model(one, &mut models).expect("they fit");
        holds("sampled", &models, &of_first);

        let mut models = blank();
        job.locals_to_model(blend, &mut models).expect("they fit");
        holds("blended", &models, &of_blend);

        // A palette through scratch: instances after those of the first part have places, weights
        // and poses of their own.
        let (mut scratch, mut palette) = (models.clone(), blank());
        scratch.truncate(if L::THINGS == 1 { 16 } else { 2 } * JOINTS);
        let binds = [DualQuat::IDENTITY; JOINTS];
        job.palette(blend, &mut scratch, &binds, &mut palette).expect("they fit");
        let [got, wanted] = [&palette, &models].map(|poses| read::<L, 8>(JOINTS, poses));
        assert_eq!(got, wanted, "a palette through scratch");

        // Some of the joints, onto models that are there already.
        let mut again: Vec<_> = models.clone();
        let blank_models = blank();
        for (i, model) in again.iter_mut().enumerate().filter(|(i, _)| i % JOINTS >= 3) {
            *model = blank_models[i];
        }
        job.clone().joints(3..JOINTS).locals_to_model(blend, &mut again).expect("they fit");
        let [all, some] = [&models, &again].map(|models| read::<L, 8>(JOINTS, models));
        assert_same_bits(&some, &all, "joints from the third on");

        // The locals themselves are the models of joints that are all roots, on every backend and
        // from any register.
        let flat = [Hierarchy::ROOT; JOINTS];
        let flat = Hierarchy::new(&flat).expect("roots are joints");
        let (mut locals, mut wanted) = (blank(), blank());
        flat.job().backend(backend).locals_to_model(blend, &mut wanted).expect("they fit");
        job.locals(blend, &mut locals).expect("they fit");
        let (all, models) = (read::<L, 8>(JOINTS, &locals), read::<L, 8>(JOINTS, &wanted));
        assert_same_bits(&all, &models, "the locals of all joints");
        let (mut some, rest) = (blank(), read::<L, 8>(JOINTS, &blank()));
        job.clone().joints(2..5).locals(blend, &mut some).expect("they fit");
        for (i, some) in read::<L, 8>(JOINTS, &some).iter().enumerate() {
            let from = if (2..5).contains(&(i % JOINTS)) { &all } else { &rest };
            assert_same_bits(
                &[*some],
                &from[i..=i],
                "the locals of some joints, and nothing beside them",
            );
        }

        let mut models = blank();
        job.locals_to_model(sum, &mut models).expect("they fit");
        holds("added", &models, &of_sum);
    }
}

/// No instance, one, some that fill no lanes, and more than fill two groups.
fn check_all<L: Memory>() {
    for instances in [0, 1, 3, 16, 35] {
        check::<L, Nlerp, 8>(instances);
        check::<L, Sclerp, 8>(instances);
        check::<L, NlerpLerp, 7>(instances);
        check::<L, SlerpLerp, 7>(instances);
    }
}

#[test]
fn plain_singles_are_sampled_and_layered_as_the_scalar_reference_does() {
    check_all::<Aos<f32>>();
}

#[test]
fn plain_doubles_are_sampled_and_layered_as_the_scalar_reference_does() {
    check_all::<Aos<f64>>();
}

#[test]
fn blocks_are_sampled_and_layered_as_the_scalar_reference_does() {
    check_all::<AoSoA<[f32; 8]>>();
    check_all::<AoSoA<[f32; 16]>>();
    check_all::<AoSoA<[f64; 4]>>();
}

#[test]
fn what_does_not_fit_is_named_and_nothing_is_written() {
    let hierarchy = Hierarchy::new(&PARENTS).expect("parents come first");
    let keys = [[0.0_f32; 8]; JOINTS * FRAMES];
    assert_eq!(
        Clip::new(JOINTS, &keys[1..]).unwrap_err(),
        ShapeError::NotWhole { what: "keys", length: JOINTS * FRAMES - 1, joints: JOINTS }
    );
    for joints in [0, 1, JOINTS] {
        let empty = Clip::new(joints, &keys[..0]).map(|clip| clip.frames());
        assert_eq!(
            empty,
            Err(ShapeError::Empty { what: "keys" }),
            "a clip of no frame has no place"
        );
    }
    let clip = Clip::new(JOINTS, &keys).expect("whole frames");
    let last = FRAMES as u32 - 1;
    assert_eq!(
        Sampled::new(Nlerp, clip, &[0, last], &[0.0; 2]).unwrap_err(),
        ShapeError::NoFrame { instance: 1, frame: FRAMES - 1, frames: FRAMES },
        "no frame follows the last"
    );
    assert!(Sampled::new(Nlerp, clip, &[u32::MAX], &[0.0]).is_err());
    let length = |what, length, expected| Err(ShapeError::Length { what, length, expected });
    assert_eq!(Sampled::new(Nlerp, clip, &[0, 1], &[0.0]).map(|_| ()), length("t", 1, 2));

    let before = [DualQuat::<f32>::IDENTITY.scale(3.0); 2 * JOINTS];
    let mut models = before;
    let sampled = Sampled::new(Nlerp, clip, &[0, 1], &[0.0, 0.5]).expect("it fits");
    let refused = |answer: Result<(), ShapeError>, wanted: Result<(), ShapeError>| {
        assert_eq!(answer, wanted);
    };
    let job = hierarchy.job();
    refused(
        job.locals_to_model(sampled, &mut models[1..]),
        length("models", 2 * JOINTS - 1, 2 * JOINTS),
    );
    refused(job.locals(sampled, &mut models[1..]), length("models", 2 * JOINTS - 1, 2 * JOINTS));
    let beyond = Err(ShapeError::Joints { range: 3..JOINTS + 2, joints: JOINTS });
    refused(job.clone().joints(3..JOINTS + 2).locals(sampled, &mut models), beyond);
    let layer = |weights| Layered::blend(Nlerp, sampled, sampled, weights);
    refused(job.locals_to_model(layer(&[0.5]), &mut models), length("weights", 1, 2));
    let masked = layer(&[0.5; 2]).mask(&[1.0; 3]);
    refused(job.locals_to_model(masked, &mut models), length("mask", 3, JOINTS));
    let short = Sampled::new(Nlerp, clip, &[0], &[0.0]).expect("it fits");
    let uneven = Layered::blend(Nlerp, sampled, short, &[0.5; 2]);
    refused(job.locals_to_model(uneven, &mut models), length("layer", JOINTS, 2 * JOINTS));
    let one = [Hierarchy::ROOT];
    let one = Hierarchy::new(&one).expect("a hierarchy");
    refused(
        one.job().locals_to_model(sampled, &mut models[..2]),
        length("each frame of the clip", JOINTS, 1),
    );
    let binds = [DualQuat::IDENTITY; JOINTS];
    let mut palette = before;
    refused(
        job.palette(sampled, &mut [binds[0]; 0], &binds, &mut palette),
        length("scratch", 0, JOINTS),
    );
    // The model of joint 0 is in no scratch: that of instance 1 least of all.
    let mut scratch = [DualQuat::IDENTITY; JOINTS];
    let tail = hierarchy.job().joints(1..JOINTS);
    refused(
        tail.palette(sampled, &mut scratch, &binds, &mut palette),
        Err(ShapeError::NoParent { joint: 1, parent: 0 }),
    );
    assert_eq!((models, palette), (before, before));
}

/// Nine instances and ten weights fill as many blocks of eight.
#[test]
fn weights_of_other_instances_are_refused_though_they_fill_as_many_blocks() {
    let hierarchy = Hierarchy::new(&PARENTS).expect("parents come first");
    let keys = [[0.0_f32; 8]; JOINTS * FRAMES];
    let clip = Clip::new(JOINTS, &keys).expect("whole frames");
    let sampled = Sampled::new(Nlerp, clip, &[0; 9], &[0.5; 9]).expect("it fits");
    let mut models = dq8::Crowd::<f32, 8>::new(JOINTS, 9);
    let before = models.clone();
    let refused = Err(ShapeError::Length { what: "weights", length: 10, expected: 9 });
    let stored = Poses(before.blocks());
    let layer = Layered::blend(Nlerp, stored, sampled, &[0.5; 10]);
    assert_eq!(hierarchy.job().locals_to_model(layer, models.blocks_mut()), refused);
    let layer = Layered::add(Nlerp, sampled, stored, &[0.5; 10]);
    assert_eq!(hierarchy.job().locals_to_model(layer, models.blocks_mut()), refused);
    assert_eq!(models, before);
}

/// σ and −σ are the same key.
#[test]
fn the_sign_of_a_key_changes_no_pose() {
    let clip = |sign: f64| {
        let mut random = Random(3);
        let keys: Vec<_> = (0..JOINTS * 2).map(|_| motions(&mut random, 1)[0]).collect();
        let sign = |i: usize| if i >= JOINTS { sign } else { 1.0 };
        keys.iter().enumerate().map(|(i, key)| key.map(|c| c * sign(i))).collect::<Vec<_>>()
    };
    let hierarchy = Hierarchy::new(&PARENTS).expect("parents come first");
    let models = |keys: &[[f64; 8]]| {
        let clip = Clip::new(JOINTS, keys).expect("whole frames");
        let mut models = [DualQuat::<f64>::IDENTITY; 9 * JOINTS];
        let sampled = Sampled::new(Nlerp, clip, &[0; 9], &[0.25; 9]).expect("it fits");
        hierarchy.job().locals_to_model(sampled, &mut models).expect("it fits");
        models
    };
    assert_eq!(models(&clip(1.0)), models(&clip(-1.0)));
}

#[test]
fn a_place_lies_between_two_frames_and_beyond_the_clip_at_its_ends() {
    let keys = [[0.0_f64; 8]; 2 * FRAMES];
    let clip = Clip::new(2, &keys).unwrap();
    let before = [f64::NEG_INFINITY, -3.0, 0.0].map(|at| (at, (0, 0.0)));
    let beyond = [4.0, 9.0, 1e300, f64::INFINITY].map(|at| (at, (3, 1.0)));
    let between = [(0.5, (0, 0.5)), (1.25, (1, 0.25)), (3.0, (3, 0.0)), (3.75, (3, 0.75))];
    for (at, wanted) in before.into_iter().chain(beyond).chain(between) {
        assert_eq!(clip.place(at), wanted, "{at}");
    }
    let (frame, t) = clip.place(f64::NAN);
    assert!(frame == 0 && t.is_nan());
}

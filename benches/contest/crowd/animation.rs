//! What a crowd needs for a frame: two clips sampled at each character's own times, blended by its
//! own weight, to model space, and the palette of 3×4 matrices.

use crate::backends;
use crate::contest::Contest;
use crate::memory::{Element, Own, Product, Representation, Rows3x4};
use crate::scene::{Scene, Shape};
use crate::walk;
use dq8::hierarchy::{Clip, Layered, Locals, PackedClip, Sampled, Tolerance, TrackPlace};
use dq8::{
    Backend, Block, DualQuat, Hierarchy,
    law::{Nlerp, NlerpLerp},
    representation::RotationTranslation,
};
use dq8_fixtures::random::Random;
use glam::{Affine3A, Quat, Vec3A};

/// Frames of a clip: two seconds at 30 a second.
const FRAMES: usize = 60;
/// Characters that differ.
const DIFFERENT: usize = 64;
/// So many models of characters go through memory at a time.
const SCRATCH: usize = 16;

type Motion = DualQuat<f32>;
/// `[x, y, z, w, tx, ty, tz]`
type Key = [f32; 7];

/// Where the characters are in the two clips, and how much they have of the second.
struct Crowd {
    parents: Vec<u32>,
    motions: [Vec<Motion>; 2],
    keys: [Vec<Key>; 2],
    packed: PackedClip,
    /// What the packed keys are, for they are not quite those.
    unpacked: [Vec<Motion>; 2],
    frames: [Vec<u32>; 2],
    places: [Vec<TrackPlace>; 2],
    t: [Vec<f32>; 2],
    weights: Vec<f32>,
    binds: Vec<Motion>,
}

impl Crowd {
    /// The first joints of the skeleton, so many or all.
    fn new(instances: usize, joints: usize) -> Self {
        let mut scene = Scene::new(Shape::Crowd { instances: DIFFERENT });
        let all = scene.parents.len();
        scene.parents.truncate(joints);
        let joints = scene.parents.len();
        let mut random = Random(4);
        // The joints swing between the poses of two of the scene's instances, at speeds of their
        // own.
        let poses = scene.locals.different();
        let swing = |first: usize, frame: usize, joint: usize| {
            let [a, b] = [first, first + 1].map(|instance| poses[instance * all + joint]);
            let speed = 0.05 + 0.01 * (joint % 8) as f32;
            a.sclerp(b, 0.5 + 0.5 * (speed * frame as f32 + joint as f32).sin())
        };
        let motions = [0, 4].map(|first| -> Vec<_> {
            let all = (0..FRAMES).flat_map(|frame| (0..joints).map(move |joint| (frame, joint)));
            all.map(|(frame, joint)| match (joint, scene.bones[joint]) {
                (0, _) => swing(first, frame, joint),
                (_, bone) => {
                    Motion::from_rotation_translation(swing(first, frame, joint).rotation(), bone)
                }
            })
            .collect()
        });
        let mut again = |below: f64| -> Vec<f64> {
            let once: Vec<_> = (0..DIFFERENT).map(|_| random.between(0.0, below)).collect();
            once.into_iter().cycle().take(instances).collect()
        };
        let mut frames = || again((FRAMES - 1) as f64).iter().map(|at| *at as u32).collect();
        let frames: [Vec<u32>; 2] = [frames(), frames()];
        let mut parameters = || again(1.0).iter().map(|t| *t as f32).collect();
        let key = |&motion: &Motion| -> Key { RotationTranslation::from(motion).into() };
        let keys = motions.each_ref().map(|motions| motions.iter().map(key).collect::<Vec<_>>());
        let packed = PackedClip::library(
            &keys.each_ref().map(|keys| Clip::new(joints, keys).expect("whole frames")),
            Tolerance::default(),
        )
        .expect("unit rotations");
        let clips = packed.clips();
        let place = |clip: usize, frame: u32| clips.place(clip, frame as f32).expect("a frame").0;
        let places =
            [0, 1].map(|clip| frames[clip].iter().map(|&frame| place(clip, frame)).collect());
        let unpacked = [0, 1].map(|clip| {
            let at = (0..FRAMES).filter_map(|frame| clips.place(clip, frame as f32));
            let (places, t): (Vec<_>, Vec<_>) = at.unzip();
            let sampled =
                Sampled::new(NlerpLerp, clips, &places, &t).expect("places of these clips");
            // Each joint a root: its model is its pose.
            let apart = vec![Hierarchy::ROOT; joints];
            let mut poses = vec![Motion::IDENTITY; FRAMES * joints];
            let hierarchy = Hierarchy::new(&apart).expect("roots");
            hierarchy.job().locals_to_model(sampled, &mut poses).expect("they fit");
            poses
        });
        Self {
            keys,
            packed,
            unpacked,
            places,
            frames,
            t: [parameters(), parameters()],
            weights: parameters(),
            binds: poses[..joints].iter().map(|pose| pose.conjugate()).collect(),
            motions,
            parents: scene.parents,
        }
    }

    /// The locals of an instance by `f64`, from what lies between two motions.
    fn locals(
        &self,
        instance: usize,
        motions: &[Vec<Motion>; 2],
        between: impl Fn(DualQuat<f64>, DualQuat<f64>, f64) -> DualQuat<f64>,
    ) -> Vec<Rows3x4<f64>> {
        let joints = self.parents.len();
        let sampled = |clip: usize, joint: usize| {
            let at = self.frames[clip][instance] as usize * joints + joint;
            let [a, b] = [at, at + joints].map(|at| motions[clip][at].cast());
            between(a, b, self.t[clip][instance].into())
        };
        let weight = f64::from(self.weights[instance]);
        let local = |joint| between(sampled(0, joint), sampled(1, joint), weight);
        (0..joints).map(|joint| Rows3x4(local(joint).to_matrix3x4())).collect()
    }

    /// The palette by `f64`.
    fn expected(
        &self,
        motions: &[Vec<Motion>; 2],
        between: impl Fn(DualQuat<f64>, DualQuat<f64>, f64) -> DualQuat<f64> + Copy,
    ) -> Vec<Vec<f64>> {
        let hierarchy = Hierarchy::new(&self.parents).expect("parents come first");
        let of_one = |instance: usize| {
            let mut models = self.locals(instance, motions, between);
            walk::local_to_model_in_place(&hierarchy, &mut models);
            let binds = self.binds.iter().map(Rows3x4::<f64>::from_motion);
            let entries = models.iter().zip(binds).map(|(model, bind)| model.product(&bind));
            entries.map(|entry| entry.numbers(0)).collect::<Vec<_>>()
        };
        (0..self.weights.len().min(DIFFERENT)).flat_map(of_one).collect()
    }
}

/// Rotations and translations apart, as engines have them.
fn apart(a: DualQuat<f64>, b: DualQuat<f64>, t: f64) -> DualQuat<f64> {
    let [from, to] = [a, b].map(|pose| DualQuat::from_rotation(pose.rotation()));
    let turn = from.nlerp(to, t).rotation();
    let (from, to) = (a.translation(), b.translation());
    let shift = std::array::from_fn(|i| (1.0 - t) * from[i] + t * to[i]);
    DualQuat::from_rotation_translation(turn, shift)
}

/// Both clips of the crowd, sampled and blended.
macro_rules! locals {
    ($crowd:ident, $law:expr, $keys:ident) => {{
        let [a, b] = [0, 1].map(|i| {
            let clip = Clip::new($crowd.parents.len(), &$crowd.$keys[i]).expect("whole frames");
            Sampled::new($law, clip, &$crowd.frames[i], &$crowd.t[i]).expect("frames of the clip")
        });
        Layered::blend($law, a, b, &$crowd.weights)
    }};
    ($crowd:ident) => {{
        let [a, b] = [0, 1].map(|i| {
            Sampled::new(NlerpLerp, $crowd.packed.clips(), &$crowd.places[i], &$crowd.t[i])
                .expect("places of these clips")
        });
        Layered::blend(NlerpLerp, a, b, &$crowd.weights)
    }};
}

pub fn with_contest(instances: usize, run: &mut dyn FnMut(&Contest<'_>)) {
    let crowd = Crowd::new(instances, usize::MAX);
    let joints = crowd.parents.len();
    let title = format!(
        "{instances} characters of {joints} joints: two clips sampled, blended, to model space, 3×4 matrices"
    );
    let mut contest = Contest {
        transforms: instances * joints,
        tolerance: 6e-5,
        expected: crowd.expected(&crowd.motions, apart),
        ..Contest::new("J6", format!("{joints}x{instances} animated"), title)
    };
    for backend in backends() {
        plain(&mut contest, &crowd, backend, "rotations and translations", |crowd| {
            locals!(crowd, NlerpLerp, keys)
        });
        // Both clips in one library.
        plain(&mut contest, &crowd, backend, "packed", |crowd| locals!(crowd));
        contest.last_should(crowd.expected(&crowd.unpacked, apart));
        plain(&mut contest, &crowd, backend, "motions", |crowd| locals!(crowd, Nlerp, motions));
        contest.last_should(crowd.expected(&crowd.motions, DualQuat::nlerp));
        blocks::<8>(&mut contest, &crowd, backend);
        blocks::<16>(&mut contest, &crowd, backend);
    }
    glam(&mut contest, &crowd);
    run(&contest);
}

/// Locals of packed clips that are written down, beside the models of the same, which are more
/// work.
pub fn with_locals_contest(instances: usize, joints: usize, run: &mut dyn FnMut(&Contest<'_>)) {
    let crowd = Crowd::new(instances, joints);
    let title = format!("{instances} characters of {joints} joints: two packed clips, blended");
    let of_one = |instance| crowd.locals(instance, &crowd.unpacked, apart);
    let numbers =
        |poses: &[Rows3x4<f64>]| -> Vec<_> { poses.iter().map(|pose| pose.numbers(0)).collect() };
    let locals: Vec<_> = (0..instances.min(DIFFERENT)).map(of_one).collect();
    let mut models = locals.clone();
    let hierarchy = Hierarchy::new(&crowd.parents).expect("parents come first");
    models.iter_mut().for_each(|poses| walk::local_to_model_in_place(&hierarchy, poses));
    let [locals, models] =
        [locals, models].map(|all| all.iter().flat_map(|one| numbers(one)).collect::<Vec<_>>());
    let mut contest = Contest {
        transforms: instances * joints,
        tolerance: 6e-5,
        expected: locals,
        ..Contest::new("J6", format!("{joints}x{instances} locals"), title)
    };
    for backend in backends() {
        written::<Motion>(&mut contest, &crowd, backend, "AoS", &models);
        written::<Block<f32, 16>>(&mut contest, &crowd, backend, "16 lanes", &models);
    }
    run(&contest);
}

fn written<'a, P: Own>(
    contest: &mut Contest<'a>,
    crowd: &'a Crowd,
    backend: Backend,
    layout: &str,
    expected: &[Vec<f64>],
) {
    let joints = crowd.parents.len();
    let memory = move || {
        ((), vec![P::gather(&[Motion::IDENTITY; 16]); crowd.weights.len() / P::LANES * joints])
    };
    let job =
        move || Hierarchy::new(&crowd.parents).expect("parents come first").job().backend(backend);
    let numbers = move |poses: &[P], index: usize| {
        let (instance, joint) = (index / joints, index % joints);
        let element = &poses[instance / P::LANES * joints + joint];
        element.numbers(instance % P::LANES)
    };
    let name = |what: &str| format!("dq8 {what}, {layout} {backend}");
    let pass = move |(): &(), to: &mut [P]| job().locals(locals!(crowd), to).expect("they fit");
    contest.add(name("locals"), Some(backend), memory, pass, numbers);
    let pass =
        move |(): &(), to: &mut [P]| job().locals_to_model(locals!(crowd), to).expect("they fit");
    contest.add(name("models"), Some(backend), memory, pass, numbers);
    contest.last_should(expected.to_vec());
}

/// Of plain motions, whatever locals are made of.
fn plain<'a, L: Locals<Motion>>(
    contest: &mut Contest<'a>,
    crowd: &'a Crowd,
    backend: Backend,
    name: &str,
    locals: impl Fn(&'a Crowd) -> L + Copy + 'a,
) {
    let joints = crowd.parents.len();
    let memory = move || ((), vec![[[0.0_f32; 4]; 3]; crowd.weights.len() * joints]);
    let pass = move |(): &(), palette: &mut [[[f32; 4]; 3]]| {
        let hierarchy = Hierarchy::new(&crowd.parents).expect("parents come first");
        let mut scratch = vec![Motion::IDENTITY; SCRATCH * joints];
        let job = hierarchy.job().backend(backend);
        job.palette(locals(crowd), &mut scratch, &crowd.binds, palette).expect("they fit");
    };
    contest.add(format!("dq8 {name}, AoS {backend}"), Some(backend), memory, pass, numbers);
}

fn numbers(palette: &[[[f32; 4]; 3]], index: usize) -> Vec<f64> {
    palette[index].as_flattened().iter().map(|number| f64::from(*number)).collect()
}

fn blocks<'a, const N: usize>(contest: &mut Contest<'a>, crowd: &'a Crowd, backend: Backend)
where
    [f32; N]: dq8::simd::Row<Real = f32>,
{
    let joints = crowd.parents.len();
    let blocks = crowd.weights.len() / N * joints;
    let memory = move || ((), vec![Block::<f32, N, 12>::splat([0.0; 12]); blocks]);
    let pass = move |(): &(), palette: &mut [Block<f32, N, 12>]| {
        let hierarchy = Hierarchy::new(&crowd.parents).expect("parents come first");
        let mut scratch = vec![Block::<f32, N>::splat([0.0; 8]); SCRATCH / N * joints];
        let locals = locals!(crowd, NlerpLerp, keys);
        let job = hierarchy.job().backend(backend);
        job.palette(locals, &mut scratch, &crowd.binds, palette).expect("they fit");
    };
    let numbers = move |palette: &[Block<f32, N, 12>], index: usize| {
        let (instance, joint) = (index / joints, index % joints);
        palette[instance / N * joints + joint].numbers(instance % N)
    };
    let name = format!("dq8 rotations and translations, {N} lanes {backend}");
    contest.add(name, Some(backend), memory, pass, numbers);
}

/// What users of glam write, with the law of engines.
fn glam<'a>(contest: &mut Contest<'a>, crowd: &'a Crowd) {
    let joints = crowd.parents.len();
    let memory = move || {
        let apart =
            |&[x, y, z, w, tx, ty, tz]: &Key| (Quat::from_xyzw(x, y, z, w), Vec3A::new(tx, ty, tz));
        let clips = crowd.keys.each_ref().map(|keys| keys.iter().map(apart).collect::<Vec<_>>());
        let binds: Vec<_> = crowd.binds.iter().map(Affine3A::from_motion).collect();
        let models = vec![Affine3A::IDENTITY; joints];
        ((clips, binds, models), vec![Affine3A::IDENTITY; crowd.weights.len() * joints])
    };
    type Clips = [Vec<(Quat, Vec3A)>; 2];
    let between = |a: (Quat, Vec3A), b: (Quat, Vec3A), t| (a.0.lerp(b.0, t), a.1.lerp(b.1, t));
    let pass = move |(clips, binds, models): &(Clips, Vec<Affine3A>, Vec<Affine3A>),
                     palette: &mut [Affine3A]| {
        let mut models = models.clone();
        for (instance, entries) in palette.chunks_exact_mut(joints).enumerate() {
            let frames = [0, 1].map(|clip| {
                &clips[clip][crowd.frames[clip][instance] as usize * joints..][..2 * joints]
            });
            for joint in 0..joints {
                let [a, b] = [0, 1].map(|clip| {
                    let (from, to) = (frames[clip][joint], frames[clip][joint + joints]);
                    between(from, to, crowd.t[clip][instance])
                });
                let (turn, shift) = between(a, b, crowd.weights[instance]);
                let local = Affine3A::from_rotation_translation(turn, shift.into());
                models[joint] = match crowd.parents[joint] {
                    Hierarchy::ROOT => local,
                    parent => models[parent as usize] * local,
                };
                entries[joint] = models[joint] * binds[joint];
            }
        }
    };
    let numbers = |palette: &[Affine3A], index: usize| palette[index].numbers(0);
    contest.add("glam Quat, Vec3A, Affine3A", None, memory, pass, numbers);
}

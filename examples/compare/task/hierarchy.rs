//! J2 and J3: down the joints of many skeletons, or of one.

use crate::contest::Contest;
use crate::limit::{Limit, Limited};
use crate::memory::{Many, Packed, QuatVec3A, flat};
use crate::representation::{Product, Representation};
use crate::rows::Rows3x4;
use crate::{skeleton, walk};
use dq8::{Backend, Block, DualQuat, Hierarchy, Pose};
use glam::{Affine3A, Mat4};
use nalgebra::{Isometry3, UnitDualQuaternion};
use simba::simd::WideF32x8;
use ultraviolet::{Isometry3x8, Mat4x8};

#[derive(Clone, Copy)]
pub(crate) enum Shape {
    /// Of 64 joints.
    Crowd { instances: usize },
    /// One, of 21.
    Biped,
    /// One, of a thousand joints in a row.
    Chain,
}

#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Way {
    /// From locals into models.
    Out,
    /// Over the locals.
    In,
    /// From rotations and the bones that all instances share into models, beside this crate's own
    /// way from motions.
    Rotations,
}

type Motion = DualQuat<f32>;

/// The biped of the example `mocap`, links and tips: parents, and metres from them. Two arms, two
/// legs.
const BIPED: [(u32, f64); 21] = {
    const ROOT: u32 = Hierarchy::ROOT;
    [
        (ROOT, 0.0),
        (0, 0.10),
        (1, 0.17),
        (2, 0.30),
        (3, 0.24),
        (2, 0.30),
        (5, 0.30),
        (6, 0.26),
        (7, 0.17),
        (2, 0.30),
        (9, 0.30),
        (10, 0.26),
        (11, 0.17),
        (0, 0.09),
        (13, 0.44),
        (14, 0.44),
        (15, 0.21),
        (0, 0.09),
        (17, 0.44),
        (18, 0.44),
        (19, 0.21),
    ]
};
const CHAIN: u32 = 1000;
/// Metres between the joints of the chain.
const LINK: f64 = 0.1;

struct Scene {
    parents: Vec<u32>,
    locals: Many<Motion>,
    /// Of each joint, from its parent; zero for roots.
    bones: Vec<[f32; 3]>,
}

pub(crate) fn with_contest<R>(shape: Shape, way: Way, run: impl FnOnce(&Contest<'_>) -> R) -> R {
    let scene = Scene::new(shape);
    let hierarchy = Hierarchy::new(&scene.parents).expect("parents come first");
    let joints = hierarchy.joints();
    let (suffix, in_words) = match way {
        Way::Out => (" out", "out of place"),
        Way::In => ("", "in place"),
        Way::Rotations => (" rotations", "from rotations"),
    };
    // Twelve levels of single precision lose a few millionths.
    let (job, size, title, tolerance) = match shape {
        Shape::Crowd { instances: 1 } => {
            ("J3", format!("skeleton {joints}"), "one skeleton".to_owned(), 3e-5)
        }
        Shape::Crowd { instances } => {
            let title = format!("{instances} skeletons of {joints} joints");
            ("J2", format!("{joints}x{instances}{suffix}"), title, 3e-5)
        }
        Shape::Biped => ("J3", "biped".to_owned(), format!("one biped of {joints} joints"), 3e-5),
        // A thousand roundings, and each turns all that follows.
        Shape::Chain => {
            ("J3", format!("chain {joints}"), format!("one chain of {joints} joints"), 1e-3)
        }
    };
    let mut contest = Contest {
        transforms: scene.locals.len(),
        tolerance,
        expected: scene.expected(&hierarchy),
        ..Contest::new(job, size, format!("{title}, {in_words}"))
    };
    let mut field = Field { scene: &scene, hierarchy, way, contest: &mut contest };
    match shape {
        Shape::Crowd { instances: 2.. } => field.crowd(),
        _ => field.one(),
    }
    if job == "J2" && way == Way::Out {
        let bytes = size_of::<Motion>() * contest.transforms;
        contest.limits.push(Limit::copy(contest.size.clone(), bytes));
        let moved = 2 * size_of::<Motion>();
        contest.limited = Some(Limited::Bytes(moved as f64, contest.size.clone()));
    }
    run(&contest)
}

impl Scene {
    fn new(shape: Shape) -> Self {
        let (parents, bones, instances) = match shape {
            Shape::Crowd { instances } => (skeleton::parents(), skeleton::bones(), instances),
            Shape::Biped => {
                let bone = |&(parent, length)| (parent != Hierarchy::ROOT).then_some(length);
                let parents = BIPED.iter().map(|&(parent, _)| parent).collect();
                (parents, BIPED.iter().map(bone).collect(), 1)
            }
            Shape::Chain => {
                let parents = [Hierarchy::ROOT].into_iter().chain(0..CHAIN - 1).collect();
                let bones = (0..CHAIN).map(|joint| (joint > 0).then_some(LINK)).collect();
                (parents, bones, 1)
            }
        };
        let different = skeleton::locals(&bones, instances.min(Many::<Motion>::DIFFERENT));
        let bones = parents.iter().zip(&different).map(|(&parent, local)| match parent {
            Hierarchy::ROOT => [0.0; 3],
            _ => local.translation(),
        });
        Self {
            bones: bones.collect(),
            locals: Many::new(parents.len(), different, instances),
            parents,
        }
    }

    fn rotations(&self) -> Many<[f32; 4]> {
        let (joints, locals) = (self.parents.len(), self.locals.different());
        let rotations = locals.iter().map(|local| local.rotation().to_array()).collect();
        Many::new(joints, rotations, self.locals.len() / joints)
    }

    /// Where each instance stands.
    fn roots(&self) -> Many<Motion> {
        let joints = self.parents.len();
        let instances = self.locals.different().chunks(joints);
        let places = instances.map(|poses| DualQuat::from_translation(poses[0].translation()));
        Many::new(1, places.collect(), self.locals.len() / joints)
    }

    fn expected(&self, hierarchy: &Hierarchy) -> Vec<Vec<f64>> {
        let different = self.locals.different().iter();
        let mut poses: Vec<_> = different.map(Rows3x4::<f64>::from_motion).collect();
        walk::local_to_model_in_place(hierarchy, &mut poses);
        poses.iter().map(|rows| flat(&rows.rows())).collect()
    }
}

struct Field<'a, 'c> {
    scene: &'a Scene,
    hierarchy: Hierarchy<'a>,
    way: Way,
    contest: &'c mut Contest<'a>,
}

impl<'a> Field<'a, '_> {
    fn crowd(&mut self) {
        self.own::<Block<f32, 8>>("8 lanes");
        self.own::<Block<f32, 16>>("16 lanes");
        if self.way == Way::Rotations {
            self.rotations::<Block<f32, 8>>("8 lanes");
            self.rotations::<Block<f32, 16>>("16 lanes");
            return;
        }
        self.one();
        self.peer::<UnitDualQuaternion<WideF32x8>>("nalgebra UnitDualQuaternion, 8 lanes");
        self.peer::<Isometry3<WideF32x8>>("nalgebra Isometry3, 8 lanes");
        self.peer::<Isometry3x8>("ultraviolet Isometry3x8");
        self.peer::<Mat4x8>("ultraviolet Mat4x8");
    }

    /// Those who need no other instances to fill their lanes.
    fn one(&mut self) {
        self.peer::<Motion>("dq8 scalar");
        self.own::<Motion>("AoS");
        self.peer::<Mat4>("glam Mat4");
        self.peer::<Affine3A>("glam Affine3A");
        self.peer::<QuatVec3A>("glam Quat+Vec3A");
        self.peer::<UnitDualQuaternion<f32>>("nalgebra UnitDualQuaternion");
    }

    fn peer<M: Product + Packed<Motion>>(&mut self, name: &str) {
        let hierarchy = self.hierarchy;
        self.add::<M>(
            name.to_owned(),
            None,
            move |locals, models| walk::local_to_model(&hierarchy, locals, models),
            move |poses| walk::local_to_model_in_place(&hierarchy, poses),
        );
    }

    fn own<P: Pose + Packed<Motion>>(&mut self, layout: &str) {
        let hierarchy = self.hierarchy;
        for backend in Backend::available() {
            self.add::<P>(
                format!("dq8 {layout} {backend}"),
                Some(backend),
                move |locals, models| {
                    let job = hierarchy.job().backend(backend);
                    job.local_to_model(locals, models).expect("whole instances");
                },
                move |poses| {
                    let job = hierarchy.job().backend(backend);
                    job.local_to_model_in_place(poses).expect("whole instances");
                },
            );
        }
    }

    fn rotations<P>(&mut self, layout: &str)
    where
        P: Pose<Real = f32, Rotation: Packed<[f32; 4]>> + Packed<Motion>,
    {
        let Self { scene, hierarchy, .. } = *self;
        for backend in Backend::available() {
            let memory = || {
                let input = (scene.rotations().pack::<P::Rotation>(), scene.roots().pack::<P>());
                (input, scene.locals.pack::<P>())
            };
            let pass = move |(rotations, roots): &(Vec<P::Rotation>, Vec<P>), models: &mut [P]| {
                let job = hierarchy.job().backend(backend).roots(roots);
                job.rotations_to_model(rotations, &scene.bones, models).expect("whole instances");
            };
            let name = format!("dq8 rotations, {layout} {backend}");
            let numbers = |models: &[P], index| scene.locals.numbers(models, index);
            self.contest.add(name, Some(backend), memory, pass, numbers);
        }
    }

    fn add<E: Packed<Motion>>(
        &mut self,
        name: String,
        backend: Option<Backend>,
        out: impl Fn(&[E], &mut [E]) + Copy + 'a,
        in_place: impl Fn(&mut [E]) + Copy + 'a,
    ) {
        let locals = &self.scene.locals;
        let numbers = |models: &[E], index| locals.numbers(models, index);
        match self.way {
            Way::Out | Way::Rotations => {
                let memory = || (locals.pack(), locals.pack());
                let pass = move |locals: &Vec<E>, models: &mut [E]| out(locals, models);
                self.contest.add(name, backend, memory, pass, numbers);
            }
            Way::In => {
                self.contest.add_in_place(name, backend, || locals.pack(), in_place, numbers);
            }
        }
    }
}

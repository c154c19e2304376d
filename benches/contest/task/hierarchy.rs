//! Down the joints of many skeletons, or of one.

use crate::backends;
use crate::contest::Contest;
use crate::limit::{Limit, Limited};
use crate::memory::{Own, Packed, Product, QuatVec3A};
use crate::scene::{Scene, Shape};
use crate::walk;
use dq8::{Backend, Block, DualQuat, Hierarchy, Skeleton};
use glam::{Affine3A, Mat4};
use nalgebra::{Isometry3, UnitDualQuaternion};
use simba::simd::WideF32x8;
use ultraviolet::{Isometry3x8, Mat4x8};

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Way {
    /// From locals into models.
    Out,
    /// Over the locals.
    In,
    /// From rotations and the bones that all instances share into models, and this crate's own way
    /// from motions to compare with.
    Rotations,
}

type Motion = DualQuat<f32>;

pub(crate) fn with_contest(shape: Shape, way: Way, run: &mut dyn FnMut(&Contest<'_>)) {
    let scene = Scene::new(shape);
    let hierarchy = Hierarchy::new(&scene.parents).expect("parents come first");
    let joints = hierarchy.joints();
    let (suffix, in_words) = match way {
        Way::Out => (" out", "out of place"),
        Way::In => ("", "in place"),
        Way::Rotations => (" rotations", "from rotations"),
    };
    // A rounding per joint, and each turns all that follows; the twelve levels of a skeleton lose a
    // few millionths.
    let of_a_chain = (1e-6 * joints as f64).max(3e-5);
    let (size, title, tolerance) = match shape {
        Shape::Crowd { instances: 1 } => {
            (format!("skeleton {joints}"), "one skeleton".to_owned(), 3e-5)
        }
        Shape::Crowd { instances } => {
            let title = format!("{instances} skeletons of {joints} joints");
            (format!("{joints}x{instances}{suffix}"), title, 3e-5)
        }
        Shape::Biped => ("biped".to_owned(), format!("one biped of {joints} joints"), 3e-5),
        Shape::Chain { .. } => {
            (format!("chain {joints}"), format!("one chain of {joints} joints"), of_a_chain)
        }
        Shape::Chains { count } => {
            (format!("chains {count}"), format!("{count} chains, {joints} joints"), of_a_chain)
        }
        Shape::Tree { children } => {
            (format!("tree {children}"), format!("{children} children a joint"), of_a_chain)
        }
    };
    let crowd = matches!(shape, Shape::Crowd { instances: 2.. });
    let job = if crowd { "J2" } else { "J3" };
    let mut contest = Contest {
        transforms: scene.locals.len(),
        tolerance,
        expected: scene.expected(&hierarchy),
        ..Contest::new(job, size, format!("{title}, {in_words}"))
    };
    let mut field = Field { scene: &scene, hierarchy, way, contest: &mut contest };
    if crowd {
        field.crowd();
    } else {
        field.one();
        field.plan();
    }
    if matches!(shape, Shape::Chain { .. }) {
        field.segments::<Block<f32, 8>>("8 lanes");
        field.segments::<Block<f32, 16>>("16 lanes");
    }
    if crowd {
        let bytes = size_of::<Motion>() * contest.transforms;
        let (size, moved) = (contest.size.clone(), 2.0 * size_of::<Motion>() as f64);
        let (limit, limited) = match way {
            Way::Out => (Limit::copy(size.clone(), bytes), Limited::Bytes(moved, size)),
            Way::In => (Limit::rewrite(size.clone(), bytes), Limited::BytesInPlace(moved, size)),
            Way::Rotations => return run(&contest),
        };
        contest.limits.push(limit);
        contest.limited = Some(limited);
    }
    run(&contest);
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

    fn own<P: Own>(&mut self, layout: &str) {
        if !self.scene.locals.instances().is_multiple_of(P::LANES) {
            return;
        }
        let hierarchy = self.hierarchy;
        for backend in backends() {
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

    fn rotations<P: Own>(&mut self, layout: &str) {
        let Self { scene, hierarchy, .. } = *self;
        for backend in backends() {
            let memory = || {
                let input = (scene.rotations().pack::<P::Rotation>(), scene.roots().pack::<P>());
                (input, scene.locals.pack::<P>())
            };
            let pass = move |(rotations, roots): &(Vec<P::Rotation>, Vec<P>), models: &mut [P]| {
                let job = hierarchy.job().backend(backend).roots(roots);
                let locals = dq8::hierarchy::Bones { rotations, offsets: &scene.bones };
                job.locals_to_model(locals, models).expect("whole instances");
            };
            let name = format!("dq8 rotations, {layout} {backend}");
            let numbers = |models: &[P], index| scene.locals.numbers(models, index);
            self.contest.add(name, Some(backend), memory, pass, numbers);
        }
    }

    /// In an order that is found once.
    fn plan(&mut self) {
        let Self { scene, hierarchy, .. } = *self;
        for backend in backends() {
            let memory = move || {
                let input = (Skeleton::from(hierarchy), scene.locals.pack::<Motion>());
                (input, scene.locals.pack::<Motion>())
            };
            let pass = move |(skeleton, locals): &(Skeleton, Vec<Motion>),
                             models: &mut [Motion]| {
                let job = skeleton.job().backend(backend);
                job.local_to_model(locals, models).expect("one instance");
            };
            let numbers = |models: &[Motion], index| scene.locals.numbers(models, index);
            self.contest.add(format!("dq8 plan {backend}"), Some(backend), memory, pass, numbers);
        }
    }

    /// A chain with a segment in each lane.
    fn segments<P: Own>(&mut self, lanes: &str) {
        let scene = self.scene;
        for backend in backends() {
            let memory = move || {
                let links = P::links(scene.locals.different());
                (links.clone(), links)
            };
            let pass = move |links: &Vec<P>, products: &mut [P]| {
                backend.chain_products(links, products).expect("as many products as links");
            };
            let numbers = |products: &[P], index: usize| {
                let (element, lane) = P::link(products.len(), index);
                products[element].numbers(lane)
            };
            let name = format!("dq8 segments in {lanes} {backend}");
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
        if self.way == Way::In {
            self.contest.add_in_place(name, backend, || locals.pack(), in_place, numbers);
        } else {
            let memory = || (locals.pack(), locals.pack());
            let pass = move |locals: &Vec<E>, models: &mut [E]| out(locals, models);
            self.contest.add(name, backend, memory, pass, numbers);
        }
    }
}

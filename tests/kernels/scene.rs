//! [`Scene`]: a skeleton with poses of many instances, and what the matrices say they come to.

use crate::subject::{Given, Root, Subject, Task};
use core::fmt;
use core::ops::Range;
use dq8::{Backend, DualQuat, Hierarchy, Quat};
use dq8_contract::bound::{unit_roundoff, within};
use dq8_contract::kinematics;
use dq8_contract::matrix::{IDENTITY, Matrix, Step, distance, inverse, product};
use dq8_contract::random::Random;
use proptest::prelude::*;

pub(crate) const ROOT: u32 = Hierarchy::ROOT;

/// The biped of the example mocap, end sites included: pelvis, trunk and head, arms, legs.
pub(crate) const BIPED: [u32; 21] =
    [ROOT, 0, 1, 2, 3, 2, 5, 6, 7, 2, 9, 10, 11, 0, 13, 14, 15, 0, 17, 18, 19];

/// Two trees of seven joints.
pub(crate) const SMALL: [u32; 7] = [ROOT, 0, 1, ROOT, 0, 3, 3];

/// The most instances that a run takes: two full blocks of the widest kind and one more.
pub(crate) const MAX_INSTANCES: usize = 2 * 16 + 1;

pub(crate) fn chain(joints: u32) -> Vec<u32> {
    (0..joints).map(|joint| joint.wrapping_sub(1)).collect()
}

/// One joint in `roots` is a root, the others hang from one of the last `reach` joints.
pub(crate) fn tree(random: &mut Random, joints: u32, roots: u32, reach: u32) -> Vec<u32> {
    let mut below = |end: u32| random.below(end as usize) as u32;
    let parent = |joint: u32| {
        let first = joint.saturating_sub(reach);
        let root = joint == 0 || below(roots) == 0;
        if root { ROOT } else { first + below(joint - first) }
    };
    (0..joints).map(parent).collect()
}

/// Axis, angle and shift, evenly.
pub(crate) fn step(random: &mut Random) -> Step {
    let shift = [(); 3].map(|()| random.between(-2.0, 2.0));
    Step { axis: random.direction(), angle: random.between(-3.2, 3.2), shift }
}

/// As many unit motions.
pub(crate) fn motions(random: &mut Random, count: usize) -> Vec<[f64; 8]> {
    (0..count).map(|_| step(random).motion()).collect()
}

/// model(j) = model(parent(j)) · local(j), one after the other.
pub(crate) fn walk(parents: &[u32], locals: &[[f64; 8]]) -> Vec<[f64; 8]> {
    let locals: Vec<_> = locals.iter().map(|local| DualQuat::from_array(*local)).collect();
    let mut models = locals.clone();
    kinematics::local_to_model(parents, &locals, &mut models);
    models.iter().map(|model| model.to_array()).collect()
}

/// As the layout's numbers hold them.
pub(crate) fn rounded<const C: usize>(single: bool, records: &[[f64; C]]) -> Vec<[f64; C]> {
    let round = |number: f64| if single { f64::from(number as f32) } else { number };
    records.iter().map(|record| record.map(round)).collect()
}

#[derive(Clone)]
pub(crate) struct Scene {
    pub(crate) parents: Vec<u32>,
    /// `[instance][joint]`, of [`MAX_INSTANCES`].
    steps: Vec<Vec<Step>>,
    /// One root transform for each instance; where all share one, it is the first.
    roots: Vec<Step>,
    instances: usize,
    pub(crate) range: Range<usize>,
}

/// Without the poses, thousands of numbers that say nothing: a failed comparison shows its own.
impl fmt::Debug for Scene {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { parents, instances, range, .. } = self;
        write!(f, "{instances} instances, joints {range:?} of {parents:?}")
    }
}

/// What joints without a parent stand on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum On {
    Nothing,
    Same,
    Each,
}

impl On {
    pub(crate) const ALL: [Self; 3] = [Self::Nothing, Self::Same, Self::Each];

    pub(crate) fn any() -> impl Strategy<Value = Self> {
        prop::sample::select(&Self::ALL[..])
    }
}

/// Up to 40 joints; about one in eight is a root, the others hang from any joint before them.
pub(crate) fn scene() -> impl Strategy<Value = Scene> {
    (any::<u64>(), 0..=40_u32, 0..=MAX_INSTANCES).prop_flat_map(|(seed, joints, instances)| {
        let ends = 0..=joints as usize;
        [ends.clone(), ends].prop_map(move |[a, b]| {
            let parents = tree(&mut Random(seed), joints, 8, u32::MAX);
            Scene { range: a.min(b)..a.max(b), ..Scene::new(&parents, instances, seed) }
        })
    })
}

impl Scene {
    /// Every pose of every instance another one; the range leaves out the first two joints and the
    /// last.
    pub(crate) fn new(parents: &[u32], instances: usize, seed: u64) -> Self {
        let mut random = Random(seed);
        let mut many = |count: usize| (0..count).map(|_| step(&mut random)).collect::<Vec<_>>();
        let joints = parents.len();
        Self {
            parents: parents.to_vec(),
            steps: (0..MAX_INSTANCES).map(|_| many(joints)).collect(),
            roots: many(MAX_INSTANCES),
            instances,
            range: 2.min(joints)..joints.saturating_sub(1).max(2.min(joints)),
        }
    }

    pub(crate) fn small(instances: usize) -> Self {
        Self::new(&SMALL, instances, 5)
    }

    pub(crate) fn joints(&self) -> usize {
        self.parents.len()
    }

    pub(crate) fn all(&self) -> Range<usize> {
        0..self.joints()
    }

    /// How many instances this layout is given, 0 to 2·lanes + 1. Of no joints there are none: the
    /// length of a slice cannot tell their number.
    pub(crate) fn instances(&self, subject: &dyn Subject) -> usize {
        // Plain motions are computed in lanes of as many instances as a register has, 16 at the
        // most.
        let lanes = if subject.things() == 1 { 16 } else { subject.things() };
        if self.joints() == 0 { 0 } else { self.instances % (2 * lanes + 2) }
    }

    /// Poses of `instances` instances.
    pub(crate) fn poses(&self, instances: usize) -> Vec<[f64; 8]> {
        self.steps.iter().take(instances).flatten().map(Step::motion).collect()
    }

    /// Other poses: those of the next instance.
    pub(crate) fn others(&self, instances: usize) -> Vec<[f64; 8]> {
        let used = self.steps.iter().cycle().skip(1).take(instances).flatten();
        used.map(Step::motion).collect()
    }

    /// The rotations of [`poses`](Self::poses).
    pub(crate) fn rotations(&self, instances: usize) -> Vec<[f64; 4]> {
        let used = self.steps.iter().take(instances).flatten();
        used.map(|step| Quat::from_axis_angle(step.axis, step.angle).to_array()).collect()
    }

    /// Rotations and translations of [`poses`](Self::poses).
    pub(crate) fn rotations_translations(&self, instances: usize) -> Vec<[f64; 7]> {
        let used = self.steps.iter().take(instances).flatten();
        let both = used.zip(self.rotations(instances)).map(|(step, [x, y, z, w])| {
            let [tx, ty, tz] = step.shift;
            [x, y, z, w, tx, ty, tz]
        });
        both.collect()
    }

    /// Offsets of the joints, the same for all instances: the shifts of the first.
    pub(crate) fn offsets(&self) -> Vec<[f64; 3]> {
        self.steps[0].iter().map(|step| step.shift).collect()
    }

    /// Poses of [`rotations`](Self::rotations) and [`offsets`](Self::offsets).
    pub(crate) fn turned(&self, instances: usize) -> Vec<[f64; 8]> {
        let used = self.steps.iter().take(instances);
        let steps = used.flat_map(|steps| steps.iter().zip(&self.steps[0]));
        steps.map(|(step, first)| Step { shift: first.shift, ..*step }.motion()).collect()
    }

    /// A motion for each joint: the roots, again and again.
    pub(crate) fn binds(&self) -> Vec<[f64; 8]> {
        self.roots.iter().cycle().skip(1).take(self.joints()).map(Step::motion).collect()
    }

    /// A root transform for each instance.
    pub(crate) fn roots(&self) -> Vec<[f64; 8]> {
        self.roots.iter().map(Step::motion).collect()
    }

    /// `roots` are [those](Self::roots) of this scene.
    pub(crate) fn task<'a>(&'a self, backend: Backend, on: On, roots: &'a [[f64; 8]]) -> Task<'a> {
        let root = match on {
            On::Nothing => Root::None,
            On::Same => Root::Same(roots[0]),
            On::Each => Root::Each(roots),
        };
        Task { root, ..Task::new(&self.parents, backend) }
    }

    /// All joints, and those of the range.
    pub(crate) fn ranges(&self) -> [Range<usize>; 2] {
        [self.all(), self.range.clone()]
    }

    /// What every instance comes to.
    pub(crate) fn every(&self, wanted: impl FnMut(usize) -> Vec<Wanted>) -> Vec<Vec<Wanted>> {
        (0..self.instances).map(wanted).collect()
    }

    /// Model poses by the rule model(j) = model(parent(j)) · local(j) within `range`, where the
    /// locals are `poses`; outside it they are `others` as they stand.
    pub(crate) fn models(&self, instance: usize, on: On, range: &Range<usize>) -> Vec<Wanted> {
        let others = &self.steps[(instance + 1) % MAX_INSTANCES];
        let mut models: Vec<Wanted> = Vec::new();
        for joint in self.all() {
            let local = Wanted::of(&self.steps[instance][joint]);
            let model = if !range.contains(&joint) {
                Wanted::of(&others[joint])
            } else if self.parents[joint] == ROOT {
                self.root(instance, on).then(&local)
            } else {
                models[self.parents[joint] as usize].then(&local)
            };
            models.push(model);
        }
        models
    }

    /// Local poses by the rule local(j) = model(parent(j))⁻¹ · model(j) within `range`, where
    /// the models are `poses`; outside it they are `others` as they stand.
    pub(crate) fn locals(&self, instance: usize, on: On, range: &Range<usize>) -> Vec<Wanted> {
        let others = &self.steps[(instance + 1) % MAX_INSTANCES];
        let model = |joint: usize| Wanted::of(&self.steps[instance][joint]);
        let local = |joint: usize| {
            let parent = match self.parents[joint] {
                ROOT => self.root(instance, on),
                parent => model(parent as usize),
            };
            parent.inverse().then(&model(joint))
        };
        let outside = |joint: usize| Wanted::of(&others[joint]);
        let wanted = |joint| if range.contains(&joint) { local(joint) } else { outside(joint) };
        self.all().map(wanted).collect()
    }

    /// The locals again, with the errors of models on the way.
    pub(crate) fn round_trip(&self, instance: usize, on: On) -> Vec<Wanted> {
        let models = self.models(instance, on, &self.all());
        let steps = self.steps[instance].iter();
        steps.zip(models).map(|(step, model)| Wanted { matrix: step.matrix(), ..model }).collect()
    }

    fn root(&self, instance: usize, on: On) -> Wanted {
        match on {
            On::Nothing => Wanted { matrix: IDENTITY, products: 0, reach: 1.0 },
            On::Same => Wanted::of(&self.roots[0]),
            On::Each => Wanted::of(&self.roots[instance]),
        }
    }
}

/// Locals of a scene in every form.
#[derive(Clone)]
pub(crate) struct Forms {
    pub(crate) poses: Vec<[f64; 8]>,
    rotations_translations: Vec<[f64; 7]>,
    rotations: Vec<[f64; 4]>,
    offsets: Vec<[f64; 3]>,
}

impl Forms {
    pub(crate) fn new(scene: &Scene, instances: usize) -> Self {
        Self {
            poses: scene.poses(instances),
            rotations_translations: scene.rotations_translations(instances),
            rotations: scene.rotations(instances),
            offsets: scene.offsets(),
        }
    }

    /// Makes a component of one local no number, in every form that has it.
    pub(crate) fn poison(&mut self, index: usize, component: usize, poison: f64) {
        self.poses[index][component] = poison;
        self.rotations_translations[index][component % 7] = poison;
        self.rotations[index][component % 4] = poison;
    }

    /// Of the first `instances` instances: poses, rotations and translations, rotations, in place.
    pub(crate) fn first(&self, instances: usize) -> [Given<'_>; 4] {
        let count = instances * self.offsets.len();
        [
            Given::Poses(&self.poses[..count]),
            Given::RotationsTranslations(&self.rotations_translations[..count]),
            Given::Rotations(&self.rotations[..count], &self.offsets),
            Given::InPlace,
        ]
    }
}

/// A matrix, and what the rounding of a chain of products that ends there depends on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wanted {
    matrix: Matrix,
    products: u32,
    /// 1, and the lengths along the chain.
    reach: f64,
}

impl Wanted {
    pub(crate) fn of(step: &Step) -> Self {
        let length = step.shift.iter().map(|s| s * s).sum::<f64>().sqrt();
        Self { matrix: step.matrix(), products: 1, reach: 1.0 + length }
    }

    fn then(&self, next: &Self) -> Self {
        Self {
            matrix: product(&self.matrix, &next.matrix),
            products: self.products + next.products,
            reach: self.reach + next.reach,
        }
    }

    fn inverse(&self) -> Self {
        Self { matrix: inverse(&self.matrix), ..*self }
    }

    /// Each product turns what follows by a few units of the last place; the errors are
    /// independent, so they add up like the root of their number.
    pub(crate) fn assert_is(&self, single: bool, motion: &[f64; 8], place: impl Fn() -> String) {
        let why = "each product turns what follows by a few u; errors are independent";
        let units = within(8.0, why).units;
        let scale = f64::from(self.products).sqrt() * self.reach;
        let allowed = units * unit_roundoff(single) * scale;
        let error = distance(motion, &self.matrix);
        assert!(
            error <= allowed,
            "{}: {motion:?} is off by {error:e} where {allowed:e} is allowed, from {:?}",
            place(),
            self.matrix
        );
    }
}

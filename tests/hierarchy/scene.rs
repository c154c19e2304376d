//! A random skeleton with poses for many instances, and what the matrices say they come to.

use crate::layout::Layout;
use crate::matrix::{IDENTITY, Matrix, Step, inverse, product};
use core::fmt;
use core::ops::Range;
use dq8::{DualQuat, Hierarchy, Job, Real};
use dq8_contract::bound::{unit_roundoff, within};
use proptest::prelude::*;

/// The most instances that a run takes: two full blocks of the widest kind and one more.
const MOST: usize = 2 * 16 + 1;

#[derive(Clone)]
pub(crate) struct Scene {
    pub(crate) parents: Vec<u32>,
    /// `[instance][joint]`
    steps: Vec<Vec<Step>>,
    /// One root transform an instance; where all share one, it is the first.
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
#[derive(Clone, Copy, Debug)]
pub(crate) enum Root {
    None,
    Same,
    Each,
}

impl Root {
    pub(crate) fn any() -> impl Strategy<Value = Self> {
        prop::sample::select(&[Self::None, Self::Same, Self::Each][..])
    }
}

fn step() -> impl Strategy<Value = Step> {
    let axis = (-1.0..=1.0, 0.0..core::f64::consts::TAU);
    (axis, -3.2..3.2, prop::array::uniform3(-2.0..2.0)).prop_map(|((z, around), angle, shift)| {
        let radius = f64::sqrt(1.0 - z * z);
        Step { axis: [radius * f64::cos(around), radius * f64::sin(around), z], angle, shift }
    })
}

/// Up to 40 joints; about one in eight is a root, the others hang from any joint before them.
pub(crate) fn scene() -> impl Strategy<Value = Scene> {
    let parent = (0..8_u32, any::<prop::sample::Index>());
    (prop::collection::vec(parent, 0..=40), 0..=MOST).prop_flat_map(|(picks, instances)| {
        let joints = picks.len();
        let parent = |(joint, (kind, pick)): (usize, (u32, prop::sample::Index))| {
            let root = joint == 0 || kind == 0;
            if root { Hierarchy::ROOT } else { u32::try_from(pick.index(joint)).unwrap() }
        };
        let parents: Vec<u32> = picks.into_iter().enumerate().map(parent).collect();
        let steps = prop::collection::vec(prop::collection::vec(step(), joints), MOST);
        let roots = prop::collection::vec(step(), MOST);
        (Just(parents), steps, roots, Just(instances), [0..=joints, 0..=joints]).prop_map(
            |(parents, steps, roots, instances, [a, b])| Scene {
                parents,
                steps,
                roots,
                instances,
                range: a.min(b)..a.max(b),
            },
        )
    })
}

impl Scene {
    /// Two trees of seven joints, every pose of every instance another one.
    pub(crate) fn small(instances: usize) -> Self {
        let step = |number: usize| {
            let [a, b, c] = [0.7, 1.1, 1.3].map(|factor| f64::sin(factor * (number + 1) as f64));
            let length = f64::sqrt(a * a + b * b + c * c);
            Step { axis: [a, b, c].map(|v| v / length), angle: 3.0 * c, shift: [b, c, a] }
        };
        let root = Hierarchy::ROOT;
        Self {
            parents: vec![root, 0, 1, root, 0, 3, 3],
            steps: (0..MOST).map(|i| (0..7).map(|j| step(8 * i + j)).collect()).collect(),
            roots: (0..MOST).map(|i| step(8 * i + 7)).collect(),
            instances,
            range: 2..6,
        }
    }

    pub(crate) fn joints(&self) -> usize {
        self.parents.len()
    }

    pub(crate) fn all(&self) -> Range<usize> {
        0..self.joints()
    }

    /// How many instances this layout is given, 0 to 2·lanes + 1. Of no joints there are none: the
    /// length of a slice cannot tell their number.
    pub(crate) fn instances<P: Layout>(&self) -> usize {
        if self.joints() == 0 { 0 } else { self.instances % (2 * P::INSTANCES + 2) }
    }

    /// Poses of all instances as the layout keeps them.
    pub(crate) fn poses<P: Layout>(&self) -> Vec<P> {
        let used = self.steps.iter().take(self.instances::<P>()).flatten();
        P::lay(self.joints(), &used.map(Step::motion).collect::<Vec<_>>())
    }

    /// Other poses: those of the next instance.
    pub(crate) fn others<P: Layout>(&self) -> Vec<P> {
        let used = self.steps.iter().cycle().skip(1).take(self.instances::<P>()).flatten();
        P::lay(self.joints(), &used.map(Step::motion).collect::<Vec<_>>())
    }

    /// A root transform for each instance.
    pub(crate) fn roots<P: Layout>(&self) -> Vec<P> {
        let used = self.roots.iter().take(self.instances::<P>());
        P::lay(1, &used.map(Step::motion).collect::<Vec<_>>())
    }

    /// The transform of [`Root::Same`] as this layout's numbers hold it.
    pub(crate) fn shared_root<P: Layout>(&self) -> [f64; 8] {
        self.roots[0].motion::<P::Real>().to_array().map(Into::into)
    }

    pub(crate) fn job<'a, P: Layout>(&'a self, root: Root, roots: &'a [P]) -> Job<'a, P> {
        let job = Hierarchy::new(&self.parents).unwrap().job();
        match root {
            Root::None => job,
            Root::Same => job.root(self.roots[0].motion()),
            Root::Each => job.roots(roots),
        }
    }

    /// The elements of `inside` at the joints of `range`, those of `outside` at the others.
    pub(crate) fn splice<P: Copy>(
        &self,
        range: &Range<usize>,
        inside: &[P],
        outside: &[P],
    ) -> Vec<P> {
        let pairs = inside.iter().zip(outside).enumerate();
        let choose = |(index, (inside, outside)): (usize, (&P, &P))| {
            if range.contains(&(index % self.joints())) { *inside } else { *outside }
        };
        pairs.map(choose).collect()
    }

    /// Model poses by the rule model(j) = model(parent(j)) · local(j) within `range`, where the
    /// locals are `poses`; outside it they are `others` as they stand.
    pub(crate) fn models(&self, instance: usize, root: Root, range: &Range<usize>) -> Vec<Wanted> {
        let others = &self.steps[(instance + 1) % MOST];
        let mut models: Vec<Wanted> = Vec::new();
        for joint in self.all() {
            let local = Wanted::of(&self.steps[instance][joint]);
            let model = if !range.contains(&joint) {
                Wanted::of(&others[joint])
            } else if self.parents[joint] == Hierarchy::ROOT {
                self.root(instance, root).then(&local)
            } else {
                models[self.parents[joint] as usize].then(&local)
            };
            models.push(model);
        }
        models
    }

    /// Local poses by the rule local(j) = model(parent(j))⁻¹ · model(j), where the models are
    /// `poses`.
    pub(crate) fn locals(&self, instance: usize, root: Root) -> Vec<Wanted> {
        let model = |joint: usize| Wanted::of(&self.steps[instance][joint]);
        let local = |joint: usize| {
            let parent = match self.parents[joint] {
                Hierarchy::ROOT => self.root(instance, root),
                parent => model(parent as usize),
            };
            parent.inverse().then(&model(joint))
        };
        self.all().map(local).collect()
    }

    /// The locals again, with the errors of models on the way.
    pub(crate) fn round_trip(&self, instance: usize, root: Root) -> Vec<Wanted> {
        let models = self.models(instance, root, &self.all());
        let steps = self.steps[instance].iter();
        steps.zip(models).map(|(step, model)| Wanted { matrix: step.matrix(), ..model }).collect()
    }

    fn root(&self, instance: usize, root: Root) -> Wanted {
        match root {
            Root::None => Wanted { matrix: IDENTITY, products: 0, reach: 1.0 },
            Root::Same => Wanted::of(&self.roots[0]),
            Root::Each => Wanted::of(&self.roots[instance]),
        }
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

    /// Each product turns what follows by a few units of the last place; the errors are independent,
    /// so they add up like the root of their number.
    pub(crate) fn assert_is<R: Real>(&self, motion: DualQuat<R>, place: impl Fn() -> String) {
        let why = "each product turns what follows by a few u; errors are independent";
        let units = within(8.0, why).units;
        let scale = f64::from(self.products).sqrt() * self.reach;
        let allowed = units * unit_roundoff(size_of::<R>() == 4) * scale;
        let error = crate::matrix::distance(motion, &self.matrix);
        assert!(
            error <= allowed,
            "{}: {motion:?} is off by {error:e} where {allowed:e} is allowed, from {:?}",
            place(),
            self.matrix
        );
    }
}

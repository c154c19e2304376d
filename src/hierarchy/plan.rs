use super::Hierarchy;
use super::job::same_length;
use super::octet::product;
use super::packing::whole_instances;
use super::schedule::{Group, Schedule};
use crate::batch;
use crate::dispatch::{Backend, Kernel};
use crate::error::ShapeError;
use crate::real::Real;
use crate::scalar::DualQuat;
use dq8_simd::{Float, Gather, Indices, Lane, Level};

/// How to compute one instance of a hierarchy, found once.
///
/// [`Hierarchy`] takes its lanes from many instances. Where there is one, lanes can only be joints
/// that do not wait for each other, and which these are depends on the parents alone. A plan is the
/// answer: an order, and which joints share the lanes of a register.
///
/// ```
/// use dq8::{DualQuat, Hierarchy, HierarchyPlan};
/// let parents = [Hierarchy::ROOT, 0, 1, 0];
/// let plan = HierarchyPlan::new(&Hierarchy::new(&parents)?);
/// let locals = [DualQuat::from_translation([0.0_f32, 2.0, 0.0]); 4];
/// let mut models = locals;
/// plan.local_to_model(&locals, &mut models)?;
/// assert_eq!(models[2].translation(), [0.0, 6.0, 0.0]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct HierarchyPlan {
    joints: usize,
    strategy: Strategy,
    schedule: Schedule,
    backend: Backend,
}

/// How a [`HierarchyPlan`] uses lanes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Strategy {
    /// Joints one by one, each in a register of its own: eight lanes are eight components.
    Single,
    /// Joints of the same height share registers where there are enough of them, the others go one by
    /// one.
    Levels,
    /// The whole hierarchy is one chain: [`Backend::chain_products`].
    Chain,
}

/// From this many joints on, a chain is scanned. Measured, see [`HierarchyPlan::new`].
const LEAST_CHAIN: usize = 32;

impl HierarchyPlan {
    #[must_use]
    pub fn new(hierarchy: &Hierarchy<'_>) -> Self {
        let chain = hierarchy.joints() >= LEAST_CHAIN && is_chain(hierarchy);
        Self::build(hierarchy, if chain { Strategy::Chain } else { Strategy::Levels })
    }

    #[must_use]
    pub fn with_strategy(hierarchy: &Hierarchy<'_>, strategy: Strategy) -> Option<Self> {
        let possible = strategy != Strategy::Chain || is_chain(hierarchy);
        possible.then(|| Self::build(hierarchy, strategy))
    }

    fn build(hierarchy: &Hierarchy<'_>, strategy: Strategy) -> Self {
        let schedule = match strategy {
            Strategy::Single => Schedule::new(hierarchy, usize::MAX),
            Strategy::Levels => Schedule::new(hierarchy, super::schedule::LEAST_GROUP),
            Strategy::Chain => Schedule::default(),
        };
        Self { joints: hierarchy.joints(), strategy, schedule, backend: Backend::MOST }
    }

    /// How many joints there are.
    #[must_use]
    pub fn joints(&self) -> usize {
        self.joints
    }

    /// How lanes are used.
    #[must_use]
    pub fn strategy(&self) -> Strategy {
        self.strategy
    }

    /// Runs with this backend, or the best below it that the CPU has; the best there is, unless told.
    #[must_use]
    pub fn backend(mut self, backend: Backend) -> Self {
        self.backend = backend;
        self
    }

    #[inline]
    pub fn local_to_model<R: Real + Float>(
        &self,
        locals: &[DualQuat<R>],
        models: &mut [DualQuat<R>],
    ) -> Result<(), ShapeError> {
        whole_instances("locals", self.joints, locals.len())?;
        same_length("models", models.len(), locals.len())?;
        self.run(Some(locals), models);
        Ok(())
    }

    #[inline]
    pub fn local_to_model_in_place<R: Real + Float>(
        &self,
        poses: &mut [DualQuat<R>],
    ) -> Result<(), ShapeError> {
        whole_instances("poses", self.joints, poses.len())?;
        self.run(None, poses);
        Ok(())
    }

    #[inline]
    fn run<R: Real + Float>(&self, locals: Option<&[DualQuat<R>]>, models: &mut [DualQuat<R>]) {
        if self.strategy != Strategy::Chain {
            return self.backend.run(Walk { plan: self, locals, models });
        }
        for (instance, models) in models.chunks_exact_mut(self.joints.max(1)).enumerate() {
            match locals.and_then(|all| all.chunks_exact(self.joints.max(1)).nth(instance)) {
                // The lengths are those of an instance.
                Some(locals) => drop(self.backend.chain_products(locals, models)),
                None => self.backend.chain_products_in_place(models),
            }
        }
    }
}

fn is_chain(hierarchy: &Hierarchy<'_>) -> bool {
    // The first parent is the root mark, which is what comes before 0.
    (0..).zip(hierarchy.parents()).all(|(joint, &parent)| parent == u32::wrapping_sub(joint, 1))
}

struct Walk<'p, 's, R> {
    plan: &'p HierarchyPlan,
    locals: Option<&'s [DualQuat<R>]>,
    models: &'s mut [DualQuat<R>],
}

impl<R: Real + Float> Kernel for Walk<'_, '_, R> {
    type Output = ();

    #[inline(always)]
    fn run<V: Level>(self, level: V) {
        let Self { plan, locals, models } = self;
        let joints = plan.joints.max(1);
        let models: &mut [[R; 8]] = bytemuck::must_cast_slice_mut(models);
        let locals: Option<&[[R; 8]]> = match locals {
            Some(locals) => Some(bytemuck::must_cast_slice(locals)),
            None => None,
        };
        for (instance, models) in models.chunks_exact_mut(joints).enumerate() {
            let locals = match locals {
                Some(all) => Some(all.get(instance * joints..).unwrap_or_default()),
                None => None,
            };
            for run in plan.schedule.runs() {
                for &[joint, parent] in run.singles {
                    single(level, joint, parent, locals, models);
                }
                for group in run.groups {
                    for first in (0..Indices::COUNT).step_by(R::Gathered::<V>::LANES) {
                        together(level, group, first, locals, models);
                    }
                }
            }
        }
    }
}

/// One joint in the lanes of a register.
#[inline(always)]
fn single<R: Real + Float, V: Level>(
    level: V,
    joint: u32,
    parent: u32,
    locals: Option<&[[R; 8]]>,
    models: &mut [[R; 8]],
) {
    let Some(local) = locals.unwrap_or(models).get(joint as usize) else { return };
    // ROOT is beyond the last joint.
    let model = match models.get(parent as usize) {
        Some(parent) => product(R::Octet::load(level, parent), local),
        None => R::Octet::load(level, local),
    };
    if let Some(slot) = models.get_mut(joint as usize) {
        model.store(slot);
    }
}

/// As many joints of a group as there are lanes.
#[inline(always)]
fn together<R: Real + Float, V: Level>(
    level: V,
    group: &Group,
    first: usize,
    locals: Option<&[[R; 8]]>,
    models: &mut [[R; 8]],
) {
    let locals = locals.unwrap_or(models);
    let Some(local) = R::Gathered::gather(level, locals, &group.joints, first) else { return };
    let Some(parent) = R::Gathered::gather(level, models, &group.parents, first) else { return };
    let model = batch::DualQuat::from_array(parent) * batch::DualQuat::from_array(local);
    R::Gathered::scatter(model.to_array(), models, &group.joints, first);
}

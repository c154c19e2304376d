use super::Hierarchy;
use super::product::packed_product;
use super::schedule::Schedule;
use crate::dispatch::{Backend, Kernel};
use crate::real::Scalar;
use crate::scalar::DualQuat;
use crate::shape::{ShapeError, same_length, whole_instances};
use crate::storage::Source;
use dq8_simd::{Lanes, Level};

/// From this many joints on, a chain is cut into segments: `cargo bench --bench hierarchy --
/// one-instance/chain` shows both strategies around it. (Nanoseconds per joint, AVX-512, of 16, 24 and 32
/// joints: ordered 4.9, 5.6, 6.0; in segments 6.7, 5.3, 4.7. Without AVX2 segments never win.)
const MIN_CHAIN: usize = 24;

/// How to compute one instance of a hierarchy, found once.
///
/// [`Hierarchy`] fills its lanes with many instances. In a single instance joints wait for their parents, so the order
/// decides how much of the time something can be computed, and the best order depends on the parents alone. A plan
/// finds it once, and serves any number of poses. It computes
///
/// model(j) = model(parent(j)) · local(j)
///
/// as [`Hierarchy::local_to_model`] does, of plain slices in the joints' own order. Products and
/// their order are the same for a tree, so results differ by rounding only; of a long chain see
/// [`Backend::chain_products`].
///
/// Several instances are computed one after the other: for crowds, [`Block`] is faster. Motions that begin at a multiple of 32 bytes (`f32`) do not cross cache lines and take
/// about 5 % less time than others.
///
/// [`Block`]: crate::storage::Block
///
/// ```
/// use dq8::{DualQuat, Hierarchy, hierarchy::HierarchyPlan};
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
    /// `None` for a chain in segments.
    schedule: Option<Schedule>,
    backend: Option<Backend>,
}

/// How a [`HierarchyPlan`] uses lanes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Strategy {
    /// Joints one by one, the eight components of a motion in the lanes of one register, in an order
    /// in which few wait for their parents.
    Ordered,
    /// The hierarchy is one chain, and lanes are its segments: [`Backend::chain_products`].
    Chain,
}

impl HierarchyPlan {
    /// The plan with the strategy that measured best: [`Strategy::Chain`] for chains of 24 joints or
    /// more where there are instructions for it, [`Strategy::Ordered`] otherwise.
    ///
    /// # Panics
    /// If the memory cannot be allocated, as for any `Vec`.
    #[must_use]
    pub fn new(hierarchy: &Hierarchy<'_>) -> Self {
        let long = hierarchy.joints() >= MIN_CHAIN && Backend::best() != Backend::PORTABLE;
        let chain = if long { Self::with_strategy(hierarchy, Strategy::Chain) } else { None };
        chain.unwrap_or_else(|| Self {
            joints: hierarchy.joints(),
            schedule: Some(Schedule::new(hierarchy)),
            backend: None,
        })
    }

    /// The plan with this strategy: to measure it. `None` if the strategy needs a chain and the
    /// hierarchy is not one.
    #[must_use]
    pub fn with_strategy(hierarchy: &Hierarchy<'_>, strategy: Strategy) -> Option<Self> {
        let schedule = match strategy {
            Strategy::Ordered => Some(Schedule::new(hierarchy)),
            Strategy::Chain if is_chain(hierarchy) => None,
            Strategy::Chain => return None,
        };
        Some(Self { joints: hierarchy.joints(), schedule, backend: None })
    }

    /// How many joints there are.
    #[must_use]
    pub const fn joints(&self) -> usize {
        self.joints
    }

    /// How lanes are used.
    #[must_use]
    pub const fn strategy(&self) -> Strategy {
        match self.schedule {
            Some(_) => Strategy::Ordered,
            None => Strategy::Chain,
        }
    }

    /// Runs with these instructions; by default with the best that the CPU has.
    #[must_use]
    pub fn backend(mut self, backend: Backend) -> Self {
        self.backend = Some(backend);
        self
    }

    /// Model poses of all joints from local ones, both in the joints' own order; one instance, or
    /// several whole ones one after the other.
    ///
    /// # Errors
    /// If the slices differ in length or hold no whole number of instances; `models` is untouched.
    #[inline]
    pub fn local_to_model<R: Scalar>(
        &self,
        locals: &[DualQuat<R>],
        models: &mut [DualQuat<R>],
    ) -> Result<(), ShapeError> {
        whole_instances("locals", self.joints, locals.len())?;
        same_length("models", models.len(), locals.len())?;
        self.run(self.backend.unwrap_or_default(), Source::Slice(locals), models);
        Ok(())
    }

    /// [`local_to_model`](Self::local_to_model) over the locals themselves.
    ///
    /// # Errors
    /// If the slice holds no whole number of instances; it is untouched then.
    #[inline]
    pub fn local_to_model_in_place<R: Scalar>(
        &self,
        poses: &mut [DualQuat<R>],
    ) -> Result<(), ShapeError> {
        whole_instances("poses", self.joints, poses.len())?;
        self.run(self.backend.unwrap_or_default(), Source::Output, poses);
        Ok(())
    }

    /// Lengths have been checked.
    #[inline]
    pub(super) fn run<R: Scalar>(
        &self,
        backend: Backend,
        locals: Source<'_, DualQuat<R>>,
        models: &mut [DualQuat<R>],
    ) {
        if let Some(schedule) = &self.schedule {
            return backend.run(Walk { schedule, locals, models });
        }
        // A chain of no joints has no instances either.
        let joints = self.joints.max(1);
        for (instance, models) in models.chunks_exact_mut(joints).enumerate() {
            let locals = match locals {
                Source::Slice(all) => {
                    let locals = all.get(instance * joints..).and_then(|rest| rest.get(..joints));
                    Source::Slice(locals.unwrap_or_default())
                }
                Source::Output => Source::Output,
            };
            backend.scan(locals, models);
        }
    }
}

/// Whether every joint hangs from the one before it. The mark of the root is what comes before 0.
fn is_chain(hierarchy: &Hierarchy<'_>) -> bool {
    (0_u32..).zip(hierarchy.parents()).all(|(joint, &parent)| parent == joint.wrapping_sub(1))
}

struct Walk<'p, 's, R> {
    schedule: &'p Schedule,
    locals: Source<'s, DualQuat<R>>,
    models: &'s mut [DualQuat<R>],
}

impl<R: Scalar> Kernel for Walk<'_, '_, R> {
    type Output = ();

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) {
        let Self { schedule, locals, models } = self;
        let joints = schedule.steps.bound();
        let mut models: &mut [[R; 8]] = bytemuck::must_cast_slice_mut(models);
        let mut locals: &[[R; 8]] = match locals {
            Source::Slice(locals) => bytemuck::must_cast_slice(locals),
            Source::Output => &[],
        };
        // An instance of no joints would come again for ever.
        while joints > 0
            && let Some((instance, others)) = models.split_at_mut_checked(joints)
        {
            match locals.split_at_checked(joints) {
                Some((of_instance, rest)) => {
                    for &root in &schedule.roots {
                        if let (Some(local), Some(model)) =
                            (of_instance.get(root), instance.get_mut(root))
                        {
                            *model = *local;
                        }
                    }
                    schedule.steps.run(
                        of_instance,
                        instance,
                        #[cfg_attr(not(opt_level_0), inline(always))]
                        |parent, local| step(level, parent, local),
                    );
                    locals = rest;
                }
                // A root stays as it is.
                None => {
                    schedule.steps.run_in_place(
                        instance,
                        #[cfg_attr(not(opt_level_0), inline(always))]
                        |parent, local| step(level, parent, local),
                    );
                }
            }
            models = others;
        }
    }
}

#[cfg_attr(not(opt_level_0), inline(always))]
fn step<R: Scalar, V: Level>(level: V, parent: &[R; 8], local: &[R; 8]) -> [R; 8] {
    let mut model = [R::ZERO; 8];
    packed_product(R::Packed::<V>::load(level, parent), local).store(&mut model);
    model
}

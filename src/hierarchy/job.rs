use super::forward::forward;
use super::locals::{InPlace, Locals, Poses};
use super::palette::{Epilogue, NoEpilogue};
use super::plan::{NoPlan, Plan, Plans};
use super::planned;
use super::root::{NoRoot, Roots};
use super::run::{Root, Run};
use super::{Hierarchy, Renormalize};
use crate::backend::Choice;
use crate::brief::brief;
use crate::palette_entry::MatrixOrder;
use crate::scalar::DualQuat;
use crate::storage::Element;
use crate::storage::shape::{ShapeError, joints_within, same_length, whole_instances};
use core::ops::{Bound, Range, RangeBounds};

/// A run over a hierarchy: with a root transform, or on some of the joints.
///
/// ```
/// use dq8::{DualQuat, Hierarchy};
/// let parents = [Hierarchy::ROOT, 0, 1];
/// let arm = Hierarchy::new(&parents)?;
/// let locals = [DualQuat::from_translation([1.0_f32, 0.0, 0.0]); 3];
/// let mut models = locals;
/// let table = DualQuat::from_translation([0.0, 0.0, 10.0]);
/// arm.job().root(table).local_to_model(&locals, &mut models)?;
/// assert_eq!(models[2].translation(), [3.0, 0.0, 10.0]);
/// // The wrist has moved: joint 2 anew, its parents stay as they are.
/// let moved = [locals[0], locals[1], DualQuat::from_translation([0.0, 5.0, 0.0])];
/// arm.job().joints(2..3).local_to_model(&moved, &mut models)?;
/// assert_eq!(models[2].translation(), [2.0, 5.0, 10.0]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone)]
#[must_use]
pub struct Job<'a, S = NoRoot, P = NoPlan> {
    parents: &'a [u32],
    joints: Range<usize>,
    root: S,
    renormalize: Renormalize,
    pub(super) choice: Choice,
    pub(super) order: MatrixOrder,
    plan: P,
}

brief!([S, P] Job<'_, S, P>: Job |it| {
    joints: it.joints, of: it.parents.len(), renormalize: it.renormalize, choice: it.choice,
});

impl<'a> Hierarchy<'a> {
    /// Model poses of all joints from local ones: model(j) = model(parent(j)) · local(j).
    ///
    /// `locals` and `models` hold one element per joint, or several whole instances one after the
    /// other. A [`Job`] does the same with a root transform, on some of the joints, in place, on
    /// threads.
    ///
    /// # Errors
    /// If the slices differ in length or hold no whole number of instances; `models` is untouched.
    #[inline]
    #[doc(alias("forward_kinematics", "fk", "LocalToModelJob"))]
    pub fn local_to_model<E: Element<8>>(
        &self,
        locals: &[E],
        models: &mut [E],
    ) -> Result<(), ShapeError> {
        self.job().local_to_model(locals, models)
    }

    /// A run with options, each of which has a default. The element type belongs to what is called
    /// at the end, so one job serves `f32` and `f64`, plain slices and blocks.
    #[inline]
    pub fn job(&self) -> Job<'a> {
        Job {
            parents: self.parents(),
            joints: 0..self.joints(),
            root: NoRoot,
            renormalize: Renormalize::Never,
            choice: Choice::default(),
            order: MatrixOrder::Rows,
            plan: NoPlan,
        }
    }
}

impl<'a, P> Job<'a, NoRoot, P> {
    /// Puts every root joint on `root`: model(j) = root · local(j), the same for all instances. A
    /// job has either this or [`roots`](Self::roots), so that neither is dropped without a word:
    ///
    /// ```compile_fail,E0599
    /// # use dq8::{DualQuat, Hierarchy};
    /// # let (one, roots) = (DualQuat::<f32>::IDENTITY, [DualQuat::<f32>::IDENTITY]);
    /// let leg = Hierarchy::new(&[Hierarchy::ROOT, 0])?;
    /// leg.job().root(one).roots(&roots);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    pub fn root<R>(self, root: DualQuat<R>) -> Job<'a, DualQuat<R>, P> {
        self.with(root)
    }

    /// Puts the root joints of each instance (block) on its own element of `roots`.
    pub fn roots<E>(self, roots: &'a [E]) -> Job<'a, &'a [E], P> {
        self.with(roots)
    }

    /// Puts root joints on what is chosen when the program runs.
    ///
    /// ```
    /// use dq8::{DualQuat, Hierarchy, hierarchy::Root};
    /// let leg = Hierarchy::new(&[Hierarchy::ROOT, 0])?;
    /// let mut models = [DualQuat::from_translation([0.0_f32, -1.0, 0.0]); 2];
    /// let stands_on: Option<DualQuat<f32>> = None;
    /// let root = stands_on.map_or(Root::None, Root::Same);
    /// leg.job().on(root).local_to_model_in_place(&mut models)?;
    /// assert_eq!(models[1].translation(), [0.0, -2.0, 0.0]);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    pub fn on<E: Element<8>>(self, root: Root<'a, E>) -> Job<'a, Root<'a, E>, P> {
        self.with(root)
    }
}

impl<'a, S, P> Job<'a, S, P> {
    fn with<T>(self, root: T) -> Job<'a, T, P> {
        Job {
            parents: self.parents,
            joints: self.joints,
            root,
            renormalize: self.renormalize,
            choice: self.choice,
            order: self.order,
            plan: self.plan,
        }
    }

    /// Only these joints are computed. Their parents outside the range must already hold their
    /// model poses; the other joints are not written.
    pub fn joints(mut self, joints: impl RangeBounds<usize>) -> Self {
        let start = match joints.start_bound() {
            Bound::Included(&start) => start,
            Bound::Excluded(&before) => before.saturating_add(1),
            Bound::Unbounded => 0,
        };
        let end = match joints.end_bound() {
            Bound::Included(&last) => last.saturating_add(1),
            Bound::Excluded(&end) => end,
            Bound::Unbounded => self.parents.len(),
        };
        self.joints = start..end;
        self
    }

    /// Sets the order of the numbers in a palette's matrices; rows by default, which is what
    /// [skins](crate::skinning::Linear) read.
    pub fn matrix_order(mut self, order: MatrixOrder) -> Self {
        self.order = order;
        self
    }

    /// Sets when models are normalized on the way down; never by default.
    pub fn renormalize(mut self, policy: Renormalize) -> Self {
        self.renormalize = policy;
        self
    }

    crate::backend::options! {
        ///
        /// ```
        /// use dq8::{Crowd, DualQuat, Hierarchy};
        /// let parents = [Hierarchy::ROOT, 0];
        /// let leg = Hierarchy::new(&parents)?;
        /// let down = DualQuat::from_translation([0.0_f32, -1.0, 0.0]);
        /// let mut legs = Crowd::<f32, 8>::from_slice(2, &[down; 1000])?;
        /// leg.job().threads(usize::MAX).local_to_model_in_place(legs.blocks_mut())?;
        /// assert_eq!(legs.get(499, 1).unwrap().translation(), [0.0, -2.0, 0.0]);
        /// # Ok::<(), Box<dyn core::error::Error>>(())
        /// ```
    }

    /// Computes one instance in the order of this plan. A [`Skeleton`](super::Skeleton)'s job has
    /// its own.
    #[inline]
    pub fn plan(self, plan: &Plan<'a>) -> Job<'a, S, Plan<'a>> {
        Job {
            parents: self.parents,
            joints: self.joints,
            root: self.root,
            renormalize: self.renormalize,
            choice: self.choice,
            order: self.order,
            plan: *plan,
        }
    }
}

impl<S, P: Plans> Job<'_, S, P> {
    /// See [`Hierarchy::local_to_model`].
    ///
    /// # Errors
    /// If lengths or the range do not fit; `models` is untouched.
    #[inline]
    #[doc(alias("forward_kinematics", "fk", "LocalToModelJob"))]
    pub fn local_to_model<E: Element<8>>(
        &self,
        locals: &[E],
        models: &mut [E],
    ) -> Result<(), ShapeError>
    where
        S: Roots<E>,
    {
        self.locals_to_model(Poses(locals), models)
    }

    /// [`local_to_model`](Self::local_to_model) over the locals themselves: half the memory. A
    /// [`Crowd`](super::Crowd) gives its poses by [`blocks_mut`](super::Crowd::blocks_mut).
    ///
    /// # Errors
    /// If lengths or the range do not fit; `poses` is untouched.
    #[inline]
    pub fn local_to_model_in_place<E: Element<8>>(&self, poses: &mut [E]) -> Result<(), ShapeError>
    where
        S: Roots<E>,
    {
        self.locals_to_model(InPlace, poses)
    }

    /// [`local_to_model`](Self::local_to_model) of locals in any form.
    ///
    /// # Errors
    /// If lengths or the range do not fit; `models` is untouched.
    ///
    /// ```
    /// use dq8::{DualQuat, Hierarchy, Quat, hierarchy::Bones};
    /// let parents = [Hierarchy::ROOT, 0];
    /// let arm = Hierarchy::new(&parents)?;
    /// let half_turn = Quat::from_xyzw(0.0_f32, 0.0, 1.0, 0.0);
    /// let locals = Bones { rotations: &[half_turn; 2], offsets: &[[0.0; 3], [2.0, 0.0, 0.0]] };
    /// let mut models = [DualQuat::IDENTITY; 2];
    /// arm.job().locals_to_model(locals, &mut models)?;
    /// assert_eq!(models[1].translation(), [-2.0, 0.0, 0.0]);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[inline]
    pub fn locals_to_model<E: Element<8>, L: Locals<E>>(
        &self,
        locals: L,
        models: &mut [E],
    ) -> Result<(), ShapeError>
    where
        S: Roots<E>,
    {
        self.check_locals::<E, L>(&locals, models.len())?;
        self.forward(locals, models, NoEpilogue);
        Ok(())
    }

    /// The run that every loop is told.
    pub(super) fn run<E: Element<8>>(&self) -> Run<'_, E>
    where
        S: Roots<E>,
    {
        Run {
            parents: self.parents,
            joints: self.joints.clone(),
            root: self.root.root(),
            renormalize: self.renormalize,
        }
    }

    /// The models of whole instances, and what the epilogue makes of them. Lengths have been
    /// checked.
    #[inline]
    pub(super) fn forward<E: Element<8>, L: Locals<E>, X: Epilogue<E>>(
        &self,
        locals: L,
        models: &mut [E],
        epilogue: X,
    ) where
        S: Roots<E>,
    {
        let (run, backend) = (self.run::<E>(), self.choice.instructions());
        if let Some(plan) = self.plan.plan()
            && planned::applies(&run, models.len())
        {
            let mut epilogue = epilogue;
            return planned::forward(backend, plan, &run, locals, models, &mut epilogue);
        }
        #[cfg(feature = "rayon")]
        if backend.many() && !run.parents.is_empty() {
            return super::parallel::forward(backend, &run, locals, models, epilogue);
        }
        forward(backend, &run, locals, models, epilogue);
    }

    pub(super) fn check_locals<E: Element<8>, L: Locals<E>>(
        &self,
        locals: &L,
        models: usize,
    ) -> Result<(), ShapeError>
    where
        S: Roots<E>,
    {
        let (what, length) = locals.shape(self.parents.len(), models)?;
        self.check::<E>(what, length)?;
        same_length("models", models, length)
    }

    /// Checks that the range, the roots and `length` elements of `what` fit the hierarchy.
    pub(super) fn check<E: Element<8>>(
        &self,
        what: &'static str,
        length: usize,
    ) -> Result<(), ShapeError>
    where
        S: Roots<E>,
    {
        let joints = self.parents.len();
        joints_within(&self.joints, joints)?;
        // A skeleton's plan is of the very same parents, and then this compares no number.
        if let Some(plan) = self.plan.plan()
            && !core::ptr::eq(plan.parents, self.parents)
            && plan.parents != self.parents
        {
            return Err(ShapeError::OtherPlan);
        }
        let instances = whole_instances(what, joints, length)?;
        match self.root.count() {
            Some(roots) => same_length("roots", roots, instances),
            None => Ok(()),
        }
    }
}

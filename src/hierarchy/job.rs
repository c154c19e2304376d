//! [`Job`]: the options of a run over a hierarchy, and the methods that run it. The methods compute
//! models or palettes from locals, locals from models, or motions from locals of any form.

use super::Hierarchy;
use super::backward::{Backward, Write};
use super::locals::{InPlace, Locals, Poses};
use super::plan::{NoPlan, Plan, Plans};
use super::run::{
    Forward, NoEpilogue, NoRoot, Palette, PaletteOnly, Renormalize, Root, Roots, Run,
};
use crate::backend::Choice;
use crate::macros::brief;
use crate::scalar::DualQuat;
use crate::storage::shape::{ShapeError, joints_within, same_length, whole_instances};
use crate::storage::{Element, MatrixOrder, Number, PaletteEntry, Source};
use core::ops::{Bound, Range, RangeBounds};

/// A run over a hierarchy and its options, such as a root transform or a range of joints. `S` is
/// the type of the base onto which root joints are multiplied, and `P` is [`Plan`] or [`NoPlan`].
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
    /// Computes the model poses of all joints from their local poses:
    /// model(j) = model(parent(j)) · local(j).
    ///
    /// `locals` and `models` have one element for each joint of one instance, or of several
    /// instances one after the other. A [`Job`] can also do this with a root transform, on a range
    /// of joints, in place, or on several threads.
    ///
    /// # Errors
    /// If the slices differ in length, or their length is not a multiple of the number of joints;
    /// `models` is untouched.
    #[inline]
    #[doc(alias("forward_kinematics", "fk", "LocalToModelJob"))]
    pub fn local_to_model<E: Element<8>>(
        &self,
        locals: &[E],
        models: &mut [E],
    ) -> Result<(), ShapeError> {
        self.job().local_to_model(locals, models)
    }

    /// Makes a job with a default for each option. The methods that run the job choose the element
    /// type, so one job serves `f32` and `f64`, plain slices and blocks.
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
    /// Sets `root` as the base of root joints in all instances: model(j) = root · local(j). A job
    /// has either this base or [`roots`](Self::roots). Setting both does not compile, because the
    /// job would ignore one base:
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

    /// Sets a base of root joints for each instance: `roots` has one element for each instance or
    /// block of instances.
    pub fn roots<E>(self, roots: &'a [E]) -> Job<'a, &'a [E], P> {
        self.with(roots)
    }

    /// Sets a base of root joints whose form is chosen at run time.
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

    /// Limits the run to a range of joints; no other joint is written. A joint whose parent is
    /// outside the range is multiplied onto the parent's pose in `models`, which must have been
    /// computed before.
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

    /// Sets the order of entries in the matrices of a palette. The default is row by row, as
    /// [skins](crate::skinning::Linear) read them.
    pub fn matrix_order(mut self, order: MatrixOrder) -> Self {
        self.order = order;
        self
    }

    /// Sets the joints whose models are normalized; by default no model is.
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

    /// Sets the plan that orders the joints of a single instance. The job of a
    /// [`Skeleton`](super::Skeleton) already has the skeleton's plan.
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
    /// Computes models from locals as [`Hierarchy::local_to_model`] does, with the options of this
    /// job.
    ///
    /// # Errors
    /// If lengths or the range of joints do not fit; `models` is untouched.
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

    /// Replaces locals by their models as [`local_to_model`](Self::local_to_model) computes them,
    /// in half the memory. The poses of a [`Crowd`](super::Crowd) are its
    /// [`blocks_mut`](super::Crowd::blocks_mut).
    ///
    /// # Errors
    /// If lengths or the range of joints do not fit; `poses` is untouched.
    #[inline]
    pub fn local_to_model_in_place<E: Element<8>>(&self, poses: &mut [E]) -> Result<(), ShapeError>
    where
        S: Roots<E>,
    {
        self.locals_to_model(InPlace, poses)
    }

    /// Computes models from locals in any form of [`Locals`]; see
    /// [`local_to_model`](Self::local_to_model).
    ///
    /// # Errors
    /// If lengths or the range of joints do not fit; `models` is untouched.
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
        let run = self.check(locals.shape(self.parents.len(), models.len())?, models.len())?;
        Forward { run: &run, locals, models, epilogue: NoEpilogue }.run(&self.plan);
        Ok(())
    }

    /// Checks that the range of joints, the plan and the roots fit the hierarchy, that `length`
    /// elements of the slice with the name `what` are whole instances, and that there are `length`
    /// models. Returns the [`Run`] that all loops read.
    #[inline]
    pub(super) fn check<E: Element<8>>(
        &self,
        (what, length): (&'static str, usize),
        models: usize,
    ) -> Result<Run<'_, E>, ShapeError>
    where
        S: Roots<E>,
    {
        let joints = self.parents.len();
        joints_within(&self.joints, joints)?;
        // The plan of a skeleton was made for the same slice of parents. In this case the pointers
        // are equal, and the parents need not be compared.
        if let Some(plan) = self.plan.plan()
            && !core::ptr::eq(plan.parents, self.parents)
            && plan.parents != self.parents
        {
            return Err(ShapeError::OtherPlan);
        }
        let instances = whole_instances(what, joints, length)?;
        if let Some(roots) = self.root.count() {
            same_length("roots", roots, instances)?;
        }
        same_length("models", models, length)?;
        Ok(Run {
            backend: self.choice.instructions(),
            parents: self.parents,
            joints: self.joints.clone(),
            root: self.root.root(),
            renormalize: self.renormalize,
        })
    }
}

impl<S, P: Plans> Job<'_, S, P> {
    /// Computes models and their skinning palette in one pass, for callers who need both;
    /// [`palette`](Self::palette) keeps no models. `models` has the results of
    /// [`locals_to_model`](Self::locals_to_model). `palette[j]` = model(j) · `inverse_binds[j]`
    /// takes a vertex of the mesh in its rest pose to its place in the posed mesh. `inverse_binds`
    /// has one motion for each joint, which serves all instances. An entry of the palette is a
    /// motion, a 3×4 matrix or a 4×4 matrix: see [`PaletteEntry`].
    ///
    /// # Errors
    /// If lengths or the range of joints do not fit; `models` and `palette` are untouched.
    ///
    /// ```
    /// use dq8::{DualQuat, Hierarchy, hierarchy::Poses};
    /// let parents = [Hierarchy::ROOT, 0];
    /// let leg = Hierarchy::new(&parents)?;
    /// let rest = [0.0_f32, -1.0].map(|y| DualQuat::from_translation([0.0, y, 0.0]));
    /// let mut models = rest;
    /// leg.job().local_to_model_in_place(&mut models)?;
    /// let inverse_binds = models.map(|model| model.conjugate());
    /// // In the rest pose no vertex moves.
    /// let mut palette = [[[0.0; 4]; 3]; 2];
    /// leg.job().palette_and_models(Poses(&rest), &mut models, &inverse_binds, &mut palette)?;
    /// assert_eq!(palette[1], DualQuat::<f32>::IDENTITY.to_matrix3x4());
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[inline]
    pub fn palette_and_models<E, L, M, const C: usize>(
        &self,
        locals: L,
        models: &mut [E],
        inverse_binds: &[DualQuat<Number<E, 8>>],
        palette: &mut [M],
    ) -> Result<(), ShapeError>
    where
        S: Roots<E>,
        E: Element<8>,
        L: Locals<E>,
        M: PaletteEntry<C, Layout = E::Layout>,
    {
        let run = self.check(locals.shape(self.parents.len(), models.len())?, models.len())?;
        same_length("inverse_binds", inverse_binds.len(), run.parents.len())?;
        same_length("palette", palette.len(), models.len())?;
        let epilogue = Palette { inverse_binds, order: self.order, entries: palette };
        Forward { run: &run, locals, models, epilogue }.run(&self.plan);
        Ok(())
    }

    /// Computes the skinning palette without models;
    /// [`palette_and_models`](Self::palette_and_models) keeps them. `scratch` has memory for the
    /// models of some whole instances, which the run reuses for later instances. For each thread,
    /// memory for 16 instances in a plain slice, or for two blocks, is fastest: so many instances
    /// fill the lanes, and their models stay in the first-level cache. After the call the contents
    /// of `scratch` have no meaning.
    ///
    /// # Errors
    /// If lengths or the range of joints do not fit, `scratch` is too small for one instance, or a
    /// joint of the range has a parent before the range, whose model no slice holds; `palette`
    /// is untouched.
    ///
    /// ```
    /// use dq8::{DualQuat, Hierarchy, hierarchy::Poses};
    /// let parents = [Hierarchy::ROOT, 0];
    /// let leg = Hierarchy::new(&parents)?;
    /// let down = DualQuat::from_translation([0.0_f32, -1.0, 0.0]);
    /// // 100 instances; 16 at a time go through the scratch.
    /// let (locals, inverse_binds) = (vec![down; 2 * 100], [DualQuat::IDENTITY; 2]);
    /// let mut scratch = [DualQuat::IDENTITY; 2 * 16];
    /// let mut palette = vec![[[0.0; 4]; 3]; 2 * 100];
    /// leg.job().palette(Poses(&locals), &mut scratch, &inverse_binds, &mut palette)?;
    /// assert_eq!(palette[199][1][3], -2.0);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    pub fn palette<E, L, M, const C: usize>(
        &self,
        locals: L,
        scratch: &mut [E],
        inverse_binds: &[DualQuat<Number<E, 8>>],
        palette: &mut [M],
    ) -> Result<(), ShapeError>
    where
        S: Roots<E>,
        E: Element<8>,
        L: Locals<E>,
        M: PaletteEntry<C, Layout = E::Layout>,
    {
        // The order is copied before the checks get a reference to the job (*Settled*,
        // docs/measured.md). Then a compiler that knows the caller's order compiles only the stores
        // for this order.
        let order = self.order;
        let run = self.check(locals.shape(self.parents.len(), palette.len())?, palette.len())?;
        let joints = run.parents.len();
        same_length("inverse_binds", inverse_binds.len(), joints)?;
        if whole_instances("scratch", joints, scratch.len())? == 0 && !palette.is_empty() {
            same_length("scratch", scratch.len(), joints)?;
        }
        for joint in run.joints.clone() {
            let parent = run.parents.get(joint).map_or(joint, |&parent| parent as usize);
            if parent < run.joints.start {
                return Err(ShapeError::NoParent { joint, parent });
            }
        }
        let instances = palette.len().checked_div(joints).unwrap_or(0);
        let epilogue = Palette { inverse_binds, order, entries: palette };
        if let (Some(models), 1) = (scratch.get_mut(..joints), instances) {
            Forward { run: &run, locals, models, epilogue }.run(&self.plan);
        } else {
            PaletteOnly { run: &run, locals, instances, scratch, epilogue }.run();
        }
        Ok(())
    }
}

impl<S, P: Plans> Job<'_, S, P> {
    /// Computes the local poses of joints from unit models:
    /// local(j) = model(parent(j))* · model(j). With a range of [`joints`](Self::joints), only
    /// their locals are written.
    ///
    /// # Errors
    /// If lengths or the range of joints do not fit; `locals` is untouched.
    ///
    /// ```
    /// use dq8::{DualQuat, Hierarchy};
    /// let parents = [Hierarchy::ROOT, 0];
    /// let pair = Hierarchy::new(&parents)?;
    /// let models = [1.0_f32, 3.0].map(|x| DualQuat::from_translation([x, 0.0, 0.0]));
    /// let mut locals = models;
    /// pair.job().model_to_local(&models, &mut locals)?;
    /// assert_eq!(locals[1].translation(), [2.0, 0.0, 0.0]);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[inline]
    pub fn model_to_local<E: Element<8>>(
        &self,
        models: &[E],
        locals: &mut [E],
    ) -> Result<(), ShapeError>
    where
        S: Roots<E>,
    {
        let run = self.check(("models", models.len()), models.len())?;
        same_length("locals", locals.len(), models.len())?;
        Backward { run: &run, models: Source::Slice(models), locals }.on_threads();
        Ok(())
    }

    /// Replaces models by their locals as [`model_to_local`](Self::model_to_local) computes them.
    ///
    /// # Errors
    /// If lengths or the range of joints do not fit; `poses` is untouched.
    #[inline]
    pub fn model_to_local_in_place<E: Element<8>>(&self, poses: &mut [E]) -> Result<(), ShapeError>
    where
        S: Roots<E>,
    {
        let run = self.check(("poses", poses.len()), poses.len())?;
        Backward { run: &run, models: Source::Output, locals: poses }.on_threads();
        Ok(())
    }
}

impl<P: Plans> Job<'_, NoRoot, P> {
    /// Writes locals of any form, such as a sampled clip or layers, as motions: for inverse
    /// kinematics after animation, for root motion, or for export. For models alone this step is
    /// not needed, because [`locals_to_model`](Self::locals_to_model) takes locals of any form.
    /// With a range of [`joints`](Self::joints), only their poses are written.
    ///
    /// # Errors
    /// If lengths or the range of joints do not fit; `poses` is untouched.
    ///
    /// ```
    /// use dq8::hierarchy::{Clip, Sampled};
    /// use dq8::{DualQuat, Skeleton, law::Nlerp};
    /// let leg = Skeleton::new(&[-1, 0])?;
    /// // Two frames of two joints, of which the second bends.
    /// let bent = DualQuat::from_rotation(dq8::Quat::from_rotation_x(1.0));
    /// let keys = [DualQuat::<f32>::IDENTITY, DualQuat::IDENTITY, DualQuat::IDENTITY, bent];
    /// let pose = Sampled::new(Nlerp, Clip::new(2, &keys)?, &[0], &[0.5])?;
    /// let mut locals = [DualQuat::IDENTITY; 2];
    /// leg.job().locals(pose, &mut locals)?;
    /// // Here `Job::two_bone` puts the foot on the ground, and then:
    /// leg.job().local_to_model_in_place(&mut locals)?;
    /// assert!((locals[1].rotation().angle_to(dq8::Quat::IDENTITY) - 0.5).abs() < 1e-6);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[inline]
    pub fn locals<E: Element<8>, L: Locals<E>>(
        &self,
        locals: L,
        poses: &mut [E],
    ) -> Result<(), ShapeError> {
        let run = self.check(locals.shape(self.parents.len(), poses.len())?, poses.len())?;
        Write { run: &run, locals, poses }.on_threads();
        Ok(())
    }
}

use super::backward::Backward;
use super::concatenate::Forward;
use super::locals::{InPlace, Locals, Poses};
use super::palette::{Epilogue, NoEpilogue, Palette};
use super::run::{Root, Run};
use super::unkept::Unkept;
use super::{Hierarchy, Renormalize, transposed};
#[cfg(feature = "alloc")]
use super::{HierarchyPlan, planned};
use crate::dispatch::Backend;
use crate::palette_entry::{MatrixOrder, PaletteEntry};
use crate::scalar::DualQuat;
use crate::shape::{ShapeError, joints_within, same_length, whole_instances};
use crate::storage::{Element, Layout, Number, Source};
use core::ops::Range;

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
#[derive(Clone, Debug)]
pub struct Job<'a, E: Element<8>> {
    pub(super) run: Run<'a, E>,
    pub(super) backend: Option<Backend>,
    order: MatrixOrder,
    /// The order to take for one instance.
    #[cfg(feature = "alloc")]
    plan: Option<&'a HierarchyPlan>,
}

impl<'a> Hierarchy<'a> {
    /// Model poses of all joints from local ones: model(j) = model(parent(j)) · local(j).
    ///
    /// `locals` and `models` hold one element per joint, or several whole instances one after the
    /// other. A [`Job`] does the same with a root transform or on some of the joints.
    ///
    /// # Errors
    /// If the slices differ in length or hold no whole number of instances; `models` is untouched.
    #[inline]
    pub fn local_to_model<E: Element<8>>(
        &self,
        locals: &[E],
        models: &mut [E],
    ) -> Result<(), ShapeError> {
        self.job().local_to_model(locals, models)
    }

    /// [`local_to_model`](Self::local_to_model) over the locals themselves: half the memory.
    ///
    /// # Errors
    /// If the slice holds no whole number of instances; it is untouched then.
    #[inline]
    pub fn local_to_model_in_place<E: Element<8>>(
        &self,
        poses: &mut [E],
    ) -> Result<(), ShapeError> {
        self.job().local_to_model_in_place(poses)
    }

    /// A run with options.
    #[must_use]
    pub fn job<E: Element<8>>(&self) -> Job<'a, E> {
        let run = Run {
            parents: self.parents(),
            joints: 0..self.joints(),
            root: Root::None,
            renormalize: Renormalize::Never,
        };
        Job {
            run,
            backend: None,
            order: MatrixOrder::Rows,
            #[cfg(feature = "alloc")]
            plan: None,
        }
    }
}

impl<'a, E: Element<8>> Job<'a, E> {
    /// Puts every root joint on `root`: model(j) = root · local(j), the same for all instances. Instead of
    /// [`roots`](Self::roots): a job with both is an error when it runs.
    #[must_use]
    pub fn root(mut self, root: DualQuat<Number<E, 8>>) -> Self {
        self.run.root = self.run.root.replaced_by(Root::Same(root));
        self
    }

    /// Puts the root joints of each instance (block) on its own element of `roots`. Instead of
    /// [`root`](Self::root): one motion before all of them is multiplied into them.
    #[must_use]
    pub fn roots(mut self, roots: &'a [E]) -> Self {
        self.run.root = self.run.root.replaced_by(Root::Each(roots));
        self
    }

    /// Only these joints are computed. Their parents outside the range must already hold their
    /// model poses; the other joints are not written.
    #[must_use]
    pub fn joints(mut self, joints: Range<usize>) -> Self {
        self.run.joints = joints;
        self
    }

    /// Sets the order of the numbers in a palette's matrices; rows by default, which is what
    /// [skins](crate::skinning::Linear) read.
    #[must_use]
    pub fn matrix_order(mut self, order: MatrixOrder) -> Self {
        self.order = order;
        self
    }

    /// Sets when models are normalized on the way down; never by default.
    #[must_use]
    pub fn renormalize(mut self, policy: Renormalize) -> Self {
        self.run.renormalize = policy;
        self
    }

    /// Runs with these instructions; by default with the best that the CPU has.
    #[must_use]
    pub fn backend(mut self, backend: Backend) -> Self {
        self.backend = Some(backend);
        self
    }

    /// Takes the order of this plan, which is of the same parents, for one instance.
    #[cfg(feature = "alloc")]
    pub(super) fn planned(mut self, plan: &'a HierarchyPlan) -> Self {
        self.plan = Some(plan);
        self
    }

    /// See [`Hierarchy::local_to_model`].
    ///
    /// # Errors
    /// If lengths or the range do not fit; `models` is untouched.
    #[inline]
    pub fn local_to_model(&self, locals: &[E], models: &mut [E]) -> Result<(), ShapeError> {
        self.locals_to_model(Poses(locals), models)
    }

    /// See [`Hierarchy::local_to_model_in_place`].
    ///
    /// # Errors
    /// If lengths or the range do not fit; `poses` is untouched.
    #[inline]
    pub fn local_to_model_in_place(&self, poses: &mut [E]) -> Result<(), ShapeError> {
        self.locals_to_model(InPlace, poses)
    }

    /// [`local_to_model`](Self::local_to_model) of locals in any form.
    ///
    /// # Errors
    /// If lengths or the range do not fit; `models` is untouched.
    ///
    /// ```
    /// use dq8::{DualQuat, Hierarchy, Quat, hierarchy::Rotations};
    /// let parents = [Hierarchy::ROOT, 0];
    /// let arm = Hierarchy::new(&parents)?;
    /// let half_turn = Quat::from_xyzw(0.0_f32, 0.0, 1.0, 0.0);
    /// let locals = Rotations { rotations: &[half_turn; 2], offsets: &[[0.0; 3], [2.0, 0.0, 0.0]] };
    /// let mut models = [DualQuat::IDENTITY; 2];
    /// arm.job().locals_to_model(locals, &mut models)?;
    /// assert_eq!(models[1].translation(), [-2.0, 0.0, 0.0]);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[inline]
    pub fn locals_to_model<L: Locals<E>>(
        &self,
        locals: L,
        models: &mut [E],
    ) -> Result<(), ShapeError> {
        self.check_locals(&locals, models.len())?;
        self.forward(locals, models, NoEpilogue);
        Ok(())
    }

    /// Models and the skinning palette of them in one pass, for callers who need both ([`palette`](Self::palette) keeps no
    /// models): `models` as of [`locals_to_model`](Self::locals_to_model), and
    /// `palette[j]` = model(j) · `inverse_binds[j]`, which takes a vertex of the mesh in its rest pose
    /// to where joint j has moved it. `inverse_binds` holds one per joint, the same for all instances;
    /// the palette is of motions, 3×4 or 4×4 matrices: [`PaletteEntry`].
    ///
    /// # Errors
    /// If lengths or the range do not fit; `models` and `palette` are untouched.
    ///
    /// ```
    /// use dq8::{DualQuat, Hierarchy, hierarchy::Poses};
    /// let parents = [Hierarchy::ROOT, 0];
    /// let leg = Hierarchy::new(&parents)?;
    /// let rest = [0.0_f32, -1.0].map(|y| DualQuat::from_translation([0.0, y, 0.0]));
    /// let mut models = rest;
    /// leg.local_to_model_in_place(&mut models)?;
    /// let inverse_binds = models.map(|model| model.conjugate());
    /// // In the rest pose no vertex moves.
    /// let mut palette = [[[0.0; 4]; 3]; 2];
    /// leg.job().locals_to_palette(Poses(&rest), &mut models, &inverse_binds, &mut palette)?;
    /// assert_eq!(palette[1], DualQuat::<f32>::IDENTITY.to_matrix3x4());
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[inline]
    pub fn locals_to_palette<L: Locals<E>, M, const C: usize>(
        &self,
        locals: L,
        models: &mut [E],
        inverse_binds: &[DualQuat<Number<E, 8>>],
        palette: &mut [M],
    ) -> Result<(), ShapeError>
    where
        M: PaletteEntry<C, Layout = E::Layout>,
    {
        self.check_locals(&locals, models.len())?;
        same_length("inverse_binds", inverse_binds.len(), self.run.parents.len())?;
        same_length("palette", palette.len(), models.len())?;
        self.forward(
            locals,
            models,
            Palette { inverse_binds, order: self.order, entries: palette },
        );
        Ok(())
    }

    /// The skinning palette alone: models are not kept ([`locals_to_palette`](Self::locals_to_palette) keeps them). They go
    /// through `scratch`, which holds some whole instances, again and again. 16 instances serve plain motions and
    /// two blocks serve blocks best: as few as fill the lanes, so that they stay in the first cache. What is in it
    /// afterwards has no meaning: with plain motions, models stay there in the order of registers.
    ///
    /// # Errors
    /// If lengths or the range do not fit, `scratch` holds no instance, or the parent of a joint of the range is
    /// not in it, so that nothing holds its model; `palette` is untouched.
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
    pub fn palette<L: Locals<E>, M, const C: usize>(
        &self,
        locals: L,
        scratch: &mut [E],
        inverse_binds: &[DualQuat<Number<E, 8>>],
        palette: &mut [M],
    ) -> Result<(), ShapeError>
    where
        M: PaletteEntry<C, Layout = E::Layout>,
    {
        self.check_locals(&locals, palette.len())?;
        let joints = self.run.parents.len();
        same_length("inverse_binds", inverse_binds.len(), joints)?;
        if whole_instances("scratch", joints, scratch.len())? == 0 && !palette.is_empty() {
            same_length("scratch", scratch.len(), joints)?;
        }
        for joint in self.run.joints.clone() {
            let parent = self.run.parents.get(joint).map_or(joint, |&parent| parent as usize);
            if parent < self.run.joints.start {
                return Err(ShapeError::NoParent { joint, parent });
            }
        }
        let (all, mut done) = (palette.len(), 0);
        if transposed::MANY && E::Layout::THINGS == 1 {
            let instances = palette.len() / joints.max(1);
            let mut epilogue = Palette { inverse_binds, order: self.order, entries: palette };
            let (run, epilogue) = (&self.run, &mut epilogue);
            let kernel = Unkept { run, locals, instances, scratch, epilogue };
            done = joints * self.backend.unwrap_or_default().run(kernel);
        }
        let rest = palette.get_mut(done..).unwrap_or_default();
        for entries in rest.chunks_mut(scratch.len().max(1)) {
            let (job, locals) = self.part(locals, done..done + entries.len(), all);
            let models = scratch.get_mut(..entries.len()).unwrap_or_default();
            job.forward(locals, models, Palette { inverse_binds, order: self.order, entries });
            done += models.len();
        }
        Ok(())
    }

    #[inline]
    pub(super) fn forward<L: Locals<E>, X: Epilogue<E>>(
        &self,
        locals: L,
        models: &mut [E],
        mut epilogue: X,
    ) {
        let (run, backend) = (&self.run, self.backend.unwrap_or_default());
        #[cfg(feature = "alloc")]
        if let Some(plan) = self.plan
            && planned::applies(run, models.len())
        {
            return planned::forward(backend, plan.borrowed(), run, locals, models, &mut epilogue);
        }
        if E::Layout::THINGS > 1 {
            backend.run(Forward { run, locals, models, epilogue });
        } else {
            transposed::forward(backend, run, locals, models, &mut epilogue);
        }
    }

    /// Local poses of all joints from model ones: local(j) = model(parent(j))* · model(j). The
    /// models must be unit. With [`joints`](Self::joints), only those locals are written.
    ///
    /// # Errors
    /// If lengths or the range do not fit; `locals` is untouched.
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
    pub fn model_to_local(&self, models: &[E], locals: &mut [E]) -> Result<(), ShapeError> {
        self.check("models", models.len())?;
        same_length("locals", locals.len(), models.len())?;
        self.backward(Source::Slice(models), locals);
        Ok(())
    }

    /// [`model_to_local`](Self::model_to_local) over the models themselves.
    ///
    /// # Errors
    /// If lengths or the range do not fit; `poses` is untouched.
    #[inline]
    pub fn model_to_local_in_place(&self, poses: &mut [E]) -> Result<(), ShapeError> {
        self.check("poses", poses.len())?;
        self.backward(Source::Output, poses);
        Ok(())
    }

    #[inline]
    fn backward(&self, models: Source<'_, E>, locals: &mut [E]) {
        self.backend.unwrap_or_default().run(Backward { run: &self.run, models, locals });
    }

    /// The same job, with its locals, for some of the models: whole instances. Without the plan, unless these are all:
    /// a plan is for one instance, and an instance among others must not know which of them share its part.
    pub(super) fn part<L: Locals<E>>(
        &self,
        locals: L,
        models: Range<usize>,
        #[cfg_attr(not(feature = "alloc"), expect(unused, reason = "nothing is planned"))]
        all: usize,
    ) -> (Self, L) {
        let joints = self.run.parents.len().max(1);
        let instances = models.start / joints..models.end / joints;
        let mut job = self.clone();
        #[cfg(feature = "alloc")]
        if models.len() < all {
            job.plan = None;
        }
        job.run.root = self.run.root.part(instances.clone());
        (job, locals.part(joints, instances))
    }

    pub(super) fn check_locals<L: Locals<E>>(
        &self,
        locals: &L,
        models: usize,
    ) -> Result<(), ShapeError> {
        let (what, length) = locals.shape(self.run.parents.len(), models)?;
        self.check(what, length)?;
        same_length("models", models, length)
    }

    /// Whether the range, the roots and `length` elements of `what` fit the hierarchy.
    fn check(&self, what: &'static str, length: usize) -> Result<(), ShapeError> {
        let joints = self.run.parents.len();
        joints_within(&self.run.joints, joints)?;
        let instances = whole_instances(what, joints, length)?;
        match self.run.root {
            Root::Each(roots) => same_length("roots", roots.len(), instances),
            Root::None | Root::Same(_) => Ok(()),
            Root::Both => Err(ShapeError::TwoRoots),
        }
    }
}

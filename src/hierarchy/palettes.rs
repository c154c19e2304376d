//! Skinning palettes: with the models, or without.

use super::Job;
use super::forward;
use super::locals::Locals;
use super::palette::Palette;
#[cfg(feature = "rayon")]
use super::parallel;
use super::plan::Plans;
use super::root::Roots;
use crate::palette_entry::PaletteEntry;
use crate::scalar::DualQuat;
use crate::storage::shape::{ShapeError, same_length, whole_instances};
use crate::storage::{Element, Number};

impl<S, P: Plans> Job<'_, S, P> {
    /// Models and the skinning palette of them in one pass, for callers who need both
    /// ([`palette`](Self::palette) keeps no models): `models` as of
    /// [`locals_to_model`](Self::locals_to_model), and `palette[j]` = model(j) ·
    /// `inverse_binds[j]`, which takes a vertex of the mesh in its rest pose to where joint j has
    /// moved it. `inverse_binds` holds one per joint, the same for all instances; the palette is of
    /// motions, 3×4 or 4×4 matrices: [`PaletteEntry`].
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
        self.check_locals::<E, L>(&locals, models.len())?;
        same_length("inverse_binds", inverse_binds.len(), self.run::<E>().parents.len())?;
        same_length("palette", palette.len(), models.len())?;
        self.forward(
            locals,
            models,
            Palette { inverse_binds, order: self.order, entries: palette },
        );
        Ok(())
    }

    /// The skinning palette alone: models are not kept
    /// ([`palette_and_models`](Self::palette_and_models) keeps them). They go through `scratch`,
    /// which holds some whole instances, again and again. 16 instances serve plain motions and two
    /// blocks serve blocks best, for each thread: as few as fill the lanes, so that they stay in
    /// the first cache. What is in it afterwards has no meaning: with plain motions, models stay
    /// there in the order of registers.
    ///
    /// # Errors
    /// If lengths or the range do not fit, `scratch` holds no instance, or the parent of a joint of
    /// the range is not in it, so that nothing holds its model; `palette` is untouched.
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
        // Before the job is lent to checks: a compiler that has seen the order written keeps the
        // stores of that one alone.
        let order = self.order;
        self.check_locals::<E, L>(&locals, palette.len())?;
        let run = self.run::<E>();
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
        let epilogue = Palette { inverse_binds, order, entries: palette };
        let one = epilogue.entries.len() == joints;
        if let Some(models) = scratch.get_mut(..joints).filter(|_| one) {
            self.forward(locals, models, epilogue);
            return Ok(());
        }
        let backend = self.choice.instructions();
        #[cfg(feature = "rayon")]
        if backend.many() && joints > 0 {
            parallel::palette(backend, &run, locals, scratch, epilogue);
            return Ok(());
        }
        forward::palette(backend, &run, locals, scratch, epilogue);
        Ok(())
    }
}

//! [`Locals`]: what a joint adds to its parent, and how it lies in memory.

use super::Pose;
use super::job::same_length;
use crate::error::ShapeError;
use crate::motion::Motion;
use dq8_simd::Level;

/// Locals of whole instances, `[instance][joint]`: [`Motions`], [`RotationsTranslations`] or
/// [`Rotations`]. Sealed.
pub trait Locals<P: Pose>: Copy + sealed::Sealed {
    /// Their name in errors, and how many there are for so many models.
    ///
    /// # Errors
    /// If what is the same for all instances is not there for all joints.
    fn shape(&self, joints: usize, models: usize) -> Result<(&'static str, usize), ShapeError>;
    /// parent · local; `models` are those of the instance.
    fn onto<V: Level>(
        self,
        level: V,
        parent: &P,
        models: &[P],
        spot: JointSlot,
    ) -> Option<P::Motion<V>>;
    /// The local itself.
    fn alone<V: Level>(self, level: V, models: &[P], spot: JointSlot) -> Option<P::Motion<V>>;
}

/// Which local.
#[derive(Clone, Copy, Debug)]
pub struct JointSlot {
    /// Among all instances.
    pub(super) index: usize,
    pub(super) joint: usize,
    /// See [`Pose::parts`].
    pub(super) part: usize,
}

/// Any motions.
#[derive(Clone, Copy, Debug)]
pub struct Motions<'s, P>(
    /// One a joint.
    pub &'s [P],
);

impl<P: Pose> Locals<P> for Motions<'_, P> {
    fn shape(&self, _: usize, _: usize) -> Result<(&'static str, usize), ShapeError> {
        Ok(("locals", self.0.len()))
    }
    #[inline(always)]
    fn onto<V: Level>(
        self,
        level: V,
        parent: &P,
        _: &[P],
        JointSlot { index, part, .. }: JointSlot,
    ) -> Option<P::Motion<V>> {
        Some(P::product(level, part, parent, self.0.get(index)?))
    }
    #[inline(always)]
    fn alone<V: Level>(
        self,
        level: V,
        _: &[P],
        JointSlot { index, part, .. }: JointSlot,
    ) -> Option<P::Motion<V>> {
        Some(self.0.get(index)?.load(level, part))
    }
}

/// Motions that lie where the models go.
#[derive(Clone, Copy)]
pub(super) struct InPlace;

impl<P: Pose> Locals<P> for InPlace {
    fn shape(&self, _: usize, models: usize) -> Result<(&'static str, usize), ShapeError> {
        Ok(("poses", models))
    }
    #[inline(always)]
    fn onto<V: Level>(
        self,
        level: V,
        parent: &P,
        models: &[P],
        JointSlot { joint, part, .. }: JointSlot,
    ) -> Option<P::Motion<V>> {
        Some(P::product(level, part, parent, models.get(joint)?))
    }
    #[inline(always)]
    fn alone<V: Level>(
        self,
        level: V,
        models: &[P],
        JointSlot { joint, part, .. }: JointSlot,
    ) -> Option<P::Motion<V>> {
        Some(models.get(joint)?.load(level, part))
    }
}

/// Rotations and translations, r + ½εtr: an eighth less memory than motions, and no more operations.
#[derive(Clone, Copy, Debug)]
pub struct RotationsTranslations<'s, P: Pose>(
    /// One a joint.
    pub &'s [P::RotationTranslation],
);

impl<P: Pose> Locals<P> for RotationsTranslations<'_, P> {
    fn shape(&self, _: usize, _: usize) -> Result<(&'static str, usize), ShapeError> {
        Ok(("locals", self.0.len()))
    }
    #[inline(always)]
    fn onto<V: Level>(
        self,
        level: V,
        parent: &P,
        _: &[P],
        JointSlot { index, part, .. }: JointSlot,
    ) -> Option<P::Motion<V>> {
        let (rotation, translation) = P::load_rotation_translation(level, part, self.0.get(index)?);
        Some(P::product_rotation_translation(level, part, parent, rotation, translation))
    }
    #[inline(always)]
    fn alone<V: Level>(
        self,
        level: V,
        _: &[P],
        JointSlot { index, part, .. }: JointSlot,
    ) -> Option<P::Motion<V>> {
        let (rotation, translation) = P::load_rotation_translation(level, part, self.0.get(index)?);
        Some(Motion::from_rotation_translation(rotation, translation))
    }
}

/// Rotations, and the offset of each joint from its parent, the same for all instances: what
/// animation clips hold, and half the memory of motions.
#[derive(Clone, Copy, Debug)]
pub struct Rotations<'s, P: Pose> {
    /// One a joint.
    pub rotations: &'s [P::Rotation],
    /// One a joint of the skeleton: its place in its parent.
    pub offsets: &'s [[P::Real; 3]],
}

impl<P: Pose> Locals<P> for Rotations<'_, P> {
    fn shape(&self, joints: usize, _: usize) -> Result<(&'static str, usize), ShapeError> {
        same_length("offsets", self.offsets.len(), joints)?;
        Ok(("rotations", self.rotations.len()))
    }
    #[inline(always)]
    fn onto<V: Level>(
        self,
        level: V,
        parent: &P,
        _: &[P],
        JointSlot { index, joint, part }: JointSlot,
    ) -> Option<P::Motion<V>> {
        let rotation = P::load_rotation(level, part, self.rotations.get(index)?);
        let offset = P::splat_vector(level, *self.offsets.get(joint)?);
        Some(P::product_rotation_translation(level, part, parent, rotation, offset))
    }
    #[inline(always)]
    fn alone<V: Level>(
        self,
        level: V,
        _: &[P],
        JointSlot { index, joint, part }: JointSlot,
    ) -> Option<P::Motion<V>> {
        let rotation = P::load_rotation(level, part, self.rotations.get(index)?);
        let offset = P::splat_vector(level, *self.offsets.get(joint)?);
        Some(Motion::from_rotation_translation(rotation, offset))
    }
}

mod sealed {
    use super::{InPlace, Motions, Pose, Rotations, RotationsTranslations};
    pub trait Sealed {}
    impl Sealed for InPlace {}
    impl<P> Sealed for Motions<'_, P> {}
    impl<P: Pose> Sealed for RotationsTranslations<'_, P> {}
    impl<P: Pose> Sealed for Rotations<'_, P> {}
}

//! [`Locals`]: what a joint adds to its parent, and how it lies in memory.

use super::Pose;
use crate::motion::Motion;
use dq8_simd::Level;

/// Which local.
#[derive(Clone, Copy)]
pub(super) struct Spot {
    /// Among all instances.
    pub(super) index: usize,
    pub(super) joint: usize,
    /// See [`Pose::parts`].
    pub(super) part: usize,
}

/// Locals of whole instances, `[instance][joint]`.
pub(super) trait Locals<P: Pose>: Copy {
    /// parent · local, or the local itself, of a part of the element at `spot`. `models` are those of
    /// its instance.
    fn onto<V: Level>(
        self,
        level: V,
        parent: Option<P::Motion<V>>,
        models: &[P],
        spot: Spot,
    ) -> Option<P::Motion<V>>;
}

/// Any motions; without a slice, they lie where the models go.
#[derive(Clone, Copy)]
pub(super) struct Motions<'s, P>(pub(super) Option<&'s [P]>);

impl<P: Pose> Locals<P> for Motions<'_, P> {
    #[inline(always)]
    fn onto<V: Level>(
        self,
        level: V,
        parent: Option<P::Motion<V>>,
        models: &[P],
        Spot { index, joint, part }: Spot,
    ) -> Option<P::Motion<V>> {
        let local = match self.0 {
            Some(locals) => locals.get(index)?,
            None => models.get(joint)?,
        };
        let local = local.load(level, part);
        Some(match parent {
            Some(parent) => parent * local,
            None => local,
        })
    }
}

/// Rotations and translations: 44 operations instead of 48, and an eighth less memory.
#[derive(Clone, Copy)]
pub(super) struct RotationsTranslations<'s, P: Pose>(pub(super) &'s [P::RotationTranslation]);

impl<P: Pose> Locals<P> for RotationsTranslations<'_, P> {
    #[inline(always)]
    fn onto<V: Level>(
        self,
        level: V,
        parent: Option<P::Motion<V>>,
        _: &[P],
        Spot { index, part, .. }: Spot,
    ) -> Option<P::Motion<V>> {
        let (rotation, translation) = P::load_rotation_translation(level, part, self.0.get(index)?);
        Some(joined(parent, rotation, translation))
    }
}

/// Rotations, and the offset of each joint from its parent, the same for all instances: what
/// animation clips hold.
#[derive(Clone, Copy)]
pub(super) struct Rotations<'s, P: Pose> {
    pub(super) rotations: &'s [P::Rotation],
    pub(super) offsets: &'s [[P::Real; 3]],
}

impl<P: Pose> Locals<P> for Rotations<'_, P> {
    #[inline(always)]
    fn onto<V: Level>(
        self,
        level: V,
        parent: Option<P::Motion<V>>,
        _: &[P],
        Spot { index, joint, part }: Spot,
    ) -> Option<P::Motion<V>> {
        let rotation = P::load_rotation(level, part, self.rotations.get(index)?);
        let offset = P::splat_vector(level, *self.offsets.get(joint)?);
        Some(joined(parent, rotation, offset))
    }
}

#[inline(always)]
fn joined<M: Motion>(parent: Option<M>, rotation: M::Quat, translation: [M::Real; 3]) -> M {
    match parent {
        Some(parent) => parent.mul_rotation_translation(rotation, translation),
        None => M::from_rotation_translation(rotation, translation),
    }
}

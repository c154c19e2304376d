//! [`Palette`]: what skinning needs of a joint, made while its model is at hand.

use super::Pose;
use super::locals::JointSlot;
use crate::real::Real;
use crate::scalar::DualQuat;
use dq8_simd::{Float, Level, Row};

/// An element of a skinning palette: a motion like `P`, or a 3×4 matrix ([`MatrixBlock`] for blocks,
/// `[[R; 4]; 3]` for one instance). Sealed.
///
/// [`MatrixBlock`]: crate::MatrixBlock
pub trait PaletteEntry<P: Pose>: Copy + sealed::Sealed {
    /// Writes the motion.
    fn store<V: Level>(&mut self, level: V, part: usize, motion: P::Motion<V>);
}

impl<R: Real + Float> PaletteEntry<DualQuat<R>> for DualQuat<R> {
    #[inline(always)]
    fn store<V: Level>(&mut self, level: V, part: usize, motion: Self) {
        Pose::store(self, level, part, motion);
    }
}

impl<R: Real + Float> PaletteEntry<DualQuat<R>> for [[R; 4]; 3] {
    #[inline(always)]
    fn store<V: Level>(&mut self, _: V, _: usize, motion: DualQuat<R>) {
        *self = motion.to_matrix3x4();
    }
}

impl<A: Row<Real: Real>> PaletteEntry<Self> for dq8_simd::Block<A, 8> {
    #[inline(always)]
    fn store<V: Level>(&mut self, level: V, part: usize, motion: <Self as Pose>::Motion<V>) {
        Pose::store(self, level, part, motion);
    }
}

impl<A: Row<Real: Real>> PaletteEntry<dq8_simd::Block<A, 8>> for dq8_simd::Block<A, 12> {
    #[inline(always)]
    fn store<V: Level>(
        &mut self,
        _: V,
        part: usize,
        motion: <dq8_simd::Block<A, 8> as Pose>::Motion<V>,
    ) {
        let [[a, b, c, d], [e, f, g, h], [i, j, k, l]] = motion.to_matrix3x4();
        self.store_part::<V>([a, b, c, d, e, f, g, h, i, j, k, l], part);
    }
}

/// What else becomes of a model once it is known.
pub(super) trait Epilogue<P: Pose> {
    fn finish<V: Level>(&mut self, level: V, spot: JointSlot, model: &P);
}

/// Nothing.
pub(super) struct NoEpilogue;

impl<P: Pose> Epilogue<P> for NoEpilogue {
    #[inline(always)]
    fn finish<V: Level>(&mut self, _: V, _: JointSlot, _: &P) {}
}

/// model(j) · inverse bind(j), from the mesh in its rest pose to the posed mesh.
pub(super) struct Palette<'s, P: Pose, E> {
    pub(super) inverse_binds: &'s [DualQuat<P::Real>],
    pub(super) entries: &'s mut [E],
}

impl<P: Pose, E: PaletteEntry<P>> Epilogue<P> for Palette<'_, P, E> {
    #[inline(always)]
    fn finish<V: Level>(
        &mut self,
        level: V,
        JointSlot { index, joint, part }: JointSlot,
        model: &P,
    ) {
        if let (Some(bind), Some(entry)) =
            (self.inverse_binds.get(joint), self.entries.get_mut(index))
        {
            entry.store(level, part, model.load(level, part) * P::splat(level, *bind));
        }
    }
}

mod sealed {
    use crate::scalar::DualQuat;
    pub trait Sealed {}
    impl<R> Sealed for DualQuat<R> {}
    impl<R> Sealed for [[R; 4]; 3] {}
    impl<A, const C: usize> Sealed for dq8_simd::Block<A, C> {}
}

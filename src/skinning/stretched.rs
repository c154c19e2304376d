use super::blender::{Blender, SurfaceMap};
use super::dual_blend::{DualBlend, DualSum, ScaledMotion};
use super::influences::Scratch;
use super::linear::Linear;
use super::linear_map::LinearMap;
use crate::number::Scalar;
use crate::scalar::DualQuat;
use crate::storage::shape::{ShapeError, same_length};
use dq8_simd::Lanes;
use dq8_simd::internal::Index;

/// Dual quaternion skinning of joints that scale and shear: v ↦ σ applied to Sv, S = Σ
/// wᵢSᵢ, σ as of [`DualBlend`]. What a joint's matrix has beyond a motion comes first, blended
/// linearly (UsdSkel's `dualQuaternion`); [`split_palette`](super::split_palette) takes matrices
/// apart.
///
/// Normals become σ applied to cof(S)n, normalized; tangents σ applied to St, normalized.
#[derive(Clone, Copy, Debug)]
pub struct StretchedDualBlend<'a, R> {
    stretch: Linear<'a, R>,
    rigid: DualBlend<'a, R>,
}

impl<'a, R: Scalar> StretchedDualBlend<'a, R> {
    /// Each joint's motion, unit, and before it its stretch: the rows of a 3×4 matrix without
    /// translation.
    #[must_use]
    pub fn new(motions: &'a [DualQuat<R>], stretches: &'a [[[R; 4]; 3]]) -> Self {
        Self { stretch: Linear::new(stretches), rigid: DualBlend::new(motions) }
    }
}

/// First a stretch, then a motion.
#[derive(Clone, Copy, Debug)]
pub struct StretchedMap<L>(LinearMap<L>, ScaledMotion<L>);

impl<L: Lanes> SurfaceMap<L> for StretchedMap<L> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn point(&self, point: [L; 3]) -> [L; 3] {
        self.1.point(self.0.point(point))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn normal(&self, normal: [L; 3]) -> [L; 3] {
        self.1.normal(self.0.normal(normal))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn tangent(&self, tangent: [L; 3]) -> [L; 3] {
        self.1.tangent(self.0.tangent(tangent))
    }
}

impl<R: Scalar> Blender<R> for StretchedDualBlend<'_, R> {
    type Sum<L: Lanes<Real = R>> = ([[L; 4]; 3], DualSum<L>);
    type Map<L: Lanes<Real = R>> = StretchedMap<L>;

    const SHUFFLES: bool = false;

    fn check(&self, joints: usize, _: usize) -> Result<(), ShapeError> {
        same_length("motions", self.rigid.joints(), joints)?;
        same_length("stretches", self.stretch.joints(), joints)
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn sum<L: Lanes<Real = R>, J: Index>(
        &self,
        level: L::Level,
        scratch: &mut Scratch<'_, R, J>,
    ) -> Option<Self::Sum<L>> {
        Some((self.stretch.sum(level, scratch)?, self.rigid.sum(level, scratch)?))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn join<L: Lanes<Real = R>>(&self, a: Self::Sum<L>, b: Self::Sum<L>) -> Self::Sum<L> {
        (self.stretch.join(a.0, b.0), self.rigid.join(a.1, b.1))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn map<L: Lanes<Real = R>>(
        &self,
        level: L::Level,
        (stretch, rigid): Self::Sum<L>,
        first: usize,
    ) -> StretchedMap<L> {
        StretchedMap(self.stretch.map(level, stretch, first), self.rigid.map(level, rigid, first))
    }
}

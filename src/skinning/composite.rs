//! Blends that combine two blends: [`StretchedDualBlend`] applies the maps of both, one after the
//! other, and [`Mixed`] interpolates between the results of both.

use super::SkinningError;
use super::blender::{Blender, SurfaceMap};
use super::dual_blend::{DualBlend, DualSum, ScaledMotion};
use super::linear::{Linear, LinearMap, unit};
use super::skin::Scratch;
use crate::macros::brief;
use crate::number::Scalar;
use crate::scalar::DualQuat;
use crate::storage::shape::{ShapeError, same_length};
use core::fmt::Debug;
use dq8_simd::Lanes;
use dq8_simd::internal::Index;

/// Dual quaternion skinning of joints that scale and shear: v ↦ σ applied to Sv, where S = Σ
/// wᵢSᵢ and σ is the motion of [`DualBlend`]. The stretch Sᵢ is the part of the matrix of
/// joint i that is not a motion. Stretches are blended linearly and applied first (UsdSkel's
/// `dualQuaternion`). [`split_palette`](super::split_palette) splits matrices into stretches and
/// motions.
///
/// A normal n becomes σ applied to cof(S)n, and a tangent t becomes σ applied to St; both are
/// normalized. cof(S) is the cofactor matrix of S.
#[derive(Clone, Copy, Debug)]
pub struct StretchedDualBlend<'a, R> {
    stretch: Linear<'a, R>,
    rigid: DualBlend<'a, R>,
}

impl<'a, R: Scalar> StretchedDualBlend<'a, R> {
    /// Makes a blend from the unit motion and the stretch of each joint. A stretch is a 3×4 matrix
    /// by rows without translation.
    #[must_use]
    pub fn new(motions: &'a [DualQuat<R>], stretches: &'a [[[R; 4]; 3]]) -> Self {
        Self { stretch: Linear::new(stretches), rigid: DualBlend::new(motions) }
    }
}

/// The map that applies a stretch first and then a motion.
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

/// Two blends A and B, mixed by a share s for each vertex: v ↦ (1 − s) A(v) + s B(v). With
/// [`Linear`](super::Linear) and [`DualBlend`](super::DualBlend) this is the usual remedy for the
/// bulge that the dual blend makes at bent joints. Normals and tangents are mixed in the same way
/// and normalized.
#[derive(Clone, Copy)]
pub struct Mixed<'a, A, B, R> {
    a: A,
    b: B,
    shares: &'a [R],
}

brief!([A: Debug, B: Debug, R] Mixed<'_, A, B, R>: Mixed |it| { a: it.a, b: it.b, vertices: it.shares.len() });

impl<'a, A, B, R: Scalar> Mixed<'a, A, B, R> {
    /// Makes a blend from `a`, `b` and, for each vertex, the share of `b`, from 0 to 1.
    ///
    /// # Errors
    /// If a share is not between 0 and 1.
    pub fn new(a: A, b: B, shares: &'a [R]) -> Result<Self, SkinningError> {
        let outside = |&share: &R| !(R::ZERO <= share && share <= R::ONE);
        match shares.iter().enumerate().find(|(_, share)| outside(share)) {
            Some((vertex, &share)) => Err(SkinningError::Share { vertex, value: share.into() }),
            None => Ok(Self { a, b, shares }),
        }
    }
}

/// The map that interpolates between the results of two maps.
#[derive(Clone, Copy, Debug)]
pub struct MixedMap<A, B, L> {
    a: A,
    b: B,
    share: L,
}

impl<A, B, L: Lanes> MixedMap<A, B, L> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn mix(&self, a: [L; 3], b: [L; 3]) -> [L; 3] {
        let mut mixed = a;
        let mut component = 0;
        while component < 3 {
            let rest = self.share.neg_mul_add(a[component], a[component]);
            mixed[component] = self.share.mul_add(b[component], rest);
            component += 1;
        }
        mixed
    }
}

impl<A: SurfaceMap<L>, B: SurfaceMap<L>, L: Lanes> SurfaceMap<L> for MixedMap<A, B, L> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn point(&self, point: [L; 3]) -> [L; 3] {
        self.mix(self.a.point(point), self.b.point(point))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn normal(&self, normal: [L; 3]) -> [L; 3] {
        unit(self.mix(self.a.normal(normal), self.b.normal(normal)))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn tangent(&self, tangent: [L; 3]) -> [L; 3] {
        unit(self.mix(self.a.tangent(tangent), self.b.tangent(tangent)))
    }
}

impl<R: Scalar, A: Blender<R>, B: Blender<R>> Blender<R> for Mixed<'_, A, B, R> {
    type Sum<L: Lanes<Real = R>> = (A::Sum<L>, B::Sum<L>);
    type Map<L: Lanes<Real = R>> = MixedMap<A::Map<L>, B::Map<L>, L>;

    const SHUFFLES: bool = A::SHUFFLES && B::SHUFFLES;

    fn check(&self, joints: usize, vertices: usize) -> Result<(), ShapeError> {
        self.a.check(joints, vertices)?;
        self.b.check(joints, vertices)?;
        same_length("shares", self.shares.len(), vertices)
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn sum<L: Lanes<Real = R>, J: Index>(
        &self,
        level: L::Level,
        scratch: &mut Scratch<'_, R, J>,
    ) -> Option<Self::Sum<L>> {
        Some((self.a.sum(level, scratch)?, self.b.sum(level, scratch)?))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn join<L: Lanes<Real = R>>(&self, x: Self::Sum<L>, y: Self::Sum<L>) -> Self::Sum<L> {
        (self.a.join(x.0, y.0), self.b.join(x.1, y.1))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn map<L: Lanes<Real = R>>(
        &self,
        level: L::Level,
        (a, b): Self::Sum<L>,
        first: usize,
    ) -> Self::Map<L> {
        let shares = self.shares.get(first..).unwrap_or_default();
        let share = L::load_partial(level, shares, R::ZERO);
        MixedMap { a: self.a.map(level, a, first), b: self.b.map(level, b, first), share }
    }
}

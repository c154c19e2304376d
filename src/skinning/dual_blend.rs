use super::blender::{Blender, SurfaceMap};
use super::skin::{GROUP, Scratch};
use crate::batch::{self, vector};
use crate::macros::brief;
use crate::number::Scalar;
use crate::scalar::DualQuat;
use crate::storage::shape::{ShapeError, same_length};
use dq8_simd::internal::Index;
use dq8_simd::{Lanes, Mask, Records};

/// Dual quaternion skinning (Kavan et al. 2008, "DLB"): v ↦ σ applied to v, where σ is the
/// normalized sum Σ ±wᵢσᵢ, with the motions σᵢ of the vertex's joints and their weights
/// wᵢ. The mesh keeps its volume where joints twist, and bulges where joints bend.
///
/// The signs are those of UsdSkel's `dualQuaternion`: σᵢ is negated if the dot product of its
/// real part and the real part of the pivot is negative. The pivot is the motion of the joint of
/// greatest weight, or of the first such joint. So the signs of the palette's entries have no
/// effect, and the mesh does not jump when a joint turns through 2π. If σᵢ is exactly half a
/// turn from the pivot, both signs are equally near. Then σᵢ and the pivot both count with the
/// sign that makes their first nonzero component of (w, x, y, z) positive.
///
/// A vertex with a single influence of weight 1 moves by exactly the motion of its joint. Normals
/// and tangents turn with σ.
#[derive(Clone, Copy)]
pub struct DualBlend<'a, R> {
    palette: &'a [DualQuat<R>],
}

brief!([R] DualBlend<'_, R>: DualBlend |it| { joints: it.palette.len() });

impl<'a, R: Scalar> DualBlend<'a, R> {
    /// Makes a blend from the unit motion of each joint, which takes the mesh at rest to the posed
    /// mesh.
    #[must_use]
    pub fn new(palette: &'a [DualQuat<R>]) -> Self {
        Self { palette }
    }

    pub(super) fn joints(&self) -> usize {
        self.palette.len()
    }
}

/// The weighted sum of the motions of some influences of a vertex, before it is normalized.
#[derive(Clone, Copy, Debug)]
pub struct DualSum<L> {
    /// The sum Σ ±wᵢσᵢ of the motions σᵢ with their weights wᵢ.
    sum: [L; 8],
    /// The sum of the weights wᵢ.
    total: L,
    /// The greatest of the weights wᵢ.
    greatest: L,
}

impl<R: Scalar> Blender<R> for DualBlend<'_, R> {
    type Sum<L: Lanes<Real = R>> = DualSum<L>;
    type Map<L: Lanes<Real = R>> = ScaledMotion<L>;

    const SHUFFLES: bool = false;

    fn check(&self, joints: usize, _: usize) -> Result<(), ShapeError> {
        same_length("motions", self.palette.len(), joints)
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn sum<L: Lanes<Real = R>, J: Index>(
        &self,
        level: L::Level,
        scratch: &mut Scratch<'_, R, J>,
    ) -> Option<DualSum<L>> {
        let motions: &[[R; 8]] = bytemuck::must_cast_slice(self.palette);
        let influences = &scratch.influences;
        let picked = influences.rows().of(motions)?;
        let weights: [L; GROUP] = L::load_four(level, influences.weights(), 0)?;
        // The real parts are loaded first, because the signs and the pivot depend on them alone.
        let mut real = [weights; GROUP];
        let mut influence = 0;
        while influence < GROUP {
            real[influence] = picked.quads(level, influence, 0);
            influence += 1;
        }
        // The pivot is the real part of the motion with the greatest weight, or of the first such
        // motion.
        let mut pivot = real[0];
        let (mut greatest, mut total) = (weights[0], weights[0]);
        influence = 1;
        while influence < GROUP {
            let weight = weights[influence];
            let greater = greatest.lt(weight);
            greatest = L::select(greater, weight, greatest);
            pivot = vector::select(greater, real[influence], pivot);
            total = total + weight;
            influence += 1;
        }
        if let Some(pivots) = &influences.pivots {
            pivot = pivots.rows().of(motions)?.quads(level, 0, 0);
        }
        let signed = toward(real, pivot, weights);
        // The weights in `signed` are already negative where a motion must be negated to lie on the
        // side of the pivot, so the sums do not need the pivot.
        let zero = total.constant(0.0);
        let mut sum = DualSum { sum: [zero; 8], total, greatest };
        influence = 0;
        while influence < GROUP {
            let mut component = 0;
            while component < 4 {
                sum.sum[component] =
                    real[influence][component].mul_add(signed[influence], sum.sum[component]);
                component += 1;
            }
            influence += 1;
        }
        influence = 0;
        while influence < GROUP {
            let dual: [L; 4] = picked.quads(level, influence, 4);
            let mut component = 0;
            while component < 4 {
                sum.sum[4 + component] =
                    dual[component].mul_add(signed[influence], sum.sum[4 + component]);
                component += 1;
            }
            influence += 1;
        }
        Some(sum)
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn join<L: Lanes<Real = R>>(&self, a: DualSum<L>, b: DualSum<L>) -> DualSum<L> {
        let mut sum = a.sum;
        for (number, other) in sum.iter_mut().zip(b.sum) {
            *number = *number + other;
        }
        let greatest = L::select(a.greatest.lt(b.greatest), b.greatest, a.greatest);
        DualSum { sum, total: a.total + b.total, greatest }
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn map<L: Lanes<Real = R>>(&self, _: L::Level, sum: DualSum<L>, _: usize) -> ScaledMotion<L> {
        let motion = batch::DualQuat::from_array(sum.sum);
        let (one, two) = (sum.total.constant(1.0), sum.total.constant(2.0));
        // A sum whose weights total 1 and whose greatest weight is 1 is a single motion, which is
        // unit. Dividing by its computed norm would only add rounding.
        let single = sum.total.eq(one) & sum.greatest.eq(one);
        let two = L::select(single, two, two / motion.real().dot(motion.real()));
        ScaledMotion { motion, two }
    }
}

/// Returns the weights, each negated if the real part of its motion points away from `pivot`.
#[cfg_attr(not(opt_level_0), inline(always))]
fn toward<L: Lanes>(real: [[L; 4]; GROUP], pivot: [L; 4], weights: [L; GROUP]) -> [L; GROUP] {
    let pivot = batch::Quat::from_array(pivot);
    let (mut dots, mut signed) = (weights, weights);
    let mut product = weights[0].constant(1.0);
    let mut influence = 0;
    while influence < GROUP {
        dots[influence] = batch::Quat::from_array(real[influence]).dot(pivot);
        product = product * dots[influence];
        signed[influence] = weights[influence].copysign(dots[influence]);
        influence += 1;
    }
    let zero = product.constant(0.0);
    // The square of the product of all dot products is zero if one of them is zero or nearly zero,
    // and NaN if a component is not finite. The comparison finds both cases, which are computed
    // again with the rule for half a turn. An absolute value in place of the square would add a
    // twentieth to the time of the whole blend on AVX2.
    if !zero.lt(product * product).all() {
        let side_of_pivot = zero.constant(1.0).copysign(leading(pivot.to_array()));
        influence = 0;
        while influence < GROUP {
            let dot = dots[influence];
            let side = leading(real[influence]) * side_of_pivot;
            let weight = L::select(side.lt(zero), -weights[influence], weights[influence]);
            // Only dot products of exactly zero take the new sign. Other lanes come here only
            // because of neighbouring lanes, on which their results must not depend.
            signed[influence] = L::select(dot.eq(zero), weight, signed[influence]);
            influence += 1;
        }
    }
    signed
}

/// Returns the first component of (w, x, y, z) that is not zero.
#[cfg_attr(not(opt_level_0), inline(always))]
fn leading<L: Lanes>([x, y, z, w]: [L; 4]) -> L {
    let mut first = z;
    for component in [y, x, w] {
        first = L::select(component.eq(component.constant(0.0)), first, component);
    }
    first
}

/// A dual quaternion of any norm, which moves a surface by the motion that its normalization gives.
/// `two` is 2/|p|², where p is the real part.
#[derive(Clone, Copy, Debug)]
pub struct ScaledMotion<L> {
    motion: batch::DualQuat<L>,
    two: L,
}

impl<L: Lanes> SurfaceMap<L> for ScaledMotion<L> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn point(&self, point: [L; 3]) -> [L; 3] {
        self.motion.transform_point_scaled(point, self.two)
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn normal(&self, normal: [L; 3]) -> [L; 3] {
        self.motion.real().rotate_scaled(normal, self.two)
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn tangent(&self, tangent: [L; 3]) -> [L; 3] {
        self.motion.real().rotate_scaled(tangent, self.two)
    }
}

use super::blender::{Blender, SurfaceMap};
use super::skin::{GROUP, Scratch};
use crate::batch::{self, vector};
use crate::macros::brief;
use crate::number::Scalar;
use crate::scalar::DualQuat;
use crate::storage::shape::{ShapeError, same_length};
use dq8_simd::internal::Index;
use dq8_simd::{Lanes, Mask, Records};

/// Dual quaternion skinning (Kavan et al. 2008, "DLB"): v ↦ σ applied to v, σ = Σ ±wᵢσᵢ
/// normalized. Twists keep their volume; bends bulge.
///
/// The signs are those of UsdSkel's `dualQuaternion`: σᵢ is negated where its real part points
/// away from that of the joint of greatest weight (the first, where several are greatest). So
/// negating an entry of the palette changes nothing, and nothing happens where a joint turns
/// through 2π. Where two are exactly half a turn apart no sign is better than the other; there the
/// one counts that makes the first component of (w, x, y, z) which is not zero positive.
///
/// A vertex of a single influence of weight 1 moves by that motion to the last bit. Normals and
/// tangents turn with σ.
#[derive(Clone, Copy)]
pub struct DualBlend<'a, R> {
    palette: &'a [DualQuat<R>],
}

brief!([R] DualBlend<'_, R>: DualBlend |it| { joints: it.palette.len() });

impl<'a, R: Scalar> DualBlend<'a, R> {
    /// Each joint's motion, from the mesh at rest to the posed mesh; unit.
    #[must_use]
    pub fn new(palette: &'a [DualQuat<R>]) -> Self {
        Self { palette }
    }

    pub(super) fn joints(&self) -> usize {
        self.palette.len()
    }
}

/// A sum of motions on its way.
#[derive(Clone, Copy, Debug)]
pub struct DualSum<L> {
    sum: [L; 8],
    /// Σ wᵢ and the greatest wᵢ.
    total: L,
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
        // Real parts alone first: signs and the pivot need no more.
        let mut real = [weights; GROUP];
        let mut influence = 0;
        while influence < GROUP {
            real[influence] = picked.quads(level, influence, 0);
            influence += 1;
        }
        // The pivot is the joint of the greatest weight, the first of several.
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
        // From here on a weight carries the sign of its motion: the dual parts need nothing else.
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
        // Nothing but one motion: it is unit, and measuring that again would only round.
        let single = sum.total.eq(one) & sum.greatest.eq(one);
        let two = L::select(single, two, two / motion.real().dot(motion.real()));
        ScaledMotion { motion, two }
    }
}

/// The weights with the signs that turn each p to the side of `pivot`.
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
    // Some are at right angles, or nearly; or there is a number so large that nobody knows. The
    // square tells both: it is not above zero. An absolute value would do, and cost a twentieth of
    // the whole blend on AVX2.
    if !zero.lt(product * product).all() {
        let side_of_pivot = zero.constant(1.0).copysign(leading(pivot.to_array()));
        influence = 0;
        while influence < GROUP {
            let dot = dots[influence];
            let side = leading(real[influence]) * side_of_pivot;
            let weight = L::select(side.lt(zero), -weights[influence], weights[influence]);
            // Only those: whether others come here depends on their neighbours.
            signed[influence] = L::select(dot.eq(zero), weight, signed[influence]);
            influence += 1;
        }
    }
    signed
}

/// The first component that is not zero.
#[cfg_attr(not(opt_level_0), inline(always))]
fn leading<L: Lanes>([x, y, z, w]: [L; 4]) -> L {
    let mut first = z;
    for component in [y, x, w] {
        first = L::select(component.eq(component.constant(0.0)), first, component);
    }
    first
}

/// σ of any norm; `two` is 2/|p|².
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

use super::blender::SurfaceMap;
use crate::batch::vector;
use dq8_simd::{Float, Lanes};

/// v ↦ Lv + t, the rows of [L | t].
#[derive(Clone, Copy, Debug)]
pub struct LinearMap<L>(pub(super) [[L; 4]; 3]);

impl<L: Lanes> SurfaceMap<L> for LinearMap<L> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn point(&self, [x, y, z]: [L; 3]) -> [L; 3] {
        let mut moved = [x; 3];
        for (moved, [a, b, c, t]) in moved.iter_mut().zip(self.0) {
            // As Linear::points does, to the last bit.
            *moved = (x * a + z * c) + (y * b + t);
        }
        moved
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn normal(&self, normal: [L; 3]) -> [L; 3] {
        unit(cofactors(self.linear(), normal))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn tangent(&self, tangent: [L; 3]) -> [L; 3] {
        unit(turned(self.linear(), tangent))
    }
}

impl<L: Lanes> LinearMap<L> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn linear(&self) -> [[L; 3]; 3] {
        let [[a, b, c, _], [d, e, f, _], [g, h, i, _]] = self.0;
        [[a, b, c], [d, e, f], [g, h, i]]
    }
}

/// Lv
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn turned<L: Lanes>(rows: [[L; 3]; 3], v: [L; 3]) -> [L; 3] {
    let [x, y, z] = rows;
    [vector::dot(x, v), vector::dot(y, v), vector::dot(z, v)]
}

/// cof(L) n: how a surface with normal n lies after L. That is det(L) L⁻ᵀn, which exists for
/// every L.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn cofactors<L: Lanes>([x, y, z]: [[L; 3]; 3], normal: [L; 3]) -> [L; 3] {
    turned([vector::cross(y, z), vector::cross(z, x), vector::cross(x, y)], normal)
}

/// v/|v|, or zero where v has no direction.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn unit<L: Lanes>(v: [L; 3]) -> [L; 3] {
    let square = vector::dot(v, v);
    let (zero, one) = (square.constant(0.0), square.constant(1.0));
    // Below the smallest normal number the quotient is not finite.
    let smallest = if L::Real::SINGLE { f32::MIN_POSITIVE.into() } else { f64::MIN_POSITIVE };
    let none = square.lt(square.constant(smallest));
    let factor = L::select(none, zero, one / L::select(none, one, square).sqrt());
    vector::scale(v, factor)
}

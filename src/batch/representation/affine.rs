use super::Polar;
use crate::batch::{DualQuat, vector};
use crate::geometry::Plane;
use core::ops::Mul;
use dq8_simd::Lanes;

/// Linear maps and translations, v ↦ Lv + t: [`Affine`](crate::representation::Affine) on lanes.
#[derive(Clone, Copy, Debug)]
pub struct Affine<L> {
    /// L, rows.
    pub linear: [[L; 3]; 3],
    /// t
    pub translation: [L; 3],
}

impl<L: Lanes> Affine<L> {
    /// The map that leaves every point where it is, in every lane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn identity(level: L::Level) -> Self {
        Self::uniform_scale(L::splat(level, L::Real::from(1.0)))
    }

    /// Rigid motions; σ must be unit.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn from_motion(motion: DualQuat<L>) -> Self {
        Self { linear: motion.rotation().to_matrix3(), translation: motion.translation() }
    }

    /// From the rows of [L | t].
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn from_matrix3x4([[a, b, c, x], [d, e, f, y], [g, h, i, z]]: [[L; 4]; 3]) -> Self {
        Self { linear: [[a, b, c], [d, e, f], [g, h, i]], translation: [x, y, z] }
    }

    /// The rows of [L | t].
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn to_matrix3x4(self) -> [[L; 4]; 3] {
        let ([[a, b, c], [d, e, f], [g, h, i]], [x, y, z]) = (self.linear, self.translation);
        [[a, b, c, x], [d, e, f, y], [g, h, i, z]]
    }

    /// v ↦ βv
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn uniform_scale(factor: L) -> Self {
        Self::scale([factor; 3])
    }

    /// v ↦ (β_x x, β_y y, β_z z)
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn scale([x, y, z]: [L; 3]) -> Self {
        let zero = x.constant(0.0);
        let linear = [[x, zero, zero], [zero, y, zero], [zero, zero, z]];
        Self { linear, translation: [zero; 3] }
    }

    /// v ↦ v + (n·v)s
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn shear(slide: [L; 3], normal: [L; 3]) -> Self {
        let mut shear = Self::uniform_scale(slide[0].constant(1.0));
        for (row, slide) in shear.linear.iter_mut().zip(slide) {
            *row = vector::scale_onto(normal, slide, *row);
        }
        shear
    }

    /// v ↦ v − 2(n·v − d)n, the mirror images in planes n·v = d, whose normals must have length 1.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn reflection(plane: Plane<L>) -> Self {
        let twice = vector::scale(plane.normal, plane.offset.constant(2.0));
        let flip = Self::shear([-twice[0], -twice[1], -twice[2]], plane.normal);
        Self { translation: vector::scale(twice, plane.offset), ..flip }
    }

    /// The points Lv + t.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn transform_point(self, point: [L; 3]) -> [L; 3] {
        vector::add(self.transform_vector(point), self.translation)
    }

    /// The directions Lv. Normals of surfaces do not move so, unless L is a rotation.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn transform_vector(self, vector: [L; 3]) -> [L; 3] {
        let [a, b, c] = self.linear;
        [vector::dot(a, vector), vector::dot(b, vector), vector::dot(c, vector)]
    }

    /// σ and S with Lv + t = σ applied to Sv, by the polar decomposition of L, and the lanes without them: an
    /// element is not finite, or L squeezes space into a line or a point. Those are NaN.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn decompose_checked(self) -> (DualQuat<L>, [[L; 3]; 3], L::Mask) {
        let (Polar { rotation, stretch, .. }, failed) = Polar::from_matrix3_checked(self.linear);
        let failed = failed | !vector::are_finite(self.translation);
        let motion = DualQuat::from_rotation_translation(rotation, self.translation);
        let nan = rotation.w().constant(f64::NAN);
        let motion = vector::select(failed, [nan; 8], motion.to_array());
        (DualQuat::from_array(motion), super::without(failed, stretch), failed)
    }
}

/// `other`, then `self`.
impl<L: Lanes> Mul for Affine<L> {
    type Output = Self;
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn mul(self, other: Self) -> Self {
        let [a, b, c] = other.linear;
        let x = self.transform_vector([a[0], b[0], c[0]]);
        let y = self.transform_vector([a[1], b[1], c[1]]);
        let z = self.transform_vector([a[2], b[2], c[2]]);
        Self {
            linear: [[x[0], y[0], z[0]], [x[1], y[1], z[1]], [x[2], y[2], z[2]]],
            translation: self.transform_point(other.translation),
        }
    }
}

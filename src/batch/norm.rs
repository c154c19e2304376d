//! Norms, normalization and inverses.

use super::{Dual, DualQuat, Quat, vector};
use dq8_simd::Lanes;

impl<L: Lanes> Quat<L> {
    /// Returns q*/|q|². Some component is NaN or infinite in lanes where q is zero or not finite.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn inverse(self) -> Self {
        let length = self.length();
        Self::from_array(length.divide_all(length.divide_all(self.conjugate().to_array())))
    }

    /// Returns q/|q|, and the mask of the lanes that cannot be normalized: q is zero, or a
    /// component of q or its length is not finite. In these lanes the result is NaN.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn normalize_checked(self) -> (Self, L::Mask) {
        let length = self.length();
        let (value, unit) = (length.value(), length.divide_all(self.to_array()));
        let zero = value.constant(0.0);
        let failed = !(zero.lt(value) & vector::is_finite(value));
        let nan = [zero.constant(f64::NAN); 4];
        (Self::from_array(vector::select(failed, nan, unit)), failed)
    }

    /// Returns `true` in the lanes where ||q| − 1| ≤ `tolerance`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn is_unit(self, tolerance: L) -> L::Mask {
        (self.norm() - tolerance.constant(1.0)).abs().le(tolerance)
    }

    /// Returns [`is_unit`](Self::is_unit) with a tolerance of 32 units of the last place.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn is_normalized(self) -> L::Mask {
        self.is_unit(self.w().constant(32.0 * vector::epsilon::<L>()))
    }
}

impl<L: Lanes> DualQuat<L> {
    /// Returns the dual norm √(σσ*) = |p| + ε (p·q)/|p|. Its dual part is NaN where p = 0.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn norm(self) -> Dual<L> {
        let length = self.real().length();
        let unit = Quat::from_array(length.divide_all(self.real().to_array()));
        Dual::new(length.value(), unit.dot(self.dual()))
    }

    /// Returns σ divided by its dual norm: the real part gets unit length, and the dual part
    /// becomes orthogonal to the real part. Some component is NaN where
    /// [`normalize_checked`](Self::normalize_checked) fails.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn normalize(self) -> Self {
        let length = self.real().length();
        let p = Quat::from_array(length.divide_all(self.real().to_array()));
        let q = Quat::from_array(length.divide_all(self.dual().to_array()));
        Self::new(p, p.scale_onto(-p.dot(q), q))
    }

    /// Returns σ divided by its dual norm, and the mask of the lanes that cannot be normalized: p
    /// is zero, or a component of σ or of the result is not finite. In these lanes every component
    /// is NaN.
    ///
    /// ```
    /// use dq8::{batch::DualQuat, simd::{Mask, Portable, f32x4}};
    /// let poses = [[0.0, 0.0, 0.0, 2.0, 6.0, 0.0, 0.0, 4.0], [0.0; 8]];
    /// let (unit, failed) = DualQuat::<f32x4>::load_records(Portable, &poses).normalize_checked();
    /// assert_eq!(failed.to_bitmask(), 0b0010);
    /// let mut back = [[9.0; 8]];
    /// unit.store_records(&mut back);
    /// assert_eq!(back, [[0.0, 0.0, 0.0, 1.0, 3.0, 0.0, 0.0, 0.0]]);
    /// ```
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn normalize_checked(self) -> (Self, L::Mask) {
        self.normalize().checked()
    }

    /// Returns `true` in the lanes where ||p| − 1| ≤ `tolerance` and |p·q| ≤
    /// `tolerance`·max(1, |q|) < ∞.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn is_unit(self, tolerance: L) -> L::Mask {
        let one = tolerance.constant(1.0);
        let off = (self.real().norm() - one).abs();
        let along = self.real().dot(self.dual()).abs();
        let size = self.dual().norm();
        let scale = L::select(size.lt(one), one, size);
        off.le(tolerance) & along.le(tolerance * scale) & scale.lt(one.constant(f64::INFINITY))
    }

    /// Returns [`is_unit`](Self::is_unit) with a tolerance of 32 units of the last place.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn is_normalized(self) -> L::Mask {
        self.is_unit(self.real().w().constant(32.0 * vector::epsilon::<L>()))
    }

    /// Returns σ⁻¹ of any σ with p ≠ 0. Some component is NaN or infinite where
    /// [`inverse_checked`](Self::inverse_checked) fails.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn inverse(self) -> Self {
        let length = self.real().length();
        let unit = Quat::from_array(length.divide_all(self.real().to_array())).conjugate();
        let q = Quat::from_array(length.divide_all(self.dual().to_array()));
        let dual = (unit * q * unit).to_array();
        Self::new(
            Quat::from_array(length.divide_all(unit.to_array())),
            -Quat::from_array(length.divide_all(dual)),
        )
    }

    /// Returns σ⁻¹ = p⁻¹ − ε p⁻¹qp⁻¹, and the mask of the lanes without an inverse:
    /// p is zero, or a component of σ or of the result is not finite. In these lanes every
    /// component is NaN.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn inverse_checked(self) -> (Self, L::Mask) {
        self.inverse().checked()
    }

    /// Fills each lane in which a component is not finite with NaN, and returns the mask of these
    /// lanes.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn checked(self) -> (Self, L::Mask) {
        let components = self.to_array();
        let finite = vector::are_finite(components);
        let nan = [components[0].constant(f64::NAN); 8];
        (Self::from_array(vector::select(finite, components, nan)), !finite)
    }
}

//! Norm, normalization and inverses.

use super::error::{InverseError, NormalizeError, Normed};
use super::{Dual, DualQuat, Quat, vector};
use crate::number::Real;
use crate::quick;

impl<R: Real> Quat<R> {
    /// Returns q⁻¹ = q*/|q|² of any q ≠ 0, unit or not. Every component is NaN if q is zero
    /// or not finite. For a unit q, [`conjugate`](Self::conjugate) gives the same result and is
    /// cheaper.
    ///
    /// ```
    /// use dq8::Quat;
    /// let inverse = Quat::from_xyzw(0.0_f32, 0.0, 2.0, 0.0).inverse();
    /// assert_eq!(inverse.to_array(), [0.0, 0.0, -0.5, 0.0]);
    /// ```
    #[inline]
    #[doc(alias("inv"))]
    pub fn inverse(self) -> Self {
        let unit = self.normalize().conjugate();
        Self::from_array(vector::over_norm(unit.to_array(), self.norm()))
    }

    /// Returns `true` if ||q| − 1| ≤ `tolerance`, and `false` if a component is not finite.
    #[inline]
    #[must_use]
    pub fn is_unit(self, tolerance: R) -> bool {
        (self.norm() - R::ONE).abs() <= tolerance
    }

    /// Returns [`is_unit`](Self::is_unit) with a tolerance of 32 units of the last place. A unit
    /// quaternion stays within this tolerance for a few products.
    #[inline]
    #[must_use]
    pub fn is_normalized(self) -> bool {
        self.is_unit(R::EPSILON * R::from(32.0))
    }
}

impl<R: Real> DualQuat<R> {
    /// Returns the norm as a dual number, √(σσ*) = |p| + ε (p·q)/|p| (Jia eq. 18, Fabisch
    /// "Norm of a Dual Quaternion"). For p = 0 the norm does not exist: its dual part is NaN.
    ///
    /// ```
    /// use dq8::{Dual, DualQuat};
    /// let sigma = DualQuat::from_wxyz([3.0_f32, 4.0, 0.0, 0.0, 5.0, 0.0, 0.0, 0.0]);
    /// assert_eq!(sigma.norm(), Dual::new(5.0, 3.0));
    /// ```
    #[inline]
    pub fn norm(self) -> Dual<R> {
        let norm = self.real().norm();
        // p/|p| is computed before the scalar product, because p·q may overflow although
        // (p·q)/|p| does not.
        Dual::new(norm, self.real().normalize().dot(self.dual()))
    }

    /// Exact normalization, σ/√(σσ*): it makes |p| = 1 *and* q orthogonal to p. Every
    /// component is NaN where [`try_normalize`](Self::try_normalize) fails.
    #[inline]
    #[must_use]
    pub fn normalize(self) -> Self {
        if let Some(unit) = R::quick(quick::Unit(self.to_array())) {
            return Self::from_array(unit);
        }
        self.spilled_copy().unit_of_any_size().unwrap_or(Self::nan()).spilled_copy()
    }

    /// Exact normalization in Fabisch's two steps: σ is divided by |p|, then the part of q along p
    /// is removed. The division alone could leave a q that belongs to no translation.
    ///
    /// # Errors
    /// If p is zero, or a component of σ or of the result is not finite.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// let sigma = DualQuat::from_wxyz([2.0_f32, 0.0, 0.0, 0.0, 7.0, 0.0, 0.0, 5.0]);
    /// let unit = sigma.try_normalize()?;
    /// assert_eq!(unit.to_wxyz(), [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 2.5]);
    /// assert!(DualQuat::<f32>::ZERO.try_normalize().is_err());
    /// # Ok::<(), dq8::scalar::NormalizeError>(())
    /// ```
    #[inline]
    pub fn try_normalize(self) -> Result<Self, NormalizeError> {
        self.unit()
            .map_err(|norm| NormalizeError { real_norm: norm.into(), of: Normed::DualQuaternion })
    }

    /// Returns the unit motion, or the norm of the real part as an error if σ cannot be
    /// normalized. The caller converts this norm to the `f64` of an error, because the conversion
    /// costs a library call on targets without double precision.
    #[inline]
    fn unit(self) -> Result<Self, R> {
        if let Some(unit) = R::quick(quick::Unit(self.to_array())) {
            let failed = unit[0].is_nan();
            return if failed { Err(self.real().norm()) } else { Ok(Self::from_array(unit)) };
        }
        self.spilled_copy().unit_of_any_size()
    }

    /// Normalizes a motion of any size by the textbook formulas. The function is not inlined,
    /// because `f32` and `f64` never need it: they use the quicker form.
    #[inline(never)]
    fn unit_of_any_size(self) -> Result<Self, R> {
        let norm = self.real().norm();
        let p = self.real().unit()?;
        let (q, length) = match vector::stretch(norm) {
            Some(stretch) => (self.dual().scale(stretch), self.real().scale(stretch).norm()),
            None => (self.dual(), norm),
        };
        let q = Quat::from_array(vector::over_norm(q.to_array(), length));
        let unit = Self::new(p, q - p.scale(p.dot(q)));
        if unit.to_array().iter().all(|c| c.is_finite()) { Ok(unit) } else { Err(norm) }
    }

    /// Returns `true` if σσ* = 1 within `tolerance`: ||p| − 1| ≤ tolerance and |p·q| ≤
    /// tolerance·max(1, |q|) (Jia eqs. 20 and 21; the second bound grows with the translation). It
    /// returns `false` if a component is not finite.
    #[inline]
    #[must_use]
    pub fn is_unit(self, tolerance: R) -> bool {
        let off = (self.real().norm() - R::ONE).abs();
        let along = self.real().dot(self.dual()).abs();
        let size = self.dual().norm().max_or_nan(R::ONE);
        off <= tolerance && along <= tolerance * size && size.is_finite()
    }

    /// Returns [`is_unit`](Self::is_unit) with a tolerance of 32 units of the last place. A unit
    /// motion stays within this tolerance for a few products.
    #[inline]
    #[must_use]
    pub fn is_normalized(self) -> bool {
        self.is_unit(R::EPSILON * R::from(32.0))
    }

    /// Returns σ⁻¹ of any σ with p ≠ 0, unit or not. Every component is NaN where
    /// [`try_inverse`](Self::try_inverse) fails. For a unit σ, [`conjugate`](Self::conjugate)
    /// gives the same result and is cheaper.
    #[inline]
    #[must_use]
    #[doc(alias("inv"))]
    pub fn inverse(self) -> Self {
        if let Some(inverse) = R::quick(quick::Inverse(self.to_array())) {
            return Self::from_array(inverse);
        }
        self.spilled_copy().reciprocal_of_any_size().unwrap_or(Self::nan()).spilled_copy()
    }

    /// Returns σ⁻¹ = p⁻¹ − ε p⁻¹qp⁻¹ (Jia §4), where p⁻¹ = p*/|p|².
    ///
    /// # Errors
    /// If p is zero, or a component of σ or of the result is not finite.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// let sigma = DualQuat::from_wxyz([2.0_f32, 0.0, 0.0, 0.0, 4.0, 0.0, 8.0, 0.0]);
    /// assert_eq!(sigma * sigma.try_inverse()?, DualQuat::IDENTITY);
    /// # Ok::<(), dq8::scalar::InverseError>(())
    /// ```
    #[inline]
    pub fn try_inverse(self) -> Result<Self, InverseError> {
        self.reciprocal()
            .map_err(|norm| InverseError { real_norm: norm.into(), of: Normed::DualQuaternion })
    }

    /// Returns the inverse, or the norm of the real part as an error if there is no inverse.
    #[inline]
    fn reciprocal(self) -> Result<Self, R> {
        if let Some(inverse) = R::quick(quick::Inverse(self.to_array())) {
            let failed = inverse[0].is_nan();
            return if failed { Err(self.real().norm()) } else { Ok(Self::from_array(inverse)) };
        }
        self.spilled_copy().reciprocal_of_any_size()
    }

    #[inline(never)]
    fn reciprocal_of_any_size(self) -> Result<Self, R> {
        let norm = self.real().norm();
        let unit = self.real().unit()?.conjugate();
        let over_norm = |q: Quat<R>| Quat::from_array(vector::over_norm(q.to_array(), norm));
        let real = over_norm(unit);
        let dual = over_norm(unit * over_norm(self.dual()) * unit);
        let inverse = Self::new(real, -dual);
        if inverse.to_array().iter().all(|c| c.is_finite()) { Ok(inverse) } else { Err(norm) }
    }
}

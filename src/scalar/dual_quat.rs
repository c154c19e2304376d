use super::{Dual, Quat};
use crate::contract::sums_by_part;
use crate::geometry::DualVector;
use crate::number::Real;
use crate::quick;
use core::ops::Mul;

crate::macros::pod! {
    /// A dual quaternion σ = p + εq, in memory `[px, py, pz, pw, qx, qy, qz, qw]`.
    ///
    /// A *unit* σ (|p| = 1, p·q = 0) is a rigid motion: it rotates by p, then translates by t =
    /// 2qp*. The conventions and laws are those of [`Motion`](crate::Motion). Operations do not
    /// check that σ is unit, except for debug builds with `--cfg dq8_debug_assert_unit`, [which
    /// panic](crate::Motion#where-unit-length-is-a-precondition).
    ///
    /// ```
    /// use dq8::{DualQuat, Quat};
    /// // Jia, example 1: a third of a turn about (1,1,1), then up by 5.
    /// let r = Quat::from_xyzw(0.5_f32, 0.5, 0.5, 0.5);
    /// let motion = DualQuat::from_rotation_translation(r, [0.0, 0.0, 5.0]);
    /// assert_eq!(motion.transform_point([2.0, 0.0, 0.0]), [0.0, 2.0, 5.0]);
    /// ```
    #[derive(Clone, Copy, Debug, PartialEq)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
    #[cfg_attr(feature = "rkyv_08", derive(rkyv::Archive, rkyv::Serialize, rkyv::Deserialize))]
    #[cfg_attr(feature = "serde", serde(transparent))]
    #[doc(alias("transform", "pose", "isometry", "se3", "rigid_transform", "screw_motion"))]
    pub struct DualQuat<R>([R; 8]);
}

/// The identity motion.
impl<R: Real> Default for DualQuat<R> {
    #[inline]
    fn default() -> Self {
        Self::IDENTITY
    }
}

impl<R: Real> DualQuat<R> {
    /// The identity motion 1, which moves nothing.
    pub const IDENTITY: Self = Self::new(Quat::IDENTITY, Quat::ZERO);
    /// 0, the neutral element of addition. It is not a motion.
    pub const ZERO: Self = Self([R::ZERO; 8]);
    /// Returns NaN in every component. This is the result of an unchecked operation if the checked
    /// operation would return an error.
    #[inline]
    pub(super) fn nan() -> Self {
        Self([R::NAN; 8])
    }

    /// Returns a copy in memory. A function that is not inlined takes and returns motions in
    /// memory. If it gets this copy, the compiler can keep the original in registers
    /// (`docs/measured.md`, *What keeps loops in registers*).
    #[inline(always)]
    pub(super) fn spilled_copy(self) -> Self {
        let [px, py, pz, pw, qx, qy, qz, qw] = self.0;
        Self([px, py, pz, pw, qx, qy, qz, qw])
    }

    /// p + εq
    #[inline]
    #[must_use]
    pub const fn new(real: Quat<R>, dual: Quat<R>) -> Self {
        let [px, py, pz, pw] = real.to_array();
        let [qx, qy, qz, qw] = dual.to_array();
        Self([px, py, pz, pw, qx, qy, qz, qw])
    }

    /// Makes σ from `[px, py, pz, pw, qx, qy, qz, qw]`, the order of memory.
    #[inline]
    #[must_use]
    pub const fn from_array(components: [R; 8]) -> Self {
        Self(components)
    }

    /// Makes σ from `[pw, px, py, pz, qw, qx, qy, qz]`, the order of the literature.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// let up = DualQuat::from_wxyz([1.0_f32, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 2.5]);
    /// assert_eq!(up.translation(), [0.0, 0.0, 5.0]);
    /// ```
    #[inline]
    #[must_use]
    pub const fn from_wxyz([pw, px, py, pz, qw, qx, qy, qz]: [R; 8]) -> Self {
        Self([px, py, pz, pw, qx, qy, qz, qw])
    }

    /// Makes σ from its scalar part, a dual number, and its vector part, a dual vector (Jia eq.
    /// 15).
    #[inline]
    #[must_use]
    pub const fn from_dual_parts(scalar: Dual<R>, vector: DualVector<R>) -> Self {
        Self::new(
            Quat::from_parts(vector.real, scalar.real),
            Quat::from_parts(vector.dual, scalar.dual),
        )
    }

    /// Returns `[px, py, pz, pw, qx, qy, qz, qw]`, the order of memory.
    #[inline]
    #[must_use]
    pub const fn to_array(self) -> [R; 8] {
        self.0
    }

    /// Returns `[pw, px, py, pz, qw, qx, qy, qz]`, the order of the literature.
    #[inline]
    #[must_use]
    pub const fn to_wxyz(self) -> [R; 8] {
        let [px, py, pz, pw, qx, qy, qz, qw] = self.0;
        [pw, px, py, pz, qw, qx, qy, qz]
    }

    /// p, the real part.
    #[inline]
    pub const fn real(self) -> Quat<R> {
        let [x, y, z, w, ..] = self.0;
        Quat::from_xyzw(x, y, z, w)
    }

    /// q, the dual part.
    #[inline]
    pub const fn dual(self) -> Quat<R> {
        let [.., x, y, z, w] = self.0;
        Quat::from_xyzw(x, y, z, w)
    }

    /// Returns the scalar part of σ, the dual number p_w + εq_w (Jia eq. 15).
    #[inline]
    pub const fn dual_scalar(self) -> Dual<R> {
        Dual::new(self.real().w(), self.dual().w())
    }

    /// Returns the vector part of σ, a dual vector (Jia eq. 15).
    #[inline]
    pub const fn dual_vector(self) -> DualVector<R> {
        DualVector { real: self.real().xyz(), dual: self.dual().xyz() }
    }

    /// σ• = p − εq (Jia eq. 16).
    #[inline]
    #[must_use]
    pub fn conjugate_dual(self) -> Self {
        Self::new(self.real(), -self.dual())
    }

    /// σ* = p* + εq* (Jia eq. 17), the inverse of a unit σ.
    ///
    /// ```
    /// use dq8::{DualQuat, Quat};
    /// let r = Quat::from_xyzw(0.5_f32, 0.5, 0.5, 0.5);
    /// let motion = DualQuat::from_rotation_translation(r, [1.0, 2.0, 3.0]);
    /// assert_eq!(motion * motion.conjugate(), DualQuat::IDENTITY);
    /// ```
    #[inline]
    #[must_use]
    #[doc(alias("quaternion_conjugate"))]
    pub fn conjugate(self) -> Self {
        Self::new(self.real().conjugate(), self.dual().conjugate())
    }

    /// σ⋄ = p* − εq* (Jia eq. 19), the conjugate that moves points by σ(1 + εv)σ⋄.
    #[inline]
    #[must_use]
    pub fn conjugate_both(self) -> Self {
        Self::new(self.real().conjugate(), -self.dual().conjugate())
    }

    /// Returns sσ for the real number s = `factor` (Kenwright §7.1).
    #[inline]
    #[must_use]
    pub fn scale(self, factor: R) -> Self {
        Self::new(self.real().scale(factor), self.dual().scale(factor))
    }

    /// (a + εb)σ = ap + ε(aq + bp) for a dual number a + εb (Jia eq. 14, with a dual number as
    /// one factor).
    #[inline]
    #[must_use]
    pub fn scale_dual(self, factor: Dual<R>) -> Self {
        Self::new(
            self.real().scale(factor.real),
            self.dual().scale(factor.real) + self.real().scale(factor.dual),
        )
    }

    /// Returns the dual number ⟨a, b⟩ = p_a·p_b + ε(p_a·q_b + q_a·p_b), the scalar part of
    /// ab* ([`dual_scalar`](Self::dual_scalar)). Its real part p_a·p_b is Kenwright's `Dot`
    /// (§13.1). For unit motions it is the cosine of half the dual angle between them.
    #[inline]
    pub fn dot(self, other: Self) -> Dual<R> {
        Dual::new(
            self.real().dot(other.real()),
            self.real().dot(other.dual()) + self.dual().dot(other.real()),
        )
    }

    /// Returns `true` if every component of `self` differs from the same component of `other` by at
    /// most `tolerance`, |a_c − b_c| ≤ tolerance, and `false` for NaN. σ and −σ are the
    /// same motion but not equal here: see [`canonical`](Self::canonical).
    #[inline]
    #[must_use]
    pub fn abs_diff_eq(self, other: Self, tolerance: R) -> bool {
        let pairs = self.0.into_iter().zip(other.0);
        pairs.into_iter().all(|(a, b)| (a - b).abs() <= tolerance)
    }

    /// `true` if every component is finite.
    #[inline]
    #[must_use]
    pub fn is_finite(self) -> bool {
        self.0.into_iter().all(Real::is_finite)
    }

    /// Converts the components to another element type, for example from `f32` to `f64` or back.
    /// Each component is rounded to the nearest value.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// let near: DualQuat<f32> = DualQuat::from_translation([1.0_f64, 2.0, 3.0]).cast();
    /// assert_eq!(near.translation(), [1.0, 2.0, 3.0]);
    /// ```
    #[inline]
    #[must_use]
    pub fn cast<S: Real>(self) -> DualQuat<S> {
        DualQuat(self.0.map(|component| S::from_f64(component.into())))
    }

    /// Returns σ or −σ, which are the same motion: the sign for which the first component of
    /// (p_w, p_x, p_y, p_z) that is not zero is positive. With this choice, half a turn has the
    /// same axis for either sign, and logarithms, powers and screws of σ and −σ agree to the
    /// last bit. SciPy's `as_quat(canonical=True)` has the same rule.
    #[inline]
    #[must_use]
    pub fn canonical(self) -> Self {
        if self.real().points_back() { -self } else { self }
    }
}

/// Borrows the components as `[px, py, pz, pw, qx, qy, qz, qw]`.
impl<R> AsRef<[R; 8]> for DualQuat<R> {
    #[inline]
    fn as_ref(&self) -> &[R; 8] {
        &self.0
    }
}

impl<R> AsMut<[R; 8]> for DualQuat<R> {
    #[inline]
    fn as_mut(&mut self) -> &mut [R; 8] {
        &mut self.0
    }
}

sums_by_part! {
    /// Operates component by component (Jia eq. 13).
    [R: Real] #[inline] DualQuat<R>: (real()) (dual())
}

/// Returns σ₁σ₂ = p₁p₂ + ε(p₁q₂ + q₁p₂) (Jia eq. 14): the motion σ₂ acts
/// first, then the motion σ₁.
///
/// The product takes three quaternion products and a sum: 48 multiplications and 40 additions.
impl<R: Real> Mul for DualQuat<R> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        if let Some(product) = R::quick(quick::Product(self.0, other.0)) {
            return Self(product);
        }
        Self::new(
            self.real() * other.real(),
            self.real() * other.dual() + self.dual() * other.real(),
        )
    }
}

use super::error::{NormalizeError, Normed};
use super::vector::{self, Length};
use crate::number::Real;
use crate::quick;
use core::ops::{Add, Mul, Neg, Sub};

crate::macros::pod! {
    /// A quaternion w + xi + yj + zk (Hamilton 1844), in memory `[x, y, z, w]`.
    ///
    /// A unit quaternion cos(θ/2) + n sin(θ/2) turns by θ about the unit axis n. Operations do
    /// not check that a quaternion is unit, except for debug builds with
    /// `--cfg dq8_debug_assert_unit`, [which
    /// panic](crate::Motion#where-unit-length-is-a-precondition).
    ///
    /// ```
    /// use dq8::Quat;
    /// let quarter = Quat::from_axis_angle([0.0, 0.0, 1.0], core::f64::consts::FRAC_PI_2);
    /// let [x, y, z] = quarter.rotate([1.0, 0.0, 0.0]);
    /// assert!((x.abs() + (y - 1.0).abs() + z.abs()) < 1e-15);
    /// ```
    #[derive(Clone, Copy, Debug, PartialEq)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
    #[cfg_attr(feature = "rkyv_08", derive(rkyv::Archive, rkyv::Serialize, rkyv::Deserialize))]
    #[cfg_attr(feature = "serde", serde(transparent))]
    #[must_use]
    #[doc(alias("quaternion", "rotation", "unit_quaternion", "so3"))]
    pub struct Quat<R>([R; 4]);
}

/// Returns the identity. If the default were zero, a rest pose of default values would collapse to
/// a point without an error.
impl<R: Real> Default for Quat<R> {
    #[inline]
    fn default() -> Self {
        Self::IDENTITY
    }
}

impl<R: Real> Quat<R> {
    /// The identity rotation 1, which turns nothing.
    pub const IDENTITY: Self = Self([R::ZERO, R::ZERO, R::ZERO, R::ONE]);
    /// The quaternion 0, which is not a rotation.
    pub const ZERO: Self = Self([R::ZERO; 4]);

    /// Makes a quaternion from components in the order of memory.
    #[inline]
    pub const fn from_xyzw(x: R, y: R, z: R, w: R) -> Self {
        Self([x, y, z, w])
    }

    /// Makes a quaternion from `[w, x, y, z]`, the order of the literature.
    #[inline]
    #[doc(alias("scalar_first"))]
    pub const fn from_wxyz([w, x, y, z]: [R; 4]) -> Self {
        Self([x, y, z, w])
    }

    /// Makes a quaternion from `[x, y, z, w]`, the order of memory.
    #[inline]
    pub const fn from_array(xyzw: [R; 4]) -> Self {
        Self(xyzw)
    }

    /// Makes a quaternion from its vector part and its scalar part.
    #[inline]
    pub const fn from_parts([x, y, z]: [R; 3], w: R) -> Self {
        Self([x, y, z, w])
    }

    /// The turn by `angle` radians about `axis`, which must have length 1:
    /// cos(θ/2) + n sin(θ/2) (Jia eq. 3).
    #[inline]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn from_axis_angle(axis: [R; 3], angle: R) -> Self {
        crate::scalar::must_be_unit::axis("Quat::from_axis_angle", axis);
        let half = angle * R::HALF;
        Self::from_parts(vector::scale(axis, half.sin()), half.cos())
    }

    /// Returns a copy in memory. If a function that is not inlined gets this copy, the compiler can
    /// keep the original in registers.
    #[inline(always)]
    pub(super) fn spilled_copy(self) -> Self {
        let [x, y, z, w] = self.0;
        Self([x, y, z, w])
    }

    /// Returns `[x, y, z, w]`, the order of memory.
    #[inline]
    #[must_use]
    pub const fn to_array(self) -> [R; 4] {
        self.0
    }

    /// Returns `[w, x, y, z]`, the order of the literature.
    #[inline]
    #[must_use]
    pub const fn to_wxyz(self) -> [R; 4] {
        let [x, y, z, w] = self.0;
        [w, x, y, z]
    }

    /// The component of i.
    #[inline]
    #[must_use]
    pub const fn x(self) -> R {
        self.0[0]
    }
    /// The component of j.
    #[inline]
    #[must_use]
    pub const fn y(self) -> R {
        self.0[1]
    }
    /// The component of k.
    #[inline]
    #[must_use]
    pub const fn z(self) -> R {
        self.0[2]
    }
    /// The scalar part.
    #[inline]
    #[must_use]
    pub const fn w(self) -> R {
        self.0[3]
    }
    /// The vector part.
    #[inline]
    #[must_use]
    pub const fn xyz(self) -> [R; 3] {
        [self.0[0], self.0[1], self.0[2]]
    }

    /// Returns `true` if −q, and not q, has the [canonical](crate::DualQuat::canonical) sign.
    #[inline]
    pub(crate) fn points_back(self) -> bool {
        let [x, y, z, w] = self.0;
        [w, x, y].into_iter().find(|&it| it != R::ZERO).unwrap_or(z) < R::ZERO
    }

    /// q* = w − xi − yj − zk, the inverse of a unit quaternion (Hamilton 1844).
    #[inline]
    pub fn conjugate(self) -> Self {
        let [x, y, z, w] = self.0;
        Self([-x, -y, -z, w])
    }

    /// The scalar product of two quaternions as 4-vectors, the sum of xx′, yy′, zz′ and
    /// ww′.
    #[inline]
    #[must_use]
    pub fn dot(self, other: Self) -> R {
        let [ax, ay, az, aw] = self.0;
        let [bx, by, bz, bw] = other.0;
        ax * bx + ay * by + az * bz + aw * bw
    }

    /// Returns |q| = √(q q*), without overflow or underflow of intermediate results.
    #[inline]
    #[must_use]
    #[doc(alias("length", "magnitude"))]
    pub fn norm(self) -> R {
        vector::norm(self.0)
    }

    /// `true` if every component is finite.
    #[inline]
    #[must_use]
    pub fn is_finite(self) -> bool {
        self.0.into_iter().all(Real::is_finite)
    }

    /// Converts the components to another element type, for example from `f32` to `f64` or back.
    /// Each component is rounded to the nearest value.
    #[inline]
    pub fn cast<S: Real>(self) -> Quat<S> {
        Quat(self.0.map(|component| S::from_f64(component.into())))
    }

    /// Returns `true` if every component of `self` differs from the same component of `other` by at
    /// most `tolerance`, and `false` for NaN. q and −q are the same rotation but not equal here.
    #[inline]
    #[must_use]
    pub fn abs_diff_eq(self, other: Self, tolerance: R) -> bool {
        self.0.into_iter().zip(other.0).all(|(a, b)| (a - b).abs() <= tolerance)
    }

    /// Returns q times a real number.
    #[inline]
    pub fn scale(self, factor: R) -> Self {
        let [x, y, z, w] = self.0;
        Self([x * factor, y * factor, z * factor, w * factor])
    }

    /// Returns q / |q|. Every component is NaN where [`try_normalize`](Self::try_normalize) fails.
    #[inline]
    pub fn normalize(self) -> Self {
        self.unit().unwrap_or(Self([R::NAN; 4]))
    }

    /// Returns q / |q|.
    ///
    /// # Errors
    /// If q is zero or not finite.
    ///
    /// ```
    /// use dq8::Quat;
    /// assert_eq!(Quat::from_xyzw(0.0, 3e-40_f32, 0.0, 4e-40).norm(), 5e-40);
    /// assert!(Quat::<f32>::ZERO.try_normalize().is_err());
    /// ```
    #[inline]
    pub fn try_normalize(self) -> Result<Self, NormalizeError> {
        self.unit()
            .map_err(|norm| NormalizeError { real_norm: norm.into(), of: Normed::Quaternion })
    }

    /// Returns q / |q|, or |q| as an error if q cannot be normalized.
    #[inline]
    pub(super) fn unit(self) -> Result<Self, R> {
        if let Some(unit) = R::quick(quick::QuaternionUnit(self.0)) {
            return Ok(Self(unit));
        }
        self.spilled_copy().unit_of_any_size()
    }

    #[inline(never)]
    fn unit_of_any_size(self) -> Result<Self, R> {
        let norm = self.norm();
        if norm == R::ZERO || !self.0.iter().all(|c| c.is_finite()) {
            return Err(norm);
        }
        Ok(Self(Length::of(self.0, norm).divide(self.0)))
    }

    /// Returns r v r*, the vector `v` turned by this unit quaternion r (Arends ch. 3 eqs. 8–10,
    /// Jia §2). It is computed as v + 2u × (u × v + w v) with r = w + u. For |r| = 1 both
    /// formulas are equal. For an r of another length, r v r* scales by |r|², and the second
    /// formula also skews.
    #[inline]
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    #[doc(alias("apply", "mul_vec3", "transform_vector"))]
    pub fn rotate(self, v: [R; 3]) -> [R; 3] {
        crate::scalar::must_be_unit::rotations("Quat::rotate", [self]);
        if let Some(turned) = R::quick(quick::Rotate(self.0, v)) {
            return turned;
        }
        let r = self.xyz();
        let inner = vector::add(vector::cross(r, v), vector::scale(v, self.w()));
        vector::add(v, vector::cross(vector::scale(r, R::TWO), inner))
    }
}

/// Borrows the components as `[x, y, z, w]`.
impl<R> AsRef<[R; 4]> for Quat<R> {
    #[inline]
    fn as_ref(&self) -> &[R; 4] {
        &self.0
    }
}

impl<R> AsMut<[R; 4]> for Quat<R> {
    #[inline]
    fn as_mut(&mut self) -> &mut [R; 4] {
        &mut self.0
    }
}

impl<R: Real> Add for Quat<R> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        let [ax, ay, az, aw] = self.0;
        let [bx, by, bz, bw] = other.0;
        Self([ax + bx, ay + by, az + bz, aw + bw])
    }
}

impl<R: Real> Sub for Quat<R> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

/// Hamilton's product pq = p₀q₀ − p·q + p₀q + q₀p + p×q (Jia eq. 2): the turn q acts
/// first, then the turn p.
impl<R: Real> Mul for Quat<R> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        if let Some(product) = R::quick(quick::QuaternionProduct(self.0, other.0)) {
            return Self(product);
        }
        let [ax, ay, az, aw] = self.0;
        let [bx, by, bz, bw] = other.0;
        // The terms are added in pairs such that the vector part of σ*σ is exactly zero for every
        // quaternion σ.
        Self([
            (aw * bx + ax * bw) + (ay * bz - az * by),
            (aw * by - ax * bz) + (ay * bw + az * bx),
            (aw * bz + ax * by) + (az * bw - ay * bx),
            (aw * bw - ax * bx) - (ay * by + az * bz),
        ])
    }
}

impl<R: Real> Neg for Quat<R> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        let [x, y, z, w] = self.0;
        Self([-x, -y, -z, -w])
    }
}

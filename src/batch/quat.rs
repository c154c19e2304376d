use super::even::cos_sinc;
use super::length::Length;
use super::{Dual, vector};
use core::ops::{Add, Mul, Neg, Sub};
use dq8_simd::Lanes;

/// Quaternions, one per lane: [`Quat`](crate::Quat) on lanes.
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct Quat<L>([L; 4]);

impl<L: Lanes> Quat<L> {
    /// Returns the identity 1 in every lane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn identity(level: L::Level) -> Self {
        let zero = L::splat(level, L::Real::from(0.0));
        Self([zero, zero, zero, zero.constant(1.0)])
    }

    /// Makes quaternions from their components, in the order of memory.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn from_xyzw(x: L, y: L, z: L, w: L) -> Self {
        Self([x, y, z, w])
    }

    /// Makes quaternions from `[x, y, z, w]`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn from_array(xyzw: [L; 4]) -> Self {
        Self(xyzw)
    }

    /// Makes quaternions from the vector part and the scalar part.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn from_parts([x, y, z]: [L; 3], w: L) -> Self {
        Self([x, y, z, w])
    }

    /// Returns cos(θ/2) + n sin(θ/2), the turn by θ = `angle` radians about n = `axis`, which
    /// must have length 1.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn from_axis_angle(axis: [L; 3], angle: L) -> Self {
        let half = angle * angle.constant(0.5);
        let (cos, sinc) = cos_sinc(Dual::new(half * half, half.constant(0.0)));
        Self::from_parts(vector::scale(axis, half * sinc.real), cos.real)
    }

    /// Returns the components `[x, y, z, w]`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn to_array(self) -> [L; 4] {
        self.0
    }

    /// Returns the component of i.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn x(self) -> L {
        self.0[0]
    }
    /// Returns the component of j.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn y(self) -> L {
        self.0[1]
    }
    /// Returns the component of k.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn z(self) -> L {
        self.0[2]
    }
    /// Returns the scalar part.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn w(self) -> L {
        self.0[3]
    }
    /// Returns the vector part.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn xyz(self) -> [L; 3] {
        [self.0[0], self.0[1], self.0[2]]
    }

    /// Returns `true` in the lanes where −q, and not q, is the canonical choice of ±q: the first
    /// component of q that is not zero, in the order w, x, y, z, is negative.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn points_back(self) -> L::Mask {
        let [x, y, z, w] = self.0;
        let zero = w.constant(0.0);
        let first = L::select(y.eq(zero), z, y);
        let first = L::select(x.eq(zero), first, x);
        L::select(w.eq(zero), first, w).lt(zero)
    }

    /// Returns the conjugate w − xi − yj − zk.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn conjugate(self) -> Self {
        let [x, y, z, w] = self.0;
        Self([-x, -y, -z, w])
    }

    /// Returns the scalar product of two quaternions as 4-vectors.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn dot(self, other: Self) -> L {
        let [ax, ay, az, aw] = self.0;
        let [bx, by, bz, bw] = other.0;
        aw.mul_add(bw, az.mul_add(bz, ay.mul_add(by, ax * bx)))
    }

    /// Returns |q| = √(q q*).
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn norm(self) -> L {
        self.length().value()
    }

    /// Returns `true` in the lanes where each component of `self` differs from that of `other` by
    /// at most `tolerance`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn abs_diff_eq(self, other: Self, tolerance: L) -> L::Mask {
        let [x, y, z, w] = (self - other).0;
        x.abs().le(tolerance)
            & y.abs().le(tolerance)
            & z.abs().le(tolerance)
            & w.abs().le(tolerance)
    }

    /// Returns `true` in the lanes where every component is finite.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn is_finite(self) -> L::Mask {
        vector::are_finite(self.0)
    }

    /// Returns q / |q|. Some component is NaN in lanes where q is zero or not finite.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn normalize(self) -> Self {
        Self(Length::unit(self.0, self.w().constant(1.0)))
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn length(self) -> Length<L> {
        Length::of(self.0, self.w().constant(1.0))
    }

    /// Returns sq, with one real number s = `factor` per lane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn scale(self, factor: L) -> Self {
        let [x, y, z, w] = self.0;
        Self([x * factor, y * factor, z * factor, w * factor])
    }

    /// Returns sq + onto, with s = `factor`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn scale_onto(self, factor: L, onto: Self) -> Self {
        let [x, y, z, w] = self.0;
        let [ox, oy, oz, ow] = onto.0;
        Self([
            x.mul_add(factor, ox),
            y.mul_add(factor, oy),
            z.mul_add(factor, oz),
            w.mul_add(factor, ow),
        ])
    }

    /// Returns pq + onto, with p = `self` and q = `other`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn mul_onto(self, other: Self, onto: Self) -> Self {
        let [ax, ay, az, aw] = self.0;
        let [bx, by, bz, bw] = other.0;
        let [ox, oy, oz, ow] = onto.0;
        Self([
            az.neg_mul_add(by, ay.mul_add(bz, ax.mul_add(bw, aw.mul_add(bx, ox)))),
            ax.neg_mul_add(bz, az.mul_add(bx, ay.mul_add(bw, aw.mul_add(by, oy)))),
            ay.neg_mul_add(bx, ax.mul_add(by, az.mul_add(bw, aw.mul_add(bz, oz)))),
            az.neg_mul_add(bz, ay.neg_mul_add(by, ax.neg_mul_add(bx, aw.mul_add(bw, ow)))),
        ])
    }

    /// Returns r v r*, the vector `v` turned by these unit quaternions r.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn rotate(self, v: [L; 3]) -> [L; 3] {
        self.rotate_onto(v, v)
    }

    /// Returns `v` turned by q of any norm; `two` must be 2/|q|².
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn rotate_scaled(self, v: [L; 3], two: L) -> [L; 3] {
        self.twice_across(v, v, two)
    }

    /// Returns r v r* − v + onto for unit r. With the vector part u and the scalar part w of r,
    /// the rotated vector is v + 2 u × (u × v + w v); here `onto` takes the place of the first v.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn rotate_onto(self, v: [L; 3], onto: [L; 3]) -> [L; 3] {
        self.twice_across(v, onto, self.w().constant(2.0))
    }

    /// Returns two·r × (r × v + w v) + onto, where r is the vector part of this quaternion and w
    /// its scalar part.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn twice_across(self, v: [L; 3], onto: [L; 3], two: L) -> [L; 3] {
        let r = self.xyz();
        let inner = vector::cross_onto(r, v, vector::scale(v, self.w()));
        vector::scale_onto(vector::cross(r, inner), two, onto)
    }
}

impl<L: Lanes> Add for Quat<L> {
    type Output = Self;
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn add(self, other: Self) -> Self {
        let [ax, ay, az, aw] = self.0;
        let [bx, by, bz, bw] = other.0;
        Self([ax + bx, ay + by, az + bz, aw + bw])
    }
}

impl<L: Lanes> Sub for Quat<L> {
    type Output = Self;
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn sub(self, other: Self) -> Self {
        let [ax, ay, az, aw] = self.0;
        let [bx, by, bz, bw] = other.0;
        Self([ax - bx, ay - by, az - bz, aw - bw])
    }
}

/// Returns Hamilton's product. It takes 16 multiplications, of which 12 are fused with additions.
impl<L: Lanes> Mul for Quat<L> {
    type Output = Self;
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn mul(self, other: Self) -> Self {
        let [ax, ay, az, aw] = self.0;
        let [bx, by, bz, bw] = other.0;
        Self([
            az.neg_mul_add(by, ay.mul_add(bz, ax.mul_add(bw, aw * bx))),
            ax.neg_mul_add(bz, az.mul_add(bx, ay.mul_add(bw, aw * by))),
            ay.neg_mul_add(bx, ax.mul_add(by, az.mul_add(bw, aw * bz))),
            az.neg_mul_add(bz, ay.neg_mul_add(by, ax.neg_mul_add(bx, aw * bw))),
        ])
    }
}

impl<L: Lanes> Neg for Quat<L> {
    type Output = Self;
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn neg(self) -> Self {
        let [x, y, z, w] = self.0;
        Self([-x, -y, -z, -w])
    }
}

use super::{Dual, Quat, vector};
use crate::contract::sums_by_part;
use crate::geometry::DualVector;
use core::ops::Mul;
use dq8_simd::{Block, Lanes, Level, Records, Row};

/// Dual quaternions σ = p + εq, one per lane: [`DualQuat`](crate::DualQuat) on lanes.
///
/// The conventions and laws are those of [`Motion`](crate::Motion). The documentation of
/// [`DualQuat`](crate::DualQuat) has the formulas with their sources, and examples.
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct DualQuat<L> {
    real: Quat<L>,
    dual: Quat<L>,
}

impl<L: Lanes> DualQuat<L> {
    /// Makes p + εq.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn new(real: Quat<L>, dual: Quat<L>) -> Self {
        Self { real, dual }
    }

    /// Returns the identity in every lane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn identity(level: L::Level) -> Self {
        let one = Quat::<L>::identity(level);
        let zero = one.w().constant(0.0);
        Self::new(one, Quat::from_array([zero; 4]))
    }

    /// Returns the same motion in every lane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn splat(level: L::Level, motion: impl Into<[L::Real; 8]>) -> Self {
        Self::from_array(vector::splat(level, motion.into()))
    }

    /// Makes dual quaternions from the lanes of `[px, py, pz, pw, qx, qy, qz, qw]`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn from_array([px, py, pz, pw, qx, qy, qz, qw]: [L; 8]) -> Self {
        Self::new(Quat::from_xyzw(px, py, pz, pw), Quat::from_xyzw(qx, qy, qz, qw))
    }

    /// Makes dual quaternions from a dual number, the scalar part, and a dual vector (Jia eq. 15).
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn from_dual_parts(scalar: Dual<L>, vector: DualVector<L>) -> Self {
        Self::new(
            Quat::from_parts(vector.real, scalar.real),
            Quat::from_parts(vector.dual, scalar.dual),
        )
    }

    /// Loads record `i`, `[px, py, pz, pw, qx, qy, qz, qw]`, into lane `i`. The records are plain
    /// dual quaternions in memory and are transposed while they are loaded. Lanes without a record
    /// hold the identity.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn load_records(level: L::Level, records: &[[L::Real; 8]]) -> Self {
        let (zero, one) = (L::Real::default(), L::Real::from(1.0));
        let identity = [zero, zero, zero, one, zero, zero, zero, zero];
        Self::from_array(L::load_records(level, records, identity))
    }

    /// Stores lane `i` in record `i`. Records beyond the last lane are not changed.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn store_records(self, records: &mut [[L::Real; 8]]) {
        L::store_records(self.to_array(), records);
    }

    /// Returns the lanes of `[px, py, pz, pw, qx, qy, qz, qw]`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn to_array(self) -> [L; 8] {
        let [px, py, pz, pw] = self.real.to_array();
        let [qx, qy, qz, qw] = self.dual.to_array();
        [px, py, pz, pw, qx, qy, qz, qw]
    }

    /// Returns p, the real part.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn real(self) -> Quat<L> {
        self.real
    }

    /// Returns q, the dual part.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn dual(self) -> Quat<L> {
        self.dual
    }

    /// Returns the dual number p_w + εq_w, the scalar part.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn dual_scalar(self) -> Dual<L> {
        Dual::new(self.real.w(), self.dual.w())
    }

    /// Returns the vector part of σ, a dual vector. The scalar part is
    /// [`dual_scalar`](Self::dual_scalar).
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn dual_vector(self) -> DualVector<L> {
        DualVector { real: self.real.xyz(), dual: self.dual.xyz() }
    }

    /// Returns σ• = p − εq.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn conjugate_dual(self) -> Self {
        Self::new(self.real, -self.dual)
    }

    /// Returns σ* = p* + εq*, the inverse of a unit σ.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn conjugate(self) -> Self {
        Self::new(self.real.conjugate(), self.dual.conjugate())
    }

    /// Returns σ⋄ = p* − εq*.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn conjugate_both(self) -> Self {
        let [x, y, z, w] = self.dual.to_array();
        Self::new(self.real.conjugate(), Quat::from_xyzw(x, y, z, -w))
    }

    /// Returns sσ, with one real number s = `factor` per lane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn scale(self, factor: L) -> Self {
        Self::new(self.real.scale(factor), self.dual.scale(factor))
    }

    /// Returns (a + εb)σ, with one dual number a + εb = `factor` per lane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn scale_dual(self, factor: Dual<L>) -> Self {
        let dual = self.real.scale_onto(factor.dual, self.dual.scale(factor.real));
        Self::new(self.real.scale(factor.real), dual)
    }

    /// Returns (a + εb)σ + onto, with one dual number a + εb = `factor` per lane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn scale_dual_onto(self, factor: Dual<L>, onto: Self) -> Self {
        let turned = self.dual.scale_onto(factor.real, onto.dual);
        Self::new(
            self.real.scale_onto(factor.real, onto.real),
            self.real.scale_onto(factor.dual, turned),
        )
    }

    /// Returns the scalar product ⟨a, b⟩ = p_a·p_b + ε(p_a·q_b + q_a·p_b), a dual number.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn dot(self, other: Self) -> Dual<L> {
        let across = self.real.dot(other.dual) + self.dual.dot(other.real);
        Dual::new(self.real.dot(other.real), across)
    }

    /// Returns `true` in the lanes where each component differs by at most `tolerance`, and `false`
    /// where a difference is NaN.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn abs_diff_eq(self, other: Self, tolerance: L) -> L::Mask {
        let (a, b) = (self.to_array(), other.to_array());
        let mut close = (a[0] - b[0]).abs().le(tolerance);
        for (a, b) in a.into_iter().zip(b).skip(1) {
            close = close & (a - b).abs().le(tolerance);
        }
        close
    }

    /// Returns `true` in the lanes where every component is finite.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn is_finite(self) -> L::Mask {
        super::vector::are_finite(self.to_array())
    }

    /// Returns whichever of σ and −σ has a positive first component, where components that are
    /// zero are skipped, in the order p_w, p_x, p_y, p_z.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn canonical(self) -> Self {
        self.negate_where(self.real.points_back())
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn negate_where(self, mask: L::Mask) -> Self {
        let one = self.real.w().constant(1.0);
        self.scale(L::select(mask, -one, one))
    }
}

/// Loads and stores of a whole [`Block`] of memory.
impl<L: Lanes> DualQuat<L> {
    /// Loads the dual quaternions of a block, one into each lane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn load<A, V>(level: V, block: &Block<A, 8>) -> Self
    where
        A: Row<Lanes<V> = L>,
        V: Level,
    {
        Self::from_array(block.load(level))
    }

    /// Stores one dual quaternion per lane in a block.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn store<A, V>(self, block: &mut Block<A, 8>)
    where
        A: Row<Lanes<V> = L>,
        V: Level,
    {
        block.store::<V>(self.to_array());
    }
}

sums_by_part! {
    [L: Lanes] #[cfg_attr(not(opt_level_0), inline(always))] DualQuat<L>: (real) (dual)
}

/// Returns the product p₁p₂ + ε(p₁q₂ + q₁p₂). It takes 48 multiplications, of which 40
/// are fused with additions.
impl<L: Lanes> Mul for DualQuat<L> {
    type Output = Self;
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn mul(self, other: Self) -> Self {
        let dual = self.dual.mul_onto(other.real, self.real * other.dual);
        Self::new(self.real * other.real, dual)
    }
}

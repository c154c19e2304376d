//! Hyper-dual quaternions as Arends writes them, four quaternions.

use crate::{HyperDual, hyper_dual, hyper_dual_parts};
use core::ops::{Add, Mul, Neg, Sub};
use dq8::{DualQuat, Quat, Real};

/// A hyper-dual quaternion a + bε₁ + cε₂ + dε₁ε₂ of four quaternions (Arends, chapter
/// 5, §2).
///
/// The same numbers are `dq8::Quat<HyperDual<R>>`, a quaternion of four hyper-dual numbers, with
/// [`From`] both ways.
///
/// ```
/// use dq8::Quat;
/// use lab::HyperDualQuat;
/// let r = Quat::from_xyzw(0.5_f64, 0.5, 0.5, 0.5);
/// let x = HyperDualQuat::from_rotation_translation(r, [0.0, 0.0, 5.0]);
/// assert_eq!(x.transform_point([2.0, 0.0, 0.0]), [0.0, 2.0, 5.0]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HyperDualQuat<R> {
    /// a
    pub real: Quat<R>,
    /// b, of ε₁
    pub first: Quat<R>,
    /// c, of ε₂
    pub second: Quat<R>,
    /// d, of ε₁ε₂
    pub mixed: Quat<R>,
}

impl<R: Real> HyperDualQuat<R> {
    /// 1
    pub const IDENTITY: Self = Self::from_rotation(Quat::IDENTITY);

    /// a + bε₁ + cε₂ + dε₁ε₂
    pub const fn new(real: Quat<R>, first: Quat<R>, second: Quat<R>, mixed: Quat<R>) -> Self {
        Self { real, first, second, mixed }
    }

    /// r (Arends, chapter 5, §3).
    pub const fn from_rotation(rotation: Quat<R>) -> Self {
        Self::new(rotation, Quat::ZERO, Quat::ZERO, Quat::ZERO)
    }

    /// 1 + ½tε₁ε₂ (Arends, chapter 5, §4).
    pub fn from_translation(translation: [R; 3]) -> Self {
        Self::from_rotation_translation(Quat::IDENTITY, translation)
    }

    /// r + ½trε₁ε₂: turn, then translate, as the code of Arends' appendix has it. His §4
    /// prints r + ½tε₁ε₂, which is that only for r = ±1.
    pub fn from_rotation_translation(rotation: Quat<R>, translation: [R; 3]) -> Self {
        let translation = Quat::from_parts(translation.map(|c| c * R::HALF), R::ZERO);
        Self { mixed: translation * rotation, ..Self::from_rotation(rotation) }
    }

    /// A motion σ = p + εq and its rate σ̇ in one number: p + ṗε₁ + qε₂ +
    /// q̇ε₁ε₂, that is σ + ε₁σ̇ with ε₂ for ε. Products of such numbers follow the
    /// product rule.
    pub const fn from_moving(sigma: DualQuat<R>, rate: DualQuat<R>) -> Self {
        Self::new(sigma.real(), rate.real(), sigma.dual(), rate.dual())
    }

    /// σ and σ̇ of [`from_moving`](Self::from_moving).
    pub const fn to_moving(self) -> (DualQuat<R>, DualQuat<R>) {
        (DualQuat::new(self.real, self.second), DualQuat::new(self.first, self.mixed))
    }

    /// Each of the four conjugated: (xy)* = y*x*, and xx* is a hyper-dual number.
    pub fn conjugate(self) -> Self {
        self.each(Quat::conjugate)
    }

    /// The conjugate with ε₁ → −ε₁: a* − b*ε₁ + c*ε₂ − d*ε₁ε₂, which
    /// turns products round as [`conjugate`](Self::conjugate) does.
    pub fn conjugate_first(self) -> Self {
        let Self { real, first, second, mixed } = self.conjugate();
        Self::new(real, -first, second, -mixed)
    }

    /// The conjugate with ε₂ → −ε₂: a* + b*ε₁ − c*ε₂ − d*ε₁ε₂.
    pub fn conjugate_second(self) -> Self {
        let Self { real, first, second, mixed } = self.conjugate();
        Self::new(real, first, -second, -mixed)
    }

    /// x† = a* − b*ε₁ − c*ε₂ − d*ε₁ε₂ (Arends, chapter 5, §2; the bars are
    /// lost in print, the code of his appendix has them). Not the conjugate of a product where b
    /// and c are not zero: −ε₁ times −ε₂ is not −ε₁ε₂.
    pub fn dagger(self) -> Self {
        let Self { real, first, second, mixed } = self.conjugate();
        Self::new(real, -first, -second, -mixed)
    }

    /// xx*, a hyper-dual number; the square of the norm.
    pub fn norm_squared(self) -> HyperDual<R> {
        let [first, second] = [self.first, self.second].map(|part| R::TWO * self.real.dot(part));
        let mixed = R::TWO * (self.real.dot(self.mixed) + self.first.dot(self.second));
        hyper_dual(self.real.dot(self.real), first, second, mixed)
    }

    /// a⁻¹ − a⁻¹ba⁻¹ε₁ − a⁻¹ca⁻¹ε₂ + (a⁻¹ba⁻¹ca⁻¹ +
    /// a⁻¹ca⁻¹ba⁻¹ − a⁻¹da⁻¹)ε₁ε₂: the inverse of hyper-dual numbers
    /// (Arends, chapter 5, §1) where the order counts.
    ///
    /// `None` if a is zero or not finite.
    pub fn inverse(self) -> Option<Self> {
        let norm = self.real.norm();
        if norm == R::ZERO || !norm.is_finite() {
            return None;
        }
        let real = self.real.normalize().conjugate().scale(R::ONE / norm);
        let (first, second) = (real * self.first, real * self.second);
        let mixed = first * second + second * first - real * self.mixed;
        Some(Self::new(real, -(first * real), -(second * real), mixed * real))
    }

    /// v′ from x(1 + vε₁ε₂)x† (Arends, chapter 5, §3), for a unit a.
    pub fn transform_point(self, point: [R; 3]) -> [R; 3] {
        (self * Self::point(point) * self.dagger()).mixed.xyz()
    }

    /// 1 + vε₁ε₂, a point (Arends, chapter 5, §3).
    pub const fn point(point: [R; 3]) -> Self {
        Self { mixed: Quat::from_parts(point, R::ZERO), ..Self::IDENTITY }
    }

    /// Where a moving body's moving point is, and its velocity: v′ and v̇′ from x(1 + vε₂ +
    /// v̇ε₁ε₂)x̄ with x from [`from_moving`](Self::from_moving), unit, and x̄ the
    /// [conjugate with ε₂ → −ε₂](Self::conjugate_second).
    pub fn transform_moving_point(self, point: [R; 3], velocity: [R; 3]) -> ([R; 3], [R; 3]) {
        let [second, mixed] = [point, velocity].map(|v| Quat::from_parts(v, R::ZERO));
        let moved = self * Self { second, mixed, ..Self::IDENTITY } * self.conjugate_second();
        (moved.second.xyz(), moved.mixed.xyz())
    }

    fn each(self, change: impl Fn(Quat<R>) -> Quat<R>) -> Self {
        let Self { real, first, second, mixed } = self;
        Self::new(change(real), change(first), change(second), change(mixed))
    }
}

impl<R: Real> Add for HyperDualQuat<R> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::new(
            self.real + other.real,
            self.first + other.first,
            self.second + other.second,
            self.mixed + other.mixed,
        )
    }
}

impl<R: Real> Sub for HyperDualQuat<R> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<R: Real> Neg for HyperDualQuat<R> {
    type Output = Self;
    fn neg(self) -> Self {
        self.each(Neg::neg)
    }
}

/// The product of hyper-dual numbers with quaternions for numbers, nine quaternion products
/// (Arends, chapter 5, §5): the right-hand motion first.
impl<R: Real> Mul for HyperDualQuat<R> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::new(
            self.real * other.real,
            self.real * other.first + self.first * other.real,
            self.real * other.second + self.second * other.real,
            self.real * other.mixed
                + self.first * other.second
                + self.second * other.first
                + self.mixed * other.real,
        )
    }
}

impl<R: Real> From<Quat<HyperDual<R>>> for HyperDualQuat<R> {
    fn from(quat: Quat<HyperDual<R>>) -> Self {
        let numbers = quat.to_array().map(hyper_dual_parts);
        let part = |which: usize| Quat::from_array(numbers.map(|parts| parts[which]));
        Self::new(part(0), part(1), part(2), part(3))
    }
}

impl<R: Real> From<HyperDualQuat<R>> for Quat<HyperDual<R>> {
    fn from(parts: HyperDualQuat<R>) -> Self {
        let HyperDualQuat { real, first, second, mixed } = parts;
        let [a, b, c, d] = [real, first, second, mixed].map(Quat::to_array);
        Self::from_array(core::array::from_fn(|i| hyper_dual(a[i], b[i], c[i], d[i])))
    }
}

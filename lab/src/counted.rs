//! [`Counted`]: a number that counts what is done with it.

use core::cell::Cell;
use core::cmp::Ordering;
use core::fmt;
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};
use dq8::Real;

/// How many operations of each kind something took.
///
/// Every operation that is written counts, also those with 0, 1, 2 or ½: an addition of a zero that
/// is known beforehand is left out by a compiler, not by the formula.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// xy
    pub multiplications: u32,
    /// x + y and x − y
    pub additions: u32,
    /// −x, which processors get for nothing more often than not.
    pub negations: u32,
    /// x/y
    pub divisions: u32,
    /// √x
    pub square_roots: u32,
    /// Sines, cosines, tangents and their inverses.
    pub trigonometric: u32,
    /// eˣ
    pub exponentials: u32,
    /// ln x
    pub logarithms: u32,
    /// Comparisons, absolute values and tests for infinity.
    pub comparisons: u32,
}

thread_local! {
    static COUNTS: Cell<Counts> = const { Cell::new(Counts::NONE) };
}

impl Counts {
    const NONE: Self = Self {
        multiplications: 0,
        additions: 0,
        negations: 0,
        divisions: 0,
        square_roots: 0,
        trigonometric: 0,
        exponentials: 0,
        logarithms: 0,
        comparisons: 0,
    };

    /// What `work` does with [`Counted`] numbers, on this thread.
    ///
    /// ```
    /// use lab::{Counted, Counts};
    /// let [x, y] = [2.0, 3.0].map(Counted);
    /// let counts = Counts::of(|| x * y + x);
    /// assert_eq!((counts.multiplications, counts.additions), (1, 1));
    /// ```
    pub fn of<T>(work: impl FnOnce() -> T) -> Self {
        let before = COUNTS.replace(Self::NONE);
        work();
        COUNTS.replace(before)
    }
}

/// One more of a kind.
fn count(kind: impl FnOnce(&mut Counts) -> &mut u32) {
    let mut counts = COUNTS.get();
    *kind(&mut counts) += 1;
    COUNTS.set(counts);
}

/// An `f64` that counts: what is written for every [`Real`] is counted by computing it with these.
#[derive(Clone, Copy, Debug, Default)]
pub struct Counted(pub f64);

impl Add for Counted {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        count(|counts| &mut counts.additions);
        Self(self.0 + other.0)
    }
}

impl Sub for Counted {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        count(|counts| &mut counts.additions);
        Self(self.0 - other.0)
    }
}

impl Mul for Counted {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        count(|counts| &mut counts.multiplications);
        Self(self.0 * other.0)
    }
}

impl Div for Counted {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        count(|counts| &mut counts.divisions);
        Self(self.0 / other.0)
    }
}

impl Neg for Counted {
    type Output = Self;
    fn neg(self) -> Self {
        count(|counts| &mut counts.negations);
        Self(-self.0)
    }
}

impl AddAssign for Counted {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for Counted {
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl MulAssign for Counted {
    fn mul_assign(&mut self, other: Self) {
        *self = *self * other;
    }
}

impl DivAssign for Counted {
    fn div_assign(&mut self, other: Self) {
        *self = *self / other;
    }
}

impl PartialEq for Counted {
    fn eq(&self, other: &Self) -> bool {
        count(|counts| &mut counts.comparisons);
        self.0 == other.0
    }
}

impl PartialOrd for Counted {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        count(|counts| &mut counts.comparisons);
        self.0.partial_cmp(&other.0)
    }
}

impl fmt::Display for Counted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl From<f32> for Counted {
    fn from(value: f32) -> Self {
        Self(value.into())
    }
}

impl From<Counted> for f64 {
    fn from(value: Counted) -> Self {
        value.0
    }
}

impl Counted {
    fn trigonometric(self, function: impl FnOnce(f64) -> f64) -> Self {
        count(|counts| &mut counts.trigonometric);
        Self(function(self.0))
    }
}

impl Real for Counted {
    const ZERO: Self = Self(0.0);
    const ONE: Self = Self(1.0);
    const TWO: Self = Self(2.0);
    const HALF: Self = Self(0.5);
    const PI: Self = Self(core::f64::consts::PI);
    const EPSILON: Self = Self(f64::EPSILON);
    const NAN: Self = Self(f64::NAN);

    fn from_f64(value: f64) -> Self {
        Self(value)
    }
    fn is_finite(self) -> bool {
        count(|counts| &mut counts.comparisons);
        self.0.is_finite()
    }
    fn abs(self) -> Self {
        count(|counts| &mut counts.comparisons);
        Self(self.0.abs())
    }
    fn sqrt(self) -> Self {
        count(|counts| &mut counts.square_roots);
        Self(self.0.sqrt())
    }
    fn sin(self) -> Self {
        self.trigonometric(<f64 as Real>::sin)
    }
    fn cos(self) -> Self {
        self.trigonometric(<f64 as Real>::cos)
    }
    fn tan(self) -> Self {
        self.trigonometric(<f64 as Real>::tan)
    }
    fn asin(self) -> Self {
        self.trigonometric(<f64 as Real>::asin)
    }
    fn acos(self) -> Self {
        self.trigonometric(<f64 as Real>::acos)
    }
    fn atan(self) -> Self {
        self.trigonometric(<f64 as Real>::atan)
    }
    fn atan2(self, x: Self) -> Self {
        self.trigonometric(|y| Real::atan2(y, x.0))
    }
    fn exp(self) -> Self {
        count(|counts| &mut counts.exponentials);
        Self(Real::exp(self.0))
    }
    fn ln(self) -> Self {
        count(|counts| &mut counts.logarithms);
        Self(Real::ln(self.0))
    }
}

//! [`Range`]: intervals of numbers, and their ends as Gappa reads them.

use crate::tape::Op;
use std::fmt::{Display, Formatter, Result};

/// Numbers from the first to the second.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Range(pub(crate) f64, pub(crate) f64);

impl Range {
    fn spanned(numbers: &[f64]) -> Self {
        let (least, most) = (f64::INFINITY, f64::NEG_INFINITY);
        Self(
            numbers.iter().copied().fold(least, f64::min),
            numbers.iter().copied().fold(most, f64::max),
        )
    }
    pub(crate) fn plus(self, other: Self) -> Self {
        Self(self.0 + other.0, self.1 + other.1)
    }
    pub(crate) fn minus(self, other: Self) -> Self {
        Self(self.0 - other.1, self.1 - other.0)
    }
    pub(crate) fn times(self, other: Self) -> Self {
        let (Self(a, b), Self(c, d)) = (self, other);
        Self::spanned(&[a * c, a * d, b * c, b * d])
    }
    pub(crate) fn both(self, other: Self) -> Self {
        Self(self.0.max(other.0), self.1.min(other.1))
    }
    pub(crate) fn wider(self, by: f64) -> Self {
        Self((self.0 - by).next_down(), (self.1 + by).next_up())
    }
    /// Of rounded numbers: 0 stays 0.
    pub(crate) fn rounded(self, by: f64) -> Self {
        let moved = |c: f64, by: f64| if c == 0.0 { c } else { c + by };
        Self(moved(self.0, -by), moved(self.1, by))
    }
    pub(crate) fn size(self) -> f64 {
        self.0.abs().max(self.1.abs())
    }
    /// The result of an operation whose product is off by `slack` before it is added; `None` where
    /// 0 is divided by.
    pub(crate) fn of(op: Op, n: &[Self], slack: f64) -> Option<Self> {
        let product = || match op {
            Op::Mul(a, b) | Op::Fma(a, b, _) | Op::Nfma(a, b, _) if a == b && n[0].0 < 0.0 => {
                Self(0.0, n[0].size() * n[0].size())
            }
            _ => n[0].times(n[1]),
        };
        Some(match op {
            Op::Input | Op::Const(_) => return None,
            Op::Add(..) => n[0].plus(n[1]),
            Op::Sub(..) => n[0].minus(n[1]),
            Op::Mul(..) => product(),
            Op::Fma(..) => n[2].plus(product().rounded(slack)),
            Op::Nfma(..) => n[2].minus(product().rounded(slack)),
            Op::Div(..) if n[1].0 > 0.0 => n[0].times(Self(1.0 / n[1].1, 1.0 / n[1].0)),
            Op::Sqrt(_) if n[0].0 > 0.0 => Self(n[0].0.sqrt(), n[0].1.sqrt()),
            Op::Div(..) | Op::Sqrt(_) => return None,
            Op::Neg(_) => Self(-n[0].1, -n[0].0),
            Op::Abs(_) => Self(0.0, n[0].size()),
        })
    }
    /// With ends of few digits.
    pub(crate) fn short(self) -> Self {
        Self(-up(-self.0), up(self.1))
    }
}

impl Display for Range {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        write!(f, "[{}, {}]", number(self.0), number(self.1))
    }
}

/// A number exactly: m·2ᵉ.
pub(crate) fn number(c: f64) -> String {
    if c == c.trunc() && c.abs() < 1e15 {
        return format!("{}", c as i64);
    }
    let bits = c.abs().to_bits();
    let (mut exponent, mut digits) = ((bits >> 52) as i64 - 1075, bits & ((1 << 52) - 1) | 1 << 52);
    while digits.is_multiple_of(2) {
        digits /= 2;
        exponent += 1;
    }
    format!("{}{digits}b{exponent}", if c < 0.0 { "-" } else { "" })
}

/// The next number of few bits.
pub(crate) fn up(c: f64) -> f64 {
    up_to(26, c)
}

pub(crate) fn up_to(bits: i32, c: f64) -> f64 {
    if c == 0.0 {
        return 0.0;
    }
    let step = 2_f64.powi(c.abs().log2().floor() as i32 - bits);
    (c / step).ceil() * step
}

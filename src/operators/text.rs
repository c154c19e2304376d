//! Quaternions, motions and other types as text: [`Display`](fmt::Display) writes, for example,
//! `[x, y, z, w]`, and `parse` restores the value from this text to the last bit.

use crate::geometry::Twist;
use crate::macros::{Count, errors};
use crate::number::Real;
use crate::representation::RotationTranslation;
use crate::scalar::{DualQuat, Quat};
use core::fmt;
use core::str::FromStr;

errors! {
    /// The error for text that is not a list of numbers, or a list of the wrong length.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    ParseError {
        /// An entry of the list is not a number.
        NotANumber {
            /// The index of the entry.
            index: usize,
        } => "element {index} of the list is not a number";
        /// The list has the wrong length.
        Count {
            /// The length of the list.
            found: usize,
            /// The length that the list must have.
            expected: usize,
        } => "the list has {} where {expected} are needed", Count(*found, "number");
    }
}

/// Parses a list of numbers that are separated by single commas, white space or both. The brackets
/// around the list may be left out.
fn parse<R: Real + FromStr, const N: usize>(text: &str) -> Result<[R; N], ParseError> {
    let text = text.trim();
    let inner = text.strip_prefix('[').and_then(|text| text.strip_suffix(']')).unwrap_or(text);
    let words = || inner.split(',').flat_map(str::split_whitespace);
    let found = words().count();
    if found != N {
        return Err(ParseError::Count { found, expected: N });
    }
    let mut before = 0;
    for part in inner.split(',') {
        let count = part.split_whitespace().count();
        if count == 0 {
            return Err(ParseError::NotANumber { index: before });
        }
        before += count;
    }
    let mut numbers = [R::ZERO; N];
    for (index, (number, word)) in numbers.iter_mut().zip(words()).enumerate() {
        *number = word.parse().map_err(|_| ParseError::NotANumber { index })?;
    }
    Ok(numbers)
}

/// Writes a list of numbers. Width and precision apply to every number: `{:.3}` writes three digits
/// after the point.
fn write<R: Real>(numbers: &[R], f: &mut fmt::Formatter<'_>) -> fmt::Result {
    f.write_str("[")?;
    for (index, number) in numbers.iter().enumerate() {
        if index > 0 {
            f.write_str(", ")?;
        }
        fmt::Display::fmt(number, f)?;
    }
    f.write_str("]")
}

macro_rules! text {
    ($($thing:ident: $order:literal;)*) => {$(
        #[doc = $order]
        /// Writes the components as a list. A precision applies to every component.
        impl<R: Real> fmt::Display for $thing<R> {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write(&self.to_array(), f)
            }
        }
        #[doc = $order]
        /// Parses numbers that are separated by commas or spaces. The brackets may be left out.
        impl<R: Real + FromStr> FromStr for $thing<R> {
            type Err = ParseError;
            fn from_str(text: &str) -> Result<Self, ParseError> {
                Ok(Self::from_array(parse(text)?))
            }
        }
    )*};
}
text! {
    Quat: "`[x, y, z, w]`";
    DualQuat: "`[px, py, pz, pw, qx, qy, qz, qw]`";
    RotationTranslation: "`[x, y, z, w, tx, ty, tz]`";
    Twist: "`[ωx, ωy, ωz, vx, vy, vz]`";
}

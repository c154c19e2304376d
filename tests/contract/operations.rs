//! Every operation of [`dq8::Motion`] on one line of `table.rs`, from which come its caller by
//! name, its inputs, the scale of its errors, the reference vectors that are its own, and its
//! bounds with their reasons. A new operation needs a line there, and nothing else in the tests:
//! `tests/bits` reads the same table.
//!
//! ```text
//! name(kind of argument and where in a Case it is, …) -> kind of answer, scale of the error,
//!     [bounds];
//! ```
//!
//! Arguments that are `unit` must be unit, `any` may be any dual quaternion; of an operation that
//! `takes_any`, only the bounds are those of unit ones. Bounds: `agrees`,
//! lanes with the scalar reference of the same precision; `double`, with the scalar path in `f64`;
//! `digits`, with answers of 60 digits. Every operation has one of the first two.
//!
//! All three are measured and not proved. `digits` holds for the vectors in the files and is no
//! bound for other input: a search that climbs finds 3.2 u in the product on lanes (2.5 here), 3.7
//! in `mul_rotation_translation` (3) and 4.0 in `normalize` (3.5). `agrees` and `double` are
//! enforced on edge cases and random input, which is no proof for all input either. What is proved
//! is in `proofs/bounds.toml`.

use crate::bound::{Bound, Kind, on, within};
use crate::entry::{method, operations};
use crate::implementation::Implementation;
use crate::kinds::*;
use crate::lanes::{MAX_LANES, Motions, Reals, Row};
use crate::operation::Inputs::{Clusters, Turns, Twists};
use crate::operation::Sign::{Either, Kept};
use crate::operation::{Answer, Argument, Call, Held, Inputs, Operation, Sign};
use crate::sample::Sample;
use crate::scale::{self, of_digits};
use crate::vectors::Vector;
use dq8::{
    Line, Plane, Twist,
    geometry::{DualVector, Mean, Screw, Wrench},
};

/// Small or no rotation: what peers lose.
const SMALL: &[&str] = &["near0", "close", "translation"];

const fn agrees(units: f64, reason: &'static str) -> Held {
    Held::Scalar(within(units, reason))
}

const fn takes_any(reason: &'static str) -> Held {
    Held::TakesAny { reason }
}

const fn double(inputs: Inputs, sign: Sign, bounds: &'static [Bound]) -> Held {
    Held::Double { inputs, sign, bounds }
}

/// `name` and `fields` are those of the file; the answer has the sign of the file's.
const fn digits(
    name: &'static str,
    fields: &'static [&'static str],
    scale: fn(&Vector, f64) -> f64,
    bounds: &'static [Bound],
) -> Held {
    Held::Digits { name, fields, sign: Kept, scale, bounds }
}

/// As `digits`, for answers whose sign is a matter of rounding.
const fn digits_of_either_sign(
    name: &'static str,
    fields: &'static [&'static str],
    bounds: &'static [Bound],
) -> Held {
    Held::Digits { name, fields, sign: Either, scale: of_digits::plain, bounds }
}

include!("table.rs");

/// The operation of that name.
///
/// # Panics
/// If there is none.
pub fn operation(name: &str) -> &'static Operation {
    let found = OPERATIONS.iter().find(|operation| operation.name == name);
    found.unwrap_or_else(|| panic!("{name} is no operation of the contract"))
}

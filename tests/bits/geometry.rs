//! Every operation of the tables of geometry, as the contract lists them.

use crate::deal::Deal;
use dq8::{Lanes, Scalar};

/// As in `operations`. What may fail is no answer in the scalar reference, and a mask on lanes.
macro_rules! geometry {
    ($scale:ident: $($name:literal($($field:ident: $shape:ident),*) -> $result:ident, $scales:expr,
        [$($bound:expr),* $(,)?], $how:ident $scalar:expr $(, $lanes:expr)?;)*) => {
        pub(super) fn scalar<R: dq8::Scalar>(sink: &mut dyn FnMut(&str, u64)) {
            $(sink($name, super::Deal::<dq8::DualQuat<R>>::hash((), $name, |deal| {
                $(let $field = take!(deal, $shape);)*
                scalar!(deal, $result $how $scalar);
            }));)*
        }
        #[allow(unused_variables, reason = "some tables are of single things alone")]
        pub(super) fn lanes<L: dq8::Lanes<Real: dq8::Scalar>>(
            level: L::Level,
            sink: &mut dyn FnMut(&str, u64),
        ) {
            $(on_lanes!($how sink($name, super::Deal::<dq8::batch::DualQuat<L>>::hash(level, $name, |deal| {
                $(let $field = take!(deal, $shape);)*
                lanes!(deal, $result $how $scalar $(, $lanes)?);
            })));)*
        }
    };
}

macro_rules! scalar {
    ($deal:ident, $result:ident plain $of:expr) => { put!($deal, $result $of) };
    ($deal:ident, $result:ident $how:ident $of:expr) => {
        if let Ok(value) = $of { put!($deal, $result value) }
    };
}

/// What there is on lanes.
macro_rules! on_lanes {
    (alone $($hash:tt)*) => {};
    ($how:ident $hash:expr) => {
        $hash
    };
}

/// The text of the lanes: that of the scalar reference, if there is no other.
macro_rules! lanes {
    ($deal:ident, $result:ident plain $scalar:expr) => { put!($deal, $result $scalar) };
    ($deal:ident, $result:ident plain $scalar:expr, $of:expr) => { put!($deal, $result $of) };
    ($deal:ident, $result:ident tried $scalar:expr, $of:expr) => {{
        let (value, failed) = $of;
        put!($deal, $result value);
        $deal.mask(failed);
    }};
}

/// The files of the contract.
macro_rules! tables {
    ($($table:ident $path:literal;)*) => {
        $(#[path = $path] mod $table;)*

        pub(crate) fn scalar<R: Scalar>(sink: &mut dyn FnMut(&str, u64)) {
            $($table::scalar::<R>(sink);)*
        }
        pub(crate) fn lanes<L: Lanes<Real: Scalar>>(level: L::Level, sink: &mut dyn FnMut(&str, u64)) {
            $($table::lanes::<L>(level, sink);)*
        }
    };
}
tables! {
    lines "../contract/geometry/lines.rs";
    rotations "../contract/geometry/rotations.rs";
    matrices "../contract/geometry/matrices.rs";
    maps "../contract/geometry/maps.rs";
    quaternions "../contract/geometry/quaternions.rs";
    duals "../contract/geometry/duals.rs";
    screws "../contract/geometry/screws.rs";
}

//! What one line of a [table](crate::geometry) becomes: an operation, and a function on rows for
//! the scalar reference and one for lanes.

use crate::lanes::Row;
use crate::sample::Sample;
use dq8::representation::EulerOrder;

/// Everything that the lines of a table become; the scales are those of a module. `tests/bits`
/// reads the same tables.
macro_rules! geometry {
    ($scale:ident: $($name:literal($($field:ident: $shape:ident),*) -> $result:ident, $scales:expr,
        [$($bound:expr),* $(,)?], $how:ident $scalar:expr $(, $lanes:expr)?;)*) => {
        #[allow(unused_imports, reason = "most tables need all of them")]
        use $crate::{bound::{on, within}, geometry::scale::{each, $scale::*}};

        pub(super) const OPERATIONS: &[$crate::geometry::Operation] =
            &[$($crate::geometry::Operation {
                name: $name,
                fields: &[$((stringify!($field), stringify!($shape))),*],
                scales: $scales,
                bounds: &[$($bound),*],
            }),*];

        pub(super) struct Scalar<R>(std::marker::PhantomData<R>);

        impl<R: dq8::Real> Scalar<R> {
            pub(super) const CALLS: &'static [Option<$crate::geometry::Call>] = &[$(Some(|given| {
                type M<R> = dq8::DualQuat<R>;
                let mut next = $crate::geometry::entry::numbers_of::<M<R>>(given);
                $(let $field = take!(M<R>, $shape next);)*
                scalar_answer!(M<R>, $result, $how $scalar)
            })),*];
        }

        pub(super) struct OnLanes<L>(std::marker::PhantomData<L>);

        impl<L: dq8::Lanes<Level: $crate::sample::Proof>> OnLanes<L> {
            pub(super) const CALLS: &'static [Option<$crate::geometry::Call>] = &[$(on_lanes!($how |given| {
                type M<L> = dq8::batch::DualQuat<L>;
                let mut next = $crate::geometry::entry::numbers_of::<M<L>>(given);
                $(let $field = take!(M<L>, $shape next);)*
                lanes_answer!(M<L>, $result, $how last!($scalar $(, $lanes)?))
            })),*];
        }
    };
}

/// An argument of `M` from the next numbers.
macro_rules! take {
    ($M:ty, order $next:ident) => { $crate::geometry::entry::order::<$M>($next()) };
    ($M:ty, integer $next:ident) => { $crate::geometry::entry::integer::<$M>($next()) };
    ($M:ty, quat $next:ident) => {{
        let [w, x, y, z] = take!($M, numbers $next);
        <$M as $crate::sample::Sample>::quat([x, y, z, w])
    }};
    ($M:ty, unit_quat $next:ident) => { take!($M, quat $next).normalize() };
    ($M:ty, unit_pose $next:ident) => {{
        let rotation = take!($M, unit_quat $next);
        (rotation, take!($M, numbers $next))
    }};
    ($M:ty, unit_motion $next:ident) => {{
        let [pw, px, py, pz, qw, qx, qy, qz] = take!($M, numbers $next);
        <$M as $crate::sample::Sample>::motion([px, py, pz, pw, qx, qy, qz, qw]).normalize()
    }};
    ($M:ty, dual $next:ident) => {{
        let [real, dual] = take!($M, numbers $next);
        <$M as $crate::sample::Sample>::dual_number(real, dual)
    }};
    ($M:ty, point $next:ident) => { take!($M, as [_; 3], $next) };
    ($M:ty, line $next:ident) => { take!($M, as dq8::Line<_>, $next) };
    ($M:ty, plane $next:ident) => { take!($M, as dq8::Plane<_>, $next) };
    ($M:ty, two $next:ident) => { take!($M, as [_; 2], $next) };
    ($M:ty, dual_vector $next:ident) => { take!($M, as dq8::geometry::DualVector<_>, $next) };
    ($M:ty, twist $next:ident) => { take!($M, as dq8::Twist<_>, $next) };
    ($M:ty, wrench $next:ident) => { take!($M, as dq8::geometry::Wrench<_>, $next) };
    ($M:ty, screw $next:ident) => { take!($M, as dq8::geometry::Screw<_>, $next) };
    ($M:ty, matrix3 $next:ident) => { take!($M, as [[_; 3]; 3], $next) };
    ($M:ty, matrix3x4 $next:ident) => { take!($M, as [[_; 4]; 3], $next) };
    ($M:ty, matrix4 $next:ident) => { take!($M, as [[_; 4]; 4], $next) };
    // Numbers, or an array whose length is seen where it is used.
    ($M:ty, $shape:ident $next:ident) => { take!($M, as _, $next) };
    ($M:ty, as $type:ty, $next:ident) => {
        <$type as $crate::case::Flat<_>>::take(&mut $next)
    };
}

/// The numbers of an answer.
macro_rules! numbers {
    ($M:ty, number $value:expr) => { vec![$value] };
    ($M:ty, flag $value:expr) => { vec![$crate::geometry::entry::flag::<$M>($value)] };
    ($M:ty, point $value:expr) => { $value.to_vec() };
    ($M:ty, dual $value:expr) => {{ let dual = $value; vec![dual.real, dual.dual] }};
    ($M:ty, quat $value:expr) => {{ let [x, y, z, w] = $value.to_array(); vec![w, x, y, z] }};
    ($M:ty, axis_angle $value:expr) => {{
        let (axis, angle) = $value;
        [&axis[..], &[angle]].concat()
    }};
    ($M:ty, limb $value:expr) => {{
        let limb = $value;
        let last = vec![limb.bend, limb.missed];
        [numbers!($M, quat limb.upper), numbers!($M, quat limb.lower), last].concat()
    }};
    ($M:ty, motion $value:expr) => {{
        let [x, y, z, w, dx, dy, dz, dw] = $value.to_array();
        vec![w, x, y, z, dw, dx, dy, dz]
    }};
    ($M:ty, pose $value:expr) => {{
        let pose = $value;
        [numbers!($M, quat pose.rotation), pose.translation.to_vec()].concat()
    }};
    ($M:ty, plane $value:expr) => {{ let p = $value; [&p.normal[..], &[p.offset]].concat() }};
    ($M:ty, line $value:expr) => {{ let l = $value; [l.direction, l.moment].concat() }};
    ($M:ty, dual_vector $value:expr) => {{ let v = $value; [v.real, v.dual].concat() }};
    ($M:ty, rows $value:expr) => { $value.as_flattened().to_vec() };
    ($M:ty, map $value:expr) => {{
        let map = $value;
        [map.linear.as_flattened(), &map.translation].concat()
    }};
    ($M:ty, euler $value:expr) => {{
        let solution = $value;
        let lock = $crate::geometry::entry::flag::<$M>(solution.gimbal_lock);
        [&solution.angles.angles[..], &[lock]].concat()
    }};
    ($M:ty, polar $value:expr) => {{
        let polar = $value;
        let mirrors = $crate::geometry::entry::flag::<$M>(polar.mirrors);
        [&numbers!($M, quat polar.rotation)[..], polar.stretch.as_flattened(), &[mirrors]].concat()
    }};
    ($M:ty, decomposed $value:expr) => {{
        let (motion, stretch) = $value;
        [&numbers!($M, motion motion)[..], stretch.as_flattened()].concat()
    }};
    ($M:ty, perpendicular $value:expr) => {{
        let found = $value;
        let parallel = $crate::geometry::entry::flag::<$M>(found.parallel);
        let last = [found.angle.real, found.angle.dual, parallel];
        [&numbers!($M, line found.axis)[..], found.feet.as_flattened(), &last].concat()
    }};
}

/// The rows of an answer, none for an error.
macro_rules! scalar_answer {
    ($M:ty, $result:ident, plain $value:expr) => {
        $crate::geometry::entry::rows::<$M>(&numbers!($M, $result $value), 0)
    };
    ($M:ty, $result:ident, $how:ident $value:expr) => {
        match $value {
            Ok(value) => $crate::geometry::entry::rows::<$M>(&numbers!($M, $result value), 0),
            Err(_) => Vec::new(),
        }
    };
}

/// What there is on lanes.
macro_rules! on_lanes {
    (alone $($call:tt)*) => {
        None
    };
    ($how:ident $call:expr) => {
        Some($call)
    };
}

/// The rows of an answer, NaN where the mask holds.
macro_rules! lanes_answer {
    ($M:ty, $result:ident, plain $value:expr) => { scalar_answer!($M, $result, plain $value) };
    ($M:ty, $result:ident, tried $value:expr) => {{
        let (value, failed) = $value;
        let failed = <$M as $crate::sample::Sample>::bits(failed);
        $crate::geometry::entry::rows::<$M>(&numbers!($M, $result value), failed)
    }};
}

/// The text of the lanes: that of the scalar reference, if there is no other.
macro_rules! last {
    ($scalar:expr) => {
        $scalar
    };
    ($scalar:expr, $lanes:expr) => {
        $lanes
    };
}

/// How many numbers a shape has.
pub(super) fn length(shape: &str) -> usize {
    match shape {
        "number" | "order" | "integer" => 1,
        "dual" | "two" => 2,
        "point" => 3,
        "quat" | "unit_quat" | "plane" => 4,
        "line" | "dual_vector" | "twist" | "wrench" => 6,
        "unit_pose" => 7,
        "unit_motion" | "screw" => 8,
        "matrix3" => 9,
        "matrix3x4" => 12,
        "matrix4" => 16,
        _ => panic!("no shape {shape}"),
    }
}

/// The next number at each call: one type for all operations of `M`, so that what takes arguments
/// from it is compiled once.
pub(super) fn numbers_of<M: Sample>(rows: &[Row]) -> impl FnMut() -> M::Real {
    let mut rows = rows.iter();
    move || M::load(rows.next().expect("as many rows as numbers"))
}

/// One integer for all lanes.
pub(super) fn integer<M: Sample>(number: M::Real) -> i32 {
    M::store(number)[0] as i32
}

/// One order for all lanes: its place among all.
pub(super) fn order<M: Sample>(number: M::Real) -> EulerOrder {
    EulerOrder::ALL[integer::<M>(number) as usize]
}

/// 1 where a mask holds, and 0 elsewhere.
pub(super) fn flag<M: Sample>(mask: M::Mask) -> M::Real {
    let bits = M::bits(mask);
    M::load(&std::array::from_fn(|lane| f64::from(bits >> lane & 1)))
}

pub(super) fn rows<M: Sample>(numbers: &[M::Real], failed: u32) -> Vec<Row> {
    let row = |&number: &M::Real| {
        let row = M::store(number);
        std::array::from_fn(|lane| if failed >> lane & 1 == 1 { f64::NAN } else { row[lane] })
    };
    numbers.iter().map(row).collect()
}

//! What one line of a [table](crate::geometry) becomes: an operation, and a function on rows for the scalar
//! reference and one for lanes.

use crate::lanes::Row;
use crate::sample::Sample;
use dq8::representation::EulerOrder;

/// Everything that the lines of a table become.
macro_rules! geometry {
    ($($name:literal($($field:ident: $shape:ident),*) -> $result:ident, $scales:expr,
        [$($bound:expr),* $(,)?], $how:ident $scalar:expr $(, $lanes:expr)?;)*) => {
        pub(super) const OPERATIONS: &[$crate::geometry::Operation] =
            &[$($crate::geometry::Operation {
                name: $name,
                fields: &[$((stringify!($field), length!($shape))),*],
                scales: $scales,
                bounds: &[$($bound),*],
            }),*];

        pub(super) struct Scalar<R>(std::marker::PhantomData<R>);

        impl<R: dq8::Real> Scalar<R> {
            pub(super) const CALLS: &'static [$crate::geometry::Call] = &[$(|given| {
                type M<R> = dq8::DualQuat<R>;
                let mut rows = given.iter();
                $(let $field = take!(M<R>, $shape rows);)*
                scalar_answer!(M<R>, $result, $how $scalar)
            }),*];
        }

        pub(super) struct OnLanes<L>(std::marker::PhantomData<L>);

        impl<L: dq8::Lanes<Level: $crate::sample::Proof>> OnLanes<L> {
            pub(super) const CALLS: &'static [$crate::geometry::Call] = &[$(|given| {
                type M<L> = dq8::batch::DualQuat<L>;
                let mut rows = given.iter();
                $(let $field = take!(M<L>, $shape rows);)*
                lanes_answer!(M<L>, $result, $how last!($scalar $(, $lanes)?))
            }),*];
        }
    };
}

/// How many numbers a shape has.
macro_rules! length {
    (number) => {
        1
    };
    (order) => {
        1
    };
    (dual) => {
        2
    };
    (point) => {
        3
    };
    (quat) => {
        4
    };
    (unit_quat) => {
        4
    };
    (plane) => {
        4
    };
    (line) => {
        6
    };
    (dual_vector) => {
        6
    };
    (twist) => {
        6
    };
    (wrench) => {
        6
    };
    (unit_pose) => {
        7
    };
    (unit_motion) => {
        8
    };
    (screw) => {
        8
    };
    (matrix3) => {
        9
    };
    (matrix3x4) => {
        12
    };
    (matrix4) => {
        16
    };
}

/// An argument of `M` from the next rows.
macro_rules! take {
    ($M:ty, order $rows:ident) => { $crate::geometry::entry::order($rows.next()) };
    ($M:ty, quat $rows:ident) => {{
        let [w, x, y, z] = take!($M, numbers $rows);
        <$M as $crate::sample::Sample>::quat([x, y, z, w])
    }};
    ($M:ty, unit_quat $rows:ident) => { take!($M, quat $rows).normalize() };
    ($M:ty, unit_pose $rows:ident) => {{
        let rotation = take!($M, unit_quat $rows);
        (rotation, take!($M, numbers $rows))
    }};
    ($M:ty, unit_motion $rows:ident) => {{
        let [pw, px, py, pz, qw, qx, qy, qz] = take!($M, numbers $rows);
        <$M as $crate::sample::Sample>::motion([px, py, pz, pw, qx, qy, qz, qw]).normalize()
    }};
    ($M:ty, dual $rows:ident) => {{
        let [real, dual] = take!($M, numbers $rows);
        <$M as $crate::sample::Sample>::dual_number(real, dual)
    }};
    ($M:ty, point $rows:ident) => { take!($M, as [_; 3], $rows) };
    ($M:ty, line $rows:ident) => { take!($M, as dq8::Line<_>, $rows) };
    ($M:ty, plane $rows:ident) => { take!($M, as dq8::Plane<_>, $rows) };
    ($M:ty, matrix3 $rows:ident) => { take!($M, as [[_; 3]; 3], $rows) };
    ($M:ty, matrix3x4 $rows:ident) => { take!($M, as [[_; 4]; 3], $rows) };
    ($M:ty, matrix4 $rows:ident) => { take!($M, as [[_; 4]; 4], $rows) };
    // Numbers, or an array whose length is seen where it is used.
    ($M:ty, $shape:ident $rows:ident) => { take!($M, as _, $rows) };
    ($M:ty, as $type:ty, $rows:ident) => {
        <$type as $crate::case::Flat<_>>::take(&mut || {
            $crate::geometry::entry::next::<$M>(&mut $rows)
        })
    };
}

/// The numbers of an answer.
macro_rules! numbers {
    ($M:ty, number $value:expr) => { vec![$value] };
    ($M:ty, flag $value:expr) => { vec![$crate::geometry::entry::flag::<$M>($value)] };
    ($M:ty, point $value:expr) => { $value.to_vec() };
    ($M:ty, dual $value:expr) => {{ let dual = $value; vec![dual.real, dual.dual] }};
    ($M:ty, quat $value:expr) => {{ let [x, y, z, w] = $value.to_array(); vec![w, x, y, z] }};
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
    ($M:ty, $result:ident, tried $value:expr) => {
        match $value {
            Ok(value) => $crate::geometry::entry::rows::<$M>(&numbers!($M, $result value), 0),
            Err(_) => Vec::new(),
        }
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

pub(super) fn next<'r, M: Sample>(rows: &mut impl Iterator<Item = &'r Row>) -> M::Real {
    M::load(rows.next().expect("as many rows as numbers"))
}

/// One order for all lanes: its place among all.
pub(super) fn order(row: Option<&Row>) -> EulerOrder {
    EulerOrder::ALL[row.expect("as many rows as numbers")[0] as usize]
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

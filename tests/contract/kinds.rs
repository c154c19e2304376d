//! The kinds of arguments and answers that the [table](crate::operations) is written in: how each
//! is picked from a case, made of rows, and turned into rows.

use crate::bound::Kind;
use crate::case::Flat;
use crate::implementation::On;
use crate::lanes::{Reals, Row};
use crate::operation::{Answer, Domain};
use crate::sample::Sample;

/// The numbers of an argument in a case.
macro_rules! pick {
    ($x:ident, $on:ident, rotation $motion:ident) => { $x.$motion[..4].to_vec() };
    ($x:ident, $on:ident, any_rotation $motion:ident) => { $x.$motion[..4].to_vec() };
    ($x:ident, $on:ident, angular $name:ident $twist:ident) => { $x.$twist[..3].to_vec() };
    ($x:ident, $on:ident, linear $name:ident $twist:ident) => { $x.$twist[3..].to_vec() };
    ($x:ident, $on:ident, influences $weights:ident $($motion:ident)+) => {{
        let pairs = [$($x.$motion),+].into_iter().zip($x.$weights);
        pairs.flat_map(|(motion, weight)| motion.into_iter().chain([weight])).collect()
    }};
    // Smaller steps than this are rounding.
    ($x:ident, $on:ident, settled $name:ident) => { vec![16.0 * $on.roundoff()] };
    ($x:ident, $on:ident, at_most $name:ident) => { vec![32.0] };
    ($x:ident, $on:ident, level $name:ident) => { Vec::new() };
    ($x:ident, $on:ident, $kind:ident $($field:ident)+) => {{
        let mut flat = Vec::new();
        $($crate::case::Flat::put(&$x.$field, &mut flat);)+
        flat
    }};
}

/// Which dual quaternions an argument of this kind may be, and how many numbers it is.
pub(crate) const fn domain(kind: &str) -> (Domain, usize) {
    match kind.as_bytes() {
        b"any" => (Domain::Any, 8),
        b"unit" => (Domain::Unit, 8),
        b"influences" => (Domain::Unit, 9),
        b"rotation" => (Domain::Rotation, 4),
        b"dual" => (Domain::Other, 2),
        b"vector" | b"angular" | b"linear" => (Domain::Other, 3),
        b"any_rotation" | b"plane" => (Domain::Other, 4),
        b"line" | b"dual_vector" | b"twist" | b"wrench" => (Domain::Other, 6),
        b"screw" => (Domain::Other, 8),
        b"rows" => (Domain::Other, 12),
        _ => (Domain::Other, 1),
    }
}

/// The type of an argument under the names of [`lanes`](crate::lanes).
macro_rules! argument {
    (any) => { Motions };
    (unit) => { Motions };
    (rotation) => { [Reals; 4] };
    (any_rotation) => { [Reals; 4] };
    (influences) => { &[(Motions, Reals)] };
    (vector) => { [Reals; 3] };
    (angular) => { [Reals; 3] };
    (linear) => { [Reals; 3] };
    (plane) => { Plane<Reals> };
    (dual) => { [Reals; 2] };
    (line) => { Line<Reals> };
    (dual_vector) => { DualVector<Reals> };
    (twist) => { Twist<Reals> };
    (wrench) => { Wrench<Reals> };
    (screw) => { Screw<Reals> };
    (rows) => { [[Reals; 4]; 3] };
    (at_most) => { u32 };
    (level) => { () };
    ($number:ident) => { Reals };
}

/// An argument as `M` wants it, of its rows.
#[rustfmt::skip]
macro_rules! give {
    ($M:ident, any $rows:expr) => { $M::motion(numbers::<$M, _>($rows)) };
    ($M:ident, unit $rows:expr) => { $M::motion(numbers::<$M, _>($rows)) };
    ($M:ident, rotation $rows:expr) => { $M::quat(numbers::<$M, _>($rows)) };
    ($M:ident, any_rotation $rows:expr) => { $M::quat(numbers::<$M, _>($rows)) };
    ($M:ident, influences $rows:expr) => { &influences::<$M>($rows)[..] };
    ($M:ident, dual $rows:expr) => {{
        let [real, dual] = numbers::<$M, _>($rows);
        $M::dual_number(real, dual)
    }};
    ($M:ident, at_most $rows:expr) => { $rows[0][0] as u32 };
    ($M:ident, level $rows:expr) => {{
        let _ = $rows;
        $M::level()
    }};
    ($M:ident, $kind:ident $rows:expr) => { numbers::<$M, _>($rows) };
}

/// The rows of an argument under the names of [`lanes`](crate::lanes).
macro_rules! pass {
    (influences $value:ident) => {
        $value
            .iter()
            .flat_map(|(motion, weight)| [rows_of(motion), rows_of(weight)].concat())
            .collect()
    };
    (at_most $value:ident) => {
        vec![[f64::from($value); MAX_LANES]]
    };
    (level $value:ident) => {{
        let () = $value;
        Vec::new()
    }};
    ($kind:ident $value:ident) => {
        rows_of(&$value)
    };
}

/// An answer under the names of [`lanes`](crate::lanes).
macro_rules! read {
    (checked $on:ident $answer:ident) => {
        ($answer.geometry($on), $answer.masks[0])
    };
    (mask $on:ident $answer:ident) => {{
        let _ = $on;
        $answer.masks[0]
    }};
    (blend $on:ident $answer:ident) => {
        (!$answer.none).then(|| $answer.geometry($on))
    };
    (mean $on:ident $answer:ident) => {
        (!$answer.none).then(|| {
            let iterations = Reals { on: $on, row: $answer.numbers[8].1 };
            Mean { motion: $answer.geometry($on), iterations, converged: $answer.masks[0] }
        })
    };
    (velocity $on:ident $answer:ident) => {{
        let twist: Twist<Reals> = $answer.geometry($on);
        (twist.angular, twist.linear)
    }};
    ($kind:ident $on:ident $answer:ident) => {
        $answer.geometry($on)
    };
}

/// The type of an answer under the names of [`lanes`](crate::lanes).
macro_rules! answer {
    (motion) => { Motions };
    (unit) => { Motions };
    (small_motion) => { Motions };
    (checked) => { (Motions, u32) };
    (blend) => { Option<Motions> };
    (mean) => { Option<Mean<Motions, Reals, u32>> };
    (mask) => { u32 };
    (quat) => { [Reals; 4] };
    (dual) => { [Reals; 2] };
    (point) => { [Reals; 3] };
    (direction) => { [Reals; 3] };
    (line) => { Line<Reals> };
    (plane) => { Plane<Reals> };
    (screw) => { Screw<Reals> };
    (log) => { DualVector<Reals> };
    (twist) => { Twist<Reals> };
    (wrench) => { Wrench<Reals> };
    (velocity) => { ([Reals; 3], [Reals; 3]) };
    (matrix3x4) => { [[Reals; 4]; 3] };
    (matrix4) => { [[Reals; 4]; 4] };
    ($number:ident) => { Reals };
}

/// The rows of what `M` answers.
#[rustfmt::skip]
macro_rules! receive {
    ($M:ident, motion $of:expr) => { motion::<$M>($of) };
    ($M:ident, unit $of:expr) => { motion::<$M>($of) };
    ($M:ident, small_motion $of:expr) => { small_motion::<$M>($of) };
    ($M:ident, checked $of:expr) => {{
        let (motion_, failed) = $of;
        motion::<$M>(motion_).mask($M::bits(failed))
    }};
    ($M:ident, blend $of:expr) => { $of.map_or_else(none, motion::<$M>) };
    ($M:ident, mean $of:expr) => {
        $of.map_or_else(none, |mean: Mean<$M, $M::Real, $M::Mask>| {
            let answer = motion::<$M>(mean.motion).and::<$M>(Kind::Count, &mean.iterations);
            answer.mask($M::bits(mean.converged))
        })
    };
    ($M:ident, mask $of:expr) => { Answer::default().mask($M::bits($of)) };
    ($M:ident, quat $of:expr) => { Answer::default().and::<$M>(Kind::Plain, &$M::quat_parts($of)) };
    ($M:ident, dual $of:expr) => {{
        let [real, dual] = $M::dual_parts($of);
        Answer::default().and::<$M>(Kind::Plain, &real).and::<$M>(Kind::Length, &dual)
    }};
    ($M:ident, point $of:expr) => { Answer::default().and::<$M>(Kind::Length, &$of) };
    ($M:ident, length $of:expr) => { Answer::default().and::<$M>(Kind::Length, &$of) };
    ($M:ident, direction $of:expr) => { Answer::default().and::<$M>(Kind::Plain, &$of) };
    ($M:ident, angle $of:expr) => { Answer::default().and::<$M>(Kind::Plain, &$of) };
    ($M:ident, line $of:expr) => {{
        let line = $of;
        two::<$M>(Kind::Plain, &line.direction, Kind::Length, &line.moment)
    }};
    ($M:ident, plane $of:expr) => {{
        let plane = $of;
        two::<$M>(Kind::Plain, &plane.normal, Kind::Length, &plane.offset)
    }};
    ($M:ident, screw $of:expr) => {{
        let screw = $of;
        two::<$M>(Kind::Plain, &screw.axis.direction, Kind::Moment, &screw.axis.moment)
            .and::<$M>(Kind::Turn, &screw.angle)
            .and::<$M>(Kind::Length, &screw.slide)
    }};
    ($M:ident, log $of:expr) => {{
        let log = $of;
        two::<$M>(Kind::Turn, &log.real, Kind::Length, &log.dual)
    }};
    ($M:ident, twist $of:expr) => {{
        let twist = $of;
        two::<$M>(Kind::Plain, &twist.angular, Kind::Length, &twist.linear)
    }};
    ($M:ident, wrench $of:expr) => {{
        let wrench = $of;
        two::<$M>(Kind::Plain, &wrench.force, Kind::Length, &wrench.torque)
    }};
    ($M:ident, velocity $of:expr) => {{
        let (angular, linear) = $of;
        two::<$M>(Kind::Plain, &angular, Kind::Length, &linear)
    }};
    ($M:ident, matrix3x4 $of:expr) => { matrix::<$M>(&$of) };
    ($M:ident, matrix4 $of:expr) => { matrix::<$M>(&$of) };
}

pub(crate) use {answer, argument, give, pass, pick, read, receive};

/// Geometry of the numbers of `M`.
pub(crate) fn numbers<M: Sample, F: Flat<M::Real>>(rows: &[Row]) -> F {
    let mut rows = rows.iter();
    F::take(&mut || M::load(rows.next().expect("as many rows as numbers")))
}

/// Motions with their weights, nine rows for each.
pub(crate) fn influences<M: Sample>(rows: &[Row]) -> Vec<(M, M::Real)> {
    let influences = rows.chunks_exact(9);
    influences.map(|rows| (M::motion(numbers::<M, _>(&rows[..8])), M::load(&rows[8]))).collect()
}

impl Answer {
    pub(crate) fn and<M: Sample>(mut self, kind: Kind, part: &impl Flat<M::Real>) -> Self {
        let mut reals = Vec::new();
        part.put(&mut reals);
        self.numbers.extend(reals.into_iter().map(|real| (kind, M::store(real))));
        self
    }

    pub(crate) fn mask(mut self, bits: u32) -> Self {
        self.masks.push(bits);
        self
    }

    /// Its numbers as geometry.
    pub(crate) fn geometry<F: Flat<Reals>>(&self, on: On) -> F {
        let mut rows = self.numbers.iter();
        F::take(&mut || Reals { on, row: rows.next().expect("as many rows as numbers").1 })
    }
}

pub(crate) fn none() -> Answer {
    Answer { none: true, ..Answer::default() }
}

pub(crate) fn two<M: Sample>(
    kind: Kind,
    part: &impl Flat<M::Real>,
    other_kind: Kind,
    other: &impl Flat<M::Real>,
) -> Answer {
    Answer::default().and::<M>(kind, part).and::<M>(other_kind, other)
}

pub(crate) fn motion<M: Sample>(motion: M) -> Answer {
    let [px, py, pz, pw, qx, qy, qz, qw] = motion.components();
    two::<M>(Kind::Plain, &[px, py, pz, pw], Kind::Length, &[qx, qy, qz, qw])
}

/// A motion whose rotation may be tiny, and keeps its relative precision.
pub(crate) fn small_motion<M: Sample>(motion_: M) -> Answer {
    let mut answer = motion(motion_);
    for (kind, _) in &mut answer.numbers[..3] {
        *kind = Kind::Turn;
    }
    answer
}

/// Rows of [R | t].
pub(crate) fn matrix<M: Sample>(rows: &[[M::Real; 4]]) -> Answer {
    rows.iter().fold(Answer::default(), |answer, [x, y, z, t]| {
        answer.and::<M>(Kind::Plain, &[*x, *y, *z]).and::<M>(Kind::Length, t)
    })
}

/// The rows of geometry.
pub(crate) fn rows_of(part: &impl Flat<Reals>) -> Vec<Row> {
    let mut reals = Vec::new();
    part.put(&mut reals);
    reals.into_iter().map(|real: Reals| real.row).collect()
}

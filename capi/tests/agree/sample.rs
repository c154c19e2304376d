//! Numbers to compute with, and the comparison.

use dq8::simd::{Block, Row};
use dq8::{DualQuat, Quat, Real};
use dq8_capi::Status;
use std::fmt::Debug;

pub(crate) const PARENTS: [i32; 4] = [-1, 0, 1, 0];
pub(crate) const JOINTS: usize = PARENTS.len();
/// Three instances: less than a block of any lanes, and an odd number.
pub(crate) const COUNT: usize = 3 * JOINTS;

pub(crate) fn wave<R: Real>(i: usize, seed: f64) -> R {
    R::from_f64((i as f64 * 1.7 + seed).sin())
}

pub(crate) fn rotation<R: Real>(i: usize, seed: f64) -> Quat<R> {
    Quat::from_array([0.1, 0.9, 2.0, 3.3].map(|more| wave(i, seed + more))).normalize()
}

pub(crate) fn vector<R: Real>(i: usize, seed: f64) -> [R; 3] {
    [4.0, 5.2, 6.1].map(|more| wave(i, seed + more))
}

/// [`COUNT`] unit motions.
pub(crate) fn motions<R: Real>(seed: f64) -> Vec<DualQuat<R>> {
    let one = |i| DualQuat::from_rotation_translation(rotation(i, seed), vector(i, seed));
    (0..COUNT).map(one).collect()
}

pub(crate) fn block<A: Row, const C: usize>(of: impl Fn(usize) -> [A::Real; C]) -> Block<A, C> {
    let mut block = Block::splat(of(0));
    for lane in 1..A::LANES {
        assert!(block.set(lane, of(lane)).is_ok());
    }
    block
}

/// As C sees an array.
pub(crate) fn numbers<T, R>(values: &[T]) -> *const R {
    values.as_ptr().cast()
}

/// The tests of a file for both number types, each with the lanes that its blocks may have.
macro_rules! for_all_lanes {
    ($agree:ident) => {
        $agree!(single_eight, f32, single, 8);
        $agree!(single_sixteen, f32, single, 16);
        $agree!(double_four, f64, double, 4);
        $agree!(double_eight, f64, double, 8);
    };
}
pub(crate) use for_all_lanes;

/// The C function makes of `start` what the Rust one makes of it, and not nothing.
#[track_caller]
pub(crate) fn compare<T: Clone + PartialEq + Debug, R>(
    what: &str,
    start: &[T],
    c: impl FnOnce(*mut R) -> Status,
    rust: impl FnOnce(&mut [T]),
) {
    let (mut got, mut wanted) = (start.to_vec(), start.to_vec());
    assert_eq!(c(got.as_mut_ptr().cast()), Status::Ok, "{what}");
    rust(&mut wanted);
    assert_eq!(got, wanted, "{what}");
    assert_ne!(wanted, start, "{what}: nothing happened");
}

/// [`compare`] for many: of an output `o` that begins as `start`, `start, C function => Rust function;`, called by the text
/// of the C function. A macro, for closures would take six lines for each.
macro_rules! same {
    (|$o:ident| $($start:expr, $c:expr => $rust:expr;)+) => {
        $($crate::sample::compare(stringify!($c), $start, |$o| $c, |$o| $rust);)+
    };
}
pub(crate) use same;

//! Random input and comparison for the tests of the laboratory.

use dq8::{DualQuat, Quat, Twist};
use proptest::prelude::Strategy;

/// Numbers from −`limit` to `limit`.
pub(crate) fn reals<const N: usize>(limit: f64) -> impl Strategy<Value = [f64; N]> {
    proptest::array::uniform::<_, N>(-limit..limit)
}

/// Twists with components from −`limit` to `limit`.
pub(crate) fn twist(limit: f64) -> impl Strategy<Value = Twist<f64>> {
    reals(limit).prop_map(Twist::from_array)
}

/// Any rotation, and a translation with components from −2 to 2.
pub(crate) fn motion() -> impl Strategy<Value = DualQuat<f64>> {
    (reals::<4>(1.0), reals(2.0))
        .prop_map(|(q, t)| (Quat::from_array(q), t))
        .prop_filter("a direction", |(q, _)| q.norm() > 0.1)
        .prop_map(|(q, t)| DualQuat::from_rotation_translation(q.normalize(), t))
}

/// Every component within `tolerance` of the wanted one.
#[track_caller]
pub(crate) fn assert_close<const N: usize>(found: [f64; N], wanted: [f64; N], tolerance: f64) {
    for (i, (a, b)) in found.into_iter().zip(wanted).enumerate() {
        assert!((a - b).abs() <= tolerance, "{i}: {a} for {b}, off by {:e}", (a - b).abs());
    }
}

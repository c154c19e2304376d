//! Strategies of proptest for rotations and motions. The rotations are uniform, but the identity
//! and half turns come more often than by chance, because errors are likely there.

use crate::number::Real;
use crate::scalar::{DualQuat, Quat};
use proptest::prelude::{Just, Strategy, prop_oneof};

/// Returns a strategy for unit quaternions.
///
/// ```
/// use proptest::prelude::*;
/// proptest!(|(rotation in dq8::interop::proptest::rotations::<f64>())| {
///     prop_assert!(rotation.is_normalized());
/// });
/// ```
pub fn rotations<R: Real>() -> impl Strategy<Value = Quat<R>> {
    let half = |xyzw: [f32; 4]| Just(xyzw.map(f64::from));
    let drawn = proptest::array::uniform4(-1.0_f64..=1.0).prop_filter(
        "in the ball, and not too short to have a direction",
        |xyzw| {
            let square: f64 = xyzw.iter().map(|c| c * c).sum();
            (1e-6..=1.0).contains(&square)
        },
    );
    prop_oneof![
        1 => half([0.0, 0.0, 0.0, 1.0]),
        1 => half([1.0, 0.0, 0.0, 0.0]),
        1 => half([0.0, -1.0, 0.0, 0.0]),
        13 => drawn,
    ]
    .prop_map(|xyzw| Quat::from_array(xyzw.map(R::from_f64)).normalize())
}

/// Returns a strategy for unit dual quaternions with translations whose coordinates are at most
/// `reach`.
pub fn motions<R: Real>(reach: f64) -> impl Strategy<Value = DualQuat<R>> {
    let translation = proptest::array::uniform3(-1.0_f64..=1.0);
    (rotations(), translation).prop_map(move |(rotation, direction)| {
        let translation = direction.map(|c| R::from_f64(c * reach));
        DualQuat::from_rotation_translation(rotation, translation)
    })
}

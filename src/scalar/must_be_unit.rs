//! The check of the precondition "must be unit", which operations of `scalar::Quat` and
//! `scalar::DualQuat` call first. In debug builds with `--cfg dq8_debug_assert_unit`, it panics if
//! the input is clearly not unit; in all other builds these functions do nothing. Values that are
//! not finite pass the check, because they make the result not finite, too.

use crate::number::Real;

/// The largest error of |p|², and of p·q relative to max(1, |q|), that the check accepts. Drift
/// stays far below this limit, and a forgotten normalization exceeds it.
const PLAINLY: f64 = 0.1;
const JUDGES: bool = cfg!(all(dq8_debug_assert_unit, debug_assertions));

/// Checks that dual quaternions p + εq have |p| = 1 and p·q = 0.
#[track_caller]
#[inline(always)]
pub(crate) fn motions<R: Real, const N: usize>(operation: &str, motions: [impl AsRef<[R; 8]>; N]) {
    if !JUDGES {
        return;
    }
    for motion in &motions {
        let [px, py, pz, pw, qx, qy, qz, qw] = motion.as_ref().map(R::into);
        let (p, q) = ([px, py, pz, pw], [qx, qy, qz, qw]);
        length(operation, "motion", p);
        let along = dot(p, q);
        let off = along.is_finite() && along * along > PLAINLY * PLAINLY * dot(q, q).max(1.0);
        assert!(!off, "{operation} takes a unit motion, but here p·q is {along} and not 0");
    }
}

/// Checks that quaternions q have |q| = 1.
#[track_caller]
#[inline(always)]
pub(crate) fn rotations<R: Real, const N: usize>(
    operation: &str,
    rotations: [impl AsRef<[R; 4]>; N],
) {
    if !JUDGES {
        return;
    }
    for rotation in &rotations {
        length(operation, "quaternion", rotation.as_ref().map(R::into));
    }
}

/// Checks that the vector `axis` has length 1.
#[track_caller]
#[inline(always)]
pub(crate) fn axis<R: Real>(operation: &str, axis: [R; 3]) {
    if JUDGES {
        length(operation, "axis", axis.map(R::into));
    }
}

#[track_caller]
fn length<const N: usize>(operation: &str, what: &str, components: [f64; N]) {
    let squared = dot(components, components);
    let off = components.iter().all(|c| c.is_finite()) && (squared - 1.0).abs() > PLAINLY;
    assert!(!off, "{operation} takes a unit {what}, but here the squared norm is {squared}");
}

fn dot<const N: usize>(a: [f64; N], b: [f64; N]) -> f64 {
    a.into_iter().zip(b).map(|(a, b)| a * b).sum()
}

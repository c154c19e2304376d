//! The peers: forward kinematics of all links, each peer in its own types, held to dq8's poses
//! before it is timed.

pub mod by_hand;
#[cfg(feature = "peers")]
pub mod dynibo;
#[cfg(feature = "peers")]
pub mod k;

use dq8::DualQuat;

/// Holds the position and the rotation (x, y, z, w) of every link of every configuration to dq8's.
fn agree(name: &str, tolerance: f64, expected: &[DualQuat<f64>], theirs: &[([f64; 3], [f64; 4])]) {
    assert_eq!(theirs.len(), expected.len(), "{name}");
    for (pose, (position, rotation)) in expected.iter().zip(theirs) {
        let turn = pose.rotation().to_array();
        let cosine: f64 = turn.iter().zip(rotation).map(|(a, b)| a * b).sum();
        // A rotation and its negative are one.
        let same = rotation.map(|number| number * cosine.signum());
        let of = |ours: &[f64], theirs: &[f64]| -> f64 {
            ours.iter().zip(theirs).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
        };
        let error = of(&pose.translation(), position).max(of(&turn, &same));
        assert!(error < tolerance, "{name}: {error}");
    }
}

//! The worst that may come in.

use super::scene::{dual, linear};
use core::f64::consts::{PI, TAU};
use dq8::skinning::Skin;
use dq8::{Backend, DualQuat, Quat};
use dq8_contract::random::Random;

/// Unit motions at and next to half and full turns, equal and opposite; weights equal, tiny, zero but for one,
/// and far from a sum of one.
#[test]
fn a_million_vertices_without_a_nan() {
    let mut random = Random(77);
    let mut motions = Vec::new();
    for axis in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], random.direction()] {
        for angle in [0.0, 1e-6, PI - 1e-6, PI, PI + 1e-6, TAU] {
            let turn = Quat::from_axis_angle(axis.map(|c| c as f32), angle as f32);
            let far = if random.between(0.0, 1.0) < 0.1 { 1e6 } else { 1.0 };
            let slide = random.direction().map(|c| (c * far) as f32);
            let motion = DualQuat::from_rotation_translation(turn, slide).normalize();
            motions.extend([motion, -motion]);
        }
    }
    let matrices: Vec<_> = motions.iter().map(|motion| motion.to_matrix3x4()).collect();
    let vertices = 1_000_000;
    let (mut joints, mut weights) = (Vec::new(), Vec::new());
    for vertex in 0..vertices {
        let scale = [1.0, 1e-2, 500.0][vertex % 3];
        for influence in 0..4 {
            joints.push(random.between(0.0, motions.len() as f64) as u16);
            weights.push(match random.between(0.0, 6.0) as u32 {
                _ if influence == vertex % 4 => 0.25 * scale as f32,
                0 => 0.0,
                1 => 1e-30,
                2 | 3 => 0.25 * scale as f32,
                _ => (random.between(0.0, 0.25) * scale) as f32,
            });
        }
    }
    let skin = Skin::new(motions.len(), 4, &joints, &weights).unwrap();
    let rest: Vec<_> = (0..vertices).map(|_| random.direction().map(|c| c as f32)).collect();
    for backend in Backend::available() {
        for posed in
            [dual(backend, &skin, &motions, &rest), linear(backend, &skin, &matrices, &rest)]
        {
            let bad = posed.iter().position(|point| point.iter().any(|c| !c.is_finite()));
            assert_eq!(bad, None, "{backend}");
        }
    }
}

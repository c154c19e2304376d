//! A tube of two joints.

use super::scene::posed;
use dq8::skinning::{DualBlend, Linear, Skin};
use dq8::{Backend, DualQuat, Quat};

const RINGS: usize = 129;
const AROUND: usize = 64;

/// Six times the volume is the sum over triangles of the determinants of their corners.
fn volume(points: &[[f32; 3]]) -> f64 {
    let point = |ring: usize, i: usize| points[ring * AROUND + i % AROUND].map(f64::from);
    let mut sum = 0.0;
    let mut add = |[a, b, c]: [[f64; 3]; 3]| {
        sum += a[0] * (b[1] * c[2] - b[2] * c[1])
            + a[1] * (b[2] * c[0] - b[0] * c[2])
            + a[2] * (b[0] * c[1] - b[1] * c[0]);
    };
    for i in 0..AROUND {
        for ring in 0..RINGS - 1 {
            add([point(ring, i), point(ring, i + 1), point(ring + 1, i)]);
            add([point(ring, i + 1), point(ring + 1, i + 1), point(ring + 1, i)]);
        }
        add([[0.0, 0.0, 0.0], point(0, i + 1), point(0, i)]);
        add([[0.0, 0.0, 4.0], point(RINGS - 1, i), point(RINGS - 1, i + 1)]);
    }
    sum / 6.0
}

#[test]
fn a_tube_twisted_by_half_a_turn_keeps_its_volume() {
    let (mut points, mut joints, mut weights) = (Vec::new(), Vec::new(), Vec::new());
    for ring in 0..RINGS {
        let share = ring as f32 / (RINGS - 1) as f32;
        for i in 0..AROUND {
            let (sin, cos) = (core::f32::consts::TAU * i as f32 / AROUND as f32).sin_cos();
            points.push([cos, sin, 4.0 * share]);
            joints.extend([0_u16, 1]);
            weights.extend([1.0 - share, share]);
        }
    }
    let skin = Skin::new(2, 2, &joints, &weights).unwrap();
    let twist = Quat::from_axis_angle([0.0, 0.0, 1.0], core::f32::consts::PI);
    let palette = [DualQuat::IDENTITY, DualQuat::from_rotation(twist)];
    let matrices = palette.map(|motion| motion.to_matrix3x4());
    let rest = volume(&points);
    for backend in Backend::available() {
        let kept = volume(&posed(backend, &skin, DualBlend::new(&palette), &points)) / rest;
        assert!((kept - 1.0).abs() < 0.02, "{backend}: {kept} of the volume");
        // (1 − 2t)² of each cross-section: a third.
        let collapsed = volume(&posed(backend, &skin, Linear::new(&matrices), &points)) / rest;
        assert!((collapsed - 1.0 / 3.0).abs() < 0.01, "{backend}: {collapsed} of the volume");
    }
}

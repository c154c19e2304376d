//! The worst that may come in.

use super::scene::posed;
use core::f64::consts::{PI, TAU};
use dq8::skinning::{DualBlend, Linear, Skin};
use dq8::{Backend, DualQuat, Quat};
use dq8_contract::random::Random;

const PALETTES: usize = 1000;
const VERTICES: usize = 1000;

/// A unit motion at or next to a half or full turn, about an axis that others share; some are far.
fn motion(random: &mut Random) -> DualQuat<f32> {
    let axis = match random.below(6) {
        3.. => random.direction(),
        own => core::array::from_fn(|i| f64::from(u8::from(i == own))),
    };
    let near = [0.0, 1e-30, 1e-6, -1e-6][random.below(4)];
    let angle = [0.0, PI, TAU, random.between(0.0, TAU)][random.below(4)] + near;
    let turn = Quat::from_axis_angle(axis.map(|c| c as f32), angle as f32);
    let far = if random.between(0.0, 1.0) < 0.1 { 1e6 } else { 1.0 };
    let slide = random.direction().map(|c| (c * far) as f32);
    DualQuat::from_rotation_translation(turn, slide).normalize()
}

#[test]
fn a_million_vertices_on_a_thousand_palettes_without_a_nan() {
    // In two threads, because nothing else is left to test by then.
    std::thread::scope(|scope| {
        for first in [0, 1] {
            scope.spawn(move || (first..PALETTES).step_by(2).for_each(a_palette_without_a_nan));
        }
    });
}

/// Motions that are equal and opposite, in pairs; weights equal, tiny, zero but for one, and far
/// from a sum of one.
fn a_palette_without_a_nan(palette: usize) {
    let mut random = Random(77 + palette as u64);
    let joint_count = 2 + 2 * (palette % 24);
    let mut motions = Vec::new();
    while motions.len() < joint_count {
        let motion = motion(&mut random);
        motions.extend([motion, -motion]);
    }
    let matrices: Vec<_> = motions.iter().map(|motion| motion.to_matrix3x4()).collect();
    let (mut joints, mut weights) = (Vec::new(), Vec::new());
    for vertex in 0..VERTICES {
        let scale = [1.0, 1e-2, 500.0][vertex % 3];
        for influence in 0..4 {
            joints.push(random.below(joint_count) as u16);
            weights.push(match random.below(6) {
                _ if influence == vertex % 4 => 0.25 * scale as f32,
                0 => 0.0,
                1 => 1e-30,
                2 | 3 => 0.25 * scale as f32,
                _ => (random.between(0.0, 0.25) * scale) as f32,
            });
        }
    }
    let skin = Skin::new(joint_count, 4, &joints, &weights).unwrap();
    let rest: Vec<_> = (0..VERTICES).map(|_| random.direction().map(|c| c as f32)).collect();
    for backend in Backend::available() {
        for posed in [
            posed(backend, &skin, DualBlend::new(&motions), &rest),
            posed(backend, &skin, Linear::new(&matrices), &rest),
        ] {
            let bad = posed.iter().position(|point| point.iter().any(|c| !c.is_finite()));
            assert_eq!(bad, None, "{backend}, palette {palette}");
        }
    }
}

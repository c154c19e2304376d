//! A sleeve over an elbow: a mesh in arrays follows two joints, by linear and dual quaternion
//! blends.
//!
//! ```sh
//! cargo run --release --example skinning
//! ```

use dq8::skinning::{DualBlend, Linear, Skin, Surface, SurfaceMut};
use dq8::{Backend, DualQuat, Quat, Skeleton, hierarchy::Poses};
use std::error::Error;

/// Rings of eight vertices along x from −1 to 1, of radius 0.2.
fn sleeve() -> Vec<[f32; 3]> {
    let vertex = |i: u8| {
        let (sin, cos) = (f32::from(i % 8) * core::f32::consts::FRAC_PI_4).sin_cos();
        [f32::from(i / 8) * 0.1 - 1.0, 0.2 * sin, 0.2 * cos]
    };
    (0..21 * 8).map(vertex).collect()
}

fn main() -> Result<(), Box<dyn Error>> {
    let rest = sleeve();
    // Two influences per vertex: the forearm takes over around the elbow, at x = 0.
    let forearm = |p: &[f32; 3]| (0.5 + p[0]).clamp(0.0, 1.0);
    let weights: Vec<f32> = rest.iter().flat_map(|p| [1.0 - forearm(p), forearm(p)]).collect();
    let joints = [0_u16, 1].repeat(rest.len());
    let skin = Skin::new(2, 2, &joints, &weights)?; // checked once

    // The forearm twists by half a turn. At rest both joints lie at the elbow.
    let arm = Skeleton::new(&[-1, 0])?;
    let twist = DualQuat::from_rotation(Quat::from_rotation_x(core::f32::consts::PI * 0.99));
    let (locals, binds) = ([DualQuat::IDENTITY, twist], [DualQuat::IDENTITY; 2]);
    let (mut models, mut motions) = ([DualQuat::IDENTITY; 2], [DualQuat::IDENTITY; 2]);
    arm.job().palette_and_models(Poses(&locals), &mut models, &binds, &mut motions)?;
    let matrices = motions.map(DualQuat::to_matrix3x4);

    let (backend, surface) = (Backend::best(), Surface::positions(&rest));
    let (mut linear, mut dual) = (rest.clone(), rest.clone());
    skin.job().backend(backend).pose(
        Linear::new(&matrices),
        surface,
        SurfaceMut::positions(&mut linear),
    )?;
    skin.job().backend(backend).pose(
        DualBlend::new(&motions),
        surface,
        SurfaceMut::positions(&mut dual),
    )?;
    let radius = |p: [f32; 3]| p[1].hypot(p[2]);
    let [thin, full] = [radius(linear[10 * 8]), radius(dual[10 * 8])];
    println!("radius at the elbow, 0.2 at rest: {thin:.3} linear, {full:.3} dual quaternions");
    assert!(thin < 0.01 && (full - 0.2).abs() < 1e-5);
    Ok(())
}

#[test]
fn the_sleeve_keeps_its_volume() {
    main().unwrap();
}

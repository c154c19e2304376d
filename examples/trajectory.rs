//! A tracker gives noisy poses at irregular times, with signs that flip. Wanted: smooth poses at 100 Hz, and velocities.
//!
//! ```sh
//! cargo run --release --example trajectory
//! ```

use dq8::{Backend, DualQuat, Quat, Twist};
use std::error::Error;

/// A turn at 1 rad/s while going up at 0.2 m/s: the truth.
fn screw(seconds: f64) -> DualQuat<f64> {
    let turn = Quat::from_rotation_z(seconds);
    DualQuat::from_rotation_translation(turn, [seconds.cos(), seconds.sin(), 0.2 * seconds])
}

fn main() -> Result<(), Box<dyn Error>> {
    // What the tracker says: about 60 poses per second, errors of about a milliradian and a millimetre.
    let times: Vec<f64> =
        (0..200).map(|i| f64::from(i) / 60.0 + 0.002 * f64::from(i).sin()).collect();
    let measured = |(i, &time): (usize, &f64)| {
        let noise = [1.0, 2.0, 3.0].map(|k| 1e-3 * (k * 7.7 * i as f64).sin());
        let pose = screw(time) * DualQuat::from_twist(Twist { angular: noise, linear: noise });
        if i % 7 == 0 { -pose } else { pose } // σ and −σ are the same motion
    };
    let mut poses: Vec<_> = times.iter().enumerate().map(measured).collect();
    DualQuat::make_continuous(&mut poses); // for files and filters; dq8 itself does not need it

    // At 100 Hz, on the screw between neighbours; then the intrinsic mean of every nine.
    let at: Vec<f64> = (0..300).map(|i| f64::from(i) / 100.0).collect();
    let mut samples = vec![DualQuat::IDENTITY; at.len()];
    let backend = Backend::best();
    backend.resample(&times, &poses, &at, &mut samples)?;
    let mut smooth = vec![DualQuat::IDENTITY; samples.len() - 8];
    let converged = backend.dib_windows(&samples, &[1.0; 9], 1e-12, 16, &mut smooth)?;
    assert_eq!(converged, smooth.len());

    // Body velocities, in rad/s and m/s; the window of sample i is centred on sample i + 4.
    let worst = smooth.iter().zip(&at[4..]).map(|(pose, &time)| pose.distance_to(screw(time)));
    let velocity = smooth[100].twist_to(smooth[120]).scale(1.0 / 0.2);
    println!("worst distance from the truth: {:.4} m", worst.fold(0.0, f64::max));
    println!("velocity: {:.3?} rad/s, {:.3?} m/s", velocity.angular, velocity.linear);
    assert!((velocity.angular[2] - 1.0).abs() < 0.02);
    Ok(())
}

#[test]
fn the_trajectory_is_smooth() {
    main().unwrap();
}

//! A tracker gives noisy poses at irregular times, with signs that flip. Wanted: smooth poses at
//! 100 Hz, and velocities.
//!
//! ```sh
//! cargo run --release --example smoothed
//! ```

use dq8::{Backend, DualQuat, Quat, Twist};
use dq8_trajectory::Trajectory;

/// A turn at 1 rad/s while going up at 0.2 m/s: the truth.
fn screw(seconds: f64) -> DualQuat<f64> {
    let turn = Quat::from_rotation_z(seconds);
    DualQuat::from_rotation_translation(turn, [seconds.cos(), seconds.sin(), 0.2 * seconds])
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // What the tracker says: about 60 poses per second, errors of about a milliradian and a
    // millimetre.
    let times: Vec<_> =
        (0..200).map(|i| f64::from(i) / 60.0 + 0.002 * f64::from(i).sin()).collect();
    let measured = |(i, &time): (usize, &f64)| {
        let noise = [1.0, 2.0, 3.0].map(|k| 1e-3 * (k * 7.7 * i as f64).sin());
        let pose = screw(time) * DualQuat::from_twist(Twist { angular: noise, linear: noise });
        if i % 7 == 0 { -pose } else { pose } // σ and −σ are the same motion
    };
    let poses: Vec<_> = times.iter().enumerate().map(measured).collect();
    // The intrinsic mean of every nine; then 100 Hz, on the screw between neighbours, and how fast
    // it goes there.
    let mut smooth = vec![DualQuat::IDENTITY; poses.len() - 8];
    let converged = Backend::best().dib_windows(&poses, &[1.0; 9], 1e-12, 16, &mut smooth)?;
    let at: Vec<_> = (10..300).map(|i| f64::from(i) / 100.0).collect();
    let (mut samples, mut twists) = (vec![DualQuat::IDENTITY; 290], vec![Twist::ZERO; 290]);
    let path = Trajectory::new(&times[4..196], &smooth)?;
    path.job().sample_with_twists(&at, &mut samples, &mut twists)?;
    let far = samples.iter().zip(&at).map(|(pose, &time)| pose.distance_to(screw(time)));
    let worst = far.fold(0.0, f64::max);
    println!("{converged} means; at most {worst:.4} m from the truth; {:.3?}", twists[150]);
    assert!(worst < 0.005 && (twists[150].angular[2] - 1.0).abs() < 0.05);
    Ok(())
}

#[test]
fn the_trajectory_is_smooth() {
    main().unwrap();
}

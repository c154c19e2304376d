//! A robot whose camera is where we put it.

use crate::calibration::Pair;
use dq8::{DualQuat, Quat, Twist};
use dq8_fixtures::random::Random;
use std::f64::consts::TAU;

pub(crate) struct Robot {
    random: Random,
    /// X, the pose of the camera on the hand.
    pub(crate) camera: DualQuat<f64>,
}

impl Robot {
    /// The camera is turned any way, and up to 0.2 m off in each axis.
    pub(crate) fn new(seed: u64) -> Self {
        let mut random = Random(seed);
        let camera = motion(&mut random, [0.0, 3.0], 0.2);
        Self { random, camera }
    }

    /// Random motions of the hand, turns between 0.3 and 2 radians, and what the camera sees of
    /// them: B = X*AX, then the noise, in the camera's own axes: its standard deviation in each, in
    /// radians and in metres.
    pub(crate) fn pairs(&mut self, motions: usize, noise: f64) -> Vec<Pair> {
        let mut pair = || {
            let hand = motion(&mut self.random, [0.3, 2.0], 0.5);
            let twist = Twist::from_array([(); 6].map(|()| noise * normal(&mut self.random)));
            let seen = self.camera.conjugate() * hand * self.camera;
            Pair { hand, eye: seen * DualQuat::from_twist(twist) }
        };
        (0..motions).map(|_| pair()).collect()
    }
}

fn motion(random: &mut Random, [least, most]: [f64; 2], reach: f64) -> DualQuat<f64> {
    let turn = Quat::from_axis_angle(random.direction(), random.between(least, most));
    let shift = [(); 3].map(|()| random.between(-reach, reach));
    DualQuat::from_rotation_translation(turn, shift)
}

/// Mean 0, standard deviation 1 (Box and Muller 1958).
fn normal(random: &mut Random) -> f64 {
    let radius = (-2.0 * random.between(0.0, 1.0).max(f64::MIN_POSITIVE).ln()).sqrt();
    radius * random.between(0.0, TAU).cos()
}

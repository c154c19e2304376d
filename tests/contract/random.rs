//! [`Random`]: the same numbers in every run and on every machine.

use dq8::{DualQuat, Quat};
use std::f64::consts::PI;

/// SplitMix64 (Steele, Lea and Flood 2014).
#[derive(Clone, Debug)]
pub struct Random(pub u64);

impl Random {
    /// Evenly from `low` to `high`.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^= bits >> 31;
        let unit = (bits >> 11) as f64 / (1_u64 << 53) as f64;
        low + (high - low) * unit
    }

    /// Evenly from −1 to 1.
    pub fn signed(&mut self) -> f64 {
        self.between(-1.0, 1.0)
    }

    /// Any of the numbers before `count`.
    pub fn below(&mut self, count: usize) -> usize {
        self.between(0.0, count as f64) as usize
    }

    /// Numbers from −1 to 1.
    pub fn vector<const N: usize>(&mut self) -> [f64; N] {
        [(); N].map(|()| self.signed())
    }

    /// A vector of length 1, all directions alike.
    pub fn direction<const N: usize>(&mut self) -> [f64; N] {
        loop {
            let v = self.vector::<N>();
            let length = v.iter().map(|c| c * c).sum::<f64>().sqrt();
            // Out of the ball: the corners of the cube would be too frequent.
            if (0.1..1.0).contains(&length) {
                return v.map(|c| c / length);
            }
        }
    }

    /// Numbers from −1 to 1, the linear ones times `size`.
    pub fn twist(&mut self, size: f64) -> [f64; 6] {
        let twist = self.vector::<6>();
        std::array::from_fn(|i| twist[i] * if i < 3 { 1.0 } else { size })
    }

    /// Any turn, then a translation of components up to `size`.
    pub fn motion(&mut self, size: f64) -> DualQuat<f64> {
        let turn = Quat::from_axis_angle(self.direction(), PI * self.signed());
        let translation = self.vector().map(|c| c * size);
        DualQuat::from_rotation_translation(turn, translation).normalize()
    }
}

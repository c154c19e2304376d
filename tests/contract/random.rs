//! [`Random`]: the same numbers in every run and on every machine.

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

    /// A vector of length 1, all directions alike.
    pub fn direction(&mut self) -> [f64; 3] {
        loop {
            let v = [(); 3].map(|()| self.signed());
            let length = v.iter().map(|c| c * c).sum::<f64>().sqrt();
            // Out of the ball: the corners of the cube would be too frequent.
            if (0.1..1.0).contains(&length) {
                return v.map(|c| c / length);
            }
        }
    }
}

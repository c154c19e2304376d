//! [`Inputs`]: what operations on slices are given.

use crate::scene::{motions, rounded};
use dq8_contract::random::Random;

#[derive(Clone, Debug)]
pub(crate) struct Inputs {
    pub(crate) a: Vec<[f64; 8]>,
    pub(crate) b: Vec<[f64; 8]>,
    pub(crate) t: Vec<[f64; 1]>,
    pub(crate) vectors: Vec<[f64; 3]>,
    pub(crate) planes: Vec<[f64; 4]>,
    /// Lines, twists and logarithms.
    pub(crate) twists: Vec<[f64; 6]>,
    pub(crate) one: [f64; 8],
}

/// Where all are interpolated.
pub(crate) const BETWEEN: f64 = 0.3;
/// The weight of the first of two motions that are blended; no other weight is as large.
pub(crate) const HEAVIER: f64 = 1.5;
/// How much too long motions are that are normalized and inverted.
pub(crate) const LONG: f64 = 2.0;

impl Inputs {
    pub(crate) fn new(count: usize) -> Self {
        let mut random = Random(count as u64);
        Self {
            a: motions(&mut random, count),
            b: motions(&mut random, count),
            t: (0..count).map(|i| [i as f64 / 40.0]).collect(),
            vectors: (0..count).map(|i| [1.0, -0.5, 0.1 * i as f64]).collect(),
            planes: (0..count).map(|i| [0.6, -0.8, 0.0, 0.1 * i as f64]).collect(),
            twists: (0..count).map(|i| [0.6, 0.1, -0.8, 0.4, 0.1 * i as f64, 0.3]).collect(),
            one: motions(&mut random, 1)[0],
        }
    }

    /// As the numbers of a layout hold them.
    pub(crate) fn rounded(&self, single: bool) -> Self {
        Self {
            a: rounded(single, &self.a),
            b: rounded(single, &self.b),
            t: rounded(single, &self.t),
            vectors: rounded(single, &self.vectors),
            planes: rounded(single, &self.planes),
            twists: rounded(single, &self.twists),
            one: rounded(single, &[self.one])[0],
        }
    }

    pub(crate) fn from(&self, first: usize) -> Self {
        Self {
            a: self.a[first..].to_vec(),
            b: self.b[first..].to_vec(),
            t: self.t[first..].to_vec(),
            vectors: self.vectors[first..].to_vec(),
            planes: self.planes[first..].to_vec(),
            twists: self.twists[first..].to_vec(),
            one: self.one,
        }
    }

    pub(crate) fn long(&self) -> Vec<[f64; 8]> {
        self.a.iter().map(|motion| motion.map(|c| LONG * c)).collect()
    }
}

//! [`Errors`] and their [`Statistics`].

use alloc::vec::Vec;
use dq8::scalar::vector;
use dq8::{Quat, Real};

/// The differences between poses or motions of two trajectories, in order of time.
#[derive(Clone, Debug)]
pub struct Errors {
    pub(super) stamps: Vec<f64>,
    pub(super) translations: Vec<f64>,
    pub(super) rotations: Vec<f64>,
}

impl Errors {
    /// The stamps in seconds, of the reference; of motions, where they end.
    #[must_use]
    pub fn stamps(&self) -> &[f64] {
        &self.stamps
    }

    /// The lengths of the differences of translations, in metres.
    #[must_use]
    pub fn translations(&self) -> &[f64] {
        &self.translations
    }

    /// The angles of the rotations in between, in radians, from 0 to π.
    #[must_use]
    pub fn rotations(&self) -> &[f64] {
        &self.rotations
    }

    /// The statistics of the translations, in metres.
    #[must_use]
    pub fn translation(&self) -> Statistics {
        Statistics::new(&self.translations)
    }

    /// The statistics of the rotations, in radians.
    #[must_use]
    pub fn rotation(&self) -> Statistics {
        Statistics::new(&self.rotations)
    }
}

/// The usual figures of errors e₁ … eₙ, under the names of evo. All have the unit of the
/// errors, but for `sse`, which has its square.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Statistics {
    /// √(Σeᵢ² / n)
    pub rmse: f64,
    /// Σeᵢ / n
    pub mean: f64,
    /// The one in the middle, or the mean of the two that are.
    pub median: f64,
    /// √(Σ(eᵢ − mean)² / n)
    pub std: f64,
    /// The smallest.
    pub min: f64,
    /// The largest.
    pub max: f64,
    /// Σeᵢ²
    pub sse: f64,
}

impl Statistics {
    /// Figures of at least one error.
    fn new(errors: &[f64]) -> Self {
        let count = errors.len() as f64;
        let mut sorted = errors.to_vec();
        sorted.sort_unstable_by(f64::total_cmp);
        // The same where there is one in the middle.
        let middle = [(sorted.len() - 1) / 2, sorted.len() / 2].map(|place| sorted[place]);
        let mean = errors.iter().sum::<f64>() / count;
        let sse: f64 = errors.iter().map(|error| error * error).sum();
        let spread: f64 = errors.iter().map(|error| (error - mean) * (error - mean)).sum();
        Self {
            rmse: Real::sqrt(sse / count),
            mean,
            median: middle[0] + 0.5 * (middle[1] - middle[0]),
            std: Real::sqrt(spread / count),
            min: sorted[0],
            max: sorted[sorted.len() - 1],
            sse,
        }
    }
}

/// The angle of a rotation in radians, from 0 to π.
pub(super) fn angle(rotation: Quat<f64>) -> f64 {
    2.0 * Real::atan2(vector::norm(rotation.xyz()), rotation.w().abs())
}

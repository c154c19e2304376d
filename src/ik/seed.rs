//! Poses of an arm from which a search begins again.

use super::joint::{Joint, chain};
use super::limits::Range;
use crate::real::Real;
use crate::scalar::DualQuat;

/// How many. Twice as many raise the success on an arm with narrow limits by half a per cent, half as
/// many lower it by as much.
pub(super) const SEEDS: usize = 128;

/// Joint values, and the pose of the end there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seed<R, const N: usize> {
    pub(super) values: [R; N],
    pub(super) pose: DualQuat<R>,
}

/// Joint values of low discrepancy within the limits: the additive recurrence u + kα modulo 1 with
/// αⱼ = g⁻ʲ, g the positive root of gᴺ⁺¹ = g + 1, which generalises the golden ratio (Roberts 2018).
pub(super) fn seeds<R: Real, const N: usize>(
    joints: &[Joint<R>; N],
    ranges: &[Range<R>; N],
    home: DualQuat<R>,
) -> [Seed<R, N>; SEEDS] {
    let ratio = 1.0 / ratio(N);
    let mut power = 1.0;
    let steps = [(); N].map(|()| {
        power *= ratio;
        power
    });
    let mut shares = [0.5; N];
    let mut seeds = [Seed { values: [R::ZERO; N], pose: home }; SEEDS];
    for seed in &mut seeds {
        for (((share, step), value), &Range { low, high, .. }) in
            shares.iter_mut().zip(steps).zip(&mut seed.values).zip(ranges)
        {
            *share += step;
            if *share >= 1.0 {
                *share -= 1.0;
            }
            *value = low + (high - low) * R::from_f64(*share);
        }
        seed.pose = chain(joints, home, &seed.values);
    }
    seeds
}

/// g, the positive root of gᴺ⁺¹ = g + 1.
pub(crate) fn ratio(joints: usize) -> f64 {
    let mut ratio = 1.5_f64;
    for _ in 0..64 {
        ratio = Real::exp(Real::ln(1.0 + ratio) / (joints as f64 + 1.0));
    }
    ratio
}

//! Configurations, within the limits of the joints.

use dq8_robot::urdf::Robot;
use std::f64::consts::PI;

/// A xorshift generator (Marsaglia 2003): the same numbers everywhere.
struct Generator(u64);

impl Generator {
    /// In [0, 1).
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// Where each value may be: its limits, or half a turn to both sides; where that is a length, a
/// unit.
fn ranges(robot: &Robot) -> Vec<[f64; 2]> {
    let names = robot.value_names().iter();
    let range = |(name, limits): (&String, Option<[f64; 2]>)| {
        let unlimited =
            if [".x", ".y", ".z"].iter().any(|end| name.ends_with(end)) { 1.0 } else { PI };
        limits.unwrap_or([-unlimited, unlimited])
    };
    names.zip(robot.value_limits()).map(range).collect()
}

pub(crate) fn random(robot: &Robot, configurations: usize) -> Vec<f64> {
    let ranges = ranges(robot);
    let mut generator = Generator(0x9e37_79b9_7f4a_7c15);
    let one = |[low, high]: &[f64; 2]| low + (high - low) * generator.next();
    ranges.iter().cycle().take(ranges.len() * configurations).map(one).collect()
}

/// All joints at zero, or at the limit next to it; floating ones turned by nothing.
pub(crate) fn nearest_zero(robot: &Robot) -> Vec<f64> {
    let names = robot.value_names().iter();
    let value = |(name, [low, high]): (&String, [f64; 2])| {
        if name.ends_with(".qw") { 1.0 } else { 0.0_f64.clamp(low, high) }
    };
    names.zip(ranges(robot)).map(value).collect()
}

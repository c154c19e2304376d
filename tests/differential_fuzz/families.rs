//! [`Families`]: implementations whose answers have the same bits.

use dq8_contract::fusing::PORTABLE_FUSES;
use dq8_contract::implementation::On;
use std::collections::BTreeMap;

/// The first of each family, with the bits that it answers in each lane.
#[derive(Default)]
pub(crate) struct Families(BTreeMap<&'static str, (On, Vec<Vec<u64>>)>);

impl Families {
    /// Another one. If the first of its family has other bits: that one, and the lane.
    pub(crate) fn add(&mut self, on: On, answers: Vec<Vec<u64>>) -> Option<(On, usize)> {
        let family = family(on)?;
        let Some((first, wanted)) = self.0.get(family) else {
            self.0.insert(family, (on, answers));
            return None;
        };
        let lane = answers.iter().zip(wanted).position(|(got, wanted)| got != wanted)?;
        Some((first, lane))
    }
}

/// The instructions decide, not how many lanes there are. A build for a CPU that fuses has them
/// fused in vectors, and not in a single number.
fn family(on: On) -> Option<&'static str> {
    let lanes = on.name.strip_prefix("lanes ")?;
    let fuses = PORTABLE_FUSES && !lanes.ends_with("x1") && !lanes.starts_with("unfused");
    Some(if lanes.starts_with("AVX") || fuses { "fused" } else { "portable" })
}

//! [`Caches`]: how much the caches of this machine hold, and how many transforms fill them.

use std::fs;

/// Bytes that one core sees.
#[derive(Clone, Copy, Debug)]
pub struct Caches {
    pub l1: usize,
    pub l2: usize,
    pub l3: usize,
}

/// Where the data of a contest lie.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Level {
    L1,
    L2,
    L3,
    Dram,
}

/// Bytes a transform in all that a pass reads and writes.
#[derive(Clone, Copy)]
pub struct Footprint {
    /// Of this crate.
    pub own: usize,
    /// Of the contender that needs the most.
    pub most: usize,
}

impl Level {
    pub const ALL: [Self; 4] = [Self::L1, Self::L2, Self::L3, Self::Dram];

    pub const fn name(self) -> &'static str {
        match self {
            Self::L1 => "L1",
            Self::L2 => "L2",
            Self::L3 => "L3",
            Self::Dram => "DRAM",
        }
    }
}

impl Caches {
    /// As Linux tells; elsewhere those of a common server.
    pub fn of_this_machine() -> Self {
        let mut caches = Self { l1: 32 << 10, l2: 1 << 20, l3: 32 << 20 };
        for index in 0..8 {
            let tell = |what| {
                let file = format!("/sys/devices/system/cpu/cpu0/cache/index{index}/{what}");
                fs::read_to_string(file).ok().map(|text| text.trim().to_owned())
            };
            let (Some(level), Some(kind)) = (tell("level"), tell("type")) else { continue };
            let Some(bytes) = tell("size").and_then(|size| bytes(&size)) else { continue };
            match (level.as_str(), kind.as_str()) {
                ("1", "Data") => caches.l1 = bytes,
                ("2", _) => caches.l2 = bytes,
                ("3", _) => caches.l3 = bytes,
                _ => {}
            }
        }
        caches
    }

    /// How many transforms lie there: the largest contender still fits into the first two caches,
    /// the smallest, this crate, does not fit any more into the one above the others.
    pub fn transforms(&self, level: Level, footprint: Footprint) -> usize {
        let Footprint { own, most } = footprint;
        let transforms = match level {
            Level::L1 => self.l1 / 4 * 3 / most,
            Level::L2 => self.l2 / 2 / most,
            Level::L3 => (4 * self.l2).min(self.l3 / 2) / own,
            Level::Dram => self.l3 / 2 * 3 / own,
        };
        // Whole blocks of any number of lanes.
        transforms.next_multiple_of(64)
    }
}

/// "48K", "2M".
pub fn bytes(size: &str) -> Option<usize> {
    let digits = size.trim_end_matches(['K', 'M']);
    let shift = match &size[digits.len()..] {
        "" => 0,
        "K" => 10,
        "M" => 20,
        _ => return None,
    };
    digits.parse::<usize>().ok().map(|number| number << shift)
}

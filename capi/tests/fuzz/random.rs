//! Random numbers, arrays of them, and pointers that may be wrong.

use dq8::{simd, storage::Block};
use dq8_fixtures::random::Random;

pub(crate) struct Fuzz(pub(crate) Random);

impl Fuzz {
    pub(crate) fn bits(&mut self) -> u64 {
        self.0.bits()
    }
    pub(crate) fn below(&mut self, end: usize) -> usize {
        self.0.below(end)
    }
    pub(crate) fn number(&mut self) -> f32 {
        match self.below(8) {
            0 => f32::from_bits(self.bits() as u32),
            1 => [0.0, f32::NAN, f32::INFINITY, f32::MAX][self.below(4)],
            _ => (self.bits() >> 40) as f32 / (1 << 22) as f32 - 2.0,
        }
    }
    /// Just so many numbers: nothing behind them is ours.
    pub(crate) fn numbers(&mut self, count: usize) -> Box<[f32]> {
        (0..count).map(|_| self.number()).collect()
    }
    /// So many blocks of eight lanes and sixteen.
    pub(crate) fn blocks<const N: usize, const C: usize>(
        &mut self,
        count: usize,
    ) -> Box<[Block<f32, N, C>]> {
        (0..count).map(|_| simd::Block([(); C].map(|()| [(); N].map(|()| self.number())))).collect()
    }
    /// A pointer that may be wrong, and whether it is.
    pub(crate) fn pointer(&mut self, good: *mut f32, wrong: &mut bool) -> *mut f32 {
        match self.below(40) {
            0 => {
                *wrong = true;
                std::ptr::null_mut()
            }
            1 => {
                *wrong = true;
                good.wrapping_byte_add(2)
            }
            _ => good,
        }
    }
}

pub(crate) fn blocks_of(lanes: usize, instances: usize) -> usize {
    instances.div_ceil(lanes)
}

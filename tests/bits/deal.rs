//! [`Deal`]: arguments dealt out to lanes, and the hashes of the answers.

use crate::random::Random;
use crate::sample::{MOST, Sample};
use dq8::representation::EulerOrder;
use dq8::{Real, Scalar};

/// So many elements of each operation, whole registers of every width.
const ELEMENTS: usize = 6 * MOST;

/// A hash of numbers, all NaN being one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hash(pub(crate) u64);

impl Hash {
    pub(crate) fn number<R: Scalar>(&mut self, number: R) {
        let number: f64 = number.into();
        self.bits(if number.is_nan() { 1 } else { number.to_bits() });
    }

    pub(crate) fn bits(&mut self, bits: u64) {
        self.0 = (self.0 ^ bits).wrapping_mul(0x0100_0000_01b3).rotate_left(23);
    }
}

/// What an operation takes its arguments from, and answers to. Each element has random numbers and
/// a hash of its own, so that it does not matter how many are computed together.
pub(crate) struct Deal<M: Sample> {
    level: M::Level,
    randoms: [Random; MOST],
    hashes: [Hash; MOST],
    /// The first that is dealt out.
    element: usize,
}

impl<M: Sample> Deal<M> {
    /// The hash of all answers of an operation.
    pub(crate) fn hash(level: M::Level, name: &str, operation: impl Fn(&mut Self)) -> u64 {
        let mut seed = Hash(0xcbf2_9ce4_8422_2325);
        name.bytes().for_each(|byte| seed.bits(byte.into()));
        let mut sum = 0_u64;
        for element in (0..ELEMENTS).step_by(M::LANES) {
            let lanes: [u64; MOST] = core::array::from_fn(|lane| (element + lane) as u64);
            let randoms = lanes.map(|lane| Random::new(seed.0 ^ lane));
            let mut deal = Self { level, randoms, hashes: lanes.map(Hash), element };
            operation(&mut deal);
            let hashes = deal.hashes.iter().take(M::LANES);
            sum = hashes.fold(sum, |sum, hash| sum.wrapping_add(hash.0));
        }
        sum
    }

    fn of<const N: usize>(&mut self, make: impl Fn(&mut Random) -> [M::Number; N]) -> [M::Real; N] {
        let made = self.randoms.each_mut().map(make);
        core::array::from_fn(|c| M::load(self.level, &made.map(|numbers| numbers[c])))
    }

    pub(crate) fn level(&self) -> M::Level {
        self.level
    }
    pub(crate) fn numbers<const N: usize>(&mut self) -> [M::Real; N] {
        self.of(Random::numbers)
    }
    pub(crate) fn number(&mut self) -> M::Real {
        let [number] = self.numbers();
        number
    }
    pub(crate) fn constant(&self, number: f64) -> M::Real {
        M::load(self.level, &[Real::from_f64(number); MOST])
    }
    pub(crate) fn unit(&mut self) -> M {
        M::motion(self.of(Random::motion))
    }
    pub(crate) fn rotation(&mut self) -> M::Quat {
        let [x, y, z, w, ..] = self.of(Random::motion);
        M::quat([x, y, z, w])
    }
    pub(crate) fn quat(&mut self) -> M::Quat {
        M::quat(self.numbers())
    }
    pub(crate) fn dual(&mut self) -> M::Dual {
        M::dual(self.numbers())
    }
    pub(crate) fn matrix(&mut self) -> [[M::Real; 4]; 3] {
        let [a, b, c, d, e, f, g, h, i, j, k, l] = self.of(Random::matrix);
        [[a, b, c, d], [e, f, g, h], [i, j, k, l]]
    }
    /// One for as many elements as any register has lanes.
    pub(crate) fn integer(&self) -> i32 {
        (self.element / MOST) as i32
    }
    pub(crate) fn order(&self) -> EulerOrder {
        let orders = EulerOrder::ALL;
        orders[5 * (self.element / MOST) % orders.len()]
    }

    pub(crate) fn put(&mut self, numbers: &[M::Real]) {
        for &number in numbers {
            let row = M::store(number);
            self.hashes.iter_mut().zip(row).for_each(|(hash, number)| hash.number(number));
        }
    }
    pub(crate) fn put_quat(&mut self, quat: M::Quat) {
        self.put(&M::xyzw(quat));
    }
    pub(crate) fn put_dual(&mut self, dual: M::Dual) {
        self.put(&M::parts(dual));
    }
    pub(crate) fn mask(&mut self, mask: M::Mask) {
        let bits = M::bits(mask);
        let hashes = self.hashes.iter_mut().enumerate().take(M::LANES);
        hashes.for_each(|(lane, hash)| hash.bits((bits >> lane & 1).into()));
    }
}

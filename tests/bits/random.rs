//! [`Random`]: numbers of every kind, made of integers.

use dq8::Scalar;

/// Xorshift (Marsaglia 2003).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        let mut random = Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
        random.next();
        random
    }

    pub(crate) fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    pub(crate) fn below(&mut self, count: u64) -> u64 {
        (self.next() >> 33) % count
    }

    /// A multiple of 2⁻²³ in [−1, 1).
    pub(crate) fn signed<R: Scalar>(&mut self) -> R {
        let integer = (self.next() >> 40) as i32 - (1 << 23);
        <R as dq8::Real>::from_f64(f64::from(integer) / f64::from(1 << 23))
    }

    /// One in eight of any bits, zero, tiny or huge: products of tiny ones are subnormal.
    pub(crate) fn number<R: Scalar>(&mut self) -> R {
        let ordinary = R::from(4.0) * self.signed::<R>();
        match self.below(32) {
            0 if R::SINGLE => R::from(f32::from_bits(self.next() as u32)),
            0 => <R as dq8::Real>::from_f64(f64::from_bits(self.next())),
            1 => R::ZERO * self.signed::<R>(),
            2 => ordinary * R::from(1e-20),
            3 => ordinary * R::from(1e18),
            _ => ordinary,
        }
    }

    pub(crate) fn numbers<R: Scalar, const N: usize>(&mut self) -> [R; N] {
        [(); N].map(|()| self.number())
    }

    /// p + ½εtp, unit but for rounding; one in eight turns by half a turn, so that motions are at
    /// right angles.
    pub(crate) fn motion<R: Scalar>(&mut self) -> [R; 8] {
        let mut p = [(); 4].map(|()| self.signed::<R>());
        if self.below(8) == 0 {
            let axis = self.below(4) as usize;
            p = [0, 1, 2, 3].map(|i| if i == axis { R::ONE } else { R::ZERO });
        }
        let square = p[0] * p[0] + p[1] * p[1] + (p[2] * p[2] + p[3] * p[3]);
        let norm = dq8::Real::sqrt(square);
        let [x, y, z, w] = p.map(|c| c / norm);
        let [a, b, c] = [(); 3].map(|()| self.signed::<R>());
        let dual = [a * w + b * z - c * y, b * w + c * x - a * z, c * w + a * y - b * x];
        let last = -(a * x) - b * y - c * z;
        [x, y, z, w, dual[0], dual[1], dual[2], last]
    }

    /// A turn about a coordinate axis, one in three by half a turn, then a translation that is
    /// often along one: most numbers are zeros, of both signs.
    pub(crate) fn turned<R: Scalar>(&mut self) -> [R; 8] {
        let turns =
            [[0.8, -0.6], [-0.96, -0.28], [1.0, 0.0], [-0.0, 1.0], [-1.0, -0.0], [0.6, 0.8]];
        let ([sine, cosine], axis) =
            (turns[self.below(6) as usize].map(<R as dq8::Real>::from_f64), self.below(3) as usize);
        let mut zero = || if self.below(2) == 0 { R::ZERO } else { -R::ZERO };
        let [x, y, z] = [0, 1, 2].map(|i| if i == axis { sine } else { zero() });
        let [a, b, c] = [(); 3].map(|()| match self.below(4) {
            0 => R::ONE,
            1 => -R::HALF,
            2 => R::ZERO,
            _ => -R::ZERO,
        });
        let (w, half) = (cosine, R::HALF);
        let dual = [a * w + b * z - c * y, b * w + c * x - a * z, c * w + a * y - b * x];
        let last = -(a * x) - b * y - c * z;
        [x, y, z, w, half * dual[0], half * dual[1], half * dual[2], half * last]
    }

    /// The rows of [R | t], or, one in four, any.
    pub(crate) fn matrix<R: Scalar>(&mut self) -> [R; 12] {
        let [x, y, z, w, a, b, c, _] = self.motion::<R>();
        let any = self.numbers();
        let (x2, y2, z2) = (x + x, y + y, z + z);
        let one = R::ONE;
        let rows = [
            [one - y * y2 - z * z2, x * y2 - w * z2, x * z2 + w * y2, a],
            [x * y2 + w * z2, one - x * x2 - z * z2, y * z2 - w * x2, b],
            [x * z2 - w * y2, y * z2 + w * x2, one - x * x2 - y * y2, c],
        ];
        if self.below(4) == 0 { any } else { rows.as_flattened().try_into().unwrap_or(any) }
    }
}

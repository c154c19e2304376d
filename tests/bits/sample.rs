//! [`Sample`]: numbers in and out of the scalar reference and of lanes.

use dq8::simd::Mask;
use dq8::{DualQuat, Lanes, Motion, Real, Scalar, batch};

/// The most lanes that a register has.
pub(crate) const MOST: usize = dq8::simd::MAX_LANES;

/// A motion that can be filled and read, lane by lane.
pub(crate) trait Sample: Motion {
    type Number: Scalar;
    const LANES: usize;
    fn load(level: Self::Level, row: &[Self::Number; MOST]) -> Self::Real;
    fn store(real: Self::Real) -> [Self::Number; MOST];
    fn bits(mask: Self::Mask) -> u32;
    fn motion(components: [Self::Real; 8]) -> Self;
    fn components(self) -> [Self::Real; 8];
    fn quat(xyzw: [Self::Real; 4]) -> Self::Quat;
    fn xyzw(quat: Self::Quat) -> [Self::Real; 4];
    fn dual(parts: [Self::Real; 2]) -> Self::Dual;
    fn parts(dual: Self::Dual) -> [Self::Real; 2];
}

/// The constructors have the same names, but no common trait.
macro_rules! parts {
    () => {
        fn motion(components: [Self::Real; 8]) -> Self {
            Self::from_array(components)
        }
        fn components(self) -> [Self::Real; 8] {
            self.to_array()
        }
        fn quat(xyzw: [Self::Real; 4]) -> Self::Quat {
            <Self::Quat>::from_array(xyzw)
        }
        fn xyzw(quat: Self::Quat) -> [Self::Real; 4] {
            quat.to_array()
        }
        fn dual([real, dual]: [Self::Real; 2]) -> Self::Dual {
            <Self::Dual>::new(real, dual)
        }
        fn parts(dual: Self::Dual) -> [Self::Real; 2] {
            [dual.real, dual.dual]
        }
    };
}

impl<R: Scalar> Sample for DualQuat<R> {
    type Number = R;
    const LANES: usize = 1;
    fn load((): (), row: &[R; MOST]) -> R {
        row[0]
    }
    fn store(real: R) -> [R; MOST] {
        [real; MOST]
    }
    fn bits(mask: bool) -> u32 {
        mask.into()
    }
    parts! {}
}

impl<L: Lanes<Real: Scalar>> Sample for batch::DualQuat<L> {
    type Number = L::Real;
    const LANES: usize = L::LANES;
    fn load(level: L::Level, row: &[L::Real; MOST]) -> L {
        L::load_partial(level, row, L::Real::ZERO)
    }
    fn store(real: L) -> [L::Real; MOST] {
        let mut row = [L::Real::ZERO; MOST];
        real.store_partial(&mut row);
        row
    }
    fn bits(mask: L::Mask) -> u32 {
        mask.to_bitmask()
    }
    parts! {}
}

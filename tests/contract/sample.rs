//! [`Sample`]: numbers in and out of any implementation of [`Motion`], so that one generic test
//! serves them all.

use crate::lanes::{MAX_LANES, Row};
use dq8::{
    DualQuat, Lanes, Motion, Quat, Real, batch, scalar,
    simd::{Float, Mask, Portable},
};

pub use dq8::Level;
pub use dq8_simd::Unfused;
#[cfg(target_arch = "x86_64")]
pub use dq8_simd::x86_64::{Avx2, Avx512};

/// A [`Motion`] that tests can fill and read, lane by lane.
pub trait Sample: Motion {
    /// How many motions one value holds.
    const LANES: usize;
    /// Whether the numbers are `f32`.
    const SINGLE: bool;

    fn level() -> Self::Level;
    /// Lane `i` from element `i`, rounded.
    fn load(row: &Row) -> Self::Real;
    fn store(real: Self::Real) -> Row;
    /// Lane `i` from element `i`, rounded.
    fn real(lanes: &[f64]) -> Self::Real;
    fn lanes(real: Self::Real) -> Vec<f64>;
    fn quat(xyzw: [Self::Real; 4]) -> Self::Quat;
    fn quat_parts(quat: Self::Quat) -> [Self::Real; 4];
    fn dual_number(real: Self::Real, dual: Self::Real) -> Self::Dual;
    fn dual_parts(dual: Self::Dual) -> [Self::Real; 2];
    fn motion(components: [Self::Real; 8]) -> Self;
    fn components(self) -> [Self::Real; 8];
    /// Which lanes a mask holds for.
    fn bits(mask: Self::Mask) -> u32;

    /// Lane `i` from `[px, py, pz, pw, qx, qy, qz, qw]` number `i`.
    fn gather(motions: &[[f64; 8]]) -> Self {
        Self::motion(std::array::from_fn(|c| {
            Self::real(&motions.iter().map(|m| m[c]).collect::<Vec<_>>())
        }))
    }
    fn scatter(self) -> Vec<[f64; 8]> {
        let rows = self.components().map(Self::lanes);
        (0..Self::LANES).map(|lane| std::array::from_fn(|c| rows[c][lane])).collect()
    }
    fn vector(vectors: &[[f64; 3]]) -> [Self::Real; 3] {
        std::array::from_fn(|c| Self::real(&vectors.iter().map(|v| v[c]).collect::<Vec<_>>()))
    }
    fn splat(value: f64) -> Self::Real {
        Self::real(&vec![value; Self::LANES])
    }
}

impl<R: Real> Sample for DualQuat<R> {
    const LANES: usize = 1;
    const SINGLE: bool = size_of::<R>() == 4;

    fn level() {}
    fn load(row: &Row) -> R {
        R::from_f64(row[0])
    }
    fn store(real: R) -> Row {
        let mut row = [0.0; MAX_LANES];
        row[0] = real.into();
        row
    }

    fn real(lanes: &[f64]) -> R {
        R::from_f64(lanes[0])
    }
    fn lanes(real: R) -> Vec<f64> {
        vec![real.into()]
    }
    fn quat(xyzw: [R; 4]) -> Quat<R> {
        Quat::from_array(xyzw)
    }
    fn quat_parts(quat: Quat<R>) -> [R; 4] {
        quat.to_array()
    }
    fn dual_number(real: R, dual: R) -> scalar::Dual<R> {
        scalar::Dual::new(real, dual)
    }
    fn dual_parts(dual: scalar::Dual<R>) -> [R; 2] {
        [dual.real, dual.dual]
    }
    fn motion(components: [R; 8]) -> Self {
        Self::from_array(components)
    }
    fn components(self) -> [R; 8] {
        self.to_array()
    }
    fn bits(mask: bool) -> u32 {
        u32::from(mask)
    }
}

impl<L: Lanes<Level: Proof>> Sample for batch::DualQuat<L> {
    const LANES: usize = L::LANES;
    const SINGLE: bool = L::Real::SINGLE;

    fn level() -> L::Level {
        L::Level::proof()
    }
    fn load(row: &Row) -> L {
        let numbers = row.map(L::Real::from_f64);
        L::load_partial(L::Level::proof(), &numbers[..L::LANES], L::Real::default())
    }
    fn store(real: L) -> Row {
        let mut row = [0.0; MAX_LANES];
        let lanes = real.to_array();
        row.iter_mut().zip(lanes.as_ref()).for_each(|(slot, &number)| *slot = number.into());
        row
    }

    fn real(lanes: &[f64]) -> L {
        let rounded: Vec<_> = lanes.iter().map(|&v| L::Real::from_f64(v)).collect();
        assert!(rounded.len() == L::LANES, "{} values for {} lanes", rounded.len(), L::LANES);
        L::load_partial(L::Level::proof(), &rounded, L::Real::default())
    }
    fn lanes(real: L) -> Vec<f64> {
        real.to_array().as_ref().iter().map(|&v| v.into()).collect()
    }
    fn quat(xyzw: [L; 4]) -> batch::Quat<L> {
        batch::Quat::from_array(xyzw)
    }
    fn quat_parts(quat: batch::Quat<L>) -> [L; 4] {
        quat.to_array()
    }
    fn dual_number(real: L, dual: L) -> batch::Dual<L> {
        batch::Dual::new(real, dual)
    }
    fn dual_parts(dual: batch::Dual<L>) -> [L; 2] {
        [dual.real, dual.dual]
    }
    fn motion(components: [L; 8]) -> Self {
        Self::from_array(components)
    }
    fn components(self) -> [L; 8] {
        self.to_array()
    }
    fn bits(mask: L::Mask) -> u32 {
        mask.to_bitmask()
    }
}

/// A level that tests can have: the code that they guard by `is_there` may ask for the proof.
pub trait Proof: Level {
    fn is_there() -> bool;
    fn proof() -> Self;
}

impl Proof for Portable {
    fn is_there() -> bool {
        true
    }
    fn proof() -> Self {
        Self
    }
}

impl<V: Proof> Proof for Unfused<V> {
    fn is_there() -> bool {
        V::is_there()
    }
    fn proof() -> Self {
        Self(V::proof())
    }
}

/// The levels that are found at run time.
#[cfg(target_arch = "x86_64")]
mod found {
    use super::Proof;
    use dq8_simd::x86_64::{Avx2, Avx512};

    impl Proof for Avx2 {
        fn is_there() -> bool {
            Self::detect().is_some()
        }
        fn proof() -> Self {
            Self::detect().expect("the CPU has AVX2")
        }
    }

    impl Proof for Avx512 {
        fn is_there() -> bool {
            Self::detect().is_some()
        }
        fn proof() -> Self {
            Self::detect().expect("the CPU has AVX-512")
        }
    }
}

/// Calls `check::<L>` with every lane type that this machine can run: those of any machine, and
/// those of every level it has.
#[macro_export]
macro_rules! on_every_lane_type {
    (@each $check:ident $given:tt $($L:ty),*) => { $($check::<$L> $given;)* };
    ($check:ident $given:tt) => {{
        $crate::on_every_lane_type! { @each $check $given f32, f64, dq8::simd::f32x4, dq8::simd::f32x8,
            dq8::simd::f32x16, dq8::simd::f64x2, dq8::simd::f64x4, dq8::simd::f64x8 }
        #[cfg(target_arch = "x86_64")]
        {
            use dq8::Level as Of;
            use dq8::simd::x86_64::{Avx2, Avx512};
            if <Avx2 as $crate::sample::Proof>::is_there() {
                $crate::on_every_lane_type! { @each $check $given <Avx2 as Of>::F32x8, <Avx2 as Of>::F64x4 }
            }
            if <Avx512 as $crate::sample::Proof>::is_there() {
                $crate::on_every_lane_type! { @each $check $given <Avx512 as Of>::F32x16, <Avx512 as Of>::F64x8 }
            }
        }
    }};
}

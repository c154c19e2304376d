//! [`Sample`]: numbers in and out of any implementation of [`Motion`], so that one generic test
//! serves them all.

use dq8::{DualQuat, Float, Lane, Mask, Motion, Portable, Quat, Real, batch, scalar};

/// A [`Motion`] that tests can fill and read, lane by lane.
pub trait Sample: Motion {
    /// How many motions one value holds.
    const LANES: usize;
    /// Whether the numbers are `f32`.
    const SINGLE: bool;

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
    fn one() -> Self;

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
    fn one() -> Self {
        Self::identity(())
    }
}

impl<L: Lane<Level = Portable>> Sample for batch::DualQuat<L> {
    const LANES: usize = L::LANES;
    const SINGLE: bool = L::Real::SINGLE;

    fn real(lanes: &[f64]) -> L {
        let rounded: Vec<_> = lanes.iter().map(|&v| L::Real::from_f64(v)).collect();
        assert!(rounded.len() == L::LANES, "{} values for {} lanes", rounded.len(), L::LANES);
        L::load_partial(Portable, &rounded, L::Real::default())
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
    fn one() -> Self {
        Self::identity(Portable)
    }
}

/// Runs `$body` with `$M` as each implementation of [`Motion`] there is, and its name.
#[macro_export]
macro_rules! for_every_implementation {
    (|$name:ident, $M:ident| $body:expr) => {{
        $crate::for_every_implementation! { @each $name, $M, $body;
            "scalar f32" = dq8::DualQuat<f32>;
            "scalar f64" = dq8::DualQuat<f64>;
            "lanes f32x1" = dq8::batch::DualQuat<f32>;
            "lanes f32x4" = dq8::batch::DualQuat<dq8::f32x4>;
            "lanes f32x8" = dq8::batch::DualQuat<dq8::f32x8>;
            "lanes f32x16" = dq8::batch::DualQuat<dq8::f32x16>;
            "lanes f64x1" = dq8::batch::DualQuat<f64>;
            "lanes f64x2" = dq8::batch::DualQuat<dq8::f64x2>;
            "lanes f64x4" = dq8::batch::DualQuat<dq8::f64x4>;
            "lanes f64x8" = dq8::batch::DualQuat<dq8::f64x8>;
        }
    }};
    (@each $name:ident, $M:ident, $body:expr; $($text:literal = $type:ty;)*) => {$({
        type $M = $type;
        let $name = $text;
        $body
    })*};
}

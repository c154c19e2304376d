//! Sweeps of the one-variable functions over the floats of `f32`, against `f64`.
//!
//! Every `DQ8_SWEEP_STRIDE`-th float is taken, by its bits, so small angles are met as often as
//! large ones. The default samples. In a release build, a stride of 61 takes about a minute and a
//! stride of 1, every float there is, about an hour.

use dq8::{DualQuat, DualVector};
use dq8_contract::sample::Sample;
use std::f32::consts::PI;

/// Runs a sweep on the scalar reference and on lanes: fused or not, they share the polynomials.
macro_rules! on_every_f32_implementation {
    ($sweep:ident) => {{
        $sweep::<DualQuat<f32>>();
        $sweep::<dq8::batch::DualQuat<f32>>();
        $sweep::<dq8::batch::DualQuat<dq8::f32x4>>();
        $sweep::<dq8::batch::DualQuat<dq8::f32x8>>();
        $sweep::<dq8::batch::DualQuat<dq8::f32x16>>();
    }};
}

/// Half a unit of the last place of 1.
const U: f64 = f32::EPSILON as f64 / 2.0;

/// The largest float below π/2: the next one has a cosine below 0, whose motion is turned over.
const BELOW_RIGHT_ANGLE: f32 = f32::from_bits(std::f32::consts::FRAC_PI_2.to_bits() - 1);

fn stride() -> u32 {
    match std::env::var("DQ8_SWEEP_STRIDE") {
        Err(_) => 65_537,
        Ok(text) => text.parse().expect("DQ8_SWEEP_STRIDE is a whole number"),
    }
}

/// Calls `check` with every stride-th float of [0, last], as many at a time as `M` has lanes, and
/// with the last one.
fn sweep<M: Sample>(last: f32, mut check: impl FnMut(&[f64])) {
    let bits = (0..=last.to_bits()).step_by(stride() as usize).chain([last.to_bits()]);
    let mut lanes = Vec::with_capacity(M::LANES);
    let mut checked = 0;
    for bits in bits {
        lanes.push(f64::from(f32::from_bits(bits)));
        if lanes.len() == M::LANES {
            check(&lanes);
            checked += lanes.len();
            lanes.clear();
        }
    }
    // Fill the last lanes with the last float.
    if !lanes.is_empty() {
        lanes.resize(M::LANES, f64::from(last));
        check(&lanes);
        checked += lanes.len();
    }
    assert!(
        checked as u64 > u64::from(last.to_bits()) / u64::from(stride()),
        "floats were left out"
    );
}

#[track_caller]
fn close(what: &str, at: f64, got: f64, wanted: f64, allowed: f64) {
    let error = (got - wanted).abs();
    assert!(
        error <= allowed,
        "{what} at {at:e}: got {got:e}, not {wanted:e}: error {:.2} u",
        error / U
    );
}

/// exp of l·h + ε(l·1 + k·1) with l = (0,0,1), k = (1,0,0): cos h, sin h, sin(h)/h and, as dual
/// parts, the derivatives −sin h and cos h.
fn exp_is_sine_and_cosine<M: Sample>() {
    let (zero, one) = (M::splat(0.0), M::splat(1.0));
    sweep::<M>(3.0 * PI, |angles| {
        let h = M::real(angles);
        let log = DualVector { real: [zero, zero, h], dual: [one, zero, one] };
        let parts = M::exp(log).components().map(M::lanes);
        for (lane, &h) in angles.iter().enumerate() {
            let (sin, cos) = h.sin_cos();
            let sinc = if h == 0.0 { 1.0 } else { sin / h };
            // A float near 3π is only known to 8 u.
            let allowed = 3.0 * U * h.max(1.0);
            close("cos", h, parts[3][lane], cos, allowed);
            close(
                "sin",
                h,
                parts[2][lane],
                sin,
                allowed.min(4.0 * U * h.max(f64::MIN_POSITIVE)) + 1e-45,
            );
            close("sinc", h, parts[4][lane], sinc, allowed);
            close("−sin", h, parts[7][lane], -sin, allowed);
            close("cos of the slide", h, parts[6][lane], cos, allowed);
        }
    });
}

/// The logarithm of a rotation keeps the *relative* precision of the angle, down to subnormals.
fn log_keeps_the_relative_precision_of_an_angle<M: Sample>() {
    let (zero, one) = (M::splat(0.0), M::splat(1.0));
    sweep::<M>(BELOW_RIGHT_ANGLE, |angles| {
        // Quaternions near the angles; what they mean is computed from their components.
        let sines: Vec<f64> = angles.iter().map(|h| f64::from(h.sin() as f32)).collect();
        let cosines: Vec<f64> = angles.iter().map(|h| f64::from(h.cos() as f32)).collect();
        let (sine, cosine) = (M::real(&sines), M::real(&cosines));
        let motion = M::motion([zero, zero, sine, cosine, one, zero, zero, zero]);
        let log = motion.log();
        let real = M::lanes(log.real[2]);
        for lane in 0..M::LANES {
            let wanted = sines[lane].atan2(cosines[lane]);
            let allowed = 5.0 * U * wanted + 3e-45;
            close("angle", wanted, real[lane], wanted, allowed);
        }
    });
}

/// (√σ)² = σ for every angle, and √σ has half of it.
fn root_has_half_the_angle<M: Sample>() {
    let (zero, one) = (M::splat(0.0), M::splat(1.0));
    sweep::<M>(BELOW_RIGHT_ANGLE, |angles| {
        let sines: Vec<f64> = angles.iter().map(|h| f64::from(h.sin() as f32)).collect();
        let cosines: Vec<f64> = angles.iter().map(|h| f64::from(h.cos() as f32)).collect();
        let motion =
            M::motion([zero, zero, M::real(&sines), M::real(&cosines), one, zero, zero, zero]);
        let root = motion.sqrt().components().map(M::lanes);
        for lane in 0..M::LANES {
            let half = 0.5 * sines[lane].atan2(cosines[lane]);
            close("sin of the half", half, root[2][lane], half.sin(), 5.0 * U * half + 3e-45);
            close("cos of the half", half, root[3][lane], half.cos(), 3.0 * U);
        }
    });
}

#[test]
fn exp_is_sine_and_cosine_for_every_angle() {
    on_every_f32_implementation!(exp_is_sine_and_cosine);
}

#[test]
fn log_keeps_relative_precision_for_every_angle() {
    on_every_f32_implementation!(log_keeps_the_relative_precision_of_an_angle);
}

#[test]
fn root_has_half_the_angle_for_every_angle() {
    on_every_f32_implementation!(root_has_half_the_angle);
}

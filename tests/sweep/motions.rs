//! Motions that depend on one number, an angle.

use crate::stride;
use dq8::{DualQuat, geometry::DualVector};
use dq8_contract::bound::unit_roundoff;
use dq8_contract::ledger::{Ledger, line};
use dq8_contract::sample::Sample;

use std::f32::consts::PI;

/// Runs a sweep on the scalar reference and on lanes: fused or not, they share the polynomials.
macro_rules! on_every_f32_implementation {
    ($sweep:ident, $ledger:ident) => {{
        $sweep::<DualQuat<f32>>($ledger);
        $sweep::<dq8::batch::DualQuat<f32>>($ledger);
        $sweep::<dq8::batch::DualQuat<dq8::simd::f32x4>>($ledger);
        $sweep::<dq8::batch::DualQuat<dq8::simd::f32x8>>($ledger);
        $sweep::<dq8::batch::DualQuat<dq8::simd::f32x16>>($ledger);
    }};
}

/// The largest float below π/2: the next one has a cosine below 0, whose motion is turned over.
const BELOW_RIGHT_ANGLE: f32 = f32::from_bits(std::f32::consts::FRAC_PI_2.to_bits() - 1);

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

/// An error in units of u · `scale`; below the normal numbers the last place no longer shrinks.
fn units(got: f64, wanted: f64, scale: f64) -> f64 {
    (got - wanted).abs() / scale.max(f64::from(f32::MIN_POSITIVE)) / unit_roundoff(true)
}

/// exp of l·h + ε(l·1 + k·1) with l = (0,0,1), k = (1,0,0): cos h, sin h, sin(h)/h and, as dual
/// parts, the derivatives −sin h and cos h.
fn exp_is_sine_and_cosine<M: Sample>(ledger: &Ledger) {
    let (zero, one) = (M::splat(0.0), M::splat(1.0));
    sweep::<M>(3.0 * PI, |angles| {
        let h = M::real(angles);
        let log = DualVector { real: [zero, zero, h], dual: [one, zero, one] };
        let parts = M::exp(log).components().map(M::lanes);
        for (lane, &h) in angles.iter().enumerate() {
            let (sin, cos) = h.sin_cos();
            let sinc = if h == 0.0 { 1.0 } else { sin / h };
            // A float near 3π is only known to 8 u.
            for (kind, part, wanted, scale) in [
                ("cos", 3, cos, h.max(1.0)),
                ("sin", 2, sin, h),
                ("sinc", 4, sinc, h.max(1.0)),
                ("-sin", 7, -sin, h.max(1.0)),
                ("cos of the slide", 6, cos, h.max(1.0)),
            ] {
                let units = units(parts[part][lane], wanted, scale);
                ledger.measure("exp", kind, units, || format!("{kind} of {h:e}"));
            }
        }
    });
}

/// The logarithm of a rotation keeps the *relative* precision of the angle, down to subnormals.
fn log_keeps_the_relative_precision_of_an_angle<M: Sample>(ledger: &Ledger) {
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
            let units = units(real[lane], wanted, wanted);
            ledger.measure("log", "", units, || format!("{wanted:e}"));
        }
    });
}

/// (√σ)² = σ for every angle, and √σ has half of it.
fn root_has_half_the_angle<M: Sample>(ledger: &Ledger) {
    let (zero, one) = (M::splat(0.0), M::splat(1.0));
    sweep::<M>(BELOW_RIGHT_ANGLE, |angles| {
        let sines: Vec<f64> = angles.iter().map(|h| f64::from(h.sin() as f32)).collect();
        let cosines: Vec<f64> = angles.iter().map(|h| f64::from(h.cos() as f32)).collect();
        let motion =
            M::motion([zero, zero, M::real(&sines), M::real(&cosines), one, zero, zero, zero]);
        let root = motion.sqrt().components().map(M::lanes);
        for lane in 0..M::LANES {
            let half = 0.5 * sines[lane].atan2(cosines[lane]);
            let place = || format!("half of {:e}", 2.0 * half);
            ledger.measure("sqrt", "sin", units(root[2][lane], half.sin(), half), place);
            ledger.measure("sqrt", "cos", units(root[3][lane], half.cos(), 1.0), place);
        }
    });
}

#[test]
fn exp_is_sine_and_cosine_for_every_angle() {
    let lines = &[
        line("exp", &["sin"], 3.0, "relative to the sine for small h"),
        line("exp", &[], 3.0, "a polynomial, and h² is rounded"),
    ];
    Ledger::keep("sines", lines, |ledger| {
        on_every_f32_implementation!(exp_is_sine_and_cosine, ledger)
    });
}

#[test]
fn log_keeps_relative_precision_for_every_angle() {
    let lines = &[line(
        "log",
        &[],
        5.0,
        "no cancellation: the vector part times a factor that varies slowly",
    )];
    Ledger::keep("logarithms", lines, |ledger| {
        on_every_f32_implementation!(log_keeps_the_relative_precision_of_an_angle, ledger)
    });
}

#[test]
fn root_has_half_the_angle_for_every_angle() {
    let lines = &[
        line("sqrt", &["sin"], 4.5, "the vector part over 2 cos(Θ/2)"),
        line("sqrt", &["cos"], 1.5, "the root of (1 + w)/2"),
    ];
    Ledger::keep("roots", lines, |ledger| {
        on_every_f32_implementation!(root_has_half_the_angle, ledger)
    });
}

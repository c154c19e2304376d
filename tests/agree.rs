//! Lanes against the scalar reference of the same precision: every operation, every lane type.
use dq8::DualQuat;
use dq8_contract::agreement::{Kind, distance};
use dq8_contract::inputs::{self, Arguments, Case};
use dq8_contract::repertoire::{self, ALGEBRA, NAMES, answer};
use dq8_contract::{for_every_implementation, sample::Sample, tolerance::unit_roundoff};
use proptest::prelude::*;
use std::collections::BTreeMap;

fn differences<M: Sample>(
    implementation: &str,
    names: &[&'static str],
    cases: &[Case],
    worst: &mut BTreeMap<String, (f64, String)>,
) {
    for chunk in cases.chunks(M::LANES) {
        let lanes = Arguments::<M>::new(chunk);
        for &name in names {
            let got = answer(name, &lanes);
            for (lane, case) in chunk.iter().enumerate() {
                let wanted = if M::SINGLE {
                    answer(name, &Arguments::<DualQuat<f32>>::new(&[*case]))
                } else {
                    answer(name, &Arguments::<DualQuat<f64>>::new(&[*case]))
                };
                let (got, _gm) = got.lane(lane);
                let (wanted, _wm) = wanted.lane(0);
                let scale = repertoire::scale(name, case);
                let dot: f64 = case.a.iter().zip(&case.b).take(4).map(|(a, b)| a * b).sum();
                let dotc: f64 = case.a.iter().zip(&case.c).take(4).map(|(a, b)| a * b).sum();
                if matches!(name, "nlerp" | "dlb" | "sclerp" | "sclerp_long")
                    && (dot.abs() < 16.0 * unit_roundoff(M::SINGLE)
                        || dotc.abs() < 16.0 * unit_roundoff(M::SINGLE))
                {
                    continue;
                }
                for (i, ((kind, g), (_, w))) in got.iter().zip(&wanted).enumerate() {
                    let d = if !g.is_finite() && !w.is_finite() {
                        0.0
                    } else {
                        distance(*g, *w, scale.of(*kind), M::SINGLE)
                    };
                    let e = worst.entry(format!("{name} {kind:?}")).or_default();
                    if d > e.0 {
                        *e = (
                            d,
                            format!(
                                "{implementation} [{i}] got {g:e} want {w:e} scale {:e} a={:?} b={:?} t={} screw={:?} v {:?} w {:?}",
                                scale.of(*kind),
                                case.a,
                                case.b,
                                case.t,
                                case.screw,
                                case.v,
                                case.w
                            ),
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn explore() {
    let verbose = std::env::var("VERBOSE").unwrap_or_default();
    let count: usize = std::env::var("COUNT").map_or(256, |c| c.parse().unwrap());
    for single in [true, false] {
        let mut worst = BTreeMap::new();
        for_every_implementation!(|name, M| {
            if M::SINGLE == single && name.starts_with("lanes") {
                let unit = inputs::unit_cases_n(count);
                differences::<M>(name, &NAMES, &unit, &mut worst);
                differences::<M>(name, &ALGEBRA, &inputs::general_cases_n(count), &mut worst);
            }
        });
        println!("SINGLE {single}");
        for (k, (v, text)) in &worst {
            println!(
                "{k:35} {v:10.2} {}",
                if k.starts_with(&verbose) && !verbose.is_empty() { text } else { "" }
            );
        }
    }
}

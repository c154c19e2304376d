//! Twists and Jacobians: every implementation against the scalar `f64` path, against
//! finite differences, and against their laws.

#[path = "differential/case.rs"]
mod case;
#[path = "differential/difference.rs"]
mod difference;
#[path = "differential/edge.rs"]
mod edge;
#[path = "differential/law.rs"]
mod law;
#[path = "differential/operation.rs"]
mod operation;
#[path = "differential/oracle.rs"]
mod oracle;

use case::{Arguments, Case, cases};
use dq8::DualQuat;
use dq8_contract::for_every_implementation;
use dq8_contract::ledger::Ledger;
use dq8_contract::sample::Sample;
use dq8_contract::tolerance::{section, unit_roundoff};
use operation::{answer, scale};

/// The worst error of the operation `name` of `M` over `cases`, in units of u · scale, and where.
fn worst_error<M: Sample>(name: &str, cases: &[Case]) -> (f64, Case) {
    // Below the normal numbers the last place no longer shrinks.
    let smallest = if M::SINGLE { f64::from(f32::MIN_POSITIVE) } else { f64::MIN_POSITIVE };
    let mut worst = (0.0, cases[0]);
    for chunk in cases.chunks(M::LANES) {
        let got = answer(name, &Arguments::<M>::new(chunk)).lanes::<M>();
        for (case, got) in chunk.iter().zip(got) {
            let case = case.rounded::<M>();
            let wanted = answer(name, &Arguments::<DualQuat<f64>>::new(&[case]));
            let scale = scale(name, &case).map(|scale| scale.max(smallest));
            let error = got.distance(&wanted, scale) / unit_roundoff(M::SINGLE);
            if error > worst.0 {
                worst = (error, case);
            }
        }
    }
    worst
}

/// The names of all operations.
fn names() -> impl Iterator<Item = &'static str> {
    section("twists").lines.iter().map(|line| line.op)
}

#[test]
fn every_implementation_keeps_the_table() {
    let cases = cases();
    let mut implementations = 0;
    Ledger::keep("twists", |ledger| {
        for_every_implementation!(|implementation, M| {
            for name in names() {
                // An infinite answer has no error; the tests of edges look at it.
                let finite = |case: &&Case| !name.ends_with("inverse") || case.angle() < 6.25;
                let cases: Vec<_> = cases.iter().filter(finite).copied().collect();
                let (error, case) = worst_error::<M>(name, &cases);
                ledger.measure(name, "", error, || format!("{implementation}: {case:?}"));
            }
            implementations += 1;
        });
    });
    assert_eq!(implementations, dq8_contract::sample::implementations(), "something did not run");
}

//! Known answers, computed with 60 digits, against every implementation under the accuracy
//! contract.

use dq8_contract::bound::find;
use dq8_contract::conformance::worst_errors;
use dq8_contract::implementation::implementations;
use dq8_contract::ledger::{Ledger, Line};
use dq8_contract::vectors::{self, Vector, known};

/// Each file and its rows.
fn files() -> [(&'static str, Vec<Vector>); 3] {
    [
        ("reference.jsonl", include_str!("vectors/reference.jsonl")),
        ("more.jsonl", include_str!("vectors/more.jsonl")),
        ("geometry.jsonl", include_str!("vectors/geometry.jsonl")),
    ]
    .map(|(file, text)| (file, vectors::parse(text).expect("the vectors can be read")))
}

#[test]
fn every_implementation_keeps_every_bound_on_every_vector() {
    let line = |known: vectors::Known| {
        known.bounds.iter().map(move |&bound| Line { op: known.name, bound })
    };
    let lines: Vec<_> = known().flat_map(line).collect();
    let (mut answered, mut rows) = (0, 0);
    Ledger::keep("vectors", &lines, |ledger| {
        for (file, vectors) in files() {
            for on in implementations() {
                rows += vectors.iter().filter(|vector| vector.is_on(on)).count();
                for worst in worst_errors(on, &vectors).expect("every operation has a bound") {
                    let place = || format!("{on:?}, {file}, row {}", worst.row);
                    ledger.measure(&worst.op, &worst.kind, worst.error / on.roundoff(), place);
                    answered += worst.vectors;
                }
            }
        }
    });
    assert_eq!(answered, rows, "something did not run");
}

#[test]
fn small_rotations_are_bounded_by_three_ten_millionths() {
    for op in ["sclerp", "pow", "sqrt", "log"] {
        let of_op = known().find(|known| known.name == op).expect("there are vectors for it");
        for kind in ["near0", "close", "translation"] {
            let units = find(of_op.bounds, kind).expect("it has a bound").units;
            assert!(units * f64::from(f32::EPSILON) / 2.0 <= 3e-7, "{op} ({kind}): {units} u");
        }
    }
}

#[test]
fn a_row_that_cannot_be_read_is_named() {
    let good = r#"{"op":"norm","kind":"general","a":[3,4,0,0,0,0,0,0],"out":["5","0"]}"#;
    let cases = [
        (r#"{"op":"norm""#, "EOF"),
        (r#"{"op":"twirl","kind":"plain","out":[]}"#, "unknown operation \"twirl\""),
        (r#"{"op":"norm","kind":"plain","out":["5","0"]}"#, "norm needs the field \"a\""),
        (r#"{"op":"norm","kind":"plain","a":[1,2],"out":["5","0"]}"#, "holds 2 numbers, not 8"),
        (
            r#"{"op":"norm","kind":"plain","a":[3,4,0,0,0,0,0,0],"out":["5","x"]}"#,
            "\"x\" is no number",
        ),
        (
            r#"{"op":"dlb","kind":"plain","s":[[1,0,0,0,0,0,0,0]],"w":[],"out":[1,0,0,0,0,0,0,0]}"#,
            "weights",
        ),
        (
            r#"{"op":"Line::from_points","kind":"plain","p":[1,2],"q":[0,0,0],"out":[0,0,0,0,0,0]}"#,
            "\"p\" holds 2 numbers, not 3",
        ),
        (
            r#"{"op":"Quat::to_euler","kind":"plain","a":[1,0,0,0],"order":24,"out":[0,0,0,1]}"#,
            "no order 24",
        ),
    ];
    assert_eq!(vectors::parse(good).expect("it is good").len(), 1);
    for (bad, reason) in cases {
        let error = vectors::parse(&format!("{good}\n{bad}\n")).expect_err(bad);
        assert_eq!(error.row, 2);
        assert!(error.to_string().contains(reason), "{error} should say {reason}");
    }
}

//! Known answers, computed with 60 digits, against every implementation under the accuracy contract.

use dq8_contract::conformance::worst_errors;
use dq8_contract::for_every_implementation;
use dq8_contract::ledger::Ledger;
use dq8_contract::sample::Sample;
use dq8_contract::tolerance::{TABLE, section, unit_roundoff};
use dq8_contract::vectors::{self, Vector};
use std::fs;
use std::path::{Path, PathBuf};

/// Each file and its rows.
fn files() -> [(&'static str, Vec<Vector>); 2] {
    [
        ("reference.jsonl", include_str!("vectors/reference.jsonl")),
        ("more.jsonl", include_str!("vectors/more.jsonl")),
    ]
    .map(|(file, text)| (file, vectors::parse(text).expect("the vectors can be read")))
}

#[test]
fn every_implementation_keeps_every_bound_on_every_vector() {
    let (mut answered, mut implementations, mut rows) = (0, 0, 0);
    Ledger::keep("vectors", |ledger| {
        for (file, vectors) in files() {
            rows += vectors.len();
            for_every_implementation!(|name, M| {
                let u = unit_roundoff(<M as Sample>::SINGLE);
                for worst in worst_errors::<M>(name, &vectors).expect("every operation has a bound")
                {
                    let place = || format!("{name}, {file}, row {}", worst.row);
                    ledger.measure(&worst.op, &worst.kind, worst.error / u, place);
                    answered += worst.vectors;
                }
                implementations += 1;
            });
        }
    });
    let expected = dq8_contract::sample::implementations();
    let counted = (implementations, answered);
    assert_eq!(counted, (files().len() * expected, expected * rows), "something did not run");
}

#[test]
fn small_rotations_are_bounded_by_three_ten_millionths() {
    for op in ["sclerp", "pow", "sqrt", "log"] {
        for kind in ["near0", "close", "translation"] {
            let units = section("vectors").line(op, kind).units;
            assert!(units * f64::from(f32::EPSILON) / 2.0 <= 3e-7, "{op} ({kind}): {units} u");
        }
    }
}

/// A ledger fails if one of its lines is not measured; here, if a section has no ledger.
#[test]
fn every_section_of_the_table_is_used() {
    let tests = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests");
    let mut sources = vec![tests.join("contract/conformance.rs")];
    for folder in ["", "blending", "differential", "hierarchy"] {
        for entry in fs::read_dir(tests.join(folder)).expect("it is a folder") {
            let path = entry.expect("it can be read").path();
            sources.extend(path.extension().is_some_and(|end| end == "rs").then_some(path));
        }
    }
    let read = |path: &PathBuf| fs::read_to_string(path).expect("it is a text");
    let text: String = sources.iter().map(read).collect();
    for (i, section) in TABLE.iter().enumerate() {
        let name = section.name;
        let kept = text.contains(&format!("Ledger::keep(\"{name}\""));
        let asked = text.contains(&format!("section(\"{name}\")"));
        assert!(kept || asked, "no test asks for the section {name:?}");
        // Lines that are looked up one by one are named one by one.
        for line in if kept { &[] } else { section.lines } {
            let op = text.contains(&format!("\"{}\"", line.op));
            let all = line.kinds.iter().all(|kind| text.contains(&format!("\"{kind}\"")));
            assert!(op && all, "no test asks for {line:?}");
        }
        assert!(TABLE[..i].iter().all(|other| other.name != name), "{name:?} is there twice");
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
    ];
    assert_eq!(vectors::parse(good).expect("it is good").len(), 1);
    for (bad, reason) in cases {
        let error = vectors::parse(&format!("{good}\n{bad}\n")).expect_err(bad);
        assert_eq!(error.row, 2);
        assert!(error.to_string().contains(reason), "{error} should say {reason}");
    }
}

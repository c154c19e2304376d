//! x
use dq8_contract::{for_every_implementation, operation, sample::Sample, vectors};
use std::collections::BTreeMap;

#[test]
fn explore() {
    let rows = vectors::parse(include_str!("vectors/reference.jsonl")).unwrap();
    let mut worst: BTreeMap<(String, String), Vec<String>> = BTreeMap::new();
    for_every_implementation!(|name, M| {
        if name.ends_with("f32") || name.ends_with("f64") || name.ends_with("x8") {
            let mut groups: BTreeMap<(String, String, usize), Vec<&vectors::Vector>> =
                BTreeMap::new();
            for r in &rows {
                groups
                    .entry((r.op.clone(), r.kind.clone(), r.input("w").len()))
                    .or_default()
                    .push(r);
            }
            let mut w: BTreeMap<(String, String), (f64, usize)> = BTreeMap::new();
            for ((op, kind, _), rows) in groups {
                for chunk in rows.chunks(<M as Sample>::LANES) {
                    let a = operation::answers::<M>(chunk);
                    for (r, a) in chunk.iter().zip(&a) {
                        let e = operation::error(r, a);
                        let s = w.entry((op.clone(), kind.clone())).or_default();
                        if e >= s.0 {
                            *s = (e, r.row);
                        }
                    }
                }
            }
            for (k, (e, row)) in w {
                worst.entry(k).or_default().push(format!("{e:.1e}@{row}"));
            }
        }
    });
    for (k, v) in worst {
        println!("{:27}{:12} {}", k.0, k.1, v.join("  "));
    }
}

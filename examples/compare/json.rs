//! The results for other programs.

use crate::results::{Limits, Results};
use dq8_contest::limit::Kind;
use serde_json::{Map, Value, json};

pub(crate) fn text(results: &Results) -> String {
    let rows: Vec<Value> = results
        .rows
        .iter()
        .map(|row| {
            let mut value = json!({
                "job": row.job,
                "size": row.size,
                "contender": row.contender,
                "profile": row.profile,
                "min_ns": row.min,
                "median_ns": row.median,
                "machine_varied": row.spread,
                "repeated": row.repeated,
            });
            if let Some(share) = results.limits.share(row) {
                value["share"] = share.into();
            }
            value
        })
        .collect();
    format!("{:#}\n", json!({ "rows": rows, "limits": limits(&results.limits) }))
}

fn limits(limits: &Limits) -> Value {
    let mut groups = Map::new();
    for (kind, &rate) in &limits.0 {
        let (group, name, rate) = match kind {
            // A multiplication and an addition.
            Kind::MultiplyAdd(backend) => ("fma_gflops", backend.to_string(), 2.0 * rate),
            Kind::Copy(size) => ("copy_gb_per_s", size.clone(), rate),
            Kind::Rewrite(size) => ("rewrite_gb_per_s", size.clone(), rate),
            Kind::Triad(size) => ("triad_gb_per_s", size.clone(), rate),
        };
        let group = groups.entry(group).or_insert_with(|| Value::Object(Map::new()));
        group[name] = rate.into();
    }
    Value::Object(groups)
}

#[cfg(test)]
mod tests {
    use super::text;
    use crate::results::{Results, Row};
    use dq8::Backend;
    use dq8_contest::limit::{Kind, Limited};

    #[test]
    fn rows_and_limits_are_there() {
        let (mut results, best) = (Results::default(), Backend::best());
        results.limits.reached(&Kind::MultiplyAdd(best), 64.0);
        results.limits.reached(&Kind::MultiplyAdd(best), 32.0);
        results.rows.push(Row {
            backend: Some(best),
            limited: Some(Limited::MultiplyAdds(48.0)),
            median: 2.0,
            spread: 0.25,
            repeated: 1,
            ..Row::sample("dq8 \"AoS\"", 1.5)
        });
        let value: serde_json::Value = serde_json::from_str(&text(&results)).unwrap();
        let row = &value["rows"][0];
        assert_eq!((&row["job"], &row["size"]), (&"J1".into(), &"L1".into()));
        assert_eq!(row["contender"], "dq8 \"AoS\"");
        assert_eq!((&row["min_ns"], &row["median_ns"]), (&1.5.into(), &2.0.into()));
        assert_eq!((&row["machine_varied"], &row["repeated"]), (&0.25.into(), &1.into()));
        // What fuses nothing has no share of a limit.
        let share = if best == Backend::PORTABLE { serde_json::Value::Null } else { 0.5.into() };
        assert_eq!((&row["share"], &row["profile"]), (&share, &"release".into()));
        assert_eq!(value["limits"]["fma_gflops"][best.to_string()], 128.0);
    }
}

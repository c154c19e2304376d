//! What the program prints.

use crate::results::{Limits, Row, best_own, first};
use dq8::Backend;
use dq8_contest::limit::Kind;
use std::fmt::{self, Write};

pub(crate) const LEGEND: &str = "
Nanoseconds a transform; × dq8: as many times the fastest of dq8, × AVX2: of dq8 on AVX2;
share: of the multiply-adds that the machine can do with these instructions (J1), or of the
speed at which it copies as many bytes (J2, out of place). The machine varied: what a chain of
products that is always the same took in the middle, against the shortest in the whole run.
";

/// One contest, its rows the fastest first.
pub(crate) fn contest(rows: &[&Row], limits: &Limits) -> Result<String, fmt::Error> {
    let mut text = String::new();
    if let [of, ..] = rows {
        let best = best_own(rows, |_| true);
        let avx2 = best_own(rows, |row| row.backend.is_some() && row.backend == Backend::avx2());
        writeln!(text, "\n{} {}: {} ({})", of.job, of.size, of.title, of.profile)?;
        let head = ["min ns", "median", "× dq8", "× AVX2", "share"];
        writeln!(text, "  {:<38}{}", "", head.map(|word| format!("{word:>9}")).concat())?;
        for row in rows {
            let ratio =
                |to: Option<f64>| to.map_or(String::new(), |to| format!("{:.2}", row.min / to));
            let share = limits.share(row);
            let share = share.map_or(String::new(), |share| format!("{:.0} %", 100.0 * share));
            let (name, min, median) = (&row.contender, row.min, row.median);
            let (best, avx2) = (ratio(best), ratio(avx2));
            writeln!(text, "  {name:<38}{min:>9.3}{median:>9.3}{best:>9}{avx2:>9}{share:>9}")?;
        }
        write!(text, "  The machine varied by {:.1} %", 100.0 * of.spread)?;
        if of.repeated > 0 {
            write!(text, ", {} measurements were repeated", of.repeated)?;
        }
        if let Some((first, second, lead)) = first(rows) {
            let (first, second, lead) = (&first.contender, &second.contender, 100.0 * lead);
            match lead > 100.0 * of.spread {
                true => write!(text, "; first: {first}, {lead:.0} % before {second}")?,
                false => {
                    write!(text, "; nobody is first: {first} and {second} are {lead:.1} % apart")?
                }
            }
        }
        text.push_str(".\n");
    }
    Ok(text)
}

/// What the machine can do at most.
pub(crate) fn limits(limits: &Limits) -> Result<String, fmt::Error> {
    let mut text = "\nLimits of this machine, one thread\n".to_owned();
    for (kind, rate) in &limits.0 {
        let name = match kind {
            Kind::MultiplyAdd(backend) => format!("multiply-adds, {backend}"),
            Kind::Copy(size) => format!("copy, {size}"),
            Kind::Rewrite(size) => format!("rewrite in place, {size}"),
            Kind::Triad(size) => format!("triad, {size}"),
        };
        let rate = match kind {
            Kind::MultiplyAdd(_) => format!("{:>8.1} GFLOP/s", 2.0 * rate),
            Kind::Copy(_) | Kind::Rewrite(_) | Kind::Triad(_) => format!("{rate:>8.1} GB/s"),
        };
        writeln!(text, "  {name:<28}{rate}")?;
    }
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::contest;
    use crate::results::{Limits, Row};

    fn sample(contender: &str, min: f64) -> Row {
        Row { spread: 0.02, repeated: 3, ..Row::sample(contender, min) }
    }

    #[test]
    fn nobody_is_first_by_less_than_the_machine_varies() {
        let text = |peer| {
            let (own, slow, peer) =
                (sample("dq8 a", 1.0), sample("dq8 b", 1.001), sample("glam", peer));
            contest(&[&own, &slow, &peer], &Limits::default()).unwrap()
        };
        let close = text(1.015);
        assert!(
            close.contains("by 2.0 %, 3 measurements were repeated; nobody is first"),
            "{close}"
        );
        assert!(close.contains("dq8 a and glam are 1.5 % apart"), "{close}");
        assert!(text(1.5).contains("; first: dq8 a, 50 % before glam"), "{}", text(1.5));
        let alone = contest(&[&sample("dq8 a", 1.0)], &Limits::default()).unwrap();
        assert!(!alone.contains("first"), "{alone}");
    }
}

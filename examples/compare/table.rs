//! What the program prints.

use crate::results::{Limits, Results, best_own};
use dq8::Backend;
use dq8_contest::limit::Kind;
use std::fmt::{self, Write};

pub(crate) fn text(results: &Results) -> Result<String, fmt::Error> {
    let mut text = String::new();
    write_limits(&mut text, &results.limits)?;
    for rows in results.contests() {
        let best = best_own(&rows, |_| true);
        let avx2 = best_own(&rows, |row| row.backend.is_some() && row.backend == Backend::avx2());
        let (job, size, title) = (rows[0].job, &rows[0].size, &rows[0].title);
        writeln!(text, "\n{job} {size}: {title} ({})", rows[0].profile)?;
        let head = ["min ns", "median", "× dq8", "× AVX2", "share"];
        writeln!(text, "  {:<38}{}", "", head.map(|word| format!("{word:>9}")).concat())?;
        for row in rows {
            let ratio =
                |to: Option<f64>| to.map_or(String::new(), |to| format!("{:.2}", row.min / to));
            let share = results.limits.share(row);
            let share = share.map_or(String::new(), |share| format!("{:.0} %", 100.0 * share));
            let (name, min, median) = (&row.contender, row.min, row.median);
            let (best, avx2) = (ratio(best), ratio(avx2));
            writeln!(text, "  {name:<38}{min:>9.3}{median:>9.3}{best:>9}{avx2:>9}{share:>9}")?;
        }
    }
    text.push_str(
        "\nNanoseconds a transform; × dq8: as many times the fastest of dq8, × AVX2: of dq8 on AVX2;\n\
         share: of the multiply-adds that the machine can do with these instructions (J1), or of the\n\
         speed at which it copies as many bytes (J2, out of place).\n",
    );
    Ok(text)
}

fn write_limits(text: &mut String, limits: &Limits) -> fmt::Result {
    writeln!(text, "Limits of this machine, one thread")?;
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
    Ok(())
}

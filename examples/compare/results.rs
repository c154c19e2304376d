//! [`Results`]: what has been measured.

use dq8::Backend;
use dq8_contest::limit::{Kind, Limited};
use std::collections::BTreeMap;

#[derive(Debug, Default)]
pub(crate) struct Results {
    pub(crate) rows: Vec<Row>,
    pub(crate) limits: Limits,
}

/// One contender in one contest; nanoseconds a transform.
#[derive(Clone, Debug)]
pub(crate) struct Row {
    pub(crate) job: &'static str,
    pub(crate) size: String,
    pub(crate) title: String,
    pub(crate) contender: String,
    pub(crate) backend: Option<Backend>,
    /// What it was built with.
    pub(crate) profile: &'static str,
    pub(crate) min: f64,
    pub(crate) median: f64,
    pub(crate) limited: Option<Limited>,
    /// By how much the machine's own speed varied in this contest, and how many measurements were
    /// repeated for it.
    pub(crate) spread: f64,
    pub(crate) repeated: usize,
}

impl Row {
    #[cfg(test)]
    pub(crate) fn sample(contender: &str, min: f64) -> Self {
        Self {
            job: "J1",
            size: "L1".into(),
            title: "product".into(),
            contender: contender.into(),
            backend: None,
            profile: "release",
            min,
            median: min,
            limited: None,
            spread: 0.0,
            repeated: 0,
        }
    }

    /// Names of this crate's contenders begin like this.
    pub(crate) fn is_own(&self) -> bool {
        self.contender.starts_with("dq8 ")
    }
}

/// The highest rates that were reached, per nanosecond.
#[derive(Debug, Default)]
pub(crate) struct Limits(pub(crate) BTreeMap<Kind, f64>);

impl Limits {
    pub(crate) fn reached(&mut self, kind: &Kind, rate: f64) {
        let most = self.0.entry(kind.clone()).or_insert(rate);
        *most = most.max(rate);
    }

    /// The part of the machine's limit that a row of this crate's uses.
    pub(crate) fn share(&self, row: &Row) -> Option<f64> {
        let (limited, backend) = (row.limited.as_ref()?, row.backend?);
        // Where nothing fuses, a multiplication that adds nothing takes half the time of one that
        // does.
        if matches!(limited, Limited::MultiplyAdds(_)) && backend == Backend::PORTABLE {
            return None;
        }
        let most = self.0.get(&limited.kind(backend))?;
        Some(limited.amount() / row.min / most)
    }
}

impl Results {
    /// Rows by contest, the fastest first.
    pub(crate) fn contests(&self) -> impl Iterator<Item = Vec<&Row>> {
        let contests = self.rows.chunk_by(|a, b| (a.job, &a.size) == (b.job, &b.size));
        contests.map(|rows| {
            let mut rows: Vec<&Row> = rows.iter().collect();
            rows.sort_by(|a, b| a.min.total_cmp(&b.min));
            rows
        })
    }
}

/// Who of `rows`, the fastest first, is first: the fastest, the fastest of the other side (this
/// crate, or its peers), and by how much of its time. Nothing where only one side takes part.
pub(crate) fn first<'r>(rows: &[&'r Row]) -> Option<(&'r Row, &'r Row, f64)> {
    let first = *rows.first()?;
    let second = *rows.iter().find(|row| row.is_own() != first.is_own())?;
    Some((first, second, second.min / first.min - 1.0))
}

/// The fastest of this crate's rows that `counts`.
pub(crate) fn best_own(rows: &[&Row], counts: impl Fn(&Row) -> bool) -> Option<f64> {
    let own = rows.iter().filter(|row| row.is_own() && counts(row));
    own.map(|row| row.min).min_by(f64::total_cmp)
}

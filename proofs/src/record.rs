//! [`Record`]: what an operation is on tape, in each form.

use crate::bound::{Analysis, Rounding};
use crate::number::Recorded;
use crate::operations::{Form, Operation};
use crate::sample;
use crate::tape::{Node, Tape, record};
use dq8::Backend;
use std::sync::{LazyLock, OnceLock};

/// An operation in one form: what a section of `bounds.toml` is about.
#[derive(Debug)]
pub struct Record {
    /// What it computes.
    pub operation: &'static Operation,
    /// By which code.
    pub form: Form,
    /// Whether a product that is added to something is rounded only with the sum.
    pub fused: bool,
    /// Of `f32` and `f64`, on the ordinary path: that of a motion that is nearly unit.
    pub tapes: [Tape; 2],
    /// Of each, for both roundings.
    analyses: [[OnceLock<Analysis>; 2]; 2],
}

impl Record {
    /// All, in the order of `bounds.toml`.
    #[must_use]
    pub fn all() -> &'static [Self] {
        static ALL: LazyLock<Vec<Record>> = LazyLock::new(|| {
            let mut all = vec![];
            for form in Form::ALL {
                for operation in form.operations() {
                    let tapes = [tape::<true>(operation, form), tape::<false>(operation, form)];
                    // What computes one configuration takes no backend, and fuses nothing in builds
                    // for any CPU.
                    let may_fuse = !operation.name.starts_with("link_");
                    for fused in [false, true] {
                        if !fused || may_fuse && tapes.iter().any(Tape::fuses) {
                            let (tapes, analyses) = (tapes.clone(), Default::default());
                            all.push(Record { operation, form, fused, tapes, analyses });
                        }
                    }
                }
            }
            all
        });
        &ALL
    }

    /// Those that are bounded by lengths.
    pub fn by_lengths() -> impl Iterator<Item = &'static Self> {
        Self::all().iter().filter(|record| record.is_by_lengths())
    }
    /// Whether this is: all but functions.
    #[must_use]
    pub fn is_by_lengths(&self) -> bool {
        self.form != Form::Function
    }

    /// As in `bounds.toml`.
    #[must_use]
    pub fn name(&self) -> String {
        let fused = if self.fused { ".fused" } else { "" };
        format!("{}.{}{fused}", self.form.name(), self.operation.name)
    }

    /// 0, and 1 where the two floats have code of their own.
    pub(crate) fn precisions(&self) -> std::ops::Range<usize> {
        0..2 - usize::from(self.tapes[0].is_same_as(&self.tapes[1]))
    }

    pub(crate) fn analysis(&self, precision: usize, rounding: Rounding) -> &Analysis {
        self.analyses[precision][rounding as usize].get_or_init(|| {
            let groups = self.operation.groups();
            Analysis::of(&self.tapes[precision], groups, self.fused, rounding)
        })
    }

    /// Whether a record before this one is the same: then nothing need be proved twice.
    pub(crate) fn is_twin(&self) -> bool {
        let mut before = Self::all().iter().take_while(|other| !std::ptr::eq(*other, self));
        before.any(|other| {
            (other.form, other.fused) == (self.form, self.fused)
                && other.operation.groups() == self.operation.groups()
                && other.tapes[0].is_same_as(&self.tapes[0])
        })
    }

    /// What comes after a weighted sum, and the nodes that it is given: sum, and point or normal.
    #[must_use]
    pub fn last(&self, precision: usize) -> Option<(&'static Self, Vec<Node>)> {
        const LAST: [&str; 5] =
            ["normalize", "quat_normalize", "scaled_point", "scaled_normal", "unit_normal"];
        let name = self.operation.name;
        if name.contains("normalize") || LAST.contains(&name) {
            return None;
        }
        let mut last = Self::all().iter().filter(|other| {
            (other.form, other.fused) == (self.form, self.fused)
                && LAST.contains(&other.operation.name)
        });
        last.find_map(|last| Some((last, self.tapes[precision].ends_in(&last.tapes[precision])?)))
    }
}

fn tape<const S: bool>(operation: &Operation, form: Form) -> Tape {
    record(&sample::ordinary(operation), |nodes| {
        let numbers: Vec<Recorded<S>> = nodes.iter().map(|&node| Recorded(node)).collect();
        let outputs = form.run()(operation.name, Backend::PORTABLE, &numbers);
        outputs.into_iter().map(|number| number.0).collect()
    })
}

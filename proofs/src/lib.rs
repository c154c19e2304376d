//! Rounding errors of dq8: bounds, proved of the code that ships.
//!
//! A number that writes its operations on a tape ([`number`]) goes through dq8's own functions ([`operations`]). The tape is
//! compared with the compiled code bit by bit (`tests/same_bits.rs`), bounded in closed form ([`bound`], kept in
//! `bounds.toml`), and written as scripts that Gappa and Coq check ([`gappa`], [`coq`], `run.sh`).

#[cfg(not(dq8_record))]
compile_error!(
    "needs --cfg dq8_record, which proofs/.cargo/config.toml sets: run from `proofs/`, without RUSTFLAGS"
);

pub mod bound;
pub mod composed;
pub mod coq;
pub mod everyday;
mod fraction;
pub mod gappa;
mod interval;
pub mod lanes;
pub mod number;
pub mod operations;
pub mod polynomial;
mod proof;
pub mod range;
pub mod sample;
pub mod table;
pub mod tape;

use number::Recorded;
use operations::{Form, Operation, functions, jobs, lanes as on_lanes, single};
use tape::{Tape, record};

/// The tape of an operation, on the ordinary path: that of a motion that is nearly unit. `None` where it has no such form.
#[must_use]
pub fn tape_of(operation: &Operation, form: Form, is_single: bool) -> Tape {
    let values = sample::ordinary(operation);
    if is_single {
        recorded::<true>(operation, form, &values)
    } else {
        recorded::<false>(operation, form, &values)
    }
}

/// Whether an operation before this one does the same: then nothing need be proved twice.
pub(crate) fn is_twin(operation: &Operation, form: Form, is_single: bool) -> bool {
    let tape = tape_of(operation, form, is_single);
    let before = form.operations().iter().take_while(|other| other.name != operation.name);
    before.into_iter().any(|other| {
        other.groups() == operation.groups() && tape_of(other, form, is_single).is_same_as(&tape)
    })
}

fn recorded<const S: bool>(operation: &Operation, form: Form, values: &[f64]) -> Tape {
    record(values, |nodes| {
        let numbers: Vec<Recorded<S>> = nodes.iter().map(|&node| Recorded(node)).collect();
        let outputs = match form {
            Form::Single => single::run(operation.name, &numbers),
            Form::Lanes => on_lanes::run(operation.name, &numbers),
            Form::Function => functions::run(operation.name, &numbers),
            Form::Job => jobs::run(operation.name, dq8::Backend::PORTABLE, &numbers),
        };
        outputs.into_iter().map(|number| number.0).collect()
    })
}

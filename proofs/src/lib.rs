//! Rounding errors of dq8: bounds, proved of the code that ships.
//!
//! A number that writes its operations on a tape ([`number`]) goes through dq8's own functions
//! ([`operations`]). The tapes ([`record`]) are compared with the compiled code bit by bit
//! (`tests/same_bits.rs`), bounded in closed form ([`bound`], kept in `bounds.toml`), and written
//! as scripts that Gappa and Coq check ([`gappa`], [`coq`], `run.sh`).

#[cfg(not(dq8_record))]
compile_error!(
    "needs --cfg dq8_record, which proofs/.cargo/config.toml sets: run from `proofs/`, without RUSTFLAGS"
);

pub mod bound;
pub mod composed;
pub mod coq;
mod fraction;
pub mod gappa;
mod interval;
pub mod lanes;
pub mod number;
pub mod operations;
pub mod polynomial;
mod proof;
pub mod quick;
pub mod range;
pub mod record;
pub mod sample;
pub mod table;
pub mod tape;

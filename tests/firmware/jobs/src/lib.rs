//! What every board computes, against answers with 60 digits, and the table that it prints.
#![no_std]
#![forbid(unsafe_code)]

#[rustfmt::skip]
#[expect(clippy::type_complexity, reason = "rows of tables")]
pub mod answers;
mod arm;
mod biped;
mod board;
pub mod error;
mod operations;
mod table;

pub use board::Board;
pub use table::Table;

/// Runs everything; true if all answers are right.
pub fn run<B: Board>(board: &mut B) -> bool {
    let mut table = Table::begin(board);
    biped::run(&mut table);
    arm::run(&mut table);
    operations::run(&mut table);
    table.end()
}

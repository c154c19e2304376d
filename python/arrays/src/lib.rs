//! NumPy arrays in and out, and the functions on them.
//!
//! A call ([`call`]) finds its precision, takes its arguments and its result as memory
//! ([`argument`], [`output`]), finds runs of elements that lie one after the other ([`broadcast`]),
//! and computes each of them ([`sweep`]) with the best instructions. What is computed for one
//! element is a [`law::Law`], written on lanes.

pub mod argument;
pub mod axis;
mod blend;
pub mod broadcast;
pub mod call;
pub mod columns;
mod cure;
pub mod error;
pub mod functions;
pub mod interrupt;
pub mod law;
pub mod links;
pub mod number;
pub mod output;
pub mod plain;
pub mod shape;
mod sweep;
pub mod threads;

//! The table of errors allowed.
pub const PLACEHOLDER: f64 = 1.0;

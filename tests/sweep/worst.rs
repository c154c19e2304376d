//! The floats at which the functions err most, of all there are, with their right values (60 digits by mpmath, as `f64`).

pub(crate) const WORST: &[(&str, u32, f64)] = &[];

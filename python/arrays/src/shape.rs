//! Shapes of arrays: the last dimensions of one element, and how shapes are written.

pub const NUMBER: &[usize] = &[];
pub const VECTOR: &[usize] = &[3];
/// A twist.
pub const SIX: &[usize] = &[6];
/// A motion.
pub const EIGHT: &[usize] = &[8];

/// As NumPy prints shapes.
pub fn tuple(shape: &[usize]) -> String {
    let sizes: Vec<_> = shape.iter().map(ToString::to_string).collect();
    format!("({}{})", sizes.join(", "), if shape.len() == 1 { "," } else { "" })
}

/// (..., 8)
pub fn pattern(core: &[usize]) -> String {
    let sizes: String = core.iter().map(|size| format!(", {size}")).collect();
    format!("(...{sizes})")
}

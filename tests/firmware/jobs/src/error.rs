//! How far an answer is off.

/// The largest difference of two components, over the largest component expected or 1, in units of
/// 2⁻²³. NaN if something is not a number.
pub fn error(computed: &[f32], expected: &[f32]) -> f32 {
    let (mut difference, mut size) = (0.0, 1.0);
    for (&computed, &expected) in computed.iter().zip(expected) {
        difference = max_or_nan((computed - expected).abs(), difference);
        size = max_or_nan(expected.abs(), size);
    }
    difference / size / f32::EPSILON
}

/// The same for motions, of which σ and −σ are one.
pub fn motion_error(computed: [f32; 8], expected: &[f32; 8]) -> f32 {
    let [same, other] = [computed, computed.map(|c| -c)].map(|c| error(&c, expected));
    if other < same { other } else { same }
}

/// NaN if either is, unlike `f32::max`: a lost answer must not pass.
pub fn max_or_nan(a: f32, b: f32) -> f32 {
    if a > b || a.is_nan() { a } else { b }
}

//! Dual vectors, lines and planes. The second opinion is vector geometry in plain `f64`: closest
//! points by solving for them, angles by Kahan's formula, planes by solving for their normals.

mod algebra;
mod edge;
mod motion;
mod pair;
mod plane;

use dq8::Real;
use dq8_contract::bound::{exact, rounded};
use dq8_contract::inputs::vector;
use dq8_contract::vector::{add, length, scale, sub, unit};
use proptest::prelude::*;

/// A point and a direction.
type Ray = ([f64; 3], [f64; 3]);

/// θ = 2 atan2(|û − v̂|, |û + v̂|) (Kahan 2006).
fn angle(u: [f64; 3], v: [f64; 3]) -> f64 {
    let (u, v) = (unit(u), unit(v));
    2.0 * length(sub(u, v)).atan2(length(add(u, v)))
}

/// What `R` makes of them, in `f64`.
fn as_stored<R: Real>((point, direction): Ray) -> Ray {
    (exact(rounded::<R, 3>(point)), exact(rounded::<R, 3>(direction)))
}

/// Vectors of lengths from 10⁻³ to 10³, all directions alike or nearly.
fn direction() -> impl Strategy<Value = [f64; 3]> {
    let vector = vector().prop_filter("it has a direction", |v| length(*v) > 0.25);
    (vector, -3.0..3.0_f64).prop_map(|(v, exponent)| scale(v, 10.0_f64.powf(exponent)))
}

/// Points near the origin, and some farther away.
fn point() -> impl Strategy<Value = [f64; 3]> {
    let size = prop_oneof![4 => Just(1.0), 1 => Just(100.0), 1 => Just(1e4)];
    (vector(), size).prop_map(|(v, size)| scale(v, size))
}

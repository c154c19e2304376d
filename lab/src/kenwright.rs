//! Formulas and code of Kenwright, as printed, and what he compares dual quaternions with: to show
//! where they break. Not for use.

use core::cell::Cell;
use core::f64::consts::TAU;
use dq8::{DualQuat, Quat};
use std::rc::Rc;

/// Euler angles of §3.3: about the fixed x, then y, then z.
pub fn euler([x, y, z]: [f64; 3]) -> Quat<f64> {
    let about = |axis: usize, angle| {
        Quat::from_axis_angle(core::array::from_fn(|i| if i == axis { 1.0 } else { 0.0 }), angle)
    };
    about(2, z) * about(1, y) * about(0, x)
}

/// An angle of §3.3 in [0, 2π).
pub fn within_a_turn(angle: f64) -> f64 {
    if angle < 0.0 { angle + TAU } else { angle }
}

/// Linear interpolation of §§3.3.4 and 3.4.2, of each parameter by itself.
pub fn straight<const N: usize>(from: [f64; N], to: [f64; N], t: f64) -> [f64; N] {
    core::array::from_fn(|i| from[i] + t * (to[i] - from[i]))
}

/// `DualQuaternion_c(r, d)` of §13.1: r is normalized and d kept.
pub fn constructor(r: Quat<f64>, d: Quat<f64>) -> DualQuat<f64> {
    DualQuat::new(r.normalize(), d)
}

/// An object of a class of §13.1: a reference.
pub type Object = Rc<Cell<DualQuat<f64>>>;

/// `q * scale` of §13.1: `DualQuaternion_c ret = q; ret.m_real *= scale`.
pub fn times(q: &Object, scale: f64) -> Object {
    let ret = Rc::clone(q);
    ret.set(ret.get().scale(scale));
    ret
}

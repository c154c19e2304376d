//! B. Kenwright, *A Beginners Guide to Dual-Quaternions*, §13.1: what his class does that its
//! formulas do not say.

use crate::{assert_close, assert_far, motions};
use core::cell::Cell;
use dq8::{DualQuat, Quat};
use lab::kenwright::{Object, constructor, times};

/// `operator +` goes through the constructor. Two poses in the same place, two radians apart, mixed
/// half and half, are elsewhere: 10 cos ½ · cos ½ · 2 is not 10.
#[test]
fn appendix_erratum_a_sum_through_the_constructor_is_no_sum() {
    let place = [10.0, 0.0, 0.0];
    let pose = |angle| {
        DualQuat::from_rotation_translation(Quat::from_axis_angle([0.0, 0.0, 1.0], angle), place)
    };
    let [a, b] = [pose(0.0).scale(0.5), pose(2.0).scale(0.5)];
    let his = constructor(a.real() + b.real(), a.dual() + b.dual());
    // |a + b| = cos ½ is divided out of the real part only.
    let (sin, cos) = 0.5_f64.sin_cos();
    assert_close(his.translation(), [10.0 * cos, 0.0, 0.0], 1e-14);
    assert!(sin > 0.4 && his.is_unit(1e-12), "the lost factor cannot be seen in the result");
    assert_close((a + b).normalize().translation(), place, 1e-14);
    assert_far(his.translation(), place);
    // Nor does it distribute: a sum with half of another pose is another pose.
    let [c, d] = motions();
    let sum = constructor(c.real() + d.real(), c.dual() + d.dual());
    assert_far(sum.to_array(), (c + d).to_array());
}

/// `public class`: `DualQuaternion_c ret = q; ret.m_real *= scale` writes into q, as here through
/// an `Rc`. So `q * scale`, `Normalize(q)`, and by it `DualQuaternionToMatrix(q)`, change their
/// argument.
#[test]
fn appendix_erratum_a_class_is_a_reference_and_operators_change_their_argument() {
    let [unit, _] = motions();
    let q = Object::new(Cell::new(unit));
    let twice = times(&q, 2.0);
    assert_eq!(twice.get(), unit.scale(2.0));
    assert_eq!(q.get(), unit.scale(2.0), "his argument has changed too");
    // In dq8 motions are values.
    let kept = unit;
    let twice = kept.scale(2.0);
    assert_eq!((kept, twice), (unit, unit.scale(2.0)));
}

/// `Assert(mag > 0.000001f)` with mag the *square*: lengths below 10⁻³ are refused. dq8
/// normalizes as long as the length is a number above zero.
#[test]
fn appendix_the_assertion_refuses_lengths_that_dq8_normalizes() {
    let refused = |q: DualQuat<f64>| q.real().dot(q.real()) <= 0.000_001;
    let [unit, _] = motions();
    for length in [0.9e-3, 1e-10, 1e-100, 1e-300] {
        let short = unit.scale(length);
        assert!(refused(short));
        assert_close(short.try_normalize().unwrap().to_array(), unit.to_array(), 1e-14);
    }
    assert!(!refused(unit.scale(1.1e-3)));
    assert!(DualQuat::<f64>::ZERO.try_normalize().is_err());
}

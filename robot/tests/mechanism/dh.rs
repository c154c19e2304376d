//! Arms from tables of Denavit and Hartenberg, against the products of their books.

use dq8::{DualQuat, Quat};
use dq8_robot::{Dh, DhConvention, MechanismError, OwnedMechanism};

fn turn(axis: [f64; 3], angle: f64) -> DualQuat<f64> {
    DualQuat::from_rotation(Quat::from_axis_angle(axis, angle))
}

fn shift(x: f64, z: f64) -> DualQuat<f64> {
    DualQuat::from_translation([x, 0.0, z])
}

/// The rows below that slide, as a reader of the table sees it.
const SLIDES: [bool; 4] = [false, true, false, false];

/// θ, d, a, α of hinges and slides.
fn table() -> [Dh<f64>; 4] {
    [
        Dh::hinge(0.2, 0.3, 0.1, -1.2),
        Dh::slide(-0.4, 0.5, 0.2, 0.7),
        Dh::hinge(0.0, 0.0, 0.4, 0.0).with_limits([-1.0, 2.0]),
        Dh::hinge(1.1, -0.2, 0.0, 1.5),
    ]
}

#[test]
fn both_conventions_are_the_products_of_their_books() {
    let (x, z) = ([1.0, 0.0, 0.0], [0.0, 0.0, 1.0]);
    let values = [0.4, -0.3, 0.8, 2.5];
    let tool = turn([0.6, 0.8, 0.0], 0.3) * shift(0.1, 0.2);
    for convention in [DhConvention::Standard, DhConvention::Modified] {
        let mut book = DualQuat::IDENTITY;
        for ((row, slides), value) in table().into_iter().zip(SLIDES).zip(values) {
            let (turned, slid) = if slides { (0.0, value) } else { (value, 0.0) };
            let along_z = turn(z, row.theta + turned) * shift(0.0, row.d + slid);
            let along_x = turn(x, row.alpha) * shift(row.a, 0.0);
            book = match convention {
                DhConvention::Standard => book * along_z * along_x,
                DhConvention::Modified => book * along_x * along_z,
            };
        }
        let arm = OwnedMechanism::from_dh(&table(), convention, tool).unwrap();
        let found = arm.link_pose(&values, 4).unwrap();
        assert!(found.abs_diff_eq(book * tool, 1e-14), "{convention:?}");
        assert_eq!(arm.view().limits(2), Some([-1.0, 2.0]));
    }
}

#[test]
fn what_is_not_finite_is_named() {
    let mut rows = table();
    rows[2].a = f64::NAN;
    for (convention, joint) in [(DhConvention::Standard, 3), (DhConvention::Modified, 2)] {
        let error = OwnedMechanism::from_dh(&rows, convention, DualQuat::IDENTITY).unwrap_err();
        let named = match error {
            MechanismError::NotFinite { joint, .. }
            | MechanismError::Placement { joint, .. }
            | MechanismError::DualPart { joint, .. } => joint,
            other => panic!("{other}"),
        };
        assert_eq!(named, joint, "{error}");
    }
}

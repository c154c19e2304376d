//! Every representation into every other.

use super::{Worst, between, for_random_motions, opinion, worst};
use core::f64::consts::{FRAC_PI_2, PI};
use dq8::{
    DualQuat, Quat, Real,
    representation::{EulerAngles, EulerOrder, RotationTranslation},
    scalar::MatrixError,
};
use dq8_contract::bound::{exact, rounded, roundoff};
use dq8_contract::inputs::{edge_motions, for_all, unit_motion};
use nalgebra::{Isometry3, Point3, Quaternion, Translation3, UnitQuaternion};

/// A few operations on each side, on the scale of the translation.
const ROUNDING: f64 = 4e-15;
/// An element of a matrix, two products in it; and the rotation that it makes again.
const ELEMENT: f64 = 1e-15;
const THERE_AND_BACK: f64 = 3e-15;

/// A motion, in one of the forms there are.
#[derive(Clone, Copy, Debug)]
enum Form<R> {
    Euler(EulerAngles<R>, [R; 3]),
    AxisAngle([R; 3], R, [R; 3]),
    ScaledAxis([R; 3], [R; 3]),
    Matrix3([[R; 3]; 3], [R; 3]),
    Matrix3x4([[R; 4]; 3]),
    Matrix4([[R; 4]; 4]),
    RotationTranslation(RotationTranslation<R>),
    DualQuat(DualQuat<R>),
}

impl<R: Real> Form<R> {
    /// All forms of a motion, Euler angles in each of `orders`.
    fn all(motion: DualQuat<R>, orders: &[EulerOrder]) -> impl Iterator<Item = Self> {
        let (rotation, translation) = (motion.rotation(), motion.translation());
        let (axis, angle) = rotation.to_axis_angle();
        let euler = move |&order| Self::Euler(rotation.to_euler(order).angles, translation);
        let others = [
            Self::AxisAngle(axis, angle, translation),
            Self::ScaledAxis(rotation.to_scaled_axis(), translation),
            Self::Matrix3(rotation.to_matrix3(), translation),
            Self::Matrix3x4(motion.to_matrix3x4()),
            Self::Matrix4(motion.to_matrix4()),
            Self::RotationTranslation(motion.into()),
            Self::DualQuat(motion),
        ];
        orders.iter().map(euler).chain(others)
    }

    fn motion(self) -> DualQuat<R> {
        let tolerance = R::EPSILON * R::from(16.0);
        let join = DualQuat::from_rotation_translation;
        match self {
            Self::Euler(angles, t) => join(angles.to_quat(), t),
            Self::AxisAngle(axis, angle, t) => join(Quat::from_axis_angle(axis, angle), t),
            Self::ScaledAxis(v, t) => join(Quat::from_scaled_axis(v), t),
            Self::Matrix3(rows, t) => {
                join(Quat::try_from_matrix3(rows, tolerance).expect("a rotation"), t)
            }
            Self::Matrix3x4(rows) => {
                DualQuat::try_from_matrix3x4(rows, tolerance).expect("a rigid motion")
            }
            Self::Matrix4(rows) => {
                DualQuat::try_from_matrix4(rows, tolerance).expect("a rigid motion")
            }
            Self::RotationTranslation(pose) => pose.into(),
            Self::DualQuat(motion) => motion,
        }
    }
}

/// The motion as nalgebra has it.
fn isometry(motion: DualQuat<f64>) -> Isometry3<f64> {
    let [w, x, y, z] = motion.rotation().to_wxyz();
    let rotation = UnitQuaternion::from_quaternion(Quaternion::new(w, x, y, z));
    Isometry3::from_parts(Translation3::from(motion.translation()), rotation)
}

/// Gimbal lock of all orders, none, quarter and half turns about each axis, and tiny ones.
fn edges() -> Vec<DualQuat<f64>> {
    let mut edges: Vec<_> = edge_motions().into_iter().map(DualQuat::from_array).collect();
    for axis in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] {
        for angle in [FRAC_PI_2, -FRAC_PI_2, PI, -PI, 1e-300, 1e-40, 1e-9] {
            let turn = Quat::from_axis_angle(axis, angle);
            edges.push(DualQuat::from_rotation_translation(turn, [1.0, -2.0, 3.0]));
        }
    }
    edges
}

/// Points of a motion made from one form, by way of another, beside those of nalgebra. Angles in
/// one order become angles in the same.
fn all_pairs<R: Real>(motion: DualQuat<f64>, orders: &[EulerOrder], worst: &Worst) {
    let start = DualQuat::<R>::from_array(rounded(motion.to_array())).normalize();
    let wanted = isometry(DualQuat::from_array(exact(start.to_array())));
    let size = 1.0 + wanted.translation.vector.norm();
    let points =
        [[1.0, 0.0, 0.0], [0.0, -0.6, 0.8]].map(|point| (point, wanted * Point3::from(point)));
    for first in Form::all(start, orders) {
        let orders = match &first {
            Form::Euler(angles, _) => core::slice::from_ref(&angles.order),
            _ => orders,
        };
        for second in Form::all(first.motion(), orders) {
            let got = DualQuat::from_array(exact(second.motion().to_array()));
            for (point, wanted) in points {
                let off = Point3::from(got.transform_point(point)) - wanted;
                worst.see(off.norm(), roundoff::<R>() * size, &(first, second));
            }
        }
    }
}

fn every_representation_reaches_every_other<R: Real>(allowed: f64) {
    let why = "two conversions in a row, each within the bound of its own, and a point is moved";
    let worst = worst("each to each", allowed, why);
    let turn = std::cell::Cell::new(0);
    for_all(300, &unit_motion(), |motion| {
        let motion = DualQuat::from_array(motion);
        let order = EulerOrder::ALL[turn.replace(turn.get() + 1) % 24];
        all_pairs::<R>(motion, &[order], &worst);
    });
    for motion in edges() {
        all_pairs::<R>(motion, &EulerOrder::ALL, &worst);
    }
}

#[test]
fn every_representation_reaches_every_other_in_f32() {
    every_representation_reaches_every_other::<f32>(20.0);
}

#[test]
fn every_representation_reaches_every_other_in_f64() {
    every_representation_reaches_every_other::<f64>(28.0);
}

#[test]
fn poses_compose_invert_and_move_as_motions_do() {
    let step = RotationTranslation {
        rotation: Quat::from_axis_angle([0.6, 0.0, -0.8], 2.0),
        translation: [3.0, -1.0, 0.5],
    };
    for_random_motions(|motion| {
        let pose = RotationTranslation::from(motion);
        let size = 1.0 + isometry(motion).translation.vector.norm();
        let wanted = isometry(motion) * isometry(step.into());
        let point = [0.5, -2.0, 1.5];
        let close = |got: [f64; 3], wanted: Point3<f64>| {
            let off = (Point3::from(got) - wanted).norm() / size;
            assert!(off < ROUNDING, "{off:e} off: {motion:?}");
        };
        close((pose * step).transform_point(point), wanted * Point3::from(point));
        close(
            pose.inverse().transform_point(point),
            isometry(motion).inverse() * Point3::from(point),
        );
        close((pose * pose.inverse()).transform_point(point), Point3::from(point));
        assert_eq!(pose.transform_vector(point), motion.transform_vector(point));
        assert_eq!(RotationTranslation::from_array(pose.to_array()), pose);
        assert_eq!(pose * RotationTranslation::IDENTITY, pose);
    });
}

#[test]
fn whole_turns_of_the_axes_go_through_matrices_exactly() {
    let half = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];
    let third = [[0.5, 0.5, 0.5, 0.5], [-0.5, 0.5, 0.5, 0.5], [0.5, -0.5, -0.5, 0.5]];
    for xyzw in half.into_iter().chain(third).chain([[0.0, 0.0, 0.0, 1.0_f32]]) {
        let turn = Quat::from_array(xyzw);
        assert_eq!(Quat::from_matrix3(turn.to_matrix3()), turn);
        assert_eq!(Quat::try_from_matrix3(turn.to_matrix3(), 0.0), Ok(turn));
        let motion = DualQuat::from_rotation_translation(turn, [1.0, 2.0, 3.0]);
        assert_eq!(DualQuat::from_matrix3x4(motion.to_matrix3x4()), motion);
        assert_eq!(DualQuat::from(RotationTranslation::from(motion)), motion);
    }
}

/// Against glam, whose quaternions know the same matrices.
#[test]
fn rotation_matrices_are_those_of_glam() {
    for_random_motions(|motion| {
        let glam = glam::DQuat::from_array(motion.rotation().to_array());
        let columns = glam::DMat3::from_quat(glam).to_cols_array_2d();
        let rows = motion.rotation().to_matrix3();
        for (row, column) in (0..9).map(|i| (i / 3, i % 3)) {
            assert!((rows[row][column] - columns[column][row]).abs() < ELEMENT);
        }
        let back = Quat::from_matrix3(rows);
        assert!(between(opinion(back), opinion(motion.rotation())) < THERE_AND_BACK, "{back:?}");
        assert!(back.w() >= 0.0, "{back:?} is the longer way");
    });
}

#[test]
fn a_matrix_that_is_no_rotation_says_why() {
    let error = |rows| Quat::<f64>::try_from_matrix3(rows, 1e-9).expect_err("it is bad");
    let mirror = error([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]]);
    assert_eq!(mirror, MatrixError::Mirrors { determinant: -1.0 });
    let sheared = error([[1.0, 0.0, 0.0], [0.5, 1.0, 0.0], [0.0, 0.0, 1.0]]);
    assert_eq!(sheared, MatrixError::NotOrthonormal { row: 0, column: 1, value: 0.5 });
    let nothing = error([[1.0, 0.0, 0.0], [0.0, f64::NAN, 0.0], [0.0, 0.0, 1.0]]);
    assert!(
        matches!(nothing, MatrixError::NotOrthonormal { row: 0, column: 1, value } if value.is_nan())
    );
}

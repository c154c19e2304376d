//! Arends, chapter 2, §4: e and ln of each element.

use super::{about_z, assert_differ, assert_same};
use lab::keyframe::{
    interpolate, interpolate_elements, matrix, orthonormality_error, smallest_offset,
};
use nalgebra::{Matrix4, Vector2, Vector3};

fn keys() -> (Matrix4<f64>, Matrix4<f64>) {
    (matrix(about_z(20.0)), matrix(about_z(140.0)))
}

#[test]
fn elements_end_where_they_should() {
    let (a, b) = keys();
    let offset = smallest_offset(&a, &b);
    assert_same(&interpolate_elements(&a, &b, 0.0, offset), &a, 1e-15);
    assert_same(&interpolate_elements(&a, &b, 1.0, offset), &b, 1e-15);
    assert_eq!(smallest_offset(&a, &b), 1.0 - a.min().min(b.min()));
    let all_large = Matrix4::repeat(3.0);
    assert_eq!(smallest_offset(&all_large, &all_large), 0.0);
}

#[test]
fn section_4_erratum_between_keys_elements_give_no_rotation() {
    let (a, b) = keys();
    let smallest = smallest_offset(&a, &b);
    for offset in [smallest, smallest + 1.0, smallest + 10.0] {
        let middle = interpolate_elements(&a, &b, 0.5, offset);
        assert!(orthonormality_error(&middle) > 0.5, "{offset}: {middle}");
        assert!(orthonormality_error(&interpolate(&a, &b, 0.5).unwrap()) < 1e-14);
    }
}

#[test]
fn section_4_erratum_the_result_depends_on_the_offset_that_he_leaves_open() {
    let (a, b) = keys();
    let smallest = smallest_offset(&a, &b);
    let at = |offset| interpolate_elements(&a, &b, 0.5, offset);
    assert_differ(&at(smallest), &at(smallest + 1.0), 0.05);
    // With larger and larger offsets it becomes the plain mean, which is no rotation either.
    assert_same(&at(1e6), &((a + b) * 0.5), 1e-6);
}

#[test]
fn without_an_offset_elements_that_are_not_positive_have_no_logarithm() {
    let (a, b) = keys();
    assert!(interpolate_elements(&a, &b, 0.5, 0.0)[(0, 0)].is_nan());
}

/// "C(0.5) gives the vector exactly on the arc between A and B": of vectors, even positive ones, it
/// does not; of matrices, after Alexa, it does.
#[test]
fn section_4_the_middle_lies_on_the_arc_for_matrices_and_not_for_elements() {
    let arc = |degrees: f64| Vector2::new(degrees.to_radians().cos(), degrees.to_radians().sin());
    let elements = arc(20.0).zip_map(&arc(70.0), |a, b| (0.5 * a.ln() + 0.5 * b.ln()).exp());
    assert!((elements.norm() - 0.801_7).abs() < 1e-4, "{}", elements.norm());
    let [a, b] = [20.0_f64, 70.0].map(|d| Matrix4::new_rotation(Vector3::z() * d.to_radians()));
    let middle = interpolate(&a, &b, 0.5).unwrap().transform_vector(&Vector3::x());
    assert!((middle.xy() - arc(45.0)).norm() < 1e-15);
}

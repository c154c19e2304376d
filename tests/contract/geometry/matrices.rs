//! Matrices that are, or are near, rotations and rigid motions.

use dq8::batch;
use dq8::representation::{Polar, gram_schmidt};
use dq8::{DualQuat, Quat};

geometry! { matrices:
    "Polar::try_from_matrix3"(rows: matrix3) -> polar, polar, [
        on(&["close"], 1.6, "of the scale, which is over the two smaller singular values"),
        within(12.0, "an eigenvector of a 4×4 matrix by Jacobi rotations, each of which rounds all of it; products of R and A")],
        alone Polar::try_from_matrix3(rows);
    "gram_schmidt"(rows: matrix3) -> rows, orthonormal, [
        within(3.3, "each column over its largest element and its length, twice across; a cross product")],
        alone gram_schmidt(rows);
    "Quat::try_from_matrix3"(rows: matrix3, tolerance: number) -> quat, |_| each(4, 1.0), [
        within(3.0, "rounded on the way in; divided by its largest sum and normalized")],
        tried Quat::try_from_matrix3(rows, tolerance), batch::Quat::from_matrix3_checked(rows, tolerance);
    "DualQuat::try_from_matrix3x4"(rows: matrix3x4, tolerance: number) -> motion, rigid, [
        within(3.0, "as from_matrix3, and a product with the translation, halved")],
        tried DualQuat::try_from_matrix3x4(rows, tolerance),
        batch::DualQuat::from_matrix3x4_checked(rows, tolerance);
    "DualQuat::try_from_matrix4"(rows: matrix4, tolerance: number) -> motion, rigid, [
        within(1.7, "as from_matrix3x4")],
        tried DualQuat::try_from_matrix4(rows, tolerance),
        batch::DualQuat::from_matrix4_checked(rows, tolerance);
}

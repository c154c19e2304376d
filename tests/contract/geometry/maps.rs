//! Maps of points: affine ones, and rotations with translations.

use dq8::representation::{Affine, RotationTranslation};

geometry! { maps:
    "Affine::from_motion"(a: unit_motion) -> map, of_motion, [
        within(10.5, "normalized first; squares and sums of products, doubled")],
        alone Ok::<_, ()>(Affine::from_motion(a));
    "Affine::shear"(s: point, n: point) -> map, shear, [
        within(1.1, "one product and one sum")],
        alone Ok::<_, ()>(Affine::shear(s, n));
    "Affine::reflection"(a: plane) -> map, reflection, [
        within(1.0, "one product and one sum")],
        alone Ok::<_, ()>(Affine::reflection(a));
    "Affine::transform_point"(a: matrix3x4, p: point) -> point, map_of_point, [
        within(1.2, "a sum of 4 terms")],
        alone Ok::<_, ()>(Affine::from_matrix3x4(a).transform_point(p));
    "Affine::transform_vector"(a: matrix3x4, p: point) -> point, map_of_vector, [
        within(1.1, "a sum of 3 products")],
        alone Ok::<_, ()>(Affine::from_matrix3x4(a).transform_vector(p));
    "Affine::mul"(a: matrix3x4, b: matrix3x4) -> rows, product_of_maps, [
        within(1.8, "sums of 3 products and one term")],
        alone Ok::<_, ()>((Affine::from_matrix3x4(a) * Affine::from_matrix3x4(b)).to_matrix3x4());
    "Affine::try_decompose"(a: matrix3x4) -> decomposed, decomposed, [
        on(&["close"], 2.6, "as the polar decomposition"),
        within(15.0, "the polar decomposition, and a product of its rotation with the translation, halved")],
        alone Affine::from_matrix3x4(a).try_decompose();
    "RotationTranslation::mul"(a: unit_pose, b: unit_pose) -> pose, product_of_poses, [
        within(6.0, "rotations normalized first, multiplied; a rotated vector and a sum")],
        alone Ok::<_, ()>(pose(a) * pose(b));
    "RotationTranslation::inverse"(a: unit_pose) -> pose, inverse_pose, [
        on(&["near0"], 1.5, "hardly turns"),
        within(12.0, "normalized first; an error of q counts twice on each side of t")],
        alone Ok::<_, ()>(pose(a).inverse());
    "RotationTranslation::transform_point"(a: unit_pose, p: point) -> point, pose_of_point, [
        on(&["near0"], 1.2, "hardly turns"),
        within(10.0, "as inverse, and a sum")],
        alone Ok::<_, ()>(pose(a).transform_point(p));
    "RotationTranslation::transform_vector"(a: unit_pose, p: point) -> point, |v| each(3, v.norm("p")), [
        on(&["near0"], 0.9, "hardly turns"),
        within(7.0, "as inverse")],
        alone Ok::<_, ()>(pose(a).transform_vector(p));
}

fn pose<R>((rotation, translation): (dq8::Quat<R>, [R; 3])) -> RotationTranslation<R> {
    RotationTranslation { rotation, translation }
}

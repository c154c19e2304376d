//! The core of the algebra: products, unit motions, points.

use dq8::{DualQuat, Quat};

type Motion = DualQuat<f32>;

#[unsafe(no_mangle)]
fn core_product(a: &Motion, b: &Motion) -> Motion {
    *a * *b
}

#[unsafe(no_mangle)]
fn core_from_rotation_translation(rotation: &Quat<f32>, translation: &[f32; 3]) -> Motion {
    Motion::from_rotation_translation(*rotation, *translation)
}

#[unsafe(no_mangle)]
fn core_translation(a: &Motion) -> [f32; 3] {
    a.translation()
}

#[unsafe(no_mangle)]
fn core_conjugate(a: &Motion) -> Motion {
    a.conjugate()
}

#[unsafe(no_mangle)]
fn core_normalize(a: &Motion) -> Motion {
    a.normalize()
}

#[unsafe(no_mangle)]
fn core_point(a: &Motion, point: &[f32; 3]) -> [f32; 3] {
    a.transform_point(*point)
}

#[unsafe(no_mangle)]
fn core_vector(a: &Motion, vector: &[f32; 3]) -> [f32; 3] {
    a.transform_vector(*vector)
}

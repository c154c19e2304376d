//! A rigid motion as each crate has it.

use core::ops::Mul;
use dq8::{DualQuat, Quat};
use micromath::Quaternion;
use micromath::vector::F32x3;
use nalgebra::{Isometry3, Point3, Translation3, UnitQuaternion};

pub(crate) trait Contender: Copy + Mul<Output = Self> {
    const NAMES: Names;
    fn new(rotation: [f32; 4], translation: [f32; 3]) -> Self;
    fn translation(self) -> [f32; 3];
    fn point(&self, point: [f32; 3]) -> [f32; 3];
}

/// What its lines are called.
pub(crate) struct Names {
    pub(crate) product: &'static str,
    pub(crate) biped: &'static str,
    pub(crate) point: &'static str,
}

impl Contender for DualQuat<f32> {
    const NAMES: Names = Names {
        product: "product, dq8",
        biped: "biped, dq8, plain loop",
        point: "point, dq8, one by one",
    };
    fn new(rotation: [f32; 4], translation: [f32; 3]) -> Self {
        Self::from_rotation_translation(Quat::from_array(rotation), translation)
    }
    fn translation(self) -> [f32; 3] {
        self.translation()
    }
    fn point(&self, point: [f32; 3]) -> [f32; 3] {
        self.transform_point(point)
    }
}

impl Contender for Isometry3<f32> {
    const NAMES: Names =
        Names { product: "product, nalgebra", biped: "biped, nalgebra", point: "point, nalgebra" };
    fn new([x, y, z, w]: [f32; 4], [tx, ty, tz]: [f32; 3]) -> Self {
        let rotation = UnitQuaternion::new_unchecked(nalgebra::Quaternion::new(w, x, y, z));
        Self::from_parts(Translation3::new(tx, ty, tz), rotation)
    }
    fn translation(self) -> [f32; 3] {
        self.translation.vector.into()
    }
    fn point(&self, [x, y, z]: [f32; 3]) -> [f32; 3] {
        self.transform_point(&Point3::new(x, y, z)).coords.into()
    }
}

/// What one writes with micromath, which has no rigid motions.
#[derive(Clone, Copy)]
pub(crate) struct Micromath {
    rotation: Quaternion,
    translation: F32x3,
}

impl Mul for Micromath {
    type Output = Self;
    fn mul(self, local: Self) -> Self {
        Self {
            rotation: self.rotation * local.rotation,
            translation: self.rotation.rotate(local.translation) + self.translation,
        }
    }
}

impl Contender for Micromath {
    const NAMES: Names = Names {
        product: "product, micromath",
        biped: "biped, micromath",
        point: "point, micromath",
    };
    fn new([x, y, z, w]: [f32; 4], translation: [f32; 3]) -> Self {
        Self { rotation: Quaternion::new(w, x, y, z), translation: vector(translation) }
    }
    fn translation(self) -> [f32; 3] {
        array(self.translation)
    }
    fn point(&self, point: [f32; 3]) -> [f32; 3] {
        array(self.rotation.rotate(vector(point)) + self.translation)
    }
}

fn vector([x, y, z]: [f32; 3]) -> F32x3 {
    F32x3 { x, y, z }
}

fn array(vector: F32x3) -> [f32; 3] {
    [vector.x, vector.y, vector.z]
}

//! Rotation and translation, in and out, and matrices.

use crate::group::Group;
use criterion::Criterion;
use dq8::Motion;
use glam::Affine3A;
use nalgebra::UnitDualQuaternion;

pub(crate) fn from_rotation_translation(criterion: &mut Criterion) {
    let mut group = Group::new(criterion, "from_rotation_translation");
    own!(group, one, |case| (case.rotation, case.translation), |(rotation, translation)| {
        motion_from(one, rotation, translation)
    });
    group.glam(
        |case| (case.rotation, case.translation),
        |(rotation, translation)| Affine3A::from_rotation_translation(rotation, translation),
    );
    group.nalgebra(
        |case| (case.rotation, case.translation),
        |(rotation, translation)| UnitDualQuaternion::from_parts(translation, rotation),
    );
}

pub(crate) fn translation(criterion: &mut Criterion) {
    let mut group = Group::new(criterion, "translation");
    own!(group, |case| case.a, |a| a.translation());
    group.nalgebra(|case| case.a, |a| a.translation());
}

pub(crate) fn to_matrix3x4(criterion: &mut Criterion) {
    let mut group = Group::new(criterion, "to_matrix3x4");
    own!(group, |case| case.a, |a| a.to_matrix3x4());
    // It has 4×4 only.
    group.nalgebra(|case| case.a, |a| a.to_homogeneous());
}

/// Names the type that the constructor is to make: that of the first argument.
#[inline(always)]
fn motion_from<M: Motion>(_: M, rotation: M::Quat, translation: [M::Real; 3]) -> M {
    M::from_rotation_translation(rotation, translation)
}

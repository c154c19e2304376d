//! What motions do to points, directions and lines.

use crate::group::Group;
use crate::representation::Representation;
use criterion::Criterion;
use glam::Affine3A;
use nalgebra::UnitDualQuaternion;

pub(crate) fn points_by_one(criterion: &mut Criterion) {
    let mut group = Group::new(criterion, "points_by_one");
    own!(group, one, |case| case.vector, |point| one.transform_point(point));
    let one = Affine3A::from_motion(&group.contenders.scalar.one);
    group.glam(|case| case.vector, |point| one.transform_point3a(point));
    let one = UnitDualQuaternion::from_motion(&group.contenders.scalar.one);
    group.nalgebra(|case| case.point, |point| one.transform_point(&point));
}

pub(crate) fn points_by_each(criterion: &mut Criterion) {
    let mut group = Group::new(criterion, "points_by_each");
    own!(group, |case| (case.a, case.vector), |(a, point)| a.transform_point(point));
    group.glam(|case| (case.a, case.vector), |(a, point)| a.transform_point3a(point));
    group.nalgebra(|case| (case.a, case.point), |(a, point)| a.transform_point(&point));
}

pub(crate) fn directions_by_each(criterion: &mut Criterion) {
    let mut group = Group::new(criterion, "directions_by_each");
    own!(group, |case| (case.a, case.vector), |(a, vector)| a.transform_vector(vector));
    group.glam(|case| (case.a, case.vector), |(a, vector)| a.transform_vector3a(vector));
    group.nalgebra(|case| (case.a, case.vector), |(a, vector)| a.transform_vector(&vector));
}

pub(crate) fn lines_by_each(criterion: &mut Criterion) {
    let mut group = Group::new(criterion, "lines_by_each");
    own!(group, |case| (case.a, case.line), |(a, line)| a.transform_line(line));
}

//! The algebra of dual quaternions.

use crate::group::Group;
use crate::representation::Product;
use criterion::Criterion;

pub(crate) fn product(criterion: &mut Criterion) {
    let mut group = Group::new(criterion, "product");
    own!(group, |case| (case.a, case.b), |(a, b)| a * b);
    group.glam(|case| (case.a, case.b), |(a, b)| a.product(&b));
    group.nalgebra(|case| (case.a, case.b), |(a, b)| a.product(&b));
}

pub(crate) fn normalize(criterion: &mut Criterion) {
    let mut group = Group::new(criterion, "normalize");
    own!(group, |case| case.scaled, |a| a.normalize());
    // By the real norm only.
    group.nalgebra(|case| case.scaled, |a| a.normalize());
}

pub(crate) fn inverse(criterion: &mut Criterion) {
    let mut group = Group::new(criterion, "inverse");
    own!(group, |case| case.a, |a| a.inverse());
    group.glam(|case| case.a, |a| a.inverse());
    group.nalgebra(|case| case.a, |a| a.inverse());
}

pub(crate) fn conjugate(criterion: &mut Criterion) {
    let mut group = Group::new(criterion, "conjugate");
    own!(group, |case| case.a, |a| a.conjugate());
    group.nalgebra(|case| case.a, |a| a.conjugate());
}

pub(crate) fn conjugate_dual(criterion: &mut Criterion) {
    let mut group = Group::new(criterion, "conjugate_dual");
    own!(group, |case| case.a, |a| a.conjugate_dual());
}

pub(crate) fn conjugate_both(criterion: &mut Criterion) {
    let mut group = Group::new(criterion, "conjugate_both");
    own!(group, |case| case.a, |a| a.conjugate_both());
}

//! Screws: logarithm, exponential, powers and interpolation.

use crate::group::Group;
use criterion::Criterion;
use dq8::{DualVector, Motion};

pub(crate) fn log(criterion: &mut Criterion) {
    let mut group = Group::new(criterion, "log");
    own!(group, |case| case.a, |a| a.log());
}

pub(crate) fn exp(criterion: &mut Criterion) {
    let mut group = Group::new(criterion, "exp");
    own!(group, one, |case| case.log, |log| exp_as(one, log));
}

pub(crate) fn pow(criterion: &mut Criterion) {
    let mut group = Group::new(criterion, "pow");
    own!(group, |case| (case.a, case.t), |(a, t)| a.pow(t));
}

pub(crate) fn sclerp(criterion: &mut Criterion) {
    let mut group = Group::new(criterion, "sclerp");
    own!(group, |case| (case.a, case.b, case.t), |(a, b, t)| a.sclerp(b, t));
    group.nalgebra(|case| (case.a, case.b, case.t), |(a, b, t)| a.sclerp(&b, t));
}

/// Names the type that the function is to make: that of the first argument.
#[inline(always)]
fn exp_as<M: Motion>(_: M, log: DualVector<M::Real>) -> M {
    M::exp(log)
}

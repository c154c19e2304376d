//! Linear blending.

use crate::group::Group;
use criterion::Criterion;

pub(crate) fn nlerp(criterion: &mut Criterion) {
    let mut group = Group::new(criterion, "nlerp");
    own!(group, |case| (case.a, case.b, case.t), |(a, b, t)| a.nlerp(b, t));
    // By the real norm only, and without a look for the shorter way.
    group.nalgebra(|case| (case.a, case.b, case.t), |(a, b, t)| a.nlerp(&b, t));
}

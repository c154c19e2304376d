//! [`OwnedPlan`]: the [`Plan`] that a skeleton keeps.

use super::Hierarchy;
use super::plan::{Order, Plan, is_long_chain, split_roots};
use super::schedule::{PlanScratch, schedule};
use alloc::boxed::Box;
use alloc::vec;
use dq8_simd::internal::CheckedSchedule;

/// The order of a [`Plan`], checked.
#[derive(Clone, Debug)]
pub(super) struct OwnedPlan {
    roots: Box<[[u32; 2]]>,
    /// `None` for a chain in segments.
    others: Option<CheckedSchedule<Box<[[u32; 2]]>>>,
}

impl OwnedPlan {
    pub(super) fn new(hierarchy: &Hierarchy<'_>) -> Self {
        let joints = hierarchy.joints();
        let mut order = vec![[0; 2]; joints];
        schedule(hierarchy, &mut order, &mut vec![PlanScratch::default(); joints]);
        if is_long_chain(&order) {
            return Self { roots: Box::default(), others: None };
        }
        let (roots, others) = split_roots(&order);
        let others = CheckedSchedule::new(others.into(), joints);
        let others = others.expect("a hierarchy's parents are among its joints");
        Self { roots: roots.into(), others: Some(others) }
    }

    /// Of the same parents.
    #[inline]
    pub(super) fn borrowed<'a>(&'a self, parents: &'a [u32]) -> Plan<'a> {
        let others = self.others.as_ref();
        let order = others.map(|others| Order { roots: &self.roots, others: others.borrowed() });
        Plan { parents, order }
    }
}

//! [`Schedule`]: which joints are computed when, and together with which.

use super::Hierarchy;
use alloc::vec;
use alloc::vec::Vec;
use dq8_simd::Indices;

/// How many joints share registers: eight lanes of `f32`, or four of `f64`, twice.
const LANES: usize = Indices::COUNT;

/// From this many joints on, lanes that stay empty are worth it.
pub(super) const LEAST_GROUP: usize = 4;

#[derive(Clone, Debug, Default)]
pub(super) struct Schedule {
    singles: Vec<[u32; 2]>,
    groups: Vec<Group>,
    /// Ends in `singles` and in `groups`.
    runs: Vec<[usize; 2]>,
}

/// Joints that do not wait for each other.
#[derive(Clone, Debug)]
pub(super) struct Group {
    pub(super) joints: Indices,
    pub(super) parents: Indices,
}

/// Single joints, then groups.
pub(super) struct Run<'s> {
    /// Joint and parent.
    pub(super) singles: &'s [[u32; 2]],
    pub(super) groups: &'s [Group],
}

impl Schedule {
    pub(super) fn new(hierarchy: &Hierarchy<'_>, least: usize) -> Self {
        let parents = hierarchy.parents();
        let mut heights = vec![0_u32; parents.len()];
        for (joint, &parent) in parents.iter().enumerate().rev() {
            let above = heights[joint] + 1;
            if let Some(height) = heights.get_mut(parent as usize) {
                *height = above.max(*height);
            }
        }
        let mut order: Vec<u32> = (0..).take(parents.len()).collect();
        let parent = |joint: u32| parents[joint as usize];
        let root = |joint: u32| parent(joint) == Hierarchy::ROOT;
        order.sort_by_key(|&joint| (!root(joint), u32::MAX - heights[joint as usize]));
        let mut schedule = Self::default();
        let same =
            |a: &u32, b: &u32| heights[*a as usize] == heights[*b as usize] && root(*a) == root(*b);
        for level in order.chunk_by(same) {
            let mut groups = Vec::new();
            let mut singles = Vec::new();
            for joints in level.chunks(LANES) {
                if joints.len() < least || root(joints[0]) {
                    singles.extend(joints.iter().map(|&joint| [joint, parent(joint)]));
                } else {
                    // The last joint again, where there are no more.
                    let joints: [u32; LANES] =
                        core::array::from_fn(|lane| joints[lane.min(joints.len() - 1)]);
                    let parents = Indices::new(joints.map(parent));
                    groups.push(Group { joints: Indices::new(joints), parents });
                }
            }
            schedule.push(singles, groups);
        }
        schedule
    }

    fn push(&mut self, singles: Vec<[u32; 2]>, groups: Vec<Group>) {
        let before = [self.singles.len(), self.groups.len()];
        self.singles.extend(singles);
        self.groups.extend(groups);
        let after = [self.singles.len(), self.groups.len()];
        let started = self.runs.len().checked_sub(2).map_or([0; 2], |i| self.runs[i]);
        match self.runs.last_mut() {
            // Nothing lies between: no groups so far, or no singles now.
            Some(last) if started[1] == before[1] || after[0] == before[0] => *last = after,
            _ => self.runs.push(after),
        }
    }

    #[inline(always)]
    pub(super) fn runs(&self) -> impl Iterator<Item = Run<'_>> {
        let mut start = [0; 2];
        self.runs.iter().map(
            #[inline(always)]
            move |&end| {
                let singles = self.singles.get(start[0]..end[0]).unwrap_or_default();
                let groups = self.groups.get(start[1]..end[1]).unwrap_or_default();
                start = end;
                Run { singles, groups }
            },
        )
    }
}

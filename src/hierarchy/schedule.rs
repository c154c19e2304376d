//! [`Schedule`]: which joint is computed when, if they are computed one by one.

use super::Hierarchy;
use alloc::collections::{BinaryHeap, VecDeque};
use alloc::vec;
use alloc::vec::Vec;
use core::cmp::Reverse;
use dq8_simd::CheckedSchedule;

/// How many other joints are begun before a joint whose parent is being computed. A product of a plan
/// takes about four times as long as until the next one can begin.
///
/// Measured on skeletons of 21 and 64 joints, with other values here, by `cargo bench --bench hierarchy
/// -- one-instance`: 3 to 6 are the same within a few hundredths, plain level order takes a twentieth
/// longer, depth first half as long again.
const BETWEEN: usize = 4;

/// The joints of one instance in the order of computing.
#[derive(Clone, Debug)]
pub(super) struct Schedule {
    /// Joints without a parent, which come first.
    pub(super) roots: Vec<usize>,
    /// Joint and parent of the others.
    pub(super) steps: CheckedSchedule,
}

impl Schedule {
    /// Of the joints whose parent is done, the one with the longest way down comes first: it decides
    /// how long the whole takes. The others fill the time in which it waits for its parent.
    ///
    /// This is list scheduling by the critical path, for one unit that begins a product per time step and returns
    /// it [`BETWEEN`] steps later:
    ///
    /// ```text
    /// able = roots
    /// at each time step:
    ///     able += those of `soon` whose time has come
    ///     begin the joint of `able` with the greatest height (the first, among equals)
    ///     soon += its children, BETWEEN steps from now
    /// ```
    ///
    /// Times only rise, so `soon` is a queue and needs no sorting; a step with nothing to begin is skipped.
    pub(super) fn new(hierarchy: &Hierarchy<'_>) -> Self {
        let parents = hierarchy.parents();
        // The longest way from a joint down, and its children, the last one first. Parents come before their
        // children, so one sweep from the last joint finds all heights.
        let mut heights = vec![0_u32; parents.len()];
        let mut children = vec![Vec::new(); parents.len()];
        let mut able = BinaryHeap::new();
        let joints: Vec<u32> = (0..).take(parents.len()).collect();
        for (&joint, &parent) in joints.iter().zip(parents).rev() {
            let height = heights[joint as usize];
            match children.get_mut(parent as usize) {
                Some(siblings) => {
                    siblings.push(joint);
                    let above = &mut heights[parent as usize];
                    *above = (height + 1).max(*above);
                }
                None => able.push((height, Reverse(joint))),
            }
        }
        let mut roots = Vec::new();
        let mut steps = Vec::with_capacity(parents.len());
        // Joints whose parent has begun, and from when on they may.
        let mut soon = VecDeque::new();
        let mut time = 0;
        while roots.len() + steps.len() < parents.len() {
            if able.is_empty() {
                // All there is waits for its parent.
                time = soon.front().map_or(time, |&(when, _)| time.max(when));
            }
            while let Some(&(when, joint)) = soon.front()
                && when <= time
            {
                soon.pop_front();
                able.push((heights[joint as usize], Reverse(joint)));
            }
            let Some((_, Reverse(joint))) = able.pop() else { break };
            let index = joint as usize;
            soon.extend(children[index].iter().rev().map(|&child| (time + BETWEEN, child)));
            match parents[index] {
                Hierarchy::ROOT => roots.push(index),
                parent => steps.push([joint, parent]),
            }
            time += 1;
        }
        let steps = CheckedSchedule::new(steps.into_boxed_slice(), parents.len());
        Self { roots, steps: steps.expect("a hierarchy's parents are among its joints") }
    }
}

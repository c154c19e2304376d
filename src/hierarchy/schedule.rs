//! The order in which joints are computed one by one.

use super::Hierarchy;
use core::cmp::Reverse;

/// The number of other joints that are begun before a joint whose parent is being computed. A
/// product of a plan takes about four times as long as until the next one can begin.
///
/// Measured on skeletons of 21 and 64 joints, with other values here, by
/// `cargo bench --bench hierarchy -- one-instance`: 3 to 6 are the same within a few hundredths,
/// plain level order takes a twentieth longer, depth first half as long again.
const BETWEEN: u32 = 4;

/// No joint: the end of a list of children.
const NONE: u32 = Hierarchy::ROOT;

/// The facts about one joint, and one place in each of two queues, while an order is looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(C)]
pub struct PlanScratch {
    /// The longest way from the joint down.
    height: u32,
    /// A list of its children, in their order.
    first_child: u32,
    next_sibling: u32,
    /// A joint whose parent is done: these are a binary heap, the one to begin first on top.
    able: u32,
    /// A joint whose parent has begun, and from when on it may: these are a queue.
    soon: u32,
    when: u32,
}

impl Default for PlanScratch {
    fn default() -> Self {
        Self { height: 0, first_child: NONE, next_sibling: NONE, able: NONE, soon: NONE, when: 0 }
    }
}

/// Writes the joints of a hierarchy into `order`, each with its parent: first those that have none,
/// and then the others, as they should be computed. Both slices have an element per joint.
///
/// Of the joints whose parent is done, the one with the longest way down comes first: it decides
/// how long the whole takes. The others fill the time in which it waits for its parent.
///
/// This is list scheduling by the critical path, for one unit that begins a product per time step
/// and returns it [`BETWEEN`] steps later:
///
/// ```text
/// able = roots
/// at each time step:
///     able += those of `soon` whose time has come
///     begin the joint of `able` with the greatest height (the first, among equals)
///     soon += its children, BETWEEN steps from now
/// ```
///
/// Times only rise, so `soon` is a queue and needs no sorting; a step with nothing to begin is
/// skipped. All memory is the caller's, so that a microcontroller can have plans; nothing here can
/// panic.
pub(super) fn schedule(
    hierarchy: &Hierarchy<'_>,
    order: &mut [[u32; 2]],
    scratch: &mut [PlanScratch],
) {
    scratch.fill(PlanScratch::default());
    let mut search = Search { of: scratch, able: 0, begin: 0, end: 0 };
    let mut roots = 0;
    // Parents come before their children, so one sweep from the last joint finds all heights.
    for (joint, &parent) in hierarchy.parents().iter().enumerate().rev() {
        // Each goes to the front of its parent's list, so going backwards leaves the children in
        // their order. A root's parent is no place in memory, and `change` does nothing there.
        let (of, above) = (search.at(joint), search.at(parent as usize));
        search.change(joint, |of| of.next_sibling = above.first_child);
        search.change(parent as usize, |above| {
            above.height = above.height.max(of.height + 1);
            above.first_child = joint as u32;
        });
        if parent == NONE {
            search.push(joint as u32);
            roots += 1;
        }
    }
    let (to_roots, to_others) = order.split_at_mut_checked(roots).unwrap_or_default();
    let (mut to_roots, mut to_others) = (to_roots.iter_mut(), to_others.iter_mut());
    let mut time = 0_u32;
    // Each joint is pushed once and popped once: as a root above, or when the time of its parent's
    // product has come.
    while search.able > 0 || search.begin < search.end {
        if search.able == 0 {
            // All there is waits for its parent.
            time = time.max(search.at(search.begin).when);
        }
        while search.begin < search.end && search.at(search.begin).when <= time {
            search.push(search.at(search.begin).soon);
            search.begin += 1;
        }
        let joint = search.pop();
        // Its children may begin when its product is done.
        let mut child = search.at(joint as usize).first_child;
        while child != NONE {
            let when = time.saturating_add(BETWEEN);
            search.change(search.end, |of| (of.soon, of.when) = (child, when));
            search.end += 1;
            child = search.at(child as usize).next_sibling;
        }
        let parent = hierarchy.parents().get(joint as usize).copied().unwrap_or(NONE);
        // Roots have no product and are copied before everything else, whatever their turn was.
        let place = if parent == NONE { to_roots.next() } else { to_others.next() };
        if let Some(place) = place {
            *place = [joint, parent];
        }
        time = time.saturating_add(1);
    }
}

/// The state of [`schedule`], and its two queues.
struct Search<'s> {
    of: &'s mut [PlanScratch],
    /// The number in the heap.
    able: usize,
    /// The begin and the end of the queue. Each joint is in it once, so it never begins again at 0.
    begin: usize,
    end: usize,
}

impl Search<'_> {
    fn at(&self, index: usize) -> PlanScratch {
        self.of.get(index).copied().unwrap_or_default()
    }

    fn change(&mut self, index: usize, change: impl FnOnce(&mut PlanScratch)) {
        if let Some(of) = self.of.get_mut(index) {
            change(of);
        }
    }

    /// `true` if the joint at `a` of the heap begins before that at `b`.
    fn before(&self, a: usize, b: usize) -> bool {
        let rank = |joint| (self.at(joint as usize).height, Reverse(joint));
        rank(self.at(a).able) > rank(self.at(b).able)
    }

    fn swap(&mut self, a: usize, b: usize) {
        let (of_a, of_b) = (self.at(a).able, self.at(b).able);
        self.change(a, |at| at.able = of_b);
        self.change(b, |at| at.able = of_a);
    }

    fn push(&mut self, joint: u32) {
        // At the end of the heap, then up past every joint that begins later.
        let mut at = self.able;
        self.change(at, |last| last.able = joint);
        self.able += 1;
        while at > 0 && self.before(at, (at - 1) / 2) {
            self.swap(at, (at - 1) / 2);
            at = (at - 1) / 2;
        }
    }

    fn pop(&mut self) -> u32 {
        // The last joint takes the place of the first, then sinks below every one that begins
        // sooner.
        let top = self.at(0).able;
        self.able = self.able.saturating_sub(1);
        self.swap(0, self.able);
        let mut at = 0;
        loop {
            let (left, right) = (2 * at + 1, 2 * at + 2);
            let best = if right < self.able && self.before(right, left) { right } else { left };
            if best >= self.able || !self.before(best, at) {
                return top;
            }
            self.swap(at, best);
            at = best;
        }
    }
}

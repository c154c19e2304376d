//! [`Scratch`], the memory of a search for all lanes, which is a slice of the caller, and the
//! length that this slice must have.

use super::problem::Reach;
use crate::mechanism::tree::Mechanism;
use dq8::{Scalar, ShapeError};
use dq8_simd::{Lanes, MAX_LANES};

/// A slice of registers. Each row of the slice is one register and holds one component for every
/// lane.
#[derive(Debug)]
pub(super) struct Registers<'s, L: Lanes>(pub(super) &'s mut [L::Array]);

impl<L: Lanes> Registers<'_, L> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn get(&self, level: L::Level, row: usize) -> L {
        match self.0.get(row) {
            Some(array) => L::load(level, array),
            None => L::splat(level, L::Real::default()),
        }
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn set(&mut self, row: usize, lanes: L) {
        if let Some(array) = self.0.get_mut(row) {
            lanes.store(array);
        }
    }

    /// Reads the `C` registers from row `first` on.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn record<const C: usize>(&self, level: L::Level, first: usize) -> [L; C] {
        let mut record = [L::splat(level, L::Real::default()); C];
        if let Some(rows) = self.0.get(first..first + C) {
            for (lanes, array) in record.iter_mut().zip(rows) {
                *lanes = L::load(level, array);
            }
        }
        record
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn set_record<const C: usize>(&mut self, first: usize, record: [L; C]) {
        if let Some(rows) = self.0.get_mut(first..first + C) {
            for (lanes, array) in record.into_iter().zip(rows) {
                lanes.store(array);
            }
        }
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn fill(&mut self, lanes: L) {
        for array in self.0.iter_mut() {
            lanes.store(array);
        }
    }

    /// Returns the rows in groups of `size`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn runs(&self, size: usize) -> core::slice::ChunksExact<'_, L::Array> {
        self.0.chunks_exact(size.max(1))
    }

    /// Returns the component of one lane in a row.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn number(&self, row: usize, lane: usize) -> L::Real {
        let array = self.0.get(row).map(AsRef::as_ref);
        array.and_then(|array| array.get(lane)).copied().unwrap_or_default()
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn set_number(&mut self, row: usize, lane: usize, number: L::Real) {
        let array = self.0.get_mut(row).map(AsMut::as_mut);
        if let Some(slot) = array.and_then(|array| array.get_mut(lane)) {
            *slot = number;
        }
    }
}

/// The memory of a search.
#[derive(Debug)]
pub(super) struct Scratch<'s, L: Lanes> {
    /// The present joint values of each lane.
    pub(super) values: Registers<'s, L>,
    /// The joint values from which the search of each lane started.
    pub(super) start: Registers<'s, L>,
    /// The best joint values of each lane so far.
    pub(super) best: Registers<'s, L>,
    /// The joint values from which a restart would begin.
    pub(super) candidate: Registers<'s, L>,
    /// The screws of the joints, six registers each. Only those of joints that move a goal are
    /// written.
    pub(super) twists: Registers<'s, L>,
    /// Poses of links whose children are not computed yet, [`POSE`] registers each.
    pub(super) slots: Registers<'s, L>,
    /// The state of each goal, [`GOAL`] registers each.
    pub(super) goals: Registers<'s, L>,
    /// The Jacobian as `[freedom][component]`. The column of a freedom that is held at its limit is
    /// zero.
    pub(super) columns: Registers<'s, L>,
    /// The change of each freedom in this step, in its own unit.
    pub(super) changes: Registers<'s, L>,
    /// The change of each freedom before limits are applied, in radians.
    pub(super) radians: Registers<'s, L>,
    /// The step of each freedom toward the posture, in radians.
    pub(super) posture_step: Registers<'s, L>,
    /// 1 for each freedom that is held at a limit, and 0 for the other freedoms.
    pub(super) held: Registers<'s, L>,
    /// The error of each component of the goals.
    pub(super) error: Registers<'s, L>,
    /// The error of each component of the goals, minus the parts that the changes of held freedoms
    /// remove.
    pub(super) residual: Registers<'s, L>,
    /// The lower triangle of the matrix of the dense normal equations.
    pub(super) triangle: Registers<'s, L>,
    /// The reciprocals of the diagonal of the Cholesky factor of the matrix in `triangle`.
    pub(super) reciprocals: Registers<'s, L>,
    /// The right-hand side of the dense normal equations, later their solution.
    pub(super) solution: Registers<'s, L>,
    /// The nonzero entries of the sparse normal equations of `tree.rs`, for several goals.
    pub(super) system: Registers<'s, L>,
    /// A copy of `system` that is factorised in place as LᵀDL.
    pub(super) factor: Registers<'s, L>,
    /// The right-hand side of the sparse normal equations.
    pub(super) right_hand_side: Registers<'s, L>,
    /// The composite rigid bodies of links whose parents are not computed yet, [`EVEN_BODY`] or
    /// [`UNEVEN_BODY`] registers each.
    pub(super) bodies: Registers<'s, L>,
}

/// The number of registers of a composite rigid body (see `body.rs`) if all goals have weights that
/// are equal for all axes.
pub(super) const EVEN_BODY: usize = 16;

/// The number of registers of a composite rigid body if weights differ from axis to axis.
pub(super) const UNEVEN_BODY: usize = 27;

/// The number of registers of a goal's state. They hold the target, replaced by the nearest point
/// within reach if it is out of reach; the vector from that point to the target itself; the pose
/// (rotation and half the translation); the rotation to the target; and the sum of the twists of
/// the joints visited so far.
pub(super) const GOAL: usize = TARGET + POSE + TURN + MOVED;
pub(super) const TARGET: usize = EXCESS + 3;
pub(super) const EXCESS: usize = 8;
pub(super) const POSE: usize = 7;
pub(super) const TURN: usize = 3;
pub(super) const MOVED: usize = 6;

/// The size of a cache line in bytes. Scratch is aligned to it, because a register that straddles
/// two cache lines takes twice as long to read.
const LINE: usize = 64;

impl<R: Copy> Reach<'_, R> {
    /// Returns the length of the scratch that [`solve`](Self::solve) needs, in values of type `R`.
    #[must_use]
    pub fn scratch_len(&self) -> usize {
        padded::<R>(Counts::of(self).numbers())
    }

    /// Returns the largest [`scratch_len`](Self::scratch_len) for a mechanism and a count of goals,
    /// for a caller who does not know the goals yet.
    #[must_use]
    pub fn scratch_bound(mechanism: Mechanism<'_, R>, goals: usize) -> usize {
        let mut twists = 0;
        for step in mechanism.steps {
            twists += step.kind.rates();
        }
        padded::<R>(Counts::most(
            mechanism.values,
            mechanism.rates,
            twists,
            slots(mechanism),
            goals,
        ))
    }

    /// Returns the largest [`scratch_len`](Self::scratch_len) for a chain of `values` joints with
    /// one value each, none of which mimics another. Fixed joints do not count. This is a
    /// `const fn` for the length of an array.
    ///
    /// ```
    /// use dq8_robot::ik::Reach;
    /// const SCRATCH: usize = Reach::<f32>::chain_scratch_bound(6, 1);
    /// let scratch = [0.0_f32; SCRATCH];
    /// assert_eq!(scratch.len(), 215);
    /// ```
    #[must_use]
    pub const fn chain_scratch_bound(values: usize, goals: usize) -> usize {
        padded::<R>(Counts::most(values, values, values, 1, goals))
    }

    /// Returns the length of the scratch that a [`ReachJob`](super::ReachJob) needs, in values of
    /// type `R`. It suffices for any number of lanes, so for any CPU.
    #[must_use]
    pub fn batch_scratch_len(&self) -> usize {
        padded::<R>(Counts::of(self).numbers().saturating_mul(MAX_LANES))
    }
}

/// The counts from which the length of the scratch follows.
struct Counts {
    values: usize,
    twists: usize,
    slots: usize,
    goals: usize,
    freedoms: usize,
    rows: usize,
    tree: usize,
    body: usize,
}

impl Counts {
    fn of<R: Copy>(reach: &Reach<'_, R>) -> Self {
        Self {
            values: reach.mechanism.values,
            twists: reach.facts.twists,
            slots: slots(reach.mechanism),
            goals: reach.goals.len(),
            freedoms: reach.freedoms.len(),
            rows: reach.facts.rows,
            tree: reach.facts.tree,
            body: if reach.facts.is_even { EVEN_BODY } else { UNEVEN_BODY },
        }
    }

    /// Returns the largest number of registers that a search needs for any goals. A search for one
    /// whole pose needs exactly this number.
    const fn most(
        values: usize,
        freedoms: usize,
        twists: usize,
        slots: usize,
        goals: usize,
    ) -> usize {
        let rows = goals.saturating_mul(6);
        // A single goal does not use the sparse normal equations.
        let tree = if goals > 1 { triangle(freedoms) } else { 0 };
        let body = UNEVEN_BODY;
        Self { values, twists, slots, goals, freedoms, rows, tree, body }.numbers()
    }

    /// Returns the number of registers that a search needs. On overflow it is the largest `usize`,
    /// so that any memory counts as too short.
    const fn numbers(&self) -> usize {
        let values = self.values.saturating_mul(4).saturating_add(self.twists.saturating_mul(6));
        let freedoms = self.freedoms.saturating_mul(self.rows.saturating_add(4));
        let goals = self.goals.saturating_mul(GOAL).saturating_add(self.rows.saturating_mul(4));
        let poses = self.slots.saturating_mul(POSE);
        let rest = poses.saturating_add(goals).saturating_add(triangle(self.rows));
        let bodies = self.bodies().saturating_mul(self.body);
        let tree = self
            .tree
            .saturating_mul(2)
            .saturating_add(self.right_hand_side())
            .saturating_add(bodies);
        values.saturating_add(freedoms).saturating_add(rest).saturating_add(tree)
    }

    const fn right_hand_side(&self) -> usize {
        if self.tree > 0 { self.freedoms } else { 0 }
    }

    const fn bodies(&self) -> usize {
        if self.tree > 0 { self.slots } else { 0 }
    }
}

/// Returns the largest number of poses that are kept at the same time, because the poses of other
/// links are still to be computed from them. It is one in a chain.
fn slots<R>(mechanism: Mechanism<'_, R>) -> usize {
    let mut slots = 0;
    for step in mechanism.steps {
        slots = slots.max(step.slot as usize + 1);
    }
    slots
}

/// Returns an error if scratch is shorter than `expected`.
pub(super) fn check_scratch(length: usize, expected: usize) -> Result<(), ShapeError> {
    let fits = length >= expected;
    if fits { Ok(()) } else { Err(ShapeError::Length { what: "scratch", length, expected }) }
}

/// Returns `numbers`, a length in elements of type `R`, plus the number of such elements in a cache
/// line. So there is room to begin the scratch at a cache line.
const fn padded<R>(numbers: usize) -> usize {
    numbers.saturating_add(LINE / size_of::<R>())
}

const fn triangle(rows: usize) -> usize {
    rows.saturating_mul(rows.saturating_add(1)) / 2
}

impl<'s, L: Lanes<Real: Scalar>> Scratch<'s, L> {
    /// Sets the column of a freedom in the Jacobian to zero, in the lanes of a mask.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn hold_column(
        &mut self,
        level: L::Level,
        index: usize,
        rows: usize,
        held: L::Mask,
    ) {
        for row in index * rows..(index + 1) * rows {
            let component = self.columns.get(level, row);
            self.columns.set(row, L::select(held, component.constant(0.0), component));
        }
    }

    /// Divides `memory`, which may have any alignment, into the arrays of a search. Returns `None`
    /// if it is too short.
    pub(super) fn new(reach: &Reach<'_, L::Real>, memory: &'s mut [L::Real]) -> Option<Self> {
        let counts = Counts::of(reach);
        let first = memory.as_ptr().align_offset(LINE);
        let mut rest = arrays::<L>(memory.get_mut(first..)?, counts.numbers())?;
        let (right_hand_side, bodies) = (counts.right_hand_side(), counts.bodies());
        let Counts { values, twists, slots, goals, freedoms, rows, tree, body } = counts;
        Some(Self {
            values: take(&mut rest, values)?,
            start: take(&mut rest, values)?,
            best: take(&mut rest, values)?,
            candidate: take(&mut rest, values)?,
            twists: take(&mut rest, 6 * twists)?,
            columns: take(&mut rest, freedoms * rows)?,
            changes: take(&mut rest, freedoms)?,
            radians: take(&mut rest, freedoms)?,
            posture_step: take(&mut rest, freedoms)?,
            held: take(&mut rest, freedoms)?,
            slots: take(&mut rest, POSE * slots)?,
            goals: take(&mut rest, GOAL * goals)?,
            error: take(&mut rest, rows)?,
            residual: take(&mut rest, rows)?,
            triangle: take(&mut rest, triangle(rows))?,
            reciprocals: take(&mut rest, rows)?,
            solution: take(&mut rest, rows)?,
            system: take(&mut rest, tree)?,
            factor: take(&mut rest, tree)?,
            right_hand_side: take(&mut rest, right_hand_side)?,
            bodies: take(&mut rest, body * bodies)?,
        })
    }
}

/// Returns the first part of `memory` as `registers` registers; `None` if it is too short.
fn arrays<L: Lanes>(memory: &mut [L::Real], registers: usize) -> Option<&mut [L::Array]> {
    let memory = memory.get_mut(..registers.checked_mul(L::LANES)?)?;
    bytemuck::try_cast_slice_mut(memory).ok()
}

/// Takes the first `rows` registers from `rest` and leaves the others in it. Returns `None` if
/// there are fewer.
fn take<'s, L: Lanes>(rest: &mut &'s mut [L::Array], rows: usize) -> Option<Registers<'s, L>> {
    let (first, others) = core::mem::take(rest).split_at_mut_checked(rows)?;
    *rest = others;
    Some(Registers(first))
}

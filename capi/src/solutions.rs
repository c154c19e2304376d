//! All solutions of arms of six hinges, for many targets.

use crate::mechanism::{Checked, Mechanism};
use crate::memory::{Input, Output, bytes, place};
use crate::reach::{Goal, status as of_goal};
use crate::span::disjoint;
use crate::status::{Done, Status};
use core::mem::{MaybeUninit, offset_of};
use dq8::{DualQuat, Real, Scalar};
use dq8_robot::ik::{self, Freedom, Reach, Singular, SixAxisArm, SolutionsError};

/// A solution: values of the six hinges that bring the link of the goal to the target. The last
/// three fields are 1 if the arm is singular there, and 0 otherwise.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solution<R> {
    /// The values of the six hinges from the base up, within their limits, and as near to the start
    /// as whole turns allow.
    pub values: [R; 6],
    /// The distance from the start in radians: the root of the sum of the squared differences.
    pub distance: R,
    /// 1 if the wrist is on the first axis, or as far from the plane of the arm as it can be.
    pub shoulder: u8,
    /// 1 if the arm is stretched or folded at the second and third axis.
    pub elbow: u8,
    /// 1 if the last axis is parallel to one before it.
    pub wrist: u8,
}

/// All solutions for a target.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solutions<R> {
    /// The solutions, the nearest to the start first. Elements from `count` on have no meaning.
    pub all: [Solution<R>; 8],
    /// The number of solutions. It is 0 if the target cannot be reached.
    pub count: usize,
    /// 1 if the arm has no other solutions, and 0 if searches have found these, so that there may
    /// be more.
    pub is_complete: u8,
}

/// Asserts that a struct of C and a struct of `dq8_robot` have the same size, alignment and public
/// fields, so that memory of one type can be written as the other.
macro_rules! same {
    ($($R:ident)*) => {$(const _: () = {
        assert!(size_of::<Solutions<$R>>() == size_of::<ik::Solutions<$R>>());
        assert!(align_of::<Solutions<$R>>() == align_of::<ik::Solutions<$R>>());
        assert!(size_of::<Solution<$R>>() == size_of::<ik::Solution<$R>>());
        let complete = offset_of!(ik::Solutions<$R>, is_complete);
        assert!(offset_of!(Solutions<$R>, is_complete) == complete);
        assert!(offset_of!(Solution<$R>, values) == offset_of!(ik::Solution<$R>, values));
        assert!(offset_of!(Solution<$R>, distance) == offset_of!(ik::Solution<$R>, distance));
        let singular = offset_of!(ik::Solution<$R>, singular);
        assert!(offset_of!(Solution<$R>, shoulder) == singular + offset_of!(Singular, shoulder));
        assert!(offset_of!(Solution<$R>, elbow) == singular + offset_of!(Singular, elbow));
        assert!(offset_of!(Solution<$R>, wrist) == singular + offset_of!(Singular, wrist));
    };)*};
}
same! { f32 f64 }

/// Returns the number of elements `R` that a call needs as scratch: memory for the freedoms of the
/// mechanism with their alignment, and after them the scratch of the arm itself.
fn scratch_len<R: Real>(known: dq8_robot::Mechanism<'_, R>) -> Result<usize, Status> {
    let freedoms = known.rates().checked_mul(size_of::<Freedom<R>>()).ok_or(Status::TooLarge)?;
    let bytes = freedoms.checked_add(align_of::<Freedom<R>>()).ok_or(Status::TooLarge)?;
    let all = bytes.div_ceil(size_of::<R>()).checked_add(SixAxisArm::batch_scratch_bound(known));
    all.filter(|all| *all <= isize::MAX as usize / size_of::<R>()).ok_or(Status::TooLarge)
}

/// # Safety
/// The mechanism must be zeroed, or was made here with steps that have not changed since.
/// `scratch_count` must point to a `usize` that no other thread uses during the call.
unsafe fn solutions_scratch<R: Real>(
    mechanism: *const Mechanism<R>,
    scratch_count: *mut usize,
) -> Done {
    // SAFETY: the caller guarantees that the mechanism is zeroed, or was made here with steps that
    // have not changed since.
    let checked = unsafe { Checked::new(mechanism)? };
    let to = Output::<usize>::new(scratch_count, 1)?;
    disjoint(&[to.span], &[checked.given, checked.steps])?;
    // SAFETY: the caller guarantees that `scratch_count` points to a `usize`, and `disjoint` has
    // checked that it does not overlap the mechanism.
    unsafe { to.write(scratch_len(checked.known)?) };
    Ok(())
}

/// Returns the status of an error, and the index of the target that it names.
fn fault(error: &SolutionsError) -> (Status, Option<usize>) {
    match error {
        SolutionsError::Target { index, .. } | SolutionsError::Start { index, .. } => {
            (Status::NotFinite, Some(*index))
        }
        SolutionsError::NotUnit { index, .. } => (Status::NotUnit, Some(*index)),
        _ => (Status::NotSixHinges, None),
    }
}

/// The arguments of [`solutions`], as C passes them.
struct Query<R> {
    mechanism: *const Mechanism<R>,
    goal: *const Goal<R>,
    targets: *const R,
    starts: *const R,
    scratch: *mut R,
    scratch_count: usize,
    found: *mut Solutions<R>,
    count: usize,
    bad_target: *mut usize,
}

/// # Safety
/// The mechanism must be zeroed, or was made here with steps that have not changed since. Each
/// array must have as many elements as its count says, and `bad_target` may be null. No other
/// thread may use the outputs or write the inputs during the call.
unsafe fn solutions<R: Scalar>(query: Query<R>) -> Done {
    // SAFETY: the caller guarantees that the mechanism is zeroed, or was made here with steps that
    // have not changed since.
    let checked = unsafe { Checked::new(query.mechanism)? };
    let goal = Input::<ik::Goal<R>>::new(query.goal, 1)?;
    let targets = Input::<DualQuat<R>>::new(query.targets, query.count)?;
    let starts = Input::<[R; 6]>::new(query.starts, query.count)?;
    let scratch = Output::<MaybeUninit<R>>::new(query.scratch, query.scratch_count)?;
    let found = Output::<MaybeUninit<Solutions<R>>>::new(query.found, query.count)?;
    let bad = Output::<usize>::unless_null(query.bad_target)?;
    let read = [goal.span, targets.span, starts.span, checked.given, checked.steps];
    disjoint(&[scratch.span, found.span, bad.span], &read)?;
    let known = checked.known;
    if query.scratch_count < scratch_len(known)? {
        return Err(Status::LengthScratch);
    }
    // SAFETY: the caller guarantees that each array has as many elements as its count says, and
    // `disjoint` has checked that no output overlaps these arrays.
    let (goal, targets, starts) = unsafe { (goal.slice(), targets.slice(), starts.slice()) };
    // SAFETY: as above, and `disjoint` has checked that the two outputs do not overlap.
    let (scratch, found) = unsafe { (scratch.slice(), found.slice()) };
    let short = Status::LengthScratch;
    let (freedoms, rest) = place(bytes(scratch), known.rates(), Freedom::default()).ok_or(short)?;
    let reach = Reach::new(known, goal, freedoms).map_err(|error| of_goal(&error))?;
    let arm = SixAxisArm::new(reach).map_err(|error| fault(&error).0)?;
    let (own, _) = place(rest, arm.batch_scratch_len(), R::ZERO).ok_or(short)?;
    if let Err(error) = arm.check(targets, starts) {
        let (status, index) = fault(&error);
        if let Some(index) = index {
            // SAFETY: the caller guarantees that `bad_target` is null or points to a `usize`, and
            // `disjoint` has checked that it overlaps no other array.
            unsafe { bad.write(index) };
        }
        return Err(status);
    }
    // All inputs have been checked, so the solutions may be written. Their memory may be
    // uninitialised.
    let (found, _) = place(bytes(found), query.count, ik::Solutions::default()).ok_or(short)?;
    arm.job().solutions_in(own, targets, starts, found).map_err(|error| fault(&error).0)
}

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export_one! { $R
            /// Writes the size that `scratch` of dq8_solutions must have. The size counts floats or
            /// doubles. It depends on the mechanism only.
            solutions_scratch(mechanism: *const Mechanism<$R>, scratch_count: *mut usize) =
                super::solutions_scratch(mechanism, scratch_count)
        }
        export_one! { $R
            /// Finds all solutions of an arm of six hinges for `count` targets: the values of its
            /// hinges that bring the link of `goal` to the target. Arms with a spherical wrist and
            /// arms with three parallel axes are solved by formula, others by searches from many
            /// starts. `targets` holds unit motions. `starts` holds six values for each target,
            /// from the base up; solutions are sorted by their distance from them. The mechanism
            /// may have other joints, which do not carry the link.
            ///
            /// Returns DQ8_STATUS_NOT_SIX_HINGES, or the errors of a goal that dq8_mechanism_reach
            /// has; and DQ8_STATUS_NOT_FINITE or _NOT_UNIT for a target or a start, and then sets
            /// `bad_target`, which may be null, to its index.
            solutions(
                mechanism: *const Mechanism<$R>, goal: *const Goal<$R>, targets: *const $R,
                starts: *const $R, scratch: *mut $R, scratch_count: usize,
                found: *mut Solutions<$R>, count: usize, bad_target: *mut usize,
            ) = super::solutions(Query {
                mechanism, goal, targets, starts, scratch, scratch_count, found, count, bad_target,
            })
        }
    };
}
for_both_numbers!(functions);

//! Inverse kinematics of a mechanism, in memory of the caller: the types, and the functions for one
//! configuration. [`targets`](crate::targets) has the functions for many configurations.

use crate::mechanism::{Checked, Mechanism};
use crate::memory::{Input, Output, bytes, place};
use crate::span::disjoint;
use crate::status::{Done, Status};
use core::mem::{MaybeUninit, offset_of};
use dq8::{DualQuat, Real, Scalar, ShapeError, simd::MAX_LANES};
use dq8_robot::ik::{self, Freedom, Reach, ReachError};

/// A goal of inverse kinematics: a link that is to come to its target, and the weights of the six
/// components of its error, in the axes of the target. A component with the weight 0 is free. The
/// sizes of the other weights matter only if the components cannot all become zero.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Goal<R> {
    /// The index of the link.
    pub link: usize,
    /// The weights of the rotation about the target's axes x, y and z. They must not be negative.
    pub angular: [R; 3],
    /// The weights of the distance along the target's axes x, y and z. They must not be negative.
    pub linear: [R; 3],
    /// The point of the link that is to be at the target, in the frame of the link. Zero is the
    /// origin of the link.
    pub point: [R; 3],
}

/// The options of a search. dq8_mechanism_reach_options fills in the defaults.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReachOptions<R> {
    /// The largest angle in radians between a link and its target at which the search has
    /// converged.
    pub angular_tolerance: R,
    /// The largest distance between a link and its target at which the search has converged.
    pub linear_tolerance: R,
    /// The largest number of iterations. Steps and restarts both count as iterations.
    pub max_iterations: u32,
    /// 1 to begin again from another configuration when the search gets stuck. 0 to search from the
    /// given values only, which suits a target that moves and is followed.
    pub restarts: u32,
    /// The error in distance that weighs as much as an error of one radian. 0 stands for an eighth
    /// of the mechanism's length. If a joint floats or slides without limits, that length is at
    /// least the distance from the base to the farthest target, and at least the largest slide in
    /// the given values.
    pub length_per_radian: R,
    /// The largest angle in radians by which a joint turns in one step. A value of more than a full
    /// turn counts as a full turn.
    pub max_step: R,
    /// The damping of steps at the target itself, in radians. It keeps steps short near singular
    /// poses. With 0, the search converges fastest.
    pub damping: R,
}

/// The outcome of a search for the values that bring links to their targets.
#[repr(i32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// All links are at their targets, within the tolerances.
    Converged = 0,
    /// A target is farther away than the chain of joints that carries its link can reach.
    OutOfReach = 1,
    /// No step led nearer to the targets, and a joint is at its limit.
    AtLimits = 2,
    /// No step led nearer to the targets.
    Stalled = 3,
    /// The search took all its iterations while the links still came nearer. More iterations would
    /// help.
    Unfinished = 4,
    /// An input is invalid: a target is not unit within 0.001, an input is not finite, an option is
    /// negative or NaN, or max_step is 0. The values are as they were.
    Invalid = 5,
}

/// The report of a search. Its errors are those of the values that the search returns.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReachReport<R> {
    /// The outcome, one of enum dq8_outcome.
    pub outcome: i32,
    /// The number of iterations. Steps and restarts both count as iterations.
    pub iterations: u32,
    /// The number of restarts.
    pub restarts: u32,
    /// The largest angle in radians between a link and its target. Components with weight 0 do not
    /// count.
    pub angular_error: R,
    /// The largest distance between a link and its target. Components with weight 0 do not count.
    pub linear_error: R,
}

/// Asserts that a struct of C and a struct of `dq8_robot` have the same layout, so that memory of
/// one type can be read as the other.
macro_rules! same {
    ($C:ty, $Rust:ty: $($field:ident)*) => {
        const _: () = {
            assert!(size_of::<$C>() == size_of::<$Rust>());
            assert!(align_of::<$C>() == align_of::<$Rust>());
            $(assert!(offset_of!($C, $field) == offset_of!($Rust, $field));)*
        };
    };
}
macro_rules! same_of {
    ($($R:ident)*) => {$(
        same! { Goal<$R>, ik::Goal<$R>: link angular linear point }
        same! { ReachReport<$R>, ik::Report<$R>: outcome iterations restarts angular_error linear_error }
    )*};
}
same_of! { f32 f64 }

macro_rules! same_outcomes {
    ($($outcome:ident)*) => {$(
        const _: () = assert!(Outcome::$outcome as i32 == ik::Outcome::$outcome as i32);
    )*};
}
same_outcomes! { Converged OutOfReach AtLimits Stalled Unfinished Invalid }

/// The number of configurations that a search computes at a time: one, or one per lane.
#[derive(Clone, Copy)]
pub(crate) enum Width {
    One,
    Lanes,
}

/// Returns the number of elements `R` that a search needs as scratch: memory for one [`Freedom`]
/// per rate, aligned, and after it the scratch of the search itself.
fn scratch_len<R: Real>(
    known: dq8_robot::Mechanism<'_, R>,
    goals: usize,
    width: Width,
) -> Result<usize, Status> {
    let lanes = if matches!(width, Width::Lanes) { MAX_LANES } else { 1 };
    let own = Reach::scratch_bound(known, goals).checked_mul(lanes);
    let freedoms = known.rates().checked_mul(size_of::<Freedom<R>>());
    let bytes = freedoms.and_then(|bytes| bytes.checked_add(align_of::<Freedom<R>>()));
    let numbers = bytes.map(|bytes| bytes.div_ceil(size_of::<R>()));
    let all = numbers.zip(own).and_then(|(numbers, own)| numbers.checked_add(own));
    all.filter(|all| *all <= isize::MAX as usize / size_of::<R>()).ok_or(Status::TooLarge)
}

/// # Safety
/// The mechanism must be zeroed, or made with steps that have not changed since. `scratch_count`
/// must point to a `usize` that no other thread uses during the call.
pub(crate) unsafe fn reach_scratch<R: Real>(
    mechanism: *const Mechanism<R>,
    goal_count: usize,
    scratch_count: *mut usize,
    width: Width,
) -> Done {
    // SAFETY: the caller guarantees that the mechanism is zeroed, or made with unchanged steps.
    let checked = unsafe { Checked::new(mechanism)? };
    let to = Output::<usize>::new(scratch_count, 1)?;
    disjoint(&[to.span], &[checked.given, checked.steps])?;
    if goal_count > GOALS {
        return Err(Status::TooLarge);
    }
    // SAFETY: the caller guarantees that `scratch_count` points to a `usize`, and `disjoint` has
    // checked that it does not overlap the mechanism.
    unsafe { to.write(scratch_len(checked.known, goal_count, width)?) };
    Ok(())
}

/// The largest number of goals. More goals have no use, and the lengths of their arrays might not
/// fit into a `usize`.
const GOALS: usize = 1 << 10;

impl<R: Real> ReachOptions<R> {
    fn known(self) -> Result<ik::Options<R>, Status> {
        let length = self.length_per_radian;
        let restarts = match self.restarts {
            0 => false,
            1 => true,
            _ => return Err(Status::UnknownValue),
        };
        Ok(ik::Options {
            angular_tolerance: self.angular_tolerance,
            linear_tolerance: self.linear_tolerance,
            max_iterations: self.max_iterations,
            length_per_radian: (length != R::ZERO).then_some(length),
            max_step: self.max_step,
            damping: self.damping,
            restarts,
            ..ik::Options::default()
        })
    }
}

/// # Safety
/// `options` must point to memory for options, which no other thread uses during the call.
unsafe fn reach_options<R: Real>(options: *mut ReachOptions<R>) -> Done {
    let to = Output::<ReachOptions<R>>::new(options, 1)?;
    let known = ik::Options::<R>::default();
    let default = ReachOptions {
        angular_tolerance: known.angular_tolerance,
        linear_tolerance: known.linear_tolerance,
        max_iterations: known.max_iterations,
        restarts: u32::from(known.restarts),
        length_per_radian: R::ZERO,
        max_step: known.max_step,
        damping: known.damping,
    };
    // SAFETY: the caller guarantees that `options` points to memory for options that no other
    // thread uses.
    unsafe { to.write(default) };
    Ok(())
}

/// The inputs of [`reach`], as C passes them. `posture` and `options` may be null.
pub(crate) struct Query<R> {
    pub(crate) mechanism: *const Mechanism<R>,
    pub(crate) goals: *const Goal<R>,
    pub(crate) targets: *const R,
    pub(crate) goal_count: usize,
    pub(crate) posture: *const R,
    pub(crate) options: *const ReachOptions<R>,
}

/// The outputs and the scratch of [`reach`], for `count` configurations, as C passes them. Before
/// the call, `values` holds the configurations from which the search begins.
pub(crate) struct Results<R> {
    pub(crate) values: *mut R,
    pub(crate) value_count: usize,
    pub(crate) scratch: *mut R,
    pub(crate) scratch_count: usize,
    pub(crate) reports: *mut ReachReport<R>,
    pub(crate) count: usize,
}

/// The inputs and outputs of a search as slices, after all checks.
pub(crate) struct Search<'a, R> {
    pub(crate) reach: Reach<'a, R>,
    pub(crate) targets: &'a [DualQuat<R>],
    pub(crate) values: &'a mut [R],
    pub(crate) scratch: &'a mut [R],
    pub(crate) reports: &'a mut [ik::Report<R>],
    pub(crate) options: ik::Options<R>,
}

/// # Safety
/// The mechanism must be zeroed, or made with steps that have not changed since. Each array must
/// have as many elements as its count says, and `posture` and `options` may be null. No other
/// thread may use the outputs or write the inputs during the call.
pub(crate) unsafe fn reach<R: Scalar>(
    query: Query<R>,
    results: Results<R>,
    width: Width,
    solve: impl FnOnce(Search<'_, R>) -> Result<(), ShapeError>,
) -> Done {
    // SAFETY: the caller guarantees that the mechanism is zeroed, or made with unchanged steps.
    let checked = unsafe { Checked::new(query.mechanism)? };
    let Results { count, value_count, scratch_count, .. } = results;
    let target_count = query.goal_count.checked_mul(count).ok_or(Status::TooLarge)?;
    let goals = Input::<ik::Goal<R>>::new(query.goals, query.goal_count)?;
    let targets = Input::<DualQuat<R>>::new(query.targets, target_count)?;
    let known = checked.known;
    let posture_count = if query.posture.is_null() { 0 } else { known.values() };
    let posture = Input::<R>::new(query.posture, posture_count)?;
    let values = Output::<R>::new(results.values, value_count)?;
    let scratch = Output::<MaybeUninit<R>>::new(results.scratch, scratch_count)?;
    let reports = Output::<MaybeUninit<ik::Report<R>>>::new(results.reports, count)?;
    let options = Input::<ReachOptions<R>>::unless_null(query.options)?;
    let read = [goals.span, targets.span, posture.span, options.span, checked.given, checked.steps];
    disjoint(&[values.span, scratch.span, reports.span], &read)?;
    // SAFETY: the caller guarantees that `options` is null or points to options, and `disjoint` has
    // checked that no output overlaps them.
    let options = match *unsafe { options.slice() } {
        [options] => options.known()?,
        _ => ik::Options::default(),
    };
    if query.goal_count > GOALS {
        return Err(Status::TooLarge);
    }
    if known.values().checked_mul(count) != Some(value_count) {
        return Err(Status::LengthValues);
    }
    if scratch_count < scratch_len(known, query.goal_count, width)? {
        return Err(Status::LengthScratch);
    }
    // SAFETY: the caller guarantees that each array has as many elements as its count says, and
    // `disjoint` has checked that no output overlaps these arrays.
    let (goals, targets, posture) = unsafe { (goals.slice(), targets.slice(), posture.slice()) };
    // SAFETY: the caller guarantees that both arrays have as many elements as their counts say, and
    // `disjoint` has checked that they overlap no other array.
    let (values, scratch) = unsafe { (values.slice(), scratch.slice()) };
    // The scratch is large enough, as has been checked above, so this error does not occur.
    let (freedoms, rest) =
        place(bytes(scratch), known.rates(), Freedom::default()).ok_or(Status::LengthScratch)?;
    let mut reach = Reach::new(known, goals, freedoms).map_err(|error| status(&error))?;
    // The search needs no more scratch than `scratch_bound`, for which the length has been checked.
    let numbers = match width {
        Width::One => reach.scratch_len(),
        Width::Lanes => reach.batch_scratch_len(),
    };
    let (scratch, _) = place(rest, numbers, R::ZERO).ok_or(Status::LengthScratch)?;
    if !query.posture.is_null() {
        reach = reach.with_posture(posture).map_err(|error| status(&error))?;
    }
    // All inputs have been checked, so the reports may be written. Their memory may be
    // uninitialised. SAFETY: the caller guarantees that `reports` has `count` elements, and
    // `disjoint` has checked that they overlap no other array.
    let reports = bytes(unsafe { reports.slice() });
    let (reports, _) = place(reports, count, ik::Report::default()).ok_or(Status::LengthScratch)?;
    Ok(solve(Search { reach, targets, values, scratch, reports, options })?)
}

pub(crate) fn status(error: &ReachError) -> Status {
    match error {
        ReachError::Link { .. } => Status::NoLink,
        ReachError::NoGoals | ReachError::Weight { .. } | ReachError::NoWeight { .. } => {
            Status::Weight
        }
        ReachError::Unmoved { .. } => Status::Unmoved,
        ReachError::Limits { .. } => Status::Limits,
        ReachError::Posture { .. } | ReachError::Point { .. } => Status::NotFinite,
        ReachError::Freedoms { .. } | ReachError::PostureLength { .. } => Status::LengthValues,
        // The enum is `non_exhaustive`: a newer `dq8_robot` may have more errors.
        _ => Status::UnknownValue,
    }
}

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export_one! { $R
            /// Writes the default options: tolerances of 1e-5 radians and 1e-5 units of length, 100
            /// iterations, with restarts.
            mechanism::reach_options(options: *mut ReachOptions<$R>) = super::reach_options(options)
        }
        export_one! { $R
            /// Writes the size that `scratch` of dq8_mechanism_reach must have. The size counts
            /// floats or doubles. It depends on the mechanism and the number of goals only. Returns
            /// DQ8_STATUS_TOO_LARGE if there are more than 1024 goals.
            mechanism::reach_scratch(
                mechanism: *const Mechanism<$R>, goal_count: usize, scratch_count: *mut usize,
            ) = super::reach_scratch(mechanism, goal_count, scratch_count, Width::One)
        }
        export_one! { $R
            /// Solves the inverse kinematics of one configuration. The search begins at `values`
            /// and changes them, within the limits of the joints, until the link of each goal is at
            /// its target. `targets` holds a unit motion for each goal. From values near a solution
            /// the search converges in a few steps.
            ///
            /// `posture` is a configuration that the search prefers where the goals leave freedom.
            /// It holds as many elements as `values`, or is null. `options` may be null for the
            /// options that dq8_mechanism_reach_options writes. The content of `scratch` does not
            /// matter. DQ8_STATUS_OK means that `report` has been written, whose `outcome` tells
            /// whether the targets are reached.
            ///
            /// Returns DQ8_STATUS_NO_LINK, _UNMOVED, _WEIGHT (a weight is negative or not finite,
            /// or all weights of a goal are 0, or there is no goal), _LIMITS, _NOT_FINITE (of the
            /// posture or of a point), _LENGTH_VALUES, _LENGTH_SCRATCH or _UNKNOWN_VALUE (of
            /// `restarts`) for wrong inputs. The function may then have written `scratch`, but not
            /// the values and the report.
            mechanism::reach(
                mechanism: *const Mechanism<$R>, goals: *const Goal<$R>, targets: *const $R,
                goal_count: usize, posture: *const $R, options: *const ReachOptions<$R>,
                values: *mut $R, value_count: usize, scratch: *mut $R, scratch_count: usize,
                report: *mut ReachReport<$R>,
            ) = super::reach(
                Query { mechanism, goals, targets, goal_count, posture, options },
                Results { values, value_count, scratch, scratch_count, reports: report, count: 1 },
                Width::One,
                |search| {
                    let Search { reach, targets, values, scratch, reports, options } = search;
                    let report = reach.solve(targets, values, scratch, &options)?;
                    reports.fill(report);
                    Ok(())
                },
            )
        }
    };
}
for_both_numbers!(functions);

//! Inverse kinematics of a mechanism, in memory of the caller: one configuration here, many in
//! [`targets`](crate::targets).

use crate::mechanism::{Made, Mechanism};
use crate::memory::{Input, Output, bytes, place};
use crate::span::apart;
use crate::status::{Done, Status};
use core::mem::{MaybeUninit, offset_of};
use dq8::{DualQuat, Real, Scalar, ShapeError, simd::MAX_LANES};
use dq8_robot::ik::{self, Freedom, Reach, ReachError};

/// What is asked of a link: components of its error in the axes of its target, and how much each
/// weighs where not all can vanish. A weight of 0 leaves its component free.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Goal<R> {
    /// The link.
    pub link: usize,
    /// Weights of the rotation about the target's x, y and z; not negative.
    pub angular: [R; 3],
    /// Weights of the way along the target's x, y and z; not negative.
    pub linear: [R; 3],
    /// The point of the link, in its frame, that is to be at the target; zero is its origin.
    pub point: [R; 3],
}

/// When a search ends, and how it weighs. dq8_reach_options fills in what serves most.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReachOptions<R> {
    /// The turn that may be left, radians.
    pub angular_tolerance: R,
    /// The distance that may be left.
    pub linear_tolerance: R,
    /// Steps and restarts together.
    pub max_iterations: u32,
    /// 1 to begin again from another configuration where the search got stuck; 0 to converge from
    /// the given start only, to follow a target that moves.
    pub restarts: u32,
    /// How long a distance weighs as much as a radian; 0 for an eighth of the mechanism's length,
    /// or where something floats or slides without end, of the longer way that it has to go.
    pub length_per_radian: R,
    /// The most that a hinge turns in one step, radians; more than a turn is as much as one.
    pub max_step: R,
    /// Damping at the target itself, radians; 0 reaches it fastest.
    pub damping: R,
}

/// How a search ended.
#[repr(i32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// Both errors are within the tolerances.
    Converged = 0,
    /// A target is farther away than the mechanism is long.
    OutOfReach = 1,
    /// No way led nearer, and a limit stands in the way.
    AtLimits = 2,
    /// No way led nearer.
    Stalled = 3,
    /// The iterations ran out while the links still came nearer: more would help.
    Unfinished = 4,
    /// A target is not unit to 0.001, a number is not finite, or an option is negative or no
    /// number, or max_step is 0: the values are untouched.
    Invalid = 5,
}

/// The result of a search, judged by the values that are returned.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReachReport<R> {
    /// One of enum dq8_outcome.
    pub outcome: i32,
    /// Steps and restarts together.
    pub iterations: u32,
    /// How many of them were restarts.
    pub restarts: u32,
    /// The largest turn that is left of what is asked for, radians.
    pub angular_error: R,
    /// The largest distance.
    pub linear_error: R,
}

/// The library's goals and reports are those of C, to the byte, and outcomes have the same numbers.
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

/// How many configurations a search has at a time.
#[derive(Clone, Copy)]
pub(crate) enum Width {
    One,
    Lanes,
}

/// How many numbers as large as `R` a search computes in: those of its freedoms and what aligns
/// them, then its own.
fn room<R: Real>(
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
/// As for [`Made::new`] and [`Output::write`].
pub(crate) unsafe fn reach_scratch<R: Real>(
    mechanism: *const Mechanism<R>,
    goal_count: usize,
    scratch_count: *mut usize,
    width: Width,
) -> Done {
    // SAFETY: promised.
    let made = unsafe { Made::new(mechanism)? };
    let to = Output::<usize>::new(scratch_count, 1)?;
    apart(&[to.span], &[made.given, made.steps])?;
    if goal_count > GOALS {
        return Err(Status::TooLarge);
    }
    // SAFETY: promised, and apart.
    unsafe { to.write(room(made.known, goal_count, width)?) };
    Ok(())
}

/// More goals than any mechanism has a use for; with more, lengths might be too large to count.
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
/// As for [`Output::write`].
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
    // SAFETY: promised.
    unsafe { to.write(default) };
    Ok(())
}

/// What [`reach`] seeks.
pub(crate) struct Asked<R> {
    pub(crate) mechanism: *const Mechanism<R>,
    pub(crate) goals: *const Goal<R>,
    pub(crate) targets: *const R,
    pub(crate) goal_count: usize,
    pub(crate) posture: *const R,
    pub(crate) options: *const ReachOptions<R>,
}

/// Where from, and what is written: `count` configurations.
pub(crate) struct Answer<R> {
    pub(crate) values: *mut R,
    pub(crate) value_count: usize,
    pub(crate) scratch: *mut R,
    pub(crate) scratch_count: usize,
    pub(crate) reports: *mut ReachReport<R>,
    pub(crate) count: usize,
}

/// What a search is given once everything has been checked.
pub(crate) struct Search<'a, R> {
    pub(crate) reach: Reach<'a, R>,
    pub(crate) targets: &'a [DualQuat<R>],
    pub(crate) values: &'a mut [R],
    pub(crate) scratch: &'a mut [R],
    pub(crate) reports: &'a mut [ik::Report<R>],
    pub(crate) options: ik::Options<R>,
}

/// # Safety
/// As for [`Made::new`], [`Input::slice`] and [`Output::slice`].
pub(crate) unsafe fn reach<R: Scalar>(
    asked: Asked<R>,
    answer: Answer<R>,
    width: Width,
    solve: impl FnOnce(Search<'_, R>) -> Result<(), ShapeError>,
) -> Done {
    // SAFETY: promised.
    let made = unsafe { Made::new(asked.mechanism)? };
    let Answer { count, value_count, scratch_count, .. } = answer;
    let target_count = asked.goal_count.checked_mul(count).ok_or(Status::TooLarge)?;
    let goals = Input::<ik::Goal<R>>::new(asked.goals, asked.goal_count)?;
    let targets = Input::<DualQuat<R>>::new(asked.targets, target_count)?;
    let known = made.known;
    let posture_count = if asked.posture.is_null() { 0 } else { known.values() };
    let posture = Input::<R>::new(asked.posture, posture_count)?;
    let values = Output::<R>::new(answer.values, value_count)?;
    let scratch = Output::<MaybeUninit<R>>::new(answer.scratch, scratch_count)?;
    let reports = Output::<MaybeUninit<ik::Report<R>>>::new(answer.reports, count)?;
    let options = Input::<ReachOptions<R>>::unless_null(asked.options)?;
    let read = [goals.span, targets.span, posture.span, options.span, made.given, made.steps];
    apart(&[values.span, scratch.span, reports.span], &read)?;
    // SAFETY: promised, and apart.
    let options = match *unsafe { options.slice() } {
        [options] => options.known()?,
        _ => ik::Options::default(),
    };
    if asked.goal_count > GOALS || known.values().checked_mul(count) != Some(value_count) {
        return Err(Status::Length);
    }
    if scratch_count < room(known, asked.goal_count, width)? {
        return Err(Status::Length);
    }
    // SAFETY: promised, and apart.
    let (goals, targets, posture) = unsafe { (goals.slice(), targets.slice(), posture.slice()) };
    // SAFETY: promised, and apart.
    let (values, scratch) = unsafe { (values.slice(), scratch.slice()) };
    // There is room for all: so it was checked. The compiler does not know that.
    let (freedoms, rest) =
        place(bytes(scratch), known.rates(), Freedom::default()).ok_or(Status::Length)?;
    let mut reach = Reach::new(known, goals, freedoms).map_err(|error| status(&error))?;
    // As much as these goals need, which is no more than was asked for.
    let numbers = match width {
        Width::One => reach.scratch_len(),
        Width::Lanes => reach.batch_scratch_len(),
    };
    let (scratch, _) = place(rest, numbers, R::ZERO).ok_or(Status::Length)?;
    if !asked.posture.is_null() {
        reach = reach.with_posture(posture).map_err(|error| status(&error))?;
    }
    // Nothing is refused any more: reports may be written. What C has there need not be one.
    // SAFETY: promised, and apart.
    let reports = bytes(unsafe { reports.slice() });
    let (reports, _) = place(reports, count, ik::Report::default()).ok_or(Status::Length)?;
    Ok(solve(Search { reach, targets, values, scratch, reports, options })?)
}

fn status(error: &ReachError) -> Status {
    match error {
        ReachError::Link { .. } => Status::NoLink,
        ReachError::NoGoals | ReachError::Weight { .. } | ReachError::NoWeight { .. } => {
            Status::Weight
        }
        ReachError::Unmoved { .. } => Status::Unmoved,
        ReachError::Limits { .. } => Status::Limits,
        ReachError::Posture { .. } | ReachError::Point { .. } => Status::NotFinite,
        ReachError::Freedoms { .. } | ReachError::PostureLength { .. } => Status::Length,
        // What only a newer dq8 knows.
        _ => Status::UnknownValue,
    }
}

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export_one! { $R
            /// Fills in the options that serve most: 1e-5 rad, 1e-5 lengths, 100 iterations,
            /// restarts.
            mechanism::reach_options(options: *mut ReachOptions<$R>) = super::reach_options(options)
        }
        export_one! { $R
            /// How many numbers `scratch` of dq8_mechanism_reach must have for so many goals, for
            /// one mechanism always the same. DQ8_STATUS_TOO_LARGE for more than 1024 goals.
            mechanism::reach_scratch(
                mechanism: *const Mechanism<$R>, goal_count: usize, scratch_count: *mut usize,
            ) = super::reach_scratch(mechanism, goal_count, scratch_count, Width::One)
        }
        export_one! { $R
            /// Inverse kinematics of one configuration: moves `values` until the link of each goal
            /// is at its target, a motion for each goal; within the limits of the joints. From a
            /// start nearby it converges in a few steps.
            ///
            /// `posture`, as many values, or null: a configuration that is preferred where the
            /// goals leave freedom. `options` null: those of dq8_mechanism_reach_options. `scratch`
            /// may hold anything. DQ8_STATUS_OK says that there is a report, not that the targets
            /// are reached: see `outcome`.
            ///
            /// DQ8_STATUS_NO_LINK, _UNMOVED, _WEIGHT (one is negative or not finite, or a goal has
            /// none, or there is no goal), _LIMITS, _NOT_FINITE (the posture, or a point) or
            /// _UNKNOWN_VALUE (`restarts`); then `scratch` may have been written, the values and
            /// the report not.
            mechanism::reach(
                mechanism: *const Mechanism<$R>, goals: *const Goal<$R>, targets: *const $R,
                goal_count: usize, posture: *const $R, options: *const ReachOptions<$R>,
                values: *mut $R, value_count: usize, scratch: *mut $R, scratch_count: usize,
                report: *mut ReachReport<$R>,
            ) = super::reach(
                Asked { mechanism, goals, targets, goal_count, posture, options },
                Answer { values, value_count, scratch, scratch_count, reports: report, count: 1 },
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

//! Inverse kinematics of one configuration of a mechanism, in memory of the caller.

use crate::mechanism::{Made, Mechanism};
use crate::memory::{Input, Output, bytes, place};
use crate::span::apart;
use crate::status::{Done, Status};
use core::mem::{MaybeUninit, offset_of};
use dq8::{DualQuat, Lanes, Real, Scalar, simd::Portable};
use dq8_robot::ik::{self, Freedom, Reach, ReachError};

/// What is asked of a link: components of its error in the axes of its target, and how much each weighs
/// where not all can vanish. A weight of 0 leaves its component free.
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
    /// 1 to begin again from another configuration where the search got stuck; 0 to converge from the
    /// given start only, to follow a target that moves.
    pub restarts: u32,
    /// How long a distance weighs as much as a radian; 0 for an eighth of the mechanism's length, or where
    /// something floats or slides without end, of the longer way that it has to go.
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
    /// A target is not unit to 0.001, a number is not finite, or an option is negative or no number, or
    /// max_step is 0: the values are untouched.
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

/// The library's goals are those of C, to the byte, and outcomes have the same numbers.
macro_rules! same {
    ($($R:ident)*) => {$(const _: () = {
        assert!(size_of::<Goal<$R>>() == size_of::<ik::Goal<$R>>());
        assert!(align_of::<Goal<$R>>() == align_of::<ik::Goal<$R>>());
        assert!(offset_of!(Goal<$R>, link) == offset_of!(ik::Goal<$R>, link));
        assert!(offset_of!(Goal<$R>, angular) == offset_of!(ik::Goal<$R>, angular));
        assert!(offset_of!(Goal<$R>, linear) == offset_of!(ik::Goal<$R>, linear));
        assert!(offset_of!(Goal<$R>, point) == offset_of!(ik::Goal<$R>, point));
    };)*};
}
same! { f32 f64 }

macro_rules! same_outcomes {
    ($($outcome:ident)*) => {$(
        const _: () = assert!(Outcome::$outcome as i32 == ik::Outcome::$outcome as i32);
    )*};
}
same_outcomes! { Converged OutOfReach AtLimits Stalled Unfinished Invalid }

/// How many numbers as large as `R` a search computes in: those of its freedoms and what aligns them, then its own.
fn room<R: Real>(known: dq8_robot::Mechanism<'_, R>, goals: usize) -> Result<usize, Status> {
    let freedoms = known.rates().checked_mul(size_of::<Freedom<R>>());
    let bytes = freedoms.and_then(|bytes| bytes.checked_add(align_of::<Freedom<R>>()));
    let numbers = bytes.map(|bytes| bytes.div_ceil(size_of::<R>()));
    let all = numbers.and_then(|all| all.checked_add(Reach::scratch_bound(known, goals)));
    all.filter(|all| *all <= isize::MAX as usize / size_of::<R>()).ok_or(Status::TooLarge)
}

/// # Safety
/// As for [`Made::new`] and [`Output::write`].
unsafe fn reach_scratch<R: Real>(
    mechanism: *const Mechanism<R>,
    goal_count: usize,
    scratch_count: *mut usize,
) -> Done {
    // SAFETY: promised.
    let made = unsafe { Made::new(mechanism)? };
    let to = Output::<usize>::new(scratch_count, 1)?;
    apart(&[to.span], &[made.given, made.steps])?;
    if goal_count > GOALS {
        return Err(Status::TooLarge);
    }
    // SAFETY: promised, and apart.
    unsafe { to.write(room(made.known, goal_count)?) };
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

/// What [`reach`] seeks, and where from.
struct Asked<R> {
    mechanism: *const Mechanism<R>,
    goals: *const Goal<R>,
    targets: *const R,
    goal_count: usize,
    posture: *const R,
    options: *const ReachOptions<R>,
}

/// # Safety
/// As for [`Made::new`], [`Input::slice`], [`Output::slice`] and [`Output::write`].
unsafe fn reach<R>(
    asked: Asked<R>,
    values: *mut R,
    value_count: usize,
    scratch: *mut R,
    scratch_count: usize,
    report: *mut ReachReport<R>,
) -> Done
where
    R: Scalar + Lanes<Real = R, Level = Portable, Mask = bool>,
{
    // SAFETY: promised.
    let made = unsafe { Made::new(asked.mechanism)? };
    let goals = Input::<ik::Goal<R>>::new(asked.goals, asked.goal_count)?;
    let targets = Input::<DualQuat<R>>::new(asked.targets, asked.goal_count)?;
    let posture_count = if asked.posture.is_null() { 0 } else { value_count };
    let posture = Input::<R>::new(asked.posture, posture_count)?;
    let values = Output::<R>::new(values, value_count)?;
    let scratch = Output::<MaybeUninit<R>>::new(scratch, scratch_count)?;
    let result = Output::<ReachReport<R>>::new(report, 1)?;
    let options = Input::<ReachOptions<R>>::unless_null(asked.options)?;
    let read = [goals.span, targets.span, posture.span, options.span, made.given, made.steps];
    apart(&[values.span, scratch.span, result.span], &read)?;
    // SAFETY: promised, and apart.
    let options = match *unsafe { options.slice() } {
        [options] => options.known()?,
        _ => ik::Options::default(),
    };
    let known = made.known;
    if asked.goal_count > GOALS || value_count != known.values() {
        return Err(Status::Length);
    }
    if scratch_count < room(known, asked.goal_count)? {
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
    let (numbers, _) = place(rest, reach.scratch_len(), R::ZERO).ok_or(Status::Length)?;
    if !asked.posture.is_null() {
        reach = reach.with_posture(posture).map_err(|error| status(&error))?;
    }
    let solved = reach.solve(targets, values, numbers, &options)?;
    // SAFETY: promised, and apart.
    unsafe { result.write(ReachReport::of(&solved)) };
    Ok(())
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

impl<R: Real> ReachReport<R> {
    fn of(report: &ik::Report<R>) -> Self {
        let ik::Report { iterations, restarts, angular_error, linear_error, outcome } = *report;
        Self { outcome: outcome as i32, iterations, restarts, angular_error, linear_error }
    }
}

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export_one! { $R
            /// Fills in the options that serve most: 1e-5 rad, 1e-5 lengths, 100 iterations, restarts.
            mechanism::reach_options(options: *mut ReachOptions<$R>) = super::reach_options(options)
        }
        export_one! { $R
            /// How many numbers `scratch` of dq8_mechanism_reach must have for so many goals, for one
            /// mechanism always the same. DQ8_STATUS_TOO_LARGE for more than 1024 goals.
            mechanism::reach_scratch(
                mechanism: *const Mechanism<$R>, goal_count: usize, scratch_count: *mut usize,
            ) = super::reach_scratch(mechanism, goal_count, scratch_count)
        }
        export_one! { $R
            /// Inverse kinematics of one configuration: moves `values` until the link of each goal is at
            /// its target, a motion for each goal; within the limits of the joints. From a start nearby it
            /// converges in a few steps.
            ///
            /// `posture`, as many values, or null: a configuration that is preferred where the goals leave
            /// freedom. `options` null: those of dq8_mechanism_reach_options. `scratch` may hold anything.
            /// DQ8_STATUS_OK says that there is a report, not that the targets are reached: see `outcome`.
            ///
            /// DQ8_STATUS_NO_LINK, _UNMOVED, _WEIGHT (one is negative or not finite, or a goal has none, or there is
            /// no goal), _LIMITS, _NOT_FINITE (the posture, or a point) or _UNKNOWN_VALUE (`restarts`); then `scratch`
            /// may have been written, the values and the report not.
            mechanism::reach(
                mechanism: *const Mechanism<$R>, goals: *const Goal<$R>, targets: *const $R,
                goal_count: usize, posture: *const $R, options: *const ReachOptions<$R>,
                values: *mut $R, value_count: usize, scratch: *mut $R, scratch_count: usize,
                report: *mut ReachReport<$R>,
            ) = super::reach(
                Asked { mechanism, goals, targets, goal_count, posture, options },
                values,
                value_count,
                scratch,
                scratch_count,
                report,
            )
        }
    };
}
for_both_numbers!(functions);

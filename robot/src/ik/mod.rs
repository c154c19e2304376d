//! Inverse kinematics of mechanisms: the search for values that bring links to their targets.
//!
//! | item | meaning |
//! |---|---|
//! | [`Goal`] | a link, and the components of its target that count |
//! | [`Reach`], [`Freedom`] | goals of a mechanism, checked once, in the caller's memory |
//! | `OwnedReach` | a [`Reach`] that owns its memory (feature `alloc`) |
//! | [`ReachJob`] | searches for many configurations |
//! | [`Options`], [`Tracking`] | tolerances, limits and weights of a search |
//! | [`Report`], [`Outcome`] | the result of a search |
//! | [`Reach::rates`] | the rates that give links their velocities |
//! | [`ReachJob::sequence`] | searches for clips of frames |
//! | [`SixAxisArm`], [`Solutions`] | all solutions of an arm of six hinges for a target |

// A call passes through these files in this order:
//
// - `goal.rs`, `freedom.rs`, `problem.rs`: goals, the values that may change, and a mechanism with
//   both, checked once;
// - `job.rs`, with `report.rs`: calls for one configuration, for many configurations, and for
//   clips;
// - `search.rs`: the loop of iterations and its decisions, with the memory that `scratch.rs`
//   divides;
// - `model.rs`: poses, errors and the Jacobian;
// - `step.rs`, or `tree.rs` with `body.rs` for many goals: damped least squares, to which
//   `floating.rs` adds the weight of floating joints.
//
// `rates.rs` solves for rates, from velocities of links. `six_axis.rs` finds all solutions of an
// arm of six hinges, with `family.rs` (geometry and a drawing) and `branches.rs` (formulas).

mod body;
mod branches;
mod family;
mod floating;
mod freedom;
mod goal;
mod job;
mod model;
#[cfg(feature = "alloc")]
mod owned;
mod problem;
mod rates;
mod report;
mod scratch;
mod search;
mod six_axis;
mod step;
mod tree;

pub use family::{Family, SolutionsError};
pub use freedom::Freedom;
pub use goal::{Goal, ReachError};
pub use job::ReachJob;
#[cfg(feature = "alloc")]
pub use owned::{OwnedReach, OwnedSixAxisArm};
pub use problem::Reach;
pub use rates::RatesError;
pub use report::{Options, Outcome, Report, Tracking};
pub use six_axis::{Singular, SixAxisArm, Solution, Solutions, SolutionsJob};

//! Inverse kinematics of mechanisms: which values bring links where they should be.
//!
//! | item | what it is |
//! |---|---|
//! | [`Goal`] | a link, and what of its target counts |
//! | [`Reach`], [`Freedom`] | goals of a mechanism, checked once, in memory of the caller |
//! | `OwnedReach` | the same with memory of its own (feature `alloc`) |
//! | [`ReachJob`] | searches for many configurations, with options |
//! | [`Options`], [`Report`], [`Outcome`] | how it searches, and how a search ended |
//! | [`Reach::rates`], [`ReachJob::sequence`] | velocities; clips of frames |
//! | [`SixAxisArm`], [`Solutions`] | all ways in which an arm of six hinges reaches a target |

// From a problem to its report: `problem.rs` (goals and mechanism, checked) with `freedom.rs` (what
// may change, within limits), `job.rs` (calls), `search.rs` (the loop and its decisions), `model.rs`
// (poses, errors, Jacobian), `step.rs` (damped least squares) or `tree.rs` (the same for many goals),
// `report.rs`; `scratch.rs` is the memory of all lanes. Beside it `rates.rs` (velocities), and for
// arms of six hinges `six_axis.rs`, `family.rs` (their geometry) and `branches.rs` (the formulas).

mod branches;
mod family;
mod freedom;
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

pub use family::Family;
pub use freedom::Freedom;
pub use job::ReachJob;
#[cfg(feature = "alloc")]
pub use owned::{OwnedReach, OwnedSixAxisArm};
pub use problem::{Goal, Reach, ReachError};
pub use rates::RatesError;
pub use report::{Options, Outcome, Report};
pub use six_axis::{Singular, SixAxisArm, Solution, Solutions, SolutionsError, SolutionsJob};

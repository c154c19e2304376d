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

// `goal.rs`, `freedom.rs`, `problem.rs`, `error.rs`: what is asked, checked once, in memory of the
// caller `bound.rs`: how far a link gets `solve.rs`, `job.rs`, `sequence.rs`: one configuration,
// many, and clips of frames `search.rs`, `lane.rs`, `assign.rs`: the loop, what a lane does next,
// what it is given and gives back `model.rs` with `forward.rs`, `compare.rs`, `columns.rs`,
// `wish.rs`, `step.rs`, `restart.rs`: what is computed of it, on lanes `rates.rs`: velocities
// instead of places `range.rs`, `report.rs`: values within limits; what a search is told, and what
// it tells `normal.rs`, `tree.rs`: damped least squares of any size; of many goals, in the shape of
// the tree `six_axis.rs`, `solutions.rs`: all solutions of an arm of six hinges; `family.rs`,
// `complex.rs`, `branches.rs`: by formula, `starts.rs`: by searches `scratch.rs`: numbers of all
// lanes in memory of the caller

mod assign;
mod bound;
mod branches;
mod columns;
mod compare;
mod complex;
mod error;
mod family;
mod forward;
mod freedom;
mod goal;
mod job;
mod lane;
mod model;
mod normal;
#[cfg(feature = "alloc")]
mod owned;
#[cfg(feature = "alloc")]
mod owned_arm;
mod problem;
mod range;
mod rates;
mod report;
mod restart;
mod scratch;
mod search;
mod sequence;
mod shape;
mod six_axis;
mod solutions;
mod solutions_job;
mod solve;
mod starts;
mod step;
mod tree;
mod wish;

pub use error::{RatesError, ReachError, SolutionsError};
pub use family::Family;
pub use freedom::Freedom;
pub use goal::Goal;
pub use job::ReachJob;
#[cfg(feature = "alloc")]
pub use owned::OwnedReach;
#[cfg(feature = "alloc")]
pub use owned_arm::OwnedSixAxisArm;
pub use problem::Reach;
pub use report::{Options, Outcome, Report};
pub use six_axis::SixAxisArm;
pub use solutions::{Singular, Solution, Solutions};
pub use solutions_job::SolutionsJob;

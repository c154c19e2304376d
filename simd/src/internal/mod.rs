//! Types that need `unsafe` code to be quick, for the crates `dq8`, `dq8-robot` and
//! `dq8-trajectory`, which forbid `unsafe` code.
//!
//! Most of these types follow one pattern: a constructor checks indices against a bound, the type
//! keeps the indices together with the bound, and a loop then reads memory without further checks.
//!
//! No other crate may use this module. It is hidden from the documentation and may change in any
//! release, so `dq8` and `dq8-robot` depend on exactly one version of this crate.
//!
//! | file | contents |
//! |---|---|
//! | `checked_schedule.rs` | [`CheckedSchedule`]: steps that need the results of earlier steps |
//! | `gather.rs` | [`Gather`]: reads of a table, with a row of its own for each lane |
//! | `picks.rs` | [`CheckedIndices`] and [`Picks`]: reads of a table's records by indices |
//! | `tracks.rs` | [`Tracks`]: the keys of packed clips |
//! | `pod.rs` | [`pod!`](crate::pod!): generic structs of floats that are `bytemuck::Pod` |
//! | `square_root.rs` | the square root of one float, which `core` does not have |

mod checked_schedule;
mod gather;
mod picks;
pub mod pod;
pub mod square_root;
mod tracks;

pub use checked_schedule::CheckedSchedule;
pub use gather::{Gather, GatheredRows};
pub use picks::{CheckedIndices, Index, PickRows, Picked, PickedInPlace, Picks, RECORDS_PER_LANE};
#[cfg(feature = "alloc")]
pub use tracks::OwnedTracks;
pub use tracks::{PlacedTracks, TrackError, TrackPlace, Tracks};

//! What `dq8`, `dq8-robot` and `dq8-trajectory` need `unsafe` code for, behind checks that are made
//! once.
//!
//! Those crates forbid unsafe code, so each of these types holds what has been checked, and the loop
//! that trusts the check. Nothing here is for other crates: it is hidden from the documentation,
//! changes in any release, and `dq8` depends on exactly one version of this crate for that reason.
//!
//! | file | what it holds |
//! |---|---|
//! | `checked_schedule.rs` | [`CheckedSchedule`]: results that need earlier results |
//! | `gather.rs` | [`Gather`]: records of a table, each lane from a row of its own |
//! | `picks.rs` | [`CheckedIndices`] and [`Picks`]: records of a table by indices |
//! | `tracks.rs` | [`Tracks`]: keys of many clips |
//! | `pod.rs` | [`pod!`](crate::pod!): structs of numbers that are `bytemuck::Pod` |
//! | `square_root.rs` | the square root of one number, which `core` does not have |

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
pub use tracks::{PlacedTracks, TrackPlace, Tracks};

//! Types that need `unsafe` code to be quick, for `dq8`, `dq8-robot` and `dq8-trajectory`, which
//! forbid it.
//!
//! Most of them follow one pattern: a constructor checks indices once, the type keeps them together
//! with what was checked, and a loop then reads memory without further checks.
//!
//! Nothing here is for other crates. The module is hidden from the documentation and may change in
//! any release, so `dq8` and `dq8-robot` depend on exactly one version of this crate.
//!
//! | file | contents |
//! |---|---|
//! | `checked_schedule.rs` | [`CheckedSchedule`]: results that need earlier results |
//! | `gather.rs` | [`Gather`]: records of a table, each lane from a row of its own |
//! | `picks.rs` | [`CheckedIndices`] and [`Picks`]: records of a table by indices |
//! | `tracks.rs` | [`Tracks`]: the keys of packed clips |
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
pub use tracks::{PlacedTracks, TrackError, TrackPlace, Tracks};

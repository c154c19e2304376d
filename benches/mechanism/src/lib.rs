//! Poses of robots from joint values: dq8's jobs, and the same by its peers.

#![allow(missing_docs, reason = "shared by programs, not published")]

pub mod ours;
pub mod peers;
pub mod points;
pub mod robots;
pub mod solutions;
#[cfg(feature = "peers")]
pub mod urdf;

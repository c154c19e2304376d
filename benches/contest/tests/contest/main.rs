//! Everyone who is timed, held to what is computed.

mod caches;
mod contenders;
mod memory;

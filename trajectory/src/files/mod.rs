//! Trajectories in text files: read whatever holds a pose on every line, written so that all digits
//! come back.
//!
//! | format | a line | stamps |
//! |---|---|---|
//! | [`Format::Tum`] | `stamp tx ty tz qx qy qz qw`, blanks between | seconds |
//! | [`Format::Euroc`] | `stamp,tx,ty,tz,qw,qx,qy,qz`, and what else there is | whole nanoseconds |
//! | [`Format::Kitti`] | twelve numbers of a 3×4 matrix, by rows | none: a second for each line |
//!
//! Lines that are empty or begin with `#` are skipped, as is a byte-order mark. Any number of
//! blanks or tabs may stand between fields and at the ends of lines, which may end in `\r\n`.
//! Stamps in any order, equal stamps and quaternions that are not unit are put right, and a
//! [`Warning`] says so. What cannot be a pose is an error that names the line: nothing is guessed.

mod error;
mod format;
mod read;
mod warning;
mod write;

pub use error::FileError;
pub use format::Format;
pub use read::{Recording, read};
pub use warning::Warning;

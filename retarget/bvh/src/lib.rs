//! Motion-capture clips in the BVH format of Biovision: [`parse`] makes a [`Clip`] of a file.
//!
//! The format has no standard. What is accepted here:
//! - keywords in any case, line ends of LF, CR or both, any white space, braces with or without
//!   space around them, several `ROOT`s;
//! - joint names with spaces; two joints of one name are an error, because the columns of a table
//!   need names;
//! - end sites become joints without channels named `<Parent>_End` (a second one `<Parent>_End2`,
//!   and so on);
//! - any number of channels in any order, rotations also repeated (`Z X Z`), and none at all
//!   (`CHANNELS 0`);
//! - a frame starts on a new line. Its values may go on over the next lines, as some programs wrap
//!   long lines;
//! - one frame more than announced, with a warning;
//! - the character that ends files under DOS.
#![forbid(unsafe_code)]

mod clip;
mod error;
mod file;
mod hierarchy;
mod locals;
mod motion;
mod number;
mod source;

pub use clip::{Axis, Channel, Clip, ClipError, Joint};
pub use error::BvhError;
pub use file::parse;
pub use motion::Warning;

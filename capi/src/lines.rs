//! Lines and planes, each moved by its own motion, plain or in blocks.

use crate::status::{Done, Status};
use dq8::storage::{AoSoA, Aos, Layout};

kernel! { lines_each(motions: 8, lines: 6) -> 6 by transform_lines_each }
kernel! { planes_each(motions: 8, planes: 4) -> 4 by transform_planes_each }

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export! { $R $lanes
            /// `lines[i]` moved by the unit `motions[i]`. A line is six numbers: its direction, and
            /// its moment p x direction of any point p on it (Plücker coordinates).
            lines_each, blocks_lines_each(motions: *const $R, lines: *const $R, out: *mut $R)
        }
        export! { $R $lanes
            /// `planes[i]` moved by the unit `motions[i]`. A plane is four numbers: its unit normal
            /// n, and n . p of any point p on it.
            planes_each, blocks_planes_each(motions: *const $R, planes: *const $R, out: *mut $R)
        }
    };
}
for_both_numbers!(functions);

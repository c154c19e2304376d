//! Lines and planes, each moved by its own motion, plain or in blocks.

use crate::memory::two_to;
use crate::status::{Done, Status};
use dq8::Backend;
use dq8::storage::{AoSoA, Aos, Layout};

/// # Safety
/// As for [`two_to`].
unsafe fn lines_each<L: Layout>(
    motions: *const L::Real,
    lines: *const L::Real,
    out: *mut L::Real,
    count: usize,
) -> Done {
    let run = |motions: &[L::Record<8>], from: &[L::Record<6>], to: &mut [_]| {
        Backend::best().transform_lines_each(motions, from, to)
    };
    // SAFETY: promised.
    unsafe { two_to(motions, lines, out, count, run) }
}

/// # Safety
/// As for [`two_to`].
unsafe fn planes_each<L: Layout>(
    motions: *const L::Real,
    planes: *const L::Real,
    out: *mut L::Real,
    count: usize,
) -> Done {
    let run = |motions: &[L::Record<8>], from: &[L::Record<4>], to: &mut [_]| {
        Backend::best().transform_planes_each(motions, from, to)
    };
    // SAFETY: promised.
    unsafe { two_to(motions, planes, out, count, run) }
}

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export! { $R $lanes
            /// `lines[i]` moved by the unit `motions[i]`. A line is six numbers: its direction, and its moment
            /// p x direction of any point p on it (Plücker coordinates).
            lines_each, blocks_lines_each(motions: *const $R, lines: *const $R, out: *mut $R)
        }
        export! { $R $lanes
            /// `planes[i]` moved by the unit `motions[i]`. A plane is four numbers: its unit normal n, and n . p of
            /// any point p on it.
            planes_each, blocks_planes_each(motions: *const $R, planes: *const $R, out: *mut $R)
        }
    };
}
for_both_numbers!(functions);

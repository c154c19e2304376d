//! How far motions are from each other, in arrays, plain or in blocks.

use crate::memory::two_to;
use crate::status::{Done, Status};
use dq8::Backend;
use dq8::storage::{AoSoA, Aos, Layout};

/// # Safety
/// As for [`two_to`].
unsafe fn angles<L: Layout>(
    a: *const L::Real,
    b: *const L::Real,
    out: *mut L::Real,
    count: usize,
) -> Done {
    let run = |a: &[L::Record<8>], b: &[L::Record<8>], to: &mut [L::Record<1>]| {
        Backend::best().angles(a, b, to)
    };
    // SAFETY: promised.
    unsafe { two_to(a, b, out, count, run) }
}

/// # Safety
/// As for [`two_to`].
unsafe fn distances<L: Layout>(
    a: *const L::Real,
    b: *const L::Real,
    out: *mut L::Real,
    count: usize,
) -> Done {
    let run = |a: &[L::Record<8>], b: &[L::Record<8>], to: &mut [L::Record<1>]| {
        Backend::best().distances(a, b, to)
    };
    // SAFETY: promised.
    unsafe { two_to(a, b, out, count, run) }
}

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export! { $R $lanes
            /// The angles between unit `a[i]` and unit `b[i]`, radians in 0 to pi, one number each.
            angles, blocks_angles(a: *const $R, b: *const $R, out: *mut $R)
        }
        export! { $R $lanes
            /// The distances between the translations of unit `a[i]` and unit `b[i]`, one number each.
            distances, blocks_distances(a: *const $R, b: *const $R, out: *mut $R)
        }
    };
}
for_both_numbers!(functions);

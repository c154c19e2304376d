//! How far motions are from each other, in arrays, plain or in blocks.

use crate::status::{Done, Status};
use dq8::storage::{AoSoA, Aos, Layout};

kernel! { angles(a: 8, b: 8) -> 1 by angles }
kernel! { distances(a: 8, b: 8) -> 1 by distances }

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export! { $R $lanes
            /// The angles between unit `a[i]` and unit `b[i]`, radians in 0 to pi, one number each.
            angles, blocks_angles(a: *const $R, b: *const $R, out: *mut $R)
        }
        export! { $R $lanes
            /// The distances between the translations of unit `a[i]` and unit `b[i]`, one number
            /// each.
            distances, blocks_distances(a: *const $R, b: *const $R, out: *mut $R)
        }
    };
}
for_both_numbers!(functions);

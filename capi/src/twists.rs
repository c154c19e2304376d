//! Twists, logarithms and powers of motions in arrays, plain or in blocks.

use crate::memory::one_to;
use crate::status::{Done, Status};
use dq8::Backend;
use dq8::storage::{AoSoA, Aos, Layout};

from_two! { twists_each: 8, 6 -> 6 by transform_twists_each }
from_two! { integrate_body: 8, 6 -> 8 by integrate_body, dt }

/// # Safety
/// As for [`one_to`].
unsafe fn log<L: Layout>(motions: *const L::Real, logs: *mut L::Real, count: usize) -> Done {
    let run = |from: &[L::Record<8>], to: &mut [L::Record<6>]| Backend::best().log(from, to);
    // SAFETY: promised.
    unsafe { one_to(motions, logs, count, run) }
}

/// # Safety
/// As for [`one_to`].
unsafe fn exp<L: Layout>(logs: *const L::Real, out: *mut L::Real, count: usize) -> Done {
    let run = |from: &[L::Record<6>], to: &mut [L::Record<8>]| Backend::best().exp(from, to);
    // SAFETY: promised.
    unsafe { one_to(logs, out, count, run) }
}

from_two! { pow_each: 8, 1 -> 8 by pow_each }

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export! { $R $lanes
            /// `twists[i]`, six numbers, angular part first, by the adjoint of the unit `motions[i]`: a body twist
            /// becomes the spatial one.
            twists_each, blocks_twists_each(motions: *const $R, twists: *const $R, out: *mut $R)
        }
        export! { $R $lanes
            /// Where the unit `motions[i]` are after `dt` seconds of the body twists `twists[i]`, six numbers each,
            /// angular part first.
            integrate_body, blocks_integrate_body(
                motions: *const $R, twists: *const $R, dt: $R, out: *mut $R
            )
        }
        export! { $R $lanes
            /// The logarithms of unit `motions`, six numbers each: half the angle times the axis, and its
            /// moment. Twice that is the twist that leads there in one second.
            log, blocks_log(motions: *const $R, logs: *mut $R)
        }
        export! { $R $lanes
            /// The motions of `logs`, six numbers each.
            exp, blocks_exp(logs: *const $R, out: *mut $R)
        }
        export! { $R $lanes
            /// The unit `motions[i]` to the power `t[i]`: the same screw axis, t times the angle and the slide.
            pow_each, blocks_pow_each(motions: *const $R, t: *const $R, out: *mut $R)
        }
    };
}
for_both_numbers!(functions);

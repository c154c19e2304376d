//! Twists, logarithms and powers of motions in arrays, plain or in blocks.

use crate::status::{Done, Status};
use dq8::storage::{AoSoA, Aos, Layout};

kernel! { twists_each(motions: 8, twists: 6) -> 6 by transform_twists_each }
kernel! { integrate_body(motions: 8, twists: 6; dt: L::Real) -> 8 by integrate_body }
kernel! { log(motions: 8) -> 6 by log }
kernel! { exp(logs: 6) -> 8 by exp }
kernel! { pow_each(motions: 8, t: 1) -> 8 by pow_each }

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export! { $R $lanes
            /// `twists[i]`, six numbers, angular part first, by the adjoint of the unit
            /// `motions[i]`: a body twist becomes the spatial one.
            twists_each, blocks_twists_each(motions: *const $R, twists: *const $R, out: *mut $R)
        }
        export! { $R $lanes
            /// Where the unit `motions[i]` are after `dt` seconds of the body twists `twists[i]`,
            /// six numbers each, angular part first.
            integrate_body, blocks_integrate_body(
                motions: *const $R, twists: *const $R, dt: $R, out: *mut $R
            )
        }
        export! { $R $lanes
            /// The logarithms of unit `motions`, six numbers each: half the angle times the axis,
            /// and its moment. Twice that is the twist that leads there in one second.
            log, blocks_log(motions: *const $R, logs: *mut $R)
        }
        export! { $R $lanes
            /// The motions of `logs`, six numbers each.
            exp, blocks_exp(logs: *const $R, out: *mut $R)
        }
        export! { $R $lanes
            /// The unit `motions[i]` to the power `t[i]`: the same screw axis, t times the angle
            /// and the slide.
            pow_each, blocks_pow_each(motions: *const $R, t: *const $R, out: *mut $R)
        }
    };
}
for_both_numbers!(functions);

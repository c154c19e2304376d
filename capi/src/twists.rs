//! Twists, logarithms and powers of motions in arrays, plain or in blocks.

use crate::memory::{one_to, two_to};
use crate::status::{Done, Status};
use dq8::Backend;
use dq8::storage::{AoSoA, Aos, Layout};

/// # Safety
/// As for [`two_to`].
unsafe fn twists_each<L: Layout>(
    motions: *const L::Real,
    twists: *const L::Real,
    out: *mut L::Real,
    count: usize,
) -> Done {
    let run = |motions: &[L::Record<8>], from: &[L::Record<6>], to: &mut [_]| {
        Backend::best().transform_twists_each(motions, from, to)
    };
    // SAFETY: promised.
    unsafe { two_to(motions, twists, out, count, run) }
}

/// # Safety
/// As for [`two_to`].
unsafe fn integrate_body<L: Layout>(
    motions: *const L::Real,
    twists: *const L::Real,
    dt: L::Real,
    out: *mut L::Real,
    count: usize,
) -> Done {
    let run = |motions: &[L::Record<8>], twists: &[L::Record<6>], to: &mut [_]| {
        Backend::best().integrate_body(motions, twists, dt, to)
    };
    // SAFETY: promised.
    unsafe { two_to(motions, twists, out, count, run) }
}

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

/// # Safety
/// As for [`two_to`].
unsafe fn pow_each<L: Layout>(
    motions: *const L::Real,
    t: *const L::Real,
    out: *mut L::Real,
    count: usize,
) -> Done {
    let run = |motions: &[L::Record<8>], t: &[L::Record<1>], to: &mut [_]| {
        Backend::best().pow_each(motions, t, to)
    };
    // SAFETY: promised.
    unsafe { two_to(motions, t, out, count, run) }
}

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

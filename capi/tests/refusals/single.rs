//! The one thing that a call reads beside its arrays (a motion, a root, options): no output may lie over any of it.

use crate::joint::joint;
use crate::refuse::{Memory, now};
use dq8_capi::joint::JointKind;
use dq8_capi::mechanism::{Mechanism, Step};
use dq8_capi::reach::{Goal, ReachOptions, ReachReport};
use dq8_capi::{Status, hierarchy, mechanism, reach, slices};
use std::mem::MaybeUninit;
use std::ptr;

/// Calls of a function with its one thing, of eight numbers, and an output of so many numbers.
type Call<'a, R> = (&'a str, usize, &'a dyn Fn(*const R, *mut R) -> Status);

/// `numbers of the output, |the one thing, output| call;`, each called by its text.
macro_rules! calls {
    ($($numbers:expr, |$one:ident, $output:ident| $call:expr;)+) => {
        &[$((stringify!($call), $numbers, &|$one, $output| $call)),+]
    };
}

macro_rules! all {
    ($test:ident, $reach:ident, $R:ident, $of:ident, $lanes:literal) => {
        #[test]
        fn $test() {
            use hierarchy::$of as h;
            use slices::$of as s;
            let parents = [-1, 0].as_ptr();
            let (mut inputs, mut more) = (memory!($R), memory!($R));
            let (a, b) = (inputs.0.as_mut_ptr(), more.0.as_mut_ptr());
            let lanes = $lanes;
            // SAFETY: all arrays are as long as their buffers, whose length is enough for 17 plain things and for
            // two blocks of matrices.
            let calls: &[Call<$R>] = unsafe {
                calls! {
                    51, |m, o| s::points(m, a, o, 17);
                    51, |m, o| s::points(m, o, o, 17);
                    51, |m, o| s::vectors(m, a, o, 17);
                    51, |m, o| s::vectors(m, o, o, 17);
                    8 * lanes, |m, o| s::blocks_points(lanes, m, a, o, 2);
                    8 * lanes, |m, o| s::blocks_points(lanes, m, o, o, 2);
                    8 * lanes, |m, o| s::blocks_vectors(lanes, m, a, o, 2);
                    128, |m, o| h::local_to_model(parents, 2, m, a, o, 16);
                    128, |m, o| h::local_to_model(parents, 2, m, o, o, 16);
                    16 * lanes, |m, o| h::blocks_local_to_model(lanes, parents, 2, m, a, o, 2);
                    16 * lanes, |m, o| h::blocks_local_to_model(lanes, parents, 2, m, o, o, 2);
                    128, |m, o| h::model_to_local(parents, 2, m, a, o, 16);
                    128, |m, o| h::model_to_local(parents, 2, m, o, o, 16);
                    16 * lanes, |m, o| h::blocks_model_to_local(lanes, parents, 2, m, a, o, 2);
                    128, |m, o| h::rotations_to_model(parents, 2, m, a, b, o, 16);
                    16 * lanes, |m, o|
                        h::blocks_rotations_to_model(lanes, parents, 2, m, a, b, o, 2);
                    128, |m, o| h::rotations_translations_to_model(parents, 2, m, a, o, 16);
                    16 * lanes, |m, o|
                        h::blocks_rotations_translations_to_model(lanes, parents, 2, m, a, o, 2);
                    128, |m, o| h::palette(parents, 2, m, a, a, o, b, 16);
                    128, |m, o| h::palette(parents, 2, m, a, a, b, o, 16);
                    16 * lanes, |m, o| h::blocks_palette(lanes, parents, 2, m, a, a, o, b, 2);
                    16 * lanes, |m, o| h::blocks_palette(lanes, parents, 2, m, a, a, b, o, 2);
                    192, |m, o| h::palette_matrices(parents, 2, m, a, a, b, o, 16);
                    16 * lanes, |m, o|
                        h::blocks_palette_matrices(lanes, parents, 2, m, a, a, o, b, 2);
                    24 * lanes, |m, o|
                        h::blocks_palette_matrices(lanes, parents, 2, m, a, a, b, o, 2);
                }
            };
            for (name, numbers, call) in calls {
                let before = memory!($R);
                let mut buffer = before.clone();
                // From the second cache line on, so that there is something before it.
                let line = 64 / size_of::<$R>();
                let out = buffer.0.as_mut_ptr().wrapping_add(line);
                for (first, wanted) in [
                    (-8, Status::Ok),
                    (-7, Status::Overlap),
                    (0, Status::Overlap),
                    (3, Status::Overlap),
                    (*numbers as isize - 1, Status::Overlap),
                    (*numbers as isize, Status::Ok),
                ] {
                    buffer.0 = before.0;
                    assert_eq!(
                        call(out.wrapping_offset(first), out),
                        wanted,
                        "{name}: from {first}"
                    );
                    let untouched = now::<$R, { 3 * 16 * 16 }>(&raw const buffer.0[0]) == before.0;
                    assert!(wanted == Status::Ok || untouched, "{name}: from {first}: written");
                }
                assert_eq!(call(a.wrapping_add(512), out), Status::Ok, "{name}: elsewhere");
            }
        }

        #[test]
        fn $reach() {
            use mechanism::$of as m;
            use reach::$of as c;
            let joints = [joint::<$R>(-1, JointKind::Revolute)];
            let mut steps = [const { MaybeUninit::<Step<$R>>::uninit() }; 1];
            let mut made = MaybeUninit::<Mechanism<$R>>::zeroed();
            let goals =
                [Goal::<$R> { link: 0, angular: [1.0; 3], linear: [1.0; 3], point: [0.0; 3] }];
            let target: [$R; 8] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
            // One memory for options and all that is written, so that the one can lie over the other.
            let mut memory = [0.0 as $R; 1024];
            let numbers = size_of::<ReachOptions<$R>>() / size_of::<$R>();
            // SAFETY: arrays have the length that is said, and what overlaps is refused.
            unsafe {
                let (of, room) = (made.as_mut_ptr(), steps.as_mut_ptr().cast());
                let status = m::make(joints.as_ptr(), 1, room, of, ptr::null_mut());
                assert_eq!(status, Status::Ok);
                let mut needed = 0;
                assert_eq!(c::reach_scratch(of, 1, &mut needed), Status::Ok);
                assert!(needed < 800, "{needed}");
                let start = memory.as_mut_ptr();
                let options = start.add(8).cast::<ReachOptions<$R>>();
                let report = start.add(32).cast::<ReachReport<$R>>();
                let call = |values, scratch, report| {
                    assert_eq!(c::reach_options(options), Status::Ok);
                    let before = now::<$R, 1024>(start);
                    let (g, t, none) = (goals.as_ptr(), target.as_ptr(), ptr::null());
                    let status =
                        c::reach(of, g, t, 1, none, options, values, 1, scratch, needed, report);
                    let bits = |all: [$R; 1024]| all.map(|number| number.to_bits());
                    assert!(status == Status::Ok || bits(now(start)) == bits(before), "written");
                    status
                };
                let (values, scratch) = (start, start.add(128));
                for at in [0, 1, numbers - 1] {
                    let over = options.cast::<$R>().add(at);
                    assert_eq!(call(over, scratch, report), Status::Overlap, "values, {at}");
                    assert_eq!(call(values, over, report), Status::Overlap, "scratch, {at}");
                    assert_eq!(call(values, scratch, over.cast()), Status::Overlap, "report, {at}");
                }
                assert_eq!(call(values, scratch, report), Status::Ok);
                // Just before them and just behind them is not over them.
                assert_eq!(
                    call(start.add(7), start.add(8 + numbers), start.add(1000).cast()),
                    Status::Ok
                );
            }
        }
    };
}
all!(
    no_output_lies_over_a_motion_or_a_root_single,
    no_output_of_a_search_lies_over_its_options_single,
    f32,
    single,
    8
);
all!(
    no_output_lies_over_a_motion_or_a_root_double,
    no_output_of_a_search_lies_over_its_options_double,
    f64,
    double,
    4
);

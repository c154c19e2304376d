//! Lines, planes, twists, metrics and chains.

use crate::answers::answers;
use crate::refuse::{Aliasing, Memory, now};
use dq8_capi::Status;
use dq8_capi::{chain, geometry, lines, metric, packing, slices, twists};
use std::ptr;

macro_rules! all {
    ($test:ident, $R:ident, $of:ident, $lanes:literal) => {
        #[test]
        fn $test() {
            use Aliasing::{Apart, Free, InPlace};
            use chain::$of as c;
            use geometry::$of as g;
            use lines::$of as l;
            use metric::$of as d;
            use packing::$of as p;
            use twists::$of as t;
            // SAFETY: all arrays are as long as their buffers, whose length is enough for 17 plain
            // things and for three blocks.
            unsafe {
                refuses! { $R:
                    Free, |[a, b, o]| g::line(a, b, o);
                    Free, |[a, b, o]| g::plane(a, b, o);
                    Free, |[a, b, o]| g::twist(a, b, o);
                    Free, |[a, o]| g::to_twist(a, o);
                    Free, |[a, b, o]| g::integrate_body(a, b, 0.5, o);
                    Free, |[a, b, o]| g::angle_to(a, b, o);
                    Free, |[a, b, o]| g::distance_to(a, b, o);

                    InPlace(0), |[a, o]| slices::$of::conjugate(a, o, 17);
                    Apart, |[a, b, o]| l::lines_each(a, b, o, 17);
                    Apart, |[a, b, o]| l::planes_each(a, b, o, 17);
                    Apart, |[a, b, o]| t::twists_each(a, b, o, 17);
                    Apart, |[a, b, o]| t::blocks_twists_each($lanes, a, b, o, 3);
                    Apart, |[a, b, o]| t::integrate_body(a, b, 0.5, o, 17);
                    Apart, |[a, o]| t::log(a, o, 17);
                    Apart, |[a, o]| t::blocks_log($lanes, a, o, 3);
                    Apart, |[a, o]| t::exp(a, o, 17);
                    Apart, |[a, b, o]| t::pow_each(a, b, o, 17);
                    Apart, |[a, b, o]| d::angles(a, b, o, 17);
                    Apart, |[a, b, o]| d::distances(a, b, o, 17);

                    InPlace(0), |[a, o]| c::chain_products(a, o, 17);
                    InPlace(0), |[a, o]| c::blocks_chain_products($lanes, a, o, 3);
                    Apart, |[a, o]| p::pack_chain($lanes, a, 2 * $lanes + 1, o, 3);
                    Apart, |[a, o]| p::unpack_chain($lanes, a, 3, o, 2 * $lanes + 1);
                }
            }
        }
    };
}
all!(every_pointer_single, f32, single, 8);
all!(every_pointer_double, f64, double, 4);

#[test]
fn what_else_is_wrong() {
    use chain::single as c;
    use packing::single as p;
    let mut from = Memory([0.0_f32; 768]);
    let mut to = from.clone();
    let (a, o) = (from.0.as_mut_ptr(), to.0.as_mut_ptr());
    // SAFETY: what is dereferenced is as long as it is said to be.
    let results = unsafe {
        [
            (c::blocks_chain_products(4, a, o, 1), Status::Lanes),
            (p::pack_chain(8, a, 17, o, 2), Status::Length),
            (p::unpack_chain(8, a, 4, o, 17), Status::Length),
            (p::pack_chain(2, a, 17, o, 3), Status::Lanes),
        ]
    };
    answers(results);
    assert_eq!(to.0, from.0);
}

//! Every pointer of every function, wrong in every way: an error of its own, and nothing written.

#[macro_use]
mod refuse;
#[path = "../support/answers.rs"]
mod answers;
mod geometry;
#[path = "../support/joint.rs"]
mod joint;
mod single;

use answers::answers;
use dq8_capi::Status;
use dq8_capi::{hierarchy, mean, motion, packing, screw, slices};
use refuse::{Aliasing, Memory, now};
use std::ptr;

const PARENTS: [i32; 2] = [-1, 0];

macro_rules! all {
    ($test:ident, $R:ident, $of:ident, $lanes:literal) => {
        #[test]
        fn $test() {
            use Aliasing::{Apart, Free, InPlace};
            use hierarchy::$of as h;
            use motion::$of as m;
            use packing::$of as p;
            use screw::$of as c;
            use slices::$of as s;
            let parents = PARENTS.as_ptr();
            // SAFETY: all arrays are as long as their buffers, whose length is enough for 17 plain
            // things and for three blocks.
            unsafe {
                refuses! { $R:
                    InPlace(0), |[a, b, o]| s::mul(a, b, o, 17);
                    InPlace(0), |[a, b, o]| s::blocks_mul($lanes, a, b, o, 3);
                    InPlace(0), |[a, o]| s::normalize(a, o, 17);
                    InPlace(0), |[a, o]| s::inverse(a, o, 17);
                    InPlace(0), |[a, o]| s::blocks_inverse($lanes, a, o, 3);
                    Apart, |[a, b, o]| s::nlerp(a, b, 0.5, o, 17);
                    Apart, |[a, b, t, o]| s::nlerp_each(a, b, t, o, 17);
                    Apart, |[a, b, o]| s::sclerp(a, b, 0.5, o, 17);
                    Apart, |[a, b, t, o]| s::sclerp_each(a, b, t, o, 17);
                    Apart, |[a, b, t, o]| s::blocks_sclerp_each($lanes, a, b, t, o, 3);
                }
                let mut by = memory!($R);
                let by = by.0.as_mut_ptr();
                refuses! { $R:
                    InPlace(0), |[a, o]| s::points(by, a, o, 17);
                    InPlace(0), |[a, o]| s::vectors(by, a, o, 17);
                    Apart, |[a, b, o]| s::points_each(a, b, o, 17);
                    Apart, |[a, b, o]| s::vectors_each(a, b, o, 17);
                    Apart, |[a, o]| s::matrices_3x4(a, 0, o, 17);
                    Apart, |[a, o]| s::matrices_4x4(a, 1, o, 17);

                    InPlace(0), |[a, o]| h::local_to_model(parents, 2, ptr::null(), a, o, 16);
                    InPlace(0), |[a, o]| h::blocks_local_to_model($lanes, parents, 2, by, a, o, 2);
                    InPlace(0), |[a, o]| h::model_to_local(parents, 2, by, a, o, 16);
                    Apart, |[a, b, o]| h::rotations_to_model(parents, 2, ptr::null(), a, b, o, 16);
                    Apart, |[a, o]|
                        h::rotations_translations_to_model(parents, 2, ptr::null(), a, o, 16);
                    Apart, |[a, b, models, o]|
                        h::palette(parents, 2, ptr::null(), a, b, models, o, 16);
                    Apart, |[a, b, palette, o]|
                        h::palette_matrices(parents, 2, ptr::null(), a, b, o, palette, 16);

                    Apart, |[a, o]| p::pack($lanes, 2, a, 16, o, 16 / $lanes);
                    Apart, |[a, o]| p::unpack($lanes, 2, a, 16 / $lanes, o, 16);

                    Free, |[o]| m::identity(o);
                    Free, |[a, b, o]| m::from_rotation_translation(a, b, o);
                    Free, |[a, b, o]| m::to_rotation_translation(a, b, o);
                    Free, |[a, o]| m::to_matrix_3x4(a, o);
                    Free, |[a, o]| m::to_matrix_4x4(a, o);
                    Free, |[a, b, o]| m::mul(a, b, o);
                    Free, |[a, o]| m::conjugate(a, o);
                    Free, |[a, o]| m::inverse(a, o);
                    Free, |[a, o]| m::normalize(a, o);
                    Free, |[a, b, o]| m::point(a, b, o);
                    Free, |[a, b, o]| m::vector(a, b, o);
                    Free, |[a, b, o]| c::nlerp(a, b, 0.5, o);
                    Free, |[a, b, o]| c::sclerp(a, b, 0.5, o);
                    Free, |[a, o]| c::log(a, o);
                    Free, |[a, o]| c::exp(a, o);
                    Free, |[a, o]| c::pow(a, 0.5, o);
                    Free, |[a, o]| c::to_screw(a, o);
                    Free, |[a, o]| c::from_screw(a, o);
                }
                // The first weight is 0, the fourth 1.
                refuses! { $R:
                    Free, |[a, b, o]| c::blend(a, b, 4, o);
                    Free, |[a, o]|
                        mean::$of::mean(a, ptr::null(), 4, 0.0, 4, o, ptr::null_mut());
                }
            }
        }
    };
}
all!(every_pointer_single, f32, single, 8);
all!(every_pointer_double, f64, double, 4);

#[test]
fn what_else_is_wrong() {
    use hierarchy::{dq8_check_parents, single as h};
    use motion::single as m;
    use packing::single as p;
    use slices::single as s;
    let mut a = memory!(f32);
    let mut out = memory!(f32);
    let before = out.0;
    let (from, to) = (a.0.as_mut_ptr(), out.0.as_mut_ptr());
    let parents = PARENTS.as_ptr();
    let root = ptr::null();
    let huge = usize::MAX / 4;
    let nan = [f32::NAN; 16];
    let (mut scales, mut mirrors) = ([0.0_f32; 16], [0.0_f32; 16]);
    for axis in 0..4 {
        scales[axis * 5] = if axis == 1 { 2.0 } else { 1.0 };
        mirrors[axis * 5] = if axis == 1 { -1.0 } else { 1.0 };
    }
    let mut unfinished = mirrors;
    unfinished[5] = 1.0;
    let mut slanted = unfinished;
    slanted[12] = 0.5;
    unfinished[3] = f32::INFINITY;
    let zero = [0.0_f32; 8];
    // SAFETY: what is dereferenced is as long as it is said to be; the huge ones are refused.
    let results = unsafe {
        let mean = |motions, weights, count, to| {
            mean::single::mean(motions, weights, count, 1e-6, 4, to, ptr::null_mut())
        };
        [
            (s::mul(from, from, to, huge), Status::TooLarge),
            (s::mul(from, from, to, usize::MAX), Status::TooLarge),
            (s::mul(from, from, to, isize::MAX as usize / 32 + 1), Status::TooLarge),
            (s::blocks_mul(5, from, from, to, 1), Status::Lanes),
            (s::matrices_3x4(from, 2, to, 1), Status::UnknownValue),
            (h::local_to_model(parents, 2, root, from, to, 3), Status::Length),
            (h::local_to_model(parents, 0, root, from, to, 3), Status::Length),
            (h::blocks_local_to_model(4, parents, 2, root, from, to, 2), Status::Lanes),
            (h::local_to_model([-1, 1].as_ptr(), 2, root, from, to, 2), Status::ParentNotBefore),
            (h::local_to_model([-2, 0].as_ptr(), 2, root, from, to, 2), Status::ParentOutOfRange),
            (h::local_to_model(ptr::null(), 2, root, from, to, 2), Status::NullPointer),
            (h::local_to_model(to.cast(), 2, root, from, to, 2), Status::Overlap),
            (p::pack(8, 2, from, 16, to, 3), Status::Length),
            (p::pack(8, 2, from, 15, to, 2), Status::Length),
            (p::unpack(8, 2, from, 1, to, 16), Status::Length),
            (p::pack(2, 2, from, 16, to, 2), Status::Lanes),
            (m::normalize(zero.as_ptr(), to), Status::NotNormalizable),
            (m::inverse(zero.as_ptr(), to), Status::NoInverse),
            (m::inverse(nan.as_ptr(), to), Status::NoInverse),
            (m::check_unit(zero.as_ptr(), 0.1), Status::NotUnit),
            (m::from_matrix_3x4(scales.as_ptr(), 1e-5, to), Status::NotOrthonormal),
            (m::from_matrix_4x4(mirrors.as_ptr(), 1e-5, to), Status::Mirrors),
            (m::from_matrix_3x4(unfinished.as_ptr(), 1e-5, to), Status::NotFinite),
            (m::from_matrix_4x4(slanted.as_ptr(), 1e-5, to), Status::NotAffine),
            (m::to_rotation_translation(from, to, to.add(3)), Status::Overlap),
            (screw::single::blend(from, from, 0, to), Status::NoInfluences),
            (mean(from, from, 0, to), Status::NoInfluences),
            (mean(from, zero.as_ptr(), 3, to), Status::NotNormalizable),
            (mean(from, from.wrapping_byte_add(1), 3, to), Status::Misaligned),
            (mean::single::mean(from, from, 3, 0.0, 4, to, to.cast()), Status::Overlap),
            (screw::single::blend(from, zero.as_ptr(), 3, to), Status::NotNormalizable),
            (screw::single::nlerp(from, nan.as_ptr(), 0.5, to), Status::NotNormalizable),
            (dq8_check_parents([-1, 5].as_ptr(), 2, ptr::null_mut()), Status::ParentOutOfRange),
            (dq8_check_parents(ptr::null(), usize::MAX, ptr::null_mut()), Status::NullPointer),
            (dq8_capi::backend::dq8_backend_limit(3), Status::UnknownValue),
            (dq8_capi::backend::dq8_set_reproducible(2), Status::UnknownValue),
        ]
    };
    answers(results);
    assert_eq!(out.0, before);
}

#[test]
fn the_joint_that_is_wrong_is_named() {
    let parents = [-1, 0, 3, 1];
    let mut bad = 77;
    // SAFETY: the array is as long as it is said to be.
    let status = unsafe { hierarchy::dq8_check_parents(parents.as_ptr(), 4, &mut bad) };
    assert_eq!((status, bad), (Status::ParentNotBefore, 2));
    // SAFETY: as above.
    let status = unsafe { hierarchy::dq8_check_parents(parents.as_ptr(), 2, &mut bad) };
    assert_eq!((status, bad), (Status::Ok, 2));
}

#[test]
fn nothing_at_all_may_lie_nowhere() {
    let (none, nowhere) = (ptr::null::<f32>(), ptr::null_mut::<f32>());
    // SAFETY: there is nothing to read or to write.
    unsafe {
        assert_eq!(slices::single::mul(none, none, nowhere, 0), Status::Ok);
        assert_eq!(slices::single::blocks_mul(8, none, none, nowhere, 0), Status::Ok);
        let run = hierarchy::single::local_to_model;
        assert_eq!(run(ptr::null(), 0, none, none, nowhere, 0), Status::Ok);
        assert_eq!(packing::single::pack(16, 3, none, 0, nowhere, 0), Status::Ok);
    }
}

#[test]
fn every_status_has_a_text_of_its_own() {
    let text = |status| {
        // SAFETY: the text is static and ends with a zero.
        unsafe { std::ffi::CStr::from_ptr(dq8_capi::status::dq8_status_text(status)) }
    };
    let texts: std::collections::BTreeSet<_> = (-1..35).map(text).collect();
    assert_eq!(texts.len(), 36);
    assert_eq!(text(35), text(i32::MIN));
}

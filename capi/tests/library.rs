//! The functions of the library itself.

use dq8::{Backend, Block};
use dq8_capi::packing::{double, single};
use dq8_capi::{InstructionSet, Status, backend, status};
use std::ffi::CStr;

fn name() -> &'static CStr {
    // SAFETY: the text is static and ends with a zero.
    unsafe { CStr::from_ptr(backend::dq8_backend_name()) }
}

#[test]
fn the_name_is_that_of_the_backend() {
    assert_eq!(name().to_str().unwrap(), Backend::best().to_string());
    assert_eq!(backend::dq8_backend_limit(3), Status::UnknownValue);
    assert_eq!(backend::dq8_backend_limit(InstructionSet::Any as i32), Status::Ok);
    assert_eq!(backend::dq8_set_reproducible(2), Status::UnknownValue);
    assert_eq!(backend::dq8_set_reproducible(0), Status::Ok);
    if cfg!(feature = "reproducible") {
        assert_eq!(backend::dq8_set_reproducible(1), Status::Ok);
        let alone = Backend::best() == Backend::PORTABLE;
        assert_eq!(name(), if alone { c"portable" } else { c"reproducible" });
        assert_eq!(backend::dq8_set_reproducible(0), Status::Ok);
    }
}

#[test]
fn every_status_has_a_text_of_its_own() {
    // SAFETY: the text is static and ends with a zero.
    let text = |number| unsafe { CStr::from_ptr(status::dq8_status_text(number)) };
    let texts: std::collections::BTreeSet<_> = (-1..52).map(text).collect();
    assert_eq!(texts.len(), 53);
    assert_eq!(text(52), text(i32::MIN));
}

#[test]
fn blocks_are_as_large_as_those_of_rust() {
    macro_rules! same {
        ($R:ident $of:ident $($lanes:literal: $($components:literal)*;)*) => {$($(
            assert_eq!(
                $of::block_size($lanes, $components) * size_of::<$R>(),
                size_of::<Block<$R, $lanes, $components>>(),
            );
        )*)*};
    }
    same! { f32 single 8: 1 3 4 7 8 12 16; 16: 1 3 4 7 8 12 16; }
    same! { f64 double 4: 1 3 4 7 8 12 16; 8: 1 3 4 7 8 12 16; }
}

//! Every function gives, number for number, what the Rust one gives that it stands for: the right
//! kernel, the right order of arguments, the right parts of memory.

mod chains;
mod geometry;
mod hierarchies;
#[path = "../support/joint.rs"]
mod joint;
mod mechanisms;
mod motions;
mod sample;
mod slices;

use dq8::Backend;
use dq8_capi::Status::Ok as Done;
use dq8_capi::backend;
use std::ffi::CStr;

#[test]
fn the_name_is_that_of_the_backend() {
    // SAFETY: the text is static and ends with a zero.
    let name = unsafe { CStr::from_ptr(backend::dq8_backend_name()) };
    assert_eq!(name.to_str().unwrap(), Backend::best().to_string());
    assert_eq!(backend::dq8_backend_limit(dq8_capi::InstructionSet::Any as i32), Done);
    assert_eq!(backend::dq8_set_reproducible(0), Done);
    if cfg!(feature = "reproducible") {
        assert_eq!(backend::dq8_set_reproducible(1), Done);
        // SAFETY: as above.
        let name = unsafe { CStr::from_ptr(backend::dq8_backend_name()) };
        let alone = dq8::Backend::best() == dq8::Backend::PORTABLE;
        assert_eq!(name, if alone { c"portable" } else { c"reproducible" });
        assert_eq!(backend::dq8_set_reproducible(0), Done);
    }
}

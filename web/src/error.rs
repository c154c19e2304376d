//! Texts of errors, which JavaScript reads after a call that failed. The module that packs has
//! numbers in place of texts.

use std::cell::RefCell;
use std::fmt::Display;

thread_local!(static ERROR: RefCell<String> = const { RefCell::new(String::new()) });

/// Returns 0, or 1 after the text of an error has been kept.
pub(crate) fn status<E: Display>(result: Result<(), E>) -> u32 {
    result.map_or_else(|error| failed(error, 1), |()| 0)
}

/// Keeps the text of an error, and returns `code`.
fn failed<E: Display, C>(error: E, code: C) -> C {
    ERROR.with_borrow_mut(|text| *text = error.to_string());
    code
}

/// The place of the thing that has been made, which JavaScript keeps; null after an error.
pub(crate) fn made<T, E: Display>(result: Result<T, E>) -> *mut T {
    result.map_or_else(
        |error| failed(error, std::ptr::null_mut()),
        |thing| Box::into_raw(Box::new(thing)),
    )
}

/// The place of the text of the last error.
#[unsafe(no_mangle)]
extern "C" fn dq8_error() -> *const u8 {
    ERROR.with_borrow(|text| text.as_ptr())
}

#[unsafe(no_mangle)]
extern "C" fn dq8_error_length() -> usize {
    ERROR.with_borrow(String::len)
}

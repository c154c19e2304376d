//! The choice of instructions that compute.

use crate::status::Status;
use core::ffi::{CStr, c_char};
use dq8::Backend;

/// The instructions that functions of arrays and blocks may use, from the least to the most.
#[repr(i32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InstructionSet {
    /// The instructions that the library was built for: SSE2 on x86-64, NEON on aarch64, no vectors
    /// on a Cortex-M.
    Portable = 0,
    /// x86-64 with AVX2 and FMA.
    Avx2 = 1,
    /// x86-64 with AVX-512 F, VL and DQ.
    Avx512 = 2,
    /// No limit. Newer versions of the library may have more levels than the ones above.
    Any = 255,
}

/// Returns the name of the instructions that compute now, for logs. The text lives as long as the
/// program.
#[unsafe(no_mangle)]
pub extern "C" fn dq8_backend_name() -> *const c_char {
    let best = Some(Backend::best());
    #[cfg(feature = "reproducible")]
    if best == Some(Backend::reproducible()) && best != Some(Backend::PORTABLE) {
        return c"reproducible".as_ptr();
    }
    let name: &'static CStr = if best == Backend::avx512() {
        c"AVX-512"
    } else if best == Backend::avx2() {
        c"AVX2"
    } else {
        c"portable"
    };
    name.as_ptr()
}

/// Limits the instructions that compute, in all threads and from now on, to `most`, one of enum
/// dq8_backend. Instructions that the CPU does not have are never used, so every limit is safe.
///
/// Returns DQ8_STATUS_UNKNOWN_VALUE if `most` is none of them; the limit then stays as it was.
#[unsafe(no_mangle)]
pub extern "C" fn dq8_backend_limit(most: i32) -> Status {
    let all = [
        (InstructionSet::Portable, Some(Backend::PORTABLE)),
        (InstructionSet::Avx2, Backend::avx2()),
        (InstructionSet::Avx512, Backend::avx512()),
        (InstructionSet::Any, None),
    ];
    match all.into_iter().find(|(known, _)| *known as i32 == most) {
        Some((_, limit)) => {
            Backend::limit(limit);
            Status::Ok
        }
        None => Status::UnknownValue,
    }
}

/// Makes the results of functions of arrays and blocks the same on every machine, bit by bit, in
/// all threads and from now on. 1 switches this on, and then functions take 1.0 to 1.5 times as
/// long. 0, the state at the start, switches it off. It works together with every limit. Functions
/// of one motion always have the same bits.
///
/// Returns DQ8_STATUS_UNKNOWN_VALUE if `reproducible` is neither 0 nor 1, or if it is 1 and the
/// library was built without the feature `reproducible`; nothing changes then.
#[unsafe(no_mangle)]
pub extern "C" fn dq8_set_reproducible(reproducible: i32) -> Status {
    match reproducible {
        #[cfg(feature = "reproducible")]
        0 | 1 => Backend::set_reproducible(reproducible == 1),
        #[cfg(not(feature = "reproducible"))]
        0 => (),
        _ => return Status::UnknownValue,
    }
    Status::Ok
}

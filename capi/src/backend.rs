//! The choice of the instruction set for functions of arrays and blocks.

use crate::status::Status;
use core::ffi::{CStr, c_char};
use dq8::Backend;

/// The instruction sets that functions of arrays and blocks may use, each with more instructions
/// than the previous set.
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
    /// No limit. Newer versions of the library may use instruction sets that this enum does not
    /// have.
    Any = 255,
}

/// Returns the name of the instruction set in use, for logs. The text lives as long as the program.
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

/// Limits the instruction set to `most`, one of enum dq8_backend. The limit holds in all threads
/// and from now on. Instructions that the CPU does not have are never used, so every limit is safe.
///
/// Returns DQ8_STATUS_UNKNOWN_VALUE if `most` is no value of enum dq8_backend. The limit then stays
/// as it was.
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

/// Makes results the same on every machine, bit by bit. This concerns functions of arrays and
/// blocks, in all threads and from now on. The value 1 of `reproducible` switches this on, and
/// functions then take 1.0 to 1.5 times as long. The value 0 switches it off, which is the state
/// when the program starts. The limit of dq8_backend_limit holds in both states. Functions of one
/// motion have the same bits on every machine in either state.
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

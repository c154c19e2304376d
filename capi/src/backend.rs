//! Which instructions compute.

use crate::status::Status;
use core::ffi::{CStr, c_char};
use dq8::Backend;

/// The instructions that kernels over arrays and blocks may use, in rising order.
#[repr(i32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InstructionSet {
    /// What the library was built for: SSE2 on x86-64, NEON on aarch64, none on a Cortex-M.
    Portable = 0,
    /// x86-64 with AVX2 and FMA.
    Avx2 = 1,
    /// x86-64 with AVX-512 F, VL and DQ.
    Avx512 = 2,
    /// No limit. Newer versions may know more than the others above.
    Any = 255,
}

/// The name of what computes now, for logs: text that lives as long as the program.
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

/// From now on, in all threads, nothing better than `most` computes: one of enum dq8_backend. What
/// the CPU lacks is passed over, so a limit is always safe.
///
/// DQ8_STATUS_UNKNOWN_VALUE if `most` is no backend; the limit stays as it was.
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

/// From now on, in all threads, whether results have the same bits on every machine, for 1.0 to 1.5
/// times the time: 1 if they have, 0 if not, as they begin. It goes with every limit. Functions of
/// one motion have the same bits always.
///
/// DQ8_STATUS_UNKNOWN_VALUE if it is neither, or 1 and the library was built without the feature
/// `reproducible`; nothing changes.
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

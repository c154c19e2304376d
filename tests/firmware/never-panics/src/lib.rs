//! A panic handler that does not link. The linker drops it from an image in which nothing can
//! panic; in any other it fails with `undefined symbol: something_can_panic`, and names what refers
//! to it.
#![no_std]

use core::panic::PanicInfo;

unsafe extern "C" {
    /// Nowhere defined.
    fn something_can_panic() -> !;
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    // SAFETY: never runs, because no image that could get here links.
    unsafe { something_can_panic() }
}

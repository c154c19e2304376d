use crate::number::{Real, Scalar};
use core::fmt::Debug;

/// A weight as it lies in memory: `f32` and `f64` as they are, `u8` and `u16` normalized, so that
/// the largest number is 1 exactly (glTF 2.0, §3.11; Vulkan's `UNORM`).
///
/// ```
/// use dq8::skinning::Weight;
/// assert_eq!([0_u8, 51, 255].map(|weight| weight.value::<f32>()), [0.0, 0.2, 1.0]);
/// ```
pub trait Weight: Copy + Debug + Send + Sync + 'static {
    /// The weight as a number.
    #[must_use]
    fn value<R: Real>(self) -> R;

    /// The same memory, if weights lie there as the numbers that kernels compute with.
    #[doc(hidden)]
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    fn as_numbers<R: Scalar>(weights: &[Self]) -> Option<&[R]> {
        let _ = weights;
        None
    }
}

impl Weight for f32 {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn value<R: Real>(self) -> R {
        R::from(self)
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn as_numbers<R: Scalar>(weights: &[Self]) -> Option<&[R]> {
        if R::SINGLE { bytemuck::try_cast_slice(weights).ok() } else { None }
    }
}

impl Weight for f64 {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn value<R: Real>(self) -> R {
        R::from_f64(self)
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn as_numbers<R: Scalar>(weights: &[Self]) -> Option<&[R]> {
        if R::SINGLE { None } else { bytemuck::try_cast_slice(weights).ok() }
    }
}

// Divided, not multiplied by a reciprocal: 255 · (1/255) need not be 1.
impl Weight for u8 {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn value<R: Real>(self) -> R {
        R::from(f32::from(self)) / R::from(255.0)
    }
}

impl Weight for u16 {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn value<R: Real>(self) -> R {
        R::from(f32::from(self)) / R::from(65535.0)
    }
}

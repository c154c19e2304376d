//! [`Time`]: the numbers that times of points may be; and the clock that makes seconds of them.

use crate::TrajectoryError;

/// A time of a point, in whole or broken units of a clock: `f32`, `f64`, `u32`, `u64` or `i64`.
/// Sealed.
///
/// Numbers of 64 bits count exactly up to 2⁵³ units, which is 104 days of nanoseconds.
pub trait Time: Copy + Send + Sync + sealed::Sealed {
    /// The nearest `f64`.
    fn count(self) -> f64;
}

mod sealed {
    pub trait Sealed {}
}

macro_rules! times {
    ($($number:ty)*) => {$(
        impl sealed::Sealed for $number {}
        impl Time for $number {
            #[inline(always)]
            #[allow(clippy::cast_lossless, reason = "some are")]
            fn count(self) -> f64 {
                self as f64
            }
        }
    )*};
}
times!(f32 f64 u32 u64 i64);

/// A time t of a point is the stamp origin + unit · t, in seconds.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Clock {
    pub(crate) origin: f64,
    pub(crate) unit: f64,
}

impl Clock {
    pub(crate) fn check(self) -> Result<(), TrajectoryError> {
        let Self { origin, unit } = self;
        match [origin, unit].into_iter().find(|number| !number.is_finite()) {
            Some(value) => Err(TrajectoryError::Clock { value }),
            None if unit == 0.0 => Err(TrajectoryError::Clock { value: unit }),
            None => Ok(()),
        }
    }

    /// The time on the clock of the stamps, in seconds.
    #[inline(always)]
    pub(crate) fn stamp(self, time: impl Time) -> f64 {
        time.count() * self.unit + self.origin
    }

    /// The seconds since the stamp `start`, whose difference from the origin is taken first: of two
    /// large stamps nothing is lost.
    #[inline(always)]
    pub(crate) fn since(self, start: f64, time: impl Time) -> f64 {
        time.count() * self.unit + (self.origin - start)
    }
}

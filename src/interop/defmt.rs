//! Formats for the logs of firmware: every type is written as an array of its components, in the
//! order of memory.

use crate::geometry::Twist;
use crate::number::Real;
use crate::representation::RotationTranslation;
use crate::scalar::{DualQuat, Quat};
use defmt::{Format, Formatter};

macro_rules! format {
    ($($thing:ident)*) => {$(
        impl<R: Real + Format> Format for $thing<R> {
            fn format(&self, f: Formatter<'_>) {
                self.to_array().format(f);
            }
        }
    )*};
}
format! { Quat DualQuat RotationTranslation Twist }

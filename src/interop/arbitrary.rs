//! Values with arbitrary bits, including infinities and NaN, for fuzzers. [`DualQuat::normalize`]
//! makes unit motions of them.

use crate::geometry::Twist;
use crate::number::Real;
use crate::representation::RotationTranslation;
use crate::scalar::{DualQuat, Quat};
use arbitrary::{Arbitrary, Result, Unstructured};

macro_rules! any {
    ($($thing:ident)*) => {$(
        impl<'a, R: Real + Arbitrary<'a>> Arbitrary<'a> for $thing<R> {
            fn arbitrary(bytes: &mut Unstructured<'a>) -> Result<Self> {
                Ok(Self::from_array(bytes.arbitrary()?))
            }
        }
    )*};
}
any! { Quat DualQuat RotationTranslation Twist }

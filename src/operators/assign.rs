//! `+=`, `-=`, `*=`, `/=`: `a *= b` is a = ab, so b comes first.

use crate::geometry::{DualVector, Twist};
use crate::number::Real;
use crate::representation::{Affine, RotationTranslation};
use crate::scalar::{Dual, DualQuat, Quat};
use core::ops::{AddAssign, DivAssign, MulAssign, SubAssign};

macro_rules! assign {
    ($($thing:ident: $($trait:ident $method:ident $operator:tt),*;)*) => {$($(
        impl<R: Real> $trait for $thing<R> {
            #[inline]
            fn $method(&mut self, other: Self) {
                *self = *self $operator other;
            }
        }
    )*)*};
}
assign! {
    Dual: AddAssign add_assign +, SubAssign sub_assign -, MulAssign mul_assign *, DivAssign div_assign /;
    Quat: AddAssign add_assign +, SubAssign sub_assign -, MulAssign mul_assign *;
    DualQuat: AddAssign add_assign +, SubAssign sub_assign -, MulAssign mul_assign *;
    RotationTranslation: MulAssign mul_assign *;
    Affine: MulAssign mul_assign *;
    Twist: AddAssign add_assign +, SubAssign sub_assign -;
    DualVector: AddAssign add_assign +, SubAssign sub_assign -;
}

//! Components by number, in the order of memory. Like those of arrays, a number that is too large
//! panics.

use crate::number::Real;
use crate::scalar::{DualQuat, Quat};
use core::ops::{Index, IndexMut};

macro_rules! index {
    ($($thing:ident: $order:literal;)*) => {$(
        #[doc = $order]
        ///
        /// # Panics
        /// Beyond the last component.
        impl<R: Real> Index<usize> for $thing<R> {
            type Output = R;
            #[inline]
            #[track_caller]
            fn index(&self, component: usize) -> &R {
                &self.as_ref()[component]
            }
        }
        #[doc = $order]
        ///
        /// # Panics
        /// Beyond the last component.
        impl<R: Real> IndexMut<usize> for $thing<R> {
            #[inline]
            #[track_caller]
            fn index_mut(&mut self, component: usize) -> &mut R {
                &mut self.as_mut()[component]
            }
        }
    )*};
}
index! {
    Quat: "`[x, y, z, w]`";
    DualQuat: "`[px, py, pz, pw, qx, qy, qz, qw]`";
}

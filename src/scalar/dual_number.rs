use super::Dual;
use crate::contract::sealed::Sealed;
use crate::contract::{DualNumber, delegate_dual_number};
use crate::number::Real;

impl<R: Real> Sealed for Dual<R> {}

impl<R: Real> DualNumber for Dual<R> {
    type Real = R;

    #[inline]
    fn parts(self) -> [R; 2] {
        [self.real, self.dual]
    }
    delegate_dual_number!();
}

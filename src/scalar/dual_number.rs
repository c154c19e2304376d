use super::Dual;
use crate::dual_number::{DualNumber, delegate_dual_number};
use crate::real::Real;
use crate::shared_trait::sealed::Sealed;

impl<R: Real> Sealed for Dual<R> {}

impl<R: Real> DualNumber for Dual<R> {
    type Real = R;

    #[inline]
    fn parts(self) -> [R; 2] {
        [self.real, self.dual]
    }
    delegate_dual_number!();
}

use super::Dual;
use crate::dual_number::{DualNumber, delegate_dual_number};
use crate::shared_trait::sealed::Sealed;
use dq8_simd::Lanes;

impl<L: Lanes> Sealed for Dual<L> {}

impl<L: Lanes> DualNumber for Dual<L> {
    type Real = L;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn parts(self) -> [L; 2] {
        [self.real, self.dual]
    }
    delegate_dual_number!();
}

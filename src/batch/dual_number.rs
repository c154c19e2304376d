use super::Dual;
use crate::contract::sealed::Sealed;
use crate::contract::{DualNumber, delegate_dual_number};
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

//! Parts of very different sizes.

use crate::only;
use dq8_contract::implementation::implementations;

/// 1.5·2ⁿ, in two steps: `powi` goes by way of 2⁻ⁿ, which may be no number.
fn number(exponent: i32) -> f64 {
    let half = exponent / 2;
    1.5 * 2.0_f64.powi(half) * 2.0_f64.powi(exponent - half)
}

/// Near the smallest numbers, and where the real part is large: nothing on the way may vanish.
#[test]
fn a_small_dual_part_keeps_its_digits_whatever_the_size_of_the_real_one() {
    for on in implementations() {
        let [(small, tiny), (large, less)] =
            if on.single { [(-63, -133), (41, -80)] } else { [(-410, -1060), (401, -600)] };
        for (real, dual) in [(small, tiny), (large, less)] {
            let sigma = on.same([0.0, 0.0, 0.0, 2.0_f64.powi(real), number(dual), 0.0, 0.0, 0.0]);
            let wanted = [0.0, 0.0, 0.0, 1.0, number(dual - real), 0.0, 0.0, 0.0];
            assert_eq!(only(sigma.normalize()), wanted, "{on:?}");
        }
        let sigma = on.same([0.0, 0.0, 0.0, 2.0_f64.powi(small), number(tiny), 0.0, 0.0, 0.0]);
        let [.., w, x, _, _, _] = only(sigma.inverse());
        assert_eq!([w, x], [2.0_f64.powi(-small), -number(tiny - 2 * small)], "{on:?}");
    }
}

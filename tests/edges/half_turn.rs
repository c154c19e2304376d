//! Half a turn, whose axis has two directions.

use super::only;
use dq8_contract::implementation::implementations;

#[test]
fn a_motion_and_its_negative_have_one_logarithm_and_one_power() {
    for on in implementations() {
        for [x, y, z] in [[0.6, 0.0, -0.8], [0.0, 0.6, -0.8], [0.0, 0.0, 1.0]] {
            for w in [0.0, -0.0] {
                let sigma = [x, y, z, w, 0.8 * y, -0.8 * x, 0.0, 0.5];
                let [a, b] = [1.0, -1.0].map(|sign| on.same(sigma.map(|c| sign * c)));
                let [one, other] = [a, b].map(|it| it.log());
                let [one, other] =
                    [one, other].map(|it| (it.real.map(|c| c.first()), it.dual.map(|c| c.first())));
                assert_eq!(one, other, "{on:?}");
                assert!(one.0.into_iter().find(|&c| c != 0.0) > Some(0.0), "{on:?}: {one:?}");
                let [one, other] = [a, b].map(|it| only(it.pow(on.splat(0.3))));
                assert_eq!(one, other, "{on:?}");
            }
        }
    }
}

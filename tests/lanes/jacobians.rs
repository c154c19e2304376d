//! Jacobians as matrices.

use super::scene::cases;
use super::{Provable, columns, measure, row};
use dq8::{DualQuat, Twist, batch};
use dq8_contract::bound::{exact, rounded};
use dq8_contract::ledger::{Ledger, line};
use dq8_contract::on_every_lane_type;

fn jacobians_agree<L: Provable>(ledger: &Ledger) {
    for chunk in cases().chunks(L::LANES) {
        let (v, w) = (columns::<L, _, 3>(chunk, |case| case.v), columns(chunk, |case| case.w));
        let twist = Twist { angular: v, linear: w };
        let jacobian = batch::DualQuat::left_jacobian_matrix(twist);
        let undone = batch::DualQuat::left_jacobian_inverse_matrix(twist);
        for (index, case) in chunk.iter().enumerate() {
            let twist = Twist { angular: rounded(case.v), linear: rounded(case.w) };
            let wanted = DualQuat::<L::Real>::left_jacobian_matrix(twist);
            let inverse = DualQuat::left_jacobian_inverse_matrix(twist);
            let got = jacobian.into_iter().chain(undone);
            for (got, wanted) in got.zip(wanted.into_iter().chain(inverse)) {
                let (got, wanted) = (row(got, index), exact(wanted));
                measure::<L, 6>(ledger, ("Jacobian", ""), got, wanted, 10.0, case);
            }
        }
    }
}

#[test]
fn matrices_of_jacobians_on_lanes_are_those_of_the_scalar_reference() {
    let bounds = [line("Jacobian", &[], 0.8, "polynomials for series")];
    Ledger::keep("Jacobians", &bounds, |ledger| on_every_lane_type!(jacobians_agree(ledger)));
}

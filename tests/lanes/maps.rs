//! Poses, and Jacobians as matrices.

use super::scene::{cases, motion, motions};
use super::{Provable, columns, exact, measure, on_every_level, rounded, row};
use dq8::representation::RotationTranslation;
use dq8::{DualQuat, Twist, batch};
use dq8_contract::ledger::{Ledger, line};
use dq8_contract::sample::Proof;

fn maps_agree<L: Provable>(ledger: &Ledger) {
    for chunk in cases().chunks(L::LANES) {
        let a = motions::<L>(chunk, |case| case.a);
        let (v, w) = (columns::<L, _, 3>(chunk, |case| case.v), columns(chunk, |case| case.w));
        let pose = batch::RotationTranslation::from(a);
        let same = pose * batch::RotationTranslation::identity(<L::Level as Proof>::proof());
        let back = batch::DualQuat::from(batch::RotationTranslation::from_array(same.to_array()));
        let twist = Twist { angular: v, linear: w };
        let jacobian = batch::DualQuat::left_jacobian_matrix(twist);
        let undone = batch::DualQuat::left_jacobian_inverse_matrix(twist);
        for (index, case) in chunk.iter().enumerate() {
            let wanted = RotationTranslation::from(motion::<L::Real>(case.a));
            let size = 1.0 + case.a.iter().map(|c| c.abs()).sum::<f64>();
            let got = row(same.to_array(), index);
            let name = ("RotationTranslation::from", "");
            measure::<L, 7>(ledger, name, got, exact(wanted.to_array()), size, case);
            let wanted = exact(DualQuat::from(wanted).to_array());
            let got = row(back.to_array(), index);
            measure::<L, 8>(ledger, ("DualQuat::from", ""), got, wanted, size, case);
            let twist = Twist::<L::Real> { angular: rounded(case.v), linear: rounded(case.w) };
            let wanted = DualQuat::left_jacobian_matrix(twist);
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
fn motions_are_maps_and_maps_motions_and_jacobians_matrices_as_the_scalar_reference_has_them() {
    let bounds = [
        line("RotationTranslation::from", &[], 0.8, "fused products"),
        line("DualQuat::from", &[], 0.4, "fused products"),
        line("Jacobian", &[], 0.8, "polynomials for series"),
    ];
    Ledger::keep("maps", &bounds, |ledger| on_every_level!(maps_agree, ledger));
}

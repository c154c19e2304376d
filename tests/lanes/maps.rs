//! Poses, and Jacobians as matrices.

use super::scene::{cases, motion, motions};
use super::{Provable, columns, exact, measure, on_every_level, rounded, row};
use dq8::representation::RotationTranslation;
use dq8::{DualQuat, Twist, batch};
use dq8_contract::ledger::{Ledger, line};
use dq8_contract::sample::Proof;

fn poses_agree<L: Provable>(ledger: &Ledger) {
    for chunk in cases().chunks(L::LANES) {
        let (a, b) = (motions::<L>(chunk, |case| case.a), motions(chunk, |case| case.b));
        let (v, w) = (columns::<L, _, 3>(chunk, |case| case.v), columns(chunk, |case| case.w));
        let (pose, other) =
            (batch::RotationTranslation::from(a), batch::RotationTranslation::from(b));
        let identity = batch::RotationTranslation::identity(<L::Level as Proof>::proof());
        let (product, inverse) = (pose * other * identity, pose.inverse());
        let same = batch::RotationTranslation::from_array(pose.to_array());
        let back = batch::DualQuat::from(same);
        let twist = Twist { angular: v, linear: w };
        let jacobian = batch::DualQuat::left_jacobian_matrix(twist);
        let undone = batch::DualQuat::left_jacobian_inverse_matrix(twist);
        for (index, case) in chunk.iter().enumerate() {
            let (a, b) = (motion::<L::Real>(case.a), motion::<L::Real>(case.b));
            let (v, w) = (rounded(case.v), rounded(case.w));
            let (by_pose, by_other) = (RotationTranslation::from(a), RotationTranslation::from(b));
            let size = 1.0 + case.a.iter().chain(&case.b).map(|c| c.abs()).sum::<f64>();
            let pair = |got: batch::RotationTranslation<L>,
                        wanted: RotationTranslation<L::Real>,
                        name: &str| {
                let got = row(got.to_array(), index);
                measure::<L, 7>(ledger, (name, ""), got, exact(wanted.to_array()), size, case);
            };
            pair(pose, by_pose, "RotationTranslation::from");
            pair(product, by_pose * by_other, "RotationTranslation::mul");
            pair(inverse, by_pose.inverse(), "RotationTranslation::inverse");
            let wanted = exact(DualQuat::from(by_pose).to_array());
            let got = row(back.to_array(), index);
            measure::<L, 8>(ledger, ("DualQuat::from", ""), got, wanted, size, case);
            let three = |got: [L; 3], wanted: [L::Real; 3], scale: f64, name: &str| {
                measure::<L, 3>(ledger, (name, ""), row(got, index), exact(wanted), scale, case);
            };
            let on = columns::<L, _, 3>(chunk, |case| case.v);
            let name = "RotationTranslation::apply";
            three(pose.transform_point(on), by_pose.transform_point(v), size, name);
            three(pose.transform_vector(on), by_pose.transform_vector(v), size, name);
            let twist = Twist { angular: v, linear: w };
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
fn poses_and_jacobians_on_lanes_are_those_of_the_scalar_reference() {
    #[rustfmt::skip]
    let bounds = [
        line("RotationTranslation::from", &[], 0.8, "fused products"),
        line("RotationTranslation::mul", &[], 1.2, "fused products"),
        line("RotationTranslation::inverse", &[], 1.2, "fused products"),
        line("RotationTranslation::apply", &[], 3.2, "fused products"),
        line("DualQuat::from", &[], 0.4, "fused products"),
        line("Jacobian", &[], 0.8, "polynomials for series"),
    ];
    Ledger::keep("poses", &bounds, |ledger| on_every_level!(poses_agree, ledger));
}

//! Derivatives of forward kinematics and of interpolations: dual and hyper-dual numbers against
//! screws and finite differences.

use crate::inputs::{assert_close, motion, reals, twist};
use dq8::{Dual, DualQuat, Quat, Real, Twist};
use lab::hessian::{Derivatives, bracket, column_derivative, columns, seeded};
use lab::{Arm, HyperDual, hyper_dual};
use proptest::prelude::*;

type Part = fn(HyperDual<f64>) -> f64;

fn part(pose: DualQuat<HyperDual<f64>>, of: Part) -> DualQuat<f64> {
    DualQuat::from_array(pose.to_array().map(of))
}

proptest! {
    #[test]
    fn first_derivatives_by_hyper_dual_numbers_are_the_geometric_jacobian(q in reals::<6>(3.0)) {
        let arm = Arm::example();
        let columns = columns(&arm, q).unwrap();
        for (i, column) in columns.into_iter().enumerate() {
            let pose = arm.pose(seeded(q, i, i, 1.0));
            let (sigma, rate) = (part(pose, |c| c.real.real), part(pose, |c| c.dual.real));
            let spatial = sigma.spatial_twist(rate);
            assert_close(spatial.to_array(), column.to_array(), 4e-15);
            // The body Jacobian is the same columns seen from the effector.
            let body = sigma.conjugate().adjoint(column);
            assert_close(sigma.body_twist(rate).to_array(), body.to_array(), 8e-15);
            prop_assert_eq!(rate, part(pose, |c| c.real.dual));
        }
    }

    /// 2 ∂ᵢ∂ⱼσ σ* = ∂ⱼJᵢ + ½JᵢJⱼ, whose vector part is ½[Jⱼ, Jᵢ] for j
    /// ≤ i.
    #[test]
    fn second_derivatives_of_the_pose_are_half_the_brackets_of_screws(q in reals::<6>(3.0)) {
        let arm = Arm::example();
        let columns = columns(&arm, q).unwrap();
        for i in 0..6 {
            for j in 0..=i {
                let pose = arm.pose(seeded(q, i, j, 1.0));
                let (sigma, mixed) = (part(pose, |c| c.real.real), part(pose, |c| c.dual.dual));
                let wanted = bracket(columns[j], columns[i]).scale(0.5);
                assert_close(sigma.spatial_twist(mixed).to_array(), wanted.to_array(), 4e-15);
            }
        }
    }

    #[test]
    fn the_hessian_by_hyper_dual_numbers_is_that_by_brackets(q in reals::<6>(3.0)) {
        let arm = Arm::example();
        let screws = Derivatives::by_screws(&arm, q).unwrap();
        // Any step, and no step loses digits.
        for step in [1e-100, 1e-8, 1.0, 1e8] {
            let numbers = Derivatives::by_hyper_dual_numbers(&arm, q, step);
            let [first, second] = numbers.distances(&screws);
            prop_assert!(first < 4e-15 && second < 4e-15, "{step}: {first:e}, {second:e}");
        }
    }

    #[test]
    fn the_hessian_by_hyper_dual_numbers_is_that_by_differences(q in reals::<6>(3.0)) {
        let arm = Arm::example();
        let numbers = Derivatives::by_hyper_dual_numbers(&arm, q, 1.0);
        let [first, _] = Derivatives::by_central_differences(&arm, q, 1e-5).distances(&numbers);
        let [_, second] = Derivatives::by_central_differences(&arm, q, 1e-4).distances(&numbers);
        prop_assert!(first < 1e-10 && second < 1e-7, "{first:e}, {second:e}");
    }

    /// The change of a column, by differentiating the Jacobian itself.
    #[test]
    fn columns_change_by_the_bracket_with_the_joints_before(q in reals::<6>(3.0)) {
        let arm = Arm::example();
        let at = |q| columns(&arm, q).unwrap();
        let (now, h) = (at(q), 1e-5);
        for j in 0..6 {
            let [mut after, mut before] = [q; 2];
            after[j] += h;
            before[j] -= h;
            let (after, before) = (at(after), at(before));
            for i in 0..6 {
                let difference = (after[i] - before[i]).scale(0.5 / h).to_array();
                assert_close(column_derivative(&now, i, j).to_array(), difference, 4e-10);
            }
        }
    }

    /// [x, y] = xy − yx over two, as dual quaternions without scalar parts.
    #[test]
    fn the_bracket_is_half_the_commutator(x in twist(2.0), y in twist(2.0)) {
        let pure = |x: Twist<f64>| {
            let [a, b] = [x.angular, x.linear].map(|v| Quat::from_parts(v, 0.0));
            DualQuat::new(a, b)
        };
        let commutator = (pure(x) * pure(y) - pure(y) * pure(x)).scale(0.5);
        assert_close(pure(bracket(x, y)).to_array(), commutator.to_array(), 0.0);
    }

    /// ScLERP is a constant twist; that is what its derivative by t says.
    #[test]
    fn the_derivative_of_sclerp_by_t_is_the_constant_twist(
        a in motion(), b in motion(), t in 0.05..1.0,
    ) {
        let apart = (a.conjugate() * b).to_twist();
        let [from, to] = [a, b].map(|sigma| {
            DualQuat::from_array(sigma.to_array().map(|c| Dual::new(c, 0.0)))
        });
        let path = from.sclerp(to, Dual::new(t, 1.0)).to_array();
        let sigma = DualQuat::from_array(path.map(|c| c.real));
        let rate = DualQuat::from_array(path.map(|c| c.dual));
        let [x, y, z] = (a.conjugate() * b).canonical().real().xyz();
        prop_assume!(x * x + y * y + z * z > 1e-4);
        assert_close(sigma.body_twist(rate).to_array(), apart.to_array(), 8e-14);
        // Its second derivative, by hyper-dual numbers: σ̈ = ½σ̇ξ.
        let [from, to] = [a, b].map(|sigma| {
            DualQuat::from_array(sigma.to_array().map(HyperDual::from_f64))
        });
        let path = from.sclerp(to, hyper_dual(t, 1.0, 1.0, 0.0));
        let wanted = part(path, |c| c.dual.real).derivative_body(apart);
        assert_close(part(path, |c| c.dual.dual).to_array(), wanted.to_array(), 8e-13);
    }
}

#[test]
fn an_arm_at_rest_has_derivatives() {
    let arm = Arm::example();
    let numbers = Derivatives::by_hyper_dual_numbers(&arm, [0.0; 6], 1.0);
    let screws = Derivatives::by_screws(&arm, [0.0; 6]).unwrap();
    let [first, second] = numbers.distances(&screws);
    assert!(first < 1e-15 && second < 1e-15, "{first:e}, {second:e}");
}

/// The V: the error falls as h² until rounding rises as 1/h and 1/h².
#[test]
fn finite_differences_have_a_best_step_and_hyper_dual_numbers_need_none() {
    let arm = Arm::example();
    let q = [0.3, -0.8, 1.2, 0.5, -0.4, 2.0];
    let screws = Derivatives::by_screws(&arm, q).unwrap();
    let error = |h| Derivatives::by_central_differences(&arm, q, h).distances(&screws);
    let ([far, far_second], [near, near_second]) = (error(1e-1), error(1e-2));
    assert!((far / near - 100.0).abs() < 2.0 && (far_second / near_second - 100.0).abs() < 2.0);
    let steps = (0..=24).map(|n| 10_f64.powf(-f64::from(n) / 2.0));
    let best = steps
        .map(error)
        .fold([f64::INFINITY; 2], |best, error| [best[0].min(error[0]), best[1].min(error[1])]);
    assert!((1e-13..1e-10).contains(&best[0]), "{best:?}");
    assert!((1e-10..1e-7).contains(&best[1]), "{best:?}");
    assert!(error(1e-12)[1] > 1e3, "rounding over h²");
    let [first, second] = Derivatives::by_hyper_dual_numbers(&arm, q, 1e-12).distances(&screws);
    assert!(first < 1e-15 && second < 2e-15, "{first:e}, {second:e}");
}

/// At t = 0 no turn has been made, so there is no axis: not even the value survives the division of
/// an infinitesimal by itself.
#[test]
fn sclerp_by_dual_numbers_is_nan_at_its_start() {
    let [from, to] = [0.0_f64, 1.0].map(|angle| {
        let turn = Quat::from_axis_angle([0.0, 0.0, 1.0], angle);
        DualQuat::from_array(DualQuat::from_rotation(turn).to_array().map(|c| Dual::new(c, 0.0)))
    });
    let start = from.sclerp(to, Dual::new(0.0, 1.0)).to_array();
    assert!(start.iter().all(|c| c.is_nan()));
    let constant = from.sclerp(to, Dual::new(0.0, 0.0)).to_array();
    assert!(constant.iter().all(|c| c.real.is_finite()));
}

#[test]
fn the_experiments_are_written_up_with_table_and_chart() {
    for section in [lab::forward_kinematics::section, lab::differentiation::section] {
        let section = section().unwrap();
        assert!(section.body.contains("<table>") && section.body.contains("<svg"));
        assert!(!section.body.contains("NaN"), "{}", section.title);
    }
}

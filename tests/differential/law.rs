//! Laws of twists, on every implementation: two ways to the same numbers.

use dq8::Twist;
use dq8_contract::bound::Kind;
use dq8_contract::case::Case;
use dq8_contract::inputs::twist_cases;
use dq8_contract::law::{self, Sides};
use dq8_contract::laws;

/// Twists clearly below a whole turn, where the inverse Jacobians are infinite.
fn turns() -> Vec<Case> {
    twist_cases().into_iter().filter(|case| case.angle() < 6.25).collect()
}

laws! {
    #[test]
    fn the_spatial_twist_undoes_its_derivative(x) -> "the twist of ½ξσ is ξ, spatial", for twist_cases(), law::step,
        within 5.0, "two products of a motion, each a sum of 7" {
        let x = x.unit();
        Sides::twists(x.a.spatial_twist(x.a.derivative_spatial(x.x)), x.x)
    }

    #[test]
    fn the_body_twist_undoes_its_derivative(x) -> "the twist of ½σξ is ξ, body", for twist_cases(), law::step,
        within 5.5, "two products of a motion, each a sum of 7" {
        let x = x.unit();
        Sides::twists(x.a.body_twist(x.a.derivative_body(x.x)), x.x)
    }

    #[test]
    fn the_adjoint_takes_body_twists_to_spatial_ones(x) -> "spatial = Ad body", for twist_cases(), law::with_derivative,
        within 9.0, "two twists of sums of 8 products, and an adjoint, whose bound is 8.5 alone" {
        let x = x.unit();
        Sides::twists(x.a.spatial_twist(x.derivative), x.a.adjoint(x.a.body_twist(x.derivative)))
    }

    #[test]
    fn the_derivatives_of_both_frames_agree(x) -> "½ξσ = ½σ Ad⁻¹ξ", for twist_cases(), law::step,
        within 5.0, "a product a side, and an adjoint" {
        let x = x.unit();
        let body = x.a.conjugate().adjoint(x.x);
        Sides::motions(x.a.derivative_spatial(x.x), x.a.derivative_body(body))
    }

    #[test]
    fn the_derivative_from_velocity_is_that_of_the_twist_at_the_origin(x)
        -> "Jia's σ̇ = ½ξσ with v = ṫ − ω × t", for twist_cases(), law::step,
        within 0.25, "the scale has |ω|, |v| and |t| as factors, of which few cases are large in all" {
        let x = x.unit();
        let linear = x.x.velocity_at(x.a.translation().map(|c| -c));
        let at_origin = Twist { angular: x.x.angular, linear };
        let jia = x.a.derivative_from_velocity(x.x.angular, x.x.linear);
        Sides::motions(jia, x.a.derivative_spatial(at_origin))
    }

    #[test]
    fn the_velocity_undoes_its_derivative(x) -> "(ω, ṫ) of Jia's σ̇", for twist_cases(), law::step,
        within 5.0, "two products of a motion and one of a translation" {
        let x = x.unit();
        let (angular, linear) = x.a.velocity(x.a.derivative_from_velocity(x.x.angular, x.x.linear));
        Sides::twists(Twist { angular, linear }, x.x)
    }

    #[test]
    fn the_twist_of_a_motion_makes_it(x) -> "from_twist(to_twist(σ)) = ±σ", for twist_cases(), law::far,
        within 8.0, "a factor and its reciprocal, each from its own function" {
        let x = x.unit();
        Sides::motions(x.on.from_twist(x.a.to_twist()), x.a.canonical())
    }

    #[test]
    fn the_twist_to_a_pose_leads_to_it(x) -> "integrate_body(a, twist_to(a, b), 1) = ±b", for twist_cases(), law::far,
        within 13.0, "two products; a factor and its reciprocal, each from its own function" {
        let x = x.unit();
        let there = x.a.integrate_body(x.a.twist_to(x.b), x.on.splat(1.0));
        Sides::same_motions(x.b, there)
    }

    #[test]
    fn steps_in_the_fixed_frame_add(x) -> "a twist for dt twice is for 2 dt, spatial", for twist_cases(), law::step,
        within 4.5, "two exponentials and two products against one of each" {
        let x = x.unit();
        let twice = x.a.integrate_spatial(x.x, x.dt).integrate_spatial(x.x, x.dt);
        Sides::motions(twice, x.a.integrate_spatial(x.x, x.dt + x.dt))
    }

    #[test]
    fn steps_in_the_moving_frame_add(x) -> "a twist for dt twice is for 2 dt, body", for twist_cases(), law::step,
        within 4.5, "two exponentials and two products against one of each" {
        let x = x.unit();
        let twice = x.a.integrate_body(x.x, x.dt).integrate_body(x.x, x.dt);
        Sides::motions(twice, x.a.integrate_body(x.x, x.dt + x.dt))
    }

    #[test]
    fn integration_may_use_either_frame(x) -> "integration in either frame", for twist_cases(), law::step,
        within 1.6, "an exponential and a product a side, and an adjoint, over a scale of several factors" {
        let x = x.unit();
        let spatial = x.a.integrate_spatial(x.a.adjoint(x.x), x.dt);
        Sides::motions(x.a.integrate_body(x.x, x.dt), spatial)
    }

    #[test]
    fn the_adjoint_of_a_product_is_the_product_of_adjoints(x) -> "Ad of a product", for twist_cases(), law::step,
        within 8.5, "two adjoints against a product and an adjoint" {
        let x = x.unit();
        Sides::twists((x.a * x.b).adjoint(x.x), x.a.adjoint(x.b.adjoint(x.x)))
    }

    #[test]
    fn the_coadjoint_of_a_product_is_the_product_of_coadjoints(x) -> "Ad* of a product", for twist_cases(), law::with_wrench,
        within 9.5, "two coadjoints against a product and a coadjoint" {
        let x = x.unit();
        Sides::wrenches((x.a * x.b).coadjoint(x.wrench), x.a.coadjoint(x.b.coadjoint(x.wrench)))
    }

    #[test]
    fn the_adjoint_of_the_inverse_undoes(x) -> "Ad of the inverse", for twist_cases(), law::step,
        within 20.0, "two adjoints of 8.5 each, and |p| is only unit to 2 u" {
        let x = x.unit();
        Sides::twists(x.a.conjugate().adjoint(x.a.adjoint(x.x)), x.x)
    }

    #[test]
    fn power_is_the_same_in_both_frames(x) -> "power is the same in both frames", for twist_cases(), law::power,
        within 0.6, "six products a side; the scale has the wrench and the twist as factors" {
        let x = x.unit();
        let moved = x.a.coadjoint(x.wrench).dot(x.a.adjoint(x.x));
        Sides::reals(Kind::Plain, &[moved], &[x.wrench.dot(x.x)])
    }

    #[test]
    fn the_left_jacobian_is_the_moved_right_one(x) -> "J_l(x) = Ad J_r(x)", for twist_cases(), law::at_twist,
        within 2.3, "two Jacobians, an exponential and an adjoint" {
        let right = x.on.from_twist(x.x).adjoint(x.on.right_jacobian(x.x, x.y));
        Sides::twists(x.on.left_jacobian(x.x, x.y), right)
    }

    #[test]
    fn jacobians_leave_their_own_twist(x) -> "J(x) x = x", for twist_cases(), law::of_twist,
        within 0.25, "the cross product of a vector with itself is all but none" {
        Sides::twists(x.on.left_jacobian(x.x, x.x), x.x)
            .and(Sides::twists(x.on.right_jacobian(x.x, x.x), x.x))
    }

    #[test]
    fn the_left_jacobian_undoes_its_inverse(x) -> "J_l J_l⁻¹ = 1", for turns(), law::inverse,
        within 0.8, "two Jacobians; what grows towards 2π is in the scale" {
        Sides::twists(x.on.left_jacobian(x.x, x.on.left_jacobian_inverse(x.x, x.y)), x.y)
    }

    #[test]
    fn the_inverse_of_the_right_jacobian_undoes_it(x) -> "J_r⁻¹ J_r = 1", for turns(), law::inverse,
        within 0.9, "two Jacobians; what grows towards 2π is in the scale" {
        Sides::twists(x.on.right_jacobian_inverse(x.x, x.on.right_jacobian(x.x, x.y)), x.y)
    }
}

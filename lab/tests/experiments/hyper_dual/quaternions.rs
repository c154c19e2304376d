//! Arends, chapter 5, §§2–6: hyper-dual quaternions and what they move.

use crate::inputs::{assert_close, motion, reals, twist};
use dq8::{Dual, DualQuat, Quat};
use lab::arends::hyper_side_by_side;
use lab::{HyperDual, HyperDualQuat, hyper_dual_parts as parts};
use proptest::prelude::*;

type Four = HyperDualQuat<f64>;

fn any_four() -> impl Strategy<Value = Four> {
    reals::<16>(1.0).prop_map(|c| {
        let part = |i: usize| Quat::from_xyzw(c[i], c[i + 1], c[i + 2], c[i + 3]);
        Four::new(part(0), part(4), part(8), part(12))
    })
}

fn invertible_four() -> impl Strategy<Value = Four> {
    any_four().prop_filter("a real part", |x| x.real.norm() > 0.25)
}

fn rotation() -> impl Strategy<Value = Quat<f64>> {
    motion().prop_map(DualQuat::rotation)
}

fn components(x: Four) -> [f64; 16] {
    let parts = [x.real, x.first, x.second, x.mixed].map(Quat::to_array);
    core::array::from_fn(|i| parts[i / 4][i % 4])
}

fn nested(x: Four) -> Quat<HyperDual<f64>> {
    x.into()
}

/// ε₁ε₂ for ε.
fn of_dual_quat(sigma: DualQuat<f64>) -> Four {
    Four { mixed: sigma.dual(), ..Four::from_rotation(sigma.real()) }
}

proptest! {
    #[test]
    fn section_2_four_quaternions_are_one_quaternion_of_hyper_dual_numbers(
        x in invertible_four(), y in any_four(),
    ) {
        let same = |found: Four, nested: Quat<HyperDual<f64>>| {
            assert_close(components(found), components(nested.into()), 2e-15);
        };
        prop_assert_eq!(Four::from(nested(x)), x);
        same(x + y, nested(x) + nested(y));
        same(x - y, nested(x) - nested(y));
        same(-x, -nested(x));
        same(x * y, nested(x) * nested(y));
        same(x.conjugate(), nested(x).conjugate());
        let norm_squared = nested(x).dot(nested(x));
        let found = x.norm_squared();
        assert_close(parts(found), parts(norm_squared), 4e-15);
        // q⁻¹ = q*/(qq*), a division of hyper-dual numbers.
        let inverse = nested(x).conjugate().scale(norm_squared.recip());
        let inverse = components(inverse.into());
        let size = inverse.into_iter().fold(1.0, |size: f64, c| size.max(c.abs()));
        assert_close(components(x.inverse().unwrap()), inverse, 1e-14 * size);
    }

    #[test]
    fn section_2_the_inverse_exists_for_every_real_part_but_zero(x in invertible_four()) {
        let inverse = x.inverse().unwrap();
        let size = components(inverse).into_iter().fold(1.0, |size: f64, c| size.max(c.abs()));
        for product in [x * inverse, inverse * x] {
            assert_close(components(product), components(Four::IDENTITY), 4e-15 * size);
        }
        for real in [Quat::ZERO, Quat::from_array([f64::NAN; 4])] {
            let without = Four { real, ..x };
            prop_assert!(without.inverse().is_none());
        }
    }

    #[test]
    fn conjugates_of_products_are_products_turned_round(x in any_four(), y in any_four()) {
        for conjugate in [Four::conjugate, Four::conjugate_first, Four::conjugate_second] {
            let found = components(conjugate(x * y));
            assert_close(found, components(conjugate(y) * conjugate(x)), 4e-15);
        }
    }

    /// (xy)† − y†x† = −2 (bc′ + cb′)* ε₁ε₂: −ε₁ times −ε₂ is
    /// ε₁ε₂, but his dagger has −ε₁ε₂.
    #[test]
    fn section_2_erratum_the_dagger_of_a_product_is_not_the_product_of_daggers_turned_round(
        x in any_four(), y in any_four(),
    ) {
        let difference = (x * y).dagger() - y.dagger() * x.dagger();
        let crossed = (x.first * y.second + x.second * y.first).conjugate().scale(-2.0);
        let wanted = Four::new(Quat::ZERO, Quat::ZERO, Quat::ZERO, crossed);
        assert_close(components(difference), components(wanted), 4e-15);
        // Where only a and d are used, as he does, it is.
        let [x, y] = [x, y].map(|x| Four { first: Quat::ZERO, second: Quat::ZERO, ..x });
        let turned_round = y.dagger() * x.dagger();
        assert_close(components((x * y).dagger()), components(turned_round), 4e-15);
        prop_assert_eq!(x.dagger(), x.conjugate_first());
    }

    #[test]
    fn section_3_rotations_turn_points(r in rotation(), v in reals(2.0)) {
        assert_close(Four::from_rotation(r).transform_point(v), r.rotate(v), 4e-15);
    }

    #[test]
    fn section_4_translations_move_points(t in reals::<3>(2.0), v in reals::<3>(2.0)) {
        let moved = core::array::from_fn(|i| v[i] + t[i]);
        assert_close(Four::from_translation(t).transform_point(v), moved, 1e-15);
    }

    #[test]
    fn section_4_rotation_and_translation_as_his_code_has_them(
        r in rotation(), t in reals(2.0), v in reals(2.0),
    ) {
        let sigma = DualQuat::from_rotation_translation(r, t);
        let x = Four::from_rotation_translation(r, t);
        assert_close(x.transform_point(v), sigma.transform_point(v), 8e-15);
        let product = Four::from_translation(t) * Four::from_rotation(r);
        assert_close(components(x), components(product), 1e-15);
    }

    /// Printed: (cos, n sin) + ½tε₁ε₂. It moves by ½(tr* + rt) = cos(θ/2) t + sin(θ/2) n
    /// × t.
    #[test]
    fn section_4_erratum_the_printed_sum_translates_by_something_else(
        r in rotation(), t in reals::<3>(2.0),
    ) {
        let printed = hyper_side_by_side(r, t);
        let [x, y, z] = r.xyz();
        let across = [y * t[2] - z * t[1], z * t[0] - x * t[2], x * t[1] - y * t[0]];
        let wanted = core::array::from_fn(|i| r.w() * t[i] + across[i]);
        assert_close(printed.transform_point([0.0; 3]), wanted, 1e-15);
    }

    /// His use of them, with b and c zero, is the dual quaternions over again.
    #[test]
    fn section_5_with_two_of_the_four_they_are_the_dual_quaternions(
        s in motion(), u in motion(), v in reals(2.0),
    ) {
        let product = of_dual_quat(s) * of_dual_quat(u);
        // Relative to the translations, as all bounds of motions.
        let size = |m: DualQuat<f64>| m.translation().into_iter().fold(0.0, |sum, c| sum + c.abs());
        let same = |x: Four, y: Four, size: f64| {
            let relative = |x: Four| components(x).map(|c| c / (1.0 + size));
            assert_close(relative(x), relative(y), 1e-15);
        };
        same(product, of_dual_quat(s * u), size(s) + size(u));
        assert_close(product.transform_point(v), (s * u).transform_point(v), 4e-15);
        let inverse = of_dual_quat(s).inverse().unwrap();
        same(inverse, of_dual_quat(s.inverse()), size(s));
    }

    /// Whatever stands in the four quaternions, and by whichever conjugate: v ↦ |a|²Rv +
    /// constant.
    #[test]
    fn section_6_no_hyper_dual_quaternion_shears_or_scales_unevenly(
        x in any_four(), v in reals::<3>(2.0),
    ) {
        let conjugates = [Four::dagger, Four::conjugate, Four::conjugate_first, Four::conjugate_second];
        for conjugate in conjugates {
            let image = |v| (x * Four::point(v) * conjugate(x)).mixed.xyz();
            let (origin, moved) = (image([0.0; 3]), image(v));
            let pure = Quat::from_parts(v, 0.0);
            let turned = (x.real * pure * x.real.conjugate()).xyz();
            let wanted = core::array::from_fn(|i| origin[i] + turned[i]);
            assert_close(moved, wanted, 2e-14);
        }
    }

    /// Two moves of his, one after the other, are not the move of their product once b and c are
    /// used.
    #[test]
    fn section_5_erratum_using_all_four_with_the_dagger_breaks_composition(t in 0.1_f64..1.0) {
        let pure = |x, y, z| Quat::from_xyzw(x, y, z, 0.0);
        let x = Four { first: pure(t, 0.0, 0.0), ..Four::IDENTITY };
        let y = Four { second: pure(0.0, t, 0.0), ..Four::IDENTITY };
        let point = Four::point([0.0; 3]);
        let once = (x * y) * point * (x * y).dagger();
        let twice = x * (y * point * y.dagger()) * x.dagger();
        assert_close((once - twice).mixed.to_array(), [0.0, 0.0, 2.0 * t * t, 0.0], 1e-15);
        let once = (x * y) * point * (x * y).conjugate_first();
        let twice = x * (y * point * y.conjugate_first()) * x.conjugate_first();
        assert_close(components(once), components(twice), 1e-15);
    }

    /// What the second unit does buy: a motion with its rate, and the product rule for nothing.
    #[test]
    fn a_hyper_dual_quaternion_is_a_motion_with_its_rate(
        s in motion(), u in motion(), xi in twist(2.0), eta in twist(2.0), v in reals(2.0), w in reals(2.0),
    ) {
        let moving = |sigma: DualQuat<f64>, xi| {
            let rate = sigma.derivative_spatial(xi);
            let [p, q] = [sigma, rate].map(DualQuat::to_array);
            let dual = DualQuat::from_array(core::array::from_fn(|i| Dual::new(p[i], q[i])));
            (Four::from_moving(sigma, rate), dual)
        };
        let ((x, x_dual), (y, y_dual)) = (moving(s, xi), moving(u, eta));
        let (sigma, rate) = (x * y).to_moving();
        // dq8 with dual numbers for numbers, the other way to write it.
        let product = (x_dual * y_dual).to_array();
        assert_close(sigma.to_array(), product.map(|c| c.real), 2e-15);
        assert_close(rate.to_array(), product.map(|c| c.dual), 5e-15);
        // Twists add, the second seen from the first.
        let sum = (xi + s.adjoint(eta)).to_array();
        assert_close(sigma.spatial_twist(rate).to_array(), sum, 5e-14);
        let (point, velocity) = x.transform_moving_point(v, w);
        let moved = x_dual.transform_point(core::array::from_fn(|i| Dual::new(v[i], w[i])));
        assert_close(point, moved.map(|c| c.real), 5e-15);
        assert_close(velocity, moved.map(|c| c.dual), 1e-14);
    }
}

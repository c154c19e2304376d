//! The laws in the documentation of [`Motion`](dq8::Motion), on every implementation: for what, on
//! which scale, how far the two sides may lie apart, and why. Those of twists are in
//! `differential/law.rs`.

use dq8::{Line, Plane};
use dq8_contract::bound::Kind;
use dq8_contract::case::Case;
use dq8_contract::inputs;
use dq8_contract::lanes::{Motions, Reals};
use dq8_contract::law::{self, Sides, norm, vectors};
use dq8_contract::vector::{cross, dot};
use dq8_contract::{laws, scale};

/// Dual numbers, one a lane.
fn dual_lanes([real, dual]: [Reals; 2]) -> Vec<[f64; 2]> {
    real.lanes().into_iter().zip(dual.lanes()).map(|(real, dual)| [real, dual]).collect()
}

/// A far turn by less than that has a moment beyond the largest `f32`.
fn not_too_far() -> Vec<Case> {
    let mut cases = inputs::unit_cases();
    cases.retain(|x| norm(&x.a[..3]) == 0.0 || norm(&x.a[..3]) > 1e-32);
    cases
}

/// Cases in which one way from a to b is clearly shorter: elsewhere either is right.
fn no_ties() -> Vec<Case> {
    let mut cases = inputs::unit_cases();
    cases.retain(|x| {
        let dot: f64 = (0..4).map(|i| x.a[i] * x.b[i]).sum();
        dot.abs() > 1e-5
    });
    cases
}

laws! {
    #[test]
    fn products_associate(x) -> "(ab)c = a(bc)", for inputs::general_cases(), law::triple_product,
        within 11.0, "two products a side, summed in another order" {
        Sides::motions((x.a * x.b) * x.c, x.a * (x.b * x.c))
    }

    #[test]
    fn one_is_neutral(x) -> "a1 = 1a = a", for inputs::general_cases(), scale::product,
        within 0.0, "products with one and zero are exact" {
        Sides::motions(x.a * x.on.identity(()), x.a).and(Sides::motions(x.on.identity(()) * x.a, x.a))
    }

    #[test]
    fn products_distribute_over_sums_and_differences(x) -> "a(b + c) = ab + ac", for inputs::general_cases(), law::product_with_sum,
        within 12.0, "one product of a sum against a sum of products" {
        Sides::motions(x.a * (x.b + x.c), x.a * x.b + x.a * x.c)
            .and(Sides::motions((x.b - x.c) * x.a, x.b * x.a - x.c * x.a))
    }

    #[test]
    fn the_dual_conjugate_keeps_the_order_of_a_product(x) -> "(ab)• = a•b•", for inputs::general_cases(), scale::product,
        within 0.0, "every rounding is symmetric in the sign of q" {
        let (a, b) = (x.a.conjugate_dual(), x.b.conjugate_dual());
        Sides::motions((x.a * x.b).conjugate_dual(), a * b)
    }

    #[test]
    fn the_two_other_conjugates_turn_a_product_round(x) -> "(ab)* = b*a*, (ab)⋄ = b⋄a⋄", for inputs::general_cases(), scale::product,
        within 8.0, "one product a side, summed in another order" {
        let ab = x.a * x.b;
        Sides::motions(ab.conjugate(), x.b.conjugate() * x.a.conjugate())
            .and(Sides::motions(ab.conjugate_both(), x.b.conjugate_both() * x.a.conjugate_both()))
    }

    #[test]
    fn the_third_conjugate_is_the_two_others_and_each_undoes_itself(x) -> "σ⋄ = (σ*)•", for inputs::general_cases(), law::square,
        within 0.0, "signs" {
        Sides::motions(x.a.conjugate_both(), x.a.conjugate().conjugate_dual())
            .and(Sides::motions(x.a.conjugate_both(), x.a.conjugate_dual().conjugate()))
            .and(Sides::motions(x.a.conjugate_both().conjugate_both(), x.a))
            .and(Sides::motions(x.a.conjugate().conjugate(), x.a))
            .and(Sides::motions(x.a.conjugate_dual().conjugate_dual(), x.a))
    }

    #[test]
    fn the_norm_is_the_root_of_the_product_with_the_conjugate(x) -> "σσ* = σ*σ = norm²", for inputs::general_cases(), law::square,
        within 14.0, "a product against the square of a root" {
        let square = |[n, d]: &[f64; 2]| [0.0, 0.0, 0.0, n * n, 0.0, 0.0, 0.0, 2.0 * n * d];
        let squares: Vec<_> = dual_lanes(x.a.norm()).iter().map(square).collect();
        Sides::components((x.a * x.a.conjugate()).scatter(), squares.clone())
            .and(Sides::components((x.a.conjugate() * x.a).scatter(), squares))
    }

    #[test]
    fn the_norm_of_a_product_is_the_product_of_the_norms(x) -> "norm(ab) = norm(a) norm(b)", for inputs::general_cases(), scale::product,
        within 10.0, "three norms and a product" {
        let [a, b, ab] = [x.a, x.b, x.a * x.b].map(|m| dual_lanes(m.norm()));
        let pairs = || a.iter().zip(&b);
        let real = pairs().map(|([an, _], [bn, _])| an * bn).collect();
        let dual = pairs().map(|([an, ad], [bn, bd])| an * bd + ad * bn).collect();
        Sides::numbers(Kind::Plain, ab.iter().map(|n| n[0]).collect(), real).and(Sides::numbers(
            Kind::Length,
            ab.iter().map(|n| n[1]).collect(),
            dual,
        ))
    }

    #[test]
    fn normalize_gives_a_unit_one(x) -> "|p| = 1, p·q = 0", for inputs::general_cases(), scale::quotient,
        within 10.0, "one normalization; p·q is the difference that is left" {
        let unit = x.a.normalize().scatter();
        let (p, along): (Vec<_>, Vec<_>) = unit
            .iter()
            .map(|m| (norm(&m[..4]), (0..4).map(|i| m[i] * m[i + 4]).sum::<f64>()))
            .unzip();
        let (one, zero) = (vec![1.0; x.on.lanes], vec![0.0; x.on.lanes]);
        Sides::numbers(Kind::Plain, p, one).and(Sides::numbers(Kind::Length, along, zero))
    }

    #[test]
    fn normalize_does_not_see_a_positive_factor(x) -> "normalize(cσ) = normalize(σ)", for inputs::general_cases(), scale::quotient,
        within 12.0, "two normalizations and the product with c" {
        let [factor, ..] = x.weights;
        Sides::motions(x.a.scale(factor).normalize(), x.a.normalize())
    }

    #[test]
    fn the_inverse_undoes(x) -> "σσ⁻¹ = σ⁻¹σ = 1", for inputs::general_cases(), scale::quotient,
        within 15.0, "an inverse and a product" {
        Sides::motions(x.a * x.a.inverse(), x.on.identity(()))
            .and(Sides::motions(x.a.inverse() * x.a, x.on.identity(())))
    }

    #[test]
    fn the_inverse_of_a_unit_one_is_its_conjugate(x) -> "σ⁻¹ = σ*", for inputs::unit_cases(), law::unit_motions,
        within 22.0, "|p| is only unit to 2 u, and its square divides q" {
        let x = x.unit();
        Sides::motions(x.a.inverse(), x.a.conjugate())
    }

    #[test]
    fn rotation_and_translation_go_out_and_in(x) -> "r + ½εtr = σ", for inputs::unit_cases(), law::unit_motions,
        within 11.0, "a translation and the product with the rotation" {
        let x = x.unit();
        let (rotation, translation) = (x.a.rotation(), x.a.translation());
        let (turn, shift) = (x.on.from_rotation(rotation), x.on.from_translation(translation));
        Sides::motions(x.on.from_rotation_translation(rotation, translation), x.a)
            .and(Sides::motions(shift * turn, x.a))
            .and(Sides::motions(x.on.from_translation_rotation(translation, rotation), turn * shift))
    }

    #[test]
    fn matrices_go_out_and_in(x) -> "from_matrix(to_matrix(σ)) = ±σ", for inputs::unit_cases(), law::unit_motions,
        within 13.0, "nine products of p, and the largest sum of them divides the others" {
        let x = x.unit();
        let [r0, r1, r2, last] = x.a.to_matrix4();
        let affine = [0.0, 0.0, 0.0, 1.0].map(|c| x.on.splat(c));
        Sides::same_motions(x.a, x.on.from_matrix3x4(x.a.to_matrix3x4()))
            .and(Sides::same_motions(x.a, x.on.from_matrix3x4([r0, r1, r2])))
            .and(Sides::reals(Kind::Plain, &last, &affine))
    }

    #[test]
    fn a_product_does_what_its_factors_do_one_after_the_other(x) -> "(ab)v = a(bv)", for inputs::unit_cases(), law::unit,
        within 29.0, "an error of p counts twice on each side of v, four times here" {
        let x = x.unit();
        let ab = x.a * x.b;
        let (points, directions) = (ab.transform_point(x.v), ab.transform_vector(x.v));
        let (line, plane) = (ab.transform_line(x.line()), ab.transform_plane(x.plane()));
        let twice = x.a.transform_line(x.b.transform_line(x.line()));
        let plane_twice = x.a.transform_plane(x.b.transform_plane(x.plane()));
        let point_twice = x.a.transform_point(x.b.transform_point(x.v));
        let direction_twice = x.a.transform_vector(x.b.transform_vector(x.v));
        Sides::reals(Kind::Length, &points, &point_twice)
            .and(Sides::reals(Kind::Plain, &directions, &direction_twice))
            .and(Sides::reals(Kind::Plain, &line.direction, &twice.direction))
            .and(Sides::reals(Kind::Length, &line.moment, &twice.moment))
            .and(Sides::reals(Kind::Plain, &plane.normal, &plane_twice.normal))
            .and(Sides::reals(Kind::Length, &[plane.offset], &[plane_twice.offset]))
    }

    /// The motion's own algebra, of which the operations on points, directions and lines are short
    /// forms.
    #[test]
    fn points_and_lines_move_by_the_sandwich_product(x) -> "σ(1 + εv)σ⋄, σ(l + εm)σ*", for inputs::unit_cases(), law::unit,
        within 17.0, "two products against one rotation and a translation" {
        let x = x.unit();
        let (zero, one) = (x.on.splat(0.0), x.on.splat(1.0));
        let pure = |real: Reals, [rx, ry, rz]: [Reals; 3], [dx, dy, dz]: [Reals; 3]| {
            Motions::from_components([rx, ry, rz, real, dx, dy, dz, zero])
        };
        let (none, point) = ([zero; 3], x.a.transform_point(x.v));
        let direction = x.a.transform_vector(x.v);
        let line = x.a.transform_line(x.line());
        let of_point = x.a * pure(one, none, x.v) * x.a.conjugate_both();
        let of_direction = x.a * pure(zero, x.v, none) * x.a.conjugate();
        let of_line = x.a * pure(zero, x.v, x.w) * x.a.conjugate();
        let [dx, dy, dz, ..] = of_direction.components();
        Sides::motions(of_point, pure(one, none, point))
            .and(Sides::motions(of_line, pure(zero, line.direction, line.moment)))
            .and(Sides::reals(Kind::Plain, &[dx, dy, dz], &direction))
    }

    #[test]
    fn matrices_move_points_as_motions_do(x) -> "[R | t](v, 1) = σv", for inputs::unit_cases(), law::unit,
        within 4.0, "the same products, summed in another order" {
        let x = x.unit();
        let (points, moved) = (vectors(x.v), vectors(x.a.transform_point(x.v)));
        let rows = x.a.to_matrix3x4().map(|[x, y, z, t]| (vectors([x, y, z]), t.lanes()));
        let sides = rows.into_iter().enumerate().map(|(c, (row, t))| {
            let products = (0..x.on.lanes).map(|i| dot(row[i], points[i]) + t[i]).collect();
            Sides::numbers(Kind::Length, moved.iter().map(|m| m[c]).collect(), products)
        });
        sides.fold(Sides::default(), Sides::and)
    }

    #[test]
    fn motions_keep_distances(x) -> "|σu − σv| = |u − v|", for inputs::unit_cases(), law::unit,
        within 12.0, "|p| is only unit to 2 u, which scales all distances" {
        let x = x.unit();
        let between = |u, v| {
            let pairs = vectors(u).into_iter().zip(vectors(v));
            pairs.map(|(u, v)| norm(&[u[0] - v[0], u[1] - v[1], u[2] - v[2]])).collect()
        };
        let (u, v) = (x.a.transform_point(x.v), x.a.transform_point(x.w));
        Sides::numbers(Kind::Length, between(u, v), between(x.v, x.w))
    }

    #[test]
    fn points_stay_on_their_lines_and_planes(x) -> "x × l = m, n·x = d", for inputs::unit_cases(), law::two_vectors,
        within 30.0, "a moved point against a moved line and plane, a product of both" {
        let x = x.unit();
        let (points, directions) = (vectors(x.v), vectors(x.w));
        let pairs = || points.iter().zip(&directions);
        let moments: Vec<_> = pairs().map(|(&v, &w)| cross(v, w)).collect();
        let offsets: Vec<_> = pairs().map(|(&v, &w)| dot(v, w)).collect();
        let line = Line { direction: x.w, moment: x.on.vector(&moments) };
        let plane = Plane { normal: x.w, offset: x.on.reals(&offsets) };

        let points = vectors(x.a.transform_point(x.v));
        let (line, plane) = (x.a.transform_line(line), x.a.transform_plane(plane));
        let directions = vectors(line.direction).into_iter();
        let moments: Vec<_> = points.iter().zip(directions).map(|(&v, l)| cross(v, l)).collect();
        let normals = vectors(plane.normal).into_iter();
        let offsets: Vec<_> = points.iter().zip(normals).map(|(&v, n)| dot(v, n)).collect();
        Sides::reals(Kind::Length, &line.moment, &x.on.vector(&moments)).and(Sides::numbers(
            Kind::Length,
            plane.offset.lanes(),
            offsets,
        ))
    }

    #[test]
    fn the_exponential_undoes_the_logarithm(x) -> "exp(log σ) = ±σ", for inputs::unit_cases(), law::small,
        within 15.0, "a factor and its reciprocal, each from its own function" {
        let x = x.unit();
        Sides::same_small_motions(x.a, x.on.exp(x.a.log()))
    }

    #[test]
    fn screws_go_out_and_in(x) -> "from_screw(to_screw(σ)) = ±σ", for not_too_far(), law::small,
        within 15.0, "axis, angle, moment and slide, each rounded, and products of them" {
        let x = x.unit();
        Sides::same_small_motions(x.a, x.on.from_screw(x.a.to_screw()))
    }

    #[test]
    fn exponents_add(x) -> "σˢσᵗ = σˢ⁺ᵗ", for inputs::unit_cases(), law::powers,
        within 6.0, "three powers and a product; the scale grows with the exponents" {
        let x = x.unit();
        Sides::motions(x.a.pow(x.s) * x.a.pow(x.t), x.a.pow(x.s + x.t))
    }

    #[test]
    fn the_first_power_is_the_motion_the_zeroth_is_one(x) -> "σ¹ = ±σ, σ⁰ = 1", for inputs::unit_cases(), law::small,
        within 15.0, "as exp(log σ)" {
        let x = x.unit();
        Sides::same_small_motions(x.a, x.a.pow(x.on.splat(1.0)))
            .and(Sides::motions(x.a.pow(x.on.splat(0.0)), x.on.identity(())))
    }

    #[test]
    fn the_root_made_twice_is_the_motion(x) -> "(√σ)² = ±σ", for inputs::unit_cases(), law::small,
        within 15.0, "a root and a product, or two ways to half a screw" {
        let x = x.unit();
        let root = x.a.sqrt();
        Sides::same_small_motions(x.a, root * root)
            .and(Sides::same_small_motions(root, x.a.pow(x.on.splat(0.5))))
    }

    #[test]
    fn interpolation_begins_at_one_motion_and_ends_at_the_other(x) -> "sclerp(a, b, 0) = a, sclerp(a, b, 1) = ±b", for inputs::unit_cases(), law::unit_motions,
        within 20.0, "at 1 the scalar way is a(a*b), which has |a|² in it" {
        let x = x.unit();
        let (zero, one) = (x.on.splat(0.0), x.on.splat(1.0));
        Sides::motions(x.a.sclerp(x.b, zero), x.a)
            .and(Sides::same_motions(x.b, x.a.sclerp(x.b, one)))
            .and(Sides::motions(x.a.nlerp(x.b, zero), x.a))
            .and(Sides::same_motions(x.b, x.a.nlerp(x.b, one)))
    }

    #[test]
    fn screw_interpolation_moves_with_its_ends(x) -> "sclerp(ca, cb, t) = c sclerp(a, b, t)", for no_ties(), law::powers,
        within 11.0, "two interpolations and three products; the scale grows with t" {
        let x = x.unit();
        let (ca, cb) = (x.c * x.a, x.c * x.b);
        Sides::motions(ca.sclerp(cb, x.t), x.c * x.a.sclerp(x.b, x.t))
    }

    #[test]
    fn screw_interpolation_is_a_power_of_the_difference(x) -> "sclerp(a, b, t) = a(a*b)ᵗ", for no_ties(), law::powers,
        within 7.0, "two products and a power against slerp about the middle, in lanes" {
        let x = x.unit();
        let power = x.a * (x.a.conjugate() * x.b).pow(x.t);
        Sides::motions(x.a.sclerp(x.b, x.t), power)
    }

    #[test]
    fn interpolation_does_not_see_the_sign_of_its_end(x) -> "sclerp(a, b, t) = sclerp(a, −b, t)", for no_ties(), law::unit_motions,
        within 0.0, "the sign is fixed before the first rounding" {
        let x = x.unit();
        Sides::motions(x.a.nlerp(x.b, x.t), x.a.nlerp(-x.b, x.t))
            .and(Sides::motions(x.a.sclerp(x.b, x.t), x.a.sclerp(-x.b, x.t)))
    }
}

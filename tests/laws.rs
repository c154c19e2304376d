//! The laws in the documentation of [`Motion`](dq8::Motion), one generic function each, on every
//! implementation. How far the two sides may lie apart is in the table `LAWS` of
//! `contract/agreement.rs`.

use dq8::{Line, Plane};
use dq8_contract::agreement::Kind;
use dq8_contract::inputs::{self, Arguments, Case};
use dq8_contract::law::{Sides, cross, dot, holds, norm, vectors};
use dq8_contract::law::{
    powers, product, product_with_sum, quotient, small, square, triple_product,
};
use dq8_contract::law::{two_vectors, unit, unit_motions};
use dq8_contract::{for_every_implementation, sample::Sample};

/// A law of all dual quaternions.
macro_rules! for_all {
    ($name:literal, $law:ident, $scale:ident) => {{
        let cases = inputs::general_cases();
        for_every_implementation!(|implementation, M| {
            holds::<M>(implementation, $name, &cases, $scale, $law);
        });
    }};
}

/// A law of unit dual quaternions.
macro_rules! for_unit {
    ($name:literal, $law:ident, $scale:ident) => {
        for_unit!(inputs::unit_cases(), $name, $law, $scale)
    };
    ($cases:expr, $name:literal, $law:ident, $scale:ident) => {{
        let cases = $cases;
        for_every_implementation!(|implementation, M| {
            holds::<M>(implementation, $name, &cases, $scale, |x| $law(&x.unit()));
        });
    }};
}

#[test]
fn products_associate() {
    fn law<M: Sample>(x: &Arguments<M>) -> Sides {
        Sides::motions((x.a * x.b) * x.c, x.a * (x.b * x.c))
    }
    for_all!("(ab)c = a(bc)", law, triple_product);
}

#[test]
fn one_is_neutral() {
    fn law<M: Sample>(x: &Arguments<M>) -> Sides {
        Sides::motions(x.a * M::one(), x.a).and(Sides::motions(M::one() * x.a, x.a))
    }
    for_all!("a1 = 1a = a", law, product);
}

#[test]
fn products_distribute_over_sums_and_differences() {
    fn law<M: Sample>(x: &Arguments<M>) -> Sides {
        Sides::motions(x.a * (x.b + x.c), x.a * x.b + x.a * x.c)
            .and(Sides::motions((x.b - x.c) * x.a, x.b * x.a - x.c * x.a))
    }
    for_all!("a(b + c) = ab + ac", law, product_with_sum);
}

#[test]
fn the_dual_conjugate_keeps_the_order_of_a_product() {
    fn law<M: Sample>(x: &Arguments<M>) -> Sides {
        let (a, b) = (x.a.conjugate_dual(), x.b.conjugate_dual());
        Sides::motions((x.a * x.b).conjugate_dual(), a * b)
    }
    for_all!("(ab)• = a•b•", law, product);
}

#[test]
fn the_two_other_conjugates_turn_a_product_round() {
    fn law<M: Sample>(x: &Arguments<M>) -> Sides {
        let ab = x.a * x.b;
        Sides::motions(ab.conjugate(), x.b.conjugate() * x.a.conjugate())
            .and(Sides::motions(ab.conjugate_both(), x.b.conjugate_both() * x.a.conjugate_both()))
    }
    for_all!("(ab)* = b*a*, (ab)⋄ = b⋄a⋄", law, product);
}

#[test]
fn the_third_conjugate_is_the_two_others_and_each_undoes_itself() {
    fn law<M: Sample>(x: &Arguments<M>) -> Sides {
        Sides::motions(x.a.conjugate_both(), x.a.conjugate().conjugate_dual())
            .and(Sides::motions(x.a.conjugate_both(), x.a.conjugate_dual().conjugate()))
            .and(Sides::motions(x.a.conjugate_both().conjugate_both(), x.a))
            .and(Sides::motions(x.a.conjugate().conjugate(), x.a))
            .and(Sides::motions(x.a.conjugate_dual().conjugate_dual(), x.a))
    }
    for_all!("σ⋄ = (σ*)•", law, square);
}

/// Dual numbers, one a lane.
fn dual_lanes<M: Sample>(dual: M::Dual) -> Vec<[f64; 2]> {
    let [real, dual] = M::dual_parts(dual).map(M::lanes);
    real.into_iter().zip(dual).map(|(real, dual)| [real, dual]).collect()
}

#[test]
fn the_norm_is_the_root_of_the_product_with_the_conjugate() {
    fn law<M: Sample>(x: &Arguments<M>) -> Sides {
        let square = |[n, d]: &[f64; 2]| [0.0, 0.0, 0.0, n * n, 0.0, 0.0, 0.0, 2.0 * n * d];
        let squares: Vec<_> = dual_lanes::<M>(x.a.norm()).iter().map(square).collect();
        Sides::components((x.a * x.a.conjugate()).scatter(), squares.clone())
            .and(Sides::components((x.a.conjugate() * x.a).scatter(), squares))
    }
    for_all!("σσ* = σ*σ = norm²", law, square);
}

#[test]
fn the_norm_of_a_product_is_the_product_of_the_norms() {
    fn law<M: Sample>(x: &Arguments<M>) -> Sides {
        let [a, b, ab] = [x.a, x.b, x.a * x.b].map(|m| dual_lanes::<M>(m.norm()));
        let pairs = || a.iter().zip(&b);
        let real = pairs().map(|([an, _], [bn, _])| an * bn).collect();
        let dual = pairs().map(|([an, ad], [bn, bd])| an * bd + ad * bn).collect();
        Sides::numbers(Kind::Plain, ab.iter().map(|n| n[0]).collect(), real).and(Sides::numbers(
            Kind::Length,
            ab.iter().map(|n| n[1]).collect(),
            dual,
        ))
    }
    for_all!("norm(ab) = norm(a) norm(b)", law, product);
}

#[test]
fn normalize_gives_a_unit_one() {
    fn law<M: Sample>(x: &Arguments<M>) -> Sides {
        let unit = x.a.normalize().scatter();
        let (p, along): (Vec<_>, Vec<_>) = unit
            .iter()
            .map(|m| (norm(&m[..4]), (0..4).map(|i| m[i] * m[i + 4]).sum::<f64>()))
            .unzip();
        let (one, zero) = (vec![1.0; M::LANES], vec![0.0; M::LANES]);
        Sides::numbers(Kind::Plain, p, one).and(Sides::numbers(Kind::Length, along, zero))
    }
    for_all!("|p| = 1, p·q = 0", law, quotient);
}

#[test]
fn normalize_does_not_see_a_positive_factor() {
    fn law<M: Sample>(x: &Arguments<M>) -> Sides {
        let [factor, ..] = x.weights;
        Sides::motions(x.a.scale(factor).normalize(), x.a.normalize())
    }
    for_all!("normalize(cσ) = normalize(σ)", law, quotient);
}

#[test]
fn the_inverse_undoes() {
    fn law<M: Sample>(x: &Arguments<M>) -> Sides {
        Sides::motions(x.a * x.a.inverse(), M::one())
            .and(Sides::motions(x.a.inverse() * x.a, M::one()))
    }
    for_all!("σσ⁻¹ = σ⁻¹σ = 1", law, quotient);
}

#[test]
fn the_inverse_of_a_unit_one_is_its_conjugate() {
    fn law<M: Sample>(x: &Arguments<M>) -> Sides {
        Sides::motions(x.a.inverse(), x.a.conjugate())
    }
    for_unit!("σ⁻¹ = σ*", law, unit_motions);
}

#[test]
fn rotation_and_translation_go_out_and_in() {
    fn law<M: Sample>(x: &Arguments<M>) -> Sides {
        let (rotation, translation) = (x.a.rotation(), x.a.translation());
        let (turn, shift) = (M::from_rotation(rotation), M::from_translation(translation));
        Sides::motions(M::from_rotation_translation(rotation, translation), x.a)
            .and(Sides::motions(shift * turn, x.a))
            .and(Sides::motions(M::from_translation_rotation(translation, rotation), turn * shift))
    }
    for_unit!("r + ½εtr = σ", law, unit_motions);
}

#[test]
fn matrices_go_out_and_in() {
    fn law<M: Sample>(x: &Arguments<M>) -> Sides {
        let [r0, r1, r2, last] = x.a.to_matrix4();
        let affine = [0.0, 0.0, 0.0, 1.0].map(M::splat);
        Sides::same_motions(x.a, M::from_matrix3x4(x.a.to_matrix3x4()))
            .and(Sides::same_motions(x.a, M::from_matrix3x4([r0, r1, r2])))
            .and(Sides::reals::<M>(Kind::Plain, &last, &affine))
    }
    for_unit!("from_matrix(to_matrix(σ)) = ±σ", law, unit_motions);
}

#[test]
fn a_product_does_what_its_factors_do_one_after_the_other() {
    fn law<M: Sample>(x: &Arguments<M>) -> Sides {
        let ab = x.a * x.b;
        let (points, directions) = (ab.transform_point(x.v), ab.transform_vector(x.v));
        let (line, plane) = (ab.transform_line(x.line()), ab.transform_plane(x.plane()));
        let twice = x.a.transform_line(x.b.transform_line(x.line()));
        let plane_twice = x.a.transform_plane(x.b.transform_plane(x.plane()));
        let point_twice = x.a.transform_point(x.b.transform_point(x.v));
        let direction_twice = x.a.transform_vector(x.b.transform_vector(x.v));
        Sides::reals::<M>(Kind::Length, &points, &point_twice)
            .and(Sides::reals::<M>(Kind::Plain, &directions, &direction_twice))
            .and(Sides::reals::<M>(Kind::Plain, &line.direction, &twice.direction))
            .and(Sides::reals::<M>(Kind::Length, &line.moment, &twice.moment))
            .and(Sides::reals::<M>(Kind::Plain, &plane.normal, &plane_twice.normal))
            .and(Sides::reals::<M>(Kind::Length, &[plane.offset], &[plane_twice.offset]))
    }
    for_unit!("(ab)v = a(bv)", law, unit);
}

/// The motion's own algebra, of which the operations on points, directions and lines are short forms.
#[test]
fn points_and_lines_move_by_the_sandwich_product() {
    fn law<M: Sample>(x: &Arguments<M>) -> Sides {
        let (zero, one) = (M::splat(0.0), M::splat(1.0));
        let pure = |real: M::Real, [rx, ry, rz]: [M::Real; 3], [dx, dy, dz]: [M::Real; 3]| {
            M::motion([rx, ry, rz, real, dx, dy, dz, zero])
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
            .and(Sides::reals::<M>(Kind::Plain, &[dx, dy, dz], &direction))
    }
    for_unit!("σ(1 + εv)σ⋄, σ(l + εm)σ*", law, unit);
}

#[test]
fn matrices_move_points_as_motions_do() {
    fn law<M: Sample>(x: &Arguments<M>) -> Sides {
        let (points, moved) = (vectors::<M>(x.v), vectors::<M>(x.a.transform_point(x.v)));
        let rows = x.a.to_matrix3x4().map(|[x, y, z, t]| (vectors::<M>([x, y, z]), M::lanes(t)));
        let sides = rows.into_iter().enumerate().map(|(c, (row, t))| {
            let products = (0..M::LANES).map(|i| dot(row[i], points[i]) + t[i]).collect();
            Sides::numbers(Kind::Length, moved.iter().map(|m| m[c]).collect(), products)
        });
        sides.fold(Sides::default(), Sides::and)
    }
    for_unit!("[R | t](v, 1) = σv", law, unit);
}

#[test]
fn motions_keep_distances() {
    fn law<M: Sample>(x: &Arguments<M>) -> Sides {
        let between = |u, v| {
            let pairs = vectors::<M>(u).into_iter().zip(vectors::<M>(v));
            pairs.map(|(u, v)| norm(&[u[0] - v[0], u[1] - v[1], u[2] - v[2]])).collect()
        };
        let (u, v) = (x.a.transform_point(x.v), x.a.transform_point(x.w));
        Sides::numbers(Kind::Length, between(u, v), between(x.v, x.w))
    }
    for_unit!("|σu − σv| = |u − v|", law, unit);
}

#[test]
fn points_stay_on_their_lines_and_planes() {
    fn law<M: Sample>(x: &Arguments<M>) -> Sides {
        let (points, directions) = (vectors::<M>(x.v), vectors::<M>(x.w));
        let pairs = || points.iter().zip(&directions);
        let moments: Vec<_> = pairs().map(|(&v, &w)| cross(v, w)).collect();
        let offsets: Vec<_> = pairs().map(|(&v, &w)| dot(v, w)).collect();
        let line = Line { direction: x.w, moment: M::vector(&moments) };
        let plane = Plane { normal: x.w, offset: M::real(&offsets) };

        let points = vectors::<M>(x.a.transform_point(x.v));
        let (line, plane) = (x.a.transform_line(line), x.a.transform_plane(plane));
        let directions = vectors::<M>(line.direction).into_iter();
        let moments: Vec<_> = points.iter().zip(directions).map(|(&v, l)| cross(v, l)).collect();
        let normals = vectors::<M>(plane.normal).into_iter();
        let offsets: Vec<_> = points.iter().zip(normals).map(|(&v, n)| dot(v, n)).collect();
        Sides::reals::<M>(Kind::Length, &line.moment, &M::vector(&moments)).and(Sides::numbers(
            Kind::Length,
            M::lanes(plane.offset),
            offsets,
        ))
    }
    for_unit!("x × l = m, n·x = d", law, two_vectors);
}

#[test]
fn the_exponential_undoes_the_logarithm() {
    fn law<M: Sample>(x: &Arguments<M>) -> Sides {
        Sides::same_small_motions(x.a, M::exp(x.a.log()))
    }
    for_unit!("exp(log σ) = ±σ", law, small);
}

#[test]
fn screws_go_out_and_in() {
    fn law<M: Sample>(x: &Arguments<M>) -> Sides {
        Sides::same_small_motions(x.a, M::from_screw(x.a.to_screw()))
    }
    // A far turn by less than that has a moment beyond the largest `f32`.
    let mut cases = inputs::unit_cases();
    cases.retain(|x| norm(&x.a[..3]) == 0.0 || norm(&x.a[..3]) > 1e-32);
    for_unit!(cases, "from_screw(to_screw(σ)) = ±σ", law, small);
}

#[test]
fn exponents_add() {
    fn law<M: Sample>(x: &Arguments<M>) -> Sides {
        let (s, t) = (M::lanes(x.s), M::lanes(x.t));
        let sum = M::real(&s.iter().zip(&t).map(|(s, t)| s + t).collect::<Vec<_>>());
        Sides::motions(x.a.pow(x.s) * x.a.pow(x.t), x.a.pow(sum))
    }
    for_unit!("σˢσᵗ = σˢ⁺ᵗ", law, powers);
}

#[test]
fn the_first_power_is_the_motion_the_zeroth_is_one() {
    fn law<M: Sample>(x: &Arguments<M>) -> Sides {
        Sides::same_small_motions(x.a, x.a.pow(M::splat(1.0)))
            .and(Sides::motions(x.a.pow(M::splat(0.0)), M::one()))
    }
    for_unit!("σ¹ = ±σ, σ⁰ = 1", law, small);
}

#[test]
fn the_root_made_twice_is_the_motion() {
    fn law<M: Sample>(x: &Arguments<M>) -> Sides {
        let root = x.a.sqrt();
        Sides::same_small_motions(x.a, root * root)
            .and(Sides::same_small_motions(root, x.a.pow(M::splat(0.5))))
    }
    for_unit!("(√σ)² = ±σ", law, small);
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

#[test]
fn interpolation_begins_at_one_motion_and_ends_at_the_other() {
    fn law<M: Sample>(x: &Arguments<M>) -> Sides {
        let (zero, one) = (M::splat(0.0), M::splat(1.0));
        Sides::motions(x.a.sclerp(x.b, zero), x.a)
            .and(Sides::same_motions(x.b, x.a.sclerp(x.b, one)))
            .and(Sides::motions(x.a.nlerp(x.b, zero), x.a))
            .and(Sides::same_motions(x.b, x.a.nlerp(x.b, one)))
    }
    for_unit!("sclerp(a, b, 0) = a, sclerp(a, b, 1) = ±b", law, unit_motions);
}

#[test]
fn screw_interpolation_moves_with_its_ends() {
    fn law<M: Sample>(x: &Arguments<M>) -> Sides {
        let (ca, cb) = (x.c * x.a, x.c * x.b);
        Sides::motions(ca.sclerp(cb, x.t), x.c * x.a.sclerp(x.b, x.t))
    }
    for_unit!(no_ties(), "sclerp(ca, cb, t) = c sclerp(a, b, t)", law, powers);
}

#[test]
fn screw_interpolation_is_a_power_of_the_difference() {
    fn law<M: Sample>(x: &Arguments<M>) -> Sides {
        let power = x.a * (x.a.conjugate() * x.b).pow(x.t);
        Sides::motions(x.a.sclerp(x.b, x.t), power)
    }
    for_unit!(no_ties(), "sclerp(a, b, t) = a(a*b)ᵗ", law, powers);
}

#[test]
fn interpolation_does_not_see_the_sign_of_its_end() {
    fn law<M: Sample>(x: &Arguments<M>) -> Sides {
        Sides::motions(x.a.nlerp(x.b, x.t), x.a.nlerp(-x.b, x.t))
            .and(Sides::motions(x.a.sclerp(x.b, x.t), x.a.sclerp(-x.b, x.t)))
    }
    for_unit!(no_ties(), "sclerp(a, b, t) = sclerp(a, −b, t)", law, unit_motions);
}

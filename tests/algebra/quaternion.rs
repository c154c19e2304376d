//! Quaternions, unit and of any length.

use super::{Sides, chunks, column, see};
use dq8::{DualQuat, Quat, Quaternion};
use dq8_contract::case::Case;
use dq8_contract::implementation::{Visitor, visit_implementations};
use dq8_contract::ledger::{Ledger, Line, line};
use dq8_contract::sample::Sample;

/// About 1.6 times the worst.
#[rustfmt::skip]
const LAWS: &[Line] = &[
    line("(ab)c = a(bc)", &[], 5.5, "two products a side"),
    line("a1 = 1a = a", &[], 0.0, "products with one and zero are exact"),
    line("a(b + c) = ab + ac", &[], 4.0, "a product of a sum against a sum of products"),
    line("(ab)* = b*a*", &[], 3.5, "another order of summands"),
    line("|ab| = |a| |b|", &[], 6.5, "three lengths"),
    line("ab* = a·b + …", &[], 4.0, "another order of summands"),
    line("|normalize(q)| = 1", &[], 6.5, "a length and quotients"),
    line("q q⁻¹ = 1", &[], 9.5, "two quotients and a product"),
    line("(ab)v = a(bv)", &[], 17.0, "two rotations against one of a product"),
    line("qv = Rv", &[], 6.0, "a rotation against a matrix"),
    line("|qv| = |v|", &[], 9.0, "|q| is only unit to its last place"),
    line("from_matrix3(to_matrix3(q)) = ±q", &[], 8.0, "a matrix, and a length"),
    line("from_axis_angle(to_axis_angle(q)) = ±q", &[], 12.0, "an arc and its sine"),
    line("from_scaled_axis(to_scaled_axis(q)) = ±q", &[], 11.0, "an arc and its sine"),
    line("slerp(a, b, 0) = a, slerp(a, b, 1) = ±b", &[], 5.0, "sines over sines"),
    line("angle(a, slerp(a, b, t)) = t angle(a, b)", &[], 10.0, "two arcs and an interpolation"),
    line("nlerp(a, b, ½) = slerp(a, b, ½)", &[], 6.5, "the middle of the way"),
    line("angle(a, −b) = angle(a, b)", &[], 0.0, "the sign is taken off"),
    line("from_rotation_arc(v, w) takes v to w", &[], 9.0, "three lengths and a rotation"),
    line("x, y, z are axes", &[], 0.0, "one rotation each"),
];

/// Lane by lane the numbers of quaternions.
fn sides<M: Sample>(left: M::Quat, right: M::Quat) -> Sides<M> {
    left.to_array().into_iter().zip(right.to_array()).collect()
}

/// The same up to the sign of all components: where their product is negative, one is turned over.
fn same_rotations<M: Sample>(left: M::Quat, right: M::Quat) -> Sides<M> {
    let sign = M::lanes(left.dot(right)).into_iter().map(f64::signum).collect::<Vec<_>>();
    sides::<M>(left.scale(M::real(&sign)), right)
}

fn vectors<M: Sample>(left: [M::Real; 3], right: [M::Real; 3]) -> Sides<M> {
    left.into_iter().zip(right).collect()
}

/// The length of vectors, in `f64`, rounded.
fn length<M: Sample>(vector: [M::Real; 3]) -> M::Real {
    let [x, y, z] = vector.map(M::lanes);
    let lengths = x.iter().zip(&y).zip(&z).map(|((x, y), z)| (x * x + y * y + z * z).sqrt());
    M::real(&lengths.collect::<Vec<_>>())
}

struct Laws<'a>(&'a Ledger);

impl Visitor for Laws<'_> {
    fn visit<M: Sample>(&mut self, on: &'static str) {
        for cases in chunks::<M>() {
            hold::<M>(self.0, on, &cases);
        }
    }
}

fn hold<M: Sample>(ledger: &Ledger, on: &str, cases: &[Case]) {
    let quat = |pick: fn(&Case) -> &[f64; 8]| {
        let c = |i: usize| column::<M>(cases, |case| pick(case)[i]);
        <M::Quat as Quaternion>::from_array([c(0), c(1), c(2), c(3)]).normalize()
    };
    let (a, b, c) = (quat(|case| &case.a), quat(|case| &case.b), quat(|case| &case.c));
    let vector = |pick: fn(&Case) -> &[f64; 3]| {
        let c = |i: usize| column::<M>(cases, |case| pick(case)[i]);
        [c(0), c(1), c(2)]
    };
    let (v, w) = (vector(|case| &case.v), vector(|case| &case.w));
    // Of other lengths than 1.
    let (long, short) = (a.scale(M::splat(3.5)), b.scale(M::splat(0.25)));
    let one = M::Quat::identity(M::level());
    let (zero, whole, t) = (M::splat(0.0), M::splat(1.0), M::splat(0.375));
    let each = |scale: f64| vec![scale; M::LANES];
    let see =
        |law: &str, sides: Sides<M>, scale: f64| see::<M>(ledger, on, law, sides, &each(scale));

    see("(ab)c = a(bc)", sides::<M>((long * b) * c, long * (b * c)), 3.5);
    see("a1 = 1a = a", sides::<M>(long * one, long), 1.0);
    see("a1 = 1a = a", sides::<M>(one * short, short), 1.0);
    see("a(b + c) = ab + ac", sides::<M>(long * (b + c), long * b + long * c), 7.0);
    see("a(b + c) = ab + ac", sides::<M>((b - c) * long, b * long - c * long), 7.0);
    let turned = short.conjugate() * long.conjugate();
    see("(ab)* = b*a*", sides::<M>((long * short).conjugate(), turned), 1.0);
    let product = M::lanes(long.norm()).into_iter().zip(M::lanes(short.norm())).map(|(a, b)| a * b);
    let product = M::real(&product.collect::<Vec<_>>());
    see("|ab| = |a| |b|", vec![((long * short).norm(), product)], 1.0);
    see("ab* = a·b + …", vec![((long * b.conjugate()).w(), long.dot(b))], 3.5);
    see("|normalize(q)| = 1", vec![(short.normalize().norm(), whole)], 1.0);
    let (unit, failed) = long.normalize_checked();
    assert_eq!(M::bits(failed), 0, "{on}");
    see("|normalize(q)| = 1", sides::<M>(unit, long.normalize()), 1.0);
    see("q q⁻¹ = 1", sides::<M>(long * long.inverse(), one), 1.0);
    see("q q⁻¹ = 1", sides::<M>(short.inverse() * short, one), 1.0);

    see("(ab)v = a(bv)", vectors::<M>((a * b).rotate(v), a.rotate(b.rotate(v))), 3.5);
    let rows = a.to_matrix3();
    let moved = rows.map(|row| {
        let products = row.map(M::lanes).into_iter().zip(v.map(M::lanes));
        let mut sums = vec![0.0; M::LANES];
        for (elements, numbers) in products {
            for (sum, (e, n)) in sums.iter_mut().zip(elements.iter().zip(&numbers)) {
                *sum += e * n;
            }
        }
        M::real(&sums)
    });
    see("qv = Rv", vectors::<M>(a.rotate(v), moved), 3.5);
    see("|qv| = |v|", vec![(length::<M>(a.rotate(v)), length::<M>(v))], 3.5);

    see(
        "from_matrix3(to_matrix3(q)) = ±q",
        same_rotations::<M>(M::Quat::from_matrix3(rows), a),
        1.0,
    );
    let (axis, angle) = a.to_axis_angle();
    let law = "from_axis_angle(to_axis_angle(q)) = ±q";
    see(law, same_rotations::<M>(M::Quat::from_axis_angle(axis, angle), a), 1.0);
    let law = "from_scaled_axis(to_scaled_axis(q)) = ±q";
    see(law, same_rotations::<M>(M::Quat::from_scaled_axis(a.to_scaled_axis()), a), 1.0);

    let law = "slerp(a, b, 0) = a, slerp(a, b, 1) = ±b";
    see(law, sides::<M>(a.slerp(b, zero), a), 1.0);
    see(law, same_rotations::<M>(a.slerp(b, whole), b), 1.0);
    let part = M::real(
        &M::lanes(a.angle_to(b)).into_iter().map(|angle| 0.375 * angle).collect::<Vec<_>>(),
    );
    see("angle(a, slerp(a, b, t)) = t angle(a, b)", vec![(a.angle_to(a.slerp(b, t)), part)], 1.0);
    // Where both ways are equally long up to rounding, either is right.
    if M::lanes(a.dot(b)).iter().all(|dot| dot.abs() > 1e-5) {
        let half = M::splat(0.5);
        see("nlerp(a, b, ½) = slerp(a, b, ½)", sides::<M>(a.nlerp(b, half), a.slerp(b, half)), 1.0);
    }
    see("angle(a, −b) = angle(a, b)", vec![(a.angle_to(-b), a.angle_to(b))], 1.0);

    let arc = M::Quat::from_rotation_arc(v, w).rotate(v);
    let (from, to) = (M::lanes(length::<M>(v)), M::lanes(length::<M>(w)));
    let wanted = w.map(|c| {
        let scaled =
            M::lanes(c).into_iter().zip(from.iter().zip(&to)).map(|(c, (from, to))| c * from / to);
        M::real(&scaled.collect::<Vec<_>>())
    });
    see("from_rotation_arc(v, w) takes v to w", vectors::<M>(arc, wanted), 3.5);
    let angle = v[0];
    for (turn, axis) in [
        (M::Quat::from_rotation_x(angle), [whole, zero, zero]),
        (M::Quat::from_rotation_y(angle), [zero, whole, zero]),
        (M::Quat::from_rotation_z(angle), [zero, zero, whole]),
    ] {
        see("x, y, z are axes", vectors::<M>(turn.rotate(axis), axis), 1.0);
        see("x, y, z are axes", sides::<M>(turn, M::Quat::from_axis_angle(axis, angle)), 1.0);
        let again = M::Quat::from_parts(turn.xyz(), turn.w());
        let tolerance = M::splat(1e-6);
        let close = M::bits(turn.abs_diff_eq(again, zero)) & M::bits(turn.is_unit(tolerance));
        assert_eq!(close, (1 << M::LANES) - 1, "{on}");
        // Not where a component is the same.
        assert_eq!(M::bits((-turn).abs_diff_eq(turn, tolerance)), 0, "{on}");
    }
}

#[test]
fn quaternions_of_every_implementation_keep_the_laws() {
    Ledger::keep("quaternions", LAWS, |ledger| visit_implementations(&mut Laws(ledger)));
}

struct NoLength;

impl Visitor for NoLength {
    fn visit<M: Sample>(&mut self, on: &'static str) {
        for bad in [[0.0; 4], [f64::NAN, 0.0, 0.0, 1.0], [0.0, f64::INFINITY, 0.0, 1.0]] {
            let q = <M::Quat as Quaternion>::from_array(bad.map(M::splat));
            let (unit, failed) = q.normalize_checked();
            assert_eq!(M::bits(failed), (1 << M::LANES) - 1, "{on}: {bad:?}");
            let all = unit.to_array().into_iter().flat_map(M::lanes);
            assert!(all.into_iter().all(f64::is_nan), "{on}: {bad:?}");
            assert_eq!(M::bits(q.is_unit(M::splat(0.5))), 0, "{on}: {bad:?}");
        }
        assert!(<M::Quat as Quaternion>::METHODS.len() > 20 && M::METHODS.len() > 20);
    }
}

#[test]
fn what_has_no_length_has_no_unit_on_any_implementation() {
    visit_implementations(&mut NoLength);
}

struct AnyLength;

impl Visitor for AnyLength {
    fn visit<M: Sample>(&mut self, on: &'static str) {
        let powers: Vec<i32> =
            if M::SINGLE { (-149..=126).collect() } else { (-1074..=1022).step_by(7).collect() };
        for first in 0..powers.len() {
            // Lanes of all lengths beside each other.
            let sizes: Vec<_> =
                (0..M::LANES).map(|lane| powers[(first + 61 * lane) % powers.len()]).collect();
            let size = M::real(&sizes.iter().map(|&k| f64::from(k).exp2()).collect::<Vec<_>>());
            let q = <M::Quat as Quaternion>::from_array([size, size, size, -size]);
            let unit = q.normalize().to_array().map(M::lanes);
            let wanted = [0.5, 0.5, 0.5, -0.5].map(|part| vec![part; M::LANES]);
            assert_eq!(unit, wanted, "{on}: powers of two {sizes:?}");
        }
    }
}

#[test]
fn any_length_there_is_is_divided_by_on_every_implementation() {
    visit_implementations(&mut AnyLength);
}

#[test]
fn differences_count_in_both_directions() {
    let [one, two] = [1.0_f32, 2.0].map(|w| Quat::from_xyzw(0.0, 0.0, 0.0, w));
    assert!(one.abs_diff_eq(two, 1.0) && two.abs_diff_eq(one, 1.0));
    assert!(!one.abs_diff_eq(two, 0.9) && !two.abs_diff_eq(one, 0.9));
    let [near, far] = [1.0_f32, 2.0].map(|x| DualQuat::from_translation([x, 0.0, 0.0]));
    assert!(near.abs_diff_eq(far, 0.5) && far.abs_diff_eq(near, 0.5));
    assert!(!near.abs_diff_eq(far, 0.4) && !far.abs_diff_eq(near, 0.4));
}

/// ||p| − 1| ≤ tolerance and |p·q| ≤ tolerance·max(1, |q|).
#[test]
fn unit_is_judged_by_the_larger_of_one_and_the_dual_part() {
    let motion = |w, x, along| DualQuat::from_array([0.0_f32, 0.0, 0.0, w, x, 0.0, 0.0, along]);
    for (w, x, along, is_unit) in [
        (1.0, 0.0, 1e-3, true),
        (1.0, 0.0, -1e-3, true),
        (1.0, 0.0, 3e-3, false),
        (1.0, 0.0, -3e-3, false),
        (1.0, 100.0, 0.1, true),
        (1.0, 100.0, 0.3, false),
        (1.001, 0.0, 0.0, true),
        (0.999, 0.0, 0.0, true),
        (1.003, 0.0, 0.0, false),
        (0.997, 0.0, 0.0, false),
    ] {
        assert_eq!(motion(w, x, along).is_unit(2e-3), is_unit, "{w} {x} {along}");
    }
}

//! Dual vectors by the laws of vectors over dual numbers (Jia §§3 and 4), on whole numbers
//! without rounding; and the same operations on lanes.

use dq8::{Dual, DualQuat, Line, Plane, geometry::DualVector, simd::f32x8};
use dq8_contract::inputs::{for_all, vector};
use dq8_simd::{Lanes, Portable};
use proptest::prelude::*;

type Vector = DualVector<f64>;

fn whole() -> impl Strategy<Value = f64> {
    (-9..=9_i32).prop_map(f64::from)
}

fn number() -> impl Strategy<Value = Dual<f64>> {
    (whole(), whole()).prop_map(|(real, dual)| Dual::new(real, dual))
}

fn dual_vector() -> impl Strategy<Value = Vector> {
    let three = || prop::array::uniform3(whole());
    (three(), three()).prop_map(|(real, dual)| DualVector { real, dual })
}

fn dot(a: Vector, b: Vector) -> Dual<f64> {
    let [real, dual] = a.dot(b);
    Dual::new(real, dual)
}

fn times(number: Dual<f64>, vector: Vector) -> Vector {
    vector.scale_dual([number.real, number.dual])
}

/// As a dual quaternion.
fn pure(vector: Vector) -> DualQuat<f64> {
    DualQuat::from_dual_parts(Dual::ZERO, vector)
}

/// Component by component, as Jia writes it.
fn components(vector: Vector) -> [Dual<f64>; 3] {
    std::array::from_fn(|i| Dual::new(vector.real[i], vector.dual[i]))
}

proptest! {
    #![proptest_config(dq8_contract::inputs::proptest_config(256))]

    #[test]
    fn eqs_8_and_9_products_are_those_of_vectors_of_dual_numbers(a in dual_vector(), b in dual_vector()) {
        let ([a0, a1, a2], [b0, b1, b2]) = (components(a), components(b));
        prop_assert_eq!(dot(a, b), a0 * b0 + a1 * b1 + a2 * b2);
        let cross = [a1 * b2 - a2 * b1, a2 * b0 - a0 * b2, a0 * b1 - a1 * b0];
        prop_assert_eq!(components(a.cross(b)), cross);
    }

    #[test]
    fn section_4_the_product_of_dual_quaternions_is_that_of_their_parts(
        a in dual_vector(), b in dual_vector(), s in number(), t in number(),
    ) {
        prop_assert_eq!(
            pure(a) * pure(b),
            DualQuat::from_dual_parts(-dot(a, b), a.cross(b)),
            "ab = −a·b + a × b"
        );
        let vector = times(s, b) + times(t, a) + a.cross(b);
        prop_assert_eq!(
            DualQuat::from_dual_parts(s, a) * DualQuat::from_dual_parts(t, b),
            DualQuat::from_dual_parts(s * t - dot(a, b), vector)
        );
    }

    /// a × b = ½(ba* + ab) (Jia, above eq. 33), and a·b = −½(ab + ba) beside it.
    #[test]
    fn products_of_vectors_are_halves_of_products_of_quaternions(a in dual_vector(), b in dual_vector()) {
        let (p, q) = (pure(a), pure(b));
        prop_assert_eq!(pure(a.cross(b)), (q * p.conjugate() + p * q).scale(0.5));
        let inner = DualQuat::from_dual_parts(dot(a, b), a - a);
        prop_assert_eq!(inner, (p * q + q * p).scale(-0.5));
    }

    #[test]
    fn products_are_bilinear_over_dual_numbers(
        a in dual_vector(), b in dual_vector(), c in dual_vector(), s in number(),
    ) {
        prop_assert_eq!(dot(times(s, a) + b, c), s * dot(a, c) + dot(b, c));
        prop_assert_eq!((times(s, a) - b).cross(c), times(s, a.cross(c)) - b.cross(c));
        prop_assert_eq!(dot(a, b), dot(b, a));
        prop_assert_eq!(a.cross(b), -b.cross(a));
        prop_assert_eq!(a.scale(s.real), times(Dual::new(s.real, 0.0), a));
    }

    #[test]
    fn products_of_three_and_four_are_those_of_vectors(
        a in dual_vector(), b in dual_vector(), c in dual_vector(), d in dual_vector(),
    ) {
        let zero = a - a;
        prop_assert_eq!(dot(a, b.cross(c)), dot(b, c.cross(a)), "a·(b × c) is cyclic");
        prop_assert_eq!(dot(a, a.cross(b)), Dual::ZERO);
        prop_assert_eq!(
            a.cross(b.cross(c)), times(dot(a, c), b) - times(dot(a, b), c), "a × (b × c)"
        );
        prop_assert_eq!(
            a.cross(b.cross(c)) + b.cross(c.cross(a)) + c.cross(a.cross(b)), zero, "Jacobi"
        );
        prop_assert_eq!(
            dot(a.cross(b), c.cross(d)), dot(a, c) * dot(b, d) - dot(a, d) * dot(b, c), "Lagrange"
        );
    }
}

#[test]
fn lines_are_dual_vectors_and_back() {
    let line = Line { direction: [1.0, 2.0, 3.0], moment: [4.0, 5.0, 6.0] };
    let vector = DualVector::from(line);
    assert_eq!(vector, DualVector { real: line.direction, dual: line.moment });
    assert_eq!(Line::from(vector), line);
    let opposite = Line::from(-vector);
    assert_eq!(opposite, Line { direction: [-1.0, -2.0, -3.0], moment: [-4.0, -5.0, -6.0] });
}

/// Lanes compute what one number does, bit for bit: nothing is fused on either side.
#[test]
fn lanes_compute_as_single_numbers_do() {
    let eight = prop::array::uniform8(prop::array::uniform4(vector()));
    for_all(64, &eight, |inputs| {
        let narrow = inputs.map(|vectors| vectors.map(|v| v.map(|c| c as f32)));
        let lanes: [[f32x8; 3]; 4] = std::array::from_fn(|which| {
            std::array::from_fn(|c| f32x8::load(Portable, &narrow.map(|v| v[which][c])))
        });
        let wide = everything(lanes).map(|lane| lane.to_array());
        for (i, vectors) in narrow.into_iter().enumerate() {
            assert_eq!(everything(vectors), wide.map(|lane| lane[i]));
        }
    });
}

/// Every operation that lanes have too, of four vectors.
fn everything<T>([a, b, c, d]: [[T; 3]; 4]) -> [T; 25]
where
    T: Copy
        + std::ops::Add<Output = T>
        + std::ops::Sub<Output = T>
        + std::ops::Mul<Output = T>
        + std::ops::Neg<Output = T>,
{
    let (v, w) = (DualVector { real: a, dual: b }, DualVector { real: c, dual: d });
    let (line, other) = (Line::from_point_direction(a, b), Line::from_point_direction(c, d));
    let products = v.cross(w).scale_dual(v.dot(w)) - (v + -w).scale(a[0]);
    let near = [line.closest_point_to_origin(), line.closest_point(c), other.moment];
    let plane = Plane::from_point_normal(a, b);
    let vectors =
        [products.real, products.dual, near[0], near[1], near[2], line.moment, line.direction];
    let scalars =
        [v.dot(w)[0], v.dot(w)[1], line.reciprocal_product(other), plane.signed_distance(c)];
    std::array::from_fn(|i| if i < 21 { vectors[i / 3][i % 3] } else { scalars[i - 21] })
}

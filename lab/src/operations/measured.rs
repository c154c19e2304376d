use crate::arends;
use crate::counted::{Counted, Counts};
use crate::matrix::{self, Matrix};
use crate::{HyperDual, HyperDualQuat};
use core::array::from_fn;
use dq8::{DualQuat, Quat, Real};

/// An operation, what a source says it takes, and what it takes.
#[derive(Clone, Debug)]
pub struct Operation {
    /// What is computed.
    pub name: &'static str,
    /// The source with its section, or nothing where no source counts it.
    pub source: &'static str,
    /// What it prints.
    pub printed: &'static str,
    /// Why the two differ, or how it is computed.
    pub reason: &'static str,
    /// As measured.
    pub counts: Counts,
}

/// A factor of every kind, without zeros that would take a branch.
struct Sample {
    motions: [DualQuat<Counted>; 2],
    matrices: [Matrix<Counted, 3, 4>; 2],
    point: [Counted; 3],
    angles: [Counted; 3],
    t: Counted,
}

impl Sample {
    fn new() -> Self {
        let motions = [(0.7, [1.0, 2.0, 3.0]), (1.2, [-2.0, 0.5, 1.0])].map(|(angle, t)| {
            let axis = [0.48, 0.6, 0.64].map(Counted);
            DualQuat::from_rotation_translation(
                Quat::from_axis_angle(axis, Counted(angle)),
                t.map(Counted),
            )
        });
        Self {
            motions,
            matrices: motions.map(DualQuat::to_matrix3x4),
            point: [0.3, -0.4, 0.5].map(Counted),
            angles: [0.1, 0.2, 0.3].map(Counted),
            t: Counted(0.25),
        }
    }
}

/// Measures all of them.
pub fn operations() -> Vec<Operation> {
    let mut list = matrices();
    list.extend(quaternions());
    list.extend(motions());
    list.extend(hyper_dual());
    list.extend(interpolations());
    list
}

/// Where no source counts it.
const UNPRINTED: (&str, &str) = ("", "");

fn row<T>(
    name: &'static str,
    (source, printed): (&'static str, &'static str),
    reason: &'static str,
    work: impl FnOnce() -> T,
) -> Operation {
    Operation { name, source, printed, reason, counts: Counts::of(work) }
}

fn matrices() -> Vec<Operation> {
    let Sample { matrices: [a, b], point: [x, y, z], angles, .. } = Sample::new();
    let [wide_a, wide_b] = [a, b].map(matrix::homogeneous);
    let one = Counted::ONE;
    let columns: Matrix<Counted, 4, 3> = from_fn(|i| from_fn(|j| wide_b[i][j]));
    vec![
        row(
            "matrix 4×4 product",
            ("Kenwright §11, Arends §2.6", "64 mul, 48 add"),
            "agrees",
            || matrix::product(wide_a, wide_b),
        ),
        row(
            "matrix 3×4 product",
            ("Kenwright §11", "48 mul, 32 add"),
            "A last row 0 0 0 1 need not be multiplied: [AB | At + s].",
            || matrix::affine_product(a, b),
        ),
        row(
            "matrix 4×3 times 3×4",
            ("Kenwright §11", "48 mul, 32 add"),
            "This has what is printed: sixteen sums of three products. It does not compose motions.",
            || matrix::product(columns, a),
        ),
        row("matrix 4×4 times column", ("Arends §2.6", "16 mul, 12 add"), "agrees", || {
            matrix::apply(wide_a, [x, y, z, one])
        }),
        row("matrix 3×4, point", UNPRINTED, "Av + t", || matrix::affine_apply(a, [x, y, z])),
        row("matrix 3×3, vector", UNPRINTED, "Av", || matrix::apply(matrix::left(a), [x, y, z])),
        row("matrix 3×4, inverse", UNPRINTED, "rigid: [Aᵀ | −Aᵀt]", || {
            matrix::rigid_inverse(a)
        }),
        row("matrix 3×3, Gram–Schmidt", UNPRINTED, "third row by a cross product", || {
            matrix::gram_schmidt(matrix::left(a))
        }),
        row(
            "Euler angles to matrix 3×3",
            UNPRINTED,
            "two products of the three turns about axes",
            || {
                let [x, y, z] = matrix::about_axes(angles);
                matrix::product(matrix::product(x, y), z)
            },
        ),
        row(
            "Euler angles applied to a point, by 4×4",
            ("Arends §2.6", "144 mul, 108 add, 12 trig"),
            "Each turn has one sine and one cosine; he counts the four elements that hold them.",
            || {
                let [x_turn, y_turn, z_turn] = matrix::about_axes(angles).map(|rows| {
                    matrix::homogeneous(rows.map(|[x, y, z]| [x, y, z, Counted::ZERO]))
                });
                let turn = matrix::product(matrix::product(x_turn, y_turn), z_turn);
                matrix::apply(turn, [x, y, z, one])
            },
        ),
    ]
}

fn quaternions() -> Vec<Operation> {
    let Sample { motions: [a, b], point, .. } = Sample::new();
    let (p, q) = (a.rotation(), b.rotation());
    let axis = [0.48, 0.6, 0.64].map(Counted);
    vec![
        row("quaternion product", ("Arends §3.4", "16 mul, 12 add"), "agrees", || p * q),
        row(
            "quaternion of axis and angle",
            ("Arends §3.4", "4 trig, 4 div"),
            "One sine, one cosine and one half for all components; he counts each component.",
            || Quat::from_axis_angle(axis, Counted(0.5)),
        ),
        row(
            "quaternion, vector by qpq*",
            ("Arends §3.4", "35 mul, 24 add, 8 trig, 8 div"),
            "He counts three negations as multiplications; sines and halves as in the row above, twice.",
            || arends::rotate(p, Quat::from_parts(point, Counted::ZERO)),
        ),
        row("quaternion, vector", UNPRINTED, "v + 2 r × (r × v + w v)", || p.rotate(point)),
        row("quaternion normalized", UNPRINTED, "guarded against overflow as below", || {
            p.normalize()
        }),
        row("quaternion + vector, product", UNPRINTED, "(r₁r₂, r₁t₂r₁* + t₁)", || {
            let turned = p.rotate(b_translation());
            let sum: [Counted; 3] = from_fn(|i| turned[i] + point[i]);
            (p * q, sum)
        }),
    ]
}

fn b_translation() -> [Counted; 3] {
    [-2.0, 0.5, 1.0].map(Counted)
}

fn motions() -> Vec<Operation> {
    let Sample { motions: [a, b], matrices: [matrix, _], point, .. } = Sample::new();
    let moved = DualQuat::new(Quat::IDENTITY, Quat::from_parts(point, Counted::ZERO));
    let (r, t) = (b.rotation(), b_translation());
    vec![
        row(
            "dual quaternion product",
            ("Kenwright §11", "42 mul, 38 add"),
            "Three quaternion products and a sum. No reading that we know gives the printed numbers.",
            || a * b,
        ),
        row(
            "dual quaternion product of Kenwright's class",
            ("Kenwright §11", "42 mul, 38 add"),
            "As §13.1 writes it: its constructor normalizes the real part of every product.",
            || kenwright_product(a, b),
        ),
        row(
            "dual quaternion by rotation and translation",
            UNPRINTED,
            "the second made of the two first",
            || a.mul_rotation_translation(r, t),
        ),
        row("dual quaternion, point", UNPRINTED, "Rv + 2qp*", || a.transform_point(point)),
        row(
            "dual quaternion, point by qpq†",
            ("Arends §4.5", "110 mul (later 103), 72 add"),
            "His 96 products and 10 for the conjugate, of which 6 are negations, are 106; the sums in \
             two dual parts, 8 additions, are forgotten.",
            || arends::dual_transform(a, moved),
        ),
        row("dual quaternion to matrix 3×4", UNPRINTED, "with t = 2qp*", || a.to_matrix3x4()),
        row(
            "matrix 3×4 to dual quaternion",
            UNPRINTED,
            "largest component first (Shepperd 1978)",
            || DualQuat::from_matrix3x4(matrix),
        ),
        row("dual quaternion, conjugate", UNPRINTED, "inverse of a unit one", || a.conjugate()),
        row("dual quaternion, inverse", UNPRINTED, "of any: p⁻¹ − ε p⁻¹qp⁻¹", || {
            a.inverse()
        }),
        row(
            "dual quaternion normalized",
            UNPRINTED,
            "exactly: |p| = 1 and p·q = 0; scaled by the largest component, so that nothing overflows",
            || a.normalize(),
        ),
        row(
            "dual quaternion normalized, unguarded",
            UNPRINTED,
            "the formula alone (Fabisch)",
            || fabisch_normalize(a),
        ),
    ]
}

/// σ/|p|, then q without its part along p (Fabisch, "two steps"), and nothing against overflow.
fn fabisch_normalize(motion: DualQuat<Counted>) -> DualQuat<Counted> {
    let reciprocal = Counted::ONE / motion.real().dot(motion.real()).sqrt();
    let (p, q) = (motion.real().scale(reciprocal), motion.dual().scale(reciprocal));
    DualQuat::new(p, q - p.scale(p.dot(q)))
}

/// `operator*` of Kenwright §13.1 with the constructor that it calls; his order is left to right.
fn kenwright_product(left: DualQuat<Counted>, right: DualQuat<Counted>) -> DualQuat<Counted> {
    let real = right.real() * left.real();
    let dual = right.dual() * left.real() + right.real() * left.dual();
    let reciprocal = Counted::ONE / real.dot(real).sqrt();
    DualQuat::new(real.scale(reciprocal), dual)
}

fn hyper_dual() -> Vec<Operation> {
    let Sample { motions: [a, b], point, .. } = Sample::new();
    let [p, q] = [a, b].map(|m| HyperDualQuat::new(m.real(), m.dual(), m.dual(), m.real()));
    let moved = HyperDualQuat::point(point);
    let [nested_p, nested_q] = [p, q].map(Quat::<HyperDual<_>>::from);
    vec![
        row(
            "hyper-dual quaternion product, written out",
            UNPRINTED,
            "Nine quaternion products and five sums.",
            || p * q,
        ),
        row(
            "hyper-dual quaternion product, Quat<Dual<Dual>>",
            UNPRINTED,
            "The same, by the quaternion product of dq8 over dual numbers of dual numbers.",
            || nested_p * nested_q,
        ),
        row(
            "hyper-dual quaternion, point by qpq†",
            ("Arends §5.5", "312 mul, 216 add"),
            "Twelve of his multiplications are negations; the ten sums, 40 additions, are forgotten.",
            || arends::hyper_transform(p, moved),
        ),
    ]
}

fn interpolations() -> Vec<Operation> {
    let Sample { motions: [a, b], angles, t, .. } = Sample::new();
    let (p, q) = (a.rotation(), b.rotation());
    vec![
        row("LERP of quaternions", UNPRINTED, "(1−t)a + tb", || {
            p.scale(Counted::ONE - t) + q.scale(t)
        }),
        row(
            "SLERP of quaternions, angle given",
            ("Arends §3.4", "10 mul, 5 add, 4 trig, 2 div"),
            "agrees",
            || arends::slerp_formula(p, q, t, Counted(0.5)),
        ),
        row(
            "SLERP of quaternions",
            UNPRINTED,
            "The angle has to be found: by an arctangent of two lengths, which keeps small ones.",
            || p.slerp(q, t),
        ),
        row("SLERP and LERP", UNPRINTED, "rotation and translation apart", || a.slerp_lerp(b, t)),
        row("NLERP of dual quaternions", UNPRINTED, "DLB of two motions", || a.nlerp(b, t)),
        row("ScLERP", UNPRINTED, "a(a*b)ᵗ by logarithm and exponential", || a.sclerp(b, t)),
        row(
            "keyframes, element by element",
            ("Arends §2.6", "6 mul, 4 add, 9 exp, 12 ln"),
            "agrees, for a vector; the matrices of the method have nine elements and another logarithm",
            || arends::keyframe(angles, angles, t),
        ),
    ]
}

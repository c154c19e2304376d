//! The errors allowed: one line for each operation and kind of input, with its reason.
//!
//! Unit: the unit roundoff u of the type, 2⁻²⁴ for `f32` and 2⁻⁵³ for `f64`, times the scale of the
//! section. One bound serves both types, the scalar reference and every lane type: the formulas are
//! the same, and fused or not is less than a factor of two. Bounds are about one and a half times the
//! worst that has been measured; where one is large, the reason says what it is made of.
//!
//! These are errors against the truth. How far two ways to the same number may lie apart is in
//! [`agreement`](crate::agreement).

/// Lines that one test measures, against one truth and on one scale.
#[derive(Debug)]
pub struct Section {
    pub name: &'static str,
    /// What answers are compared to.
    pub truth: &'static str,
    /// What an error is divided by, beside u.
    pub scale: &'static str,
    pub lines: &'static [Bound],
}

/// One line of the table.
#[derive(Clone, Copy, Debug)]
pub struct Bound {
    pub op: &'static str,
    /// The kinds of input it is for; empty for all that no line above names.
    pub kinds: &'static [&'static str],
    /// The largest error allowed, in units of u · scale.
    pub units: f64,
    pub reason: &'static str,
}

const fn line(
    op: &'static str,
    kinds: &'static [&'static str],
    units: f64,
    reason: &'static str,
) -> Bound {
    Bound { op, kinds, units, reason }
}

/// Small or no rotation: what peers lose.
const SMALL: &[&str] = &["near0", "close", "translation"];

/// What `f64` cannot be: the truth of its own errors is the scalar path in `f64`, so that there its
/// lines hold two ways against each other.
const DOUBLE: &str = "the scalar path in f64, on the same rounded input";

/// The table.
#[rustfmt::skip]
pub static TABLE: &[Section] = &[
    Section { name: "vectors", truth: "60 digits", scale: "max(1, |t|), times norms of factors that are not unit", lines: &[
        line("conj_dual", &[], 0.0, "signs only"),
        line("conj_quat", &[], 0.0, "signs only"),
        line("conj_both", &[], 0.0, "signs only"),
        line("mul", &[], 2.5, "sums of 4 and 8 products"),
        line("norm", &[], 2.0, "a sum of squares, half of whose error the root takes away"),
        line("normalize", &[], 3.5, "norm, reciprocal, product, and the part of q along p"),
        line("inverse", &[], 5.0, "two divisions by the norm, two quaternion products"),
        line("from_rotation_translation", &[], 4.0, "the rotation is normalized first"),
        line("translation", &[], 8.0, "normalized first; then sums of 4 products of q and p, doubled"),
        line("vector", &[], 12.0, "normalized first; an error of p counts twice on each side of v"),
        line("matrix", &[], 13.0, "normalized first; squares of p, doubled, and the translation"),
        line("point", &[], 14.0, "a vector and a translation"),
        line("line", &[], 11.0, "three vectors and a product of a translation, over 1 + |l|"),
        line("log", SMALL, 4.0, "no cancellation: the vector part keeps its relative precision"),
        line("log", &[], 6.0, "normalized first; then one factor that varies slowly"),
        line("exp", &[], 2.5, "even functions of the square, one product"),
        line("pow", SMALL, 4.0, "no cancellation: the vector part keeps its relative precision"),
        line("pow", &[], 6.0, "normalized first; log, times t, exp"),
        line("sclerp", SMALL, 5.0, "both ends normalized; slerp about their middle"),
        line("sclerp", &[], 5.0, "both ends normalized; slerp about their middle"),
        line("screw", &[], 17.0, "normalized first; the angle is up to π, so 1 ulp of it is 4 u"),
        line("dlb", &[], 4.0, "up to 4 poses normalized, summed, normalized"),
        line("from_screw", &[], 2.5, "a sine and a cosine; the axis is rounded on the way in"),
        line("from_matrix3x4", &[], 3.0, "rounded on the way in; divided by its largest sum, normalized, and a product"),
        line("to_matrix4", &[], 13.0, "as matrix"),
        line("transform_plane", &[], 6.5, "a vector and its product with a translation, over 1 + |n|"),
        line("from_translation_rotation", &[], 3.0, "the rotation is normalized first"),
        line("mul_rotation_translation", &[], 3.0, "half a product with a translation, and two with a rotation"),
        line("sqrt", SMALL, 1.5, "no cancellation: the vector part keeps its relative precision"),
        line("sqrt", &[], 3.0, "normalized first; one root, or half a screw"),
        line("sclerp_long", &["opposite"], 2.0, "the scale holds how near the antipode is"),
        line("sclerp_long", &[], 4.5, "as sclerp"),
        line("nlerp", &[], 3.0, "as dlb, of two"),
        line("slerp_lerp", &[], 6.0, "both ends normalized; a slerp, two translations and a product"),
        line("squad", &[], 5.5, "four ends normalized; three screw interpolations"),
        line("squad_control", &[], 4.5, "three ends normalized; two logarithms, an exponential and a product"),
        line("dot", &[], 0.75, "sums of 4 and 8 products, of which few are as large as the scale"),
        line("add", &[], 1.25, "one sum"),
        line("sub", &[], 1.25, "one difference"),
        line("scale", &[], 0.75, "one product"),
        line("scale_dual", &[], 0.75, "a sum of two products, over the length of the factor"),
        line("canonical", &[], 0.0, "signs only"),
    ]},
    Section { name: "twists", truth: DOUBLE, scale: "the terms of the sums that the numbers are", lines: &[
        line("derivative_spatial", &[], 5.0, "sums of 3 and 7 products"),
        line("derivative_body", &[], 3.0, "sums of 3 and 7 products"),
        line("spatial_twist", &[], 4.5, "sums of 4 and 8 products"),
        line("body_twist", &[], 4.5, "sums of 4 and 8 products"),
        line("derivative_from_velocity", &[], 5.0, "a translation and two products"),
        line("velocity", &[], 5.5, "lanes go through the spatial twist"),
        line("from_twist", &[], 2.0, "exp of the half"),
        line("to_twist", &[], 18.0, "twice a log; turns are up to π, so 1 ulp of one is 4 u"),
        line("integrate_spatial", &[], 3.5, "exp and a product"),
        line("integrate_body", &[], 3.0, "exp and a product"),
        line("adjoint", &[], 8.5, "two turns and a product of the translation"),
        line("coadjoint", &[], 6.5, "two turns and a product of the translation"),
        line("left_jacobian", &[], 2.5, "two dual cross products, coefficients of a few u"),
        line("right_jacobian", &[], 3.0, "as the left one"),
        line("left_jacobian_inverse", &[], 4.0, "grows towards |ω| = 2π, which the scale takes out"),
        line("right_jacobian_inverse", &[], 3.5, "as the left one"),
    ]},
    Section { name: "twists near a whole turn", truth: DOUBLE, scale: "as twists", lines: &[
        line("left_jacobian_inverse", &[], 2.0, "what grows is in the scale"),
        line("right_jacobian_inverse", &[], 2.0, "what grows is in the scale"),
    ]},
    Section { name: "subnormal twists", truth: DOUBLE, scale: "the smallest normal number", lines: &[
        line("any", &[], 12.5, "every step rounds to the same last place, however small its operands"),
    ]},
    Section { name: "jacobians by an integral", truth: "the integral of adjoints; scalar f64 alone", scale: "as twists", lines: &[
        line("left_jacobian", &[], 13.0, "as among the twists, and the sum that the integral is"),
    ]},
    Section { name: "jacobians by Barfoot", truth: "his closed form in 3×3 matrices; scalar f64 alone", scale: "1", lines: &[
        line("left_jacobian_matrix", &[], 42.0, "his own: coefficients divide small differences by up to φ⁵"),
    ]},
    Section { name: "twists of joints", truth: DOUBLE, scale: "max(1, |t|) of the models", lines: &[
        line("velocities", &[], 10.5, "an adjoint a joint, summed from the root down"),
        line("jacobian", &[], 2.5, "an adjoint"),
    ]},
    Section { name: "hierarchies", truth: "4×4 matrices in f64", scale: "√products · (1 + the lengths along the chain)", lines: &[
        line("poses", &[], 8.0, "each product turns what follows by a few u; errors are independent"),
    ]},
    Section { name: "blends", truth: DOUBLE, scale: "max(1, |t|)", lines: &[
        line("dlb_running", &[], 4.5, "four poses summed and normalized"),
        line("dib", &[], 13.0, "steps within 16 u are none; then a product and a mean of logs"),
        line("slerp_lerp", &[], 6.0, "two sines over a third, and two translations"),
    ]},
    Section { name: "blends of tiny turns", truth: "the angle", scale: "the sine itself", lines: &[
        line("dlb_running", &[], 4.5, "no cancellation: the vector part keeps its relative precision"),
        line("dib", &[], 4.5, "no cancellation: the vector part keeps its relative precision"),
        line("slerp_lerp", &[], 8.0, "no cancellation: the vector part keeps its relative precision"),
    ]},
    Section { name: "paths", truth: DOUBLE, scale: "max(1, |t|)", lines: &[
        line("squad", &["start", "end"], 6.5, "interpolated with 0 or 1"),
        line("squad", &[], 7.5, "three screw interpolations"),
        line("squad_control", &[], 3.0, "two logarithms, an exponential and a product"),
    ]},
    Section { name: "distances", truth: DOUBLE, scale: "max(1, |t|), and |v| for points; π for the angle", lines: &[
        line("angle_to", &[], 2.5, "a product of rotations, whose vector part cancels; twice an arctangent of it"),
        line("distance_to", &[], 7.5, "two translations of 8 products each"),
        line("distance_weighted", &[], 9.0, "an angle, a distance and a root"),
        line("point_error", &[], 7.0, "two points of 14 u each at worst, but over |t| + |v|"),
        line("shell_error", &[], 6.0, "as point_error"),
    ]},
    Section { name: "angles", truth: "the angle of the input", scale: "1", lines: &[
        line("angle_to", &["tiny"], 6.0, "the scale is the angle itself: nothing cancels beside no turn"),
        line("angle_to", &[], 13.0, "angles are up to π, of which 1 ulp is 4 u"),
    ]},
    Section { name: "lengths of any size", truth: "the length", scale: "the length itself", lines: &[
        line("distance_to", &[], 3.0, "lengths neither overflow nor vanish on the way"),
        line("distance_weighted", &[], 3.0, "lengths neither overflow nor vanish on the way"),
        line("point_error", &[], 3.0, "lengths neither overflow nor vanish on the way"),
        line("shell_error", &[], 3.0, "lengths neither overflow nor vanish on the way"),
    ]},
    Section { name: "what nalgebra loses", truth: DOUBLE, scale: "the number; |t| for the distance; 1 for the angle", lines: &[
        line("sclerp", &["turn"], 2.0, "the vector part keeps its relative precision"),
        line("sclerp", &["distance"], 2.0, "the scale is |t| of the end"),
        line("sclerp", &["angle"], 1.5, "the angle between what is and what should be"),
    ]},
    Section { name: "edges", truth: "closed forms in f64", scale: "the size of the numbers", lines: &[
        line("normalize", &["any size"], 2.0, "as among the vectors: lengths neither overflow nor vanish"),
        line("pow", &["tiny, far"], 5.5, "half the angle times t, which may be large, and its sine"),
        line("sclerp", &["tiny, far"], 2.5, "as pow; the scale is the angle itself"),
        line("sclerp_long", &["long"], 6.5, "π − Θ, to 3 times of it"),
        line("log", &["half turn"], 1.25, "π/2, of which 1 ulp is 2 u"),
        line("exp", &["half turn"], 3.0, "the sine of a rounded angle"),
        line("exp", &["many turns"], 1.0, "over the angle, which is rounded, and its square"),
        line("from_matrix3x4", &["ties"], 5.0, "rounded matrices; four ways to a quaternion, normalized"),
        line("nlerp", &["half turn"], 2.5, "as dlb"),
        line("sclerp", &["half turn"], 2.5, "half a turn by its middle"),
        line("sclerp_long", &["half turn"], 2.5, "half a turn by its middle"),
        line("dlb", &["half turn"], 2.5, "as among the vectors"),
        line("ends", &["half turn"], 5.0, "interpolated with 0 or 1"),
    ]},
    Section { name: "sines", truth: "sine and cosine in f64; f32 alone, whose floats can be swept", scale: "max(1, h), h half the angle", lines: &[
        line("exp", &["sin"], 3.0, "relative to the sine for small h"),
        line("exp", &[], 3.0, "a polynomial, and h² is rounded"),
    ]},
    Section { name: "logarithms", truth: "the arctangent in f64; f32 alone", scale: "the angle itself", lines: &[
        line("log", &[], 5.0, "no cancellation: the vector part times a factor that varies slowly"),
    ]},
    Section { name: "roots", truth: "sine and cosine in f64; f32 alone", scale: "the sine itself, and 1 for the cosine", lines: &[
        line("sqrt", &["sin"], 4.5, "the vector part over 2 cos(Θ/2); scalar is a log and an exp"),
        line("sqrt", &["cos"], 1.5, "the root of (1 + w)/2"),
    ]},
];

/// The section of that name.
///
/// # Panics
/// If there is none.
pub fn section(name: &str) -> &'static Section {
    let found = TABLE.iter().find(|section| section.name == name);
    found.unwrap_or_else(|| panic!("the table of tolerances has no section {name:?}"))
}

impl Section {
    /// The line for an operation and a kind of input.
    pub fn bound(&self, op: &str, kind: &str) -> Option<&'static Bound> {
        let of_op = || self.lines.iter().filter(|bound| bound.op == op);
        of_op()
            .find(|bound| bound.kinds.contains(&kind))
            .or_else(|| of_op().find(|bound| bound.kinds.is_empty()))
    }

    /// The line for an operation and a kind of input.
    ///
    /// # Panics
    /// If there is none.
    pub fn line(&self, op: &str, kind: &str) -> &'static Bound {
        self.bound(op, kind).unwrap_or_else(|| {
            panic!("the section {:?} of the tolerances has no line for {op} ({kind:?})", self.name)
        })
    }
}

/// The unit roundoff: half the distance from 1 to the next number.
pub const fn unit_roundoff(single: bool) -> f64 {
    if single { f32::EPSILON as f64 / 2.0 } else { f64::EPSILON / 2.0 }
}

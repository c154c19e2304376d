//! Runs an operation of the reference vectors on any implementation and measures the error.

use super::sample::Sample;
use super::vectors::Vector;
use dq8::{DualVector, Line, Plane, Screw};

/// The answers of `M` to vectors of one operation and shape, at most as many as it has lanes.
pub fn answers<M: Sample>(vectors: &[&Vector]) -> Vec<Vec<f64>> {
    let first = vectors[0];
    // Lanes without a vector repeat the first one.
    let lane = |i: usize| *vectors.get(i).unwrap_or(&first);
    let reals = |name: &str, at: usize| {
        M::real(&(0..M::LANES).map(|i| lane(i).input(name)[at]).collect::<Vec<_>>())
    };
    let vector = |name: &str| std::array::from_fn::<_, 3, _>(|c| reals(name, c));
    // In the file w comes first.
    let motion_at = |name: &str, at: usize| {
        M::motion([1, 2, 3, 0, 5, 6, 7, 4].map(|c| reals(name, 8 * at + c)))
    };
    let raw = |name: &str| motion_at(name, 0);
    let unit = |name: &str| raw(name).normalize();
    let rotation = || M::quat([1, 2, 3, 0].map(|c| reals("r", c)));
    let unit_rotation = || M::from_rotation(rotation()).normalize().rotation();
    let (dual_quat, flat) = (wxyz::<M>, |reals: &[M::Real]| reals.to_vec());

    let columns: Vec<M::Real> = match first.op.as_str() {
        "mul" => dual_quat(raw("a") * raw("b")),
        "conj_dual" => dual_quat(raw("a").conjugate_dual()),
        "conj_quat" => dual_quat(raw("a").conjugate()),
        "conj_both" => dual_quat(raw("a").conjugate_both()),
        "norm" => flat(&M::dual_parts(raw("a").norm())),
        "normalize" => dual_quat(unit("a")),
        "inverse" => dual_quat(raw("a").inverse()),
        "from_rotation_translation" => {
            dual_quat(M::from_rotation_translation(unit_rotation(), vector("t")))
        }
        "translation" => flat(&unit("a").translation()),
        "point" => flat(&unit("a").transform_point(vector("v"))),
        "vector" => flat(&unit("a").transform_vector(vector("v"))),
        "matrix" => unit("a").to_matrix3x4().concat(),
        "line" => {
            let line = Line { direction: vector("l"), moment: vector("m") };
            let line = unit("a").transform_line(line);
            [line.direction, line.moment].concat()
        }
        "log" => {
            let log = unit("a").log();
            [log.real, log.dual].concat()
        }
        "exp" => dual_quat(M::exp(DualVector { real: vector("v"), dual: vector("m") })),
        "pow" => dual_quat(unit("a").pow(reals("t", 0))),
        "sclerp" => dual_quat(unit("a").sclerp(unit("b"), reals("t", 0))),
        "screw" => {
            let screw = unit("a").to_screw();
            let axis = [screw.axis.direction, screw.axis.moment].concat();
            [axis, vec![screw.angle, screw.slide]].concat()
        }
        "dlb" => {
            let influences: Vec<_> = (0..first.input("w").len())
                .map(|i| (motion_at("s", i).normalize(), reals("w", i)))
                .collect();
            dual_quat(M::dlb(&influences).expect("there are influences"))
        }
        "from_screw" => dual_quat(M::from_screw(Screw {
            axis: Line { direction: vector("l"), moment: vector("m") },
            angle: reals("angle", 0),
            slide: reals("slide", 0),
        })),
        "from_matrix3x4" => {
            let row = |r: usize| std::array::from_fn(|c| reals("rows", 4 * r + c));
            dual_quat(M::from_matrix3x4(std::array::from_fn(row)))
        }
        "to_matrix4" => unit("a").to_matrix4().concat(),
        "transform_plane" => {
            let plane = Plane { normal: vector("n"), offset: reals("offset", 0) };
            let plane = unit("a").transform_plane(plane);
            [&plane.normal[..], &[plane.offset]].concat()
        }
        "from_translation_rotation" => {
            dual_quat(M::from_translation_rotation(vector("t"), unit_rotation()))
        }
        "mul_rotation_translation" => {
            dual_quat(raw("a").mul_rotation_translation(rotation(), vector("t")))
        }
        "sqrt" => dual_quat(unit("a").sqrt()),
        "sclerp_long" => dual_quat(unit("a").sclerp_long(unit("b"), reals("t", 0))),
        "nlerp" => dual_quat(unit("a").nlerp(unit("b"), reals("t", 0))),
        "slerp_lerp" => dual_quat(unit("a").slerp_lerp(unit("b"), reals("t", 0))),
        "squad" => dual_quat(unit("a").squad(unit("b"), unit("c"), unit("d"), reals("t", 0))),
        "squad_control" => dual_quat(M::squad_control(unit("a"), unit("b"), unit("c"))),
        "dot" => flat(&M::dual_parts(raw("a").dot(raw("b")))),
        "add" => dual_quat(raw("a") + raw("b")),
        "sub" => dual_quat(raw("a") - raw("b")),
        "scale" => dual_quat(raw("a").scale(reals("factor", 0))),
        "scale_dual" => {
            let factor = M::dual_number(reals("factor", 0), reals("factor", 1));
            dual_quat(raw("a").scale_dual(factor))
        }
        "canonical" => dual_quat(raw("a").canonical()),
        other => panic!("{other} passed the parser"),
    };
    let columns: Vec<Vec<f64>> = columns.into_iter().map(M::lanes).collect();
    (0..vectors.len()).map(|lane| columns.iter().map(|column| column[lane]).collect()).collect()
}

fn wxyz<M: Sample>(motion: M) -> Vec<M::Real> {
    let c = motion.components();
    [3, 0, 1, 2, 7, 4, 5, 6].map(|i| c[i]).to_vec()
}

/// Whose answer may be of either sign: σ and −σ are the same motion, and the sign of a p_w near zero
/// is a matter of rounding.
const EITHER_SIGN: &[&str] = &["pow", "sclerp", "dlb", "sqrt", "from_matrix3x4"];

/// The largest error of `answer` over its components, relative to [`scale`]; NaN counts as infinite.
pub fn error(vector: &Vector, answer: &[f64]) -> f64 {
    let distance = |sign: f64| {
        let pairs = answer.iter().zip(&vector.out);
        pairs.map(|(a, b)| (sign * a - b).abs()).fold(0.0, nan_is_infinite)
    };
    let either_sign = EITHER_SIGN.contains(&vector.op.as_str());
    let absolute = if either_sign { distance(1.0).min(distance(-1.0)) } else { distance(1.0) };
    absolute / scale(vector)
}

fn nan_is_infinite(worst: f64, error: f64) -> f64 {
    if error.is_nan() { f64::INFINITY } else { worst.max(error) }
}

/// What an error is measured against: max(1, |t|), |t| the largest translation, vector or moment
/// among inputs and result, times the norms of factors that are not unit.
pub fn scale(vector: &Vector) -> f64 {
    let input = |name: &str| norm(vector.input(name));
    let real_norm = |name: &str| norm(&vector.input(name)[..4]);
    let mut length = 1.0_f64;
    for name in ["a", "b", "c", "d", "s"] {
        for sigma in vector.input(name).chunks_exact(8) {
            length = length.max(translation(sigma));
        }
    }
    for name in ["t", "v", "m"] {
        if vector.input(name).len() == 3 && vector.op != "from_screw" {
            length = length.max(input(name));
        }
    }
    match vector.op.as_str() {
        "mul" | "dot" => length * real_norm("a") * real_norm("b"),
        "mul_rotation_translation" => length * real_norm("a") * input("r"),
        "add" | "sub" => length * real_norm("a").max(real_norm("b")),
        "scale" | "scale_dual" => length * real_norm("a") * input("factor"),
        "norm" => length * real_norm("a"),
        "inverse" => length / real_norm("a"),
        // The moment of a small turn is large.
        "screw" => length.max(norm(&vector.out[3..6])),
        // And is multiplied by its sine. A sine is known to the last place of its angle.
        "from_screw" => {
            let (half, slide) = (input("angle") / 2.0, input("slide"));
            half.max(1.0) * translation(&vector.out).max(slide).max(1.0).max(half * input("m"))
        }
        // Near the antipode the axis is what is left of a difference.
        "sclerp_long" => {
            let (a, b) = (vector.input("a"), vector.input("b"));
            let dot: f64 = a.iter().zip(b).take(4).map(|(a, b)| a * b).sum();
            let cosine = (dot / (real_norm("a") * real_norm("b"))).min(0.0);
            length / (1.0 - cosine * cosine).sqrt()
        }
        "log" => length,
        "line" => length * (1.0 + input("l")),
        "transform_plane" => (length * (1.0 + input("n"))).max(input("offset")),
        _ if vector.out.len() == 8 => length.max(translation(&vector.out)),
        _ => length,
    }
}

fn norm(components: &[f64]) -> f64 {
    components.iter().map(|c| c * c).sum::<f64>().sqrt()
}

/// |t|, however long σ is; none without a real part, or the scale would be infinite and no error seen.
fn translation(sigma: &[f64]) -> f64 {
    let t = 2.0 * norm(&sigma[4..]) / norm(&sigma[..4]);
    if t.is_finite() { t } else { 0.0 }
}

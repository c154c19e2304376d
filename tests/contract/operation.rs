//! Runs an operation of the reference vectors on any implementation and measures the error.

use super::sample::Sample;
use super::vectors::Vector;
use dq8::{DualVector, Line};

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
            let r = M::quat([1, 2, 3, 0].map(|c| reals("r", c)));
            let r = M::from_rotation(r).normalize().rotation();
            dual_quat(M::from_rotation_translation(r, vector("t")))
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
        other => panic!("{other} passed the parser"),
    };
    let columns: Vec<Vec<f64>> = columns.into_iter().map(M::lanes).collect();
    (0..vectors.len()).map(|lane| columns.iter().map(|column| column[lane]).collect()).collect()
}

fn wxyz<M: Sample>(motion: M) -> Vec<M::Real> {
    let c = motion.components();
    [3, 0, 1, 2, 7, 4, 5, 6].map(|i| c[i]).to_vec()
}

/// The largest error of `answer` over its components, relative to [`scale`]; NaN counts as infinite.
pub fn error(vector: &Vector, answer: &[f64]) -> f64 {
    let distance = |sign: f64| {
        let pairs = answer.iter().zip(&vector.out);
        pairs.map(|(a, b)| (sign * a - b).abs()).fold(0.0, nan_is_infinite)
    };
    // σ and −σ are the same motion.
    let either_sign = matches!(vector.op.as_str(), "pow" | "sclerp" | "dlb");
    let absolute = if either_sign { distance(1.0).min(distance(-1.0)) } else { distance(1.0) };
    absolute / scale(vector)
}

fn nan_is_infinite(worst: f64, error: f64) -> f64 {
    if error.is_nan() { f64::INFINITY } else { worst.max(error) }
}

/// What an error is measured against: max(1, |t|), |t| the largest translation, vector or moment
/// among inputs and result, times the norms of factors that are not unit.
pub fn scale(vector: &Vector) -> f64 {
    let norm = |c: &[f64]| c.iter().map(|c| c * c).sum::<f64>().sqrt();
    let real_norm = |name: &str| norm(&vector.input(name)[..4]);
    let mut length = 1.0_f64;
    for name in ["a", "b", "s"] {
        for sigma in vector.input(name).chunks_exact(8) {
            length = length.max(2.0 * norm(&sigma[4..]) / norm(&sigma[..4]));
        }
    }
    for name in ["t", "v", "m"] {
        if vector.input(name).len() == 3 {
            length = length.max(norm(vector.input(name)));
        }
    }
    let translation_of = |sigma: &[f64]| 2.0 * norm(&sigma[4..]) / norm(&sigma[..4]);
    match vector.op.as_str() {
        "mul" => length * real_norm("a") * real_norm("b"),
        "norm" => length * real_norm("a"),
        "inverse" => length / real_norm("a"),
        // The moment of a small turn is large.
        "screw" => length.max(norm(&vector.out[3..6])),
        "log" => length,
        "line" => length * (1.0 + norm(vector.input("l"))),
        _ if vector.out.len() == 8 => length.max(translation_of(&vector.out)),
        _ => length,
    }
}

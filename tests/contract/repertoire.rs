//! Every operation of [`Motion`](dq8::Motion) by name, on any implementation, and what its rounding
//! errors are measured against.

use crate::agreement::{Kind, Scale};
use crate::inputs::{Arguments, Case};
use crate::sample::Sample;
use dq8::{DualQuat, Line};

/// The methods of the trait, then its operators.
pub const NAMES: [&str; 43] = [
    "identity",
    "from_rotation",
    "from_translation",
    "from_rotation_translation",
    "from_translation_rotation",
    "mul_rotation_translation",
    "from_matrix3x4",
    "from_screw",
    "rotation",
    "translation",
    "to_matrix3x4",
    "to_matrix4",
    "to_screw",
    "conjugate_dual",
    "conjugate",
    "conjugate_both",
    "canonical",
    "scale",
    "scale_dual",
    "dot",
    "norm",
    "normalize",
    "normalize_checked",
    "is_unit",
    "inverse",
    "inverse_checked",
    "abs_diff_eq",
    "transform_point",
    "transform_vector",
    "transform_line",
    "transform_plane",
    "nlerp",
    "dlb",
    "log",
    "exp",
    "pow",
    "sqrt",
    "sclerp",
    "sclerp_long",
    "add",
    "sub",
    "mul",
    "neg",
];

/// The operations that are defined for any dual quaternion; the others want unit ones.
pub const ALGEBRA: [&str; 15] = [
    "conjugate_dual",
    "conjugate",
    "conjugate_both",
    "canonical",
    "scale",
    "scale_dual",
    "dot",
    "norm",
    "normalize",
    "normalize_checked",
    "inverse",
    "inverse_checked",
    "add",
    "sub",
    "mul",
];

/// What an operation answers, lane by lane.
#[derive(Clone, Debug, Default)]
pub struct Answer {
    pub numbers: Vec<(Kind, Vec<f64>)>,
    /// Bit `i` is lane `i`.
    pub masks: Vec<u32>,
}

impl Answer {
    fn of<M: Sample>(kind: Kind, reals: &[M::Real]) -> Self {
        Self::default().and::<M>(kind, reals)
    }

    fn and<M: Sample>(mut self, kind: Kind, reals: &[M::Real]) -> Self {
        self.numbers.extend(reals.iter().map(|&real| (kind, M::lanes(real))));
        self
    }

    fn truth<M: Sample>(mut self, mask: M::Mask) -> Self {
        self.masks.push(M::bits(mask));
        self
    }

    fn motion<M: Sample>(motion: M) -> Self {
        let c = motion.components();
        Self::of::<M>(Kind::Plain, &c[..4]).and::<M>(Kind::Length, &c[4..])
    }

    /// A motion whose rotation may be tiny, and keeps its relative precision.
    fn small_motion<M: Sample>(motion: M) -> Self {
        let c = motion.components();
        let turn = Self::of::<M>(Kind::Turn, &c[..3]);
        turn.and::<M>(Kind::Plain, &c[3..4]).and::<M>(Kind::Length, &c[4..])
    }

    fn line<M: Sample>(line: Line<M::Real>, moment: Kind) -> Self {
        Self::of::<M>(Kind::Plain, &line.direction).and::<M>(moment, &line.moment)
    }

    fn matrix<M: Sample>(rows: &[[M::Real; 4]]) -> Self {
        rows.iter().fold(Self::default(), |answer, [x, y, z, t]| {
            answer.and::<M>(Kind::Plain, &[*x, *y, *z]).and::<M>(Kind::Length, &[*t])
        })
    }

    /// What lane `lane` answers.
    pub fn lane(&self, lane: usize) -> (Vec<(Kind, f64)>, Vec<bool>) {
        let numbers = self.numbers.iter().map(|(kind, lanes)| (*kind, lanes[lane])).collect();
        (numbers, self.masks.iter().map(|mask| mask >> lane & 1 == 1).collect())
    }
}

/// The answer of the operation `name`.
pub fn answer<M: Sample>(name: &str, x: &Arguments<M>) -> Answer {
    let quat = |quat| Answer::of::<M>(Kind::Plain, &M::quat_parts(quat));
    let checked = |(motion, failed): (M, M::Mask)| Answer::motion(motion).truth::<M>(failed);
    match name {
        "identity" => Answer::motion(M::one()),
        "from_rotation" => Answer::motion(M::from_rotation(x.a.rotation())),
        "from_translation" => Answer::motion(M::from_translation(x.v)),
        "from_rotation_translation" => {
            Answer::motion(M::from_rotation_translation(x.a.rotation(), x.v))
        }
        "from_translation_rotation" => {
            Answer::motion(M::from_translation_rotation(x.v, x.a.rotation()))
        }
        "mul_rotation_translation" => {
            Answer::motion(x.a.mul_rotation_translation(x.b.rotation(), x.v))
        }
        "from_matrix3x4" => Answer::motion(M::from_matrix3x4(x.rows)),
        "from_screw" => Answer::small_motion(M::from_screw(x.screw)),
        "rotation" => quat(x.a.rotation()),
        "translation" => Answer::of::<M>(Kind::Length, &x.a.translation()),
        "to_matrix3x4" => Answer::matrix::<M>(&x.a.to_matrix3x4()),
        "to_matrix4" => Answer::matrix::<M>(&x.a.to_matrix4()),
        "to_screw" => {
            let screw = x.a.to_screw();
            let axis = Answer::line::<M>(screw.axis, Kind::Moment);
            axis.and::<M>(Kind::Turn, &[screw.angle]).and::<M>(Kind::Length, &[screw.slide])
        }
        "conjugate_dual" => Answer::motion(x.a.conjugate_dual()),
        "conjugate" => Answer::motion(x.a.conjugate()),
        "conjugate_both" => Answer::motion(x.a.conjugate_both()),
        "canonical" => Answer::motion(x.a.canonical()),
        "scale" => Answer::motion(x.a.scale(x.s)),
        "scale_dual" => Answer::motion(x.a.scale_dual(M::dual_number(x.s, x.t))),
        "dot" | "norm" => {
            let dual = if name == "dot" { x.a.dot(x.b) } else { x.a.norm() };
            let [real, dual] = M::dual_parts(dual);
            Answer::of::<M>(Kind::Plain, &[real]).and::<M>(Kind::Length, &[dual])
        }
        "normalize" => Answer::motion(x.a.normalize()),
        "normalize_checked" => checked(x.a.normalize_checked()),
        "is_unit" => Answer::default().truth::<M>(x.a.is_unit(x.tolerance)),
        "inverse" => Answer::motion(x.a.inverse()),
        "inverse_checked" => checked(x.a.inverse_checked()),
        "abs_diff_eq" => Answer::default().truth::<M>(x.a.abs_diff_eq(x.b, x.tolerance)),
        "transform_point" => Answer::of::<M>(Kind::Length, &x.a.transform_point(x.v)),
        "transform_vector" => Answer::of::<M>(Kind::Plain, &x.a.transform_vector(x.v)),
        "transform_line" => Answer::line::<M>(x.a.transform_line(x.line()), Kind::Length),
        "transform_plane" => {
            let plane = x.a.transform_plane(x.plane());
            Answer::of::<M>(Kind::Plain, &plane.normal).and::<M>(Kind::Length, &[plane.offset])
        }
        "nlerp" => Answer::motion(x.a.nlerp(x.b, x.t)),
        "dlb" => Answer::motion(M::dlb(&x.influences()).expect("there are influences")),
        "log" => {
            let log = x.a.log();
            Answer::of::<M>(Kind::Turn, &log.real).and::<M>(Kind::Length, &log.dual)
        }
        "exp" => Answer::small_motion(M::exp(x.dual_vector())),
        "pow" => Answer::small_motion(x.a.pow(x.t)),
        "sqrt" => Answer::small_motion(x.a.sqrt()),
        "sclerp" => Answer::motion(x.a.sclerp(x.b, x.t)),
        "sclerp_long" => Answer::motion(x.a.sclerp_long(x.b, x.t)),
        "add" => Answer::motion(x.a + x.b),
        "sub" => Answer::motion(x.a - x.b),
        "mul" => Answer::motion(x.a * x.b),
        "neg" => Answer::motion(-x.a),
        other => panic!("{other} is no operation of the contract"),
    }
}

/// What an error of the operation `name` is measured against: the size that the answer, or a term
/// of the sum that it is, can have.
pub fn scale(name: &str, x: &Case) -> Scale {
    let (pa, qa, pb, qb) = (norm(&x.a[..4]), norm(&x.a[4..]), norm(&x.b[..4]), norm(&x.b[4..]));
    let length = [qa, qb, norm(&x.c[4..])].into_iter().fold(1.0, f64::max);
    let (v, w) = (norm(&x.v), norm(&x.w));
    let moment = norm(&x.screw[3..6]);
    let scale = |plain: f64, length: f64| Scale { plain, turn: plain, length, moment: length };
    match name {
        "from_translation" | "from_rotation_translation" | "from_translation_rotation" => {
            scale(1.0, v)
        }
        "mul_rotation_translation" => scale(pa * pb, pb * (qa + pa * v)),
        "from_matrix3x4" => scale(1.0, norm(&x.rows.map(|row| row[3]))),
        "from_screw" => {
            let sine = (x.screw[6] / 2.0).sin().abs();
            Scale { turn: sine, ..scale(1.0, moment * sine + x.screw[7].abs()) }
        }
        "to_screw" => {
            // m = ½ (t × l + (t − dl) cot(θ/2)), and t − dl may cancel.
            let sine = norm(&x.a[..3]);
            Scale { turn: 2.0 * sine, moment: qa / sine, ..scale(1.0, qa) }
        }
        "scale" => scale(x.s.abs() * pa, x.s.abs() * qa),
        "scale_dual" => scale(x.s.abs() * pa, x.s.abs() * qa + x.t.abs() * pa),
        "dot" | "mul" => scale(pa * pb, pa * qb + qa * pb),
        "norm" => scale(pa, qa),
        "normalize" | "normalize_checked" => scale(1.0, qa / pa),
        "inverse" | "inverse_checked" => scale(1.0 / pa, qa / (pa * pa)),
        "transform_point" => scale(1.0, v + qa),
        "transform_vector" => scale(v, 0.0),
        "transform_line" => scale(v, w + qa * v),
        "transform_plane" => scale(v, x.s.abs() + qa * v),
        // The sum may be shorter than its terms, and is divided by its length.
        "nlerp" => blend_scale(&[(x.a, 1.0 - x.t), (x.b, x.t)]),
        "dlb" => blend_scale(&[(x.a, x.weights[0]), (x.b, x.weights[1]), (x.c, x.weights[2])]),
        "log" => Scale { turn: norm(&x.a[..3]), ..scale(1.0, length) },
        // An angle is known to its last place, and so is its sine only to that of the angle.
        "exp" => Scale { turn: v, ..scale(1.0 + v, w * (1.0 + v)) },
        "pow" | "sqrt" => {
            let times = if name == "sqrt" { 1.0 } else { x.t.abs() };
            let turn = times * norm(&x.a[..3]);
            Scale { turn, ..scale(1.0 + times, length * (1.0 + times).powi(2)) }
        }
        "sclerp" => scale(1.0 + x.t.abs(), length * (1.0 + x.t.abs()).powi(2)),
        "sclerp_long" => {
            // Near the antipode the axis is what is left of a difference.
            let way = DualQuat::from_array(x.a).conjugate() * DualQuat::from_array(x.b);
            let [x0, y0, z0, w] = way.real().to_array();
            let sine = if w < 0.0 { norm(&[x0, y0, z0]) } else { 1.0 };
            let times = (1.0 + x.t.abs()) / sine;
            scale(times, length * times.powi(2))
        }
        "add" | "sub" => scale(pa + pb, qa + qb),
        _ => scale(pa, qa),
    }
}

fn blend_scale(influences: &[([f64; 8], f64)]) -> Scale {
    let (first, _) = influences[0];
    let (mut sum, mut plain, mut length) = ([0.0; 4], 0.0, 0.0);
    for (motion, weight) in influences {
        let dot: f64 = first.iter().zip(motion).take(4).map(|(a, b)| a * b).sum();
        for (total, component) in sum.iter_mut().zip(motion) {
            *total += component * weight * if dot < 0.0 { -1.0 } else { 1.0 };
        }
        plain += weight.abs();
        length += weight.abs() * norm(&motion[4..]);
    }
    let shrinks = plain / norm(&sum);
    let length = (length / plain) * shrinks.powi(2);
    Scale { plain: shrinks, turn: shrinks, length, moment: length }
}

fn norm(components: &[f64]) -> f64 {
    components.iter().map(|c| c * c).sum::<f64>().sqrt()
}

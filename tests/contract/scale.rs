//! What errors are measured against: the size of answers, and of the terms of the sums that they
//! are.

use crate::bound::Scale;
use crate::case::{Case, length};
use crate::vectors::Vector;
use dq8::DualQuat;

/// |p| and |q| of a, b and c.
pub fn norms(x: &Case) -> [(f64, f64); 3] {
    [x.a, x.b, x.c].map(|m| (length(&m[..4]), length(&m[4..])))
}

/// For unit motions, and what does not grow with them.
pub fn one(_: &Case) -> Scale {
    Scale::new(1.0, 0.0)
}

/// The size of a.
pub fn of_a(x: &Case) -> Scale {
    let [(pa, qa), ..] = norms(x);
    Scale::new(pa, qa)
}

/// The size of v, for what is made of it.
pub fn of_v(x: &Case) -> Scale {
    Scale::new(1.0, length(&x.v))
}

pub fn times_rotation_translation(x: &Case) -> Scale {
    let [(pa, qa), (pb, _), _] = norms(x);
    Scale::new(pa * pb, pb * (qa + pa * length(&x.v)))
}

pub fn of_rows(x: &Case) -> Scale {
    Scale::new(1.0, length(&x.rows.map(|row| row[3])))
}

pub fn from_screw(x: &Case) -> Scale {
    let sine = (x.screw[6] / 2.0).sin().abs();
    let moment = length(&x.screw[3..6]);
    Scale { turn: sine, ..Scale::new(1.0, moment * sine + x.screw[7].abs()) }
}

/// m = ½ (t × l + (t − dl) cot(θ/2)), and t − dl may cancel.
pub fn to_screw(x: &Case) -> Scale {
    let [(_, qa), ..] = norms(x);
    let sine = length(&x.a[..3]);
    Scale { turn: 2.0 * sine, moment: qa / sine, ..Scale::new(1.0, qa) }
}

pub fn scaled(x: &Case) -> Scale {
    let [(pa, qa), ..] = norms(x);
    Scale::new(x.s.abs() * pa, x.s.abs() * qa)
}

pub fn scaled_dual(x: &Case) -> Scale {
    let [(pa, qa), ..] = norms(x);
    Scale::new(x.s.abs() * pa, x.s.abs() * qa + x.t.abs() * pa)
}

pub fn sum(x: &Case) -> Scale {
    let [(pa, qa), (pb, qb), _] = norms(x);
    Scale::new(pa + pb, qa + qb)
}

pub fn product(x: &Case) -> Scale {
    let [(pa, qa), (pb, qb), _] = norms(x);
    Scale::new(pa * pb, pa * qb + qa * pb)
}

/// For results that do not grow with |p|.
pub fn quotient(x: &Case) -> Scale {
    let [(pa, qa), ..] = norms(x);
    Scale::new(1.0, qa / pa)
}

pub fn inverse(x: &Case) -> Scale {
    let [(pa, qa), ..] = norms(x);
    Scale::new(1.0 / pa, qa / (pa * pa))
}

pub fn point(x: &Case) -> Scale {
    let [(_, qa), ..] = norms(x);
    Scale::new(1.0, length(&x.v) + qa)
}

pub fn direction(x: &Case) -> Scale {
    Scale::new(length(&x.v), 0.0)
}

pub fn line(x: &Case) -> Scale {
    let ([(_, qa), ..], v) = (norms(x), length(&x.v));
    Scale::new(v, length(&x.w) + qa * v)
}

pub fn plane(x: &Case) -> Scale {
    let ([(_, qa), ..], v) = (norms(x), length(&x.v));
    Scale::new(v, x.s.abs() + qa * v)
}

pub fn nlerp(x: &Case) -> Scale {
    blend(&[(x.a, 1.0 - x.t), (x.b, x.t)])
}

pub fn dlb(x: &Case) -> Scale {
    let [wa, wb, wc, _] = x.weights;
    blend(&[(x.a, wa), (x.b, wb), (x.c, wc)])
}

/// The sum may be shorter than its terms, and is divided by its length.
fn blend(influences: &[([f64; 8], f64)]) -> Scale {
    let (first, _) = influences[0];
    let (mut sum, mut plain, mut far) = ([0.0; 4], 0.0, 0.0);
    for (motion, weight) in influences {
        let dot: f64 = first.iter().zip(motion).take(4).map(|(a, b)| a * b).sum();
        for (total, component) in sum.iter_mut().zip(motion) {
            *total += component * weight * if dot < 0.0 { -1.0 } else { 1.0 };
        }
        plain += weight.abs();
        far += weight.abs() * length(&motion[4..]);
    }
    let shrinks = plain / length(&sum);
    Scale::new(shrinks, (far / plain) * shrinks.powi(2))
}

/// max(1, |q|) over a, b and c.
fn far(x: &Case) -> f64 {
    norms(x).iter().fold(1.0, |far, (_, q)| far.max(*q))
}

pub fn log(x: &Case) -> Scale {
    Scale { turn: length(&x.a[..3]), ..Scale::new(1.0, far(x)) }
}

/// An angle is known to its last place, and so is its sine only to that of the angle.
pub fn exp(x: &Case) -> Scale {
    let (v, w) = (length(&x.v), length(&x.w));
    Scale { turn: v, ..Scale::new(1.0 + v, w * (1.0 + v)) }
}

pub fn pow(x: &Case) -> Scale {
    power(x, x.t.abs())
}

pub fn sqrt(x: &Case) -> Scale {
    power(x, 1.0)
}

fn power(x: &Case, times: f64) -> Scale {
    let turn = times * length(&x.a[..3]);
    Scale { turn, ..Scale::new(1.0 + times, far(x) * (1.0 + times).powi(2)) }
}

pub fn sclerp(x: &Case) -> Scale {
    let times = 1.0 + x.t.abs();
    Scale::new(times, far(x) * times.powi(2))
}

/// Near the antipode the axis is what is left of a difference.
pub fn sclerp_long(x: &Case) -> Scale {
    let way = DualQuat::from_array(x.a).conjugate() * DualQuat::from_array(x.b);
    let [x0, y0, z0, w] = way.real().to_array();
    let sine = if w < 0.0 { length(&[x0, y0, z0]) } else { 1.0 };
    let times = (1.0 + x.t.abs()) / sine;
    Scale::new(times, far(x) * times.powi(2))
}

/// max(1, |t|) over some motions, |t| = 2|q|.
pub fn farthest(motions: &[[f64; 8]]) -> f64 {
    motions.iter().map(|m| 2.0 * length(&m[4..])).fold(1.0, f64::max)
}

/// max(1, |t|) over all four motions.
pub fn poses(x: &Case) -> Scale {
    Scale::new(1.0, farthest(&[x.a, x.b, x.c, x.d]))
}

/// π for the angle, max(1, |t|) over a and b for lengths.
pub fn apart(x: &Case) -> Scale {
    Scale::new(std::f64::consts::PI, farthest(&[x.a, x.b]))
}

/// As [`apart`], and |v| for points; the radius of a shell is no longer than that of v.
pub fn points_apart(x: &Case) -> Scale {
    Scale::new(1.0, apart(x).length + length(&x.v))
}

/// |ω| and |v| of both twists, |p| and |q| of a and of its derivative.
fn rates(x: &Case) -> [(f64, f64); 4] {
    let halves = |c: &[f64], at: usize| (length(&c[..at]), length(&c[at..]));
    [halves(&x.x, 3), halves(&x.y, 3), halves(&x.a, 4), halves(&x.derivative, 4)]
}

pub fn derivative(x: &Case) -> Scale {
    let [(angular, linear), _, (p, q), _] = rates(x);
    Scale::new(angular * p, angular * q + linear * p)
}

pub fn twist_of_derivative(x: &Case) -> Scale {
    let [.., (p, q), (p_rate, q_rate)] = rates(x);
    Scale::new(2.0 * p_rate * p, 2.0 * (p_rate * q + q_rate * p))
}

pub fn velocity(x: &Case) -> Scale {
    let [.., (p, q), (p_rate, q_rate)] = rates(x);
    Scale::new(2.0 * p_rate * p, 2.0 * (2.0 * p_rate * q + q_rate * p))
}

/// An angle is known to its last place, and so is its sine only to that of the angle.
pub fn from_twist(x: &Case) -> Scale {
    let [(angular, linear), ..] = rates(x);
    Scale::new(1.0 + angular, (1.0 + angular) * linear)
}

pub fn to_twist(x: &Case) -> Scale {
    let [.., (_, q), _] = rates(x);
    Scale::new(1.0, 1.0_f64.max(2.0 * q))
}

pub fn integrate(x: &Case) -> Scale {
    let [(angular, linear), _, (_, q), _] = rates(x);
    let (angular, linear) = (angular * x.dt.abs(), linear * x.dt.abs());
    Scale::new(1.0 + angular, (1.0 + angular) * (linear + q))
}

pub fn adjoint(x: &Case) -> Scale {
    let [(angular, linear), _, (_, q), _] = rates(x);
    Scale::new(angular, linear + 2.0 * q * angular)
}

pub fn coadjoint(x: &Case) -> Scale {
    let [.., (_, q), _] = rates(x);
    let (force, torque) = (length(&x.wrench[..3]), length(&x.wrench[3..]));
    Scale::new(force, torque + 2.0 * q * force)
}

pub fn jacobian(x: &Case) -> Scale {
    let [(angular, linear), (along, along_linear), ..] = rates(x);
    let turns = 1.0 + angular;
    Scale::new(turns * along, turns * (along_linear + linear * along))
}

/// (θ/2)/sin(θ/2): every step from C to its derivative goes with one more.
pub fn jacobian_inverse(x: &Case) -> Scale {
    let [(angular, linear), (along, along_linear), ..] = rates(x);
    let grows = grows(angular);
    let plain = grows.powi(2);
    Scale::new(plain * along, plain * along_linear + grows.powi(3) * linear * along)
}

/// (θ/2)/sin(θ/2) grows without end towards 2π.
pub fn grows(angle: f64) -> f64 {
    let half = angle / 2.0;
    if half < 1e-3 { 1.0 } else { (half / half.sin()).abs().max(1.0) }
}

/// Scales of the reference vectors: from max(1, |t|) to what errors are measured against.
pub mod of_digits {
    use super::{Vector, grows, length};
    use crate::vectors::translation;

    /// A motion may be farther away than what it was made of.
    pub fn plain(vector: &Vector, far: f64) -> f64 {
        if vector.out.len() == 8 { far.max(translation(&vector.out)) } else { far }
    }

    pub fn product(vector: &Vector, far: f64) -> f64 {
        far * vector.real_norm("a") * vector.real_norm("b")
    }

    pub fn product_with_rotation(vector: &Vector, far: f64) -> f64 {
        far * vector.real_norm("a") * vector.norm("r")
    }

    pub fn sum(vector: &Vector, far: f64) -> f64 {
        far * vector.real_norm("a").max(vector.real_norm("b"))
    }

    pub fn scaled(vector: &Vector, far: f64) -> f64 {
        far * vector.real_norm("a") * vector.norm("factor")
    }

    pub fn norm(vector: &Vector, far: f64) -> f64 {
        far * vector.real_norm("a")
    }

    pub fn inverse(vector: &Vector, far: f64) -> f64 {
        far / vector.real_norm("a")
    }

    /// The moment of a small turn is large.
    pub fn to_screw(vector: &Vector, far: f64) -> f64 {
        far.max(length(&vector.out[3..6]))
    }

    /// And is multiplied by its sine. A sine is known to the last place of its angle.
    pub fn from_screw(vector: &Vector, _: f64) -> f64 {
        let (half, slide) = (vector.norm("angle") / 2.0, vector.norm("slide"));
        let far = translation(&vector.out).max(slide).max(1.0);
        half.max(1.0) * far.max(half * vector.norm("m"))
    }

    /// Near the antipode the axis is what is left of a difference.
    pub fn sclerp_long(vector: &Vector, far: f64) -> f64 {
        let (a, b) = (vector.input("a"), vector.input("b"));
        let dot: f64 = a.iter().zip(b).take(4).map(|(a, b)| a * b).sum();
        let cosine = (dot / (vector.real_norm("a") * vector.real_norm("b"))).min(0.0);
        far / (1.0 - cosine * cosine).sqrt()
    }

    pub fn line(vector: &Vector, far: f64) -> f64 {
        far * (1.0 + vector.norm("l"))
    }

    pub fn plane(vector: &Vector, far: f64) -> f64 {
        (far * (1.0 + vector.norm("n"))).max(vector.norm("offset"))
    }

    /// An angle is as small as the turns that it is between, and keeps its relative precision.
    pub fn angle(vector: &Vector, _: f64) -> f64 {
        let turns = length(&vector.input("a")[1..4]) + length(&vector.input("b")[1..4]);
        // Below the normal numbers the last place no longer shrinks.
        turns.max(f32::MIN_POSITIVE.into())
    }

    /// A radian is worth a length.
    pub fn weighted(vector: &Vector, far: f64) -> f64 {
        far + std::f64::consts::PI * vector.norm("length_per_radian")
    }

    pub fn shell(vector: &Vector, far: f64) -> f64 {
        far + vector.norm("radius")
    }

    /// Of a twist or velocity at a pose, which may be carried elsewhere.
    pub fn derivative(vector: &Vector, far: f64) -> f64 {
        far * vector.norm("angular") + vector.norm("linear")
    }

    pub fn twist_of_derivative(vector: &Vector, far: f64) -> f64 {
        let rate = vector.input("derivative");
        2.0 * (far * length(&rate[..4]) + length(&rate[4..]))
    }

    /// An angle is known to its last place, and so is its sine only to that of the angle.
    pub fn from_twist(vector: &Vector, _: f64) -> f64 {
        (1.0 + vector.norm("angular")) * vector.norm("linear").max(1.0)
    }

    pub fn integrate(vector: &Vector, far: f64) -> f64 {
        let dt = vector.norm("dt");
        (1.0 + dt * vector.norm("angular")) * (far + dt * vector.norm("linear"))
    }

    pub fn coadjoint(vector: &Vector, far: f64) -> f64 {
        far * vector.norm("force") + vector.norm("torque")
    }

    pub fn jacobian(vector: &Vector, _: f64) -> f64 {
        let along = vector.norm("along_angular");
        let once = vector.norm("along_linear") + vector.norm("linear") * along;
        (1.0 + vector.norm("angular")) * along.max(once)
    }

    pub fn jacobian_inverse(vector: &Vector, _: f64) -> f64 {
        let (along, grows) = (vector.norm("along_angular"), grows(vector.norm("angular")));
        let once = vector.norm("along_linear") + grows * vector.norm("linear") * along;
        grows.powi(2) * along.max(once)
    }
}

//! [`judge`]: what an answer is held to: the bound of its operation where its input is what the
//! operation is for, and elsewhere what is promised for any input.

use crate::draw::Draw;
use dq8_contract::bound::{Kind, Scale, distance, largest, largest_half_angle};
use dq8_contract::case::{Case, length};
use dq8_contract::implementation::On;
use dq8_contract::operation::{Held, Operation, Sign};
use std::f64::consts::PI;

/// What one lane answers: numbers and truth values.
pub(crate) type Lane = (Vec<(Kind, f64)>, Vec<bool>);

/// One case, as numbers of one precision.
pub(crate) struct Question {
    pub(crate) draw: Draw,
    pub(crate) case: Case,
    /// Whether every number that the operation is given is finite.
    pub(crate) finite: bool,
    /// What the scalar path answers in `f64`.
    pub(crate) truth: Lane,
    /// And with tolerances a little smaller and larger.
    pub(crate) masks_about: [Vec<bool>; 2],
}

/// What is wrong with an answer, and by how much, in units of what is allowed.
pub(crate) fn judge(
    operation: &Operation,
    on: On,
    question: &Question,
    got: &Lane,
) -> Option<(f64, &'static str)> {
    let (case, (truth, _)) = (&question.case, &question.truth);
    let [less, more] = &question.masks_about;
    let scale = scale(operation, case);
    // How many steps a mean takes is a matter of rounding; what has no room in the type fails.
    let sizes = [&case.a[..4], &case.a[4..]].map(length);
    let said = operation.name != "dib"
        && scale.length.max(scale.plain).max(sizes[0] * sizes[1]) <= 0.25 * largest(on.single);
    if said && less == more && got.1 != *less && !case.is_at_the_end(on.single) {
        return Some((f64::INFINITY, "another truth value"));
    }
    let any = |numbers: &[(Kind, f64)]| numbers.iter().any(|(_, number)| !number.is_finite());
    if !question.finite {
        // An infinity may be a sum of finite numbers that overflowed, and NaN twice a number that
        // is nearly the largest, times nothing.
        let doubled =
            case.a[..4].iter().any(|c| c.is_finite() && c.abs() > 0.5 * largest(on.single));
        let lost = truth.iter().any(|(_, number)| number.is_nan()) && !any(&got.0) && !doubled;
        return lost.then_some((f64::INFINITY, "finite, of what is not"));
    }
    // What is documented to have no answer.
    let none = match operation.name {
        "normalize" | "normalize_checked" | "inverse" | "inverse_checked" => {
            case.a[..4].iter().all(|c| *c == 0.0)
        }
        name if name == "exp" || name == "from_twist" || name.starts_with("integrate") => {
            on.name.starts_with("lanes")
                && half_angle(operation.name, case) > 1.001 * largest_half_angle(on.single)
        }
        _ => false,
    };
    if none {
        return (!any(&got.0)).then_some((f64::INFINITY, "an answer where there is none"));
    }
    let allowed = allowed(operation, case);
    // Where nothing is left of what the answer is made of, it is a motion, and no more than that.
    let left = scale.plain * allowed * on.roundoff() < 0.1 || question.draw == Draw::General;
    if left && is_held(operation, on, question) {
        let error = error(operation, on, &scale, truth, &got.0) / allowed;
        return (error > 1.0).then_some((error, "beyond its bound"));
    }
    let normalizes = matches!(operation.name, "normalize" | "normalize_checked" | "nlerp" | "dlb");
    if operation.answers_units()
        && (normalizes || question.draw.is_unit())
        && (operation.name != "squad" || has_room("squad", on, case))
    {
        let p: Vec<_> = got.0[..4].iter().map(|(_, number)| *number).collect();
        // Through the neighbourhood of whole turns, where an axis is known to fewer digits.
        let lost = if operation.name.starts_with("squad") { 16.0 } else { 1.0 };
        let off = (length(&p) - 1.0).abs() / on.roundoff() / scale.plain.max(1.0) / allowed / lost;
        return (off > 1.0 && !any(&got.0)).then_some((off, "neither unit nor NaN"));
    }
    None
}

/// In units of u · scale. Bounds are one and a half times the worst of 10⁵ answers; so many more
/// reach farther. Where lanes are held to the scalar reference of the same precision, that has its
/// own error.
fn allowed(operation: &Operation, case: &Case) -> f64 {
    let of = |held: &Held| match held {
        Held::TakesAny { .. } => 0.0,
        Held::Scalar(bound) => bound.units,
        Held::Double { bounds, .. } => bounds.iter().map(|bound| bound.units).fold(0.0, f64::max),
        Held::Digits { bounds, .. } => bounds.iter().map(|bound| bound.units).fold(0.0, f64::max),
    };
    // That bound is for parameters from 0 to 1.
    let beyond = if operation.name == "slerp_lerp" { (1.0 + case.t.abs()).powi(2) } else { 1.0 };
    // A number below the normal ones is rounded, though it be only halved.
    (2.0 * beyond * operation.bounds.iter().map(of).sum::<f64>()).max(1.0)
}

/// What the error is measured against.
fn scale(operation: &Operation, case: &Case) -> Scale {
    let scale = (operation.scale)(case);
    match operation.name {
        "distance_weighted" => Scale { length: scale.length + PI * case.s.abs(), ..scale },
        "shell_error" => Scale { length: scale.length + case.radius.abs(), ..scale },
        // An angle is known to its last place.
        "from_screw" => {
            let turns = 1.0 + 0.5 * case.screw[6].abs();
            let [plain, turn] = [scale.plain, scale.turn.max(turns - 1.0)].map(|size| size * turns);
            Scale {
                plain,
                turn,
                length: turns * (scale.length + length(&case.screw[3..6])),
                ..scale
            }
        }
        // |p|² may be no number.
        "inverse" | "inverse_checked" => {
            let [p, q] = [&case.a[..4], &case.a[4..]].map(length);
            Scale::new(1.0 / p, q / p / p)
        }
        _ => scale,
    }
}

/// Whether what is multiplied on the way is among the normal numbers, or nothing: below them digits
/// are lost, beyond them everything.
fn has_room(name: &str, on: On, case: &Case) -> bool {
    let least = if on.single { 2.0_f64.powi(-100) } else { 2.0_f64.powi(-960) };
    let fits = |number: f64| number == 0.0 || (least..1.0 / least).contains(&number.abs());
    // What becomes zero of numbers that are not has no room either.
    let product = |a: f64, b: f64| a == 0.0 || b == 0.0 || (a * b != 0.0 && fits(a * b));
    let [p, q] = [&case.a[..4], &case.a[4..]].map(length);
    match name {
        "squad" => (0.0..=1.0).contains(&case.t),
        // They fail as a whole where a component of the answer is none.
        "normalize" | "normalize_checked" => fits(q) && q / p < largest(on.single) / 64.0,
        "inverse" | "inverse_checked" => {
            fits(q) && (q / p / p).max(1.0 / p) < largest(on.single) / 64.0
        }
        "dlb" | "dlb_running" | "dib" => {
            let sizes = [case.a, case.b, case.c, case.d].map(|motion| length(&motion[4..]));
            let weights = &case.weights;
            let fit = |weight: &f64| sizes.iter().all(|&size| product(*weight, size));
            weights.iter().all(|weight| *weight > least) && weights.iter().all(fit)
        }
        "from_screw" => fits(case.screw[6]),
        "to_screw" => fits(length(&case.a[..3])) && fits(q),
        "mul_rotation_translation" => {
            let ([r, v], p) = ([length(&case.b[..4]), length(&case.v)], p.max(q));
            let pairs = [(p, v), (r, v), (p, r), (p * v, r), (p * r, v)];
            [p, q, v, r].into_iter().all(fits) && pairs.into_iter().all(|(a, b)| product(a, b))
        }
        _ => true,
    }
}

/// Whether its bound holds for such a case.
fn is_held(operation: &Operation, on: On, question: &Question) -> bool {
    let (name, case) = (operation.name, &question.case);
    let of_a_cluster = ["dib", "dlb_running", "squad", "squad_control"].contains(&name);
    let whole_turn = name.ends_with("jacobian_inverse") && case.angle() > 6.25;
    let in_domain =
        question.draw.is_unit() || question.draw == Draw::General && operation.is_algebra();
    in_domain
        && !whole_turn
        && (!of_a_cluster || question.draw == Draw::Close)
        && !operation.is_a_tie(on, case)
        && has_room(name, on, case)
        && half_angle(name, case) < 0.999 * largest_half_angle(on.single)
}

/// How far the operation turns.
fn half_angle(name: &str, case: &Case) -> f64 {
    match name {
        "pow" | "sclerp" | "sclerp_long" | "slerp_lerp" => 3.2 * case.t.abs(),
        "exp" => length(&case.v),
        "from_screw" => 0.5 * case.screw[6].abs(),
        "from_twist" => 0.5 * case.angle(),
        // The length of the twist itself may be no number.
        _ if name.starts_with("integrate") => {
            let [x, y, z, ..] = case.x;
            length(&[x, y, z].map(|rate| 0.5 * rate * case.dt))
        }
        _ if name.contains("jacobian") => 0.5 * case.angle(),
        _ => 0.0,
    }
}

/// The largest error over what it is measured against; no number that the type has no room for is
/// asked of it.
fn error(
    operation: &Operation,
    on: On,
    scale: &Scale,
    truth: &[(Kind, f64)],
    got: &[(Kind, f64)],
) -> f64 {
    let with_sign = |sign: f64| {
        let pairs = got.iter().zip(truth).filter(|((kind, _), (_, truth))| {
            *kind != Kind::Count
                && truth.is_finite()
                && scale.of(*kind) <= largest(on.single) / 64.0
        });
        pairs.fold(0.0, |worst: f64, (&(kind, got), &(_, truth))| {
            worst.max(distance(sign * got, truth, scale.of(kind), on.single))
        })
    };
    match operation.double() {
        Some((_, Sign::Either, _)) => with_sign(1.0).min(with_sign(-1.0)),
        _ => with_sign(1.0),
    }
}

/// How large the dual quaternions are that truth values are about.
pub(crate) fn size(case: &Case) -> f64 {
    [case.a, case.b].as_flattened().iter().fold(case.tolerance.abs(), |size, c| size.max(c.abs()))
}

//! Turns as far as numbers go: a motion on lanes is unit or, beyond the documented half angle, NaN
//! in every component; never anything between. Up to there it is that of the scalar reference. Only
//! between ends that are close do lanes keep what these lack of unit length.

use dq8::storage::{Aos, Element};
use dq8::{Backend, DualQuat, Quat, Real, Scalar, Twist, scalar::MatrixError};
use dq8_contract::bound::{largest, largest_half_angle, unit_roundoff};
use dq8_contract::case::Case;
use dq8_contract::implementation::{On, implementations, scalar_f64};
use dq8_contract::operation::{Argument, Domain, Operation};
use dq8_contract::operations::{OPERATIONS, operation};

/// Half angles from 0.7 to the largest number, none at the limit itself.
fn half_angles(single: bool) -> impl Iterator<Item = f64> {
    let rising = std::iter::successors(Some(0.7), |half| Some(1.37 * half));
    let all = rising.take_while(move |&half| half <= largest(single)).chain([largest(single)]);
    all.filter(move |half| (half / largest_half_angle(single) - 1.0).abs() > 1e-3)
}

/// Unit, or wholly NaN if it may be.
fn assert_unit_or_nan(what: &str, single: bool, half: f64, pose: [f64; 8]) {
    if half > largest_half_angle(single) {
        assert!(pose.iter().all(|c| c.is_nan()), "{what} of {half:e}: {pose:?}");
        return;
    }
    let [p, q] = [&pose[..4], &pose[4..]];
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let epsilon = 2.0 * unit_roundoff(single);
    let (norm, along, size) = (dot(p, p).sqrt(), dot(p, q), dot(q, q).sqrt());
    assert!((norm - 1.0).abs() < 8.0 * epsilon, "{what} of {half:e}: |p| = {norm}");
    assert!(along.abs() < 16.0 * epsilon * size.max(1.0), "{what} of {half:e}: p·q = {along:e}");
}

const AXIS: [f64; 3] = [0.36, 0.48, 0.8];
const MOMENT: [f64; 3] = [0.3, -0.5, 0.1];

/// A turn whose half angle is 1.
fn radian() -> DualQuat<f64> {
    DualQuat::from_rotation_translation(Quat::from_axis_angle(AXIS, 2.0), MOMENT)
}

/// Of whole operations; up to there `exp` is what the textbook makes of it, and `differential_fuzz`
/// holds the others to the scalar path.
#[test]
fn lanes_turn_as_far_as_numbers_are_known_and_no_farther() {
    let identity = DualQuat::IDENTITY.to_array();
    for on in implementations() {
        for half in half_angles(on.single) {
            let [x, y, z] = AXIS.map(|c| half * c);
            let [mx, my, mz] = MOMENT;
            let case = Case {
                t: half,
                v: [x, y, z],
                w: MOMENT,
                x: [2.0 * x, 2.0 * y, 2.0 * z, mx, my, mz],
                dt: 1.0,
                screw: [AXIS[0], AXIS[1], AXIS[2], -0.48, 0.36, 0.0, 2.0 * half, 0.1],
                ..Case::of_motions(identity, radian().to_array(), identity)
            };
            let power = Case { a: case.b, ..case };
            for (name, case) in [
                ("exp", case),
                ("pow", power),
                ("sclerp", case),
                ("sclerp_long", case),
                ("from_twist", case),
                ("from_screw", case),
                ("integrate_spatial", power),
                ("integrate_body", power),
            ] {
                // Twice the half angle may be infinite, and the reference of single numbers knows
                // every angle.
                let is_number = 2.0 * half < largest(on.single);
                let lanes = on.name.starts_with("lanes");
                if !matches!(name, "exp" | "pow" | "sclerp" | "sclerp_long") && !is_number
                    || !lanes && (name != "exp" || on.name.starts_with("textbook"))
                {
                    continue;
                }
                let (numbers, _) = operation(name).answer(on, &[case]).lane(0);
                let pose = std::array::from_fn(|c| numbers[c].1);
                assert_unit_or_nan(&format!("{on:?} {name}"), on.single, half, pose);
                if name == "exp" && half <= largest_half_angle(on.single) {
                    let is_book =
                        |book: &On| book.name.starts_with("textbook") && book.single == on.single;
                    let book = implementations().into_iter().find(is_book).expect("the textbook");
                    let (numbers, _) = operation(name).answer(book, &[case]).lane(0);
                    let by_the_book = std::array::from_fn(|c| numbers[c].1);
                    let [pose, book] = [pose, by_the_book].map(DualQuat::from_array);
                    let bound = 8.0 * unit_roundoff(on.single) * half.max(1.0);
                    let apart = pose.angle_to(book);
                    assert!(apart < bound, "{on:?}: {apart:e} at {half:e}");
                }
            }
        }
    }
}

/// The slice kernel, whose lanes are those of the CPU.
fn every_backend_ends_at_the_same_parameter<R>()
where
    R: Scalar + Element<1, Layout = Aos<R>>,
{
    let real = <R as Real>::from_f64;
    let turn = Quat::from_axis_angle(AXIS.map(real), R::TWO);
    let radian = DualQuat::from_rotation_translation(turn, MOMENT.map(real));
    let parameters: Vec<R> = half_angles(R::SINGLE).map(real).collect();
    let (from, to) = (vec![DualQuat::IDENTITY; parameters.len()], vec![radian; parameters.len()]);
    for backend in Backend::available() {
        let mut poses = from.clone();
        let mut hold = |what: &str, run: &dyn Fn(&mut [DualQuat<R>])| {
            run(&mut poses);
            for (pose, half) in poses.iter().zip(half_angles(R::SINGLE)) {
                let pose = pose.to_array().map(Into::into);
                assert_unit_or_nan(&format!("{backend} {what}"), R::SINGLE, half, pose);
            }
        };
        let fits = "lengths fit";
        hold("sclerp_each", &|out| {
            backend.sclerp_each(&from, &to, &parameters, out).expect(fits);
        });
        hold("pow_each", &|out| backend.pow_each(&to, &parameters, out).expect(fits));
        hold("sclerp", &|out| {
            for (i, &t) in parameters.iter().enumerate() {
                backend.sclerp(&from[..1], &to[..1], t, &mut out[i..=i]).expect(fits);
            }
        });
        hold("integrate_body", &|out| {
            // Half of ω is 1.
            let twist = Twist { angular: [0.72, 0.96, 1.6].map(real), linear: [R::ZERO; 3] };
            for (i, &t) in parameters.iter().enumerate() {
                let twists = [twist.to_array()];
                backend.integrate_body(&from[..1], &twists, t, &mut out[i..=i]).expect(fits);
            }
        });
    }
}

#[test]
fn slices_turn_as_far_on_every_backend() {
    every_backend_ends_at_the_same_parameter::<f32>();
    every_backend_ends_at_the_same_parameter::<f64>();
}

/// An infinite tolerance takes any matrix of finite numbers whose products are finite, and no
/// other.
#[test]
fn no_tolerance_makes_a_motion_of_what_is_not_finite() {
    let (inf, nan) = (f32::INFINITY, f32::NAN);
    let rigid = [[1.0, 0.0, 0.0, 1.0], [0.0, 1.0, 0.0, 2.0], [0.0, 0.0, 1.0, 3.0]];
    assert!(DualQuat::try_from_matrix3x4(rigid, inf).is_ok());
    for bad in [inf, -inf, nan, f32::MAX, -f32::MAX] {
        for index in 0..9 {
            let mut rows = rigid;
            rows[index / 3][index % 3] = bad;
            let refused = DualQuat::try_from_matrix3x4(rows, inf);
            assert!(matches!(refused, Err(MatrixError::NotOrthonormal { .. })), "{refused:?}");
        }
        assert!(DualQuat::try_from_matrix3x4([[bad; 4]; 3], inf).is_err());
    }
}

/// However small the turn; where |t| over the angle overflows, the moment says so and the logarithm
/// still has the way back.
#[test]
fn the_axis_of_the_smallest_turns_is_unit_and_the_moment_overflows_as_documented() {
    for places in [1, 3, 100, 1 << 22] {
        let c = |factor: f32| factor * places as f32 * f32::from_bits(1);
        let turn = Quat::from_xyzw(c(3.0), c(-5.0), c(4.0), 1.0);
        let pose = DualQuat::from_rotation_translation(turn, [1.0, 0.0, 0.0]);
        let screw = pose.to_screw();
        for (got, wanted) in screw.axis.direction.into_iter().zip([3.0, -5.0, 4.0]) {
            let wanted = wanted / 50.0_f64.sqrt();
            assert!(
                (f64::from(got) - wanted).abs() < 0.75 * f64::from(f32::EPSILON),
                "{places}: {screw:?}"
            );
        }
        let overflows = 1.0 / f64::from(screw.angle) > f64::from(f32::MAX);
        assert_eq!(!screw.axis.moment.iter().all(|c| c.is_finite()), overflows, "{screw:?}");
        assert!(DualQuat::exp(pose.log()).abs_diff_eq(pose, 0.75 * f32::EPSILON));
    }
}

/// Half the angle between the ends: from none, by such as have no square, to nearly half a turn.
const HALF_ANGLES: [f64; 9] = [0.0, 1e-30, 1e-22, 1e-19, 1e-9, 1e-4, 0.05, 0.7, 1.5];

/// Whether it takes unit motions and a number, and answers a motion.
fn has_parameter(operation: &Operation) -> bool {
    let case = Case::of_motions([0.0; 8], [0.0; 8], [0.0; 8]);
    let answer = operation.answer(scalar_f64(), &[case]);
    let of = |domain: Domain, numbers: usize| {
        let is = |argument: &Argument| (argument.domain, argument.numbers) == (domain, numbers);
        operation.arguments.iter().any(is)
    };
    answer.numbers.len() == 8 && of(Domain::Unit, 8) && of(Domain::Other, 1)
}

/// Of all operations of the table, by every implementation: ends close together and far apart, and
/// parameters from half to the largest number, of either sign.
#[test]
fn every_operation_with_a_parameter_is_unit_or_nan_however_far_it_goes() {
    let operations: Vec<_> = OPERATIONS.iter().filter(|&each| has_parameter(each)).collect();
    let names: Vec<_> = operations.iter().map(|operation| operation.name).collect();
    let known = ["nlerp", "slerp_lerp", "squad", "pow", "sclerp", "sclerp_long"];
    assert_eq!(names[..6], known, "{names:?}");
    assert_eq!(names[6..], ["integrate_spatial", "integrate_body"], "{names:?}");
    for on in implementations() {
        let largest = largest(on.single);
        let factor = if on.single { 1.9 } else { 7.1 };
        let sizes = std::iter::successors(Some(0.5), |t| Some(factor * t));
        let sizes: Vec<f64> = sizes.take_while(|&t| t < largest).chain([largest]).collect();
        for half in HALF_ANGLES {
            let (a, b) = apart_by(half);
            let far = |t: f64| Case { d: b, s: t, t, dt: t, ..Case::of_motions(a, b, a) };
            let cases = sizes.iter().flat_map(|&t| [t, -t]).map(|t| far(t).rounded(on));
            let cases: Vec<Case> = cases.collect();
            for operation in &operations {
                for chunk in cases.chunks(on.lanes) {
                    let answer = operation.answer(on, chunk);
                    for (lane, case) in chunk.iter().enumerate() {
                        let (numbers, _) = answer.lane(lane);
                        judge(on, operation, case, half, std::array::from_fn(|c| numbers[c].1));
                    }
                }
            }
        }
    }
}

/// Two motions of which one is turned by twice `half` against the other.
fn apart_by(half: f64) -> ([f64; 8], [f64; 8]) {
    let turn = |axis, angle| DualQuat::from_rotation(Quat::from_axis_angle(axis, angle));
    let start = DualQuat::from_translation([0.2, 0.1, -0.4]) * turn([0.6, 0.0, 0.8], 0.9);
    let step = DualQuat::from_translation([0.3, -0.5, 0.1]) * turn([0.36, 0.48, 0.8], 2.0 * half);
    // Beside the identity a tiny turn has all its digits.
    if half < 1e-6 {
        ([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0], step.to_array())
    } else {
        (start.to_array(), (start * step).to_array())
    }
}

fn judge(on: On, operation: &Operation, case: &Case, half: f64, motion: [f64; 8]) {
    let Operation { name, .. } = operation;
    let squared: f64 = motion[..4].iter().map(|c| c * c).sum();
    if squared.is_nan() {
        // NaN where the half angle is beyond the limit or the square of t is infinite, and of NLERP
        // of equal ends, whose weights cancel. The parameter of the last screw of `squad` grows
        // with t², and its turn with t.
        let t = 2.0 * case.t.abs() + 1.0;
        let t = if *name == "squad" { t.powi(3) } else { t };
        let limit = largest_half_angle(on.single);
        let square = if on.single { 1e19 } else { 1e154 };
        let twist = case.x[..3].iter().map(|c| c * c).sum::<f64>().sqrt() / 2.0;
        let turn = case.a[..3].iter().map(|c| c * c).sum::<f64>().sqrt().asin();
        let turns = match *name {
            "pow" => turn,
            "integrate_spatial" | "integrate_body" => twist,
            _ => half,
        };
        assert!(
            *name == "nlerp" || t * turns > limit || t > square,
            "{on:?} {name}: NaN at {case:?}"
        );
        return;
    }
    // Two ends differ in length by half a unit of the last place at most. Lanes turn in the plane
    // of the two as they are, so that it counts |τ| times, until the turn is a radian. The third
    // screw of `squad` has such ends.
    let tau = (2.0 * case.t - 1.0).abs();
    let tau = if *name == "squad" { tau.powi(3) } else { tau };
    let by_the_book = on.name.starts_with("textbook") || on.name.starts_with("scalar");
    let ends = if by_the_book { 0.0 } else { 0.25 * tau.min(1.0 / half) };
    let off = (squared.sqrt() - 1.0).abs() / (2.0 * on.roundoff());
    assert!(off < 8.0 + ends, "{on:?} {name}: |p| is off by {off:.1} ε at {case:?}");
}

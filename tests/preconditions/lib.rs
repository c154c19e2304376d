//! Operations that need unit input judge it in debug builds with `--cfg dq8_debug_assert_unit`, and in no others. Which
//! operations these are is read from their documentation.
#![cfg(test)]

use dq8::geometry::{Plane, Screw, Wrench};
use dq8::representation::{EulerAxes, EulerFrame, EulerOrder};
use dq8::{Dual, DualQuat, Line, Quat, Real, Twist};
use std::cell::RefCell;
use std::collections::BTreeSet;
use std::panic::{catch_unwind, set_hook};
use std::path::Path;
use std::sync::Once;

const JUDGED: bool = cfg!(all(dq8_debug_assert_unit, debug_assertions));

/// What is tried: the arguments of one call, of which one may not be unit.
#[derive(Clone, Copy)]
struct Given<R> {
    rotation: Quat<R>,
    motion: DualQuat<R>,
    axis: [R; 3],
    unit: DualQuat<R>,
    vector: [R; 3],
    half: R,
}

type Operation<R> = (&'static str, fn(Given<R>));

/// A line for each argument that must be unit.
#[rustfmt::skip]
fn operations<R: Real>() -> Vec<Operation<R>> {
    const ORDER: EulerOrder = EulerOrder { axes: EulerAxes::ZYX, frame: EulerFrame::Intrinsic };
    fn twist<R: Real>(g: Given<R>) -> Twist<R> {
        Twist { angular: g.vector, linear: g.vector }
    }
    vec![
        ("Quat::from_axis_angle", |g| { let _ = Quat::from_axis_angle(g.axis, g.half); }),
        ("Quat::rotate", |g| { let _ = g.rotation.rotate(g.vector); }),
        ("Quat::to_matrix3", |g| { let _ = g.rotation.to_matrix3(); }),
        ("Quat::to_cols_array_2d", |g| { let _ = g.rotation.to_cols_array_2d(); }),
        ("Quat::slerp", |g| { let _ = g.rotation.slerp(g.unit.real(), g.half); }),
        ("Quat::slerp", |g| { let _ = g.unit.real().slerp(g.rotation, g.half); }),
        ("Quat::angle_to", |g| { let _ = g.rotation.angle_to(g.unit.real()); }),
        ("Quat::angle_to", |g| { let _ = g.unit.real().angle_to(g.rotation); }),
        ("Quat::to_axis_angle", |g| { let _ = g.rotation.to_axis_angle(); }),
        ("Quat::to_scaled_axis", |g| { let _ = g.rotation.to_scaled_axis(); }),
        ("Quat::to_euler", |g| { let _ = g.rotation.to_euler(ORDER); }),
        ("DualQuat::from_rotation_translation", |g| { let _ = DualQuat::from_rotation_translation(g.rotation, g.vector); }),
        ("DualQuat::from_translation_rotation", |g| { let _ = DualQuat::from_translation_rotation(g.vector, g.rotation); }),
        ("DualQuat::mul_rotation_translation", |g| { let _ = g.unit.mul_rotation_translation(g.rotation, g.vector); }),
        ("DualQuat::from_screw", |g| {
            let axis = Line { direction: g.axis, moment: [R::ZERO; 3] };
            let _ = DualQuat::from_screw(Screw { axis, angle: g.half, slide: g.half });
        }),
        ("DualQuat::rotation", |g| { let _ = g.motion.rotation(); }),
        ("DualQuat::translation", |g| { let _ = g.motion.translation(); }),
        ("DualQuat::to_matrix3x4", |g| { let _ = g.motion.to_matrix3x4(); }),
        ("DualQuat::to_matrix4", |g| { let _ = g.motion.to_matrix4(); }),
        ("DualQuat::to_rows_array_2d", |g| { let _ = g.motion.to_rows_array_2d(); }),
        ("DualQuat::to_cols_array_2d", |g| { let _ = g.motion.to_cols_array_2d(); }),
        ("DualQuat::transform_point", |g| { let _ = g.motion.transform_point(g.vector); }),
        ("DualQuat::transform_vector", |g| { let _ = g.motion.transform_vector(g.vector); }),
        ("DualQuat::transform_line", |g| {
            let _ = g.motion.transform_line(Line { direction: g.vector, moment: g.vector });
        }),
        ("DualQuat::transform_plane", |g| {
            let _ = g.motion.transform_plane(Plane { normal: g.vector, offset: g.half });
        }),
        ("DualQuat::to_screw", |g| { let _ = g.motion.to_screw(); }),
        ("DualQuat::log", |g| { let _ = g.motion.log(); }),
        ("DualQuat::pow", |g| { let _ = g.motion.pow(g.half); }),
        ("DualQuat::sqrt", |g| { let _ = g.motion.sqrt(); }),
        ("DualQuat::sclerp", |g| { let _ = g.motion.sclerp(g.unit, g.half); }),
        ("DualQuat::sclerp", |g| { let _ = g.unit.sclerp(g.motion, g.half); }),
        ("DualQuat::sclerp_long", |g| { let _ = g.motion.sclerp_long(g.unit, g.half); }),
        ("DualQuat::sclerp_long", |g| { let _ = g.unit.sclerp_long(g.motion, g.half); }),
        ("DualQuat::slerp_lerp", |g| { let _ = g.motion.slerp_lerp(g.unit, g.half); }),
        ("DualQuat::slerp_lerp", |g| { let _ = g.unit.slerp_lerp(g.motion, g.half); }),
        ("DualQuat::squad", |g| { let _ = g.motion.squad(g.unit, g.unit, g.unit, g.half); }),
        ("DualQuat::squad", |g| { let _ = g.unit.squad(g.motion, g.unit, g.unit, g.half); }),
        ("DualQuat::squad", |g| { let _ = g.unit.squad(g.unit, g.motion, g.unit, g.half); }),
        ("DualQuat::squad", |g| { let _ = g.unit.squad(g.unit, g.unit, g.motion, g.half); }),
        ("DualQuat::squad_control", |g| { let _ = DualQuat::squad_control(g.motion, g.unit, g.unit); }),
        ("DualQuat::squad_control", |g| { let _ = DualQuat::squad_control(g.unit, g.motion, g.unit); }),
        ("DualQuat::squad_control", |g| { let _ = DualQuat::squad_control(g.unit, g.unit, g.motion); }),
        ("DualQuat::dib", |g| { let _ = DualQuat::dib(&[(g.motion, R::ONE), (g.unit, R::ONE)], R::EPSILON, 2); }),
        ("DualQuat::dib", |g| { let _ = DualQuat::dib(&[(g.unit, R::ONE), (g.motion, R::ONE)], R::EPSILON, 2); }),
        ("DualQuat::angle_to", |g| { let _ = g.motion.angle_to(g.unit); }),
        ("DualQuat::angle_to", |g| { let _ = g.unit.angle_to(g.motion); }),
        ("DualQuat::distance_to", |g| { let _ = g.motion.distance_to(g.unit); }),
        ("DualQuat::distance_to", |g| { let _ = g.unit.distance_to(g.motion); }),
        ("DualQuat::distance_weighted", |g| { let _ = g.motion.distance_weighted(g.unit, g.half); }),
        ("DualQuat::distance_weighted", |g| { let _ = g.unit.distance_weighted(g.motion, g.half); }),
        ("DualQuat::point_error", |g| { let _ = g.motion.point_error(g.unit, g.vector); }),
        ("DualQuat::point_error", |g| { let _ = g.unit.point_error(g.motion, g.vector); }),
        ("DualQuat::shell_error", |g| { let _ = g.motion.shell_error(g.unit, g.half); }),
        ("DualQuat::shell_error", |g| { let _ = g.unit.shell_error(g.motion, g.half); }),
        ("DualQuat::spatial_twist", |g| { let _ = g.motion.spatial_twist(g.unit); }),
        ("DualQuat::body_twist", |g| { let _ = g.motion.body_twist(g.unit); }),
        ("DualQuat::derivative_from_velocity", |g| { let _ = g.motion.derivative_from_velocity(g.vector, g.vector); }),
        ("DualQuat::velocity", |g| { let _ = g.motion.velocity(g.unit); }),
        ("DualQuat::to_twist", |g| { let _ = g.motion.to_twist(); }),
        ("DualQuat::twist_to", |g| { let _ = g.motion.twist_to(g.unit); }),
        ("DualQuat::twist_to", |g| { let _ = g.unit.twist_to(g.motion); }),
        ("DualQuat::adjoint", |g| { let _ = g.motion.adjoint(twist(g)); }),
        ("DualQuat::coadjoint", |g| {
            let _ = g.motion.coadjoint(Wrench { force: g.vector, torque: g.vector });
        }),
    ]
}

impl<R: Real> Given<R> {
    fn unit() -> Self {
        // Exactly unit, so that the norms of multiples are theirs to the last digit.
        let axis = [R::ZERO, R::ZERO, -R::ONE];
        let rotation = Quat::from_xyzw(R::HALF, R::HALF, R::HALF, R::HALF);
        let vector = [-4.0, 5.0, 6.0].map(R::from_f64);
        let motion = DualQuat::from_rotation_translation(rotation, vector);
        Self { rotation, motion, axis, unit: motion, vector, half: R::HALF }
    }

    fn times(factor: f64) -> Self {
        let (unit, factor) = (Self::unit(), R::from_f64(factor));
        Self {
            rotation: unit.rotation.scale(factor),
            motion: unit.motion.scale(factor),
            axis: unit.axis.map(|c| c * factor),
            ..unit
        }
    }
}

/// What a panic said, and the source from where it said that it was.
struct Complaint {
    message: String,
    file: String,
    source: String,
}

fn complaint<R: Real>(operation: fn(Given<R>), given: Given<R>) -> Option<Complaint> {
    thread_local! {
        static LAST: RefCell<Option<Complaint>> = const { RefCell::new(None) };
    }
    static HOOK: Once = Once::new();
    HOOK.call_once(|| {
        set_hook(Box::new(|panic| {
            let place = panic.location().expect("a place");
            let message = panic.payload().downcast_ref::<String>().cloned().unwrap_or_default();
            let line = include_str!("lib.rs").lines().nth(place.line() as usize - 1);
            let source = line.and_then(|line| line.get(place.column() as usize - 1..));
            let source = source.unwrap_or_default().to_owned();
            // Failed assertions of the tests themselves come here too.
            eprintln!("{place}: {message}");
            let complaint = Complaint { message, file: place.file().to_owned(), source };
            LAST.with(|last| *last.borrow_mut() = Some(complaint));
        }));
    });
    // Plain numbers have no state that a panic could leave half done.
    let call = std::panic::AssertUnwindSafe(|| operation(given));
    let panicked = catch_unwind(call).is_err();
    let last = LAST.with(|last| last.borrow_mut().take());
    panicked.then(|| last.expect("the hook has seen it"))
}

/// The panic names the operation, says `words`, and is at the line of the caller.
fn all_complain<R: Real>(given: Given<R>, words: &str) {
    for (name, operation) in operations::<R>() {
        let complaint = complaint(operation, given);
        assert_eq!(complaint.is_some(), JUDGED, "{name}");
        let Some(Complaint { message, file, source }) = complaint else { continue };
        let (_, method) = name.split_once("::").expect("a method");
        assert!(message.starts_with(&format!("{name} takes a unit ")), "{message}");
        assert!(message.ends_with(words), "{message}");
        assert!(file.ends_with("preconditions/lib.rs"), "{name}: {file}");
        let called = source.strip_prefix("DualQuat::").or(source.strip_prefix("Quat::"));
        assert!(called.unwrap_or(&source).starts_with(method), "{name}: {source}");
    }
}

fn none_complains<R: Real>(given: Given<R>) {
    for (name, operation) in operations::<R>() {
        assert!(complaint(operation, given).is_none(), "{name}");
    }
}

/// For both floats, and for a number that takes no quicker form.
macro_rules! for_all_numbers {
    ($law:ident) => {
        $law::<f32>();
        $law::<f64>();
        $law::<Dual<f64>>();
    };
}

#[test]
fn a_norm_that_is_plainly_off_is_told_of_at_the_line_of_the_caller() {
    fn law<R: Real>() {
        all_complain(Given::<R>::times(2.0), "the squared norm is 4");
        all_complain(Given::<R>::times(0.0), "the squared norm is 0");
        all_complain(Given::<R>::times(1.0625), "the squared norm is 1.12890625");
        all_complain(Given::<R>::times(1e30), "");
    }
    for_all_numbers!(law);
}

#[test]
fn a_dual_part_along_the_real_part_is_told_of() {
    fn law<R: Real>() {
        let mut given = Given::<R>::unit();
        let along = given.motion.real();
        given.motion = given.motion + DualQuat::new(Quat::ZERO, along);
        for (name, operation) in operations::<R>() {
            // The others take a rotation or an axis, which is unit here.
            let of_motion = name.starts_with("DualQuat::")
                && !name.contains("::from_")
                && !name.starts_with("DualQuat::mul_");
            let complaint = complaint(operation, given);
            assert_eq!(complaint.is_some(), JUDGED && of_motion, "{name}");
            assert!(complaint.is_none_or(|complaint| complaint.message.contains("p·q is ")));
        }
    }
    for_all_numbers!(law);
}

#[test]
fn what_drifts_or_is_no_number_passes() {
    fn law<R: Real>() {
        none_complains(Given::<R>::unit());
        none_complains(Given::<R>::times(-1.0));
        none_complains(Given::<R>::times(1.03));
        none_complains(Given::<R>::times(0.97));
        none_complains(Given::<R>::times(f64::NAN));
        none_complains(Given::<R>::times(f64::INFINITY));
    }
    for_all_numbers!(law);
}

/// The phrases by which the documentation asks for unit input.
const ASKS: &[&str] = &[
    "must be unit",
    "must have length 1",
    "of a unit σ",
    "of a unit quaternion",
    "this unit quaternion",
    "of unit quaternions",
    "of unit motions",
];

/// `const`, for other numbers too, and the question itself.
const UNJUDGED: &[&str] = &["from_rotation", "conjugate", "is_normalized"];

#[test]
fn every_operation_that_asks_for_unit_input_judges_it_and_is_tried_here() {
    let tried: BTreeSet<&str> = operations::<f64>().into_iter().map(|(name, _)| name).collect();
    let (mut judging, mut silent) = (BTreeSet::new(), Vec::new());
    for folder in ["scalar", "representation"] {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../src").join(folder);
        for file in std::fs::read_dir(folder).unwrap() {
            let text = std::fs::read_to_string(file.unwrap().path()).unwrap();
            let (mut about, mut owner) = (String::new(), String::new());
            let mut lines = text.lines().peekable();
            while let Some(line) = lines.next() {
                let trimmed = line.trim();
                if let Some(type_of) = line.strip_prefix("impl<R: Real> ") {
                    owner = type_of.split('<').next().unwrap_or_default().to_owned();
                } else if let Some(doc) = trimmed.strip_prefix("/// ") {
                    about.push_str(doc);
                    about.push(' ');
                } else if let Some(signature) =
                    trimmed.strip_prefix("pub fn ").or(trimmed.strip_prefix("pub const fn "))
                {
                    let name = signature.split(['(', '<']).next().unwrap_or_default();
                    let name = format!("{owner}::{name}");
                    let body: String =
                        std::iter::from_fn(|| lines.next_if(|line| *line != "    }")).collect();
                    let judges = body.contains("must_be_unit::");
                    let asks = ["Quat", "DualQuat"].contains(&owner.as_str())
                        && ASKS.iter().any(|phrase| about.contains(phrase))
                        && !UNJUDGED.iter().any(|method| name.ends_with(&format!("::{method}")));
                    if judges {
                        assert!(body.contains(&format!("(\"{name}\", ")), "{name} says its name");
                        judging.insert(name);
                    } else if asks {
                        silent.push(name);
                    }
                    about.clear();
                } else if !trimmed.starts_with("#[") && !trimmed.starts_with("///") {
                    about.clear();
                }
            }
        }
    }
    assert_eq!(silent, Vec::<String>::new(), "asks for unit input, and does not judge it");
    assert_eq!(judging.iter().map(String::as_str).collect::<BTreeSet<_>>(), tried);
}

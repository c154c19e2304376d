//! Operations that need unit input judge it in debug builds with `--cfg dq8_debug_assert_unit`, and
//! in no others. Which operations of motions these are is known from the accuracy contract, by the
//! domain of each argument.
#![cfg(test)]

use dq8::geometry::{Plane, Screw, Wrench};
use dq8::representation::{EulerAxes, EulerFrame, EulerOrder};
use dq8::{Dual, DualQuat, Line, Quat, Real, Twist};
use dq8_contract::implementation::scalar_f64;
use dq8_contract::inputs::unit_cases;
use dq8_contract::operation::Domain;
use dq8_contract::operations::OPERATIONS;
use std::cell::RefCell;
use std::collections::BTreeSet;
use std::panic::{catch_unwind, set_hook};
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

/// The line of a call, its name, and the call.
type Operation<R> = (u32, &'static str, fn(Given<R>));

/// A line for each argument that must be unit. Calls are on the line that is written before them.
#[rustfmt::skip]
fn operations<R: Real>() -> Vec<Operation<R>> {
    const ORDER: EulerOrder = EulerOrder { axes: EulerAxes::ZYX, frame: EulerFrame::Intrinsic };
    fn line<R: Real>(g: Given<R>) -> Line<R> { Line { direction: g.vector, moment: g.vector } }
    fn plane<R: Real>(g: Given<R>) -> Plane<R> { Plane { normal: g.vector, offset: g.half } }
    fn screw<R: Real>(g: Given<R>) -> Screw<R> {
        let axis = Line { direction: g.axis, moment: [R::ZERO; 3] };
        Screw { axis, angle: g.half, slide: g.half }
    }
    fn twist<R: Real>(g: Given<R>) -> Twist<R> { Twist { angular: g.vector, linear: g.vector } }
    fn wrench<R: Real>(g: Given<R>) -> Wrench<R> { Wrench { force: g.vector, torque: g.vector } }
    vec![
        (line!(), "Quat::from_axis_angle", |g| { let _ = Quat::from_axis_angle(g.axis, g.half); }),
        (line!(), "Quat::rotate", |g| { let _ = g.rotation.rotate(g.vector); }),
        (line!(), "Quat::to_matrix3", |g| { let _ = g.rotation.to_matrix3(); }),
        (line!(), "Quat::to_cols_array_2d", |g| { let _ = g.rotation.to_cols_array_2d(); }),
        (line!(), "Quat::slerp", |g| { let _ = g.rotation.slerp(g.unit.real(), g.half); }),
        (line!(), "Quat::slerp", |g| { let _ = g.unit.real().slerp(g.rotation, g.half); }),
        (line!(), "Quat::angle_to", |g| { let _ = g.rotation.angle_to(g.unit.real()); }),
        (line!(), "Quat::angle_to", |g| { let _ = g.unit.real().angle_to(g.rotation); }),
        (line!(), "Quat::to_axis_angle", |g| { let _ = g.rotation.to_axis_angle(); }),
        (line!(), "Quat::to_scaled_axis", |g| { let _ = g.rotation.to_scaled_axis(); }),
        (line!(), "Quat::to_euler", |g| { let _ = g.rotation.to_euler(ORDER); }),
        (line!(), "Quat::to_rpy", |g| { let _ = g.rotation.to_rpy(); }),
        (line!(), "Quat::log", |g| { let _ = g.rotation.log(); }),
        (line!(), "Quat::pow", |g| { let _ = g.rotation.pow(g.half); }),
        (line!(), "Quat::mean", |g| { let _ = Quat::mean(&[g.unit.real(), g.rotation]); }),
        (line!(), "DualQuat::from_axis_angle", |g| { let _ = DualQuat::from_axis_angle(g.axis, g.half); }),
        (line!(), "DualQuat::with_translation", |g| { let _ = g.motion.with_translation(g.vector); }),
        (line!(), "DualQuat::with_rotation", |g| { let _ = g.motion.with_rotation(g.unit.real()); }),
        (line!(), "DualQuat::from_rotation_translation", |g| { let _ = g.unit.with_rotation(g.rotation); }),
        (line!(), "DualQuat::mean", |g| { let _ = DualQuat::mean(&[g.unit, g.motion]); }),
        (line!(), "DualQuat::from_rotation_translation", |g| { let _ = DualQuat::from_rotation_translation(g.rotation, g.vector); }),
        (line!(), "DualQuat::from_translation_rotation", |g| { let _ = DualQuat::from_translation_rotation(g.vector, g.rotation); }),
        (line!(), "DualQuat::mul_rotation_translation", |g| { let _ = g.unit.mul_rotation_translation(g.rotation, g.vector); }),
        (line!(), "DualQuat::from_screw", |g| { let _ = DualQuat::from_screw(screw(g)); }),
        (line!(), "DualQuat::rotation", |g| { let _ = g.motion.rotation(); }),
        (line!(), "DualQuat::translation", |g| { let _ = g.motion.translation(); }),
        (line!(), "DualQuat::to_matrix3x4", |g| { let _ = g.motion.to_matrix3x4(); }),
        (line!(), "DualQuat::to_matrix4", |g| { let _ = g.motion.to_matrix4(); }),
        (line!(), "DualQuat::to_rows_array_2d", |g| { let _ = g.motion.to_rows_array_2d(); }),
        (line!(), "DualQuat::to_cols_array_2d", |g| { let _ = g.motion.to_cols_array_2d(); }),
        (line!(), "DualQuat::transform_point", |g| { let _ = g.motion.transform_point(g.vector); }),
        (line!(), "DualQuat::transform_vector", |g| { let _ = g.motion.transform_vector(g.vector); }),
        (line!(), "DualQuat::transform_line", |g| { let _ = g.motion.transform_line(line(g)); }),
        (line!(), "DualQuat::transform_plane", |g| { let _ = g.motion.transform_plane(plane(g)); }),
        (line!(), "DualQuat::to_screw", |g| { let _ = g.motion.to_screw(); }),
        (line!(), "DualQuat::log", |g| { let _ = g.motion.log(); }),
        (line!(), "DualQuat::pow", |g| { let _ = g.motion.pow(g.half); }),
        (line!(), "DualQuat::sqrt", |g| { let _ = g.motion.sqrt(); }),
        (line!(), "DualQuat::sclerp", |g| { let _ = g.motion.sclerp(g.unit, g.half); }),
        (line!(), "DualQuat::sclerp", |g| { let _ = g.unit.sclerp(g.motion, g.half); }),
        (line!(), "DualQuat::sclerp_long", |g| { let _ = g.motion.sclerp_long(g.unit, g.half); }),
        (line!(), "DualQuat::sclerp_long", |g| { let _ = g.unit.sclerp_long(g.motion, g.half); }),
        (line!(), "DualQuat::slerp_lerp", |g| { let _ = g.motion.slerp_lerp(g.unit, g.half); }),
        (line!(), "DualQuat::slerp_lerp", |g| { let _ = g.unit.slerp_lerp(g.motion, g.half); }),
        (line!(), "DualQuat::squad", |g| { let _ = g.motion.squad(g.unit, g.unit, g.unit, g.half); }),
        (line!(), "DualQuat::squad", |g| { let _ = g.unit.squad(g.motion, g.unit, g.unit, g.half); }),
        (line!(), "DualQuat::squad", |g| { let _ = g.unit.squad(g.unit, g.motion, g.unit, g.half); }),
        (line!(), "DualQuat::squad", |g| { let _ = g.unit.squad(g.unit, g.unit, g.motion, g.half); }),
        (line!(), "DualQuat::squad_control", |g| { let _ = DualQuat::squad_control(g.motion, g.unit, g.unit); }),
        (line!(), "DualQuat::squad_control", |g| { let _ = DualQuat::squad_control(g.unit, g.motion, g.unit); }),
        (line!(), "DualQuat::squad_control", |g| { let _ = DualQuat::squad_control(g.unit, g.unit, g.motion); }),
        (line!(), "DualQuat::dib", |g| { let _ = DualQuat::dib(&[(g.motion, R::ONE), (g.unit, R::ONE)], R::EPSILON, 2); }),
        (line!(), "DualQuat::dib", |g| { let _ = DualQuat::dib(&[(g.unit, R::ONE), (g.motion, R::ONE)], R::EPSILON, 2); }),
        (line!(), "DualQuat::angle_to", |g| { let _ = g.motion.angle_to(g.unit); }),
        (line!(), "DualQuat::angle_to", |g| { let _ = g.unit.angle_to(g.motion); }),
        (line!(), "DualQuat::distance_to", |g| { let _ = g.motion.distance_to(g.unit); }),
        (line!(), "DualQuat::distance_to", |g| { let _ = g.unit.distance_to(g.motion); }),
        (line!(), "DualQuat::distance_weighted", |g| { let _ = g.motion.distance_weighted(g.unit, g.half); }),
        (line!(), "DualQuat::distance_weighted", |g| { let _ = g.unit.distance_weighted(g.motion, g.half); }),
        (line!(), "DualQuat::point_error", |g| { let _ = g.motion.point_error(g.unit, g.vector); }),
        (line!(), "DualQuat::point_error", |g| { let _ = g.unit.point_error(g.motion, g.vector); }),
        (line!(), "DualQuat::shell_error", |g| { let _ = g.motion.shell_error(g.unit, g.half); }),
        (line!(), "DualQuat::shell_error", |g| { let _ = g.unit.shell_error(g.motion, g.half); }),
        (line!(), "DualQuat::spatial_twist", |g| { let _ = g.motion.spatial_twist(g.unit); }),
        (line!(), "DualQuat::body_twist", |g| { let _ = g.motion.body_twist(g.unit); }),
        (line!(), "DualQuat::derivative_from_velocity", |g| { let _ = g.motion.derivative_from_velocity(g.vector, g.vector); }),
        (line!(), "DualQuat::velocity", |g| { let _ = g.motion.velocity(g.unit); }),
        (line!(), "DualQuat::to_twist", |g| { let _ = g.motion.to_twist(); }),
        (line!(), "DualQuat::twist_to", |g| { let _ = g.motion.twist_to(g.unit); }),
        (line!(), "DualQuat::twist_to", |g| { let _ = g.unit.twist_to(g.motion); }),
        (line!(), "DualQuat::adjoint", |g| { let _ = g.motion.adjoint(twist(g)); }),
        (line!(), "DualQuat::coadjoint", |g| { let _ = g.motion.coadjoint(wrench(g)); }),
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

/// What a panic said, and where it said that it was.
struct Complaint {
    message: String,
    file: String,
    line: u32,
}

fn complaint(call: impl FnOnce()) -> Option<Complaint> {
    thread_local! {
        static LAST: RefCell<Option<Complaint>> = const { RefCell::new(None) };
    }
    static HOOK: Once = Once::new();
    HOOK.call_once(|| {
        set_hook(Box::new(|panic| {
            let place = panic.location().expect("a place");
            let message = panic.payload().downcast_ref::<String>().cloned().unwrap_or_default();
            // Failed assertions of the tests themselves come here too.
            eprintln!("{place}: {message}");
            let complaint =
                Complaint { message, file: place.file().to_owned(), line: place.line() };
            LAST.with(|last| *last.borrow_mut() = Some(complaint));
        }));
    });
    // Plain numbers have no state that a panic could leave half done.
    let panicked = catch_unwind(std::panic::AssertUnwindSafe(call)).is_err();
    let last = LAST.with(|last| last.borrow_mut().take());
    panicked.then(|| last.expect("the hook has seen it"))
}

/// The panic names the operation, says `words`, and is at the line of the caller.
fn all_complain<R: Real>(given: Given<R>, words: &str) {
    for (line, name, operation) in operations::<R>() {
        let complaint = complaint(|| operation(given));
        assert_eq!(complaint.is_some(), JUDGED, "{name}");
        let Some(complaint) = complaint else { continue };
        let message = complaint.message;
        assert!(message.starts_with(&format!("{name} takes a unit ")), "{message}");
        assert!(message.ends_with(words), "{message}");
        assert!(complaint.file.ends_with("preconditions/lib.rs"), "{name}: {}", complaint.file);
        assert_eq!(complaint.line, line, "{name}");
    }
}

fn none_complains<R: Real>(given: Given<R>) {
    for (_, name, operation) in operations::<R>() {
        assert!(complaint(|| operation(given)).is_none(), "{name}");
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
        for (_, name, operation) in operations::<R>() {
            // The others take a rotation or an axis, which is unit here.
            let of_motion = name.starts_with("DualQuat::")
                && !name.contains("::from_")
                && !name.starts_with("DualQuat::mul_");
            let complaint = complaint(|| operation(given));
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

/// Operations that take any motions, though their errors are bounded for unit ones: they normalize,
/// are linear in the motion, or ask the question.
const OF_ANY: &[&str] = &[
    "from_rotation",
    "is_unit",
    "abs_diff_eq",
    "nlerp",
    "dlb",
    "dlb_running",
    "derivative_spatial",
    "derivative_body",
    "integrate_spatial",
    "integrate_body",
];

#[test]
fn every_argument_that_the_contract_wants_unit_is_judged_and_no_other() {
    let tried: BTreeSet<&str> = operations::<f64>().into_iter().map(|(_, name, _)| name).collect();
    let (on, case) = (scalar_f64(), unit_cases()[3]);
    for operation in OPERATIONS {
        let given = operation.given(on, &case);
        for (argument, place) in operation.arguments.iter().zip(0..) {
            if argument.domain == Domain::Other {
                continue;
            }
            let mut given = given.clone();
            // Eight numbers of a motion, whether its weight follows or not.
            given[place].iter_mut().take(8).for_each(|number| *number *= 2.0);
            let complaint = complaint(|| {
                let _ = operation.answer_given(on, &[&given]);
            });
            let name = operation.name;
            let wanted = argument.domain != Domain::Any && !OF_ANY.contains(&name);
            assert_eq!(complaint.is_some(), JUDGED && wanted, "{name}, argument {place}");
            assert!(
                !wanted || tried.contains(&*format!("DualQuat::{name}")),
                "{name} is not tried"
            );
        }
    }
}

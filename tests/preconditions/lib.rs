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

/// The file and line of a call, its name, and the call.
type Operation<R> = (&'static str, u32, &'static str, fn(Given<R>));

/// The calls of the contract's table: one for each argument that must be unit, where it is not.
macro_rules! operations {
    ($($name:ident($($kind:ident $field:ident $($more:ident)*),*) -> $result:ident,
        $scale:expr, [$($held:expr),* $(,)?];)*) => {
        fn of_the_contract<R: Real>() -> Vec<Operation<R>> {
            let mut calls: Vec<Operation<R>> = Vec::new();
            $(calls! { calls $name [] $($kind)* })*
            calls
        }
    };
}

/// The calls of one operation, by the kinds of its arguments: those before, and those from the next
/// one on.
macro_rules! calls {
    ($calls:ident $name:ident [$($before:ident)*]) => {};
    ($calls:ident $name:ident [$($before:ident)*] influences $($after:ident)*) => {
        $calls.push(call!($name [$($before)*] first [$($after)*]));
        $calls.push(call!($name [$($before)*] second [$($after)*]));
    };
    ($calls:ident $name:ident [$($before:ident)*] unit $($after:ident)*) => {
        $calls.push(call!($name [$($before)*] motion [$($after)*]));
        calls! { $calls $name [$($before)* unit] $($after)* }
    };
    ($calls:ident $name:ident [$($before:ident)*] rotation $($after:ident)*) => {
        $calls.push(call!($name [$($before)*] turn [$($after)*]));
        calls! { $calls $name [$($before)* rotation] $($after)* }
    };
    ($calls:ident $name:ident [$($before:ident)*] $next:ident $($after:ident)*) => {
        calls! { $calls $name [$($before)* $next] $($after)* }
    };
}

macro_rules! call {
    ($name:ident [$($before:ident)*] $off:ident [$($after:ident)*]) => {
        (file!(), line!(), concat!("DualQuat::", stringify!($name)), |g| {
            let _ = DualQuat::<R>::$name(
                $(given!(g $before),)* given!(g $off) $(, given!(g $after))*
            );
        })
    };
}

/// An argument of that kind. A `motion`, a `turn`, and the `first` or `second` of two influences
/// may not be unit.
macro_rules! given {
    ($g:ident motion) => {
        $g.motion
    };
    ($g:ident turn) => {
        $g.rotation
    };
    ($g:ident first) => {
        &[($g.motion, R::ONE), ($g.unit, R::ONE)]
    };
    ($g:ident second) => {
        &[($g.unit, R::ONE), ($g.motion, R::ONE)]
    };
    ($g:ident unit) => {
        $g.unit
    };
    ($g:ident any) => {
        $g.unit
    };
    ($g:ident rotation) => {
        $g.unit.real()
    };
    ($g:ident vector) => {
        $g.vector
    };
    ($g:ident angular) => {
        $g.vector
    };
    ($g:ident linear) => {
        $g.vector
    };
    ($g:ident line) => {
        Line { direction: $g.vector, moment: $g.vector }
    };
    ($g:ident plane) => {
        Plane { normal: $g.vector, offset: $g.half }
    };
    ($g:ident twist) => {
        Twist { angular: $g.vector, linear: $g.vector }
    };
    ($g:ident wrench) => {
        Wrench { force: $g.vector, torque: $g.vector }
    };
    ($g:ident settled) => {
        R::EPSILON
    };
    ($g:ident at_most) => {
        2
    };
    ($g:ident real) => {
        $g.half
    };
}

include!("../contract/table.rs");

/// Every call of which one argument must be unit.
fn operations<R: Real>() -> Vec<Operation<R>> {
    let takes_any = |name: &str| {
        OPERATIONS.iter().any(|operation| operation.name == name && operation.takes_any())
    };
    let mut all = of_the_contract::<R>();
    all.retain(|(.., name, _)| !takes_any(name.trim_start_matches("DualQuat::")));
    all.extend(others::<R>());
    all
}

/// The calls that the table has not, each on the line that is written before it.
#[rustfmt::skip]
fn others<R: Real>() -> Vec<Operation<R>> {
    const ORDER: EulerOrder = EulerOrder { axes: EulerAxes::ZYX, frame: EulerFrame::Intrinsic };
    fn screw<R: Real>(g: Given<R>) -> Screw<R> {
        let axis = Line { direction: g.axis, moment: [R::ZERO; 3] };
        Screw { axis, angle: g.half, slide: g.half }
    }
    vec![
        (file!(), line!(), "Quat::from_axis_angle", |g| { let _ = Quat::from_axis_angle(g.axis, g.half); }),
        (file!(), line!(), "Quat::rotate", |g| { let _ = g.rotation.rotate(g.vector); }),
        (file!(), line!(), "Quat::to_matrix3", |g| { let _ = g.rotation.to_matrix3(); }),
        (file!(), line!(), "Quat::to_cols_array_2d", |g| { let _ = g.rotation.to_cols_array_2d(); }),
        (file!(), line!(), "Quat::slerp", |g| { let _ = g.rotation.slerp(g.unit.real(), g.half); }),
        (file!(), line!(), "Quat::slerp", |g| { let _ = g.unit.real().slerp(g.rotation, g.half); }),
        (file!(), line!(), "Quat::angle_to", |g| { let _ = g.rotation.angle_to(g.unit.real()); }),
        (file!(), line!(), "Quat::angle_to", |g| { let _ = g.unit.real().angle_to(g.rotation); }),
        (file!(), line!(), "Quat::to_axis_angle", |g| { let _ = g.rotation.to_axis_angle(); }),
        (file!(), line!(), "Quat::to_scaled_axis", |g| { let _ = g.rotation.to_scaled_axis(); }),
        (file!(), line!(), "Quat::to_euler", |g| { let _ = g.rotation.to_euler(ORDER); }),
        (file!(), line!(), "Quat::to_rpy", |g| { let _ = g.rotation.to_rpy(); }),
        (file!(), line!(), "Quat::log", |g| { let _ = g.rotation.log(); }),
        (file!(), line!(), "Quat::pow", |g| { let _ = g.rotation.pow(g.half); }),
        (file!(), line!(), "Quat::mean", |g| { let _ = Quat::mean(&[g.unit.real(), g.rotation]); }),
        (file!(), line!(), "DualQuat::from_axis_angle", |g| { let _ = DualQuat::from_axis_angle(g.axis, g.half); }),
        (file!(), line!(), "DualQuat::with_translation", |g| { let _ = g.motion.with_translation(g.vector); }),
        (file!(), line!(), "DualQuat::with_rotation", |g| { let _ = g.motion.with_rotation(g.unit.real()); }),
        (file!(), line!(), "DualQuat::from_rotation_translation", |g| { let _ = g.unit.with_rotation(g.rotation); }),
        (file!(), line!(), "DualQuat::mean", |g| { let _ = DualQuat::mean(&[g.unit, g.motion]); }),
        (file!(), line!(), "DualQuat::mul_rotation_translation", |g| { let _ = g.unit.mul_rotation_translation(g.rotation, g.vector); }),
        (file!(), line!(), "DualQuat::from_screw", |g| { let _ = DualQuat::from_screw(screw(g)); }),
        (file!(), line!(), "DualQuat::to_rows_array_2d", |g| { let _ = g.motion.to_rows_array_2d(); }),
        (file!(), line!(), "DualQuat::to_cols_array_2d", |g| { let _ = g.motion.to_cols_array_2d(); }),
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
    for (file, line, name, operation) in operations::<R>() {
        let complaint = complaint(|| operation(given));
        assert_eq!(complaint.is_some(), JUDGED, "{name}");
        let Some(complaint) = complaint else { continue };
        let message = complaint.message;
        assert!(message.starts_with(&format!("{name} takes a unit ")), "{message}");
        assert!(message.ends_with(words), "{message}");
        assert_eq!((&*complaint.file, complaint.line), (file, line), "{name}");
    }
}

fn none_complains<R: Real>(given: Given<R>) {
    for (.., name, operation) in operations::<R>() {
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
        for (.., name, operation) in operations::<R>() {
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

#[test]
fn every_argument_that_the_contract_wants_unit_is_judged_and_no_other() {
    let tried: BTreeSet<&str> = operations::<f64>().into_iter().map(|(.., name, _)| name).collect();
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
            let wanted = argument.domain != Domain::Any && !operation.takes_any();
            assert_eq!(complaint.is_some(), JUDGED && wanted, "{name}, argument {place}");
            assert!(
                !wanted || tried.contains(&*format!("DualQuat::{name}")),
                "{name} is not tried"
            );
        }
    }
}

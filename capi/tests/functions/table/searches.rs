//! Inverse kinematics: of one configuration, and of many; all solutions of arms of six hinges.

use super::mechanisms::Scene;
use crate::argument::{Of, Read, count, names, passes, reads, writes};
use crate::element::{Element, wave};
use crate::function::Function;
use crate::shape::Shape;
use dq8::{DualQuat, Real, Scalar};
use dq8_capi::reach::{Goal, ReachOptions, ReachReport};
use dq8_capi::solutions::Solutions as SolutionList;
use dq8_capi::{Status, reach, solutions, targets};
use dq8_robot::ik::{self, OwnedReach, ReachError, Report, SixAxisArm};
use dq8_robot::{Joint, JointKind};
use std::rc::Rc;

/// The options in C.
fn options<R: Real>(known: ik::Options<R>) -> ReachOptions<R> {
    ReachOptions {
        angular_tolerance: known.angular_tolerance,
        linear_tolerance: known.linear_tolerance,
        max_iterations: known.max_iterations,
        restarts: known.restarts.into(),
        length_per_radian: known.length_per_radian.unwrap_or(R::ZERO),
        max_step: known.max_step,
        damping: known.damping,
    }
}

fn known<R: Real>(options: &ReachOptions<R>) -> ik::Options<R> {
    let length = options.length_per_radian;
    ik::Options {
        angular_tolerance: options.angular_tolerance,
        linear_tolerance: options.linear_tolerance,
        max_iterations: options.max_iterations,
        restarts: options.restarts == 1,
        length_per_radian: (length != R::ZERO).then_some(length),
        max_step: options.max_step,
        damping: options.damping,
        ..ik::Options::default()
    }
}

fn status(error: ReachError) -> Status {
    match error {
        ReachError::Link { .. } => Status::NoLink,
        ReachError::Unmoved { .. } => Status::Unmoved,
        _ => Status::Weight,
    }
}

fn search<R: Scalar>(
    scene: &Scene<R>,
    goals: &[Goal<R>],
    posture: &[R],
) -> Result<OwnedReach<R>, Status> {
    let goals: Vec<_> = goals
        .iter()
        .map(|&Goal { link, angular, linear, point }| ik::Goal { link, angular, linear, point })
        .collect();
    let search = OwnedReach::new(scene.rust.clone(), goals).map_err(status)?;
    if posture.is_empty() { Ok(search) } else { search.with_posture(posture).map_err(status) }
}

fn told<R: Copy>(report: &Report<R>) -> ReachReport<R> {
    ReachReport {
        outcome: report.outcome as i32,
        iterations: report.iterations,
        restarts: report.restarts,
        angular_error: report.angular_error,
        linear_error: report.linear_error,
    }
}

/// Goals for links that a joint moves, every second one for the position alone.
fn goals<R: Real>(shape: &Shape) -> Of<Goal<R>, Read>
where
    Goal<R>: Element,
{
    let joints = shape.joints.len();
    // Which links nothing moves.
    let still = shape.joints.iter().fold(Vec::new(), |mut still, joint| {
        let on_it = joint.parent.is_none_or(|parent| still[parent]);
        still.push(on_it && joint.kind == JointKind::Fixed);
        still
    });
    let moved: Vec<_> = (0..joints).rev().filter(|&link| !still[link]).collect();
    let unmoved = still.iter().position(|&still| still);
    let (one, none) = ([R::ONE; 3], [R::ZERO; 3]);
    let goals = reads::<Goal<R>>(shape.goals)
        .only(move |at| Goal {
            link: moved.get(at).copied().unwrap_or(0),
            angular: if at == 0 { one } else { none },
            linear: one,
            point: none.map(|zero| zero + wave::<R>(at, 2)),
        })
        .fault(Status::NoLink, None, move |goals| goals[0].link = joints)
        .fault(Status::Weight, None, |goals| goals[0].linear[1] = -R::ONE)
        .fault(Status::Weight, None, |goals| goals[0].angular[1] = R::NAN)
        .fault(Status::Weight, None, move |goals| {
            (goals[0].angular, goals[0].linear) = (none, none)
        });
    match unmoved {
        Some(link) => goals.fault(Status::Unmoved, None, move |goals| goals[0].link = link),
        None => goals,
    }
}

macro_rules! add {
    ($shape:ident $list:ident $R:ident $of:ident) => {{
        let scene = Scene::<$R>::$of($shape);
        let (values, goal_count) = (scene.made.values, $shape.goals);
        let needed = |of: unsafe extern "C" fn(_, _, *mut usize) -> Status| {
            let mut needed = 0;
            // SAFETY: it has been made.
            assert_eq!(unsafe { of(&raw const scene.made, goal_count, &raw mut needed) }, Status::Ok);
            needed
        };
        let [room, room_of_many] = [needed(reach::$of::reach_scratch), needed(targets::$of::reach_scratch)];
        let n = $shape.instances;
        let [one, many] = [(); 2].map(|()| Rc::clone(&scene));
        let target = |at: usize| match at {
            // One beyond everything, and one that is none.
            3 => DualQuat::from_translation([99.0, 0.0, 0.0]),
            7 => DualQuat::from_array([<$R>::NAN; 8]),
            _ => DualQuat::sample(at, 3),
        };
        let any = $shape.any;
        let asked = move |_| {
            let known = ik::Options { max_iterations: 1 + any as u32 % 30, restarts: any % 2 == 0, ..Default::default() };
            ReachOptions { damping: 0.01, max_step: 0.7, // Not a number: there is a report that says so.
                length_per_radian: [0.0, 1.0, 2.0, <$R>::NAN][any % 4], ..options(known) }
        };
        let asks = || {
            reads::<ReachOptions<$R>>(1).unless_null(0).only(asked)
                .fault(Status::UnknownValue, None, |options| options[0].restarts = 2)
        };
        let posture = || {
            let posture = reads::<$R>(values).unless_null(1).only(|at| wave(at, 6));
            if goal_count == 0 { posture } else { posture.fault(Status::NotFinite, None, |posture| posture.fill(<$R>::NAN)) }
        };
        let rooms = |of: usize| writes::<$R>(of).scratch();
        let few = |of: usize| count(of).wrong_if(of > 0, of.saturating_sub(1), Status::LengthScratch);
        of_numbers! { $list $R $of:
            "mechanism_" reach reach_options (filled: writes::<ReachOptions<$R>>(1))
                => filled[0] = options(ik::Options::default());
            "mechanism_" reach reach_scratch (
                mechanism: scene.argument(), goal_count: passes(goal_count).wrong(1025, Status::TooLarge),
                scratch_count: writes::<usize>(1),
            ) => scratch_count[0] = room;
            "mechanism_" reach reach (
                mechanism: scene.argument(), goals: goals::<$R>($shape), targets: reads::<DualQuat<$R>>(goal_count),
                goal_count: count(goal_count), posture: posture(), options: asks(),
                values: writes::<$R>(values).only(|at| wave(at, 4)), value_count: count(values).wrong(values + 1, Status::LengthValues),
                scratch: rooms(room), scratch_count: few(room), report: writes::<ReachReport<$R>>(1),
            ) => {
                let options = options.first().map(known).unwrap_or_default();
                let mut search = search(&one, goals, posture)?;
                report[0] = told(&search.solve(targets, values, &options)?);
            };
            "" targets reach_scratch (
                mechanism: scene.argument(), goal_count: passes(goal_count).wrong(1025, Status::TooLarge),
                scratch_count: writes::<usize>(1),
            ) => scratch_count[0] = room_of_many;
            "" targets reach (
                mechanism: scene.argument(), goals: goals::<$R>($shape), goal_count: count(goal_count),
                targets: reads::<DualQuat<$R>>(goal_count * n).of(target), posture: posture(), options: asks(),
                values: writes::<$R>(values * n).only(|at| wave(at, 4)),
                value_count: count(values * n).wrong(values * n + 1, Status::LengthValues),
                scratch: rooms(room_of_many), scratch_count: few(room_of_many),
                reports: writes::<ReachReport<$R>>(n), count: count(n).wrong_if(values > 0, n + 1, Status::LengthValues),
            ) => {
                let options = options.first().map(known).unwrap_or_default();
                let search = search(&many, goals, posture)?;
                let mut all = vec![Report::default(); reports.len()];
                search.job().solve(targets, values, &mut all, &options)?;
                reports.iter_mut().zip(&all).for_each(|(report, known)| *report = told(known));
            };
        }
    }};
}

/// A shape whose mechanism is an arm with a spherical wrist, which formulas solve, with one more
/// joint that does not carry its link.
fn with_arm(shape: &Shape) -> Shape {
    let hinge = |parent: Option<usize>, at: [f64; 3], axis: [f64; 3]| {
        Joint::revolute(parent, DualQuat::from_translation(at), axis)
    };
    let [x, y, z, here] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0; 3]];
    let joints = vec![
        hinge(None, here, z),
        hinge(Some(0), z, y),
        hinge(Some(1), z, y),
        hinge(Some(2), here, x),
        hinge(Some(3), x, y),
        hinge(Some(4), here, x),
        hinge(Some(0), x, y),
    ];
    Shape { joints, ..shape.clone() }
}

/// The solutions in C.
fn listed<R>(found: &ik::Solutions<R>) -> SolutionList<R> {
    // SAFETY: the library has checked that both have one layout.
    unsafe { std::mem::transmute_copy(found) }
}

macro_rules! add_solutions {
    ($shape:ident $list:ident $R:ident $of:ident) => {{
        let scene = Scene::<$R>::$of(&with_arm($shape));
        let mut room = 0;
        // SAFETY: it has been made.
        let said = unsafe { solutions::$of::solutions_scratch(&raw const scene.made, &raw mut room) };
        assert_eq!(said, Status::Ok);
        let (n, [arm, placed]) = ($shape.count, [(); 2].map(|()| Rc::clone(&scene)));
        let values = |at: usize| std::array::from_fn::<$R, 7, _>(|joint| wave(7 * at + joint, 5));
        let goal = Goal::<$R> { link: 5, angular: [1.0; 3], linear: [1.0; 3], point: [0.1, 0.2, 0.3] };
        of_numbers! { $list $R $of:
            "" solutions solutions_scratch (mechanism: scene.argument(), scratch_count: writes::<usize>(1))
                => scratch_count[0] = room;
            "" solutions solutions (
                mechanism: scene.argument(),
                goal: reads::<Goal<$R>>(1).only(move |_| goal)
                    .fault(Status::NoLink, None, |goal| goal[0].link = 7)
                    .fault(Status::Weight, None, |goal| goal[0].linear[1] = -1.0)
                    .fault(Status::NotSixHinges, None, |goal| goal[0].linear[1] = 0.0)
                    .fault(Status::NotSixHinges, None, |goal| goal[0].link = 6),
                targets: reads::<DualQuat<$R>>(n)
                    .only(move |at| placed.rust.view().link_pose(&values(at), 5).expect("a link"))
                    .fault(Status::NotFinite, Some(2), |targets| targets[2] = DualQuat::from_array([<$R>::NAN; 8]))
                    .fault(Status::NotUnit, Some(1), |targets| targets[1] = targets[1].scale(2.0)),
                starts: reads::<[$R; 6]>(n).only(move |at| std::array::from_fn(|hinge| wave(at + hinge, 8)))
                    .fault(Status::NotFinite, Some(1), |starts| starts[1][3] = <$R>::INFINITY),
                scratch: writes::<$R>(room).scratch(),
                scratch_count: count(room).wrong(room - 1, Status::LengthScratch),
                found: writes::<SolutionList<$R>>(n), count: count(n), bad_target: names(),
            ) => {
                let search = search(&arm, goal, &[])?;
                let solver = SixAxisArm::new(search.view()).map_err(|_| Status::NotSixHinges)?;
                let mut all = vec![ik::Solutions::default(); n];
                solver.job().solutions(targets, starts, &mut all).expect("targets that may be");
                found.iter_mut().zip(&all).for_each(|(list, known)| *list = listed(known));
            };
        }
    }};
}

pub(super) fn add(shape: &Shape, to: &mut Vec<Function>) {
    add_solutions!(shape to f32 single);
    add_solutions!(shape to f64 double);
    add!(shape to f32 single);
    add!(shape to f64 double);
}

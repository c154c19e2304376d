//! Robots of URDF files. The only file that knows where robots come from.

use crate::Motion;
use crate::error::{made, status};
use crate::memory::{exports, frees};
use dq8::ShapeError;
use dq8_robot::ik::{Goal, Options, OwnedReach, Report, SixAxisArm, Solutions};
use dq8_robot::urdf::{ChangeError, Robot as Urdf};
use dq8_robot::{Joint, OwnedMechanism, World};
use std::fmt::{Display, Write};

#[derive(Debug)]
struct Robot {
    mechanism: OwnedMechanism<f32>,
    /// Two numbers for each value, without end where there are none.
    limits: Vec<f32>,
    /// How many links and values there are, the names of links and of values, parents and warnings,
    /// each after a zero, which no file can hold.
    text: String,
    poses: Vec<Motion>,
    /// The problems that have been asked for, by link and by what of it is to be at the target.
    problems: Vec<(usize, u32, OwnedReach<f32>)>,
    scratch: Vec<f32>,
    reports: Vec<Report<f32>>,
    solutions: Vec<f32>,
}

/// The texts of errors in place of them, so that functions of several errors are compiled once.
fn text<T, E: Display>(result: Result<T, E>) -> Result<T, String> {
    result.map_err(|error| error.to_string())
}

impl Robot {
    fn new(urdf: &Urdf) -> Result<Self, String> {
        let mechanism = text(urdf.cast::<f32>())?;
        let limits = urdf.value_limits().into_iter().flat_map(|limits| {
            limits.map_or([f32::NEG_INFINITY, f32::INFINITY], |range| range.map(|end| end as f32))
        });
        let (links, values) = (urdf.link_names(), urdf.value_names());
        let mut text = format!("{}\0{}", links.len(), values.len());
        let mut add = |item: &dyn Display| _ = write!(text, "\0{item}");
        for name in links.iter().chain(values) {
            add(name);
        }
        for joint in urdf.joints() {
            add(&joint.parent.map_or(-1, |parent| parent as i32));
        }
        for warning in urdf.warnings() {
            add(warning);
        }
        Ok(Self {
            limits: limits.collect(),
            text,
            mechanism,
            poses: Vec::new(),
            problems: Vec::new(),
            scratch: Vec::new(),
            reports: Vec::new(),
            solutions: Vec::new(),
        })
    }

    /// Where among the problems the one of a link is, whose pose (0) or position (1) is asked for.
    fn problem(&mut self, link: usize, goal: u32) -> Result<usize, String> {
        let found = self.problems.iter().position(|&(of, as_is, _)| (of, as_is) == (link, goal));
        if let Some(index) = found {
            return Ok(index);
        }
        let goals = [if goal == 0 { Goal::pose(link) } else { Goal::position(link) }];
        let reach = OwnedReach::new(self.mechanism.clone(), goals);
        self.problems.push((link, goal, text(reach)?));
        Ok(self.problems.len() - 1)
    }

    fn reach(
        &mut self,
        (link, goal): (usize, u32),
        targets: &[Motion],
        values: &mut [f32],
        options: &Options<f32>,
    ) -> Result<(), String> {
        let index = self.problem(link, goal)?;
        let reach = self.problems[index].2.view();
        let length = reach.batch_scratch_len().max(self.scratch.len());
        self.scratch.resize(length, 0.0);
        text(reach.job().solve_in(&mut self.scratch, targets, values, &mut self.reports, options))
    }

    /// Writes a number of the family, whether these are all, and for each solution a whole
    /// configuration, how far it is from `values`, and at which of three places it is singular.
    fn solve(&mut self, link: usize, target: Motion, values: &[f32]) -> Result<(), String> {
        let index = self.problem(link, 0)?;
        let arm = text(SixAxisArm::new(self.problems[index].2.view()))?;
        let hinges = arm.values();
        let start = hinges.map(|value| values.get(value).copied().unwrap_or(f32::NAN));
        let mut found = [Solutions::default()];
        text(arm.job().solutions(&[target], &[start], &mut found))?;
        let [found] = found;
        self.solutions.clear();
        self.solutions.extend([arm.family() as u32 as f32, f32::from(u8::from(found.is_complete))]);
        for solution in found.iter() {
            let first = self.solutions.len();
            self.solutions.extend_from_slice(values);
            for (hinge, value) in hinges.iter().zip(solution.values) {
                self.solutions[first + hinge] = value;
            }
            let singular = solution.singular;
            let singular = [singular.shoulder, singular.elbow, singular.wrist];
            self.solutions.push(solution.distance);
            self.solutions.extend(singular.map(|is| f32::from(u8::from(is))));
        }
        Ok(())
    }
}

/// A robot as its file has it, until its base and its tools are there; `None` after an error.
type Draft = Option<Urdf>;

fn changed(
    draft: &mut Draft,
    change: impl FnOnce(Urdf) -> Result<Urdf, ChangeError>,
) -> Result<(), String> {
    let changed = draft.take().map(change).transpose();
    *draft = text(changed)?;
    Ok(())
}

frees!(dq8_robot_free: Robot);
frees!(dq8_urdf_free: Draft);
exports! {
    /// JavaScript knows more encodings than are worth their tables here; it sends UTF-8.
    fn dq8_urdf(; urdf[bytes]: u8;) -> *mut Draft {
        made(Urdf::from_urdf(&String::from_utf8_lossy(urdf)).map(Some))
    }

    /// A base that moves freely.
    fn dq8_urdf_floating(draft: &mut Draft;;) -> u32 {
        status(changed(draft, Urdf::floating))
    }

    /// A base that stands at a pose.
    fn dq8_urdf_base(draft: &mut Draft, pose: &Motion;;) -> u32 {
        let base = Joint::fixed(None, pose.cast());
        status(changed(draft, |urdf| urdf.on("root_joint", base)))
    }

    /// One more link, fixed to another.
    fn dq8_urdf_tool(draft: &mut Draft, pose: &Motion; name[name_bytes]: u8, link[link_bytes]: u8;) -> u32 {
        let [name, link] = [name, link].map(String::from_utf8_lossy);
        status(changed(draft, |urdf| urdf.with_tool(&name, &link, pose.cast())))
    }

    fn dq8_robot(draft: &Draft;;) -> *mut Robot {
        let Some(urdf) = draft else { return std::ptr::null_mut() };
        made(Robot::new(urdf))
    }

    fn dq8_robot_text(robot: &Robot;;) -> *const u8 { robot.text.as_ptr() }

    fn dq8_robot_text_length(robot: &Robot;;) -> usize { robot.text.len() }

    fn dq8_robot_rates(robot: &Robot;;) -> usize { robot.mechanism.view().rates() }

    fn dq8_robot_limits(robot: &Robot;;) -> *const f32 { robot.limits.as_ptr() }

    /// `[configuration][value]` to `[configuration][link]`.
    fn dq8_robot_poses(robot: &Robot; values[value_count]: f32; poses[count]: Motion) -> u32 {
        status(robot.mechanism.job().poses(values, poses))
    }

    /// `[configuration][rate]` of six numbers each, angular first, in the axes of the world.
    fn dq8_robot_jacobians(
        robot: &mut Robot, link: usize; values[value_count]: f32; columns[count]: [f32; 6]
    ) -> u32 {
        let Robot { mechanism, poses, .. } = robot;
        let configurations = values.len().checked_div(mechanism.view().values()).unwrap_or(1);
        poses.resize(configurations, Motion::IDENTITY);
        status(mechanism.job().links(&[link]).jacobians(World, values, poses, columns))
    }

    /// Moves the values of so many configurations until a link is at the target of each, a pose (0)
    /// or a position (1).
    fn dq8_robot_reach(
        robot: &mut Robot, link: usize, goal: u32, restarts: u32, configurations: usize;
        targets[target_count]: Motion; values[value_count]: f32
    ) -> u32 {
        robot.reports.resize(configurations, Report::default());
        let options = Options { restarts: restarts != 0, ..Options::default() };
        status(robot.reach((link, goal), targets, values, &options))
    }

    /// What became of each configuration: five words.
    fn dq8_robot_reports(robot: &Robot;;) -> *const Report<f32> { robot.reports.as_ptr() }

    /// Finds all values that bring a link of a six-axis arm to a target.
    fn dq8_robot_solve(
        robot: &mut Robot, link: usize; target[target_count]: Motion, values[value_count]: f32;
    ) -> u32 {
        let needed = robot.mechanism.view().values();
        for (what, length, expected) in [("target", target_count, 1), ("values", value_count, needed)] {
            if length != expected {
                return status(Err(ShapeError::Length { what, length, expected }));
            }
        }
        status(robot.solve(link, target[0], values))
    }

    fn dq8_robot_solutions(robot: &Robot;;) -> *const f32 { robot.solutions.as_ptr() }

    fn dq8_robot_solutions_length(robot: &Robot;;) -> usize { robot.solutions.len() }
}

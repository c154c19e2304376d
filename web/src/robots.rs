//! Robots of URDF files. The only file that knows where robots come from.

use crate::Motion;
use crate::memory::{exports, failed, frees, made, status};
use dq8_robot::ik::{Goal, Options, OwnedReach};
use dq8_robot::urdf::Robot as Urdf;
use dq8_robot::{OwnedMechanism, World};

#[derive(Debug)]
struct Robot {
    mechanism: OwnedMechanism<f32>,
    /// Two numbers for each value, without end where there are none.
    limits: Vec<f32>,
    /// Links, then values, then parents, then warnings: lines, parted by tabs.
    text: String,
    poses: Vec<Motion>,
    reach: Option<(usize, u32, OwnedReach<f32>)>,
    scratch: Vec<f32>,
}

impl Robot {
    fn from_urdf(urdf: &str) -> Result<Self, String> {
        let urdf = Urdf::from_urdf(urdf).map_err(|error| error.to_string())?;
        let mechanism = urdf.cast::<f32>().map_err(|error| error.to_string())?;
        let limits = urdf.value_limits().into_iter().flat_map(|limits| {
            limits.map_or([f32::NEG_INFINITY, f32::INFINITY], |range| range.map(|end| end as f32))
        });
        let parents = urdf.joints().iter();
        let parents = parents.map(|joint| joint.parent.map_or("-1".into(), |to| to.to_string()));
        let lines = [
            urdf.link_names().join("\t"),
            urdf.value_names().join("\t"),
            parents.collect::<Vec<_>>().join("\t"),
            urdf.warnings().iter().map(ToString::to_string).collect::<Vec<_>>().join("\t"),
        ];
        Ok(Self {
            limits: limits.collect(),
            text: lines.map(|line| line.replace('\n', " ")).join("\n"),
            mechanism,
            poses: Vec::new(),
            reach: None,
            scratch: Vec::new(),
        })
    }
}

frees!(dq8_robot_free: Robot);
exports! {
    /// JavaScript knows more encodings than are worth their tables here; it sends UTF-8.
    fn dq8_robot(; urdf[bytes]: u8;) -> *mut Robot {
        made(Robot::from_urdf(&String::from_utf8_lossy(urdf)))
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

    /// Moves values until a link is at its target, a pose (0) or a position (1). What became of it:
    /// a number of `Outcome`, or 255 and an error. `report` gets iterations, restarts and the two
    /// errors.
    fn dq8_robot_reach(
        robot: &mut Robot, link: usize, goal: u32, restarts: u32, report: &mut [f32; 4];
        target[target_count]: Motion; values[value_count]: f32
    ) -> u32 {
        const FAILED: u32 = 255;
        if !matches!(robot.reach, Some((of, as_is, _)) if (of, as_is) == (link, goal)) {
            let goals = [if goal == 0 { Goal::pose(link) } else { Goal::position(link) }];
            match OwnedReach::new(robot.mechanism.clone(), goals) {
                Ok(reach) => {
                    robot.scratch = vec![0.0; reach.view().scratch_len()];
                    robot.reach = Some((link, goal, reach));
                }
                Err(error) => return failed(error, FAILED),
            }
        }
        let Some((_, _, reach)) = &robot.reach else { return FAILED };
        let options = Options { restarts: restarts != 0, ..Options::default() };
        match reach.view().solve(target, values, &mut robot.scratch, &options) {
            Ok(found) => {
                let counts = [found.iterations as f32, found.restarts as f32];
                *report = [counts[0], counts[1], found.angular_error, found.linear_error];
                found.outcome as u32
            }
            Err(error) => failed(error, FAILED),
        }
    }
}

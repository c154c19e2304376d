//! Robots of URDF files. The only file that knows where robots come from.

use crate::Motion;
use crate::memory::{failed, made, slice, slice_mut, status};
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

/// JavaScript knows more encodings than are worth their tables here; it sends UTF-8.
///
/// # Safety
/// So many bytes are there.
#[unsafe(no_mangle)]
unsafe extern "C" fn dq8_robot(urdf: *const u8, bytes: usize) -> *mut Robot {
    // SAFETY: promised.
    made(Robot::from_urdf(&String::from_utf8_lossy(unsafe { slice(urdf, bytes) })))
}

/// # Safety
/// It has been made, and is not used any more.
#[unsafe(no_mangle)]
unsafe extern "C" fn dq8_robot_free(robot: *mut Robot) {
    // SAFETY: promised.
    drop(unsafe { Box::from_raw(robot) });
}

#[unsafe(no_mangle)]
extern "C" fn dq8_robot_text(robot: &Robot) -> *const u8 {
    robot.text.as_ptr()
}

#[unsafe(no_mangle)]
extern "C" fn dq8_robot_text_length(robot: &Robot) -> usize {
    robot.text.len()
}

#[unsafe(no_mangle)]
extern "C" fn dq8_robot_rates(robot: &Robot) -> usize {
    robot.mechanism.view().rates()
}

#[unsafe(no_mangle)]
extern "C" fn dq8_robot_limits(robot: &Robot) -> *const f32 {
    robot.limits.as_ptr()
}

/// `[configuration][value]` to `[configuration][link]`.
///
/// # Safety
/// So many are there, apart.
#[unsafe(no_mangle)]
unsafe extern "C" fn dq8_robot_poses(
    robot: &Robot,
    values: *const f32,
    value_count: usize,
    poses: *mut Motion,
    count: usize,
) -> u32 {
    // SAFETY: promised.
    let (values, poses) = unsafe { (slice(values, value_count), slice_mut(poses, count)) };
    status(robot.mechanism.job().poses(values, poses))
}

/// `[configuration][rate]` of six numbers each, angular first, in the axes of the world.
///
/// # Safety
/// So many are there, apart.
#[unsafe(no_mangle)]
unsafe extern "C" fn dq8_robot_jacobians(
    robot: &mut Robot,
    link: usize,
    values: *const f32,
    value_count: usize,
    columns: *mut [f32; 6],
    count: usize,
) -> u32 {
    let Robot { mechanism, poses, .. } = robot;
    // SAFETY: promised.
    let (values, columns) = unsafe { (slice(values, value_count), slice_mut(columns, count)) };
    let configurations = values.len().checked_div(mechanism.view().values()).unwrap_or(1);
    poses.resize(configurations, Motion::IDENTITY);
    status(mechanism.job().links(&[link]).jacobians(World, values, poses, columns))
}

/// Moves values until a link is at its target, a pose (0) or a position (1). What became of it: a number of
/// `Outcome`, or 255 and an error. `report` gets iterations, restarts and the two errors.
///
/// # Safety
/// So many are there, apart.
#[unsafe(no_mangle)]
unsafe extern "C" fn dq8_robot_reach(
    robot: &mut Robot,
    link: usize,
    goal: u32,
    restarts: u32,
    target: *const Motion,
    target_count: usize,
    values: *mut f32,
    value_count: usize,
    report: &mut [f32; 4],
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
    // SAFETY: promised.
    let (target, values) = unsafe { (slice(target, target_count), slice_mut(values, value_count)) };
    let options = Options { restarts: restarts != 0, ..Options::default() };
    match reach.view().solve(target, values, &mut robot.scratch, &options) {
        Ok(found) => {
            *report = [
                found.iterations as f32,
                found.restarts as f32,
                found.angular_error,
                found.linear_error,
            ];
            found.outcome as u32
        }
        Err(error) => failed(error, FAILED),
    }
}

//! The pose of the clip that stands for the robot's own: a person who stands, from whose limbs and
//! axes all other frames are counted.

use crate::map::{Place, ROLES};
use dq8::scalar::vector::{add, cross, dot, norm, over_norm, scale, sub};
use dq8::{DualQuat, Quat};
use mocap::clip::{Channel, Clip, Joint};
use std::error::Error;

type Vector = [f64; 3];

/// The pose from which the turns of joints are counted.
#[derive(Debug)]
pub(crate) struct Rest {
    /// The poses of all joints, in the axes of the file.
    pub(crate) poses: Vec<DualQuat<f64>>,
    /// The rotation from the axes of the file to those of robots: x forward, y to the left, z up.
    pub(crate) axes: Quat<f64>,
    /// The sentence that tells which pose was taken, if it is not that with all channels zero.
    pub(crate) told: Option<String>,
}

impl Rest {
    /// Takes the pose of the asked frame. If none is asked for, takes the pose in which all
    /// channels are zero if a person stands in it. In files whose axes lie along the bones, that
    /// pose is a straight line; then the first frame in which a person stands is taken.
    ///
    /// # Errors
    /// If there is no such frame.
    pub(crate) fn of(
        clip: &Clip,
        places: &[Place],
        asked: Option<usize>,
    ) -> Result<Self, Box<dyn Error>> {
        let joints = clip.joints.len();
        let all = clip.models()?;
        let taken = |frame: usize| -> Option<Self> {
            let poses = all.chunks_exact(joints).nth(frame)?.to_vec();
            let axes = facing(places, &positions(&poses));
            let told = Some(format!("frame {frame} is the rest pose"));
            Some(Self { poses, axes, told })
        };
        if let Some(frame) = asked {
            return taken(frame).ok_or_else(|| {
                format!("--rest {frame}: the clip has {} frames, from 0 on", clip.frames()).into()
            });
        }
        let poses = Clip { values: zero_channels(clip), ..clip.clone() }.models()?;
        let axes = facing(places, &positions(&poses));
        let zero = Self { poses, axes, told: None };
        if zero.stands(places) {
            return Ok(zero);
        }
        // Someone who lies in a frame is upright along another axis than in most frames.
        let upright = upright(places, &all, joints);
        let found = (0..clip.frames()).find_map(|frame| {
            taken(frame).filter(|rest| {
                dot(rest.axes.conjugate().rotate([0.0, 0.0, 1.0]), upright) > 0.5
                    && rest.stands(places)
            })
        });
        found.ok_or_else(|| {
            "no rest pose was found: with all channels zero, and in each frame, the head is not above the hips, \
             the hips are not above the feet, or left and right are exchanged. Name a frame in which the person \
             stands: --rest FRAME"
                .into()
        })
    }

    /// Returns `true` if the head is above the hips, the hips are above the feet, and each left
    /// part is to the left of the right one.
    fn stands(&self, places: &[Place]) -> bool {
        let place = |role: usize| {
            let found = places.iter().find(|place| place.role == role)?;
            Some(self.axes.rotate(self.poses[found.joint].translation()))
        };
        // The trunk's length is the measure of what counts as apart.
        let (Some(pelvis), Some(top)) = (place(0), place(2).or(place(1))) else { return false };
        let trunk = top[2] - pelvis[2];
        let apart = |left: usize| match (place(left), place(left + 6)) {
            (Some(left), Some(right)) => left[1] - right[1] > 0.05 * trunk,
            _ => true,
        };
        let below = |role: usize| place(role).is_none_or(|low| pelvis[2] - low[2] > 0.3 * trunk);
        let leans = norm([top[0] - pelvis[0], top[1] - pelvis[1]]);
        trunk > leans && (3..9).all(apart) && [7, 8, 13, 14].into_iter().all(below)
    }
}

/// The direction from the hips to the head in the axes of the file, in the mean of all frames.
fn upright(places: &[Place], all: &[DualQuat<f64>], joints: usize) -> Vector {
    let mut sum = [0.0; 3];
    for poses in all.chunks_exact(joints) {
        sum = add(sum, up(places, &positions(poses)));
    }
    if norm(sum) > 0.0 { over_norm(sum, norm(sum)) } else { sum }
}

/// The way from the hips to the head, or to the chest.
fn up(places: &[Place], at: &[Vector]) -> Vector {
    let place = |role: usize| Some(at[places.iter().find(|place| place.role == role)?.joint]);
    match (place(2).or(place(1)), place(0)) {
        (Some(top), Some(pelvis)) => sub(top, pelvis),
        _ => [0.0; 3],
    }
}

/// From the axes of a clip to those of robots: x forward, y to the left, z up.
fn facing(places: &[Place], at: &[Vector]) -> Quat<f64> {
    let place = |role: usize| Some(at[places.iter().find(|place| place.role == role)?.joint]);
    let mut left = [0.0; 3];
    for role in (3..ROLES.len()).take(6) {
        if let (Some(a), Some(b)) = (place(role), place(role + 6)) {
            left = add(left, sub(a, b));
        }
    }
    // The axis of the file that is nearest to up: spines lean.
    let up = up(places, at);
    let largest = (0..3).max_by(|&a, &b| up[a].abs().total_cmp(&up[b].abs())).unwrap_or(1);
    let up = core::array::from_fn(|axis| if axis == largest { up[axis].signum() } else { 0.0 });
    let left = sub(left, scale(up, dot(left, up)));
    let left = over_norm(left, norm(left));
    Quat::from_matrix3([cross(left, up), left, up]).normalize()
}

/// The values of the clip with no turns, the root at the origin, and every other joint that has
/// position channels where the first frame has it. Files that give all joints positions repeat the
/// offsets there, which zeros would drop.
fn zero_channels(clip: &Clip) -> Vec<f64> {
    let channels =
        clip.joints.iter().flat_map(|joint| joint.channels.iter().map(move |c| (joint, c)));
    let keeps = |(joint, channel): (&Joint, &Channel)| {
        joint.parent.is_some() && matches!(channel, Channel::Position(_))
    };
    clip.values
        .iter()
        .zip(channels)
        .map(|(&value, of)| if keeps(of) { value } else { 0.0 })
        .collect()
}

pub(crate) fn positions(poses: &[DualQuat<f64>]) -> Vec<Vector> {
    poses.iter().map(|pose| pose.translation()).collect()
}

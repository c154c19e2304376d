//! The pose of the person that stands for the robot's own: a person who stands, from whose limbs
//! and axes all other frames are counted.

use crate::role::Role;
use crate::shape::leftward;
use crate::{Person, RetargetError};
use dq8::scalar::vector::{add, cross, dot, norm, over_norm, scale, sub};
use dq8::{DualQuat, Quat};

type Vector = [f64; 3];

/// Hips that are at least at this share of their greatest height are those of a person who stands
/// upright.
const HIGH: f64 = 0.95;

/// The pose from which the turns of joints are counted.
#[derive(Debug)]
pub(crate) struct Rest {
    /// The poses of all joints, in the axes of the file.
    pub(crate) poses: Vec<DualQuat<f64>>,
    /// The rotation from the axes of the file to those of robots: x forward, y to the left, z up.
    pub(crate) axes: Quat<f64>,
    /// The sentence that tells which pose was taken, if it is not the neutral one.
    pub(crate) told: Option<String>,
}

impl Rest {
    /// Takes the pose of the asked frame. If none is asked for, takes the neutral pose if a person
    /// stands in it. In files whose axes lie along the bones, that pose is a straight line; then
    /// the mean of the frames in which a person stands is taken.
    pub(crate) fn of(person: &Person, asked: Option<usize>) -> Result<Self, RetargetError> {
        if let Some(asked) = asked {
            let frames = person.frames();
            if asked >= frames {
                return Err(RetargetError::RestFrame { asked, frames });
            }
            let poses = person.poses(asked..asked + 1)?;
            let told = Some(format!("frame {asked} is the rest pose"));
            return Ok(Self { axes: facing(person, &poses), poses, told });
        }
        if let Some(poses) = person.neutral() {
            let axes = facing(person, poses);
            if stands(person, poses, axes) {
                return Ok(Self { poses: poses.to_vec(), axes, told: None });
            }
        }
        // A person who lies in a frame is upright along another axis than in most frames.
        let all = person.poses(0..person.frames())?;
        let upright = upright(person, &all);
        let frames = all.chunks_exact(person.joint_names().len());
        let mut standing: Vec<_> = frames.map(|poses| (poses, facing(person, poses))).collect();
        standing.retain(|&(poses, axes)| {
            dot(axes.conjugate().rotate([0.0, 0.0, 1.0]), upright) > 0.5
                && stands(person, poses, axes)
        });
        Self::mean(person, standing).ok_or(RetargetError::NoRest)
    }

    /// Returns the mean of the poses whose hips are about as high as in any, each turned so that
    /// all of them face the same way. In a single frame, people are bent and turned by a step.
    fn mean(person: &Person, mut standing: Vec<(&[DualQuat<f64>], Quat<f64>)>) -> Option<Self> {
        let height = |&(poses, axes): &(&[DualQuat<f64>], Quat<f64>)| {
            let place = |role| Some(axes.rotate(place_of(person, poses, role)?)[2]);
            let feet = [Role::LeftFoot, Role::RightFoot].into_iter().filter_map(place);
            feet.reduce(f64::min).and_then(|low| Some(place(Role::Pelvis)? - low)).unwrap_or(0.0)
        };
        let most = standing.iter().map(height).fold(0.0, f64::max);
        standing.retain(|frame| height(frame) >= HIGH * most);
        let &(first, axes) = standing.first()?;
        let mut poses = first.to_vec();
        for (joint, parent) in person.parents().iter().enumerate() {
            let sum = standing.iter().fold([0.0; 4], |sum, (poses, facing)| {
                let turn = axes.conjugate() * *facing * poses[joint].rotation();
                let sign = if turn.dot(first[joint].rotation()) < 0.0 { -1.0 } else { 1.0 };
                let turn = turn.to_array();
                core::array::from_fn(|i| sum[i] + sign * turn[i])
            });
            // Bones keep their lengths.
            let at = parent.map_or(first[joint].translation(), |on| {
                let bone = first[on].conjugate().transform_point(first[joint].translation());
                poses[on].transform_point(bone)
            });
            let turn = Quat::from_array(sum).normalize();
            poses[joint] = DualQuat::from_rotation_translation(turn, at);
        }
        let (count, frames) = (standing.len(), person.frames());
        let told = format!(
            "the rest pose is the mean of {count} of {frames} frames, in which the person stands upright"
        );
        Some(Self { poses, axes, told: Some(told) })
    }
}

/// Returns `true` if the head is above the hips, the hips are above the feet, and each left part is
/// to the left of the right one.
fn stands(person: &Person, poses: &[DualQuat<f64>], axes: Quat<f64>) -> bool {
    let place = |role: Role| Some(axes.rotate(place_of(person, poses, role)?));
    // The trunk's length is the measure of what counts as apart.
    let (Some(pelvis), Some(top)) = (place(Role::Pelvis), place(Role::Head).or(place(Role::Chest)))
    else {
        return false;
    };
    let trunk = top[2] - pelvis[2];
    let apart = |[left, right]: [Role; 2]| match (place(left), place(right)) {
        (Some(left), Some(right)) => left[1] - right[1] > 0.05 * trunk,
        _ => true,
    };
    let below = |role: Role| place(role).is_none_or(|low| pelvis[2] - low[2] > 0.3 * trunk);
    let leans = norm([top[0] - pelvis[0], top[1] - pelvis[1]]);
    let mut low = Role::ALL.into_iter().filter(|role| role.is_below_hips());
    trunk > leans && Role::PAIRS.into_iter().all(apart) && low.all(below)
}

fn place_of(person: &Person, poses: &[DualQuat<f64>], role: Role) -> Option<Vector> {
    Some(poses[person.joint(role)?].translation())
}

/// Returns the direction from the hips to the head in the axes of the file, in the mean of all
/// frames.
fn upright(person: &Person, all: &[DualQuat<f64>]) -> Vector {
    let frames = all.chunks_exact(person.joint_names().len());
    let sum = frames.fold([0.0; 3], |sum, poses| add(sum, up(person, poses)));
    if norm(sum) > 0.0 { over_norm(sum, norm(sum)) } else { sum }
}

/// Returns the way from the hips to the head, or to the chest.
fn up(person: &Person, poses: &[DualQuat<f64>]) -> Vector {
    let place = |role| place_of(person, poses, role);
    match (place(Role::Head).or(place(Role::Chest)), place(Role::Pelvis)) {
        (Some(top), Some(pelvis)) => sub(top, pelvis),
        _ => [0.0; 3],
    }
}

/// Returns the rotation from the axes of a clip to those of robots: x forward, y to the left, z up.
fn facing(person: &Person, poses: &[DualQuat<f64>]) -> Quat<f64> {
    // The axis of the file that is nearest to up, because spines lean.
    let up = up(person, poses);
    let largest = (0..3).max_by(|&a, &b| up[a].abs().total_cmp(&up[b].abs())).unwrap_or(1);
    let up = core::array::from_fn(|axis| if axis == largest { up[axis].signum() } else { 0.0 });
    let left = leftward(|role| place_of(person, poses, role));
    let left = sub(left, scale(up, dot(left, up)));
    if norm(left) == 0.0 {
        return Quat::IDENTITY;
    }
    let left = over_norm(left, norm(left));
    Quat::from_matrix3([cross(left, up), left, up]).normalize()
}

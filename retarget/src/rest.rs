//! The pose of the person that stands for the robot's own: a person who stands, from whose limbs
//! and axes all other frames are counted.

use crate::role::Role;
use crate::{Person, RetargetError};
use dq8::scalar::vector::{add, cross, dot, norm, over_norm, scale, sub};
use dq8::{DualQuat, Quat};

type Vector = [f64; 3];

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
    /// the first frame in which a person stands is taken.
    pub(crate) fn of(person: &Person, asked: Option<usize>) -> Result<Self, RetargetError> {
        let taken = |frame: usize, poses: &[DualQuat<f64>]| {
            let told = Some(format!("frame {frame} is the rest pose"));
            Self { poses: poses.to_vec(), axes: facing(person, poses), told }
        };
        if let Some(asked) = asked {
            let frames = person.frames();
            if asked >= frames {
                return Err(RetargetError::RestFrame { asked, frames });
            }
            return Ok(taken(asked, &person.poses(asked..asked + 1)?));
        }
        if let Some(poses) = person.neutral() {
            let axes = facing(person, poses);
            let neutral = Self { poses: poses.to_vec(), axes, told: None };
            if neutral.stands(person) {
                return Ok(neutral);
            }
        }
        // A person who lies in a frame is upright along another axis than in most frames.
        let all = person.poses(0..person.frames())?;
        let joints = person.joint_names().len();
        let upright = upright(person, &all);
        let frames = all.chunks_exact(joints).enumerate();
        let mut standing = frames.map(|(frame, poses)| taken(frame, poses)).filter(|rest| {
            dot(rest.axes.conjugate().rotate([0.0, 0.0, 1.0]), upright) > 0.5 && rest.stands(person)
        });
        standing.next().ok_or(RetargetError::NoRest)
    }

    /// Returns `true` if the head is above the hips, the hips are above the feet, and each left
    /// part is to the left of the right one.
    fn stands(&self, person: &Person) -> bool {
        let place = |role: Role| Some(self.axes.rotate(place_of(person, &self.poses, role)?));
        // The trunk's length is the measure of what counts as apart.
        let (Some(pelvis), Some(top)) =
            (place(Role::Pelvis), place(Role::Head).or(place(Role::Chest)))
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
    let mut left = [0.0; 3];
    for [of_left, of_right] in Role::PAIRS {
        let places = (place_of(person, poses, of_left), place_of(person, poses, of_right));
        if let (Some(a), Some(b)) = places {
            left = add(left, sub(a, b));
        }
    }
    // The axis of the file that is nearest to up, because spines lean.
    let up = up(person, poses);
    let largest = (0..3).max_by(|&a, &b| up[a].abs().total_cmp(&up[b].abs())).unwrap_or(1);
    let up = core::array::from_fn(|axis| if axis == largest { up[axis].signum() } else { 0.0 });
    let left = sub(left, scale(up, dot(left, up)));
    if norm(left) == 0.0 {
        return Quat::IDENTITY;
    }
    let left = over_norm(left, norm(left));
    Quat::from_matrix3([cross(left, up), left, up]).normalize()
}

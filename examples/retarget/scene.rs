//! The clip and the robot in one world: where each part should be in each frame.

use crate::map::{Place, ROLES};
use dq8::scalar::vector::{add, cross, dot, norm, over_norm, scale, sub};
use dq8::{DualQuat, Quat};
use dq8_robot::ik::{Goal, Options, OwnedReach, Tracking};
use dq8_robot::urdf::Robot;
use mocap::clip::{Channel, Clip, Joint};
use std::error::Error;

type Vector = [f64; 3];

pub(crate) struct Scene {
    pub(crate) robot: Robot,
    pub(crate) clip: Clip,
    pub(crate) places: Vec<Place>,
    pub(crate) goals: Vec<Goal<f64>>,
    /// `[frame][goal]`
    pub(crate) targets: Vec<DualQuat<f64>>,
    /// Places of the joints of the clip, in the axes and the size of the robot: `[frame][joint]`.
    pub(crate) skeleton: Vec<Vector>,
    /// Where the robot stands as the clip does at rest, moved to the first frame.
    pub(crate) start: Vec<f64>,
    /// Seconds from frame to frame.
    pub(crate) step: f64,
}

impl Scene {
    pub(crate) fn new(
        robot: Robot,
        clip: Clip,
        places: Vec<Place>,
        rate: f64,
    ) -> Result<Self, Box<dyn Error>> {
        let stride = (1.0 / (rate * clip.frame_time)).round().max(1.0) as usize;
        let still = Clip { values: rest(&clip), ..clip.clone() };
        let unturned = positions(&still.models()?);
        let axes = facing(&places, &unturned);
        let rest: Vec<_> = unturned.iter().map(|&place| axes.rotate(place)).collect();
        let stance = Stance::new(&robot, &places, &rest)?;

        let all = clip.models()?;
        let (mut targets, mut skeleton) = (Vec::new(), Vec::new());
        // Many files begin with the skeleton at rest, and then jump into the motion.
        let first = usize::from(jumps(&all, clip.joints.len()));
        for poses in all.chunks_exact(clip.joints.len()).skip(first).step_by(stride) {
            let turns: Vec<_> =
                poses.iter().map(|pose| axes * pose.rotation() * axes.conjugate()).collect();
            let places_now: Vec<_> =
                poses.iter().map(|pose| axes.rotate(pose.translation())).collect();
            targets.extend(stance.targets(&places, &rest, &places_now, &turns));
            skeleton.extend(places_now.iter().map(|&place| scale(place, stance.size)));
        }
        let goals = places.iter().zip(&stance.points).map(|(place, &point)| {
            let [rotation, position] = ROLES[place.role].weights;
            Goal::pose(place.link).at(point).weighing(rotation, position)
        });
        let goals = goals.collect();
        let mut start = stance.values;
        let first = targets[0];
        start[..4].copy_from_slice(&first.rotation().to_array());
        start[4..7].copy_from_slice(&first.translation());
        let step = stride as f64 * clip.frame_time;
        Ok(Self { robot, clip, places, goals, targets, skeleton, start, step })
    }

    pub(crate) fn frames(&self) -> usize {
        self.targets.len() / self.goals.len()
    }

    pub(crate) fn text(&self) -> String {
        let mut text = format!(
            "{} on {}: {} frames of {:.1} ms, {} goals, {} rates\n",
            self.clip.title,
            self.robot.name(),
            self.frames(),
            1e3 * self.step,
            self.goals.len(),
            self.robot.mechanism().rates(),
        );
        for (role, known) in ROLES.iter().enumerate() {
            if !self.places.iter().any(|place| place.role == role) {
                text += &format!("  {:<15} not found\n", known.name);
            }
        }
        for place in &self.places {
            text += &format!(
                "  {:<15} {} follows {}\n",
                ROLES[place.role].name,
                self.robot.link_names()[place.link],
                self.clip.joints[place.joint].name,
            );
        }
        text
    }
}

/// The robot as the clip is at rest.
struct Stance {
    values: Vec<f64>,
    /// Of each place: where it is, how its link is turned, and where it is on that.
    at: Vec<Vector>,
    turns: Vec<Quat<f64>>,
    points: Vec<Vector>,
    /// The length of the robot's limbs for one of the clip.
    size: f64,
}

impl Stance {
    /// Limbs in the directions of the clip, and everything else as near to zero as it can be.
    fn new(robot: &Robot, places: &[Place], rest: &[Vector]) -> Result<Self, Box<dyn Error>> {
        let mechanism = robot.mechanism();
        let mut zero: Vec<f64> = robot
            .value_limits()
            .iter()
            .map(|limits| limits.map_or(0.0, |[low, high]| 0.0_f64.clamp(low, high)))
            .collect();
        zero[3] = 1.0;
        let mut poses = vec![DualQuat::IDENTITY; mechanism.links()];
        mechanism.link_poses(&zero, &mut poses)?;
        let own: Vec<_> = places.iter().map(|place| poses[place.centre].translation()).collect();
        let (mut wanted, mut lengths): (Vec<Vector>, _) = (Vec::new(), [0.0; 2]);
        for (index, place) in places.iter().enumerate() {
            let Some(on) = carrier(places, index) else {
                wanted.push(own[index]);
                continue;
            };
            let mut way = sub(own[index], own[on]);
            let bone = sub(rest[place.joint], rest[places[on].joint]);
            if ROLES[place.role].is_limb && norm(bone) > 0.0 {
                lengths = [lengths[0] + norm(way), lengths[1] + norm(bone)];
                way = scale(bone, norm(way) / norm(bone));
            }
            wanted.push(add(wanted[on], way));
        }
        let point = |poses: &[DualQuat<f64>], place: &Place| {
            poses[place.link].conjugate().transform_point(poses[place.centre].translation())
        };
        let goals: Vec<_> = places
            .iter()
            .map(|place| Goal::position(place.link).at(point(&poses, place)))
            .collect();
        let mechanism = dq8_robot::OwnedMechanism::new(robot.joints())?;
        let mut reach = OwnedReach::new(mechanism, goals)?.with_posture(zero.clone())?;
        let targets: Vec<_> =
            wanted.iter().map(|&place| DualQuat::from_translation(place)).collect();
        let options = Options { max_iterations: 200, least_gain: 1e-6, ..Options::track() };
        let options = Tracking { options, posture_weight: 0.05, ..Tracking::default() };
        let mut values = zero;
        reach.track(&targets, &mut values, &options)?;
        robot.mechanism().link_poses(&values, &mut poses)?;
        Ok(Self {
            values,
            at: places.iter().map(|place| poses[place.centre].translation()).collect(),
            turns: places.iter().map(|place| poses[place.link].rotation()).collect(),
            points: places.iter().map(|place| point(&poses, place)).collect(),
            size: if lengths[1] > 0.0 { lengths[0] / lengths[1] } else { 1.0 },
        })
    }

    /// What the robot should do where the clip is so: each part as far from the one that carries it
    /// as on the robot, in the direction that it has in the clip, turned as there.
    fn targets(
        &self,
        places: &[Place],
        rest: &[Vector],
        now: &[Vector],
        turns: &[Quat<f64>],
    ) -> Vec<DualQuat<f64>> {
        let mut targets: Vec<DualQuat<f64>> = Vec::new();
        for (index, place) in places.iter().enumerate() {
            let at = match carrier(places, index) {
                None => scale(now[place.joint], self.size),
                Some(on) => {
                    let from = places[on].joint;
                    let bone = sub(rest[place.joint], rest[from]);
                    let (there, mut turn) = (sub(now[place.joint], now[from]), turns[from]);
                    let mut stretch = 1.0;
                    if norm(bone) > 0.0 && norm(there) > 0.0 {
                        // As the carrier is turned, and then the shortest way to where the bone is.
                        let arc = Quat::from_rotation_arc(unit(turn.rotate(bone)), unit(there));
                        (turn, stretch) = (arc * turn, norm(there) / norm(bone));
                    }
                    let way = turn.rotate(sub(self.at[index], self.at[on]));
                    add(targets[on].translation(), scale(way, stretch))
                }
            };
            let turn = turns[place.joint] * self.turns[index];
            targets.push(DualQuat::from_rotation_translation(turn.normalize(), at));
        }
        targets
    }
}

/// The nearest part that carries one and is known.
pub(crate) fn carrier(places: &[Place], index: usize) -> Option<usize> {
    let mut role = places[index].role;
    while role != 0 {
        role = ROLES[role].on;
        if let Some(on) = places.iter().position(|place| place.role == role) {
            return Some(on);
        }
    }
    None
}

/// From the axes of a clip to those of robots: x forward, y to the left, z up.
fn facing(places: &[Place], rest: &[Vector]) -> Quat<f64> {
    let place = |role: usize| {
        let found = places.iter().find(|place| place.role == role)?;
        Some(rest[found.joint])
    };
    let (mut left, mut up) = ([0.0; 3], [0.0; 3]);
    for role in 3..9 {
        if let (Some(a), Some(b)) = (place(role), place(role + 6)) {
            left = add(left, sub(a, b));
        }
    }
    if let (Some(top), Some(pelvis)) = (place(2).or(place(1)), place(0)) {
        up = sub(top, pelvis);
    }
    // The axis of the file that is nearest to up: spines lean.
    let largest = (0..3).max_by(|&a, &b| up[a].abs().total_cmp(&up[b].abs())).unwrap_or(1);
    up = core::array::from_fn(|axis| if axis == largest { up[axis].signum() } else { 0.0 });
    let left = unit(sub(left, scale(up, dot(left, up))));
    Quat::from_matrix3([cross(left, up), left, up]).normalize()
}

/// The values of the clip at rest: no turns, the root at the origin, and every other joint that has
/// position channels where the first frame has it. Files that give all joints positions repeat the
/// offsets there, which zeros would drop.
fn rest(clip: &Clip) -> Vec<f64> {
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

/// Whether the second frame is ten times as far from the first as from the third.
fn jumps(all: &[DualQuat<f64>], joints: usize) -> bool {
    let mut frames = all.chunks_exact(joints).map(positions);
    let (Some(first), Some(second), Some(third)) = (frames.next(), frames.next(), frames.next())
    else {
        return false;
    };
    let way = |a: &[Vector], b: &[Vector]| -> f64 {
        a.iter().zip(b).map(|(&a, &b)| norm(sub(a, b))).sum()
    };
    way(&first, &second) > 10.0 * way(&second, &third)
}

fn positions(poses: &[DualQuat<f64>]) -> Vec<Vector> {
    poses.iter().map(|pose| pose.translation()).collect()
}

fn unit(a: Vector) -> Vector {
    over_norm(a, norm(a))
}

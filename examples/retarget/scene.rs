//! The clip and the robot in one world: where each part should be in each frame.

use crate::ground;
use crate::map::{Place, ROLES};
use crate::rest::{Rest, positions};
use dq8::scalar::vector::{add, norm, over_norm, scale, sub};
use dq8::{DualQuat, Quat};
use dq8_robot::ik::{Goal, Options, OwnedReach, Tracking};
use dq8_robot::urdf::Robot;
use mocap::clip::Clip;
use std::error::Error;

type Vector = [f64; 3];

pub(crate) struct Scene {
    /// The first joint that moves is the floating one of the base.
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
    /// Sentences about what was found out of the files, and about what had to be assumed.
    pub(crate) told: Vec<String>,
}

/// The wishes of the command line.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wishes<'s> {
    /// Frames per second that are solved.
    pub(crate) fps: f64,
    /// The frame in which the person stands as the robot does at rest.
    pub(crate) rest: Option<usize>,
    /// The height of the robot's ankle above its sole in metres.
    pub(crate) ankle: Option<f64>,
    /// The text of the robot's file, whose collision shapes tell where soles are.
    pub(crate) urdf: &'s str,
}

impl Scene {
    pub(crate) fn new(
        robot: Robot,
        clip: Clip,
        places: Vec<Place>,
        wishes: Wishes<'_>,
    ) -> Result<Self, Box<dyn Error>> {
        let step = 1.0 / wishes.fps;
        let Rest { poses: rest, axes, told } = Rest::of(&clip, &places, wishes.rest)?;
        let back: Vec<_> = rest.iter().map(|pose| pose.rotation().conjugate()).collect();
        let rest: Vec<_> = positions(&rest).into_iter().map(|place| axes.rotate(place)).collect();
        let stance = Stance::new(&robot, &places, &rest)?;

        // Many files begin with the skeleton at rest, and then jump into the motion.
        let first = if jumps(&clip)? { clip.frame_time } else { 0.0 };
        let all = clip.models_every(first, step)?;
        let (mut targets, mut skeleton) = (Vec::new(), Vec::new());
        for poses in all.chunks_exact(clip.joints.len()) {
            let turns: Vec<_> = poses
                .iter()
                .zip(&back)
                .map(|(pose, &back)| axes * (pose.rotation() * back) * axes.conjugate())
                .collect();
            let places_now: Vec<_> =
                poses.iter().map(|pose| axes.rotate(pose.translation())).collect();
            targets.extend(stance.targets(&places, &rest, &places_now, &turns));
            skeleton.extend(places_now.iter().map(|&place| scale(place, stance.size)));
        }
        let mut told: Vec<_> = told.into_iter().collect();
        let ankle = wishes
            .ankle
            .or_else(|| ground::ankle_height(wishes.urdf, &robot, &places, &stance.poses));
        if ankle.is_none() {
            told.push(
                "the file has no box, sphere or cylinder at the feet, so ankles are taken to be 0.05 m above \
                 the soles; --ankle METRES says how high they are"
                    .into(),
            );
        }
        let floor = ground::floor(&places, &targets, step, ankle.unwrap_or(0.05));
        let lower = DualQuat::from_translation([0.0, 0.0, -floor]);
        targets.iter_mut().for_each(|target| *target = lower * *target);
        skeleton.iter_mut().for_each(|place: &mut Vector| place[2] -= floor);
        let goals = places.iter().zip(&stance.points).map(|(place, &point)| {
            let [rotation, position] = ROLES[place.role].weights;
            Goal::pose(place.link).at(point).weighing(rotation, position)
        });
        let goals = goals.collect();
        let mut start = stance.values;
        start[..4].copy_from_slice(&targets[0].rotation().to_array());
        start[4..7].copy_from_slice(&targets[0].translation());
        Ok(Self { robot, clip, places, goals, targets, skeleton, start, step, told })
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
        for sentence in &self.told {
            text += &format!("  {sentence}\n");
        }
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
    /// The poses of all links.
    poses: Vec<DualQuat<f64>>,
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
            poses,
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

/// Whether the second frame is ten times as far from the first as from the third.
fn jumps(clip: &Clip) -> Result<bool, Box<dyn Error>> {
    let first = (3 * clip.channels()).min(clip.values.len());
    let all = Clip { values: clip.values[..first].to_vec(), ..clip.clone() }.models()?;
    let mut frames = all.chunks_exact(clip.joints.len()).map(positions);
    let (Some(first), Some(second), Some(third)) = (frames.next(), frames.next(), frames.next())
    else {
        return Ok(false);
    };
    let way = |a: &[Vector], b: &[Vector]| -> f64 {
        a.iter().zip(b).map(|(&a, &b)| norm(sub(a, b))).sum()
    };
    Ok(way(&first, &second) > 10.0 * way(&second, &third))
}

fn unit(a: Vector) -> Vector {
    over_norm(a, norm(a))
}

//! [`Targets`], the person and the robot in one world: where each part should be in each frame.

use crate::collision::Sole;
use crate::feet::{self, Foot};
use crate::motion::reach;
use crate::rest::Rest;
use crate::role::Role;
use crate::{Humanoid, Person, RetargetError, Settings};
use dq8::scalar::vector::{add, norm, over_norm, scale, sub};
use dq8::{DualQuat, Quat};
use dq8_robot::ik::{Goal, Options, Tracking};

type Vector = [f64; 3];

/// A part that both the person and the robot have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// The role.
    pub role: Role,
    /// The link of the robot.
    pub link: usize,
    /// The link whose origin is the place of the part.
    pub centre: usize,
    /// The joint of the person.
    pub joint: usize,
}

/// The poses that parts of a robot should have in each frame. There is a goal for each place.
#[derive(Clone, Debug)]
pub struct Targets {
    /// The parts that both have.
    pub places: Vec<Place>,
    /// The goals of the search.
    pub goals: Vec<Goal<f64>>,
    /// The target of each goal, `[frame][goal]`.
    pub poses: Vec<DualQuat<f64>>,
    /// The places of the person's joints, in the axes and the size of the robot,
    /// `[frame][joint]`.
    pub skeleton: Vec<Vector>,
    /// The values with which the robot stands as the person does at rest, moved to the first frame.
    pub start: Vec<f64>,
    /// The seconds from frame to frame.
    pub step: f64,
    /// Sentences about what was found in the files, and about what had to be assumed.
    pub told: Vec<String>,
    /// The rotation from the pelvis to the base.
    pub(crate) base: Quat<f64>,
    pub(crate) feet: Vec<Foot>,
}

/// The fewest parts that tell where a body is.
const FEWEST: usize = 6;

/// The weights of rotation and position of feet that are held. With half the weight of rotation,
/// soles slide twice as fast and sink twice as deep, because they turn about the ankle.
const HELD: [f64; 2] = [1.0, 4.0];

/// The height of an ankle above its sole, where the robot's file does not say it. Metres.
const ANKLE: f64 = 0.05;

impl Targets {
    /// Finds the targets of a robot for the motion of a person. Soles that stand are at height
    /// zero, and held on the ground if the settings say so.
    ///
    /// # Errors
    /// If a setting is out of its range, too little is known of the bodies, the person stands in no
    /// frame, or a pose is not finite.
    pub fn new(
        person: &Person,
        humanoid: &Humanoid,
        settings: &Settings,
    ) -> Result<Self, RetargetError> {
        settings.check()?;
        let step = 1.0 / settings.fps;
        let places = places(person, humanoid)?;
        let Rest { poses: rest, axes, told } = Rest::of(person, settings.rest)?;
        let back: Vec<_> = rest.iter().map(|pose| pose.rotation().conjugate()).collect();
        let rest: Vec<_> = rest.iter().map(|pose| axes.rotate(pose.translation())).collect();
        let stance = Stance::new(humanoid, &places, &rest)?;

        let joints = person.joint_names().len();
        let first = if person.jumps()? { person.frame_time() } else { 0.0 };
        let all = person.poses_every(first, step)?;
        let mut poses = Vec::with_capacity(all.len() / joints * places.len());
        let mut skeleton = Vec::with_capacity(all.len());
        let (mut turns, mut now) = (vec![Quat::IDENTITY; joints], vec![[0.0; 3]; joints]);
        for frame in all.chunks_exact(joints) {
            for place in &places {
                let turn = frame[place.joint].rotation() * back[place.joint];
                turns[place.joint] = axes * turn * axes.conjugate();
            }
            for (now, pose) in now.iter_mut().zip(frame) {
                *now = axes.rotate(pose.translation());
            }
            stance.targets(&places, &rest, &now, &turns, &mut poses);
            skeleton.extend(now.iter().map(|&place| scale(place, stance.size)));
        }
        let is_sane = |pose: &DualQuat<f64>| pose.to_array().iter().all(|x| x.abs() < 1e9);
        if let Some(index) = poses.iter().position(|pose| !is_sane(pose)) {
            let (frame, place) = (index / places.len(), places[index % places.len()]);
            let joint = person.joint_names()[place.joint].clone();
            return Err(RetargetError::NotFinite { frame, joint });
        }
        let goals = places.iter().zip(&stance.points).map(|(place, &point)| {
            let [rotation, position] = match place.role.weights() {
                _ if settings.feet && place.role.is_foot() => HELD,
                weights => weights,
            };
            Goal::pose(place.link).at(point).weighing(rotation, position)
        });
        let base = Quat::from_array(core::array::from_fn(|i| stance.values[i]));
        let mut targets = Self {
            goals: goals.collect(),
            places,
            poses,
            skeleton,
            base: stance.turns[0].conjugate() * base,
            start: stance.values.clone(),
            step,
            told: told.into_iter().collect(),
            feet: Vec::new(),
        };
        targets.stand(person, humanoid, settings)?;
        targets.start = targets.start_at(0);
        Ok(targets)
    }

    /// The number of frames.
    #[must_use]
    pub fn frames(&self) -> usize {
        self.poses.len() / self.goals.len()
    }

    /// Returns the corners of the sole of a foot in the frame of the link of that role, in order
    /// around the sole. Returns `None` if the role is not that of a foot, or only one of person and
    /// robot has it.
    #[must_use]
    pub fn sole(&self, role: Role) -> Option<Vec<Vector>> {
        let foot = self.feet.iter().find(|foot| self.places[foot.goal].role == role)?;
        Some(foot.sole.outline(foot.normal))
    }

    /// Finds the feet and when they stand, moves the ground to height zero, and holds the feet.
    fn stand(
        &mut self,
        person: &Person,
        humanoid: &Humanoid,
        settings: &Settings,
    ) -> Result<(), RetargetError> {
        let zero = humanoid.poses(&humanoid.zero())?;
        let mut is_assumed = false;
        for (goal, place) in self.places.iter().enumerate().filter(|(_, p)| p.role.is_foot()) {
            let point = self.goals[goal].point;
            let shaped = humanoid.sole(&zero, place.role).filter(|_| settings.ankle.is_none());
            let sole = shaped.unwrap_or_else(|| {
                is_assumed |= settings.ankle.is_none();
                Sole::below(zero[place.link], point, settings.ankle.unwrap_or(ANKLE))
            });
            let normal = zero[place.link].rotation().conjugate().rotate([0.0, 0.0, 1.0]);
            let mut foot = Foot { goal, point, sole, normal, stands: Vec::new() };
            let joints = feet::joints_of_the_foot(person, place.joint);
            foot.find(&self.skeleton, person.joint_names().len(), &joints, self.step);
            foot.level(&mut self.poses, self.goals.len());
            self.feet.push(foot);
        }
        if is_assumed {
            self.told.push(format!(
                "the file has no box, sphere or cylinder at the feet, so ankles are taken to be {ANKLE} m above \
                 the soles; the setting `ankle` says how high they are"
            ));
        }
        let ground = feet::ground(&self.feet, &self.poses, self.goals.len());
        let lower = DualQuat::from_translation([0.0, 0.0, -ground]);
        self.poses.iter_mut().for_each(|target| *target = lower * *target);
        self.skeleton.iter_mut().for_each(|place| place[2] -= ground);
        if settings.feet {
            let (frames, goals) = (self.frames(), self.goals.len());
            let hold = |foot: &Foot| foot.hold(&mut self.poses, goals, frames);
            let ways: Vec<_> = self.feet.iter().map(hold).collect();
            // A robot of other proportions does not kneel as high over its feet as the person.
            let shifts = feet::shared(&ways, self.step);
            for (poses, &shift) in self.poses.chunks_exact_mut(goals).zip(&shifts) {
                for (pose, place) in poses.iter_mut().zip(&self.places) {
                    if !place.role.is_foot() {
                        *pose = DualQuat::from_translation(shift) * *pose;
                    }
                }
            }
        }
        Ok(())
    }
}

/// Returns the parts that both have.
fn places(person: &Person, humanoid: &Humanoid) -> Result<Vec<Place>, RetargetError> {
    let both = Role::ALL.into_iter().filter_map(|role| {
        let (part, joint) = (humanoid.part(role)?, person.joint(role)?);
        Some(Place { role, link: part.link, centre: part.centre, joint })
    });
    let places: Vec<_> = both.collect();
    let has = |role: Role| person.joint(role).is_some();
    // The way a person faces is told by what is left and what is right.
    let faces = Role::PAIRS.into_iter().any(|pair| pair.into_iter().all(has));
    let upright = has(Role::Head) || has(Role::Chest);
    let pelvis = places.first().is_some_and(|place| place.role == Role::Pelvis);
    if places.len() >= FEWEST && pelvis && faces && upright {
        return Ok(places);
    }
    let missing =
        |known: &dyn Fn(Role) -> bool| Role::ALL.into_iter().filter(|&r| !known(r)).collect();
    Err(RetargetError::TooLittle {
        robot: missing(&|role| humanoid.part(role).is_some()),
        person: missing(&has),
        links: humanoid.robot().link_names().to_vec(),
        joints: person.joint_names().to_vec(),
    })
}

/// The robot as the person is at rest.
struct Stance {
    values: Vec<f64>,
    /// Of each place: where it is, how its link is turned, and the point of the link at its centre.
    at: Vec<Vector>,
    turns: Vec<Quat<f64>>,
    points: Vec<Vector>,
    /// The length of the robot's limbs for one of the person.
    size: f64,
    /// The place that carries each place.
    carriers: Vec<Option<usize>>,
}

impl Stance {
    /// Puts limbs in the directions of the person, and everything else as near to zero as it can
    /// be.
    fn new(humanoid: &Humanoid, places: &[Place], rest: &[Vector]) -> Result<Self, RetargetError> {
        let zero = humanoid.zero();
        let poses = humanoid.poses(&zero)?;
        let own: Vec<_> = places.iter().map(|place| poses[place.centre].translation()).collect();
        let carriers: Vec<_> = (0..places.len()).map(|index| carrier(places, index)).collect();
        let (mut wanted, mut lengths): (Vec<Vector>, _) = (Vec::new(), [0.0; 2]);
        for (index, place) in places.iter().enumerate() {
            let Some(on) = carriers[index] else {
                wanted.push(own[index]);
                continue;
            };
            let mut way = sub(own[index], own[on]);
            let bone = sub(rest[place.joint], rest[places[on].joint]);
            if place.role.is_limb() && norm(bone) > 0.0 {
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
        let targets: Vec<_> =
            wanted.iter().map(|&place| DualQuat::from_translation(place)).collect();
        let options = Options { max_iterations: 200, least_gain: 1e-6, ..Options::track() };
        let options = Tracking { options, posture_weight: 0.05, ..Tracking::default() };
        let values = reach(humanoid, &goals, &targets, &zero, &zero, &options)?;
        let poses = humanoid.poses(&values)?;
        Ok(Self {
            values,
            at: places.iter().map(|place| poses[place.centre].translation()).collect(),
            turns: places.iter().map(|place| poses[place.link].rotation()).collect(),
            points: places.iter().map(|place| point(&poses, place)).collect(),
            size: if lengths[1] > 0.0 { lengths[0] / lengths[1] } else { 1.0 },
            carriers,
        })
    }

    /// Appends the targets of a frame: each part as far from the one that carries it as on the
    /// robot, in the direction that it has on the person, and turned as there.
    fn targets(
        &self,
        places: &[Place],
        rest: &[Vector],
        now: &[Vector],
        turns: &[Quat<f64>],
        targets: &mut Vec<DualQuat<f64>>,
    ) {
        let first = targets.len();
        for (index, place) in places.iter().enumerate() {
            let at = match self.carriers[index] {
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
                    add(targets[first + on].translation(), scale(way, stretch))
                }
            };
            let turn = turns[place.joint] * self.turns[index];
            targets.push(DualQuat::from_rotation_translation(turn.normalize(), at));
        }
    }
}

/// Returns the nearest part that carries a part and is known.
fn carrier(places: &[Place], index: usize) -> Option<usize> {
    let mut role = places[index].role;
    while let Some(on) = role.carrier() {
        role = on;
        if let Some(on) = places.iter().position(|place| place.role == role) {
            return Some(on);
        }
    }
    None
}

fn unit(a: Vector) -> Vector {
    over_norm(a, norm(a))
}

//! How well a motion follows its targets, and how smoothly.

use crate::map::ROLES;
use crate::scene::Scene;
use dq8::DualQuat;
use dq8::scalar::vector::{norm, sub};
use std::error::Error;

pub(crate) struct Quality {
    /// Distances from the targets, of all goals and of the feet: mean, and the one that a twentieth
    /// exceeds, mm.
    pub(crate) mean: f64,
    pub(crate) most: f64,
    pub(crate) feet: f64,
    /// Of joints: the speed that a twentieth exceeds, rad/s, and the mean third derivative,
    /// rad/s³.
    pub(crate) speed: f64,
    pub(crate) jerk: f64,
    /// The percentage of the values of joints that carry a goal that are at a limit, and the
    /// largest distance of any value beyond its limits.
    pub(crate) at_limits: f64,
    pub(crate) beyond: f64,
}

impl Quality {
    pub(crate) fn of(scene: &Scene, motion: &[f64]) -> Result<Self, Box<dyn Error>> {
        let mechanism = scene.robot.mechanism();
        let count = mechanism.values();
        let (mut apart, mut feet) = (Vec::new(), Vec::new());
        let mut poses = vec![DualQuat::IDENTITY; mechanism.links()];
        for (values, targets) in
            motion.chunks_exact(count).zip(scene.targets.chunks_exact(scene.goals.len()))
        {
            mechanism.link_poses(values, &mut poses)?;
            for ((goal, target), place) in scene.goals.iter().zip(targets).zip(&scene.places) {
                let point = poses[goal.link].transform_point(goal.point);
                apart.push(1e3 * norm(sub(point, target.translation())));
                if ROLES[place.role].name.ends_with("foot") {
                    feet.extend(apart.last());
                }
            }
        }
        let limits = scene.robot.value_limits();
        let (mut touched, mut hinges, mut beyond) = (0.0, 0.0_f64, 0.0_f64);
        let (mut speeds, mut jerks) = (Vec::new(), Vec::new());
        let carries = carries(scene);
        for (value, limits) in limits.iter().enumerate() {
            let Some([low, high]) = *limits else { continue };
            let course: Vec<f64> = motion.iter().skip(value).step_by(count).copied().collect();
            for angle in &course {
                // What single floats round an end to is at it as well.
                let end = 1e-6 * (1.0 + angle.abs());
                let touches = *angle <= low + end || *angle >= high - end;
                beyond = beyond.max(low - angle).max(angle - high);
                if carries[value] {
                    touched += f64::from(u8::from(touches));
                    hinges += 1.0;
                }
            }
            speeds.extend(course.windows(2).map(|w| (w[1] - w[0]).abs() / scene.step));
            let third = |w: &[f64]| (w[3] - 3.0 * w[2] + 3.0 * w[1] - w[0]).abs();
            jerks.extend(course.windows(4).map(|w| third(w) / scene.step.powi(3)));
        }
        Ok(Self {
            mean: mean(&apart),
            most: high(&mut apart),
            feet: mean(&feet),
            speed: high(&mut speeds),
            jerk: mean(&jerks),
            at_limits: 100.0 * touched / hinges.max(1.0),
            beyond,
        })
    }
}

impl Quality {
    /// Sentences about figures that a good motion does not have.
    pub(crate) fn warnings(&self) -> Vec<String> {
        let mut warnings = Vec::new();
        if self.mean > 50.0 {
            warnings.push(format!(
                "links are {:.0} mm from their targets in the mean: look at the list above for links and joints that do not \
                 belong together, and at --map and --rest",
                self.mean
            ));
        }
        if self.at_limits > 10.0 {
            warnings.push(format!(
                "{:.0} % of the values are at a limit: the robot cannot do this motion, or its rest pose is not the clip's \
                 (--rest)",
                self.at_limits
            ));
        }
        warnings
    }
}

/// For each value, `true` if its joint carries a link that has a goal. Fingers do not, and rest.
fn carries(scene: &Scene) -> Vec<bool> {
    let joints = scene.robot.joints();
    let mut carry = vec![false; joints.len()];
    for goal in &scene.goals {
        let mut link = Some(goal.link);
        while let Some(joint) = link {
            carry[joint] = true;
            link = joints[joint].parent;
        }
    }
    let mut values = Vec::new();
    for (joint, &carries) in joints.iter().zip(&carry) {
        let own = if joint.mimic.is_some() { 0 } else { joint.kind.values() };
        values.extend(core::iter::repeat_n(carries, own));
    }
    values
}

fn mean(numbers: &[f64]) -> f64 {
    numbers.iter().sum::<f64>() / numbers.len().max(1) as f64
}

/// What a twentieth exceeds.
fn high(numbers: &mut [f64]) -> f64 {
    numbers.sort_by(f64::total_cmp);
    numbers.get(numbers.len() * 19 / 20).copied().unwrap_or(0.0)
}

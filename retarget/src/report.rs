//! [`Report`]: how well a motion follows its targets, and whether a robot can learn from it.

use crate::collide::Bodies;
use crate::collision::KnownShapes;
use crate::motion::BASE;
use crate::{Humanoid, RetargetError, Targets};
use dq8::DualQuat;
use dq8::scalar::vector::{norm, sub};
use dq8::storage::same_length;
use std::fmt;

/// An overlap that is deeper than this is a hit. Metres.
const HIT: f32 = 0.01;

/// The measures of a motion. Distances are in millimetres, and percentages are of frames or values.
/// It is displayed as one line for each measure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Report {
    /// The mean distance of all goals from their targets.
    pub residual: f64,
    /// The distance that a twentieth of them exceed.
    pub residual_high: f64,
    /// The mean distance of the feet from their targets.
    pub feet: f64,
    /// The mean speed of soles while the person's feet stand, mm/s.
    pub slide: f64,
    /// The median height of standing soles above the height zero.
    pub ground: f64,
    /// The standard deviation of that height.
    pub unevenness: f64,
    /// The depth of the lowest sole below the height of standing soles.
    pub sink: f64,
    /// The percentage of frames in which a sole is more than a centimetre under that height.
    pub sunk: f64,
    /// `false` if no edges of a sole are known, but one point: edges may sink deeper than it does.
    pub edges: bool,
    /// The speed of joints that a twentieth of them exceed, rad/s.
    pub speed: f64,
    /// The greatest speed of a joint, rad/s.
    pub speed_most: f64,
    /// The mean third derivative of joints, rad/s³.
    pub jerk: f64,
    /// The percentage of values at a limit, of joints that carry a goal.
    pub at_limits: f64,
    /// The largest distance of a value beyond its limits, rad.
    pub beyond: f64,
    /// The percentage of frames in which the robot is more than a centimetre deep in itself. It is
    /// `None` where that is not known: a shape is a mesh, or there are no shapes that could meet.
    pub self_hits: Option<f64>,
    /// The number of links with shapes, and of those whose shapes are not all known.
    pub shapes: KnownShapes,
}

impl Report {
    /// Measures a motion, `[frame][value]`.
    ///
    /// # Errors
    /// If the motion does not have as many frames as the targets.
    pub fn of(
        targets: &Targets,
        humanoid: &Humanoid,
        motion: &[f64],
    ) -> Result<Self, RetargetError> {
        let robot = humanoid.robot();
        let goals = targets.goals.len();
        let count = robot.mechanism().values();
        same_length("motion", motion.len(), targets.frames() * count)?;
        // `[frame][goal]`, of the links that have goals.
        let mut poses = vec![DualQuat::IDENTITY; targets.poses.len()];
        let links: Vec<_> = targets.goals.iter().map(|goal| goal.link).collect();
        robot.mechanism().job().links(&links).poses(motion, &mut poses)?;

        let (mut apart, mut feet) = (Vec::with_capacity(poses.len()), Vec::new());
        for (poses, wanted) in poses.chunks_exact(goals).zip(targets.poses.chunks_exact(goals)) {
            for (index, (pose, target)) in poses.iter().zip(wanted).enumerate() {
                let (goal, place) = (&targets.goals[index], &targets.places[index]);
                let point = pose.transform_point(goal.point);
                apart.push(1e3 * norm(sub(point, target.translation())));
                if place.role.is_foot() {
                    feet.extend(apart.last());
                }
            }
        }
        let soles = Soles::of(targets, &poses);
        let joints = Joints::of(targets, humanoid, motion, count);
        let shapes = humanoid.known_shapes();
        Ok(Self {
            residual: mean(&apart),
            residual_high: high(&mut apart),
            feet: mean(&feet),
            slide: soles.slide,
            ground: soles.ground,
            unevenness: soles.unevenness,
            sink: soles.sink,
            sunk: soles.sunk,
            edges: targets.feet.iter().all(|foot| !foot.sole.is_point()),
            speed: joints.speed,
            speed_most: joints.speed_most,
            jerk: joints.jerk,
            at_limits: joints.at_limits,
            beyond: joints.beyond,
            self_hits: self_hits(targets, humanoid, motion, shapes)?,
            shapes,
        })
    }

    /// The names of the [`measures`](Self::measures), which are those of the fields.
    pub const MEASURES: [&'static str; 14] = [
        "residual",
        "residual_high",
        "feet",
        "slide",
        "ground",
        "unevenness",
        "sink",
        "sunk",
        "speed",
        "speed_most",
        "jerk",
        "at_limits",
        "beyond",
        "self_hits",
    ];

    /// Returns the measures in the order of their names. `None` is a measure that is not known.
    #[must_use]
    pub fn measures(&self) -> [Option<f64>; 14] {
        [
            Some(self.residual),
            Some(self.residual_high),
            Some(self.feet),
            Some(self.slide),
            Some(self.ground),
            Some(self.unevenness),
            Some(self.sink),
            Some(self.sunk),
            Some(self.speed),
            Some(self.speed_most),
            Some(self.jerk),
            Some(self.at_limits),
            Some(self.beyond),
            self.self_hits,
        ]
    }

    /// Returns sentences about measures that a good motion does not have.
    #[must_use]
    pub fn warnings(&self) -> Vec<String> {
        let mut warnings = Vec::new();
        if self.residual > 50.0 {
            warnings.push(format!(
                "links are {:.0} mm from their targets in the mean: look at the list above for links and joints that do not \
                 belong together, and at the frame of the rest pose",
                self.residual
            ));
        }
        if self.at_limits > 10.0 {
            warnings.push(format!(
                "{:.0} % of the values are at a limit: the robot cannot do this motion, or its rest pose is not the clip's",
                self.at_limits
            ));
        }
        warnings
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut row = |name: &str, text: String| writeln!(f, "  {name:<28} {text}");
        row(
            "residual, mm",
            format!("{:.1} (a twentieth above {:.1})", self.residual, self.residual_high),
        )?;
        row("residual of feet, mm", format!("{:.1}", self.feet))?;
        row("slide of feet, mm/s", format!("{:.0}", self.slide))?;
        row("ground, mm", format!("{:.1} ± {:.1}", self.ground, self.unevenness))?;
        let edges = if self.edges { "" } else { ", of one point: edges are not known" };
        row(
            "sink, mm",
            format!("{:.1} ({:.1} % of frames above 10){edges}", self.sink, self.sunk),
        )?;
        row(
            "speed, rad/s",
            format!("{:.1} (a twentieth above {:.1})", self.speed_most, self.speed),
        )?;
        row("jerk, rad/s³", format!("{:.0}", self.jerk))?;
        row("at limits, %", format!("{:.1}", self.at_limits))?;
        row("beyond limits, rad", format!("{:.1e}", self.beyond))?;
        let KnownShapes { links, unread } = self.shapes;
        let hits = match self.self_hits {
            Some(hits) => format!("{hits:.1} ({links} links have shapes)"),
            None if unread > 0 => {
                format!("not known: {unread} of {links} links have meshes as shapes")
            }
            None => "not known: there are no shapes that could meet".into(),
        };
        row("self-hits, % of frames", hits)
    }
}

/// Returns the percentage of frames in which shapes meet, if all shapes are known.
fn self_hits(
    targets: &Targets,
    humanoid: &Humanoid,
    motion: &[f64],
    shapes: KnownShapes,
) -> Result<Option<f64>, RetargetError> {
    // Shapes that were read may meet seldom, and those that were not may meet in every frame.
    if shapes.unread > 0 {
        return Ok(None);
    }
    let bodies = Bodies::new(humanoid, targets)?;
    if bodies.is_empty() {
        return Ok(None);
    }
    let mut hits = vec![false; targets.frames()];
    let values: Vec<f32> = motion.iter().map(|&value| value as f32).collect();
    bodies.meetings(&values, HIT, |meeting| hits[meeting.frame] = true)?;
    Ok(Some(percentage(&hits)))
}

/// The measures of the soles.
struct Soles {
    slide: f64,
    ground: f64,
    unevenness: f64,
    sink: f64,
    sunk: f64,
}

impl Soles {
    fn of(targets: &Targets, poses: &[DualQuat<f64>]) -> Self {
        let (mut standing, mut all, mut ways) = (Vec::new(), Vec::new(), Vec::new());
        for foot in &targets.feet {
            let pose = |frame: usize| poses[frame * targets.goals.len() + foot.goal];
            for frame in 0..targets.frames() {
                all.push((frame, 1e3 * foot.sole.lowest(pose(frame))));
            }
            for run in &foot.stands {
                standing.extend(run.clone().map(|frame| 1e3 * foot.sole.lowest(pose(frame))));
                for frame in run.start + 1..run.end {
                    let middle = |frame: usize| foot.sole.middle(pose(frame));
                    ways.push(1e3 * norm(sub(middle(frame), middle(frame - 1))) / targets.step);
                }
            }
        }
        let mut sorted = standing.clone();
        sorted.sort_by(f64::total_cmp);
        let ground = sorted.get(sorted.len() / 2).copied().unwrap_or(0.0);
        let mid = mean(&standing);
        let squares: Vec<_> = standing.iter().map(|height| (height - mid).powi(2)).collect();
        let mut sunk = vec![false; targets.frames()];
        for &(frame, height) in &all {
            sunk[frame] |= height < ground - 10.0;
        }
        let lowest = all.iter().map(|(_, height)| *height).fold(ground, f64::min);
        Self {
            slide: mean(&ways),
            ground,
            unevenness: mean(&squares).sqrt(),
            sink: ground - lowest,
            sunk: percentage(&sunk),
        }
    }
}

/// The measures of the joints.
struct Joints {
    speed: f64,
    speed_most: f64,
    jerk: f64,
    at_limits: f64,
    beyond: f64,
}

impl Joints {
    fn of(targets: &Targets, humanoid: &Humanoid, motion: &[f64], count: usize) -> Self {
        let limits = humanoid.robot().value_limits();
        let (mut touched, mut beyond) = (Vec::new(), 0.0_f64);
        let (mut speeds, mut jerks) = (Vec::new(), Vec::new());
        let carries = carries(targets, humanoid);
        for (value, limits) in limits.iter().enumerate().skip(BASE) {
            let course: Vec<f64> = motion.iter().skip(value).step_by(count).copied().collect();
            if let Some([low, high]) = *limits {
                for angle in &course {
                    // A value that single precision rounds to an end is at it as well.
                    let end = 1e-6 * (1.0 + angle.abs());
                    beyond = beyond.max(low - angle).max(angle - high);
                    if carries[value] {
                        touched.push(*angle <= low + end || *angle >= high - end);
                    }
                }
            }
            speeds.extend(course.windows(2).map(|w| (w[1] - w[0]).abs() / targets.step));
            let third = |w: &[f64]| (w[3] - 3.0 * w[2] + 3.0 * w[1] - w[0]).abs();
            jerks.extend(course.windows(4).map(|w| third(w) / targets.step.powi(3)));
        }
        Self {
            speed_most: speeds.iter().copied().fold(0.0, f64::max),
            speed: high(&mut speeds),
            jerk: mean(&jerks),
            at_limits: percentage(&touched),
            beyond,
        }
    }
}

/// Returns, for each value, `true` if its joint carries a link that has a goal. Fingers do not, and
/// rest.
fn carries(targets: &Targets, humanoid: &Humanoid) -> Vec<bool> {
    let joints = humanoid.robot().joints();
    let mut carry = vec![false; joints.len()];
    for goal in &targets.goals {
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

fn percentage(flags: &[bool]) -> f64 {
    100.0 * flags.iter().filter(|&&flag| flag).count() as f64 / flags.len().max(1) as f64
}

fn mean(numbers: &[f64]) -> f64 {
    // The sum of no numbers is −0, which would be shown.
    (0.0 + numbers.iter().sum::<f64>()) / numbers.len().max(1) as f64
}

/// Returns the number that a twentieth exceed.
fn high(numbers: &mut [f64]) -> f64 {
    let place = numbers.len() * 19 / 20;
    if numbers.is_empty() {
        return 0.0;
    }
    *numbers.select_nth_unstable_by(place, f64::total_cmp).1
}

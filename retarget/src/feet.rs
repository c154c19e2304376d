//! [`Foot`]: when feet stand, the height of the ground under them, and targets that hold them.

use crate::Person;
use crate::collision::Sole;
use crate::smooth::{SLOWEST, lambda, smooth};
use dq8::scalar::vector::{add, dot, norm, over_norm, scale, sub};
use dq8::{DualQuat, Quat};
use std::ops::Range;

type Vector = [f64; 3];

/// A joint of a foot that is slower than this stands, if it is also low. Metres per second.
const SLOW: f64 = 0.2;

/// A joint of a foot that is at most so far above its lowest twentieth is low. Metres.
const LOW: f64 = 0.04;

/// A foot that stands for a shorter time does not stand. Seconds.
const SHORTEST: f64 = 0.1;

/// A joint of a foot that stands is at most so far from its median place, or the foot has wandered:
/// slowly enough to seem to stand, as from standing to kneeling. Metres.
const FAR: f64 = 0.05;

/// The time for which a foot that has wandered does not stand. Seconds.
const LET_GO: f64 = 0.4;

/// The body follows the ways of held feet with at most this frequency. Hz.
const SHARED: f64 = 1.0;

/// The cosine of an eighth of a round.
const FLAT: f64 = core::f64::consts::FRAC_1_SQRT_2;

/// A foot of the robot.
#[derive(Clone, Debug)]
pub(crate) struct Foot {
    /// The goal of the foot.
    pub(crate) goal: usize,
    /// The point of the goal in the frame of the foot's link.
    pub(crate) point: Vector,
    pub(crate) sole: Sole,
    /// The direction of the foot's link that points up while the sole is flat.
    pub(crate) normal: Vector,
    /// The runs of frames in which the person's foot stands.
    pub(crate) stands: Vec<Range<usize>>,
}

/// The change of a target that holds a foot in a frame: a turn, and a way.
#[derive(Clone, Copy)]
struct Held {
    frame: usize,
    turn: Quat<f64>,
    way: Vector,
}

/// Returns the joint of the ankle and those that it carries directly, without tips: heel and toe
/// stand, too, where a whole foot stands.
pub(crate) fn joints_of_the_foot(person: &Person, ankle: usize) -> Vec<usize> {
    let parents = person.parents();
    let has_child = |joint: usize| parents.contains(&Some(joint));
    let toes = (0..parents.len()).filter(|&j| parents[j] == Some(ankle) && has_child(j));
    std::iter::once(ankle).chain(toes).collect()
}

impl Foot {
    /// Finds when the foot stands: all of its joints are slow and low. `skeleton` is
    /// `[frame][joint]`, in the size of the robot; `step` is the time of a frame.
    pub(crate) fn find(&mut self, skeleton: &[Vector], count: usize, joints: &[usize], step: f64) {
        let frames = skeleton.len() / count;
        let mut stands = vec![frames > 1; frames];
        let course = |&joint: &usize| -> Vec<Vector> {
            skeleton.iter().skip(joint).step_by(count).copied().collect()
        };
        let courses: Vec<_> = joints.iter().map(course).collect();
        for course in &courses {
            let mut heights: Vec<_> = course.iter().map(|place| place[2]).collect();
            heights.sort_by(f64::total_cmp);
            let Some(lowest) = heights.get(heights.len() / 20) else { continue };
            for (frame, stands) in stands.iter_mut().enumerate() {
                let (before, after) = (frame.saturating_sub(1), (frame + 1).min(frames - 1));
                let way = norm(sub(course[after], course[before]));
                let is_slow = way < SLOW * step * (after - before) as f64;
                *stands &= is_slow && course[frame][2] < lowest + LOW;
            }
        }
        let least = (SHORTEST / step).max(2.0) as usize;
        let mut first = 0;
        self.stands.clear();
        for frame in 0..=frames {
            if !stands.get(frame).copied().unwrap_or(false) {
                if frame - first >= least {
                    let let_go = (LET_GO / step).ceil() as usize;
                    self.stands.extend(staying(first..frame, &courses, least, let_go));
                }
                first = frame + 1;
            }
        }
    }

    /// Returns `true` if the foot stands in a frame.
    pub(crate) fn stands_in(&self, frame: usize) -> bool {
        // The runs are in the order of time.
        let next = self.stands.partition_point(|run| run.end <= frame);
        self.stands.get(next).is_some_and(|run| run.contains(&frame))
    }

    /// Turns the targets of the foot about its goal so that the sole is flat in the mean of all
    /// frames in which it stands. In the rest pose the person's foot may not be flat, and the
    /// robot's foot is not turned as it is there.
    pub(crate) fn level(&self, targets: &mut [DualQuat<f64>], goals: usize) {
        let standing = self.stands.iter().cloned().flatten();
        let up = standing.fold([0.0; 3], |sum, frame| {
            let turned = targets[frame * goals + self.goal].rotation();
            add(sum, turned.conjugate().rotate([0.0, 0.0, 1.0]))
        });
        // A foot that is turned by more than an eighth of a round stands in another way.
        if dot(up, self.normal) <= FLAT * norm(up) {
            return;
        }
        let turn = Quat::from_rotation_arc(self.normal, over_norm(up, norm(up)));
        for target in targets.iter_mut().skip(self.goal).step_by(goals) {
            let rotation = (target.rotation() * turn).normalize();
            *target = DualQuat::from_rotation_translation(rotation, target.translation());
        }
    }

    /// Returns the pose of the link if the goal has this target.
    fn link(&self, target: DualQuat<f64>) -> DualQuat<f64> {
        target * DualQuat::from_translation(scale(self.point, -1.0))
    }

    fn lowest(&self, target: DualQuat<f64>) -> f64 {
        self.sole.lowest(self.link(target))
    }

    /// Changes the targets so that the foot is flat on the ground and does not move while it
    /// stands, and is nowhere under the ground. In the air, the changes before and after are
    /// shared out. Returns the way of each frame.
    pub(crate) fn hold(
        &self,
        targets: &mut [DualQuat<f64>],
        goals: usize,
        frames: usize,
    ) -> Vec<Vector> {
        let at = |frame: usize| frame * goals + self.goal;
        let mut held: Vec<Held> = Vec::new();
        for run in &self.stands {
            let target = self.standing(targets, run.clone(), at);
            for frame in run.clone() {
                let old = targets[at(frame)];
                let turn = target.rotation() * old.rotation().conjugate();
                let way = sub(target.translation(), old.translation());
                held.push(Held { frame, turn, way });
            }
        }
        let (mut next, mut ways) = (0, Vec::new());
        for frame in 0..frames {
            while held.get(next).is_some_and(|held| held.frame < frame) {
                next += 1;
            }
            let old = targets[at(frame)];
            let (mut turn, mut place) = (old.rotation(), old.translation());
            if let (Some(before), Some(after)) =
                (held.get(next.saturating_sub(1)), held.get(next).or(held.last()))
            {
                let span = after.frame.saturating_sub(before.frame).max(1) as f64;
                let share = (frame.saturating_sub(before.frame) as f64 / span).min(1.0);
                let share = share * share * (3.0 - 2.0 * share);
                turn = (before.turn.nlerp(after.turn, share) * turn).normalize();
                place = add(place, add(scale(before.way, 1.0 - share), scale(after.way, share)));
            }
            let depth = -self.lowest(DualQuat::from_rotation_translation(turn, place));
            place[2] += depth.max(0.0);
            targets[at(frame)] = DualQuat::from_rotation_translation(turn, place);
            ways.push(sub(place, old.translation()));
        }
        ways
    }

    /// Returns the target of the foot in a run of frames in which it stands: flat on the ground, in
    /// the median place.
    fn standing(
        &self,
        targets: &[DualQuat<f64>],
        run: Range<usize>,
        at: impl Fn(usize) -> usize,
    ) -> DualQuat<f64> {
        let first = targets[at(run.start)].rotation();
        let mut sum = [0.0; 4];
        for frame in run.clone() {
            let turn = targets[at(frame)].rotation();
            let sign = if turn.dot(first) < 0.0 { -1.0 } else { 1.0 };
            let turn = turn.to_array();
            sum = core::array::from_fn(|i| sum[i] + sign * turn[i]);
        }
        let mean = Quat::from_array(sum).normalize();
        let flat = Quat::from_rotation_arc(mean.rotate(self.normal), [0.0, 0.0, 1.0]) * mean;
        let median = |axis: usize| {
            let course = run.clone().map(|frame| targets[at(frame)].translation()[axis]);
            middle(course.collect())
        };
        let (x, y) = (median(0), median(1));
        let depth = self.lowest(DualQuat::from_rotation(flat));
        DualQuat::from_rotation_translation(flat, [x, y, -depth])
    }
}

/// Returns the parts of a run of frames in which joints stay where they are. Where they have
/// wandered, `let_go` frames are left out about the middle of their way.
fn staying(
    run: Range<usize>,
    courses: &[Vec<Vector>],
    least: usize,
    let_go: usize,
) -> Vec<Range<usize>> {
    let (mut parts, mut open) = (Vec::new(), vec![run]);
    while let Some(run) = open.pop() {
        let wandered = courses.iter().find(|course| {
            let course = &course[run.clone()];
            let median = |axis: usize| middle(course.iter().map(|place| place[axis]).collect());
            let median = [median(0), median(1), median(2)];
            course.iter().any(|&place| norm(sub(place, median)) > FAR)
        });
        let Some(course) = wandered else {
            parts.push(run);
            continue;
        };
        let span = let_go.min(run.len());
        let way = |&first: &usize| norm(sub(course[first + span - 1], course[first]));
        let starts = run.start..=run.end - span;
        let first = starts.max_by(|a, b| way(a).total_cmp(&way(b))).unwrap_or(run.start);
        // The later part is taken up last, so that parts are in the order of time.
        for part in [first + span..run.end, run.start..first] {
            if part.len() >= least {
                open.push(part);
            }
        }
    }
    parts
}

/// Returns the way of the whole body in each frame: the mean of the ways by which held feet were
/// moved, `[foot][frame]`, without what changes with every stride.
pub(crate) fn shared(ways: &[Vec<Vector>], step: f64) -> Vec<Vector> {
    let frames = ways.iter().map(Vec::len).min().unwrap_or(0);
    let mean = |frame: usize| {
        let sum = ways.iter().fold([0.0; 3], |sum, ways| add(sum, ways[frame]));
        scale(sum, 1.0 / ways.len() as f64).map(|part| part as f32)
    };
    let mut shared: Vec<[f32; 3]> = (0..frames).map(mean).collect();
    let frequency = SHARED.max(SLOWEST / step);
    smooth(shared.as_flattened_mut(), 3, lambda(frequency, step));
    shared.into_iter().map(|way| way.map(f64::from)).collect()
}

/// Returns the height of the ground under the targets: the median height of soles that stand, or,
/// if none stands, the lowest height of a sole.
pub(crate) fn ground(feet: &[Foot], targets: &[DualQuat<f64>], goals: usize) -> f64 {
    let heights = |foot: &Foot, frame: usize| foot.lowest(targets[frame * goals + foot.goal]);
    let standing = feet.iter().flat_map(|foot| {
        foot.stands.iter().cloned().flatten().map(move |frame| heights(foot, frame))
    });
    let standing: Vec<_> = standing.collect();
    if !standing.is_empty() {
        return middle(standing);
    }
    let frames = targets.len() / goals;
    let all = feet.iter().flat_map(|foot| (0..frames).map(move |frame| heights(foot, frame)));
    all.reduce(f64::min).unwrap_or(0.0)
}

fn middle(mut numbers: Vec<f64>) -> f64 {
    numbers.sort_by(f64::total_cmp);
    numbers.get(numbers.len() / 2).copied().unwrap_or(0.0)
}

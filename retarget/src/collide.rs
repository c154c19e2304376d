//! [`Balls`]: where a robot meets itself, and how its targets must move so that it does not.

use crate::collision::Ball;
use crate::smooth::{lambda, smooth};
use crate::{Humanoid, RetargetError, Targets};
use dq8::DualQuat;
use dq8::scalar::vector::{norm, scale, sub};
use dq8_robot::OwnedMechanism;

type Vector = [f64; 3];

/// Balls that overlap by more than this are pushed apart. Metres.
const DEEP: f32 = 0.005;

/// Overlaps are pushed apart by this times their depth, because the search follows a push in part.
const EAGER: f64 = 1.3;

/// Pushes change with at most this frequency. Hz.
const FREQUENCY: f64 = 5.0;

/// The balls of a robot, and the pairs of them that should not overlap.
#[derive(Clone, Debug)]
pub(crate) struct Balls {
    points: Vec<(usize, [f32; 3])>,
    /// Two balls, and the sum of their radii.
    pairs: Vec<(usize, usize, f32)>,
    /// The goals that move each ball.
    movers: Vec<Vec<usize>>,
    /// The largest distance of centres at which a pair of any size overlaps.
    widest: f32,
}

impl Balls {
    /// Takes the balls from the shapes of the robot. Pairs on links that are at most three joints
    /// apart, or that overlap while the robot stands, do not count: shapes are fatter than bodies.
    pub(crate) fn new(humanoid: &Humanoid, targets: &Targets) -> Result<Self, RetargetError> {
        let balls: Vec<Ball> =
            humanoid.collisions().iter().flat_map(|shape| shape.balls()).collect();
        let stands = [humanoid.zero(), targets.start.clone()];
        let stands = stands.iter().map(|values| humanoid.poses(values));
        let stands = stands.collect::<Result<Vec<_>, _>>()?;
        let paths: Vec<Vec<usize>> = balls.iter().map(|ball| path(humanoid, ball.link)).collect();
        let mut pairs = Vec::new();
        for (a, ball) in balls.iter().enumerate() {
            for (b, other) in balls.iter().enumerate().skip(a + 1) {
                let same = paths[a].iter().zip(&paths[b]).take_while(|(a, b)| a == b).count();
                let joints = paths[a].len() + paths[b].len() - 2 * same;
                let reach = ball.radius + other.radius;
                let overlaps = |poses: &Vec<DualQuat<f64>>| {
                    let at = |ball: &Ball| poses[ball.link].transform_point(ball.centre);
                    norm(sub(at(ball), at(other))) < reach
                };
                if joints > 3 && !stands.iter().any(overlaps) {
                    pairs.push((a, b, reach as f32));
                }
            }
        }
        let movers = balls.iter().map(|ball| movers(humanoid, targets, ball.link)).collect();
        let points = balls.iter().map(|ball| (ball.link, ball.centre.map(|x| x as f32))).collect();
        let widest = pairs.iter().map(|pair| pair.2).fold(0.0, f32::max);
        Ok(Self { points, pairs, movers, widest })
    }

    /// Returns `true` if there is no pair to look at.
    pub(crate) fn is_empty(&self) -> bool {
        self.pairs.is_empty()
    }

    /// Calls `found` with the frame, the pair, its depth, and the unit vector from its second ball
    /// to its first one, for each pair that overlaps by more than `least`.
    pub(crate) fn overlaps(
        &self,
        mechanism: &OwnedMechanism<f32>,
        values: &[f32],
        least: f32,
        mut found: impl FnMut(usize, (usize, usize), f32, Vector),
    ) -> Result<(), RetargetError> {
        let count = mechanism.view().values();
        let mut places = vec![[0.0_f32; 3]; values.len() / count * self.points.len()];
        mechanism.job().points(&self.points, values, &mut places)?;
        for (frame, places) in places.chunks_exact(self.points.len()).enumerate() {
            for &(a, b, reach) in &self.pairs {
                let [x, y, z]: [f32; 3] = core::array::from_fn(|i| places[a][i] - places[b][i]);
                let square = x * x + y * y + z * z;
                if square < self.widest * self.widest && square < (reach - least) * (reach - least)
                {
                    let distance = square.sqrt();
                    let way = [x, y, z].map(|part| f64::from(part / distance.max(1e-6)));
                    found(frame, (a, b), reach - distance, way);
                }
            }
        }
        Ok(())
    }

    /// Moves targets apart where the robot meets itself. Returns `true` if it does anywhere. Feet
    /// that stand are not pushed.
    pub(crate) fn push(
        &self,
        mechanism: &OwnedMechanism<f32>,
        values: &[f32],
        targets: &Targets,
        poses: &mut [DualQuat<f32>],
    ) -> Result<bool, RetargetError> {
        let goals = targets.goals.len();
        let mut pushes = vec![[0.0_f32; 3]; poses.len()];
        let mut meets = false;
        let is_held = |frame: usize, goal: usize| {
            targets.feet.iter().any(|foot| foot.goal == goal && foot.stands_in(frame))
        };
        self.overlaps(mechanism, values, DEEP, |frame, (a, b), depth, way| {
            meets = true;
            let movable = |ball: usize| {
                self.movers[ball].iter().copied().filter(|&goal| !is_held(frame, goal)).collect()
            };
            let sides: [Vec<usize>; 2] = [movable(a), movable(b)];
            let both = sides.iter().all(|side| !side.is_empty());
            let size = EAGER * f64::from(depth) * if both { 0.5 } else { 1.0 };
            for (side, sign) in sides.iter().zip([1.0, -1.0]) {
                for &goal in side {
                    let push = &mut pushes[frame * goals + goal];
                    // The largest push of all pairs, because pairs of two links say the same.
                    let old = push.map(f64::from);
                    if norm(old) < size {
                        *push = scale(way, sign * size).map(|part| part as f32);
                    }
                }
            }
        })?;
        if meets {
            smooth(pushes.as_flattened_mut(), 3 * goals, lambda(FREQUENCY, targets.step));
            for (pose, push) in poses.iter_mut().zip(&pushes) {
                *pose = DualQuat::from_translation(*push) * *pose;
            }
        }
        Ok(meets)
    }
}

/// Returns the links that move relative to their parents, from the root to this link.
fn path(humanoid: &Humanoid, link: usize) -> Vec<usize> {
    let joints = humanoid.robot().joints();
    let mut path = Vec::new();
    let mut next = Some(link);
    while let Some(link) = next {
        if joints[link].kind.values() > 0 || joints[link].mimic.is_some() {
            path.push(link);
        }
        next = joints[link].parent;
    }
    path.reverse();
    path
}

/// Returns the goals of limbs at or below a link, or, if there are none, the nearest one above it.
fn movers(humanoid: &Humanoid, targets: &Targets, link: usize) -> Vec<usize> {
    let own = path(humanoid, link);
    let goals = || {
        let limbs = targets.places.iter().enumerate().filter(|(_, place)| place.role.is_limb());
        limbs.map(|(goal, place)| (goal, path(humanoid, place.link)))
    };
    // A link of the trunk carries all limbs, and is not moved by them.
    let trunk = targets.places.iter().filter(|place| !place.role.is_limb());
    let is_trunk =
        trunk.filter(|place| place.role.carrier().is_none() || place.role.side().is_none());
    if is_trunk.map(|place| path(humanoid, place.link)).any(|path| path.starts_with(&own)) {
        return Vec::new();
    }
    let below: Vec<_> =
        goals().filter(|(_, path)| path.starts_with(&own)).map(|(g, _)| g).collect();
    if !below.is_empty() {
        return below;
    }
    let above = goals().filter(|(_, path)| own.starts_with(path));
    above.max_by_key(|(_, path)| path.len()).map(|(goal, _)| goal).into_iter().collect()
}

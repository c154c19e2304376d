//! [`Balls`]: where a robot meets itself, and how its targets must move so that it does not.

use crate::collision::Ball;
use crate::smooth::{lambda, smooth};
use crate::{Humanoid, RetargetError, Targets};
use dq8::DualQuat;
use dq8::scalar::vector::{add, norm, scale, sub};
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
    /// The centres of balls, and then of one hull around the balls of each link.
    points: Vec<(usize, [f32; 3])>,
    /// Pairs of links: their hulls, and the pairs of their balls.
    near: Vec<(Pair, Vec<Pair>)>,
    /// The goals that move each ball.
    movers: Vec<Vec<usize>>,
}

/// Two points, and the distance below which the balls around them overlap.
#[derive(Clone, Copy, Debug)]
struct Pair {
    a: usize,
    b: usize,
    reach: f32,
}

impl Pair {
    /// Returns the way from b to a, and the square of its length.
    fn way(self, places: &[[f32; 3]]) -> ([f32; 3], f32) {
        let [x, y, z]: [f32; 3] = core::array::from_fn(|i| places[self.a][i] - places[self.b][i]);
        ([x, y, z], x * x + y * y + z * z)
    }
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
        let hulls = hulls(&balls);
        let hull = |link: usize| hulls.iter().position(|hull| hull.link == link).unwrap_or(0);
        let mut near: Vec<(Pair, Vec<Pair>)> = Vec::new();
        for (a, ball) in balls.iter().enumerate() {
            for (b, other) in balls.iter().enumerate().skip(a + 1) {
                let same = paths[a].iter().zip(&paths[b]).take_while(|(a, b)| a == b).count();
                let joints = paths[a].len() + paths[b].len() - 2 * same;
                let reach = ball.radius + other.radius;
                let overlaps = |poses: &Vec<DualQuat<f64>>| {
                    let at = |ball: &Ball| poses[ball.link].transform_point(ball.centre);
                    norm(sub(at(ball), at(other))) < reach
                };
                if joints <= 3 || stands.iter().any(overlaps) {
                    continue;
                }
                let pair = Pair { a, b, reach: reach as f32 };
                let [i, j] = [hull(ball.link), hull(other.link)];
                let (first, second) = (balls.len() + i, balls.len() + j);
                match near.iter_mut().find(|(hulls, _)| hulls.a == first && hulls.b == second) {
                    Some((_, pairs)) => pairs.push(pair),
                    None => {
                        let reach = (hulls[i].radius + hulls[j].radius) as f32;
                        near.push((Pair { a: first, b: second, reach }, vec![pair]));
                    }
                }
            }
        }
        let movers = balls.iter().map(|ball| movers(humanoid, targets, ball.link)).collect();
        let point = |ball: &Ball| (ball.link, ball.centre.map(|x| x as f32));
        let points = balls.iter().chain(&hulls).map(point).collect();
        Ok(Self { points, near, movers })
    }

    /// Returns `true` if there is no pair to look at.
    pub(crate) fn is_empty(&self) -> bool {
        self.near.is_empty()
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
            for (hulls, pairs) in &self.near {
                if hulls.way(places).1 > hulls.reach * hulls.reach {
                    continue;
                }
                for pair in pairs {
                    let (way, square) = pair.way(places);
                    let reach = pair.reach - least;
                    if reach > 0.0 && square < reach * reach {
                        let distance = square.sqrt();
                        let way = way.map(|part| f64::from(part / distance.max(1e-6)));
                        found(frame, (pair.a, pair.b), pair.reach - distance, way);
                    }
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

/// Returns a ball around the balls of each link.
fn hulls(balls: &[Ball]) -> Vec<Ball> {
    let mut links: Vec<_> = balls.iter().map(|ball| ball.link).collect();
    links.sort_unstable();
    links.dedup();
    let hull = |link: usize| {
        let own = || balls.iter().filter(move |ball| ball.link == link);
        let sum = own().fold([0.0; 3], |sum, ball| add(sum, ball.centre));
        let centre = scale(sum, 1.0 / own().count() as f64);
        let reach = |ball: &Ball| norm(sub(ball.centre, centre)) + ball.radius;
        Ball { link, centre, radius: own().map(reach).fold(0.0, f64::max) }
    };
    links.into_iter().map(hull).collect()
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

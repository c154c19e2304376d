//! [`Bodies`]: where a robot meets itself, and how its targets must move so that it does not.

use crate::collision::moving;
use crate::smooth::{lambda, smooth};
use crate::solid::{Frame, Solid};
use crate::{Humanoid, RetargetError, Targets};
use dq8::DualQuat;
use dq8::scalar::vector::{add, dot, norm, scale, sub};
use dq8_robot::OwnedMechanism;
use std::ops::Range;

type Vector = [f64; 3];

/// Shapes that overlap by more than this are pushed apart. Metres.
const DEEP: f32 = 0.005;

/// Overlaps are pushed apart by this times their depth, because the search follows a push in part.
const EAGER: f64 = 1.3;

/// Pushes change with at most this frequency. Hz.
const FREQUENCY: f64 = 8.0;

/// Links that are at most so many joints apart do not count, because shapes are fatter than bodies.
const JOINTS: usize = 3;

/// The number of frames whose points are known at once.
const FRAMES: usize = 256;

/// The shapes of a robot, and what tells quickly that links do not meet.
#[derive(Clone, Debug)]
pub(crate) struct Bodies {
    mechanism: OwnedMechanism<f32>,
    /// The centre of the hull of each body, and then, for each shape, its origin and, if it is not
    /// a sphere, three points that are 1 m away from there along its axes.
    points: Vec<(usize, [f32; 3])>,
    /// The point of the origin of each shape.
    origins: Vec<usize>,
    bodies: Vec<Body>,
    /// The shapes, in the order of their bodies.
    solids: Vec<Solid>,
    /// The depths of pairs of shapes while the robot stands, in the order of the pairs.
    standing: Vec<([usize; 2], f32)>,
    /// The nearest link above each link that moves, and the number of those that do.
    above: Vec<usize>,
    depths: Vec<usize>,
}

/// A link with shapes.
#[derive(Clone, Debug)]
struct Body {
    /// The link, or the one above it to which it is fixed.
    link: usize,
    solids: Range<usize>,
    /// The radius of a ball around all shapes.
    reach: f32,
    /// The goals that move it.
    movers: Vec<usize>,
}

/// Two bodies that meet in a frame.
pub(crate) struct Meeting {
    pub(crate) frame: usize,
    bodies: [usize; 2],
    depth: f32,
    /// The unit vector that leads the first one out.
    way: Vector,
}

impl Bodies {
    /// Takes the shapes of the robot.
    pub(crate) fn new(humanoid: &Humanoid, targets: &Targets) -> Result<Self, RetargetError> {
        let robot = humanoid.robot();
        let (moving, zero) = (moving(robot), humanoid.zero());
        let poses = humanoid.poses(&zero)?;
        let mut shapes: Vec<_> = humanoid.collisions().iter().collect();
        shapes.sort_by_key(|shape| moving[shape.link]);
        let above = |link: usize| robot.joints()[link].parent.map_or(link, |up| moving[up]);
        let above: Vec<_> = (0..moving.len()).map(|link| above(moving[link])).collect();
        let mut depths = vec![0; above.len()];
        for link in 1..above.len() {
            depths[link] = depths[above[link]] + usize::from(moving[link] == link);
        }
        let (mut bodies, mut hulls, mut points) = (Vec::new(), Vec::new(), Vec::new());
        let mut origins = Vec::with_capacity(shapes.len());
        let (mut solids, mut first) = (Vec::with_capacity(shapes.len()), 0);
        for shapes in shapes.chunk_by(|a, b| moving[a.link] == moving[b.link]) {
            let link = moving[shapes[0].link];
            let own: Vec<_> = shapes.iter().map(|shape| Solid::new(shape.form)).collect();
            let on = |link_of: usize| poses[link].conjugate() * poses[link_of];
            let places: Vec<_> = shapes.iter().map(|shape| on(shape.link) * shape.pose).collect();
            let sum = places.iter().fold([0.0; 3], |sum, place| add(sum, place.translation()));
            let centre = scale(sum, 1.0 / places.len() as f64);
            let reach = |(place, solid): (&DualQuat<f64>, &Solid)| {
                norm(sub(place.translation(), centre)) + f64::from(solid.reach)
            };
            let reach = places.iter().zip(&own).map(reach).fold(0.0, f64::max) as f32;
            hulls.push((link, centre));
            for (place, solid) in places.into_iter().zip(&own) {
                origins.push(points.len());
                let axes = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
                let axes = if solid.is_sphere() { &axes[..1] } else { &axes };
                points.extend(axes.iter().map(|&point| (link, place.transform_point(point))));
            }
            solids.extend(own);
            let movers = movers(humanoid, targets, link);
            bodies.push(Body { link, solids: first..solids.len(), reach, movers });
            first = solids.len();
        }
        origins.iter_mut().for_each(|origin| *origin += hulls.len());
        let single = |(link, point): (usize, Vector)| (link, point.map(|part| part as f32));
        let points = hulls.into_iter().chain(points).map(single).collect();
        let mechanism = robot.cast()?;
        let mut own = Self {
            mechanism,
            points,
            bodies,
            solids,
            origins,
            standing: Vec::new(),
            above,
            depths,
        };
        own.stand([&zero, &targets.start])?;
        Ok(own)
    }

    /// Notes which shapes overlap while the robot stands.
    fn stand(&mut self, stances: [&[f64]; 2]) -> Result<(), RetargetError> {
        let mut standing = Vec::new();
        let values: Vec<f32> = stances.concat().iter().map(|&value| value as f32).collect();
        self.each_overlap(&values, 0.0, |_, _, pair, depth, _| standing.push((pair, depth)))?;
        standing.sort_by(|a, b| a.0.cmp(&b.0).then(b.1.total_cmp(&a.1)));
        standing.dedup_by_key(|(pair, _)| *pair);
        self.standing = standing;
        Ok(())
    }

    /// Returns `true` if there are no bodies that could meet.
    pub(crate) fn is_empty(&self) -> bool {
        // The two bodies of a tree that are farthest apart: the farthest from any of them, and the
        // farthest from there.
        let farthest = |from: usize| {
            let others = self.bodies.iter().map(|body| body.link);
            others.max_by_key(|&link| self.joints_between(from, link)).unwrap_or(from)
        };
        let Some(first) = self.bodies.first() else { return true };
        let end = farthest(first.link);
        self.joints_between(end, farthest(end)) <= JOINTS
    }

    /// Returns the number of joints between two links that move.
    fn joints_between(&self, mut a: usize, mut b: usize) -> usize {
        let mut joints = 0;
        while a != b {
            let deeper = if self.depths[a] > self.depths[b] { &mut a } else { &mut b };
            *deeper = self.above[*deeper];
            joints += 1;
        }
        joints
    }

    /// Calls `found` for each two bodies and frame in which shapes are deeper in each other than
    /// `least`, or, if they overlap while the robot stands, than there by `least`.
    pub(crate) fn meetings(
        &self,
        values: &[f32],
        least: f32,
        mut found: impl FnMut(&Meeting),
    ) -> Result<(), RetargetError> {
        self.each_overlap(values, least, |frame, bodies, pair, depth, way| {
            let standing = self.standing.binary_search_by_key(&pair, |(pair, _)| *pair);
            let known = standing.map_or(0.0, |index| self.standing[index].1);
            if depth - known > least {
                found(&Meeting { frame, bodies, depth: depth - known, way: way.map(f64::from) });
            }
        })
    }

    /// Calls `found` with the frame, the bodies, the shapes, their depth and the way out of the
    /// first one for each overlap of more than `least`.
    fn each_overlap(
        &self,
        values: &[f32],
        least: f32,
        mut found: impl FnMut(usize, [usize; 2], [usize; 2], f32, [f32; 3]),
    ) -> Result<(), RetargetError> {
        if self.bodies.is_empty() {
            return Ok(());
        }
        let (count, points) = (self.mechanism.view().values(), self.points.len());
        let mut places = vec![[0.0_f32; 3]; points * FRAMES.min(values.len() / count)];
        // Bodies in the order of their lowest points, which changes little from frame to frame.
        let mut order: Vec<usize> = (0..self.bodies.len()).collect();
        let mut near = [Vec::new(), Vec::new()];
        for (block, values) in values.chunks(FRAMES * count).enumerate() {
            let places = &mut places[..points * (values.len() / count)];
            self.mechanism.job().points(&self.points, values, places)?;
            for (frame, places) in places.chunks_exact(points).enumerate() {
                let low = |body: usize| places[body][2] - self.bodies[body].reach;
                for place in 1..order.len() {
                    let mut place = place;
                    while place > 0 && low(order[place - 1]) > low(order[place]) {
                        order.swap(place - 1, place);
                        place -= 1;
                    }
                }
                for (place, &a) in order.iter().enumerate() {
                    let top = places[a][2] + self.bodies[a].reach;
                    for &b in order[place + 1..].iter().take_while(|&&body| low(body) < top) {
                        let pair = [a.min(b), a.max(b)];
                        self.overlaps(pair, places, least, &mut near, &mut |solids, depth, way| {
                            found(block * FRAMES + frame, pair, solids, depth, way);
                        });
                    }
                }
            }
        }
        Ok(())
    }

    /// Calls `found` for each overlap of the shapes of two bodies. `near` is memory for shapes that
    /// are near to the other body.
    fn overlaps(
        &self,
        pair: [usize; 2],
        places: &[[f32; 3]],
        least: f32,
        near: &mut [Vec<usize>; 2],
        found: &mut impl FnMut([usize; 2], f32, [f32; 3]),
    ) {
        let [a, b] = pair.map(|body| &self.bodies[body]);
        let [a_at, b_at] = pair.map(|body| places[body]);
        if !within(a_at, b_at, a.reach + b.reach) || self.joints_between(a.link, b.link) <= JOINTS {
            return;
        }
        let origin = |solid: usize| places[self.origins[solid]];
        let frame = |solid: usize| {
            let (first, origin) = (self.origins[solid], origin(solid));
            if self.solids[solid].is_sphere() {
                return Frame { origin, axes: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] };
            }
            Frame { origin, axes: core::array::from_fn(|i| sub(places[first + 1 + i], origin)) }
        };
        for (near, (body, hull, reach)) in
            near.iter_mut().zip([(a, b_at, b.reach), (b, a_at, a.reach)])
        {
            near.clear();
            let meets =
                |&solid: &usize| within(origin(solid), hull, self.solids[solid].reach + reach);
            near.extend(body.solids.clone().filter(meets));
        }
        let [near_a, near_b] = near;
        for &i in &*near_a {
            for &j in &*near_b {
                let (solid, other) = (&self.solids[i], &self.solids[j]);
                if !within(origin(i), origin(j), solid.reach + other.reach) {
                    continue;
                }
                // The way that leads the first shape out is opposite to that of the other one.
                if let Some((depth, way)) = other.overlap(&frame(j), solid, &frame(i), least) {
                    found([i, j], depth, way);
                }
            }
        }
    }

    /// Moves targets apart where the robot meets itself. Returns `true` if it does anywhere. Feet
    /// that stand are not pushed.
    pub(crate) fn push(
        &self,
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
        self.meetings(values, DEEP, |&Meeting { frame, bodies, depth, way }| {
            meets = true;
            let sides = bodies.map(|body| -> Vec<usize> {
                let movers = self.bodies[body].movers.iter().copied();
                movers.filter(|&goal| !is_held(frame, goal)).collect()
            });
            let both = sides.iter().all(|side| !side.is_empty());
            let size = EAGER * f64::from(depth) * if both { 0.5 } else { 1.0 };
            for (side, sign) in sides.iter().zip([1.0, -1.0]) {
                for &goal in side {
                    let push = &mut pushes[frame * goals + goal];
                    // What other pairs push this way counts, because pairs of two links say the
                    // same.
                    let (old, way) = (push.map(f64::from), scale(way, sign));
                    let lack = size - dot(old, way);
                    if lack > 0.0 {
                        *push = add(old, scale(way, lack)).map(|part| part as f32);
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

/// Returns `true` if two points are nearer to each other than a distance.
fn within(a: [f32; 3], b: [f32; 3], distance: f32) -> bool {
    let way = sub(a, b);
    dot(way, way) < distance * distance
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

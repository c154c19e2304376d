//! The parts of a robot by its shape, without names: the two mirrored chains of hinges that reach
//! lowest are legs, two more are arms, and knees bend backward.

use crate::role::Role;
use dq8::DualQuat;
use dq8::scalar::vector::{add, cross, dot, norm, over_norm, scale, sub};
use dq8_robot::urdf::Robot;
use dq8_robot::{Joint, JointKind};

type Vector = [f64; 3];

const UP: Vector = [0.0, 0.0, 1.0];

/// The most ends, and the most joints in a row, of a robot whose shape is looked at: each two ends
/// are compared. Humanoids with all their fingers have some sixty ends.
const MOST: usize = 256;

/// The links of a robot that move, with all joints at zero.
pub(crate) struct Shape<'r> {
    joints: &'r [Joint<f64>],
    poses: &'r [DualQuat<f64>],
    /// The nearest link above or at each link that moves relative to its parent.
    moving: Vec<usize>,
    /// The links that each moving link carries and that move on it.
    children: Vec<Vec<usize>>,
    /// The number of hinges to the farthest tip below each moving link.
    depth: Vec<usize>,
    /// The moving links that carry no others.
    tips: Vec<usize>,
    /// The height of the whole robot.
    height: f64,
    lowest: f64,
}

/// A limb: the links of its hinges, from the trunk to the last.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Limb {
    pub(crate) links: Vec<usize>,
    /// The place among `links` of the hinge of the knee or elbow.
    pub(crate) middle: usize,
}

/// Two mirrored limbs, and the link that carries both. The first is the left one.
#[derive(Clone, Debug)]
pub(crate) struct Pair {
    pub(crate) trunk: usize,
    pub(crate) limbs: [Limb; 2],
}

/// What the shape tells.
#[derive(Debug, Default)]
pub(crate) struct Body {
    pub(crate) legs: Option<Pair>,
    pub(crate) arms: Option<Pair>,
    pub(crate) head: Option<usize>,
    /// `true` if neither the knees nor anything else tells where front is, so that x is assumed.
    pub(crate) is_front_assumed: bool,
}

impl<'r> Shape<'r> {
    pub(crate) fn new(robot: &'r Robot, poses: &'r [DualQuat<f64>]) -> Self {
        let joints = robot.joints();
        let moves = |joint: &Joint<f64>| joint.kind.values() > 0 || joint.mimic.is_some();
        let (mut moving, mut children) = (Vec::new(), vec![Vec::new(); joints.len()]);
        for (link, joint) in joints.iter().enumerate() {
            let above = joint.parent.map(|parent| moving[parent]);
            match above {
                Some(above) if !moves(joint) => moving.push(above),
                _ => {
                    moving.push(link);
                    if let Some(above) = above {
                        children[above].push(link);
                    }
                }
            }
        }
        let mut depth = vec![0; joints.len()];
        for link in (0..joints.len()).rev() {
            depth[link] =
                children[link].iter().map(|&child: &usize| depth[child] + 1).max().unwrap_or(0);
        }
        let is_tip = |&link: &usize| moving[link] == link && children[link].is_empty();
        let tips = (0..joints.len()).filter(is_tip).collect();
        let heights = || poses.iter().map(|pose| pose.translation()[2]);
        let lowest = heights().fold(f64::INFINITY, f64::min);
        let height = heights().fold(f64::NEG_INFINITY, f64::max) - lowest;
        Self { joints, poses, moving, children, depth, tips, height, lowest }
    }

    /// Returns `true` if one link cannot move relative to the other.
    pub(crate) fn is_rigid(&self, a: usize, b: usize) -> bool {
        self.moving[a] == self.moving[b]
    }

    /// Returns the place of the link among the links of a limb to which it is fixed.
    pub(crate) fn place_on(&self, limb: &Limb, link: usize) -> Option<usize> {
        limb.links.iter().position(|&own| self.is_rigid(own, link))
    }

    /// Returns `true` if joints that move are between a link and another that it carries.
    pub(crate) fn carries(&self, above: usize, below: usize) -> bool {
        !self.is_rigid(above, below) && self.path(below).contains(&self.moving[above])
    }

    /// Returns `true` if the link is part of an arm or a leg.
    pub(crate) fn is_on_a_limb(&self, body: &Body, link: usize) -> bool {
        let path = self.path(link);
        let pairs = [body.legs.as_ref(), body.arms.as_ref()].into_iter().flatten();
        pairs.flat_map(|pair| &pair.limbs).any(|limb| path.contains(&limb.links[0]))
    }

    fn at(&self, link: usize) -> Vector {
        self.poses[link].translation()
    }

    /// Returns the moving links from the root to this one.
    fn path(&self, link: usize) -> Vec<usize> {
        let mut path = vec![self.moving[link]];
        while let Some(parent) = path.last().and_then(|&link| self.joints[link].parent) {
            path.push(self.moving[parent]);
        }
        path.reverse();
        path
    }

    /// Returns the direction of a hinge's axis.
    fn axis(&self, link: usize) -> Option<Vector> {
        match self.joints[link].kind {
            JointKind::Revolute { axis } => {
                let axis = self.poses[link].transform_vector(axis);
                Some(over_norm(axis, norm(axis)))
            }
            _ => None,
        }
    }

    /// Returns `true` if the robot has so many links that its shape is not looked at.
    pub(crate) fn is_too_large(&self) -> bool {
        self.tips.len() > MOST || self.depth.first().is_some_and(|&joints| joints > MOST)
    }

    /// Returns the parts that the shape tells.
    pub(crate) fn body(&self) -> Body {
        let mut body = Body::default();
        if self.is_too_large() {
            return body;
        }
        let paths: Vec<_> = self.tips.iter().map(|&tip| self.path(tip)).collect();
        let mut pairs = Vec::new();
        for (index, a) in paths.iter().enumerate() {
            pairs.extend(paths[index + 1..].iter().filter_map(|b| self.twins(a, b)));
        }
        // Of rods and soles at the end of a leg, the one with most hinges before it is the foot.
        let low = |pair: &&Pair| {
            self.end_height(pair) < self.lowest + 0.15 * self.height
                && self.at(pair.trunk)[2] > self.lowest + 0.2 * self.height
        };
        let most = |pairs: &mut dyn Iterator<Item = &Pair>| {
            pairs.max_by_key(|pair| pair.limbs[0].links.len()).cloned()
        };
        let Some(legs) = most(&mut pairs.iter().filter(low)) else { return body };
        let others = |pair: &&Pair| {
            let roots = [&legs.limbs[0].links[0], &legs.limbs[1].links[0]];
            let [a, b] = [&pair.limbs[0].links, &pair.limbs[1].links];
            !roots.iter().any(|root| a.contains(root) || b.contains(root))
                && !legs.limbs.iter().any(|limb| limb.links.contains(&pair.trunk))
        };
        let arms = most(&mut pairs.iter().filter(others));
        let hips = self.at(legs.limbs[0].links[0])[2];
        if let Some(arms) = &arms {
            // The fore legs of a quadruped begin as high as its hind legs, and end as low.
            let shoulders = self.at(arms.limbs[0].links[0])[2];
            let stands_on = self.end_height(arms) < self.lowest + 0.15 * self.height;
            if stands_on && shoulders - hips < 0.3 * (hips - self.lowest) {
                return body;
            }
        }
        let Some(mut legs) = self.bent(legs, true) else { return body };
        let mut arms = arms.and_then(|arms| self.bent(arms, false));
        body.is_front_assumed = !self.orient(&mut legs, arms.as_mut());
        (body.legs, body.arms) = (Some(legs), arms);
        body.head = self.head(&body);
        body
    }

    fn end_height(&self, pair: &Pair) -> f64 {
        let [a, b] = pair.limbs.each_ref().map(|limb| limb.links.last().copied().unwrap_or(0));
        0.5 * (self.at(a)[2] + self.at(b)[2])
    }

    /// Returns two limbs if the paths to two tips part into chains of at least three hinges, of the
    /// same lengths, and mirrored.
    fn twins(&self, a: &[usize], b: &[usize]) -> Option<Pair> {
        if a.len() != b.len() {
            return None;
        }
        let same = a.iter().zip(b).take_while(|(a, b)| a == b).count();
        let (trunk, a, b) = (*a.get(same.checked_sub(1)?)?, &a[same..], &b[same..]);
        if a.len() < 3 {
            return None;
        }
        let near = |x: f64, y: f64| (x - y).abs() < 0.02 * self.height;
        for (index, (&l, &r)) in a.iter().zip(b).enumerate() {
            let from = |links: &[usize]| self.at(if index == 0 { trunk } else { links[index - 1] });
            let (p, q) = (self.at(l), self.at(r));
            let lengths = [sub(p, from(a)), sub(q, from(b))].map(norm);
            if !near(p[2], q[2]) || !near(lengths[0], lengths[1]) {
                return None;
            }
        }
        let [p, q] = [a, b].map(|links| self.at(links[links.len() - 1]));
        let apart = sub(p, q);
        (norm([apart[0], apart[1]]) > 0.03 * self.height).then(|| Pair {
            trunk,
            limbs: [a, b].map(|links| Limb { links: links.to_vec(), middle: 0 }),
        })
    }

    /// Returns the pair without toes and fingers, and with knees or elbows.
    fn bent(&self, mut pair: Pair, are_legs: bool) -> Option<Pair> {
        let links = &pair.limbs[0].links;
        let length = if are_legs { self.without_toes(links) } else { self.without_fingers(links) };
        pair.limbs.iter_mut().for_each(|limb| limb.links.truncate(length));
        let links = &pair.limbs[0].links;
        let (first, last) = (self.at(*links.first()?), self.at(*links.last()?));
        let way = sub(last, first);
        let along = over_norm(way, norm(way).max(f64::MIN_POSITIVE));
        let imbalance = |index: usize| {
            let place = self.at(links[index]);
            (norm(sub(place, first)) - norm(sub(last, place))).abs()
        };
        // A hinge about the limb itself turns it and does not bend it, and hinges near the first
        // are those of a hip or shoulder.
        let bends = |&index: &usize| {
            let axis = self.axis(links[index]);
            let is_far = norm(sub(self.at(links[index]), first)) > 0.3 * norm(way);
            is_far && axis.is_some_and(|axis| dot(axis, along).abs() < 0.7)
        };
        let middle = (1..links.len().saturating_sub(1))
            .filter(bends)
            .min_by(|&a, &b| imbalance(a).total_cmp(&imbalance(b)))
            .or_else(|| {
                // An arm without a wrist ends in its elbow.
                (!are_legs).then(|| links.len() - 1).filter(bends)
            })?;
        pair.limbs.iter_mut().for_each(|limb| limb.middle = middle);
        Some(pair)
    }

    /// Returns the number of hinges of a leg before its toes, which are ahead of the ankle.
    fn without_toes(&self, links: &[usize]) -> usize {
        let mut length = links.len();
        while length > 3 {
            let way = sub(self.at(links[length - 1]), self.at(links[length - 2]));
            if norm([way[0], way[1]]) < 0.05 * self.height || way[2].abs() > norm([way[0], way[1]])
            {
                break;
            }
            length -= 1;
        }
        length
    }

    /// Returns the number of hinges of an arm before its fingers, of which a hand carries several.
    fn without_fingers(&self, links: &[usize]) -> usize {
        let branches = |&index: &usize| {
            self.children[links[index]].len() > 1 && index >= 2 && self.depth[links[index]] <= 5
        };
        (0..links.len()).find(branches).map_or(links.len(), |index| index + 1)
    }

    /// Exchanges left and right where knees that bend backward say so. Returns `false` if knees say
    /// nothing.
    fn orient(&self, legs: &mut Pair, arms: Option<&mut Pair>) -> bool {
        let mut front = [0.0; 3];
        for limb in &legs.limbs {
            let knee = limb.links[limb.middle];
            let (Some(axis), Some([low, high])) = (self.axis(knee), self.joints[knee].limits)
            else {
                continue;
            };
            let bend = 0.5 * (low + high);
            if bend.abs() > 0.1 * (high - low) && bend.is_finite() {
                let shank = sub(self.at(limb.links[limb.links.len() - 1]), self.at(knee));
                front = sub(front, scale(cross(axis, shank), bend.signum() / norm(shank)));
            }
        }
        let across = |pair: &Pair| {
            let [a, b] =
                pair.limbs.each_ref().map(|limb| self.at(limb.links[limb.links.len() - 1]));
            [a[0] - b[0], a[1] - b[1], 0.0]
        };
        // With the first limb on the left, this is front.
        let ahead = cross(across(legs), UP);
        let size = norm(ahead).max(f64::MIN_POSITIVE);
        let says = dot(front, over_norm(ahead, size));
        let known = says.abs() > 0.5;
        let wrong = if known { says < 0.0 } else { ahead[0] + 0.1 * ahead[1] < 0.0 };
        if wrong {
            legs.limbs.reverse();
        }
        if let Some(arms) = arms
            && dot(across(arms), across(legs)) < 0.0
        {
            arms.limbs.reverse();
        }
        known
    }

    /// Returns the highest link above the shoulders that no limb has and that moves.
    fn head(&self, body: &Body) -> Option<usize> {
        let arms = body.arms.as_ref()?;
        let shoulders = self.at(arms.limbs[0].links[0])[2];
        let heads = (0..self.joints.len()).filter(|&link| {
            self.moving[link] == link
                && self.carries(arms.trunk, link)
                && !self.is_on_a_limb(body, link)
                && self.at(link)[2] > shoulders
        });
        heads.max_by(|&a, &b| self.at(a)[2].total_cmp(&self.at(b)[2]))
    }
}

impl Body {
    /// Returns the link of a role, and the link at the centre of its joint.
    pub(crate) fn part(&self, role: Role) -> Option<[usize; 2]> {
        let one = |link: usize| Some([link, link]);
        let pair = match role {
            Role::Pelvis => return one(self.legs.as_ref()?.trunk),
            Role::Chest => {
                let (legs, arms) = (self.legs.as_ref()?, self.arms.as_ref()?);
                return one(arms.trunk).filter(|_| arms.trunk != legs.trunk);
            }
            Role::Head => return one(self.head?),
            _ => self.pair(role)?,
        };
        let Limb { links, middle } = &pair.limbs[usize::from(role.side() == Some("right"))];
        match role {
            Role::LeftShoulder | Role::RightShoulder | Role::LeftHip | Role::RightHip => {
                // Of the hinges above the middle, the second but last is the centre of most hips.
                Some([links[middle - 1], links[middle.saturating_sub(2)]])
            }
            Role::LeftElbow | Role::RightElbow | Role::LeftKnee | Role::RightKnee => {
                one(links[*middle])
            }
            // An arm that ends in its elbow has no hand.
            _ => one(*links.last()?).filter(|_| middle + 1 < links.len()),
        }
    }

    /// Returns the limbs to which a role belongs.
    pub(crate) fn pair(&self, role: Role) -> Option<&Pair> {
        match role {
            Role::Pelvis | Role::Chest | Role::Head => None,
            Role::LeftHip | Role::RightHip => self.legs.as_ref(),
            role if role.is_below_hips() => self.legs.as_ref(),
            _ => self.arms.as_ref(),
        }
    }
}

/// Returns the rotation about up that turns a robot whose left parts are `left` of its right ones
/// to x forward and y to the left. A robot that is within a few degrees of that is not turned.
pub(crate) fn facing(left: Vector) -> dq8::Quat<f64> {
    let left = [left[0], left[1], 0.0];
    let size = norm(left);
    if size == 0.0 || left[1] > 0.99 * size {
        return dq8::Quat::IDENTITY;
    }
    let left = over_norm(left, size);
    dq8::Quat::from_matrix3([cross(left, UP), left, UP]).normalize()
}

/// Returns the sum of the ways from right parts to left ones.
pub(crate) fn leftward(at: impl Fn(Role) -> Option<Vector>) -> Vector {
    Role::PAIRS.into_iter().fold([0.0; 3], |sum, [left, right]| match (at(left), at(right)) {
        (Some(left), Some(right)) => add(sum, sub(left, right)),
        _ => sum,
    })
}

//! One configuration of floats by the [plan](super::plan): what `f32` and `f64` compute instead of the products of the
//! book.
//!
//! Four lanes hold a quaternion, p or q of the motion p + εq of a turned frame. Nothing is fused: the bits are the same on
//! all targets. Cosines and sines come first, as many at a time as there are lanes for, and a frame is kept nowhere: what
//! branches off is turned back from the pose that has been written.

use super::frame::Frame;
use super::joint::JointKind;
use super::plan::{Factor, Moves, ORDER, SIGNS};
use super::points::{Found, Point};
use super::step::{Alignment, NONE, Step};
use super::tree::Mechanism;
use super::values::half_turn;
use dq8::Real;
use dq8::geometry::Twist;
use dq8::scalar::{DualQuat, Quat, vector};
use dq8::seams::{Number, Quick};
use dq8_simd::{Float, Lanes, Portable, Unfused};

const LEVEL: Unfused<Portable> = Unfused(Portable);
/// A quaternion.
type Four<R> = <R as Float>::Half<Unfused<Portable>>;
/// Two, or eight angles.
type Eight<R> = <R as Float>::Packed<Unfused<Portable>>;
/// What a register holds.
type Native<R> = <R as Float>::Lanes<Unfused<Portable>>;

#[inline(always)]
fn splat<R: Float>(number: R) -> Four<R> {
    Lanes::splat(LEVEL, number)
}

#[inline(always)]
fn load<R: Float>(numbers: [R; 4]) -> Four<R> {
    Lanes::load(LEVEL, &numbers)
}

/// x e_K but for its signs.
#[inline(always)]
fn ordered<const K: usize, R: Float>(x: Four<R>) -> Four<R> {
    let (x, [a, b, c, d]) = (x.to_array(), ORDER[K]);
    load([x[a], x[b], x[c], x[d]])
}

/// What the vector of a [`Factor`] along no axis multiplies [`ordered`] numbers with.
#[inline(always)]
fn rows<R: Float>(vector: Four<R>) -> [Four<R>; 3] {
    let [x, y, z, _] = vector.to_array();
    let row = |k: usize, number: R| splat::<R>(number) * load(SIGNS[k].map(R::from));
    [row(0, x), row(1, y), row(2, z)]
}

/// x (v + w)
#[inline(always)]
fn product<R: Float>(x: Four<R>, [i, j, k]: [Four<R>; 3], w: Four<R>) -> Four<R> {
    (x * w + ordered::<0, R>(x) * i) + (ordered::<1, R>(x) * j + ordered::<2, R>(x) * k)
}

/// The turned frame of a link.
#[derive(Clone, Copy)]
struct Turned<R: Float> {
    p: Four<R>,
    q: Four<R>,
}

impl<R: Real + Number> Turned<R> {
    #[inline(always)]
    fn new([x, y, z, w, qx, qy, qz, qw]: [R; 8]) -> Self {
        Self { p: load([x, y, z, w]), q: load([qx, qy, qz, qw]) }
    }

    #[inline(always)]
    fn to_array(self) -> [R; 8] {
        let ([x, y, z, w], [qx, qy, qz, qw]) = (self.p.to_array(), self.q.to_array());
        [x, y, z, w, qx, qy, qz, qw]
    }

    /// Moved by a vector in its own axes, of which half is given: q + p h.
    #[inline(always)]
    fn moved(self, along: Alignment, half: Four<R>) -> Self {
        let p = self.p;
        let added = match along {
            Alignment::None => return self,
            Alignment::X => ordered::<0, R>(p) * half,
            Alignment::Y => ordered::<1, R>(p) * half,
            Alignment::Z => ordered::<2, R>(p) * half,
            Alignment::Any => {
                let [x, y, z] = rows::<R>(half);
                ordered::<0, R>(p) * x + ordered::<1, R>(p) * y + ordered::<2, R>(p) * z
            }
        };
        Self { p, q: self.q + added }
    }

    /// Turned by the unit quaternion v + w.
    #[inline(always)]
    fn turned(self, about: Alignment, row: Four<R>, w: Four<R>) -> Self {
        match about {
            Alignment::None => self,
            Alignment::X => self.about::<0>(row, w),
            Alignment::Y => self.about::<1>(row, w),
            Alignment::Z => self.about::<2>(row, w),
            Alignment::Any => {
                let rows = rows::<R>(row);
                Self { p: product::<R>(self.p, rows, w), q: product::<R>(self.q, rows, w) }
            }
        }
    }

    #[inline(always)]
    fn about<const K: usize>(self, row: Four<R>, w: Four<R>) -> Self {
        let Self { p, q } = self;
        Self { p: p * w + ordered::<K, R>(p) * row, q: q * w + ordered::<K, R>(q) * row }
    }

    /// The pose of the link, whose own frame this is turned to.
    #[inline(always)]
    fn pose(self, own: &Factor<R>) -> DualQuat<R> {
        let own = self.turned(own.along, load(own.row), splat(own.w));
        DualQuat::from_array(own.to_array())
    }

    /// And back.
    #[inline(always)]
    fn of_pose(pose: &DualQuat<R>, own: &Factor<R>) -> Self {
        Self::new(pose.to_array()).turned(own.along, -load(own.row), splat(own.w))
    }

    /// From the frame of the parent to that of the joint.
    #[inline(always)]
    fn placed(self, step: &Step<R>) -> Self {
        let half_offset = &step.planned.half_offset;
        self.moved(half_offset.along, load(half_offset.row))
    }

    /// From the frame of the joint to that of the link.
    #[inline(always)]
    fn joined(self, step: &Step<R>, turns: &mut Turns<'_, R>) -> Self {
        let (at, planned) = (self, &step.planned);
        let mut turn = || {
            let [cos, sin] = turns.half_turn(step.value as usize);
            (load(planned.axis.row) * splat(sin), splat(cos))
        };
        match planned.moves {
            Moves::Not => at,
            Moves::AboutX => {
                let (row, cos) = turn();
                at.about::<0>(row, cos)
            }
            Moves::AboutY => {
                let (row, cos) = turn();
                at.about::<1>(row, cos)
            }
            Moves::AboutZ => {
                let (row, cos) = turn();
                at.about::<2>(row, cos)
            }
            Moves::AboutAny => {
                let (row, cos) = turn();
                at.turned(Alignment::Any, row, cos)
            }
            // By value: what is in memory here would be there for all.
            Moves::Otherwise => Self::new(otherwise(at.to_array(), step, turns.values)),
        }
    }

    /// Moved along the axis of a joint.
    fn slid(self, step: &Step<R>, length: R) -> Self {
        let axis = &step.planned.axis;
        self.moved(axis.along, load(axis.row) * splat(length * R::HALF))
    }

    /// Turned about it.
    fn hinged(self, step: &Step<R>, angle: R) -> Self {
        let axis = &step.planned.axis;
        let [cos, sin] = half_turn_of(angle);
        self.turned(axis.along, load(axis.row) * splat(sin), splat(cos))
    }
}

/// What most joints of a robot are not. Out of line: its constants would take the registers of what is in it.
#[cold]
#[inline(never)]
fn otherwise<R: Real + Number>(at: [R; 8], step: &Step<R>, values: &[R]) -> [R; 8] {
    let (at, own) = (Turned::new(at), step.planned.own.quaternion());
    let moved = |[x, y, z]: [R; 3]| {
        let [x, y, z] = own.rotate([x * R::HALF, y * R::HALF, z * R::HALF]);
        at.moved(Alignment::Any, load([x, y, z, R::ZERO]))
    };
    let at = match step.kind {
        JointKind::Fixed => at,
        JointKind::Revolute { .. } => at.hinged(step, step.single(values)),
        JointKind::Prismatic { .. } => at.slid(step, step.single(values)),
        JointKind::Screw { pitch, .. } => {
            let angle = step.single(values);
            at.slid(step, angle * pitch).hinged(step, angle)
        }
        JointKind::Planar { .. } => {
            let [x, y, angle] = Step::numbers(step.value, values);
            let [first, second] = step.plane;
            let slide = vector::add(vector::scale(first, x), vector::scale(second, y));
            moved(slide).hinged(step, angle)
        }
        JointKind::Floating => {
            let [x, y, z, w, tx, ty, tz] = Step::numbers(step.value, values);
            let turn = own * Quat::from_xyzw(x, y, z, w).normalize() * own.conjugate();
            let [x, y, z, w] = turn.to_array();
            let row = load([x, y, z, R::ZERO]);
            moved([tx, ty, tz]).turned(Alignment::Any, row, splat(w))
        }
    };
    at.to_array()
}

impl<R: Real> Step<R> {
    /// The spatial twists of the link for each rate of the joint alone, from the turned frame of the joint and the pose of
    /// the link. Where a hinge is, is known also where its angle is too far.
    #[inline]
    fn screws(
        &self,
        before: DualQuat<R>,
        pose: DualQuat<R>,
        values: &[R],
    ) -> impl Iterator<Item = Twist<R>> {
        let zero = [R::ZERO; 3];
        let axis = self.planned.axis.quaternion().xyz();
        let mut twists = [Twist { angular: zero, linear: zero }; 6];
        match self.kind {
            JointKind::Fixed => {}
            JointKind::Revolute { .. } => twists[0].angular = axis,
            JointKind::Prismatic { .. } => twists[0].linear = axis,
            JointKind::Screw { pitch, .. } => {
                twists[0] = Twist { angular: axis, linear: vector::scale(axis, pitch) };
            }
            JointKind::Planar { .. } => {
                let own = self.planned.own.quaternion();
                let [first, second] = self.plane.map(|direction| own.rotate(direction));
                let [x, y, _] = Self::numbers(self.value, values);
                let slide = vector::add(vector::scale(first, x), vector::scale(second, y));
                (twists[0].linear, twists[1].linear) = (first, second);
                twists[2] = Twist { angular: axis, linear: vector::cross(slide, axis) };
            }
            JointKind::Floating => {
                for (index, twist) in twists.iter_mut().enumerate() {
                    let mut unit = [R::ZERO; 6];
                    unit[index] = R::ONE;
                    *twist = Twist::from_array(unit);
                }
            }
        }
        let from = if let JointKind::Floating = self.kind { pose } else { before };
        let times = self.multiplier;
        let twists = twists.into_iter().take(self.kind.rates());
        let moved = move |twist: Twist<R>| match twist.angular == zero {
            // A slide does not turn, wherever it is.
            true => Twist { linear: from.transform_vector(twist.linear), ..twist },
            false => from.adjoint(twist),
        };
        twists.map(move |twist| moved(twist).scale(times))
    }
}

/// The values, and cosine and sine of half of some that follow each other.
struct Turns<'v, R> {
    values: &'v [R],
    first: usize,
    cos: [R; 8],
    sin: [R; 8],
}

impl<'v, R: Real + Number> Turns<'v, R> {
    /// From the values of a step on, at once: nothing else can be computed before.
    #[inline(always)]
    fn new(values: &'v [R], step: Option<&Step<R>>) -> Self {
        let mut turns = Self { values, first: 0, cos: [R::ZERO; 8], sin: [R::ZERO; 8] };
        turns.compute(step.map_or(0, |step| step.value as usize));
        turns
    }

    /// Cosine and sine of half of value number `index`.
    #[inline(always)]
    fn half_turn(&mut self, index: usize) -> [R; 2] {
        // One at a time, where lanes hold one number.
        let some = if Native::<R>::LANES == 1 { 1 } else { 8 };
        if index.wrapping_sub(self.first) >= some {
            self.compute_others(index);
        }
        let at = index.wrapping_sub(self.first) % some;
        [self.cos[at], self.sin[at]]
    }

    #[cold]
    #[inline(never)]
    fn compute_others(&mut self, index: usize) {
        self.compute(index);
    }

    /// Those of this value and of as many of the next ones as there are.
    #[inline(always)]
    fn compute(&mut self, index: usize) {
        if Native::<R>::LANES == 1 {
            self.first = index;
            let value = self.values.get(index).copied().unwrap_or(R::NAN);
            [self.cos[0], self.sin[0]] = half_turn_of(value);
            return;
        }
        self.first = index.min(self.values.len().saturating_sub(4));
        let rest = self.values.get(self.first..).unwrap_or_default();
        // The last four again, rather than fewer than four.
        let second = rest.len().wrapping_sub(4).min(4);
        let high = rest.get(second..).and_then(<[R]>::first_chunk::<4>);
        let some = match (rest.first_chunk::<4>(), high) {
            (Some(&[a, b, c, d]), Some(&[e, f, g, h])) => {
                Eight::<R>::load(LEVEL, &[a, b, c, d, e, f, g, h])
            }
            _ => Eight::<R>::load_partial(LEVEL, rest, R::ZERO),
        };
        let [cos, sin] = half_turn(some * some.constant(0.5));
        for (to, from) in [(&mut self.cos, cos.to_array()), (&mut self.sin, sin.to_array())] {
            to[..4].copy_from_slice(&from[..4]);
            to[second..][..4].copy_from_slice(&from[4..]);
        }
    }
}

/// Cosine and sine of half an angle.
fn half_turn_of<R: Real + Number>(angle: R) -> [R; 2] {
    let angle = Native::<R>::splat(LEVEL, angle);
    half_turn(angle * angle.constant(0.5)).map(|of| of.to_array().as_ref()[0])
}

/// The steps from the base to a link.
#[inline(always)]
fn way<'s, R: Copy>(
    mechanism: &Mechanism<'s, R>,
    link: usize,
) -> impl Iterator<Item = &'s Step<R>> {
    let end = mechanism.steps.get(link).map_or(NONE, |step| step.position) as usize;
    // No steps, if there is no such link: the base.
    let steps = mechanism.steps.get(..=end).unwrap_or_default().iter().enumerate();
    // What a step carries follows it.
    steps.filter(move |(position, step)| end - position < step.size as usize).map(|(_, step)| step)
}

const BASE: [f32; 8] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0];

/// [`Mechanism::link_poses`], for any value: NaN where an angle is too far for lanes.
pub(crate) struct LinkPoses<'s, R> {
    pub(crate) mechanism: &'s Mechanism<'s, R>,
    pub(crate) values: &'s [R],
    pub(crate) poses: &'s mut [DualQuat<R>],
}

impl<R: Real> Quick<R> for LinkPoses<'_, R> {
    type Output = ();

    #[inline]
    fn compute(self) -> Option<()>
    where
        R: Number,
    {
        let mut turns = Turns::new(self.values, self.mechanism.steps.first());
        let base = Turned::new(BASE.map(R::from));
        let (mut last, mut at) = (NONE, base);
        for step in self.mechanism.steps {
            // The children of a link but the first come after what the others carry.
            if step.parent != last {
                let link = step.parent as usize;
                at = match (self.poses.get(link), self.mechanism.step(link)) {
                    (Some(pose), Some(parent)) => Turned::of_pose(pose, &parent.planned.own),
                    _ => base,
                };
            }
            at = at.placed(step).joined(step, &mut turns);
            last = step.link;
            if let Some(slot) = self.poses.get_mut(step.link as usize) {
                *slot = at.pose(&step.planned.own);
            }
        }
        Some(())
    }
}

/// [`Mechanism::link_pose`].
pub(crate) struct LinkPose<'s, R> {
    pub(crate) mechanism: &'s Mechanism<'s, R>,
    pub(crate) values: &'s [R],
    pub(crate) link: usize,
}

impl<R: Real> Quick<R> for LinkPose<'_, R> {
    type Output = DualQuat<R>;

    #[inline]
    fn compute(self) -> Option<DualQuat<R>>
    where
        R: Number,
    {
        let mut turns = Turns::new(self.values, way(self.mechanism, self.link).next());
        let (mut at, mut own) = (Turned::new(BASE.map(R::from)), &Factor::ONE);
        for step in way(self.mechanism, self.link) {
            at = at.placed(step).joined(step, &mut turns);
            own = &step.planned.own;
        }
        Some(at.pose(own))
    }
}

/// [`Mechanism::link_jacobian`].
pub(crate) struct LinkJacobian<'s, R> {
    pub(crate) mechanism: &'s Mechanism<'s, R>,
    pub(crate) values: &'s [R],
    pub(crate) link: usize,
    pub(crate) frame: Frame,
    pub(crate) columns: &'s mut [Twist<R>],
}

impl<R: Real> Quick<R> for LinkJacobian<'_, R> {
    type Output = DualQuat<R>;

    #[inline]
    fn compute(self) -> Option<DualQuat<R>>
    where
        R: Number,
    {
        self.columns.fill(Twist::from_array([R::ZERO; 6]));
        let mut turns = Turns::new(self.values, way(self.mechanism, self.link).next());
        let (mut at, mut pose) = (Turned::new(BASE.map(R::from)), DualQuat::IDENTITY);
        for step in way(self.mechanism, self.link) {
            let before = at.placed(step);
            at = before.joined(step, &mut turns);
            pose = at.pose(&step.planned.own);
            let columns = self.columns.get_mut(step.rate as usize..).unwrap_or_default();
            let before = DualQuat::from_array(before.to_array());
            for (column, screw) in columns.iter_mut().zip(step.screws(before, pose, self.values)) {
                // What others mimic is moved by all of them.
                *column = *column + screw;
            }
        }
        let (back, origin) = (pose.conjugate(), pose.translation());
        for column in self.columns {
            // Of a joint that does not carry the link, wherever that is.
            if column.to_array() == [R::ZERO; 6] {
                continue;
            }
            match self.frame {
                Frame::World => break,
                Frame::Body => *column = back.adjoint(*column),
                Frame::WorldAligned => column.linear = column.velocity_at(origin),
            }
        }
        Some(pose)
    }
}

/// [`Mechanism::link_points`].
pub(crate) struct LinkPoints<'s, R> {
    pub(crate) mechanism: &'s Mechanism<'s, R>,
    pub(crate) values: &'s [R],
    pub(crate) points: &'s [Point<R>],
    pub(crate) places: &'s mut [[R; 3]],
}

impl<R: Real> Quick<R> for LinkPoints<'_, R> {
    type Output = ();

    #[inline]
    fn compute(self) -> Option<()>
    where
        R: Number,
    {
        let mut turns = Turns::new(self.values, self.mechanism.steps.first());
        let mut found = Found::new(self.points);
        let (mut last, mut at) = (NONE, Turned::new(BASE.map(R::from)));
        for step in self.mechanism.steps {
            if step.parent != last {
                // Again, from the base: there is no memory for frames, and few branch off far from it.
                at = Turned::new(BASE.map(R::from));
                for step in way(self.mechanism, step.parent as usize) {
                    at = at.placed(step).joined(step, &mut turns);
                }
            }
            at = at.placed(step).joined(step, &mut turns);
            last = step.link;
            let pose = at.pose(&step.planned.own);
            for index in found.of(step.link as usize) {
                if let (Some(&(link, point)), Some(place)) =
                    (self.points.get(index), self.places.get_mut(index))
                    && link == step.link as usize
                {
                    *place = pose.transform_point(point);
                }
            }
        }
        Some(())
    }
}

//! One configuration of floats by the [plan](super::plan): what `f32` and `f64` compute instead of
//! the products of the book. A frame is kept nowhere: what branches off is turned back from the
//! pose that has been written.

use super::jacobians::Frame;
use super::job::{Found, Point};
use super::joint::JointKind;
use super::step::{Alignment, Factor, Moves, NONE, ORDER, SIGNS, Step, Way};
use super::tree::Mechanism;
use super::values::half_turn;
use dq8::Real;
use dq8::geometry::Twist;
use dq8::internal::{Number, Quick};
use dq8::scalar::{DualQuat, Quat, vector};
use dq8_simd::{Float, Lanes, Portable, Unfused};

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

/// What a [`Mechanism`] asks of floats, by name: where a number is any `Real`, a function over
/// [`Number`] cannot be named, but what it is to be called with can.
macro_rules! quick {
    ($($name:ident { $($field:ident: $type:ty),+ } -> $output:ty;)*) => {$(
        pub(crate) struct $name<'s, R> {
            pub(crate) mechanism: &'s Mechanism<'s, R>,
            pub(crate) values: &'s [R],
            $(pub(crate) $field: $type),+
        }

        impl<R: Real> Quick<R> for $name<'_, R> {
            type Output = $output;

            #[inline]
            fn compute(self) -> Option<$output>
            where
                R: Number,
            {
                Some(self.run())
            }
        }
    )*};
}
quick! {
    LinkPoses { poses: &'s mut [DualQuat<R>] } -> ();
    LinkPose { link: usize } -> DualQuat<R>;
    LinkJacobian { link: usize, frame: Frame, columns: &'s mut [Twist<R>] } -> DualQuat<R>;
    LinkPoints { points: &'s [Point<R>], places: &'s mut [[R; 3]] } -> ();
}

/// For any value: NaN where an angle is too far for lanes.
impl<R: Real + Number> LinkPoses<'_, R> {
    #[inline(always)]
    fn run(self) {
        let mut turns = Turns::new(self.values);
        turns.begin(self.mechanism.steps.first());
        let base = Turned::base();
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
    }
}

impl<R: Real + Number> LinkPose<'_, R> {
    #[inline(always)]
    fn run(self) -> DualQuat<R> {
        let mut turns = Turns::new(self.values);
        turns.begin(way(self.mechanism, self.link).next());
        let (mut at, mut own) = (Turned::base(), &Factor::ONE);
        for step in way(self.mechanism, self.link) {
            at = at.placed(step).joined(step, &mut turns);
            own = &step.planned.own;
        }
        at.pose(own)
    }
}

impl<R: Real + Number> LinkJacobian<'_, R> {
    #[inline(always)]
    fn run(self) -> DualQuat<R> {
        self.columns.fill(Twist::from_array([R::ZERO; 6]));
        let mut turns = Turns::new(self.values);
        turns.begin(way(self.mechanism, self.link).next());
        let (mut at, mut own) = (Turned::base(), &Factor::ONE);
        for step in way(self.mechanism, self.link) {
            let before = at.placed(step);
            at = before.joined(step, &mut turns);
            own = &step.planned.own;
            let columns = self.columns.get_mut(step.rate as usize..).unwrap_or_default();
            let frames = [before, at].map(|frame| DualQuat::from_array(frame.to_array()));
            for (index, column) in columns.iter_mut().take(step.kind.rates()).enumerate() {
                // What others mimic is moved by all of them.
                *column = *column + step.screw(index, frames, self.values);
            }
        }
        let pose = at.pose(own);
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
        pose
    }
}

impl<R: Real + Number> LinkPoints<'_, R> {
    #[inline(always)]
    fn run(self) {
        let mut turns = Turns::new(self.values);
        turns.begin(self.mechanism.steps.first());
        let mut found = Found::new(self.points);
        let (mut last, mut at) = (NONE, Turned::base());
        for step in self.mechanism.steps {
            if step.parent != last {
                // Again, from the base: there is no memory for frames, and few branch off far from
                // it.
                at = Turned::base();
                for step in way(self.mechanism, step.parent as usize) {
                    at = at.placed(step).joined(step, &mut turns);
                }
            }
            at = at.placed(step).joined(step, &mut turns);
            last = step.link;
            let some = found.of(step.link as usize);
            if some.is_empty() {
                continue;
            }
            let [a, b, c] = at.pose(&step.planned.own).to_matrix3x4();
            let column = |k: usize| load([a[k], b[k], c[k], R::ZERO]);
            let (across, origin) = ([column(0), column(1), column(2)], column(3));
            for index in some {
                if let (Some(&(link, [x, y, z])), Some(place)) =
                    (self.points.get(index), self.places.get_mut(index))
                    && link == step.link as usize
                {
                    let at = across[2] * splat(z) + origin;
                    let at = across[0] * splat(x) + (across[1] * splat(y) + at);
                    [place[0], place[1], place[2], _] = at.to_array();
                }
            }
        }
    }
}

impl<R: Real> Step<R> {
    /// The spatial twist of the link for a rate of one of the joint alone, number `index`, from the
    /// turned frames of the joint and of the link. Where a hinge is, is known also where its angle
    /// is too far.
    #[inline(always)]
    fn screw(&self, index: usize, [before, after]: [DualQuat<R>; 2], values: &[R]) -> Twist<R> {
        let (own, zero) = (self.planned.own.quaternion(), [R::ZERO; 3]);
        let axis = self.planned.axis.vector;
        let slide = |along| Twist { angular: zero, linear: along };
        let hinge = |angular, at| Twist { angular, linear: vector::cross(at, angular) };
        let screw = match self.kind {
            JointKind::Planar { .. } => {
                let directions = self.plane.map(|direction| own.rotate(direction));
                if let Some(&direction) = directions.get(index) {
                    slide(before.transform_vector(direction))
                } else {
                    let [x, y, _] = Self::numbers(self.value, values);
                    let [first, second] = directions;
                    let at = vector::add(vector::scale(first, x), vector::scale(second, y));
                    hinge(before.transform_vector(axis), before.transform_point(at))
                }
            }
            JointKind::Floating => {
                let mut unit = zero;
                unit[index % 3] = R::ONE;
                let axis = after.transform_vector(own.rotate(unit));
                if index < 3 { hinge(axis, after.translation()) } else { slide(axis) }
            }
            kind => {
                let axis = before.transform_vector(axis);
                match kind {
                    JointKind::Prismatic { .. } => slide(axis),
                    JointKind::Screw { pitch, .. } => {
                        let Twist { angular, linear } = hinge(axis, before.translation());
                        Twist { angular, linear: vector::add(linear, vector::scale(axis, pitch)) }
                    }
                    _ => hinge(axis, before.translation()),
                }
            }
        };
        if self.mimics { screw.scale(self.multiplier) } else { screw }
    }
}

// The frames of one configuration, turned parallel to the base: four lanes hold a quaternion, p or
// q of the motion p + εq.
//
// Nothing is fused: the bits are the same on all targets.

/// A quaternion.
pub(crate) type Four<R> = <R as Float>::Half<Unfused<Portable>>;

#[inline(always)]
pub(crate) fn splat<R: Float>(number: R) -> Four<R> {
    Lanes::splat(LEVEL, number)
}

#[inline(always)]
pub(crate) fn load<R: Float>(numbers: [R; 4]) -> Four<R> {
    Lanes::load(LEVEL, &numbers)
}

/// x e_K but for its signs.
#[inline(always)]
fn ordered<const K: usize, R: Float>(x: Four<R>) -> Four<R> {
    let (x, [a, b, c, d]) = (x.to_array(), ORDER[K]);
    load([x[a], x[b], x[c], x[d]])
}

/// What a number along an axis multiplies [`ordered`] numbers with.
#[inline(always)]
fn row<const K: usize, R: Float>(number: R) -> Four<R> {
    splat::<R>(number) * load(SIGNS[K].map(R::from))
}

/// What a vector along no axis multiplies them with.
#[inline(always)]
fn rows<R: Float>([x, y, z]: [R; 3]) -> [Four<R>; 3] {
    [row::<0, R>(x), row::<1, R>(y), row::<2, R>(z)]
}

/// x (v + w)
#[inline(always)]
fn product<R: Float>(x: Four<R>, [i, j, k]: [Four<R>; 3], w: Four<R>) -> Four<R> {
    (x * w + ordered::<0, R>(x) * i) + (ordered::<1, R>(x) * j + ordered::<2, R>(x) * k)
}

/// The turned frame of a link.
#[derive(Clone, Copy)]
pub(crate) struct Turned<R: Float> {
    p: Four<R>,
    q: Four<R>,
}

impl<R: Real + Number> Turned<R> {
    #[inline(always)]
    pub(crate) fn base() -> Self {
        Self::new([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0].map(R::from))
    }

    #[inline(always)]
    fn new([x, y, z, w, qx, qy, qz, qw]: [R; 8]) -> Self {
        Self { p: load([x, y, z, w]), q: load([qx, qy, qz, qw]) }
    }

    #[inline(always)]
    pub(crate) fn to_array(self) -> [R; 8] {
        let ([x, y, z, w], [qx, qy, qz, qw]) = (self.p.to_array(), self.q.to_array());
        [x, y, z, w, qx, qy, qz, qw]
    }

    /// Moved by a vector in its own axes, of which half is given: q + p h.
    #[inline(always)]
    fn moved(self, along: Alignment, half: [R; 3]) -> Self {
        let (p, [x, y, z]) = (self.p, half);
        let added = match along {
            Alignment::None => return self,
            Alignment::X => ordered::<0, R>(p) * row::<0, R>(x),
            Alignment::Y => ordered::<1, R>(p) * row::<1, R>(y),
            Alignment::Z => ordered::<2, R>(p) * row::<2, R>(z),
            Alignment::Any => {
                let [x, y, z] = rows(half);
                ordered::<0, R>(p) * x + ordered::<1, R>(p) * y + ordered::<2, R>(p) * z
            }
        };
        Self { p, q: self.q + added }
    }

    /// Turned by the unit quaternion v + w.
    #[inline(always)]
    fn turned(self, about: Alignment, v: [R; 3], w: R) -> Self {
        let [x, y, z] = v;
        match about {
            Alignment::None => self,
            Alignment::X => self.about::<0>(x, w),
            Alignment::Y => self.about::<1>(y, w),
            Alignment::Z => self.about::<2>(z, w),
            Alignment::Any => {
                let (rows, w) = (rows(v), splat(w));
                Self { p: product::<R>(self.p, rows, w), q: product::<R>(self.q, rows, w) }
            }
        }
    }

    #[inline(always)]
    fn about<const K: usize>(self, along: R, w: R) -> Self {
        let Self { p, q } = self;
        let (row, w) = (row::<K, R>(along), splat(w));
        Self { p: p * w + ordered::<K, R>(p) * row, q: q * w + ordered::<K, R>(q) * row }
    }

    /// The pose of the link, whose own frame this is turned to.
    #[inline(always)]
    pub(crate) fn pose(self, own: &Factor<R>) -> DualQuat<R> {
        let own = self.turned(own.v.along, own.v.vector, own.w);
        DualQuat::from_array(own.to_array())
    }

    /// And back.
    #[inline(always)]
    pub(crate) fn of_pose(pose: &DualQuat<R>, own: &Factor<R>) -> Self {
        Self::new(pose.to_array()).turned(own.v.along, own.v.vector.map(|c| -c), own.w)
    }

    /// From the frame of the parent to that of the joint.
    #[inline(always)]
    pub(crate) fn placed(self, step: &Step<R>) -> Self {
        let half_offset = &step.planned.half_offset;
        self.moved(half_offset.along, half_offset.vector)
    }

    /// From the frame of the joint to that of the link.
    #[inline(always)]
    pub(crate) fn joined(self, step: &Step<R>, turns: &mut Turns<'_, R>) -> Self {
        let (at, [x, y, z]) = (self, step.planned.axis.vector);
        let mut turn = || turns.half_turn(step.value as usize);
        match step.planned.moves {
            Moves::Not => at,
            Moves::AboutX => {
                let [cos, sin] = turn();
                at.about::<0>(x * sin, cos)
            }
            Moves::AboutY => {
                let [cos, sin] = turn();
                at.about::<1>(y * sin, cos)
            }
            Moves::AboutZ => {
                let [cos, sin] = turn();
                at.about::<2>(z * sin, cos)
            }
            Moves::AboutAny => {
                let [cos, sin] = turn();
                at.turned(Alignment::Any, [x * sin, y * sin, z * sin], cos)
            }
            // By value: what is in memory here would be there for all.
            Moves::Otherwise => Self::new(otherwise(at.to_array(), step, turns.values)),
        }
    }

    /// Moved along the axis of a joint.
    fn slid(self, step: &Step<R>, length: R) -> Self {
        let Way { along, vector } = step.planned.axis;
        self.moved(along, vector::scale(vector, length * R::HALF))
    }

    /// Turned about it.
    fn hinged(self, step: &Step<R>, angle: R) -> Self {
        let Way { along, vector } = step.planned.axis;
        let [cos, sin] = half_turn_of(angle);
        self.turned(along, vector::scale(vector, sin), cos)
    }
}

/// What most joints of a robot are not. Out of line: its constants would take the registers of what
/// is in it.
#[cold]
#[inline(never)]
fn otherwise<R: Real + Number>(at: [R; 8], step: &Step<R>, values: &[R]) -> [R; 8] {
    let (at, own) = (Turned::new(at), step.planned.own.quaternion());
    let moved = |[x, y, z]: [R; 3]| {
        at.moved(Alignment::Any, own.rotate([x * R::HALF, y * R::HALF, z * R::HALF]))
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
            moved([tx, ty, tz]).turned(Alignment::Any, [x, y, z], w)
        }
    };
    at.to_array()
}

// Cosines and sines of one configuration: they come first, as many at a time as there are lanes
// for.

pub(crate) const LEVEL: Unfused<Portable> = Unfused(Portable);
/// Eight angles.
type Eight<R> = <R as Float>::Packed<Unfused<Portable>>;
/// What a register holds.
type Native<R> = <R as Float>::Lanes<Unfused<Portable>>;

/// The values, and cosine and sine of half of some that follow each other.
pub(crate) struct Turns<'v, R> {
    pub(crate) values: &'v [R],
    first: usize,
    cos: [R; 8],
    sin: [R; 8],
}

impl<'v, R: Real + Number> Turns<'v, R> {
    /// So many at a time. Where lanes hold one number, a loop that keeps its constants in
    /// registers, over fewer that may not be needed.
    const SOME: usize = if Native::<R>::LANES == 1 { 4 } else { 8 };

    #[inline(always)]
    pub(crate) fn new(values: &'v [R]) -> Self {
        Self { values, first: 0, cos: [R::NAN; 8], sin: [R::NAN; 8] }
    }

    /// From the values of a step on, at once: nothing else can be computed before. Where they are:
    /// a copy of what has just been written in fours that overlap would wait for the memory.
    #[inline(always)]
    pub(crate) fn begin(&mut self, step: Option<&Step<R>>) {
        let index = step.map_or(0, |step| step.value as usize);
        if Native::<R>::LANES == 1 {
            self.compute_others(index);
        } else {
            self.compute(index);
        }
    }

    /// Cosine and sine of half of value number `index`.
    #[inline(always)]
    pub(crate) fn half_turn(&mut self, index: usize) -> [R; 2] {
        if index.wrapping_sub(self.first) >= Self::SOME {
            self.compute_others(index);
        }
        let at = index.wrapping_sub(self.first) % Self::SOME;
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
            let rest = self.values.get(index..).unwrap_or_default();
            let turns = self.cos.iter_mut().zip(&mut self.sin).take(Self::SOME);
            for ((cos, sin), &value) in turns.zip(rest) {
                [*cos, *sin] = half_turn_of(value);
            }
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
pub(crate) fn half_turn_of<R: Real + Number>(angle: R) -> [R; 2] {
    let angle = Native::<R>::splat(LEVEL, angle);
    half_turn(angle * angle.constant(0.5)).map(|of| of.to_array().as_ref()[0])
}

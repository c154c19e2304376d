//! One configuration of floats by the [plan](super::plan): four lanes hold a quaternion, p or q of the motion p + εq of a
//! turned frame. What `f32` and `f64` compute instead of the products of the book.
//!
//! Nothing is fused: the bits are the same on all targets.

use super::frame::Frame;
use super::joint::JointKind;
use super::plan::{Factor, Motion, ORDER, Planned};
use super::step::{Alignment, NONE, Step};
use super::tree::Mechanism;
use super::values::half_turn;
use dq8::{Kernel, Real};
use dq8::geometry::Twist;
use dq8::scalar::{DualQuat, Quat, vector};
use dq8::seams::{Number, Quick};
use dq8_simd::{Float, Lanes, Level, Portable, Unfused};

/// x e_K but for its signs.
#[inline(always)]
fn ordered<const K: usize, R: Float, Q: Lanes<Real = R, Array = [R; 4]>>(x: Q) -> Q {
    let (level, x, [a, b, c, d]) = (x.level(), x.to_array(), ORDER[K]);
    Q::load(level, &[x[a], x[b], x[c], x[d]])
}

/// The turned frame of a link.
#[derive(Clone, Copy)]
struct Turned<Q> {
    p: Q,
    q: Q,
}

impl<R: Float, Q: Lanes<Real = R, Array = [R; 4]>> Turned<Q> {
    #[inline(always)]
    fn base(level: Q::Level) -> Self {
        let zero = R::default();
        Self::load(level, [zero, zero, zero, R::from(1.0), zero, zero, zero, zero])
    }

    #[inline(always)]
    fn load(level: Q::Level, [x, y, z, w, qx, qy, qz, qw]: [R; 8]) -> Self {
        Self { p: Q::load(level, &[x, y, z, w]), q: Q::load(level, &[qx, qy, qz, qw]) }
    }

    #[inline(always)]
    fn to_array(self) -> [R; 8] {
        let ([x, y, z, w], [qx, qy, qz, qw]) = (self.p.to_array(), self.q.to_array());
        [x, y, z, w, qx, qy, qz, qw]
    }

    /// Moved by a vector in its own axes, of which half is given: q + p h.
    #[inline(always)]
    fn moved(self, along: Alignment, half: Q) -> Self {
        let p = self.p;
        let add = match along {
            Alignment::None => return self,
            Alignment::X => ordered::<0, R, Q>(p) * half,
            Alignment::Y => ordered::<1, R, Q>(p) * half,
            Alignment::Z => ordered::<2, R, Q>(p) * half,
            Alignment::Any => {
                let [x, y, z] = rows(half);
                ordered::<0, R, Q>(p) * x + ordered::<1, R, Q>(p) * y + ordered::<2, R, Q>(p) * z
            }
        };
        Self { p, q: self.q + add }
    }

    /// Turned by a unit quaternion v + w.
    #[inline(always)]
    fn turned(self, about: Alignment, row: Q, w: Q) -> Self {
        match about {
            Alignment::None => self,
            Alignment::X => self.about::<0>(row, w),
            Alignment::Y => self.about::<1>(row, w),
            Alignment::Z => self.about::<2>(row, w),
            Alignment::Any => {
                let row = rows(row);
                Self { p: product(self.p, row, w), q: product(self.q, row, w) }
            }
        }
    }

    /// Turned about an axis of the base.
    #[inline(always)]
    fn about<const K: usize>(self, row: Q, w: Q) -> Self {
        let Self { p, q } = self;
        Self {
            p: p * w + ordered::<K, R, Q>(p) * row,
            q: q * w + ordered::<K, R, Q>(q) * row,
        }
    }

    /// From the turned frame to the link's own.
    #[inline(always)]
    fn own(self, own: &Factor<R>) -> Self {
        let level = self.p.level();
        self.turned(own.along, Q::load(level, &own.row), Q::splat(level, own.w))
    }
}

/// a (v + w)
#[inline(always)]
fn product<R: Float, Q: Lanes<Real = R, Array = [R; 4]>>(a: Q, [x, y, z]: [Q; 3], w: Q) -> Q {
    let first = a * w + ordered::<0, R, Q>(a) * x;
    first + (ordered::<1, R, Q>(a) * y + ordered::<2, R, Q>(a) * z)
}

/// What the numbers of a vector are multiplied with, each with its signs.
#[inline(always)]
fn rows<R: Float, Q: Lanes<Real = R, Array = [R; 4]>>(vector: Q) -> [Q; 3] {
    let (level, [x, y, z, _]) = (vector.level(), vector.to_array());
    let one = R::from(1.0);
    [
        Q::splat(level, x) * Q::load(level, &[one, one, -one, -one]),
        Q::splat(level, y) * Q::load(level, &[-one, one, one, -one]),
        Q::splat(level, z) * Q::load(level, &[one, -one, one, -one]),
    ]
}

/// The values, and cosines and sines of half of some that follow each other.
struct Turns<'v, R> {
    values: &'v [R],
    first: usize,
    cos: [R; 8],
    sin: [R; 8],
}

impl<'v, R: Real + Number> Turns<'v, R> {
    /// From the values of a step on, at once: nothing else can be computed before.
    #[inline(always)]
    fn new<V: Level>(level: V, values: &'v [R], step: Option<&Step<R>>) -> Self {
        let mut turns = Self { values, first: 0, cos: [R::ZERO; 8], sin: [R::ZERO; 8] };
        turns.turn(level, step.map_or(0, |step| step.value as usize));
        turns
    }

    /// Cosine and sine of half of value number `index`.
    #[inline(always)]
    fn half_turn<V: Level>(&mut self, level: V, index: usize) -> [R; 2] {
        // Where lanes hold one number, one at a time.
        let some = if R::Lanes::<V>::LANES == 1 { 1 } else { 8 };
        if index.wrapping_sub(self.first) >= some {
            apart(
                level,
                #[inline(always)]
                || self.turn(level, index),
            );
        }
        let at = index.wrapping_sub(self.first) % some;
        [self.cos[at], self.sin[at]]
    }

    /// Those of this value and as many of the next ones as there are.
    #[inline(always)]
    fn turn<V: Level>(&mut self, level: V, index: usize) {
        if R::Lanes::<V>::LANES == 1 {
            self.first = index;
            let value = self.values.get(index).copied().unwrap_or(R::NAN);
            [self.cos[0], self.sin[0]] = half_turn_of(level, value);
            return;
        }
        self.first = index.min(self.values.len().saturating_sub(4));
        let rest = self.values.get(self.first..).unwrap_or_default();
        // The last four again, rather than less than four.
        let second = rest.len().saturating_sub(4).min(4);
        let high = rest.get(second..).and_then(<[R]>::first_chunk::<4>);
        let some = match (rest.first_chunk::<4>(), high) {
            (Some(&[a, b, c, d]), Some(&[e, f, g, h])) => {
                R::Packed::<V>::load(level, &[a, b, c, d, e, f, g, h])
            }
            _ => R::Packed::<V>::load_partial(level, rest, R::ZERO),
        };
        let [cos, sin] = half_turn(some * some.constant(0.5));
        for (to, from) in [(&mut self.cos, cos.to_array()), (&mut self.sin, sin.to_array())] {
            to[..4].copy_from_slice(&from[..4]);
            to[second..][..4].copy_from_slice(&from[4..]);
        }
    }
}

/// Cosine and sine of half of one value.
#[inline(always)]
fn half_turn_of<R: Real + Number, V: Level>(level: V, value: R) -> [R; 2] {
    let value = R::Lanes::<V>::splat(level, value);
    half_turn(value * value.constant(0.5)).map(|of| of.to_array().as_ref()[0])
}

/// Out of line: what is rare, whose constants would take the registers of what is not.
#[cold]
#[inline(never)]
fn apart<V: Level, T>(level: V, kernel: impl FnOnce() -> T) -> T {
    level.run(kernel)
}

#[inline(always)]
fn loaded<R: Float, V: Level>(level: V, [x, y, z]: [R; 3]) -> R::Half<V> {
    R::Half::<V>::load(level, &[x, y, z, R::default()])
}

/// From the turned frame of the parent to that of the link.
#[inline(always)]
fn step<R: Real + Number, V: Level>(
    level: V,
    parent: Turned<R::Half<V>>,
    step: &Step<R>,
    turns: &mut Turns<'_, R>,
) -> Turned<R::Half<V>> {
    let planned = &step.planned;
    let half = R::Half::<V>::load(level, &planned.half_offset.row);
    let at = parent.moved(planned.half_offset.along, half);
    macro_rules! turn {
        () => {{
            let [cos, sin] = turns.half_turn(level, step.value as usize);
            let sin = R::Half::<V>::splat(level, sin);
            let row = R::Half::<V>::load(level, &planned.axis.row) * sin;
            (row, R::Half::<V>::splat(level, cos))
        }};
    }
    match planned.motion {
        Motion::Fixed => at,
        Motion::AboutX => {
            let (row, cos) = turn!();
            at.about::<0>(row, cos)
        }
        Motion::AboutY => {
            let (row, cos) = turn!();
            at.about::<1>(row, cos)
        }
        Motion::AboutZ => {
            let (row, cos) = turn!();
            at.about::<2>(row, cos)
        }
        Motion::AboutAny => {
            let (row, cos) = turn!();
            at.turned(Alignment::Any, row, cos)
        }
        Motion::Other => {
            // By value: what is kept in memory here would be there for all.
            let at = at.to_array();
            let values = turns.values;
            let at = apart(
                level,
                #[inline(always)]
                move || other(level, Turned::load(level, at), step, values).to_array(),
            );
            Turned::load(level, at)
        }
    }
}

/// Turned about the axis of a joint.
#[inline(always)]
fn hinge<R: Real + Number, V: Level>(
    level: V,
    at: Turned<R::Half<V>>,
    axis: &Factor<R>,
    angle: R,
) -> Turned<R::Half<V>> {
    let [cos, sin] = half_turn_of(level, angle);
    let sin = R::Half::<V>::load(level, &axis.row) * R::Half::<V>::splat(level, sin);
    at.turned(axis.along, sin, R::Half::<V>::splat(level, cos))
}

/// Moved along an axis.
#[inline(always)]
fn slide<R: Real + Number, V: Level>(
    level: V,
    at: Turned<R::Half<V>>,
    axis: &Factor<R>,
    length: R,
) -> Turned<R::Half<V>> {
    let half = R::Half::<V>::splat(level, length * R::HALF);
    at.moved(axis.along, R::Half::<V>::load(level, &axis.row) * half)
}

/// Joints that most robots have none of.
#[inline(always)]
fn other<R: Real + Number, V: Level>(
    level: V,
    at: Turned<R::Half<V>>,
    step: &Step<R>,
    values: &[R],
) -> Turned<R::Half<V>> {
    let Planned { own, axis, .. } = &step.planned;
    let own = own.quaternion();
    match step.kind {
        JointKind::Fixed => at,
        JointKind::Revolute { .. } => hinge(level, at, axis, step.single(values)),
        JointKind::Prismatic { .. } => slide(level, at, axis, step.single(values)),
        JointKind::Screw { pitch, .. } => {
            let angle = step.single(values);
            hinge(level, slide(level, at, axis, angle * pitch), axis, angle)
        }
        JointKind::Planar { .. } => {
            let [x, y, angle] = Step::numbers(step.value, values);
            let [first, second] = step.plane;
            let slide = vector::add(vector::scale(first, x), vector::scale(second, y));
            let slide = own.rotate(vector::scale(slide, R::HALF));
            let at = at.moved(Alignment::Any, loaded::<R, V>(level, slide));
            hinge(level, at, axis, angle)
        }
        JointKind::Floating => {
            let [x, y, z, w, tx, ty, tz] = Step::numbers(step.value, values);
            let turn = own * Quat::from_xyzw(x, y, z, w).normalize() * own.conjugate();
            let [x, y, z, w] = turn.to_array();
            let slide = own.rotate(vector::scale([tx, ty, tz], R::HALF));
            let at = at.moved(Alignment::Any, loaded::<R, V>(level, slide));
            let turn = loaded::<R, V>(level, [x, y, z]);
            at.turned(Alignment::Any, turn, R::Half::<V>::splat(level, w))
        }
    }
}

/// The steps from the base to a link.
#[inline(always)]
fn way<'s, R: Copy>(
    mechanism: &Mechanism<'s, R>,
    link: usize,
) -> impl Iterator<Item = &'s Step<R>> {
    let end = mechanism.steps.get(link).map_or(NONE, |step| step.position) as usize;
    // What a step carries follows it.
    let steps = mechanism.steps.get(..=end).unwrap_or_default().iter().enumerate();
    // What a step carries follows it.
    steps.filter(move |(position, step)| end - position < step.size as usize).map(|(_, step)| step)
}

/// Without fused multiply-add, with the best instructions for that.
#[inline(always)]
fn unfused<K: Kernel>(kernel: K) -> K::Output {
    #[cfg(target_arch = "x86_64")]
    if let Some(level) = dq8_simd::x86_64::Avx2::detect() {
        return level.run(
            #[inline(always)]
            || kernel.run(Unfused(level)),
        );
    }
    kernel.run(Unfused(Portable))
}

/// What floats compute.
macro_rules! quick {
    ($($name:ident -> $output:ty;)*) => {$(
        impl<R: Real> Quick<R> for $name<'_, R> {
            type Output = $output;
            #[inline(always)]
            fn compute(self) -> Option<$output>
            where
                R: Number,
            {
                Some(unfused(self))
            }
        }
    )*};
}
quick! { LinkPoses -> (); LinkPose -> DualQuat<R>; LinkJacobian -> DualQuat<R>; }

/// [`Mechanism::link_poses`], for any value: NaN where an angle is too far for lanes.
pub(crate) struct LinkPoses<'s, R> {
    pub(crate) mechanism: &'s Mechanism<'s, R>,
    pub(crate) values: &'s [R],
    pub(crate) poses: &'s mut [DualQuat<R>],
}

impl<R: Real + Number> Kernel for LinkPoses<'_, R> {
    type Output = ();

    #[inline(always)]
    fn run<V: Level>(self, level: V) {
        let base = Turned::<R::Half<V>>::base(level);
        let mut turns = Turns::new(level, self.values, self.mechanism.steps.first());
        let (mut last, mut at) = (NONE, base);
        for step in self.mechanism.steps {
            // The children of a link but the first come after what the others carry. A frame that they need is turned
            // from the pose that has been written: to keep it costs all others more.
            if step.parent != last {
                at = base;
                let link = step.parent as usize;
                if let (Some(pose), Some(parent)) = (self.poses.get(link), self.mechanism.step(link)) {
                    let own = &parent.planned.own;
                    let back = -R::Half::<V>::load(level, &own.row);
                    let w = R::Half::<V>::splat(level, own.w);
                    at = Turned::load(level, pose.to_array()).turned(own.along, back, w);
                }
            }
            at = self::step(level, at, step, &mut turns);
            let pose = at.own(&step.planned.own);
            if let Some(slot) = self.poses.get_mut(step.link as usize) {
                *slot = DualQuat::from_array(pose.to_array());
            }
            last = step.link;
        }
    }
}

/// [`Mechanism::link_pose`].
pub(crate) struct LinkPose<'s, R> {
    pub(crate) mechanism: &'s Mechanism<'s, R>,
    pub(crate) values: &'s [R],
    pub(crate) link: usize,
}

impl<R: Real + Number> Kernel for LinkPose<'_, R> {
    type Output = DualQuat<R>;

    #[inline(always)]
    fn run<V: Level>(self, level: V) -> DualQuat<R> {
        let mut at = Turned::<R::Half<V>>::base(level);
        let mut turns = Turns::new(level, self.values, way(self.mechanism, self.link).next());
        let mut own = &Factor::ONE;
        for step in way(self.mechanism, self.link) {
            at = self::step(level, at, step, &mut turns);
            own = &step.planned.own;
        }
        DualQuat::from_array(at.own(own).to_array())
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

impl<R: Real + Number> Kernel for LinkJacobian<'_, R> {
    type Output = DualQuat<R>;

    #[inline(always)]
    fn run<V: Level>(self, level: V) -> DualQuat<R> {
        self.columns.fill(Twist::from_array([R::ZERO; 6]));
        let mut at = Turned::<R::Half<V>>::base(level);
        let mut turns = Turns::new(level, self.values, way(self.mechanism, self.link).next());
        let mut pose = DualQuat::IDENTITY;
        for step in way(self.mechanism, self.link) {
            at = self::step(level, at, step, &mut turns);
            pose = DualQuat::from_array(at.own(&step.planned.own).to_array());
            let columns = self.columns.get_mut(step.rate as usize..).unwrap_or_default();
            for (column, own) in columns.iter_mut().zip(step.own_twists(self.values)) {
                let Some(own) = own else { break };
                // What others mimic is moved by all of them.
                *column = *column + pose.adjoint(own);
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
        pose
    }
}

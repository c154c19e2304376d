//! One configuration of `f32` or `f64`, by the plan of [`step`](super::step): base frames in place
//! of the general products of `single.rs`.
//!
//! ```text
//! for each step:
//!     frame ← frame of the parent          the last, or from the written pose
//!     frame ← frame moved by half_offset   to the joint
//!     frame ← frame moved by the joint     to the link
//!     pose of the link ← frame · link_rotation
//! ```
//!
//! Frames are not stored. Where the tree branches, the frame of the parent is recovered from its
//! stored pose. Four lanes hold a quaternion, p or q of the motion p + εq. Nothing is fused, so
//! the bits are the same on all targets.

use super::jacobians::Frame;
use super::job::{Point, PointsByLink};
use super::joint::JointKind;
use super::step::{
    Alignment, AxisVector, Factor, JointFrame, JointScrews, Moves, NONE, ORDER, SIGNS, Step,
};
use super::tree::Mechanism;
use super::values::checked_cos_sin;
use dq8::Real;
use dq8::geometry::Twist;
use dq8::internal::{Number, Quick};
use dq8::scalar::{DualQuat, Quat, vector};
use dq8_simd::{Float, Lanes, Portable, Unfused};

/// The steps from the base to a link.
#[inline(always)]
fn path<'s, R: Copy>(
    mechanism: &Mechanism<'s, R>,
    link: usize,
) -> impl Iterator<Item = &'s Step<R>> {
    let end = mechanism.steps.get(link).map_or(NONE, |step| step.position) as usize;
    // There are no steps to the base, which is no link.
    let steps = mechanism.steps.get(..=end).unwrap_or_default().iter().enumerate();
    // A step is followed by all that it carries.
    steps.filter(move |(position, step)| end - position < step.size as usize).map(|(_, step)| step)
}

/// The calls of a [`Mechanism`] that floats answer by the plan, as structs of their arguments. Code
/// for any `Real` cannot name a function that needs a [`Number`], but it can hand over such a
/// struct.
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

impl<R: Real + Number> LinkPoses<'_, R> {
    #[inline(always)]
    fn run(self) {
        let mut angles = HalfAngles::new(self.values);
        angles.begin(self.mechanism.steps.first());
        let base = BaseFrame::base();
        let (mut last, mut at) = (NONE, base);
        for step in self.mechanism.steps {
            // Between a parent and its second child lie the steps that the first one carries.
            if step.parent != last {
                let link = step.parent as usize;
                at = match (self.poses.get(link), self.mechanism.step(link)) {
                    (Some(pose), Some(parent)) => {
                        BaseFrame::of_pose(pose, &parent.plan.link_rotation)
                    }
                    _ => base,
                };
            }
            at = at.joint_frame(step).planned_link_frame(step, &mut angles);
            last = step.link;
            if let Some(slot) = self.poses.get_mut(step.link as usize) {
                *slot = at.pose(&step.plan.link_rotation);
            }
        }
    }
}

impl<R: Real + Number> LinkPose<'_, R> {
    #[inline(always)]
    fn run(self) -> DualQuat<R> {
        let mut angles = HalfAngles::new(self.values);
        angles.begin(path(self.mechanism, self.link).next());
        let (mut at, mut own) = (BaseFrame::base(), &Factor::ONE);
        for step in path(self.mechanism, self.link) {
            at = at.joint_frame(step).planned_link_frame(step, &mut angles);
            own = &step.plan.link_rotation;
        }
        at.pose(own)
    }
}

impl<R: Real + Number> LinkJacobian<'_, R> {
    #[inline(always)]
    fn run(self) -> DualQuat<R> {
        self.columns.fill(Twist::from_array([R::ZERO; 6]));
        let mut angles = HalfAngles::new(self.values);
        angles.begin(path(self.mechanism, self.link).next());
        let (mut at, mut own) = (BaseFrame::base(), &Factor::ONE);
        for step in path(self.mechanism, self.link) {
            let before = at.joint_frame(step);
            at = before.planned_link_frame(step, &mut angles);
            own = &step.plan.link_rotation;
            let columns = self.columns.get_mut(step.rate as usize..).unwrap_or_default();
            let [joint, link] = [before, at].map(|frame| DualQuat::from_array(frame.to_array()));
            let frames = BaseFrames { joint, link, values: self.values };
            for (index, column) in columns.iter_mut().take(step.kind.rates()).enumerate() {
                // The columns of joints that mimic the same one are added up.
                *column = *column + frames.screw(step, index);
            }
        }
        let pose = at.pose(own);
        let (back, origin) = (pose.conjugate(), pose.translation());
        for column in self.columns {
            // The column of a joint that does not carry the link stays zero in every frame.
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
        let mut angles = HalfAngles::new(self.values);
        angles.begin(self.mechanism.steps.first());
        let mut found = PointsByLink::new(self.points);
        let (mut last, mut at) = (NONE, BaseFrame::base());
        for step in self.mechanism.steps {
            if step.parent != last {
                // No poses are written here, so the frame is computed again from the base. Few
                // robots branch far from it.
                at = BaseFrame::base();
                for step in path(self.mechanism, step.parent as usize) {
                    at = at.joint_frame(step).planned_link_frame(step, &mut angles);
                }
            }
            at = at.joint_frame(step).planned_link_frame(step, &mut angles);
            last = step.link;
            let some = found.of(step.link as usize);
            if some.is_empty() {
                continue;
            }
            let [a, b, c] = at.pose(&step.plan.link_rotation).to_matrix3x4();
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

/// The base frames of a joint and of its link, and the values of all joints.
struct BaseFrames<'v, R> {
    joint: DualQuat<R>,
    link: DualQuat<R>,
    values: &'v [R],
}

impl<R: Real> JointScrews<R> for BaseFrames<'_, R> {
    type Number = R;

    #[inline(always)]
    fn number(&self, number: R) -> R {
        number
    }

    #[inline(always)]
    fn axis(&self, step: &Step<R>) -> [R; 3] {
        self.joint.transform_vector(step.plan.axis.vector)
    }

    #[inline(always)]
    fn plane_axis(&self, step: &Step<R>, index: usize) -> [R; 3] {
        let direction = step.plane.get(index).copied().unwrap_or([R::ZERO; 3]);
        self.joint.transform_vector(step.plan.link_rotation.quaternion().rotate(direction))
    }

    #[inline(always)]
    fn link_axis(&self, step: &Step<R>, index: usize) -> [R; 3] {
        let mut unit = [R::ZERO; 3];
        unit[index % 3] = R::ONE;
        self.link.transform_vector(step.plan.link_rotation.quaternion().rotate(unit))
    }

    #[inline(always)]
    fn hinge(&self, axis: [R; 3]) -> Twist<R> {
        hinge(axis, self.joint.translation())
    }

    #[inline(always)]
    fn thread(&self, axis: [R; 3], pitch: R) -> Twist<R> {
        let Twist { angular, linear } = hinge(axis, self.joint.translation());
        Twist { angular, linear: vector::add(linear, vector::scale(axis, pitch)) }
    }

    /// The axis of a planar joint is known even if its angle is out of range and its link is NaN.
    /// Not inlined, as few robots have such joints: a Jacobian takes 7 % fewer instructions.
    #[inline(never)]
    fn link_hinge(&self, step: &Step<R>, axis: [R; 3]) -> Twist<R> {
        let JointKind::Planar { .. } = step.kind else {
            return hinge(axis, self.link.translation());
        };
        let own = step.plan.link_rotation.quaternion();
        let [x, y] = Step::numbers(step.value, self.values);
        let [first, second] = step.plane.map(|direction| own.rotate(direction));
        let at = vector::add(vector::scale(first, x), vector::scale(second, y));
        hinge(axis, self.joint.transform_point(at))
    }
}

/// Turning about an axis through a point.
#[inline(always)]
fn hinge<R: Real>(axis: [R; 3], point: [R; 3]) -> Twist<R> {
    Twist { angular: axis, linear: vector::cross(point, axis) }
}

/// The lanes of a quaternion.
pub(crate) type Four<R> = <R as Float>::Half<Unfused<Portable>>;

#[inline(always)]
pub(crate) fn splat<R: Float>(number: R) -> Four<R> {
    Lanes::splat(LEVEL, number)
}

#[inline(always)]
pub(crate) fn load<R: Float>(numbers: [R; 4]) -> Four<R> {
    Lanes::load(LEVEL, &numbers)
}

/// The numbers of the product q e_K, without their signs.
#[inline(always)]
fn ordered<const K: usize, R: Float>(x: Four<R>) -> Four<R> {
    let (x, [a, b, c, d]) = (x.to_array(), ORDER[K]);
    load([x[a], x[b], x[c], x[d]])
}

/// The factors of [`ordered`] numbers for a vector on axis K.
#[inline(always)]
fn row<const K: usize, R: Float>(number: R) -> Four<R> {
    splat::<R>(number) * load(SIGNS[K].map(R::from))
}

/// The factors of [`ordered`] numbers, for each axis, for a vector on none.
#[inline(always)]
fn rows<R: Float>([x, y, z]: [R; 3]) -> [Four<R>; 3] {
    [row::<0, R>(x), row::<1, R>(y), row::<2, R>(z)]
}

/// The product q (v + w).
#[inline(always)]
fn product<R: Float>(x: Four<R>, [i, j, k]: [Four<R>; 3], w: Four<R>) -> Four<R> {
    (x * w + ordered::<0, R>(x) * i) + (ordered::<1, R>(x) * j + ordered::<2, R>(x) * k)
}

/// The base frame of a joint or a link: the motion p + εq.
#[derive(Clone, Copy)]
pub(crate) struct BaseFrame<R: Float> {
    p: Four<R>,
    q: Four<R>,
}

impl<R: Real + Number> BaseFrame<R> {
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

    /// The frame moved by a vector in its own axes, of which half, h, is given: q + p h.
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

    /// The frame rotated by the unit quaternion v + w.
    #[inline(always)]
    fn rotated(self, about: Alignment, v: [R; 3], w: R) -> Self {
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

    /// The pose of the link that has this base frame.
    #[inline(always)]
    pub(crate) fn pose(self, own: &Factor<R>) -> DualQuat<R> {
        let own = self.rotated(own.v.along, own.v.vector, own.w);
        DualQuat::from_array(own.to_array())
    }

    /// The base frame of the link that has this pose.
    #[inline(always)]
    pub(crate) fn of_pose(pose: &DualQuat<R>, own: &Factor<R>) -> Self {
        Self::new(pose.to_array()).rotated(own.v.along, own.v.vector.map(|c| -c), own.w)
    }

    /// The frame of the joint on a parent with this frame.
    #[inline(always)]
    pub(crate) fn joint_frame(self, step: &Step<R>) -> Self {
        let half_offset = &step.plan.half_offset;
        self.moved(half_offset.along, half_offset.vector)
    }

    /// The frame of the link behind a joint with this frame.
    #[inline(always)]
    pub(crate) fn planned_link_frame(self, step: &Step<R>, angles: &mut HalfAngles<'_, R>) -> Self {
        let (at, [x, y, z]) = (self, step.plan.axis.vector);
        let mut turn = || angles.half_angle(step.value as usize);
        match step.plan.moves {
            Moves::Fixed => at,
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
                at.rotated(Alignment::Any, [x * sin, y * sin, z * sin], cos)
            }
            // Passed by value: taking the address would force the frame to memory on every path.
            Moves::General => Self::new(general_joint(at.to_array(), step, angles.values)),
        }
    }
}

/// The motion of a joint of any kind. Not inlined: its constants would take the registers of the
/// loop.
#[cold]
#[inline(never)]
fn general_joint<R: Real + Number>(frame: [R; 8], step: &Step<R>, mut values: &[R]) -> [R; 8] {
    BaseFrame::new(frame).link_frame(step, &mut values).to_array()
}

impl<R: Real + Number> JointFrame<R, &[R]> for BaseFrame<R> {
    type Number = R;

    #[inline(always)]
    fn number(self, number: R) -> R {
        number
    }

    #[inline(always)]
    fn numbers<const C: usize>(self, step: &Step<R>, values: &mut &[R]) -> [R; C] {
        Step::numbers(step.value, values)
    }

    #[inline(always)]
    fn value(self, step: &Step<R>, index: usize, values: &mut &[R]) -> R {
        step.number(index, values)
    }

    #[inline(always)]
    fn half_angle(self, angle: R) -> [R; 2] {
        half_angle_of(angle)
    }

    #[inline(always)]
    fn turn(self, step: &Step<R>, [cos, sin]: [R; 2]) -> Self {
        let AxisVector { along, vector } = step.plan.axis;
        self.rotated(along, vector::scale(vector, sin), cos)
    }

    #[inline(always)]
    fn slide(self, step: &Step<R>, distance: R) -> Self {
        let AxisVector { along, vector } = step.plan.axis;
        self.moved(along, vector::scale(vector, distance * R::HALF))
    }

    #[inline(always)]
    fn slide_in_plane(self, step: &Step<R>, distances: [R; 2]) -> Self {
        let [x, y, z] = step.in_plane(distances);
        let half = [x * R::HALF, y * R::HALF, z * R::HALF];
        self.moved(Alignment::Any, step.plan.link_rotation.quaternion().rotate(half))
    }

    #[inline(always)]
    fn float(self, step: &Step<R>, [x, y, z, w, tx, ty, tz]: [R; 7]) -> Self {
        let own = step.plan.link_rotation.quaternion();
        let half = own.rotate([tx * R::HALF, ty * R::HALF, tz * R::HALF]);
        let turn = own * Quat::from_xyzw(x, y, z, w).normalize() * own.conjugate();
        let [x, y, z, w] = turn.to_array();
        self.moved(Alignment::Any, half).rotated(Alignment::Any, [x, y, z], w)
    }
}

pub(crate) const LEVEL: Unfused<Portable> = Unfused(Portable);
/// The lanes of eight angles.
type Eight<R> = <R as Float>::Packed<Unfused<Portable>>;
/// The lanes that a register holds.
type Native<R> = <R as Float>::Lanes<Unfused<Portable>>;

/// The values of a configuration, and cosine and sine of half of eight that follow each other.
pub(crate) struct HalfAngles<'v, R> {
    pub(crate) values: &'v [R],
    first: usize,
    cos: [R; 8],
    sin: [R; 8],
}

impl<'v, R: Real + Number> HalfAngles<'v, R> {
    /// The number of angles computed at once: eight, or four on targets with one lane, where angles
    /// that are not needed cost time.
    const BATCH: usize = if Native::<R>::LANES == 1 { 4 } else { 8 };

    #[inline(always)]
    pub(crate) fn new(values: &'v [R]) -> Self {
        Self { values, first: 0, cos: [R::NAN; 8], sin: [R::NAN; 8] }
    }

    /// Computes the angles from the first value of a step on, before the loop needs them. They are
    /// computed in place: copying numbers that were just written would wait for memory.
    #[inline(always)]
    pub(crate) fn begin(&mut self, step: Option<&Step<R>>) {
        let index = step.map_or(0, |step| step.value as usize);
        if Native::<R>::LANES == 1 {
            self.compute_others(index);
        } else {
            self.compute(index);
        }
    }

    /// Cosine and sine of half of value number `index`, computed with its neighbours if need be.
    #[inline(always)]
    pub(crate) fn half_angle(&mut self, index: usize) -> [R; 2] {
        if index.wrapping_sub(self.first) >= Self::BATCH {
            self.compute_others(index);
        }
        let at = index.wrapping_sub(self.first) % Self::BATCH;
        [self.cos[at], self.sin[at]]
    }

    #[cold]
    #[inline(never)]
    fn compute_others(&mut self, index: usize) {
        self.compute(index);
    }

    /// Computes cosine and sine for value number `index` and those after it.
    #[inline(always)]
    fn compute(&mut self, index: usize) {
        if Native::<R>::LANES == 1 {
            self.first = index;
            let rest = self.values.get(index..).unwrap_or_default();
            let angles = self.cos.iter_mut().zip(&mut self.sin).take(Self::BATCH);
            for ((cos, sin), &value) in angles.zip(rest) {
                [*cos, *sin] = half_angle_of(value);
            }
            return;
        }
        self.first = index.min(self.values.len().saturating_sub(4));
        let rest = self.values.get(self.first..).unwrap_or_default();
        // The last four, some of them again, because lanes load no fewer than four.
        let second = rest.len().wrapping_sub(4).min(4);
        let high = rest.get(second..).and_then(<[R]>::first_chunk::<4>);
        let some = match (rest.first_chunk::<4>(), high) {
            (Some(&[a, b, c, d]), Some(&[e, f, g, h])) => {
                Eight::<R>::load(LEVEL, &[a, b, c, d, e, f, g, h])
            }
            _ => Eight::<R>::load_partial(LEVEL, rest, R::ZERO),
        };
        let [cos, sin] = checked_cos_sin(some * some.constant(0.5));
        for (to, from) in [(&mut self.cos, cos.to_array()), (&mut self.sin, sin.to_array())] {
            to[..4].copy_from_slice(&from[..4]);
            to[second..][..4].copy_from_slice(&from[4..]);
        }
    }
}

/// Cosine and sine of half an angle. Firmware holds it once.
#[cfg_attr(target_os = "none", inline(never))]
pub(crate) fn half_angle_of<R: Real + Number>(angle: R) -> [R; 2] {
    let angle = Native::<R>::splat(LEVEL, angle);
    checked_cos_sin(angle * angle.constant(0.5)).map(|of| of.to_array().as_ref()[0])
}

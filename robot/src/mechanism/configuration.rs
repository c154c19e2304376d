//! The fast code for one configuration of `f32` or `f64`. It computes with the *base frames* of
//! links, which have the origins of the link frames and the axes of the base while all values are
//! zero (see [`step`](super::step)). So it needs fewer products than the general formulas of
//! `single.rs`.
//!
//! ```text
//! for each step:
//!     frame ← frame of the parent          the last frame, or from the stored pose
//!     frame ← frame moved by half_offset   to the joint
//!     frame ← frame moved by the joint     to the link
//!     pose of the link ← frame · link_rotation
//! ```
//!
//! Base frames are not stored. Where the tree branches, the base frame of the parent is recovered
//! from its stored pose. A frame is a motion p + εq, and four lanes hold the quaternion p or q.
//! Multiplications and additions are not fused, so the bits are the same on all targets.

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

/// Returns the steps from the base to a link, in this order.
#[inline(always)]
fn path<'s, R: Copy>(
    mechanism: &Mechanism<'s, R>,
    link: usize,
) -> impl Iterator<Item = &'s Step<R>> {
    let end = mechanism.steps.get(link).map_or(NONE, |step| step.position) as usize;
    // If `link` stands for the base, `end` is out of bounds, and the path is empty.
    let steps = mechanism.steps.get(..=end).unwrap_or_default().iter().enumerate();
    // A step is directly followed by the `size` − 1 steps of the links that its link carries, so
    // it is on the path if `end` is the index of the step or of one of these.
    steps.filter(move |(position, step)| end - position < step.size as usize).map(|(_, step)| step)
}

/// Declares a struct of arguments for each method of [`Mechanism`] that has fast code for floats.
/// Code for any `Real` cannot call a function that needs a [`Number`], but it can pass such a
/// struct to `Real::quick`, which calls the fast code if the type is `f32` or `f64`.
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
            // The parent differs from the previous link only where the tree branches. There the
            // steps of an earlier child's subtree lie between the parent and this step.
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
                // A joint and the joints that mimic it share one column, so the column is a sum.
                *column = *column + frames.screw(step, index);
            }
        }
        let pose = at.pose(own);
        let (back, origin) = (pose.conjugate(), pose.translation());
        for column in self.columns {
            // The column of a joint that does not carry the link stays zero in every frame, so it
            // is not converted.
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
                // This function stores no poses, so the frame of the parent is computed again from
                // the base. Few robots branch far from the base, so this is cheap.
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

/// The base frames of a joint and of its link, and the values of all joints, from which the columns
/// of the joint are computed.
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

    /// Returns the twist of a rotation about `axis` through the origin of the link. For a planar
    /// joint this origin is computed from the joint's frame and its two distances. So it is finite
    /// even if the angle is out of range and the pose of the link is NaN. The function is not
    /// inlined, because few robots have planar or floating joints: so a Jacobian takes 7 % fewer
    /// instructions.
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

/// Returns the twist with the angular velocity `axis`, about an axis through `point`.
#[inline(always)]
fn hinge<R: Real>(axis: [R; 3], point: [R; 3]) -> Twist<R> {
    Twist { angular: axis, linear: vector::cross(point, axis) }
}

/// The lanes that hold the four components of a quaternion.
pub(crate) type Four<R> = <R as Float>::Half<Unfused<Portable>>;

#[inline(always)]
pub(crate) fn splat<R: Float>(number: R) -> Four<R> {
    Lanes::splat(LEVEL, number)
}

#[inline(always)]
pub(crate) fn load<R: Float>(numbers: [R; 4]) -> Four<R> {
    Lanes::load(LEVEL, &numbers)
}

/// Reorders the components of the quaternion q as the product with the unit vector e_K of axis K
/// does, but does not change signs.
#[inline(always)]
fn ordered<const K: usize, R: Float>(x: Four<R>) -> Four<R> {
    let (x, [a, b, c, d]) = (x.to_array(), ORDER[K]);
    load([x[a], x[b], x[c], x[d]])
}

/// Returns the factors by which [`ordered`] components are multiplied in the product of q and the
/// vector `number` · e_K: `number` with the signs of the product q e_K.
#[inline(always)]
fn row<const K: usize, R: Float>(number: R) -> Four<R> {
    splat::<R>(number) * load(SIGNS[K].map(R::from))
}

/// Returns the factors by which [`ordered`] components are multiplied, one register for each axis,
/// for a vector that lies on no axis.
#[inline(always)]
fn rows<R: Float>([x, y, z]: [R; 3]) -> [Four<R>; 3] {
    [row::<0, R>(x), row::<1, R>(y), row::<2, R>(z)]
}

/// Returns the product of the quaternion q and the quaternion with vector part v and scalar part w.
/// `x` holds q, the three registers are the [`rows`] of v, and all lanes of `w` hold w.
#[inline(always)]
fn product<R: Float>(x: Four<R>, [i, j, k]: [Four<R>; 3], w: Four<R>) -> Four<R> {
    (x * w + ordered::<0, R>(x) * i) + (ordered::<1, R>(x) * j + ordered::<2, R>(x) * k)
}

/// The base frame of a joint or a link, as the motion p + εq.
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

    /// Returns the frame moved by a vector along its own axes. `half` is half of that vector, h,
    /// and the new dual part is q + p h.
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

    /// Returns the frame rotated by the unit quaternion with vector part v and scalar part w.
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

    /// Returns the pose of the link that has this base frame and the link rotation `own`.
    #[inline(always)]
    pub(crate) fn pose(self, own: &Factor<R>) -> DualQuat<R> {
        let own = self.rotated(own.v.along, own.v.vector, own.w);
        DualQuat::from_array(own.to_array())
    }

    /// Returns the base frame of the link that has this pose and the link rotation `own`.
    #[inline(always)]
    pub(crate) fn of_pose(pose: &DualQuat<R>, own: &Factor<R>) -> Self {
        Self::new(pose.to_array()).rotated(own.v.along, own.v.vector.map(|c| -c), own.w)
    }

    /// Returns the base frame of the joint of `step`, if `self` is the base frame of its parent.
    #[inline(always)]
    pub(crate) fn joint_frame(self, step: &Step<R>) -> Self {
        let half_offset = &step.plan.half_offset;
        self.moved(half_offset.along, half_offset.vector)
    }

    /// Returns the base frame of the link that the joint of `step` carries, if `self` is the base
    /// frame of the joint.
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
            // The frame is passed by value. If its address were taken, the compiler would keep the
            // frame on the stack and not in registers, for all kinds of joints.
            Moves::General => Self::new(general_joint(at.to_array(), step, angles.values)),
        }
    }
}

/// Applies the motion of a joint of any kind. The function is not inlined, because its constants
/// would occupy registers that the loop needs.
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
/// The lanes that hold eight angles.
type Eight<R> = <R as Float>::Packed<Unfused<Portable>>;
/// The lanes of one register of the target; a single lane on targets without SIMD.
type Native<R> = <R as Float>::Lanes<Unfused<Portable>>;

/// The values of a configuration, and a cache with the cosines and sines of half of eight
/// consecutive values.
pub(crate) struct HalfAngles<'v, R> {
    pub(crate) values: &'v [R],
    first: usize,
    cos: [R; 8],
    sin: [R; 8],
}

impl<'v, R: Real + Number> HalfAngles<'v, R> {
    /// The number of angles whose cosines and sines are computed at once: eight, or four on targets
    /// with one lane, where each angle that is not needed costs time.
    const BATCH: usize = if Native::<R>::LANES == 1 { 4 } else { 8 };

    #[inline(always)]
    pub(crate) fn new(values: &'v [R]) -> Self {
        Self { values, first: 0, cos: [R::NAN; 8], sin: [R::NAN; 8] }
    }

    /// Fills the cache of cosines and sines from the first value of a step on, before the loop
    /// needs it. The cache is filled in place, because a copy right after the writes would wait for
    /// them.
    #[inline(always)]
    pub(crate) fn begin(&mut self, step: Option<&Step<R>>) {
        let index = step.map_or(0, |step| step.value as usize);
        if Native::<R>::LANES == 1 {
            self.compute_others(index);
        } else {
            self.compute(index);
        }
    }

    /// Returns the cosine and the sine of half of the value with this `index`. If the cache does
    /// not hold them, it is filled with them and their neighbours.
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

    /// Fills the cache with the cosines and sines of half of consecutive values that include the
    /// value with this `index`.
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
        // A load always takes four values. So if fewer than eight values are left, the second half
        // of the cache holds the last four values, and some of them are in the first half too.
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

/// Returns the cosine and the sine of half an angle. On firmware the function is not inlined, so
/// that the image holds it once.
#[cfg_attr(target_os = "none", inline(never))]
pub(crate) fn half_angle_of<R: Real + Number>(angle: R) -> [R; 2] {
    let angle = Native::<R>::splat(LEVEL, angle);
    checked_cos_sin(angle * angle.constant(0.5)).map(|of| of.to_array().as_ref()[0])
}

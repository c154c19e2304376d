//! The loop over the links of a mechanism, which all kernels share, with one configuration in each
//! lane.
//!
//! # The algorithm
//!
//! Each lane computes one configuration, so a register holds the same component of several
//! configurations.
//!
//! ```text
//! for each group of configurations:
//!     for each step of the mechanism, parents first:
//!         joint ← pose of the parent · placement
//!         link  ← joint · motion of the joint       cosines of four joints at a time
//!         the task takes the link
//! ```
//!
//! A [`Task`] writes the pose, adds a column to a Jacobian, or passes the link's velocity on to its
//! children.
//!
//! # Reasons
//!
//! - *The stack is laid out beforehand.* A pose that children still need is kept in a slot, whose
//!   index was chosen when the mechanism was made. A link's largest subtree comes last and takes
//!   over the slot of the link. So 32 slots are enough for any tree, nothing is pushed or popped,
//!   and all poses stay in the L1 cache.
//! - *The steps of a subtree are contiguous*, so a subtree without any requested link is skipped in
//!   one jump.
//! - *Translations are kept as halves.* The dual part of a motion is ½t r, so keeping ½t saves
//!   the multiplication by ½.
//! - *Rotations about a coordinate axis* take half the operations of rotations about other axes,
//!   and a placement without a rotation takes none ([`HalfPose`]).

use super::step::{Alignment, JointFrame, JointScrews, NONE, Step};
use super::tree::Mechanism;
use super::values::{CachedValues, Group, JointValues, LaneValues, Part, checked_cos_sin};
use dq8::batch::{Quat, vector};
use dq8::geometry::Twist;
use dq8::storage::Layout;
use dq8::{Kernel, Scalar};
use dq8_simd::{Float, Lanes, Level};

/// The greatest count of poses that the loop keeps for children at a time. [`Mechanism::new`]
/// orders the steps so that this count is at most log₂ of the count of joints, plus one. That is
/// less than 32, because a mechanism has fewer than 2²⁸ joints.
pub(crate) const SLOTS: usize = 32;

/// The work that a kernel does with each link, for poses in the layout `Y`.
pub(crate) trait Task<Y: Layout> {
    /// `true` if the task is faster with sixteen lanes of plain `f32` than with eight, on a CPU
    /// that shuffles both in the same time. It is `false` for tasks whose memory for sixteen lanes
    /// does not fit the L1 cache.
    const WIDE: bool = true;
    /// The registers that the task keeps from link to link.
    type State<V: Level>;
    /// The quantities of a link, besides its pose, that its children need, such as its twist.
    type Carried<V: Level>: Copy;
    /// Returns the state before the first group of configurations.
    fn start<V: Level>(&self, level: V) -> Self::State<V>;
    /// Returns the quantities of the base, such as a twist of zero. Links on the base take them in
    /// place of the quantities of a parent link.
    fn base<V: Level>(level: V) -> Self::Carried<V>;
    /// Begins a group of configurations, before its links are visited.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn begin<V: Level>(&mut self, _: V, _: Group, _: &[Step<Y::Real>], _: &mut Self::State<V>) {}
    /// Returns `true` if the task needs neither the link of the step at the given position nor any
    /// link that this link carries. The loop then skips all of them.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn skips(&self, _: &[Step<Y::Real>], _: usize) -> bool {
        false
    }
    /// Does the task's work for one link, and returns the quantities that the link's children need.
    fn link<V: Level>(
        &mut self,
        visit: &Visit<'_, Y, V>,
        parent: &Self::Carried<V>,
        state: &mut Self::State<V>,
    ) -> Self::Carried<V>;
    /// Ends a group of configurations, after its links were visited.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn end<V: Level>(&mut self, _: V, _: Group, _: &[Step<Y::Real>], _: &mut Self::State<V>) {}
}

/// The inputs of a task at one link, for one group of configurations.
pub(crate) struct Visit<'s, Y: Layout, V: Level> {
    pub(crate) level: V,
    pub(crate) group: Group,
    pub(crate) step: &'s Step<Y::Real>,
    pub(crate) frames: LinkFrames<Y::Register<V>>,
}

/// The frames of a joint and of its link, one configuration per lane.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LinkFrames<L> {
    /// The frame of the joint before its motion.
    pub(crate) joint: HalfPose<L>,
    /// The pose of the link.
    pub(crate) link: HalfPose<L>,
}

pub(crate) struct Walk<'r, Y: Layout, T, K> {
    pub(crate) mechanism: Mechanism<'r, Y::Real>,
    pub(crate) values: Part<'r, T>,
    /// The count of configurations, or of blocks if poses are in blocks.
    pub(crate) elements: usize,
    pub(crate) task: K,
}

impl<Y: Layout, T: JointValues<Y>, K: Task<Y>> Kernel for Walk<'_, Y, T, K> {
    type Output = ();
    // Poses in plain slices are transposed with shuffles, which cost more with more lanes. In f64 a
    // link takes so long to compute that eight lanes in place of four still save a third of the
    // time: 36 ns instead of 53 for the seven links of an arm. In f32 sixteen lanes in place of
    // eight save as much on CPUs with quick shuffles, and nothing on other CPUs.
    const WIDE: bool = Y::WIDE || !<Y::Real as Float>::SINGLE || K::WIDE;
    const SHUFFLES: bool = !Y::WIDE && <Y::Real as Float>::SINGLE;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) {
        let Self { mechanism, values, elements, mut task } = self;
        let mut numbers = CachedValues::<Y, T, V>::new(level, values, mechanism.values);
        let mut poses = [HalfPose::<Y::Register<V>>::identity(level); SLOTS];
        let mut carried = [K::base(level); SLOTS];
        let mut state = task.start(level);
        for first in (0..elements).step_by(Y::records::<V>()) {
            for register in 0..Y::registers::<V>() {
                let group = Group { first, register };
                numbers.seek(group);
                task.begin(level, group, mechanism.steps, &mut state);
                let mut position = 0;
                while let Some(step) = mechanism.steps.get(position) {
                    if task.skips(mechanism.steps, position) {
                        position += step.size as usize;
                        continue;
                    }
                    position += 1;
                    // Slots are below `SLOTS`, so the remainder changes no slot. It shows the
                    // compiler that the slots are within the array, so that the loop has no bounds
                    // check.
                    let from = step.parent_slot as usize % SLOTS;
                    let to = step.slot as usize % SLOTS;
                    let is_root = step.parent == NONE;
                    let joint = if is_root {
                        HalfPose::on_base(level, step)
                    } else {
                        poses[from].joint_frame(step)
                    };
                    let link = joint.link_frame(step, &mut numbers);
                    let visit = Visit { level, group, step, frames: LinkFrames { joint, link } };
                    let parent = if is_root { K::base(level) } else { carried[from] };
                    poses[to] = link;
                    carried[to] = task.link(&visit, &parent, &mut state);
                }
                task.end(level, group, mechanism.steps, &mut state);
            }
        }
    }
}

/// The form of poses while they are computed, one pose per lane: a rotation, and half the
/// translation. In this form, rotations about a coordinate axis and translations along one take the
/// fewest operations.
#[derive(Clone, Copy, Debug)]
pub(crate) struct HalfPose<L> {
    pub(crate) rotation: [L; 4],
    /// Half the translation, from which the dual part ½t r of the motion is computed.
    pub(crate) half: [L; 3],
}

impl<L: Lanes<Real: Scalar>> HalfPose<L> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn identity(level: L::Level) -> Self {
        let zero = L::splat(level, L::Real::default());
        Self { rotation: [zero, zero, zero, zero.constant(1.0)], half: [zero; 3] }
    }

    /// Returns the frame of the joint of `step`, which stands on the base.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn on_base(level: L::Level, step: &Step<L::Real>) -> Self {
        let rotation = vector::splat(level, step.rotation);
        Self { rotation, half: vector::splat(level, step.half_offset) }
    }

    /// Returns the components of the motion r + ε ½t r, with 12 multiplications.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn to_motion(self) -> [L; 8] {
        let ([x, y, z, w], [hx, hy, hz]) = (self.rotation, self.half);
        [
            x,
            y,
            z,
            w,
            hz.neg_mul_add(y, hy.mul_add(z, hx * w)),
            hx.neg_mul_add(z, hz.mul_add(x, hy * w)),
            hy.neg_mul_add(x, hx.mul_add(y, hz * w)),
            -hz.mul_add(z, hy.mul_add(y, hx * x)),
        ]
    }

    /// Returns the frame of the joint of `step`, which stands on a link with the pose `self`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn joint_frame(self, step: &Step<L::Real>) -> Self {
        let level = self.half[0].level();
        let half = self.shifted(step.offset_alignment, step.half_offset);
        let [x, y, z, w] = step.rotation;
        let rotation = match step.rotation_alignment {
            Alignment::None => self.rotation,
            Alignment::X => about::<L, 0>(self.rotation, L::splat(level, w), L::splat(level, x)),
            Alignment::Y => about::<L, 1>(self.rotation, L::splat(level, w), L::splat(level, y)),
            Alignment::Z => about::<L, 2>(self.rotation, L::splat(level, w), L::splat(level, z)),
            Alignment::Any => {
                let placement = Quat::from_array(vector::splat(level, step.rotation));
                (Quat::from_array(self.rotation) * placement).to_array()
            }
        };
        Self { rotation, half }
    }

    /// Returns half the translation of this frame after it is moved by a constant vector, in its
    /// own axes. `half` is half of that vector.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn shifted(self, along: Alignment, half: [L::Real; 3]) -> [L; 3] {
        let level = self.half[0].level();
        let [x, y, z] = half;
        match along {
            Alignment::None => self.half,
            Alignment::X => self.along::<0>(L::splat(level, x)),
            Alignment::Y => self.along::<1>(L::splat(level, y)),
            Alignment::Z => self.along::<2>(L::splat(level, z)),
            Alignment::Any => self.moved(vector::splat(level, half)),
        }
    }

    /// Returns half the translation after a move by the half distance d along axis K of this frame:
    /// h + d R e_K.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn along<const K: usize>(self, distance: L) -> [L; 3] {
        let (own, next, last) = (K, (K + 1) % 3, (K + 2) % 3);
        let (r, mut half) = (self.rotation, self.half);
        let twice = distance + distance;
        // The column R e_K = e_K + 2(…) of the rotation matrix has, for the axes K, n (next) and
        // l (last), the components 1 − 2(r_n² + r_l²), 2(r_K r_n + w r_l), 2(r_K r_l − w
        // r_n).
        let squares = r[next].mul_add(r[next], r[last] * r[last]);
        half[own] = twice.neg_mul_add(squares, half[own] + distance);
        half[next] = twice.mul_add(r[own].mul_add(r[next], r[3] * r[last]), half[next]);
        half[last] = twice.mul_add(r[3].neg_mul_add(r[next], r[own] * r[last]), half[last]);
        half
    }

    /// Returns half the translation after a move by a vector of this frame, half of which is v: h +
    /// R v.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn moved(self, vector: [L; 3]) -> [L; 3] {
        Quat::from_array(self.rotation).rotate_onto(vector, vector::add(vector, self.half))
    }

    /// Converts a vector from this frame to the frame of the base: R v.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn rotated(self, vector: [L; 3]) -> [L; 3] {
        Quat::from_array(self.rotation).rotate(vector)
    }

    /// Returns the axis n of a joint in the frame of the base, R n. If n is a coordinate axis, this
    /// is a column of R.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn direction(self, step: &Step<L::Real>) -> [L; 3] {
        let level = self.half[0].level();
        let at_origin = Self { half: [L::splat(level, L::Real::default()); 3], ..self };
        let one = L::splat(level, step.sign);
        match step.axis_alignment {
            Alignment::X => at_origin.along::<0>(one),
            Alignment::Y => at_origin.along::<1>(one),
            Alignment::Z => at_origin.along::<2>(one),
            Alignment::Any | Alignment::None => self.rotated(vector::splat(level, step.axis)),
        }
    }

    /// Returns the twist with the angular velocity `axis`, about an axis through the origin of this
    /// frame.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn hinge(self, axis: [L; 3]) -> Twist<L> {
        let moment = vector::cross(self.half, axis);
        Twist { angular: axis, linear: vector::add(moment, moment) }
    }

    /// Returns the rotation r of this frame after a turn about the axis n of a joint, by the cosine
    /// and the sine of half the angle: r (cos + n sin).
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn rotation_about_axis(self, step: &Step<L::Real>, cos: L, sin: L) -> [L; 4] {
        let level = cos.level();
        match step.axis_alignment {
            Alignment::None => self.rotation,
            Alignment::X => about::<L, 0>(self.rotation, cos, sin),
            Alignment::Y => about::<L, 1>(self.rotation, cos, sin),
            Alignment::Z => about::<L, 2>(self.rotation, cos, sin),
            Alignment::Any => {
                let axis = vector::scale(vector::splat(level, step.axis), sin);
                let turn = Quat::from_parts(axis, cos);
                (Quat::from_array(self.rotation) * turn).to_array()
            }
        }
    }
}

impl<L: Lanes<Real: Scalar>, N: LaneValues<L>> JointFrame<L::Real, N> for HalfPose<L> {
    type Number = L;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn number(self, number: L::Real) -> L {
        L::splat(self.half[0].level(), number)
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn numbers<const C: usize>(self, step: &Step<L::Real>, values: &mut N) -> [L; C] {
        let level = self.half[0].level();
        let mut numbers = [L::splat(level, Default::default()); C];
        for (index, number) in numbers.iter_mut().enumerate() {
            *number = values.get(level, step.value as usize + index);
        }
        numbers
    }

    /// Returns half of the joint's value, times −1 if the axis points against a coordinate axis.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn value(self, step: &Step<L::Real>, index: usize, values: &mut N) -> L {
        let level = self.half[0].level();
        let value = values.get(level, step.value as usize + index);
        value.mul_add(L::splat(level, step.half_multiplier), L::splat(level, step.half_bias))
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn half_angle(self, half: L) -> [L; 2] {
        checked_cos_sin(half)
    }

    /// Returns the cosine and the sine from the cache of `values`, which computes the cosines and
    /// sines of four consecutive values at a time. The cache ignores multipliers and offsets, so
    /// the joint must mimic no other joint.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn own_half_angle(self, step: &Step<L::Real>, values: &mut N) -> [L; 2] {
        let level = self.half[0].level();
        let [cos, sin] = values.half_angle(level, step.value as usize);
        [cos, sin * L::splat(level, step.sign)]
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn turn(self, step: &Step<L::Real>, [cos, sin]: [L; 2]) -> Self {
        Self { rotation: self.rotation_about_axis(step, cos, sin), half: self.half }
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn slide(self, step: &Step<L::Real>, half: L) -> Self {
        let half = match step.axis_alignment {
            Alignment::None => self.half,
            Alignment::X => self.along::<0>(half),
            Alignment::Y => self.along::<1>(half),
            Alignment::Z => self.along::<2>(half),
            Alignment::Any => {
                self.moved(vector::scale(vector::splat(half.level(), step.axis), half))
            }
        };
        Self { rotation: self.rotation, half }
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn slide_in_plane(self, step: &Step<L::Real>, [x, y]: [L; 2]) -> Self {
        let [first, second] = step.plane.map(|direction| vector::splat(x.level(), direction));
        let (x, y) = (x * x.constant(0.5), y * y.constant(0.5));
        let half = self.moved(vector::scale_onto(second, y, vector::scale(first, x)));
        Self { rotation: self.rotation, half }
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn float(self, _: &Step<L::Real>, [x, y, z, w, tx, ty, tz]: [L; 7]) -> Self {
        let turn = Quat::from_xyzw(x, y, z, w).normalize();
        let half = vector::scale([tx, ty, tz], x.constant(0.5));
        let rotation = (Quat::from_array(self.rotation) * turn).to_array();
        Self { rotation, half: self.moved(half) }
    }
}

/// Returns the product r (cos + sin e_K), where e_K is the unit vector of axis K, with 8
/// multiplications instead of 16.
#[cfg_attr(not(opt_level_0), inline(always))]
fn about<L: Lanes, const K: usize>(r: [L; 4], cos: L, sin: L) -> [L; 4] {
    let (own, next, last) = (K, (K + 1) % 3, (K + 2) % 3);
    let mut turned = r;
    turned[next] = r[last].mul_add(sin, r[next] * cos);
    turned[last] = r[next].neg_mul_add(sin, r[last] * cos);
    turned[own] = r[3].mul_add(sin, r[own] * cos);
    turned[3] = r[own].neg_mul_add(sin, r[3] * cos);
    turned
}

impl<L: Lanes<Real: Scalar>> JointScrews<L::Real> for LinkFrames<L> {
    type Number = L;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn number(&self, number: L::Real) -> L {
        L::splat(self.link.half[0].level(), number)
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn axis(&self, step: &Step<L::Real>) -> [L; 3] {
        self.joint.direction(step)
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn plane_axis(&self, step: &Step<L::Real>, index: usize) -> [L; 3] {
        let direction = step.plane.get(index).copied().unwrap_or_default();
        self.joint.rotated(vector::splat(self.link.half[0].level(), direction))
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn link_axis(&self, _: &Step<L::Real>, index: usize) -> [L; 3] {
        let mut axis = [L::splat(self.link.half[0].level(), L::Real::default()); 3];
        axis[index % 3] = axis[0].constant(1.0);
        self.link.rotated(axis)
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn hinge(&self, axis: [L; 3]) -> Twist<L> {
        self.joint.hinge(axis)
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn thread(&self, axis: [L; 3], pitch: L::Real) -> Twist<L> {
        let hinge = self.joint.hinge(axis);
        Twist { linear: vector::scale_onto(axis, self.number(pitch), hinge.linear), ..hinge }
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn link_hinge(&self, _: &Step<L::Real>, axis: [L; 3]) -> Twist<L> {
        self.link.hinge(axis)
    }
}

impl<L: Lanes> LinkFrames<L> {
    /// Returns `rate`, or NaN in lanes in which the pose of the link is NaN. There the screw of the
    /// joint may still be finite, but the velocity of the link must be NaN too.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn nan_if_nowhere(&self, rate: L) -> L {
        let [.., w] = self.link.rotation;
        w.mul_add(w.constant(0.0), rate)
    }
}

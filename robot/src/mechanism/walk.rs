//! The one loop of all kernels over mechanisms.
//!
//! # The algorithm
//!
//! A register holds the same number of as many configurations as it has lanes. For each group of
//! configurations: compute sine and cosine of the values, four joints at a time; then go down the
//! tree, every link once, right after what carries it: frame of the joint = pose of the parent ·
//! placement, pose of the link = frame · motion of the joint. A [`Task`] takes each link as it
//! comes: it writes a pose, adds a column to a Jacobian, passes a velocity on to the children.
//!
//! # Why it is as it is
//!
//! - *A stack laid out beforehand.* Poses that wait for children are kept in numbered slots. Which
//!   slot a link takes was found when the mechanism was made, the larger subtree last, which takes
//!   over the slot of its parent: so 32 slots carry any tree, nothing is pushed or popped, and all
//!   of it stays in the first cache.
//! - *Subtrees follow each other*, so that links nobody asked for are one jump.
//! - *Half translations.* ½t is what dual parts are made of: it saves a factor in every product.
//! - *Axes of the frame's own* take half the operations of others, and placements without a turn
//!   none ([`HalfPose`]).

use super::step::{Alignment, JointFrame, JointScrews, NONE, Step};
use super::tree::Mechanism;
use super::values::{CachedValues, Group, JointValues, LaneValues, Part, checked_cos_sin};
use dq8::batch::{Quat, vector};
use dq8::geometry::Twist;
use dq8::storage::Layout;
use dq8::{Kernel, Scalar};
use dq8_simd::{Float, Lanes, Level};

/// As many poses wait for children at most: log₂ of the number of joints, and one
/// ([`Mechanism::new`] puts them in such an order).
pub(crate) const SLOTS: usize = 32;

/// What is done with each link.
pub(crate) trait Task<Y: Layout> {
    /// Whether sixteen lanes of plain `f32` gain, where the CPU shuffles them as quickly as eight.
    /// Not where they are so much memory that the first cache does not hold it.
    const WIDE: bool = true;
    /// What it keeps in registers' form.
    type State<V: Level>;
    /// What children need of a link in addition to its pose.
    type Carried<V: Level>: Copy;
    /// Before everything.
    fn start<V: Level>(&self, level: V) -> Self::State<V>;
    /// What the base carries.
    fn base<V: Level>(level: V) -> Self::Carried<V>;
    /// Before the links of a group.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn begin<V: Level>(&mut self, _: V, _: Group, _: &[Step<Y::Real>], _: &mut Self::State<V>) {}
    /// Whether neither the link of this step nor what it carries is wanted.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn skips(&self, _: &[Step<Y::Real>], _: usize) -> bool {
        false
    }
    /// Takes a link.
    fn link<V: Level>(
        &mut self,
        level: V,
        group: Group,
        step: &Step<Y::Real>,
        joined: &LinkFrames<Y::Register<V>>,
        parent: &Self::Carried<V>,
        state: &mut Self::State<V>,
    ) -> Self::Carried<V>;
    /// After the links of a group.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn end<V: Level>(&mut self, _: V, _: Group, _: &[Step<Y::Real>], _: &mut Self::State<V>) {}
}

/// A link and its joint, one configuration per lane.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LinkFrames<L> {
    /// The frame of the joint.
    pub(crate) joint: HalfPose<L>,
    /// The link.
    pub(crate) link: HalfPose<L>,
}

pub(crate) struct Walk<'r, Y: Layout, T, K> {
    pub(crate) mechanism: Mechanism<'r, Y::Real>,
    pub(crate) values: Part<'r, T>,
    /// How many configurations, or blocks of them, there are.
    pub(crate) elements: usize,
    pub(crate) task: K,
}

impl<Y: Layout, T: JointValues<Y>, K: Task<Y>> Kernel for Walk<'_, Y, T, K> {
    type Output = ();
    // Plain poses are transposed, but a link of f64 is so much to compute that eight lanes still
    // gain a third: 36 ns instead of 53 for the seven links of an arm. Of f32 they gain as much
    // where shuffles are quick, else nothing.
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
                    let (from, to) = slots(step);
                    let is_root = step.parent == NONE;
                    let before = frame(level, &poses, step);
                    let pose = before.link_frame(step, &mut numbers);
                    let joined = LinkFrames { joint: before, link: pose };
                    let parent = if is_root { K::base(level) } else { carried[from] };
                    poses[to] = pose;
                    carried[to] = task.link(level, group, step, &joined, &parent, &mut state);
                }
                task.end(level, group, mechanism.steps, &mut state);
            }
        }
    }
}

/// Where the poses of a parent and of the link of a step are. They are smaller than [`SLOTS`]; the
/// remainder, a mask, tells the compiler, and no check is left.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(crate) fn slots<R>(step: &Step<R>) -> (usize, usize) {
    (step.parent_slot as usize % SLOTS, step.slot as usize % SLOTS)
}

/// The frame of the joint.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(crate) fn frame<L: Lanes<Real: Scalar>>(
    level: L::Level,
    poses: &[HalfPose<L>; SLOTS],
    step: &Step<L::Real>,
) -> HalfPose<L> {
    if step.parent == NONE {
        return HalfPose::root(level, step);
    }
    let (from, _) = slots(step);
    poses[from].place(step)
}

// Poses on lanes while they are computed: a rotation and half the translation, which is what
// products with a rotation about an axis of the frame, or a translation along one, take least of.

/// Poses, one per lane.
#[derive(Clone, Copy, Debug)]
pub(crate) struct HalfPose<L> {
    pub(crate) rotation: [L; 4],
    /// Half the translation: what the dual part of a motion is made of.
    pub(crate) half: [L; 3],
}

impl<L: Lanes<Real: Scalar>> HalfPose<L> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn identity(level: L::Level) -> Self {
        let zero = L::splat(level, L::Real::default());
        Self { rotation: [zero, zero, zero, zero.constant(1.0)], half: [zero; 3] }
    }

    /// The placement of a joint on the base.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn root(level: L::Level, step: &Step<L::Real>) -> Self {
        let rotation = vector::splat(level, step.rotation);
        Self { rotation, half: vector::splat(level, step.half_offset) }
    }

    /// The components of the motion r + ε ½t r: 12 multiplications.
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

    /// This pose times the placement of a joint.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn place(self, step: &Step<L::Real>) -> Self {
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

    /// Half the translation after a constant one in the frame of this pose, of which half is given.
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

    /// Half the translation, moved along an axis of the frame: h + d R e_K.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn along<const K: usize>(self, distance: L) -> [L; 3] {
        let (own, next, last) = (K, (K + 1) % 3, (K + 2) % 3);
        let (r, mut half) = (self.rotation, self.half);
        let twice = distance + distance;
        // R e_K = e_K + 2(…): 1 − 2(r_n² + r_l²), 2(r_K r_n + w r_l), 2(r_K r_l − w r_n).
        let squares = r[next].mul_add(r[next], r[last] * r[last]);
        half[own] = twice.neg_mul_add(squares, half[own] + distance);
        half[next] = twice.mul_add(r[own].mul_add(r[next], r[3] * r[last]), half[next]);
        half[last] = twice.mul_add(r[3].neg_mul_add(r[next], r[own] * r[last]), half[last]);
        half
    }

    /// h + R v
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn moved(self, vector: [L; 3]) -> [L; 3] {
        Quat::from_array(self.rotation).rotate_onto(vector, vector::add(vector, self.half))
    }

    /// R v
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn rotated(self, vector: [L; 3]) -> [L; 3] {
        Quat::from_array(self.rotation).rotate(vector)
    }

    /// R n for the axis of a joint: a column of the rotation, where it is an axis of the frame.
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

    /// Turning about an axis through the origin of this frame.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn hinge(self, axis: [L; 3]) -> Twist<L> {
        let moment = vector::cross(self.half, axis);
        Twist { angular: axis, linear: vector::add(moment, moment) }
    }

    /// The rotation, turned about the axis of a joint: r (c + n s).
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

    /// Half of it, counted where the axis is positive.
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

    /// Cosines and sines of values as they are come four at a time.
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

/// r (c + s e_K): two components instead of four, 8 multiplications.
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

// How joints move links, on lanes.

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
    /// A rate, or NaN where the pose of the link is: a link that is nowhere does not move, although
    /// the screw of its joint may be known.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn nan_if_nowhere(&self, rate: L) -> L {
        let [.., w] = self.link.rotation;
        w.mul_add(w.constant(0.0), rate)
    }
}

//! The form of a joint that kernels use: a [`Step`], which is checked and made from a [`Joint`].
//! This file also has the motion that a joint gives to frames ([`JointFrame`]), the twists that it
//! gives to its link ([`JointScrews`]), the plan for one configuration at a time ([`plan`]), and
//! the limits of joints that mimic others.
//!
//! # The plan for one configuration
//!
//! With one configuration, no other configurations fill the lanes, and the pose of each link
//! depends on the pose of its parent. So as much as possible is computed once, when the mechanism
//! is made. A link's *base frame* has the origin of the link's frame, and is turned so that it is
//! parallel to the base while every value is zero:
//!
//! ```text
//!   link frames, as in the file     base frames: same origins, axes of the base
//!
//!   z         y                     z         z
//!   │         │                     │         │
//!   ●── x ────●── z                 ●── x ────●── x
//!   link 0    link 1                link 0    link 1
//! ```
//!
//! Between base frames no placement has a rotation: the frame of a joint is the frame of its
//! parent, translated. The hinges of nearly all robots lie on axes of the base, so a hinge turns a
//! frame by `r ← cos · r + sin · (r n)`, where the product `r n` with a unit vector n along an
//! axis only reorders the four components of r and changes some signs. The constant rotation from
//! the base frame to the link's own frame is multiplied when the pose is written; no other link
//! depends on that product.

use super::joint::{Joint, JointKind, MechanismError};
use core::ops::Mul;
use dq8::Real;
use dq8::geometry::Twist;
use dq8::scalar::{DualQuat, Quat, vector};

/// The tolerance for the norms of axes, placements and targets that should be unit. Input that
/// people type with four decimals is within it.
pub(crate) const UNIT: f32 = 1e-3;

/// The index that stands for "none": for a link, value or rate that does not exist.
pub(crate) const NONE: u32 = u32::MAX;

/// A joint in the form that kernels use. A [`Mechanism`](super::Mechanism) borrows one step for
/// each of its joints.
#[derive(Clone, Copy, Debug)]
pub struct Step<R> {
    /// The rotation of the joint's placement on its parent, a quaternion.
    pub(crate) rotation: [R; 4],
    /// Half of the translation of the placement, because kernels keep the halves of translations.
    pub(crate) half_offset: [R; 3],
    /// The coordinate axis about which the placement rotates, if there is one.
    pub(crate) rotation_alignment: Alignment,
    /// The coordinate axis along which the placement translates, if there is one.
    pub(crate) offset_alignment: Alignment,
    /// The kind of the joint, with a normalized axis.
    pub(crate) kind: JointKind<R>,
    /// The axis in `kind`, or zero for joints without an axis.
    pub(crate) axis: [R; 3],
    /// The two directions in which a planar joint slides, in the frame of the joint.
    pub(crate) plane: [[R; 3]; 2],
    /// The coordinate axis on which the axis of the joint lies, if there is one.
    pub(crate) axis_alignment: Alignment,
    /// −1 if the axis of the joint lies on a coordinate axis and points against it, else 1.
    pub(crate) sign: R,
    /// The factor in the rule for the joint's value: `multiplier` · (the value at index `value`) +
    /// `offset`. It is 1 unless the joint mimics another joint.
    pub(crate) multiplier: R,
    /// The summand in the rule for the joint's value: `multiplier` · (the value at index
    /// `value`) + `offset`. It is 0 unless the joint mimics another joint.
    pub(crate) offset: R,
    /// ½ · `sign` · `multiplier`. Half of the joint's value along the coordinate axis is this
    /// factor times the value at index `value`, plus `half_bias`.
    pub(crate) half_multiplier: R,
    /// ½ · `sign` · `offset`, the summand in half of the joint's value along the coordinate
    /// axis.
    pub(crate) half_bias: R,
    pub(crate) plan: JointPlan<R>,
    pub(crate) limits: Option<[R; 2]>,
    pub(crate) mimics: bool,
    /// The index of the joint's first value.
    pub(crate) value: u32,
    /// The index of the joint's first rate.
    pub(crate) rate: u32,
    /// The index of the joint in the caller's order.
    pub(crate) link: u32,
    /// The index of the joint's parent in the caller's order.
    pub(crate) parent: u32,
    /// In the finished mechanism, the step at index i holds here the index of the step of link i.
    /// While the steps are put in order, each step holds the index to which it will be moved.
    pub(crate) position: u32,
    /// The count of steps, from this step on, that belong to this link and to the links that it
    /// carries.
    pub(crate) size: u32,
    /// The index of the child with the largest subtree. It is used only while steps are put in
    /// order.
    pub(crate) largest: u32,
    /// The number of rates of the joints whose steps are before this step. Joints that mimic count
    /// too. While the steps are put in order, it is the index at which the subtree of the next
    /// child will begin.
    pub(crate) twist: u32,
    /// The index of the slot that holds the pose of this link. Kernels keep poses in a fixed number
    /// of slots.
    pub(crate) slot: u8,
    /// The index of the slot that holds the pose of the link's parent.
    pub(crate) parent_slot: u8,
}

impl<R: Real> Default for Step<R> {
    /// Returns a placeholder, which [`Mechanism::new`](super::Mechanism::new) overwrites.
    fn default() -> Self {
        Self {
            rotation: [R::ZERO, R::ZERO, R::ZERO, R::ONE],
            half_offset: [R::ZERO; 3],
            rotation_alignment: Alignment::None,
            offset_alignment: Alignment::None,
            kind: JointKind::Fixed,
            axis: [R::ZERO; 3],
            plane: [[R::ZERO; 3]; 2],
            axis_alignment: Alignment::None,
            sign: R::ONE,
            multiplier: R::ONE,
            offset: R::ZERO,
            half_multiplier: R::HALF,
            half_bias: R::ZERO,
            plan: JointPlan::NONE,
            limits: None,
            mimics: false,
            value: NONE,
            rate: NONE,
            link: NONE,
            parent: NONE,
            position: NONE,
            size: 1,
            largest: NONE,
            twist: 0,
            slot: 0,
            parent_slot: 0,
        }
    }
}

impl<R: Real> Step<R> {
    /// Checks the joint with this `index` on its own, and makes its step. The callers check its
    /// parent and the joint that it mimics.
    pub(crate) fn of(joint: &Joint<R>, index: usize) -> Result<Self, MechanismError> {
        let mut step = Self::default();
        step.place(joint.placement, index)?;
        step.kind = joint.kind;
        if let JointKind::Screw { pitch, .. } = step.kind {
            finite(pitch, "pitch", index)?;
        }
        if let JointKind::Revolute { axis }
        | JointKind::Prismatic { axis }
        | JointKind::Screw { axis, .. }
        | JointKind::Planar { normal: axis } = &mut step.kind
        {
            *axis = unit(*axis, index)?;
            step.axis = *axis;
        }
        step.axis_alignment = Alignment::of(step.axis);
        let [x, y, z] = step.axis;
        if step.axis_alignment != Alignment::Any && x + y + z < R::ZERO {
            step.sign = -R::ONE;
        }
        if let JointKind::Planar { normal } = step.kind {
            let turn = from_z(normal);
            let (x, y) = ([R::ONE, R::ZERO, R::ZERO], [R::ZERO, R::ONE, R::ZERO]);
            step.plane = [turn.rotate(x), turn.rotate(y)];
        }
        if let Some(mimic) = joint.mimic {
            finite(mimic.multiplier, "multiplier", index)?;
            finite(mimic.offset, "offset", index)?;
            (step.multiplier, step.offset, step.mimics) = (mimic.multiplier, mimic.offset, true);
        }
        if let Some([low, high]) = joint.limits {
            if !(low <= high && step.kind.values() == 1) {
                let (low, high) = (low.into(), high.into());
                return Err(MechanismError::Limits { joint: index, low, high });
            }
            step.limits = joint.limits;
        }
        step.half_multiplier = R::HALF * step.multiplier * step.sign;
        step.half_bias = R::HALF * step.offset * step.sign;
        Ok(step)
    }

    /// Returns the pose of the joint in the frame of its parent.
    #[inline]
    pub(crate) fn placement(&self) -> DualQuat<R> {
        let rotation = Quat::from_array(self.rotation);
        DualQuat::from_rotation_translation(rotation, vector::scale(self.half_offset, R::TWO))
    }

    fn place(&mut self, placement: DualQuat<R>, index: usize) -> Result<(), MechanismError> {
        let norm = norm(placement.real());
        if is_far_from_one(norm) {
            return Err(MechanismError::Placement { joint: index, norm: norm.into() });
        }
        let (along, size) = (placement.real().dot(placement.dual()), self::norm(placement.dual()));
        if along.abs() > R::from(UNIT) * size.max_or_nan(R::ONE) {
            return Err(MechanismError::DualPart { joint: index, along: along.into() });
        }
        let placement = if placement.is_normalized() { placement } else { placement.normalize() };
        let mut rotation = placement.rotation().to_array();
        let mut translation = placement.translation();
        for number in translation {
            finite(number, "translation", index)?;
        }
        // In floats the cosine of a quarter turn is not zero, because π/2 is rounded. Such
        // components become exactly zero here, so that the alignment below is found.
        for number in &mut rotation {
            if number.abs() <= R::EPSILON {
                *number = R::ZERO;
            }
        }
        // Adding zero turns a negative zero into a positive one.
        for number in &mut translation {
            *number += R::ZERO;
        }
        let [x, y, z, _] = rotation;
        (self.rotation_alignment, self.offset_alignment) =
            (Alignment::of([x, y, z]), Alignment::of(translation));
        self.rotation = rotation;
        self.half_offset = vector::scale(translation, R::HALF);
        Ok(())
    }
}

/// A frame that a joint moves, from the joint's own frame to the frame of its link. The motion of
/// each kind of joint is written once, in [`link_frame`](Self::link_frame), for three implementers:
/// one configuration per lane, one configuration of `f32` or `f64`, and one configuration of any
/// `Real`. `V` holds the values of the joints.
///
/// The implementation for one configuration per lane uses halves of angles and distances, because
/// its products need only the halves. The other two implementations use whole angles and distances.
pub(crate) trait JointFrame<R: Real, V>: Copy {
    /// A scalar, or a register with one scalar per lane.
    type Number: Copy + Mul<Output = Self::Number>;
    /// Returns a constant, with the same value in every lane.
    fn number(self, number: R) -> Self::Number;
    /// Returns the first `C` values of a joint, as the caller gave them.
    fn numbers<const C: usize>(self, step: &Step<R>, values: &mut V) -> [Self::Number; C];
    /// Returns value `index` of a joint, an angle about its axis or a distance along it, with the
    /// rule of a joint that mimics another already applied.
    fn value(self, step: &Step<R>, index: usize, values: &mut V) -> Self::Number;
    /// Returns the cosine and the sine of half an angle.
    fn half_angle(self, angle: Self::Number) -> [Self::Number; 2];
    /// Returns the cosine and the sine of half the angle of a hinge that mimics no other joint.
    /// Most joints of a robot are such hinges, so implementers may have faster code for them.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn own_half_angle(self, step: &Step<R>, values: &mut V) -> [Self::Number; 2] {
        self.half_angle(self.value(step, 0, values))
    }
    /// Returns the frame turned about the axis of the joint, by the cosine and sine of half the
    /// angle.
    fn turn(self, step: &Step<R>, half_angle: [Self::Number; 2]) -> Self;
    /// Returns the frame moved along the axis of the joint.
    fn slide(self, step: &Step<R>, distance: Self::Number) -> Self;
    /// Returns the frame moved along the two directions of a planar joint, perpendicular to its
    /// normal.
    fn slide_in_plane(self, step: &Step<R>, distances: [Self::Number; 2]) -> Self;
    /// Returns the frame moved by the translation of a floating joint, then turned by its
    /// quaternion, which may have any length.
    fn float(self, step: &Step<R>, numbers: [Self::Number; 7]) -> Self;

    /// Returns the frame of the link, if `self` is the frame of the joint.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn link_frame(self, step: &Step<R>, values: &mut V) -> Self {
        match step.kind {
            JointKind::Fixed => self,
            JointKind::Revolute { .. } if !step.mimics => {
                self.turn(step, self.own_half_angle(step, values))
            }
            JointKind::Prismatic { .. } => self.slide(step, self.value(step, 0, values)),
            JointKind::Floating => self.float(step, self.numbers(step, values)),
            // One arm of this `match` serves three kinds of joints, so that the code of cosine and
            // sine, which is most of the machine code, is compiled once.
            JointKind::Revolute { .. } | JointKind::Screw { .. } | JointKind::Planar { .. } => {
                let index = if let JointKind::Planar { .. } = step.kind { 2 } else { 0 };
                let angle = self.value(step, index, values);
                let half_angle = self.half_angle(angle);
                let moved = match step.kind {
                    JointKind::Screw { pitch, .. } => self.slide(step, angle * self.number(pitch)),
                    JointKind::Planar { .. } => {
                        self.slide_in_plane(step, self.numbers(step, values))
                    }
                    _ => self,
                };
                moved.turn(step, half_angle)
            }
        }
    }
}

/// The twists that a joint gives to its link if one of its rates is 1. They are written once for
/// each kind of joint, in [`screw`](Self::screw). The implementers for one configuration per lane,
/// and for one configuration of `f32` or `f64`, give spatial twists, in the frame of the base. The
/// implementer for any `Real` gives body twists, in the frame of the link.
pub(crate) trait JointScrews<R: Real> {
    /// A scalar, or a register with one scalar per lane.
    type Number: Copy + Mul<Output = Self::Number>;
    /// Returns a constant, with the same value in every lane.
    fn number(&self, number: R) -> Self::Number;
    /// Returns the axis of the joint.
    fn axis(&self, step: &Step<R>) -> [Self::Number; 3];
    /// Returns the direction in which a planar joint slides for x (index 0) or y (index 1).
    fn plane_axis(&self, step: &Step<R>, index: usize) -> [Self::Number; 3];
    /// Returns the axis of the link's frame for rate `index` of a floating joint: x for index 0 or
    /// 3, y for 1 or 4, z for 2 or 5.
    fn link_axis(&self, step: &Step<R>, index: usize) -> [Self::Number; 3];
    /// Returns the twist of a rotation about `axis`, through the origin of the joint, at a rate
    /// of 1.
    fn hinge(&self, axis: [Self::Number; 3]) -> Twist<Self::Number>;
    /// Returns the twist of a screw motion about `axis`, through the origin of the joint, at a rate
    /// of 1. The motion slides along the axis by `pitch` for each radian.
    fn thread(&self, axis: [Self::Number; 3], pitch: R) -> Twist<Self::Number>;
    /// Returns the twist of a rotation about `axis`, through the origin of the link, at a rate
    /// of 1.
    fn link_hinge(&self, step: &Step<R>, axis: [Self::Number; 3]) -> Twist<Self::Number>;

    /// Returns the twist of a translation along `axis`, at a rate of 1.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn slide(&self, axis: [Self::Number; 3]) -> Twist<Self::Number> {
        Twist { angular: [self.number(R::ZERO); 3], linear: axis }
    }

    /// Returns the twist for rate `index` of the joint, which is a column of the Jacobian.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn screw(&self, step: &Step<R>, index: usize) -> Twist<Self::Number> {
        let screw = match step.kind {
            // A planar joint slides before it turns, so it slides along axes of the joint. The
            // rates of a floating joint are along axes of the link, after its turn.
            JointKind::Planar { .. } if index < 2 => self.slide(self.plane_axis(step, index)),
            JointKind::Floating => {
                let axis = self.link_axis(step, index);
                if index < 3 { self.link_hinge(step, axis) } else { self.slide(axis) }
            }
            kind => {
                let axis = self.axis(step);
                match kind {
                    JointKind::Prismatic { .. } => self.slide(axis),
                    JointKind::Screw { pitch, .. } => self.thread(axis, pitch),
                    JointKind::Planar { .. } => self.link_hinge(step, axis),
                    _ => self.hinge(axis),
                }
            }
        };
        if step.mimics { screw.scale(self.number(step.multiplier)) } else { screw }
    }
}

/// Returns the shortest rotation that takes z to the unit vector n = (x, y, z).
fn from_z<R: Real>([x, y, z]: [R; 3]) -> Quat<R> {
    if x == R::ZERO && y == R::ZERO {
        let about_x = if z < R::ZERO { R::ONE } else { R::ZERO };
        return Quat::from_xyzw(about_x, R::ZERO, R::ZERO, R::ONE - about_x);
    }
    // The quaternion has the vector part z × n and the scalar part 1 + z·n. Near −z that sum
    // cancels, so it is computed from x and y, as (x² + y²) / (1 − z).
    let across = vector::norm([x, y]);
    let w = if z < R::ZERO { across * across / (R::ONE - z) } else { R::ONE + z };
    Quat::from_xyzw(-y, x, R::ZERO, w).normalize()
}

/// Returns the norm. The function is not inlined, so that machine code holds it once.
#[inline(never)]
fn norm<R: Real>(quaternion: Quat<R>) -> R {
    quaternion.norm()
}

/// Returns `true` for a length that differs from 1 by more than [`UNIT`], and for NaN.
fn is_far_from_one<R: Real>(length: R) -> bool {
    let near = (length - R::ONE).abs() <= R::from(UNIT);
    !near
}

// The function is not inlined, so that machine code holds it once and not for each kind of joint.
#[inline(never)]
pub(crate) fn unit<R: Real>(axis: [R; 3], index: usize) -> Result<[R; 3], MechanismError> {
    let length = vector::norm(axis);
    if is_far_from_one(length) {
        return Err(MechanismError::Axis { joint: index, length: length.into() });
    }
    Ok(vector::over_norm(axis, length))
}

pub(crate) fn finite<R: Real>(
    value: R,
    what: &'static str,
    index: usize,
) -> Result<(), MechanismError> {
    if value.is_finite() {
        return Ok(());
    }
    Err(MechanismError::NotFinite { joint: index, what, value: value.into() })
}

/// The coordinate axis that a vector lies on. Most axes and offsets of robots lie on one. For
/// these, kernels leave out most of a product, which would consist of multiplications by zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Alignment {
    /// The vector is zero, so the rotation or translation is the identity.
    None,
    X,
    Y,
    Z,
    /// The vector lies on no coordinate axis.
    Any,
}

impl Alignment {
    pub(crate) fn of<R: Real>([x, y, z]: [R; 3]) -> Self {
        match [x, y, z].map(|number| number == R::ZERO) {
            [true, true, true] => Self::None,
            [false, true, true] => Self::X,
            [true, false, true] => Self::Y,
            [true, true, false] => Self::Z,
            _ => Self::Any,
        }
    }
}

/// The product q e_K of a quaternion with the unit vector of axis K: component i of the product is
/// component `ORDER[K][i]` of q, times `SIGNS[K][i]`.
pub(crate) const ORDER: [[usize; 4]; 3] = [[3, 2, 1, 0], [2, 3, 0, 1], [1, 0, 3, 2]];
pub(crate) const SIGNS: [[f32; 4]; 3] =
    [[1.0, 1.0, -1.0, -1.0], [-1.0, 1.0, 1.0, -1.0], [1.0, -1.0, 1.0, -1.0]];

/// A vector, and the coordinate axis that it lies on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AxisVector<R> {
    pub(crate) along: Alignment,
    pub(crate) vector: [R; 3],
}

impl<R: Real> AxisVector<R> {
    const ZERO: Self = Self { along: Alignment::None, vector: [R::ZERO; 3] };

    pub(crate) fn new(vector: [R; 3]) -> Self {
        Self { along: Alignment::of(vector), vector }
    }
}

/// A constant quaternion with vector part v and scalar part w, by which frames are multiplied from
/// the right.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Factor<R> {
    pub(crate) v: AxisVector<R>,
    pub(crate) w: R,
}

impl<R: Real> Factor<R> {
    pub(crate) const ONE: Self = Self { v: AxisVector::ZERO, w: R::ONE };

    pub(crate) fn new([x, y, z, w]: [R; 4]) -> Self {
        Self { v: AxisVector::new([x, y, z]), w }
    }

    pub(crate) fn quaternion(&self) -> Quat<R> {
        let [x, y, z] = self.v.vector;
        Quat::from_xyzw(x, y, z, self.w)
    }
}

/// The kind of motion of a joint between base frames, which decides how `configuration.rs` computes
/// it.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Moves {
    Fixed,
    /// A hinge that mimics no other joint and turns about x of its base frame. The next three
    /// variants are hinges about y, about z, and about any other axis.
    AboutX,
    AboutY,
    AboutZ,
    AboutAny,
    /// Any other joint that moves; few robots have such joints.
    General,
}

/// The constants of a joint for computations with base frames, which the head of this file defines.
#[derive(Clone, Copy, Debug)]
pub(crate) struct JointPlan<R> {
    pub(crate) moves: Moves,
    /// The rotation from the base frame of the link to the link's own frame.
    pub(crate) link_rotation: Factor<R>,
    /// Half the translation from the parent to the joint, in the parent's base frame.
    pub(crate) half_offset: AxisVector<R>,
    /// The axis or normal of the joint, in the joint's base frame.
    pub(crate) axis: AxisVector<R>,
}

impl<R: Real> JointPlan<R> {
    pub(crate) const NONE: Self = Self {
        moves: Moves::Fixed,
        link_rotation: Factor::ONE,
        half_offset: AxisVector::ZERO,
        axis: AxisVector::ZERO,
    };
}

/// Writes the plans of all steps. The steps must still be in the order of the joints. Then each
/// parent lies at its own index, and its plan is written before the plans of its children.
// The function is not inlined, so that machine code holds it once and not for each constructor.
#[inline(never)]
pub(crate) fn plan<R: Real>(steps: &mut [Step<R>]) {
    for index in 0..steps.len() {
        let Some(step) = steps.get(index) else { return };
        let on = steps.get(step.parent as usize).map_or(Factor::ONE, |on| on.plan.link_rotation);
        let on = on.quaternion();
        let own = on * Quat::from_array(step.rotation);
        // One step of Newton's method brings the norm, which rounding has changed, back to 1.
        let mut own = own.scale(R::from(1.5) - R::HALF * own.dot(own)).to_array();
        snap(&mut own, R::ONE);
        let largest = step.half_offset.into_iter().map(R::abs).fold(R::ZERO, R::max_or_nan);
        let mut half_offset = on.rotate(step.half_offset);
        snap(&mut half_offset, largest);
        let mut axis = Quat::from_array(own).rotate(step.axis);
        snap(&mut axis, R::ONE);
        if let Some(step) = steps.get_mut(index) {
            let axis = AxisVector::new(axis);
            let moves = match (step.kind, axis.along) {
                (JointKind::Fixed, _) => Moves::Fixed,
                (JointKind::Revolute { .. }, _) if step.mimics => Moves::General,
                (JointKind::Revolute { .. }, Alignment::X) => Moves::AboutX,
                (JointKind::Revolute { .. }, Alignment::Y) => Moves::AboutY,
                (JointKind::Revolute { .. }, Alignment::Z) => Moves::AboutZ,
                (JointKind::Revolute { .. }, _) => Moves::AboutAny,
                _ => Moves::General,
            };
            let (link_rotation, half_offset) = (Factor::new(own), AxisVector::new(half_offset));
            step.plan = JointPlan { moves, link_rotation, half_offset, axis };
        }
    }
}

/// Replaces components that rounding has moved away from 0, ½, √½ or 1, times `size`, by these
/// exact values. Frames of machines are mostly turned by quarter turns, whose quaternions consist
/// of such components.
#[inline(never)]
fn snap<R: Real>(numbers: &mut [R], size: R) {
    let (root, near) = (R::HALF.sqrt(), R::TWO * R::EPSILON * size);
    for number in numbers {
        for nice in [R::ZERO, R::HALF * size, root * size, size] {
            if (number.abs() - nice).abs() <= near {
                *number = if *number < R::ZERO { -nice } else { nice };
            }
        }
    }
}

// In many files a joint that mimics another (the leader) has limits of its own, which were copied
// from the leader without the sign or the factor of the rule. If these limits leave a part of the
// leader's range, they narrow it. If they leave one value or none, the file cannot mean them, and
// the joint has no limits.

/// Returns the part of the leader's range `[low, high]` in which the follower is within its own
/// `limits`. The follower's value is `multiplier` · (leader's value) + `offset`. The result is
/// `None` if no more than one value is left.
pub(crate) fn common_range<R: Real>(
    [low, high]: [R; 2],
    limits: [R; 2],
    multiplier: R,
    offset: R,
) -> Option<[R; 2]> {
    // The limits are converted to values of the leader. A multiplier of zero gives NaN or
    // infinities here, and is ruled out in the last line.
    let [a, b] = limits.map(|limit| (limit - offset) / multiplier);
    let [least, most] = if a <= b { [a, b] } else { [b, a] };
    let low = if least > low { least } else { low };
    let high = if most < high { most } else { high };
    (multiplier != R::ZERO && low < high).then_some([low, high])
}

impl<R: Real> Step<R> {
    /// Returns the part of the leader's `range` that the limits of this joint, which mimics the
    /// leader, allow ([`common_range`]). It is the whole range if this joint has no limits.
    pub(crate) fn narrowed(&self, range: [R; 2]) -> Option<[R; 2]> {
        match self.limits {
            Some(limits) => common_range(range, limits, self.multiplier, self.offset),
            None => Some(range),
        }
    }
}

/// Returns the range from −∞ to ∞.
pub(crate) fn unlimited<R: Real>() -> [R; 2] {
    [-R::ONE / R::ZERO, R::ONE / R::ZERO]
}

#[cfg(test)]
mod tests {
    use super::{Alignment, Moves, plan};
    use crate::mechanism::joint::Joint;
    use crate::mechanism::step::Step;
    use dq8::{DualQuat, Quat, Real};

    /// Checks that hinge axes and offsets stay on axes of the base in a chain of frames, each
    /// turned by a quarter or half turn, in spite of the rounding of floats.
    fn stays_aligned<R: Real>() {
        let mut steps = [Step::default(); 60];
        for (index, step) in steps.iter_mut().enumerate() {
            let axis =
                |which: usize| [0, 1, 2].map(|i| if i == which % 3 { R::ONE } else { R::ZERO });
            let angle = R::PI * R::HALF * R::from((1 + index % 2) as f32);
            let turn = Quat::from_axis_angle(axis(index * index), angle);
            let at = DualQuat::from_rotation_translation(turn, axis(index / 2));
            let on = index.checked_sub(1);
            *step = Step::of(&Joint::revolute(on, at, axis(index / 5)), index).unwrap();
            step.parent = on.map_or(u32::MAX, |on| on as u32);
        }
        plan(&mut steps);
        for step in steps {
            assert!(!matches!(step.plan.moves, Moves::AboutAny | Moves::General), "{step:?}");
            assert_ne!(step.plan.half_offset.along, Alignment::Any, "{step:?}");
        }
    }

    #[test]
    fn quarter_turns_leave_hinges_and_offsets_on_axes_of_the_base() {
        stays_aligned::<f32>();
        stays_aligned::<f64>();
    }
}

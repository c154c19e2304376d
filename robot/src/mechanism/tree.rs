//! [`Mechanism`]: a tree of joints, checked and put in order. It has three constructors: from
//! joints, from screws, and from a table of Denavit and Hartenberg.

use super::joint::{Joint, JointKind, MechanismError};
use super::step::{NONE, Step, finite, plan, unit, unlimited};
use dq8::geometry::{Line, Screw};
use dq8::internal::brief;
use dq8::scalar::{DualQuat, Quat, vector};
use dq8::storage::same_length;
use dq8::{Real, ShapeError};

/// A tree of joints, checked once. The count of joints is known at run time. The tree borrows its
/// memory from the caller: one [`Step`] for each joint. [`OwnedMechanism`](super::OwnedMechanism)
/// owns that memory.
///
/// - Joint j carries link j, so a joint and its link have the same index. Poses, twists,
///   accelerations and goals are indexed by link.
/// - The values of a configuration are one array: the values of joint 0, then the values of joint
///   1, and so on. Joints that are fixed or mimic another joint have no values of their own, so
///   value j need not belong to joint j; [`values_of`](Self::values_of) gives the values of a
///   joint. Limits and postures are indexed by value.
/// - Rates lie joint by joint in an array of their own, with indices of their own, because a
///   floating joint has seven values and six rates; [`rates_of`](Self::rates_of) gives the rates of
///   a joint. Columns of a Jacobian are indexed by rate.
///
/// ```
/// use dq8_robot::{Joint, Mechanism, Step};
/// use dq8::DualQuat;
/// // A hinge about z at the base, and a slide along x on it.
/// let joints = [
///     Joint::revolute(None, DualQuat::IDENTITY, [0.0_f64, 0.0, 1.0]),
///     Joint::prismatic(Some(0), DualQuat::from_translation([1.0, 0.0, 0.0]), [1.0, 0.0, 0.0]),
/// ];
/// let mut steps = [Step::default(); 2];
/// let crane = Mechanism::new(&joints, &mut steps)?;
/// assert_eq!((crane.links(), crane.values(), crane.rates()), (2, 2, 2));
/// let mut poses = [DualQuat::IDENTITY; 2];
/// crane.link_poses(&[core::f64::consts::FRAC_PI_2, 0.5], &mut poses)?;
/// let [x, y, z] = poses[1].translation();
/// assert!(x.abs() < 1e-15 && (y - 1.5).abs() < 1e-15 && z == 0.0);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy)]
pub struct Mechanism<'a, R> {
    /// The steps in depth-first order: each is followed by the steps of all links that its link
    /// carries, the largest branch last.
    pub(crate) steps: &'a [Step<R>],
    pub(crate) values: usize,
    pub(crate) rates: usize,
}

brief!([R] Mechanism<'_, R>: Mechanism |it| {
    links: it.steps.len(), values: it.values, rates: it.rates,
});

impl<'a, R: Real> Mechanism<'a, R> {
    /// Checks the joints and writes a step for each. The constructor finds the axes that lie on an
    /// axis of a frame, and the placements without a rotation or a translation, for which kernels
    /// need fewer operations.
    ///
    /// # Errors
    /// If a parent does not come before its joint, a placement or axis is farther than 10⁻³ from
    /// unit or not finite, limits are not in order, a joint mimics a joint that does not have
    /// exactly one value of its own, or there are fewer steps than joints. In any of these cases
    /// `steps` may have been written.
    pub fn new(joints: &[Joint<R>], steps: &'a mut [Step<R>]) -> Result<Self, MechanismError> {
        let steps = step_memory(steps, joints.len())?;
        let counts = check(joints, steps)?;
        Ok(finish(steps, counts))
    }
}

impl<R: Real> Mechanism<'_, R> {
    /// Writes the lower and the upper limit of each value of a configuration, infinite where there
    /// is no limit. These are the limits of the joint that has the value, narrowed by the limits of
    /// each joint that mimics it. Limits of a mimicking joint that would leave one value or none
    /// are ignored.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// use dq8_robot::{Joint, OwnedMechanism};
    /// let finger = Joint::prismatic(None, DualQuat::IDENTITY, [0.0, 1.0, 0.0]);
    /// let finger = finger.with_limits([0.0, 0.04]);
    /// let other = finger.with_limits([0.0, 0.06]).mimicking(0, 2.0, 0.0);
    /// let hand = OwnedMechanism::new(&[finger, other])?;
    /// let mut limits = [[0.0; 2]];
    /// hand.view().value_limits(&mut limits)?;
    /// assert_eq!(limits, [[0.0, 0.03]]); // where the other is at 0.06
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// If the length of `limits` is not [`values`](Self::values); nothing is written.
    pub fn value_limits(&self, limits: &mut [[R; 2]]) -> Result<(), ShapeError> {
        same_length("limits", limits.len(), self.values)?;
        limits.fill(unlimited());
        let slots = |step: &Step<R>| step.value as usize..step.value as usize + step.kind.values();
        for step in self.steps.iter().filter(|step| !step.mimics) {
            if let (Some(own), Some(slots)) = (step.limits, limits.get_mut(slots(step))) {
                slots.fill(own);
            }
        }
        for step in self.steps.iter().filter(|step| step.mimics) {
            if let Some(slot) = limits.get_mut(step.value as usize) {
                *slot = step.narrowed(*slot).unwrap_or(*slot);
            }
        }
        Ok(())
    }
}

impl<R: Real> Mechanism<'_, R> {
    /// Returns `true` if all joints are within their limits, including the joints that mimic
    /// others, and `false` if a value is NaN.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// use dq8_robot::{Joint, OwnedMechanism};
    /// let slide = Joint::prismatic(None, DualQuat::IDENTITY, [0.0, 0.0, 1.0]);
    /// let slide = slide.with_limits([0.0, 0.5]);
    /// let lift = OwnedMechanism::new(&[slide])?;
    /// let within = [0.0, 0.5, 0.6].map(|height| lift.view().within_limits(&[height]));
    /// assert_eq!(within, [Ok(true), Ok(true), Ok(false)]);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// If `values` does not have the length of a configuration.
    pub fn within_limits(&self, values: &[R]) -> Result<bool, ShapeError> {
        same_length("values", values.len(), self.values)?;
        let within = |step: &Step<R>| {
            let (Some([low, high]), Some(&value)) = (step.limits, values.get(step.value as usize))
            else {
                return true;
            };
            let value = if step.mimics { value * step.multiplier + step.offset } else { value };
            low <= value && value <= high
        };
        Ok(self.steps.iter().all(within) && !values.iter().any(|value| value.is_nan()))
    }
}

impl<R: Copy> Mechanism<'_, R> {
    /// Returns an error if the mechanism has no link of this index.
    pub(crate) fn check_link(&self, link: usize) -> Result<(), ShapeError> {
        let links = self.links();
        if link < links { Ok(()) } else { Err(ShapeError::NoLink { link, links }) }
    }

    /// Returns the count of links, which is also the count of joints.
    #[must_use]
    pub fn links(&self) -> usize {
        self.steps.len()
    }

    /// Returns the index of the link that carries `link`; `None` if the base carries it, or there
    /// is no such link.
    #[must_use]
    pub fn parent(&self, link: usize) -> Option<usize> {
        let parent = self.step(link)?.parent;
        (parent != NONE).then_some(parent as usize)
    }

    /// Returns the count of values of a configuration.
    #[must_use]
    #[doc(alias("nq"))]
    pub fn values(&self) -> usize {
        self.values
    }

    /// Returns the count of rates of a configuration, which is also the count of columns of a
    /// Jacobian.
    #[must_use]
    #[doc(alias("nv"))]
    pub fn rates(&self) -> usize {
        self.rates
    }

    /// Returns the degrees of freedom, which are as many as [`rates`](Self::rates). There are more
    /// [`values`](Self::values) if a joint is floating.
    #[must_use]
    pub fn dof(&self) -> usize {
        self.rates
    }

    /// Returns the indices of the values of a joint. For a joint that mimics another, this is the
    /// index of the value that it follows.
    #[must_use]
    pub fn values_of(&self, joint: usize) -> Option<core::ops::Range<usize>> {
        let step = self.step(joint)?;
        let first = step.value as usize;
        Some(if step.value == NONE { 0..0 } else { first..first + step.kind.values() })
    }

    /// Returns the indices of the rates of a joint, which are also the indices of its columns in a
    /// Jacobian. For a joint that mimics another, this is the index of the rate that it follows.
    #[must_use]
    pub fn rates_of(&self, joint: usize) -> Option<core::ops::Range<usize>> {
        let step = self.step(joint)?;
        let first = step.rate as usize;
        Some(if step.rate == NONE { 0..0 } else { first..first + step.kind.rates() })
    }

    /// Returns the limits of a joint. Limits of a mimicking joint are left out if
    /// [`value_limits`](Self::value_limits) ignores them. That method also gives the limits of each
    /// value, which joints that mimic may narrow.
    #[must_use]
    pub fn limits(&self, joint: usize) -> Option<[R; 2]> {
        self.step(joint)?.limits
    }

    /// Returns the step of a link. The `position` of the element at index `link` is the index of
    /// this step.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn step(&self, link: usize) -> Option<&Step<R>> {
        let position = self.steps.get(link)?.position;
        self.steps.get(position as usize)
    }
}

/// Returns the first `joints` steps of the memory, or an error if there are too few.
pub(crate) fn step_memory<R>(
    steps: &mut [Step<R>],
    joints: usize,
) -> Result<&mut [Step<R>], MechanismError> {
    let count = steps.len();
    let steps = steps.get_mut(..joints).filter(|steps| steps.len() < 1 << 28);
    steps.ok_or(MechanismError::Steps { steps: count, joints })
}

/// Writes the step of the joint with this `index`, but does not look up the joint that it mimics.
/// The indices of the joint's first value and first rate are the counts of values and rates so far,
/// which then grow. Steps are large, so the step is written in place, without a copy on the stack.
pub(crate) fn write_step<R: Real>(
    joint: &Joint<R>,
    index: usize,
    (values, rates): &mut (usize, usize),
    step: &mut Step<R>,
) -> Result<(), MechanismError> {
    *step = Step::of(joint, index)?;
    step.link = index as u32;
    if let Some(parent) = joint.parent {
        if parent >= index {
            return Err(MechanismError::Parent { joint: index, parent });
        }
        step.parent = parent as u32;
    }
    if joint.mimic.is_none() && step.kind.values() > 0 {
        (step.value, step.rate) = (*values as u32, *rates as u32);
        *values += step.kind.values();
        *rates += step.kind.rates();
    }
    Ok(())
}

/// Checks the joints, writes their steps in the order of the joints, and returns the counts of
/// values and of rates.
fn check<R: Real>(
    joints: &[Joint<R>],
    steps: &mut [Step<R>],
) -> Result<(usize, usize), MechanismError> {
    let mut counts = (0, 0);
    for (index, (joint, slot)) in joints.iter().zip(steps.iter_mut()).enumerate() {
        write_step(joint, index, &mut counts, slot)?;
    }
    for (index, joint) in joints.iter().enumerate() {
        let Some(mimic) = joint.mimic else { continue };
        let error = MechanismError::Mimic { joint: index, other: mimic.joint };
        let other = joints.get(mimic.joint).filter(|other| other.mimic.is_none());
        let leader = steps.get(mimic.joint).map(|leader| (leader.value, leader.rate));
        let range = other.and_then(|other| other.limits).unwrap_or(unlimited());
        let (Some(other), Some(leader)) = (other, leader) else {
            return Err(error);
        };
        if other.kind.values() != 1 || joint.kind.values() != 1 {
            return Err(error);
        }
        if let Some(step) = steps.get_mut(index) {
            (step.value, step.rate) = leader;
            // If the limits of the follower leave no range for the leader, the file's author cannot
            // have meant them, so they are dropped.
            if step.narrowed(range).is_none() {
                step.limits = None;
            }
        }
    }
    Ok(counts)
}

/// Writes the plans that the code for one configuration uses into the steps, puts the steps in
/// depth-first order, and returns the mechanism.
pub(crate) fn finish<R: Real>(
    steps: &mut [Step<R>],
    (values, rates): (usize, usize),
) -> Mechanism<'_, R> {
    plan(steps);
    order(steps);
    Mechanism { steps, values, rates }
}

/// Puts the steps in depth-first order, the largest branch last.
///
/// While one branch of a link is computed, the pose of the link is kept for its other children. For
/// its largest branch it need not be kept, because this branch is computed after the others. So at
/// most log₂(n) + 1 poses are kept at a time (the Strahler number of the tree), and memory of a
/// fixed size is enough.
// Steps are large, so no step is copied to the stack. The function is not inlined: otherwise its
// stack frame and the frame of `plan` would be needed at the same time.
#[inline(never)]
fn order<R>(steps: &mut [Step<R>]) {
    let count = steps.len();
    for index in (0..count).rev() {
        let Some(&Step { size, parent, .. }) = steps.get(index) else { return };
        let Some(&Step { largest, .. }) = steps.get(parent as usize) else { continue };
        let largest = steps.get(largest as usize).is_none_or(|other| size > other.size);
        if let Some(parent) = steps.get_mut(parent as usize) {
            parent.size += size;
            if largest {
                parent.largest = index as u32;
            }
        }
    }
    // The steps of a subtree fill a range. In the range of each link, the largest branch goes to
    // the end, and the other branches go before it.
    let mut free = 0;
    for index in 0..count {
        let Some(&Step { size, parent, .. }) = steps.get(index) else { return };
        let (mut position, mut slot, mut parent_slot) = (free, 0, 0);
        if let Some(parent) = steps.get_mut(parent as usize) {
            (position, slot, parent_slot) =
                (parent.position + parent.size - size, parent.slot, parent.slot);
            if parent.largest as usize != index {
                (position, slot) = (parent.twist, parent.slot + 1);
                parent.twist += size;
            }
        } else {
            free += size;
        }
        let Some(step) = steps.get_mut(index) else { return };
        (step.position, step.twist) = (position, position + 1);
        (step.slot, step.parent_slot) = (slot, parent_slot);
    }
    for index in 0..count {
        // Each swap puts one step at its final position.
        while let Some(step) = steps.get(index)
            && let Ok([here, there]) = steps.get_disjoint_mut([index, step.position as usize])
        {
            core::mem::swap(here, there);
        }
    }
    let mut twist = 0;
    for position in 0..count {
        let Some(step) = steps.get_mut(position) else { return };
        (step.twist, twist) = (twist, twist + step.kind.rates() as u32);
        let link = step.link;
        if let Some(of_link) = steps.get_mut(link as usize) {
            of_link.position = position as u32;
        }
    }
}

impl<'a, R: Real> Mechanism<'a, R> {
    /// Makes a serial arm from a product of exponentials, exp(½ξ₁q₁) … exp(½ξ_N q_N) tool
    /// (Brockett 1984; Lynch & Park, *Modern Robotics*, 2017, eq. 4.14). Each of the N screws is a
    /// joint, from the base outward, and each joint carries the next joint. Link N is the tool,
    /// fixed to the last joint. `steps` must hold at least N + 1 steps.
    ///
    /// A screw is the motion, in the frame of the base, that a value of 1 gives to all links beyond
    /// the joint while all other values are zero. The caller need not choose frames for the links.
    ///
    /// | angle | slide | joint |
    /// |---|---|---|
    /// | 1 | 0 | a hinge |
    /// | 1 | any | a thread, with `slide` as the length per radian |
    /// | 0 | 1 | a slide along the axis; the place of the axis does not matter |
    ///
    /// Each screw is paired with the limits of its joint, infinite for a joint without limits.
    /// `tool` is the pose of the tool while all values are zero. Axes and tool are normalized, so
    /// input with four decimals is precise enough. A component of the moment along the axis counts
    /// as rounding, and is left out.
    ///
    /// While all values are zero, the frames of the links are parallel to the base. The origin of a
    /// hinge's frame is the point of its axis that is nearest to the origin of the previous frame,
    /// so [`Reach::reach_bound`](crate::Reach::reach_bound) is the sum of the distances between
    /// successive axes.
    ///
    /// ```
    /// use dq8::geometry::Screw;
    /// use dq8_robot::{Mechanism, Step};
    /// use dq8::{DualQuat, Line};
    /// // Two links of length 1 in a plane.
    /// let hinge = |x| {
    ///     let axis = Line::from_point_direction([x, 0.0, 0.0], [0.0_f64, 0.0, 1.0]);
    ///     (Screw { axis, angle: 1.0, slide: 0.0 }, [-3.0, 3.0])
    /// };
    /// let (tool, mut steps) = (DualQuat::from_translation([2.0, 0.0, 0.0]), [Step::default(); 3]);
    /// let arm = Mechanism::from_screws(&[hinge(0.0), hinge(1.0)], tool, &mut steps)?;
    /// let [x, y, _] = arm.link_pose(&[0.0, core::f64::consts::FRAC_PI_2], 2)?.translation();
    /// assert!((x - 1.0).abs() < 1e-15 && (y - 1.0).abs() < 1e-15);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// If an axis or the tool is farther than 10⁻³ from unit or not finite (errors name the tool
    /// as joint N), a screw is not one of the three kinds in the table, limits are not in order, or
    /// there are fewer than N + 1 steps. In any of these cases `steps` may have been written.
    // The function is not inlined: otherwise its stack frame would be part of the frame of a caller
    // that goes on to a search by inverse kinematics.
    #[inline(never)]
    pub fn from_screws(
        screws: &[(Screw<R>, [R; 2])],
        tool: DualQuat<R>,
        steps: &'a mut [Step<R>],
    ) -> Result<Self, MechanismError> {
        let count = screws.len();
        let steps = step_memory(steps, count.saturating_add(1))?;
        let tool = Step::of(&Joint::fixed(None, tool), count)?.placement();
        let mut at = first_frame(screws, tool)?;
        let (mut before, mut counts) = ([R::ZERO; 3], (0, 0));
        let joints = screws.iter().map(Some).chain([None]);
        for ((index, screw), slot) in joints.enumerate().zip(steps.iter_mut()) {
            let back = DualQuat::from_translation(vector::scale(before, -R::ONE));
            let parent = index.checked_sub(1);
            let joint = if let Some((screw, limits)) = screw {
                let (kind, axis) = checked(screw, index)?;
                if !matches!(kind, JointKind::Prismatic { .. }) {
                    at = axis.closest_point(at);
                }
                let placement = back * DualQuat::from_translation(at);
                Joint::new(parent, placement, kind).with_limits(*limits)
            } else {
                Joint::fixed(parent, back * tool)
            };
            write_step(&joint, index, &mut counts, slot)?;
            before = at;
        }
        Ok(finish(steps, counts))
    }
}

/// Returns the place of the first joint, which is on the axis of the first hinge or thread. The
/// place of a slide does not matter, so slides before that hinge are placed there too. So no
/// distance from a slide to the hinge adds to the bound on the reach of the arm.
fn first_frame<R: Real>(
    screws: &[(Screw<R>, [R; 2])],
    tool: DualQuat<R>,
) -> Result<[R; 3], MechanismError> {
    for (index, (screw, _)) in screws.iter().enumerate() {
        let (kind, axis) = checked(screw, index)?;
        if !matches!(kind, JointKind::Prismatic { .. }) {
            return Ok(axis.closest_point_to_origin());
        }
    }
    Ok(tool.translation())
}

/// Returns the kind of joint that a screw describes, and its axis. The direction is normalized in
/// both.
fn checked<R: Real>(
    screw: &Screw<R>,
    joint: usize,
) -> Result<(JointKind<R>, Line<R>), MechanismError> {
    let Screw { axis: Line { direction, moment }, angle, slide } = *screw;
    let axis = unit(direction, joint)?;
    let moment = vector::over_norm(moment, vector::norm(direction));
    let kind = if angle == R::ZERO && slide == R::ONE {
        JointKind::Prismatic { axis }
    } else if angle != R::ONE || !slide.is_finite() {
        return Err(MechanismError::Screw { joint, angle: angle.into(), slide: slide.into() });
    } else if slide == R::ZERO {
        JointKind::Revolute { axis }
    } else {
        JointKind::Screw { axis, pitch: slide }
    };
    // The moment of a slide's axis does not change the motion, so only hinges and threads need a
    // finite moment.
    if angle == R::ONE {
        for number in moment {
            finite(number, "moment", joint)?;
        }
    }
    Ok((kind, Line { direction: axis, moment }))
}

/// A row of a table of Denavit and Hartenberg: turn by θ about z and move by d along z, turn by α
/// about x and move by a along x.
///
/// ```text
/// standard: turn θ about z, move d along z, move a along x, turn α about x
/// modified: turn α about x, move a along x, turn θ about z, move d along z
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dh<R> {
    /// The angle θ in radians. For a hinge, it is added to the value of the joint.
    pub theta: R,
    /// The offset d along z. For a slide, it is added to the value of the joint.
    pub d: R,
    /// The length a of the link, along x.
    pub a: R,
    /// The twist α of the link, about x, in radians.
    pub alpha: R,
    /// `true` for a slide, whose value moves along z; `false` for a hinge, whose value turns about
    /// z.
    pub slides: bool,
    /// The least and the largest value of the joint; `None` without limits.
    pub limits: Option<[R; 2]>,
}

/// The order in which a row's motions about and along x and z are multiplied.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DhConvention {
    /// First the motions about and along z, then those of x: A = Rz(θ) Tz(d) Tx(a) Rx(α) (Denavit
    /// & Hartenberg 1955; Paul; Spong).
    Standard,
    /// First the motions about and along x, then those of z: A = Rx(α) Tx(a) Rz(θ) Tz(d), where a
    /// and α belong to the preceding link (Craig, *Introduction to Robotics*).
    Modified,
}

impl<R: Real> Dh<R> {
    /// Returns the row of a hinge without limits; angles are in radians.
    #[must_use]
    pub fn hinge(theta: R, d: R, a: R, alpha: R) -> Self {
        Self { theta, d, a, alpha, slides: false, limits: None }
    }

    /// Returns the row of a slide without limits; angles are in radians.
    #[must_use]
    pub fn slide(theta: R, d: R, a: R, alpha: R) -> Self {
        Self { slides: true, ..Self::hinge(theta, d, a, alpha) }
    }

    /// Returns this row with the limits `[least, largest]` of the joint's value.
    #[must_use]
    pub fn with_limits(self, limits: [R; 2]) -> Self {
        Self { limits: Some(limits), ..self }
    }

    fn about_z(&self) -> DualQuat<R> {
        let turn = Quat::from_axis_angle([R::ZERO, R::ZERO, R::ONE], self.theta);
        DualQuat::from_rotation_translation(turn, [R::ZERO, R::ZERO, self.d])
    }

    fn about_x(&self) -> DualQuat<R> {
        let turn = Quat::from_axis_angle([R::ONE, R::ZERO, R::ZERO], self.alpha);
        DualQuat::from_rotation_translation(turn, [self.a, R::ZERO, R::ZERO])
    }
}

impl<'a, R: Real> Mechanism<'a, R> {
    /// Makes a serial arm from N rows, A₁ … A_N tool. Each row is a joint that turns about its
    /// z axis or slides along it. Link N is the tool, fixed to the last joint; if `tool` is the
    /// identity, link N is the last frame of the table. `steps` must hold at least N + 1 steps.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// use dq8_robot::{Dh, DhConvention, Mechanism, Step};
    /// // Two links of length 1 in a plane.
    /// let (rows, mut steps) = ([Dh::hinge(0.0_f64, 0.0, 1.0, 0.0); 2], [Step::default(); 3]);
    /// let (convention, tool) = (DhConvention::Standard, DualQuat::IDENTITY);
    /// let arm = Mechanism::from_dh(&rows, convention, tool, &mut steps)?;
    /// let [x, y, _] = arm.link_pose(&[0.0, core::f64::consts::FRAC_PI_2], 2)?.translation();
    /// assert!((x - 1.0).abs() < 1e-15 && (y - 1.0).abs() < 1e-15);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// If a component of a row is not finite (in the standard convention, errors in a and α name
    /// the following joint), limits are not in order, the tool is farther than 10⁻³ from unit
    /// (errors name it as joint N), or there are fewer than N + 1 steps. In any of these cases
    /// `steps` may have been written.
    pub fn from_dh(
        rows: &[Dh<R>],
        convention: DhConvention,
        tool: DualQuat<R>,
        steps: &'a mut [Step<R>],
    ) -> Result<Self, MechanismError> {
        let steps = step_memory(steps, rows.len().saturating_add(1))?;
        let (mut before, mut counts) = (DualQuat::IDENTITY, (0, 0));
        let axis = [R::ZERO, R::ZERO, R::ONE];
        let joints = rows.iter().map(Some).chain([None]);
        for ((index, row), slot) in joints.enumerate().zip(steps.iter_mut()) {
            let parent = index.checked_sub(1);
            let mut joint = Joint::fixed(parent, before * tool);
            if let Some(row) = row {
                // The row's rotation about z and translation along z commute with the motion of the
                // joint, which is about or along z too. So they can be part of the placement.
                let along_x = match convention {
                    DhConvention::Standard => core::mem::replace(&mut before, row.about_x()),
                    DhConvention::Modified => row.about_x(),
                };
                joint.placement = along_x * row.about_z();
                joint.limits = row.limits;
                joint.kind = match row.slides {
                    true => JointKind::Prismatic { axis },
                    false => JointKind::Revolute { axis },
                };
            }
            write_step(&joint, index, &mut counts, slot)?;
        }
        Ok(finish(steps, counts))
    }
}

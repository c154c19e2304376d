use super::error::MechanismError;
use super::joint::Joint;
use super::limits::endless;
use super::plan::plan;
use super::step::{NONE, Step};
use super::values::JointValues;
use dq8::seams::brief;
use dq8::storage::{Layout, same_length, whole_instances};
use dq8::{Real, ShapeError};

/// A tree of joints, checked once, of any number known at run time. It borrows its memory: a
/// [`Step`] for each joint. [`OwnedMechanism`](super::OwnedMechanism) has its own.
///
/// Link j is what joint j carries, so joints and links have one number; poses, twists and
/// accelerations are indexed by it, and so are goals. Values are one array for each configuration:
/// those of joint 0, then those of joint 1, and so on; joints that are fixed or mimic have none, so
/// that value j is not of joint j ([`values_of`](Self::values_of) says which are). Limits and
/// postures are indexed by value. Rates are numbered in the same way, apart from values, as a
/// floating joint has seven of those and six rates ([`rates_of`](Self::rates_of)); columns of a
/// Jacobian are indexed by rate.
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
    /// In an order in which what a link carries comes right after it, the largest branch last.
    pub(crate) steps: &'a [Step<R>],
    pub(crate) values: usize,
    pub(crate) rates: usize,
}

brief!([R] Mechanism<'_, R>: Mechanism |it| {
    links: it.steps.len(), values: it.values, rates: it.rates,
});

impl<'a, R: Real> Mechanism<'a, R> {
    /// Checks the joints and prepares them. It is here that axes along those of a frame, and
    /// placements without rotation or translation, are found, for which kernels do less.
    ///
    /// # Errors
    /// If a parent does not come before its joint, a placement or axis is farther than 10⁻³ from
    /// unit or not finite, limits are not in order, what should be mimicked has not one value of
    /// its own, or there are fewer steps than joints. `steps` may have been written.
    pub fn new(joints: &[Joint<R>], steps: &'a mut [Step<R>]) -> Result<Self, MechanismError> {
        let steps = room(steps, joints.len())?;
        let counts = check(joints, steps)?;
        Ok(planned(steps, counts))
    }
}

impl<R: Real> Mechanism<'_, R> {
    /// The least and the largest of each value, infinite where there is no limit: the limits of its
    /// joint, and of each joint that mimics it, as far as those leave more than one value of the
    /// range.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// use dq8_robot::{Joint, OwnedMechanism};
    /// let finger = Joint::prismatic(None, DualQuat::IDENTITY, [0.0, 1.0, 0.0]).with_limits([0.0, 0.04]);
    /// let other = finger.with_limits([0.0, 0.06]).mimicking(0, 2.0, 0.0);
    /// let hand = OwnedMechanism::new(&[finger, other])?;
    /// let mut limits = [[0.0; 2]];
    /// hand.view().value_limits(&mut limits)?;
    /// assert_eq!(limits, [[0.0, 0.03]]); // where the other is at 0.06
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// If there are not as many limits as values; nothing is written.
    pub fn value_limits(&self, limits: &mut [[R; 2]]) -> Result<(), ShapeError> {
        same_length("limits", limits.len(), self.values)?;
        limits.fill(endless());
        let slots = |step: &Step<R>| step.value as usize..step.value as usize + step.kind.values();
        for step in self.steps.iter().filter(|step| !step.mimics) {
            if let (Some(own), Some(slots)) = (step.limits, limits.get_mut(slots(step))) {
                slots.fill(own);
            }
        }
        for step in self.steps.iter().filter(|step| step.mimics) {
            if let Some(slot) = limits.get_mut(step.value as usize) {
                *slot = step.narrows(*slot).unwrap_or(*slot);
            }
        }
        Ok(())
    }
}

impl<R: Real> Mechanism<'_, R> {
    /// True if all joints are within their limits, those that mimic others too; false if a value is
    /// NaN.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// use dq8_robot::{Joint, OwnedMechanism};
    /// let slide = Joint::prismatic(None, DualQuat::IDENTITY, [0.0, 0.0, 1.0]).with_limits([0.0, 0.5]);
    /// let lift = OwnedMechanism::new(&[slide])?;
    /// let within = [0.0, 0.5, 0.6].map(|height| lift.view().within_limits(&[height]));
    /// assert_eq!(within, [Ok(true), Ok(true), Ok(false)]);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// If there are not as many values as a configuration has.
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
    /// How many configurations, or blocks of them, have as many `poses` if each has those of
    /// `links` links, and whether there are values for as many.
    pub(crate) fn configurations<Y: Layout, T: JointValues<Y>>(
        &self,
        values: &[T],
        links: usize,
        poses: usize,
    ) -> Result<usize, ShapeError> {
        let elements = whole_instances("poses", links, poses)?;
        T::check("values", values, self.values, elements)?;
        Ok(elements)
    }

    /// How many links there are: one for each joint.
    #[must_use]
    pub fn links(&self) -> usize {
        self.steps.len()
    }

    /// The link that carries a link; none if the base does, or there is no such link.
    #[must_use]
    pub fn parent(&self, link: usize) -> Option<usize> {
        let parent = self.step(link)?.parent;
        (parent != NONE).then_some(parent as usize)
    }

    /// How many values a configuration has.
    #[must_use]
    #[doc(alias("nq"))]
    pub fn values(&self) -> usize {
        self.values
    }

    /// How many rates, and columns of a Jacobian, a configuration has.
    #[must_use]
    #[doc(alias("nv"))]
    pub fn rates(&self) -> usize {
        self.rates
    }

    /// The degrees of freedom of a configuration: as many as [`rates`](Self::rates). Floating
    /// joints have more [`values`](Self::values) than that.
    #[must_use]
    pub fn dof(&self) -> usize {
        self.rates
    }

    /// Where the values of a joint are among all; of a joint that mimics, the value that it takes.
    #[must_use]
    pub fn values_of(&self, joint: usize) -> Option<core::ops::Range<usize>> {
        let step = self.step(joint)?;
        let first = step.value as usize;
        Some(if step.value == NONE { 0..0 } else { first..first + step.kind.values() })
    }

    /// The place of a joint's rates among all, and of its columns in a Jacobian; of a joint that
    /// mimics, the rate that moves it.
    #[must_use]
    pub fn rates_of(&self, joint: usize) -> Option<core::ops::Range<usize>> {
        let step = self.step(joint)?;
        let first = step.rate as usize;
        Some(if step.rate == NONE { 0..0 } else { first..first + step.kind.rates() })
    }

    /// The limits of a joint, if it has any that bind; [`value_limits`](Self::value_limits) has
    /// those of its value, which joints that mimic it may narrow.
    #[must_use]
    pub fn limits(&self, joint: usize) -> Option<[R; 2]> {
        self.step(joint)?.limits
    }

    /// The step of a link.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn step(&self, link: usize) -> Option<&Step<R>> {
        let position = self.steps.get(link)?.position;
        self.steps.get(position as usize)
    }
}

/// As many steps as there are joints.
pub(crate) fn room<R>(
    steps: &mut [Step<R>],
    joints: usize,
) -> Result<&mut [Step<R>], MechanismError> {
    let count = steps.len();
    let steps = steps.get_mut(..joints).filter(|steps| steps.len() < 1 << 28);
    steps.ok_or(MechanismError::Steps { steps: count, joints })
}

/// Writes the step of joint number `index`, but for what it mimics, with the next of the values and
/// rates that have been counted. Steps are large: none is copied on the stack.
pub(crate) fn numbered<R: Real>(
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

/// Writes the steps in the order of the joints. How many values and rates they have.
fn check<R: Real>(
    joints: &[Joint<R>],
    steps: &mut [Step<R>],
) -> Result<(usize, usize), MechanismError> {
    let mut counts = (0, 0);
    for (index, (joint, slot)) in joints.iter().zip(steps.iter_mut()).enumerate() {
        numbered(joint, index, &mut counts, slot)?;
    }
    for (index, joint) in joints.iter().enumerate() {
        let Some(mimic) = joint.mimic else { continue };
        let error = MechanismError::Mimic { joint: index, other: mimic.joint };
        let other = joints.get(mimic.joint).filter(|other| other.mimic.is_none());
        let leader = steps.get(mimic.joint).map(|leader| (leader.value, leader.rate));
        let range = other.and_then(|other| other.limits).unwrap_or(endless());
        let (Some(other), Some(leader)) = (other, leader) else {
            return Err(error);
        };
        if other.kind.values() != 1 || joint.kind.values() != 1 {
            return Err(error);
        }
        if let Some(step) = steps.get_mut(index) {
            (step.value, step.rate) = leader;
            // What leaves nothing of the leader's range is not meant.
            if step.narrows(range).is_none() {
                step.limits = None;
            }
        }
    }
    Ok(counts)
}

/// The mechanism of steps in the order of the joints, which have so many values and rates.
pub(crate) fn planned<R: Real>(
    steps: &mut [Step<R>],
    (values, rates): (usize, usize),
) -> Mechanism<'_, R> {
    plan(steps);
    order(steps);
    Mechanism { steps, values, rates }
}

/// Depth first, the largest branch last. So a pose is kept for its children only while other
/// branches are computed, all of them no larger than the last one: log₂(n) + 1 poses are kept at
/// most (Strahler's number), in memory of a fixed size.
// Steps are large: none is copied to the stack. A frame of its own, so that it does not lie under
// that of `plan`.
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
    // The largest branch goes to the end of what belongs to its parent, the others to the front.
    let mut free = 0;
    for index in 0..count {
        let Some(&Step { size, parent, .. }) = steps.get(index) else { return };
        let (mut position, mut slot, mut parent_slot) = (free, 0, 0);
        if let Some(parent) = steps.get_mut(parent as usize) {
            (position, slot, parent_slot) =
                (parent.position + parent.size - size, parent.slot, parent.slot);
            if parent.largest as usize != index {
                (position, slot) = (parent.free, parent.slot + 1);
                parent.free += size;
            }
        } else {
            free += size;
        }
        let Some(step) = steps.get_mut(index) else { return };
        (step.position, step.free) = (position, position + 1);
        (step.slot, step.parent_slot) = (slot, parent_slot);
    }
    for index in 0..count {
        // Each swap puts one step where it belongs.
        while let Some(step) = steps.get(index)
            && let Ok([here, there]) = steps.get_disjoint_mut([index, step.position as usize])
        {
            core::mem::swap(here, there);
        }
    }
    for position in 0..count {
        let Some(&Step { link, .. }) = steps.get(position) else { return };
        if let Some(of_link) = steps.get_mut(link as usize) {
            of_link.position = position as u32;
        }
    }
}

//! A serial arm from the screws of its joints, for which no frames have to be laid into the links.

use super::error::MechanismError;
use super::joint::{Joint, JointKind};
use super::step::{Step, finite, unit};
use super::tree::{Mechanism, numbered, planned, room};
use dq8::Real;
use dq8::geometry::{Line, Screw};
use dq8::scalar::{DualQuat, vector};

impl<'a, R: Real> Mechanism<'a, R> {
    /// A serial arm as a product of exponentials, exp(½ξ₁q₁) … exp(½ξ_N q_N) tool
    /// (Brockett 1984; Lynch & Park, *Modern Robotics*, 2017, eq. 4.14): a joint for each of N
    /// screws, the one at the base first, each on the one before, and as link N the tool, fixed to
    /// the last. `steps` are N + 1.
    ///
    /// A screw says how a joint moves what hangs on it, for a value of 1, in the frame of the base,
    /// where all values are zero. With the angle 1 and no slide it is a hinge; with the angle 1, a
    /// thread that slides so far for each radian; with the angle 0 and the slide 1, a slide along
    /// the direction of its axis, wherever that is. (What of the moment lies along the axis is
    /// rounding, and left out.) Beside it are the limits of the joint, infinite where there are
    /// none. `tool` is the pose of the tool where all values are zero. Axes and tool are made
    /// exactly unit, so that numbers with four decimals will do.
    ///
    /// The frames of links are parallel to the base where all values are zero, that of a hinge at
    /// the point of its axis that is nearest to the frame before: so
    /// [`Reach::reach_bound`](crate::Reach::reach_bound) is the sum of the ways from axis to axis.
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
    /// If an axis or the tool, as that of joint N, is farther than 10⁻³ from unit or not finite,
    /// a screw is none of the three, limits are not in order, or there are fewer steps than N + 1.
    /// `steps` may have been written.
    // A frame of its own, so that it does not lie under that of a search.
    #[inline(never)]
    pub fn from_screws(
        screws: &[(Screw<R>, [R; 2])],
        tool: DualQuat<R>,
        steps: &'a mut [Step<R>],
    ) -> Result<Self, MechanismError> {
        let count = screws.len();
        let steps = room(steps, count.saturating_add(1))?;
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
            numbered(&joint, index, &mut counts, slot)?;
            before = at;
        }
        Ok(planned(steps, counts))
    }
}

/// Where the first joint is: on the axis that is the first of a hinge or a thread. Slides are
/// anywhere, so those before it are there too, and the way to it is no part of what the arm spans.
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

/// What a screw is, with an axis that is exactly unit.
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
    // A slide is the same wherever its axis is.
    if angle == R::ONE {
        for number in moment {
            finite(number, "moment", joint)?;
        }
    }
    Ok((kind, Line { direction: axis, moment }))
}

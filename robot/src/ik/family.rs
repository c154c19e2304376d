//! [`Geometry`], the family, axes and lengths of an arm of six hinges, which are computed once; and
//! [`SolutionsError`], the error of joints that are not such an arm.
//!
//! The drawing shows both families where all values are zero. An `o` is an axis toward the reader,
//! a `*` a point. The plane of the drawing is the *plane of the elbow*, at right angles to axis 2.
//!
//! ```text
//!  spherical wrist                            three parallel axes
//!
//!                axis 3                                     axis 3
//!                  o                                          o
//!       upper    /   \    lower                    upper    /   \    lower
//!        arm   /       \   arm                      arm   /       \   arm
//!            /           \                              /           \
//!   axis 2  o             * - - - tool         axis 2  o             o  axis 4
//!           :           wrist: axes                    :             |  hand
//!           :           4, 5, 6 meet                   :             * - - - tool
//!     base  *                                    base  *           wrist: axes 5, 6 meet
//!           |  axis 1                                  |  axis 1
//! ```
//!
//! Axis 1 need not lie in this plane, nor meet axis 2. The *shoulder* is the angle about axis 1. It
//! brings the wrist to its `height` along axis 2, because no other angle of the arm changes this
//! height. The *elbow* is the angle about axis 3. It follows from the distance between axis 2 and
//! the end of the lower arm (the wrist, or axis 4), which is within `elbow_reach`. The *wrist* is
//! the angle about axis 5. It follows from the angle between axis 6 and `wrist_reference`, which is
//! axis 4, or axis 2 of an arm with three parallel axes.
//!
//! A third kind of arm counts as an arm with a spherical wrist: axes 1 and 2 intersect in `base`,
//! and axis 3 has any direction (`crosses`). Then the elbow follows from the distance between
//! `base` and the wrist, and the first two angles from the direction to the wrist.

use super::problem::Reach;
use crate::mechanism::joint::JointKind;
use dq8::internal::errors;
use dq8::scalar::vector::{add, cross, dot, norm, scale, sub};
use dq8::scalar::{DualQuat, vector};
use dq8::{Real, ShapeError};

/// The family of an arm, by the positions of its six axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Family {
    /// The last three axes meet in a point, and either the second and third axis are parallel or
    /// the first two axes meet. Such an arm has a shoulder, an elbow, and a spherical wrist (PUMA,
    /// and most arms that weld, paint and lift).
    SphericalWrist,
    /// The second, third and fourth axis are parallel, and the last two axes meet (UR and other
    /// arms that work beside people).
    ThreeParallel,
    /// The arm belongs to neither of the two families.
    Other,
}

errors! {
    /// The reason why solutions cannot be computed: joints that are no arm of six hinges, or an
    /// invalid target or start.
    #[derive(Clone, Debug, PartialEq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    SolutionsError {
        /// The lengths of two slices do not fit each other, or the scratch is too short.
        Shape(error: ShapeError) => "{error}";
        /// The problem has more goals than one.
        Goals { goals: usize = "The number of goals." } => "expected one goal, got {goals}";
        /// The goal leaves a part of rotation or position free.
        NoPose => "the goal leaves a part of rotation or position free: expected a whole pose";
        /// A joint that carries the link is neither fixed nor a hinge with a value of its own.
        Joint { joint: usize = "The joint." }
            => "joint {joint} carries the link: expected a hinge with a value of its own, or a fixed joint";
        /// More or fewer than six hinges carry the link.
        Hinges { hinges: usize = "The number of hinges." } => "{hinges} hinges carry the link, not six";
        /// A component of a target is not finite.
        Target { index: usize = "The target.", value: f64 = "The component that is not finite." }
            => "target {index} is not finite: it has the number {value}";
        /// A target is farther than 10⁻³ from a unit motion.
        NotUnit { index: usize = "The target.", norm: f64 = "The norm of its real part." }
            => "target {index} is not a unit motion: the norm of its real part is {norm}";
        /// A joint value of a start, the configuration to which solutions should be near, is not
        /// finite.
        Start { index: usize = "The start.", hinge: usize = "The hinge.", value: f64 = "The value." }
            => "value {hinge} of start {index} is not finite: {value}";
    }
}

/// The axes, points and lengths of an arm whose values are all zero, in the frame of the base. The
/// drawing of this module shows them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Geometry<R> {
    pub(super) family: Family,
    pub(super) axes: [[R; 3]; 6],
    /// The inverse of the tool's pose where all values are zero. The product of a target and this
    /// inverse is the product of the turns about the six axes.
    pub(super) home_inverse: DualQuat<R>,
    /// `true` if the first two axes intersect in `base` and the formulas for links that move in a
    /// plane do not fit the arm.
    pub(super) crosses: bool,
    /// A point of the first axis.
    pub(super) base: [R; 3],
    /// The point where axes 5 and 6 meet, and for a spherical wrist axis 4 too.
    pub(super) wrist: [R; 3],
    /// The vector from the base to the third axis. It is used only if `crosses` is `true`.
    pub(super) upper_arm: [R; 3],
    /// The vector from the third axis to the wrist. It is used only if `crosses` is `true`.
    pub(super) lower_arm: [R; 3],
    /// The vector from the wrist to the fourth axis. It is used only for three parallel axes.
    pub(super) hand: [R; 3],
    /// The smallest and the largest distance of the lower arm's end from the second axis, or from
    /// the point where the first two axes intersect.
    pub(super) elbow_reach: [R; 2],
    /// Two directions that span the plane of the elbow.
    pub(super) plane: [[R; 3]; 2],
    /// The coordinates of `base` in the plane of the elbow, relative to the second axis.
    pub(super) base_in_plane: [R; 2],
    /// The vectors of the upper and the lower arm in the plane of the elbow.
    pub(super) links_in_plane: [[R; 2]; 2],
    /// The angle of the upper arm minus that of the lower arm where all values are zero, as a
    /// complex number of length 1.
    pub(super) elbow_at_zero: [R; 2],
    /// The directions of the third and fourth axis: 1 if parallel to the second axis, −1 if
    /// opposite to it.
    pub(super) signs: [R; 2],
    /// The distance from the base to the wrist along the second axis.
    pub(super) height: R,
    /// The cosine of the angle between the first two axes.
    pub(super) tilt: R,
    /// The direction whose angle with the last axis determines the fifth angle: axis 4, or axis 2
    /// of an arm with three parallel axes.
    pub(super) wrist_reference: [R; 3],
    /// Two directions at right angles to the last axis.
    pub(super) across_last: [[R; 3]; 2],
    /// A length that is typical for the arm.
    pub(super) size: R,
    /// The largest angle by which axes that count as parallel may differ, in radians, and the
    /// largest distance between axes that count as meeting, as a fraction of `size`:
    /// [`exact_tolerance`], or [`NEAR`] for an arm that is only nearly of its family.
    pub(super) tolerance: R,
}

/// Returns the tolerance within which axes count as parallel or as meeting. Axes that were given
/// with nine decimals, or computed as products of rounded rotations, deviate by less.
pub(super) fn exact_tolerance<R: Real>() -> R {
    if R::EPSILON > R::from(1e-10) { R::from(1e-5) } else { R::from(1e-8) }
}

/// The tolerance for arms that were described with few digits, such as 1.57 for a quarter turn.
const NEAR: f32 = 1e-3;

impl<R: Real> Geometry<R> {
    /// Returns `true` if the formulas of the family fit the arm exactly.
    pub(super) fn is_exact(&self) -> bool {
        self.tolerance <= exact_tolerance()
    }

    /// Finds the geometry of the arm that carries the only goal.
    ///
    /// # Errors
    /// If the joints that carry the goal are not an arm of six hinges.
    pub(super) fn of(reach: &Reach<'_, R>) -> Result<Self, SolutionsError> {
        let &[goal] = reach.goals else {
            return Err(SolutionsError::Goals { goals: reach.goals.len() });
        };
        if !goal.is_pose() {
            return Err(SolutionsError::NoPose);
        }
        let (mut axes, mut points, mut hinges) = ([[R::ZERO; 3]; 6], [[R::ZERO; 3]; 6], 0);
        let mut pose = DualQuat::IDENTITY;
        for (position, step) in reach.mechanism.steps.iter().enumerate() {
            if !reach.moves(position, &goal) {
                continue;
            }
            pose = pose * step.placement();
            match step.kind {
                JointKind::Fixed => continue,
                JointKind::Revolute { axis } if !step.mimics => {
                    if let (Some(slot), Some(point)) =
                        (axes.get_mut(hinges), points.get_mut(hinges))
                    {
                        (*slot, *point) = (pose.transform_vector(axis), pose.translation());
                    }
                    hinges += 1;
                }
                _ => return Err(SolutionsError::Joint { joint: step.link as usize }),
            }
        }
        if hinges != 6 {
            return Err(SolutionsError::Hinges { hinges });
        }
        let tool = pose.transform_point(goal.point);
        let mut size = norm(points[0]) + norm(sub(tool, points[5]));
        for pair in points.windows(2) {
            size = size + norm(sub(pair[1], pair[0]));
        }
        let tool = pose * DualQuat::from_translation(goal.point);
        let within = |tolerance| Self::new(axes, points, tool, size, tolerance);
        let exact = within(exact_tolerance());
        Ok(if exact.family == Family::Other { within(R::from(NEAR)) } else { exact })
    }

    fn new(
        axes: [[R; 3]; 6],
        points: [[R; 3]; 6],
        tool: DualQuat<R>,
        size: R,
        tolerance: R,
    ) -> Self {
        let slack = tolerance * size;
        let is_off = |point, i: usize| norm(cross(axes[i], sub(point, points[i]))) > slack;
        let parallel = |i: usize, j: usize| norm(cross(axes[i], axes[j])) <= tolerance;
        let normal = axes[1];
        let direction = any_across(normal);
        let plane = [direction, cross(normal, direction)];
        let in_plane = |v| plane.map(|direction| dot(direction, v));
        let last = any_across(axes[5]);

        // This is the point where the last two axes meet, if `meets` is `true`.
        let wrist = meeting([points[4], points[5]], [axes[4], axes[5]]);
        let meets = !parallel(4, 5) && !is_off(wrist, 4) && !is_off(wrist, 5);
        let is_wrist = meets && !is_off(wrist, 3) && !parallel(3, 4);
        let is_parallel = meets && parallel(1, 3) && !parallel(1, 4);
        let (family, end_of_arm, wrist_reference) = if is_wrist {
            (Family::SphericalWrist, wrist, axes[3])
        } else if is_parallel {
            (Family::ThreeParallel, points[3], normal)
        } else {
            (Family::Other, wrist, normal)
        };
        let links_in_plane =
            [in_plane(sub(points[2], points[1])), in_plane(sub(end_of_arm, points[2]))];
        let lengths = links_in_plane.map(norm);
        let [[a, b], [c, d]] = links_in_plane;
        let mut geometry = Self {
            family,
            axes,
            home_inverse: tool.conjugate(),
            crosses: false,
            base: points[0],
            wrist,
            upper_arm: [R::ZERO; 3],
            lower_arm: [R::ZERO; 3],
            hand: sub(end_of_arm, wrist),
            elbow_reach: [(lengths[0] - lengths[1]).abs(), lengths[0] + lengths[1]],
            plane,
            base_in_plane: in_plane(sub(points[0], points[1])),
            links_in_plane,
            elbow_at_zero: unit([a * c + b * d, b * c - a * d]),
            signs: [2, 3].map(|i| if dot(normal, axes[i]) < R::ZERO { -R::ONE } else { R::ONE }),
            height: dot(normal, sub(wrist, points[0])),
            tilt: dot(normal, axes[0]),
            wrist_reference,
            across_last: [last, cross(axes[5], last)],
            size,
            tolerance,
        };
        let bends = parallel(1, 2) && !parallel(0, 1) && lengths.iter().all(|&l| l > slack);
        if !bends {
            let crossing = meeting([points[0], points[1]], [axes[0], axes[1]]);
            let is_crossing = is_wrist && !parallel(0, 1) && !is_off(crossing, 1);
            let is_family = is_crossing && geometry.cross(crossing, points[2]);
            geometry.family = if is_family { family } else { Family::Other };
        }
        geometry
    }

    /// Sets `base` to the point at which the first two axes intersect, and the lengths that follow
    /// from it. Returns `true` if the third axis changes the distance between `base` and the wrist.
    fn cross(&mut self, crossing: [R; 3], elbow: [R; 3]) -> bool {
        let (upper, lower, axis) = (sub(elbow, crossing), sub(self.wrist, elbow), self.axes[2]);
        let (a, b) = (cross(axis, upper), cross(axis, lower));
        let (lengths, along) = ([norm(a), norm(b)], dot(axis, add(upper, lower)));
        (self.crosses, self.base) = (true, crossing);
        (self.upper_arm, self.lower_arm) = (upper, lower);
        self.elbow_reach =
            [lengths[0] - lengths[1], lengths[0] + lengths[1]].map(|l| norm([l, along]));
        self.elbow_at_zero = unit([dot(a, b), dot(upper, b)]);
        lengths.iter().all(|&length| length > self.tolerance * self.size)
    }
}

fn unit<R: Real, const N: usize>(v: [R; N]) -> [R; N] {
    vector::over_norm(v, norm(v))
}

/// Returns any unit vector at right angles to `v`.
fn any_across<R: Real>(v: [R; 3]) -> [R; 3] {
    let mut least = [R::ZERO; 3];
    let index = usize::from(v[1].abs() < v[0].abs());
    let index = if v[2].abs() < v[index].abs() { 2 } else { index };
    least[index] = R::ONE;
    unit(sub(least, scale(v, dot(v, least))))
}

/// Returns the point of the first line that is nearest to the second line. It is not finite if the
/// lines are parallel.
fn meeting<R: Real>([p, q]: [[R; 3]; 2], [a, b]: [[R; 3]; 2]) -> [R; 3] {
    let across = cross(a, b);
    add(p, scale(a, dot(cross(sub(q, p), b), across) / dot(across, across)))
}

//! What is known of an arm of six hinges before a target is: found once, where it is made.

use super::problem::Reach;
use super::six_axis::SolutionsError;
use crate::mechanism::joint::JointKind;
use dq8::Real;
use dq8::scalar::vector::{add, cross, dot, norm, scale, sub};
use dq8::scalar::{DualQuat, vector};

/// How the six axes lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Family {
    /// The last three axes meet in a point, and the second and third are parallel, or the first two
    /// meet: a shoulder, an elbow, and a spherical wrist (PUMA, and most of what welds, paints and
    /// lifts).
    SphericalWrist,
    /// The second, third and fourth axis are parallel, and the last two meet (UR and other arms
    /// that work beside people).
    ThreeParallel,
    /// Neither.
    Other,
}

/// Axes, and the lengths between them, in the frame of the base where all values are zero.
#[derive(Clone, Copy, Debug)]
pub(super) struct Geometry<R> {
    pub(super) family: Family,
    pub(super) axes: [[R; 3]; 6],
    /// From a target to the motion of what is fixed to the tool.
    pub(super) back: DualQuat<R>,
    /// A point on the first axis, that where the second crosses it if `crosses`; and where the last
    /// axes meet.
    pub(super) crosses: bool,
    pub(super) base: [R; 3],
    pub(super) centre: [R; 3],
    /// From the base to the third axis; from there to the centre, or of three parallel axes from
    /// the centre to the fourth.
    pub(super) upper: [R; 3],
    pub(super) lower: [R; 3],
    /// How near to the second axis, or to where it crosses the first, the end of the lower arm
    /// gets, and how far from it.
    pub(super) spans: [R; 2],
    /// Two directions across the second axis, in which the elbow is a plane one; the base in it,
    /// from the second axis.
    pub(super) across: [[R; 3]; 2],
    pub(super) origin: [R; 2],
    /// The links there: from the second to the third axis, and from there to the centre or the
    /// fourth axis; and the angle between them about the third axis.
    pub(super) links: [[R; 2]; 2],
    pub(super) between: [R; 2],
    /// Which way the third and fourth axis turn there.
    pub(super) signs: [R; 2],
    /// How high the centre is over the base along the second axis, and how much of that axis is
    /// along the first.
    pub(super) height: R,
    pub(super) tilt: R,
    /// What the fifth axis turns the last against.
    pub(super) against: [R; 3],
    /// Two directions across the last axis.
    pub(super) end: [[R; 3]; 2],
    /// A length that is typical for the arm.
    pub(super) size: R,
    /// How far from parallel, or apart, its axes may be: [`fit`], or of an arm that is only nearly
    /// of its family, [`NEAR`].
    pub(super) fit: R,
}

/// How far from parallel, or apart, axes may be: what numbers of nine decimals, or chains of
/// rounded turns, differ by.
pub(super) fn fit<R: Real>() -> R {
    if R::EPSILON > R::from(1e-10) { R::from(1e-5) } else { R::from(1e-8) }
}

/// The same of arms that somebody typed: 1.57 is nearer to a quarter turn.
const NEAR: f32 = 1e-3;

impl<R: Real> Geometry<R> {
    /// Whether the formulas of the family are those of the arm.
    pub(super) fn is_exact(&self) -> bool {
        self.fit <= fit()
    }

    /// The arm that carries the only goal.
    ///
    /// # Errors
    /// If it is none of six hinges.
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
        let of = |fit| Self::new(axes, points, tool, size, fit);
        let exact = of(fit());
        Ok(if exact.family == Family::Other { of(R::from(NEAR)) } else { exact })
    }

    fn new(axes: [[R; 3]; 6], points: [[R; 3]; 6], tool: DualQuat<R>, size: R, fit: R) -> Self {
        let slack = fit * size;
        let is_off = |point, i: usize| norm(cross(axes[i], sub(point, points[i]))) > slack;
        let parallel = |i: usize, j: usize| norm(cross(axes[i], axes[j])) <= fit;
        let normal = axes[1];
        let first_of = any_across(normal);
        let across = [first_of, cross(normal, first_of)];
        let plane = |v| across.map(|direction| dot(direction, v));
        let last = any_across(axes[5]);

        // Where the last two axes meet, if they do.
        let centre = meeting([points[4], points[5]], [axes[4], axes[5]]);
        let meets = !parallel(4, 5) && !is_off(centre, 4) && !is_off(centre, 5);
        let is_wrist = meets && !is_off(centre, 3) && !parallel(3, 4);
        let is_parallel = meets && parallel(1, 3) && !parallel(1, 4);
        let (family, end_of_arm, against) = if is_wrist {
            (Family::SphericalWrist, centre, axes[3])
        } else if is_parallel {
            (Family::ThreeParallel, points[3], normal)
        } else {
            (Family::Other, centre, normal)
        };
        let links = [plane(sub(points[2], points[1])), plane(sub(end_of_arm, points[2]))];
        let lengths = links.map(norm);
        let [[a, b], [c, d]] = links;
        let mut geometry = Self {
            family,
            axes,
            back: tool.conjugate(),
            crosses: false,
            base: points[0],
            centre,
            upper: [R::ZERO; 3],
            lower: sub(end_of_arm, centre),
            spans: [(lengths[0] - lengths[1]).abs(), lengths[0] + lengths[1]],
            across,
            origin: plane(sub(points[0], points[1])),
            links,
            between: unit([a * c + b * d, b * c - a * d]),
            signs: [2, 3].map(|i| if dot(normal, axes[i]) < R::ZERO { -R::ONE } else { R::ONE }),
            height: dot(normal, sub(centre, points[0])),
            tilt: dot(normal, axes[0]),
            against,
            end: [last, cross(axes[5], last)],
            size,
            fit,
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

    /// Takes the point where the first two axes cross for the base. Whether the third axis then
    /// moves the centre to or from it.
    fn cross(&mut self, crossing: [R; 3], elbow: [R; 3]) -> bool {
        let (upper, lower, axis) = (sub(elbow, crossing), sub(self.centre, elbow), self.axes[2]);
        let (a, b) = (cross(axis, upper), cross(axis, lower));
        let (lengths, along) = ([norm(a), norm(b)], dot(axis, add(upper, lower)));
        (self.crosses, self.base, self.upper, self.lower) = (true, crossing, upper, lower);
        self.spans = [lengths[0] - lengths[1], lengths[0] + lengths[1]].map(|l| norm([l, along]));
        self.between = unit([dot(a, b), dot(upper, b)]);
        lengths.iter().all(|&length| length > self.fit * self.size)
    }
}

fn unit<R: Real, const N: usize>(v: [R; N]) -> [R; N] {
    vector::over_norm(v, norm(v))
}

/// A unit vector across another.
fn any_across<R: Real>(v: [R; 3]) -> [R; 3] {
    let mut least = [R::ZERO; 3];
    let index = usize::from(v[1].abs() < v[0].abs());
    let index = if v[2].abs() < v[index].abs() { 2 } else { index };
    least[index] = R::ONE;
    unit(sub(least, scale(v, dot(v, least))))
}

/// The point of the first line that is nearest to the second; not finite where they are parallel.
fn meeting<R: Real>([p, q]: [[R; 3]; 2], [a, b]: [[R; 3]; 2]) -> [R; 3] {
    let across = cross(a, b);
    add(p, scale(a, dot(cross(sub(q, p), b), across) / dot(across, across)))
}

use super::vector::{self, Length};
use super::{DualQuat, Quat};
use crate::macros::errors;
use crate::number::Real;
use crate::quick;

errors! {
    /// The error of a limb that [`TwoBone`](crate::ik::TwoBone) cannot bend.
    #[derive(Clone, Copy, Debug, PartialEq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    LimbError {
        /// A bone has a negative or infinite length, or NaN.
        Length {
            /// The index of the bone, 0 for the bone at the root.
            bone: usize,
            /// The length of the bone.
            value: f64,
        } => "bone {bone} cannot have the length {value}";
        /// A coordinate is not finite.
        NotFinite {
            /// The name of the vector.
            what: &'static str,
            /// The index of the coordinate in the vector.
            index: usize,
            /// The value of the coordinate.
            value: f64,
        } => "the {what} is not finite: coordinate {index} is {value}";
    }
}

/// A limb of two bones with a hinge between them, posed so that its end is at a target: hip, knee
/// and ankle, or shoulder, elbow and wrist.
///
/// The limb lies in the plane of the target and the *pole*, and the knee is on the side of the
/// pole. In the rest pose, where all rotations are the identity, both bones run along x and the
/// hinge turns about z, so that the knee bends toward −y and each bone's frame has x along the
/// bone. If the axes of a limb in its rest pose are the columns of another rotation F, the rotation
/// of its upper bone is `upper * F.conjugate()`.
///
/// ```
/// use dq8::ik::{Span, TwoBone};
/// // A leg of 0.4 and 0.4 under a hip at height 0.8, its foot on a step; the knee bends to +y.
/// let hip = [0.0_f64, 0.0, 0.8];
/// let leg = TwoBone::reach(hip, [0.4, 0.4], [0.0, 0.2, 0.2], [0.0, 1.0, 0.0])?;
/// assert_eq!(leg.span, Span::Within);
/// let knee = leg.upper.rotate([0.4, 0.0, 0.0]);
/// let shin = leg.lower.rotate([0.4, 0.0, 0.0]);
/// assert!((hip[2] + knee[2] + shin[2] - 0.2).abs() < 1e-15);
/// assert!(knee[1] > 0.2);
/// # Ok::<(), dq8::ik::LimbError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[doc(alias("IKTwoBoneJob"))]
pub struct TwoBone<R> {
    /// The rotation of the bone at the root, in the frame in which root and target are given.
    pub upper: Quat<R>,
    /// The rotation of the second bone in the same frame: `upper` times a turn by `bend` about z.
    pub lower: Quat<R>,
    /// The angle of the hinge in radians, 0 for a stretched limb and π for a folded limb.
    pub bend: R,
    /// The relation of the target's distance to the reach of the limb.
    pub span: Span,
    /// The distance of the end from the target. It is zero, except for rounding, if `span` is
    /// [`Span::Within`].
    pub missed: R,
}

/// The relation of a target's distance from the root to the distances that the limb can reach.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Span {
    /// The limb can reach the target.
    Within,
    /// The target is too far away: the limb is stretched toward it.
    Stretched,
    /// The target is nearer than the difference of the bones' lengths: the limb is folded. The bone
    /// at the root points toward the target if it is the longer bone, and away from the target
    /// otherwise.
    Folded,
}

impl<R: Real> TwoBone<R> {
    /// Bends a limb so that its end is at `target`. Its root is at `root`, and `lengths` are those
    /// of its bones, the bone at the root first. The knee is on the side to which the direction
    /// `pole`, of any length, points.
    ///
    /// The bones a and b and the distance D to the target are the sides of a triangle. Its angles
    /// at the root and at the knee are computed from the sides by formulas that lose no digits for
    /// a flat triangle (Kahan, *Miscalculating Area and Angles of a Needle-like Triangle*, 2014):
    ///
    /// ```text
    /// tan(α/2) = √((b + D − a)(b − D + a) / ((a + D + b)(a + D − b)))
    /// tan(β/2) = √((a + b + D)(a + b − D) / ((D + a − b)(D − a + b))),  β the bend
    /// ```
    ///
    /// For floats the same rotations are computed with square roots only, by the formulas of
    /// [`batch::TwoBone::reach`](crate::batch::TwoBone::reach). The results have the same bits as
    /// on lanes that fuse no multiplication with an addition.
    ///
    /// If the pole is zero or parallel to the direction of the target, it defines no plane. The
    /// knee then goes toward the coordinate axis that is farthest from this direction. If the
    /// target is at the root, the knee is where the pole points, or on the x axis if the pole is
    /// zero.
    ///
    /// # Errors
    /// If a length is negative, or if an input or the sum of the triangle's sides is not finite.
    pub fn reach(
        root: [R; 3],
        lengths: [R; 2],
        target: [R; 3],
        pole: [R; 3],
    ) -> Result<Self, LimbError> {
        Self::check(root, lengths, target, pole)?;
        let Some((turns, [bend, beyond])) = R::quick(quick::Limb(root, lengths, target, pole))
        else {
            return Ok(Self::by_the_book(root, lengths, target, pole));
        };
        let span = if beyond > R::ZERO {
            Span::Stretched
        } else if beyond < R::ZERO {
            Span::Folded
        } else {
            Span::Within
        };
        let [upper, lower] = turns.map(Quat::from_array);
        Ok(Self { upper, lower, bend, span, missed: beyond.abs() })
    }

    /// Returns the error that [`reach`](Self::reach) would return.
    #[inline]
    pub(crate) fn check(
        root: [R; 3],
        lengths: [R; 2],
        target: [R; 3],
        pole: [R; 3],
    ) -> Result<(), LimbError> {
        let [a, b] = lengths;
        let way = vector::sub(target, root);
        let mut sum = R::TWO * (a + b);
        for number in [root, pole, way].as_flattened() {
            sum += number.abs();
        }
        // This one comparison accepts nearly all limbs.
        if a >= R::ZERO && b >= R::ZERO && sum.is_finite() {
            return Ok(());
        }
        check_each(root, lengths, target, pole)
    }

    /// Computes the limb by the textbook form, with angles.
    fn by_the_book(root: [R; 3], [a, b]: [R; 2], target: [R; 3], pole: [R; 3]) -> Self {
        let way = vector::sub(target, root);
        let wanted = vector::norm(way);
        let (shortest, longest) = ((a - b).abs(), a + b);
        // Stretched and folded limbs are separate cases, because in the formulas the square root of
        // a rounding error would leave only eight digits of sixteen.
        let (span, d, root_angle, bend) = if wanted > longest {
            (Span::Stretched, longest, R::ZERO, R::ZERO)
        } else if wanted < shortest {
            (Span::Folded, shortest, if a < b { R::PI } else { R::ZERO }, R::PI)
        } else {
            let d = wanted;
            let sides = [b + (d - a), b - (d - a)];
            let root_angle = twice_arctangent(sides, [a + d + b, d + (a - b)]);
            let bend = twice_arctangent([a + b + d, a + b - d], [d + (a - b), d - (a - b)]);
            (Span::Within, d, root_angle, bend)
        };

        let (along, side) = plane(way, pole, a < b);
        let about_z = |angle: R| Quat::from_axis_angle([R::ZERO, R::ZERO, R::ONE], angle);
        let frame = frame(along, side);
        Self {
            upper: frame * about_z(-root_angle),
            lower: frame * about_z(bend - root_angle),
            bend,
            span,
            missed: (wanted - d).abs(),
        }
    }
}

#[cold]
#[inline(never)]
fn check_each<R: Real>(
    root: [R; 3],
    lengths: [R; 2],
    target: [R; 3],
    pole: [R; 3],
) -> Result<(), LimbError> {
    for (bone, length) in lengths.into_iter().enumerate() {
        if !(length >= R::ZERO && length.is_finite()) {
            return Err(LimbError::Length { bone, value: length.into() });
        }
    }
    let [a, b] = lengths;
    // The sum of the lengths is tested with a factor of two, because the formulas add all sides of
    // the triangle, which is at most twice this sum.
    if !(R::TWO * (a + b)).is_finite() {
        return Err(LimbError::Length { bone: 1, value: b.into() });
    }
    let way = vector::sub(target, root);
    for (what, point) in [("root", root), ("target", target), ("pole", pole), ("way", way)] {
        for (index, value) in point.into_iter().enumerate() {
            if !value.is_finite() {
                return Err(LimbError::NotFinite { what, index, value: value.into() });
            }
        }
    }
    Ok(())
}

/// Returns 2 arctan √(ab/(cd)). A factor that rounding has made slightly negative counts as zero.
fn twice_arctangent<R: Real>(over: [R; 2], under: [R; 2]) -> R {
    let root = |[a, b]: [R; 2]| {
        let clipped = |x: R| if x > R::ZERO { x } else { R::ZERO };
        clipped(a).sqrt() * clipped(b).sqrt()
    };
    R::TWO * root(over).atan2(root(under))
}

/// Returns the direction to the target, and the direction across it in which the knee bends. For a
/// target at the root, the pole gives the first direction: the knee is on the side of the pole, or
/// opposite to the pole if the bone at the root is the shorter bone.
fn plane<R: Real>(way: [R; 3], pole: [R; 3], shorter: bool) -> ([R; 3], [R; 3]) {
    let Some(along) = direction(way) else {
        let knee = direction(pole).unwrap_or([R::ONE, R::ZERO, R::ZERO]);
        let along = if shorter { vector::scale(knee, -R::ONE) } else { knee };
        return (along, vector::any_across(along));
    };
    let across_way = |pole| {
        let left = vector::across(along, pole);
        // If the pole is parallel to the way, its component across the way consists of rounding
        // errors. If it is nearly parallel, this component is not quite orthogonal to the way.
        let least = R::from(16.0) * R::EPSILON;
        let side = if vector::norm(left) > least { direction(left) } else { None };
        side.and_then(|side| direction(vector::across(along, side)))
    };
    (along, direction(pole).and_then(across_way).unwrap_or_else(|| vector::any_across(along)))
}

/// Returns `vector` scaled to length 1, or `None` if it is zero.
fn direction<R: Real>(vector: [R; 3]) -> Option<[R; 3]> {
    let norm = vector::norm(vector);
    (norm > R::ZERO).then(|| Length::of(vector, norm).divide(vector))
}

/// Returns the rotation that takes x to `along` and −y to `side`.
fn frame<R: Real>(along: [R; 3], side: [R; 3]) -> Quat<R> {
    let y = [-side[0], -side[1], -side[2]];
    let z = vector::cross(along, y);
    let row = |i: usize| [along[i], y[i], z[i], R::ZERO];
    DualQuat::from_matrix3x4([row(0), row(1), row(2)]).rotation()
}

use super::length::Length;
use super::representation::quat_without;
use super::trigonometry::atan2;
use super::{Quat, vector};
use core::f64::consts::PI;
use dq8_simd::Lanes;

/// Limbs of two bones with a hinge between them: [`ik::TwoBone`](crate::ik::TwoBone) on lanes, with its
/// conventions.
#[derive(Clone, Copy, Debug)]
pub struct TwoBone<L: Lanes> {
    /// The rotation of the bone at the root, in the frame of the root and the target.
    pub upper: Quat<L>,
    /// The rotation of the other bone, in the same frame: `upper` times a turn of `bend` about z.
    pub lower: Quat<L>,
    /// The angle of the hinge, 0 for a stretched limb and π for a folded one.
    pub bend: L,
    /// The target is farther than the bones reach: the limb is stretched toward it.
    pub stretched: L::Mask,
    /// It is nearer than the bones differ in length: the limb is folded.
    pub folded: L::Mask,
    /// The distance of the end from the target: zero but for rounding where neither mask holds.
    pub missed: L,
}

impl<L: Lanes> TwoBone<L> {
    /// The limb with its root at `root`, bones of `lengths` (the one at the root first) and its end at
    /// `target`; the knee is where `pole`, a direction of any length, points. And the lanes without one: a
    /// length is negative, or a number or the sum of all sides is not finite. Those are NaN.
    ///
    /// ```
    /// use dq8::{batch::TwoBone, simd::{Mask, f32x4}};
    /// let at = |x, y, z| [x, y, z].map(f32x4::splat);
    /// // One leg and four steps of a stair; the last is out of reach.
    /// let steps = [f32x4::splat(0.0), f32x4::new([0.0, 0.1, 0.2, 3.0]), f32x4::splat(0.2)];
    /// let bones = [f32x4::splat(0.4); 2];
    /// let (leg, failed) = TwoBone::reach_checked(at(0.0, 0.0, 0.8), bones, steps, at(0.0, 1.0, 0.0));
    /// assert_eq!((failed.any(), leg.stretched.to_bitmask()), (false, 0b1000));
    /// assert!(leg.missed.to_array()[..3].iter().all(|&missed| missed == 0.0));
    /// ```
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn reach_checked(
        root: [L; 3],
        lengths: [L; 2],
        target: [L; 3],
        pole: [L; 3],
    ) -> (Self, L::Mask) {
        let [a, b] = lengths;
        let (zero, one) = (a.constant(0.0), a.constant(1.0));
        let way = vector::sub(target, root);
        let sum = a + b;
        // Twice: the sides of the triangle are added up.
        let finite = vector::is_finite(sum + sum)
            & vector::are_finite(root)
            & vector::are_finite(target)
            & vector::are_finite(pole)
            & vector::are_finite(way);
        let failed = !(zero.le(a) & zero.le(b) & finite);

        let wanted = Length::of(way, one).value();
        let (shortest, longest) = ((a - b).abs(), sum);
        // Straight limbs are told apart: the root of a rounding is eight digits, not sixteen.
        let (stretched, folded) = (longest.lt(wanted), wanted.lt(shortest));
        let nearest = L::select(folded, shortest, wanted);
        let d = L::select(stretched, longest, nearest);
        let shorter = a.lt(b);
        let pi = one.constant(PI);
        let sides = [b + (d - a), b - (d - a)];
        let inside = twice_arctangent(sides, [a + d + b, d + (a - b)]);
        let bent = twice_arctangent([a + b + d, a + b - d], [d + (a - b), d - (a - b)]);
        let back = L::select(shorter, pi, zero);
        let root_angle = L::select(stretched, zero, L::select(folded, back, inside));
        let bend = L::select(stretched, zero, L::select(folded, pi, bent));

        let (along, side) = plane(way, pole, shorter);
        let frame = quat_without(failed, frame(along, side));
        let nan = one.constant(f64::NAN);
        let limb = Self {
            upper: frame * Quat::from_rotation_z(-root_angle),
            lower: frame * Quat::from_rotation_z(bend - root_angle),
            bend: L::select(failed, nan, bend),
            stretched,
            folded,
            missed: L::select(failed, nan, (wanted - d).abs()),
        };
        (limb, failed)
    }
}

/// 2 arctan √(ab/(cd)); rounding may have left a factor a little below zero.
#[cfg_attr(not(opt_level_0), inline(always))]
fn twice_arctangent<L: Lanes>(over: [L; 2], under: [L; 2]) -> L {
    let half = atan2(root_of_product(over), root_of_product(under));
    half + half
}

#[cfg_attr(not(opt_level_0), inline(always))]
fn root_of_product<L: Lanes>([a, b]: [L; 2]) -> L {
    let zero = a.constant(0.0);
    let (a, b) = (L::select(zero.lt(a), a, zero), L::select(zero.lt(b), b, zero));
    a.sqrt() * b.sqrt()
}

/// The direction to the target, and the one across it that the knee goes to. A target at the root
/// leaves the knee on the way to it: behind it if the bone at the root is the shorter.
#[cfg_attr(not(opt_level_0), inline(always))]
fn plane<L: Lanes>(way: [L; 3], pole: [L; 3], shorter: L::Mask) -> ([L; 3], [L; 3]) {
    let (zero, one) = (way[0].constant(0.0), way[0].constant(1.0));
    let (ahead, has_way) = direction(way);
    let (pole, has_pole) = direction(pole);
    let knee = vector::select(has_pole, pole, [one, zero, zero]);
    let knee = vector::scale(knee, L::select(shorter, -one, one));
    let along = vector::select(has_way, ahead, knee);
    let left = vector::across(along, pole);
    // What is left of a pole along the way is rounding; of one nearly so, it is not quite across.
    let least = one.constant(16.0 * vector::epsilon::<L>());
    let clear = least.lt(Length::of(left, one).value());
    let (side, _) = direction(left);
    let (side, is_across) = direction(vector::across(along, side));
    let toward_pole = has_way & has_pole & clear & is_across;
    (along, vector::select(toward_pole, side, vector::any_across(along)))
}

/// Vectors with length 1, and where there are any: not for zero.
#[cfg_attr(not(opt_level_0), inline(always))]
fn direction<L: Lanes>(vector: [L; 3]) -> ([L; 3], L::Mask) {
    let one = vector[0].constant(1.0);
    let length = Length::of(vector, one);
    (length.divide_all(vector), one.constant(0.0).lt(length.value()))
}

/// The rotation that takes x to `along` and −y to `side`.
#[cfg_attr(not(opt_level_0), inline(always))]
fn frame<L: Lanes>(along: [L; 3], side: [L; 3]) -> Quat<L> {
    let y = [-side[0], -side[1], -side[2]];
    let z = vector::cross(along, y);
    let row = |i: usize| [along[i], y[i], z[i]];
    Quat::from_matrix3([row(0), row(1), row(2)])
}

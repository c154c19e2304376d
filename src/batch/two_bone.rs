use super::length::Length;
use super::vector::{across, any_across, cross, dot, epsilon, scale, scale_onto, select, sub};
use super::{DualQuat, Quat, atan2, vector};
use dq8_simd::{Lanes, Mask};

/// The rotations and the bend of limbs of two bones, one limb per lane:
/// [`ik::TwoBone`](crate::ik::TwoBone) on lanes.
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct TwoBone<L> {
    /// The rotation of the bone at the root, in the frame in which the root and the target are
    /// given.
    pub upper: Quat<L>,
    /// The rotation of the bone at the end, in the frame in which the root and the target are
    /// given.
    pub lower: Quat<L>,
    /// The angle of the hinge in radians, 0 for a stretched limb and π for a folded limb.
    pub bend: L,
    /// The distance by which the end misses the target: positive where the target is too far away,
    /// zero where it is within reach, negative where it is too near to the root.
    pub beyond: L,
}

impl<L: Lanes> TwoBone<L> {
    /// Returns the limbs whose end is at the target, or as near to it as the bones allow. The
    /// parameters are those of [`ik::TwoBone::reach`](crate::ik::TwoBone::reach). In lanes for
    /// which that function would return an error, the result has no meaning.
    ///
    /// No angle is needed for the rotations. Let a and b be the lengths of the bones, D the
    /// distance from the root to the target, and S = a + b + D. The differences p = D + a − b,
    /// q = D − a + b and r = a + b − D are computed in an order that avoids cancellation (Kahan
    /// 2014). Then half the angles at the root and at the end have the tangents √(qr/(Sp)) and
    /// √(pr/(Sq)). So square roots alone give a quaternion of the right direction, which is then
    /// normalized.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn reach(root: [L; 3], lengths: [L; 2], target: [L; 3], pole: [L; 3]) -> Self {
        let [a, b] = lengths;
        let (zero, one) = (a.constant(0.0), a.constant(1.0));
        let way = sub(target, root);
        let length = Length::of(way, one);
        let (wanted, along) = (length.value(), length.divide_all(way));
        let shorter = a.lt(b);
        let (less, more) = (L::select(shorter, a, b), L::select(shorter, b, a));
        let (longest, shortest) = (a + b, more - less);
        let (stretched, folded) = (longest.lt(wanted), wanted.lt(shortest));
        let d = L::select(folded, shortest, L::select(stretched, longest, wanted));

        let r = less - (d - more);
        let straight = stretched | r.le(zero);
        let at_root = wanted.eq(zero);
        let folded = folded | (at_root & !straight);
        let sum = longest + d;
        let folds = L::select(shorter, zero, one);
        let p = L::select(folded, folds, share(d, a, b, sum, straight));
        let q = L::select(folded, one - folds, share(d, b, a, sum, straight));
        let r = L::select(folded, one, L::select(straight, zero, r / sum));

        let frame = frame(along, pole, at_root, shorter);
        Self {
            upper: about_z(frame, -(q * r).sqrt(), p.sqrt()),
            lower: about_z(frame, (p * r).sqrt(), q.sqrt()),
            bend: atan2(r.sqrt(), (p * q).sqrt()) * one.constant(2.0),
            beyond: wanted - d,
        }
    }

    /// Returns [`reach`](Self::reach), and the mask of the lanes for which
    /// [`ik::TwoBone::reach`](crate::ik::TwoBone::reach) would return an error.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn reach_checked(
        root: [L; 3],
        lengths: [L; 2],
        target: [L; 3],
        pole: [L; 3],
    ) -> (Self, L::Mask) {
        let found = Self::reach(root, lengths, target, pole);
        (found, Self::refuses(root, lengths, target, pole))
    }

    /// Returns the mask of the lanes with a negative length or with an argument that is not finite.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn refuses(
        [x, y, z]: [L; 3],
        [a, b]: [L; 2],
        target: [L; 3],
        [px, py, pz]: [L; 3],
    ) -> L::Mask {
        let zero = a.constant(0.0);
        let [u, v, w] = sub(target, [x, y, z]);
        let two = a.constant(2.0);
        let fits = vector::are_finite([x, y, z, px, py, pz, u, v, w, (a + b) * two]);
        !(fits & zero.le(a) & zero.le(b))
    }
}

/// Returns (d + side − other)/sum. The result is 1 in the lanes of `straight`, where the limb is
/// stretched, and 0 where rounding makes the numerator negative.
#[cfg_attr(not(opt_level_0), inline(always))]
fn share<L: Lanes>(d: L, side: L, other: L, sum: L, straight: L::Mask) -> L {
    let (zero, one) = (d.constant(0.0), d.constant(1.0));
    let nearer = d.lt(side);
    let (less, more) = (L::select(nearer, d, side), L::select(nearer, side, d));
    let part = less - (other - more);
    L::select(straight, one, L::select(zero.lt(part), part, zero) / sum)
}

/// Returns a multiple of the quaternion that turns the x axis to the unit vector `along`, and the
/// −y axis to the side of the pole. In the lanes of `at_root` the target is at the root, so
/// `along` has no meaning and is replaced by another vector.
#[cfg_attr(not(opt_level_0), inline(always))]
fn frame<L: Lanes>(along: [L; 3], pole: [L; 3], at_root: L::Mask, shorter: L::Mask) -> Quat<L> {
    let (zero, one) = (along[0].constant(0.0), along[0].constant(1.0));
    let length = Length::of(pole, one);
    let has_pole = zero.lt(length.value());
    let pole = select(has_pole, length.divide_all(pole), [zero; 3]);
    let mut along = along;
    if at_root.any() {
        // If the target is at the root, the knee is on the line of `along`, on its negative side if
        // the bone at the root is the shorter bone. This choice of `along` puts the knee on the
        // side of the pole.
        let knee = select(has_pole, pole, [one, zero, zero]);
        along = select(at_root, scale(knee, L::select(shorter, -one, one)), along);
    }
    let normal = cross(pole, along);
    // The component of `normal` along `along` is removed. If the pole is nearly parallel to
    // `along`, the cross product is so short that its rounding errors matter. If the pole is
    // parallel, only rounding errors are left, and `clear` is `false`.
    let normal = scale_onto(along, -dot(along, normal), normal);
    let size = Length::of(normal, one);
    let clear = one.constant(16.0 * epsilon::<L>()).lt(size.value()) & !at_root;
    let mut z = size.divide_all(normal);
    if !clear.all() {
        z = select(clear, z, cross(any_across(along), along));
    }
    frame_of(along, z)
}

/// Returns a multiple of the quaternion that turns the x axis to `x` and the z axis to `z`, with w
/// ≥ 0.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(crate) fn frame_of<L: Lanes>(x: [L; 3], z: [L; 3]) -> Quat<L> {
    let y = cross(z, x);
    let some = Quat::some_of_matrix3([[x[0], y[0], z[0]], [x[1], y[1], z[1]], [x[2], y[2], z[2]]]);
    let one = some.w().constant(1.0);
    some.scale(L::select(some.w().lt(one.constant(0.0)), -one, one))
}

/// Returns the product `frame` · (w + z k), normalized.
#[cfg_attr(not(opt_level_0), inline(always))]
fn about_z<L: Lanes>(frame: Quat<L>, z: L, w: L) -> Quat<L> {
    let [i, j, k, s] = frame.to_array();
    Quat::from_xyzw(
        j.mul_add(z, i * w),
        i.neg_mul_add(z, j * w),
        s.mul_add(z, k * w),
        k.neg_mul_add(z, s * w),
    )
    .normalize()
}

/// Returns the position of a limb's root and the lengths of its two bones, from the local poses of
/// its three joints and the pose of their parent.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(crate) fn root_and_lengths<L: Lanes>(
    parent: Option<DualQuat<L>>,
    [hip, knee, foot]: [DualQuat<L>; 3],
) -> ([L; 3], [L; 2]) {
    let place = hip.translation();
    let root = match parent {
        Some(parent) => parent.transform_point(place),
        None => place,
    };
    let one = place[0].constant(1.0);
    let length = Length::of(knee.translation(), one);
    (root, [length.value(), Length::of(foot.translation(), one).value()])
}

/// Returns the local poses of the three joints of a limb whose end is at the target and has the
/// rotation `end`. The axis `hinge` is in the frame of the second joint.
///
/// The rotation of a bone in the model is `upper` or `lower` times F*, where the rotation F, in the
/// frame of the bone's joint, turns the x axis to the bone and the z axis to the hinge.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(crate) fn locals<L: Lanes>(
    parent: Option<DualQuat<L>>,
    [hip, knee, foot]: [DualQuat<L>; 3],
    end: Quat<L>,
    hinge: [L; 3],
    (root, lengths, target, pole): ([L; 3], [L; 2], [L; 3], [L; 3]),
) -> [DualQuat<L>; 3] {
    let found = TwoBone::reach(root, lengths, target, pole);
    let (thigh, shin) = (knee.translation(), foot.translation());
    // The component of the hinge axis along the shin is removed first, for both bones. If it were
    // turned into the frame of the thigh by the old rotation of the knee, it would roll the thigh.
    let (x, hinge) = axes_of_bone(shin, hinge);
    let of_shin = frame_of(x, hinge);
    let (x, hinge) = axes_of_bone(thigh, knee.real().rotate(hinge));
    let of_thigh = frame_of(x, hinge);
    let upper = (found.upper * of_thigh.conjugate()).normalize();
    let lower = (found.lower * of_shin.conjugate()).normalize();
    let of_hip = match parent {
        Some(parent) => parent.real().conjugate() * upper,
        None => upper,
    };
    [
        DualQuat::from_rotation_translation(of_hip, hip.translation()),
        DualQuat::from_rotation_translation(upper.conjugate() * lower, thigh),
        DualQuat::from_rotation_translation(lower.conjugate() * end, shin),
    ]
}

/// Returns the direction of a bone, and the direction of the hinge axis after its component along
/// the bone is removed. If the hinge axis is parallel to the bone, the second direction is any axis
/// across the bone.
#[cfg_attr(not(opt_level_0), inline(always))]
fn axes_of_bone<L: Lanes>(bone: [L; 3], hinge: [L; 3]) -> ([L; 3], [L; 3]) {
    let (zero, one) = (bone[0].constant(0.0), bone[0].constant(1.0));
    let length = Length::of(bone, one);
    let x = select(zero.lt(length.value()), length.divide_all(bone), [one, zero, zero]);
    let length = Length::of(hinge, one);
    let hinge = length.divide_all(hinge);
    let side = across(x, across(x, hinge));
    let size = Length::of(side, one);
    let clear = one.constant(16.0 * epsilon::<L>()).lt(size.value());
    let mut z = size.divide_all(side);
    if !clear.all() {
        z = select(clear, z, any_across(x));
    }
    (x, z)
}

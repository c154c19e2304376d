//! [`Law`], a rule for interpolating between two poses and for adding a difference to a pose.

use crate::batch::{DualQuat, Quat, vector};
use dq8_simd::Lanes;

/// A law by which poses of `C` components are interpolated: [`Nlerp`] or [`Sclerp`] for motions,
/// [`NlerpLerp`] or [`SlerpLerp`] for rotations and translations. The trait is sealed.
pub trait Law<const C: usize>: Copy + core::fmt::Debug + Send + Sync + sealed::Sealed {
    /// Interpolates from `a` (t = 0) to `b` (t = 1).
    #[must_use]
    fn between<L: Lanes>(self, a: [L; C], b: [L; C], t: L) -> [L; C];
    /// Returns the pose `base`, changed by the difference `delta` scaled by `weight`.
    #[must_use]
    fn add<L: Lanes>(self, base: [L; C], delta: [L; C], weight: L) -> [L; C];
    /// Returns the pose as a motion.
    fn motion<L: Lanes>(self, pose: [L; C]) -> DualQuat<L>;
    /// Returns the product parent · pose as a motion.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn onto<L: Lanes>(self, parent: DualQuat<L>, pose: [L; C]) -> DualQuat<L> {
        parent * self.motion(pose)
    }
}

/// Normalized linear interpolation of motions: from a to ±b by the shorter way, normalize((1−t)a
/// ± tb). A difference is added as base · nlerp(1, delta, weight). See
/// [`DualQuat::nlerp`](crate::DualQuat::nlerp).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Nlerp;

/// Screw linear interpolation of motions: from a to ±b by the shorter way, a(a*b)ᵗ. A difference
/// is added as base · delta^weight. See [`DualQuat::sclerp`](crate::DualQuat::sclerp).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Sclerp;

/// The law of animation engines, which interpolates rotations and translations independently:
/// rotations by normalize((1−t)a ± tb) by the shorter way, translations by (1−t)a + tb. A
/// joint moves from one position to the other on a straight line, even while it turns.
///
/// A difference is multiplied from the left, as in ozz-animation and Unreal: the rotation is
/// nlerp(1, delta, weight) · base, the translation base + weight · delta.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct NlerpLerp;

/// The law of [`NlerpLerp`] with rotations by slerp, at a constant speed, as three.js has it; it
/// takes more time. Between rotations that are near each other, as neighbouring frames are, the two
/// laws hardly differ. See [`Quat::slerp`](crate::Quat::slerp).
///
/// ```
/// use dq8::hierarchy::{Layered, RotationsTranslations};
/// use dq8::law::{NlerpLerp, SlerpLerp};
/// use dq8::{DualQuat, Hierarchy, Quat};
/// let joint = Hierarchy::new(&[Hierarchy::ROOT])?;
/// let turned = |angle| {
///     let [x, y, z, w] = Quat::from_rotation_z(angle).to_array();
///     [[x, y, z, w, 0.0_f32, 0.0, 0.0]]
/// };
/// let (still, far) = (turned(0.0), turned(2.0));
/// let [a, b] = [&still, &far].map(|pose| RotationsTranslations(pose));
/// let mut models = [DualQuat::IDENTITY];
/// joint.job().locals_to_model(Layered::blend(SlerpLerp, a, b, &[0.25]), &mut models)?;
/// let angle = models[0].rotation().angle_to(Quat::IDENTITY);
/// assert!((angle - 0.5).abs() < 1e-6);
/// // Nlerp turns by a little less than a quarter of the angle there.
/// joint.job().locals_to_model(Layered::blend(NlerpLerp, a, b, &[0.25]), &mut models)?;
/// assert!((0.4..0.48).contains(&models[0].rotation().angle_to(Quat::IDENTITY)));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SlerpLerp;

impl Law<8> for Nlerp {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn between<L: Lanes>(self, a: [L; 8], b: [L; 8], t: L) -> [L; 8] {
        DualQuat::from_array(a).nlerp(DualQuat::from_array(b), t).to_array()
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn add<L: Lanes>(self, base: [L; 8], delta: [L; 8], weight: L) -> [L; 8] {
        let still = DualQuat::identity(weight.level());
        let step = still.nlerp(DualQuat::from_array(delta), weight);
        (DualQuat::from_array(base) * step).to_array()
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn motion<L: Lanes>(self, pose: [L; 8]) -> DualQuat<L> {
        DualQuat::from_array(pose)
    }
}

impl Law<8> for Sclerp {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn between<L: Lanes>(self, a: [L; 8], b: [L; 8], t: L) -> [L; 8] {
        DualQuat::from_array(a).sclerp(DualQuat::from_array(b), t).to_array()
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn add<L: Lanes>(self, base: [L; 8], delta: [L; 8], weight: L) -> [L; 8] {
        (DualQuat::from_array(base) * DualQuat::from_array(delta).pow(weight)).to_array()
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn motion<L: Lanes>(self, pose: [L; 8]) -> DualQuat<L> {
        DualQuat::from_array(pose)
    }
}

/// Implements [`Law`] for rotations and translations, with the given interpolation of rotations.
macro_rules! rotations_and_translations {
    ($($law:ty: $between:ident;)*) => {$(
        impl Law<7> for $law {
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn between<L: Lanes>(self, a: [L; 7], b: [L; 7], t: L) -> [L; 7] {
                let ([ax, ay, az, aw, from @ ..], [bx, by, bz, bw, to @ ..]) = (a, b);
                let turn = Quat::from_xyzw(ax, ay, az, aw).$between(Quat::from_xyzw(bx, by, bz, bw), t);
                let [x, y, z, w] = turn.to_array();
                let from = vector::scale(from, t.constant(1.0) - t);
                let [tx, ty, tz] = vector::scale_onto(to, t, from);
                [x, y, z, w, tx, ty, tz]
            }
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn add<L: Lanes>(self, base: [L; 7], delta: [L; 7], weight: L) -> [L; 7] {
                let ([x, y, z, w, from @ ..], [dx, dy, dz, dw, step @ ..]) = (base, delta);
                let turn = Quat::identity(weight.level()).$between(Quat::from_xyzw(dx, dy, dz, dw), weight);
                let [x, y, z, w] = (turn * Quat::from_xyzw(x, y, z, w)).to_array();
                let [tx, ty, tz] = vector::scale_onto(step, weight, from);
                [x, y, z, w, tx, ty, tz]
            }
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn motion<L: Lanes>(self, [x, y, z, w, t @ ..]: [L; 7]) -> DualQuat<L> {
                DualQuat::from_rotation_translation(Quat::from_xyzw(x, y, z, w), t)
            }
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn onto<L: Lanes>(self, parent: DualQuat<L>, [x, y, z, w, t @ ..]: [L; 7]) -> DualQuat<L> {
                parent.mul_rotation_translation(Quat::from_xyzw(x, y, z, w), t)
            }
        }
    )*};
}
rotations_and_translations! {
    NlerpLerp: nlerp;
    SlerpLerp: slerp;
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for super::Nlerp {}
    impl Sealed for super::Sclerp {}
    impl Sealed for super::NlerpLerp {}
    impl Sealed for super::SlerpLerp {}
}

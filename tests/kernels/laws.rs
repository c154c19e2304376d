//! [`Reference`]: the laws of interpolation in words of the scalar reference.

use crate::memory::Memory;
use crate::scene::{motions, step};
use dq8::hierarchy::PoseSource;
use dq8::law::Law;
use dq8::{
    DualQuat, Quat,
    hierarchy::{Poses, RotationsTranslations},
    law::{Nlerp, NlerpLerp, Sclerp, SlerpLerp},
};
use dq8_contract::random::Random;

/// A law, and what it is to give.
pub(crate) trait Reference<const C: usize>: Law<C> {
    const LAW: Self;
    type Stored<'a, L: Memory>: PoseSource<L, C>
    where
        L::Record<C>: 'a;
    fn stored<L: Memory>(poses: &[L::Record<C>]) -> Self::Stored<'_, L>;
    fn key(random: &mut Random) -> [f64; C];
    fn between_by_the_book(a: [f64; C], b: [f64; C], t: f64) -> [f64; C];
    fn add_by_the_book(base: [f64; C], delta: [f64; C], weight: f64) -> [f64; C];
    fn as_motion(pose: [f64; C]) -> [f64; 8];
}

/// Both keep motions; they differ in what lies between two of them.
macro_rules! of_motions {
    ($($law:ty: |$a:ident, $b:ident, $t:ident| $between:expr;)*) => {$(
        impl Reference<8> for $law {
            const LAW: Self = Self;
            type Stored<'a, L: Memory>
                = Poses<'a, L::Record<8>>
            where
                L::Record<8>: 'a;
            fn stored<L: Memory>(poses: &[L::Record<8>]) -> Self::Stored<'_, L> {
                Poses(poses)
            }
            fn key(random: &mut Random) -> [f64; 8] {
                motions(random, 1)[0]
            }
            fn between_by_the_book(a: [f64; 8], b: [f64; 8], $t: f64) -> [f64; 8] {
                let ($a, $b) = (DualQuat::from_array(a), DualQuat::from_array(b));
                $between.to_array()
            }
            fn add_by_the_book(base: [f64; 8], delta: [f64; 8], weight: f64) -> [f64; 8] {
                let still = DualQuat::<f64>::IDENTITY.to_array();
                let step = Self::between_by_the_book(still, delta, weight);
                (DualQuat::from_array(base) * DualQuat::from_array(step)).to_array()
            }
            fn as_motion(pose: [f64; 8]) -> [f64; 8] {
                pose
            }
        }
    )*};
}
of_motions! {
    Nlerp: |a, b, t| a.nlerp(b, t);
    Sclerp: |a, b, t| a.sclerp(b, t);
}

fn turn_and_shift([x, y, z, w, t @ ..]: [f64; 7]) -> (Quat<f64>, [f64; 3]) {
    (Quat::from_xyzw(x, y, z, w), t)
}

fn seven(turn: Quat<f64>, [tx, ty, tz]: [f64; 3]) -> [f64; 7] {
    let [x, y, z, w] = turn.to_array();
    [x, y, z, w, tx, ty, tz]
}

/// By the shorter way.
fn turned(a: Quat<f64>, b: Quat<f64>, t: f64) -> Quat<f64> {
    let sign = if a.dot(b) < 0.0 { -1.0 } else { 1.0 };
    let (a, b) = (a.to_array(), b.to_array());
    Quat::from_array(std::array::from_fn(|i| (1.0 - t) * a[i] + sign * t * b[i])).normalize()
}

/// At a constant speed about one axis, by the shorter way.
fn slerped(a: Quat<f64>, b: Quat<f64>, t: f64) -> Quat<f64> {
    a.slerp(b, t)
}

/// Both keep rotations and translations apart.
macro_rules! apart {
    ($($law:ty: $between:ident;)*) => {$(
        impl Reference<7> for $law {
            const LAW: Self = Self;
            type Stored<'a, L: Memory>
                = RotationsTranslations<'a, L::Record<7>>
            where
                L::Record<7>: 'a;
            fn stored<L: Memory>(poses: &[L::Record<7>]) -> Self::Stored<'_, L> {
                RotationsTranslations(poses)
            }
            fn key(random: &mut Random) -> [f64; 7] {
                let step = step(random);
                seven(Quat::from_axis_angle(step.axis, step.angle), step.shift)
            }
            fn between_by_the_book(a: [f64; 7], b: [f64; 7], t: f64) -> [f64; 7] {
                let ((p, from), (q, to)) = (turn_and_shift(a), turn_and_shift(b));
                seven($between(p, q, t), std::array::from_fn(|i| (1.0 - t) * from[i] + t * to[i]))
            }
            fn add_by_the_book(base: [f64; 7], delta: [f64; 7], weight: f64) -> [f64; 7] {
                let ((p, from), (q, step)) = (turn_and_shift(base), turn_and_shift(delta));
                let turn = $between(Quat::IDENTITY, q, weight) * p;
                seven(turn, std::array::from_fn(|i| from[i] + weight * step[i]))
            }
            fn as_motion(pose: [f64; 7]) -> [f64; 8] {
                let (turn, shift) = turn_and_shift(pose);
                DualQuat::from_rotation_translation(turn, shift).to_array()
            }
        }
    )*};
}
apart! {
    NlerpLerp: turned;
    SlerpLerp: slerped;
}

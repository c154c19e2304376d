//! [`Pose`]: how a motion lies in memory.

use super::octet;
use crate::batch;
use crate::geometry::Twist;
use crate::motion::Motion;
use crate::real::Real;
use crate::scalar::{DualQuat, Quat};
use dq8_simd::{Float, Lanes, Level, Native, Row};

/// Dual quaternions of `N` instances: eight rows of `N` numbers, `[px, py, pz, pw, qx, qy, qz, qw]`.
/// `Block<f32, 8>` is 256 bytes.
pub type Block<R, const N: usize> = dq8_simd::Block<[R; N], 8>;

/// Twists of `N` instances: six rows of `N` numbers, `[ωx, ωy, ωz, vx, vy, vz]`; see
/// [`Twist::to_array`].
pub type TwistBlock<R, const N: usize> = dq8_simd::Block<[R; N], 6>;

/// Rotations of `N` instances: four rows of `N` numbers, `[x, y, z, w]`.
pub type RotationBlock<R, const N: usize> = dq8_simd::Block<[R; N], 4>;

/// Rotations and translations of `N` instances: seven rows of `N` numbers, `[x, y, z, w, tx, ty, tz]`.
pub type RotationTranslationBlock<R, const N: usize> = dq8_simd::Block<[R; N], 7>;

/// A place in memory that holds one motion, or one an instance.
///
/// Implemented for [`DualQuat`] (one instance) and [`Block`] (as many as it has lanes); sealed. What
/// has several registers of lanes is read and written in parts, one register each.
pub trait Pose: Copy + sealed::Sealed {
    /// The number.
    type Real: Real + Float;
    /// What is computed with: the motion itself, or lanes of it.
    type Motion<V: Level>: Motion;
    /// A place in memory that holds a rotation for each motion: a [`Quat`], or a block of four rows.
    type Rotation: Copy;
    /// A place in memory that holds `[x, y, z, w, tx, ty, tz]` for each motion: an array of seven, or
    /// a block of seven rows.
    type RotationTranslation: Copy;
    /// A place in memory that holds a twist for each motion: a [`Twist`], or a [`TwistBlock`].
    type Twist: Copy;
    /// How many instances share an element.
    const INSTANCES: usize;

    /// How many parts there are, each computed by itself: a register full of instances.
    #[must_use]
    fn parts<V: Level>() -> usize;

    /// Reads the motion.
    fn load<V: Level>(&self, level: V, part: usize) -> Self::Motion<V>;
    /// parent · local
    fn product<V: Level>(level: V, part: usize, parent: &Self, local: &Self) -> Self::Motion<V>;
    /// parent · (r + ½εtr)
    #[inline(always)]
    fn product_rotation_translation<V: Level>(
        level: V,
        part: usize,
        parent: &Self,
        rotation: Rotation<Self, V>,
        translation: [Number<Self, V>; 3],
    ) -> Self::Motion<V> {
        parent.load(level, part).mul_rotation_translation(rotation, translation)
    }
    /// Writes the motion.
    fn store<V: Level>(&mut self, level: V, part: usize, motion: Self::Motion<V>);
    /// The same motion for every instance.
    fn splat<V: Level>(level: V, motion: DualQuat<Self::Real>) -> Self::Motion<V>;

    /// Reads a rotation.
    fn load_rotation<V: Level>(level: V, part: usize, from: &Self::Rotation) -> Rotation<Self, V>;
    /// Reads a rotation and a translation.
    fn load_rotation_translation<V: Level>(
        level: V,
        part: usize,
        from: &Self::RotationTranslation,
    ) -> (Rotation<Self, V>, [Number<Self, V>; 3]);
    /// The same vector for every instance.
    fn splat_vector<V: Level>(level: V, vector: [Self::Real; 3]) -> [Number<Self, V>; 3];

    /// Reads a twist.
    fn load_twist<V: Level>(level: V, part: usize, from: &Self::Twist) -> Twist<Number<Self, V>>;
    /// Writes a twist.
    fn store_twist<V: Level>(
        level: V,
        part: usize,
        to: &mut Self::Twist,
        twist: Twist<Number<Self, V>>,
    );
    /// The same twist for every instance.
    fn splat_twist<V: Level>(level: V, twist: Twist<Self::Real>) -> Twist<Number<Self, V>>;
}

/// What the motions of a pose are made of: a number, or lanes of them.
type Number<P, V> = <<P as Pose>::Motion<V> as Motion>::Real;

/// The quaternions of a pose, or lanes of them.
type Rotation<P, V> = <<P as Pose>::Motion<V> as Motion>::Quat;

pub(super) mod sealed {
    pub trait Sealed {}
}

impl<R: Real> sealed::Sealed for DualQuat<R> {}
impl<R: Real + Float> Pose for DualQuat<R> {
    type Real = R;
    type Motion<V: Level> = Self;
    type Rotation = Quat<R>;
    type RotationTranslation = [R; 7];
    type Twist = Twist<R>;
    const INSTANCES: usize = 1;

    #[inline(always)]
    fn parts<V: Level>() -> usize {
        1
    }
    #[inline(always)]
    fn load<V: Level>(&self, _: V, _: usize) -> Self {
        *self
    }
    #[inline(always)]
    fn product<V: Level>(level: V, _: usize, parent: &Self, local: &Self) -> Self {
        if <R::Octet<V> as Lanes>::Native::LANES == 1 {
            return *parent * *local;
        }
        let parent = R::Octet::load(level, bytemuck::must_cast_ref(parent));
        Self::from_array(octet::product(parent, bytemuck::must_cast_ref(local)).to_array())
    }
    #[inline(always)]
    fn product_rotation_translation<V: Level>(
        level: V,
        part: usize,
        parent: &Self,
        rotation: Quat<R>,
        translation: [R; 3],
    ) -> Self {
        if <R::Octet<V> as Lanes>::Native::LANES > 1 {
            let local = Self::from_rotation_translation(rotation, translation);
            return Self::product(level, part, parent, &local);
        }
        // (p + ε(q + ½pt))r, as on lanes: two thirds of the reference's operations.
        let half = Quat::from_parts(translation.map(|c| c * R::HALF), R::ZERO);
        let moved = parent.dual() + parent.real() * half;
        Self::new(parent.real() * rotation, moved * rotation)
    }
    #[inline(always)]
    fn store<V: Level>(&mut self, _: V, _: usize, motion: Self) {
        *self = motion;
    }
    #[inline(always)]
    fn splat<V: Level>(_: V, motion: Self) -> Self {
        motion
    }
    #[inline(always)]
    fn load_rotation<V: Level>(_: V, _: usize, from: &Quat<R>) -> Quat<R> {
        *from
    }
    #[inline(always)]
    fn load_rotation_translation<V: Level>(_: V, _: usize, from: &[R; 7]) -> (Quat<R>, [R; 3]) {
        let [x, y, z, w, translation @ ..] = *from;
        (Quat::from_array([x, y, z, w]), translation)
    }
    #[inline(always)]
    fn splat_vector<V: Level>(_: V, vector: [R; 3]) -> [R; 3] {
        vector
    }
    #[inline(always)]
    fn load_twist<V: Level>(_: V, _: usize, from: &Twist<R>) -> Twist<R> {
        *from
    }
    #[inline(always)]
    fn store_twist<V: Level>(_: V, _: usize, to: &mut Twist<R>, twist: Twist<R>) {
        *to = twist;
    }
    #[inline(always)]
    fn splat_twist<V: Level>(_: V, twist: Twist<R>) -> Twist<R> {
        twist
    }
}

impl<A: Row<Real: Real>> sealed::Sealed for dq8_simd::Block<A, 8> {}
impl<A: Row<Real: Real>> Pose for dq8_simd::Block<A, 8> {
    type Real = A::Real;
    type Motion<V: Level> = batch::DualQuat<Native<A, V>>;
    type Rotation = dq8_simd::Block<A, 4>;
    type RotationTranslation = dq8_simd::Block<A, 7>;
    type Twist = dq8_simd::Block<A, 6>;
    const INSTANCES: usize = A::LANES;

    #[inline(always)]
    fn parts<V: Level>() -> usize {
        Self::parts::<V>()
    }
    #[inline(always)]
    fn load<V: Level>(&self, level: V, part: usize) -> Self::Motion<V> {
        batch::DualQuat::from_array(self.load_part(level, part))
    }
    #[inline(always)]
    fn product<V: Level>(level: V, part: usize, parent: &Self, local: &Self) -> Self::Motion<V> {
        Pose::load(parent, level, part) * Pose::load(local, level, part)
    }
    #[inline(always)]
    fn store<V: Level>(&mut self, _: V, part: usize, motion: Self::Motion<V>) {
        self.store_part::<V>(motion.to_array(), part);
    }
    #[inline(always)]
    fn splat<V: Level>(level: V, motion: DualQuat<A::Real>) -> Self::Motion<V> {
        batch::DualQuat::splat(level, motion.to_array())
    }
    #[inline(always)]
    fn load_rotation<V: Level>(
        level: V,
        part: usize,
        from: &Self::Rotation,
    ) -> batch::Quat<Native<A, V>> {
        batch::Quat::from_array(from.load_part(level, part))
    }
    #[inline(always)]
    fn load_rotation_translation<V: Level>(
        level: V,
        part: usize,
        from: &Self::RotationTranslation,
    ) -> (batch::Quat<Native<A, V>>, [Native<A, V>; 3]) {
        let [x, y, z, w, translation @ ..] = from.load_part(level, part);
        (batch::Quat::from_array([x, y, z, w]), translation)
    }
    #[inline(always)]
    fn splat_vector<V: Level>(level: V, [x, y, z]: [A::Real; 3]) -> [Native<A, V>; 3] {
        [
            Native::<A, V>::splat(level, x),
            Native::<A, V>::splat(level, y),
            Native::<A, V>::splat(level, z),
        ]
    }
    #[inline(always)]
    fn load_twist<V: Level>(level: V, part: usize, from: &Self::Twist) -> Twist<Native<A, V>> {
        Twist::from_array(from.load_part(level, part))
    }
    #[inline(always)]
    fn store_twist<V: Level>(_: V, part: usize, to: &mut Self::Twist, twist: Twist<Native<A, V>>) {
        to.store_part::<V>(twist.to_array(), part);
    }
    #[inline(always)]
    fn splat_twist<V: Level>(level: V, twist: Twist<A::Real>) -> Twist<Native<A, V>> {
        let mut lanes = [Native::<A, V>::splat(level, A::Real::default()); 6];
        for (lane, value) in lanes.iter_mut().zip(twist.to_array()) {
            *lane = Native::<A, V>::splat(level, value);
        }
        Twist::from_array(lanes)
    }
}

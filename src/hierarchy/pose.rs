//! [`Pose`]: how a motion lies in memory.

use crate::batch;
use crate::motion::Motion;
use crate::real::Real;
use crate::scalar::DualQuat;
use dq8_simd::{Level, Row};

/// Dual quaternions of `N` instances: eight rows of `N` numbers, `[px, py, pz, pw, qx, qy, qz, qw]`.
/// `Block<f32, 8>` is 256 bytes.
pub type Block<R, const N: usize> = dq8_simd::Block<[R; N], 8>;

/// A place in memory that holds one motion, or one an instance.
///
/// Implemented for [`DualQuat`] (one instance) and [`Block`] (as many as it has lanes); sealed.
pub trait Pose: Copy + sealed::Sealed {
    /// The number.
    type Real: Real;
    /// What is computed with: the motion itself, or lanes of it.
    type Motion<V: Level>: Motion;
    /// How many instances share an element.
    const INSTANCES: usize;

    /// Reads the motion.
    fn load<V: Level>(&self, level: V) -> Self::Motion<V>;
    /// Writes the motion.
    fn store<V: Level>(&mut self, level: V, motion: Self::Motion<V>);
    /// The same motion for every instance.
    fn splat<V: Level>(level: V, motion: DualQuat<Self::Real>) -> Self::Motion<V>;
}

mod sealed {
    pub trait Sealed {}
}

impl<R: Real> sealed::Sealed for DualQuat<R> {}
impl<R: Real> Pose for DualQuat<R> {
    type Real = R;
    type Motion<V: Level> = Self;
    const INSTANCES: usize = 1;

    #[inline(always)]
    fn load<V: Level>(&self, _: V) -> Self {
        *self
    }
    #[inline(always)]
    fn store<V: Level>(&mut self, _: V, motion: Self) {
        *self = motion;
    }
    #[inline(always)]
    fn splat<V: Level>(_: V, motion: Self) -> Self {
        motion
    }
}

impl<A: Row<Real: Real>> sealed::Sealed for dq8_simd::Block<A, 8> {}
impl<A: Row<Real: Real>> Pose for dq8_simd::Block<A, 8> {
    type Real = A::Real;
    type Motion<V: Level> = batch::DualQuat<A::Lane<V>>;
    const INSTANCES: usize = A::LANES;

    #[inline(always)]
    fn load<V: Level>(&self, level: V) -> Self::Motion<V> {
        batch::DualQuat::load(level, self)
    }
    #[inline(always)]
    fn store<V: Level>(&mut self, _: V, motion: Self::Motion<V>) {
        motion.store::<A, V>(self);
    }
    #[inline(always)]
    fn splat<V: Level>(level: V, motion: DualQuat<A::Real>) -> Self::Motion<V> {
        batch::DualQuat::splat(level, motion.to_array())
    }
}

//! [`Pose`]: how a motion lies in memory.

use crate::batch;
use crate::geometry::Twist;
use crate::motion::Motion;
use crate::real::Real;
use crate::scalar::DualQuat;
use dq8_simd::{Lane, Level, Row};

/// Dual quaternions of `N` instances: eight rows of `N` numbers, `[px, py, pz, pw, qx, qy, qz, qw]`.
/// `Block<f32, 8>` is 256 bytes.
pub type Block<R, const N: usize> = dq8_simd::Block<[R; N], 8>;

/// Twists of `N` instances: six rows of `N` numbers, `[ωx, ωy, ωz, vx, vy, vz]`; see
/// [`Twist::to_array`].
pub type TwistBlock<R, const N: usize> = dq8_simd::Block<[R; N], 6>;

/// A place in memory that holds one motion, or one an instance.
///
/// Implemented for [`DualQuat`] (one instance) and [`Block`] (as many as it has lanes); sealed.
pub trait Pose: Copy + sealed::Sealed {
    /// The number.
    type Real: Real;
    /// What is computed with: the motion itself, or lanes of it.
    type Motion<V: Level>: Motion;
    /// A place in memory that holds a twist for each motion: a [`Twist`], or a [`TwistBlock`].
    type Twist: Copy;
    /// How many instances share an element.
    const INSTANCES: usize;

    /// Reads the motion.
    fn load<V: Level>(&self, level: V) -> Self::Motion<V>;
    /// Writes the motion.
    fn store<V: Level>(&mut self, level: V, motion: Self::Motion<V>);
    /// The same motion for every instance.
    fn splat<V: Level>(level: V, motion: DualQuat<Self::Real>) -> Self::Motion<V>;

    /// Reads a twist.
    fn load_twist<V: Level>(level: V, from: &Self::Twist) -> Twist<Number<Self, V>>;
    /// Writes a twist.
    fn store_twist<V: Level>(level: V, to: &mut Self::Twist, twist: Twist<Number<Self, V>>);
    /// The same twist for every instance.
    fn splat_twist<V: Level>(level: V, twist: Twist<Self::Real>) -> Twist<Number<Self, V>>;
}

/// What the motions of a pose are made of: a number, or lanes of them.
type Number<P, V> = <<P as Pose>::Motion<V> as Motion>::Real;

mod sealed {
    pub trait Sealed {}
}

impl<R: Real> sealed::Sealed for DualQuat<R> {}
impl<R: Real> Pose for DualQuat<R> {
    type Real = R;
    type Motion<V: Level> = Self;
    type Twist = Twist<R>;
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
    #[inline(always)]
    fn load_twist<V: Level>(_: V, from: &Twist<R>) -> Twist<R> {
        *from
    }
    #[inline(always)]
    fn store_twist<V: Level>(_: V, to: &mut Twist<R>, twist: Twist<R>) {
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
    type Motion<V: Level> = batch::DualQuat<A::Lane<V>>;
    type Twist = dq8_simd::Block<A, 6>;
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
    #[inline(always)]
    fn load_twist<V: Level>(level: V, from: &Self::Twist) -> Twist<A::Lane<V>> {
        Twist::from_array(from.load(level))
    }
    #[inline(always)]
    fn store_twist<V: Level>(_: V, to: &mut Self::Twist, twist: Twist<A::Lane<V>>) {
        to.store::<V>(twist.to_array());
    }
    #[inline(always)]
    fn splat_twist<V: Level>(level: V, twist: Twist<A::Real>) -> Twist<A::Lane<V>> {
        let mut lanes = [A::Lane::<V>::splat(level, A::Real::default()); 6];
        for (lane, value) in lanes.iter_mut().zip(twist.to_array()) {
            *lane = A::Lane::<V>::splat(level, value);
        }
        Twist::from_array(lanes)
    }
}

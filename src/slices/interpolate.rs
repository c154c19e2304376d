use super::sweep::{SliceKernel, Things, part, sweep};
use crate::backend::Backend;
use crate::batch::DualQuat;
use crate::law::{Law, Nlerp, Sclerp};
use crate::storage::shape::{ShapeError, same_length};
use crate::storage::{self, Element, Number, Register, Tile};
use core::ops::Range;
use dq8_simd::{Lanes, Level};

impl Backend {
    /// `between[i]` = normalize((1−t)aᵢ ± tbᵢ), by the shorter way; see
    /// [`DualQuat::nlerp`](crate::DualQuat::nlerp).
    ///
    /// # Errors
    /// If the slices differ in length; `between` is untouched.
    #[inline]
    pub fn nlerp<E: Element<8>>(
        self,
        a: &[E],
        b: &[E],
        t: Number<E, 8>,
        between: &mut [E],
    ) -> Result<(), ShapeError> {
        interpolate(self, Nlerp, a, b, One(t), between)
    }

    /// [`nlerp`](Self::nlerp) with a t for each, in the precision of the motions: `&[0.5_f32; 4]`,
    /// where bare literals are `f64`.
    ///
    /// # Errors
    /// If the slices differ in length; `between` is untouched.
    #[inline]
    pub fn nlerp_each<E: Element<8>, T: Element<1, Layout = E::Layout>>(
        self,
        a: &[E],
        b: &[E],
        t: &[T],
        between: &mut [E],
    ) -> Result<(), ShapeError> {
        same_length("t", t.len(), a.len())?;
        interpolate(self, Nlerp, a, b, Many(t), between)
    }

    /// `between[i]` = aᵢ(aᵢ*bᵢ)ᵗ, screw motion by the shorter way; see
    /// [`DualQuat::sclerp`](crate::DualQuat::sclerp).
    ///
    /// # Errors
    /// If the slices differ in length; `between` is untouched.
    ///
    /// ```
    /// use dq8::{Backend, DualQuat};
    /// let (a, b) = ([DualQuat::IDENTITY; 5], [DualQuat::from_translation([4.0_f32, 0.0, 0.0]); 5]);
    /// let mut between = a;
    /// Backend::best().sclerp(&a, &b, 0.25, &mut between)?;
    /// assert_eq!(between[4].translation(), [1.0, 0.0, 0.0]);
    /// Backend::best().sclerp_each(&a, &b, &[0.0_f32, 0.25, 0.5, 0.75, 1.0], &mut between)?;
    /// assert_eq!(between[3].translation(), [3.0, 0.0, 0.0]);
    /// # Ok::<(), dq8::ShapeError>(())
    /// ```
    #[inline]
    pub fn sclerp<E: Element<8>>(
        self,
        a: &[E],
        b: &[E],
        t: Number<E, 8>,
        between: &mut [E],
    ) -> Result<(), ShapeError> {
        interpolate(self, Sclerp, a, b, One(t), between)
    }

    /// [`sclerp`](Self::sclerp) with a t for each, in the precision of the motions.
    ///
    /// # Errors
    /// If the slices differ in length; `between` is untouched.
    #[inline]
    pub fn sclerp_each<E: Element<8>, T: Element<1, Layout = E::Layout>>(
        self,
        a: &[E],
        b: &[E],
        t: &[T],
        between: &mut [E],
    ) -> Result<(), ShapeError> {
        same_length("t", t.len(), a.len())?;
        interpolate(self, Sclerp, a, b, Many(t), between)
    }

    /// `between[i]` = rotation by SLERP and translation by LERP, each for itself; see
    /// [`DualQuat::slerp_lerp`](crate::DualQuat::slerp_lerp).
    ///
    /// # Errors
    /// If the slices differ in length; `between` is untouched.
    ///
    /// ```
    /// use dq8::{Backend, DualQuat, Quat};
    /// let turn = Quat::from_rotation_z(core::f32::consts::FRAC_PI_2);
    /// let (a, b) = ([DualQuat::IDENTITY; 3], [DualQuat::from_rotation_translation(turn, [4.0, 0.0, 0.0]); 3]);
    /// let mut between = a;
    /// Backend::best().slerp_lerp(&a, &b, 0.25, &mut between)?;
    /// let [x, y, _] = between[2].translation();
    /// assert!((x - 1.0).abs() < 1e-6 && y.abs() < 1e-6); // straight, where `sclerp` goes on an arc
    /// # Ok::<(), dq8::ShapeError>(())
    /// ```
    #[inline]
    pub fn slerp_lerp<E: Element<8>>(
        self,
        a: &[E],
        b: &[E],
        t: Number<E, 8>,
        between: &mut [E],
    ) -> Result<(), ShapeError> {
        interpolate(self, SlerpLerp, a, b, One(t), between)
    }

    /// [`slerp_lerp`](Self::slerp_lerp) with a t for each, in the precision of the motions.
    ///
    /// # Errors
    /// If the slices differ in length; `between` is untouched.
    #[inline]
    pub fn slerp_lerp_each<E: Element<8>, T: Element<1, Layout = E::Layout>>(
        self,
        a: &[E],
        b: &[E],
        t: &[T],
        between: &mut [E],
    ) -> Result<(), ShapeError> {
        same_length("t", t.len(), a.len())?;
        interpolate(self, SlerpLerp, a, b, Many(t), between)
    }
}

/// A way from one motion to another: a law of clips, or [`SlerpLerp`], which no clip follows.
trait Between: Copy + Sync {
    fn between<L: Lanes>(self, a: [L; 8], b: [L; 8], t: L) -> [L; 8];
}

impl<W: Law<8>> Between for W {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn between<L: Lanes>(self, a: [L; 8], b: [L; 8], t: L) -> [L; 8] {
        Law::between(self, a, b, t)
    }
}

#[derive(Clone, Copy)]
struct SlerpLerp;

impl Between for SlerpLerp {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn between<L: Lanes>(self, a: [L; 8], b: [L; 8], t: L) -> [L; 8] {
        DualQuat::from_array(a).slerp_lerp(DualQuat::from_array(b), t).to_array()
    }
}

#[inline]
fn interpolate<E: Element<8>, W: Between, T: Parameter<E>>(
    backend: Backend,
    law: W,
    a: &[E],
    b: &[E],
    t: T,
    between: &mut [E],
) -> Result<(), ShapeError> {
    same_length("b", b.len(), a.len())?;
    same_length("between", between.len(), a.len())?;
    sweep(backend, between, Interpolation { law, a, b, t });
    Ok(())
}

/// The parameter t: the same for all, or one for each.
trait Parameter<E: Element<8>>: Sync {
    /// That of some of the elements.
    fn part(&self, elements: Range<usize>) -> Self;
    fn load<V: Level>(&self, level: V, tile: Tile) -> Option<Register<E, V, 8>>;
}

struct One<R>(R);
impl<E: Element<8>> Parameter<E> for One<Number<E, 8>> {
    fn part(&self, _: Range<usize>) -> Self {
        Self(self.0)
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load<V: Level>(&self, level: V, _: Tile) -> Option<Register<E, V, 8>> {
        Some(Lanes::splat(level, self.0))
    }
}

struct Many<'s, T>(&'s [T]);
impl<E: Element<8>, T: Element<1, Layout = E::Layout>> Parameter<E> for Many<'_, T> {
    fn part(&self, elements: Range<usize>) -> Self {
        Self(part(self.0, elements))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load<V: Level>(&self, level: V, tile: Tile) -> Option<Register<E, V, 8>> {
        let [t] = T::load(level, self.0, tile, &storage::identity())?;
        Some(t)
    }
}

struct Interpolation<'s, E, W, T> {
    law: W,
    a: &'s [E],
    b: &'s [E],
    t: T,
}

impl<E: Element<8>, W: Between, T: Parameter<E>> SliceKernel<E, 8> for Interpolation<'_, E, W, T> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn compute<V: Level>(&self, level: V, _: &[E], tile: Tile) -> Things<E, V, 8> {
        let a = E::load(level, self.a, tile, &storage::identity())?;
        let b = E::load(level, self.b, tile, &storage::identity())?;
        Some(self.law.between(a, b, self.t.load(level, tile)?))
    }
    fn part(&self, elements: Range<usize>) -> Self {
        let (a, b) = (part(self.a, elements.clone()), part(self.b, elements.clone()));
        Self { law: self.law, a, b, t: self.t.part(elements) }
    }
}

use super::sweep::{Operation, motions, same_length, sweep};
use crate::batch;
use crate::dispatch::Backend;
use crate::error::ShapeError;
use crate::place::{Number, Place, Register, Step};
use dq8_simd::{Lanes, Level};

impl Backend {
    /// `between[i]` = normalize((1−t)aᵢ ± tbᵢ), by the shorter way; see
    /// [`DualQuat::nlerp`](crate::DualQuat::nlerp).
    ///
    /// # Errors
    /// If the slices differ in length; `between` is untouched.
    #[inline]
    pub fn nlerp<P: Place<8>>(
        self,
        a: &[P],
        b: &[P],
        t: Number<P, 8>,
        between: &mut [P],
    ) -> Result<(), ShapeError> {
        interpolate(self, Nlerp, a, b, One(t), between)
    }

    /// [`nlerp`](Self::nlerp) with a t for each.
    ///
    /// # Errors
    /// If the slices differ in length; `between` is untouched.
    #[inline]
    pub fn nlerp_each<P: Place<8>, T: Place<1, Layout = P::Layout>>(
        self,
        a: &[P],
        b: &[P],
        t: &[T],
        between: &mut [P],
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
    pub fn sclerp<P: Place<8>>(
        self,
        a: &[P],
        b: &[P],
        t: Number<P, 8>,
        between: &mut [P],
    ) -> Result<(), ShapeError> {
        interpolate(self, Sclerp, a, b, One(t), between)
    }

    /// [`sclerp`](Self::sclerp) with a t for each.
    ///
    /// # Errors
    /// If the slices differ in length; `between` is untouched.
    #[inline]
    pub fn sclerp_each<P: Place<8>, T: Place<1, Layout = P::Layout>>(
        self,
        a: &[P],
        b: &[P],
        t: &[T],
        between: &mut [P],
    ) -> Result<(), ShapeError> {
        same_length("t", t.len(), a.len())?;
        interpolate(self, Sclerp, a, b, Many(t), between)
    }
}

#[inline]
fn interpolate<P: Place<8>, W: Way, T: Parameter<P>>(
    backend: Backend,
    way: W,
    a: &[P],
    b: &[P],
    t: T,
    between: &mut [P],
) -> Result<(), ShapeError> {
    same_length("b", b.len(), a.len())?;
    same_length("between", between.len(), a.len())?;
    sweep(backend, between, Interpolation { way, a, b, t });
    Ok(())
}

/// From one motion to another.
trait Way {
    fn at<L: Lanes>(
        &self,
        a: batch::DualQuat<L>,
        b: batch::DualQuat<L>,
        t: L,
    ) -> batch::DualQuat<L>;
}

struct Nlerp;
impl Way for Nlerp {
    #[inline(always)]
    fn at<L: Lanes>(
        &self,
        a: batch::DualQuat<L>,
        b: batch::DualQuat<L>,
        t: L,
    ) -> batch::DualQuat<L> {
        a.nlerp(b, t)
    }
}

struct Sclerp;
impl Way for Sclerp {
    #[inline(always)]
    fn at<L: Lanes>(
        &self,
        a: batch::DualQuat<L>,
        b: batch::DualQuat<L>,
        t: L,
    ) -> batch::DualQuat<L> {
        a.sclerp(b, t)
    }
}

/// t, the same for all or one each.
trait Parameter<P: Place<8>> {
    fn lanes<V: Level>(&self, level: V, step: Step) -> Option<Register<P, V, 8>>;
}

struct One<R>(R);
impl<P: Place<8>> Parameter<P> for One<Number<P, 8>> {
    #[inline(always)]
    fn lanes<V: Level>(&self, level: V, _: Step) -> Option<Register<P, V, 8>> {
        Some(Lanes::splat(level, self.0))
    }
}

struct Many<'s, T>(&'s [T]);
impl<P: Place<8>, T: Place<1, Layout = P::Layout>> Parameter<P> for Many<'_, T> {
    #[inline(always)]
    fn lanes<V: Level>(&self, level: V, step: Step) -> Option<Register<P, V, 8>> {
        let [t] = T::gather(level, self.0, step, [Default::default()])?;
        Some(t)
    }
}

struct Interpolation<'s, P, W, T> {
    way: W,
    a: &'s [P],
    b: &'s [P],
    t: T,
}

impl<P: Place<8>, W: Way, T: Parameter<P>> Operation<P, 8> for Interpolation<'_, P, W, T> {
    #[inline(always)]
    fn compute<V: Level>(&self, level: V, _: &[P], step: Step) -> Option<[Register<P, V, 8>; 8]> {
        let (a, b) = (motions(level, self.a, step)?, motions(level, self.b, step)?);
        Some(self.way.at(a, b, self.t.lanes(level, step)?).to_array())
    }
}

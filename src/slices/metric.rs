use super::sweep::{SliceKernel, motions, part, sweep};
use crate::backend::Backend;
use crate::batch;
use crate::storage::shape::{ShapeError, same_length};
use crate::storage::{Element, Register, Tile};
use core::ops::Range;
use dq8_simd::{Lanes, Level};

impl Backend {
    /// `angles[i]` = the angle between unit aᵢ and bᵢ, radians in [0, π]; see
    /// [`DualQuat::angle_to`](crate::DualQuat::angle_to).
    ///
    /// # Errors
    /// If the slices differ in length; `angles` is untouched.
    #[inline]
    pub fn angles<E: Element<8>, T: Element<1, Layout = E::Layout>>(
        self,
        a: &[E],
        b: &[E],
        angles: &mut [T],
    ) -> Result<(), ShapeError> {
        same_length("b", b.len(), a.len())?;
        same_length("angles", angles.len(), a.len())?;
        sweep(self, angles, Between { a, b, measure: Angle });
        Ok(())
    }

    /// `distances[i]` = |t_a − t_b| of unit aᵢ and bᵢ; see
    /// [`DualQuat::distance_to`](crate::DualQuat::distance_to).
    ///
    /// # Errors
    /// If the slices differ in length; `distances` is untouched.
    ///
    /// ```
    /// use dq8::{Backend, DualQuat};
    /// let (here, there) = ([DualQuat::IDENTITY; 5], [DualQuat::from_translation([0.0_f32, 3.0, 4.0]); 5]);
    /// let mut distances = [0.0_f32; 5];
    /// Backend::best().distances(&here, &there, &mut distances)?;
    /// assert_eq!(distances, [5.0; 5]);
    /// # Ok::<(), dq8::ShapeError>(())
    /// ```
    #[inline]
    pub fn distances<E: Element<8>, T: Element<1, Layout = E::Layout>>(
        self,
        a: &[E],
        b: &[E],
        distances: &mut [T],
    ) -> Result<(), ShapeError> {
        same_length("b", b.len(), a.len())?;
        same_length("distances", distances.len(), a.len())?;
        sweep(self, distances, Between { a, b, measure: Distance });
        Ok(())
    }
}

/// A number between two motions.
trait Measure: Copy + Sync {
    fn of<L: Lanes>(&self, a: batch::DualQuat<L>, b: batch::DualQuat<L>) -> L;
}

#[derive(Clone, Copy)]
struct Angle;
impl Measure for Angle {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn of<L: Lanes>(&self, a: batch::DualQuat<L>, b: batch::DualQuat<L>) -> L {
        a.angle_to(b)
    }
}

#[derive(Clone, Copy)]
struct Distance;
impl Measure for Distance {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn of<L: Lanes>(&self, a: batch::DualQuat<L>, b: batch::DualQuat<L>) -> L {
        a.distance_to(b)
    }
}

struct Between<'s, E, M> {
    a: &'s [E],
    b: &'s [E],
    measure: M,
}

impl<E, T, M> SliceKernel<T, 1> for Between<'_, E, M>
where
    E: Element<8>,
    T: Element<1, Layout = E::Layout>,
    M: Measure,
{
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn compute<V: Level>(&self, level: V, _: &[T], tile: Tile) -> Option<[Register<T, V, 1>; 1]> {
        Some([self.measure.of(motions(level, self.a, tile)?, motions(level, self.b, tile)?)])
    }
    fn part(&self, elements: Range<usize>) -> Self {
        let (a, b) = (part(self.a, elements.clone()), part(self.b, elements));
        Self { a, b, measure: self.measure }
    }
}

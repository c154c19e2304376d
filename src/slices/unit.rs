use super::map::{Unary, operations};
use super::sweep::{SliceKernel, Things, sweep};
use crate::backend::Backend;
use crate::batch::DualQuat;
use crate::storage::shape::{ShapeError, same_length};
use crate::storage::{self, Element, Source, Tile};
use core::ops::Range;
use dq8_simd::Level;

impl Backend {
    /// `units[i]` = σᵢ/√(σᵢσᵢ*), exactly; some component is NaN where the result does
    /// not exist (see [`Motion::normalize_checked`](crate::Motion::normalize_checked)).
    ///
    /// # Errors
    /// If the slices differ in length; `units` is untouched.
    ///
    /// ```
    /// use dq8::{Backend, DualQuat};
    /// let twice = [DualQuat::from_translation([1.0_f32, 2.0, 3.0]).scale(2.0); 5];
    /// let mut units = [DualQuat::ZERO; 5];
    /// Backend::best().normalize(&twice, &mut units)?;
    /// assert_eq!(units[4].translation(), [1.0, 2.0, 3.0]);
    /// # Ok::<(), dq8::ShapeError>(())
    /// ```
    #[inline]
    pub fn normalize<E: Element<8>>(
        self,
        motions: &[E],
        units: &mut [E],
    ) -> Result<(), ShapeError> {
        same_length("units", units.len(), motions.len())?;
        sweep(self, units, OrInPlace { from: Source::Slice(motions), operation: Normalize });
        Ok(())
    }

    /// [`normalize`](Self::normalize) over the motions themselves.
    #[inline]
    pub fn normalize_in_place<E: Element<8>>(self, motions: &mut [E]) {
        sweep(self, motions, OrInPlace { from: Source::Output, operation: Normalize });
    }

    /// `inverses[i]` = σᵢ⁻¹; some component is NaN or infinite where it does not exist (see
    /// [`Motion::inverse_checked`](crate::Motion::inverse_checked)).
    ///
    /// # Errors
    /// If the slices differ in length; `inverses` is untouched.
    #[inline]
    pub fn inverse<E: Element<8>>(
        self,
        motions: &[E],
        inverses: &mut [E],
    ) -> Result<(), ShapeError> {
        same_length("inverses", inverses.len(), motions.len())?;
        sweep(self, inverses, OrInPlace { from: Source::Slice(motions), operation: Inverse });
        Ok(())
    }

    /// [`inverse`](Self::inverse) over the motions themselves.
    #[inline]
    pub fn inverse_in_place<E: Element<8>>(self, motions: &mut [E]) {
        sweep(self, motions, OrInPlace { from: Source::Output, operation: Inverse });
    }

    /// `conjugates[i]` = σᵢ* = p* + εq*, the inverse of unit motions: no division.
    ///
    /// # Errors
    /// If the slices differ in length; `conjugates` is untouched.
    #[inline]
    pub fn conjugate<E: Element<8>>(
        self,
        motions: &[E],
        conjugates: &mut [E],
    ) -> Result<(), ShapeError> {
        same_length("conjugates", conjugates.len(), motions.len())?;
        sweep(self, conjugates, OrInPlace { from: Source::Slice(motions), operation: Conjugate });
        Ok(())
    }

    /// [`conjugate`](Self::conjugate) over the motions themselves.
    #[inline]
    pub fn conjugate_in_place<E: Element<8>>(self, motions: &mut [E]) {
        sweep(self, motions, OrInPlace { from: Source::Output, operation: Conjugate });
    }
}

operations! {
    Normalize(motion: 8) -> 8 = DualQuat::from_array(motion).normalize().to_array();
    Inverse(motion: 8) -> 8 = DualQuat::from_array(motion).inverse().to_array();
    Conjugate(motion: 8) -> 8 = DualQuat::from_array(motion).conjugate().to_array();
}

struct OrInPlace<'s, E, F> {
    from: Source<'s, E>,
    operation: F,
}

impl<E: Element<8>, F: Unary<8, 8>> SliceKernel<E, 8> for OrInPlace<'_, E, F> {
    fn reads_output(&self) -> bool {
        self.from.is_output()
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn compute<V: Level>(&self, level: V, output: &[E], tile: Tile) -> Things<E, V, 8> {
        let motion = E::load(level, self.from.or(output), tile, &storage::identity())?;
        Some(self.operation.of(motion))
    }
    fn part(&self, elements: Range<usize>) -> Self {
        Self { from: self.from.part(elements), operation: self.operation }
    }
}

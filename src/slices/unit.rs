use super::sweep::{Operation, motions, same_length, sweep};
use crate::batch;
use crate::dispatch::Backend;
use crate::error::ShapeError;
use crate::place::{Place, Register, Step};
use dq8_simd::{Lanes, Level};

impl Backend {
    /// `units[i]` = σᵢ/√(σᵢσᵢ*), exactly; some component is NaN where there is no such motion (see
    /// [`Motion::normalize_checked`](crate::Motion::normalize_checked)).
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
    pub fn normalize<P: Place<8>>(self, motions: &[P], units: &mut [P]) -> Result<(), ShapeError> {
        same_length("units", units.len(), motions.len())?;
        sweep(self, units, Each { from: Some(motions), change: Normalize });
        Ok(())
    }

    /// [`normalize`](Self::normalize) over the motions themselves.
    #[inline]
    pub fn normalize_in_place<P: Place<8>>(self, motions: &mut [P]) {
        sweep(self, motions, Each { from: None, change: Normalize });
    }

    /// `inverses[i]` = σᵢ⁻¹; some component is NaN or infinite where there is none (see
    /// [`Motion::inverse_checked`](crate::Motion::inverse_checked)).
    ///
    /// # Errors
    /// If the slices differ in length; `inverses` is untouched.
    #[inline]
    pub fn inverse<P: Place<8>>(self, motions: &[P], inverses: &mut [P]) -> Result<(), ShapeError> {
        same_length("inverses", inverses.len(), motions.len())?;
        sweep(self, inverses, Each { from: Some(motions), change: Inverse });
        Ok(())
    }

    /// [`inverse`](Self::inverse) over the motions themselves.
    #[inline]
    pub fn inverse_in_place<P: Place<8>>(self, motions: &mut [P]) {
        sweep(self, motions, Each { from: None, change: Inverse });
    }
}

/// A function of one motion.
trait Change {
    fn of<L: Lanes>(&self, motion: batch::DualQuat<L>) -> batch::DualQuat<L>;
}

struct Normalize;
impl Change for Normalize {
    #[inline(always)]
    fn of<L: Lanes>(&self, motion: batch::DualQuat<L>) -> batch::DualQuat<L> {
        motion.normalize()
    }
}

struct Inverse;
impl Change for Inverse {
    #[inline(always)]
    fn of<L: Lanes>(&self, motion: batch::DualQuat<L>) -> batch::DualQuat<L> {
        motion.inverse()
    }
}

/// Without `from`, what the output holds.
struct Each<'s, P, C> {
    from: Option<&'s [P]>,
    change: C,
}

impl<P: Place<8>, C: Change> Operation<P, 8> for Each<'_, P, C> {
    fn reads_output(&self) -> bool {
        self.from.is_none()
    }
    #[inline(always)]
    fn compute<V: Level>(
        &self,
        level: V,
        output: &[P],
        step: Step,
    ) -> Option<[Register<P, V, 8>; 8]> {
        Some(self.change.of(motions(level, self.from.unwrap_or(output), step)?).to_array())
    }
}

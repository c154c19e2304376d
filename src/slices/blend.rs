use super::sweep::{SliceKernel, Things, part, sweep};
use crate::backend::Backend;
use crate::batch;
use crate::storage::motions;
use crate::storage::shape::{ShapeError, same_length};
use crate::storage::{self, Element, Register, Tile};
use core::ops::Range;
use dq8_simd::{Lanes, Level};

impl Backend {
    /// `blends[i]` = normalize(Σₖ ±wₖᵢσₖᵢ), each sign turned toward the motion of the
    /// first influence: dual quaternion linear blending of K slices by a weight each, influence k
    /// being `(σₖ, wₖ)`; see [`DualQuat::dlb`](crate::DualQuat::dlb).
    ///
    /// # Errors
    /// If the slices differ in length; `blends` is untouched.
    ///
    /// ```
    /// use dq8::{Backend, DualQuat};
    /// let at = |x| [DualQuat::from_translation([x, 0.0_f32, 0.0]); 5];
    /// let mut blends = at(0.0);
    /// let influences = [(&at(0.0)[..], &[0.25_f32; 5][..]), (&at(4.0), &[0.75; 5])];
    /// Backend::best().dlb(influences, &mut blends)?;
    /// assert_eq!(blends[4].translation(), [3.0, 0.0, 0.0]);
    /// # Ok::<(), dq8::ShapeError>(())
    /// ```
    #[inline]
    pub fn dlb<E: Element<8>, T: Element<1, Layout = E::Layout>, const K: usize>(
        self,
        influences: [(&[E], &[T]); K],
        blends: &mut [E],
    ) -> Result<(), ShapeError> {
        const { assert!(K > 0, "a blend needs an influence") }
        for (motions, weights) in influences {
            same_length("influence", motions.len(), blends.len())?;
            same_length("weights", weights.len(), blends.len())?;
        }
        sweep(self, blends, Dlb(influences));
        Ok(())
    }
}

struct Dlb<'s, E, T, const K: usize>([(&'s [E], &'s [T]); K]);

impl<E, T, const K: usize> SliceKernel<E, 8> for Dlb<'_, E, T, K>
where
    E: Element<8>,
    T: Element<1, Layout = E::Layout>,
{
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn compute<V: Level>(&self, level: V, _: &[E], tile: Tile) -> Things<E, V, 8> {
        let zero = Register::<E, V, 8>::splat(level, Default::default());
        let mut influences = [(batch::DualQuat::identity(level), zero); K];
        for ((motions_of, weights), influence) in self.0.iter().zip(&mut influences) {
            let [weight] = T::load(level, weights, tile, &storage::identity())?;
            *influence = (motions(level, motions_of, tile)?, weight);
        }
        Some(batch::DualQuat::dlb(&influences)?.to_array())
    }
    fn part(&self, elements: Range<usize>) -> Self {
        Self(self.0.map(|(motions, weights)| {
            (part(motions, elements.clone()), part(weights, elements.clone()))
        }))
    }
}

//! Kernels that blend several motions into one: motions of several slices, or of a window of one
//! slice.

#[cfg(feature = "rayon")]
use super::sweep::GRAIN;
use super::sweep::{SliceKernel, Things, sweep};
use crate::backend::{Backend, Kernel};
use crate::batch;
use crate::number::Scalar;
use crate::scalar::DualQuat;
use crate::storage::motions;
use crate::storage::shape::{ShapeError, same_length};
use crate::storage::{self, Element, Register, Tile, tiles};
use core::ops::Range;
use dq8_simd::{Lanes, Level};

impl Backend {
    /// Blends K slices of motions by dual quaternion linear blending: `blends[i]` = normalize(Σₖ
    /// ±wₖᵢσₖᵢ), where influence k is the pair of slices `(σₖ, wₖ)`. Each sign is
    /// chosen so that the motion lies on the same hemisphere as the motion of the first influence;
    /// see [`DualQuat::dlb`](crate::DualQuat::dlb).
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

    /// Smooths a trajectory: `means[i]` is the intrinsic mean of the `W` poses `poses[i..i + W]`,
    /// with the same `weights` for each window; see [`DualQuat::dib`]. Returns the number of means
    /// that have converged to `tolerance` within `max_iterations`.
    ///
    /// # Errors
    /// If there are no weights, or `means` does not have `poses.len() + 1 - W` elements, one for
    /// each whole window (fewer than `W` poses have no window); `means` is untouched.
    ///
    /// ```
    /// use dq8::{Backend, DualQuat};
    /// let poses = [0.0_f64, 1.0, 5.0, 6.0].map(|x| DualQuat::from_translation([x, 0.0, 0.0]));
    /// let mut means = [DualQuat::IDENTITY; 2];
    /// let converged = Backend::best().dib_windows(&poses, &[1.0; 3], 1e-12, 16, &mut means)?;
    /// assert_eq!(converged, 2);
    /// assert!((means[1].translation()[0] - 4.0).abs() < 1e-12);
    /// # Ok::<(), dq8::ShapeError>(())
    /// ```
    #[doc(alias("smooth", "moving_average", "filter"))]
    pub fn dib_windows<R: Scalar, const W: usize>(
        self,
        poses: &[DualQuat<R>],
        weights: &[R; W],
        tolerance: R,
        max_iterations: u32,
        means: &mut [DualQuat<R>],
    ) -> Result<usize, ShapeError> {
        if W == 0 {
            return same_length("weights", 0, 1).map(|()| 0);
        }
        if poses.len() < W && !means.is_empty() {
            return Err(ShapeError::NoWindow { poses: poses.len(), window: W });
        }
        same_length("means", means.len(), (poses.len() + 1).saturating_sub(W))?;
        #[cfg(feature = "rayon")]
        if self.many() {
            let converged = core::sync::atomic::AtomicUsize::new(0);
            self.share(GRAIN, (means, 1), &|start, (means, _): (&mut [_], usize)| {
                let Some(poses) = poses.get(start..start + means.len() + W - 1) else { return };
                let windows = Windows { poses, weights, tolerance, max_iterations, means };
                converged.fetch_add(self.run(windows), core::sync::atomic::Ordering::Relaxed);
            });
            return Ok(converged.into_inner());
        }
        Ok(self.run(Windows { poses, weights, tolerance, max_iterations, means }))
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
    fn part(&self, elements: Range<usize>) -> Option<Self> {
        let mut parts = self.0;
        for (motions, weights) in &mut parts {
            *motions = motions.get(elements.clone())?;
            *weights = weights.get(elements.clone())?;
        }
        Some(Self(parts))
    }
}

struct Windows<'s, R, const W: usize> {
    poses: &'s [DualQuat<R>],
    weights: &'s [R; W],
    tolerance: R,
    max_iterations: u32,
    means: &'s mut [DualQuat<R>],
}

impl<R: Scalar, const W: usize> Kernel for Windows<'_, R, W> {
    type Output = usize;
    const WIDE: bool = false;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) -> usize {
        let Self { poses, weights, tolerance, max_iterations, means } = self;
        let tolerance = R::Lanes::<V>::splat(level, tolerance);
        let (zero, one) = (tolerance.constant(0.0), tolerance.constant(1.0));
        let mut converged = 0;
        for tile in tiles::<DualQuat<R>, V, 8>(means.len()) {
            let mut window = [(batch::DualQuat::identity(level), zero); W];
            for (offset, (influence, &weight)) in window.iter_mut().zip(weights).enumerate() {
                let Some(poses) = motions(level, poses, Tile::at(tile.element + offset, 0)) else {
                    return converged;
                };
                *influence = (poses, R::Lanes::<V>::splat(level, weight));
            }
            let Some(mean) = batch::DualQuat::dib(&window, tolerance, max_iterations) else {
                return converged;
            };
            let done = R::Lanes::<V>::select(mean.converged, one, zero).to_array();
            let here = means.len().saturating_sub(tile.element);
            for &lane in done.as_ref().iter().take(here) {
                converged += usize::from(lane == R::ONE);
            }
            DualQuat::store(mean.motion.to_array(), means, tile);
        }
        converged
    }
}

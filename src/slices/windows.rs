//! Means of windows: poses that follow each other, smoothed.

#[cfg(feature = "rayon")]
use super::sweep::{GRAIN, part};
use crate::backend::{Backend, Kernel};
use crate::batch;
use crate::number::Scalar;
use crate::scalar::DualQuat;
use crate::storage::motions;
use crate::storage::shape::{ShapeError, same_length};
use crate::storage::{Element, Tile, tiles};
use dq8_simd::{Lanes, Level};

impl Backend {
    /// `means[i]` = the intrinsic mean of `poses[i..i + W]` with these weights, the same for all:
    /// a trajectory smoothed, [`DualQuat::dib`] on lanes. Gives back how many of the means have
    /// converged to the tolerance.
    ///
    /// # Errors
    /// If there are no weights, or `means` does not hold one element for each whole window,
    /// `poses.len() + 1 - W`, of which fewer than W poses have none; `means` is untouched.
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
                let poses = part(poses, start..start + means.len() + W - 1);
                let windows = Windows { poses, weights, tolerance, max_iterations, means };
                converged.fetch_add(self.run(windows), core::sync::atomic::Ordering::Relaxed);
            });
            return Ok(converged.into_inner());
        }
        Ok(self.run(Windows { poses, weights, tolerance, max_iterations, means }))
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

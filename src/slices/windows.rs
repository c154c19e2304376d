//! Trajectories: poses at times, sampled at other times, and smoothed.

use super::interpolate::{Interpolation, Many};
#[cfg(feature = "rayon")]
use super::sweep::GRAIN;
use super::sweep::{SliceKernel, Things, motions, part, sweep};
#[cfg(feature = "rayon")]
use crate::backend::Rows;
use crate::backend::{Backend, Kernel};
use crate::batch;
use crate::errors::errors;
use crate::geometry::Twist;
use crate::law::Sclerp;
use crate::number::{Real, Scalar};
use crate::scalar::DualQuat;
use crate::storage::shape::{ShapeError, same_length};
use crate::storage::{Element, Tile, tiles};
use core::ops::Range;
use dq8_simd::{Lanes, Level};

/// The number of samples that are looked up before they are computed: few enough to stay in the
/// first cache, on the stack.
const CHUNK: usize = 64;

errors! {
    /// Times and poses that do not make a trajectory.
    #[derive(Clone, Debug, PartialEq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    TrajectoryError {
        /// Slices that do not fit each other.
        Shape(error: ShapeError) => "{error}";
        /// There are no poses to sample.
        Empty => "a trajectory without poses has no samples";
        /// A time is not finite, or not later than the one before.
        NotRising { index: usize = "The number of the time.", value: f64 = "Its value." }
            => "time {index} is {value}: times must be finite, and rise";
        /// A time to sample at is NaN.
        NotATime { index: usize = "Which." } => "sample {index} is asked for at NaN";
    }
}

impl Backend {
    /// `samples[i]` = the pose at the time `at[i]` on the trajectory through `poses[k]` at
    /// `times[k]`: screw motion between neighbours, [`DualQuat::sclerp`] by the shorter way; before
    /// the first and after the last pose, that pose. Samples may be asked for in any order; rising
    /// ones are found fastest.
    ///
    /// # Errors
    /// If lengths differ (`times` and `poses`, `at` and `samples`), there is no pose, times do not
    /// rise or one is not finite, or a sample is asked for at NaN; `samples` is untouched.
    ///
    /// ```
    /// use dq8::{Backend, DualQuat};
    /// let poses = [0.0_f64, 2.0, 8.0].map(|x| DualQuat::from_translation([x, 0.0, 0.0]));
    /// let mut samples = [DualQuat::IDENTITY; 3];
    /// Backend::best().resample(&[0.0, 1.0, 3.0], &poses, &[0.5, 2.0, 9.0], &mut samples)?;
    /// assert_eq!(samples.map(|pose| pose.translation()[0]), [1.0, 5.0, 8.0]);
    /// # Ok::<(), dq8::slices::TrajectoryError>(())
    /// ```
    pub fn resample<R: Scalar>(
        self,
        times: &[R],
        poses: &[DualQuat<R>],
        at: &[R],
        samples: &mut [DualQuat<R>],
    ) -> Result<(), TrajectoryError> {
        self.sample(times, poses, at, samples, &mut [])
    }

    /// [`resample`](Self::resample), and `twists[i]` = how the pose moves there: the twist in the
    /// frame of the moving body, of the unit of time of `times`, which on a screw motion is the
    /// same from one pose to the next, log((p*q)²) / (t_q − t_p). At a pose it is that of the
    /// way to the next one; before the first pose, and from the last one on, it is zero.
    /// [`integrate_body`](Self::integrate_body) goes along it.
    ///
    /// # Errors
    /// As there, and if `twists` is not as long as `at`; nothing is written.
    ///
    /// ```
    /// use dq8::{Backend, DualQuat, Twist};
    /// let poses = [0.0_f64, 2.0, 8.0].map(|x| DualQuat::from_translation([x, 0.0, 0.0]));
    /// let (mut samples, mut twists) = ([DualQuat::IDENTITY; 3], [Twist::ZERO; 3]);
    /// let times = [0.0, 1.0, 3.0];
    /// Backend::best().resample_with_twists(&times, &poses, &[0.5, 2.0, 9.0], &mut samples, &mut twists)?;
    /// assert_eq!(twists.map(|twist| twist.linear[0]), [2.0, 3.0, 0.0]);
    /// # Ok::<(), dq8::slices::TrajectoryError>(())
    /// ```
    pub fn resample_with_twists<R: Scalar>(
        self,
        times: &[R],
        poses: &[DualQuat<R>],
        at: &[R],
        samples: &mut [DualQuat<R>],
        twists: &mut [Twist<R>],
    ) -> Result<(), TrajectoryError> {
        same_length("twists", twists.len(), at.len())?;
        self.sample(times, poses, at, samples, twists)
    }

    /// Samples, and twists unless there are none.
    fn sample<R: Scalar>(
        self,
        times: &[R],
        poses: &[DualQuat<R>],
        at: &[R],
        samples: &mut [DualQuat<R>],
        twists: &mut [Twist<R>],
    ) -> Result<(), TrajectoryError> {
        same_length("poses", poses.len(), times.len())?;
        same_length("samples", samples.len(), at.len())?;
        let Some(first) = poses.first() else { return Err(TrajectoryError::Empty) };
        let mut before = None;
        for (index, &time) in times.iter().enumerate() {
            if !time.is_finite() || before.is_some_and(|before| time <= before) {
                return Err(TrajectoryError::NotRising { index, value: time.into() });
            }
            before = Some(time);
        }
        if let Some(index) = at.iter().position(|time| time.is_nan()) {
            return Err(TrajectoryError::NotATime { index });
        }
        let trajectory = Trajectory { times, poses, first: *first };
        #[cfg(feature = "rayon")]
        if self.many() {
            let work = |start, ((samples, _), (twists, _)): (Rows<'_, _>, Rows<'_, _>)| {
                let at = part(at, start..start + samples.len());
                trajectory.sample(self, at, samples, twists);
            };
            self.share(GRAIN, ((samples, 1), (twists, 1)), &work);
            return Ok(());
        }
        trajectory.sample(self, at, samples, twists);
        Ok(())
    }

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

/// Checked: times rise, and there is a pose for each.
struct Trajectory<'s, R> {
    times: &'s [R],
    poses: &'s [DualQuat<R>],
    first: DualQuat<R>,
}

impl<R: Scalar> Trajectory<'_, R> {
    fn sample(
        &self,
        backend: Backend,
        at: &[R],
        samples: &mut [DualQuat<R>],
        twists: &mut [Twist<R>],
    ) {
        let Self { times, poses, first } = *self;
        let (mut from, mut to, mut share) = ([first; CHUNK], [first; CHUNK], [[R::ZERO]; CHUNK]);
        let mut durations = [[R::ONE]; CHUNK];
        let (mut after, mut twists) = (0, twists.chunks_mut(CHUNK));
        for (at, samples) in at.chunks(CHUNK).zip(samples.chunks_mut(CHUNK)) {
            let slots = from.iter_mut().zip(&mut to).zip(&mut share).zip(&mut durations);
            for (&time, (((from, to), [share]), [duration])) in at.iter().zip(slots) {
                after = first_after(times, time, after);
                let last = times.len().saturating_sub(1);
                let (start, end) = (after.saturating_sub(1), after.min(last));
                let pose = |index| poses.get(index).copied().unwrap_or(first);
                let when = |index| times.get(index).copied().unwrap_or(time);
                (*from, *to) = (pose(start), pose(end));
                let (start, end) = (when(start), when(end));
                *share = if start < end { share_of(time, start, end) } else { R::ZERO };
                // Outside nothing moves, to the last bit.
                let moves = start < end;
                *duration = if moves { end - start } else { <R as Real>::from_f64(f64::INFINITY) };
            }
            let n = 0..at.len();
            let (a, b, t) =
                (part(&from, n.clone()), part(&to, n.clone()), Many(part(&share, n.clone())));
            sweep(backend, samples, Interpolation { law: Sclerp, a, b, t });
            if let Some(twists) = twists.next() {
                sweep(backend, twists, Velocities { a, b, durations: part(&durations, n) });
            }
        }
    }
}

/// The index of the first of the `times` later than `time`; `near` is a guess, right if samples
/// rise slowly.
fn first_after<R: Scalar>(times: &[R], time: R, near: usize) -> usize {
    let before = |index: usize| times.get(index).is_some_and(|&t| t <= time);
    for guess in near..near.saturating_add(4) {
        if !before(guess) && (guess == 0 || before(guess - 1)) {
            return guess.min(times.len());
        }
    }
    times.partition_point(|&t| t <= time)
}

/// The share of the way from `start` to `end` at `time`, 0 to 1.
fn share_of<R: Scalar>(time: R, start: R, end: R) -> R {
    let length = end - start;
    if length.is_finite() {
        return (time - start) / length;
    }
    // Half of so long a time is not.
    (time * R::HALF - start * R::HALF) / (end * R::HALF - start * R::HALF)
}

/// The twist from `a` to `b` by the shorter way, in this time.
struct Velocities<'s, R> {
    a: &'s [DualQuat<R>],
    b: &'s [DualQuat<R>],
    durations: &'s [[R; 1]],
}

impl<R: Scalar> SliceKernel<Twist<R>, 6> for Velocities<'_, R> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn compute<V: Level>(&self, level: V, _: &[Twist<R>], tile: Tile) -> Things<Twist<R>, V, 6> {
        let (a, b) = (motions(level, self.a, tile)?, motions(level, self.b, tile)?);
        let [duration] = <[R; 1]>::load(level, self.durations, tile, &[R::ONE])?;
        // A logarithm takes the shorter way.
        Some((a.conjugate() * b).to_twist().to_array().map(|component| component / duration))
    }
    fn part(&self, elements: Range<usize>) -> Self {
        let [a, b] = [self.a, self.b].map(|poses| part(poses, elements.clone()));
        Self { a, b, durations: part(self.durations, elements) }
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

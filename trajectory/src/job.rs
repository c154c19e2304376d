//! [`Job`]: a run over many times, with options that all have a default.

use crate::along::{Along, MOVES, Moves, Points, Poses, SAMPLES, Samples, Scan, Work};
use crate::clock::{Clock, Time};
use crate::segments::{Frame, Outside, Segments};
use crate::stretches::{Record, beyond, segments};
use crate::{OwnedTrajectory, Trajectory, TrajectoryError};
use alloc::vec;
use dq8::internal::{Choice, Rows, options};
use dq8::storage::{Element, Layout, same_length};
use dq8::{DualQuat, Scalar, ShapeError};

/// A run over many times, as many at once as there are lanes, of a [`Trajectory`], of a
/// [`Spline`](crate::Spline) or of [`Frames`](crate::Frames). Times may be in any order; rising
/// ones are quickest.
///
/// Without options times are seconds on the clock of the stamps, poses and points come out in the
/// world, and the body stands before the first stamp and after the last one. Slices are plain or
/// blocks, of `f32` or `f64`.
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct Job<P> {
    pub(crate) path: P,
    pub(crate) clock: Clock,
    pub(crate) frame: Frame,
    pub(crate) outside: Outside,
    pub(crate) choice: Choice,
}

/// The number of things that a thread takes at least.
pub(crate) const GRAIN: usize = 4096;

impl<'a> Trajectory<'a> {
    /// A run over many times.
    pub fn job(self) -> Job<Self> {
        Job::new(self)
    }
}

impl OwnedTrajectory {
    /// A run over many times.
    pub fn job(&self) -> Job<Trajectory<'_>> {
        self.view().job()
    }
}

impl<P: Copy> Job<P> {
    pub(crate) fn new(path: P) -> Self {
        let clock = Clock { origin: 0.0, unit: 1.0 };
        let choice = Choice::default();
        Self { path, clock, frame: Frame::default(), outside: Outside::default(), choice }
    }

    /// The clock of the times: the time t is the stamp `origin + unit · t`, in seconds. With an
    /// origin near the scan, times may be `f32` though stamps count from 1970.
    pub fn clock(mut self, origin: f64, unit: f64) -> Self {
        self.clock = Clock { origin, unit };
        self
    }

    /// The frame that poses and points come out in; by default the world.
    pub fn frame(mut self, frame: Frame) -> Self {
        self.frame = frame;
        self
    }

    /// What happens before the first stamp and after the last one; by default the body stands.
    pub fn outside(mut self, outside: Outside) -> Self {
        self.outside = outside;
        self
    }

    options!();

    /// A time on the clock of the stamps, in seconds.
    pub(crate) fn stamp(self, time: impl Time) -> f64 {
        self.clock.stamp(time)
    }

    /// Lengths, clock, and times that are refused.
    pub(crate) fn check<T: Time>(
        self,
        [first, last]: [f64; 2],
        what: &'static str,
        length: usize,
        times: &[T],
        things: usize,
    ) -> Result<(), TrajectoryError> {
        same_length(what, length, times.len().div_ceil(things))?;
        self.clock.check()?;
        if self.outside != Outside::Refuse {
            return Ok(());
        }
        let inside = |stamp| (first..=last).contains(&stamp);
        match times.iter().position(|&time| !inside(self.clock.stamp(time))) {
            Some(index) => {
                let value = self.clock.stamp(times[index]);
                Err(TrajectoryError::Outside { index, value, first, last })
            }
            None => Ok(()),
        }
    }

    /// The loop over the times of a part of the output.
    pub(crate) fn along<Y: Layout, T: Time, W: Work<Y, C>, const C: usize>(
        self,
        segments: &Segments<Y::Real, C>,
        times: &[T],
        first: usize,
        elements: usize,
        work: W,
    ) {
        let from = first * Y::THINGS;
        let to = (from + elements * Y::THINGS).min(times.len());
        let (clock, times) = (self.clock, times.get(from..to).unwrap_or_default());
        let stands = self.outside != Outside::Continue;
        self.choice.instructions().run(Along { segments, clock, stands, times, elements, work });
    }
}

impl<'a> Job<Trajectory<'a>> {
    /// A scan whose points share times by column: `times[column]`.
    pub fn columns<T: Time>(self, times: &'a [T]) -> Columns<'a, T> {
        Columns { job: self, times }
    }

    /// `poses[i]` = the pose at the time `times[i]`, in the frame of the job.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// use dq8_trajectory::Trajectory;
    /// let steps = [0.0, 2.0, 8.0].map(|x| DualQuat::from_translation([x, 0.0, 0.0]));
    /// let path = Trajectory::new(&[0.0, 1.0, 3.0], &steps)?;
    /// let mut poses = [DualQuat::<f32>::IDENTITY; 3];
    /// path.job().sample(&[2.0, 0.5, 9.0], &mut poses)?;
    /// assert_eq!(poses.map(|pose| pose.translation()[0]), [5.0, 1.0, 8.0]);
    /// # Ok::<(), dq8_trajectory::TrajectoryError>(())
    /// ```
    ///
    /// # Errors
    /// If `poses` does not hold as many poses as there are times (of blocks, so many that all find
    /// place), the clock has a number that is not finite or a unit of zero, there is no such frame,
    /// a time is outside where that is refused, or a single pose has no velocity to continue with;
    /// nothing is written.
    pub fn sample<T: Time, M: Element<8>>(
        self,
        times: &[T],
        poses: &mut [M],
    ) -> Result<(), TrajectoryError> {
        self.check(self.path.range(), "poses", poses.len(), times, M::Layout::THINGS)?;
        let none: &mut [<M::Layout as Layout>::Record<6>] = &mut [];
        self.poses(times, poses, none)
    }

    /// [`sample`](Self::sample), and `twists[i]` = the velocity there for one second, in the frame
    /// of the moving body (angular first): log((σ_k* σ_{k+1})²) / (t_{k+1} − t_k). At a stamp
    /// it is that of the way to the next one; where the body stands it is zero.
    ///
    /// # Errors
    /// As there, and if `twists` is not as long as `poses`; nothing is written.
    pub fn sample_with_twists<T: Time, M: Element<8>, W: Element<6, Layout = M::Layout>>(
        self,
        times: &[T],
        poses: &mut [M],
        twists: &mut [W],
    ) -> Result<(), TrajectoryError> {
        self.check(self.path.range(), "poses", poses.len(), times, M::Layout::THINGS)?;
        same_length("twists", twists.len(), poses.len())?;
        self.poses(times, poses, twists)
    }

    /// `moved[i]` = F⁻¹ σ(`times[i]`) `points[i]`: points that the moving body measured, each
    /// at its own time, in the frame F of the job. A point has three coordinates first; what else
    /// its record holds is copied.
    ///
    /// ```
    /// use dq8::Twist;
    /// use dq8_trajectory::{Frame, OwnedTrajectory};
    /// let turn = Twist { angular: [0.0, 0.0, 1.0], linear: [0.0; 3] };
    /// let path = OwnedTrajectory::of_twist(turn, 0.0..0.5)?;
    /// let mut points = [[1.0_f64, 0.0, 0.0]; 2];
    /// path.job().frame(Frame::Start).deskew_in_place(&[0.0, 0.5], &mut points)?;
    /// assert_eq!(points[0], [1.0, 0.0, 0.0]);
    /// assert!((points[1][1] - 0.5_f64.sin()).abs() < 1e-15);
    /// # Ok::<(), dq8_trajectory::TrajectoryError>(())
    /// ```
    ///
    /// # Errors
    /// If there are not as many points as times (of blocks, so many that all find place), `moved`
    /// is not as long as `points`, and as for [`sample`](Self::sample); nothing is written.
    pub fn deskew<T: Time, P: Element<N>, const N: usize>(
        self,
        times: &[T],
        points: &[P],
        moved: &mut [P],
    ) -> Result<(), TrajectoryError> {
        self.check(self.path.range(), "points", points.len(), times, P::Layout::THINGS)?;
        same_length("moved", moved.len(), points.len())?;
        self.points::<_, _, false, N>(times, Some(points), moved)
    }

    /// [`deskew`](Self::deskew) of `points` themselves.
    ///
    /// # Errors
    /// As there.
    pub fn deskew_in_place<T: Time, P: Element<N>, const N: usize>(
        self,
        times: &[T],
        points: &mut [P],
    ) -> Result<(), TrajectoryError> {
        self.check(self.path.range(), "points", points.len(), times, P::Layout::THINGS)?;
        self.points::<_, _, false, N>(times, None, points)
    }

    /// The inverse of [`deskew`](Self::deskew): `moved[i]` = σ(`times[i]`)⁻¹ F `points[i]`,
    /// points as the moving body would have measured them, each at its own time.
    ///
    /// # Errors
    /// As there.
    pub fn skew<T: Time, P: Element<N>, const N: usize>(
        self,
        times: &[T],
        points: &[P],
        moved: &mut [P],
    ) -> Result<(), TrajectoryError> {
        self.check(self.path.range(), "points", points.len(), times, P::Layout::THINGS)?;
        same_length("moved", moved.len(), points.len())?;
        self.points::<_, _, true, N>(times, Some(points), moved)
    }

    /// [`skew`](Self::skew) of `points` themselves.
    ///
    /// # Errors
    /// As there.
    pub fn skew_in_place<T: Time, P: Element<N>, const N: usize>(
        self,
        times: &[T],
        points: &mut [P],
    ) -> Result<(), TrajectoryError> {
        self.check(self.path.range(), "points", points.len(), times, P::Layout::THINGS)?;
        self.points::<_, _, true, N>(times, None, points)
    }

    fn poses<T: Time, M: Element<8>, W: Element<6, Layout = M::Layout>>(
        self,
        times: &[T],
        poses: &mut [M],
        twists: &mut [W],
    ) -> Result<(), TrajectoryError> {
        let segments = self.segments::<_, Samples, SAMPLES>(times)?;
        let work = |first, ((poses, _), (twists, _)): (Rows<'_, M>, Rows<'_, W>)| {
            let elements = poses.len();
            self.along::<M::Layout, _, _, _>(
                &segments,
                times,
                first,
                elements,
                Poses { poses, twists },
            );
        };
        let backend = self.choice.instructions();
        backend.share(GRAIN, ((poses, 1), (twists, 1)), &work);
        Ok(())
    }

    fn points<T: Time, P: Element<N>, const BACK: bool, const N: usize>(
        self,
        times: &[T],
        points: Option<&[P]>,
        moved: &mut [P],
    ) -> Result<(), TrajectoryError> {
        const { assert!(N >= 3, "a point has three coordinates") }
        let segments = self.segments::<_, Moves<BACK>, MOVES>(times)?;
        let work = |first: usize, (moved, _): Rows<'_, P>| {
            let elements = moved.len();
            let points = points.map(|points| &points[first..first + elements]);
            let work = Points::<P, BACK, N> { points, moved };
            self.along::<P::Layout, _, _, _>(&segments, times, first, elements, work);
        };
        self.choice.instructions().share(GRAIN, (moved, 1), &work);
        Ok(())
    }

    /// Records of the stretches that these times are in.
    fn segments<R: Scalar, Q: Record<C>, const C: usize>(
        self,
        times: &[impl Time],
    ) -> Result<Segments<R, C>, TrajectoryError> {
        let Self { path, clock, frame, outside, .. } = self;
        let goes_on = outside == Outside::Continue;
        if goes_on && path.stamps().len() == 1 {
            return Err(TrajectoryError::OnePose);
        }
        let outer = |time| beyond(path, time).filter(|_| goes_on);
        let at = |time| outer(time).unwrap_or_else(|| path.at(time));
        let into = frame.pose(path.range(), outside, at)?.conjugate();
        // Where there are many poses, those that no time needs are left out.
        let few = (2 * times.len() < path.stamps().len())
            .then(|| path.around(times.iter().map(|&time| clock.stamp(time))));
        let near = few.as_ref().map_or(path, OwnedTrajectory::view);
        Ok(segments::<_, Q, C>(near, outside, into, self.choice.instructions()))
    }
}

/// A scan of rows and columns, whose points share the times of their columns: [`Job::columns`].
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct Columns<'a, T> {
    job: Job<Trajectory<'a>>,
    times: &'a [T],
}

impl<T: Time> Columns<'_, T> {
    /// `moved[row][column]` = F⁻¹ σ(`times[column]`) `points[row][column]`, as [`Job::deskew`]
    /// does for points of their own times. Rows follow each other.
    ///
    /// ```
    /// use dq8::Twist;
    /// use dq8_trajectory::{Frame, OwnedTrajectory};
    /// let ahead = Twist { angular: [0.0; 3], linear: [1.0, 0.0, 0.0] };
    /// let path = OwnedTrajectory::of_twist(ahead, 0.0..1.0)?;
    /// let scan = [[[5.0_f32, 0.0, 0.0]; 3]; 2]; // two rows of three columns
    /// let mut moved = scan;
    /// let job = path.job().frame(Frame::End);
    /// job.columns(&[0.0, 0.5, 1.0]).deskew(scan.as_flattened(), moved.as_flattened_mut())?;
    /// assert_eq!(moved[1].map(|[x, ..]| x), [4.0, 4.5, 5.0]);
    /// # Ok::<(), dq8_trajectory::TrajectoryError>(())
    /// ```
    ///
    /// # Errors
    /// If the points are no whole number of rows, and as [`Job::deskew`]; nothing is written.
    pub fn deskew<R: Scalar, const N: usize>(
        self,
        points: &[[R; N]],
        moved: &mut [[R; N]],
    ) -> Result<(), TrajectoryError> {
        self.scan::<R, false, N>(points, moved)
    }

    /// The inverse of [`deskew`](Self::deskew).
    ///
    /// # Errors
    /// As there.
    pub fn skew<R: Scalar, const N: usize>(
        self,
        points: &[[R; N]],
        moved: &mut [[R; N]],
    ) -> Result<(), TrajectoryError> {
        self.scan::<R, true, N>(points, moved)
    }

    fn scan<R: Scalar, const BACK: bool, const N: usize>(
        self,
        points: &[[R; N]],
        moved: &mut [[R; N]],
    ) -> Result<(), TrajectoryError> {
        const { assert!(N >= 3, "a point has three coordinates") }
        let (length, columns) = (points.len(), self.times.len());
        if columns == 0 && length > 0 {
            return Err(ShapeError::Empty { what: "times" }.into());
        }
        if columns > 0 && length % columns != 0 {
            let expected = length - length % columns;
            return Err(ShapeError::Length { what: "points", length, expected }.into());
        }
        same_length("moved", moved.len(), length)?;
        // A pose for each column, which the rows share.
        let mut poses = vec![DualQuat::<R>::IDENTITY; columns];
        self.job.sample(self.times, &mut poses)?;
        if BACK {
            for pose in &mut poses {
                *pose = pose.conjugate();
            }
        }
        let work = |row: usize, (moved, _): Rows<'_, [R; N]>| {
            let points = &points[row * columns..][..moved.len()];
            self.job.choice.instructions().run(Scan { poses: &poses, points, moved });
        };
        let grain = GRAIN.div_ceil(columns.max(1));
        self.job.choice.instructions().share(grain, (moved, columns.max(1)), &work);
        Ok(())
    }
}

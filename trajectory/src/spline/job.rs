//! A spline at many times, a time in each lane.

use super::curve::{Moving, Spline};
use crate::TrajectoryError;
use crate::along::Work;
use crate::clock::Time;
use crate::job::{GRAIN, Job};
use crate::screw::horner;
use crate::segments::{Outside, Segments};
use alloc::vec::Vec;
use dq8::batch::{self, lie_bracket};
use dq8::internal::Rows;
use dq8::storage::{Element, Layout, Register, Tile, same_length};
use dq8::{DualQuat, Lanes, Level, Real, Scalar, Twist};

/// The numbers of a record: the first control pose of four, the three ways between them, and two
/// that fill fours.
pub(super) const RECORD: usize = 28;

impl Spline {
    /// A run over many times.
    pub fn job(&self) -> Job<&Self> {
        Job::new(self)
    }

    /// The pose at a time in seconds, also where the body goes on.
    fn at_or_beyond(&self, time: f64, outside: Outside) -> DualQuat<f64> {
        let ([first, last], [start, end]) = (self.range(), self.ends());
        let goes_on =
            |from: Moving, since: f64| from.pose * DualQuat::from_twist(from.twist.scale(since));
        match outside {
            Outside::Continue if time < first => goes_on(start, time - first),
            Outside::Continue if time > last => goes_on(end, time - last),
            _ => self.at(time),
        }
    }
}

impl Job<&Spline> {
    /// `poses[i]` = the pose at the time `times[i]`, in the frame of the job.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// use dq8_trajectory::{Basis, Spline};
    /// let control = [0.0, 1.0, 4.0, 9.0].map(|x| DualQuat::from_translation([x, 0.0, 0.0]));
    /// let spline = Spline::new(0.0, 1.0, &control, Basis::Through)?;
    /// let mut poses = [DualQuat::<f32>::IDENTITY; 3];
    /// spline.job().sample(&[0.0, 0.5, 7.0], &mut poses)?;
    /// assert_eq!(poses.map(|pose| pose.translation()[0]), [1.0, 2.25, 4.0]);
    /// # Ok::<(), dq8_trajectory::TrajectoryError>(())
    /// ```
    ///
    /// # Errors
    /// If `poses` does not hold as many poses as there are times (of blocks, so many that all find
    /// place), the clock has a number that is not finite or a unit of zero, there is no such frame,
    /// or a time is outside where that is refused; nothing is written.
    pub fn sample<T: Time, M: Element<8>>(
        self,
        times: &[T],
        poses: &mut [M],
    ) -> Result<(), TrajectoryError> {
        self.check(self.path.range(), "poses", poses.len(), times, M::Layout::THINGS)?;
        let [twists, accelerations]: [&mut [Sixes<M>]; 2] = Default::default();
        self.run::<_, _, _, _, 0>(times, poses, twists, accelerations)
    }

    /// [`sample`](Self::sample), and `twists[i]` = the velocity there for one second, in the frame
    /// of the moving body (angular first). Outside the knots it is zero where the body stands, and
    /// that of the nearest knot where it goes on.
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
        let none: &mut [Sixes<M>] = &mut [];
        self.run::<_, _, _, _, 1>(times, poses, twists, none)
    }

    /// [`sample_with_twists`](Self::sample_with_twists), and `accelerations[i]` = how fast the
    /// twist changes there, for one second. Outside the knots it is zero.
    ///
    /// # Errors
    /// As there, and if `accelerations` is not as long as `poses`; nothing is written.
    pub fn sample_with_accelerations<
        T: Time,
        M: Element<8>,
        W: Element<6, Layout = M::Layout>,
        A: Element<6, Layout = M::Layout>,
    >(
        self,
        times: &[T],
        poses: &mut [M],
        twists: &mut [W],
        accelerations: &mut [A],
    ) -> Result<(), TrajectoryError> {
        self.check(self.path.range(), "poses", poses.len(), times, M::Layout::THINGS)?;
        same_length("twists", twists.len(), poses.len())?;
        same_length("accelerations", accelerations.len(), poses.len())?;
        self.run::<_, _, _, _, 2>(times, poses, twists, accelerations)
    }

    fn run<
        T: Time,
        M: Element<8>,
        W: Element<6, Layout = M::Layout>,
        A: Element<6, Layout = M::Layout>,
        const DERIVATIVES: usize,
    >(
        self,
        times: &[T],
        poses: &mut [M],
        twists: &mut [W],
        accelerations: &mut [A],
    ) -> Result<(), TrajectoryError> {
        let segments = self.segments()?;
        let Spline { every, basis, .. } = *self.path;
        let shares = basis.shares();
        let work = |first, ((poses, _), ((twists, _), (accelerations, _))): Parts<'_, M, W, A>| {
            let elements = poses.len();
            let rate = 1.0 / every;
            let work = Curve::<_, _, _, DERIVATIVES> { poses, twists, accelerations, shares, rate };
            self.along::<M::Layout, _, _, _>(&segments, times, first, elements, work);
        };
        let outputs = ((poses, 1), ((twists, 1), (accelerations, 1)));
        self.choice.instructions().share(GRAIN, outputs, &work);
        Ok(())
    }

    fn segments<R: Scalar>(self) -> Result<Segments<R, RECORD>, TrajectoryError> {
        let (spline, outside) = (self.path, self.outside);
        let [first, last] = spline.range();
        let at = |time| spline.at_or_beyond(time, outside);
        let into = self.frame.pose([first, last], outside, at)?.conjugate();
        // λ₁ + λ₂ + λ₃ = 1 + u: of three equal ways the motion has a constant twist.
        let ends = spline.ends().map(|end| {
            let way = match outside {
                Outside::Continue => end.twist.scale(spline.every),
                _ => Twist::ZERO,
            };
            record(into * end.pose * DualQuat::from_twist(-way), &[way; 3])
        });
        let records = [ends[0]].into_iter().chain(spline.records(into)).chain([ends[1]]);
        // The last knot is of the segment before.
        let starts = [first].into_iter().chain(spline.starts()).chain([last.next_up()]);
        Ok(Segments::new(starts.collect(), rounded(records), [first, last]))
    }
}

impl Spline {
    /// The first knot of each segment.
    fn starts(&self) -> impl Iterator<Item = f64> {
        (0..self.ways.len() - 2).map(|index| self.knot(index))
    }

    /// The records of the segments, in the frame that `into` leads into.
    fn records(&self, into: DualQuat<f64>) -> impl Iterator<Item = [f64; RECORD]> {
        let segments = self.ways.windows(3).zip(self.control());
        segments.map(move |(ways, &pose)| record(into * pose, ways))
    }

    /// Segments of which the first and the last have no end.
    pub(super) fn inner_segments<R: Scalar>(&self) -> Segments<R, RECORD> {
        let range = self.range();
        let starts = [range[0]].into_iter().chain(self.starts());
        let records = self.records(DualQuat::IDENTITY);
        let before = self.records(DualQuat::IDENTITY).take(1);
        Segments::new(starts.collect(), rounded(before.chain(records)), range)
    }
}

fn rounded<R: Scalar>(records: impl Iterator<Item = [f64; RECORD]>) -> Vec<[R; RECORD]> {
    records.map(|record| record.map(<R as Real>::from_f64)).collect()
}

fn record(pose: DualQuat<f64>, ways: &[Twist<f64>]) -> [f64; RECORD] {
    let mut record = [0.0; RECORD];
    record[..8].copy_from_slice(&pose.to_array());
    for (slots, way) in record[8..26].chunks_exact_mut(6).zip(ways) {
        slots.copy_from_slice(&way.to_array());
    }
    record
}

/// The three ways of a record.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn ways<L: Lanes>(record: &[L; RECORD]) -> [Twist<L>; 3] {
    let [.., a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, _, _] = *record;
    let first = Twist { angular: [a, b, c], linear: [d, e, f] };
    let second = Twist { angular: [g, h, i], linear: [j, k, l] };
    [first, second, Twist { angular: [m, n, o], linear: [p, q, r] }]
}

type Parts<'s, M, W, A> = (Rows<'s, M>, (Rows<'s, W>, Rows<'s, A>));

/// Twists or accelerations beside such poses.
type Sixes<M> = <<M as Element<8>>::Layout as Layout>::Record<6>;

/// `poses[i]` = σ₀ exp(½λ₁ξ₁) exp(½λ₂ξ₂) exp(½λ₃ξ₃), and so many of its
/// derivatives.
struct Curve<'s, M, W, A, const DERIVATIVES: usize> {
    poses: &'s mut [M],
    twists: &'s mut [W],
    accelerations: &'s mut [A],
    shares: [[f64; 4]; 3],
    /// Knots in a second.
    rate: f64,
}

impl<
    M: Element<8>,
    W: Element<6, Layout = M::Layout>,
    A: Element<6, Layout = M::Layout>,
    const DERIVATIVES: usize,
> Work<M::Layout, RECORD> for Curve<'_, M, W, A, DERIVATIVES>
{
    const WIDE: bool = true;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn tile<V: Level>(
        &mut self,
        _: V,
        tile: Tile,
        records: [Register<M, V, 8>; RECORD],
        since: Register<M, V, 8>,
    ) -> Option<()> {
        let [a, b, c, d, e, f, g, h, ..] = records;
        let mut pose = batch::DualQuat::from_array([a, b, c, d, e, f, g, h]);
        let rate = since.constant(self.rate);
        let u = since * rate;
        let zero = Twist { angular: [since.constant(0.0); 3], linear: [since.constant(0.0); 3] };
        let [mut twist, mut acceleration] = [zero; 2];
        for (j, (way, shares)) in ways(&records).into_iter().zip(self.shares).enumerate() {
            let value = horner(u, shares);
            let step = batch::DualQuat::from_twist(way.scale(value));
            pose = pose * step;
            if DERIVATIVES < 1 {
                continue;
            }
            let [_, b, c, d] = shares;
            let now = way.scale(horner(u, [b, 2.0 * c, 3.0 * d]) * rate);
            let faster = way.scale(horner(u, [2.0 * c, 6.0 * d]) * (rate * rate));
            if j == 0 {
                // Nothing is carried on yet.
                (twist, acceleration) = (now, faster);
                continue;
            }
            let back = step.conjugate();
            twist = back.adjoint(twist) + now;
            if DERIVATIVES > 1 {
                acceleration = back.adjoint(acceleration) + lie_bracket(twist, now) + faster;
            }
        }
        M::store(pose.to_array(), self.poses, tile);
        if DERIVATIVES > 0 {
            W::store(twist.to_array(), self.twists, tile);
        }
        if DERIVATIVES > 1 {
            A::store(acceleration.to_array(), self.accelerations, tile);
        }
        Some(())
    }
}

//! The pose of one frame in another at many times: some dozens of times at once, edge after edge.
//!
//! # The algorithm
//!
//! From the source the edges are climbed to the nearest common ancestor, and likewise from the
//! target: A and B, each a product of samples of the moving edges, to which the fixed ones between
//! them come as one motion. The answer is B⁻¹A. All is computed in `f64`, in blocks that stay in
//! the first cache, and rounded at the end: of two frames far from the origin of their map nothing
//! is lost to `f32`.

use super::{Frames, FramesError, Motion, Way};
use crate::along::Poses;
use crate::clock::Time;
use crate::job::{GRAIN, Job};
use crate::segments::Outside;
use alloc::borrow::ToOwned;
use dq8::internal::Rows;
use dq8::simd::Block;
use dq8::storage::{AoSoA, Element, Layout, Number, same_length};
use dq8::{Backend, DualQuat, Real};

/// A block of as many motions as AVX-512 has lanes: nothing has to be transposed in it.
type Eight = Block<[f64; EIGHT], 8>;

/// The blocks that are computed at once: three times 8 KiB.
const BLOCKS: usize = 16;
const EIGHT: usize = 8;

impl Job<&Frames> {
    /// `poses[i]` = the pose of the frame `source` in the frame `target` at the time `times[i]`:
    /// `target = poses[i].transform_point(source)`, as tf2's `lookupTransform(target, source,
    /// time)`. A fixed pose holds at any time; one that moves at NaN is NaN.
    ///
    /// The [`frame`](Job::frame) of the job, if not the world, is that of the source as it was at
    /// one time, seen from the target ([`Frame::Start`](crate::Frame::Start) and
    /// [`End`](crate::Frame::End) are the ends of [`Frames::range`]), or any pose in the target:
    /// the poses of the source come out relative to it, as a scan is deskewed.
    ///
    /// Lanes of a block beyond the last time are left alone.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// use dq8_trajectory::{Edge, Frames, FramesError, Outside, Trajectory};
    /// let steps = [0.0, 6.0].map(|x| DualQuat::from_translation([x, 0.0, 0.0]));
    /// let frames = Frames::new([
    ///     Edge::moving("a", "map", Trajectory::new(&[0.0, 2.0], &steps)?),
    ///     Edge::moving("b", "map", Trajectory::new(&[0.0, 3.0], &steps)?),
    /// ])?;
    /// let job = frames.job().outside(Outside::Refuse);
    /// let mut poses = [DualQuat::<f64>::IDENTITY; 2];
    /// job.lookup("a", "b", &[1.0, 2.0], &mut poses)?;
    /// assert_eq!(poses.map(|pose| pose.translation()[0]), [-1.0, -2.0]);
    /// let error = job.lookup("a", "b", &[1.0, 2.5], &mut poses).unwrap_err();
    /// assert_eq!(
    ///     error.to_string(),
    ///     "time 1 is 2.5 s, and the stamps of the frame \"a\" go from 0 s to 2 s"
    /// );
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// If there is no such frame, no edges lead from one to the other, `poses` does not hold as
    /// many poses as there are times (of blocks, so many that all find place), the clock has a
    /// number that is not finite or a unit of zero, a time is outside where that is refused, an
    /// edge of a single pose has no velocity to continue with, or the job has no such frame;
    /// nothing is written.
    pub fn lookup<T: Time, M: Element<8>>(
        self,
        target: &str,
        source: &str,
        times: &[T],
        poses: &mut [M],
    ) -> Result<(), FramesError> {
        let things = M::Layout::THINGS;
        let way = self.path.way(target, source)?;
        let length = same_length("poses", poses.len(), times.len().div_ceil(things));
        length.map_err(crate::TrajectoryError::from)?;
        self.clock.check()?;
        self.reaches(way, times)?;
        let range = self.path.range(target, source)?;
        let at = |time| {
            let mut pose = [DualQuat::IDENTITY];
            let seconds = self.clock(0.0, 1.0);
            seconds.part(way, DualQuat::IDENTITY, &[time], &mut pose);
            pose[0]
        };
        let into = self.frame.pose(range, self.outside, at)?.conjugate();
        let work = |first: usize, (poses, _): Rows<'_, M>| {
            let times = times.get(first * things..).unwrap_or_default();
            let count = times.len().min(poses.len() * things);
            self.part(way, into, &times[..count], poses);
        };
        self.choice.instructions().share(GRAIN, (poses, 1), &work);
        Ok(())
    }

    /// Refuses times that an edge has no pose for.
    fn reaches<T: Time>(self, way: Way, times: &[T]) -> Result<(), FramesError> {
        for (frame, edge) in self.path.moving(way) {
            if self.outside == Outside::Continue && edge.is_one_pose() {
                return Err(FramesError::OnePose { frame: frame.to_owned() });
            }
            let [first, last] = edge.range;
            let is_outside = |&time: &T| !(first..=last).contains(&self.stamp(time));
            if self.outside != Outside::Refuse {
                continue;
            }
            if let Some(index) = times.iter().position(is_outside) {
                let (frame, value) = (frame.to_owned(), self.stamp(times[index]));
                return Err(FramesError::Outside { frame, index, value, first, last });
            }
        }
        Ok(())
    }

    /// Some of the poses, relative to the frame that `into` leads into.
    fn part<T: Time, M: Element<8>>(
        self,
        way: Way,
        into: DualQuat<f64>,
        times: &[T],
        poses: &mut [M],
    ) {
        let backend = self.choice.instructions();
        let [mut a, mut b, mut c] = [[Block([[0.0; EIGHT]; 8]); BLOCKS]; 3];
        for (chunk, times) in times.chunks(BLOCKS * EIGHT).enumerate() {
            let blocks = times.len().div_ceil(EIGHT);
            let mut buffers = [&mut a[..blocks], &mut c[..blocks]];
            let source = self.climb(way.source, way.ancestor, times, &mut buffers);
            let [of_source, free] = buffers;
            let mut buffers = [&mut b[..blocks], free];
            let target = self.climb(way.target, way.ancestor, times, &mut buffers);
            let [of_target, _] = buffers;

            let between = target.fixed.conjugate() * source.fixed;
            if source.moves {
                mul_left(backend, between, of_source);
            } else {
                fill(of_source, between);
            }
            let found = if target.moves {
                backend.conjugate_in_place(of_target);
                // They are as long as each other.
                let _ = backend.mul_in_place(of_target, of_source);
                of_target
            } else {
                of_source
            };
            mul_left(backend, into, found);
            for index in 0..times.len() {
                let Some(pose) = <Eight as Element<8>>::get(found, index) else { return };
                let pose = pose.map(<Number<M, 8> as Real>::from_f64);
                M::set(poses, chunk * BLOCKS * EIGHT + index, pose);
            }
        }
    }

    /// The poses of a frame in its ancestor, the last fixed edges aside. They come into the first
    /// buffer.
    fn climb<T: Time>(
        self,
        frame: usize,
        ancestor: usize,
        times: &[T],
        buffers: &mut [&mut [Eight]; 2],
    ) -> Climb {
        let backend = self.choice.instructions();
        let mut climb = Climb { fixed: DualQuat::IDENTITY, moves: false };
        for node in self.path.climb(frame, ancestor) {
            let edge = match &node.motion {
                Motion::Fixed(pose) => {
                    climb.fixed = *pose * climb.fixed;
                    continue;
                }
                Motion::Moving(edge) => edge,
            };
            let [poses, sampled] = buffers;
            let twists: &mut [Block<[f64; EIGHT], 6>] = &mut [];
            let work = Poses { poses: sampled, twists };
            self.along::<AoSoA<[f64; EIGHT]>, _, _, _>(&edge.segments, times, 0, poses.len(), work);
            if climb.moves {
                mul_left(backend, climb.fixed, poses);
            } else {
                fill(poses, climb.fixed);
            }
            if climb.moves || climb.fixed != DualQuat::IDENTITY {
                // They are as long as each other.
                let _ = backend.mul_in_place(sampled, poses);
            }
            buffers.swap(0, 1);
            climb = Climb { fixed: DualQuat::IDENTITY, moves: true };
        }
        climb
    }
}

/// The way from a frame up to its ancestor.
struct Climb {
    /// The product of the fixed edges above the last one that moves.
    fixed: DualQuat<f64>,
    /// True if an edge moves, and so there are poses below the fixed ones.
    moves: bool,
}

fn mul_left(backend: Backend, left: DualQuat<f64>, poses: &mut [Eight]) {
    if left != DualQuat::IDENTITY {
        backend.mul_left_in_place(left, poses);
    }
}

fn fill(poses: &mut [Eight], pose: DualQuat<f64>) {
    poses.fill(Block(pose.to_array().map(|number| [number; EIGHT])));
}

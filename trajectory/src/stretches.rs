//! [`segments`]: a trajectory as stretches of time of constant velocity.
//!
//! # The algorithm
//!
//! The ways between the poses are computed as many at once as there are lanes. Where none of them
//! turns far, a stretch begins at each of these poses, and its record is made of what is in the
//! registers. Other ways are cut into parts that turn little; these wait in memory until there are
//! as many as lanes, and then the poses at their starts and their records are computed.
//!
//! Nothing fuses here, on no level. So a record has the same bits wherever it is computed, also
//! those of [`Frames`](crate::Frames), which do not know which instructions will sample them.

use crate::Trajectory;
use crate::screw::{LONGEST, parts};
use crate::segments::{Outside, Segments};
use alloc::vec::Vec;
use core::marker::PhantomData;
use dq8::batch::{self, vector};
use dq8::simd::{Mask, Unfused};
use dq8::storage::{self, Element, Tile};
use dq8::{Backend, DualQuat, Kernel, Lanes, Level, Real, Scalar, Twist};

/// What is kept of a stretch.
pub(crate) trait Record<const C: usize> {
    /// Its numbers, from the pose at its start and the twist for one second.
    fn of<L: Lanes>(pose: batch::DualQuat<L>, velocity: Twist<L>) -> [L; C];
}

/// The time before the first stamp, the ways between the poses, cut into parts that turn little,
/// and the time after the last stamp, in the frame that `into` leads into.
pub(crate) fn segments<R: Scalar, Q: Record<C>, const C: usize>(
    path: Trajectory<'_>,
    outside: Outside,
    into: DualQuat<f64>,
    backend: Backend,
) -> Segments<R, C> {
    let count = path.stamps().len() + 1;
    let (mut starts, mut records) = (Vec::with_capacity(count), Vec::with_capacity(count));
    let record_is = PhantomData::<Q>;
    let (begin, rows) = (&mut starts, &mut records);
    backend.run(Prepare { path, outside, into, starts: begin, records: rows, record_is });
    Segments::new(starts, records, path.range())
}

/// The pose of a body that goes on as it moved between the first two poses, or the last two, at a
/// time outside the stamps; `None` within them.
pub(crate) fn beyond(path: Trajectory<'_>, time: f64) -> Option<DualQuat<f64>> {
    let (stamps, poses) = (path.stamps(), path.poses());
    let [first, last] = path.range();
    let (start, from) = match time {
        _ if time < first => (0, 0),
        _ if time > last => (stamps.len().checked_sub(2)?, stamps.len() - 1),
        _ => return None,
    };
    let (pair, between) = (poses.get(start..start + 2)?, stamps.get(start..start + 2)?);
    let share = (time - stamps[from]) / (between[1] - between[0]);
    Some(poses[from] * DualQuat::from_twist(pair[0].twist_to(pair[1]).scale(share)))
}

struct Prepare<'s, R, Q, const C: usize> {
    path: Trajectory<'s>,
    outside: Outside,
    into: DualQuat<f64>,
    starts: &'s mut Vec<f64>,
    records: &'s mut Vec<[R; C]>,
    record_is: PhantomData<Q>,
}

impl<R: Scalar, Q: Record<C>, const C: usize> Kernel for Prepare<'_, R, Q, C> {
    type Output = ();

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) {
        let _ = self.all(Unfused(level));
    }
}

impl<R: Scalar, Q: Record<C>, const C: usize> Prepare<'_, R, Q, C> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn all<V: Level>(self, level: V) -> Option<()> {
        let Self { path, outside, into, starts, records, .. } = self;
        let (begins, ends) = (path.stamps().split_last()?.1, path.stamps().get(1..)?);
        let (from, to) = (path.poses().split_last()?.1, path.poses().get(1..)?);
        let into = batch::DualQuat::splat(level, into);
        let mut rows =
            Rows::<_, Q, C> { records, buffer: [[0.0; C]; MOST], record_is: PhantomData };
        let mut waiting = Waiting {
            count: 0,
            poses: [DualQuat::IDENTITY; MOST],
            ways: [Twist::ZERO; MOST],
            velocities: [Twist::ZERO; MOST],
        };
        // The first is the record of the time before, whose velocity is not yet known.
        let [first_stamp, last_stamp] = path.range();
        starts.push(first_stamp);
        rows.records.push([R::ZERO; C]);
        let [mut first, mut last] = [Twist::ZERO; 2];
        let lanes = V::Double::LANES;
        let mut k = 0;
        while k < from.len() {
            let (tile, count) = (Tile::at(k, 0), lanes.min(from.len() - k));
            let [begin] = <f64 as Element<1>>::load(level, begins, tile, &[0.0])?;
            let [end] = <f64 as Element<1>>::load(level, ends, tile, &[1.0])?;
            let pose = DualQuat::load(level, from, tile, &storage::identity())?;
            let later = DualQuat::load(level, to, tile, &storage::identity())?;
            let pose = batch::DualQuat::from_array(pose);
            let way = pose.twist_to(batch::DualQuat::from_array(later));
            let mut velocity = way.to_array();
            for number in &mut velocity {
                *number = *number / (end - begin);
            }
            let [mut ways, mut velocities] = [[Twist::ZERO; MOST]; 2];
            let is_end = k == 0 || k + lanes >= from.len();
            let square = vector::dot(way.angular, way.angular);
            // Less than what is cut, however it is rounded. False for NaN.
            let is_short = square.lt(square.constant(0.99 * LONGEST * LONGEST)).all();
            if is_end || !is_short {
                Twist::store::<V>(velocity, &mut velocities, Tile::at(0, 0));
                first = if k == 0 { velocities[0] } else { first };
                last = *velocities.get(count - 1)?;
            }
            if is_short {
                starts.extend_from_slice(begins.get(k..k + count)?);
                rows.push::<V>(into * pose, Twist::from_array(velocity), count);
            } else {
                Twist::store::<V>(way.to_array(), &mut ways, Tile::at(0, 0));
                for lane in 0..count {
                    let (way, velocity) = (*ways.get(lane)?, *velocities.get(lane)?);
                    let (begin, pose) = (*begins.get(k + lane)?, *from.get(k + lane)?);
                    let length = *ends.get(k + lane)? - begin;
                    let [x, y, z] = way.angular;
                    // The shorter way turns by π at most. Of poses that are not unit it may turn
                    // by anything, which must not become that much memory.
                    let turn: f64 = Real::sqrt(x * x + y * y + z * z);
                    let parts = parts(turn.min(core::f64::consts::PI));
                    for part in 0..parts {
                        let start = begin + length * (part as f64 / parts as f64);
                        // The start is rounded, and the pose is the one at the rounded start.
                        let share = (start - begin) / length;
                        starts.push(start);
                        waiting.push(pose, way.scale(share), velocity);
                        if waiting.count == MOST {
                            waiting.flush(level, into, &mut rows)?;
                        }
                    }
                }
                waiting.flush(level, into, &mut rows)?;
            }
            k += lanes;
        }
        if outside != Outside::Continue {
            [first, last] = [Twist::ZERO; 2];
        }
        starts.push(last_stamp);
        waiting.push(*path.poses().first()?, Twist::ZERO, first);
        waiting.push(*path.poses().last()?, Twist::ZERO, last);
        waiting.flush(level, into, &mut rows)?;
        // The last but one to the place of the first.
        let before = rows.records.len() - 2;
        rows.records[0] = rows.records.swap_remove(before);
        Some(())
    }
}

/// No fewer than there are lanes.
const MOST: usize = 16;

/// The records of stretches.
struct Rows<'s, R, Q, const C: usize> {
    records: &'s mut Vec<[R; C]>,
    /// Those of as many stretches as there are lanes, not yet rounded.
    buffer: [[f64; C]; MOST],
    record_is: PhantomData<Q>,
}

impl<R: Scalar, Q: Record<C>, const C: usize> Rows<'_, R, Q, C> {
    /// The records of the first lanes.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn push<V: Level>(
        &mut self,
        pose: batch::DualQuat<V::Double>,
        velocity: Twist<V::Double>,
        count: usize,
    ) {
        <[f64; C]>::store::<V>(Q::of(pose, velocity), &mut self.buffer, Tile::at(0, 0));
        for row in self.buffer.iter().take(count) {
            let mut rounded = [R::ZERO; C];
            for (slot, &number) in rounded.iter_mut().zip(row) {
                *slot = <R as Real>::from_f64(number);
            }
            self.records.push(rounded);
        }
    }
}

/// Parts of ways whose records are not yet made.
struct Waiting {
    count: usize,
    /// Poses of the trajectory.
    poses: [DualQuat<f64>; MOST],
    /// The ways from there to the starts of the parts.
    ways: [Twist<f64>; MOST],
    /// For one second, in the frame of the moving body.
    velocities: [Twist<f64>; MOST],
}

impl Waiting {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn push(&mut self, pose: DualQuat<f64>, way: Twist<f64>, velocity: Twist<f64>) {
        let part = self.count % MOST;
        self.poses[part] = pose;
        self.ways[part] = way;
        self.velocities[part] = velocity;
        self.count = part + 1;
    }

    /// Makes their records.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn flush<R: Scalar, Q: Record<C>, V: Level, const C: usize>(
        &mut self,
        level: V,
        into: batch::DualQuat<V::Double>,
        rows: &mut Rows<'_, R, Q, C>,
    ) -> Option<()> {
        let mut k = 0;
        while k < self.count {
            let tile = Tile::at(k, 0);
            let pose = DualQuat::load(level, &self.poses, tile, &storage::identity())?;
            let way = Twist::load(level, &self.ways, tile, &storage::identity())?;
            let velocity = Twist::load(level, &self.velocities, tile, &storage::identity())?;
            let from = batch::DualQuat::from_array(pose);
            let there = from * batch::DualQuat::from_twist(Twist::from_array(way));
            // The pose itself where the way is none: as where no way is cut.
            let zero = way[0].constant(0.0);
            let mut stays = way[0].eq(zero);
            for number in way {
                stays = stays & number.eq(zero);
            }
            let pose = vector::select(stays, pose, there.to_array());
            let pose = batch::DualQuat::from_array(pose);
            let count = V::Double::LANES.min(self.count - k);
            rows.push::<V>(into * pose, Twist::from_array(velocity), count);
            k += V::Double::LANES;
        }
        self.count = 0;
        Some(())
    }
}

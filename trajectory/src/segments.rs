//! [`Segments`]: a path as a table of records, one for each stretch of time; and which of them a
//! time is in.

use crate::TrajectoryError;
use crate::clock::{Clock, Time};
use alloc::vec::Vec;
use dq8::{DualQuat, Real, Scalar};

/// The frame that poses and points come out in.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Frame {
    /// The world, into which the poses of the trajectory lead.
    #[default]
    World,
    /// The moving body as it was at the first stamp.
    Start,
    /// The moving body as it was at the last stamp.
    End,
    /// The moving body as it was at this time in seconds, on the clock of the stamps.
    At(f64),
    /// A frame of which this is the pose in the world.
    Pose(DualQuat<f64>),
}

/// What happens at times before the first stamp and after the last one. A time that is NaN makes
/// NaN of its pose or point alone, but where it is refused.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Outside {
    /// The body stands at the first pose or at the last one.
    #[default]
    Hold,
    /// The body goes on as it moved between the first two poses, or the last two.
    Continue,
    /// An error that names the first such time; nothing is written.
    Refuse,
}

impl Frame {
    /// Its pose in the world, where `at` gives the poses of the body at any time.
    pub(crate) fn pose(
        self,
        [first, last]: [f64; 2],
        outside: Outside,
        at: impl Fn(f64) -> DualQuat<f64>,
    ) -> Result<DualQuat<f64>, TrajectoryError> {
        match self {
            Self::World => Ok(DualQuat::IDENTITY),
            Self::Pose(pose) => Ok(pose),
            Self::Start => Ok(at(first)),
            Self::End => Ok(at(last)),
            Self::At(time) => {
                let inside = (first..=last).contains(&time);
                let is_there = time.is_finite() && (inside || outside != Outside::Refuse);
                is_there.then(|| at(time)).ok_or(TrajectoryError::NoFrame { time })
            }
        }
    }
}

/// One record for the time before the range, one for each stretch of it, and one for the time
/// after.
#[derive(Debug)]
pub(crate) struct Segments<R, const C: usize> {
    /// The time at which the body is at the pose of each record, from which on the record is for,
    /// until the next one begins; the first is for all times before too. A NaN follows the last,
    /// which no time is after.
    starts: Vec<f64>,
    pub(crate) records: Vec<[R; C]>,
    /// For each of as many equal times the last record that has begun at all times in it.
    buckets: Vec<u32>,
    /// Buckets per second.
    rate: f64,
    /// `true` if in no bucket more than one record begins.
    is_even: bool,
}

/// The number of times whose records are looked up before anything is computed: they stay in the
/// first cache.
pub(crate) const CHUNK: usize = 64;

/// Buckets for each record. With sixteen, records may be a sixteenth as long as they are on average
/// before two begin in one bucket.
const BUCKETS: usize = 16;

/// Where the times of a chunk are.
#[derive(Debug)]
pub(crate) struct Found<R> {
    /// Which record each is in.
    pub(crate) records: [u32; CHUNK],
    /// The seconds since the start of that record.
    pub(crate) since: [R; CHUNK],
}

impl<R: Scalar, const C: usize> Segments<R, C> {
    /// Records that begin at `starts`, the first for the time before and the last for the time
    /// after the `range`.
    pub(crate) fn new(mut starts: Vec<f64>, records: Vec<[R; C]>, [first, last]: [f64; 2]) -> Self {
        starts.push(f64::NAN);
        let count = BUCKETS * records.len();
        // One bucket for all, where the stamps are one.
        let rate = if last > first { count as f64 / (last - first) } else { 0.0 };
        let mut segments = Self { starts, records, buckets: Vec::new(), rate, is_even: true };
        segments.fill(count);
        segments
    }

    /// Finds the records of so many buckets.
    ///
    /// What is later is in no earlier bucket, however it is rounded. So where a record begins in a
    /// bucket, all records that begin in earlier ones have begun at any time in it, and none that
    /// begins in a later one has.
    fn fill(&mut self, count: usize) {
        let mut buckets = Vec::with_capacity(count);
        let end = self.records.len() - 1;
        for record in 0..end {
            let bucket = bucket(self.starts[0], self.rate, count, self.starts[record + 1]) as usize;
            self.is_even &= buckets.len() <= bucket;
            buckets.resize(buckets.len().max(bucket + 1), index(record));
        }
        buckets.resize(count, index(end));
        self.buckets = buckets;
    }

    /// The bucket of a time.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn bucket(&self, first: f64, stamp: f64) -> u32 {
        bucket(first, self.rate, self.buckets.len(), stamp)
    }

    /// The record that a time of this bucket is in, where records begin evenly; the first for NaN.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn find(&self, bucket: u32, stamp: f64) -> usize {
        let near = self.buckets.get(bucket as usize).map_or(0, |&near| near as usize);
        // Nobody can foresee which of two it is, so it is added and not branched upon.
        let next = self.starts.get(near + 1).is_some_and(|&start| start <= stamp);
        near + usize::from(next)
    }

    /// The records of times, where many may begin in a bucket. Out of line, because the compiler
    /// keeps no number of the loop that calls it in a register across a call.
    #[cold]
    #[inline(never)]
    fn search<T: Time>(&self, clock: Clock, times: &[T], records: &mut [u32; CHUNK]) {
        let end = self.records.len() - 1;
        for (record, &time) in records.iter_mut().zip(times) {
            let stamp = clock.stamp(time);
            let bucket = self.bucket(self.starts[0], stamp) as usize;
            let near = self.buckets[bucket] as usize;
            let last = self.buckets.get(bucket + 1).map_or(end, |&next| next as usize);
            let starts = &self.starts[near + 1..=last];
            *record = index(near + starts.partition_point(|&start| start <= stamp));
        }
    }

    /// The first time that a record is for, and the first that it is not.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn span(&self, record: usize) -> Option<[f64; 2]> {
        let [start, next] = *self.starts.get(record..)?.first_chunk::<2>()?;
        let from = if record == 0 { f64::NEG_INFINITY } else { start };
        Some([from, if next.is_nan() { f64::INFINITY } else { next }])
    }

    /// Finds the records of at most [`CHUNK`] times. Gives back the record that all are in, if it
    /// is one; `near` is a guess. Outside the range the body `stands`, or goes on.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn place<T: Time>(
        &self,
        clock: Clock,
        times: &[T],
        near: usize,
        stands: bool,
        found: &mut Found<R>,
    ) -> Option<usize> {
        let mut span = self.span(near)?;
        let end = self.records.len() - 1;
        // No early end, so that the compiler compares many at a time.
        let mut all = true;
        for &time in times {
            all &= has(span, clock.stamp(time));
        }
        if all {
            let start = *self.starts.get(near)?;
            // Decided once: the compiler would not do more than one time at once.
            if stands && (near == 0 || near == end) {
                found.since.fill(R::ZERO);
            } else {
                for (slot, &time) in found.since.iter_mut().zip(times) {
                    *slot = <R as Real>::from_f64(clock.since(start, time));
                }
            }
            return Some(near);
        }
        let first = *self.starts.first()?;
        let numbers = found.records.iter_mut().zip(times);
        // Rising times begin where the last ones were, and most are where the one before was.
        let [begin, middle] = [0, times.len() / 2].map(|index| times.get(index));
        if !self.is_even {
            self.search(clock, times, &mut found.records);
        } else if has(span, clock.stamp(*begin?)) & has(span, clock.stamp(*middle?)) {
            let mut record = near;
            for (number, &time) in numbers {
                let stamp = clock.stamp(time);
                if !has(span, stamp) {
                    record = self.find(self.bucket(first, stamp), stamp);
                    span = self.span(record)?;
                }
                *number = index(record);
            }
        } else {
            // Buckets by themselves, many at a time.
            let mut buckets = [0; CHUNK];
            for (bucket, &time) in buckets.iter_mut().zip(times) {
                *bucket = self.bucket(first, clock.stamp(time));
            }
            for ((number, &time), bucket) in numbers.zip(buckets) {
                *number = index(self.find(bucket, clock.stamp(time)));
            }
        }
        let mut starts = [0.0; CHUNK];
        for (start, &record) in starts.iter_mut().zip(&found.records).take(times.len()) {
            *start = *self.starts.get(record as usize)?;
        }
        for ((slot, &time), start) in found.since.iter_mut().zip(times).zip(starts) {
            *slot = <R as Real>::from_f64(clock.since(start, time));
        }
        if stands {
            for ((slot, &record), &time) in found.since.iter_mut().zip(&found.records).zip(times) {
                let is_outside = (record == 0) | (record == index(end));
                let is_number = !clock.stamp(time).is_nan();
                *slot = if is_outside & is_number { R::ZERO } else { *slot };
            }
        }
        // Lanes beyond the last time have the record of the last.
        let last = *found.records.get(times.len().checked_sub(1)?)?;
        found.records.get_mut(times.len()..)?.fill(last);
        let one = found.records[0];
        found.records.iter().all(|&record| record == one).then_some(one as usize)
    }
}

/// `true` if a span of times has this one.
#[cfg_attr(not(opt_level_0), inline(always))]
fn has([from, to]: [f64; 2], stamp: f64) -> bool {
    (from <= stamp) & (stamp < to)
}

/// The bucket of a time, of as many as there are. A later time is in no earlier one.
#[cfg_attr(not(opt_level_0), inline(always))]
fn bucket(first: f64, rate: f64, count: usize, stamp: f64) -> u32 {
    /// A number below this one, added to it, stands in its last bits: a conversion would saturate,
    /// which takes longer.
    const WHOLE: f64 = (1_u64 << 52) as f64;
    let place = (stamp - first) * rate - 0.5;
    // A number, also of NaN, since `max` and `min` return the other one.
    let place = place.max(0.0).min(count as f64 - 1.0);
    #[allow(clippy::cast_possible_truncation, reason = "the last bits are wanted")]
    let bucket = (place + WHOLE).to_bits() as u32;
    bucket
}

/// The number of a record, which takes more than sixteen bytes: so many as do not fit find no
/// memory.
#[cfg_attr(not(opt_level_0), inline(always))]
#[allow(clippy::cast_possible_truncation, reason = "see above")]
fn index(record: usize) -> u32 {
    record as u32
}

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

/// The times that one record is for.
#[derive(Clone, Copy, Debug)]
struct Span {
    /// From here on, until `to`; infinite before the range and after it.
    from: f64,
    to: f64,
    /// The time at which the body is at the pose of the record.
    start: f64,
    /// True before the range and after it.
    is_outside: bool,
}

impl Span {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn has(self, stamp: f64) -> bool {
        (self.from <= stamp) & (stamp < self.to)
    }

    /// The seconds since the start; none outside the range, if the body `stands` there, for however
    /// long.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn since<R: Real>(self, clock: Clock, time: impl Time, stands: bool) -> R {
        let since = clock.since(self.start, time);
        if self.is_outside && stands && !since.is_nan() { R::ZERO } else { R::from_f64(since) }
    }
}

/// One record for the time before the range, one for each stretch of it, and one for the time
/// after.
#[derive(Debug)]
pub(crate) struct Segments<R, const C: usize> {
    spans: Vec<Span>,
    pub(crate) records: Vec<[R; C]>,
    /// The record of the beginning of each of as many equal times.
    buckets: Vec<u32>,
    /// Buckets per second.
    rate: f64,
}

/// The number of times whose records are looked up before anything is computed: they stay in the
/// first cache.
pub(crate) const CHUNK: usize = 64;

/// Buckets for each record. With sixteen, a time is soon in the record of its bucket or in the
/// next.
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
    pub(crate) fn new(
        starts: impl IntoIterator<Item = f64>,
        records: impl IntoIterator<Item = [f64; C]>,
        [first, last]: [f64; 2],
    ) -> Self {
        let starts: Vec<_> = starts.into_iter().collect();
        let round = |numbers: [f64; C]| numbers.map(<R as Real>::from_f64);
        let records: Vec<_> = records.into_iter().map(round).collect();
        let end = starts.len() - 1;
        // Parts that are shorter than the roundoff of their stamps begin at one time: all but the
        // last are empty.
        let span = |k: usize| Span {
            from: if k == 0 { f64::NEG_INFINITY } else { starts[k] },
            to: starts.get(k + 1).copied().unwrap_or(f64::INFINITY),
            start: starts[k],
            is_outside: k == 0 || k == end,
        };
        let spans: Vec<_> = (0..=end).map(span).collect();

        let count = BUCKETS * records.len();
        // One bucket for all, where the stamps are one.
        let rate = if last > first { count as f64 / (last - first) } else { 0.0 };
        let mut buckets = Vec::with_capacity(count);
        let mut record = 0;
        for bucket in 0..count {
            let begin = if rate > 0.0 { first + bucket as f64 / rate } else { first };
            while spans[record].to <= begin {
                record += 1;
            }
            buckets.push(index(record));
        }
        Self { spans, records, buckets, rate }
    }

    /// The record that a time is in; the first for NaN.
    #[cold]
    #[inline(never)]
    fn search(&self, stamp: f64) -> usize {
        self.spans.partition_point(|span| span.to <= stamp).min(self.spans.len() - 1)
    }

    /// The bucket of a time.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn bucket(&self, first: f64, stamp: f64) -> u32 {
        /// A number below this one, added to it, stands in its last bits: a conversion would
        /// saturate, which takes longer.
        const WHOLE: f64 = (1_u64 << 52) as f64;
        let place = (stamp - first) * self.rate - 0.5;
        // A number, also of NaN, since `max` and `min` return the other one.
        let place = place.max(0.0).min(self.buckets.len() as f64 - 1.0);
        #[allow(clippy::cast_possible_truncation, reason = "the last bits are wanted")]
        let bucket = (place + WHOLE).to_bits() as u32;
        bucket
    }

    /// The record that a time is in, soon: that of its bucket or the next one, unless stamps are
    /// very uneven.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn find(&self, bucket: u32, stamp: f64) -> usize {
        let near = self.buckets.get(bucket as usize).map_or(0, |&near| near as usize);
        // Nobody can foresee which of two it is, so it is added and not branched upon.
        let ended = self.spans.get(near).is_some_and(|span| span.to <= stamp);
        let record = near + usize::from(ended);
        match self.spans.get(record) {
            Some(span) if span.has(stamp) => record,
            _ => self.search(stamp),
        }
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
        let span = *self.spans.get(near)?;
        // No early end, so that the compiler compares many at a time.
        let mut all = true;
        for &time in times {
            all &= span.has(clock.stamp(time));
        }
        if all {
            // Decided once: the compiler would not do more than one time at once.
            if span.is_outside && stands {
                for (slot, &time) in found.since.iter_mut().zip(times) {
                    *slot = span.since(clock, time, stands);
                }
            } else {
                for (slot, &time) in found.since.iter_mut().zip(times) {
                    *slot = <R as Real>::from_f64(clock.since(span.start, time));
                }
            }
            return Some(near);
        }
        let first = self.spans.first()?.start;
        let slots = found.since.iter_mut().zip(&mut found.records).zip(times);
        // Rising times begin where the last ones were, and most are where the one before was.
        let (mut record, mut span) = (near, span);
        if span.has(clock.stamp(*times.first()?)) {
            for ((slot, number), &time) in slots {
                let stamp = clock.stamp(time);
                if !span.has(stamp) {
                    record = self.find(self.bucket(first, stamp), stamp);
                    span = *self.spans.get(record)?;
                }
                *slot = span.since(clock, time, stands);
                *number = index(record);
            }
        } else {
            // Buckets by themselves, many at a time.
            let mut buckets = [0; CHUNK];
            for (bucket, &time) in buckets.iter_mut().zip(times) {
                *bucket = self.bucket(first, clock.stamp(time));
            }
            for (((slot, number), &time), bucket) in slots.zip(buckets) {
                let record = self.find(bucket, clock.stamp(time));
                *slot = self.spans.get(record)?.since(clock, time, stands);
                *number = index(record);
            }
        }
        // Lanes beyond the last time have the record of the last.
        let last = *found.records.get(times.len().checked_sub(1)?)?;
        found.records.get_mut(times.len()..)?.fill(last);
        let one = found.records[0];
        found.records.iter().all(|&record| record == one).then_some(one as usize)
    }
}

/// The number of a record, which takes more than sixteen bytes: so many as do not fit find no
/// memory.
#[cfg_attr(not(opt_level_0), inline(always))]
#[allow(clippy::cast_possible_truncation, reason = "see above")]
fn index(record: usize) -> u32 {
    record as u32
}

//! The tracking of clips: from arrays of targets to arrays of values.

use crate::argument::{Argument, Input, is_single};
use crate::broadcast::{common, misfit};
use crate::error::{misshapen, value_error};
use crate::number::Number;
use crate::output::Output;
use crate::reach::{LONG, STEPS};
use crate::reach_report::{Columns, Part, ReachReport};
use crate::search::{Parts, Rows, Search, configurations, filled, of_goals, settings};
use crate::threads::Threads;
use dq8::simd::MAX_LANES;
use dq8::{Backend, Real, ShapeError};
use dq8_robot::OwnedMechanism;
use dq8_robot::ik::{Reach, Report, Tracking};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use std::ops::RangeInclusive;
use std::sync::{Mutex, PoisonError};
use std::time::Instant;

/// The least and the greatest number of frames of a piece. All frames are of one clip, or a few are
/// of each of many clips.
const PIECE: RangeInclusive<usize> = MAX_LANES..=4096;

/// The number of clips that a thread tracks at the same time: a few for each lane, so that lanes
/// seldom wait for each other at the end of a piece.
const CLIPS: usize = 4 * MAX_LANES;

/// The number of clips that fill the registers of AVX2. So few clips take longer in the wider
/// registers of AVX-512, which give the same bits: a single clip of a humanoid a quarter longer.
const FEW: usize = 4;

/// Computes the values of all frames of clips, and a report of each frame. `clips` has the lengths
/// of the clips, whose frames follow each other. Without it all clips have one length: the last
/// leading dimension of the targets counts frames, and those before it count clips.
///
/// Arrays of float32 are computed in double precision, piece by piece: the kernel is a fiftieth of
/// the wheel, so it is compiled for one precision alone.
pub fn track<'py>(
    mechanism: &OwnedMechanism<f64>,
    clips: Option<&Argument<'py>>,
    search: &Search<'py>,
    out: Option<&Bound<'py, PyAny>>,
) -> PyResult<(Bound<'py, PyAny>, ReachReport)> {
    if is_single([&search.targets, &search.values]) {
        typed::<f32>(mechanism, clips, search, out)
    } else {
        typed::<f64>(mechanism, clips, search, out)
    }
}

fn typed<'py, R: Number>(
    mechanism: &OwnedMechanism<f64>,
    clips: Option<&Argument<'py>>,
    search: &Search<'py>,
    out: Option<&Bound<'py, PyAny>>,
) -> PyResult<(Bound<'py, PyAny>, ReachReport)> {
    let view = mechanism.view();
    let value_count = view.values();
    let targets = Input::<R>::of(&search.targets)?;
    let of_targets = of_goals(&targets, &search.goals)?;
    let values = Input::<R>::of(&search.values)?;
    let of_values = configurations(&values, value_count)?;
    let Some((&frames, of_clips)) = of_targets.split_last() else {
        let each = [search.goals.each(), &[targets.size()]].concat();
        let each: String = each.iter().map(|size| format!(", {size}")).collect();
        return Err(misshapen("targets", &format!("(..., frames{each})"), &targets.shape()));
    };
    // The leading dimensions of clips, their lengths, and those of all frames.
    let (shape, lengths, all_frames) = if let Some(clips) = clips {
        let lengths = lengths(clips, frames)?;
        let expected = [lengths.len()];
        if !of_clips.is_empty() {
            let each = &targets.shape()[of_targets.len()..];
            let each: String = each.iter().map(|size| format!(", {size}")).collect();
            return Err(misshapen("targets", &format!("({frames}{each})"), &targets.shape()));
        }
        if !of_values.is_empty() && of_values != expected {
            let each = format!("({}, {value_count}) or ({value_count},)", lengths.len());
            return Err(misshapen("values", &each, &values.shape()));
        }
        (expected.to_vec(), lengths, vec![frames])
    } else {
        let Some(shape) = common([of_clips, of_values].into_iter()) else {
            return Err(misfit([("targets", of_clips), ("values", of_values)].into_iter()));
        };
        let lengths = vec![frames; shape.iter().product()];
        let all_frames = [&shape[..], &[frames]].concat();
        (shape, lengths, all_frames)
    };
    let mut parts = Parts::of(search, view)?;
    let settings = settings::<f64>(&search.settings)?;
    let problem = parts.reach(view)?;

    let (py, each_goal) = (targets.py(), search.goals.each());
    let output = Output::<R>::new(py, out, &all_frames, &[value_count])?;
    let targets = filled(targets, &all_frames, each_goal)?.apart_from(&output)?;
    let values = filled(values, &shape, &[value_count])?.apart_from(&output)?;
    let targets = (Rows::of(&targets, each_goal), targets.size());
    let start = Rows::of(&values, &[value_count]);
    let mut columns = Columns::new(all_frames.iter().product());
    let reports = columns.all();
    let threads = Threads::for_elements(reports.len() * view.links() * STEPS);
    let values = output.fill::<1>(&threads, |to| {
        let left =
            Left { lengths: &lengths, first: 0, frame: 0, values: to.as_flattened_mut(), reports };
        solve(&threads, &problem, targets, start, left, &settings).map_err(value_error)
    })?;
    Ok((values, ReachReport::new(py, columns, &all_frames)?))
}

/// Returns the lengths of clips, which must have `frames` frames together.
fn lengths(clips: &Argument<'_>, frames: usize) -> PyResult<Vec<usize>> {
    let input = Input::<f64>::of(clips)?;
    let [_] = input.full_leading() else {
        return Err(misshapen("clips", "(clips,)", &input.shape()));
    };
    let input = input.in_full()?;
    let whole = |&&length: &&f64| length >= 0.0 && length.fract() == 0.0;
    if let Some((clip, length)) = input.numbers().iter().enumerate().find(|(_, it)| !whole(it)) {
        let message = format!("`clips`: clip {clip} has {length} frames, not 0 or more.");
        return Err(PyValueError::new_err(message));
    }
    let sum: f64 = input.numbers().iter().sum();
    if sum != frames as f64 {
        let message = format!("`clips` have {sum} frames together, and `targets` have {frames}.");
        return Err(PyValueError::new_err(message));
    }
    Ok(input.numbers().iter().map(|&length| length as usize).collect())
}

/// The clips that no thread has begun, and the memory for their frames.
struct Left<'s, R> {
    lengths: &'s [usize],
    /// The index of the first of these clips.
    first: usize,
    /// The index of the first frame of that clip.
    frame: usize,
    values: &'s mut [R],
    reports: Part<'s, R>,
}

/// The rest of a clip that a thread has begun.
struct Clip<'s, R> {
    /// The index of the next frame of the clip.
    frame: usize,
    /// The values from which that frame begins.
    start: Vec<f64>,
    values: &'s mut [R],
    reports: Part<'s, R>,
}

impl<'s, R: Number> Left<'s, R> {
    /// Takes the next clip that has frames.
    fn begin(&mut self, numbers: usize, start: Rows<'_, R>) -> Option<Clip<'s, R>> {
        loop {
            let (&length, lengths) = self.lengths.split_first()?;
            let (clip, frame) = (self.first, self.frame);
            (self.lengths, self.first, self.frame) = (lengths, clip + 1, frame + length);
            if length > 0 {
                return Some(Clip {
                    frame,
                    start: start.at(clip).iter().map(|&value| value.into()).collect(),
                    values: self.values.split_off_mut(..length * numbers).unwrap_or_default(),
                    reports: self.reports.split_off(length),
                });
            }
        }
    }
}

/// Tracks all clips with all threads. Each thread tracks some clips at the same time, a piece of
/// each in one call of the kernel, so that long clips can be interrupted. A frame depends only on
/// the frame before it: neither other clips nor the size of the pieces changes a bit.
fn solve<R: Number>(
    threads: &Threads,
    problem: &Reach<'_, f64>,
    (targets, record): (Rows<'_, R>, usize),
    start: Rows<'_, R>,
    left: Left<'_, R>,
    settings: &Tracking<f64>,
) -> Result<(), ShapeError> {
    let numbers = problem.mechanism().values();
    // If there are fewer clips than the threads could take, they are shared out evenly.
    let width = left.lengths.len().div_ceil(threads.count()).min(CLIPS);
    let best = Backend::best();
    let narrow = Backend::avx2().filter(|_| Backend::avx512() == Some(best)).unwrap_or(best);
    let (left, failure) = (Mutex::new(left), Mutex::new(None));
    threads.all(usize::MAX, &|| {
        let mut scratch = vec![0.0; problem.batch_scratch_len()];
        let (mut wanted, mut values, mut counts) = (Vec::new(), Vec::new(), Vec::new());
        let mut reports = Vec::new();
        let mut piece = CLIPS;
        let mut clips: Vec<Clip<'_, R>> = Vec::new();
        while !threads.interrupted() {
            let mut all = left.lock().unwrap_or_else(PoisonError::into_inner);
            clips
                .extend(std::iter::from_fn(|| all.begin(numbers, start)).take(width - clips.len()));
            drop(all);
            if clips.is_empty() {
                return;
            }
            let begin = Instant::now();
            let now = clips.len().min(piece);
            wanted.clear();
            values.clear();
            counts.clear();
            for clip in &clips[..now] {
                let count = (piece / now).min(clip.reports.len());
                counts.push(count);
                targets.targets(clip.frame..clip.frame + count, record, &mut wanted);
                values.extend_from_slice(&clip.start);
                values.resize(values.len() + (count - 1) * numbers, 0.0);
            }
            reports.clear();
            reports.resize(counts.iter().sum(), Report::default());
            let backend = if now <= FEW { narrow } else { best };
            let done = problem.job().backend(backend).sequence_in(
                &mut scratch,
                &counts,
                &wanted,
                &mut values,
                &mut reports,
                settings,
            );
            if let Err(error) = done {
                *failure.lock().unwrap_or_else(PoisonError::into_inner) = Some(error);
                return;
            }
            let (mut from, mut reached) = (&values[..], &reports[..]);
            for (clip, &count) in clips.iter_mut().zip(&counts) {
                let (own, others) = from.split_at(count * numbers);
                let (said, later) = reached.split_at(count);
                (from, reached) = (others, later);
                clip.start.copy_from_slice(&own[own.len() - numbers..]);
                let to = clip.values.split_off_mut(..own.len()).unwrap_or_default();
                for (to, &value) in to.iter_mut().zip(own) {
                    *to = <R as Real>::from_f64(value);
                }
                clip.reports.split_off(count).write(said);
                clip.frame += count;
            }
            // The clips that were not in this piece come first in the next one.
            clips.rotate_left(now);
            clips.retain(|clip| clip.reports.len() > 0);
            piece = if begin.elapsed() > LONG { piece / 2 } else { piece * 2 };
            piece = piece.clamp(*PIECE.start(), *PIECE.end());
        }
    });
    failure.into_inner().unwrap_or_else(PoisonError::into_inner).map_or(Ok(()), Err)
}

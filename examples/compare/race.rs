//! A contest is run: every contender is checked, then all are timed in turns.

use crate::machine::Machine;
use crate::profile::PROFILE;
use crate::progress::Progress;
use crate::results::{Results, Row};
use dq8_contest::contest::{Contest, Run, Wrong};
use dq8_fixtures::turns::turns;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// How much time a contest may take.
#[derive(Clone, Copy)]
pub(crate) struct Effort {
    /// No round begins after it, but for the fewest.
    pub(crate) budget: Duration,
    pub(crate) fewest_rounds: usize,
    pub(crate) most_rounds: usize,
    /// How often a contender is timed at most while the machine is disturbed.
    pub(crate) attempts: usize,
}

/// A measurement must be long against the tick of the clock and interrupts.
const SAMPLE: Duration = Duration::from_millis(1);

pub(crate) fn race(
    contest: &Contest<'_>,
    effort: Effort,
    machine: &mut Machine,
    progress: &mut Progress,
    results: &mut Results,
) -> Result<(), Wrong> {
    machine.next();
    let mut times: Vec<Vec<f64>> = vec![Vec::new(); contest.contenders.len()];
    let begin = Instant::now();
    for round in 0..effort.most_rounds {
        if round >= effort.fewest_rounds && begin.elapsed() > effort.budget {
            break;
        }
        for limit in &contest.limits {
            for nanoseconds in nanoseconds_a_pass(&mut *(limit.start)()) {
                results.limits.reached(&limit.kind, limit.per_pass / nanoseconds);
            }
        }
        for index in turns(round, contest.contenders.len()) {
            let contender = &contest.contenders[index];
            progress.show(contest, round, &contender.name);
            let mut run = (contender.start)();
            if round == 0 {
                contest.check(contender, &mut *run)?;
            }
            let samples = machine.calmly(effort.attempts, || {
                let mut samples = [0.0; 3];
                deeper(round % 64, &mut || samples = nanoseconds_a_pass(&mut *run));
                samples
            });
            times[index].extend(samples.map(|pass| pass / contest.transforms as f64));
        }
    }
    for (contender, mut times) in contest.contenders.iter().zip(times) {
        times.sort_by(f64::total_cmp);
        results.rows.push(Row {
            job: contest.job,
            size: contest.size.clone(),
            title: contest.title.clone(),
            contender: contender.name.clone(),
            backend: contender.backend,
            profile: PROFILE,
            min: times[0],
            median: times[times.len() / 2],
            limited: contest.limited.clone(),
            spread: machine.spread(),
            repeated: machine.repeated(),
        });
    }
    Ok(())
}

/// Works with so many frames of some ninety bytes below on the stack.
///
/// A kernel that keeps values there runs at half its speed if they straddle pages, in one process
/// and not in the next. So every round tries another place, as it tries another place for the data.
#[inline(never)]
fn deeper(frames: usize, work: &mut dyn FnMut()) {
    let frame = black_box([0_u8; 64]);
    if frames == 0 {
        work();
    } else {
        deeper(frames - 1, work);
    }
    black_box(&frame);
}

/// Runs until caches, branch predictors and clocks are warm, then measures. More than once: to make
/// the data of a large contest takes longer than that.
fn nanoseconds_a_pass(run: &mut dyn Run) -> [f64; 3] {
    let mut passes: u32 = 1;
    let elapsed = loop {
        let elapsed = run.time(passes);
        if elapsed >= SAMPLE / 4 {
            break elapsed;
        }
        passes *= 2;
    };
    let enough = SAMPLE.as_secs_f64() / elapsed.as_secs_f64() * f64::from(passes);
    let passes = (enough.ceil() as u32).max(1);
    [(); 3].map(|()| run.time(passes).as_secs_f64() * 1e9 / f64::from(passes))
}

#[cfg(test)]
mod tests {
    use super::{Effort, race};
    use crate::machine::Machine;
    use crate::progress::Progress;
    use crate::results::Results;
    use dq8_contest::contest::Contest;
    use std::time::Duration;

    const EFFORT: Effort =
        Effort { budget: Duration::ZERO, fewest_rounds: 3, most_rounds: 3, attempts: 2 };

    fn halving<'a>(name: &'static str, factor: f32) -> Contest<'a> {
        let mut contest = Contest {
            transforms: 4,
            expected: vec![vec![0.5], vec![1.0]],
            tolerance: 1e-6,
            ..Contest::new("J0", "tiny", "a half")
        };
        let pass = move |input: &Vec<f32>, output: &mut [f32]| {
            for (output, input) in output.iter_mut().zip(input) {
                *output = factor * input;
            }
        };
        let memory = || (vec![1.0, 2.0, 1.0, 2.0], vec![0.0; 4]);
        contest.add(name, None, memory, pass, |output, index| vec![output[index].into()]);
        contest
    }

    #[test]
    fn who_is_right_gets_a_row() {
        let mut results = Results::default();
        let contest = halving("right", 0.5);
        let (machine, progress) = (&mut Machine::new(), &mut Progress::silent());
        race(&contest, EFFORT, machine, progress, &mut results).unwrap();
        let [row] = results.rows.as_slice() else { panic!("{:?}", results.rows) };
        assert_eq!((row.job, row.contender.as_str()), ("J0", "right"));
        assert!(row.min > 0.0 && row.min <= row.median);
    }

    #[test]
    fn who_is_wrong_is_named() {
        for factor in [0.500_01, f32::NAN] {
            let mut results = Results::default();
            let contest = halving("wrong", factor);
            let (machine, progress) = (&mut Machine::new(), &mut Progress::silent());
            let wrong = race(&contest, EFFORT, machine, progress, &mut results).unwrap_err();
            assert!(wrong.to_string().contains("wrong is wrong at transform 0"), "{wrong}");
            assert!(results.rows.is_empty());
        }
    }
}

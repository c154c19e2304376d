//! Contenders for the same answer, checked and then timed in turns; and the table of their ratios.

use dq8::Backend;
use dq8_fixtures::turns::{Job, least};

/// What is asked of the ratio of two times.
#[derive(Clone, Copy)]
pub(crate) enum Goal {
    /// The peer takes so many times as long as dq8, or more.
    Peer(f64),
    /// dq8 takes so many times as long as the peer, or less.
    Own(f64),
    /// The ratio is only told: the peer's time by that of dq8.
    None,
}

/// A peer's job, or dq8's, and what it found.
pub(crate) struct Contender<'a> {
    name: &'static str,
    goal: Goal,
    /// The largest difference from dq8's numbers; `None` for a job that has another answer.
    tolerance: Option<f64>,
    answer: Vec<f64>,
    job: Job<'a>,
}

impl<'a> Contender<'a> {
    /// Runs the pass once for its answer.
    pub(crate) fn new<O: 'a>(
        name: &'static str,
        goal: Goal,
        tolerance: Option<f64>,
        mut output: O,
        pass: impl Fn(&mut O) + 'a,
        answer: impl Fn(&O) -> Vec<f64>,
    ) -> Self {
        pass(&mut output);
        let answer = answer(&output);
        Self { name, goal, tolerance, answer, job: Job::new(name, move || pass(&mut output)) }
    }
}

/// Fails if a number differs from the wanted one by more than the tolerance.
pub(crate) fn check(name: &str, found: &[f64], wanted: &[f64], tolerance: f64) {
    assert_eq!(found.len(), wanted.len(), "{name}");
    for (index, (&found, &wanted)) in found.iter().zip(wanted).enumerate() {
        let is_near = (found - wanted).abs() <= tolerance;
        assert!(is_near, "{name}: number {index} is {found}, dq8's is {wanted}");
    }
}

/// The rows of all contests.
pub(crate) struct Table {
    /// Answers are checked, and nothing is timed.
    is_quick: bool,
}

/// The rounds in which contenders take turns.
const ROUNDS: usize = 40;

impl Table {
    pub(crate) fn new(is_quick: bool) -> Self {
        if !is_quick {
            println!("dq8: {}, chosen at run time. C++: -O3 -march=native.\n", Backend::best());
            println!(
                "| job | dq8 | peer | its time | goal | measured |\n|---|---|---|---|---|---|"
            );
        }
        Self { is_quick }
    }

    /// Checks all answers, then times all contenders, of which the first is dq8, whose time is
    /// returned: nanoseconds for one of so many things.
    pub(crate) fn contest(&self, job: &str, things: usize, all: Vec<Contender<'_>>) -> f64 {
        let wanted = all[0].answer.clone();
        let (mut goals, mut jobs) = (Vec::new(), Vec::new());
        for Contender { name, goal, tolerance, answer, job } in all {
            if let Some(tolerance) = tolerance {
                check(name, &answer, &wanted, tolerance);
            }
            goals.push(goal);
            jobs.push(job);
        }
        if self.is_quick {
            println!("{job}: the answers agree");
            return f64::NAN;
        }
        let times = least(jobs, things, ROUNDS);
        for ((peer, time), goal) in times[1..].iter().zip(&goals[1..]) {
            self.row(job, [times[0].1, *time], peer, *goal);
        }
        times[0].1
    }

    /// One row: nanoseconds of dq8 and of the peer.
    pub(crate) fn row(&self, job: &str, [own, peer]: [f64; 2], name: &str, goal: Goal) {
        let ratio = peer / own;
        let (goal, is_met) = match goal {
            Goal::Peer(least) => (format!("≥ {least} ×"), ratio >= least),
            Goal::Own(most) => (format!("≥ 1/{most} ×"), ratio >= 1.0 / most),
            Goal::None => (String::new(), true),
        };
        let missed = if is_met { "" } else { ", missed" };
        let [own, peer] = [own, peer].map(|time| match time {
            ..1e6 => format!("{time:.2} ns"),
            _ => format!("{:.1} ms", time / 1e6),
        });
        println!("| {job} | {own} | {name} | {peer} | {goal} | {ratio:.2} ×{missed} |");
    }
}

//! What is timed.

use std::time::Instant;

/// One pass over all configurations.
pub struct Job<'a> {
    name: &'static str,
    /// How many configurations a pass is over, if not over all.
    configurations: Option<usize>,
    pass: Box<dyn FnMut() + 'a>,
    least: f64,
}

impl<'a> Job<'a> {
    pub fn new(name: &'static str, pass: impl FnMut() + 'a) -> Self {
        Self { name, configurations: None, pass: Box::new(pass), least: f64::INFINITY }
    }

    /// What takes so long that some of the configurations must do.
    pub fn over(configurations: usize, name: &'static str, pass: impl FnMut() + 'a) -> Self {
        Self { configurations: Some(configurations), ..Self::new(name, pass) }
    }
}

/// All jobs take turns in rounds; each one's least time in nanoseconds per configuration.
pub fn least(mut jobs: Vec<Job>, configurations: usize, rounds: usize) -> Vec<(&'static str, f64)> {
    for _ in 0..rounds {
        for job in &mut jobs {
            let start = Instant::now();
            (job.pass)();
            let configurations = job.configurations.unwrap_or(configurations);
            let time = start.elapsed().as_secs_f64() * 1e9 / configurations as f64;
            job.least = job.least.min(time);
        }
    }
    jobs.into_iter().map(|job| (job.name, job.least)).collect()
}

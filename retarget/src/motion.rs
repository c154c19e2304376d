//! [`retarget`], which brings the motion of a person on a robot, and [`Motion`], its result.

use crate::collide::Balls;
use crate::smooth::{lambda, slow_down, smooth};
use crate::{Humanoid, Person, Report, RetargetError, Settings, Targets};
use dq8::DualQuat;
use dq8_robot::OwnedMechanism;
use dq8_robot::ik::{self, Goal, Options, OwnedReach, Tracking};
use dq8_robot::urdf::{Drive, Robot};

/// The time that the robot lags behind in the first search, seconds. The targets are then farther
/// away by less than a fiftieth.
const LAG: f64 = 1.0 / 480.0;

/// The number of passes that smooth.
const PASSES: usize = 3;

/// The number of passes at most, if the robot meets itself.
const MOST_PASSES: usize = 8;

/// The number of values of the base: a rotation and a place.
const BASE: usize = 7;

/// The motion of a robot.
#[derive(Clone, Debug)]
pub struct Motion {
    /// The values of the robot, `[frame][value]`, in the order of its value names.
    pub values: Vec<f64>,
    /// `true` where the left and the right foot stand, for each frame.
    pub contacts: Vec<[bool; 2]>,
    /// The seconds from frame to frame.
    pub step: f64,
    /// The measures.
    pub report: Report,
    /// Sentences about what was found in the files, and about what had to be assumed.
    pub told: Vec<String>,
}

/// Brings the motion of a person on a robot.
///
/// ```no_run
/// use dq8_retarget::{Humanoid, Person, Settings, retarget};
/// let humanoid = Humanoid::from_bytes(&std::fs::read("robot.urdf")?, None)?;
/// let (person, _) = Person::from_bvh("walk", &std::fs::read("walk.bvh")?)?;
/// let motion = retarget(&person, &humanoid, &Settings::default())?;
/// print!("{humanoid}{}", motion.report);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// If a setting is out of its range, too little is known of the bodies, the person stands in no
/// frame, or a pose is not finite.
pub fn retarget(
    person: &Person,
    humanoid: &Humanoid,
    settings: &Settings,
) -> Result<Motion, RetargetError> {
    let targets = Targets::new(person, humanoid, settings)?;
    let values = targets.solve(humanoid, settings)?;
    let report = Report::of(&targets, humanoid, &values)?;
    let stands = |side: usize, frame: usize| {
        targets.feet.get(side).is_some_and(|foot| foot.stands_in(frame))
    };
    let contacts = (0..targets.frames()).map(|f| [stands(0, f), stands(1, f)]).collect();
    Ok(Motion { values, contacts, step: targets.step, report, told: targets.told })
}

impl Targets {
    /// Returns the options with which frames follow one another: near the targets, near the frame
    /// before, and where both leave freedom, near the stance.
    #[must_use]
    pub fn tracking(&self) -> Tracking<f64> {
        // The lag is the square of the weight times the way in a frame.
        let start_weight = (LAG / self.step).sqrt();
        Tracking { start_weight, posture_weight: 0.02, ..Tracking::default() }
    }

    /// Returns the options of a search until a step gains nothing, without a start to stay near.
    #[must_use]
    pub fn converging(&self) -> Tracking<f64> {
        let options = Options { max_iterations: 100, least_gain: 1e-5, ..Options::track() };
        Tracking { options, start_weight: 0.0, ..self.tracking() }
    }

    /// Returns the values with which the robot reaches the first frame.
    ///
    /// # Errors
    /// If there can be no search for the goals.
    pub fn first(&self, humanoid: &Humanoid) -> Result<Vec<f64>, RetargetError> {
        let mechanism = OwnedMechanism::new(humanoid.robot().joints())?;
        let reach = OwnedReach::new(mechanism, self.goals.clone())?;
        let (mut reach, mut values) = (reach.with_posture(self.start.clone())?, self.start.clone());
        reach.track(&self.poses[..self.goals.len()], &mut values, &self.converging())?;
        Ok(values)
    }

    /// Finds the values of all frames, `[frame][value]`: frame after frame at first, and then in
    /// passes over all frames at once, which smooth, keep speeds, and push shapes apart.
    ///
    /// # Errors
    /// If there can be no search for the goals.
    pub fn solve(
        &self,
        humanoid: &Humanoid,
        settings: &Settings,
    ) -> Result<Vec<f64>, RetargetError> {
        settings.check()?;
        let robot = humanoid.robot();
        let goals: Vec<_> = self.goals.iter().map(Goal::cast).collect();
        let reach = OwnedReach::<f32>::new(robot.cast()?, goals)?;
        let reach = reach.with_posture(cast(&self.start))?;
        let mut poses: Vec<DualQuat<f32>> = self
            .poses
            .iter()
            .map(|pose| DualQuat::from_array(pose.to_array().map(|x| x as f32)))
            .collect();
        let start = cast(&self.first(humanoid)?);
        let mut search = Passes {
            columns: start.len(),
            limits: robot.value_limits(),
            speeds: speeds(robot, settings),
            values: start.repeat(self.frames()),
            reach,
            targets: self,
        };
        search.follow(&poses)?;
        let mechanism = robot.cast()?;
        let balls = settings.collide.then(|| Balls::new(humanoid, self)).transpose()?;
        let balls = balls.filter(|balls| !balls.is_empty());
        let passes = if settings.smooth.is_some() { PASSES } else { 0 };
        for pass in 0..MOST_PASSES {
            let meets = match &balls {
                Some(balls) => balls.push(&mechanism, &search.values, self, &mut poses)?,
                None => false,
            };
            if pass >= passes && !meets {
                break;
            }
            search.pass(&poses, settings.smooth)?;
        }
        search.slow_down();
        Ok(search.values.into_iter().map(f64::from).collect())
    }
}

/// Searches over all frames of a clip.
struct Passes<'t> {
    targets: &'t Targets,
    reach: OwnedReach<f32>,
    limits: Vec<Option<[f64; 2]>>,
    speeds: Vec<f64>,
    columns: usize,
    /// `[frame][value]`
    values: Vec<f32>,
}

impl Passes<'_> {
    /// Follows the targets, frame after frame.
    fn follow(&mut self, poses: &[DualQuat<f32>]) -> Result<(), RetargetError> {
        let (options, goals) = (self.targets.tracking().cast(), self.targets.goals.len());
        let mut now = self.values[..self.columns].to_vec();
        for (targets, values) in
            poses.chunks_exact(goals).zip(self.values.chunks_exact_mut(self.columns))
        {
            self.reach.track(targets, &mut now, &options)?;
            values.copy_from_slice(&now);
        }
        Ok(())
    }

    /// Smooths all frames, and brings each of them back to its targets by a step from there. Each
    /// frame is a clip of its own, so that one clip fills all lanes.
    fn pass(
        &mut self,
        poses: &[DualQuat<f32>],
        frequency: Option<f64>,
    ) -> Result<(), RetargetError> {
        if let Some(frequency) = frequency {
            self.smooth(frequency);
        }
        self.slow_down();
        let options = Options { max_iterations: 1, ..Options::track() };
        let options = Tracking { options, start_weight: 1.0, ..self.targets.tracking() };
        let frames = self.targets.frames();
        let mut reports = vec![ik::Report::default(); frames];
        let clips = vec![1; frames];
        let job = self.reach.job();
        job.sequence(&clips, poses, &mut self.values, &mut reports, &options.cast())?;
        Ok(())
    }

    fn smooth(&mut self, frequency: f64) {
        let Self { columns, values, .. } = self;
        let turn = 0..4;
        // Of the two quaternions of a rotation, the one that is near the last frame's.
        for frame in 1..values.len() / *columns {
            let (before, now) = values[(frame - 1) * *columns..].split_at_mut(*columns);
            let dot: f32 = turn.clone().map(|i| before[i] * now[i]).sum();
            if dot < 0.0 {
                now[turn.clone()].iter_mut().for_each(|part| *part = -*part);
            }
        }
        smooth(values, *columns, lambda(frequency, self.targets.step));
        for now in values.chunks_exact_mut(*columns) {
            let size = now[turn.clone()].iter().map(|part| part * part).sum::<f32>().sqrt();
            now[turn.clone()].iter_mut().for_each(|part| *part /= size);
            for (value, limits) in now.iter_mut().zip(&self.limits) {
                if let Some([low, high]) = *limits {
                    *value = value.clamp(low as f32, high as f32);
                }
            }
        }
    }

    /// Keeps the speeds of joints within those that they may have.
    fn slow_down(&mut self) {
        for (column, &speed) in self.speeds.iter().enumerate() {
            if speed.is_finite() {
                // Less by what the mean of two single floats may round up.
                let most = (speed * self.targets.step * (1.0 - 1e-5)) as f32;
                slow_down(&mut self.values, self.columns, column, most);
            }
        }
    }
}

/// Returns the greatest speed of each value.
fn speeds(robot: &Robot, settings: &Settings) -> Vec<f64> {
    let speed = |(column, drive): (usize, &Drive)| match settings.speed {
        _ if column < BASE => f64::INFINITY,
        Some(speed) => speed,
        // A file that writes a speed of zero has not been filled in.
        None => Some(drive.velocity).filter(|speed| *speed > 0.0).unwrap_or(f64::INFINITY),
    };
    robot.value_drives().iter().enumerate().map(speed).collect()
}

fn cast(numbers: &[f64]) -> Vec<f32> {
    numbers.iter().map(|&number| number as f32).collect()
}

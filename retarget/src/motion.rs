//! [`retarget`], which brings the motion of a person on a robot, and [`Motion`], its result.

use crate::collide::Bodies;
use crate::feet::Foot;
use crate::smooth::{lambda, slow_down, smooth};
use crate::{Humanoid, Person, Report, RetargetError, Role, Settings, Speeds, Targets};
use dq8::DualQuat;
use dq8_robot::ik::{self, Goal, Options, OwnedReach, Tracking};
use dq8_robot::urdf::{Drive, Robot};

/// The time that the robot lags behind in the first search, seconds. The targets are then farther
/// away by less than a fiftieth.
const LAG: f64 = 1.0 / 480.0;

/// The number of passes that smooth.
const PASSES: usize = 3;

/// The number of passes at most, if the robot meets itself.
const MOST_PASSES: usize = 8;

/// The number of parts of a clip that are followed at once: so many lanes are filled.
const PARTS: usize = 16;

/// The number of frames of a part from which on a clip has more of them, so that the work can be
/// ended from block to block.
const LONG: usize = 512;

/// The number of frames that are followed at once where a clip has no parts, and where parts are
/// mended.
const TOGETHER: usize = 16;

/// The time by which parts of a clip begin early. Seconds.
const EARLY: f64 = 0.3;

/// A part whose joints are farther than this from the part before it is followed again. Radians.
const TORN: f32 = 0.3;

/// A frame that is farther from its targets than another search by more than this has lost them.
/// Metres.
const LOST: f32 = 0.05;

/// Joints that are nearer to those of another search than this have met it. Radians.
const MET: f32 = 0.03;

/// The number of values of the base: a rotation and a place.
pub(crate) const BASE: usize = 7;

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
    retarget_while(person, humanoid, settings, &mut |_| true)
}

/// Brings the motion of a person on a robot as [`retarget`] does. `go_on` is told after each block
/// of frames which part of the work is done, from 0 to 1, and ends the work with `false`.
///
/// # Errors
/// The errors of [`retarget`], and [`RetargetError::Stopped`] if `go_on` has returned `false`.
pub fn retarget_while(
    person: &Person,
    humanoid: &Humanoid,
    settings: &Settings,
    go_on: &mut dyn FnMut(f64) -> bool,
) -> Result<Motion, RetargetError> {
    let mut work = Work { go_on, done: 0.0 };
    let targets = Targets::new(person, humanoid, settings)?;
    work.has_done(0.25)?;
    let values = targets.solve_while(humanoid, settings, &mut work)?;
    work.has_done(0.0)?;
    let report = Report::of(&targets, humanoid, &values)?;
    let [left, right] = [Role::LeftFoot, Role::RightFoot]
        .map(|role| targets.feet.iter().find(|foot| targets.places[foot.goal].role == role));
    let stands = |foot: Option<&Foot>, frame| foot.is_some_and(|foot| foot.stands_in(frame));
    let contacts = (0..targets.frames()).map(|f| [stands(left, f), stands(right, f)]).collect();
    Ok(Motion { values, contacts, step: targets.step, report, told: targets.told })
}

/// The part of the work that is done, and the function that is told of it.
struct Work<'w> {
    go_on: &'w mut dyn FnMut(f64) -> bool,
    done: f64,
}

impl Work<'_> {
    /// Tells that another part of the work is done.
    fn has_done(&mut self, part: f64) -> Result<(), RetargetError> {
        self.done = (self.done + part).min(0.9);
        if (self.go_on)(self.done) { Ok(()) } else { Err(RetargetError::Stopped) }
    }
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

    /// Returns the stance, moved to where the pelvis should be in a frame.
    pub(crate) fn start_at(&self, frame: usize) -> Vec<f64> {
        let pelvis = self.poses[frame * self.goals.len()];
        let mut start = self.start.clone();
        start[..4].copy_from_slice(&(pelvis.rotation() * self.base).normalize().to_array());
        start[4..BASE].copy_from_slice(&pelvis.translation());
        start
    }

    /// Returns the values with which the robot reaches the first frame.
    ///
    /// # Errors
    /// If there can be no search for the goals.
    pub fn first(&self, humanoid: &Humanoid) -> Result<Vec<f64>, RetargetError> {
        let poses = &self.poses[..self.goals.len()];
        reach(humanoid, &self.goals, poses, &self.start, &self.start, &self.converging())
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
        self.solve_while(humanoid, settings, &mut Work { go_on: &mut |_| true, done: 0.0 })
    }

    fn solve_while(
        &self,
        humanoid: &Humanoid,
        settings: &Settings,
        work: &mut Work<'_>,
    ) -> Result<Vec<f64>, RetargetError> {
        settings.check()?;
        let robot = humanoid.robot();
        let reach = problem(humanoid, &self.goals, &self.start)?;
        let mut poses = single(&self.poses);
        let start = cast(&self.first(humanoid)?);
        let mut search = Passes {
            columns: start.len(),
            limits: robot.value_limits(),
            speeds: speeds(robot, settings),
            values: start.repeat(self.frames()),
            errors: vec![0.0; self.frames()],
            reach,
            targets: self,
        };
        search.follow(&poses, work)?;
        let bodies = settings.collide.then(|| Bodies::new(humanoid, self)).transpose()?;
        let bodies = bodies.filter(|bodies| !bodies.is_empty());
        let passes = if settings.smooth.is_some() { PASSES } else { 0 };
        for pass in 0..MOST_PASSES {
            let meets = match &bodies {
                Some(bodies) => bodies.push(&search.values, self, &mut poses)?,
                None => false,
            };
            if pass >= passes && !meets {
                break;
            }
            search.pass(&poses, settings.smooth, work)?;
        }
        search.slow_down();
        Ok(search.values.into_iter().map(f64::from).collect())
    }
}

/// A search from frame to frame of a clip that goes on from the frame `last`.
struct Run {
    last: usize,
    is_backward: bool,
}

impl Run {
    /// Returns the frames that it has before it, of so many in the clip.
    fn frames(&self, total: usize) -> impl Iterator<Item = usize> + use<> {
        let (last, is_backward) = (self.last, self.is_backward);
        let count = if is_backward { last } else { total - 1 - last };
        (1..=count).map(move |step| if is_backward { last - step } else { last + step })
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
    /// The largest distance of each frame from a target after the first search, metres.
    errors: Vec<f32>,
}

impl Passes<'_> {
    /// Follows the targets. The clip is cut into parts that fill all lanes; each begins some frames
    /// early, so that it is where the part before it is when its own frames begin.
    fn follow(
        &mut self,
        poses: &[DualQuat<f32>],
        work: &mut Work<'_>,
    ) -> Result<(), RetargetError> {
        let (goals, frames) = (self.targets.goals.len(), self.targets.frames());
        let early = ((EARLY / self.targets.step).ceil() as usize).max(1);
        let parts = (frames / (2 * early)).min(PARTS.max(frames / LONG));
        if parts < 4 {
            return self.follow_on(poses, work);
        }
        let cut = |part: usize| part * frames / parts;
        let begin = |part: usize| if part == 0 { 0 } else { cut(part) - early };
        let clips: Vec<_> = (0..parts).map(|part| cut(part + 1) - begin(part)).collect();
        let (mut wanted, mut firsts, mut starts) = (Vec::new(), Vec::new(), Vec::new());
        for part in 0..parts {
            wanted.extend(&poses[begin(part) * goals..cut(part + 1) * goals]);
            firsts.extend(&poses[begin(part) * goals..(begin(part) + 1) * goals]);
            starts.extend(cast(&self.targets.start_at(begin(part))));
        }
        let mut reports = vec![ik::Report::default(); clips.iter().sum()];
        let options = self.targets.converging().cast();
        let job = self.reach.job();
        job.sequence(&vec![1; parts], &firsts, &mut starts, &mut reports[..parts], &options)?;
        let mut values = vec![0.0; reports.len() * self.columns];
        let mut row = 0;
        for (clip, start) in clips.iter().zip(starts.chunks_exact(self.columns)) {
            values[row * self.columns..][..self.columns].copy_from_slice(start);
            row += clip;
        }
        // The first part starts where the first frame was reached.
        values[..self.columns].copy_from_slice(&self.values[..self.columns]);
        let options = self.targets.tracking().cast();
        let mut first = 0;
        for clips in clips.chunks(PARTS) {
            let rows = first..first + clips.iter().sum::<usize>();
            let wanted = &wanted[rows.start * goals..rows.end * goals];
            let values = &mut values[rows.start * self.columns..rows.end * self.columns];
            job.sequence(clips, wanted, values, &mut reports[rows.clone()], &options)?;
            work.has_done(0.25 * rows.len() as f64 / reports.len() as f64)?;
            first = rows.end;
        }

        let (mut row, mut runs) = (0, Vec::new());
        for (part, clip) in clips.iter().enumerate() {
            let part_values = &values[row * self.columns..(row + clip) * self.columns];
            let part_errors = reports[row..row + clip].iter().map(|report| report.linear_error);
            row += clip;
            // Where the part before it ends, both parts count, and this one more and more.
            let mut common = cut(part) - begin(part);
            let mut is_torn = false;
            if part > 0 {
                let own = &part_values[(common - 1) * self.columns..][..self.columns];
                let before = &self.values[(cut(part) - 1) * self.columns..][..self.columns];
                is_torn = apart(own, before) > TORN;
            }
            if is_torn {
                let own = reports[row - clip + common - 1].linear_error;
                let is_backward = self.errors[cut(part) - 1] > own + LOST;
                if is_backward {
                    common = 0;
                }
                let last = if is_backward { begin(part) } else { cut(part) - 1 };
                runs.push(Run { last, is_backward });
            }
            let frames = self.values[begin(part) * self.columns..].chunks_exact_mut(self.columns);
            let errors = self.errors[begin(part)..].iter_mut().zip(part_errors);
            let new = part_values.chunks_exact(self.columns).zip(errors);
            for (index, (own, (new, (error, new_error)))) in frames.zip(new).enumerate() {
                if index >= common {
                    own.copy_from_slice(new);
                    *error = new_error;
                } else if !is_torn {
                    blend(own, new, (index + 1) as f32 / (common + 1) as f32);
                }
            }
        }
        self.mend(poses, runs, work)
    }

    /// Follows torn parts again, all of them at once: forward from the end of the part before
    /// them, or, if that part has lost its targets, backward through it. A run ends where it meets
    /// the values that were there, and where it loses targets that they reach. One that goes on
    /// through frames of another run meets what that one has written.
    fn mend(
        &mut self,
        poses: &[DualQuat<f32>],
        mut runs: Vec<Run>,
        work: &mut Work<'_>,
    ) -> Result<(), RetargetError> {
        let (goals, columns) = (self.targets.goals.len(), self.columns);
        let (total, options) = (self.targets.frames(), self.targets.tracking().cast());
        let (mut wanted, mut values, mut clips) = (Vec::new(), Vec::new(), Vec::new());
        let mut reports = vec![ik::Report::default(); runs.len() * TOGETHER];
        while !runs.is_empty() {
            wanted.clear();
            values.clear();
            clips.clear();
            for run in &runs {
                let (row, posed) = (values.len(), wanted.len());
                for frame in run.frames(total).take(TOGETHER) {
                    wanted.extend_from_slice(&poses[frame * goals..(frame + 1) * goals]);
                }
                let count = (wanted.len() - posed) / goals;
                values.resize(row + count * columns, 0.0);
                let last = &self.values[run.last * columns..(run.last + 1) * columns];
                values[row..row + columns].copy_from_slice(last);
                clips.push(count);
            }
            let reports = &mut reports[..values.len() / columns];
            self.reach.job().sequence(&clips, &wanted, &mut values, reports, &options)?;
            let mut rows = values.chunks_exact(columns).zip(reports);
            let mut counts = clips.iter();
            runs.retain_mut(|run| {
                let mut goes_on = true;
                let rows = rows.by_ref().take(*counts.next().unwrap_or(&0));
                for (frame, (new, report)) in run.frames(total).zip(rows) {
                    let own = &mut self.values[frame * columns..(frame + 1) * columns];
                    let (error, before) = (report.linear_error, self.errors[frame]);
                    // Backward, the search differs in all that targets leave free, which passes
                    // smooth.
                    let near = if run.is_backward { TORN } else { MET };
                    let is_met = apart(own, new) < near && before < error + LOST;
                    goes_on &= !is_met && error < before + LOST;
                    if goes_on {
                        own.copy_from_slice(new);
                        self.errors[frame] = error;
                        run.last = frame;
                    }
                }
                goes_on && run.frames(total).next().is_some()
            });
            work.has_done(0.0)?;
        }
        Ok(())
    }

    /// Follows the targets, frame after frame, from the first one.
    fn follow_on(
        &mut self,
        poses: &[DualQuat<f32>],
        work: &mut Work<'_>,
    ) -> Result<(), RetargetError> {
        let (options, goals) = (self.targets.tracking().cast(), self.targets.goals.len());
        let (columns, frames) = (self.columns, self.targets.frames());
        let mut reports = [ik::Report::default(); TOGETHER];
        let mut now = vec![0.0; TOGETHER * columns];
        now[..columns].copy_from_slice(&self.values[..columns]);
        for first in (1..frames).step_by(TOGETHER) {
            let count = TOGETHER.min(frames - first);
            let (poses, now) = (&poses[first * goals..][..count * goals], &mut now);
            let (job, reports) = (self.reach.job(), &mut reports[..count]);
            job.sequence(&[count], poses, &mut now[..count * columns], reports, &options)?;
            let all = &mut self.values[first * columns..][..count * columns];
            all.copy_from_slice(&now[..count * columns]);
            now.copy_within((count - 1) * columns..count * columns, 0);
            work.has_done(0.0)?;
        }
        Ok(())
    }

    /// Smooths all frames, and brings each of them back to its targets by a step from there. Each
    /// frame is a clip of its own, so that one clip fills all lanes.
    fn pass(
        &mut self,
        poses: &[DualQuat<f32>],
        frequency: Option<f64>,
        work: &mut Work<'_>,
    ) -> Result<(), RetargetError> {
        if let Some(frequency) = frequency {
            self.smooth(frequency);
        }
        self.slow_down();
        let options = Options { max_iterations: 1, ..Options::track() };
        let options = Tracking { options, start_weight: 1.0, ..self.targets.tracking() };
        let (frames, goals) = (self.targets.frames(), self.targets.goals.len());
        let block = frames.min(PARTS * LONG);
        let (clips, mut reports) = (vec![1; block], vec![ik::Report::default(); block]);
        let blocks = poses.chunks(block * goals).zip(self.values.chunks_mut(block * self.columns));
        for (poses, values) in blocks {
            let count = poses.len() / goals;
            let reports = &mut reports[..count];
            self.reach.job().sequence(&clips[..count], poses, values, reports, &options.cast())?;
            work.has_done(0.1 * count as f64 / frames as f64)?;
        }
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
    let speed = |(column, drive): (usize, &Drive)| match settings.speeds {
        Speeds::AtMost(speed) if column >= BASE => speed,
        // A file that writes a speed of zero has not been filled in.
        Speeds::File if column >= BASE && drive.velocity > 0.0 => drive.velocity,
        _ => f64::INFINITY,
    };
    robot.value_drives().iter().enumerate().map(speed).collect()
}

/// Moves values by a share of the way to others that are near.
fn blend(values: &mut [f32], others: &[f32], share: f32) {
    // A rotation has two quaternions.
    let dot: f32 = values[..4].iter().zip(others).map(|(a, b)| a * b).sum();
    for (index, (value, &other)) in values.iter_mut().zip(others).enumerate() {
        let other = if index < 4 && dot < 0.0 { -other } else { other };
        *value += share * (other - *value);
    }
    let size = values[..4].iter().map(|part| part * part).sum::<f32>().sqrt();
    values[..4].iter_mut().for_each(|part| *part /= size);
}

/// Returns the largest difference of a joint.
fn apart(a: &[f32], b: &[f32]) -> f32 {
    let (a, b) = (&a[BASE..], &b[BASE..]);
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max)
}

/// Returns values that bring links near their targets, from a start, and near a posture. Lanes hold
/// one problem here as well: what is compiled for many is there already.
pub(crate) fn reach(
    humanoid: &Humanoid,
    goals: &[Goal<f64>],
    targets: &[DualQuat<f64>],
    start: &[f64],
    posture: &[f64],
    options: &Tracking<f64>,
) -> Result<Vec<f64>, RetargetError> {
    let (mut values, mut reports) = (cast(start), [ik::Report::default()]);
    let reach = problem(humanoid, goals, posture)?;
    let (targets, options) = (single(targets), options.cast());
    reach.job().sequence(&[1], &targets, &mut values, &mut reports, &options)?;
    Ok(values.into_iter().map(f64::from).collect())
}

fn problem(
    humanoid: &Humanoid,
    goals: &[Goal<f64>],
    posture: &[f64],
) -> Result<OwnedReach<f32>, RetargetError> {
    let goals: Vec<_> = goals.iter().map(Goal::cast).collect();
    Ok(OwnedReach::new(humanoid.robot().cast()?, goals)?.with_posture(cast(posture))?)
}

fn single(poses: &[DualQuat<f64>]) -> Vec<DualQuat<f32>> {
    let single = |pose: &DualQuat<f64>| DualQuat::from_array(pose.to_array().map(|x| x as f32));
    poses.iter().map(single).collect()
}

fn cast(numbers: &[f64]) -> Vec<f32> {
    numbers.iter().map(|&number| number as f32).collect()
}

#[cfg(test)]
mod tests {
    use super::{BASE, Passes, Run, Targets, Work, apart, cast, problem, single, speeds};
    use crate::{Humanoid, Person, Settings};
    use std::fs;
    use std::path::Path;

    #[test]
    fn frames_that_have_lost_their_targets_are_followed_backward_from_those_that_have_not() {
        // The files are not in the package.
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let urdf = fs::read(root.join("robot/robots/humanoid.urdf")).unwrap();
        let humanoid = Humanoid::from_bytes(&urdf, None).unwrap();
        let bvh = fs::read(root.join("examples/mocap/walk.bvh")).unwrap();
        let (person, _) = Person::from_bvh("walk", &bvh).unwrap();
        let settings = Settings::plain();
        let targets = Targets::new(&person, &humanoid, &settings).unwrap();
        let (frames, start) = (targets.frames(), cast(&targets.first(&humanoid).unwrap()));
        let mut search = Passes {
            columns: start.len(),
            limits: humanoid.robot().value_limits(),
            speeds: speeds(humanoid.robot(), &settings),
            values: start.repeat(frames),
            errors: vec![0.0; frames],
            reach: problem(&humanoid, &targets.goals, &targets.start).unwrap(),
            targets: &targets,
        };
        let (poses, columns) = (single(&targets.poses), start.len());
        let work = &mut Work { go_on: &mut |_| true, done: 0.0 };
        search.follow_on(&poses, work).unwrap();
        let right = search.values.clone();
        for frame in 5..25 {
            search.values[frame * columns + BASE - 1] += 2.0;
            search.values[frame * columns + BASE..][..8].fill(1.0);
            search.errors[frame] = 2.0;
        }
        // Another run begins where nothing is lost, and ends there.
        let [backward, forward] =
            [(25, true), (27, false)].map(|(last, is_backward)| Run { last, is_backward });
        let runs = vec![backward, forward];
        search.mend(&poses, runs, work).unwrap();
        for (frame, rows) in right.chunks(columns).zip(search.values.chunks(columns)).enumerate() {
            let (right, mended) = rows;
            let height = (right[BASE - 1] - mended[BASE - 1]).abs();
            assert!(height < 0.02 && apart(right, mended) < 0.3, "{frame}: {right:?} {mended:?}");
            assert!(frame.abs_diff(14) < 11 || right == mended, "{frame} was not lost");
        }
    }
}

//! The search of [`Reach`](dq8_robot::ik::Reach) written once more, plainly: one target, `f64`,
//! branches instead of masks, the joints as screws, the linear algebra by nalgebra; up to where it
//! begins again. It stands here and not in the library because nobody needs a second, slower
//! search; the lanes need a second opinion.

use dq8::geometry::Screw;
use dq8::scalar::lie_bracket;
use dq8::{DualQuat, Twist};
use dq8_arms::{Arm, Plan, Random, gantry, puma, seven, ur5};
use dq8_robot::ik::{Options, Outcome};
use nalgebra::{DMatrix, DVector, Matrix6, Vector6};
use std::f64::consts::TAU;

/// The difference of steps that differ by rounding alone. Each step multiplies the difference
/// before it by a few.
const SAME_WAY: f64 = 1e-7;

/// The end of a plain search, without an outcome if a search would begin again.
struct Plain<const N: usize> {
    outcome: Option<Outcome>,
    iterations: u32,
    values: [f64; N],
}

struct Search<'a, const N: usize> {
    plan: &'a Plan<N>,
    arm: &'a Arm<f64, N>,
    target: DualQuat<f64>,
    options: Options<f64>,
    /// The length that weighs as much as a radian.
    length: f64,
}

/// The state of an arm: its columns, and its error.
struct Here {
    columns: Vec<Twist<f64>>,
    end: [f64; 3],
    error: Vector6<f64>,
    reached: bool,
}

/// Changes, and what they would leave of the squared error where a limit cut them short.
struct Step<const N: usize> {
    changes: [f64; N],
    left: Option<f64>,
}

impl<const N: usize> Search<'_, N> {
    fn is_slide(&self, joint: usize) -> bool {
        self.plan.axes[joint].pitch.is_none()
    }

    fn limits(&self, joint: usize) -> [f64; 2] {
        self.plan.axes[joint].limits
    }

    /// `true` if a turn more or less is the same pose.
    fn is_hinge(&self, joint: usize) -> bool {
        self.plan.axes[joint].pitch == Some(0.0)
    }

    /// `true` if a value a turn away is within the limits, too.
    fn wraps(&self, joint: usize) -> bool {
        let [low, high] = self.limits(joint);
        self.is_hinge(joint) && high - low >= TAU
    }

    /// `true` if a step to `value` ends at a limit: the value is outside by any number of turns.
    fn stops(&self, joint: usize, value: f64) -> bool {
        let turns: &[f64] = if self.is_hinge(joint) { &[0.0, TAU, -TAU] } else { &[0.0] };
        let [low, high] = self.limits(joint);
        !turns.iter().any(|turn| (low..=high).contains(&(value + turn)))
    }

    /// A twist as angle and way of the end, both in radians.
    fn row(&self, twist: Twist<f64>, end: [f64; 3]) -> Vector6<f64> {
        let [x, y, z] = twist.velocity_at(end).map(|c| c / self.length);
        let [wx, wy, wz] = twist.angular;
        Vector6::new(wx, wy, wz, x, y, z)
    }

    fn here(&self, values: &[f64; N]) -> Here {
        let (mut pose, mut columns) = (DualQuat::IDENTITY, Vec::new());
        for (axis, &value) in self.plan.axes.iter().zip(values) {
            let (Screw { axis, angle, slide }, _) = axis.screw();
            let moment: [f64; 3] =
                core::array::from_fn(|i| angle * axis.moment[i] + slide * axis.direction[i]);
            let screw = Twist { angular: axis.direction.map(|c| angle * c), linear: moment };
            columns.push(pose.adjoint(screw));
            let (angle, slide) = (angle * value, slide * value);
            pose = pose * DualQuat::from_screw(Screw { axis, angle, slide });
        }
        let pose = self.arm.forward(values);
        let reached = pose.angle_to(self.target) <= self.options.angular_tolerance
            && pose.distance_to(self.target) <= self.options.linear_tolerance;
        Here { columns, end: pose.translation(), error: self.error(pose), reached }
    }

    /// The error of an end at `pose`.
    fn error(&self, pose: DualQuat<f64>) -> Vector6<f64> {
        self.row((self.target * pose.conjugate()).to_twist(), pose.translation())
    }

    /// Damped least squares; joints that would leave their limits stop there, and the others try
    /// again.
    fn step(
        &self,
        values: &[f64; N],
        columns: &[Twist<f64>],
        here: &Here,
        damping: f64,
    ) -> Step<N> {
        let unit = |j: usize| if self.is_slide(j) { self.length } else { 1.0 };
        let row = |j: usize| self.row(columns[j].scale(unit(j)), here.end);
        let (mut changes, mut left) = ([0.0; N], here.error);
        let (mut free, mut limited): (Vec<usize>, bool) = ((0..N).collect(), false);
        loop {
            let rows: Vec<_> = free.iter().map(|&j| row(j)).collect();
            let jacobian = DMatrix::from_fn(6, rows.len(), |i, j| rows[j][i]);
            let square = &jacobian * jacobian.transpose();
            let rounding = 0.25 * f64::EPSILON * (square.trace() + 1e-300);
            let system = square + DMatrix::identity(6, 6) * (damping + rounding);
            let system = Matrix6::from_column_slice(system.as_slice());
            let y = system.cholesky().expect("damped").solve(&left);
            let radians: DVector<f64> = jacobian.transpose() * y;
            // What slides may have a long way to go.
            let turns = free.iter().zip(radians.iter()).filter(|&(&j, _)| !self.is_slide(j));
            let most = turns.fold(0.0, |most: f64, (_, turn)| most.max(turn.abs()));
            let shrink = (self.options.max_step / most).min(1.0);
            let mut stopped = Vec::new();
            for (&j, radians) in free.iter().zip(radians.iter()) {
                changes[j] = radians * shrink * unit(j);
                let [low, high] = self.limits(j);
                let (value, inside) =
                    (values[j] + changes[j], (values[j] + changes[j]).clamp(low, high));
                if !self.wraps(j) && self.stops(j, value) {
                    changes[j] = inside - values[j];
                    left -= row(j) * (changes[j] / unit(j));
                    stopped.push(j);
                }
            }
            limited |= !stopped.is_empty();
            free.retain(|j| !stopped.contains(j));
            if stopped.is_empty() || free.is_empty() {
                for &j in &free {
                    left -= row(j) * (changes[j] / unit(j));
                }
                return Step { changes, left: limited.then(|| left.norm_squared()) };
            }
        }
    }

    /// A step along columns that are bent by half of another.
    fn halley(&self, values: &[f64; N], here: &Here, caution: f64) -> Step<N> {
        let damping = 0.02 * caution * here.error.norm_squared();
        let damping = damping + self.options.damping.powi(2);
        let first = self.step(values, &here.columns, here, damping);
        let mut moved = Twist::from_array([0.0; 6]);
        let mut bent = Vec::new();
        for (&column, change) in here.columns.iter().zip(first.changes) {
            bent.push(column + lie_bracket(moved, column).scale(0.5));
            moved = moved + column.scale(change);
        }
        self.step(values, &bent, here, damping)
    }

    fn moved(&self, values: &[f64; N], changes: &[f64; N], start: &[f64; N]) -> [f64; N] {
        core::array::from_fn(|j| {
            let [low, high] = self.limits(j);
            let value = values[j] + changes[j];
            // Of what a whole turn leaves within the limits, the nearest to the start.
            let turns = if self.is_hinge(j) { -3..=3 } else { 0..=0 };
            let near = turns
                .map(|k| value + f64::from(k) * TAU)
                .filter(|near| (low..=high).contains(near))
                .min_by(|a, b| (a - start[j]).abs().total_cmp(&(b - start[j]).abs()));
            near.unwrap_or(value.clamp(low, high))
        })
    }

    fn run(&self, start: [f64; N]) -> Plain<N> {
        let may_restart = self.options.restarts;
        // Where it may begin again, less patience and more progress are asked for.
        let (patience, needed) = if may_restart { (2, 0.4) } else { (6, 0.999) };
        let mut values = start;
        let mut here = self.here(&values);
        let (mut best, mut square) = (values, here.error.norm_squared());
        let (mut best_square, mut mark, mut idle, mut caution) = (square, square, 0, 1.0);
        let mut iterations = 0;
        while !here.reached && iterations < self.options.max_iterations {
            iterations += 1;
            let Step { changes, left } = self.halley(&values, &here, caution);
            let is_hopeless = may_restart && left.is_some_and(|left| left > 0.2 * square);
            let is_hopeless = is_hopeless && square > 1e-4;
            values = self.moved(&values, &changes, &start);
            here = self.here(&values);
            let next = here.error.norm_squared();
            if here.reached || next < best_square {
                (best, best_square) = (values, next);
            }
            let led_away = !may_restart && next > square;
            caution = if led_away { 8.0 * caution } else { f64::max(0.5 * caution, 1.0) };
            square = next;
            (mark, idle) = if square < mark * needed { (square, 0) } else { (mark, idle + 1) };
            if !here.reached && (idle >= patience || is_hopeless) {
                let outcome = (!may_restart).then(|| self.stopped(&best));
                return Plain { outcome, iterations, values: best };
            }
        }
        let outcome = if here.reached { Outcome::Converged } else { Outcome::Unfinished };
        Plain { outcome: Some(outcome), iterations, values: best }
    }

    fn stopped(&self, best: &[f64; N]) -> Outcome {
        let at_limit = (0..N).any(|j| {
            let [low, high] = self.limits(j);
            !self.wraps(j) && (best[j] <= low || best[j] >= high)
        });
        if at_limit { Outcome::AtLimits } else { Outcome::Stalled }
    }
}

/// Rounding differs, and near singular poses the last bit becomes another way: all but a few
/// searches take the same steps to the same values, or begin again as well. A fifth of the targets
/// is moved out of reach or nearly so.
fn searches_agree<const N: usize>(plan: &Plan<N>, options: &Options<f64>) {
    let (arm, mut random) = (plan.arm::<f64>(), Random(21));
    let (_, reach) = arm.bound();
    let length = options.length_per_radian.unwrap_or(reach / 8.0);
    let options = Options { length_per_radian: Some(length), ..*options };
    let (mut differ, mut end, mut begin_again) = (0, 0, 0);
    for i in 0..60 {
        let mut target = arm.forward(&plan.draw(&mut random));
        if i % 5 == 4 {
            target = DualQuat::from_translation([0.2 * reach * random.signed(), 0.0, 0.0]) * target;
        }
        let start = plan.draw(&mut random);
        let mut values = start;
        let report = arm.reach(target, &mut values, &options);
        if report.outcome == Outcome::OutOfReach {
            continue;
        }
        let plain = Search { plan, arm: &arm, target, options, length }.run(start);
        let Some(outcome) = plain.outcome else {
            differ += usize::from(report.restarts == 0);
            begin_again += 1;
            continue;
        };
        let same_way =
            (report.outcome, report.iterations, report.restarts) == (outcome, plain.iterations, 0);
        let near = values.iter().zip(plain.values).all(|(a, b)| {
            let apart = (a - b).abs();
            apart < SAME_WAY || (apart - TAU).abs() < SAME_WAY
        });
        differ += usize::from(!(same_way && near));
        end += 1;
    }
    assert!(differ <= 1, "{differ} of 60 differ");
    assert!(
        end >= 5 && (begin_again > 0) == options.restarts,
        "{end} end, {begin_again} begin again"
    );
}

#[test]
fn a_search_written_plainly_takes_the_same_steps_to_the_same_values() {
    let options = Options { max_iterations: 40, ..Options::default() };
    let once = Options { restarts: false, ..options };
    // Seven of eight searches with these begin again.
    let careful = Options { damping: 0.01, max_step: 0.3, length_per_radian: Some(0.2), ..options };
    let weighed = Options { damping: 0.01, length_per_radian: Some(0.2), ..options };
    for options in [options, once, careful, weighed] {
        searches_agree(&ur5(), &options);
        searches_agree(&puma(), &options);
        searches_agree(&gantry(), &options);
        searches_agree(&seven(), &options);
    }
}

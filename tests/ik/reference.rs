//! The search of [`Arm::reach`] written once more, plainly: one target, `f64`, branches instead of masks,
//! the joints by the scalar [`Joint::motion`](dq8::ik::Joint::motion), the linear algebra by nalgebra.
//! It stands here and not in the library because nobody needs a second, slower search; the lanes
//! need a second opinion.

use super::arms::{Plan, Random, gantry, puma, seven, ur5};
use dq8::ik::{Arm, Options, Outcome};
use dq8::mechanism::{Freedom, Goal, OwnedMechanism, Reach};
use dq8::{DualQuat, Twist};
use nalgebra::{DMatrix, DVector, Matrix6, Vector6};
use std::f64::consts::TAU;

/// Where steps differ by rounding alone: each makes a few times as much of what came before.
const SAME_WAY: f64 = 1e-7;

/// How a plain search ended.
struct Plain<const N: usize> {
    outcome: Outcome,
    iterations: u32,
    restarts: u32,
    values: [f64; N],
}

struct Search<'a, const N: usize> {
    arm: &'a Arm<f64, N>,
    target: DualQuat<f64>,
    options: Options<f64>,
    /// The length that weighs as much as a radian.
    length: f64,
}

/// Where an arm is, and what separates it from its target.
struct Here {
    columns: Vec<Twist<f64>>,
    end: [f64; 3],
    error: Vector6<f64>,
    reached: bool,
}

impl<const N: usize> Search<'_, N> {
    fn is_slide(&self, joint: usize) -> bool {
        self.arm.joints()[joint].screw.angular == [0.0; 3]
    }

    /// Whether a turn more or less is the same pose.
    fn is_hinge(&self, joint: usize) -> bool {
        let Twist { angular: w, linear: v } = self.arm.joints()[joint].screw;
        let pitch = w[0] * v[0] + w[1] * v[1] + w[2] * v[2];
        w != [0.0; 3] && pitch.abs() < 1e-12
    }

    /// Whether one is within the limits too.
    fn wraps(&self, joint: usize) -> bool {
        let [low, high] = self.arm.joints()[joint].limits;
        self.is_hinge(joint) && high - low >= TAU
    }

    /// Whether a step to `value` ends at a limit: no turn less is between them.
    fn stops(&self, joint: usize, value: f64) -> bool {
        let turns: &[f64] = if self.is_hinge(joint) { &[0.0, TAU, -TAU] } else { &[0.0] };
        let [low, high] = self.arm.joints()[joint].limits;
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
        for (joint, &value) in self.arm.joints().iter().zip(values) {
            columns.push(pose.adjoint(joint.screw));
            pose = pose * joint.motion(value);
        }
        let pose = self.arm.forward(values);
        let reached = pose.angle_to(self.target) <= self.options.angular_tolerance
            && pose.distance_to(self.target) <= self.options.linear_tolerance;
        Here { columns, end: pose.translation(), error: self.error(pose), reached }
    }

    /// What separates an end at `pose` from the target.
    fn error(&self, pose: DualQuat<f64>) -> Vector6<f64> {
        self.row((self.target * pose.conjugate()).to_twist(), pose.translation())
    }

    /// Damped least squares; joints that would leave their limits stop there, and the others try again.
    /// The changes, and whether there was such a joint.
    fn step(&self, values: &[f64; N], columns: &[Twist<f64>], here: &Here) -> ([f64; N], bool) {
        let unit = |j: usize| if self.is_slide(j) { self.length } else { 1.0 };
        let row = |j: usize| self.row(columns[j].scale(unit(j)), here.end);
        let damping = 0.02 * here.error.norm_squared() + self.options.damping.powi(2);
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
            let shrink = (self.options.max_step / radians.amax()).min(1.0);
            let mut stopped = Vec::new();
            for (&j, radians) in free.iter().zip(radians.iter()) {
                changes[j] = radians * shrink * unit(j);
                let [low, high] = self.arm.joints()[j].limits;
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
                return (changes, limited);
            }
        }
    }

    /// A step along columns that are bent by half of another.
    fn halley(&self, values: &[f64; N], here: &Here) -> ([f64; N], bool) {
        let (first, _) = self.step(values, &here.columns, here);
        let mut moved = Twist::from_array([0.0; 6]);
        let mut bent = Vec::new();
        for (&column, change) in here.columns.iter().zip(first) {
            bent.push(column + bracket(moved, column).scale(0.5));
            moved = moved + column.scale(change);
        }
        self.step(values, &bent, here)
    }

    fn moved(&self, values: &[f64; N], changes: &[f64; N], start: &[f64; N]) -> [f64; N] {
        core::array::from_fn(|j| {
            let [low, high] = self.arm.joints()[j].limits;
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
        let mut values = start;
        let mut here = self.here(&values);
        let (mut best, mut best_square) = (values, here.error.norm_squared());
        let (mut mark, mut idle, mut stuck, mut ever_stuck) = (best_square, 0, false, false);
        let mut seeds = None;
        let (mut iterations, mut restarts) = (0, 0);
        let mut outcome = if here.reached { Outcome::Converged } else { Outcome::Unfinished };
        while outcome == Outcome::Unfinished && iterations < self.options.max_iterations {
            iterations += 1;
            let mut hopeless = false;
            let restarting = stuck;
            if restarting {
                let seeds = seeds.get_or_insert_with(|| self.seeds());
                let Some(seed) = seeds.pop() else { break };
                (values, restarts) = (self.moved(&seed, &[0.0; N], &start), restarts + 1);
            } else {
                let (changes, limited) = self.halley(&values, &here);
                let square = here.error.norm_squared();
                let mut left = here.error;
                for (&column, change) in here.columns.iter().zip(changes) {
                    left -= self.row(column, here.end) * change;
                }
                hopeless = limited && left.norm_squared() > 0.4 * square && square > 1e-4;
                values = self.moved(&values, &changes, &start);
            }
            here = self.here(&values);
            let square = here.error.norm_squared();
            if here.reached || square < best_square {
                (best, best_square) = (values, square);
            }
            if here.reached {
                outcome = Outcome::Converged;
            }
            let (patience, needed) = if self.options.restarts { (2, 0.4) } else { (6, 0.999) };
            if restarting || square < mark * needed {
                (mark, idle) = (square, 0);
            } else {
                idle += 1;
            }
            stuck = idle >= patience || hopeless && self.options.restarts;
            ever_stuck |= stuck && !here.reached;
            if stuck && !self.options.restarts {
                break;
            }
        }
        if outcome == Outcome::Unfinished && ever_stuck {
            let at_limit = (0..N).any(|j| {
                let [low, high] = self.arm.joints()[j].limits;
                !self.wraps(j) && (best[j] <= low || best[j] >= high)
            });
            outcome = if at_limit { Outcome::AtLimits } else { Outcome::Stalled };
        }
        Plain { outcome, iterations, restarts, values: best }
    }

    /// The 128 poses to begin again from, the nearest to the target last: ½ + kα modulo 1.
    fn seeds(&self) -> Vec<[f64; N]> {
        let ratio = (0..64).fold(1.5_f64, |g, _| (1.0 + g).powf(1.0 / (N as f64 + 1.0)));
        let mut seeds: Vec<(f64, [f64; N])> = (1..=128)
            .map(|k| {
                let values = core::array::from_fn(|j| {
                    let share = (0.5 + f64::from(k) * ratio.powi(-(j as i32 + 1))).fract();
                    let [low, high] = self.arm.joints()[j].limits;
                    low + (high - low) * share
                });
                (self.error(self.arm.forward(&values)).norm_squared(), values)
            })
            .collect();
        seeds.sort_by(|(a, _), (b, _)| b.total_cmp(a));
        seeds.into_iter().map(|(_, values)| values).collect()
    }
}

/// [a, b] of spatial twists: a as a velocity of b.
fn bracket(a: Twist<f64>, b: Twist<f64>) -> Twist<f64> {
    let cross =
        |[a, b, c]: [f64; 3], [x, y, z]: [f64; 3]| [b * z - c * y, c * x - a * z, a * y - b * x];
    let (first, second) = (cross(a.angular, b.linear), cross(a.linear, b.angular));
    Twist {
        angular: cross(a.angular, b.angular),
        linear: core::array::from_fn(|i| first[i] + second[i]),
    }
}

/// Rounding differs, and near singular poses the last bit becomes another way: all but a few searches
/// take the same steps to the same values. A fifth of the targets is moved out of reach or nearly so.
fn searches_agree<const N: usize>(plan: &Plan<N>, options: &Options<f64>) {
    let (arm, mut random) = (plan.arm::<f64>(), Random(21));
    let (_, reach) = arm.reach_bound();
    let length = options.length_per_radian.unwrap_or(reach / 8.0);
    let mut differ = 0;
    for i in 0..30 {
        let mut target = arm.forward(&plan.draw(&mut random));
        if i % 5 == 4 {
            target = DualQuat::from_translation([0.2 * reach * random.signed(), 0.0, 0.0]) * target;
        }
        let start = plan.draw(&mut random);
        let mut values = start;
        let report = arm.reach(target, &mut values, options);
        if report.outcome == Outcome::OutOfReach {
            continue;
        }
        let search = Search { arm: &arm, target, options: *options, length };
        let plain = search.run(start);
        let same_way = (plain.outcome, plain.iterations, plain.restarts)
            == (report.outcome, report.iterations, report.restarts);
        let near = values.iter().zip(plain.values).all(|(a, b)| {
            let apart = (a - b).abs();
            apart < SAME_WAY || (apart - TAU).abs() < SAME_WAY
        });
        differ += usize::from(!(same_way && near));
    }
    assert!(differ <= 1, "{differ} of 30 differ");
}

#[test]
fn a_search_written_plainly_takes_the_same_steps_to_the_same_values() {
    let options = Options { max_iterations: 40, ..Options::default() };
    let once = Options { restarts: false, ..options };
    // Seven of eight searches with these begin again.
    let careful = Options { damping: 0.01, max_step: 0.3, length_per_radian: Some(0.2), ..options };
    for options in [options, once, careful] {
        searches_agree(&ur5(), &options);
        searches_agree(&puma(), &options);
        searches_agree(&gantry(), &options);
        searches_agree(&seven(), &options);
    }
}

/// A mechanism begins again elsewhere and sooner before limits; until then it takes the same steps.
fn a_mechanism_agrees<const N: usize>(plan: &Plan<N>, options: &Options<f64>) {
    let (arm, mut random) = (plan.arm::<f64>(), Random(22));
    let mechanism = OwnedMechanism::new(&plan.links()).expect("a mechanism");
    let (goals, mut freedoms) = ([Goal::pose(N)], [Freedom::default(); N]);
    let problem = Reach::new(mechanism.view(), &goals, &mut freedoms).expect("a problem");
    let mut scratch = vec![0.0; problem.scratch_len()];
    let (_, reach) = arm.reach_bound();
    let length = options.length_per_radian.unwrap_or(reach / 8.0);
    let options = Options { length_per_radian: Some(length), ..*options };
    let (mut compared, mut sooner, mut differ) = (0, 0, 0);
    for _ in 0..90 {
        let (target, start) = (arm.forward(&plan.draw(&mut random)), plan.draw(&mut random));
        let plain = Search { arm: &arm, target, options, length }.run(start);
        if plain.outcome != Outcome::Converged || plain.restarts > 0 {
            continue;
        }
        compared += 1;
        let mut values = start;
        let report =
            problem.solve(&[target], &mut values, &mut scratch, &options).expect("lengths fit");
        if report.restarts > 0 {
            sooner += 1;
            continue;
        }
        let same_way =
            (report.outcome, report.iterations) == (Outcome::Converged, plain.iterations);
        let near = values.iter().zip(plain.values).all(|(a, b)| {
            let apart = (a - b).abs();
            apart < SAME_WAY || (apart - TAU).abs() < SAME_WAY
        });
        differ += usize::from(!(same_way && near));
    }
    assert!(compared >= 20, "{compared} to compare");
    assert!(sooner <= compared / 8, "{sooner} of {compared} begin again");
    assert!(differ <= 1, "{differ} of {compared} differ");
}

#[test]
fn a_mechanism_takes_the_same_steps_until_it_begins_again() {
    let options = Options { max_iterations: 40, ..Options::default() };
    let weighed = Options { damping: 0.01, length_per_radian: Some(0.2), ..options };
    for options in [options, weighed] {
        a_mechanism_agrees(&ur5(), &options);
        a_mechanism_agrees(&puma(), &options);
        a_mechanism_agrees(&seven(), &options);
    }
}

//! Velocities and Jacobians of hierarchies against differences of forward kinematics: a six-axis arm
//! and a biped with branches; and in every layout on every backend against the definition.

use crate::records::{assert_same_bits, splice};
use crate::scene::{BIPED, MAX_INSTANCES, ROOT, motions, rounded};
use crate::subject::{Task, for_every_subject};
use dq8::{Backend, DualQuat, Hierarchy, Twist};
use dq8_contract::bound::unit_roundoff;
use dq8_contract::ledger::{Ledger, line};
use dq8_contract::random::Random;

/// Joints that each turn, slide or screw about an axis of their own.
struct Machine {
    parents: Vec<u32>,
    /// From the parent's frame to the joint's at rest.
    rest: Vec<DualQuat<f64>>,
    axes: Vec<Twist<f64>>,
}

impl Machine {
    fn new(parents: &[u32], random: &mut Random) -> Self {
        let rest = parents.iter().map(|_| DualQuat::from_array(motions(random, 1)[0])).collect();
        let axis = |joint: usize| {
            let (axis, none) = (random.direction(), [0.0; 3]);
            match joint % 4 {
                // A slide, a screw of pitch ¼, and hinges.
                1 => Twist { angular: none, linear: axis },
                3 => Twist { angular: axis, linear: axis.map(|c| 0.25 * c) },
                _ => Twist { angular: axis, linear: none },
            }
        };
        let axes = (0..parents.len()).map(axis).collect();
        Self { parents: parents.to_vec(), rest, axes }
    }

    /// An arm of six axes, and a biped.
    fn both() -> [Self; 2] {
        let mut random = Random(11);
        let arm = [ROOT, 0, 1, 2, 3, 4];
        [Self::new(&arm, &mut random), Self::new(&BIPED, &mut random)]
    }

    fn hierarchy(&self) -> Hierarchy<'_> {
        Hierarchy::new(&self.parents).expect("parents come first")
    }

    fn joints(&self) -> usize {
        self.parents.len()
    }

    fn models(&self, q: &[f64]) -> Vec<DualQuat<f64>> {
        let joints = self.rest.iter().zip(&self.axes).zip(q);
        let locals: Vec<_> =
            joints.map(|((rest, axis), q)| *rest * DualQuat::from_twist(axis.scale(*q))).collect();
        let mut models = locals.clone();
        self.hierarchy().local_to_model(&locals, &mut models).expect("lengths fit");
        models
    }

    fn ancestors(&self, effector: usize) -> Vec<usize> {
        let step = |&joint: &usize| {
            let parent = self.parents[joint];
            (parent != ROOT).then_some(parent as usize)
        };
        std::iter::successors(Some(effector), step).collect()
    }
}

fn numbers(random: &mut Random, count: usize) -> Vec<f64> {
    (0..count).map(|_| 2.0 * random.signed()).collect()
}

fn assert_close(got: Twist<f64>, wanted: Twist<f64>, tolerance: f64, what: &str) {
    for (got, wanted) in got.to_array().into_iter().zip(wanted.to_array()) {
        assert!((got - wanted).abs() < tolerance, "{what}: {got:e}, not {wanted:e}");
    }
}

const STEP: f64 = 1e-5;

/// The spatial twist between two motions 2h apart.
fn change(after: DualQuat<f64>, before: DualQuat<f64>) -> Twist<f64> {
    (after * before.conjugate()).to_twist().scale(0.5 / STEP)
}

#[test]
fn a_column_is_the_twist_of_the_effector_for_one_joint_that_moves() {
    let mut random = Random(12);
    for machine in Machine::both() {
        let q = numbers(&mut random, machine.joints());
        let models = machine.models(&q);
        for effector in 0..machine.joints() {
            let mut columns = vec![Twist::from_array([f64::NAN; 6]); machine.joints()];
            let hierarchy = machine.hierarchy();
            hierarchy
                .job()
                .jacobian(&models, &machine.axes, effector, &mut columns)
                .expect("it fits");
            for (joint, &column) in columns.iter().enumerate() {
                let moved = |by: f64| {
                    let mut q = q.clone();
                    q[joint] += by;
                    machine.models(&q)[effector]
                };
                let wanted = change(moved(STEP), moved(-STEP));
                assert_close(column, wanted, 1e-8, &format!("joint {joint} of {effector}"));
                if !machine.ancestors(effector).contains(&joint) {
                    assert_eq!(column, Twist::from_array([0.0; 6]), "{joint} of {effector}");
                }
            }
        }
    }
}

#[test]
fn the_geometric_jacobian_moves_a_point_of_the_effector() {
    let mut random = Random(13);
    for machine in Machine::both() {
        let q = numbers(&mut random, machine.joints());
        let (models, effector) = (machine.models(&q), machine.joints() - 1);
        let mut columns = machine.axes.clone();
        let hierarchy = machine.hierarchy();
        hierarchy.job().jacobian(&models, &machine.axes, effector, &mut columns).expect("it fits");
        let tool = [0.3, -0.2, 0.9];
        for (joint, column) in columns.into_iter().enumerate() {
            let moved = |by: f64| {
                let mut q = q.clone();
                q[joint] += by;
                machine.models(&q)[effector].transform_point(tool)
            };
            let (after, before) = (moved(STEP), moved(-STEP));
            let got = column.velocity_at(models[effector].transform_point(tool));
            for i in 0..3 {
                let wanted = (after[i] - before[i]) * (0.5 / STEP);
                assert!((got[i] - wanted).abs() < 1e-8, "joint {joint}: {got:?}");
            }
        }
    }
}

#[test]
fn velocities_are_differences_of_forward_kinematics_and_the_jacobian_times_the_rates() {
    let mut random = Random(14);
    for machine in Machine::both() {
        let q = numbers(&mut random, machine.joints());
        let speeds = numbers(&mut random, machine.joints());
        let models = machine.models(&q);
        let at = |time: f64| {
            let moved: Vec<_> = q.iter().zip(&speeds).map(|(q, speed)| q + time * speed).collect();
            machine.models(&moved)
        };
        let (after, before) = (at(STEP), at(-STEP));
        let rates: Vec<_> = machine.axes.iter().zip(&speeds).map(|(a, s)| a.scale(*s)).collect();
        let mut twists = vec![Twist::from_array([f64::NAN; 6]); machine.joints()];
        machine.hierarchy().job().velocities(&models, &rates, &mut twists).expect("it fits");
        for joint in 0..machine.joints() {
            let what = format!("joint {joint}");
            assert_close(twists[joint], change(after[joint], before[joint]), 1e-7, &what);
            let mut columns = machine.axes.clone();
            let hierarchy = machine.hierarchy();
            hierarchy.job().jacobian(&models, &machine.axes, joint, &mut columns).expect("it fits");
            let products = columns.iter().zip(&speeds).map(|(column, speed)| column.scale(*speed));
            let sum = products.fold(Twist::from_array([0.0; 6]), |sum, product| sum + product);
            assert_close(twists[joint], sum, 1e-13, &what);
        }
    }
}

/// twist(j) = twist(parent(j)) + Ad_{model(j)} rate(j), of the joints of `range`; the others are given.
fn velocities(
    task: &Task,
    models: &[[f64; 8]],
    rates: &[[f64; 6]],
    given: &[[f64; 6]],
) -> Vec<[f64; 6]> {
    let mut twists = given.to_vec();
    let joints = task.parents.len();
    for index in (0..twists.len()).filter(|index| task.joints.contains(&(index % joints))) {
        let own = adjoint(models[index], rates[index]);
        twists[index] = match task.parents[index % joints] {
            ROOT => own,
            parent => {
                let parent = twists[index / joints * joints + parent as usize];
                (Twist::from_array(parent) + Twist::from_array(own)).to_array()
            }
        };
    }
    twists
}

/// Ad_{model(j)} axis(j) of the effector and its ancestors, 0 of the others; of the joints of `range`.
fn jacobian(
    task: &Task,
    models: &[[f64; 8]],
    axes: &[[f64; 6]],
    effector: usize,
    given: &[[f64; 6]],
) -> Vec<[f64; 6]> {
    let joints = task.parents.len();
    let mut above = vec![effector];
    while task.parents[above[above.len() - 1]] != ROOT {
        above.push(task.parents[above[above.len() - 1]] as usize);
    }
    let column = |index: usize| match index % joints {
        joint if !task.joints.contains(&joint) => given[index],
        joint if above.contains(&joint) => adjoint(models[index], axes[joint]),
        _ => [0.0; 6],
    };
    (0..models.len()).map(column).collect()
}

fn adjoint(motion: [f64; 8], twist: [f64; 6]) -> [f64; 6] {
    DualQuat::from_array(motion).adjoint(Twist::from_array(twist)).to_array()
}

fn twists(random: &mut Random, count: usize) -> Vec<[f64; 6]> {
    (0..count).map(|_| [(); 6].map(|()| random.signed())).collect()
}

/// Two blocks and a bit of instances, all joints and some of them.
#[test]
fn every_layout_on_every_backend_keeps_the_table() {
    let lines = &[
        line("velocities", &[], 10.5, "an adjoint per joint, summed from the root down"),
        line("jacobian", &[], 2.5, "an adjoint"),
    ];
    Ledger::keep("twists of joints", lines, |ledger| {
        let mut random = Random(15);
        for machine in Machine::both() {
            let (joints, effector) = (machine.joints(), machine.joints() - 2);
            let mut models = Vec::new();
            for _ in 0..MAX_INSTANCES {
                let posed = machine.models(&numbers(&mut random, joints));
                models.extend(posed.iter().map(|model| model.to_array()));
            }
            let [rates, given] = [(); 2].map(|()| twists(&mut random, models.len()));
            let axes: Vec<_> = machine.axes.iter().map(|axis| axis.to_array()).collect();
            for_every_subject(|subject, backend| {
                let single = subject.single();
                let round = |records: &[[f64; 6]]| rounded(single, records);
                let exact = rounded(single, &models);
                let far = |model: &[f64; 8]| {
                    let [x, y, z] = DualQuat::from_array(*model).translation();
                    x.hypot(y).hypot(z)
                };
                let scale = exact.iter().map(far).fold(1.0, f64::max);
                let unit = scale * unit_roundoff(single);
                for range in [0..joints, 2..joints - 1] {
                    let task =
                        Task { joints: range.clone(), ..Task::new(&machine.parents, backend) };
                    let instances =
                        if subject.things() == 1 { 17 } else { 2 * subject.things() + 1 };
                    let count = instances * joints;
                    // NaN is what may not be read: twists of the range, rates outside it.
                    let unread = vec![[f64::NAN; 6]; count];
                    let before = splice(joints, &range, &unread, &given[..count]);
                    let moving = splice(joints, &range, &rates[..count], &unread);
                    let models = &models[..count];
                    let got_twists = subject.velocities(&task, models, &moving, &before);
                    let true_twists =
                        velocities(&task, &exact[..count], &round(&moving), &round(&before));
                    let got_columns = subject.jacobian(&task, models, &axes, effector, &before);
                    let true_columns =
                        jacobian(&task, &exact[..count], &round(&axes), effector, &round(&before));
                    for (name, got, truth) in [
                        ("velocities", &got_twists, &true_twists),
                        ("jacobian", &got_columns, &true_columns),
                    ] {
                        let outside =
                            |twists: &[_]| splice(joints, &range, &unread, &twists[..count]);
                        assert_same_bits(&outside(got), &outside(truth), "outside the range");
                        for (index, (got, truth)) in got.iter().zip(truth).enumerate() {
                            if !range.contains(&(index % joints)) {
                                continue;
                            }
                            for (got, truth) in got.iter().zip(truth) {
                                let units = (got - truth).abs() / unit;
                                ledger.measure(name, "", units, || {
                                    format!("{} on {backend}, element {index}", subject.name())
                                });
                            }
                        }
                    }
                }
            });
        }
    });
}

/// A `Twist` has halves with names, and is read by a way of its own.
#[test]
fn twists_with_names_are_twists_of_six_numbers() {
    let machine = &Machine::both()[1];
    let mut random = Random(16);
    for instances in [1, 3, 17] {
        let count = instances * machine.joints();
        let models: Vec<_> =
            motions(&mut random, count).into_iter().map(DualQuat::from_array).collect();
        let rates = twists(&mut random, count);
        let named: Vec<_> = rates.iter().map(|rate| Twist::from_array(*rate)).collect();
        for backend in Backend::available() {
            let hierarchy = machine.hierarchy();
            let job = hierarchy.job().backend(backend);
            let (mut by_number, mut by_name) = (rates.clone(), named.clone());
            job.velocities(&models, &rates, &mut by_number).expect("lengths fit");
            job.velocities(&models, &named, &mut by_name).expect("lengths fit");
            let numbers = |twists: &[Twist<f64>]| -> Vec<[f64; 6]> {
                twists.iter().map(|twist| twist.to_array()).collect()
            };
            assert_same_bits(&numbers(&by_name), &by_number, "velocities");
            let effector = machine.joints() - 1;
            job.jacobian(&models, &machine.axes, effector, &mut by_number).expect("lengths fit");
            job.jacobian(&models, &machine.axes, effector, &mut by_name).expect("lengths fit");
            assert_same_bits(&numbers(&by_name), &by_number, "columns");
        }
    }
}

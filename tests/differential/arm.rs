//! Velocities and Jacobians of hierarchies against differences of forward kinematics: a six-axis arm
//! and a biped with branches, one instance and blocks of every width.

use dq8::{Block, DualQuat, Float, Hierarchy, Pose, Real, ShapeError, Twist, TwistBlock, pack};
use dq8_contract::bound::unit_roundoff;
use dq8_contract::case::length;
use dq8_contract::ledger::{Ledger, line};
use dq8_contract::random::Random;
use dq8_simd::Row;

const ROOT: u32 = Hierarchy::ROOT;

/// Joints that each turn, slide or screw about an axis of their own.
struct Machine {
    parents: Vec<u32>,
    /// From the parent's frame to the joint's at rest.
    rest: Vec<DualQuat<f64>>,
    axes: Vec<Twist<f64>>,
}

impl Machine {
    fn new(parents: &[u32], random: &mut Random) -> Self {
        let rest = parents.iter().map(|_| random.motion(1.0)).collect();
        let axis = |joint: usize| {
            let (axis, none) = (random.axis(), [0.0; 3]);
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

    /// An arm of six axes, and a biped: pelvis, spine with head and arms, two legs.
    fn both() -> [Self; 2] {
        let mut random = Random(11);
        let arm = [ROOT, 0, 1, 2, 3, 4];
        let biped = [ROOT, 0, 1, 2, 2, 4, 5, 2, 7, 8, 0, 10, 11, 0, 13, 14];
        [Self::new(&arm, &mut random), Self::new(&biped, &mut random)]
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
            hierarchy.jacobian(&models, &machine.axes, effector, &mut columns).expect("it fits");
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
        hierarchy.jacobian(&models, &machine.axes, effector, &mut columns).expect("it fits");
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
        machine.hierarchy().velocities(&models, &rates, &mut twists).expect("it fits");
        for joint in 0..machine.joints() {
            let what = format!("joint {joint}");
            assert_close(twists[joint], change(after[joint], before[joint]), 1e-7, &what);
            let mut columns = machine.axes.clone();
            let hierarchy = machine.hierarchy();
            hierarchy.jacobian(&models, &machine.axes, joint, &mut columns).expect("it fits");
            let products = columns.iter().zip(&speeds).map(|(column, speed)| column.scale(*speed));
            let sum = products.fold(Twist::from_array([0.0; 6]), |sum, product| sum + product);
            assert_close(twists[joint], sum, 1e-13, &what);
        }
    }
}

fn exact<R: Real + Float, const C: usize>(numbers: [R; C]) -> [f64; C] {
    numbers.map(Into::into)
}

/// Two blocks and a bit of instances, in blocks and each by itself, against `f64`.
fn joints_keep_the_table<R: Real + Float, const N: usize>(ledger: &Ledger)
where
    [R; N]: Row<Real = R>,
{
    let mut random = Random(15);
    for machine in Machine::both() {
        let (joints, instances) = (machine.joints(), 2 * N + 1);
        let effector = joints - 2;
        let round =
            |twist: Twist<f64>| Twist::from_array(twist.to_array().map(<R as Real>::from_f64));
        let mut models = Vec::new();
        let mut rates = Vec::new();
        for _ in 0..instances {
            let posed = machine.models(&numbers(&mut random, joints));
            models.extend(
                posed.iter().map(|m| DualQuat::from_array(m.to_array().map(<R as Real>::from_f64))),
            );
            rates.extend((0..joints).map(|_| round(Twist::from_array(random.twist(1.0)))));
        }
        let axes: Vec<Twist<R>> = machine.axes.iter().map(|&axis| round(axis)).collect();
        let hierarchy = machine.hierarchy();
        let (mut twists, mut columns) = (rates.clone(), rates.clone());
        hierarchy.velocities(&models, &rates, &mut twists).expect("lengths fit");
        hierarchy.jacobian(&models, &axes, effector, &mut columns).expect("lengths fit");

        let exact_models: Vec<_> =
            models.iter().map(|m| DualQuat::from_array(exact(m.to_array()))).collect();
        let exactly = |twists: &[Twist<R>]| -> Vec<Twist<f64>> {
            twists.iter().map(|twist| Twist::from_array(exact(twist.to_array()))).collect()
        };
        let (exact_rates, exact_axes) = (exactly(&rates), exactly(&axes));
        let (mut true_twists, mut true_columns) = (exact_rates.clone(), exact_rates.clone());
        hierarchy.velocities(&exact_models, &exact_rates, &mut true_twists).expect("lengths fit");
        hierarchy
            .jacobian(&exact_models, &exact_axes, effector, &mut true_columns)
            .expect("lengths fit");
        let far = |model: &DualQuat<f64>| length(&model.translation());
        let scale = exact_models.iter().map(far).fold(1.0, f64::max);
        let unit = scale * unit_roundoff(size_of::<R>() == 4);

        let mut blocks = vec![Block::<R, N>::splat([R::ZERO; 8]); instances.div_ceil(N) * joints];
        pack(joints, &models, &mut blocks).expect("lengths fit");
        let mut block_rates = vec![TwistBlock::<R, N>::splat([R::ZERO; 6]); blocks.len()];
        for (index, rate) in rates.iter().enumerate() {
            let (instance, joint) = (index / joints, index % joints);
            let block = &mut block_rates[instance / N * joints + joint];
            block.set(instance % N, rate.to_array()).expect("there is such a lane");
        }
        let nowhere = TwistBlock::splat([<R as Real>::from_f64(f64::NAN); 6]);
        let mut block_twists = vec![nowhere; blocks.len()];
        let mut block_columns = vec![nowhere; blocks.len()];
        hierarchy.velocities(&blocks, &block_rates, &mut block_twists).expect("lengths fit");
        hierarchy.jacobian(&blocks, &axes, effector, &mut block_columns).expect("lengths fit");

        for index in 0..models.len() {
            let (instance, joint) = (index / joints, index % joints);
            let place = instance / N * joints + joint;
            for (name, in_blocks, alone, truth) in [
                ("velocities", &block_twists, &twists, &true_twists),
                ("jacobian", &block_columns, &columns, &true_columns),
            ] {
                let in_block = in_blocks[place].get(instance % N).expect("there is such a lane");
                for (kind, got) in [("blocks", in_block), ("alone", alone[index].to_array())] {
                    for (got, wanted) in exact(got).into_iter().zip(truth[index].to_array()) {
                        let units = (got - wanted).abs() / unit;
                        let place = || format!("lanes {N}, instance {instance}, joint {joint}");
                        ledger.measure(name, kind, units, place);
                    }
                }
            }
        }
    }
}

#[test]
fn blocks_of_every_width_and_single_instances_keep_the_table() {
    let lines = &[
        line("velocities", &[], 10.5, "an adjoint a joint, summed from the root down"),
        line("jacobian", &[], 2.5, "an adjoint"),
    ];
    Ledger::keep("twists of joints", lines, |ledger| {
        joints_keep_the_table::<f32, 4>(ledger);
        joints_keep_the_table::<f32, 8>(ledger);
        joints_keep_the_table::<f32, 16>(ledger);
        joints_keep_the_table::<f64, 2>(ledger);
        joints_keep_the_table::<f64, 4>(ledger);
        joints_keep_the_table::<f64, 8>(ledger);
    });
}

/// Whatever does not fit is named, and nothing is written.
fn refuses<P: Pose + PartialEq>(pose: P, twist: P::Twist)
where
    P::Twist: PartialEq + core::fmt::Debug,
{
    let parents = [ROOT, 0, 1];
    let pair = Hierarchy::new(&parents).expect("parents come first");
    let axes = [Twist::from_array([P::Real::ONE; 6]); 4];
    let (models, rates) = ([pose; 7], [twist; 7]);
    let length = |what, length, expected| Err(ShapeError::Length { what, length, expected });

    let mut out = [twist; 7];
    let whole = Err(ShapeError::NotWhole { what: "models", length: 7, joints: 3 });
    assert_eq!(pair.velocities(&models, &rates, &mut out), whole);
    assert_eq!(pair.jacobian(&models, &axes[..3], 0, &mut out), whole);
    assert_eq!(pair.velocities(&models[..6], &rates[..5], &mut out[..6]), length("rates", 5, 6));
    assert_eq!(pair.velocities(&models[..6], &rates[..6], &mut out), length("twists", 7, 6));
    assert_eq!(pair.jacobian(&models[..6], &axes, 0, &mut out[..6]), length("axes", 4, 3));
    assert_eq!(pair.jacobian(&models[..6], &axes[..3], 0, &mut out), length("columns", 7, 6));
    for effector in [3, usize::MAX] {
        let joints =
            Err(ShapeError::Joints { range: effector..effector.saturating_add(1), joints: 3 });
        assert_eq!(pair.jacobian(&models[..6], &axes[..3], effector, &mut out[..6]), joints);
    }
    assert_eq!(out, [twist; 7], "something was written");

    // No instances, and no joints.
    assert_eq!(pair.velocities::<P>(&[], &[], &mut []), Ok(()));
    assert_eq!(pair.jacobian::<P>(&[], &axes[..3], 2, &mut []), Ok(()));
    let nothing = Hierarchy::new(&[]).expect("it is empty");
    assert_eq!(nothing.velocities::<P>(&[], &[], &mut []), Ok(()));
    let joints = Err(ShapeError::Joints { range: 0..1, joints: 0 });
    assert_eq!(nothing.jacobian::<P>(&[], &[], 0, &mut []), joints);
}

#[test]
fn slices_that_do_not_fit_are_refused() {
    refuses(DualQuat::<f64>::IDENTITY, Twist::from_array([7.0; 6]));
    refuses(Block::<f32, 8>::splat([1.0; 8]), TwistBlock::splat([7.0; 6]));
}

//! Many configurations on the lanes of every backend, held to one configuration at a time.

use crate::book::Book;
use crate::tree::{mechanism, tree, values};
use dq8::{Backend, Block, DualQuat, Twist};
use dq8_fixtures::random::Random;
use dq8_robot::{Body, JacobianFrame, Joint, OwnedMechanism, World, WorldAligned};

/// Up to 64 products one after the other, on their own scale, and the same in `f32`.
const POSES: f64 = 2e-14;
const IN_SINGLE: f64 = 1e-5;
/// Moments about links that are some lengths away.
const TWISTS: f64 = 1e-13;

/// Poses of `configurations` by the book.
fn wanted(joints: &[Joint<f64>], values: &[f64], configurations: usize) -> Vec<DualQuat<f64>> {
    let (book, links) = (Book::new(joints), joints.len());
    let mut poses = vec![DualQuat::IDENTITY; configurations * links];
    for configuration in 0..configurations {
        let count = book.view().values();
        let poses = &mut poses[configuration * links..][..links];
        book.link_poses(&values[configuration * count..][..count], poses);
    }
    poses
}

fn close(a: DualQuat<f64>, b: DualQuat<f64>, bound: f64, what: &str) {
    // The sign too: neighbours may be blended.
    let scale = 1.0 + b.dual().norm();
    assert!(a.abs_diff_eq(b, bound * scale), "{what}: {a:?} {b:?}");
}

#[test]
fn lanes_agree_with_one_configuration_for_every_backend_and_layout() {
    let mut random = Random(5);
    for count in (1..30).chain([64]) {
        let joints = tree(&mut random, count);
        let configurations = [1, 2, 3, 4, 7, 8, 9, 16, 33][count % 9];
        let values: Vec<f64> =
            (0..configurations).flat_map(|_| values(&mut random, &joints)).collect();
        let owned = mechanism::<f64>(&joints);
        let single = mechanism::<f32>(&joints);
        let (robot, narrow) = (owned.view(), single.view());
        let wanted = wanted(&joints, &values, configurations);
        let floats: Vec<f32> = values.iter().map(|&value| value as f32).collect();
        for backend in Backend::available() {
            let what = format!("{backend}, {count} joints, {configurations} configurations");
            let mut poses = vec![DualQuat::IDENTITY; wanted.len()];
            robot.job().backend(backend).poses(&values, &mut poses).unwrap();
            for (&pose, &wanted) in poses.iter().zip(&wanted) {
                close(pose, wanted, POSES, &what);
            }
            let mut floating = vec![DualQuat::<f32>::IDENTITY; wanted.len()];
            narrow.job().backend(backend).poses(&floats, &mut floating).unwrap();
            for (pose, &wanted) in floating.iter().zip(&wanted) {
                close(
                    DualQuat::from_array(pose.to_array().map(f64::from)),
                    wanted,
                    IN_SINGLE,
                    &what,
                );
            }
            // Plain values, poses in blocks that are not full.
            let blocks = configurations.div_ceil(8);
            let mut packed = vec![Block::<f64, 8>::splat([0.0; 8]); blocks * count];
            if !values.is_empty() {
                robot.job().backend(backend).poses(&values, &mut packed).unwrap();
                in_blocks(&packed, &poses, count, &what);
            }
            // Both in blocks.
            let mut inputs = vec![Block::<f64, 8, 1>::splat([0.0]); blocks * robot.values()];
            for (index, &value) in values.iter().enumerate() {
                let (configuration, value_index) = (index / robot.values(), index % robot.values());
                let block = &mut inputs[configuration / 8 * robot.values() + value_index];
                block.set(configuration % 8, [value]).unwrap();
            }
            packed.fill(Block::splat([0.0; 8]));
            robot.job().backend(backend).poses(&inputs, &mut packed).unwrap();
            in_blocks(&packed, &poses, count, &what);
            // Some of them, one twice.
            let links = [count - 1, count / 2, count - 1];
            let mut chosen = vec![DualQuat::IDENTITY; 3 * configurations];
            robot.job().links(&links).backend(backend).poses(&values, &mut chosen).unwrap();
            for (index, pose) in chosen.into_iter().enumerate() {
                let all = &poses[index / 3 * count..];
                assert_eq!(pose, all[links[index % 3]], "{what}, chosen");
            }
        }
    }
}

/// Blocks hold what plain poses hold, to rounding: they may be of other lanes.
fn in_blocks(blocks: &[Block<f64, 8>], plain: &[DualQuat<f64>], links: usize, what: &str) {
    for (index, &pose) in plain.iter().enumerate() {
        let (configuration, link) = (index / links, index % links);
        let block = blocks[configuration / 8 * links + link];
        let motion = DualQuat::from_array(block.get(configuration % 8).unwrap());
        close(motion, pose, POSES, &format!("{what}, blocks"));
    }
}

#[test]
fn nothing_is_computed_of_nothing() {
    let owned = OwnedMechanism::<f64>::new(&[]).unwrap();
    let no_poses: &mut [DualQuat<f64>] = &mut [];
    let no_values: &[f64] = &[];
    for backend in Backend::available() {
        owned.job().backend(backend).poses(no_values, no_poses).unwrap();
        let hinge = [Joint::revolute(None, DualQuat::IDENTITY, [0.0, 0.0, 1.0])];
        let hinge = OwnedMechanism::new(&hinge).unwrap();
        hinge.job().backend(backend).poses(no_values, no_poses).unwrap();
        hinge.job().links(&[0]).backend(backend).poses(no_values, no_poses).unwrap();
        // No values, but links.
        let up = DualQuat::from_translation([0.0, 0.0, 2.0]);
        let post = OwnedMechanism::new(&[Joint::fixed(None, up)]).unwrap();
        let mut poses = [DualQuat::IDENTITY; 5];
        post.job().backend(backend).poses(no_values, &mut poses).unwrap();
        assert_eq!(poses, [up; 5], "{backend}");
    }
}

#[test]
fn an_angle_that_is_no_number_spoils_its_own_configuration_alone() {
    let turn = |parent| Joint::revolute(parent, DualQuat::IDENTITY, [0.0_f32, 1.0, 0.0]);
    let owned = OwnedMechanism::new(&[turn(None), turn(Some(0))]).unwrap();
    for bad in [f32::NAN, f32::INFINITY, 1e9] {
        for backend in Backend::available() {
            let mut values = [0.5_f32; 2 * 19];
            values[2 * 7 + 1] = bad;
            let mut poses = [DualQuat::IDENTITY; 2 * 19];
            owned.job().backend(backend).poses(&values, &mut poses).unwrap();
            for (index, pose) in poses.iter().enumerate() {
                let spoilt = pose.to_array().iter().any(|number| number.is_nan());
                assert_eq!(spoilt, index == 2 * 7 + 1, "{backend}, {bad}, {index}");
            }
        }
    }
}

/// An `f32` angle of 10⁴ radians is known to 5·10⁻⁴, but what is given is taken as exact.
#[test]
fn angles_many_turns_away_are_as_exact_as_near_ones() {
    let hinge = [Joint::revolute(None, DualQuat::IDENTITY, [0.0_f64, 0.0, 1.0])];
    let single = mechanism::<f32>(&hinge);
    let mut random = Random(6);
    let angles: Vec<f32> = (0..10_000).map(|_| (1e4 * random.signed()) as f32).collect();
    let exact: Vec<f64> = angles.iter().map(|&angle| f64::from(angle)).collect();
    let wanted = wanted(&hinge, &exact, exact.len());
    for backend in Backend::available() {
        let mut poses = vec![DualQuat::IDENTITY; angles.len()];
        single.job().backend(backend).poses(&angles, &mut poses).unwrap();
        for (pose, wanted) in poses.iter().zip(&wanted) {
            // Five units of 2⁻²⁴. What is left of the angle, up to π/2, is rounded twice. Near π/2, where
            // terms of size 1.2 cancel, the cosine adds the rounding of the square, of the inner sum
            // times 2.5, and, where nothing fuses, of the last product: three more.
            let error = (0..8).map(|i| f64::from(pose.to_array()[i]) - wanted.to_array()[i]);
            let error = error.map(f64::abs).fold(0.0, f64::max);
            assert!(error < 5.0 / f64::from(1 << 24), "{backend}: {error}");
        }
    }
}

const NOTHING: Twist<f64> = Twist { angular: [0.0; 3], linear: [0.0; 3] };

fn close_twists(found: &[[f64; 6]], wanted: &[Twist<f64>], what: &str) {
    assert_eq!(found.len(), wanted.len());
    for (found, wanted) in found.iter().zip(wanted) {
        for (found, wanted) in found.iter().zip(wanted.to_array()) {
            let error = (found - wanted).abs() / (1.0 + wanted.abs());
            assert!(error < TWISTS, "{what}: {found} for {wanted}");
        }
    }
}

fn jacobians_agree<F: JacobianFrame>(frame: F) {
    let mut random = Random(8);
    for count in 1..25 {
        let joints = tree(&mut random, count);
        let configurations = [1, 3, 4, 9, 16, 21][count % 6];
        let values: Vec<f64> =
            (0..configurations).flat_map(|_| values(&mut random, &joints)).collect();
        let owned = mechanism::<f64>(&joints);
        let (robot, book, link) = (owned.view(), Book::new(&joints), random.below(count));
        if robot.values() == 0 {
            continue;
        }
        let mut wanted = vec![NOTHING; configurations * robot.rates()];
        let tools: Vec<_> = values
            .chunks_exact(robot.values())
            .zip(wanted.chunks_exact_mut(robot.rates()))
            .map(|(values, columns)| book.link_jacobian(frame, values, link, columns))
            .collect();
        for backend in Backend::available() {
            let what = format!("{backend}, {frame:?}, {count} joints, link {link}");
            let job = robot.job().backend(backend);
            let mut poses = vec![DualQuat::IDENTITY; configurations];
            let mut columns = vec![[f64::NAN; 6]; wanted.len()];
            job.links(&[link]).jacobians(frame, &values, &mut poses, &mut columns).unwrap();
            close_twists(&columns, &wanted, &what);
            for (&pose, &tool) in poses.iter().zip(&tools) {
                close(pose, tool, POSES, &what);
            }
            // Several links at once, one of them twice: to the last bit what each has alone.
            let links = [link, count - 1, random.below(count), link];
            let mut several = vec![DualQuat::IDENTITY; 4 * configurations];
            let mut all_columns = vec![[f64::NAN; 6]; 4 * wanted.len()];
            job.links(&links).jacobians(frame, &values, &mut several, &mut all_columns).unwrap();
            for (index, link) in links.into_iter().enumerate() {
                job.links(&[link]).jacobians(frame, &values, &mut poses, &mut columns).unwrap();
                let of_link = several.iter().skip(index).step_by(4);
                assert!(of_link.eq(&poses), "{what}, number {index} of {links:?}");
                let of_link = all_columns.chunks_exact(robot.rates()).skip(index).step_by(4);
                assert!(of_link.flatten().eq(&columns), "{what}, number {index} of {links:?}");
            }
        }
    }
}

#[test]
fn jacobians_on_lanes_are_those_of_one_configuration_in_every_frame() {
    jacobians_agree(World);
    jacobians_agree(Body);
    jacobians_agree(WorldAligned);
}

#[test]
fn velocities_and_accelerations_on_lanes_are_those_of_one_configuration() {
    let mut random = Random(9);
    for count in 1..25 {
        let joints = tree(&mut random, count);
        let configurations = [1, 3, 4, 9, 16, 21][count % 6];
        let values: Vec<f64> =
            (0..configurations).flat_map(|_| values(&mut random, &joints)).collect();
        let owned = mechanism::<f64>(&joints);
        let robot = owned.view();
        if robot.values() == 0 {
            continue;
        }
        let mut next = |_| random.signed();
        let rates: Vec<f64> = (0..configurations * robot.rates()).map(&mut next).collect();
        let second: Vec<f64> = (0..configurations * robot.rates()).map(&mut next).collect();
        let links = configurations * count;
        let mut wanted_poses = vec![DualQuat::IDENTITY; links];
        let (mut wanted, mut wanted_second) = (vec![NOTHING; links], vec![NOTHING; links]);
        for configuration in 0..configurations {
            let of = |all: usize| configuration * all..(configuration + 1) * all;
            robot
                .link_accelerations(
                    &values[of(robot.values())],
                    &rates[of(robot.rates())],
                    &second[of(robot.rates())],
                    &mut wanted_poses[of(count)],
                    &mut wanted[of(count)],
                    &mut wanted_second[of(count)],
                )
                .unwrap();
        }
        for backend in Backend::available() {
            let what = format!("{backend}, {count} joints");
            let mut poses = vec![DualQuat::IDENTITY; links];
            let [mut twists, mut changes, mut alone] = [(); 3].map(|()| vec![[f64::NAN; 6]; links]);
            let job = robot.job().backend(backend);
            job.accelerations(&values, &rates, &second, &mut poses, &mut twists, &mut changes)
                .unwrap();
            close_twists(&twists, &wanted, &what);
            close_twists(&changes, &wanted_second, &what);
            for (&pose, &wanted) in poses.iter().zip(&wanted_poses) {
                close(pose, wanted, POSES, &what);
            }
            job.velocities(&values, &rates, &mut poses, &mut alone).unwrap();
            assert_eq!(alone, twists, "{what}");
        }
    }
}

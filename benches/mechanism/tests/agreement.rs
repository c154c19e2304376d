//! dq8's poses of links are those of the crate `k`, which has another reader of files and another
//! algebra: for the robots of the repository and for random trees, within 10⁻¹² of the rotation
//! and 10⁻¹² · max(1, |t|) of the translation t.

use dq8::DualQuat;
use dq8_fixtures::random::Random;
use dq8_robot::urdf::Robot;
use std::fmt::Write;
use std::path::Path;

const BOUND: f64 = 1e-12;

fn vector(random: &mut Random, size: f64) -> [f64; 3] {
    random.vector().map(|number| size * number)
}

fn written([x, y, z]: [f64; 3]) -> String {
    format!("\"{x:?} {y:?} {z:?}\"")
}

/// A tree whose joints stand in the file in any order. k follows a mimic to one joint and no
/// farther, and refuses values beyond limits.
fn tree(random: &mut Random, joints: usize) -> String {
    let size = [0.5, 30.0][random.below(2)];
    let mut elements: Vec<String> = Vec::new();
    // Those that move by a value of their own.
    let mut movers: Vec<usize> = Vec::new();
    for joint in 0..joints {
        let kind = ["revolute", "continuous", "prismatic", "fixed"][random.below(4)];
        let parent = random.below(joint + 1);
        let child = joint + 1;
        let mut element = format!(
            "<link name=\"l{child}\"/><joint name=\"j{joint}\" type=\"{kind}\"><parent link=\"l{parent}\"/>\
             <child link=\"l{child}\"/><origin xyz={} rpy={}/>",
            written(vector(random, size)),
            written(vector(random, 3.2)),
        );
        if kind != "fixed" {
            // Any length but zero.
            let mut axis = vector(random, 2.0);
            axis[random.below(3)] += 2.5;
            let _ = write!(element, "<axis xyz={}/>", written(axis));
            let mimics = !movers.is_empty() && random.below(4) == 0;
            if mimics {
                let other = movers[random.below(movers.len())];
                let [multiplier, offset, _] = vector(random, 2.0);
                let _ = write!(
                    element,
                    "<mimic joint=\"j{other}\" multiplier=\"{multiplier:?}\" offset=\"{offset:?}\"/>"
                );
            } else {
                movers.push(joint);
            }
            let limit = if mimics { 99.0 } else { 3.0 };
            if kind != "continuous" {
                let _ = write!(
                    element,
                    "<limit lower=\"-{limit}\" upper=\"{limit}\" effort=\"1\" velocity=\"1\"/>"
                );
            }
        }
        element += "</joint>\n";
        elements.insert(random.below(elements.len() + 1), element);
    }
    format!("<robot name=\"tree\"><link name=\"l0\"/>{}</robot>", elements.concat())
}

/// Holds the poses of all links at random values within the limits to k's; how many there were.
fn compare(path: &Path, random: &mut Random, configurations: usize) -> usize {
    let name = path.display();
    let robot = Robot::from_file(path).unwrap_or_else(|error| panic!("{name}: {error}"));
    let chain = k::Chain::<f64>::from_urdf_file(path).expect("a robot");
    let (links, limits) = (robot.link_names(), robot.value_limits());
    let mut values = Vec::new();
    for _ in 0..configurations {
        values.extend(limits.iter().map(|limits| {
            let [low, high] = limits.unwrap_or([-3.0, 3.0]);
            random.between(low, high)
        }));
    }
    let mut poses = vec![DualQuat::IDENTITY; configurations * links.len()];
    robot.mechanism().job().poses(&values, &mut poses).expect("shape");
    for (configuration, poses) in poses.chunks_exact(links.len()).enumerate() {
        let values = &values[configuration * limits.len()..][..limits.len()];
        for (joint, &value) in robot.value_names().iter().zip(values) {
            let node = chain.find(joint).unwrap_or_else(|| panic!("{name}: no {joint}"));
            node.set_joint_position(value).expect("within the limits");
        }
        chain.update_transforms();
        for (link, pose) in links.iter().zip(poses) {
            let node = chain.find_link(link).unwrap_or_else(|| panic!("{name}: no {link}"));
            let theirs = node.world_transform().expect("updated");
            let place: [f64; 3] = theirs.translation.vector.into();
            let turn: [f64; 4] = theirs.rotation.coords.into();
            let ours = pose.rotation().to_array();
            // A rotation and its negative are one.
            let sign = ours.iter().zip(turn).map(|(a, b)| a * b).sum::<f64>().signum();
            let far = |a: &[f64], b: &[f64]| {
                a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
            };
            let turned = far(&ours, &turn.map(|number| sign * number));
            let moved = far(&pose.translation(), &place);
            let length = place.iter().map(|x| x * x).sum::<f64>().sqrt();
            assert!(
                turned <= BOUND && moved <= BOUND * length.max(1.0),
                "{name}, {link}: {turned:e} of the rotation, {moved:e} of {length}"
            );
        }
    }
    poses.len()
}

#[test]
fn links_of_the_robots_of_the_repository_are_where_k_has_them() {
    let robots = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../robot/robots");
    for (file, links) in [("arm6", 8), ("arm7", 11), ("humanoid", 35)] {
        let path = robots.join(file).with_extension("urdf");
        assert_eq!(compare(&path, &mut Random(1), 101), 101 * links, "{file}");
    }
}

#[test]
fn links_of_random_trees_are_where_k_has_them() {
    let mut random = Random(2);
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("tree.urdf");
    let mut kinds = String::new();
    for _ in 0..60 {
        let joints = 1 + random.below(40);
        let text = tree(&mut random, joints);
        std::fs::write(&path, &text).expect("a file");
        assert_eq!(compare(&path, &mut random, 9), 9 * (joints + 1));
        kinds += &text;
    }
    std::fs::remove_file(&path).expect("the file");
    for what in ["\"revolute\"", "\"continuous\"", "\"prismatic\"", "\"fixed\"", "<mimic"] {
        assert!(kinds.matches(what).count() > 30, "{what}");
    }
}

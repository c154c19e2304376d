//! The peer k, on the URDF files of this repository: all links, fixed ones too.

use dq8::{Backend, DualQuat};
use dq8_urdf::Robot;
use std::hint::black_box;
use std::time::Instant;

const CONFIGURATIONS: usize = 1000;

/// Nanoseconds per configuration of both, once they agree.
pub fn file(name: &str, backend: Backend, rounds: usize) -> [(&'static str, f64); 2] {
    let path = format!("{}/../../urdf/robots/{name}.urdf", env!("CARGO_MANIFEST_DIR"));
    let robot = Robot::from_file(&path).expect("a robot");
    let chain = k::Chain::<f64>::from_urdf_file(&path).expect("a robot");
    let (mechanism, count) = (robot.mechanism(), robot.mechanism().values());
    let links = mechanism.links();
    let values: Vec<f64> =
        (0..CONFIGURATIONS * count).map(|i| 0.02 + 0.01 * (i as f64).sin()).collect();
    let mut poses = vec![DualQuat::IDENTITY; CONFIGURATIONS * links];
    // The order in which the peer wants the values.
    let order: Vec<usize> = chain
        .iter_joints()
        .map(|joint| {
            let name = joint.name.clone();
            robot.value_names().iter().position(|other| *other == name).expect("the same joints")
        })
        .collect();
    let theirs: Vec<f64> = values
        .chunks_exact(count)
        .flat_map(|values| order.iter().map(|&value| values[value]))
        .collect();
    backend.link_poses(mechanism, &values, &mut poses).expect("shape");
    for (values, poses) in theirs.chunks_exact(order.len()).zip(poses.chunks_exact(links)) {
        chain.set_joint_positions_unchecked(values);
        chain.update_transforms();
        for node in chain.iter() {
            let link = node.link().as_ref().map(|link| link.name.clone());
            let Some(link) = link.and_then(|name| robot.link(&name)) else { continue };
            let at = node.world_transform().expect("updated").translation;
            let [x, y, z] = poses[link].translation();
            let error = (at.x - x).abs().max((at.y - y).abs()).max((at.z - z).abs());
            assert!(error < 1e-14, "{name}: {error}");
        }
    }
    let mut least = [("dq8: all poses, plain", f64::INFINITY), ("k: all poses", f64::INFINITY)];
    for _ in 0..rounds {
        let start = Instant::now();
        backend.link_poses(mechanism, black_box(&values), &mut poses).expect("shape");
        let ours = start.elapsed();
        let start = Instant::now();
        for values in black_box(&theirs).chunks_exact(order.len()) {
            chain.set_joint_positions_unchecked(values);
            black_box(chain.update_transforms());
        }
        for (least, time) in least.iter_mut().zip([ours, start.elapsed()]) {
            least.1 = least.1.min(time.as_secs_f64() * 1e9 / CONFIGURATIONS as f64);
        }
    }
    least
}

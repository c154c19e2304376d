//! The crate k: it keeps poses in the nodes of a tree and hands out copies.

use super::agree;
use crate::urdf;
use dq8::DualQuat;
use dq8_fixtures::turns::Job;
use std::hint::black_box;
use std::path::Path;

pub fn jobs<'a>(path: &Path, values: &'a [f64], expected: &[DualQuat<f64>]) -> Vec<Job<'a>> {
    let chain = k::Chain::<f64>::from_urdf_file(path).expect("a robot");
    let links = chain.dof();
    // The order of k's values is that of its own tree.
    let order: Vec<usize> = chain
        .iter_joints()
        .filter_map(|joint| (0..links).find(|&link| joint.name == urdf::name(link)))
        .collect();
    let values: Vec<f64> = values
        .chunks_exact(links)
        .flat_map(|values| order.iter().map(|&link| values[link]))
        .collect();
    let mut poses = Vec::new();
    for values in values.chunks_exact(links) {
        chain.set_joint_positions(values).expect("no limits");
        chain.update_transforms();
        poses.extend((0..links).map(|link| {
            let node = chain.find_link(&urdf::name(link)).expect("a link");
            let pose = node.world_transform().expect("updated");
            (pose.translation.vector.into(), pose.rotation.coords.into())
        }));
    }
    agree("k", 1e-12, expected, &poses);
    vec![Job::new("k: all poses", move || {
        for values in black_box(&values).chunks_exact(links) {
            chain.set_joint_positions(values).expect("no limits");
            black_box(chain.update_transforms());
        }
    })]
}

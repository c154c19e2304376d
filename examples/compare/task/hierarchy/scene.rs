//! [`Scene`]: skeletons and their poses.

use crate::memory::{Many, flat};
use crate::representation::Representation;
use crate::rows::Rows3x4;
use crate::{skeleton, walk};
use dq8::{DualQuat, Hierarchy};

#[derive(Clone, Copy)]
pub(crate) enum Shape {
    /// Of 64 joints.
    Crowd { instances: usize },
    /// One, of 21.
    Biped,
    /// One, of a thousand joints in a row.
    Chain,
}

/// The biped of the example `mocap`, links and tips: parents, and metres from them. Two arms, two
/// legs.
const BIPED: [(u32, f64); 21] = {
    const ROOT: u32 = Hierarchy::ROOT;
    [
        (ROOT, 0.0),
        (0, 0.10),
        (1, 0.17),
        (2, 0.30),
        (3, 0.24),
        (2, 0.30),
        (5, 0.30),
        (6, 0.26),
        (7, 0.17),
        (2, 0.30),
        (9, 0.30),
        (10, 0.26),
        (11, 0.17),
        (0, 0.09),
        (13, 0.44),
        (14, 0.44),
        (15, 0.21),
        (0, 0.09),
        (17, 0.44),
        (18, 0.44),
        (19, 0.21),
    ]
};
const CHAIN: u32 = 1000;
/// Metres between the joints of the chain.
const LINK: f64 = 0.1;

pub(super) struct Scene {
    pub(super) parents: Vec<u32>,
    pub(super) locals: Many<DualQuat<f32>>,
    /// Of each joint, from its parent; zero for roots.
    pub(super) bones: Vec<[f32; 3]>,
}

impl Scene {
    pub(super) fn new(shape: Shape) -> Self {
        let (parents, bones, instances) = match shape {
            Shape::Crowd { instances } => (skeleton::parents(), skeleton::bones(), instances),
            Shape::Biped => {
                let bone = |&(parent, length)| (parent != Hierarchy::ROOT).then_some(length);
                let parents = BIPED.iter().map(|&(parent, _)| parent).collect();
                (parents, BIPED.iter().map(bone).collect(), 1)
            }
            Shape::Chain => {
                let parents = [Hierarchy::ROOT].into_iter().chain(0..CHAIN - 1).collect();
                let bones = (0..CHAIN).map(|joint| (joint > 0).then_some(LINK)).collect();
                (parents, bones, 1)
            }
        };
        let different = skeleton::locals(&bones, instances.min(Many::<DualQuat<f32>>::DIFFERENT));
        let bones = parents.iter().zip(&different).map(|(&parent, local)| match parent {
            Hierarchy::ROOT => [0.0; 3],
            _ => local.translation(),
        });
        Self {
            bones: bones.collect(),
            locals: Many::new(parents.len(), different, instances),
            parents,
        }
    }

    pub(super) fn rotations(&self) -> Many<[f32; 4]> {
        let (joints, locals) = (self.parents.len(), self.locals.different());
        let rotations = locals.iter().map(|local| local.rotation().to_array()).collect();
        Many::new(joints, rotations, self.locals.len() / joints)
    }

    /// Where each instance stands.
    pub(super) fn roots(&self) -> Many<DualQuat<f32>> {
        let joints = self.parents.len();
        let instances = self.locals.different().chunks(joints);
        let places = instances.map(|poses| DualQuat::from_translation(poses[0].translation()));
        Many::new(1, places.collect(), self.locals.len() / joints)
    }

    pub(super) fn expected(&self, hierarchy: &Hierarchy) -> Vec<Vec<f64>> {
        let different = self.locals.different().iter();
        let mut poses: Vec<_> = different.map(Rows3x4::<f64>::from_motion).collect();
        walk::local_to_model_in_place(hierarchy, &mut poses);
        poses.iter().map(|rows| flat(&rows.rows())).collect()
    }
}

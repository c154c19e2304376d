//! `Scene`: skeletons and their poses.

use crate::memory::{Element, Many, Representation, Rows3x4};
use crate::{skeleton, walk};
use dq8::{DualQuat, Hierarchy};
use mocap::biped;

#[derive(Clone, Copy)]
pub enum Shape {
    /// Of 64 joints.
    Crowd { instances: usize },
    /// One, the biped of the example `mocap`, links and tips.
    Biped,
    /// One, of so many joints in a row.
    Chain { joints: u32 },
    /// One, of [`MANY`] joints in so many chains.
    Chains { count: u32 },
    /// One, of [`MANY`] joints, with so many children each.
    Tree { children: u32 },
}

pub const MANY: u32 = 256;
/// Metres between the joints of chains and trees.
const LINK: f64 = 0.1;

impl Shape {
    /// The parents, and how far from them, in metres; `None` for roots.
    fn skeleton(self) -> (Vec<u32>, Vec<Option<f64>>) {
        let parents: Vec<u32> = match self {
            Self::Crowd { .. } => return (skeleton::parents(), skeleton::bones()),
            Self::Biped => {
                let clip = biped::clip();
                let bones = clip.joints.iter().map(|joint| {
                    let [x, y, z] = joint.offset;
                    joint.parent.map(|_| x.hypot(y).hypot(z))
                });
                return (clip.parents(), bones.collect());
            }
            Self::Chain { joints } => (0..joints).map(|joint| joint.wrapping_sub(1)).collect(),
            Self::Chains { count } => {
                let parent = |joint: u32| joint.checked_sub(count).unwrap_or(Hierarchy::ROOT);
                (0..MANY).map(parent).collect()
            }
            Self::Tree { children } => {
                let before = |joint: u32| joint.checked_sub(1).map(|before| before / children);
                (0..MANY).map(|joint| before(joint).unwrap_or(Hierarchy::ROOT)).collect()
            }
        };
        let bone = |&parent: &u32| (parent != Hierarchy::ROOT).then_some(LINK);
        let bones = parents.iter().map(bone).collect();
        (parents, bones)
    }
}

pub struct Scene {
    pub parents: Vec<u32>,
    pub locals: Many<DualQuat<f32>>,
    /// Of each joint, from its parent; zero for roots.
    pub bones: Vec<[f32; 3]>,
}

impl Scene {
    pub fn new(shape: Shape) -> Self {
        let (parents, bones) = shape.skeleton();
        let instances = if let Shape::Crowd { instances } = shape { instances } else { 1 };
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

    pub fn rotations(&self) -> Many<[f32; 4]> {
        let (joints, locals) = (self.parents.len(), self.locals.different());
        let rotations = locals.iter().map(|local| local.rotation().to_array()).collect();
        Many::new(joints, rotations, self.locals.len() / joints)
    }

    /// Where each instance stands.
    pub fn roots(&self) -> Many<DualQuat<f32>> {
        let joints = self.parents.len();
        let instances = self.locals.different().chunks(joints);
        let places = instances.map(|poses| DualQuat::from_translation(poses[0].translation()));
        Many::new(1, places.collect(), self.locals.len() / joints)
    }

    pub fn expected(&self, hierarchy: &Hierarchy) -> Vec<Vec<f64>> {
        let different = self.locals.different().iter();
        let mut poses: Vec<_> = different.map(Rows3x4::<f64>::from_motion).collect();
        walk::local_to_model_in_place(hierarchy, &mut poses);
        poses.iter().map(|rows| rows.numbers(0)).collect()
    }
}

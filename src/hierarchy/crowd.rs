use super::Block;
use super::packing::{blocks_for, pack, unpack, whole_instances};
use crate::error::ShapeError;
use crate::real::Real;
use crate::scalar::DualQuat;
use alloc::vec;
use alloc::vec::Vec;
use dq8_simd::Row;

/// Poses of many instances of one skeleton, in blocks of `N` lanes: lanes are instances.
///
/// ```
/// use dq8::{Crowd, DualQuat, Hierarchy};
/// let parents = [Hierarchy::ROOT, 0];
/// let skeleton = Hierarchy::new(&parents)?;
/// let step = DualQuat::from_translation([0.0_f32, 1.0, 0.0]);
/// // Eleven instances: one full block of eight lanes and three lanes of the next.
/// let mut crowd = Crowd::<f32, 8>::from_slice(2, &[step; 11 * 2])?;
/// skeleton.local_to_model_in_place(crowd.blocks_mut())?;
/// assert_eq!(crowd.get(10, 1).unwrap().translation(), [0.0, 2.0, 0.0]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Crowd<R, const N: usize> {
    blocks: Vec<Block<R, N>>,
    joints: usize,
    instances: usize,
}

impl<R: Real, const N: usize> Crowd<R, N>
where
    [R; N]: Row<Real = R>,
{
    /// All joints of all instances at the identity.
    ///
    /// # Panics
    /// If the memory cannot be allocated, as for any `Vec`.
    #[must_use]
    pub fn new(joints: usize, instances: usize) -> Self {
        let identity = Block::splat(DualQuat::IDENTITY.to_array());
        Self { blocks: vec![identity; blocks_for::<N>(joints, instances)], joints, instances }
    }

    /// From `[instance][joint]`.
    ///
    /// # Errors
    /// If `poses` holds no whole number of instances.
    pub fn from_slice(joints: usize, poses: &[DualQuat<R>]) -> Result<Self, ShapeError> {
        let mut crowd = Self::new(joints, whole_instances("poses", joints, poses.len())?);
        pack(joints, poses, &mut crowd.blocks)?;
        Ok(crowd)
    }

    /// Into `[instance][joint]`.
    ///
    /// # Errors
    /// If `poses` is not `instances` · `joints` long; it is untouched then.
    pub fn copy_to_slice(&self, poses: &mut [DualQuat<R>]) -> Result<(), ShapeError> {
        let (length, expected) = (poses.len(), self.instances * self.joints);
        if length != expected {
            return Err(ShapeError::Length { what: "poses", length, expected });
        }
        unpack(self.joints, &self.blocks, poses)
    }

    /// As `[instance][joint]`.
    #[must_use]
    pub fn to_vec(&self) -> Vec<DualQuat<R>> {
        let mut poses = vec![DualQuat::IDENTITY; self.instances * self.joints];
        // The length is right by construction.
        let _ = unpack(self.joints, &self.blocks, &mut poses);
        poses
    }

    /// How many joints an instance has.
    #[must_use]
    pub fn joints(&self) -> usize {
        self.joints
    }

    /// How many instances there are.
    #[must_use]
    pub fn instances(&self) -> usize {
        self.instances
    }

    /// `[instance block][joint]`, for [`Hierarchy`](super::Hierarchy) and kernels of your own.
    #[must_use]
    pub fn blocks(&self) -> &[Block<R, N>] {
        &self.blocks
    }

    /// `[instance block][joint]`. Lanes beyond the last instance hold the identity; keep them finite.
    #[must_use]
    pub fn blocks_mut(&mut self) -> &mut [Block<R, N>] {
        &mut self.blocks
    }

    /// One pose; `None` beyond the last instance or joint.
    #[must_use]
    pub fn get(&self, instance: usize, joint: usize) -> Option<DualQuat<R>> {
        let index = self.index(instance, joint)?;
        self.blocks.get(index)?.get(instance % N).map(DualQuat::from_array)
    }

    /// Writes one pose.
    ///
    /// # Errors
    /// If there is no such instance or joint.
    pub fn set(
        &mut self,
        instance: usize,
        joint: usize,
        pose: DualQuat<R>,
    ) -> Result<(), ShapeError> {
        let missing =
            ShapeError::NoPose { instance, joint, instances: self.instances, joints: self.joints };
        let block = self.index(instance, joint).and_then(|index| self.blocks.get_mut(index));
        let Some(block) = block else { return Err(missing) };
        block.set(instance % N, pose.to_array()).map_err(|_| missing)
    }

    fn index(&self, instance: usize, joint: usize) -> Option<usize> {
        let inside = instance < self.instances && joint < self.joints;
        inside.then(|| instance / N * self.joints + joint)
    }
}

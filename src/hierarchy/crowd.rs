//! [`Crowd`]: blocks that own their memory, for many instances of one skeleton.

use crate::backend::Backend;
use crate::macros::brief;
use crate::number::Scalar;
use crate::scalar::DualQuat;
use crate::storage::shape::{ShapeError, same_length, whole_instances};
use crate::storage::{Aos, Block, Element, Pack, Unpack, blocks_for, identity};
use alloc::vec;
use alloc::vec::Vec;
use dq8_simd::Row;

/// Records of many instances of one skeleton, in blocks of `N` lanes. Each instance has a lane. A
/// record has `C` components of type `R`: 8 for a pose (the default), 4 for a rotation, 7 for a
/// rotation and a translation, 12 for a matrix (see [`storage`](crate::storage)).
///
/// ```
/// use dq8::{Crowd, DualQuat, Hierarchy, Quat, hierarchy::Bones};
/// let parents = [Hierarchy::ROOT, 0];
/// let skeleton = Hierarchy::new(&parents)?;
/// let step = DualQuat::from_translation([0.0_f32, 1.0, 0.0]);
/// // Eleven instances: one full block of eight lanes and three lanes of the next.
/// let mut crowd = Crowd::<f32, 8>::from_slice(2, &[step; 11 * 2])?;
/// skeleton.job().local_to_model_in_place(crowd.blocks_mut())?;
/// assert_eq!(crowd.get(10, 1).unwrap().translation(), [0.0, 2.0, 0.0]);
/// // The same from rotations.
/// let turns = Crowd::<f32, 8, 4>::from_slice(2, &[Quat::IDENTITY; 11 * 2])?;
/// let locals = Bones { rotations: turns.blocks(), offsets: &[[0.0, 1.0, 0.0]; 2] };
/// skeleton.job().locals_to_model(locals, crowd.blocks_mut())?;
/// assert_eq!(crowd.get(10, 1).unwrap().translation(), [0.0, 2.0, 0.0]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone)]
pub struct Crowd<R, const N: usize, const C: usize = 8>
where
    [R; N]: Row<Real = R>,
{
    blocks: Vec<Block<R, N, C>>,
    joints: usize,
    instances: usize,
}

brief!([R, const N: usize, const C: usize] Crowd<R, N, C>, where [[R; N]: Row<Real = R>]: Crowd |it| {
    joints: it.joints, instances: it.instances, lanes: N, components: C,
});

impl<R: Scalar, const N: usize, const C: usize> Crowd<R, N, C>
where
    [R; N]: Row<Real = R>,
{
    /// Makes a crowd with all joints of all instances at the identity. Records that are not
    /// motions, rotations or matrices are zero.
    ///
    /// # Panics
    /// If the memory cannot be allocated, as for any `Vec`, or there are more blocks than a `usize`
    /// can count.
    #[must_use]
    pub fn new(joints: usize, instances: usize) -> Self {
        let blocks = vec![Block::splat(identity()); blocks_for::<N>(joints, instances)];
        Self { blocks, joints, instances }
    }

    /// Packs a slice `[instance][joint]` as [`pack`](crate::storage::pack) does.
    ///
    /// # Errors
    /// If the length of `things` is not a multiple of `joints`.
    pub fn from_slice<E>(joints: usize, things: &[E]) -> Result<Self, ShapeError>
    where
        E: Element<C, Layout = Aos<R>>,
    {
        let mut crowd = Self::new(joints, whole_instances("things", joints, things.len())?);
        Backend::best().run(Pack { stride: joints, things, blocks: &mut crowd.blocks });
        Ok(crowd)
    }

    /// Unpacks all records into a slice `[instance][joint]`.
    ///
    /// # Errors
    /// If `things` does not have `instances` · `joints` elements; it is then untouched.
    pub fn copy_to_slice<E>(&self, things: &mut [E]) -> Result<(), ShapeError>
    where
        E: Element<C, Layout = Aos<R>>,
    {
        same_length("things", things.len(), self.instances * self.joints)?;
        self.unpack(things);
        Ok(())
    }

    /// The number of joints of an instance.
    #[must_use]
    pub fn joints(&self) -> usize {
        self.joints
    }

    /// The number of instances.
    #[must_use]
    pub fn instances(&self) -> usize {
        self.instances
    }

    /// The blocks as `[instance block][joint]`, for [`Hierarchy`](super::Hierarchy) and for your
    /// kernels.
    #[must_use]
    pub fn blocks(&self) -> &[Block<R, N, C>] {
        &self.blocks
    }

    /// The blocks as `[instance block][joint]`, to be written. Lanes beyond the last instance hold
    /// the identity; values that you write to these lanes must be finite.
    #[must_use]
    pub fn blocks_mut(&mut self) -> &mut [Block<R, N, C>] {
        &mut self.blocks
    }

    /// Returns the record of a joint of an instance; `None` if there is no such instance or joint.
    #[must_use]
    pub fn record(&self, instance: usize, joint: usize) -> Option<[R; C]> {
        self.blocks.get(self.index(instance, joint)?)?.get(instance % N)
    }

    /// Writes the record of a joint of an instance.
    ///
    /// # Errors
    /// If there is no such instance or joint.
    pub fn set_record(
        &mut self,
        instance: usize,
        joint: usize,
        record: [R; C],
    ) -> Result<(), ShapeError> {
        let missing =
            ShapeError::NoPose { instance, joint, instances: self.instances, joints: self.joints };
        let block = self.index(instance, joint).and_then(|index| self.blocks.get_mut(index));
        let Some(block) = block else { return Err(missing) };
        block.set(instance % N, record).map_err(|_| missing)
    }

    /// Unpacks all records into `things`, whose length has been checked.
    fn unpack<E>(&self, things: &mut [E])
    where
        E: Element<C, Layout = Aos<R>>,
    {
        Backend::best().run(Unpack { stride: self.joints, blocks: &self.blocks, things });
    }

    fn index(&self, instance: usize, joint: usize) -> Option<usize> {
        let inside = instance < self.instances && joint < self.joints;
        inside.then(|| instance / N * self.joints + joint)
    }
}

impl<R: Scalar, const N: usize> Crowd<R, N>
where
    [R; N]: Row<Real = R>,
{
    /// Makes a crowd of the poses that `pose` returns for each instance and joint, in this order.
    ///
    /// # Panics
    /// If the memory cannot be allocated; see [`new`](Self::new).
    ///
    /// ```
    /// use dq8::{Crowd, DualQuat};
    /// let at = |instance, joint| DualQuat::from_translation([instance as f32, joint as f32, 0.0]);
    /// let mut crowd = Crowd::<f32, 8>::from_fn(2, 3, at);
    /// crowd.set_instance(1, &[at(7, 0), at(7, 1)])?;
    /// let elbows = crowd.iter().map(|mut joints| joints.nth(1).unwrap().translation());
    /// assert!(elbows.eq([[0.0, 1.0, 0.0], [7.0, 1.0, 0.0], [2.0, 1.0, 0.0]]));
    /// # Ok::<(), dq8::ShapeError>(())
    /// ```
    #[must_use]
    pub fn from_fn(
        joints: usize,
        instances: usize,
        mut pose: impl FnMut(usize, usize) -> DualQuat<R>,
    ) -> Self {
        let mut crowd = Self::new(joints, instances);
        for instance in 0..instances {
            for joint in 0..joints {
                // The instance and the joint exist, so `set` returns no error.
                let _ = crowd.set(instance, joint, pose(instance, joint));
            }
        }
        crowd
    }

    /// Iterates over the instances. Each item is an iterator over the poses of one instance, as
    /// [`instance`](Self::instance) returns it.
    pub fn iter(
        &self,
    ) -> impl ExactSizeIterator<Item = impl ExactSizeIterator<Item = DualQuat<R>>> {
        (0..self.instances).map(|instance| self.instance(instance))
    }

    /// Writes the poses of one instance, in the order of joints.
    ///
    /// # Errors
    /// If there is no such instance, or `poses` does not have one pose for each joint; nothing is
    /// written.
    pub fn set_instance(
        &mut self,
        instance: usize,
        poses: &[DualQuat<R>],
    ) -> Result<(), ShapeError> {
        same_length("poses", poses.len(), self.joints)?;
        if instance >= self.instances {
            let (instances, joints) = (self.instances, self.joints);
            return Err(ShapeError::NoPose { instance, joint: 0, instances, joints });
        }
        poses.iter().enumerate().try_for_each(|(joint, &pose)| self.set(instance, joint, pose))
    }

    /// Unpacks all poses into a vector `[instance][joint]`.
    #[must_use]
    pub fn to_vec(&self) -> Vec<DualQuat<R>> {
        let mut poses = vec![DualQuat::IDENTITY; self.instances * self.joints];
        self.unpack(&mut poses);
        poses
    }

    /// Iterates over the poses of one instance, in the order of joints; empty if there is no such
    /// instance.
    ///
    /// ```
    /// use dq8::{Crowd, DualQuat};
    /// let steps = [1.0_f32, 2.0, 3.0, 4.0].map(|x| DualQuat::from_translation([x, 0.0, 0.0]));
    /// let pairs = Crowd::<f32, 8>::from_slice(2, &steps)?;
    /// assert!(pairs.instance(1).eq([steps[2], steps[3]]));
    /// # Ok::<(), dq8::ShapeError>(())
    /// ```
    pub fn instance(&self, instance: usize) -> impl ExactSizeIterator<Item = DualQuat<R>> + '_ {
        let joints = if instance < self.instances { self.joints } else { 0 };
        (0..joints).map(move |joint| self.get(instance, joint).unwrap_or_default())
    }

    /// Returns the pose of a joint of an instance; `None` if there is no such instance or joint.
    #[must_use]
    pub fn get(&self, instance: usize, joint: usize) -> Option<DualQuat<R>> {
        self.record(instance, joint).map(DualQuat::from_array)
    }

    /// Writes the pose of a joint of an instance.
    ///
    /// # Errors
    /// If there is no such instance or joint.
    pub fn set(
        &mut self,
        instance: usize,
        joint: usize,
        pose: DualQuat<R>,
    ) -> Result<(), ShapeError> {
        self.set_record(instance, joint, pose.to_array())
    }
}

/// Crowds are equal if their numbers of joints and instances and their records are equal. Lanes
/// without an instance are not compared.
impl<R: Scalar, const N: usize, const C: usize> PartialEq for Crowd<R, N, C>
where
    [R; N]: Row<Real = R>,
{
    fn eq(&self, other: &Self) -> bool {
        let of = |crowd: &Self| (crowd.joints, crowd.instances);
        let mut places = (0..self.instances).flat_map(|i| (0..self.joints).map(move |j| (i, j)));
        of(self) == of(other) && places.all(|(i, j)| self.record(i, j) == other.record(i, j))
    }
}

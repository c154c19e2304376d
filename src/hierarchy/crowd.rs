//! [`Crowd`]: owned blocks for many instances of one skeleton.

use crate::backend::Backend;
use crate::macros::brief;
use crate::number::Scalar;
use crate::scalar::DualQuat;
use crate::storage::shape::{ShapeError, same_length, whole_instances};
use crate::storage::{Aos, Block, Element, Pack, Unpack, blocks_for, identity};
use alloc::vec;
use alloc::vec::Vec;
use dq8_simd::Row;

/// Things of many instances of one skeleton, in blocks of `N` lanes: lanes are instances. Poses,
/// unless another number of components `C` says otherwise: 4 for rotations, 7 for rotations and
/// translations, 12 for matrices (see [`storage`](crate::storage)).
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
    /// All joints of all instances at the identity (at zero, for what is not a motion, a rotation
    /// or a matrix).
    ///
    /// # Panics
    /// If the memory cannot be allocated, as for any `Vec`; so also if there are more blocks than a
    /// `usize` can count.
    #[must_use]
    pub fn new(joints: usize, instances: usize) -> Self {
        let blocks = vec![Block::splat(identity()); blocks_for::<N>(joints, instances)];
        Self { blocks, joints, instances }
    }

    /// Packs `[instance][joint]`, as [`pack`](crate::storage::pack) does.
    ///
    /// # Errors
    /// If `things` holds no whole number of instances.
    pub fn from_slice<E>(joints: usize, things: &[E]) -> Result<Self, ShapeError>
    where
        E: Element<C, Layout = Aos<R>>,
    {
        let mut crowd = Self::new(joints, whole_instances("things", joints, things.len())?);
        Backend::best().run(Pack { stride: joints, things, blocks: &mut crowd.blocks });
        Ok(crowd)
    }

    /// Unpacks into `[instance][joint]`.
    ///
    /// # Errors
    /// If `things` is not `instances` · `joints` long; it is untouched then.
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

    /// `[instance block][joint]`, for [`Hierarchy`](super::Hierarchy) and kernels of your own.
    #[must_use]
    pub fn blocks(&self) -> &[Block<R, N, C>] {
        &self.blocks
    }

    /// `[instance block][joint]`. Lanes beyond the last instance hold the identity; keep them
    /// finite.
    #[must_use]
    pub fn blocks_mut(&mut self) -> &mut [Block<R, N, C>] {
        &mut self.blocks
    }

    /// The numbers of one joint of one instance; `None` beyond the last of either.
    #[must_use]
    pub fn record(&self, instance: usize, joint: usize) -> Option<[R; C]> {
        self.blocks.get(self.index(instance, joint)?)?.get(instance % N)
    }

    /// Writes the numbers of one joint of one instance.
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

    /// Unpacks into as many things as there are.
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
    /// Each pose by its instance and joint.
    ///
    /// # Panics
    /// As [`new`](Self::new).
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
                // There is such a pose.
                let _ = crowd.set(instance, joint, pose(instance, joint));
            }
        }
        crowd
    }

    /// The poses of each [`instance`](Self::instance).
    pub fn iter(
        &self,
    ) -> impl ExactSizeIterator<Item = impl ExactSizeIterator<Item = DualQuat<R>>> {
        (0..self.instances).map(|instance| self.instance(instance))
    }

    /// Writes the poses of one instance, joint by joint.
    ///
    /// # Errors
    /// If there is no such instance, or not one pose for each joint; nothing is written then.
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

    /// As `[instance][joint]`.
    #[must_use]
    pub fn to_vec(&self) -> Vec<DualQuat<R>> {
        let mut poses = vec![DualQuat::IDENTITY; self.instances * self.joints];
        self.unpack(&mut poses);
        poses
    }

    /// The poses of one instance, joint by joint; none beyond the last.
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

    /// The pose of a joint of an instance; `None` beyond the last instance or joint.
    #[must_use]
    pub fn get(&self, instance: usize, joint: usize) -> Option<DualQuat<R>> {
        self.record(instance, joint).map(DualQuat::from_array)
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
        self.set_record(instance, joint, pose.to_array())
    }
}

/// Equal if joints, instances and their numbers are; lanes without an instance do not count.
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

//! [`Contender`]: a way to concatenate a hierarchy. [`Own`] is this crate's, [`Peer`] the loop that
//! users of another representation write.

use crate::representation::{Representation, Rows};
use crate::walk;
use dq8::{Block, DualQuat, Hierarchy, Pose};
use dq8_simd::Row;
use std::marker::PhantomData;

pub(crate) trait Contender {
    /// What lies in memory for one joint, of one instance or of several.
    type Element: Copy;

    /// From `[instance][joint]`.
    fn pack(joints: usize, locals: &[DualQuat<f32>]) -> Vec<Self::Element>;
    /// Back to `[instance][joint]`; there may be more instances than were packed.
    fn unpack(joints: usize, models: &[Self::Element]) -> Vec<Rows>;

    fn local_to_model(h: &Hierarchy, locals: &[Self::Element], models: &mut [Self::Element]);
    fn local_to_model_in_place(h: &Hierarchy, poses: &mut [Self::Element]);
}

pub(crate) struct Own<P>(PhantomData<P>);

impl<P: Packed> Contender for Own<P> {
    type Element = P;

    fn pack(joints: usize, locals: &[DualQuat<f32>]) -> Vec<P> {
        P::pack(joints, locals)
    }
    fn unpack(joints: usize, models: &[P]) -> Vec<Rows> {
        let rows = |motion: DualQuat<f32>| motion.to_matrix3x4().map(|row| row.map(f64::from));
        P::unpack(joints, models).into_iter().map(rows).collect()
    }
    fn local_to_model(h: &Hierarchy, locals: &[P], models: &mut [P]) {
        h.local_to_model(locals, models).expect("whole instances");
    }
    fn local_to_model_in_place(h: &Hierarchy, poses: &mut [P]) {
        h.local_to_model_in_place(poses).expect("whole instances");
    }
}

/// A [`Pose`] that can be made from scalar ones.
pub(crate) trait Packed: Pose {
    fn pack(joints: usize, locals: &[DualQuat<f32>]) -> Vec<Self>;
    fn unpack(joints: usize, models: &[Self]) -> Vec<DualQuat<f32>>;
}

impl Packed for DualQuat<f32> {
    fn pack(_: usize, locals: &[DualQuat<f32>]) -> Vec<Self> {
        locals.to_vec()
    }
    fn unpack(_: usize, models: &[Self]) -> Vec<DualQuat<f32>> {
        models.to_vec()
    }
}

impl<const N: usize> Packed for Block<f32, N>
where
    [f32; N]: Row<Real = f32>,
{
    fn pack(joints: usize, locals: &[DualQuat<f32>]) -> Vec<Self> {
        let instances = locals.len() / joints;
        let mut blocks = vec![Self::splat([0.0; 8]); instances.div_ceil(N) * joints];
        dq8::pack(joints, locals, &mut blocks).expect("whole instances");
        blocks
    }
    fn unpack(joints: usize, models: &[Self]) -> Vec<DualQuat<f32>> {
        let mut poses = vec![DualQuat::IDENTITY; models.len() * N];
        dq8::unpack(joints, models, &mut poses).expect("whole instances");
        poses
    }
}

pub(crate) struct Peer<M>(PhantomData<M>);

impl<M: Representation> Contender for Peer<M> {
    type Element = M;

    fn pack(_: usize, locals: &[DualQuat<f32>]) -> Vec<M> {
        locals.iter().map(M::from_motion).collect()
    }
    fn unpack(_: usize, models: &[M]) -> Vec<Rows> {
        models.iter().map(M::rows).collect()
    }
    fn local_to_model(h: &Hierarchy, locals: &[M], models: &mut [M]) {
        walk::local_to_model(h, locals, models);
    }
    fn local_to_model_in_place(h: &Hierarchy, poses: &mut [M]) {
        walk::local_to_model_in_place(h, poses);
    }
}

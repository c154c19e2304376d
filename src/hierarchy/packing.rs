//! Between slices of scalar poses and blocks of instances.

use super::Block;
use crate::error::ShapeError;
use crate::real::Real;
use crate::scalar::DualQuat;
use dq8_simd::Row;

/// Writes `poses`, `[instance][joint]`, into `blocks`, `[instance block][joint]`. Lanes of the last
/// blocks that have no instance hold the identity: a number that computing cannot slow down.
///
/// # Errors
/// If `poses` holds no whole number of instances, or `blocks` is not just large enough for them;
/// `blocks` is untouched.
///
/// ```
/// use dq8::{Block, DualQuat, pack, unpack};
/// let poses = [DualQuat::from_translation([1.0_f32, 2.0, 3.0]); 3 * 2]; // 3 instances, 2 joints
/// let mut blocks = [Block::<f32, 8>::splat([0.0; 8]); 2];
/// pack(2, &poses, &mut blocks)?;
/// assert_eq!(blocks[1].get(2), Some(poses[5].to_array()));
/// let mut back = [DualQuat::IDENTITY; 6];
/// unpack(2, &blocks, &mut back)?;
/// assert_eq!(back, poses);
/// # Ok::<(), dq8::ShapeError>(())
/// ```
pub fn pack<R: Real, const N: usize>(
    joints: usize,
    poses: &[DualQuat<R>],
    blocks: &mut [Block<R, N>],
) -> Result<(), ShapeError>
where
    [R; N]: Row<Real = R>,
{
    check::<N>("poses", joints, poses.len(), blocks.len())?;
    blocks.fill(Block::splat(DualQuat::IDENTITY.to_array()));
    for (index, pose) in poses.iter().enumerate() {
        let Some((block, lane)) = place::<N>(joints, index) else { break };
        if let Some(block) = blocks.get_mut(block) {
            let _ = block.set(lane, pose.to_array());
        }
    }
    Ok(())
}

/// Writes `blocks`, `[instance block][joint]`, into `poses`, `[instance][joint]`; the lanes beyond
/// the last instance are dropped.
///
/// # Errors
/// If `poses` holds no whole number of instances, or `blocks` is not just large enough for them;
/// `poses` is untouched.
pub fn unpack<R: Real, const N: usize>(
    joints: usize,
    blocks: &[Block<R, N>],
    poses: &mut [DualQuat<R>],
) -> Result<(), ShapeError>
where
    [R; N]: Row<Real = R>,
{
    check::<N>("poses", joints, poses.len(), blocks.len())?;
    for (index, pose) in poses.iter_mut().enumerate() {
        let Some((block, lane)) = place::<N>(joints, index) else { break };
        if let Some(record) = blocks.get(block).and_then(|block| block.get(lane)) {
            *pose = DualQuat::from_array(record);
        }
    }
    Ok(())
}

/// How many blocks `instances` of `joints` take.
pub(super) const fn blocks_for<const N: usize>(joints: usize, instances: usize) -> usize {
    instances.div_ceil(N) * joints
}

/// Block and lane of element `index` of `[instance][joint]`; `None` without joints. Lengths have been
/// checked, so that both always exist; the compiler need not know, and keeps no panic.
fn place<const N: usize>(joints: usize, index: usize) -> Option<(usize, usize)> {
    let (instance, joint) = (index.checked_div(joints)?, index.checked_rem(joints)?);
    Some((instance / N * joints + joint, instance % N))
}

fn check<const N: usize>(
    what: &'static str,
    joints: usize,
    poses: usize,
    blocks: usize,
) -> Result<(), ShapeError> {
    let instances = whole_instances(what, joints, poses)?;
    let expected = blocks_for::<N>(joints, instances);
    if blocks == expected {
        Ok(())
    } else {
        Err(ShapeError::Length { what: "blocks", length: blocks, expected })
    }
}

/// How many instances of `joints` joints `length` elements are.
pub(super) fn whole_instances(
    what: &'static str,
    joints: usize,
    length: usize,
) -> Result<usize, ShapeError> {
    // Divisions take long, and one instance is what most have.
    if length == joints && length > 0 {
        return Ok(1);
    }
    match length.checked_rem(joints) {
        Some(0) => Ok(length / joints),
        None if length == 0 => Ok(0),
        _ => Err(ShapeError::NotWhole { what, length, joints }),
    }
}

//! Conversion between slices of plain things and blocks, whose lanes are instances or segments of a
//! chain.

use super::{Block, Element, Tile, identity};
use crate::backend::{Backend, Kernel};
use crate::batch::vector;
use crate::number::Scalar;
use crate::storage::shape::{ShapeError, same_length, whole_instances};
use dq8_simd::{Lanes, Level, Row};

/// Writes `things`, `[instance][joint]`, into `blocks`, `[instance block][joint]`. Lanes of the
/// last blocks that have no instance hold the [`identity`], with which arithmetic is never slow.
///
/// Things may be motions, rotations, points, twists, matrices or scalars.
/// Pass 1 as `joints` for things that do not belong to a skeleton.
///
/// # Errors
/// If `things` does not hold a whole number of instances, or `blocks` has not exactly the length
/// that they need; `blocks` is untouched.
///
/// ```
/// use dq8::storage::{Block, pack, unpack};
/// use dq8::DualQuat;
/// let poses = [DualQuat::from_translation([1.0_f32, 2.0, 3.0]); 3 * 2]; // 3 instances, 2 joints
/// let mut blocks = [Block::<f32, 8>::splat([0.0; 8]); 2];
/// pack(2, &poses, &mut blocks)?;
/// assert_eq!(blocks[1].get(2), Some(poses[5].to_array()));
/// let mut back = [DualQuat::IDENTITY; 6];
/// unpack(2, &blocks, &mut back)?;
/// assert_eq!(back, poses);
/// # Ok::<(), dq8::ShapeError>(())
/// ```
pub fn pack<R: Scalar, E, const N: usize, const C: usize>(
    joints: usize,
    things: &[E],
    blocks: &mut [Block<R, N, C>],
) -> Result<(), ShapeError>
where
    [R; N]: Row<Real = R>,
    E: Element<C, Layout = super::Aos<R>>,
{
    let instances = whole_instances("things", joints, things.len())?;
    same_length("blocks", blocks.len(), blocks_for::<N>(joints, instances))?;
    Backend::best().run(Pack { stride: joints, things, blocks });
    Ok(())
}

/// Writes `blocks`, `[instance block][joint]`, into `things`, `[instance][joint]`; the lanes beyond
/// the last instance are dropped.
///
/// # Errors
/// If `things` does not hold a whole number of instances, or `blocks` has not exactly the length
/// that they need; `things` is untouched.
pub fn unpack<R: Scalar, E, const N: usize, const C: usize>(
    joints: usize,
    blocks: &[Block<R, N, C>],
    things: &mut [E],
) -> Result<(), ShapeError>
where
    [R; N]: Row<Real = R>,
    E: Element<C, Layout = super::Aos<R>>,
{
    let instances = whole_instances("things", joints, things.len())?;
    same_length("blocks", blocks.len(), blocks_for::<N>(joints, instances))?;
    Backend::best().run(Unpack { stride: joints, blocks, things });
    Ok(())
}

/// Writes a chain into blocks, a segment of `blocks.len()` links in each lane: link `i` is at lane
/// `i / blocks.len()` of block `i % blocks.len()`. Lanes beyond the last link hold the identity.
///
/// # Errors
/// If `blocks` does not have exactly the length that the links fill; `blocks` is untouched.
///
/// ```
/// use dq8::storage::{Block, pack_chain, unpack_chain};
/// use dq8::{Backend, DualQuat};
/// let rope = [DualQuat::from_translation([1.0_f32, 0.0, 0.0]); 10];
/// let mut blocks = [Block::<f32, 8>::splat([0.0; 8]); 2]; // ⌈10 / 8⌉
/// pack_chain(&rope, &mut blocks)?;
/// Backend::best().chain_products_in_place(&mut blocks);
/// let mut models = [DualQuat::IDENTITY; 10];
/// unpack_chain(&blocks, &mut models)?;
/// assert_eq!(models[9].translation(), [10.0, 0.0, 0.0]);
/// # Ok::<(), dq8::ShapeError>(())
/// ```
pub fn pack_chain<R: Scalar, E, const N: usize, const C: usize>(
    links: &[E],
    blocks: &mut [Block<R, N, C>],
) -> Result<(), ShapeError>
where
    [R; N]: Row<Real = R>,
    E: Element<C, Layout = super::Aos<R>>,
{
    same_length("blocks", blocks.len(), links.len().div_ceil(N))?;
    // A segment of the chain is packed as one instance, with a joint for each of its links.
    Backend::best().run(Pack { stride: blocks.len(), things: links, blocks });
    Ok(())
}

/// Writes the links of a chain from blocks in the order that [`pack_chain`] uses.
///
/// # Errors
/// If `blocks` does not have exactly the length that the links fill; `links` is untouched.
pub fn unpack_chain<R: Scalar, E, const N: usize, const C: usize>(
    blocks: &[Block<R, N, C>],
    links: &mut [E],
) -> Result<(), ShapeError>
where
    [R; N]: Row<Real = R>,
    E: Element<C, Layout = super::Aos<R>>,
{
    same_length("blocks", blocks.len(), links.len().div_ceil(N))?;
    Backend::best().run(Unpack { stride: blocks.len(), blocks, things: links });
    Ok(())
}

/// Returns the number of blocks that `instances` instances of `joints` joints take.
pub(crate) fn blocks_for<const N: usize>(joints: usize, instances: usize) -> usize {
    instances.div_ceil(N).saturating_mul(joints)
}

/// The kernel of [`pack`]: in each group of `N · stride` things, the thing
/// `lane · stride + joint` goes to the lane `lane` of the block `joint`. The caller has checked
/// the lengths.
pub(crate) struct Pack<'s, E, B> {
    pub(crate) stride: usize,
    pub(crate) things: &'s [E],
    pub(crate) blocks: &'s mut [B],
}

impl<R: Scalar, E, const N: usize, const C: usize> Kernel for Pack<'_, E, Block<R, N, C>>
where
    [R; N]: Row<Real = R>,
    E: Element<C, Layout = super::Aos<R>>,
{
    type Output = ();
    // The kernel consists of transposes, which AVX-512 makes slower: see `Aos::WIDE`.
    const WIDE: bool = false;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) {
        let Self { stride, things, blocks } = self;
        let padding = identity();
        for (group, blocks) in blocks.chunks_mut(stride.max(1)).enumerate() {
            for (joint, block) in blocks.iter_mut().enumerate() {
                for lane in (0..N).step_by(R::Lanes::<V>::LANES) {
                    let element = (group * N + lane) * stride + joint;
                    let tile = Tile { element, register: 0, stride: Some(stride) };
                    let components = E::load(level, things, tile, &padding).unwrap_or_else(
                        #[cfg_attr(not(opt_level_0), inline(always))]
                        || vector::splat(level, padding),
                    );
                    for (row, component) in block.0.iter_mut().zip(components) {
                        let lanes = row.as_mut().get_mut(lane..).unwrap_or_default();
                        for (slot, &number) in lanes.iter_mut().zip(component.to_array().as_ref()) {
                            *slot = number;
                        }
                    }
                }
            }
        }
    }
}

/// The kernel of [`unpack`]: the thing in each lane of each block goes back to the place from which
/// [`Pack`] takes it.
pub(crate) struct Unpack<'s, E, B> {
    pub(crate) stride: usize,
    pub(crate) blocks: &'s [B],
    pub(crate) things: &'s mut [E],
}

impl<R: Scalar, E, const N: usize, const C: usize> Kernel for Unpack<'_, E, Block<R, N, C>>
where
    [R; N]: Row<Real = R>,
    E: Element<C, Layout = super::Aos<R>>,
{
    type Output = ();
    const WIDE: bool = false;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) {
        let Self { stride, blocks, things } = self;
        for (group, blocks) in blocks.chunks(stride.max(1)).enumerate() {
            // A register may have more lanes than a block. The slice ends with the group, so that
            // the lanes beyond the block are dropped.
            let end = (group + 1).saturating_mul(N).saturating_mul(stride).min(things.len());
            let Some(things) = things.get_mut(..end) else { return };
            for (joint, block) in blocks.iter().enumerate() {
                for lane in (0..N).step_by(R::Lanes::<V>::LANES) {
                    let mut components: [R::Lanes<V>; C] = vector::splat(level, [R::ZERO; C]);
                    for (component, row) in components.iter_mut().zip(&block.0) {
                        let mut array = component.to_array();
                        let lanes = row.as_ref().get(lane..).unwrap_or_default();
                        for (slot, &number) in array.as_mut().iter_mut().zip(lanes) {
                            *slot = number;
                        }
                        *component = R::Lanes::<V>::load(level, &array);
                    }
                    let element = (group * N + lane) * stride + joint;
                    E::store(
                        components,
                        things,
                        Tile { element, register: 0, stride: Some(stride) },
                    );
                }
            }
        }
    }
}

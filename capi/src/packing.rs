//! Conversions of poses and of chains between plain arrays and blocks, and the size of a block.

use crate::memory::{Input, Output};
use crate::span::disjoint;
use crate::status::{Done, Status};
use dq8::simd::Row;
use dq8::storage::{self, Block};
use dq8::{DualQuat, Scalar, ShapeError};

/// # Safety
/// Each array must have as many elements as its count says. No other thread may use the output or
/// write the input during the call.
unsafe fn to_blocks<R: Scalar, const N: usize>(
    poses: *const R,
    pose_count: usize,
    blocks: *mut R,
    block_count: usize,
    run: impl FnOnce(&[DualQuat<R>], &mut [Block<R, N>]) -> Result<(), ShapeError>,
) -> Done
where
    [R; N]: Row<Real = R>,
{
    let poses = Input::<DualQuat<R>>::new(poses, pose_count)?;
    let blocks = Output::<Block<R, N>>::new(blocks, block_count)?;
    disjoint(&[blocks.span], &[poses.span])?;
    // SAFETY: the caller guarantees that each array has as many elements as its count says, and
    // `disjoint` has checked that the output does not overlap the input.
    unsafe { Ok(run(poses.slice(), blocks.slice())?) }
}

/// # Safety
/// Each array must have as many elements as its count says. No other thread may use the output or
/// write the input during the call.
unsafe fn from_blocks<R: Scalar, const N: usize>(
    blocks: *const R,
    block_count: usize,
    poses: *mut R,
    pose_count: usize,
    run: impl FnOnce(&[Block<R, N>], &mut [DualQuat<R>]) -> Result<(), ShapeError>,
) -> Done
where
    [R; N]: Row<Real = R>,
{
    let blocks = Input::<Block<R, N>>::new(blocks, block_count)?;
    let poses = Output::<DualQuat<R>>::new(poses, pose_count)?;
    disjoint(&[poses.span], &[blocks.span])?;
    // SAFETY: the caller guarantees that each array has as many elements as its count says, and
    // `disjoint` has checked that the output does not overlap the input.
    unsafe { Ok(run(blocks.slice(), poses.slice())?) }
}

/// Exports a function that converts a plain array to blocks, or blocks to a plain array, for both
/// lane counts of the element type.
macro_rules! export_packing {
    (
        $R:ident [$few:literal $many:literal]
        $(#[doc = $about:literal])*
        $name:ident($($argument:ident: $type:ty),* $(,)?) = $way:ident($($array:ident),*) by $run:expr
    ) => {
        $(#[doc = $about])*
        ///
        /// # Safety
        /// Each array must have the length that its count states. No other thread may use the
        /// output or write the input during the call.
        #[unsafe(export_name = concat!("dq8_", stringify!($name), "_", stringify!($R)))]
        pub unsafe extern "C" fn $name(lanes: usize, $($argument: $type),*) -> Status {
            Status::of(match lanes {
                // SAFETY: `$way` needs arrays of the stated lengths that no other thread uses,
                // which the caller guarantees.
                $few => unsafe { $way::<$R, $few>($($array,)* $run) },
                // SAFETY: `$way` needs arrays of the stated lengths that no other thread uses,
                // which the caller guarantees.
                $many => unsafe { $way::<$R, $many>($($array,)* $run) },
                _ => Err(Status::Lanes),
            })
        }
    };
}

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export_packing! { $R $lanes
            /// Packs plain poses into blocks. `poses` is `[instance][joint]`, and `blocks` is
            /// `[block of instances][joint]`, with `lanes` instances in a block. Lanes without an
            /// instance get the identity. Returns DQ8_STATUS_LENGTH_BLOCKS if `block_count` is not
            /// `joints` times the number of blocks of instances: the number of instances over
            /// `lanes`, rounded up.
            pack(
                joints: usize,
                poses: *const $R, pose_count: usize, blocks: *mut $R, block_count: usize,
            ) = to_blocks(poses, pose_count, blocks, block_count) by |poses, blocks| storage::pack(joints, poses, blocks)
        }
        export_packing! { $R $lanes
            /// Unpacks blocks into plain poses. This is the inverse of dq8_pack, and the arrays
            /// have the same shapes. Lanes after the last instance are ignored.
            unpack(
                joints: usize,
                blocks: *const $R, block_count: usize, poses: *mut $R, pose_count: usize,
            ) = from_blocks(blocks, block_count, poses, pose_count) by |blocks, poses| storage::unpack(joints, blocks, poses)
        }
        export_packing! { $R $lanes
            /// Packs the links of a chain into blocks. Each lane holds a segment of `block_count`
            /// links: link i goes to lane `i / block_count` of block `i % block_count`. Places
            /// after the last link get the identity. Returns DQ8_STATUS_LENGTH if `block_count` is
            /// not `link_count` over `lanes`, rounded up.
            pack_chain(
                links: *const $R, link_count: usize, blocks: *mut $R, block_count: usize,
            ) = to_blocks(links, link_count, blocks, block_count) by storage::pack_chain
        }
        export_packing! { $R $lanes
            /// Unpacks the blocks of a chain into plain links. This is the inverse of
            /// dq8_pack_chain.
            unpack_chain(
                blocks: *const $R, block_count: usize, links: *mut $R, link_count: usize,
            ) = from_blocks(blocks, block_count, links, link_count) by storage::unpack_chain
        }

        /// Returns the size of a block, counted in floats or doubles. It is `lanes` times
        /// `components`, rounded up to whole 64 bytes. A motion has 8 components, a point 3, a
        /// rotation 4, a rotation with a translation 7, and a matrix 12 or 16.
        #[unsafe(export_name = concat!("dq8_block_size_", stringify!($R)))]
        pub extern "C" fn block_size(lanes: usize, components: usize) -> usize {
            let line = 64 / size_of::<$R>();
            lanes.saturating_mul(components).div_ceil(line).saturating_mul(line)
        }
    };
}
for_both_numbers!(functions);

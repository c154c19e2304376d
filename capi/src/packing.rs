//! Between plain arrays of poses, or of the links of a chain, and blocks, and how large blocks are.

use crate::memory::{Input, Output};
use crate::span::apart;
use crate::status::{Done, Status};
use dq8::simd::Row;
use dq8::storage::{self, Block};
use dq8::{DualQuat, Scalar, ShapeError};

/// # Safety
/// As for [`Input::slice`] and [`Output::slice`].
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
    apart(&[blocks.span], &[poses.span])?;
    // SAFETY: promised, and apart.
    unsafe { Ok(run(poses.slice(), blocks.slice())?) }
}

/// # Safety
/// As for [`Input::slice`] and [`Output::slice`].
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
    apart(&[poses.span], &[blocks.span])?;
    // SAFETY: promised, and apart.
    unsafe { Ok(run(blocks.slice(), poses.slice())?) }
}

/// A function between plain arrays and blocks of either number of lanes.
macro_rules! export_packing {
    (
        $R:ident [$few:literal $many:literal]
        $(#[doc = $about:literal])*
        $name:ident($($argument:ident: $type:ty),* $(,)?) = $way:ident($($array:ident),*) by $run:expr
    ) => {
        $(#[doc = $about])*
        ///
        /// # Safety
        /// Arrays have the lengths named.
        #[unsafe(export_name = concat!("dq8_", stringify!($name), "_", stringify!($R)))]
        pub unsafe extern "C" fn $name(lanes: usize, $($argument: $type),*) -> Status {
            Status::of(match lanes {
                // SAFETY: promised.
                $few => unsafe { $way::<$R, $few>($($array,)* $run) },
                // SAFETY: promised.
                $many => unsafe { $way::<$R, $many>($($array,)* $run) },
                _ => Err(Status::Lanes),
            })
        }
    };
}

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export_packing! { $R $lanes
            /// Writes `poses`, `[instance][joint]`, into blocks of `lanes` instances,
            /// `[instance block][joint]`; lanes without an instance get the identity. `block_count`
            /// is `joints` times the number of instances over `lanes`, rounded up;
            /// DQ8_STATUS_LENGTH if it is not.
            pack(
                joints: usize,
                poses: *const $R, pose_count: usize, blocks: *mut $R, block_count: usize,
            ) = to_blocks(poses, pose_count, blocks, block_count) by |poses, blocks| storage::pack(joints, poses, blocks)
        }
        export_packing! { $R $lanes
            /// Writes blocks into `poses`, the other way round; lanes beyond the last instance are
            /// dropped.
            unpack(
                joints: usize,
                blocks: *const $R, block_count: usize, poses: *mut $R, pose_count: usize,
            ) = from_blocks(blocks, block_count, poses, pose_count) by |blocks, poses| storage::unpack(joints, blocks, poses)
        }
        export_packing! { $R $lanes
            /// Writes a chain into blocks, a segment of `block_count` links in each lane: link i is
            /// in lane `i / block_count` of block `i % block_count`. Lanes beyond the last link get
            /// the identity. `block_count` is `link_count` over `lanes`, rounded up;
            /// DQ8_STATUS_LENGTH if it is not.
            pack_chain(
                links: *const $R, link_count: usize, blocks: *mut $R, block_count: usize,
            ) = to_blocks(links, link_count, blocks, block_count) by storage::pack_chain
        }
        export_packing! { $R $lanes
            /// Writes blocks of a chain into `links`, the other way round.
            unpack_chain(
                blocks: *const $R, block_count: usize, links: *mut $R, link_count: usize,
            ) = from_blocks(blocks, block_count, links, link_count) by storage::unpack_chain
        }

        /// How many numbers one block takes that has `components` (8 in motions, 3 in points, 4 in
        /// rotations, 7 in rotations with translations, 12 or 16 in matrices) of each of `lanes`
        /// things: their product, rounded up to whole 64 bytes.
        #[unsafe(export_name = concat!("dq8_block_size_", stringify!($R)))]
        pub extern "C" fn block_size(lanes: usize, components: usize) -> usize {
            let line = 64 / size_of::<$R>();
            lanes.saturating_mul(components).div_ceil(line).saturating_mul(line)
        }
    };
}
for_both_numbers!(functions);

//! Between plain arrays of poses and blocks, and how large blocks are.

use crate::memory::{Input, Output};
use crate::status::{Done, Status};
use dq8::simd::Row;
use dq8::storage::{self, Block};
use dq8::{DualQuat, Scalar};

/// # Safety
/// As for [`Input::slice`] and [`Output::slice`].
unsafe fn pack<R: Scalar, const N: usize>(
    joints: usize,
    poses: *const R,
    pose_count: usize,
    blocks: *mut R,
    block_count: usize,
) -> Done
where
    [R; N]: Row<Real = R>,
{
    let poses = Input::<DualQuat<R>>::new(poses, pose_count)?;
    let blocks = Output::<Block<R, N>>::new(blocks, block_count)?;
    blocks.apart_from(&poses)?;
    // SAFETY: promised, and apart.
    unsafe { Ok(storage::pack(joints, poses.slice(), blocks.slice())?) }
}

/// # Safety
/// As for [`Input::slice`] and [`Output::slice`].
unsafe fn unpack<R: Scalar, const N: usize>(
    joints: usize,
    blocks: *const R,
    block_count: usize,
    poses: *mut R,
    pose_count: usize,
) -> Done
where
    [R; N]: Row<Real = R>,
{
    let blocks = Input::<Block<R, N>>::new(blocks, block_count)?;
    let poses = Output::<DualQuat<R>>::new(poses, pose_count)?;
    poses.apart_from(&blocks)?;
    // SAFETY: promised, and apart.
    unsafe { Ok(storage::unpack(joints, blocks.slice(), poses.slice())?) }
}

macro_rules! functions {
    ($R:ident [$few:literal $many:literal]) => {
        /// Writes `poses`, `[instance][joint]`, into blocks of `lanes` instances, `[instance block][joint]`;
        /// lanes without an instance get the identity. `block_count` is `joints` times the number of
        /// instances over `lanes`, rounded up; DQ8_STATUS_LENGTH if it is not.
        ///
        /// # Safety
        /// Arrays have the lengths named.
        #[unsafe(export_name = concat!("dq8_pack_", stringify!($R)))]
        pub unsafe extern "C" fn pack(
            lanes: usize,
            joints: usize,
            poses: *const $R,
            pose_count: usize,
            blocks: *mut $R,
            block_count: usize,
        ) -> Status {
            Status::of(match lanes {
                // SAFETY: promised.
                $few => unsafe {
                    super::pack::<$R, $few>(joints, poses, pose_count, blocks, block_count)
                },
                // SAFETY: promised.
                $many => unsafe {
                    super::pack::<$R, $many>(joints, poses, pose_count, blocks, block_count)
                },
                _ => Err(Status::Lanes),
            })
        }

        /// Writes blocks into `poses`, the other way round; lanes beyond the last instance are dropped.
        ///
        /// # Safety
        /// Arrays have the lengths named.
        #[unsafe(export_name = concat!("dq8_unpack_", stringify!($R)))]
        pub unsafe extern "C" fn unpack(
            lanes: usize,
            joints: usize,
            blocks: *const $R,
            block_count: usize,
            poses: *mut $R,
            pose_count: usize,
        ) -> Status {
            Status::of(match lanes {
                // SAFETY: promised.
                $few => unsafe {
                    super::unpack::<$R, $few>(joints, blocks, block_count, poses, pose_count)
                },
                // SAFETY: promised.
                $many => unsafe {
                    super::unpack::<$R, $many>(joints, blocks, block_count, poses, pose_count)
                },
                _ => Err(Status::Lanes),
            })
        }

        /// How many numbers one block takes that has `components` (8 in motions, 3 in points, 4 in rotations,
        /// 7 in rotations with translations, 12 or 16 in matrices) of each of `lanes` things: their
        /// product, rounded up to whole 64 bytes.
        #[unsafe(export_name = concat!("dq8_block_size_", stringify!($R)))]
        pub extern "C" fn block_size(lanes: usize, components: usize) -> usize {
            let line = 64 / size_of::<$R>();
            lanes.saturating_mul(components).div_ceil(line).saturating_mul(line)
        }
    };
}
for_both_numbers!(functions);

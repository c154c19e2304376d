//! Kernels over arrays, plain and in blocks; and what takes one to the other.

use crate::argument::{Of, Read, Written, count, one_of, passes, reads, writes};
use crate::element::{Element, SCALED};
use dq8::hierarchy::MatrixOrder;
use dq8::internal::{for_each_kernel, record};
use dq8::storage::{self, Block, Layout};
use dq8::{Backend, DualQuat, Scalar};
use dq8_capi::{Status, chain, packing, slices, trajectory};
use dq8_trajectory::{Time, Trajectory, TrajectoryError};

fn order(order: i32) -> MatrixOrder {
    if order == 0 { MatrixOrder::Rows } else { MatrixOrder::Columns }
}

/// Kernels of the list: `n` elements, plain or in blocks of so many lanes.
macro_rules! of_each {
    ($list:ident $R:ident $of:ident $lanes:tt $n:ident $best:ident, $(
        $(#[doc = $brief:literal])+
        $name:ident $(as $c:literal)? [$($types:tt)*]
        ($input:ident: $kind:ident $I:ident $(, $other:ident: $others:ident $O:ident)* $(; $parameter:ident)?)
            -> $output:ident: $result:ident $Q:ident $(, in place $in_place:ident)? = $one:expr, {
            $($more:tt)*
        }
    )*) => {$(
        of_each! { @ $list $R $lanes $of $name [$name $($c)?] (
            $input: input!($kind $n), $($other: input!($others $n),)* $($parameter: passes(0.3),)?
            out: to::<{ record!($result) }>($n) $(.over(over!($in_place $input)))?, count: count($n),
        ) => $best.$name($input, $($other,)* $($parameter,)? out) }
    )*};
    (@ $list:ident $R:ident [] $of:ident $name:ident [$($c:tt)+] ($($arguments:tt)*) => $rust:expr) => {
        functions! { $list: concat!("dq8_", name!($($c)+), "_", stringify!($R)),
            slices::$of::$name = ($($arguments)*) => $rust; }
    };
    (@ $list:ident $R:ident [$lanes:literal] $of:ident $name:ident [$($c:tt)+]
        ($($arguments:tt)*) => $rust:expr) => {
        functions! { $list: concat!("dq8_blocks_", name!($($c)+), "_", stringify!($R)),
            slices::$of::blocks::$name = (lanes: crate::argument::lanes::<$R>($lanes), $($arguments)*)
                => $rust; }
    };
}

/// The name in C, without `dq8_` and the number type.
macro_rules! name {
    ($name:ident) => {
        stringify!($name)
    };
    ($name:ident $c:literal) => {
        $c
    };
}

macro_rules! input {
    (any $n:ident) => {
        scaled($n)
    };
    ($kind:ident $n:ident) => {
        of::<{ record!($kind) }>($n)
    };
}

macro_rules! over {
    ($in_place:ident $input:ident) => {
        stringify!($input)
    };
}

/// Poses on the trajectory, which is of doubles whatever the numbers are.
fn resampled<R: Scalar + Time>(
    times: &[R],
    poses: &[DualQuat<R>],
    at: &[R],
    out: &mut [DualQuat<R>],
) -> Result<(), TrajectoryError> {
    let stamps: Vec<f64> = times.iter().map(|&time| time.into()).collect();
    let double = |pose: &DualQuat<R>| DualQuat::from_array(pose.to_array().map(Into::into));
    let poses: Vec<_> = poses.iter().map(double).collect();
    Trajectory::new(&stamps, &poses)?.job().sample(at, out)
}

macro_rules! layout {
    ($shape:ident $list:ident $R:ident $of:ident $L:ty [$($lanes:literal)?]) => {{
        fn of<const C: usize>(count: usize) -> Of<<$L as Layout>::Record<C>, Read> {
            reads(count)
        }
        fn to<const C: usize>(count: usize) -> Of<<$L as Layout>::Record<C>, Written> {
            writes(count)
        }
        // Motions that are not unit.
        fn scaled(count: usize) -> Of<<$L as Layout>::Record<8>, Read> {
            of::<8>(count).of(|at| Element::sample(at, SCALED))
        }
        let n = $shape.count.div_ceil(<$L as Layout>::THINGS);
        let best = Backend::best();
        let orders = || one_of([0, 1]).wrong(2, Status::UnknownValue).wrong(-1, Status::UnknownValue);
        for_each_kernel!(of_each, $list $R $of [$($lanes)?] n best);
        of_arrays! { $list $R $of [$($lanes)?]:
            slices points blocks_points
                (motion: reads::<DualQuat<$R>>(1), points: of::<3>(n), out: to::<3>(n).over("points"), count: count(n))
                => best.transform_points(motion[0], points, out);
            slices vectors blocks_vectors
                (motion: reads::<DualQuat<$R>>(1), vectors: of::<3>(n), out: to::<3>(n).over("vectors"), count: count(n))
                => best.transform_vectors(motion[0], vectors, out);
            slices matrices_3x4 blocks_matrices_3x4
                (motions: of::<8>(n), by: orders(), out: to::<12>(n), count: count(n))
                => best.matrices(motions, order(by), out);
            slices matrices_4x4 blocks_matrices_4x4
                (motions: of::<8>(n), by: orders(), out: to::<16>(n), count: count(n))
                => best.matrices(motions, order(by), out);
            chain chain_products blocks_chain_products
                (links: of::<8>(n), out: to::<8>(n).over("links"), count: count(n))
                => best.chain_products(links, out);
        }
        layout! { @rest $shape $list $R $of [$($lanes)?] }
    }};
    (@rest $shape:ident $list:ident $R:ident $of:ident []) => {
        let (n, at) = ($shape.times.len(), $shape.count);
        let times = $shape.times.clone();
        of_numbers! { $list $R $of:
            "" trajectory resample (
                times: reads::<$R>(n).only(move |i| times[i] as $R)
                    .fault(Status::Times, Some(2), |times| times[2] = times[1])
                    .fault(Status::Times, Some(1), |times| times[1] = <$R>::INFINITY),
                poses: reads::<DualQuat<$R>>(n),
                pose_count: count(n).wrong(0, Status::FewPoses),
                at: reads::<$R>(at).only(|i| i as $R * 0.4 - 1.0)
                    .fault(Status::NotFinite, Some(1), |at| at[1] = <$R>::NAN),
                out: writes::<DualQuat<$R>>(at),
                count: count(at),
                bad_time: crate::argument::names(),
            ) => resampled(times, poses, at, out).map_err(|_| Status::FewPoses);
        }
    };
    (@rest $shape:ident $list:ident $R:ident $of:ident [$lanes:literal]) => {
        let (joints, n) = ($shape.parents.len(), $shape.poses());
        let blocks = $shape.instances.div_ceil($lanes) * joints;
        let links = n.div_ceil($lanes);
        type Blocks = Block<$R, $lanes>;
        let lanes = || crate::argument::lanes::<$R>($lanes);
        let joint_count = || {
            let no_instances = n % (joints + 1) != 0;
            passes(joints)
                .wrong_if(n > 0, 0, Status::LengthPoses)
                .wrong_if(no_instances, joints + 1, Status::LengthPoses)
        };
        of_numbers! { $list $R $of:
            "" packing pack (
                lanes: lanes(), joints: joint_count(),
                poses: reads::<DualQuat<$R>>(n), pose_count: count(n).wrong(n + 1, Status::LengthPoses),
                blocks: writes::<Blocks>(blocks), block_count: count(blocks).wrong(blocks + 1, Status::LengthBlocks),
            ) => storage::pack(joints, poses, blocks);
            "" packing unpack (
                lanes: lanes(), joints: joint_count(),
                blocks: reads::<Blocks>(blocks), block_count: count(blocks).wrong(blocks + 1, Status::LengthBlocks),
                poses: writes::<DualQuat<$R>>(n), pose_count: count(n).wrong(n + 1, Status::LengthPoses),
            ) => storage::unpack(joints, blocks, poses);
            "" packing pack_chain (
                lanes: lanes(), links: reads::<DualQuat<$R>>(n), link_count: count(n),
                blocks: writes::<Blocks>(links), block_count: count(links).wrong(links + 1, Status::LengthBlocks),
            ) => storage::pack_chain(links, blocks);
            "" packing unpack_chain (
                lanes: lanes(), blocks: reads::<Blocks>(links),
                block_count: count(links).wrong(links + 1, Status::LengthBlocks),
                links: writes::<DualQuat<$R>>(n), link_count: count(n),
            ) => storage::unpack_chain(blocks, links);
        }
    };
}
super::for_all_layouts!(layout);

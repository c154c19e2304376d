//! Poses and Jacobians of links for many configurations of a mechanism.

use crate::mechanism::{Checked, Frame, Mechanism};
use crate::memory::{Input, Output};
use crate::span::disjoint;
use crate::status::{Done, Status};
use dq8::storage::{AoSoA, Aos, Layout};
use dq8_robot::{Body, JointValues, World, WorldAligned};

/// # Safety
/// The mechanism must be zeroed, or made with steps that have not changed since. Each array must
/// have as many elements as its count says. No other thread may use the output or write the inputs
/// during the call.
unsafe fn link_poses<L: Layout>(
    mechanism: *const Mechanism<L::Real>,
    values: *const L::Real,
    value_count: usize,
    poses: *mut L::Real,
    count: usize,
) -> Done
where
    L::Real: JointValues<L>,
{
    // SAFETY: the caller guarantees that the mechanism is zeroed, or made with unchanged steps.
    let checked = unsafe { Checked::new(mechanism)? };
    let values = Input::<L::Real>::new(values, value_count)?;
    let poses = Output::<L::Record<8>>::new(poses, count)?;
    disjoint(&[poses.span], &[values.span, checked.given, checked.steps])?;
    // SAFETY: the caller guarantees that each array has as many elements as its count says, and
    // `disjoint` has checked that `poses` overlaps no input.
    unsafe { Ok(checked.known.job().poses(values.slice(), poses.slice())?) }
}

/// # Safety
/// The mechanism must be zeroed, or made with steps that have not changed since. Each array must
/// have as many elements as its count says, and `columns` must have `count` times the number of
/// rates. No other thread may use the
/// outputs or write the inputs during the call.
#[expect(clippy::too_many_arguments, reason = "one per line of the C function")]
unsafe fn link_jacobians<L: Layout>(
    mechanism: *const Mechanism<L::Real>,
    frame: i32,
    values: *const L::Real,
    value_count: usize,
    links: *const usize,
    link_count: usize,
    poses: *mut L::Real,
    columns: *mut L::Real,
    count: usize,
) -> Done
where
    L::Real: JointValues<L>,
{
    // SAFETY: the caller guarantees that the mechanism is zeroed, or was made here with steps that
    // have not changed since.
    let checked = unsafe { Checked::new(mechanism)? };
    let known = checked.known;
    let values = Input::<L::Real>::new(values, value_count)?;
    let links = Input::<usize>::new(links, link_count)?;
    let poses = Output::<L::Record<8>>::new(poses, count)?;
    let column_count = count.checked_mul(known.rates()).ok_or(Status::TooLarge)?;
    let columns = Output::<L::Record<6>>::new(columns, column_count)?;
    let read = [values.span, links.span, checked.given, checked.steps];
    disjoint(&[poses.span, columns.span], &read)?;
    // SAFETY: the caller guarantees that each array has as many elements as its count says, and
    // `disjoint` has checked that no output overlaps another array.
    let (values, links) = unsafe { (values.slice(), links.slice()) };
    let job = known.job().links(links);
    // SAFETY: as above.
    let (poses, columns) = unsafe { (poses.slice(), columns.slice()) };
    Ok(match frame {
        frame if frame == Frame::World as i32 => job.jacobians(World, values, poses, columns),
        frame if frame == Frame::Body as i32 => job.jacobians(Body, values, poses, columns),
        frame if frame == Frame::WorldAligned as i32 => {
            job.jacobians(WorldAligned, values, poses, columns)
        }
        _ => return Err(Status::UnknownValue),
    }?)
}

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export! { $R $lanes
            /// Computes the poses of all links for many configurations: forward kinematics.
            /// `values` is `[configuration][value]` and holds `value_count` values: the
            /// mechanism's number of values times the number of configurations. `poses` is
            /// `[configuration][link]` and holds `count` motions: the mechanism's number of
            /// links times the number of configurations.
            ///
            /// In blocks, `poses` is `[block of configurations][link]`, and `count` is the number
            /// of links times the number of blocks of configurations: the number of configurations
            /// over `lanes`, rounded up. `values` is a plain array in either case. Lanes without a
            /// configuration get the poses for values that are all zero. Returns
            /// DQ8_STATUS_LENGTH_VALUES if `value_count` and `count` belong to different numbers of
            /// configurations.
            link_poses, blocks_link_poses(
                mechanism: *const Mechanism<$R>, values: *const $R, value_count: usize,
                poses: *mut $R,
            )
        }
        export! { $R $lanes
            /// Computes the Jacobians and the poses of some links for many configurations.
            /// `links` holds the indices of `link_count` links. `values` is
            /// `[configuration][value]` and holds `value_count` values in all. `poses` is
            /// `[configuration][link]`, in the order of `links`, and holds `count` motions in all:
            /// `link_count` times the number of configurations. `columns` is
            /// `[configuration][link][rate]` and holds `count` times the mechanism's number of
            /// rates columns, of six components each, in `frame`, one of enum dq8_frame: see
            /// dq8_mechanism_link_jacobian.
            ///
            /// In blocks, `poses` and `columns` are `[block of configurations]` and so on, and
            /// `count` is `link_count` times the number of blocks of configurations. `values` is a
            /// plain array in either case. Returns DQ8_STATUS_NO_LINK, DQ8_STATUS_UNKNOWN_VALUE (of
            /// `frame`), DQ8_STATUS_LENGTH if `count` is no multiple of `link_count`, and
            /// DQ8_STATUS_LENGTH_VALUES if `value_count` belongs to another number of
            /// configurations than `count`.
            link_jacobians, blocks_link_jacobians(
                mechanism: *const Mechanism<$R>, frame: i32, values: *const $R,
                value_count: usize, links: *const usize, link_count: usize, poses: *mut $R,
                columns: *mut $R,
            )
        }
    };
}
for_both_numbers!(functions);

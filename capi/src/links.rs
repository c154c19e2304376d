//! Poses of links for many configurations of a mechanism.

use crate::mechanism::{Checked, Mechanism};
use crate::memory::{Input, Output};
use crate::span::disjoint;
use crate::status::{Done, Status};
use dq8::storage::{AoSoA, Aos, Layout};
use dq8_robot::JointValues;

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
            /// configuration get the poses for values that are all zero. Returns DQ8_STATUS_LENGTH
            /// if `value_count` and `count` belong to different numbers of configurations.
            link_poses, blocks_link_poses(
                mechanism: *const Mechanism<$R>, values: *const $R, value_count: usize,
                poses: *mut $R,
            )
        }
    };
}
for_both_numbers!(functions);

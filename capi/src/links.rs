//! Poses of links for many configurations of a mechanism.

use crate::mechanism::{Made, Mechanism};
use crate::memory::{Input, Output};
use crate::span::apart;
use crate::status::{Done, Status};
use dq8::storage::{AoSoA, Aos, Layout};
use dq8_robot::JointValues;

/// # Safety
/// As for [`Made::new`], [`Input::slice`] and [`Output::slice`].
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
    // SAFETY: promised.
    let made = unsafe { Made::new(mechanism)? };
    let values = Input::<L::Real>::new(values, value_count)?;
    let poses = Output::<L::Record<8>>::new(poses, count)?;
    apart(&[poses.span], &[values.span, made.given, made.steps])?;
    // SAFETY: promised, and apart.
    unsafe { Ok(made.known.job().poses(values.slice(), poses.slice())?) }
}

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export! { $R $lanes
            /// Forward kinematics of many configurations: `values` is `[configuration][value]`,
            /// `value_count` numbers in all: values of the mechanism times configurations. `poses`
            /// is `[configuration][link]`, `count` motions in all: links of the mechanism times
            /// configurations.
            ///
            /// In blocks, `poses` is `[block of configurations][link]`, `count` blocks in all:
            /// links times the number of configurations over `lanes`, rounded up; `values` are
            /// plain, as above. Lanes without a configuration get the poses of values that are all
            /// zero. DQ8_STATUS_LENGTH if `value_count` and `count` are not those of the same
            /// configurations.
            link_poses, blocks_link_poses(
                mechanism: *const Mechanism<$R>, values: *const $R, value_count: usize,
                poses: *mut $R,
            )
        }
    };
}
for_both_numbers!(functions);

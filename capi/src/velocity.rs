//! Joint hierarchies in motion: twists of all joints, and the Jacobian of one.

use crate::hierarchy::parents;
use crate::memory::{Input, Output};
use crate::span::apart;
use crate::status::{Done, Status};
use dq8::storage::{AoSoA, Aos, Layout};
use dq8::{Hierarchy, Twist};

/// # Safety
/// As for [`Input::slice`] and [`Output::slice`].
unsafe fn velocities<L: Layout>(
    parents: *const i32,
    joints: usize,
    models: *const L::Real,
    rates: *const L::Real,
    twists: *mut L::Real,
    count: usize,
) -> Done {
    let parents = self::parents(parents, joints)?;
    let models = Input::<L::Record<8>>::new(models, count)?;
    let rates = Input::<L::Record<6>>::new(rates, count)?;
    let twists = Output::<L::Record<6>>::new(twists, count)?;
    apart(&[twists.span], &[parents.span, models.span, rates.span])?;
    // SAFETY: promised, and apart.
    unsafe {
        let job = Hierarchy::new(parents.slice())?.job();
        Ok(job.velocities(models.slice(), rates.slice(), twists.slice())?)
    }
}

/// # Safety
/// As for [`Input::slice`] and [`Output::slice`].
unsafe fn jacobian<L: Layout>(
    parents: *const i32,
    joints: usize,
    models: *const L::Real,
    axes: *const L::Real,
    effector: usize,
    columns: *mut L::Real,
    count: usize,
) -> Done {
    let parents = self::parents(parents, joints)?;
    let models = Input::<L::Record<8>>::new(models, count)?;
    let axes = Input::<Twist<L::Real>>::new(axes, joints)?;
    let columns = Output::<L::Record<6>>::new(columns, count)?;
    apart(&[columns.span], &[parents.span, models.span, axes.span])?;
    if effector >= joints {
        return Err(Status::NoLink);
    }
    // SAFETY: promised, and apart.
    unsafe {
        let job = Hierarchy::new(parents.slice())?.job();
        Ok(job.jacobian(models.slice(), axes.slice(), effector, columns.slice())?)
    }
}

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export! { $R $lanes
            /// Spatial twists of all joints, six numbers each, angular part first, from unit model poses and
            /// `rates`, the body twist of each joint relative to its parent (of a hinge: its axis times its rate,
            /// and zeros): `twists[j] = twists[parents[j]] + Ad(models[j]) rates[j]`.
            ///
            /// `models`, `rates` and `twists` are `[instance][joint]`, `count` elements in all, as in
            /// dq8_local_to_model. Twists are in the frame that the models are in, about its origin.
            velocities, blocks_velocities(
                parents: *const i32, joints: usize,
                models: *const $R, rates: *const $R, twists: *mut $R,
            )
        }
        export! { $R $lanes
            /// The spatial Jacobian of joint `effector`: column j, six numbers, is the twist per rate of joint j,
            /// `Ad(models[j]) axes[j]`, for the effector and what it hangs from, and zero for all others.
            ///
            /// `axes` holds `joints` plain twists, the same for all instances: the body twist of each joint for a
            /// rate of 1. `models` and `columns` are `[instance][joint]`, `count` elements in all, as in
            /// dq8_local_to_model. DQ8_STATUS_NO_LINK if there is no such joint.
            jacobian, blocks_jacobian(
                parents: *const i32, joints: usize,
                models: *const $R, axes: *const $R, effector: usize, columns: *mut $R,
            )
        }
    };
}
for_both_numbers!(functions);

//! Plans: the order of joints in which one instance of a hierarchy is computed fastest.

use crate::hierarchy::checked;
use crate::memory::{Input, Output, from_to};
use crate::span::disjoint;
use crate::status::{Done, Status};
use dq8::hierarchy::{Plan, PlanScratch};
use dq8::{DualQuat, Hierarchy, Scalar};

/// Finds the order in which dq8_plan_local_to_model computes the joints of one instance fastest:
/// joints that others wait for come early, and between a joint and its parent there are others.
///
/// `order` holds two numbers per joint, and must not change while it is used. `scratch` holds six
/// numbers per joint, which are not needed afterwards. Errors of `parents` are those of
/// dq8_check_parents, with the joint in `bad_joint`, which may be null.
///
/// # Safety
/// Arrays must have the lengths that are named.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dq8_plan_make(
    parents: *const i32,
    joints: usize,
    order: *mut u32,
    scratch: *mut u32,
    bad_joint: *mut usize,
) -> Status {
    // SAFETY: the caller keeps the conditions under `# Safety`, which are those of the functions
    // called here.
    Status::of(unsafe { make(parents, joints, order, scratch, bad_joint) })
}

/// # Safety
/// The caller must keep the conditions of [`checked`] and [`Output::slice`].
unsafe fn make(
    parents: *const i32,
    joints: usize,
    order: *mut u32,
    scratch: *mut u32,
    bad_joint: *mut usize,
) -> Done {
    let parents = crate::hierarchy::parents(parents, joints)?;
    let order = Output::<[u32; 2]>::new(order, joints)?;
    let scratch = Output::<PlanScratch>::new(scratch, joints)?;
    let bad_joint = Output::unless_null(bad_joint)?;
    disjoint(&[order.span, scratch.span, bad_joint.span], &[parents.span])?;
    // SAFETY: the caller guarantees that the memory is valid, and the outputs have been checked to
    // overlap nothing.
    unsafe {
        let hierarchy = checked(&parents, &bad_joint)?;
        Plan::new(&hierarchy, order.slice(), scratch.slice())?;
    }
    Ok(())
}

/// # Safety
/// The caller must keep the conditions of [`from_to`], and [`Input::slice`] of `parents` and
/// `order`.
unsafe fn local_to_model<R: Scalar>(
    parents: *const i32,
    order: *const u32,
    joints: usize,
    locals: *const R,
    models: *mut R,
    count: usize,
) -> Done {
    let parents = crate::hierarchy::parents(parents, joints)?;
    let order = Input::<[u32; 2]>::new(order, joints)?;
    disjoint(&[Output::<DualQuat<R>>::new(models, count)?.span], &[parents.span, order.span])?;
    // SAFETY: the caller guarantees that both arrays are valid, and the outputs have been checked
    // to overlap neither.
    let (parents, order) = unsafe { (parents.slice(), order.slice()) };
    let hierarchy = Hierarchy::new(parents)?;
    let job = hierarchy.job().plan(&Plan::of_order(&hierarchy, order).or(Err(Status::NoPlan))?);
    let elsewhere = |from: &[DualQuat<R>], to: &mut [_]| job.local_to_model(from, to);
    // SAFETY: the caller keeps the conditions under `# Safety`, which are those of the functions
    // called here.
    unsafe { from_to(locals, models, count, elsewhere, |all| job.local_to_model_in_place(all)) }
}

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export_one! { $R
            /// Computes model poses like dq8_local_to_model, in the `order` that dq8_plan_make
            /// found for the same parents. This is the fastest way for one instance. Several
            /// instances are computed as by dq8_local_to_model: `count` is `joints` times the
            /// number of instances. `models` may be `locals`.
            ///
            /// Returns DQ8_STATUS_NO_PLAN if a pair of `order` is not a joint and its parent, or if
            /// a root comes after other joints. It does not notice if pairs have been exchanged.
            plan::local_to_model(
                parents: *const i32, order: *const u32, joints: usize, locals: *const $R,
                models: *mut $R, count: usize,
            ) = super::local_to_model(parents, order, joints, locals, models, count)
        }
    };
}
for_both_numbers!(functions);

//! Plans: the order of joints in which the model poses of one instance are computed fastest.

use crate::hierarchy::checked;
use crate::memory::{Input, Output, from_to};
use crate::span::disjoint;
use crate::status::{Done, Status};
use dq8::hierarchy::{Plan, PlanScratch};
use dq8::{DualQuat, Hierarchy, Scalar};

/// Finds the fastest order of joints for dq8_plan_local_to_model. Joints at the head of long chains
/// come early, and between a joint and its parent the order has other joints, so that the CPU need
/// not wait for the parent.
///
/// `order` holds two elements per joint, and must not change while it is used. `scratch` holds six
/// elements per joint, whose content is not needed afterwards. If `parents` is wrong, the function
/// returns the status of dq8_check_parents and sets `bad_joint`, which may be null, to the index of
/// the wrong joint.
///
/// # Safety
/// Each array must have the length that is stated. No other thread may use the outputs or write the
/// parents during the call.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dq8_plan_make(
    parents: *const i32,
    joints: usize,
    order: *mut u32,
    scratch: *mut u32,
    bad_joint: *mut usize,
) -> Status {
    // SAFETY: `make` needs arrays of the stated lengths that no other thread uses, which the caller
    // guarantees.
    Status::of(unsafe { make(parents, joints, order, scratch, bad_joint) })
}

/// # Safety
/// `parents` must have `joints` elements, `order` twice as many and `scratch` six times as many. No
/// other thread may use the outputs or write the parents during the call.
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
    // SAFETY: the caller guarantees the lengths of the arrays, and `disjoint` has checked that no
    // output overlaps another array.
    unsafe {
        let hierarchy = checked(&parents, &bad_joint)?;
        Plan::new(&hierarchy, order.slice(), scratch.slice())?;
    }
    Ok(())
}

/// # Safety
/// `parents` must have `joints` elements, `order` twice as many, and the poses `count` elements. No
/// other thread may use the output or write the inputs during the call.
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
    // SAFETY: the caller guarantees the lengths of both arrays, and `disjoint` has checked that the
    // output overlaps neither.
    let (parents, order) = unsafe { (parents.slice(), order.slice()) };
    let hierarchy = Hierarchy::new(parents)?;
    let job = hierarchy.job().plan(&Plan::of_order(&hierarchy, order).or(Err(Status::NoPlan))?);
    let elsewhere = |from: &[DualQuat<R>], to: &mut [_]| job.local_to_model(from, to);
    // SAFETY: the caller guarantees that both arrays of poses have `count` elements, and that no
    // other thread uses them.
    unsafe { from_to(locals, models, count, elsewhere, |all| job.local_to_model_in_place(all)) }
}

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export_one! { $R
            /// Computes model poses like dq8_local_to_model, in a faster order. `order` is the
            /// order that dq8_plan_make has found for the same parents. This is the fastest
            /// function for one instance. Several instances are computed in the order of
            /// dq8_local_to_model. `count` is `joints` times the number of instances. `models` may
            /// be `locals`.
            ///
            /// Returns DQ8_STATUS_NO_PLAN if a pair of `order` is not a joint and its parent, or if
            /// a root comes after other joints. The function does not notice whether pairs have
            /// changed places.
            plan::local_to_model(
                parents: *const i32, order: *const u32, joints: usize, locals: *const $R,
                models: *mut $R, count: usize,
            ) = super::local_to_model(parents, order, joints, locals, models, count)
        }
    };
}
for_both_numbers!(functions);

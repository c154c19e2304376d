//! Plans: the order in which one instance of a hierarchy is computed fastest, found once.

use crate::hierarchy::checked;
use crate::memory::{Input, Output, from_to};
use crate::span::apart;
use crate::status::{Done, Status};
use dq8::hierarchy::{Plan, PlanScratch};
use dq8::{DualQuat, Hierarchy, Scalar};

/// Finds the order in which dq8_plan_local_to_model computes the joints of one instance: those that
/// others wait for come early, and between a joint and its parent there are others.
///
/// `order` has two numbers per joint, and must stay as it is while it is used; `scratch` six, which
/// are not needed afterwards. A bad parent is told as by dq8_check_parents, and `bad_joint` set to
/// it, which may be null.
///
/// # Safety
/// Arrays have the lengths named.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dq8_plan_make(
    parents: *const i32,
    joints: usize,
    order: *mut u32,
    scratch: *mut u32,
    bad_joint: *mut usize,
) -> Status {
    // SAFETY: promised.
    Status::of(unsafe { make(parents, joints, order, scratch, bad_joint) })
}

/// # Safety
/// As for [`checked`] and [`Output::slice`].
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
    apart(&[order.span, scratch.span, bad_joint.span], &[parents.span])?;
    // SAFETY: promised, and apart.
    unsafe {
        let hierarchy = checked(&parents, &bad_joint)?;
        Plan::new(&hierarchy, order.slice(), scratch.slice())?;
    }
    Ok(())
}

/// # Safety
/// As for [`from_to`], and [`Input::slice`] of `parents` and `order`.
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
    apart(&[Output::<DualQuat<R>>::new(models, count)?.span], &[parents.span, order.span])?;
    // SAFETY: promised, and apart from what is written.
    let (parents, order) = unsafe { (parents.slice(), order.slice()) };
    let hierarchy = Hierarchy::new(parents)?;
    let job = hierarchy.job().plan(&Plan::of_order(&hierarchy, order).or(Err(Status::NoPlan))?);
    let elsewhere = |from: &[DualQuat<R>], to: &mut [_]| job.local_to_model(from, to);
    // SAFETY: promised.
    unsafe { from_to(locals, models, count, elsewhere, |all| job.local_to_model_in_place(all)) }
}

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export_one! { $R
            /// As dq8_local_to_model, joint by joint in the `order` that dq8_plan_make found for
            /// the same parents, with the eight numbers of a motion in one register: the fastest
            /// way for one instance. Several are computed as by dq8_local_to_model: `count` motions
            /// in all, `joints` times instances. `models` may be `locals`.
            ///
            /// DQ8_STATUS_NO_PLAN if a pair of `order` is not a joint and its parent, or a root
            /// stands behind other joints. An order whose pairs have changed places is not noticed.
            plan::local_to_model(
                parents: *const i32, order: *const u32, joints: usize, locals: *const $R,
                models: *mut $R, count: usize,
            ) = super::local_to_model(parents, order, joints, locals, models, count)
        }
    };
}
for_both_numbers!(functions);

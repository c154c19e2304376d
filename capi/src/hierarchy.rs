//! Joint hierarchies: model poses from local poses and back, and skinning palettes.

use crate::memory::{Input, Output, from_to};
use crate::span::disjoint;
use crate::status::{Done, Status};
use dq8::storage::{AoSoA, Aos, Layout};
use dq8::{
    DualQuat, Hierarchy, Job,
    hierarchy::{Bones, HierarchyError, Poses, Root as StandsOn, RotationsTranslations},
};

/// Checks the array of parents. C marks a root by -1, whose four bytes are those of
/// [`Hierarchy::ROOT`], so the array is read as `u32`.
pub(crate) fn parents(start: *const i32, joints: usize) -> Result<Input<u32>, Status> {
    Input::new(start, joints)
}

/// The motion of the root: an array of one element, or an empty array if C passes null.
type Root<L> = Input<DualQuat<<L as Layout>::Real>>;

/// Returns the job that computes poses in the hierarchy of these parents. If `root` holds a motion,
/// the job moves all joints without a parent by it.
///
/// # Safety
/// Both inputs must point to as many elements as they count, and no other thread may write these
/// elements while `'a` lasts.
unsafe fn job<'a, L: Layout>(
    parents: &Input<u32>,
    root: &Root<L>,
) -> Result<Job<'a, StandsOn<'a, L::Record<8>>>, Status> {
    // SAFETY: the caller guarantees that both inputs point to as many elements as they count, and
    // that no other thread writes these elements.
    let (parents, root) = unsafe { (parents.slice(), root.slice()) };
    let job = Hierarchy::new(parents)?.job();
    Ok(job.on(match *root {
        [root] => StandsOn::Same(root),
        _ => StandsOn::None,
    }))
}

/// Defines the function `$name`, which computes the poses `$to` from the poses `$from`. It calls
/// `$in_place` if both are the same array, and `$elsewhere` if they are not.
macro_rules! poses {
    ($name:ident($from:ident, $to:ident) by |$job:ident| $elsewhere:expr, $in_place:ident) => {
        /// # Safety
        /// Each array must have as many elements as its count says, and `root` must be null or a
        /// motion. No other thread may use the output or write the inputs during the call.
        unsafe fn $name<L: Layout>(
            parents: *const i32,
            joints: usize,
            root: *const L::Real,
            $from: *const L::Real,
            $to: *mut L::Real,
            count: usize,
        ) -> Done {
            let (parents, root) = (self::parents(parents, joints)?, Root::<L>::unless_null(root)?);
            let written = Output::<L::Record<8>>::new($to, count)?.span;
            disjoint(&[written], &[parents.span, root.span])?;
            // SAFETY: the caller guarantees that `parents` and `root` point to as many elements as
            // they count, and `disjoint` has checked that the output overlaps neither.
            let $job = unsafe { job::<L>(&parents, &root)? };
            // SAFETY: the caller guarantees that both arrays of poses have `count` elements, and
            // that no other thread uses them.
            unsafe { from_to($from, $to, count, $elsewhere, |all| $job.$in_place(all)) }
        }
    };
}
poses! {
    local_to_model(locals, models)
        by |job| |from: &[_], to: &mut [_]| job.locals_to_model(Poses(from), to), local_to_model_in_place
}
poses! {
    model_to_local(models, locals)
        by |job| |from: &[_], to: &mut [_]| job.model_to_local(from, to), model_to_local_in_place
}

/// # Safety
/// Each array must have as many elements as its count says, and `root` must be null or a motion. No
/// other thread may use the outputs or write the inputs during the call.
unsafe fn rotations_to_model<L: Layout>(
    parents: *const i32,
    joints: usize,
    root: *const L::Real,
    rotations: *const L::Real,
    offsets: *const L::Real,
    models: *mut L::Real,
    count: usize,
) -> Done {
    let (parents, root) = (self::parents(parents, joints)?, Root::<L>::unless_null(root)?);
    let rotations = Input::<L::Record<4>>::new(rotations, count)?;
    let offsets = Input::<[L::Real; 3]>::new(offsets, joints)?;
    let models = Output::new(models, count)?;
    disjoint(&[models.span], &[parents.span, root.span, rotations.span, offsets.span])?;
    // SAFETY: the caller guarantees that each array has as many elements as its count says, and
    // `disjoint` has checked that `models` overlaps no input.
    unsafe {
        let job = job::<L>(&parents, &root)?;
        let locals = Bones { rotations: rotations.slice(), offsets: offsets.slice() };
        Ok(job.locals_to_model(locals, models.slice())?)
    }
}

/// # Safety
/// Each array must have as many elements as its count says, and `root` must be null or a motion. No
/// other thread may use the outputs or write the inputs during the call.
unsafe fn rotations_translations_to_model<L: Layout>(
    parents: *const i32,
    joints: usize,
    root: *const L::Real,
    locals: *const L::Real,
    models: *mut L::Real,
    count: usize,
) -> Done {
    let (parents, root) = (self::parents(parents, joints)?, Root::<L>::unless_null(root)?);
    let locals = Input::<L::Record<7>>::new(locals, count)?;
    let models = Output::new(models, count)?;
    disjoint(&[models.span], &[parents.span, root.span, locals.span])?;
    // SAFETY: the caller guarantees that each array has as many elements as its count says, and
    // `disjoint` has checked that `models` overlaps no input.
    unsafe {
        let job = job::<L>(&parents, &root)?;
        Ok(job.locals_to_model(RotationsTranslations(locals.slice()), models.slice())?)
    }
}

/// Defines the function `$name`, which computes model poses and a palette whose entries have
/// `$count` components.
macro_rules! palettes {
    ($($name:ident of $count:literal;)+) => {$(
        /// # Safety
        /// Each array must have as many elements as its count says, and `root` must be null or a
        /// motion. No other thread may use the outputs or write the inputs during the call.
        #[expect(clippy::too_many_arguments, reason = "one per line of the C function")]
        unsafe fn $name<L: Layout>(
            parents: *const i32,
            joints: usize,
            root: *const L::Real,
            locals: *const L::Real,
            inverse_binds: *const L::Real,
            models: *mut L::Real,
            palette: *mut L::Real,
            count: usize,
        ) -> Done {
            let (parents, root) = (self::parents(parents, joints)?, Root::<L>::unless_null(root)?);
            let locals = Input::<L::Record<8>>::new(locals, count)?;
            let binds = Input::<DualQuat<L::Real>>::new(inverse_binds, joints)?;
            let models = Output::<L::Record<8>>::new(models, count)?;
            let palette = Output::<L::Record<$count>>::new(palette, count)?;
            let read = [parents.span, root.span, locals.span, binds.span];
            disjoint(&[models.span, palette.span], &read)?;
            // SAFETY: the caller guarantees that each array has as many elements as its count says,
            // and `disjoint` has checked that no output overlaps another array.
            unsafe {
                let (job, locals) = (job::<L>(&parents, &root)?, Poses(locals.slice()));
                let (models, palette) = (models.slice(), palette.slice());
                Ok(job.palette_and_models(locals, models, binds.slice(), palette)?)
            }
        }
    )+};
}
palettes! { palette of 8; palette_matrices of 12; }

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export! { $R $lanes
            /// Computes model poses from local poses: `models[j] = models[parents[j]] * locals[j]`.
            ///
            /// `parents` holds `joints` indices of parents, or -1 for a joint without a parent.
            /// `root` is a motion that moves all joints without a parent, or null. `locals` and
            /// `models` are `[instance][joint]` and hold `count` motions: `joints` times the number
            /// of instances. In blocks they are `[block of instances][joint]`, and `count` is
            /// `joints` times the number of blocks of instances: the number of instances over
            /// `lanes`, rounded up. `models` may be `locals`. Returns DQ8_STATUS_LENGTH if `count`
            /// is no multiple of `joints`.
            local_to_model, blocks_local_to_model(
                parents: *const i32, joints: usize, root: *const $R,
                locals: *const $R, models: *mut $R,
            )
        }
        export! { $R $lanes
            /// Computes local poses from unit model poses. This is the inverse of
            /// dq8_local_to_model, and the arrays have the same shapes. `locals` may be `models`.
            model_to_local, blocks_model_to_local(
                parents: *const i32, joints: usize, root: *const $R,
                models: *const $R, locals: *mut $R,
            )
        }
        export! { $R $lanes
            /// Computes model poses from rotations and fixed offsets. Animation clips often hold
            /// local poses in this form. `rotations` holds `count` unit quaternions (x, y, z, w).
            /// `offsets` holds `joints` translations (x, y, z): the position of each joint in its
            /// parent, which is the same in all instances. Other arguments and errors are those of
            /// dq8_local_to_model.
            rotations_to_model, blocks_rotations_to_model(
                parents: *const i32, joints: usize, root: *const $R,
                rotations: *const $R, offsets: *const $R, models: *mut $R,
            )
        }
        export! { $R $lanes
            /// Computes model poses from rotations and translations. `locals` holds `count` local
            /// poses of seven components: a unit quaternion (x, y, z, w), then a translation (x, y,
            /// z). Other arguments and errors are those of dq8_local_to_model.
            rotations_translations_to_model, blocks_rotations_translations_to_model(
                parents: *const i32, joints: usize, root: *const $R,
                locals: *const $R, models: *mut $R,
            )
        }
        export! { $R $lanes
            /// Computes model poses and the skinning palette in one pass. The model poses are those
            /// of dq8_local_to_model. The palette is `palette[j] = models[j] * inverse_binds[j]`,
            /// which moves the mesh at rest with joint j.
            ///
            /// `inverse_binds` holds `joints` plain motions, which are the same for all instances.
            /// `models` and `palette` hold `count` motions, like `locals`, and must not overlap any
            /// other array.
            palette, blocks_palette(
                parents: *const i32, joints: usize, root: *const $R,
                locals: *const $R, inverse_binds: *const $R, models: *mut $R, palette: *mut $R,
            )
        }
        export! { $R $lanes
            /// Computes model poses and the palette like dq8_palette, but with matrices in the
            /// palette. Each entry is a matrix `[R | t]` of twelve components, row by row.
            palette_matrices, blocks_palette_matrices(
                parents: *const i32, joints: usize, root: *const $R,
                locals: *const $R, inverse_binds: *const $R, models: *mut $R, palette: *mut $R,
            )
        }
    };
}
for_both_numbers!(functions);

/// Checks that `parents` is a hierarchy: `parents[j]`, the parent of joint j, is less than j, or
/// -1. Every function that takes parents makes the same check, which costs little beside its work.
/// This function also tells which joint is wrong.
///
/// Returns DQ8_STATUS_PARENT_NOT_BEFORE or _PARENT_OUT_OF_RANGE for the first joint whose parent is
/// wrong, and sets `bad_joint` to the index of this joint. `bad_joint` may be null, and must not
/// point into `parents`.
///
/// # Safety
/// `parents` must hold `joints` elements, and `bad_joint` must be null or point to a `usize` that
/// no other thread uses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dq8_check_parents(
    parents: *const i32,
    joints: usize,
    bad_joint: *mut usize,
) -> Status {
    // SAFETY: `check_parents` needs `joints` parents, and a `bad_joint` that is null or that no
    // other thread uses, which the caller guarantees.
    Status::of(unsafe { check_parents(parents, joints, bad_joint) })
}

/// # Safety
/// `start` must hold `joints` elements, and `bad_joint` must be null or point to a `usize` that no
/// other thread uses.
unsafe fn check_parents(start: *const i32, joints: usize, bad_joint: *mut usize) -> Done {
    let (parents, bad_joint) = (parents(start, joints)?, Output::unless_null(bad_joint)?);
    disjoint(&[bad_joint.span], &[parents.span])?;
    // SAFETY: the caller guarantees `joints` parents and a `bad_joint` that is null or points to a
    // `usize`, and `disjoint` has checked that the two do not overlap.
    unsafe { checked(&parents, &bad_joint).map(|_| ()) }
}

/// Returns the hierarchy of these parents. If a parent is wrong, the index of its joint is written
/// to `bad_joint`.
///
/// # Safety
/// `parents` must point to as many elements as it counts, and `bad_joint` must be null or point to
/// a `usize` outside of `parents`. No other thread may write either while `'a` lasts.
pub(crate) unsafe fn checked<'a>(
    parents: &Input<u32>,
    bad_joint: &Output<usize>,
) -> Result<Hierarchy<'a>, Status> {
    // SAFETY: the caller guarantees that `parents` points to as many elements as it counts, and
    // that these do not change.
    let hierarchy = Hierarchy::new(unsafe { parents.slice() });
    if let Err(
        HierarchyError::ParentNotBefore { joint, .. }
        | HierarchyError::ParentOutOfRange { joint, .. },
    ) = &hierarchy
    {
        // SAFETY: the caller guarantees that `bad_joint` is null or points to a `usize` outside of
        // `parents`.
        unsafe { bad_joint.write(*joint) };
    }
    Ok(hierarchy?)
}

//! Joint hierarchies: local poses to model space and back, and skinning palettes.

use crate::memory::{Input, Output, from_to};
use crate::span::disjoint;
use crate::status::{Done, Status};
use dq8::storage::{AoSoA, Aos, Layout};
use dq8::{
    DualQuat, Hierarchy, Job,
    hierarchy::{Bones, HierarchyError, Poses, Root as StandsOn, RotationsTranslations},
};

/// The array of parents. C marks a root by -1, whose four bytes are those of [`Hierarchy::ROOT`].
pub(crate) fn parents(start: *const i32, joints: usize) -> Result<Input<u32>, Status> {
    Input::new(start, joints)
}

/// The motion of the root, if C does not pass null.
type Root<L> = Input<DualQuat<<L as Layout>::Real>>;

/// The job that computes a hierarchy from a root.
///
/// # Safety
/// The caller must keep the conditions of [`Input::slice`].
unsafe fn job<'a, L: Layout>(
    parents: &Input<u32>,
    root: &Root<L>,
) -> Result<Job<'a, StandsOn<'a, L::Record<8>>>, Status> {
    // SAFETY: the caller keeps the conditions under `# Safety`, which are those of the functions
    // called here.
    let (parents, root) = unsafe { (parents.slice(), root.slice()) };
    let job = Hierarchy::new(parents)?.job();
    Ok(job.on(match *root {
        [root] => StandsOn::Same(root),
        _ => StandsOn::None,
    }))
}

/// Defines a function that computes poses from poses, either in another array or in place.
macro_rules! poses {
    ($name:ident($from:ident, $to:ident) by |$job:ident| $elsewhere:expr, $in_place:ident) => {
        /// # Safety
        /// The caller must keep the conditions of [`from_to`], and for `parents` and `root` those
        /// of [`job`].
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
            // SAFETY: the caller guarantees that both arrays are valid, and the outputs have been
            // checked to overlap neither.
            let $job = unsafe { job::<L>(&parents, &root)? };
            // SAFETY: the caller keeps the conditions under `# Safety`, which are those of the
            // functions called here.
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
/// The caller must keep the conditions of [`Input::slice`] and [`Output::slice`], and for `parents`
/// and `root` those of [`job`].
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
    // SAFETY: the caller guarantees that the memory is valid, and the outputs have been checked to
    // overlap nothing.
    unsafe {
        let job = job::<L>(&parents, &root)?;
        let locals = Bones { rotations: rotations.slice(), offsets: offsets.slice() };
        Ok(job.locals_to_model(locals, models.slice())?)
    }
}

/// # Safety
/// The caller must keep the conditions of [`Input::slice`] and [`Output::slice`], and for `parents`
/// and `root` those of [`job`].
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
    // SAFETY: the caller guarantees that the memory is valid, and the outputs have been checked to
    // overlap nothing.
    unsafe {
        let job = job::<L>(&parents, &root)?;
        Ok(job.locals_to_model(RotationsTranslations(locals.slice()), models.slice())?)
    }
}

/// Defines a function that computes models and a palette whose entries have `$count` numbers.
macro_rules! palettes {
    ($($name:ident of $count:literal;)+) => {$(
        /// # Safety
        /// The caller must keep the conditions of [`Input::slice`] and [`Output::slice`], and for
        /// `parents` and `root` those of [`job`].
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
            // SAFETY: the caller guarantees that the memory is valid, and the outputs have been
            // checked to overlap nothing.
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
            /// `parents` holds `joints` numbers, -1 for a joint without a parent. `root` is a
            /// motion that moves all joints without a parent, or null. `locals` and `models` are
            /// `[instance][joint]` and hold `count` motions in all, which is `joints` times the
            /// number of instances. In blocks they are `[block of instances][joint]`, and `count`
            /// is `joints` times the number of instances over `lanes`, rounded up. `models` may be
            /// `locals`. Returns DQ8_STATUS_LENGTH if `count` is no multiple of `joints`.
            local_to_model, blocks_local_to_model(
                parents: *const i32, joints: usize, root: *const $R,
                locals: *const $R, models: *mut $R,
            )
        }
        export! { $R $lanes
            /// Computes local poses from unit model poses: the inverse of dq8_local_to_model, with
            /// the same arrays. `locals` may be `models`.
            model_to_local, blocks_model_to_local(
                parents: *const i32, joints: usize, root: *const $R,
                models: *const $R, locals: *mut $R,
            )
        }
        export! { $R $lanes
            /// Computes model poses from rotations and fixed offsets, as animation clips hold them,
            /// otherwise like dq8_local_to_model. `rotations` holds `count` unit quaternions (x, y,
            /// z, w). `offsets` holds the translation of each joint in its parent (x, y, z), which
            /// is the same in all instances: three numbers for each of `joints`.
            rotations_to_model, blocks_rotations_to_model(
                parents: *const i32, joints: usize, root: *const $R,
                rotations: *const $R, offsets: *const $R, models: *mut $R,
            )
        }
        export! { $R $lanes
            /// Computes model poses from rotations and translations, otherwise like
            /// dq8_local_to_model. `locals` holds seven numbers each: a unit quaternion (x, y, z,
            /// w) and a translation (x, y, z).
            rotations_translations_to_model, blocks_rotations_translations_to_model(
                parents: *const i32, joints: usize, root: *const $R,
                locals: *const $R, models: *mut $R,
            )
        }
        export! { $R $lanes
            /// Computes model poses like dq8_local_to_model, and in the same pass the skinning
            /// palette: `palette[j] = models[j] * inverse_binds[j]`, the motion of joint j from the
            /// mesh at rest.
            ///
            /// `inverse_binds` holds `joints` plain motions, the same for all instances. `models`
            /// and `palette` hold `count` motions, like `locals`, and must overlap nothing.
            palette, blocks_palette(
                parents: *const i32, joints: usize, root: *const $R,
                locals: *const $R, inverse_binds: *const $R, models: *mut $R, palette: *mut $R,
            )
        }
        export! { $R $lanes
            /// Computes model poses and the palette like dq8_palette, with the palette as matrices
            /// `[R | t]` of twelve numbers each, row by row.
            palette_matrices, blocks_palette_matrices(
                parents: *const i32, joints: usize, root: *const $R,
                locals: *const $R, inverse_binds: *const $R, models: *mut $R, palette: *mut $R,
            )
        }
    };
}
for_both_numbers!(functions);

/// Checks that `parents` is a hierarchy: `parents[j]`, the parent of joint j, is less than j, or
/// -1. Every function that takes parents makes the same check, which costs little beside its work;
/// this one also tells which joint is wrong.
///
/// Returns DQ8_STATUS_PARENT_NOT_BEFORE or _PARENT_OUT_OF_RANGE for the first joint whose parent is
/// wrong, and sets `bad_joint` to it. `bad_joint` may be null, and must not be in `parents`.
///
/// # Safety
/// `parents` must hold `joints` numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dq8_check_parents(
    parents: *const i32,
    joints: usize,
    bad_joint: *mut usize,
) -> Status {
    // SAFETY: the caller keeps the conditions under `# Safety`, which are those of the functions
    // called here.
    Status::of(unsafe { check_parents(parents, joints, bad_joint) })
}

/// # Safety
/// The caller must keep the conditions of [`Input::slice`] and [`Output::write`].
unsafe fn check_parents(start: *const i32, joints: usize, bad_joint: *mut usize) -> Done {
    let (parents, bad_joint) = (parents(start, joints)?, Output::unless_null(bad_joint)?);
    disjoint(&[bad_joint.span], &[parents.span])?;
    // SAFETY: the caller guarantees that the memory is valid, and the outputs have been checked to
    // overlap nothing.
    unsafe { checked(&parents, &bad_joint).map(|_| ()) }
}

/// The hierarchy of these parents. If one of them is wrong, its joint is written to `bad_joint`.
///
/// # Safety
/// The caller must keep the conditions of [`Input::slice`] and [`Output::write`], and the two must
/// be disjoint.
pub(crate) unsafe fn checked<'a>(
    parents: &Input<u32>,
    bad_joint: &Output<usize>,
) -> Result<Hierarchy<'a>, Status> {
    // SAFETY: the caller keeps the conditions under `# Safety`, which are those of the functions
    // called here.
    let hierarchy = Hierarchy::new(unsafe { parents.slice() });
    if let Err(
        HierarchyError::ParentNotBefore { joint, .. }
        | HierarchyError::ParentOutOfRange { joint, .. },
    ) = &hierarchy
    {
        // SAFETY: the caller keeps the conditions under `# Safety`, which are those of the
        // functions called here.
        unsafe { bad_joint.write(*joint) };
    }
    Ok(hierarchy?)
}

//! Joint hierarchies: local poses to model space and back, and skinning palettes.

use crate::memory::{Input, Output, from_to};
use crate::span::apart;
use crate::status::{Done, Status};
use dq8::storage::{AoSoA, Aos, Layout};
use dq8::{
    DualQuat, Hierarchy, Job,
    hierarchy::{Bones, HierarchyError, Poses, Root as StandsOn, RotationsTranslations},
};

/// Parents as C has them. It marks roots by -1: in the same four bytes, [`Hierarchy::ROOT`].
pub(crate) fn parents(start: *const i32, joints: usize) -> Result<Input<u32>, Status> {
    Input::new(start, joints)
}

/// What joints without a parent stand on, if that is not null.
type Root<L> = Input<DualQuat<<L as Layout>::Real>>;

/// A run over the hierarchy.
///
/// # Safety
/// As for [`Input::slice`].
unsafe fn job<'a, L: Layout>(
    parents: &Input<u32>,
    root: &Root<L>,
) -> Result<Job<'a, StandsOn<'a, L::Record<8>>>, Status> {
    // SAFETY: promised.
    let (parents, root) = unsafe { (parents.slice(), root.slice()) };
    let job = Hierarchy::new(parents)?.job();
    Ok(job.on(match *root {
        [root] => StandsOn::Same(root),
        _ => StandsOn::None,
    }))
}

/// Poses from others, elsewhere or in place.
macro_rules! poses {
    ($name:ident($from:ident, $to:ident) by |$job:ident| $elsewhere:expr, $in_place:ident) => {
        /// # Safety
        /// As for [`from_to`]; `parents` and `root` as [`job`].
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
            apart(&[written], &[parents.span, root.span])?;
            // SAFETY: promised, and apart from what is written.
            let $job = unsafe { job::<L>(&parents, &root)? };
            // SAFETY: promised.
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
/// As for [`Input::slice`] and [`Output::slice`]; `parents` and `root` as [`job`].
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
    apart(&[models.span], &[parents.span, root.span, rotations.span, offsets.span])?;
    // SAFETY: promised, and apart.
    unsafe {
        let job = job::<L>(&parents, &root)?;
        let locals = Bones { rotations: rotations.slice(), offsets: offsets.slice() };
        Ok(job.locals_to_model(locals, models.slice())?)
    }
}

/// # Safety
/// As for [`Input::slice`] and [`Output::slice`]; `parents` and `root` as [`job`].
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
    apart(&[models.span], &[parents.span, root.span, locals.span])?;
    // SAFETY: promised, and apart.
    unsafe {
        let job = job::<L>(&parents, &root)?;
        Ok(job.locals_to_model(RotationsTranslations(locals.slice()), models.slice())?)
    }
}

/// Models, and a palette of entries of so many numbers.
macro_rules! palettes {
    ($($name:ident of $count:literal;)+) => {$(
        /// # Safety
        /// As for [`Input::slice`] and [`Output::slice`]; `parents` and `root` as [`job`].
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
            apart(&[models.span, palette.span], &read)?;
            // SAFETY: promised, and apart.
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
            /// Model poses of all joints from local ones:
            /// `models[j] = models[parents[j]] * locals[j]`.
            ///
            /// `locals` and `models` are `[instance][joint]`, `count` motions in all: `joints`
            /// times instances, which is `joints` for one instance; in blocks,
            /// `[block of instances][joint]`, `joints` times the number of instances over `lanes`,
            /// rounded up. DQ8_STATUS_LENGTH if `count` is no multiple of `joints`. `root` is what
            /// joints without a parent stand on, or null. `models` may be `locals`.
            local_to_model, blocks_local_to_model(
                parents: *const i32, joints: usize, root: *const $R,
                locals: *const $R, models: *mut $R,
            )
        }
        export! { $R $lanes
            /// Local poses of all joints from unit model ones, as dq8_local_to_model the other way
            /// round. `locals` may be `models`.
            model_to_local, blocks_model_to_local(
                parents: *const i32, joints: usize, root: *const $R,
                models: *const $R, locals: *mut $R,
            )
        }
        export! { $R $lanes
            /// As dq8_local_to_model of `count` unit quaternions (x, y, z, w) in all and `joints`
            /// offsets of joints from their parents (x, y, z), the same for all instances: what
            /// animation clips hold.
            rotations_to_model, blocks_rotations_to_model(
                parents: *const i32, joints: usize, root: *const $R,
                rotations: *const $R, offsets: *const $R, models: *mut $R,
            )
        }
        export! { $R $lanes
            /// As dq8_local_to_model of `locals` with seven numbers each: a unit quaternion (x, y,
            /// z, w) and a translation (x, y, z).
            rotations_translations_to_model, blocks_rotations_translations_to_model(
                parents: *const i32, joints: usize, root: *const $R,
                locals: *const $R, models: *mut $R,
            )
        }
        export! { $R $lanes
            /// As dq8_local_to_model, and in the same pass the skinning palette:
            /// `palette[j] = models[j] * inverse_binds[j]`, which takes a vertex of the mesh at
            /// rest to where joint j has moved it.
            ///
            /// `inverse_binds` holds `joints` plain motions, the same for all instances. `models`
            /// and `palette` hold `count` motions in all, as there, and must overlap nothing.
            palette, blocks_palette(
                parents: *const i32, joints: usize, root: *const $R,
                locals: *const $R, inverse_binds: *const $R, models: *mut $R, palette: *mut $R,
            )
        }
        export! { $R $lanes
            /// As dq8_palette with a palette of matrices `[R | t]`, twelve numbers each, row after
            /// row.
            palette_matrices, blocks_palette_matrices(
                parents: *const i32, joints: usize, root: *const $R,
                locals: *const $R, inverse_binds: *const $R, models: *mut $R, palette: *mut $R,
            )
        }
    };
}
for_both_numbers!(functions);

/// Whether `parents` is a hierarchy: `parents[j]` is the parent of joint j and comes before it, or
/// is -1. Every function that takes parents checks them too, in a pass that costs little beside its
/// work; this one also says where the fault is.
///
/// If it is DQ8_STATUS_PARENT_NOT_BEFORE or _PARENT_OUT_OF_RANGE, `bad_joint` is set to the first
/// such joint; it may be null, and must not lie in `parents`.
///
/// # Safety
/// `parents` holds `joints` numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dq8_check_parents(
    parents: *const i32,
    joints: usize,
    bad_joint: *mut usize,
) -> Status {
    // SAFETY: promised.
    Status::of(unsafe { check_parents(parents, joints, bad_joint) })
}

/// # Safety
/// As for [`Input::slice`] and [`Output::write`].
unsafe fn check_parents(start: *const i32, joints: usize, bad_joint: *mut usize) -> Done {
    let (parents, bad_joint) = (parents(start, joints)?, Output::unless_null(bad_joint)?);
    apart(&[bad_joint.span], &[parents.span])?;
    // SAFETY: promised, and apart.
    unsafe { checked(&parents, &bad_joint).map(|_| ()) }
}

/// The hierarchy of these parents; if they are none, the joint that is wrong is written to
/// `bad_joint`.
///
/// # Safety
/// As for [`Input::slice`] and [`Output::write`], and the two are apart.
pub(crate) unsafe fn checked<'a>(
    parents: &Input<u32>,
    bad_joint: &Output<usize>,
) -> Result<Hierarchy<'a>, Status> {
    // SAFETY: promised.
    let hierarchy = Hierarchy::new(unsafe { parents.slice() });
    if let Err(
        HierarchyError::ParentNotBefore { joint, .. }
        | HierarchyError::ParentOutOfRange { joint, .. },
    ) = &hierarchy
    {
        // SAFETY: promised.
        unsafe { bad_joint.write(*joint) };
    }
    Ok(hierarchy?)
}

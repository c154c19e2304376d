//! Skeletons: model poses and palettes of any number of instances.

use crate::clip::{Places, Source};
use crate::memory::{made, slice, slice_mut, status};
use crate::{Columns, Motion};
use dq8::hierarchy::{MatrixOrder, Poses, Root};
use dq8::{Hierarchy, ShapeError, Skeleton};

/// How many instances go through scratch at once: as many as the widest lanes hold.
const AT_ONCE: usize = 16;

/// A skeleton, and what it computes in, kept so that no frame allocates.
#[derive(Debug)]
pub(crate) struct Rig {
    pub(crate) skeleton: Skeleton,
    /// No joint has a parent: what models and inverse binds make palettes by.
    loose: Box<[u32]>,
    places: [Places; 2],
    scratch: Box<[Motion]>,
    models: Vec<Motion>,
}

/// # Safety
/// So many parents are there.
#[unsafe(no_mangle)]
unsafe extern "C" fn dq8_skeleton(parents: *const i32, joints: usize) -> *mut Rig {
    // SAFETY: promised.
    let skeleton = Skeleton::new(unsafe { slice(parents, joints) });
    made(skeleton.map(|skeleton| Rig {
        skeleton,
        loose: vec![Hierarchy::ROOT; joints].into(),
        places: Default::default(),
        scratch: vec![Motion::IDENTITY; AT_ONCE.saturating_mul(joints)].into(),
        models: Vec::new(),
    }))
}

/// # Safety
/// It has been made, and is not used any more.
#[unsafe(no_mangle)]
unsafe extern "C" fn dq8_skeleton_free(rig: *mut Rig) {
    // SAFETY: promised.
    drop(unsafe { Box::from_raw(rig) });
}

/// # Safety
/// So many are there.
unsafe fn root<'a>(roots: *const Motion, count: usize) -> Root<'a, Motion> {
    // SAFETY: promised.
    if roots.is_null() { Root::None } else { Root::Each(unsafe { slice(roots, count) }) }
}

/// Palettes of models that are there.
fn model_palette(
    loose: &[u32],
    models: &[Motion],
    scratch: &mut [Motion],
    inverse_binds: &[Motion],
    palette: &mut [Columns],
) -> Result<(), ShapeError> {
    let Ok(loose) = Hierarchy::new(loose) else { return Ok(()) };
    let job = loose.job().on(Root::None).matrix_order(MatrixOrder::Columns);
    job.palette(Poses(models), scratch, inverse_binds, palette)
}

/// Model poses, `[instance][joint]`; in place if the source is where they go.
///
/// # Safety
/// All that is named is there, and `models` lies apart from it or is the source.
#[unsafe(no_mangle)]
unsafe extern "C" fn dq8_skeleton_local_to_model(
    rig: &mut Rig,
    source: &Source,
    roots: *const Motion,
    root_count: usize,
    models: *mut Motion,
    count: usize,
) -> u32 {
    let Rig { skeleton, places, .. } = rig;
    // SAFETY: promised.
    let (root, out) = unsafe { (root(roots, root_count), slice_mut(models, count)) };
    if source.is_at(models) {
        return status(skeleton.job().on(root).local_to_model_in_place(out));
    }
    // Without a plan, which is for one instance alone, and twice the code.
    let job = skeleton.hierarchy().job().on(root);
    // SAFETY: promised.
    status(unsafe {
        match source.locals() {
            Some(locals) => job.locals_to_model(Poses(locals), out),
            None => source.poses(places).and_then(|poses| job.locals_to_model(poses, out)),
        }
    })
}

/// Skinning palettes, `[instance][joint]`, 4×4 matrices by columns.
///
/// # Safety
/// All that is named is there, and `palette` lies apart from it.
#[unsafe(no_mangle)]
unsafe extern "C" fn dq8_skeleton_palette(
    rig: &mut Rig,
    source: &Source,
    roots: *const Motion,
    root_count: usize,
    inverse_binds: *const Motion,
    bind_count: usize,
    palette: *mut Columns,
    count: usize,
) -> u32 {
    let Rig { skeleton, places, scratch, models, loose } = rig;
    // SAFETY: promised.
    let (root, inverse_binds, palette) = unsafe {
        (root(roots, root_count), slice(inverse_binds, bind_count), slice_mut(palette, count))
    };
    let job = skeleton.hierarchy().job().on(root);
    // SAFETY: promised.
    let Some(locals) = (unsafe { source.locals() }) else {
        let job = job.matrix_order(MatrixOrder::Columns);
        // SAFETY: promised.
        return status(
            unsafe { source.poses(places) }
                .and_then(|poses| job.palette(poses, scratch, inverse_binds, palette)),
        );
    };
    // Through models in memory: no kernel more, which a page would wait for.
    models.resize(palette.len(), Motion::IDENTITY);
    status(
        job.locals_to_model(Poses(locals), models)
            .and_then(|()| model_palette(loose, models, scratch, inverse_binds, palette)),
    )
}

/// The same from models.
///
/// # Safety
/// All that is named is there, and `palette` lies apart from it.
#[unsafe(no_mangle)]
unsafe extern "C" fn dq8_skeleton_model_palette(
    rig: &mut Rig,
    models: *const Motion,
    model_count: usize,
    inverse_binds: *const Motion,
    bind_count: usize,
    palette: *mut Columns,
    count: usize,
) -> u32 {
    let Rig { loose, scratch, .. } = rig;
    // SAFETY: promised.
    let (models, inverse_binds, palette) = unsafe {
        (slice(models, model_count), slice(inverse_binds, bind_count), slice_mut(palette, count))
    };
    status(model_palette(loose, models, scratch, inverse_binds, palette))
}

//! Skeletons: model poses and palettes of any number of instances.

use crate::clip::{Places, Source};
use crate::error::{made, status};
use crate::memory::{exports, frees, slice};
use crate::motions::to_rotations_translations;
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
    pub(crate) loose: Box<[u32]>,
    places: [Places; 2],
    pub(crate) scratch: Box<[Motion]>,
    pub(crate) models: Vec<Motion>,
}

impl Rig {
    fn locals(&mut self, source: &Source, locals: &mut [Motion]) -> Result<(), ShapeError> {
        let Self { skeleton, places, .. } = self;
        // SAFETY: JavaScript promises that all that the source names is there.
        let poses = unsafe { source.poses(places)? };
        skeleton.hierarchy().job().locals(poses, locals)
    }
}

/// # Safety
/// So many are there.
unsafe fn root<'a>(roots: *const Motion, count: usize) -> Root<'a, Motion> {
    // SAFETY: promised.
    match unsafe { slice(roots, count) } {
        _ if roots.is_null() => Root::None,
        // One motion serves any number of instances.
        &[root] => Root::Same(root),
        roots => Root::Each(roots),
    }
}

/// Palettes of models that are there.
pub(crate) fn model_palette(
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

frees!(dq8_skeleton_free: Rig);
exports! {
    fn dq8_skeleton(; parents[joints]: i32;) -> *mut Rig {
        made(Skeleton::new(parents).map(|skeleton| Rig {
            skeleton,
            loose: vec![Hierarchy::ROOT; joints].into(),
            places: Default::default(),
            scratch: vec![Motion::IDENTITY; AT_ONCE.saturating_mul(joints)].into(),
            models: Vec::new(),
        }))
    }

    /// Model poses, `[instance][joint]`; in place if the source is where they go.
    fn dq8_skeleton_local_to_model(
        rig: &mut Rig, source: &Source, roots: *const Motion, root_count: usize;; models[count]: Motion
    ) -> u32 {
        let Rig { skeleton, places, .. } = rig;
        // SAFETY: promised.
        let root = unsafe { root(roots, root_count) };
        if source.is_at(models.as_ptr()) {
            return status(skeleton.job().on(root).local_to_model_in_place(models));
        }
        // Without a plan, which is for one instance alone, and twice the code.
        let job = skeleton.hierarchy().job().on(root);
        // SAFETY: promised.
        status(unsafe {
            match source.locals() {
                Some(locals) => job.locals_to_model(Poses(locals), models),
                None => source.poses(places).and_then(|poses| job.locals_to_model(poses, models)),
            }
        })
    }

    /// Locals of models, each in its parent; those of root joints in the roots.
    fn dq8_skeleton_model_to_local(
        rig: &Rig, roots: *const Motion, root_count: usize; models[model_count]: Motion; locals[count]: Motion
    ) -> u32 {
        // SAFETY: promised.
        let root = unsafe { root(roots, root_count) };
        status(rig.skeleton.hierarchy().job().on(root).model_to_local(models, locals))
    }

    /// Locals of poses of clips, `[instance][joint]`.
    fn dq8_skeleton_locals(rig: &mut Rig, source: &Source;; locals[count]: Motion) -> u32 {
        status(rig.locals(source, locals))
    }

    /// The same as rotations and translations, which a layer above them reads. They may go where
    /// the source lies.
    fn dq8_skeleton_layer(rig: &mut Rig, source: &Source, poses: *mut [f32; 7], count: usize;;) -> u32 {
        let mut motions = std::mem::take(&mut rig.models);
        motions.resize(count, Motion::IDENTITY);
        let done = rig.locals(source, &mut motions);
        if done.is_ok() {
            // SAFETY: JavaScript passes an array of `count` poses. The source, which may lie in it,
            // has been read.
            let poses = unsafe { std::slice::from_raw_parts_mut(poses, count) };
            to_rotations_translations(&motions, poses);
        }
        rig.models = motions;
        status(done)
    }

    /// Skinning palettes, `[instance][joint]`, 4×4 matrices by columns.
    fn dq8_skeleton_palette(
        rig: &mut Rig, source: &Source, roots: *const Motion, root_count: usize;
        inverse_binds[bind_count]: Motion; palette[count]: Columns
    ) -> u32 {
        let Rig { skeleton, places, scratch, models, loose } = rig;
        // SAFETY: promised.
        let (root, locals) = unsafe { (root(roots, root_count), source.locals()) };
        let job = skeleton.hierarchy().job().on(root);
        let Some(locals) = locals else {
            let job = job.matrix_order(MatrixOrder::Columns);
            // SAFETY: promised.
            let poses = unsafe { source.poses(places) };
            return status(poses.and_then(|poses| job.palette(poses, scratch, inverse_binds, palette)));
        };
        // Through models in memory: no kernel more, which a page would wait for.
        models.resize(palette.len(), Motion::IDENTITY);
        status(
            job.locals_to_model(Poses(locals), models)
                .and_then(|()| model_palette(loose, models, scratch, inverse_binds, palette)),
        )
    }

    /// The same from models.
    fn dq8_skeleton_model_palette(
        rig: &mut Rig; models[model_count]: Motion, inverse_binds[bind_count]: Motion; palette[count]: Columns
    ) -> u32 {
        let Rig { loose, scratch, .. } = rig;
        status(model_palette(loose, models, scratch, inverse_binds, palette))
    }
}

//! Crowds: poses in blocks of four instances, the quickest form where nothing else wants them
//! plain.

use crate::error::status;
use crate::memory::{exports, frees};
use crate::skeleton::{Rig, model_palette};
use crate::{Columns, Motion};
use dq8::Crowd;

type Blocks = Crowd<f32, 4>;

frees!(dq8_crowd_free: Blocks);
exports! {
    fn dq8_crowd(rig: &Rig, instances: usize;;) -> *mut Blocks {
        Box::into_raw(Box::new(Crowd::new(rig.skeleton.joints(), instances)))
    }

    fn dq8_crowd_set(crowd: &mut Blocks; poses[count]: Motion;) -> u32 {
        status(dq8::storage::pack(crowd.joints(), poses, crowd.blocks_mut()))
    }

    fn dq8_crowd_copy_to(crowd: &Blocks;; poses[count]: Motion) -> u32 {
        status(crowd.copy_to_slice(poses))
    }

    /// Palettes of models, by way of plain ones.
    fn dq8_crowd_palette(
        crowd: &Blocks, rig: &mut Rig; inverse_binds[bind_count]: Motion; palette[count]: Columns
    ) -> u32 {
        let Rig { loose, scratch, models, .. } = rig;
        models.resize(palette.len(), Motion::IDENTITY);
        status(
            crowd
                .copy_to_slice(models)
                .and_then(|()| model_palette(loose, models, scratch, inverse_binds, palette)),
        )
    }

    /// In place.
    fn dq8_crowd_local_to_model(crowd: &mut Blocks, rig: &Rig;;) -> u32 {
        status(rig.skeleton.job().local_to_model_in_place(crowd.blocks_mut()))
    }
}

//! Skinning over all cores (feature `rayon`).

use super::SkinningError;
use super::blender::Blender;
use super::interleaved::{self, Interleaved, VertexFields};
use super::mesh::Separate;
use super::run::{Run, check};
use super::skin::Skin;
use super::surface::{Surface, SurfaceMut};
use super::weight::Weight;
use crate::dispatch::Backend;
use crate::real::Scalar;
use crate::storage::{Element, Layout, Number};
use alloc::vec::Vec;
use core::marker::PhantomData;
use dq8_simd::picks::Index;
use rayon::prelude::*;

/// How many vertices a task has: some microseconds of work.
const GRAIN: usize = 4096;

impl Backend {
    /// [`skin`](Self::skin) on all threads of rayon's current pool. Every bit of the result is the same.
    ///
    /// # Errors
    /// If the slices, the palette and the skin do not fit each other; `posed` is untouched.
    pub fn par_skin<J, W, B, P>(
        self,
        skin: &Skin<'_, J, W>,
        blend: B,
        rest: Surface<'_, P>,
        posed: SurfaceMut<'_, P>,
    ) -> Result<(), SkinningError>
    where
        J: Index,
        W: Weight,
        B: Blender<Number<P, 3>> + Send + Sync,
        P: Element<3> + Send + Sync,
    {
        check(skin, &blend, &rest, &posed)?;
        let size = GRAIN / P::Layout::THINGS;
        let tasks: Vec<_> = rest.chunks(size).zip(posed.chunks(size)).enumerate().collect();
        tasks.into_par_iter().for_each(|(task, (rest, posed))| {
            let mesh = Separate { rest, posed };
            self.run(Run { skin, blend, first: task * GRAIN, mesh, layout: PhantomData });
        });
        Ok(())
    }

    /// [`skin_interleaved`](Self::skin_interleaved) on all threads of rayon's current pool. Every bit of the result is
    /// the same.
    ///
    /// # Errors
    /// As there; `posed` is untouched.
    pub fn par_skin_interleaved<J, W, B, R>(
        self,
        skin: &Skin<'_, J, W>,
        blend: B,
        (rest, from): (&[R], VertexFields),
        (posed, to): (&mut [R], VertexFields),
    ) -> Result<(), SkinningError>
    where
        J: Index,
        W: Weight,
        B: Blender<R> + Send + Sync,
        R: Scalar,
    {
        interleaved::check(skin, &blend, &Interleaved { rest, from, posed, to })?;
        let [length, posed_length] = [from, to].map(|fields| GRAIN.saturating_mul(fields.stride));
        let tasks = rest.par_chunks(length).zip(posed.par_chunks_mut(posed_length)).enumerate();
        tasks.for_each(|(task, (rest, posed))| {
            let mesh = Interleaved { rest, from, posed, to };
            let first = task * GRAIN;
            self.run(Run { skin, blend, first, mesh, layout: PhantomData::<[R; 3]> });
        });
        Ok(())
    }
}

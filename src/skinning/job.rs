//! [`Job`], the options of skinning, and the loop over the vertices of a mesh that all blends
//! share.
//!
//! # The algorithm
//!
//! Each lane of a register holds one vertex. For each register of vertices the loop reads their
//! joints and weights in groups of four influences. It gathers the palette's entries and sums them
//! by weight, which takes most of the time. It makes one map for each vertex from the sum, and
//! applies the map to position, normal and tangent.
//!
//! # Reasons
//!
//! - *Blends differ in four steps only* ([`Blender`]: check, sum, join, map). So all blends, for
//!   plain and interleaved meshes, share this loop, and another blend needs four functions only.
//! - *Influences are copied to scratch in groups* of a fixed size. So the code that sums a group
//!   has no branch on the number of influences. Eight influences are two groups.
//! - *Meshes with positions alone have a path of their own* ([`Blender::points`]), because a linear
//!   blend of positions needs no map. The general loop poses the last points, which this path
//!   leaves over. The general loop begins at a whole register, so it poses some points a second
//!   time, with the same bits.
//! - *All inputs are checked before the loop*. So no index in the loop is out of range, and an
//!   error leaves the output untouched.

use super::SkinningError;
use super::blender::{Blender, SurfaceMap};
use super::mesh::{Field, Interleaved, Mesh, Separate, Surface, SurfaceMut, VertexFields};
use super::skin::{Skin, Weight};
#[cfg(doc)]
use super::{DualBlend, Linear, Mixed, StretchedDualBlend};
use crate::backend::{Choice, Kernel};
use crate::macros::brief;
use crate::number::Scalar;
use crate::storage::{self, Element, Layout, Number, Register};
use dq8_simd::internal::Index;
use dq8_simd::{Lanes, Level};

/// The options with which the mesh of a [`Skin`] is posed. Each option has a default, and the
/// methods [`pose`](Self::pose) and [`pose_interleaved`](Self::pose_interleaved) pose the mesh.
///
/// ```
/// use dq8::skinning::{DualBlend, Skin, Surface, SurfaceMut};
/// use dq8::{Backend, DualQuat};
/// let skin = Skin::new(2, 2, &[0_u8, 1, 0, 1], &[1.0_f32, 0.0, 0.25, 0.75])?;
/// let palette = [DualQuat::IDENTITY, DualQuat::from_translation([0.0_f32, 0.0, 4.0])];
/// let (rest, mut posed) = ([[1.0, 2.0, 3.0]; 2], [[0.0; 3]; 2]);
/// let (from, to) = (Surface::positions(&rest), SurfaceMut::positions(&mut posed));
/// skin.job().backend(Backend::PORTABLE).pose(DualBlend::new(&palette), from, to)?;
/// assert_eq!(posed, [[1.0, 2.0, 3.0], [1.0, 2.0, 6.0]]);
/// # Ok::<(), dq8::skinning::SkinningError>(())
/// ```
#[derive(Clone, Copy)]
#[must_use]
pub struct Job<'s, J, W> {
    skin: Skin<'s, J, W>,
    choice: Choice,
}

brief!([J: Index, W: Weight] Job<'_, J, W>: Job |it| { skin: it.skin, choice: it.choice });

impl<'s, J: Index, W: Weight> Skin<'s, J, W> {
    /// Poses a mesh: each vertex moves by the blend of the motions of its joints. The blend is
    /// [`Linear`], [`DualBlend`], [`StretchedDualBlend`] or a mix of two blends ([`Mixed`]). `rest`
    /// and `posed` hold positions, and normals and tangents if both have them, in plain slices or
    /// blocks: see [`skinning`](crate::skinning).
    ///
    /// # Errors
    /// If the slices, the palette and the skin do not fit each other; `posed` is untouched.
    #[inline]
    pub fn pose<B: Blender<Number<P, 3>>, P: Element<3>>(
        &self,
        blend: B,
        rest: Surface<'_, P>,
        posed: SurfaceMut<'_, P>,
    ) -> Result<(), SkinningError> {
        self.job().pose(blend, rest, posed)
    }

    /// Returns a [`Job`], which poses the mesh with options.
    pub fn job(&self) -> Job<'s, J, W> {
        Job { skin: *self, choice: Choice::default() }
    }
}

impl<J: Index, W: Weight> Job<'_, J, W> {
    crate::backend::options!();

    /// Poses a mesh as [`Skin::pose`] does, with the options of this job.
    ///
    /// # Errors
    /// If the slices, the palette and the skin do not fit each other; `posed` is untouched.
    #[inline]
    pub fn pose<B: Blender<Number<P, 3>>, P: Element<3>>(
        &self,
        blend: B,
        rest: Surface<'_, P>,
        posed: SurfaceMut<'_, P>,
    ) -> Result<(), SkinningError> {
        self.run(blend, Separate { rest, posed })
    }

    /// Poses vertices that are records of several fields, such as the vertex buffer of a GPU.
    /// `rest` and `posed` hold one vertex after the other, and the two [`VertexFields`] give the
    /// offsets of position, normal and tangent in a vertex. All other fields of `posed` stay as
    /// they are.
    ///
    /// A slice of your own vertex type becomes a slice of `R` by `bytemuck::cast_slice`, even if it
    /// has fields of other types of the same size.
    ///
    /// # Errors
    /// If a field lies outside of its vertex or overlaps another field, the two buffers have
    /// different fields, or the buffers, the palette and the skin do not fit each other; `posed` is
    /// untouched.
    ///
    /// ```
    /// use dq8::skinning::{DualBlend, Skin, VertexFields};
    /// use dq8::DualQuat;
    /// let skin = Skin::new(2, 1, &[0_u8, 1], &[1.0_f32, 1.0])?;
    /// let palette = [DualQuat::IDENTITY, DualQuat::from_translation([0.0_f32, 0.0, 4.0])];
    /// // Positions and texture coordinates.
    /// let rest = [1.0, 2.0, 3.0, 0.5, 0.5, 1.0, 2.0, 3.0, 0.1, 0.9];
    /// let (fields, mut posed) = (VertexFields::positions(5), rest);
    /// let blend = DualBlend::new(&palette);
    /// skin.job().pose_interleaved(blend, (&rest, fields), (&mut posed, fields))?;
    /// assert_eq!(posed, [1.0, 2.0, 3.0, 0.5, 0.5, 1.0, 2.0, 7.0, 0.1, 0.9]);
    /// # Ok::<(), dq8::skinning::SkinningError>(())
    /// ```
    pub fn pose_interleaved<B: Blender<R>, R: Scalar>(
        &self,
        blend: B,
        (rest, from): (&[R], VertexFields),
        (posed, to): (&mut [R], VertexFields),
    ) -> Result<(), SkinningError> {
        self.run(blend, Interleaved { rest, from, posed, to })
    }

    /// Checks that all inputs fit each other, and poses the mesh.
    fn run<B, M>(&self, blend: B, mesh: M) -> Result<(), SkinningError>
    where
        B: Blender<Number<M::Point, 3>>,
        M: Mesh,
    {
        let skin = &self.skin;
        blend.check(skin.joint_count(), skin.vertices())?;
        mesh.check(skin.vertices())?;
        let backend = self.choice.instructions();
        backend.share(GRAIN, mesh, &|first, mesh| backend.run(Run { skin, blend, first, mesh }));
        Ok(())
    }
}

/// The least number of vertices in a task of a thread. Posing them takes some microseconds.
const GRAIN: usize = 4096;

/// The loop over the vertices of a mesh, with a vertex in each lane.
struct Run<'s, 'a, J, W, B, M> {
    skin: &'s Skin<'a, J, W>,
    blend: B,
    /// The index in the skin of the first vertex of `mesh`, which is a part of the mesh if several
    /// threads share the work.
    first: usize,
    mesh: M,
}

impl<J, W, B, M> Kernel for Run<'_, '_, J, W, B, M>
where
    J: Index,
    W: Weight,
    B: Blender<Number<M::Point, 3>>,
    M: Mesh,
{
    type Output = ();
    const SHUFFLES: bool = B::SHUFFLES;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) {
        let Self { skin, blend, first, mut mesh } = self;
        let lanes = Register::<M::Point, V, 3>::LANES;
        let mut done = 0;
        if let Some(points) = mesh.points(first) {
            done = blend.points(level, skin, points).unwrap_or(0);
        }
        let things = <M::Point as Element<3>>::Layout::THINGS;
        let mut scratch = skin.scratch();
        // The first register here may hold points that are posed already. They are posed again,
        // with the same bits.
        for tile in storage::tiles::<M::Point, V, 3>(mesh.elements()).skip(done / lanes) {
            let vertex = first + tile.element * things + tile.register * lanes;
            skin.read(vertex, lanes, 0, &mut scratch.influences);
            let Some(mut sum) = blend.sum::<Register<M::Point, V, 3>, _>(level, &mut scratch)
            else {
                return;
            };
            for group in 1..skin.groups() {
                skin.read(vertex, lanes, group, &mut scratch.influences);
                let Some(more) = blend.sum(level, &mut scratch) else { return };
                sum = blend.join(sum, more);
            }
            let map = blend.map(level, sum, vertex);
            let Some(point) = mesh.load(level, Field::Position, tile) else { return };
            mesh.store::<V>(map.point(point), Field::Position, tile);
            if let Some(normal) = mesh.load(level, Field::Normal, tile) {
                mesh.store::<V>(map.normal(normal), Field::Normal, tile);
            }
            if let Some(tangent) = mesh.load(level, Field::Tangent, tile) {
                mesh.store::<V>(map.tangent(tangent), Field::Tangent, tile);
            }
        }
    }
}

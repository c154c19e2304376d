//! The one loop of all blends over the vertices of a mesh.
//!
//! # The algorithm
//!
//! A register holds as many vertices as it has lanes. For each tile of vertices: read their joints
//! and weights, in groups of a few influences; sum the palette's entries by weight, the gather that
//! everything else waits for; turn the sum into one map for each vertex; take position, normal and
//! tangent through it.
//!
//! # Why it is as it is
//!
//! - *Blends differ in four steps only* ([`Blender`]: check, sum, join, map), so linear, dual
//!   quaternion and mixed blends, plain and interleaved meshes share this loop, and a blend of
//!   one's own is four functions.
//! - *Influences go through scratch in groups* of a fixed number: the sum of a group is straight
//!   code without a branch on how many a vertex has, and eight influences are two groups.
//! - *Positions alone have a way of their own* ([`Blender::points`]): linear blends of nothing else
//!   need no map at all. What is left over there is posed once more by the general loop, to the
//!   same bits.
//! - *Everything was checked before*: no index can be wrong here, and nothing is written if one is.

use super::SkinningError;
use super::blender::{Blender, SurfaceMap};
use super::mesh::{Field, Mesh};
use super::skin::Skin;
use super::surface::{Surface, SurfaceMut};
use super::weight::Weight;
use crate::backend::{Backend, Kernel};
use crate::storage::{self, Element, Layout, Number, Register};
use core::marker::PhantomData;
use dq8_simd::internal::Index;
use dq8_simd::{Lanes, Level};

/// Checks that everything fits.
pub(super) fn check<J, W, B, P>(
    skin: &Skin<'_, J, W>,
    blend: &B,
    rest: &Surface<'_, P>,
    posed: &SurfaceMut<'_, P>,
) -> Result<(), SkinningError>
where
    J: Index,
    W: Weight,
    B: Blender<Number<P, 3>>,
    P: Element<3>,
{
    blend.check(skin.joint_count(), skin.vertices())?;
    rest.check(skin.vertices().div_ceil(P::Layout::THINGS))?;
    posed.check(rest)?;
    Ok(())
}

/// The vertices to each thread at least: some microseconds of work.
#[cfg(feature = "rayon")]
const GRAIN: usize = 4096;

/// Poses a mesh; everything has been checked.
pub(super) fn pose<J, W, B, P, M>(backend: Backend, skin: &Skin<'_, J, W>, blend: B, mesh: M)
where
    J: Index,
    W: Weight,
    B: Blender<Number<P, 3>>,
    P: Element<3>,
    M: Mesh<P>,
{
    let run = |first, mesh| {
        backend.run(Run { skin, blend, first, mesh, layout: PhantomData::<P> });
    };
    #[cfg(feature = "rayon")]
    if backend.many() {
        return backend.share(GRAIN, mesh, &run);
    }
    run(0, mesh);
}

/// Lanes are vertices.
struct Run<'s, 'a, J, W, B, P, M> {
    skin: &'s Skin<'a, J, W>,
    blend: B,
    /// The vertex that the mesh begins with.
    first: usize,
    mesh: M,
    layout: PhantomData<P>,
}

impl<J, W, B, P, M> Kernel for Run<'_, '_, J, W, B, P, M>
where
    J: Index,
    W: Weight,
    B: Blender<Number<P, 3>>,
    P: Element<3>,
    M: Mesh<P>,
{
    type Output = ();
    const SHUFFLES: bool = B::SHUFFLES;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) {
        let Self { skin, blend, first, mut mesh, .. } = self;
        let lanes = Register::<P, V, 3>::LANES;
        let mut done = 0;
        if let Some((rest, posed)) = mesh.points() {
            done = blend.points(level, skin, first, rest, posed).unwrap_or(0);
        }
        let mut scratch = skin.scratch();
        // Points that share a tile with what is left are posed again, to the same bits.
        for tile in storage::tiles::<P, V, 3>(mesh.elements()).skip(done / lanes) {
            let vertex = first + tile.element * P::Layout::THINGS + tile.register * lanes;
            skin.read(vertex, lanes, 0, &mut scratch.influences);
            let Some(mut sum) = blend.sum::<Register<P, V, 3>, _>(level, &mut scratch) else {
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

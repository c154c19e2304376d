use super::SkinningError;
use super::blender::{Blender, SurfaceMap};
use super::skin::Skin;
use super::surface::{Surface, SurfaceMut};
use super::weight::Weight;
use crate::dispatch::{Backend, Kernel};
use crate::storage::{self, Element, Layout, Number, Register, Tile};
use core::marker::PhantomData;
use dq8_simd::picks::Index;
use dq8_simd::{Lanes, Level};

impl Backend {
    /// Poses a mesh: each vertex moves by the blend of the motions of its joints, [`Linear`], [`Dual`],
    /// [`Stretched`] or a mix of those ([`Mixed`]). Positions, and normals and tangents where `rest` has
    /// them, in plain slices or blocks; see [`skinning`](crate::skinning).
    ///
    /// # Errors
    /// If the slices, the palette and the skin do not fit each other; `posed` is untouched.
    ///
    /// ```
    /// use dq8::skinning::{Dual, Skin, Surface, SurfaceMut};
    /// use dq8::{Backend, DualQuat};
    /// let skin = Skin::new(2, 2, &[0_u8, 1, 0, 1], &[1.0_f32, 0.0, 0.25, 0.75])?;
    /// let palette = [DualQuat::IDENTITY, DualQuat::from_translation([0.0_f32, 0.0, 4.0])];
    /// let (rest, mut posed) = ([[1.0, 2.0, 3.0]; 2], [[0.0; 3]; 2]);
    /// let (from, to) = (Surface::positions(&rest), SurfaceMut::positions(&mut posed));
    /// Backend::best().skin(&skin, Dual::new(&palette), from, to)?;
    /// assert_eq!(posed, [[1.0, 2.0, 3.0], [1.0, 2.0, 6.0]]);
    /// # Ok::<(), dq8::skinning::SkinningError>(())
    /// ```
    ///
    /// [`Linear`]: crate::skinning::Linear
    /// [`Dual`]: crate::skinning::Dual
    /// [`Stretched`]: crate::skinning::Stretched
    /// [`Mixed`]: crate::skinning::Mixed
    #[inline]
    pub fn skin<J, W, B, P>(
        self,
        skin: &Skin<'_, J, W>,
        blend: B,
        rest: Surface<'_, P>,
        posed: SurfaceMut<'_, P>,
    ) -> Result<(), SkinningError>
    where
        J: Index,
        W: Weight,
        B: Blender<Number<P, 3>>,
        P: Element<3>,
    {
        check(skin, &blend, &rest, &posed)?;
        let mesh = Separate { rest, posed };
        self.run(Run { skin, blend, first: 0, mesh, layout: PhantomData });
        Ok(())
    }
}

/// Whether everything fits.
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

/// A mesh at rest and posed, in memory whose tiles are those of `P`.
pub(super) trait Mesh<P: Element<3>> {
    /// How many elements it has.
    fn elements(&self) -> usize;
    /// The vectors of a tile at rest; zero in lanes beyond the end. `None` if there are none.
    fn load<V: Level>(&self, level: V, field: Field, tile: Tile) -> Option<Vectors<P, V>>;
    /// The posed vectors of a tile.
    fn store<V: Level>(&mut self, vectors: Vectors<P, V>, field: Field, tile: Tile);
}

/// A register for each component of a vector.
pub(super) type Vectors<P, V> = [Register<P, V, 3>; 3];

/// What there is for each vertex.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Field {
    Position,
    Normal,
    Tangent,
}

/// A slice for each field.
pub(super) struct Separate<'s, P> {
    pub(super) rest: Surface<'s, P>,
    pub(super) posed: SurfaceMut<'s, P>,
}

impl<P: Element<3>> Mesh<P> for Separate<'_, P> {
    #[inline(always)]
    fn elements(&self) -> usize {
        self.posed.positions.len()
    }
    #[inline(always)]
    fn load<V: Level>(&self, level: V, field: Field, tile: Tile) -> Option<Vectors<P, V>> {
        let from = match field {
            Field::Position => self.rest.positions,
            Field::Normal => self.rest.normals?,
            Field::Tangent => self.rest.tangents?,
        };
        P::load(level, from, tile, &storage::identity())
    }
    #[inline(always)]
    fn store<V: Level>(&mut self, vectors: Vectors<P, V>, field: Field, tile: Tile) {
        let to = match field {
            Field::Position => Some(&mut *self.posed.positions),
            Field::Normal => self.posed.normals.as_deref_mut(),
            Field::Tangent => self.posed.tangents.as_deref_mut(),
        };
        if let Some(to) = to {
            P::store(vectors, to, tile);
        }
    }
}

/// Lanes are vertices.
pub(super) struct Run<'s, 'a, J, W, B, P, M> {
    pub(super) skin: &'s Skin<'a, J, W>,
    pub(super) blend: B,
    /// The vertex that the mesh begins with.
    pub(super) first: usize,
    pub(super) mesh: M,
    pub(super) layout: PhantomData<P>,
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
    const WIDE: bool = B::WIDE;

    #[inline(always)]
    fn run<V: Level>(self, level: V) {
        let Self { skin, blend, first, mut mesh, .. } = self;
        let lanes = Register::<P, V, 3>::LANES;
        let mut influences = skin.scratch();
        for tile in storage::tiles::<P, V, 3>(mesh.elements()) {
            let vertex = first + tile.element * P::Layout::THINGS + tile.register * lanes;
            skin.read(vertex, lanes, 0, &mut influences);
            let Some(mut sum) = blend.sum::<Register<P, V, 3>, _>(level, &mut influences) else {
                return;
            };
            for group in 1..skin.groups() {
                skin.read(vertex, lanes, group, &mut influences);
                let Some(more) = blend.sum(level, &mut influences) else { return };
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

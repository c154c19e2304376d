use super::SkinningError;
use super::blender::{Blender, SurfaceMap};
use super::mesh::{Field, Mesh, Separate};
use super::skin::Skin;
use super::surface::{Surface, SurfaceMut};
use super::weight::Weight;
use crate::dispatch::{Backend, Kernel};
use crate::storage::{self, Element, Layout, Number, Register};
use core::marker::PhantomData;
use dq8_simd::picks::Index;
use dq8_simd::{Lanes, Level};

impl Backend {
    /// Poses a mesh: each vertex moves by the blend of the motions of its joints, [`Linear`], [`DualBlend`],
    /// [`Stretched`] or a mix of those ([`Mixed`]). Positions, and normals and tangents where `rest` has
    /// them, in plain slices or blocks; see [`skinning`](crate::skinning).
    ///
    /// # Errors
    /// If the slices, the palette and the skin do not fit each other; `posed` is untouched.
    ///
    /// ```
    /// use dq8::skinning::{DualBlend, Skin, Surface, SurfaceMut};
    /// use dq8::{Backend, DualQuat};
    /// let skin = Skin::new(2, 2, &[0_u8, 1, 0, 1], &[1.0_f32, 0.0, 0.25, 0.75])?;
    /// let palette = [DualQuat::IDENTITY, DualQuat::from_translation([0.0_f32, 0.0, 4.0])];
    /// let (rest, mut posed) = ([[1.0, 2.0, 3.0]; 2], [[0.0; 3]; 2]);
    /// let (from, to) = (Surface::positions(&rest), SurfaceMut::positions(&mut posed));
    /// Backend::best().skin(&skin, DualBlend::new(&palette), from, to)?;
    /// assert_eq!(posed, [[1.0, 2.0, 3.0], [1.0, 2.0, 6.0]]);
    /// # Ok::<(), dq8::skinning::SkinningError>(())
    /// ```
    ///
    /// [`Linear`]: crate::skinning::Linear
    /// [`DualBlend`]: crate::skinning::DualBlend
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

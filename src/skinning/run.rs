use super::SkinningError;
use super::blender::{Blender, SurfaceMap};
use super::skin::Skin;
use super::surface::{Surface, SurfaceMut};
use super::weight::Weight;
use crate::dispatch::{Backend, Kernel};
use crate::storage::{self, Element, Layout, Number, Register, Tile};
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
        self.run(Run { skin, blend, first: 0, rest, posed });
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
pub(super) struct Run<'s, 'a, J, W, B, P> {
    pub(super) skin: &'s Skin<'a, J, W>,
    pub(super) blend: B,
    /// The vertex that the slices begin with.
    pub(super) first: usize,
    pub(super) rest: Surface<'s, P>,
    pub(super) posed: SurfaceMut<'s, P>,
}

impl<J, W, B, P> Kernel for Run<'_, '_, J, W, B, P>
where
    J: Index,
    W: Weight,
    B: Blender<Number<P, 3>>,
    P: Element<3>,
{
    type Output = ();
    // AVX-512 gains a tenth although palettes are transposed: a dual quaternion blend has more in its hands than
    // sixteen registers hold.

    #[inline(always)]
    fn run<V: Level>(self, level: V) {
        let Self { skin, blend, first, rest, mut posed } = self;
        let lanes = Register::<P, V, 3>::LANES;
        let mut influences = skin.scratch();
        for tile in storage::tiles::<P, V, 3>(posed.positions.len()) {
            let vertex = first + tile.element * P::Layout::THINGS + tile.register * lanes;
            skin.read::<B, _>(vertex, lanes, 0, &mut influences);
            let Some(mut sum) = blend.sum::<Register<P, V, 3>, _>(level, &mut influences) else {
                return;
            };
            for group in 1..skin.groups() {
                skin.read::<B, _>(vertex, lanes, group, &mut influences);
                let Some(more) = blend.sum(level, &mut influences) else { return };
                sum = blend.join(sum, more);
            }
            let map = blend.map(level, sum, vertex);
            let Some(point) = vectors(level, rest.positions, tile) else { return };
            P::store(map.point(point), posed.positions, tile);
            if let (Some(from), Some(to)) = (rest.normals, posed.normals.as_deref_mut()) {
                let Some(normal) = vectors(level, from, tile) else { return };
                P::store(map.normal(normal), to, tile);
            }
            if let (Some(from), Some(to)) = (rest.tangents, posed.tangents.as_deref_mut()) {
                let Some(tangent) = vectors(level, from, tile) else { return };
                P::store(map.tangent(tangent), to, tile);
            }
        }
    }
}

/// The vectors of a tile; zero in lanes beyond the end of `slice`.
#[inline(always)]
fn vectors<P: Element<3>, V: Level>(
    level: V,
    slice: &[P],
    tile: Tile,
) -> Option<[Register<P, V, 3>; 3]> {
    P::load(level, slice, tile, &storage::identity())
}

use super::element::Tile;
use super::element::{Element, Layout, sealed};
use crate::number::Scalar;
use core::marker::PhantomData;
use dq8_simd::{Lanes, Level, Native, Row};

/// `N` things of `C` components each, stored as `C` rows: row `c` holds component `c` of all `N`
/// things. By default `C` is 8 and the things are motions [px, py, pz, pw, qx, qy, qz, qw].
/// `Block<f32, 8>` is 256 bytes; `Block<f32, 8, 3>` holds eight points.
pub type Block<R, const N: usize, const C: usize = 8> = dq8_simd::Block<[R; N], C>;

/// The layout *array of structures of arrays*: a block holds [`Row::LANES`] things, with one row of
/// type `A` for each component. Kernels load a row without a transpose, one register after the
/// other.
#[derive(Clone, Copy, Debug)]
pub struct AoSoA<A>(PhantomData<A>);

impl<A: Row<Real: Scalar>> sealed::Sealed for AoSoA<A> {}
impl<A: Row<Real: Scalar>> Layout for AoSoA<A> {
    type Real = A::Real;
    type Record<const C: usize> = dq8_simd::Block<A, C>;
    type Register<V: Level> = Native<A, V>;
    const THINGS: usize = A::LANES;
    const WIDE: bool = true;
    // Stores that bypass the caches are quicker for large outputs only. This crate has such stores
    // for x86-64 only.
    const STREAMS: bool = cfg!(target_arch = "x86_64");
}

impl<A, const C: usize> sealed::Sealed for dq8_simd::Block<A, C> {}
impl<A: Row<Real: Scalar>, const C: usize> Element<C> for dq8_simd::Block<A, C> {
    type Layout = AoSoA<A>;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load<V: Level>(
        level: V,
        from: &[Self],
        tile: Tile,
        _: &[A::Real; C],
    ) -> Option<[Native<A, V>; C]> {
        Some(from.get(tile.element)?.load_part(level, tile.register))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn store<V: Level>(components: [Native<A, V>; C], to: &mut [Self], tile: Tile) {
        if let Some(block) = to.get_mut(tile.element) {
            block.store_part::<V>(components, tile.register);
        }
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn copy<V: Level>(_: V, rows: &[<Native<A, V> as Lanes>::Array], to: &mut [Self], tile: Tile) {
        if let Some(block) = to.get_mut(tile.element) {
            block.copy_part::<V>(rows, tile.register);
        }
    }
    #[inline]
    fn get(slice: &[Self], index: usize) -> Option<[A::Real; C]> {
        slice.get(index / A::LANES)?.get(index % A::LANES)
    }
    #[inline]
    fn set(slice: &mut [Self], index: usize, thing: [A::Real; C]) {
        if let Some(block) = slice.get_mut(index / A::LANES) {
            // The lane exists, because the index is taken modulo `A::LANES`, so `set` cannot fail.
            let _ = block.set(index % A::LANES, thing);
        }
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn stream<V: Level>(
        level: V,
        to: &mut [Self],
        mut each: impl FnMut(Tile) -> Option<[Native<A, V>; C]>,
    ) {
        Self::stream(
            level,
            to,
            #[cfg_attr(not(opt_level_0), inline(always))]
            |element, register| each(Tile::at(element, register)),
        );
    }
}

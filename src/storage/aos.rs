//! [`Aos`], the layout of plain records that lie one after the other, and [`LinearFirst`], a twist
//! whose linear part comes first.

use super::element::Tile;
use super::element::{Element, Layout, Register, sealed};
use crate::geometry::{Line, Plane, Twist};
use crate::macros::conversions;
use crate::number::Scalar;
use crate::representation::RotationTranslation;
use crate::scalar::{DualQuat, Quat};
use core::marker::PhantomData;
use dq8_simd::{Float, Lanes, Level, Records};

/// The layout *array of structures*: things (motions, points and so on) lie one after the other in
/// memory, and kernels transpose them in registers when they load and store them. If the compiler
/// reports that it expects `Aos<f32>` and finds `Aos<f64>`, the call mixes two precisions: a slice
/// of bare literals such as `&[0.5; 4]` has elements of type `f64`; write `&[0.5_f32; 4]`.
#[derive(Clone, Copy, Debug)]
pub struct Aos<R>(PhantomData<R>);

impl<R: Scalar> sealed::Sealed for Aos<R> {}
impl<R: Scalar> Layout for Aos<R> {
    type Real = R;
    type Record<const C: usize> = [R; C];
    type Register<V: Level> = R::Lanes<V>;
    const THINGS: usize = 1;
    // Transposes consist of shuffles. With AVX-512 these would run on one port of the CPU instead
    // of two: products would take 2.2 ns instead of 1.8 ns, points 0.69 ns instead of 0.52 ns.
    const WIDE: bool = false;
    // Stores that bypass the caches must write whole cache lines, but records are smaller than a
    // line.
    const STREAMS: bool = false;
}

/// Reads the records of a tile into lanes, one register for each component.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(crate) fn load<L: Lanes, const C: usize>(
    level: L::Level,
    from: &[[L::Real; C]],
    tile: Tile,
    padding: &[L::Real; C],
) -> Option<[L; C]> {
    let from = from.get(tile.element..)?;
    Some(L::load_strided(level, from, tile.stride, padding))
}

/// Writes the records of a tile from lanes, one register for each component.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(crate) fn store<L: Lanes, const C: usize>(
    components: [L; C],
    to: &mut [[L::Real; C]],
    tile: Tile,
) {
    if let Some(to) = to.get_mut(tile.element..) {
        L::store_strided(components, to, tile.stride);
    }
}

/// Implements [`Element`] for types that consist of `C` components and nothing else, so that a
/// slice of them can be cast to a slice of arrays `[R; C]`.
macro_rules! casts {
    ($($thing:ty: $components:tt of $real:ident $(, any $any:ident)? $(, any size $size:ident)?;)*) => {$(
        impl<$($any: Scalar,)? $(const $size: usize)?> Element<$components> for $thing {
            type Layout = Aos<$real>;

            #[cfg_attr(not(opt_level_0), inline(always))]
            fn load<V: Level>(
                level: V,
                from: &[Self],
                tile: Tile,
                padding: &[$real; $components],
            ) -> Option<[<$real as Float>::Lanes<V>; $components]> {
                load(level, bytemuck::must_cast_slice(from), tile, padding)
            }
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn store<V: Level>(
                components: [<$real as Float>::Lanes<V>; $components],
                to: &mut [Self],
                tile: Tile,
            ) {
                store(components, bytemuck::must_cast_slice_mut(to), tile);
            }
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn get(slice: &[Self], index: usize) -> Option<[$real; $components]> {
                Some(bytemuck::must_cast(*slice.get(index)?))
            }
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn set(slice: &mut [Self], index: usize, thing: [$real; $components]) {
                if let Some(slot) = slice.get_mut(index) {
                    *slot = bytemuck::must_cast(thing);
                }
            }
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn plain(slice: &[Self]) -> Option<&[[$real; $components]]> {
                Some(bytemuck::must_cast_slice(slice))
            }
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn plain_mut(slice: &mut [Self]) -> Option<&mut [[$real; $components]]> {
                Some(bytemuck::must_cast_slice_mut(slice))
            }
        }
    )*};
}
casts! {
    [R; C]: C of R, any R, any size C;
    f32: 1 of f32;
    f64: 1 of f64;
    Quat<R>: 4 of R, any R;
    Plane<R>: 4 of R, any R;
    Line<R>: 6 of R, any R;
    Twist<R>: 6 of R, any R;
    RotationTranslation<R>: 7 of R, any R;
    DualQuat<R>: 8 of R, any R;
    [[R; 4]; 3]: 12 of R, any R;
    [[R; 4]; 4]: 16 of R, any R;
    [[R; 6]; 6]: 36 of R, any R;
}

impl sealed::Sealed for f32 {}
impl sealed::Sealed for f64 {}
impl<R> sealed::Sealed for Quat<R> {}
impl<R> sealed::Sealed for Plane<R> {}
impl<R> sealed::Sealed for Line<R> {}
impl<R> sealed::Sealed for Twist<R> {}
impl<R> sealed::Sealed for RotationTranslation<R> {}
impl<R> sealed::Sealed for DualQuat<R> {}
impl<T, const N: usize> sealed::Sealed for [T; N] {}

crate::macros::pod! {
    /// A twist in memory as `[vx, vy, vz, ωx, ωy, ωz]`, the order of pinocchio and of many
    /// controllers; `[R; 6]`, [`Twist`] and a [`Block`](super::Block) of six rows have the angular
    /// part first. It may hold any six components in this order: a column of a Jacobian, a
    /// velocity, an acceleration. An array of six `LinearFirst` is a matrix whose rows and columns
    /// have this order, such as a covariance.
    ///
    /// ```
    /// use dq8::{Twist, storage::LinearFirst};
    /// // A wheel two metres away turns about z.
    /// let spin = Twist { angular: [0.0, 0.0, 1.0], linear: [0.0, -2.0, 0.0] };
    /// assert_eq!(LinearFirst::from(spin), LinearFirst([0.0, -2.0, 0.0, 0.0, 0.0, 1.0]));
    /// assert_eq!(Twist::from(LinearFirst::from(spin)), spin);
    /// ```
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct LinearFirst<R>(pub [R; 6]);
}

/// Swaps the angular and the linear half of a twist's six components.
#[cfg_attr(not(opt_level_0), inline(always))]
const fn other<T: Copy>([a, b, c, d, e, f]: [T; 6]) -> [T; 6] {
    [d, e, f, a, b, c]
}

conversions! {
    [R: Copy] Twist<R> => LinearFirst<R>: |twist| Self(other(twist.to_array()));
    [R: Copy] LinearFirst<R> => Twist<R>: |twist| Self::from_array(other(twist.0));
}

impl<R> sealed::Sealed for LinearFirst<R> {}
impl<R: Scalar> Element<6> for LinearFirst<R> {
    type Layout = Aos<R>;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load<V: Level>(
        level: V,
        from: &[Self],
        tile: Tile,
        padding: &[R; 6],
    ) -> Option<[Register<Self, V, 6>; 6]> {
        let numbers = load(level, bytemuck::must_cast_slice(from), tile, &other(*padding))?;
        Some(other(numbers))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn store<V: Level>(components: [<R as Float>::Lanes<V>; 6], to: &mut [Self], tile: Tile) {
        store(other(components), bytemuck::must_cast_slice_mut(to), tile);
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn get(slice: &[Self], index: usize) -> Option<[R; 6]> {
        slice.get(index).map(|twist| other(twist.0))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn set(slice: &mut [Self], index: usize, thing: [R; 6]) {
        if let Some(slot) = slice.get_mut(index) {
            *slot = Self(other(thing));
        }
    }
}

/// Swaps the first three rows of a 6×6 matrix with the last three rows, and its first three
/// columns with the last three columns.
#[cfg_attr(not(opt_level_0), inline(always))]
fn others<T: Copy>(matrix: [T; 36]) -> [T; 36] {
    let mut changed = matrix;
    for row in 0..6 {
        for column in 0..6 {
            changed[6 * ((row + 3) % 6) + (column + 3) % 6] = matrix[6 * row + column];
        }
    }
    changed
}

impl<R: Scalar> Element<36> for [LinearFirst<R>; 6] {
    type Layout = Aos<R>;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load<V: Level>(
        level: V,
        from: &[Self],
        tile: Tile,
        padding: &[R; 36],
    ) -> Option<[Register<Self, V, 36>; 36]> {
        let padding = &others(*padding);
        Some(others(load(level, bytemuck::must_cast_slice(from), tile, padding)?))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn store<V: Level>(components: [<R as Float>::Lanes<V>; 36], to: &mut [Self], tile: Tile) {
        store(others(components), bytemuck::must_cast_slice_mut(to), tile);
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn get(slice: &[Self], index: usize) -> Option<[R; 36]> {
        slice.get(index).map(|matrix| others(bytemuck::must_cast(*matrix)))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn set(slice: &mut [Self], index: usize, thing: [R; 36]) {
        if let Some(slot) = slice.get_mut(index) {
            *slot = bytemuck::must_cast(others(thing));
        }
    }
}

//! [`Place`]: how components lie in memory, plain or in blocks of lanes.

use crate::dispatch::Backend;
use crate::real::Real;
use crate::scalar::{DualQuat, Quat};
use core::marker::PhantomData;
use dq8_simd::{Block, Float, Lanes, Level, Native, Row};

/// One number for each of `N` motions.
pub type NumberBlock<R, const N: usize> = Block<[R; N], 1>;
/// `N` points or vectors: rows of x, y and z.
pub type PointBlock<R, const N: usize> = Block<[R; N], 3>;
/// `N` 3×4 matrices: their rows one after the other, twelve rows of `N` numbers.
pub type MatrixBlock<R, const N: usize> = Block<[R; N], 12>;

/// Which lanes a place is read into; a kernel reads all its slices into the same. Sealed.
pub trait Layout: sealed::Sealed {
    /// The number.
    type Real: Real + Float;
    /// The best backend for this layout; a better one computes with it.
    const MOST: Backend;
    /// The lanes.
    type Lanes<V: Level>: Lanes<Real = Self::Real, Level = V>;
}

/// One thing an element: arrays of structures. They are transposed on the way into the widest lanes
/// of the backend, and back on the way out.
#[derive(Clone, Copy, Debug)]
pub struct Plain<R>(PhantomData<R>);

/// [`Row::LANES`] things an element: [`Block`]s, structures of arrays. They are read as they are, a
/// register at a time.
#[derive(Clone, Copy, Debug)]
pub struct InBlocks<A>(PhantomData<A>);

impl<R: Real + Float> Layout for Plain<R> {
    type Real = R;
    // Transposes are shuffles, and the compiler makes AVX-512 shuffles of them, which run on one port
    // instead of two: products take 2.2 ns instead of 1.8, points 0.69 instead of 0.52.
    const MOST: Backend = Backend::Avx2;
    type Lanes<V: Level> = R::Lanes<V>;
}

impl<A: Row<Real: Real>> Layout for InBlocks<A> {
    type Real = A::Real;
    const MOST: Backend = Backend::MOST;
    type Lanes<V: Level> = Native<A, V>;
}

/// An element of memory with `C` components: of one thing, or of several in a block. Sealed.
///
/// | `C` | what | one an element | `N` an element |
/// |---|---|---|---|
/// | 1 | a number | `R` | `Block<[R; N], 1>` |
/// | 3 | a point or a vector | `[R; 3]` | `Block<[R; N], 3>` |
/// | 4 | a rotation | [`Quat<R>`](Quat) | `Block<[R; N], 4>` |
/// | 7 | a rotation and a translation | `[R; 7]`: `[x, y, z, w, tx, ty, tz]` | `Block<[R; N], 7>` |
/// | 8 | a motion | [`DualQuat<R>`](DualQuat) | `Block<[R; N], 8>` |
/// | 12 | a 3×4 matrix | `[R; 12]`, `[[R; 4]; 3]` | `Block<[R; N], 12>` |
/// | 16 | a 4×4 matrix | `[R; 16]`, `[[R; 4]; 4]` | `Block<[R; N], 16>` |
pub trait Place<const C: usize>: Copy + sealed::Sealed {
    /// Which lanes it is read into.
    type Layout: Layout;

    /// How many turns of a kernel go over `length` elements.
    #[must_use]
    fn turns<V: Level>(length: usize) -> usize;
    /// How many steps a turn has: a step fills a register of each component.
    #[must_use]
    fn parts<V: Level>() -> usize;
    /// Into lanes what belongs to a step; `padding` where `from` has ended, and nothing beyond it.
    fn gather<V: Level>(
        level: V,
        from: &[Self],
        step: Step,
        padding: [Number<Self, C>; C],
    ) -> Option<[Register<Self, V, C>; C]>;
    /// [`scatter`](Self::scatter) of every step, past the caches where that exists. The first `None` of
    /// `each` ends.
    fn stream<V: Level>(
        level: V,
        to: &mut [Self],
        each: impl FnMut(Step) -> Option<[Register<Self, V, C>; C]>,
    );
    /// Lanes to where they belong in a step; what is beyond the end of `to` is dropped.
    fn scatter<V: Level>(components: [Register<Self, V, C>; C], to: &mut [Self], step: Step);
}

/// Which elements, and which of their parts.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    pub(crate) turn: usize,
    pub(crate) part: usize,
}

/// The number of a place.
pub type Number<P, const C: usize> = <<P as Place<C>>::Layout as Layout>::Real;
/// The lanes that a place is read into.
pub type Register<P, V, const C: usize> = <<P as Place<C>>::Layout as Layout>::Lanes<V>;

impl<A: Row<Real: Real>, const C: usize> Place<C> for Block<A, C> {
    type Layout = InBlocks<A>;

    #[inline(always)]
    fn turns<V: Level>(length: usize) -> usize {
        length
    }
    #[inline(always)]
    fn parts<V: Level>() -> usize {
        Self::parts::<V>()
    }
    #[inline(always)]
    fn gather<V: Level>(
        level: V,
        from: &[Self],
        step: Step,
        _: [A::Real; C],
    ) -> Option<[Native<A, V>; C]> {
        Some(from.get(step.turn)?.load_part(level, step.part))
    }
    #[inline(always)]
    fn stream<V: Level>(
        level: V,
        to: &mut [Self],
        mut each: impl FnMut(Step) -> Option<[Native<A, V>; C]>,
    ) {
        Self::stream(
            level,
            to,
            #[inline(always)]
            |turn, part| each(Step { turn, part }),
        );
    }
    #[inline(always)]
    fn scatter<V: Level>(components: [Native<A, V>; C], to: &mut [Self], step: Step) {
        if let Some(block) = to.get_mut(step.turn) {
            block.store_part::<V>(components, step.part);
        }
    }
}

/// Records of `C` numbers: the types differ, the bytes do not.
macro_rules! plain {
    ($($real:ident $(= $any:ident)?, $record:ty, $components:literal;)*) => {$(
        impl$(<$any: Real + Float>)? Place<$components> for $record {
            type Layout = Plain<$real>;

            #[inline(always)]
            fn turns<V: Level>(length: usize) -> usize {
                length.div_ceil(<$real as Float>::Lanes::<V>::LANES)
            }
            #[inline(always)]
            fn parts<V: Level>() -> usize {
                1
            }
            #[inline(always)]
            fn gather<V: Level>(
                level: V,
                from: &[Self],
                step: Step,
                padding: [$real; $components],
            ) -> Option<[<$real as Float>::Lanes<V>; $components]> {
                let records: &[[$real; $components]] = bytemuck::must_cast_slice(from);
                let first = step.turn * <$real as Float>::Lanes::<V>::LANES;
                Some(<$real as Float>::Lanes::<V>::load_records(level, records.get(first..)?, padding))
            }
            #[inline(always)]
            fn stream<V: Level>(
                _: V,
                to: &mut [Self],
                mut each: impl FnMut(Step) -> Option<[<$real as Float>::Lanes<V>; $components]>,
            ) {
                // Records are pieces of cache lines, which cannot be written past the caches.
                for turn in 0..<Self as Place<$components>>::turns::<V>(to.len()) {
                    let step = Step { turn, part: 0 };
                    let Some(components) = each(step) else { return };
                    <Self as Place<$components>>::scatter::<V>(components, to, step);
                }
            }
            #[inline(always)]
            fn scatter<V: Level>(
                components: [<$real as Float>::Lanes<V>; $components],
                to: &mut [Self],
                step: Step,
            ) {
                let records: &mut [[$real; $components]] = bytemuck::must_cast_slice_mut(to);
                let first = step.turn * <$real as Float>::Lanes::<V>::LANES;
                let records = records.get_mut(first..).unwrap_or_default();
                <$real as Float>::Lanes::<V>::store_records(components, records);
            }
        }
    )*};
}
plain! {
    f32, f32, 1;
    f64, f64, 1;
    R = R, [R; 3], 3;
    R = R, Quat<R>, 4;
    R = R, [R; 7], 7;
    R = R, DualQuat<R>, 8;
    R = R, [R; 12], 12;
    R = R, [[R; 4]; 3], 12;
    R = R, [R; 16], 16;
    R = R, [[R; 4]; 4], 16;
}

mod sealed {
    use super::{Block, DualQuat, InBlocks, Plain, Quat};
    pub trait Sealed {}
    impl<R> Sealed for Plain<R> {}
    impl<A> Sealed for InBlocks<A> {}
    impl<A, const C: usize> Sealed for Block<A, C> {}
    impl<R> Sealed for Quat<R> {}
    impl<R> Sealed for DualQuat<R> {}
    impl<T, const N: usize> Sealed for [T; N] {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
}

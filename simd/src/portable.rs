//! [`Portable`]: the level of the build target, whose lanes are the vectors of the crate [`wide`].

#[cfg(all(target_arch = "aarch64", target_feature = "neon", target_endian = "little"))]
use crate::aarch64::{f32x4 as singles, f64x2 as doubles};
use crate::internal::square_root::VECTORS;
#[cfg(not(all(target_arch = "aarch64", target_feature = "neon", target_endian = "little")))]
use crate::lanes::PackedDualQuat;
use crate::lanes::{Lanes, Level, Mask};
use crate::shorts::{Shorts, four_at_once, one_by_one};
#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
use crate::wasm32 as singles;
#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
use crate::x86_64::f32x4 as singles;
use core::ops::{BitAnd, BitOr, Not};
use wide::{Select, f32x4, f32x8, f32x16, f64x2, f64x4, f64x8};

/// The level of the build target's instructions: SSE2 for a default x86-64 build, AVX2 with
/// `-C target-cpu=x86-64-v3`, NEON on aarch64, simd128 on wasm, and scalar code elsewhere.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Portable;

impl crate::sealed::Sealed for Portable {}
impl Level for Portable {
    type F32x4 = f32x4;
    type F32x8 = f32x8;
    type F32x16 = f32x16;
    type F64x2 = f64x2;
    type F64x4 = f64x4;
    type F64x8 = f64x8;
    type Single = part::F32x16;
    type Double = part::F64x8;

    #[inline(always)]
    fn run<R>(self, kernel: impl FnOnce() -> R) -> R {
        kernel()
    }
}

/// The lanes of one register of the build target, for each vector of `wide` ([`Lanes::Native`]). A
/// register has at most 256 bits with AVX, and 128 bits with SSE2, NEON or simd128. On a target
/// without vector registers the lanes are a single float, because `wide` would emulate vectors
/// there.
mod part {
    #[cfg(not(any(
        target_feature = "avx",
        target_feature = "sse2",
        target_feature = "neon",
        target_feature = "simd128"
    )))]
    pub(super) use core::primitive::{
        f32 as F32x4, f32 as F32x8, f32 as F32x16, f64 as F64x2, f64 as F64x4, f64 as F64x8,
    };
    #[cfg(all(
        not(target_feature = "avx"),
        any(target_feature = "sse2", target_feature = "neon", target_feature = "simd128")
    ))]
    pub(super) use wide::{
        f32x4 as F32x4, f32x4 as F32x8, f32x4 as F32x16, f64x2 as F64x2, f64x2 as F64x4,
        f64x2 as F64x8,
    };
    #[cfg(target_feature = "avx")]
    pub(super) use wide::{
        f32x4 as F32x4, f32x8 as F32x8, f32x8 as F32x16, f64x2 as F64x2, f64x4 as F64x4,
        f64x4 as F64x8,
    };
}

/// A mask of [`wide`]: a vector in which each lane has all bits one (true) or all bits zero
/// (false).
#[derive(Clone, Copy, Debug)]
pub struct WideMask<V>(V);

/// The multiply-adds of WebAssembly's relaxed-simd, which round once if the host CPU has a fused
/// multiply-add. The multiply-adds of `wide` always round twice on WebAssembly.
#[cfg(target_feature = "relaxed-simd")]
mod relaxed {
    use core::arch::wasm32::{
        f32x4_relaxed_madd, f32x4_relaxed_nmadd, f64x2_relaxed_madd, f64x2_relaxed_nmadd, v128,
    };
    use wide::{f32x4, f32x8, f32x16, f64x2, f64x4, f64x8};

    pub(super) trait Relaxed: Copy {
        /// Returns self · factor + addend.
        fn madd(self, factor: Self, addend: Self) -> Self;
        /// Returns addend − self · factor.
        fn nmadd(self, factor: Self, addend: Self) -> Self;
    }

    macro_rules! relaxed {
        ($($vector:ident: $registers:literal, $madd:ident, $nmadd:ident;)*) => {$(
            impl Relaxed for $vector {
                #[inline(always)]
                fn madd(self, factor: Self, addend: Self) -> Self {
                    each::<$vector, $registers>(self, factor, addend, |a, b, c| $madd(a, b, c))
                }
                #[inline(always)]
                fn nmadd(self, factor: Self, addend: Self) -> Self {
                    each::<$vector, $registers>(self, factor, addend, |a, b, c| $nmadd(a, b, c))
                }
            }
            // A vector of `wide` must consist of whole registers, because `each` transmutes it to
            // them.
            const _: () = assert!(size_of::<$vector>() == $registers * size_of::<v128>());
        )*};
    }
    relaxed! {
        f32x4: 1, f32x4_relaxed_madd, f32x4_relaxed_nmadd;
        f32x8: 2, f32x4_relaxed_madd, f32x4_relaxed_nmadd;
        f32x16: 4, f32x4_relaxed_madd, f32x4_relaxed_nmadd;
        f64x2: 1, f64x2_relaxed_madd, f64x2_relaxed_nmadd;
        f64x4: 2, f64x2_relaxed_madd, f64x2_relaxed_nmadd;
        f64x8: 4, f64x2_relaxed_madd, f64x2_relaxed_nmadd;
    }

    /// Calls `of` with each register of `a` and the same registers of `b` and `c`, and returns the
    /// results as a vector.
    #[inline(always)]
    fn each<V: Copy, const N: usize>(a: V, b: V, c: V, of: impl Fn(v128, v128, v128) -> v128) -> V {
        // SAFETY: `V` is plain floats and has the size of `N` registers, as `relaxed!` asserts for
        // every `V`, and any bits are a valid `v128`.
        let [mut a, b, c] =
            [a, b, c].map(|vector| unsafe { core::mem::transmute_copy::<V, [v128; N]>(&vector) });
        for ((a, b), c) in a.iter_mut().zip(b).zip(c) {
            *a = of(*a, b, c);
        }
        // SAFETY: `V` has the size of `N` registers, as `relaxed!` asserts for every `V`, and any
        // bits are valid floats.
        unsafe { core::mem::transmute_copy::<[v128; N], V>(&a) }
    }
}

/// Implements [`Lanes`] and [`Mask`] for the vectors of `wide`. This is a macro, because the
/// operations of these vectors are inherent methods, which no generic `impl` can call.
macro_rules! wide_lanes {
    ($($vector:ident: [$real:ty; $lanes:literal], $part:ty, $between:ident $(, $transpose:ident)? $(quads $quads:ident)? $(records $records:ident)? $(=> $half:ident)?;)*) => {$(
        impl crate::sealed::Sealed for $vector {}
        impl Lanes for $vector {
            type Real = $real;
            type Mask = WideMask<$vector>;
            type Level = Portable;
            type Native = $part;
            type Array = [$real; $lanes];
            const LANES: usize = $lanes;

            #[inline(always)]
            fn level(self) -> Portable {
                Portable
            }
            #[inline(always)]
            fn splat(_: Portable, value: $real) -> Self {
                <$vector>::splat(value)
            }
            #[inline(always)]
            fn load(_: Portable, from: &[$real; $lanes]) -> Self {
                <$vector>::new(*from)
            }
            #[inline(always)]
            fn store(self, to: &mut [$real; $lanes]) {
                *to = <$vector>::to_array(self);
            }
            $(
                #[inline(always)]
                unsafe fn load_quads(
                    _: Portable,
                    from: *const $real,
                    offset: impl Fn(usize) -> usize,
                ) -> [Self; 4] {
                    let mut rows = [Self::ZERO; 4];
                    for (i, row) in rows.iter_mut().enumerate() {
                        // SAFETY: this vector has four lanes, so the row is four components. The
                        // caller guarantees that the four components from `from + offset(i)` on are
                        // readable for each lane `i`, and an array has the alignment of its
                        // elements.
                        *row = Self::new(unsafe { *from.add(offset(i)).cast::<[$real; $lanes]>() });
                    }
                    Self::$transpose(rows)
                }
                #[inline(always)]
                unsafe fn store_quads(components: [Self; 4], to: *mut $real, stride: usize) {
                    for (i, row) in Self::$transpose(components).iter().enumerate() {
                        // SAFETY: this vector has four lanes, so the row is four components. The
                        // caller guarantees that the four components from `to + i · stride` on are
                        // writable for each lane `i`, and an array has the alignment of its
                        // elements.
                        unsafe { *to.add(i * stride).cast::<[$real; $lanes]>() = row.to_array() };
                    }
                }
                #[inline(always)]
                fn sum_quads(vectors: [Self; 4]) -> Self {
                    #[cfg(any(
                        all(target_arch = "aarch64", target_feature = "neon", target_endian = "little"),
                        all(target_arch = "wasm32", target_feature = "simd128")
                    ))]
                    return singles::sum_quads(vectors);
                    #[cfg(not(any(
                        all(target_arch = "aarch64", target_feature = "neon", target_endian = "little"),
                        all(target_arch = "wasm32", target_feature = "simd128")
                    )))]
                    {
                        let [a, b, c, d] = Self::$transpose(vectors);
                        (a + c) + (b + d)
                    }
                }
            )?
            $(
                #[inline(always)]
                unsafe fn load_quads(
                    _: Portable,
                    from: *const $real,
                    offset: impl Fn(usize) -> usize,
                ) -> [Self; 4] {
                    // SAFETY: `load_quads` reads the four components from `from + offset(i)` on for
                    // each lane `i`, which the caller guarantees to be readable.
                    unsafe { $quads::load_quads(from, offset) }
                }
                #[inline(always)]
                unsafe fn store_quads(components: [Self; 4], to: *mut $real, stride: usize) {
                    // SAFETY: `store_quads` writes the four components from `to + i · stride` on
                    // for each lane `i`, which the caller guarantees to be writable.
                    unsafe { $quads::store_quads(components, to, stride) }
                }
            )?
            $(
                #[inline(always)]
                unsafe fn store_triples(components: [Self; 3], to: *mut $real) {
                    // SAFETY: `store_triples` writes three components per lane from `to` on, which
                    // the caller guarantees to be writable.
                    unsafe { $records::store_triples(components, to) }
                }
                #[inline(always)]
                unsafe fn store_adjoining<const C: usize>(
                    components: [Self; C],
                    to: *mut $real,
                ) -> bool {
                    // SAFETY: `store_adjoining` writes `C` components per lane from `to` on, which
                    // the caller guarantees to be writable.
                    unsafe { $records::store_adjoining(components, to) }
                }
                #[inline(always)]
                unsafe fn load_adjoining<const C: usize>(
                    _: Portable,
                    from: *const $real,
                ) -> Option<[Self; C]> {
                    // SAFETY: `load_adjoining` reads `C` components per lane from `from` on, which
                    // the caller guarantees to be readable.
                    unsafe { $records::load_adjoining::<C>(from) }
                }
            )?
            $(
                #[inline(always)]
                unsafe fn load_quads(
                    level: Portable,
                    from: *const $real,
                    offset: impl Fn(usize) -> usize,
                ) -> [Self; 4] {
                    // SAFETY: the lower half reads four components at `from + offset(i)` for the
                    // lanes `i` below `$lanes / 2`, and the upper half for the lanes from
                    // `$lanes / 2` on. The caller guarantees that these components are readable for
                    // all lanes.
                    let [[a, b, c, d], [e, f, g, h]] = unsafe {
                        let upper = |lane| offset($lanes / 2 + lane);
                        [$half::load_quads(level, from, &offset), $half::load_quads(level, from, upper)]
                    };
                    [[a, e], [b, f], [c, g], [d, h]].map(bytemuck::cast)
                }
                #[inline(always)]
                unsafe fn store_quads(components: [Self; 4], to: *mut $real, stride: usize) {
                    let halves = components.map(|vector| bytemuck::cast::<Self, [$half; 2]>(vector));
                    // SAFETY: the lower half writes four components at `to + i · stride` for the
                    // lanes `i` below `$lanes / 2`, and the upper half for the lanes from
                    // `$lanes / 2` on. The caller guarantees that these components are writable for
                    // all lanes.
                    unsafe {
                        $half::store_quads(halves.map(|half| half[0]), to, stride);
                        let upper = to.add($lanes / 2 * stride);
                        $half::store_quads(halves.map(|half| half[1]), upper, stride);
                    }
                }
                // This replaces the loop over lanes in `Lanes::sum_quads`. The compiler would store
                // the vectors of that loop to memory and reload them, which takes five times as
                // long with SSE2. It would also call `map` as a function that takes its vectors
                // from memory, if the two sums were computed by `map`.
                #[inline(always)]
                fn sum_quads([a, b, c, d]: [Self; 4]) -> Self {
                    let [a, b, c, d]: [[$half; 2]; 4] =
                        [bytemuck::cast(a), bytemuck::cast(b), bytemuck::cast(c), bytemuck::cast(d)];
                    let lower = $half::sum_quads([a[0], b[0], c[0], d[0]]);
                    let upper = $half::sum_quads([a[1], b[1], c[1], d[1]]);
                    bytemuck::cast([lower, upper])
                }
            )?
            #[inline(always)]
            unsafe fn between_shorts(
                _: Portable,
                from: *const Shorts,
                records: impl Fn(usize) -> [usize; 2],
                t: Self,
            ) -> [Self; 4] {
                // SAFETY: `$between` reads the two records that `records` names for each lane,
                // which the caller guarantees to be readable.
                unsafe { $between(Portable, from, records, t) }
            }
            #[inline(always)]
            fn mul_add(self, factor: Self, addend: Self) -> Self {
                #[cfg(target_feature = "relaxed-simd")]
                return relaxed::Relaxed::madd(self, factor, addend);
                #[cfg(not(target_feature = "relaxed-simd"))]
                <$vector>::mul_add(self, factor, addend)
            }
            #[inline(always)]
            fn neg_mul_add(self, factor: Self, addend: Self) -> Self {
                #[cfg(target_feature = "relaxed-simd")]
                return relaxed::Relaxed::nmadd(self, factor, addend);
                #[cfg(not(target_feature = "relaxed-simd"))]
                <$vector>::mul_neg_add(self, factor, addend)
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                if VECTORS {
                    return <$vector>::sqrt(self);
                }
                Self::new(self.to_array().map(<$real as Lanes>::sqrt))
            }
            #[inline(always)]
            fn abs(self) -> Self {
                <$vector>::abs(self)
            }
            #[inline(always)]
            fn copysign(self, sign: Self) -> Self {
                let sign_bit = <$vector>::splat(-0.0);
                (self & !sign_bit) | (sign & sign_bit)
            }
            #[inline(always)]
            fn lt(self, other: Self) -> Self::Mask {
                WideMask(<$vector>::simd_lt(self, other))
            }
            #[inline(always)]
            fn le(self, other: Self) -> Self::Mask {
                WideMask(<$vector>::simd_le(self, other))
            }
            #[inline(always)]
            fn eq(self, other: Self) -> Self::Mask {
                WideMask(<$vector>::simd_eq(self, other))
            }
            #[inline(always)]
            fn select(mask: Self::Mask, yes: Self, no: Self) -> Self {
                Select::select(mask.0, yes, no)
            }
        }

        impl Mask for WideMask<$vector> {
            const LANES: u32 = $lanes;
            #[inline(always)]
            fn any(self) -> bool {
                self.0.any()
            }
            #[inline(always)]
            fn all(self) -> bool {
                self.0.all()
            }
            #[inline(always)]
            fn to_bitmask(self) -> u32 {
                self.0.to_bitmask()
            }
        }
    )*};
}
#[cfg(any(
    all(target_arch = "x86_64", target_feature = "sse2"),
    all(target_arch = "wasm32", target_feature = "simd128")
))]
wide_lanes! {
    f32x4: [f32; 4], part::F32x4, four_at_once, transpose records singles;
    f64x2: [f64; 2], part::F64x2, one_by_one;
}
#[cfg(not(any(
    all(target_arch = "aarch64", target_feature = "neon", target_endian = "little"),
    all(target_arch = "x86_64", target_feature = "sse2"),
    all(target_arch = "wasm32", target_feature = "simd128")
)))]
wide_lanes! {
    f32x4: [f32; 4], part::F32x4, four_at_once, transpose;
    f64x2: [f64; 2], part::F64x2, one_by_one;
}
#[cfg(all(target_arch = "aarch64", target_feature = "neon", target_endian = "little"))]
wide_lanes! {
    f32x4: [f32; 4], part::F32x4, four_at_once, transpose records singles;
    f64x2: [f64; 2], part::F64x2, one_by_one quads doubles records doubles;
}
wide_lanes! {
    f32x8: [f32; 8], part::F32x8, one_by_one => f32x4;
    f32x16: [f32; 16], part::F32x16, one_by_one;
    f64x4: [f64; 4], part::F64x4, one_by_one;
    f64x8: [f64; 8], part::F64x8, one_by_one;
}

impl<V: BitAnd<Output = V>> BitAnd for WideMask<V> {
    type Output = Self;
    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }
}

impl<V: BitOr<Output = V>> BitOr for WideMask<V> {
    type Output = Self;
    #[inline(always)]
    fn bitor(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
}

impl<V: Not<Output = V>> Not for WideMask<V> {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        Self(!self.0)
    }
}

#[cfg(not(all(target_arch = "aarch64", target_feature = "neon", target_endian = "little")))]
impl PackedDualQuat for f32x8 {}
#[cfg(not(all(target_arch = "aarch64", target_feature = "neon", target_endian = "little")))]
impl PackedDualQuat for f64x8 {}

//! Loads and stores of records of two and three `f32` for four lanes of WebAssembly, by shuffles of
//! simd128. The functions are those of `x86_64/f32x4.rs`, and so are the shuffles of triples.

use core::arch::wasm32::*;
use core::mem::transmute;
use wide::f32x4;

/// Implements [`Lanes::sum_quads`](crate::Lanes::sum_quads). The halves of two vectors are added
/// before their lanes are, which takes six shuffles; a transpose takes eight.
#[inline(always)]
pub(crate) fn sum_quads(vectors: [f32x4; 4]) -> f32x4 {
    // SAFETY: an `f32x4` is one register.
    let [a, b, c, d] = unsafe { transmute::<[f32x4; 4], [v128; 4]>(vectors) };
    // a₀+a₂ a₁+a₃ b₀+b₂ b₁+b₃
    let halves =
        |a, b| f32x4_add(i32x4_shuffle::<0, 1, 4, 5>(a, b), i32x4_shuffle::<2, 3, 6, 7>(a, b));
    let (ab, cd) = (halves(a, b), halves(c, d));
    let (even, odd) = (i32x4_shuffle::<0, 2, 4, 6>(ab, cd), i32x4_shuffle::<1, 3, 5, 7>(ab, cd));
    // SAFETY: an `f32x4` is one register.
    unsafe { transmute::<v128, f32x4>(f32x4_add(even, odd)) }
}

/// Implements [`Lanes::store_triples`](crate::Lanes::store_triples).
///
/// # Safety
/// The twelve `f32` from `to` on must be writable, and no other thread may use them during the
/// call.
#[inline(always)]
pub(crate) unsafe fn store_triples(components: [f32x4; 3], to: *mut f32) {
    // SAFETY: an `f32x4` is one register, and the caller guarantees that the twelve `f32` are
    // writable.
    unsafe {
        let [x, y, z] = transmute::<[f32x4; 3], [v128; 3]>(components);
        let xy = i32x4_shuffle::<0, 2, 4, 6>(x, y); // x₀ x₂ y₀ y₂
        let yz = i32x4_shuffle::<1, 3, 5, 7>(y, z); // y₁ y₃ z₁ z₃
        let zx = i32x4_shuffle::<0, 2, 5, 7>(z, x); // z₀ z₂ x₁ x₃
        let to = to.cast::<v128>();
        v128_store(to, i32x4_shuffle::<0, 2, 4, 6>(xy, zx)); // x₀ y₀ z₀ x₁
        v128_store(to.add(1), i32x4_shuffle::<0, 2, 5, 7>(yz, xy)); // y₁ z₁ x₂ y₂
        v128_store(to.add(2), i32x4_shuffle::<1, 3, 5, 7>(zx, yz)); // z₂ x₃ y₃ z₃
    }
}

/// Implements [`Lanes::store_adjoining`](crate::Lanes::store_adjoining) for records of two
/// components. Records of three components are stored by [`store_triples`].
///
/// # Safety
/// The `4 · C` floats from `to` on must be writable, and no other thread may use them during the
/// call.
#[inline(always)]
pub(crate) unsafe fn store_adjoining<const C: usize>(components: [f32x4; C], to: *mut f32) -> bool {
    let &[x, y] = components.as_slice() else { return false };
    // SAFETY: an `f32x4` is one register, and the caller guarantees that eight `f32` are writable
    // for the two components.
    unsafe {
        let [x, y] = transmute::<[f32x4; 2], [v128; 2]>([x, y]);
        let to = to.cast::<v128>();
        v128_store(to, i32x4_shuffle::<0, 4, 1, 5>(x, y));
        v128_store(to.add(1), i32x4_shuffle::<2, 6, 3, 7>(x, y));
    }
    true
}

/// Implements [`Lanes::load_adjoining`](crate::Lanes::load_adjoining) for records of two and three
/// components.
///
/// # Safety
/// The `4 · C` floats from `from` on must be readable.
#[inline(always)]
pub(crate) unsafe fn load_adjoining<const C: usize>(from: *const f32) -> Option<[f32x4; C]> {
    let mut to = [f32x4::ZERO; C];
    let from = from.cast::<v128>();
    // SAFETY: an `f32x4` is one register, and the caller guarantees that four records of C
    // components are readable.
    unsafe {
        match to.as_mut_slice() {
            [x, y] => {
                let (a, b) = (v128_load(from), v128_load(from.add(1))); // x₀ y₀ x₁ y₁, …
                *x = transmute::<v128, f32x4>(i32x4_shuffle::<0, 2, 4, 6>(a, b));
                *y = transmute::<v128, f32x4>(i32x4_shuffle::<1, 3, 5, 7>(a, b));
            }
            [x, y, z] => {
                let (a, b, c) = (v128_load(from), v128_load(from.add(1)), v128_load(from.add(2)));
                let xy = i32x4_shuffle::<2, 3, 5, 6>(b, c); // x₂ y₂ x₃ y₃
                let yz = i32x4_shuffle::<1, 2, 4, 5>(a, b); // y₀ z₀ y₁ z₁
                *x = transmute::<v128, f32x4>(i32x4_shuffle::<0, 3, 4, 6>(a, xy));
                *y = transmute::<v128, f32x4>(i32x4_shuffle::<0, 2, 5, 7>(yz, xy));
                *z = transmute::<v128, f32x4>(i32x4_shuffle::<1, 3, 4, 7>(yz, c));
            }
            _ => return None,
        }
    }
    Some(to)
}

//! Records from anywhere, transposed in registers.

use super::quads::*;
use super::{avx2, avx512};
use crate::gather::{Gather, Indices};
use crate::lane::Lane;

/// A lane type, its number, how many, and the transposes of four components.
macro_rules! gather {
    ($($name:ty = [$real:ident; $lanes:literal], $load_quads:ident, $store_quads:ident;)*) => {$(
        impl Gather for $name {
            #[inline(always)]
            fn gather<const C: usize>(
                level: Self::Level,
                from: &[[$real; C]],
                at: &Indices,
                first: usize,
            ) -> Option<[Self; C]> {
                const { assert!(C.is_multiple_of(4), "whole quads") }
                let at = at.within::<$lanes>(first, from.len())?;
                let mut components = [Self::splat(level, 0.0); C];
                for (quad, number) in components.chunks_exact_mut(4).zip((0..C).step_by(4)) {
                    let mut records = [from.as_ptr().cast::<$real>(); $lanes];
                    for (record, &index) in records.iter_mut().zip(at) {
                        *record = record.wrapping_add(index as usize * C + number);
                    }
                    // SAFETY: `level` proves the instructions. `within` says that the records are in
                    // the slice, and each pointer is four numbers before the end of one, or more.
                    let [x, y, z, w] = unsafe { $load_quads(records) };
                    quad.copy_from_slice(&[
                        Self(x, level),
                        Self(y, level),
                        Self(z, level),
                        Self(w, level),
                    ]);
                }
                Some(components)
            }
            #[inline(always)]
            fn scatter<const C: usize>(
                components: [Self; C],
                to: &mut [[$real; C]],
                at: &Indices,
                first: usize,
            ) {
                const { assert!(C.is_multiple_of(4), "whole quads") }
                let Some(at) = at.within::<$lanes>(first, to.len()) else { return };
                for (quad, number) in components.chunks_exact(4).zip((0..C).step_by(4)) {
                    let &[x, y, z, w] = quad else { return };
                    let mut records = [to.as_mut_ptr().cast::<$real>(); $lanes];
                    for (record, &index) in records.iter_mut().zip(at) {
                        *record = record.wrapping_add(index as usize * C + number);
                    }
                    // SAFETY: the lanes prove the instructions. `within` says that the records are in
                    // the slice, and each pointer is four numbers before the end of one, or more.
                    unsafe { $store_quads([x.0, y.0, z.0, w.0], records) }
                }
            }
        }
    )*};
}
gather! {
    avx2::F32x8 = [f32; 8], f32x8_load, f32x8_store;
    avx2::F64x4 = [f64; 4], f64x4_load, f64x4_store;
    avx512::F32x8 = [f32; 8], f32x8_load, f32x8_store;
    avx512::F64x4 = [f64; 4], f64x4_load, f64x4_store;
}

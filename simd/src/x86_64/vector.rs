//! The macro that defines a lane type by its register and its instructions.

/// Defines the lane type `$name`: a `$register` that holds the lanes `[$real; $lanes]`, and a
/// `$level`, which proves that the CPU has the instructions.
///
/// This is a macro because the lane types differ in the names of their intrinsics, which a generic
/// `impl` cannot take as parameters. Comparisons and `select` are given as expressions, because
/// AVX2 and AVX-512 have different types of masks.
macro_rules! vector {
    (
        $(#[$doc:meta])*
        $name:ident = $register:ident [$real:ident; $lanes:literal], $level:ident, mask $mask:ident;
        add $add:ident; sub $sub:ident; mul $mul:ident; div $div:ident; sqrt $sqrt:ident;
        mul_add $mul_add:ident; neg_mul_add $neg_mul_add:ident;
        splat $splat:ident; load $load:ident; store $store:ident; stream $stream:ident;
        quads $load_quads:ident $store_quads:ident $store_triples:ident $($sum_quads:ident)?;
        $(triples $load_triples:ident;)?
        $(between_shorts $between:ident;)?
        $(shorts $one_by_one:ident;)?
        and $and:ident; and_not $and_not:ident; or $or:ident; xor $xor:ident;
        less |$la:ident, $lb:ident| $less:expr;
        less_equal |$ea:ident, $eb:ident| $less_equal:expr;
        equal |$qa:ident, $qb:ident| $equal:expr;
        select |$m:ident, $yes:ident, $no:ident| $select:expr;
    ) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        pub struct $name(pub(super) $register, pub(super) $level);

        impl crate::sealed::Sealed for $name {}
        impl Lanes for $name {
            type Real = $real;
            type Mask = $mask;
            type Level = $level;
            type Native = Self;
            type Array = [$real; $lanes];
            const LANES: usize = $lanes;

            #[cfg_attr(not(opt_level_0), inline(always))]
            fn level(self) -> $level {
                self.1
            }
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn splat(level: $level, value: $real) -> Self {
                // SAFETY: only detection makes `level`, so the CPU has the instruction.
                Self(unsafe { $splat(value) }, level)
            }
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn load(level: $level, from: &[$real; $lanes]) -> Self {
                // SAFETY: `level` proves that the CPU has the instruction, which reads as many
                // elements as `from` has.
                Self(unsafe { $load(from.as_ptr()) }, level)
            }
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn store(self, to: &mut [$real; $lanes]) {
                // SAFETY: `self` proves that the CPU has the instruction, which writes as many
                // elements as `to` has.
                unsafe { $store(to.as_mut_ptr(), self.0) }
            }
            #[cfg_attr(not(opt_level_0), inline(always))]
            unsafe fn stream(self, to: &mut [$real; $lanes]) {
                let at = to.as_mut_ptr();
                if at.addr() % size_of::<$register>() != 0 {
                    return self.store(to);
                }
                // SAFETY: `self` proves that the CPU has the instruction, which writes as many
                // elements as `to` has. `at` is aligned to the register, as checked above, and the
                // caller guarantees a fence before other code uses `to`.
                unsafe { $stream(at.cast(), self.0) }
            }
            #[cfg_attr(not(opt_level_0), inline(always))]
            unsafe fn load_quads(
                level: $level,
                from: *const $real,
                offset: impl Fn(usize) -> usize,
            ) -> [Self; 4] {
                // SAFETY: `level` proves that the CPU has the instructions, and the caller
                // guarantees four readable components from `from + offset(i)` on for each lane `i`.
                let [x, y, z, w] = unsafe { $load_quads(from, offset) };
                [Self(x, level), Self(y, level), Self(z, level), Self(w, level)]
            }
            #[cfg_attr(not(opt_level_0), inline(always))]
            unsafe fn store_quads([x, y, z, w]: [Self; 4], to: *mut $real, stride: usize) {
                // SAFETY: the vectors prove that the CPU has the instructions, and the caller
                // guarantees four writable components from `to + i · stride` on for each lane `i`.
                unsafe { $store_quads([x.0, y.0, z.0, w.0], to, stride) }
            }
            $(
                #[cfg_attr(not(opt_level_0), inline(always))]
                unsafe fn load_adjoining<const C: usize>(
                    level: $level,
                    from: *const $real,
                ) -> Option<[Self; C]> {
                    if C != 3 {
                        return None;
                    }
                    // SAFETY: `level` proves that the CPU has the instructions, and the caller
                    // guarantees three readable components per lane from `from` on.
                    let [x, y, z] = unsafe { $load_triples(from) };
                    let mut components = [Self(x, level); C];
                    if let [_, second, third] = components.as_mut_slice() {
                        (*second, *third) = (Self(y, level), Self(z, level));
                    }
                    Some(components)
                }
            )?
            #[cfg_attr(not(opt_level_0), inline(always))]
            unsafe fn store_triples([x, y, z]: [Self; 3], to: *mut $real) {
                // SAFETY: the vectors prove that the CPU has the instructions, and the caller
                // guarantees three writable components per lane from `to` on.
                unsafe { $store_triples([x.0, y.0, z.0], to) }
            }
            $(
                #[cfg_attr(not(opt_level_0), inline(always))]
                unsafe fn between_shorts(
                    level: $level,
                    from: *const crate::shorts::Shorts,
                    records: impl Fn(usize) -> [usize; 2],
                    t: Self,
                ) -> [Self; 4] {
                    // SAFETY: `level` proves that the CPU has the instructions, and the caller
                    // guarantees that both records of each lane are readable.
                    let [x, y, z, w] = unsafe { $between(from, records, t.0) };
                    [Self(x, level), Self(y, level), Self(z, level), Self(w, level)]
                }
            )?
            $(
                #[cfg_attr(not(opt_level_0), inline(always))]
                unsafe fn between_shorts(
                    level: $level,
                    from: *const crate::shorts::Shorts,
                    records: impl Fn(usize) -> [usize; 2],
                    t: Self,
                ) -> [Self; 4] {
                    // SAFETY: `one_by_one` reads the two records that `records` names for each
                    // lane, which the caller guarantees to be readable.
                    unsafe { crate::shorts::$one_by_one(level, from, records, t) }
                }
            )?
            $(
                #[cfg_attr(not(opt_level_0), inline(always))]
                fn sum_quads([a, b, c, d]: [Self; 4]) -> Self {
                    // SAFETY: each vector holds a `$level`, which only detection makes, so the CPU
                    // has the instructions.
                    Self(unsafe { $sum_quads([a.0, b.0, c.0, d.0]) }, a.1)
                }
            )?
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn mul_add(self, factor: Self, addend: Self) -> Self {
                // SAFETY: `self` holds a `$level`, which only detection makes, so the CPU has the
                // instructions.
                Self(unsafe { $mul_add(self.0, factor.0, addend.0) }, self.1)
            }
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn neg_mul_add(self, factor: Self, addend: Self) -> Self {
                // SAFETY: `self` holds a `$level`, which only detection makes, so the CPU has the
                // instructions.
                Self(unsafe { $neg_mul_add(self.0, factor.0, addend.0) }, self.1)
            }
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn sqrt(self) -> Self {
                // SAFETY: `self` holds a `$level`, which only detection makes, so the CPU has the
                // instructions.
                Self(unsafe { $sqrt(self.0) }, self.1)
            }
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn abs(self) -> Self {
                // SAFETY: `self` holds a `$level`, which only detection makes, so the CPU has the
                // instructions.
                Self(unsafe { $and_not($splat(-0.0), self.0) }, self.1)
            }
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn copysign(self, sign: Self) -> Self {
                // SAFETY: `self` holds a `$level`, which only detection makes, so the CPU has the
                // instructions.
                let joined = unsafe {
                    let bit = $splat(-0.0);
                    $or($and_not(bit, self.0), $and(bit, sign.0))
                };
                Self(joined, self.1)
            }
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn lt(self, other: Self) -> $mask {
                let ($la, $lb) = (self, other);
                // SAFETY: `self` holds a `$level`, which only detection makes, so the CPU has the
                // instructions.
                unsafe { $less }
            }
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn le(self, other: Self) -> $mask {
                let ($ea, $eb) = (self, other);
                // SAFETY: `self` holds a `$level`, which only detection makes, so the CPU has the
                // instructions.
                unsafe { $less_equal }
            }
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn eq(self, other: Self) -> $mask {
                let ($qa, $qb) = (self, other);
                // SAFETY: `self` holds a `$level`, which only detection makes, so the CPU has the
                // instructions.
                unsafe { $equal }
            }
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn select($m: $mask, $yes: Self, $no: Self) -> Self {
                // SAFETY: each vector holds a `$level`, which only detection makes, so the CPU has
                // the instructions.
                Self(unsafe { $select }, $yes.1)
            }
        }

        crate::x86_64::vector::operator!($name, Add, add, $add);
        crate::x86_64::vector::operator!($name, Sub, sub, $sub);
        crate::x86_64::vector::operator!($name, Mul, mul, $mul);
        crate::x86_64::vector::operator!($name, Div, div, $div);

        impl core::ops::Neg for $name {
            type Output = Self;
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn neg(self) -> Self {
                // SAFETY: `self` holds a `$level`, which only detection makes, so the CPU has the
                // instructions.
                Self(unsafe { $xor(self.0, $splat(-0.0)) }, self.1)
            }
        }
    };
}
pub(super) use vector;

macro_rules! operator {
    ($name:ident, $trait:ident, $method:ident, $instruction:ident) => {
        impl core::ops::$trait for $name {
            type Output = Self;
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn $method(self, other: Self) -> Self {
                // SAFETY: `self` holds a `$level`, which only detection makes, so the CPU has the
                // instructions.
                Self(unsafe { $instruction(self.0, other.0) }, self.1)
            }
        }
    };
}
pub(super) use operator;

//! Sine and cosine of `f32`, computed in `f32`. The functions of `libm` compute in `f64`, which
//! takes most microcontrollers a thousand instructions and 9 KB of code. The tests in `tests/sweep`
//! have tried every `f32`.

/// Returns sin x, with an error of at most 1.06 units of the last place.
#[inline]
pub(crate) fn sin(x: f32) -> f32 {
    let (quarters, rest) = reduce(x);
    of_quarter(quarters, rest)
}

/// Returns cos x, with an error of at most 1.06 units of the last place.
#[inline]
pub(crate) fn cos(x: f32) -> f32 {
    let (quarters, rest) = reduce(x);
    of_quarter(quarters.wrapping_add(1), rest)
}

/// Returns tan x, with an error of at most 3.02 units of the last place.
#[inline]
pub(crate) fn tan(x: f32) -> f32 {
    let (quarters, rest) = reduce(x);
    of_quarter(quarters, rest) / of_quarter(quarters.wrapping_add(1), rest)
}

/// A value as the sum of a float, `number`, and a small correction, `missing`.
#[derive(Clone, Copy)]
struct Precise {
    number: f32,
    missing: f32,
}

/// Returns sin(kπ/2 + r) for |r| ≤ π/4, by the polynomials of Cephes (Moshier 1984).
#[inline]
fn of_quarter(k: u32, r: Precise) -> f32 {
    let Precise { number: r, missing } = r;
    let z = r * r;
    let value = if k & 1 == 0 {
        let tail = (-1.951_529_6e-4 * z + 8.332_161e-3) * z - 1.666_665_5e-1;
        // `copysign` keeps the sign of a zero.
        (r + (missing + r * z * tail)).copysign(r)
    } else {
        let tail = (2.443_315_7e-5 * z - 1.388_731_6e-3) * z + 4.166_664_6e-2;
        1.0 - (0.5 * z - (z * z * tail - r * missing))
    };
    if k & 2 == 0 { value } else { -value }
}

/// Returns the number of quarter turns nearest to x, modulo 4, and the remaining angle in radians,
/// which is NaN unless x is finite.
///
/// The function is inlined, so that the sine and the cosine of one angle share the reduction.
///
/// The computation is in integers (Payne and Hanek 1983), because the remainder of a large x, or of
/// an x close to a multiple of a quarter turn, needs more bits than a float has.
#[inline]
fn reduce(x: f32) -> (u32, Precise) {
    /// The first 224 bits of 2/π, after 32 zero bits.
    const TWO_OVER_PI: [u32; 8] = [
        0,
        0xa2f9_836e,
        0x4e44_1529,
        0xfc27_57d1,
        0xf534_ddc0,
        0xdb62_9599,
        0x3c43_9041,
        0xfe51_63ab,
    ];
    /// The value π/2 · 2³¹, rounded.
    const HALF_PI: u64 = 0xc90f_daa2;

    if x.abs() <= core::f32::consts::FRAC_PI_4 {
        return (0, Precise { number: x, missing: 0.0 });
    }
    if !x.is_finite() {
        return (0, Precise { number: f32::NAN, missing: 0.0 });
    }
    // x is ±m · 2ᵏ with −24 ≤ k ≤ 104. Bits of 2/π whose product with 2ᵏ is a multiple
    // of 4 (quarter turns) contribute whole turns only and are skipped. The next 96 bits are
    // enough.
    let bits = x.to_bits();
    let m = u64::from(bits & 0x7f_ffff | 0x80_0000);
    let skip = ((bits >> 23) & 0xff).wrapping_sub(150 - 30);
    let word = |i: u32| {
        let at = |i: u32| u64::from(TWO_OVER_PI.get(i as usize).copied().unwrap_or_default());
        let pair = at(skip / 32 + i) << 32 | at(skip / 32 + i + 1);
        (pair << (skip % 32)) >> 32
    };
    // `product` is the number of quarter turns modulo 4, with two bits before the binary point and
    // 62 bits after it.
    let product = ((m * word(0)) << 32).wrapping_add(m * word(1)).wrapping_add((m * word(2)) >> 32);
    let quarters = product.wrapping_add(1 << 61) >> 62;
    let rest = product.wrapping_sub(quarters << 62).cast_signed();

    // The 32 leading bits of the remainder are converted to radians. The product is split into 24
    // bits that fit a float, and the bits after these.
    let size = rest.unsigned_abs();
    let shift = size.leading_zeros();
    let leading = (size << shift) >> 32;
    let radians = leading * HALF_PI;
    // `leading`/2³² · 2^(64 − shift) · 2⁻⁶² quarter turns are `radians` · 2^(−61 −
    // shift) radians.
    let number = (radians >> 40) as u32;
    let missing = ((radians >> 16) as u32) & 0xff_ffff;
    let unit = f32::from_bits((127 + 40 - 61 - shift) << 23);
    let sign = if (rest < 0) != x.is_sign_negative() { -unit } else { unit };
    let rest =
        Precise { number: number as f32 * sign, missing: missing as f32 * (sign / 16_777_216.0) };
    let quarters = quarters as u32;
    (if x.is_sign_negative() { quarters.wrapping_neg() } else { quarters }, rest)
}

#[cfg(test)]
mod tests {
    use super::{cos, sin, tan};

    #[test]
    fn zeros_keep_their_sign_and_what_is_not_finite_has_no_sine() {
        let zero = -0.0_f32;
        assert_eq!([sin(zero), tan(zero)].map(f32::to_bits), [zero.to_bits(); 2]);
        assert_eq!((cos(0.0), sin(-1.0), tan(-1.0)), (1.0, -sin(1.0), -tan(1.0)));
        assert!(
            [f32::INFINITY, f32::NEG_INFINITY, f32::NAN]
                .iter()
                .all(|&x| sin(x).is_nan() && cos(x).is_nan() && tan(x).is_nan())
        );
    }
}

//! Numbers of files. The parser of the standard library holds a table of ten kilobytes, which would
//! be a tenth of what a web page waits for. So WebAssembly has a parser without a table, which
//! computes powers of ten; that takes longer only for numbers of more than fifteen digits or with
//! powers beyond 10^±22.

/// The digits of exact products: a number of so many digits times a power of ten up to 10²²
/// rounds once.
const EXACT_DIGITS: usize = 15;
const EXACT_POWER: usize = 22;
/// Beyond these no digits make a finite number other than zero.
const MOST: i64 = 400;
/// Middles of two floats have fewer digits: whether any digit after these is not zero is enough.
const DIGITS: usize = 800;

/// Returns the `f64` nearest to a decimal number, with ties to even, as `str::parse` does; `None`
/// if the text is no finite number.
pub(super) fn finite(text: &str) -> Option<f64> {
    if cfg!(target_arch = "wasm32") {
        decimal(text)
    } else {
        text.parse().ok().filter(|number: &f64| number.is_finite())
    }
}

/// Does what [`finite`] does without the standard library.
fn decimal(text: &str) -> Option<f64> {
    let (negative, text) = match text.as_bytes() {
        [b'-', rest @ ..] => (true, rest),
        [b'+', rest @ ..] => (false, rest),
        all => (false, all),
    };
    let end = text.iter().position(|byte| matches!(byte, b'e' | b'E'));
    let (mantissa, exponent) = match end {
        Some(at) => (text.get(..at)?, power(text.get(at + 1..)?)?),
        None => (text, 0),
    };
    let point = mantissa.iter().position(|&byte| byte == b'.');
    let (whole, part) = match point {
        Some(at) => (mantissa.get(..at)?, mantissa.get(at + 1..)?),
        None => (mantissa, &[][..]),
    };
    if whole.is_empty() && part.is_empty() {
        return None;
    }
    let all = whole.iter().chain(part);
    if !all.clone().all(u8::is_ascii_digit) {
        return None;
    }
    let digits = || all.clone().map(|byte| u32::from(byte - b'0')).skip_while(|&digit| digit == 0);
    let count = digits().count();
    // The place of the first digit, in powers of ten.
    let place = exponent.saturating_sub(part.len() as i64).saturating_add(count as i64);
    let size = if count == 0 || place < -MOST {
        0.0
    } else if place > MOST {
        return None;
    } else if count > DIGITS {
        let rest = u32::from(digits().skip(DIGITS).any(|digit| digit != 0));
        rounded(digits().take(DIGITS).chain([rest]), DIGITS + 1, place - DIGITS as i64 - 1)
    } else {
        rounded(digits(), count, place - count as i64)
    };
    size.is_finite().then_some(if negative { -size } else { size })
}

/// Returns an exponent; those beyond all floats count as ±10⁹.
fn power(text: &[u8]) -> Option<i64> {
    let (sign, digits) = match text {
        [b'-', rest @ ..] => (-1, rest),
        [b'+', rest @ ..] => (1, rest),
        all => (1, all),
    };
    if digits.is_empty() || !digits.iter().all(u8::is_ascii_digit) {
        return None;
    }
    let most = 1_000_000_000;
    Some(sign * digits.iter().fold(0, |sum: i64, byte| most.min(10 * sum + i64::from(byte - b'0'))))
}

/// Returns the float nearest to these digits times a power of ten.
fn rounded(digits: impl Iterator<Item = u32>, count: usize, exponent: i64) -> f64 {
    let power = exponent.unsigned_abs() as usize;
    if count <= EXACT_DIGITS && power <= EXACT_POWER {
        let number = digits.fold(0.0, |sum, digit| 10.0 * sum + f64::from(digit));
        let ten = (0..power).fold(1.0, |product, _| 10.0 * product);
        return if exponent < 0 { number / ten } else { number * ten };
    }
    let (mut numerator, mut denominator) = (Vec::new(), Vec::new());
    digits.for_each(|digit| times_plus(&mut numerator, 10, digit));
    times_plus(&mut denominator, 1, 1);
    let scaled = if exponent < 0 { &mut denominator } else { &mut numerator };
    (0..power).for_each(|_| times_plus(scaled, 10, 0));
    quotient(numerator, denominator)
}

/// Returns the float nearest to a quotient, which is not zero.
fn quotient(mut numerator: Vec<u32>, mut denominator: Vec<u32>) -> f64 {
    // Shifts that bring the quotient to at least ½ and less than 2.
    let shift = bits(&numerator) as i32 - bits(&denominator) as i32;
    double(if shift < 0 { &mut numerator } else { &mut denominator }, shift.unsigned_abs());
    // The last bit of the smallest floats is 2⁻¹⁰⁷⁴; the bit below it says how to round,
    // and the last one whether anything is left.
    let wanted = (1074 + 1 + shift).clamp(0, 62);
    let mut all: u64 = 0;
    for _ in 0..=wanted {
        all *= 2;
        if !is_less(&numerator, &denominator) {
            subtract(&mut numerator, &denominator);
            all += 1;
        }
        double(&mut numerator, 1);
    }
    let rest = u64::from(numerator.iter().any(|&limb| limb != 0));
    // Floats of 53 bits, or of fewer where they are the smallest.
    let spare = (64 - all.leading_zeros() as i32 - 53).max(wanted - (1074 + shift));
    let spare = spare.clamp(0, 63) as u32;
    let (kept, cut) = (all >> spare, all & ((1 << spare) - 1));
    let half = (1_u64 << spare) / 2;
    let up = cut > half || (cut == half && spare > 0 && (rest == 1 || kept % 2 == 1));
    scaled((kept + u64::from(up)) as f64, shift - wanted + spare as i32)
}

/// Returns a number times a power of two, in steps of which none rounds.
fn scaled(mut number: f64, mut power: i32) -> f64 {
    while power != 0 {
        let step = power.clamp(-60, 60);
        number *= f64::from_bits(((1023 + step) as u64) << 52);
        power -= step;
    }
    number
}

/// Multiplies limbs, the lowest first, by a number, and adds another.
fn times_plus(limbs: &mut Vec<u32>, factor: u32, addend: u32) {
    let mut carry = u64::from(addend);
    for limb in limbs.iter_mut() {
        carry += u64::from(*limb) * u64::from(factor);
        *limb = carry as u32;
        carry >>= 32;
    }
    if carry > 0 {
        limbs.push(carry as u32);
    }
}

fn double(limbs: &mut Vec<u32>, times: u32) {
    (0..times).for_each(|_| times_plus(limbs, 2, 0));
}

/// The number of bits, of limbs whose last is not zero.
fn bits(limbs: &[u32]) -> usize {
    32 * limbs.len() - limbs.last().map_or(0, |limb| limb.leading_zeros() as usize)
}

fn is_less(a: &[u32], b: &[u32]) -> bool {
    let limb = |limbs: &[u32], index: usize| limbs.get(index).copied().unwrap_or(0);
    let differ = (0..a.len().max(b.len())).rev().find(|&index| limb(a, index) != limb(b, index));
    differ.is_some_and(|index| limb(a, index) < limb(b, index))
}

/// Subtracts the smaller `b` from `a`.
fn subtract(a: &mut [u32], b: &[u32]) {
    let mut borrow = false;
    for (index, limb) in a.iter_mut().enumerate() {
        let (less, first) = limb.overflowing_sub(b.get(index).copied().unwrap_or(0));
        let (less, second) = less.overflowing_sub(u32::from(borrow));
        (*limb, borrow) = (less, first || second);
    }
}

#[cfg(test)]
mod tests {
    use super::decimal;

    /// What the standard library says of the same text.
    fn std(text: &str) -> Option<f64> {
        text.parse().ok().filter(|number: &f64| number.is_finite())
    }

    fn same(text: &str) {
        assert_eq!(decimal(text).map(f64::to_bits), std(text).map(f64::to_bits), "{text}");
    }

    #[test]
    fn texts_that_are_no_numbers_are_none() {
        for text in [
            "", ".", "-", "+", "e5", "1e", "1e+", "--1", "1.2.3", "1 ", "1e1.5", "x", "inf", "nan",
            "1_0", "٣",
        ] {
            assert_eq!(decimal(text), None, "{text}");
        }
    }

    #[test]
    fn every_number_has_the_bits_of_the_standard_library() {
        for text in [
            "0",
            "-0",
            "+1",
            "1.",
            ".5",
            "-.5e1",
            "1E5",
            "00012.5000",
            "3.14159265358979",
            "3.14159265358979323846",
            "9007199254740993",
            "9007199254740992.5",
            "9007199254740993e-1",
            "1e22",
            "1e23",
            "123456789012345678e-30",
            "5e-324",
            "2.4703282292062327e-324",
            "2.4703282292062328e-324",
            "2.2250738585072011e-308",
            "2.2250738585072014e-308",
            "1.7976931348623157e308",
            "1.7976931348623159e308",
            "1e309",
            "1e-400",
            "1e999999999999999999999",
            "1e-999999999999999999999",
            "0e999999999999999999999",
            "0.0000001e7",
        ] {
            same(text);
        }
        let mut state = 1_u64;
        let mut random = |below: u64| {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (state >> 33) % below
        };
        for _ in 0..20_000 {
            let bits = random(1 << 31) << 33 | random(1 << 31) << 2 | random(4);
            let number = f64::from_bits(bits);
            if number.is_finite() {
                same(&format!("{number:e}"));
                same(&format!("{number:.17e}"));
                // The middle of two floats, or almost.
                let next = f64::from_bits(bits.wrapping_add(1));
                if number.abs() < 1e15 && number.abs() > 1e-5 && next.is_finite() {
                    same(&format!("{:.40}", number));
                    same(&format!("{number:.60}5"));
                }
            }
            let digits: String =
                (0..=random(40)).map(|_| char::from(b'0' + random(10) as u8)).collect();
            let (at, power) = (random(digits.len() as u64 + 1) as usize, random(700) as i64 - 360);
            same(&format!("{}.{}e{power}", &digits[..at], &digits[at..]));
        }
        let long = "4".repeat(900);
        for tail in ["", "1", "5"] {
            same(&format!("{long}{tail}e-700"));
            same(&format!("9007199254740993.{}{tail}", "0".repeat(1000)));
            same(&format!("0.{}{long}{tail}", "0".repeat(300)));
        }
        // Exact middles: odd multiples of half the distance of floats, written out.
        for k in 0..2_000_u128 {
            same(&(((1_u128 << 54) + 2 * k + 1).to_string() + "00"));
            same(&((1_u128 << 54) + 2 * k + 1).to_string());
        }
    }
}

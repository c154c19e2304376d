//! Operations with one quaternion in the four lanes x, y, z, w of a register.

use super::{Four, Number, one_lane};
use dq8_simd::{Lanes, Mask, Portable};

/// Returns the product of two dual quaternions, p₁p₂ + ε(p₁q₂ + q₁p₂).
#[inline(always)]
pub(super) fn product<F: Number>(a: [F; 8], b: [F; 8]) -> Option<[F; 8]> {
    let ([p, q], [r, s]) = (halves(a), halves(b));
    let (p, q, r, s) = (each(p), each(q), turned(r), turned(s));
    Some(join(sum_of_products(p, r), sum_of_products(p, s) + sum_of_products(q, r)))
}

/// Returns the quaternion product pq. It is rounded as each product within [`product`] is, so that
/// laws that connect the two functions hold bit by bit.
#[inline(always)]
pub(super) fn quaternion_product<F: Number>(a: [F; 4], b: [F; 4]) -> Option<[F; 4]> {
    let (a, b): (F::Four, F::Four) = (load(a), load(b));
    Some(sum_of_products(each(a), turned(b)).to_array())
}

/// Returns the moved point v + 2(w_p s + p × s − w_q p) with s = q + p × v. It is the rotated
/// point v + 2(w_p(p × v) + p × (p × v)) plus the translation, so s takes the place of q in the
/// formula of the translation.
#[inline(always)]
pub(super) fn point<F: Number>(motion: [F; 8], point: [F; 3]) -> Option<[F; 3]> {
    let [p, q] = halves(motion);
    let v = load_three(point);
    let (s, twice) = (q + cross(p, v), p + p);
    // The cross product is finished later than the other terms, so it is added last.
    let [x, y, z, _] = (along(twice, s, q) + v + cross(twice, s)).to_array();
    Some([x, y, z])
}

/// Returns the rotated vector v + 2p × (p × v + wv).
#[inline(always)]
pub(super) fn rotate<F: Number>(rotation: [F; 4], vector: [F; 3]) -> Option<[F; 3]> {
    // In `f64`, a vector takes two registers, and one lane in four is idle: that is slower than
    // three scalars.
    if !F::SINGLE {
        return None;
    }
    let p: F::Four = load(rotation);
    let v = load_three(vector);
    let turned = cross(p + p, pick(p, [3; 4]) * v + cross(p, v));
    let [x, y, z, _] = (turned + v).to_array();
    Some([x, y, z])
}

/// Returns the translation t = 2qp*, with the same bits as in [`matrix3x4`].
#[inline(always)]
pub(super) fn translation<F: Number>(motion: [F; 8]) -> Option<[F; 3]> {
    let [p, q] = halves(motion);
    let [x, y, z, _] = translation_of(p + p, q).to_array();
    Some([x, y, z])
}

/// Returns the rows of [R | t]. One register holds the diagonal of R, 1 − 2(y² + z²) and so on.
/// A second holds 2(xy − wz), 2(yz − wx), 2(zx − wy), and a third holds the elements across
/// the diagonal from these.
#[inline(always)]
pub(super) fn matrix3x4<F: Number>(motion: [F; 8]) -> Option<[[F; 4]; 3]> {
    let [p, q] = halves(motion);
    let twice = p + p;
    let squares = p * twice;
    let diagonal = p.constant(1.0) - (pick(squares, [1, 0, 0, 3]) + pick(squares, [2, 2, 1, 3]));
    let across = p * pick(twice, [1, 2, 0, 3]);
    let turning = pick(pick(p, [3; 4]) * twice, [2, 0, 1, 3]);
    let [xx, yy, zz, _] = diagonal.to_array();
    let [xy, yz, zx, _] = (across - turning).to_array();
    let [yx, zy, xz, _] = (across + turning).to_array();
    let [x, y, z, _] = translation_of(twice, q).to_array();
    Some([[xx, xy, xz, x], [yx, yy, yz, y], [zx, zy, zz, z]])
}

/// Normalizes a dual quaternion exactly: |p| = 1, and q is orthogonal to p.
#[inline(always)]
pub(super) fn unit<F: Number>(motion: [F; 8]) -> Option<[F; 8]> {
    let [p, q] = halves(motion);
    // The components are copied (*A spilled copy*, docs/measured.md), so that the result of the
    // common path stays in registers.
    Some(unit_of(p, q).unwrap_or_else(|| {
        let [px, py, pz, pw, qx, qy, qz, qw] = unit_of_stretched(join(p, q));
        [px, py, pz, pw, qx, qy, qz, qw]
    }))
}

/// Normalizes σ after scaling it by a power of two. The scaling is exact, so the result is the
/// same as without it.
#[cold]
#[inline(never)]
fn unit_of_stretched<F: Number>(motion: [F; 8]) -> [F; 8] {
    let mut largest = F::default();
    for component in motion.into_iter().take(4).map(Lanes::abs) {
        largest = F::select(largest.lt(component), component, largest);
    }
    let stretch = F::from(1.0) / largest.power_of_two();
    let [p, q] = halves(motion.map(|component| component * stretch));
    unit_of(p, q).unwrap_or_else(|| one_lane::unit(motion))
}

/// Returns q / |q|, or `None` if |q| is so large or so small that its square might overflow or
/// vanish.
#[inline(always)]
pub(super) fn quaternion_unit<F: Number>(quaternion: [F; 4]) -> Option<[F; 4]> {
    let q: F::Four = load(quaternion);
    let squared = sum(q * q);
    let moderate = squared.constant(1e-6).lt(squared) & squared.lt(squared.constant(1e6));
    moderate.then(|| (q * load([squared.constant(1.0) / Lanes::sqrt(squared); 4])).to_array())
}

/// Returns (1−t)a ± tb, with the sign for which the way from a to ±b is the shorter one.
#[inline(always)]
pub(super) fn lerp<F: Number>(a: [F; 8], b: [F; 8], t: F) -> Option<[F; 8]> {
    let ([p, q], [r, s]) = (halves(a), halves(b));
    let turn = turn_toward(p, r);
    let t: F::Four = load([t; 4]);
    let rest = t.constant(1.0) - t;
    // The signs are known later than the products, so they are applied to the products.
    let (r, s) = ((r * t) ^ turn, (s * t) ^ turn);
    Some(join(p * rest + r, q * rest + s))
}

/// Returns the inverse, p*/|p|² + ε(q/|p|² − 2(p·q)p/|p|⁴)*, which follows from p*qp* =
/// 2(p·q)p* − |p|²q*.
#[inline(always)]
pub(super) fn inverse<F: Number>(motion: [F; 8]) -> Option<[F; 8]> {
    let [p, q] = halves(motion);
    let Some([squared, along]) = moderate(p, q) else { return Some(one_lane::inverse(join(p, q))) };
    let over_squared = squared.constant(1.0) / squared;
    let twice = (along + along) * over_squared;
    let [px, py, pz, pw] = (p * over_squared).to_array();
    let [qx, qy, qz, qw] = ((q - p * twice) * over_squared).to_array();
    Some([-px, -py, -pz, pw, -qx, -qy, -qz, qw])
}

/// Returns p/|p| + ε(q − (p·q)p/|p|²)/|p|, or `None` if squares or quotients might overflow or
/// vanish.
#[inline(always)]
fn unit_of<V: Four>(p: V, q: V) -> Option<[V::Number; 8]> {
    let [squared, along] = moderate(p, q)?;
    // 1/|p| is computed as |p|·(1/|p|²), so that the quotient need not wait for the root. For
    // nearly unit p its error is also smaller: 0.42 roundoffs (root mean square, `f32`) instead of
    // 0.77 for 1/√(|p|²).
    let over_squared = squared.constant(1.0) / squared;
    let over_norm = squared.sqrt() * over_squared;
    Some(join(p * over_norm, (q - p * (along * over_squared)) * over_norm))
}

/// Returns −0 in all lanes if a·b is negative, and +0 otherwise. The exclusive or of this mask
/// and `b` is ±`b`, with the sign nearer to `a`.
#[inline(always)]
pub(super) fn turn_toward<V: Four>(a: V, b: V) -> V {
    let pairs = a * b;
    let pairs = pairs + pick(pairs, [2, 3, 0, 1]);
    let dot = pairs + pick(pairs, [1, 0, 3, 2]);
    // The dot product is compared with zero instead of using its sign bit, which is also set for
    // −0.
    V::select(dot.lt(dot.constant(0.0)), dot.constant(-0.0), dot.constant(0.0))
}

/// Returns |p|² and p·q, each in all lanes, or `None` if squares or quotients might overflow or
/// vanish.
#[inline(always)]
fn moderate<V: Four>(p: V, q: V) -> Option<[V; 2]> {
    let sums = dots(p, p, q);
    let [squared, ..] = sums.to_array();
    // p·q is rounded to a multiple of the smallest subnormal number. If |p| is at least a half,
    // this changes q by a few such steps; if |p| is smaller, by many.
    let fits = squared.is_between(squared.constant(0.25), squared.constant(1e6))
        && q.abs().lt(q.constant(1e12)).to_bitmask() == 0b1111;
    fits.then(|| [pick(sums, [0; 4]), pick(sums, [1; 4])])
}

/// Returns [a·b, a·c, a·b, a·c].
#[inline(always)]
pub(super) fn dots<V: Four>(a: V, b: V, c: V) -> V {
    sums(a * b, a * c)
}

/// Returns the sums of the components, [Σa, Σb, Σa, Σb].
#[inline(always)]
pub(super) fn sums<V: Four>(a: V, b: V) -> V {
    let ([a0, a1, a2, a3], [b0, b1, b2, b3]) = (a.to_array(), b.to_array());
    let sums: V = load::<V>([a0, b0, a1, b1]) + load([a2, b2, a3, b3]);
    sums + pick(sums, [2, 3, 0, 1])
}

#[inline(always)]
pub(super) fn sum<V: Four>(numbers: V) -> V::Number {
    let [even, odd, ..] = (numbers + pick(numbers, [2, 3, 2, 3])).to_array();
    even + odd
}

/// Returns the translation 2(w_p q − w_q p + p × q), where `twice` is 2p. The last lane is
/// unused.
#[inline(always)]
fn translation_of<V: Four>(twice: V, q: V) -> V {
    along(twice, q, q) + cross(twice, q)
}

/// Returns 2(w_p v − w_q p), where `twice` is 2p. The last lane is unused.
#[inline(always)]
fn along<V: Four>(twice: V, v: V, q: V) -> V {
    pick(twice, [3; 4]) * v - pick(q, [3; 4]) * twice
}

/// Returns a × b. The last lane is unused.
#[inline(always)]
fn cross<V: Four>(a: V, b: V) -> V {
    let turned = a * pick(b, [1, 2, 0, 3]) - pick(a, [1, 2, 0, 3]) * b;
    pick(turned, [1, 2, 0, 3])
}

/// Returns four vectors, each with one of the four components in all lanes.
#[inline(always)]
fn each<V: Four>(a: V) -> [V; 4] {
    [pick(a, [0; 4]), pick(a, [1; 4]), pick(a, [2; 4]), pick(a, [3; 4])]
}

/// Returns the products ib, jb, kb, and b itself.
#[inline(always)]
fn turned<V: Four>(b: V) -> [V; 4] {
    let one = <V::Number>::from(1.0);
    [
        pick(b, [3, 2, 1, 0]) * load([one, -one, one, -one]),
        pick(b, [2, 3, 0, 1]) * load([one, one, -one, -one]),
        pick(b, [1, 0, 3, 2]) * load([-one, one, one, -one]),
        b,
    ]
}

/// Returns a_x ib + a_y jb + a_z kb + a_w b. The terms are added in the same pairs as in the scalar
/// reference, so both give the same bits.
#[inline(always)]
fn sum_of_products<V: Four>(a: [V; 4], b: [V; 4]) -> V {
    let ([x, y, z, w], [i, j, k, one]) = (a, b);
    (w * one + x * i) + (y * j + z * k)
}

#[inline(always)]
pub(super) fn halves<F: Number>(motion: [F; 8]) -> [F::Four; 2] {
    let [px, py, pz, pw, qx, qy, qz, qw] = motion;
    [load([px, py, pz, pw]), load([qx, qy, qz, qw])]
}

#[inline(always)]
pub(super) fn join<V: Four>(p: V, q: V) -> [V::Number; 8] {
    let ([px, py, pz, pw], [qx, qy, qz, qw]) = (p.to_array(), q.to_array());
    [px, py, pz, pw, qx, qy, qz, qw]
}

#[inline(always)]
pub(super) fn load<V: Four>(numbers: [V::Number; 4]) -> V {
    V::load(Portable, &numbers)
}

/// Loads three components and a zero. The array is copied first, so that the compiler keeps all
/// lanes in one register. Otherwise it would build each order that [`pick`] makes from three
/// separate components, with twice as many shuffles.
#[inline(always)]
fn load_three<V: Four>(numbers: [V::Number; 3]) -> V {
    let mut four = [V::Number::default(); 4];
    four[..3].copy_from_slice(&numbers);
    load(four)
}

/// Returns the lanes in another order.
#[inline(always)]
pub(super) fn pick<V: Four>(from: V, [i, j, k, l]: [usize; 4]) -> V {
    let from = from.to_array();
    load([from[i], from[j], from[k], from[l]])
}

//! The product of two motions that nothing else waits beside: one register holds a whole motion.

use crate::real::Real;
use dq8_simd::Octet;

/// left · right: p_L·(p_R + εq_R) + εq_L·p_R, of which the left factor comes whole and the right one
/// number by number from memory. Eight multiplications of vectors; the upper half of what is raised
/// is dropped, for ε² = 0.
#[inline(always)]
pub(super) fn product<R: Real, L: Octet<Real = R>>(left: L, right: &[R; 8]) -> L {
    let level = left.level();
    let [x, y, z, w] = left.columns();
    let [px, py, pz, pw, qx, qy, qz, qw] = right;
    let dual = w * L::splat(level, *qw);
    let dual = x.mul_add(L::splat(level, *qx), dual);
    let dual = y.mul_add(L::splat(level, *qy), dual);
    let dual = z.mul_add(L::splat(level, *qz), dual);
    let both = w * L::splat(level, *pw);
    let both = x.mul_add(L::splat(level, *px), both);
    let both = y.mul_add(L::splat(level, *py), both);
    let both = z.mul_add(L::splat(level, *pz), both);
    both + dual.raised()
}

//! The product of two motions that nothing else waits beside: one register holds a whole motion.

use crate::real::Real;
use dq8_simd::{Level, Octet};

/// left · right, of which the left factor comes whole and the right one number by number from memory.
///
/// Of left · (p + εq) the part left · q is raised by ε, and what is beyond ε dropped: eight
/// multiplications of vectors.
///
/// Three other ways were measured and are slower on a skeleton of 64 joints: signs by alternating
/// multiply-adds, which are three instructions less (by a sixth), the left factor number by number (by
/// a sixth), and joints of one level in the lanes, gathered and scattered (by a twentieth).
#[inline(always)]
pub(super) fn product<R: Real, L: Octet<Real = R>>(left: L, right: &[R; 8]) -> L {
    let level = left.level();
    let [x, y, z, w] = left.columns();
    let [px, py, pz, pw, qx, qy, qz, qw] = level.locate(right);
    let dual = x.mul_add(L::splat(level, *qx), w * L::splat(level, *qw));
    let dual = y.mul_add(L::splat(level, *qy), dual);
    let dual = z.mul_add(L::splat(level, *qz), dual);
    let both = x.mul_add(L::splat(level, *px), w * L::splat(level, *pw));
    let both = y.mul_add(L::splat(level, *py), both);
    let both = z.mul_add(L::splat(level, *pz), both);
    both + dual.raised()
}

//! The product of two motions for loops over a single instance: one register holds a whole motion.
//! And the same product in lanes, equal to the last bit and to the sign of a zero.

use crate::number::Scalar;
use dq8_simd::{Lanes, Level, PackedDualQuat};

/// left · right, of which the left factor comes whole and the right one number by number from
/// memory.
///
/// Of left · (p + εq) the part left · q is raised by ε, and what is beyond ε dropped: eight
/// multiplications of vectors. The last sum adds −0 to the real part, which leaves every bit of
/// it as it is; +0 would take the sign of a zero, which [`product_in_lanes`] keeps.
///
/// Three other ways were measured and are slower on a skeleton of 64 joints: signs by alternating
/// multiply-adds, which are three instructions less (by a sixth), the left factor number by number
/// (by a sixth), and joints of one level in the lanes, gathered and scattered (by a twentieth).
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn packed_product<L: PackedDualQuat>(left: L, right: &[L::Real; 8]) -> L {
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

/// [`packed_product`] of a parent and its child in memory.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn product<R: Scalar, V: Level>(level: V, parent: &[R; 8], local: &[R; 8]) -> [R; 8] {
    let mut model = [R::ZERO; 8];
    packed_product(R::Packed::<V>::load(level, parent), local).store(&mut model);
    model
}

/// [`packed_product`] of a motion in each lane: the same sums in the same order, with the same
/// signs of zeros, so that the result of an instance does not depend on how many others are
/// computed with it, nor on how wide the lanes are. (The product of
/// [`batch::DualQuat`](crate::batch::DualQuat) adds the halves of the dual part as it goes, and
/// saves four additions.)
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn product_in_lanes<L: Lanes>(left: [L; 8], right: [L; 8]) -> [L; 8] {
    let [px, py, pz, pw, qx, qy, qz, qw] = left;
    let [rx, ry, rz, rw, sx, sy, sz, sw] = right;
    let (p, q) = ([px, py, pz, pw], [qx, qy, qz, qw]);
    let (r, s) = ([rx, ry, rz, rw], [sx, sy, sz, sw]);
    let [dx, dy, dz, dw] = hamilton(p, s);
    let [ex, ey, ez, ew] = hamilton(q, r);
    let [x, y, z, w] = hamilton(p, r);
    [x, y, z, w, ex + dx, ey + dy, ez + dz, ew + dw]
}

/// pq, by the columns of p: w first, then x, y and z.
#[cfg_attr(not(opt_level_0), inline(always))]
fn hamilton<L: Lanes>([px, py, pz, pw]: [L; 4], [x, y, z, w]: [L; 4]) -> [L; 4] {
    [
        py.mul_add(z, pz.neg_mul_add(y, pw.mul_add(x, px * w))),
        px.neg_mul_add(z, pw.mul_add(y, pz.mul_add(x, py * w))),
        pw.mul_add(z, px.mul_add(y, py.neg_mul_add(x, pz * w))),
        pz.neg_mul_add(z, py.neg_mul_add(y, px.neg_mul_add(x, pw * w))),
    ]
}

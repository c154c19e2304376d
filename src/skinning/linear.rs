use super::blender::{Blender, PlainPoints, SurfaceMap};
use super::skin::{GROUP, Scratch, Skin, Weight, settled};
use crate::batch::vector;
use crate::macros::brief;
use crate::number::Scalar;
use crate::storage::shape::{ShapeError, same_length};
use dq8_simd::internal::Index;
use dq8_simd::{Float, Lanes, Level, PackedDualQuat, Records};

/// Linear blend skinning (Magnenat-Thalmann et al. 1988): v ↦ Σ wᵢMᵢv. The weights must sum
/// to one. This blend is the cheapest and takes any matrix, but the sum of two rotations is not a
/// rotation, so bent elbows and twisted wrists collapse.
///
/// A normal n becomes cof(Σ wᵢMᵢ)n, with the matrix of cofactors, and a tangent t becomes (Σ
/// wᵢMᵢ)t; both are normalized, unless they are zero.
#[derive(Clone, Copy)]
pub struct Linear<'a, R> {
    palette: &'a [[[R; 4]; 3]],
}

brief!([R] Linear<'_, R>: Linear |it| { joints: it.palette.len() });

impl<'a, R: Scalar> Linear<'a, R> {
    /// Makes a blend from the 3×4 matrix of each joint, which takes the mesh at rest to the posed
    /// mesh. Matrices are stored by rows ([`MatrixOrder::Rows`]), the default order of palettes.
    ///
    /// [`MatrixOrder::Rows`]: crate::hierarchy::MatrixOrder
    #[must_use]
    pub fn new(palette: &'a [[[R; 4]; 3]]) -> Self {
        Self { palette }
    }

    pub(super) fn joints(&self) -> usize {
        self.palette.len()
    }
}

/// A 3×4 matrix in two registers: the first holds rows 0 and 1, and the second holds row 2.
type Rows<R, V> = (<R as Float>::Packed<V>, <R as Float>::Half<V>);

/// Returns the sum of the four `matrices`, each multiplied by its weight.
#[cfg_attr(not(opt_level_0), inline(always))]
fn blended<R: Scalar, V: Level>(
    level: V,
    matrices: [&[R; 12]; GROUP],
    weights: [R; GROUP],
) -> Option<Rows<R, V>> {
    let mut sum: Option<Rows<R, V>> = None;
    let mut influence = 0;
    while influence < GROUP {
        let (matrix, weight) = (matrices[influence], weights[influence]);
        let two = R::Packed::load(level, matrix.first_chunk()?);
        let third = R::Half::load(level, matrix.last_chunk()?);
        let (by_two, by_third) = (R::Packed::splat(level, weight), R::Half::splat(level, weight));
        sum = Some(match sum {
            None => (two * by_two, third * by_third),
            Some(sum) => (two.mul_add(by_two, sum.0), third.mul_add(by_third, sum.1)),
        });
        influence += 1;
    }
    sum
}

impl<R: Scalar> Blender<R> for Linear<'_, R> {
    type Sum<L: Lanes<Real = R>> = [[L; 4]; 3];
    type Map<L: Lanes<Real = R>> = LinearMap<L>;

    // The sums of matrices are computed in registers of half the width and then transposed by
    // shuffles.
    const SHUFFLES: bool = true;

    fn check(&self, joints: usize, _: usize) -> Result<(), ShapeError> {
        same_length("palette", self.palette.len(), joints)
    }
    /// Sums the matrices of one vertex after the other, with the entries of a matrix in the lanes.
    /// So only the sums are transposed. With a vertex in each lane, every matrix of a sum would be
    /// transposed.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn sum<L: Lanes<Real = R>, J: Index>(
        &self,
        level: L::Level,
        scratch: &mut Scratch<'_, R, J>,
    ) -> Option<[[L; 4]; 3]> {
        let Scratch { influences, sums } = scratch;
        let picked = influences.rows().of(bytemuck::must_cast_slice(self.palette))?;
        let weights = influences.weights();
        let mut lane = 0;
        while lane < L::LANES {
            let sum = blended::<R, L::Level>(level, picked.records(lane), weights[lane])?;
            let (two, rest) = sums.0[lane].split_first_chunk_mut()?;
            sum.0.store(two);
            sum.1.store(rest.first_chunk_mut()?);
            lane += 1;
        }
        let sums = &settled(&*sums).0;
        Some([
            L::load_four(level, sums, 0)?,
            L::load_four(level, sums, 4)?,
            L::load_four(level, sums, 8)?,
        ])
    }
    /// Poses four points at a time. Each point is multiplied by the rows of its summed matrix, and
    /// the transpose adds the products in its steps, so that each step halves the number of
    /// registers. With a vertex in each lane all twelve entries of a sum would be transposed.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn points<V: Level, J: Index, W: Weight>(
        &self,
        level: V,
        skin: &Skin<'_, J, W>,
        PlainPoints { first, rest, posed }: PlainPoints<'_, R>,
    ) -> Option<usize> {
        // If a vector of four components takes several registers, a vertex in each lane is quicker.
        if R::Lanes::<V>::LANES < 4 {
            return None;
        }
        // A point is read as four components, of which the fourth belongs to the next point. No
        // point follows the last point, so the general loop poses the last one to four points.
        let count = posed.len().checked_sub(1)? & !3;
        let (rest, posed) = (rest.as_flattened().get(..3 * count + 1)?, posed.get_mut(..count)?);
        let palette: &[[R; 12]] = bytemuck::must_cast_slice(self.palette);
        let (picked, weights) = skin.in_place(first, count, palette)?;
        let one = [R::ZERO, R::ZERO, R::ZERO, R::ONE];
        let one: Rows<R, V> = (R::Packed::load_twice(level, &one), R::Half::load(level, &one));
        let fourth = (one.0.constant(0.0).lt(one.0), one.1.constant(0.0).lt(one.1));
        let mut four = 0;
        while four < count {
            let (mut two, mut third) = ([one.0; 4], [one.1; 4]);
            let weights: &[_; 4] = weights.get(four..four + 4)?.first_chunk()?;
            let points: &[R; 13] = rest.get(3 * four..)?.first_chunk()?;
            let mut which = 0;
            while which < 4 {
                let vertex = four + which;
                let sum = blended::<R, V>(level, picked.records(vertex)?, weights[which])?;
                let point = points[3 * which..].first_chunk()?;
                let twice = R::Packed::select(fourth.0, one.0, R::Packed::load_twice(level, point));
                let once = R::Half::select(fourth.1, one.1, R::Half::load(level, point));
                (two[which], third[which]) = (sum.0 * twice, sum.1 * once);
                which += 1;
            }
            let xy = R::Packed::sum_quads(two).to_array();
            let [x, y]: &[[R; 4]; 2] = bytemuck::cast_ref(&xy);
            let (x, y) = (R::Half::load(level, x), R::Half::load(level, y));
            let z = R::Half::sum_quads(third);
            Records::store_records([x, y, z], posed.get_mut(four..four + 4)?);
            four += 4;
        }
        Some(count)
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn join<L: Lanes<Real = R>>(&self, a: [[L; 4]; 3], b: [[L; 4]; 3]) -> [[L; 4]; 3] {
        let mut sum = a;
        for (row, other) in sum.iter_mut().zip(b) {
            for (number, other) in row.iter_mut().zip(other) {
                *number = *number + other;
            }
        }
        sum
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn map<L: Lanes<Real = R>>(&self, _: L::Level, sum: [[L; 4]; 3], _: usize) -> LinearMap<L> {
        LinearMap(sum)
    }
}

/// The affine map v ↦ Lv + t, as the rows of the matrix [L | t].
#[derive(Clone, Copy, Debug)]
pub struct LinearMap<L>(pub(super) [[L; 4]; 3]);

impl<L: Lanes> SurfaceMap<L> for LinearMap<L> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn point(&self, [x, y, z]: [L; 3]) -> [L; 3] {
        let mut moved = [x; 3];
        for (moved, [a, b, c, t]) in moved.iter_mut().zip(self.0) {
            // This is the order of operations in `Linear::points`, so both give the same bits.
            *moved = (x * a + z * c) + (y * b + t);
        }
        moved
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn normal(&self, normal: [L; 3]) -> [L; 3] {
        unit(cofactors(self.linear(), normal))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn tangent(&self, tangent: [L; 3]) -> [L; 3] {
        unit(turned(self.linear(), tangent))
    }
}

impl<L: Lanes> LinearMap<L> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn linear(&self) -> [[L; 3]; 3] {
        let [[a, b, c, _], [d, e, f, _], [g, h, i, _]] = self.0;
        [[a, b, c], [d, e, f], [g, h, i]]
    }
}

/// Returns Lv, the product of a 3×3 matrix by rows and a vector.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn turned<L: Lanes>(rows: [[L; 3]; 3], v: [L; 3]) -> [L; 3] {
    let [x, y, z] = rows;
    [vector::dot(x, v), vector::dot(y, v), vector::dot(z, v)]
}

/// Returns cof(L) n, which is normal to the image under L of a surface with the normal n. It equals
/// det(L) L⁻ᵀn, and also exists if L has no inverse.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn cofactors<L: Lanes>([x, y, z]: [[L; 3]; 3], normal: [L; 3]) -> [L; 3] {
    turned([vector::cross(y, z), vector::cross(z, x), vector::cross(x, y)], normal)
}

/// Returns v/|v|, or zero if v is so short that it has no direction.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn unit<L: Lanes>(v: [L; 3]) -> [L; 3] {
    let square = vector::dot(v, v);
    let (zero, one) = (square.constant(0.0), square.constant(1.0));
    // If the square of the length is subnormal, the quotient may overflow.
    let smallest = if L::Real::SINGLE { f32::MIN_POSITIVE.into() } else { f64::MIN_POSITIVE };
    let none = square.lt(square.constant(smallest));
    let factor = L::select(none, zero, one / L::select(none, one, square).sqrt());
    vector::scale(v, factor)
}

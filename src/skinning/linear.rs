use super::blender::{Blender, PlainPoints, SurfaceMap};
use super::skin::{GROUP, Scratch, Skin, Weight, settled};
use crate::batch::vector;
use crate::macros::brief;
use crate::number::Scalar;
use crate::storage::shape::{ShapeError, same_length};
use dq8_simd::internal::Index;
use dq8_simd::{Float, Lanes, Level, PackedDualQuat, Records};

/// Linear blend skinning (Magnenat-Thalmann et al. 1988): v ↦ Σ wᵢMᵢv. Needs weights that
/// sum to one. Cheapest, and right for any matrix, but the sum of two rotations is not a rotation:
/// elbows and twisted wrists collapse.
///
/// Normals become cof(Σ wᵢMᵢ)n, normalized; tangents (Σ wᵢMᵢ)t, normalized; zero where
/// that is zero.
#[derive(Clone, Copy)]
pub struct Linear<'a, R> {
    palette: &'a [[[R; 4]; 3]],
}

brief!([R] Linear<'_, R>: Linear |it| { joints: it.palette.len() });

impl<'a, R: Scalar> Linear<'a, R> {
    /// The rows of each joint's 3×4 matrix, from the mesh at rest to the posed mesh:
    /// [`MatrixOrder::Rows`], as palettes are unless told otherwise.
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

/// A register of two rows of a matrix, and one of the third.
type Rows<R, V> = (<R as Float>::Packed<V>, <R as Float>::Half<V>);

/// The weighted sum of four matrices.
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

    // Sums of matrices are made in half as wide registers, and transposed.
    const SHUFFLES: bool = true;

    fn check(&self, joints: usize, _: usize) -> Result<(), ShapeError> {
        same_length("palette", self.palette.len(), joints)
    }
    /// First in memory, one vertex after the other: fewer instructions than lanes of vertices,
    /// which would transpose every matrix. Here it is the sums only.
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
    /// Four points at a time, each times the rows of its sum of matrices; then the products are
    /// added, and half of the numbers are gone at each step of the transpose. On lanes all twelve
    /// of a sum would be transposed.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn points<V: Level, J: Index, W: Weight>(
        &self,
        level: V,
        skin: &Skin<'_, J, W>,
        PlainPoints { first, rest, posed }: PlainPoints<'_, R>,
    ) -> Option<usize> {
        // Where a vector of four numbers is several registers, lanes of vertices are quicker.
        if R::Lanes::<V>::LANES < 4 {
            return None;
        }
        // A point is read with the number after it, which the last one does not have.
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
            let mut which = 0;
            while which < 4 {
                let vertex = four + which;
                let sum = blended::<R, V>(level, picked.records(vertex)?, *weights.get(vertex)?)?;
                let point = rest.get(3 * vertex..)?.first_chunk()?;
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

/// v ↦ Lv + t, the rows of [L | t].
#[derive(Clone, Copy, Debug)]
pub struct LinearMap<L>(pub(super) [[L; 4]; 3]);

impl<L: Lanes> SurfaceMap<L> for LinearMap<L> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn point(&self, [x, y, z]: [L; 3]) -> [L; 3] {
        let mut moved = [x; 3];
        for (moved, [a, b, c, t]) in moved.iter_mut().zip(self.0) {
            // As Linear::points does, to the last bit.
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

/// Lv
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn turned<L: Lanes>(rows: [[L; 3]; 3], v: [L; 3]) -> [L; 3] {
    let [x, y, z] = rows;
    [vector::dot(x, v), vector::dot(y, v), vector::dot(z, v)]
}

/// cof(L) n: how a surface with normal n lies after L. That is det(L) L⁻ᵀn, which exists for
/// every L.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn cofactors<L: Lanes>([x, y, z]: [[L; 3]; 3], normal: [L; 3]) -> [L; 3] {
    turned([vector::cross(y, z), vector::cross(z, x), vector::cross(x, y)], normal)
}

/// v/|v|, or zero where v has no direction.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn unit<L: Lanes>(v: [L; 3]) -> [L; 3] {
    let square = vector::dot(v, v);
    let (zero, one) = (square.constant(0.0), square.constant(1.0));
    // Below the smallest normal number the quotient is not finite.
    let smallest = if L::Real::SINGLE { f32::MIN_POSITIVE.into() } else { f64::MIN_POSITIVE };
    let none = square.lt(square.constant(smallest));
    let factor = L::select(none, zero, one / L::select(none, one, square).sqrt());
    vector::scale(v, factor)
}

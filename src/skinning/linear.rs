use super::blender::Blender;
use super::influences::{GROUP, Influences, settled};
use super::linear_map::LinearMap;
use crate::real::Scalar;
use crate::shape::{ShapeError, same_length};
use dq8_simd::picks::Index;
use dq8_simd::{Float, Lanes, PackedDualQuat, Records};

/// Linear blend skinning (Magnenat-Thalmann et al. 1988): v ↦ Σ wᵢMᵢv. Needs weights that sum to one.
/// Cheapest, and right for any matrix, but the sum of two rotations is not a rotation: elbows and twisted wrists
/// collapse.
///
/// Normals become cof(Σ wᵢMᵢ)n, normalized; tangents (Σ wᵢMᵢ)t, normalized; zero where that is zero.
#[derive(Clone, Copy, Debug)]
pub struct Linear<'a, R> {
    palette: &'a [[[R; 4]; 3]],
}

impl<'a, R: Scalar> Linear<'a, R> {
    /// The rows of each joint's 3×4 matrix, from the mesh at rest to the posed mesh.
    #[must_use]
    pub fn new(palette: &'a [[[R; 4]; 3]]) -> Self {
        Self { palette }
    }

    pub(super) fn joints(&self) -> usize {
        self.palette.len()
    }
}

/// A register that holds eight numbers of a matrix.
type Eight<L> = <<L as Lanes>::Real as Float>::Packed<<L as Lanes>::Level>;

/// Of a matrix of twelve numbers the first eight and the last eight: the four in the middle twice.
#[inline(always)]
fn halves<T>(matrix: &[T; 12]) -> Option<(&[T; 8], &[T; 8])> {
    Some((matrix.first_chunk()?, matrix.last_chunk()?))
}

/// The halves of a matrix times a weight.
#[inline(always)]
fn scaled<L: Lanes>(
    level: L::Level,
    matrix: &[L::Real; 12],
    weight: L::Real,
) -> Option<[Eight<L>; 2]> {
    let (head, tail) = halves(matrix)?;
    let weight = Eight::<L>::splat(level, weight);
    Some([Eight::<L>::load(level, head) * weight, Eight::<L>::load(level, tail) * weight])
}

/// And added to a sum.
#[inline(always)]
fn add_scaled<L: Lanes>(
    level: L::Level,
    matrix: &[L::Real; 12],
    weight: L::Real,
    [low, high]: [Eight<L>; 2],
) -> Option<[Eight<L>; 2]> {
    let (head, tail) = halves(matrix)?;
    let weight = Eight::<L>::splat(level, weight);
    let low = Eight::<L>::load(level, head).mul_add(weight, low);
    Some([low, Eight::<L>::load(level, tail).mul_add(weight, high)])
}

impl<R: Scalar> Blender<R> for Linear<'_, R> {
    type Sum<L: Lanes<Real = R>> = [[L; 4]; 3];
    type Map<L: Lanes<Real = R>> = LinearMap<L>;
    const MOTIONS: bool = false;
    const MATRICES: bool = true;

    fn check(&self, joints: usize, _: usize) -> Result<(), ShapeError> {
        same_length("palette", self.palette.len(), joints)
    }
    /// First in memory, one vertex after the other: fewer instructions than lanes of vertices, which
    /// would transpose every matrix. Here it is the sums only.
    #[inline(always)]
    fn sum<L: Lanes<Real = R>, J: Index>(
        &self,
        level: L::Level,
        influences: &mut Influences<'_, R, J>,
    ) -> Option<[[L; 4]; 3]> {
        let weights = &settled(&influences.weights).0;
        let matrices = settled(&influences.matrices);
        let picked = matrices.of(bytemuck::must_cast_slice(self.palette))?;
        let mut lane = 0;
        while lane < L::LANES {
            let weights = weights[lane];
            let mut sum = scaled::<L>(level, picked.record(lane, 0), weights[0])?;
            let mut influence = 1;
            while influence < GROUP {
                let matrix = picked.record(lane, influence);
                sum = add_scaled::<L>(level, matrix, weights[influence], sum)?;
                influence += 1;
            }
            let [low, high] = sum;
            let [x, y, z] = &mut influences.rows.0;
            low.store_halves(&mut x[lane], &mut y[lane]);
            // The lower half is the second row again.
            high.store_halves(&mut influences.again.0, &mut z[lane]);
            lane += 1;
        }
        let [x, y, z] = &settled(&influences.rows).0;
        Some([L::load_four(level, x, 0)?, L::load_four(level, y, 0)?, L::load_four(level, z, 0)?])
    }
    #[inline(always)]
    fn join<L: Lanes<Real = R>>(&self, a: [[L; 4]; 3], b: [[L; 4]; 3]) -> [[L; 4]; 3] {
        let mut sum = a;
        for (row, other) in sum.iter_mut().zip(b) {
            for (number, other) in row.iter_mut().zip(other) {
                *number = *number + other;
            }
        }
        sum
    }
    #[inline(always)]
    fn map<L: Lanes<Real = R>>(&self, _: L::Level, sum: [[L; 4]; 3], _: usize) -> LinearMap<L> {
        LinearMap(sum)
    }
}

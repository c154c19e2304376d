use super::blender::Blender;
use super::influences::{GROUP, Scratch, settled};
use super::linear_map::LinearMap;
use crate::real::Scalar;
use crate::shape::{ShapeError, same_length};
use dq8_simd::picks::Index;
use dq8_simd::{Float, Lanes, Records};

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

/// Registers that hold two rows of a matrix, and one.
type Two<L> = <<L as Lanes>::Real as Float>::Packed<<L as Lanes>::Level>;
type Third<L> = <<L as Lanes>::Real as Float>::Half<<L as Lanes>::Level>;

/// A matrix times a weight.
#[cfg_attr(not(opt_level_0), inline(always))]
fn scaled<L: Lanes>(
    level: L::Level,
    matrix: &[L::Real; 12],
    weight: L::Real,
) -> Option<(Two<L>, Third<L>)> {
    let two = Two::<L>::load(level, matrix.first_chunk()?) * Two::<L>::splat(level, weight);
    Some((two, Third::<L>::load(level, matrix.last_chunk()?) * Third::<L>::splat(level, weight)))
}

/// And added to a sum.
#[cfg_attr(not(opt_level_0), inline(always))]
fn add_scaled<L: Lanes>(
    level: L::Level,
    matrix: &[L::Real; 12],
    weight: L::Real,
    (two, third): (Two<L>, Third<L>),
) -> Option<(Two<L>, Third<L>)> {
    let of = (Two::<L>::load(level, matrix.first_chunk()?), Two::<L>::splat(level, weight));
    let last = (Third::<L>::load(level, matrix.last_chunk()?), Third::<L>::splat(level, weight));
    Some((of.0.mul_add(of.1, two), last.0.mul_add(last.1, third)))
}

impl<R: Scalar> Blender<R> for Linear<'_, R> {
    type Sum<L: Lanes<Real = R>> = [[L; 4]; 3];
    type Map<L: Lanes<Real = R>> = LinearMap<L>;

    // Sums of matrices are made in half as wide registers, and transposed.
    const SHUFFLES: bool = true;

    fn check(&self, joints: usize, _: usize) -> Result<(), ShapeError> {
        same_length("palette", self.palette.len(), joints)
    }
    /// First in memory, one vertex after the other: fewer instructions than lanes of vertices, which
    /// would transpose every matrix. Here it is the sums only.
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
            let weights = weights[lane];
            let mut sum = scaled::<L>(level, picked.record(lane, 0), weights[0])?;
            let mut influence = 1;
            while influence < GROUP {
                let matrix = picked.record(lane, influence);
                sum = add_scaled::<L>(level, matrix, weights[influence], sum)?;
                influence += 1;
            }
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

//! Jacobians at many times, a time in each lane.
//!
//! Maps of twists that come from motions or from brackets are 3×3 matrices of dual numbers, P +
//! εQ: they take ω + εv to Pω + ε(Pv + Qω), and as 6×6 matrices they are [P, 0; Q, P]. With
//! X for ξ ×, all maps of one factor are polynomials of X, for which X³ = −(ξ·ξ) X: three
//! coefficients each. So with
//!
//! ```text
//! λ J_r(λξ) = λ − λ²A X + λ³B X²
//! J_r⁻¹(ξ) = 1 + ½X + C X²        J_l⁻¹(ξ) = 1 − ½X + C X²
//! ```
//!
//! their products are one polynomial for each of the two control poses beside the factor.

use super::curve::Spline;
use super::job::{RECORD, ways};
use crate::along::Work;
use crate::clock::Time;
use crate::job::{GRAIN, Job};
use crate::screw::horner;
use crate::{Outside, TrajectoryError};
use dq8::batch::{self, Dual, vector};
use dq8::internal::{Rows, exponential_integrals, half_cotangent};
use dq8::storage::{Element, Register, Tile, same_length};
use dq8::{Lanes, Level, Scalar, Twist};

/// A matrix for each of four control poses.
const NUMBERS: usize = 4 * 36;

impl Job<&Spline> {
    /// `matrices[i]` = the four matrices of [`Spline::jacobians`] at the time `times[i]`, and
    /// `first[i]` = the number of the first of their control poses. Times outside are those of the
    /// nearest knot, if they are not refused; the frame of the job makes no difference.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// use dq8_trajectory::{Basis, Spline};
    /// let control = [0.0, 1.0, 4.0, 9.0, 16.0].map(|x| DualQuat::from_translation([x, 0.0, 0.0]));
    /// let spline = Spline::new(0.0, 1.0, &control, Basis::Through)?;
    /// let (mut first, mut matrices) = ([0; 2], [[[[0.0_f64; 6]; 6]; 4]; 2]);
    /// spline.job().jacobians(&[0.5, 1.0], &mut first, &mut matrices)?;
    /// assert_eq!(first, [0, 1]);
    /// // At a knot that pose alone counts.
    /// assert_eq!(matrices[1].map(|matrix| matrix[0][0]), [0.0, 1.0, 0.0, 0.0]);
    /// # Ok::<(), dq8_trajectory::TrajectoryError>(())
    /// ```
    ///
    /// # Errors
    /// If `first` or `matrices` are not as long as the times, the clock has a number that is not
    /// finite or a unit of zero, or a time is outside where that is refused; nothing is written.
    pub fn jacobians<T: Time, R: Scalar>(
        self,
        times: &[T],
        first: &mut [usize],
        matrices: &mut [[[[R; 6]; 6]; 4]],
    ) -> Result<(), TrajectoryError> {
        self.check(self.path.range(), "matrices", matrices.len(), times, 1)?;
        same_length("first", first.len(), times.len())?;
        for (first, &time) in first.iter_mut().zip(times) {
            *first = self.path.place(self.stamp(time)).first;
        }
        let segments = self.path.inner_segments();
        let numbers = matrices.as_flattened_mut().as_flattened_mut().as_flattened_mut();
        let (numbers, _) = numbers.as_chunks_mut::<NUMBERS>();
        let (shares, rate) = (self.path.basis.shares(), 1.0 / self.path.every);
        // The first and the last segment have no end: a time outside the knots goes on in them.
        let job = self.outside(Outside::Continue);
        let work = |first, (numbers, _): Rows<'_, [R; NUMBERS]>| {
            let elements = numbers.len();
            let work = Answers { numbers, shares, rate };
            job.along::<_, _, _, _>(&segments, times, first, elements, work);
        };
        // A time takes as long as some dozens of poses.
        self.choice.instructions().share(GRAIN / 32, (numbers, 1), &work);
        Ok(())
    }
}

struct Answers<'s, R> {
    numbers: &'s mut [[R; NUMBERS]],
    shares: [[f64; 4]; 3],
    /// Knots in a second.
    rate: f64,
}

type Plain<R> = <[R; NUMBERS] as Element<NUMBERS>>::Layout;

impl<R: Scalar> Work<Plain<R>, RECORD> for Answers<'_, R> {
    const WIDE: bool = true;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn tile<V: Level>(
        &mut self,
        _: V,
        tile: Tile,
        records: [Register<[R; NUMBERS], V, NUMBERS>; RECORD],
        since: Register<[R; NUMBERS], V, NUMBERS>,
    ) -> Option<()> {
        let [zero, one] = [0.0, 1.0].map(
            #[cfg_attr(not(opt_level_0), inline(always))]
            |number| since.constant(number),
        );
        // Outside it is the nearest knot; NaN stays.
        let u = since * since.constant(self.rate);
        let u = Lanes::select(u.lt(zero), zero, u);
        let u = Lanes::select(one.lt(u), one, u);
        let none = Dual::new(zero, zero);
        let mut sums = [[[none; 3]; 3]; 4];
        let mut behind =
            batch::DualQuat::from_twist(Twist { angular: [zero * u; 3], linear: [zero; 3] });
        let ways = ways(&records);
        for j in [2, 1, 0] {
            let way = ways[j];
            let share = horner(u, self.shares[j]);
            let carried = rotation(behind);
            let [before, after] = factor(way, share);
            add_product(&mut sums[j + 1], carried, after);
            add_product(&mut sums[j], carried, before);
            behind = behind * batch::DualQuat::from_twist(-way.scale(share));
        }
        let carried = rotation(behind);
        for row in 0..3 {
            for column in 0..3 {
                sums[0][row][column] = sums[0][row][column] + carried[row][column];
            }
        }
        let mut numbers = [zero; NUMBERS];
        for (matrix, sum) in numbers.chunks_exact_mut(36).zip(sums) {
            for row in 0..3 {
                for column in 0..3 {
                    let Dual { real, dual } = sum[row][column];
                    matrix[6 * row + column] = real;
                    matrix[6 * (row + 3) + column] = dual;
                    matrix[6 * (row + 3) + column + 3] = real;
                }
            }
        }
        <[R; NUMBERS]>::store(numbers, self.numbers, tile);
        Some(())
    }
}

type Map<L> = [[Dual<L>; 3]; 3];

/// −λ J_r(λξ) J_l⁻¹(ξ) and λ J_r(λξ) J_r⁻¹(ξ): how a factor answers to the control
/// poses before and after it.
#[cfg_attr(not(opt_level_0), inline(always))]
fn factor<L: Lanes>(way: Twist<L>, share: L) -> [Map<L>; 2] {
    let across = vector::dot(way.angular, way.linear);
    let square = Dual::new(vector::dot(way.angular, way.angular), across + across);
    let twice = share * share;
    let (once, again) = exponential_integrals(square.scale(twice));
    let (first, second) = (once.scale(-twice), again.scale(twice * share));
    let (half, cotangent) = (share.constant(0.5), half_cotangent(square));
    [
        answer(way, square, [-share, -half], [-first, -second, cotangent]),
        answer(way, square, [share, half], [first, second, cotangent]),
    ]
}

/// The product of λ + pX + qX² and 1 + hX + CX², of [λ, h] and [p, q, C].
#[cfg_attr(not(opt_level_0), inline(always))]
fn answer<L: Lanes>(
    way: Twist<L>,
    square: Dual<L>,
    [share, half]: [L; 2],
    [p, q, cotangent]: [Dual<L>; 3],
) -> Map<L> {
    let zero = share.constant(0.0);
    // X³ = −ξ·ξ X
    let first = Dual::new(share * half, zero) + p - square * (p * cotangent + q.scale(half));
    let second = cotangent.scale(share) + p.scale(half) + q - square * (q * cotangent);
    // X² = ξξᵀ − ξ·ξ
    of_way(way, [Dual::new(share, zero) - second * square, first, second])
}

/// a + bX + cξξᵀ
#[cfg_attr(not(opt_level_0), inline(always))]
fn of_way<L: Lanes>(way: Twist<L>, [a, b, c]: [Dual<L>; 3]) -> Map<L> {
    let ([x, y, z], [p, q, r]) = (way.angular, way.linear);
    let way = [Dual::new(x, p), Dual::new(y, q), Dual::new(z, r)];
    let [x, y, z] = [b * way[0], b * way[1], b * way[2]];
    let [i, j, k] = [c * way[0], c * way[1], c * way[2]];
    let [xy, xz, yz] = [i * way[1], i * way[2], j * way[2]];
    [
        [a + i * way[0], xy - z, xz + y],
        [xy + z, a + j * way[1], yz - x],
        [xz - y, yz + x, a + k * way[2]],
    ]
}

/// The adjoint of a motion, R + ε t×R.
#[cfg_attr(not(opt_level_0), inline(always))]
fn rotation<L: Lanes>(motion: batch::DualQuat<L>) -> Map<L> {
    let rows = motion.real().to_matrix3();
    let [x, y, z] = motion.translation();
    let mut map = [[Dual::new(x, x); 3]; 3];
    for column in 0..3 {
        let [a, b, c] = [rows[0][column], rows[1][column], rows[2][column]];
        let moment = vector::cross([x, y, z], [a, b, c]);
        for (row, (real, dual)) in [a, b, c].into_iter().zip(moment).enumerate() {
            map[row][column] = Dual::new(real, dual);
        }
    }
    map
}

#[cfg_attr(not(opt_level_0), inline(always))]
fn add_product<L: Lanes>(sum: &mut Map<L>, a: Map<L>, b: Map<L>) {
    for row in 0..3 {
        for column in 0..3 {
            let mut entry = sum[row][column];
            for k in 0..3 {
                let (x, y) = (a[row][k], b[k][column]);
                let dual = x.dual.mul_add(y.real, x.real.mul_add(y.dual, entry.dual));
                entry = Dual::new(x.real.mul_add(y.real, entry.real), dual);
            }
            sum[row][column] = entry;
        }
    }
}

//! The rates that give a link a velocity: damped least squares, by turning the rows of a Jacobian
//! until they are orthogonal. The same code serves one configuration and many on lanes.

use super::jacobians::JacobianFrame;
use super::tree::Mechanism;
use dq8::geometry::Twist;
use dq8::storage::same_length;
use dq8::{Scalar, ShapeError};
use dq8_simd::{Lanes, Mask};

impl<R: Scalar + Lanes<Real = R>> Mechanism<'_, R> {
    /// Computes the rates that move a link best with the velocity `twist`, given in the frame of
    /// the first argument: |J · rates − twist|² + λ²|rates|² is least, where J is the link's
    /// Jacobian and λ is `damping` (Wampler 1986). This is the inverse of
    /// [`link_velocities`](Self::link_velocities) for one link. Angular and linear velocities have
    /// equal weights.
    ///
    /// With `damping` zero these are the least rates of all that fit equally well, J⁺ · twist,
    /// so rates that move nothing are zero. Near a singularity they are large, unless `damping`
    /// keeps them small. `columns` is scratch memory with one element per rate, whose contents do
    /// not matter.
    ///
    /// ```
    /// use dq8::{DualQuat, Twist};
    /// use dq8_robot::{Joint, OwnedMechanism, WorldAligned};
    /// // A hinge on a slide.
    /// let joints = [
    ///     Joint::prismatic(None, DualQuat::IDENTITY, [1.0, 0.0, 0.0]),
    ///     Joint::revolute(Some(0), DualQuat::IDENTITY, [0.0, 0.0, 1.0_f64]),
    /// ];
    /// let arm = OwnedMechanism::new(&joints)?;
    /// let (mut columns, mut rates) = ([Twist::ZERO; 2], [0.0; 2]);
    /// // Nothing moves it along y.
    /// let twist = Twist { angular: [0.0, 0.0, 0.5], linear: [2.0, 3.0, 0.0] };
    /// let at = [0.1, 0.2];
    /// arm.view().rates_for(WorldAligned, &at, 1, twist, 0.0, &mut columns, &mut rates)?;
    /// assert!((rates[0] - 2.0).abs() < 1e-14 && (rates[1] - 0.5).abs() < 1e-14);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// If a slice does not have the length that the mechanism asks for, or there is no such link;
    /// `columns` and `rates` are untouched.
    #[expect(clippy::too_many_arguments, reason = "the question, then the memory of the answer")]
    pub fn rates_for<F: JacobianFrame>(
        &self,
        frame: F,
        values: &[R],
        link: usize,
        twist: Twist<R>,
        damping: R,
        columns: &mut [Twist<R>],
        rates: &mut [R],
    ) -> Result<(), ShapeError> {
        same_length("rates", rates.len(), self.rates())?;
        self.link_jacobian(frame, values, link, columns)?;
        let columns = bytemuck::must_cast_slice_mut::<_, [R; 6]>(columns);
        let scales = scales(R::ZERO, columns, twist.to_array(), damping.into());
        for (rate, column) in rates.iter_mut().zip(&*columns) {
            *rate = rate_of(R::ZERO, column, &scales);
        }
        Ok(())
    }
}

/// Returns the product of two rows of a Jacobian.
#[cfg_attr(not(opt_level_0), inline(always))]
pub fn rows<L: Lanes>(zero: L, columns: &[[L; 6]], i: usize, j: usize) -> L {
    let mut sum = zero;
    for column in columns {
        sum = column[i].mul_add(column[j], sum);
    }
    sum
}

/// The number of sweeps that rows of nearly equal length may take.
const SWEEPS: usize = 16;

/// Turns the rows of J, and a twist with them, until the rows are orthogonal: U J = ΣVᵀ
/// (Hestenes' form of Jacobi's method). The rates are then sums of the rows that are left in
/// `columns` ([`rate_of`]), with the factors that this function returns: (U twist)/(σ² + λ²),
/// or 0 where σ is only rounding, compared with the largest.
#[cfg_attr(not(opt_level_0), inline(always))]
pub fn scales<L: Lanes>(
    zero: L,
    columns: &mut [[L; 6]],
    mut twist: [L; 6],
    damping: f64,
) -> [L; 6] {
    let one = zero.constant(1.0);
    let epsilon: f64 =
        if <L::Real as dq8_simd::Float>::SINGLE { f32::EPSILON.into() } else { f64::EPSILON };
    let mut total = zero;
    for row in 0..6 {
        total = total + rows(zero, columns, row, row);
    }
    // Shorter rows and smaller products are rounding errors.
    let cut = epsilon * columns.len().max(6) as f64;
    let (cut, least) = (total * zero.constant(cut * cut), zero.constant(16.0 * epsilon * epsilon));
    for _ in 0..SWEEPS {
        let mut turned = !zero.eq(zero);
        for i in 0..5 {
            for j in i + 1..6 {
                let (a, b) = (rows(zero, columns, i, i), rows(zero, columns, j, j));
                let product = rows(zero, columns, i, j);
                let is_small = (product * product).le(least * a * b) | a.le(cut) | b.le(cut);
                turned = turned | (!is_small & product.eq(product));
                let half = (b - a) / (product + product);
                let size = one / (half.abs() + (half * half + one).sqrt());
                let tangent = L::select(half.lt(zero), -size, size);
                let tangent = L::select(is_small, zero, tangent);
                let cosine = one / (tangent * tangent + one).sqrt();
                let sine = tangent * cosine;
                for column in &mut *columns {
                    (column[i], column[j]) = turn(cosine, sine, column[i], column[j]);
                }
                (twist[i], twist[j]) = turn(cosine, sine, twist[i], twist[j]);
            }
        }
        if !turned.any() {
            break;
        }
    }
    let added = zero.constant(damping * damping);
    let mut scales = twist;
    for (row, scale) in scales.iter_mut().enumerate() {
        let square = rows(zero, columns, row, row);
        *scale = L::select(square.le(cut), zero, twist[row] / (square + added));
    }
    scales
}

/// Returns a rate from its column, whose rows [`scales`] has turned.
#[cfg_attr(not(opt_level_0), inline(always))]
pub fn rate_of<L: Lanes>(zero: L, column: &[L; 6], scales: &[L; 6]) -> L {
    let mut sum = zero;
    for (&row, &scale) in column.iter().zip(scales) {
        sum = row.mul_add(scale, sum);
    }
    sum
}

/// Returns two numbers of a column after the turn.
#[cfg_attr(not(opt_level_0), inline(always))]
fn turn<L: Lanes>(cosine: L, sine: L, x: L, y: L) -> (L, L) {
    (cosine * x - sine * y, sine * x + cosine * y)
}

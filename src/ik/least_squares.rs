//! Damped least squares in six dimensions, for any number of columns.

use dq8_simd::{Float, Lanes};

/// y with (JJᵀ + λ²1) y = e, so that Jᵀy is the x that makes |Jx − e|² + λ²|x|² least (Nakamura &
/// Hanafusa 1986; Wampler 1986; Buss 2004, eq. 11), J without the columns that are `held`.
///
/// By Cholesky's factorisation in place. To λ² is added what rounding makes of JJᵀ, so that a singular
/// J is not a special case; and each pivot is at least λ², as it would be without rounding.
#[inline(always)]
#[allow(clippy::needless_range_loop, reason = "rows and columns are numbers here")]
pub(super) fn damped<L: Lanes, const N: usize>(
    columns: &[[L; 6]; N],
    held: &[L::Mask; N],
    error: [L; 6],
    damping: L,
) -> [L; 6] {
    let zero = damping.constant(0.0);
    let mut a = [[zero; 6]; 6];
    for (column, &held) in columns.iter().zip(held) {
        for i in 0..6 {
            let factor = L::select(held, zero, column[i]);
            for j in 0..=i {
                a[i][j] = factor.mul_add(column[j], a[i][j]);
            }
        }
    }
    let trace = a[0][0] + a[1][1] + a[2][2] + a[3][3] + a[4][4] + a[5][5];
    let least = trace.mul_add(damping.constant(0.25 * epsilon::<L>()), damping);

    // L of LLᵀ, row by row, with the reciprocals of its diagonal.
    let mut reciprocals = [zero; 6];
    for i in 0..6 {
        for j in 0..i {
            let mut sum = a[i][j];
            for k in 0..j {
                sum = a[i][k].neg_mul_add(a[j][k], sum);
            }
            a[i][j] = sum * reciprocals[j];
        }
        let mut pivot = a[i][i] + least;
        for k in 0..i {
            pivot = a[i][k].neg_mul_add(a[i][k], pivot);
        }
        let pivot = L::select(pivot.lt(least), least, pivot);
        reciprocals[i] = damping.constant(1.0) / pivot.sqrt();
    }
    let mut y = error;
    for i in 0..6 {
        for k in 0..i {
            y[i] = a[i][k].neg_mul_add(y[k], y[i]);
        }
        y[i] = y[i] * reciprocals[i];
    }
    for i in (0..6).rev() {
        for k in i + 1..6 {
            y[i] = a[k][i].neg_mul_add(y[k], y[i]);
        }
        y[i] = y[i] * reciprocals[i];
    }
    y
}

/// The distance from 1 to the next larger number.
#[inline(always)]
pub(crate) fn epsilon<L: Lanes>() -> f64 {
    if L::Real::SINGLE { f64::from(f32::EPSILON) } else { f64::EPSILON }
}

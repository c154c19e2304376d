use super::error::OrthonormalError;
use crate::number::Real;
use crate::scalar::vector;

/// The rotation matrix with the first column in the direction of the matrix's first, the second in
/// the plane of its first two, and the third their cross product (Gram 1883, Schmidt 1907;
/// Kenwright §3.5.2 names it against drift). Rows in, rows out.
///
/// Cheap, and not fair: the first axis keeps its direction and the errors go to the others, so
/// another order of axes gives another rotation. [`Polar`](crate::representation::Polar) gives the
/// nearest one. The first two columns are projected twice, because one projection of a thin wedge
/// leaves a right angle only to rounding over the sine of the wedge.
///
/// # Errors
/// If an element is not finite, a column is within rounding of the span of those before it, or the
/// matrix mirrors.
///
/// ```
/// let drifted = [[2.0_f64, 0.5, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 3.0]];
/// let identity = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// assert_eq!(dq8::representation::gram_schmidt(drifted)?, identity);
/// # Ok::<(), dq8::representation::OrthonormalError>(())
/// ```
pub fn gram_schmidt<R: Real>(rows: [[R; 3]; 3]) -> Result<[[R; 3]; 3], OrthonormalError> {
    all_finite(rows)?;
    let least = R::from(4.0) * R::EPSILON;
    let column = |index: usize| {
        let column = rows.map(|row| row[index]);
        let largest = vector::largest(column);
        if largest == R::ZERO {
            return Err(OrthonormalError::Dependent { column: index, sine: 0.0 });
        }
        // First by the largest element: the length itself may overflow.
        Ok(direction(column.map(|c| c / largest)))
    };
    let x = column(0)?;
    let across = vector::across(x, column(1)?);
    let sine = vector::norm(across);
    if sine <= least {
        return Err(OrthonormalError::Dependent { column: 1, sine: sine.into() });
    }
    let y = direction(vector::across(x, direction(across)));
    let z = vector::cross(x, y);
    let height = vector::dot(z, column(2)?);
    if height.abs() <= least {
        return Err(OrthonormalError::Dependent { column: 2, sine: height.abs().into() });
    }
    if height < R::ZERO {
        return Err(OrthonormalError::Mirrors { determinant: (sine * height).into() });
    }
    Ok(core::array::from_fn(|row| [x[row], y[row], z[row]]))
}

/// # Errors
/// If an element is not finite.
pub(super) fn all_finite<R: Real>(rows: [[R; 3]; 3]) -> Result<(), OrthonormalError> {
    for (row, elements) in rows.into_iter().enumerate() {
        for (column, value) in elements.into_iter().enumerate() {
            if !value.is_finite() {
                return Err(OrthonormalError::NotFinite { row, column, value: value.into() });
            }
        }
    }
    Ok(())
}

fn direction<R: Real>(v: [R; 3]) -> [R; 3] {
    let norm = vector::norm(v);
    v.map(|c| c / norm)
}

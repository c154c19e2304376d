use super::frame::WorldAligned;
use super::tree::Mechanism;
use dq8::geometry::Twist;
use dq8::{Real, ShapeError};

impl<R: Real> Mechanism<'_, R> {
    /// The distance of a link from where it cannot move in every direction: w = √det(J Jᵀ), the
    /// volume of the twists that rates of length one give it, but for a constant factor (Yoshikawa,
    /// *Manipulability of Robotic Mechanisms*, 1985, eq. 9), from the whole Jacobian of six rows;
    /// radians, and lengths cubed. It is the same in every [frame](super::JacobianFrame). Zero
    /// where the link is singular, but for rounding, and always where there are fewer than six
    /// rates; NaN if its pose is. It is computed in the memory of `columns`, which may hold
    /// anything.
    ///
    /// ```
    /// use dq8::{DualQuat, Twist};
    /// use dq8_robot::{Joint, OwnedMechanism};
    /// // Three slides, and three hinges that meet in a point: singular where the second lays the third along the first.
    /// let [x, y, z] = [[1.0_f64, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    /// let here = DualQuat::IDENTITY;
    /// let wrist = OwnedMechanism::new(&[
    ///     Joint::prismatic(None, here, x),
    ///     Joint::prismatic(Some(0), here, y),
    ///     Joint::prismatic(Some(1), here, z),
    ///     Joint::revolute(Some(2), here, z),
    ///     Joint::revolute(Some(3), here, y),
    ///     Joint::revolute(Some(4), here, z),
    /// ])?;
    /// let mut columns = [Twist::ZERO; 6];
    /// let mut at = |bend: f64| {
    ///     wrist.view().manipulability(&[0.1, 0.2, 0.3, 0.4, bend, 0.5], 5, &mut columns)
    /// };
    /// assert!((at(0.3)? - 0.3_f64.sin()).abs() < 1e-15);
    /// assert!(at(0.0)? < 1e-15);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// If there are not as many values and columns as the mechanism has, or there is no such link;
    /// `columns` is untouched.
    pub fn manipulability(
        &self,
        values: &[R],
        link: usize,
        columns: &mut [Twist<R>],
    ) -> Result<R, ShapeError> {
        self.link_jacobian(WorldAligned, values, link, columns)?;
        Ok(volume(columns))
    }
}

/// √det(J Jᵀ) of these columns, which it overwrites: the product of the lengths of the six
/// rows, each without what lies along those before it (Gram–Schmidt). Near singularities the
/// product J Jᵀ would have lost half of the digits.
fn volume<R: Real>(columns: &mut [Twist<R>]) -> R {
    // Six rows of fewer columns are never independent.
    let mut volume = if columns.len() < 6 { R::ZERO } else { R::ONE };
    for first in 0..6 {
        let dot = |columns: &[Twist<R>], row: usize| {
            let rows = columns.iter().map(|column| column.to_array());
            rows.fold(R::ZERO, |sum, column| sum + column[first] * column[row])
        };
        let square = dot(columns, first);
        volume = volume * square.sqrt();
        for row in first + 1..6 {
            let along = dot(columns, row) / square;
            for column in columns.iter_mut().filter(|_| square > R::ZERO) {
                let mut rows = column.to_array();
                rows[row] = rows[row] - along * rows[first];
                *column = Twist::from_array(rows);
            }
        }
    }
    volume
}

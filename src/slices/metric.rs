use super::map::{OfPairs, operations};
use super::sweep::sweep;
use crate::backend::Backend;
use crate::batch::DualQuat;
use crate::storage::Element;
use crate::storage::shape::{ShapeError, same_length};

impl Backend {
    /// `angles[i]` = the angle between unit aᵢ and bᵢ, radians in [0, π]; see
    /// [`DualQuat::angle_to`](crate::DualQuat::angle_to).
    ///
    /// # Errors
    /// If the slices differ in length; `angles` is untouched.
    #[inline]
    pub fn angles<E: Element<8>, T: Element<1, Layout = E::Layout>>(
        self,
        a: &[E],
        b: &[E],
        angles: &mut [T],
    ) -> Result<(), ShapeError> {
        same_length("b", b.len(), a.len())?;
        same_length("angles", angles.len(), a.len())?;
        sweep(self, angles, OfPairs { a, b, operation: Angle });
        Ok(())
    }

    /// `distances[i]` = |t_a − t_b| of unit aᵢ and bᵢ; see
    /// [`DualQuat::distance_to`](crate::DualQuat::distance_to).
    ///
    /// # Errors
    /// If the slices differ in length; `distances` is untouched.
    ///
    /// ```
    /// use dq8::{Backend, DualQuat};
    /// let (here, there) = ([DualQuat::IDENTITY; 5], [DualQuat::from_translation([0.0_f32, 3.0, 4.0]); 5]);
    /// let mut distances = [0.0_f32; 5];
    /// Backend::best().distances(&here, &there, &mut distances)?;
    /// assert_eq!(distances, [5.0; 5]);
    /// # Ok::<(), dq8::ShapeError>(())
    /// ```
    #[inline]
    pub fn distances<E: Element<8>, T: Element<1, Layout = E::Layout>>(
        self,
        a: &[E],
        b: &[E],
        distances: &mut [T],
    ) -> Result<(), ShapeError> {
        same_length("b", b.len(), a.len())?;
        same_length("distances", distances.len(), a.len())?;
        sweep(self, distances, OfPairs { a, b, operation: Distance });
        Ok(())
    }
}

operations! {
    Angle(a: 8, b: 8) -> 1 = [DualQuat::from_array(a).angle_to(DualQuat::from_array(b))];
    Distance(a: 8, b: 8) -> 1 = [DualQuat::from_array(a).distance_to(DualQuat::from_array(b))];
}

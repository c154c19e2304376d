use super::sweep::{Operation, motions, same_length, sweep};
use crate::batch;
use crate::dispatch::Backend;
use crate::error::ShapeError;
use crate::place::{Number, Place, Register, Step};
use crate::scalar::DualQuat;
use dq8_simd::Level;

impl Backend {
    /// `products[i] = a[i] · b[i]`: b acts first.
    ///
    /// # Errors
    /// If the slices differ in length; `products` is untouched.
    ///
    /// ```
    /// use dq8::{Backend, DualQuat};
    /// let step = [DualQuat::from_translation([1.0_f32, 0.0, 0.0]); 3];
    /// let mut two = [DualQuat::IDENTITY; 3];
    /// Backend::best().mul(&step, &step, &mut two)?;
    /// assert_eq!(two[2].translation(), [2.0, 0.0, 0.0]);
    /// # Ok::<(), dq8::ShapeError>(())
    /// ```
    #[inline]
    pub fn mul<P: Place<8>>(self, a: &[P], b: &[P], products: &mut [P]) -> Result<(), ShapeError> {
        same_length("b", b.len(), a.len())?;
        same_length("products", products.len(), a.len())?;
        sweep(self, products, Product { a: Some(a), b });
        Ok(())
    }

    /// `a[i] ← a[i] · b[i]`
    ///
    /// # Errors
    /// If the slices differ in length; `a` is untouched.
    #[inline]
    pub fn mul_in_place<P: Place<8>>(self, a: &mut [P], b: &[P]) -> Result<(), ShapeError> {
        same_length("b", b.len(), a.len())?;
        sweep(self, a, Product { a: None, b });
        Ok(())
    }

    /// `motions[i] ← left · motions[i]`: every motion goes where `left` takes it.
    ///
    /// ```
    /// use dq8::{Backend, DualQuat};
    /// let mut poses = [DualQuat::from_translation([1.0_f32, 0.0, 0.0]); 3];
    /// let up = DualQuat::from_translation([0.0, 0.0, 2.0]);
    /// Backend::best().mul_left_in_place(up, &mut poses);
    /// assert_eq!(poses[2].translation(), [1.0, 0.0, 2.0]);
    /// ```
    #[inline]
    pub fn mul_left_in_place<P: Place<8>>(self, left: DualQuat<Number<P, 8>>, motions: &mut [P]) {
        sweep(self, motions, Left(left));
    }
}

struct Left<R>(DualQuat<R>);

impl<P: Place<8>> Operation<P, 8> for Left<Number<P, 8>> {
    fn reads_output(&self) -> bool {
        true
    }
    #[inline(always)]
    fn compute<V: Level>(
        &self,
        level: V,
        output: &[P],
        step: Step,
    ) -> Option<[Register<P, V, 8>; 8]> {
        let left = batch::DualQuat::splat(level, self.0.to_array());
        Some((left * motions(level, output, step)?).to_array())
    }
}

/// Without `a`, what the output holds.
struct Product<'s, P> {
    a: Option<&'s [P]>,
    b: &'s [P],
}

impl<P: Place<8>> Operation<P, 8> for Product<'_, P> {
    fn reads_output(&self) -> bool {
        self.a.is_none()
    }
    #[inline(always)]
    fn compute<V: Level>(
        &self,
        level: V,
        output: &[P],
        step: Step,
    ) -> Option<[Register<P, V, 8>; 8]> {
        let a = motions(level, self.a.unwrap_or(output), step)?;
        Some((a * motions(level, self.b, step)?).to_array())
    }
}

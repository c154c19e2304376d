use super::sweep::{SliceKernel, Things, motions, part, sweep};
use crate::backend::Backend;
use crate::batch;
use crate::scalar::DualQuat;
use crate::storage::shape::{ShapeError, same_length};
use crate::storage::{Element, Number, Source, Tile};
use core::ops::Range;
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
    pub fn mul<E: Element<8>>(
        self,
        a: &[E],
        b: &[E],
        products: &mut [E],
    ) -> Result<(), ShapeError> {
        same_length("b", b.len(), a.len())?;
        same_length("products", products.len(), a.len())?;
        sweep(self, products, Product { a: Source::Slice(a), b });
        Ok(())
    }

    /// `a[i] ← a[i] · b[i]`
    ///
    /// # Errors
    /// If the slices differ in length; `a` is untouched.
    #[inline]
    pub fn mul_in_place<E: Element<8>>(self, a: &mut [E], b: &[E]) -> Result<(), ShapeError> {
        same_length("b", b.len(), a.len())?;
        sweep(self, a, Product { a: Source::Output, b });
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
    pub fn mul_left_in_place<E: Element<8>>(self, left: DualQuat<Number<E, 8>>, motions: &mut [E]) {
        sweep(self, motions, ProductByOne(left));
    }
}

struct ProductByOne<R>(DualQuat<R>);

impl<E: Element<8>> SliceKernel<E, 8> for ProductByOne<Number<E, 8>> {
    fn reads_output(&self) -> bool {
        true
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn compute<V: Level>(&self, level: V, output: &[E], tile: Tile) -> Things<E, V, 8> {
        let left = batch::DualQuat::splat(level, self.0);
        Some((left * motions(level, output, tile)?).to_array())
    }
    fn part(&self, _: Range<usize>) -> Self {
        Self(self.0)
    }
}

struct Product<'s, E> {
    a: Source<'s, E>,
    b: &'s [E],
}

impl<E: Element<8>> SliceKernel<E, 8> for Product<'_, E> {
    fn reads_output(&self) -> bool {
        self.a.is_output()
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn compute<V: Level>(&self, level: V, output: &[E], tile: Tile) -> Things<E, V, 8> {
        let a = motions(level, self.a.or(output), tile)?;
        Some((a * motions(level, self.b, tile)?).to_array())
    }
    fn part(&self, elements: Range<usize>) -> Self {
        Self { a: self.a.part(elements.clone()), b: part(self.b, elements) }
    }
}

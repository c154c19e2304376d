//! Kernels that apply one motion to all elements.

use super::sweep::{SliceKernel, Things, sweep};
use crate::backend::Backend;
use crate::batch;
use crate::scalar::DualQuat;
use crate::storage::motions;
use crate::storage::shape::{ShapeError, same_length};
use crate::storage::{self, Element, Number, Register, Source, Tile};
use core::ops::Range;
use dq8_simd::{Lanes, Level};

impl Backend {
    /// Multiplies every motion by `left` from the left, which moves each pose by `left`:
    /// `motions[i] ← left · motions[i]`. For products of two slices there is [`mul`](Self::mul).
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

    /// Moves points by one unit motion with rotation R and translation t: `moved[i]` =
    /// R·`points[i]` + t. The motion is converted to a 3×4 matrix once, so that each point takes
    /// nine multiplications; see [`DualQuat::transform_point`].
    ///
    /// # Errors
    /// If the slices differ in length; `moved` is untouched.
    #[inline]
    pub fn transform_points<P: Element<3>>(
        self,
        motion: DualQuat<Number<P, 3>>,
        points: &[P],
        moved: &mut [P],
    ) -> Result<(), ShapeError> {
        same_length("moved", moved.len(), points.len())?;
        sweep(self, moved, ByOne::of(motion, Source::Slice(points)));
        Ok(())
    }

    /// Moves points in place as [`transform_points`](Self::transform_points) does.
    #[inline]
    pub fn transform_points_in_place<P: Element<3>>(
        self,
        motion: DualQuat<Number<P, 3>>,
        points: &mut [P],
    ) {
        sweep(self, points, ByOne::of(motion, Source::Output));
    }

    /// Turns vectors by the rotation R of one unit motion: `turned[i]` = R·`vectors[i]`. Vectors
    /// are directions or differences of points, which do not translate; see
    /// [`DualQuat::transform_vector`].
    ///
    /// # Errors
    /// If the slices differ in length; `turned` is untouched.
    #[inline]
    pub fn transform_vectors<P: Element<3>>(
        self,
        motion: DualQuat<Number<P, 3>>,
        vectors: &[P],
        turned: &mut [P],
    ) -> Result<(), ShapeError> {
        same_length("turned", turned.len(), vectors.len())?;
        let turn = DualQuat::from_rotation(motion.rotation());
        sweep(self, turned, ByOne::of(turn, Source::Slice(vectors)));
        Ok(())
    }

    /// Turns vectors in place as [`transform_vectors`](Self::transform_vectors) does.
    #[inline]
    pub fn transform_vectors_in_place<P: Element<3>>(
        self,
        motion: DualQuat<Number<P, 3>>,
        vectors: &mut [P],
    ) {
        sweep(self, vectors, ByOne::of(DualQuat::from_rotation(motion.rotation()), Source::Output));
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
    fn part(&self, _: Range<usize>) -> Option<Self> {
        Some(Self(self.0))
    }
}

/// A kernel that moves points by the three rows of one 3×4 matrix.
struct ByOne<'s, P: Element<3>> {
    rows: [[Number<P, 3>; 4]; 3],
    from: Source<'s, P>,
}

impl<'s, P: Element<3>> ByOne<'s, P> {
    #[inline]
    fn of(motion: DualQuat<Number<P, 3>>, from: Source<'s, P>) -> Self {
        Self { rows: motion.to_matrix3x4(), from }
    }
}

impl<P: Element<3>> SliceKernel<P, 3> for ByOne<'_, P> {
    // A page waits for every byte of WebAssembly.
    const TILES: usize = if cfg!(target_arch = "wasm32") { 1 } else { 2 };
    fn reads_output(&self) -> bool {
        self.from.is_output()
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn compute<V: Level>(&self, level: V, output: &[P], tile: Tile) -> Things<P, V, 3> {
        let [x, y, z] = P::load(level, self.from.or(output), tile, &storage::identity())?;
        let mut moved = [x; 3];
        for (moved, row) in moved.iter_mut().zip(self.rows) {
            // The splats are written inside the loop over tiles, but the compiler hoists them: the
            // twelve registers hold their values from one tile to the next.
            let [a, b, c, t] = row.map(
                #[cfg_attr(not(opt_level_0), inline(always))]
                |number| Register::<P, V, 3>::splat(level, number),
            );
            *moved = z.mul_add(c, y.mul_add(b, x.mul_add(a, t)));
        }
        Some(moved)
    }
    fn part(&self, elements: Range<usize>) -> Option<Self> {
        Some(Self { rows: self.rows, from: self.from.part(elements)? })
    }
}

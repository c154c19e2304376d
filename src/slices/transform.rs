use super::sweep::{SliceKernel, motions, sweep};
use crate::batch;
use crate::dispatch::Backend;
use crate::scalar::DualQuat;
use crate::shape::{ShapeError, same_length};
use crate::storage::{self, Element, Number, Register, Source, Tile};
use dq8_simd::{Lanes, Level};

impl Backend {
    /// `moved[i]` = R·`points[i]` + t of one unit motion, which becomes a 3×4 matrix once: nine
    /// multiplications per point.
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

    /// [`transform_points`](Self::transform_points) over the points themselves.
    #[inline]
    pub fn transform_points_in_place<P: Element<3>>(
        self,
        motion: DualQuat<Number<P, 3>>,
        points: &mut [P],
    ) {
        sweep(self, points, ByOne::of(motion, Source::Output));
    }

    /// `turned[i]` = R·`vectors[i]`: directions and differences, which do not translate.
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
        sweep(
            self,
            turned,
            ByOne::of(DualQuat::from_rotation(motion.rotation()), Source::Slice(vectors)),
        );
        Ok(())
    }

    /// [`transform_vectors`](Self::transform_vectors) over the vectors themselves.
    #[inline]
    pub fn transform_vectors_in_place<P: Element<3>>(
        self,
        motion: DualQuat<Number<P, 3>>,
        vectors: &mut [P],
    ) {
        sweep(self, vectors, ByOne::of(DualQuat::from_rotation(motion.rotation()), Source::Output));
    }

    /// `moved[i]` = Rᵢ·`points[i]` + tᵢ of a unit motion each.
    ///
    /// # Errors
    /// If the slices differ in length; `moved` is untouched.
    ///
    /// ```
    /// use dq8::{Backend, DualQuat};
    /// let steps = [1.0_f32, 2.0, 3.0].map(|x| DualQuat::from_translation([x, 0.0, 0.0]));
    /// let mut moved = [[0.0; 3]; 3];
    /// Backend::best().transform_points_each(&steps, &[[10.0, 0.0, 5.0]; 3], &mut moved)?;
    /// assert_eq!(moved[2], [13.0, 0.0, 5.0]);
    /// # Ok::<(), dq8::ShapeError>(())
    /// ```
    #[inline]
    pub fn transform_points_each<M: Element<8>, P: Element<3, Layout = M::Layout>>(
        self,
        motions: &[M],
        points: &[P],
        moved: &mut [P],
    ) -> Result<(), ShapeError> {
        same_length("points", points.len(), motions.len())?;
        same_length("moved", moved.len(), motions.len())?;
        sweep(self, moved, ByEach { motions, from: points, action: Point });
        Ok(())
    }

    /// `turned[i]` = Rᵢ·`vectors[i]` of a unit motion each.
    ///
    /// # Errors
    /// If the slices differ in length; `turned` is untouched.
    #[inline]
    pub fn transform_vectors_each<M: Element<8>, P: Element<3, Layout = M::Layout>>(
        self,
        motions: &[M],
        vectors: &[P],
        turned: &mut [P],
    ) -> Result<(), ShapeError> {
        same_length("vectors", vectors.len(), motions.len())?;
        same_length("turned", turned.len(), motions.len())?;
        sweep(self, turned, ByEach { motions, from: vectors, action: Vector });
        Ok(())
    }
}

/// By the rows of one matrix.
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
    fn reads_output(&self) -> bool {
        self.from.is_output()
    }
    #[inline(always)]
    fn compute<V: Level>(
        &self,
        level: V,
        output: &[P],
        tile: Tile,
    ) -> Option<[Register<P, V, 3>; 3]> {
        let [x, y, z] = vectors(level, self.from.or(output), tile)?;
        let mut moved = [x; 3];
        for (moved, row) in moved.iter_mut().zip(self.rows) {
            // The compiler keeps the twelve lanes in registers from one turn of the loop to the next.
            let [a, b, c, t] = row.map(
                #[inline(always)]
                |number| Register::<P, V, 3>::splat(level, number),
            );
            *moved = z.mul_add(c, y.mul_add(b, x.mul_add(a, t)));
        }
        Some(moved)
    }
}

/// What a motion does to a vector.
trait VectorAction {
    fn act<L: Lanes>(&self, motion: batch::DualQuat<L>, vector: [L; 3]) -> [L; 3];
}

struct Point;
impl VectorAction for Point {
    #[inline(always)]
    fn act<L: Lanes>(&self, motion: batch::DualQuat<L>, point: [L; 3]) -> [L; 3] {
        motion.transform_point(point)
    }
}

struct Vector;
impl VectorAction for Vector {
    #[inline(always)]
    fn act<L: Lanes>(&self, motion: batch::DualQuat<L>, vector: [L; 3]) -> [L; 3] {
        motion.transform_vector(vector)
    }
}

struct ByEach<'s, M, P, A> {
    motions: &'s [M],
    from: &'s [P],
    action: A,
}

impl<M, P, A> SliceKernel<P, 3> for ByEach<'_, M, P, A>
where
    M: Element<8>,
    P: Element<3, Layout = M::Layout>,
    A: VectorAction,
{
    #[inline(always)]
    fn compute<V: Level>(&self, level: V, _: &[P], tile: Tile) -> Option<[Register<P, V, 3>; 3]> {
        Some(self.action.act(motions(level, self.motions, tile)?, vectors(level, self.from, tile)?))
    }
}

/// The vectors of a tile; zero in lanes beyond the end of `slice`.
#[inline(always)]
fn vectors<E: Element<3>, V: Level>(
    level: V,
    slice: &[E],
    tile: Tile,
) -> Option<[Register<E, V, 3>; 3]> {
    E::load(level, slice, tile, &storage::identity())
}

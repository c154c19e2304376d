use super::sweep::{Operation, motions, same_length, sweep, vectors};
use crate::batch;
use crate::dispatch::Backend;
use crate::error::ShapeError;
use crate::place::{Number, Place, Register, Step};
use crate::scalar::DualQuat;
use dq8_simd::{Lanes, Level};

impl Backend {
    /// `moved[i]` = R·`points[i]` + t of one unit motion, which becomes a 3×4 matrix once: nine
    /// multiplications a point.
    ///
    /// # Errors
    /// If the slices differ in length; `moved` is untouched.
    #[inline]
    pub fn transform_points<P: Place<3>>(
        self,
        motion: DualQuat<Number<P, 3>>,
        points: &[P],
        moved: &mut [P],
    ) -> Result<(), ShapeError> {
        same_length("moved", moved.len(), points.len())?;
        sweep(self, moved, ByOne::of(motion, Some(points)));
        Ok(())
    }

    /// [`transform_points`](Self::transform_points) over the points themselves.
    #[inline]
    pub fn transform_points_in_place<P: Place<3>>(
        self,
        motion: DualQuat<Number<P, 3>>,
        points: &mut [P],
    ) {
        sweep(self, points, ByOne::of(motion, None));
    }

    /// `turned[i]` = R·`vectors[i]`: directions and differences, which do not translate.
    ///
    /// # Errors
    /// If the slices differ in length; `turned` is untouched.
    #[inline]
    pub fn transform_vectors<P: Place<3>>(
        self,
        motion: DualQuat<Number<P, 3>>,
        vectors: &[P],
        turned: &mut [P],
    ) -> Result<(), ShapeError> {
        same_length("turned", turned.len(), vectors.len())?;
        sweep(self, turned, ByOne::of(DualQuat::from_rotation(motion.rotation()), Some(vectors)));
        Ok(())
    }

    /// [`transform_vectors`](Self::transform_vectors) over the vectors themselves.
    #[inline]
    pub fn transform_vectors_in_place<P: Place<3>>(
        self,
        motion: DualQuat<Number<P, 3>>,
        vectors: &mut [P],
    ) {
        sweep(self, vectors, ByOne::of(DualQuat::from_rotation(motion.rotation()), None));
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
    pub fn transform_points_each<M: Place<8>, P: Place<3, Layout = M::Layout>>(
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
    pub fn transform_vectors_each<M: Place<8>, P: Place<3, Layout = M::Layout>>(
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

/// By the rows of one matrix; without `from`, over what the output holds.
struct ByOne<'s, P: Place<3>> {
    rows: [[Number<P, 3>; 4]; 3],
    from: Option<&'s [P]>,
}

impl<'s, P: Place<3>> ByOne<'s, P> {
    #[inline]
    fn of(motion: DualQuat<Number<P, 3>>, from: Option<&'s [P]>) -> Self {
        Self { rows: motion.to_matrix3x4(), from }
    }
}

impl<P: Place<3>> Operation<P, 3> for ByOne<'_, P> {
    fn reads_output(&self) -> bool {
        self.from.is_none()
    }
    #[inline(always)]
    fn compute<V: Level>(
        &self,
        level: V,
        output: &[P],
        step: Step,
    ) -> Option<[Register<P, V, 3>; 3]> {
        let [x, y, z] = vectors(level, self.from.unwrap_or(output), step)?;
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
trait Action {
    fn act<L: Lanes>(&self, motion: batch::DualQuat<L>, vector: [L; 3]) -> [L; 3];
}

struct Point;
impl Action for Point {
    #[inline(always)]
    fn act<L: Lanes>(&self, motion: batch::DualQuat<L>, point: [L; 3]) -> [L; 3] {
        motion.transform_point(point)
    }
}

struct Vector;
impl Action for Vector {
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

impl<M, P, A> Operation<P, 3> for ByEach<'_, M, P, A>
where
    M: Place<8>,
    P: Place<3, Layout = M::Layout>,
    A: Action,
{
    #[inline(always)]
    fn compute<V: Level>(&self, level: V, _: &[P], step: Step) -> Option<[Register<P, V, 3>; 3]> {
        Some(self.action.act(motions(level, self.motions, step)?, vectors(level, self.from, step)?))
    }
}

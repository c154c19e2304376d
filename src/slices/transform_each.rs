use super::map::{OfPairs, operations};
use super::sweep::sweep;
use crate::backend::Backend;
use crate::batch::DualQuat;
use crate::geometry::{Line, Plane, Twist};
use crate::storage::Element;
use crate::storage::shape::{ShapeError, same_length};

impl Backend {
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
        sweep(self, moved, OfPairs { a: motions, b: points, operation: OnPoint });
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
        sweep(self, turned, OfPairs { a: motions, b: vectors, operation: OnVector });
        Ok(())
    }

    /// `moved[i]` = Rᵢl + ε(Rᵢm + tᵢ × Rᵢl) of a unit motion each. A line is six numbers,
    /// direction and moment; see [`Line`](crate::Line).
    ///
    /// # Errors
    /// If the slices differ in length; `moved` is untouched.
    ///
    /// ```
    /// use dq8::{Backend, DualQuat};
    /// // The axis x, carried up by 2: its moment is (0, 0, 2) × x.
    /// let up = [DualQuat::from_translation([0.0_f32, 0.0, 2.0])];
    /// let mut moved = [[0.0; 6]];
    /// Backend::best().transform_lines_each(&up, &[[1.0, 0.0, 0.0, 0.0, 0.0, 0.0]], &mut moved)?;
    /// assert_eq!(moved[0], [1.0, 0.0, 0.0, 0.0, 2.0, 0.0]);
    /// # Ok::<(), dq8::ShapeError>(())
    /// ```
    #[inline]
    pub fn transform_lines_each<M: Element<8>, P: Element<6, Layout = M::Layout>>(
        self,
        motions: &[M],
        lines: &[P],
        moved: &mut [P],
    ) -> Result<(), ShapeError> {
        same_length("lines", lines.len(), motions.len())?;
        same_length("moved", moved.len(), motions.len())?;
        sweep(self, moved, OfPairs { a: motions, b: lines, operation: OnLine });
        Ok(())
    }

    /// `moved[i]` = the plane n′ = Rᵢn, d′ = d + n′·tᵢ of a unit motion each. A plane is
    /// four numbers, normal and offset; see [`Plane`](crate::Plane).
    ///
    /// # Errors
    /// If the slices differ in length; `moved` is untouched.
    #[inline]
    pub fn transform_planes_each<M: Element<8>, P: Element<4, Layout = M::Layout>>(
        self,
        motions: &[M],
        planes: &[P],
        moved: &mut [P],
    ) -> Result<(), ShapeError> {
        same_length("planes", planes.len(), motions.len())?;
        same_length("moved", moved.len(), motions.len())?;
        sweep(self, moved, OfPairs { a: motions, b: planes, operation: OnPlane });
        Ok(())
    }

    /// `moved[i]` = ω′ = Rᵢω, v′ = Rᵢv + tᵢ × ω′, the adjoint of a unit motion
    /// each: a body twist of σᵢ becomes the spatial one.
    ///
    /// # Errors
    /// If the slices differ in length; `moved` is untouched.
    #[inline]
    pub fn transform_twists_each<M: Element<8>, P: Element<6, Layout = M::Layout>>(
        self,
        motions: &[M],
        twists: &[P],
        moved: &mut [P],
    ) -> Result<(), ShapeError> {
        same_length("twists", twists.len(), motions.len())?;
        same_length("moved", moved.len(), motions.len())?;
        sweep(self, moved, OfPairs { a: motions, b: twists, operation: OnTwist });
        Ok(())
    }
}

operations! {
    OnPoint(motion: 8, point: 3) -> 3 = DualQuat::from_array(motion).transform_point(point);
    OnVector(motion: 8, vector: 3) -> 3 = DualQuat::from_array(motion).transform_vector(vector);
    OnLine(motion: 8, line: 6) -> 6 = {
        let [a, b, c, d, e, f] = line;
        let line = Line { direction: [a, b, c], moment: [d, e, f] };
        let line = DualQuat::from_array(motion).transform_line(line);
        let ([a, b, c], [d, e, f]) = (line.direction, line.moment);
        [a, b, c, d, e, f]
    };
    OnPlane(motion: 8, plane: 4) -> 4 = {
        let [a, b, c, offset] = plane;
        let plane = DualQuat::from_array(motion).transform_plane(Plane { normal: [a, b, c], offset });
        let [a, b, c] = plane.normal;
        [a, b, c, plane.offset]
    };
    OnTwist(motion: 8, twist: 6) -> 6 =
        DualQuat::from_array(motion).adjoint(Twist::from_array(twist)).to_array();
}

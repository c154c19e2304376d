use super::sweep::{SliceKernel, motions, part, sweep};
use crate::backend::Backend;
use crate::batch;
use crate::geometry::{Line, Plane, Twist};
use crate::storage::shape::{ShapeError, same_length};
use crate::storage::{self, Element, Register, Tile};
use core::ops::Range;
use dq8_simd::{Lanes, Level};

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
        sweep(self, moved, ByEach { motions, from: points, action: OnPoint });
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
        sweep(self, turned, ByEach { motions, from: vectors, action: OnVector });
        Ok(())
    }

    /// `moved[i]` = Rᵢl + ε(Rᵢm + tᵢ × Rᵢl) of a unit motion each. A line is six numbers, direction and
    /// moment; see [`Line`](crate::Line).
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
        sweep(self, moved, ByEach { motions, from: lines, action: OnLine });
        Ok(())
    }

    /// `moved[i]` = the plane n′ = Rᵢn, d′ = d + n′·tᵢ of a unit motion each. A plane is four numbers,
    /// normal and offset; see [`Plane`](crate::Plane).
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
        sweep(self, moved, ByEach { motions, from: planes, action: OnPlane });
        Ok(())
    }

    /// `moved[i]` = ω′ = Rᵢω, v′ = Rᵢv + tᵢ × ω′, the adjoint of a unit motion each: a body twist of σᵢ
    /// becomes the spatial one.
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
        sweep(self, moved, ByEach { motions, from: twists, action: OnTwist });
        Ok(())
    }
}

/// The action of a motion on a thing of `C` numbers.
trait Action<const C: usize>: Copy + Sync {
    fn act<L: Lanes>(&self, motion: batch::DualQuat<L>, thing: [L; C]) -> [L; C];
}

#[derive(Clone, Copy)]
struct OnPoint;
impl Action<3> for OnPoint {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn act<L: Lanes>(&self, motion: batch::DualQuat<L>, point: [L; 3]) -> [L; 3] {
        motion.transform_point(point)
    }
}

#[derive(Clone, Copy)]
struct OnVector;
impl Action<3> for OnVector {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn act<L: Lanes>(&self, motion: batch::DualQuat<L>, vector: [L; 3]) -> [L; 3] {
        motion.transform_vector(vector)
    }
}

#[derive(Clone, Copy)]
struct OnLine;
impl Action<6> for OnLine {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn act<L: Lanes>(&self, motion: batch::DualQuat<L>, [a, b, c, d, e, f]: [L; 6]) -> [L; 6] {
        let line = motion.transform_line(Line { direction: [a, b, c], moment: [d, e, f] });
        let ([a, b, c], [d, e, f]) = (line.direction, line.moment);
        [a, b, c, d, e, f]
    }
}

#[derive(Clone, Copy)]
struct OnPlane;
impl Action<4> for OnPlane {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn act<L: Lanes>(&self, motion: batch::DualQuat<L>, [a, b, c, offset]: [L; 4]) -> [L; 4] {
        let plane = motion.transform_plane(Plane { normal: [a, b, c], offset });
        let [a, b, c] = plane.normal;
        [a, b, c, plane.offset]
    }
}

#[derive(Clone, Copy)]
struct OnTwist;
impl Action<6> for OnTwist {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn act<L: Lanes>(&self, motion: batch::DualQuat<L>, twist: [L; 6]) -> [L; 6] {
        motion.adjoint(Twist::from_array(twist)).to_array()
    }
}

struct ByEach<'s, M, P, A> {
    motions: &'s [M],
    from: &'s [P],
    action: A,
}

impl<M, P, A, const C: usize> SliceKernel<P, C> for ByEach<'_, M, P, A>
where
    M: Element<8>,
    P: Element<C, Layout = M::Layout>,
    A: Action<C>,
{
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn compute<V: Level>(&self, level: V, _: &[P], tile: Tile) -> Option<[Register<P, V, C>; C]> {
        let thing = P::load(level, self.from, tile, &storage::identity())?;
        Some(self.action.act(motions(level, self.motions, tile)?, thing))
    }
    fn part(&self, elements: Range<usize>) -> Self {
        let motions = part(self.motions, elements.clone());
        Self { motions, from: part(self.from, elements), action: self.action }
    }
}

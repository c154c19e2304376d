use super::skin::Scratch;
use super::skin::Skin;
use super::skin::Weight;
use crate::number::Scalar;
use crate::storage::shape::ShapeError;
use dq8_simd::internal::Index;
use dq8_simd::{Lanes, Level};

/// A way to blend the motions of joints, with a vertex in each lane: the weighted sum of the
/// palette entries of a vertex's joints, and the map by which the complete sum moves a surface. `R`
/// is the element type. The trait is sealed, because only this crate can name the types that its
/// methods take.
pub trait Blender<R: Scalar>: Copy + Send + Sync {
    /// The type of the weighted sum: matrices, or dual quaternions.
    #[doc(hidden)]
    type Sum<L: Lanes<Real = R>>;
    /// The map of points, normals and tangents that the complete sum gives.
    #[doc(hidden)]
    type Map<L: Lanes<Real = R>>: SurfaceMap<L>;

    /// `true` if most instructions of the blend are shuffles: see
    /// [`Kernel::SHUFFLES`](crate::Kernel::SHUFFLES).
    #[doc(hidden)]
    const SHUFFLES: bool;

    /// Checks that each palette has `joints` entries, and that each slice with a value per vertex
    /// has `vertices` entries.
    ///
    /// # Errors
    /// If a slice has another length.
    #[doc(hidden)]
    fn check(&self, joints: usize, vertices: usize) -> Result<(), ShapeError>;
    /// Returns the weighted sum of the group of influences that `scratch` holds. Returns `None` for
    /// an index out of range, which the checks before the loop rule out.
    #[doc(hidden)]
    fn sum<L: Lanes<Real = R>, J: Index>(
        &self,
        level: L::Level,
        scratch: &mut Scratch<'_, R, J>,
    ) -> Option<Self::Sum<L>>;
    /// Poses plain points one after the other, which is quicker for some blends than a vertex in
    /// each lane. Returns the number of points that are posed, or `None` if the blend has no such
    /// method.
    #[doc(hidden)]
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn points<V: Level, J: Index, W: Weight>(
        &self,
        level: V,
        skin: &Skin<'_, J, W>,
        points: PlainPoints<'_, R>,
    ) -> Option<usize> {
        let _ = (level, skin, points);
        None
    }
    /// Adds the sums of two groups of influences.
    #[doc(hidden)]
    fn join<L: Lanes<Real = R>>(&self, a: Self::Sum<L>, b: Self::Sum<L>) -> Self::Sum<L>;
    /// Returns the maps of the vertices from index `first` on, one in each lane.
    #[doc(hidden)]
    fn map<L: Lanes<Real = R>>(
        &self,
        level: L::Level,
        sum: Self::Sum<L>,
        first: usize,
    ) -> Self::Map<L>;
}

/// The points of consecutive vertices, at rest and posed. The first vertex has the index `first`,
/// and both slices have the same length.
#[derive(Debug)]
pub struct PlainPoints<'m, R> {
    pub(super) first: usize,
    pub(super) rest: &'m [[R; 3]],
    pub(super) posed: &'m mut [[R; 3]],
}

/// The map by which a blend moves a surface.
pub trait SurfaceMap<L>: Copy {
    /// Moves a point.
    fn point(&self, point: [L; 3]) -> [L; 3];
    /// Moves a normal, and scales the result to length 1.
    fn normal(&self, normal: [L; 3]) -> [L; 3];
    /// Moves a tangent, and scales the result to length 1.
    fn tangent(&self, tangent: [L; 3]) -> [L; 3];
}

use super::skin::Scratch;
use super::skin::Skin;
use super::skin::Weight;
use crate::number::Scalar;
use crate::storage::shape::ShapeError;
use dq8_simd::internal::Index;
use dq8_simd::{Lanes, Level};

/// A way to blend the motions of joints, on lanes that are vertices: a sum over groups of
/// influences, and what the sum does to a surface. Sealed: only this crate can name what its
/// methods take.
pub trait Blender<R: Scalar>: Copy + Send + Sync {
    /// The thing that is summed.
    #[doc(hidden)]
    type Sum<L: Lanes<Real = R>>;
    /// The map that the sum is.
    #[doc(hidden)]
    type Map<L: Lanes<Real = R>>: SurfaceMap<L>;

    /// `true` if most of it are shuffles, see [`Kernel::SHUFFLES`](crate::Kernel::SHUFFLES).
    #[doc(hidden)]
    const SHUFFLES: bool;

    /// Checks that palettes have `joints` entries, and what is per vertex fits `vertices`.
    ///
    /// # Errors
    /// If not.
    #[doc(hidden)]
    fn check(&self, joints: usize, vertices: usize) -> Result<(), ShapeError>;
    /// The sum of a group of influences. `None` where an index is out of range, which has been
    /// checked.
    #[doc(hidden)]
    fn sum<L: Lanes<Real = R>, J: Index>(
        &self,
        level: L::Level,
        scratch: &mut Scratch<'_, R, J>,
    ) -> Option<Self::Sum<L>>;
    /// Poses plain points, where that is quicker than on lanes, and says how many; `None` if none.
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
    /// The sum of two groups.
    #[doc(hidden)]
    fn join<L: Lanes<Real = R>>(&self, a: Self::Sum<L>, b: Self::Sum<L>) -> Self::Sum<L>;
    /// The map of the vertices from `first` on.
    #[doc(hidden)]
    fn map<L: Lanes<Real = R>>(
        &self,
        level: L::Level,
        sum: Self::Sum<L>,
        first: usize,
    ) -> Self::Map<L>;
}

/// Points that lie one after the other, from vertex `first` on: as many posed as at rest.
#[derive(Debug)]
pub struct PlainPoints<'m, R> {
    pub(super) first: usize,
    pub(super) rest: &'m [[R; 3]],
    pub(super) posed: &'m mut [[R; 3]],
}

/// A blend, as it acts on a surface.
pub trait SurfaceMap<L>: Copy {
    /// A point of it.
    fn point(&self, point: [L; 3]) -> [L; 3];
    /// A normal, of length 1 again.
    fn normal(&self, normal: [L; 3]) -> [L; 3];
    /// A tangent, of length 1 again.
    fn tangent(&self, tangent: [L; 3]) -> [L; 3];
}

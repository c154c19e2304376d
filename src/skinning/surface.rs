use crate::storage::shape::{ShapeError, same_length};

/// What there is for each vertex of a mesh, a slice each: written as [`Surface`], at rest, or
/// [`SurfaceMut`], posed, which say what slices they are.
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct Vertices<S> {
    /// The positions of the vertices.
    pub positions: S,
    /// Their normals, of length 1.
    pub normals: Option<S>,
    /// Their tangents, of length 1, without the sign of the bitangent.
    pub tangents: Option<S>,
}

/// A mesh at rest.
pub type Surface<'s, P> = Vertices<&'s [P]>;

/// The memory that a posed mesh goes to. It has normals and tangents if the mesh at rest has.
pub type SurfaceMut<'s, P> = Vertices<&'s mut [P]>;

impl<S> Vertices<S> {
    /// Nothing but positions.
    pub fn positions(positions: S) -> Self {
        Self { positions, normals: None, tangents: None }
    }
    /// And normals.
    pub fn normals(self, normals: S) -> Self {
        Self { normals: Some(normals), ..self }
    }
    /// And tangents.
    pub fn tangents(self, tangents: S) -> Self {
        Self { tangents: Some(tangents), ..self }
    }

    /// Pieces for several threads: those before element `at`, and the others.
    #[cfg(feature = "rayon")]
    pub(super) fn split(self, at: usize, cut: impl Fn(S, usize) -> (S, S)) -> (Self, Self) {
        let (positions, others) = cut(self.positions, at);
        let normals = self.normals.map(|slice| cut(slice, at)).unzip();
        let tangents = self.tangents.map(|slice| cut(slice, at)).unzip();
        (
            Self { positions, normals: normals.0, tangents: tangents.0 },
            Self { positions: others, normals: normals.1, tangents: tangents.1 },
        )
    }
}

impl<P> Surface<'_, P> {
    pub(super) fn check(&self, length: usize) -> Result<(), ShapeError> {
        same_length("positions", self.positions.len(), length)?;
        same_length("normals", self.normals.map_or(length, <[P]>::len), length)?;
        same_length("tangents", self.tangents.map_or(length, <[P]>::len), length)
    }
}

impl<P> SurfaceMut<'_, P> {
    pub(super) fn check(&self, rest: &Surface<'_, P>) -> Result<(), ShapeError> {
        let length = |slice: Option<&[P]>| slice.map_or(0, <[P]>::len);
        same_length("posed positions", self.positions.len(), rest.positions.len())?;
        same_length("posed normals", length(self.normals.as_deref()), length(rest.normals))?;
        same_length("posed tangents", length(self.tangents.as_deref()), length(rest.tangents))
    }
}

use crate::shape::{ShapeError, same_length};

/// A mesh at rest: what there is for each vertex. Normals and tangents of length 1.
#[derive(Clone, Copy, Debug)]
pub struct Surface<'s, P> {
    /// Where the vertices are.
    pub positions: &'s [P],
    /// Their normals.
    pub normals: Option<&'s [P]>,
    /// Their tangents, without the sign of the bitangent.
    pub tangents: Option<&'s [P]>,
}

impl<'s, P> Surface<'s, P> {
    /// Nothing but positions.
    #[must_use]
    pub fn positions(positions: &'s [P]) -> Self {
        Self { positions, normals: None, tangents: None }
    }
    /// And normals.
    #[must_use]
    pub fn normals(self, normals: &'s [P]) -> Self {
        Self { normals: Some(normals), ..self }
    }
    /// And tangents.
    #[must_use]
    pub fn tangents(self, tangents: &'s [P]) -> Self {
        Self { tangents: Some(tangents), ..self }
    }

    pub(super) fn check(&self, length: usize) -> Result<(), ShapeError> {
        same_length("positions", self.positions.len(), length)?;
        same_length("normals", self.normals.map_or(length, <[P]>::len), length)?;
        same_length("tangents", self.tangents.map_or(length, <[P]>::len), length)
    }
}

/// Where a posed mesh goes. It has normals and tangents if the mesh at rest has.
#[derive(Debug)]
pub struct SurfaceMut<'s, P> {
    /// Where the vertices are.
    pub positions: &'s mut [P],
    /// Their normals.
    pub normals: Option<&'s mut [P]>,
    /// Their tangents.
    pub tangents: Option<&'s mut [P]>,
}

impl<'s, P> SurfaceMut<'s, P> {
    /// Nothing but positions.
    #[must_use]
    pub fn positions(positions: &'s mut [P]) -> Self {
        Self { positions, normals: None, tangents: None }
    }
    /// And normals.
    #[must_use]
    pub fn normals(self, normals: &'s mut [P]) -> Self {
        Self { normals: Some(normals), ..self }
    }
    /// And tangents.
    #[must_use]
    pub fn tangents(self, tangents: &'s mut [P]) -> Self {
        Self { tangents: Some(tangents), ..self }
    }

    pub(super) fn check(&self, rest: &Surface<'_, P>) -> Result<(), ShapeError> {
        let length = |slice: Option<&[P]>| slice.map_or(0, <[P]>::len);
        same_length("posed positions", self.positions.len(), rest.positions.len())?;
        same_length("posed normals", length(self.normals.as_deref()), length(rest.normals))?;
        same_length("posed tangents", length(self.tangents.as_deref()), length(rest.tangents))
    }
}

/// Pieces of both for the tasks of [`parallel`](super::parallel).
#[cfg(feature = "rayon")]
impl<'s, P> Surface<'s, P> {
    pub(super) fn chunks(self, size: usize) -> impl Iterator<Item = Self> {
        self.positions.chunks(size).enumerate().map(move |(task, positions)| {
            let piece = |slice: &'s [P]| &slice[task * size..task * size + positions.len()];
            Self { positions, normals: self.normals.map(piece), tangents: self.tangents.map(piece) }
        })
    }
}

#[cfg(feature = "rayon")]
impl<'s, P> SurfaceMut<'s, P> {
    pub(super) fn chunks(self, size: usize) -> impl Iterator<Item = Self> {
        let mut normals = self.normals.map(|slice| slice.chunks_mut(size));
        let mut tangents = self.tangents.map(|slice| slice.chunks_mut(size));
        self.positions.chunks_mut(size).map(move |positions| Self {
            positions,
            normals: normals.as_mut().and_then(Iterator::next),
            tangents: tangents.as_mut().and_then(Iterator::next),
        })
    }
}

use crate::storage::shape::{ShapeError, same_length};

/// A mesh at rest: what there is for each vertex. Normals and tangents of length 1.
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct Surface<'s, P> {
    /// The positions of the vertices.
    pub positions: &'s [P],
    /// Their normals.
    pub normals: Option<&'s [P]>,
    /// Their tangents, without the sign of the bitangent.
    pub tangents: Option<&'s [P]>,
}

impl<'s, P> Surface<'s, P> {
    /// Nothing but positions.
    pub fn positions(positions: &'s [P]) -> Self {
        Self { positions, normals: None, tangents: None }
    }
    /// And normals.
    pub fn normals(self, normals: &'s [P]) -> Self {
        Self { normals: Some(normals), ..self }
    }
    /// And tangents.
    pub fn tangents(self, tangents: &'s [P]) -> Self {
        Self { tangents: Some(tangents), ..self }
    }

    pub(super) fn check(&self, length: usize) -> Result<(), ShapeError> {
        same_length("positions", self.positions.len(), length)?;
        same_length("normals", self.normals.map_or(length, <[P]>::len), length)?;
        same_length("tangents", self.tangents.map_or(length, <[P]>::len), length)
    }
}

/// The memory that a posed mesh goes to. It has normals and tangents if the mesh at rest has.
#[derive(Debug)]
#[must_use]
pub struct SurfaceMut<'s, P> {
    /// The positions of the vertices.
    pub positions: &'s mut [P],
    /// Their normals.
    pub normals: Option<&'s mut [P]>,
    /// Their tangents.
    pub tangents: Option<&'s mut [P]>,
}

impl<'s, P> SurfaceMut<'s, P> {
    /// Nothing but positions.
    pub fn positions(positions: &'s mut [P]) -> Self {
        Self { positions, normals: None, tangents: None }
    }
    /// And normals.
    pub fn normals(self, normals: &'s mut [P]) -> Self {
        Self { normals: Some(normals), ..self }
    }
    /// And tangents.
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

/// Pieces for several threads.
#[cfg(feature = "rayon")]
impl<P> Surface<'_, P> {
    /// Those before element `at`, and the others.
    pub(super) fn split(self, at: usize) -> (Self, Self) {
        let (positions, others) = self.positions.split_at(at);
        let normals = self.normals.map(|slice| slice.split_at(at)).unzip();
        let tangents = self.tangents.map(|slice| slice.split_at(at)).unzip();
        (
            Self { positions, normals: normals.0, tangents: tangents.0 },
            Self { positions: others, normals: normals.1, tangents: tangents.1 },
        )
    }
}

#[cfg(feature = "rayon")]
impl<P> SurfaceMut<'_, P> {
    /// Those before element `at`, and the others.
    pub(super) fn split(self, at: usize) -> (Self, Self) {
        let (positions, others) = self.positions.split_at_mut(at);
        let normals = self.normals.map(|slice| slice.split_at_mut(at)).unzip();
        let tangents = self.tangents.map(|slice| slice.split_at_mut(at)).unzip();
        (
            Self { positions, normals: normals.0, tangents: tangents.0 },
            Self { positions: others, normals: normals.1, tangents: tangents.1 },
        )
    }
}

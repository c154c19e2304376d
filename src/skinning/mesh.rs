//! Meshes at rest and posed. A mesh has a slice for each field, or its vertices are records of
//! several fields.

use super::SkinningError;
use super::blender::PlainPoints;
use crate::backend::Outputs;
use crate::number::Scalar;
use crate::storage::shape::same_length;
use crate::storage::{self, Element, Layout, Number, Register, Tile};
use dq8_simd::{Float, Lanes, Level, MAX_LANES, Records};

/// The slices of a mesh, one for each field of its vertices. `S` is the type of a slice, which is
/// shared in [`Surface`] and mutable in [`SurfaceMut`].
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct Vertices<S> {
    /// The positions of the vertices.
    pub positions: S,
    /// The normals of the vertices, of length 1, if the mesh has them.
    pub normals: Option<S>,
    /// The tangents of the vertices, of length 1 and without the sign of the bitangent, if the mesh
    /// has them.
    pub tangents: Option<S>,
}

/// A mesh at rest: a slice of positions and, if the mesh has them, slices of normals and tangents.
/// `positions` makes a mesh with positions alone, and `normals` and `tangents` add a slice to it.
///
/// ```
/// use dq8::skinning::Surface;
/// let (positions, normals) = ([[1.0_f32, 2.0, 3.0]], [[0.0, 0.0, 1.0]]);
/// let rest = Surface::positions(&positions).normals(&normals);
/// assert_eq!((rest.normals, rest.tangents), (Some(&normals[..]), None));
/// ```
pub type Surface<'s, P> = Vertices<&'s [P]>;

/// The memory to which a posed mesh is written, made like a [`Surface`]. It has normals and
/// tangents if the mesh at rest has them.
pub type SurfaceMut<'s, P> = Vertices<&'s mut [P]>;

impl<S> Vertices<S> {
    /// Makes a mesh with positions alone.
    pub fn positions(positions: S) -> Self {
        Self { positions, normals: None, tangents: None }
    }
    /// Adds normals to the mesh.
    pub fn normals(self, normals: S) -> Self {
        Self { normals: Some(normals), ..self }
    }
    /// Adds tangents to the mesh.
    pub fn tangents(self, tangents: S) -> Self {
        Self { tangents: Some(tangents), ..self }
    }

    /// Splits each slice before element `at` by `cut`, so that two threads can pose one part each.
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

/// A mesh at rest and posed.
pub(super) trait Mesh: Outputs {
    /// The element type of the points. The loop runs over the tiles of this type.
    type Point: Element<3>;
    /// Checks that the meshes at rest and posed have `vertices` vertices and the same fields.
    fn check(&self, vertices: usize) -> Result<(), SkinningError>;
    /// The number of elements of type [`Point`](Self::Point).
    fn elements(&self) -> usize;
    /// Reads the vectors of a tile of the mesh at rest, with zero in lanes beyond the end. Returns
    /// `None` if the whole tile is beyond the end.
    fn load<V: Level>(&self, level: V, field: Field, tile: Tile)
    -> Option<Vectors<Self::Point, V>>;
    /// Returns the positions if they are plain records and the mesh has no other field to pose,
    /// otherwise `None`. `first` is the index in the skin of the mesh's first vertex.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn points(&mut self, first: usize) -> Option<PlainPoints<'_, Number<Self::Point, 3>>> {
        let _ = first;
        None
    }
    /// Writes the posed vectors of a tile.
    fn store<V: Level>(&mut self, vectors: Vectors<Self::Point, V>, field: Field, tile: Tile);
}

/// A register for each component of a vector.
pub(super) type Vectors<P, V> = [Register<P, V, 3>; 3];

/// The fields that a vertex may have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Field {
    Position,
    Normal,
    Tangent,
}

/// A mesh with a slice for each field, at rest and posed.
pub(super) struct Separate<'s, P> {
    pub(super) rest: Surface<'s, P>,
    pub(super) posed: SurfaceMut<'s, P>,
}

#[cfg(feature = "rayon")]
impl<P: Element<3>> Outputs for Separate<'_, P> {
    fn things(&self) -> usize {
        self.posed.positions.len() * P::Layout::THINGS
    }
    fn split(self, at: usize) -> (Self, Self) {
        let at = (at / P::Layout::THINGS).min(self.posed.positions.len());
        let (rest, others) = self.rest.split(at, <[P]>::split_at);
        let (posed, to_others) = self.posed.split(at, <[P]>::split_at_mut);
        (Self { rest, posed }, Self { rest: others, posed: to_others })
    }
}

impl<P: Element<3>> Mesh for Separate<'_, P> {
    type Point = P;

    fn check(&self, vertices: usize) -> Result<(), SkinningError> {
        let Self { rest, posed } = self;
        let elements = vertices.div_ceil(P::Layout::THINGS);
        same_length("positions", rest.positions.len(), elements)?;
        same_length("normals", rest.normals.map_or(elements, <[P]>::len), elements)?;
        same_length("tangents", rest.tangents.map_or(elements, <[P]>::len), elements)?;
        let length = |slice: Option<&[P]>| slice.map_or(0, <[P]>::len);
        same_length("posed positions", posed.positions.len(), elements)?;
        same_length("posed normals", length(posed.normals.as_deref()), length(rest.normals))?;
        same_length("posed tangents", length(posed.tangents.as_deref()), length(rest.tangents))?;
        Ok(())
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn elements(&self) -> usize {
        self.posed.positions.len()
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load<V: Level>(&self, level: V, field: Field, tile: Tile) -> Option<Vectors<P, V>> {
        let from = match field {
            Field::Position => self.rest.positions,
            Field::Normal => self.rest.normals?,
            Field::Tangent => self.rest.tangents?,
        };
        P::load(level, from, tile, &storage::identity())
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn points(&mut self, first: usize) -> Option<PlainPoints<'_, Number<P, 3>>> {
        if self.rest.normals.is_some() || self.rest.tangents.is_some() {
            return None;
        }
        let (rest, posed) = (P::plain(self.rest.positions)?, P::plain_mut(self.posed.positions)?);
        Some(PlainPoints { first, rest, posed })
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn store<V: Level>(&mut self, vectors: Vectors<P, V>, field: Field, tile: Tile) {
        let to = match field {
            Field::Position => Some(&mut *self.posed.positions),
            Field::Normal => self.posed.normals.as_deref_mut(),
            Field::Tangent => self.posed.tangents.as_deref_mut(),
        };
        if let Some(to) = to {
            P::store(vectors, to, tile);
        }
    }
}

/// The offsets of a vertex's fields in a buffer of elements of type `R`, which holds one vertex
/// after the other. All offsets count elements, and each field has three components.
///
/// ```
/// use dq8::skinning::VertexFields;
/// // Position, normal, tangent with its sign, texture coordinates: 12 numbers.
/// let fields = VertexFields { stride: 12, position: 0, normal: Some(3), tangent: Some(6) };
/// assert_eq!(VertexFields::positions(12), VertexFields { normal: None, tangent: None, ..fields });
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct VertexFields {
    /// The distance from the beginning of a vertex to the beginning of the next.
    pub stride: usize,
    /// The offset of the position in a vertex.
    pub position: usize,
    /// The offset of the normal in a vertex, if it has one.
    pub normal: Option<usize>,
    /// The offset of the tangent in a vertex, if it has one. The sign of the bitangent is not a
    /// part of it.
    pub tangent: Option<usize>,
}

impl VertexFields {
    /// Returns the fields of vertices that begin with their positions. No other field is posed.
    #[must_use]
    pub fn positions(stride: usize) -> Self {
        Self { stride, position: 0, normal: None, tangent: None }
    }

    fn at(&self, field: Field) -> Option<usize> {
        match field {
            Field::Position => Some(self.position),
            Field::Normal => self.normal,
            Field::Tangent => self.tangent,
        }
    }

    /// Checks that all fields lie within a vertex and do not overlap, and that a buffer of
    /// `numbers` elements holds exactly `vertices` vertices.
    fn check(
        &self,
        what: &'static str,
        numbers: usize,
        vertices: usize,
    ) -> Result<(), SkinningError> {
        let fields = [Field::Position, Field::Normal, Field::Tangent];
        for (index, field) in fields.into_iter().enumerate() {
            let Some(first) = self.at(field) else { continue };
            let mut before = fields.iter().take(index).filter_map(|&field| self.at(field));
            // The condition is not written as `first + 3 > stride`, because the sum may wrap.
            let outside = self.stride < 3 || first > self.stride - 3;
            if outside || before.any(|other| first.abs_diff(other) < 3) {
                return Err(SkinningError::Field { what, first, stride: self.stride });
            }
        }
        Ok(same_length(what, numbers, vertices.saturating_mul(self.stride))?)
    }
}

/// A mesh as two buffers of vertices, one at rest and one posed.
pub(super) struct Interleaved<'s, R> {
    pub(super) rest: &'s [R],
    pub(super) from: VertexFields,
    pub(super) posed: &'s mut [R],
    pub(super) to: VertexFields,
}

#[cfg(feature = "rayon")]
impl<R: Scalar> Outputs for Interleaved<'_, R> {
    fn things(&self) -> usize {
        self.posed.len() / self.to.stride.max(1)
    }
    fn split(self, at: usize) -> (Self, Self) {
        let (rest, others) = self.rest.split_at((at * self.from.stride).min(self.rest.len()));
        let (posed, to_others) =
            self.posed.split_at_mut((at * self.to.stride).min(self.posed.len()));
        (Self { rest, posed, ..self }, Self { rest: others, posed: to_others, ..self })
    }
}

impl<R: Scalar> Mesh for Interleaved<'_, R> {
    type Point = [R; 3];

    fn check(&self, vertices: usize) -> Result<(), SkinningError> {
        self.from.check("rest", self.rest.len(), vertices)?;
        self.to.check("posed", self.posed.len(), vertices)?;
        let count = |field: Option<usize>| field.map_or(0, |_| vertices);
        same_length("posed normals", count(self.to.normal), count(self.from.normal))?;
        same_length("posed tangents", count(self.to.tangent), count(self.from.tangent))?;
        Ok(())
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn elements(&self) -> usize {
        self.posed.len() / self.to.stride.max(1)
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load<V: Level>(&self, level: V, field: Field, tile: Tile) -> Option<Vectors<[R; 3], V>> {
        let stride = self.from.stride;
        let from = self.rest.get(tile.element * stride + self.from.at(field)?..)?;
        if <R as Float>::Lanes::<V>::LANES > 1
            && let Some([x, y, z, _]) = <R as Float>::Lanes::<V>::load_rows(level, from, stride)
        {
            return Some([x, y, z]);
        }
        let mut records = [[R::ZERO; 3]; MAX_LANES];
        let lanes = records.iter_mut().take(<R as Float>::Lanes::<V>::LANES);
        for (record, vertex) in lanes.zip(from.chunks(stride.max(1))) {
            *record = *vertex.first_chunk().unwrap_or(record);
        }
        Some(Records::load_records(level, &records, [R::ZERO; 3]))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn store<V: Level>(&mut self, vectors: Vectors<[R; 3], V>, field: Field, tile: Tile) {
        let stride = self.to.stride;
        let Some(at) = self.to.at(field) else { return };
        let Some(to) = self.posed.get_mut(tile.element * stride + at..) else { return };
        let mut records = [[R::ZERO; 3]; MAX_LANES];
        Records::store_records(vectors, &mut records);
        let lanes = records.iter().take(<R as Float>::Lanes::<V>::LANES);
        for (record, vertex) in lanes.zip(to.chunks_mut(stride.max(1))) {
            if let Some(slot) = vertex.first_chunk_mut() {
                *slot = *record;
            }
        }
    }
}

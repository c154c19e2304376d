//! Meshes whose vertices are records of several fields.

use super::SkinningError;
use super::blender::Blender;
use super::mesh::{Field, Mesh, Vectors};
use super::skin::Skin;
use super::weight::Weight;
#[cfg(feature = "rayon")]
use crate::backend::Outputs;
use crate::number::Scalar;
use crate::storage::Tile;
use crate::storage::shape::same_length;
use dq8_simd::internal::Index;
use dq8_simd::{Float, Lanes, Level, MAX_LANES, Records};

/// The places of a vertex's fields in a buffer that holds one vertex after the other, all counted
/// in numbers. A field is three numbers.
///
/// ```
/// use dq8::skinning::VertexFields;
/// // Position, normal, tangent with its sign, texture coordinates: 12 numbers.
/// let fields = VertexFields { stride: 12, position: 0, normal: Some(3), tangent: Some(6) };
/// assert_eq!(VertexFields::positions(12), VertexFields { normal: None, tangent: None, ..fields });
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct VertexFields {
    /// From a vertex to the next.
    pub stride: usize,
    /// The begin of the position in a vertex.
    pub position: usize,
    /// The begin of the normal, if it has one.
    pub normal: Option<usize>,
    /// The begin of the tangent, if it has one, without the sign of the bitangent.
    pub tangent: Option<usize>,
}

impl VertexFields {
    /// Vertices that begin with their positions; nothing else is posed.
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

    /// Checks that all fields lie in a vertex, apart from each other, and `numbers` are `vertices`.
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
            // Not `first + 3`, which may wrap.
            let outside = self.stride < 3 || first > self.stride - 3;
            if outside || before.any(|other| first.abs_diff(other) < 3) {
                return Err(SkinningError::Field { what, first, stride: self.stride });
            }
        }
        Ok(same_length(what, numbers, vertices.saturating_mul(self.stride))?)
    }
}

/// Two buffers of vertices.
pub(super) struct Interleaved<'s, R> {
    pub(super) rest: &'s [R],
    pub(super) from: VertexFields,
    pub(super) posed: &'s mut [R],
    pub(super) to: VertexFields,
}

/// Checks that everything fits.
pub(super) fn check<J: Index, W: Weight, B: Blender<R>, R: Scalar>(
    skin: &Skin<'_, J, W>,
    blend: &B,
    Interleaved { rest, from, posed, to }: &Interleaved<'_, R>,
) -> Result<(), SkinningError> {
    let vertices = skin.vertices();
    blend.check(skin.joint_count(), vertices)?;
    from.check("rest", rest.len(), vertices)?;
    to.check("posed", posed.len(), vertices)?;
    let count = |field: Option<usize>| field.map_or(0, |_| vertices);
    same_length("posed normals", count(to.normal), count(from.normal))?;
    same_length("posed tangents", count(to.tangent), count(from.tangent))?;
    Ok(())
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

impl<R: Scalar> Mesh<[R; 3]> for Interleaved<'_, R> {
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

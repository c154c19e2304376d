//! Meshes whose vertices are records of several fields.

use super::SkinningError;
use super::blender::Blender;
use super::mesh::{Field, Mesh, Vectors};
use super::run::Run;
use super::skin::Skin;
use super::weight::Weight;
use crate::dispatch::Backend;
use crate::real::Scalar;
use crate::shape::same_length;
use crate::storage::Tile;
use core::marker::PhantomData;
use dq8_simd::picks::Index;
use dq8_simd::{Float, Lanes, Level, MAX_LANES, Records};

/// Where the fields of a vertex lie in a buffer that holds one vertex after the other, all counted in numbers.
/// A field is three numbers.
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
    /// Where in a vertex its position begins.
    pub position: usize,
    /// Where its normal begins, if it has one.
    pub normal: Option<usize>,
    /// Where its tangent begins, if it has one, without the sign of the bitangent.
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

    /// Whether all fields lie in a vertex, apart from each other, and `numbers` are `vertices`.
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

/// Whether everything fits.
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

impl Backend {
    /// [`skin`](Self::skin) of vertices that are records of several fields, such as the vertex buffer of a GPU:
    /// `rest` and `posed` hold the numbers of one vertex after those of another, and the two [`VertexFields`] say
    /// where its position is, and its normal and tangent. Everything else in `posed` is left alone.
    ///
    /// A slice of a user's own vertices is one of numbers by `bytemuck::cast_slice`, whatever fields of other types
    /// of the same size it has.
    ///
    /// # Errors
    /// If a field lies beyond its vertex or in another one, not both buffers have the same fields, or the
    /// buffers, the palette and the skin do not fit each other; `posed` is untouched.
    ///
    /// ```
    /// use dq8::skinning::{DualBlend, Skin, VertexFields};
    /// use dq8::{Backend, DualQuat};
    /// let skin = Skin::new(2, 1, &[0_u8, 1], &[1.0_f32, 1.0])?;
    /// let palette = [DualQuat::IDENTITY, DualQuat::from_translation([0.0_f32, 0.0, 4.0])];
    /// // Positions and texture coordinates.
    /// let rest = [1.0, 2.0, 3.0, 0.5, 0.5, 1.0, 2.0, 3.0, 0.1, 0.9];
    /// let (fields, mut posed) = (VertexFields::positions(5), rest);
    /// let best = Backend::best();
    /// best.skin_interleaved(&skin, DualBlend::new(&palette), (&rest, fields), (&mut posed, fields))?;
    /// assert_eq!(posed, [1.0, 2.0, 3.0, 0.5, 0.5, 1.0, 2.0, 7.0, 0.1, 0.9]);
    /// # Ok::<(), dq8::skinning::SkinningError>(())
    /// ```
    pub fn skin_interleaved<J: Index, W: Weight, B: Blender<R>, R: Scalar>(
        self,
        skin: &Skin<'_, J, W>,
        blend: B,
        (rest, from): (&[R], VertexFields),
        (posed, to): (&mut [R], VertexFields),
    ) -> Result<(), SkinningError> {
        let mesh = Interleaved { rest, from, posed, to };
        check(skin, &blend, &mesh)?;
        self.run(Run { skin, blend, first: 0, mesh, layout: PhantomData::<[R; 3]> });
        Ok(())
    }
}

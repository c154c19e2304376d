//! Influences in vertices that are records of several fields.

use super::SkinningError;
use super::skin::Skin;
use super::weight::Weight;
use crate::storage::shape::{same_length, whole_instances};
use dq8_simd::internal::Index;

/// The place of a vertex's joints in a buffer that holds one vertex after the other, or its
/// weights; counted in elements of their own type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct InfluenceField {
    /// From a vertex to the next.
    pub stride: usize,
    /// The begin of the field in a vertex.
    pub first: usize,
}

impl InfluenceField {
    /// The buffer from the field of the first vertex on, and how many vertices it has.
    fn check<'b, T>(
        self,
        what: &'static str,
        influences: usize,
        buffer: &'b [T],
    ) -> Result<(&'b [T], usize), SkinningError> {
        let Self { stride, first } = self;
        // Not `first + influences`, which may wrap.
        if stride < influences || first > stride - influences {
            return Err(SkinningError::InfluenceField { what, first, stride, influences });
        }
        let vertices = whole_instances(what, stride, buffer.len())?;
        Ok((buffer.get(first..).unwrap_or_default(), vertices))
    }
}

impl<'a, J: Index, W: Weight> Skin<'a, J, W> {
    /// As [`new`](Self::new), of joints and weights that lie between other fields: the attributes
    /// of a glTF file with a `byteStride`, or the vertex buffer of a GPU. Each is a slice of
    /// elements of its own type and says where the field is; the slices may be two views of the
    /// same bytes (`bytemuck::cast_slice`). A stride or an offset in bytes, divided by the size of
    /// an element, is one in elements.
    ///
    /// The skin borrows them, so what is posed goes to another buffer.
    ///
    /// # Errors
    /// If a field lies beyond its vertex, the buffers are not whole vertices or not as many of
    /// them, and as [`new`](Self::new).
    ///
    /// ```
    /// use dq8::skinning::{DualBlend, InfluenceField, Skin, VertexFields};
    /// use dq8::{Backend, DualQuat};
    /// #[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
    /// #[repr(C)]
    /// struct Vertex {
    ///     position: [f32; 3],
    ///     joints: [u16; 2],
    ///     weights: [f32; 2],
    /// }
    /// let position = [1.0, 2.0, 3.0];
    /// let rest = [
    ///     Vertex { position, joints: [0, 1], weights: [1.0, 0.0] },
    ///     Vertex { position, joints: [0, 1], weights: [0.25, 0.75] },
    /// ];
    /// // 24 bytes: 12 of u16, 6 of f32.
    /// let joints = (bytemuck::cast_slice(&rest), InfluenceField { stride: 12, first: 6 });
    /// let weights = (bytemuck::cast_slice(&rest), InfluenceField { stride: 6, first: 4 });
    /// let skin = Skin::<u16, f32>::interleaved(2, 2, joints, weights)?;
    ///
    /// let palette = [DualQuat::IDENTITY, DualQuat::from_translation([0.0_f32, 0.0, 4.0])];
    /// let (mut posed, fields) = (rest, VertexFields::positions(6));
    /// let from = (bytemuck::cast_slice(&rest), fields);
    /// let to = (bytemuck::cast_slice_mut(&mut posed), fields);
    /// skin.job().pose_interleaved(DualBlend::new(&palette), from, to)?;
    /// assert_eq!(posed.map(|vertex| vertex.position[2]), [3.0, 6.0]);
    /// # Ok::<(), dq8::skinning::SkinningError>(())
    /// ```
    pub fn interleaved(
        joint_count: usize,
        influences: usize,
        (joints, at): (&'a [J], InfluenceField),
        (weights, of): (&'a [W], InfluenceField),
    ) -> Result<Self, SkinningError> {
        if influences == 0 {
            return Err(SkinningError::NoInfluences);
        }
        let (joints, vertices) = at.check("joints", influences, joints)?;
        let (weights, weighted) = of.check("weights", influences, weights)?;
        same_length("weighted vertices", weighted, vertices)?;
        Self::checked(joint_count, influences, (joints, at.stride), (weights, of.stride))
    }
}

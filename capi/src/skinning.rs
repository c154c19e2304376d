//! Meshes that follow joints: a skin that is checked once, and poses by linear or dual quaternion
//! blends.

use crate::mesh::{Arrays, Mesh, Records, VertexFields};
use crate::skin::{InfluenceField, Pointers, Posing, Skin, SkinParts};
use crate::status::{Done, Status};
use dq8::Scalar;
use dq8::skinning::{self, DualBlend, Linear, Mixed, StretchedDualBlend};

/// Defines the generic function of each blend, from its palettes, their [`Pointers`], and the blend
/// of the [`Palettes`](crate::skin::Palettes).
macro_rules! blends {
    ($($name:ident($($palette:ident),+) of $mesh:ident: $given:expr, |$by:ident| $blend:expr;)+) => {$(
        /// # Safety
        /// The caller must keep the conditions of [`Mesh::pose`].
        unsafe fn $name<R: Scalar + skinning::Weight>(
            skin: *const Skin<R>,
            $($palette: *const R,)+
            joints: usize,
            $mesh: impl Mesh<R>,
        ) -> Done {
            // SAFETY: the caller keeps the conditions under `# Safety`, which are those of the
            // functions called here.
            unsafe {
                let by = Posing::new(skin, joints, $given)?;
                $mesh.pose(&by, |$by| $blend)
            }
        }
    )+};
}
blends! {
    linear(matrices) of mesh: Pointers { matrices: Some(matrices), ..Pointers::NOTHING },
        |by| Ok(Linear::new(by.matrices));
    dual(motions) of mesh: Pointers { motions: Some(motions), ..Pointers::NOTHING },
        |by| Ok(DualBlend::new(by.motions));
    stretched(motions, stretches) of mesh:
        Pointers { motions: Some(motions), matrices: Some(stretches), ..Pointers::NOTHING },
        |by| Ok(StretchedDualBlend::new(by.motions, by.matrices));
    mixed(matrices, motions, shares) of mesh: Pointers {
            motions: Some(motions),
            matrices: Some(matrices),
            shares: Some((shares, mesh.vertices())),
        },
        |by| Mixed::new(Linear::new(by.matrices), DualBlend::new(by.motions), by.shares);
}

/// Exports the two functions that pose a mesh by a blend: of arrays and of vertex buffers. Both
/// call the generic function of the first name.
macro_rules! export_pose {
    ($R:ident $(#[doc = $about:literal])* $name:ident, $interleaved:ident($($palette:ident),*)) => {
        export_one! { $R
            /// Poses a vertex buffer, otherwise like the function without _interleaved. `rest` and
            /// `posed` hold `stride` numbers per vertex, and `from` and `to` say where in them the
            /// position, normal and tangent are. Other numbers in `posed` are left as they are.
            ///
            /// Returns DQ8_STATUS_LENGTH if one buffer has a normal or tangent and the other has
            /// not, and DQ8_STATUS_FIELD if a field is not inside of its vertex, or overlaps
            /// another.
            skin::$interleaved(
                skin: *const Skin<$R>, $($palette: *const $R,)* joint_count: usize,
                rest: *const $R, from: VertexFields, posed: *mut $R, to: VertexFields,
                vertices: usize,
            ) = super::$name(skin, $($palette,)* joint_count, Records { rest, from, posed, to, vertices })
        }
        export_one! { $R
            $(#[doc = $about])*
            skin::$name(
                skin: *const Skin<$R>, $($palette: *const $R,)* joint_count: usize,
                positions: *const $R, normals: *const $R, tangents: *const $R,
                posed_positions: *mut $R, posed_normals: *mut $R, posed_tangents: *mut $R,
                vertices: usize,
            ) = {
                let rest = [positions, normals, tangents];
                let posed = [posed_positions, posed_normals, posed_tangents];
                super::$name(skin, $($palette,)* joint_count, Arrays { rest, posed, vertices })
            }
        }
    };
}

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export_one! { $R
            /// Makes a skin of the joints that move each vertex and their weights. It checks them
            /// once, so that the functions that pose the mesh only compute. `joint_indices` and
            /// `weights` hold `influences` numbers for the first vertex, then those for the next,
            /// and so on. Fill unused influences with any joint and weight 0. The skin keeps using
            /// both arrays; its functions are undefined if these change.
            ///
            /// Returns DQ8_STATUS_JOINT_OUT_OF_RANGE, _WEIGHT or _WEIGHT_SUM, and sets
            /// `bad_vertex`, which may be null, to that vertex. Returns DQ8_STATUS_NO_INFLUENCES if
            /// `influences` is 0. The skin is then not written.
            skin::make(
                joint_count: usize, influences: usize, joint_indices: *const u16,
                weights: *const $R, vertices: usize, skin: *mut Skin<$R>, bad_vertex: *mut usize,
            ) = {
                let packed = InfluenceField { stride: influences, first: 0 };
                let (joint_field, weight_field) = (packed, packed);
                let joints = joint_count;
                SkinParts { joints, influences, joint_indices, joint_field, weights, weight_field, vertices }
                    .make(skin, bad_vertex)
            }
        }
        export_one! { $R
            /// Makes a skin of a vertex buffer, otherwise like dq8_skin_make. `joint_indices` and
            /// `weights` hold `stride` elements per vertex, of which `influences` elements from
            /// `first` on are read. Both may be the same memory. Divide strides and offsets in
            /// bytes by the size of an element. Returns DQ8_STATUS_FIELD if a field is not inside
            /// of its vertex.
            skin::make_interleaved(
                joint_count: usize, influences: usize,
                joint_indices: *const u16, joint_field: InfluenceField,
                weights: *const $R, weight_field: InfluenceField,
                vertices: usize, skin: *mut Skin<$R>, bad_vertex: *mut usize,
            ) = {
                let joints = joint_count;
                SkinParts { joints, influences, joint_indices, joint_field, weights, weight_field, vertices }
                    .make(skin, bad_vertex)
            }
        }
        export_pose! { $R
            /// Poses a mesh by linear blends: each vertex moves by the weighted sum of `matrices`,
            /// the palette, with twelve numbers per joint, row by row. Weights must sum to 1.
            ///
            /// `positions`, `normals` and `tangents` hold three numbers per vertex. The posed ones
            /// are written to `posed_positions`, `posed_normals` and `posed_tangents`, which must
            /// overlap nothing. Both pointers of normals or of tangents may be null. Returns
            /// DQ8_STATUS_LENGTH if `joint_count` or `vertices` is not that of the skin.
            linear, linear_interleaved(matrices)
        }
        export_pose! { $R
            /// Poses a mesh by dual quaternion blends, otherwise like dq8_skin_linear. Each vertex
            /// moves by the normalized weighted sum of `motions`, the palette, each with the sign
            /// that turns it toward the one with the greatest weight. Twisted joints keep their
            /// volume.
            dual, dual_interleaved(motions)
        }
        export_pose! { $R
            /// Poses a mesh whose joints scale or shear, otherwise like dq8_skin_dual. Each vertex
            /// is stretched by the weighted sum of `stretches`, matrices of twelve numbers per
            /// joint, before it moves. dq8_skin_split makes both palettes.
            stretched, stretched_interleaved(motions, stretches)
        }
        export_pose! { $R
            /// Poses a mesh by dq8_skin_linear and dq8_skin_dual, and mixes the two with a share s
            /// per vertex: (1 - s) times the first and s times the second. This is against the
            /// bulge of dual quaternion blends at bent joints. `shares` holds a number per vertex.
            /// Returns DQ8_STATUS_SHARE if one is not in [0, 1].
            mixed, mixed_interleaved(matrices, motions, shares)
        }
    };
}
for_both_numbers!(functions);

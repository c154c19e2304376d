//! Meshes that follow joints: a skin checked once, posed by linear or dual quaternion blends.

use crate::mesh::{Arrays, Mesh, Records, VertexFields};
use crate::skin::{By, Given, InfluenceField, Posing, Skin};
use crate::status::{Done, Status};
use dq8::Scalar;
use dq8::skinning::{self, DualBlend, Linear, Mixed, StretchedDualBlend};

/// The generic function of each blend: its palettes, what they are to [`Posing`], and the blend of
/// what is found.
macro_rules! blends {
    ($($name:ident($($palette:ident),+) of $mesh:ident: $given:expr, |$by:ident| $blend:expr;)+) => {$(
        /// # Safety
        /// As for [`Mesh::pose`].
        unsafe fn $name<R: Scalar + skinning::Weight>(
            skin: *const Skin<R>,
            $($palette: *const R,)+
            joints: usize,
            $mesh: impl Mesh<R>,
        ) -> Done {
            // SAFETY: promised.
            unsafe {
                let by = Posing::new(skin, joints, $given)?;
                $mesh.pose(&by, |$by| $blend)
            }
        }
    )+};
}
blends! {
    linear(matrices) of mesh: By { matrices: Some(matrices), ..By::NOTHING },
        |by| Ok(Linear::new(by.matrices));
    dual(motions) of mesh: By { motions: Some(motions), ..By::NOTHING },
        |by| Ok(DualBlend::new(by.motions));
    stretched(motions, stretches) of mesh:
        By { motions: Some(motions), matrices: Some(stretches), ..By::NOTHING },
        |by| Ok(StretchedDualBlend::new(by.motions, by.matrices));
    mixed(matrices, motions, shares) of mesh: By {
            motions: Some(motions),
            matrices: Some(matrices),
            shares: Some((shares, mesh.vertices())),
        },
        |by| Mixed::new(Linear::new(by.matrices), DualBlend::new(by.motions), by.shares);
}

/// Functions that pose a mesh with these palettes, and the generic one of the first name in the
/// file.
macro_rules! export_pose {
    ($R:ident $(#[doc = $about:literal])* $name:ident, $interleaved:ident($($palette:ident),*)) => {
        export_one! { $R
            /// As without _interleaved, of vertices that are records of several fields, such as the
            /// vertex buffer of a GPU: `rest` and `posed` hold `stride` numbers per vertex, and the
            /// two `dq8_vertex_fields` say where its position is, and its normal and tangent. Both
            /// buffers have the same fields, or it is DQ8_STATUS_LENGTH; DQ8_STATUS_FIELD if a
            /// field lies beyond its vertex or in another one. Everything else in `posed` is left
            /// alone.
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
            /// Checks which joints move each vertex and how much, once; the functions that pose the
            /// mesh then only compute. `joint_indices` and `weights` hold `influences` numbers of
            /// the first vertex, then those of the next; fill unused influences with any joint and
            /// weight 0. The skin keeps using both: they must stay where they are, as they are;
            /// what its functions do is undefined if they change.
            ///
            /// DQ8_STATUS_JOINT_OUT_OF_RANGE, _WEIGHT or _WEIGHT_SUM; `bad_vertex`, which may be
            /// null, is set to that vertex. DQ8_STATUS_NO_INFLUENCES if `influences` is 0. The skin
            /// has then not been written.
            skin::make(
                joint_count: usize, influences: usize, joint_indices: *const u16,
                weights: *const $R, vertices: usize, skin: *mut Skin<$R>, bad_vertex: *mut usize,
            ) = {
                let packed = InfluenceField { stride: influences, first: 0 };
                let (joint_field, weight_field) = (packed, packed);
                let joints = joint_count;
                Given { joints, influences, joint_indices, joint_field, weights, weight_field, vertices }
                    .make(skin, bad_vertex)
            }
        }
        export_one! { $R
            /// As dq8_skin_make, of joints and weights that lie between other fields, such as in a
            /// vertex buffer: `joint_indices` and `weights` hold `stride` elements per vertex, of
            /// which `influences` from `first` on are the field; they may be the same memory. A
            /// stride or an offset in bytes, divided by the size of an element, is one in elements.
            /// DQ8_STATUS_FIELD if the field lies beyond its vertex.
            skin::make_interleaved(
                joint_count: usize, influences: usize,
                joint_indices: *const u16, joint_field: InfluenceField,
                weights: *const $R, weight_field: InfluenceField,
                vertices: usize, skin: *mut Skin<$R>, bad_vertex: *mut usize,
            ) = {
                let joints = joint_count;
                Given { joints, influences, joint_indices, joint_field, weights, weight_field, vertices }
                    .make(skin, bad_vertex)
            }
        }
        export_pose! { $R
            /// Poses a mesh by linear blends: each vertex by the weighted sum of `matrices`, the
            /// palette, twelve numbers per joint, row after row. Weights must sum to 1.
            ///
            /// `positions`, and `normals` and `tangents` if not null, hold three numbers per
            /// vertex; what becomes of them goes to `posed_positions`, `posed_normals` and
            /// `posed_tangents`, which must overlap nothing. `joint_count` and `vertices` are those
            /// of the skin, or it is DQ8_STATUS_LENGTH.
            linear, linear_interleaved(matrices)
        }
        export_pose! { $R
            /// As dq8_skin_linear by dual quaternion blends: each vertex by the weighted sum of
            /// `motions`, the palette, normalized, each with the sign that turns it toward that of
            /// the greatest weight. Twists keep their volume.
            dual, dual_interleaved(motions)
        }
        export_pose! { $R
            /// As dq8_skin_dual where joints scale or shear: before the motions come the weighted
            /// sums of `stretches`, matrices of twelve numbers per joint. dq8_skin_split makes
            /// both.
            stretched, stretched_interleaved(motions, stretches)
        }
        export_pose! { $R
            /// As dq8_skin_linear and dq8_skin_dual, mixed by a number per vertex against the bulge
            /// of the second at bent joints: (1 − s) times the first and s times the second, s
            /// from `shares`. DQ8_STATUS_SHARE if one is not in [0, 1].
            mixed, mixed_interleaved(matrices, motions, shares)
        }
    };
}
for_both_numbers!(functions);

//! Meshes that follow joints: functions that make a skin, and functions that pose its mesh by
//! linear or dual quaternion blends.

use crate::mesh::{Arrays, Mesh, Records, VertexFields};
use crate::skin::{InfluenceField, Pointers, Posing, Skin, SkinParts};
use crate::status::{Done, Status};
use dq8::Scalar;
use dq8::skinning::{self, DualBlend, Linear, Mixed, StretchedDualBlend};

/// Defines the generic function of each blend. An entry has the names of the blend's palettes,
/// their [`Pointers`], and the blend of the [`Palettes`](crate::skin::Palettes).
macro_rules! blends {
    ($($name:ident($($palette:ident),+) of $mesh:ident: $given:expr, |$by:ident| $blend:expr;)+) => {$(
        /// # Safety
        /// The skin must be zeroed, or made with arrays that have not changed since. The palettes
        /// must have `joints` entries, or one share per vertex, and the mesh must have the elements
        /// of all its vertices. No other thread may use the outputs or write the inputs during the
        /// call.
        unsafe fn $name<R: Scalar + skinning::Weight>(
            skin: *const Skin<R>,
            $($palette: *const R,)+
            joints: usize,
            $mesh: impl Mesh<R>,
        ) -> Done {
            // SAFETY: the caller guarantees that the skin is zeroed or made, that the palettes and
            // the mesh have the stated lengths, and that no other thread uses them.
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

/// Exports the two functions that pose a mesh by a blend: `$name` for arrays, and `$interleaved`
/// for vertex buffers. Both call the generic function `$name`.
macro_rules! export_pose {
    ($R:ident $(#[doc = $about:literal])* $name:ident, $interleaved:ident($($palette:ident),*)) => {
        export_one! { $R
            /// Poses a vertex buffer, like the function without _interleaved poses arrays. `rest`
            /// and `posed` hold `stride` elements per vertex. `from` and `to` are the layouts of
            /// `rest` and `posed`: the offsets of position, normal and tangent in a vertex. All
            /// other elements of `posed` keep their values.
            ///
            /// Returns DQ8_STATUS_FIELDS if only one of the two buffers has a normal, or a tangent,
            /// and DQ8_STATUS_FIELD if a field is not inside of its vertex, or overlaps another
            /// field.
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
            /// Makes a skin of the joints that move each vertex and their weights. It checks both
            /// arrays once, so that the functions that pose the mesh need not. `joint_indices` and
            /// `weights` hold `influences` elements per vertex, one vertex after the other. Fill
            /// unused influences with any joint and weight 0. The skin points to both arrays, and
            /// the behaviour of its functions is undefined if the program changes or frees them.
            ///
            /// Returns DQ8_STATUS_JOINT_OUT_OF_RANGE, _WEIGHT or _WEIGHT_SUM if a vertex is wrong,
            /// and sets `bad_vertex`, which may be null, to its index. Returns
            /// DQ8_STATUS_NO_INFLUENCES if `influences` is 0. After an error the skin has not been
            /// written.
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
            /// `weights` hold `stride` elements per vertex, of which the skin reads `influences`
            /// elements from `first` on. Both pointers may be to the same memory. Divide strides
            /// and offsets in bytes by the size of an element. Returns DQ8_STATUS_FIELD if a field
            /// is not inside of its vertex.
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
            /// Poses a mesh by linear blends: each vertex moves by the weighted sum of its joints'
            /// matrices. `matrices` is the palette, with twelve components per joint, row by row.
            /// The weights of a vertex must sum to 1.
            ///
            /// `positions`, `normals` and `tangents` hold three components per vertex, of the mesh
            /// at rest. The posed mesh is written to `posed_positions`, `posed_normals` and
            /// `posed_tangents`, which must not overlap any other array. `normals` and
            /// `posed_normals` may both be null, and so may `tangents` and `posed_tangents`.
            /// Returns DQ8_STATUS_LENGTH_JOINTS or _LENGTH_VERTICES if `joint_count` or `vertices`
            /// differs from that of the skin.
            linear, linear_interleaved(matrices)
        }
        export_pose! { $R
            /// Poses a mesh by dual quaternion blends, otherwise like dq8_skin_linear. Each vertex
            /// moves by the normalized weighted sum of its joints' motions. Each motion gets the
            /// sign that turns it toward the motion with the greatest weight. `motions` is the
            /// palette, with eight components per joint. The mesh keeps its volume at twisted
            /// joints.
            dual, dual_interleaved(motions)
        }
        export_pose! { $R
            /// Poses a mesh whose joints scale or shear, otherwise like dq8_skin_dual. The weighted
            /// sum of its joints' `stretches` acts on each vertex before the motion does.
            /// `stretches` are matrices of twelve components per joint. dq8_skin_split makes both
            /// palettes.
            stretched, stretched_interleaved(motions, stretches)
        }
        export_pose! { $R
            /// Poses a mesh by a mix of dq8_skin_linear and dq8_skin_dual. A posed vertex is (1 -
            /// s) times the vertex of dq8_skin_linear plus s times the vertex of dq8_skin_dual.
            /// This reduces the bulge of dual quaternion blends at bent joints. `shares` holds the
            /// share s of each vertex. Returns DQ8_STATUS_SHARE if a share is not in [0, 1].
            mixed, mixed_interleaved(matrices, motions, shares)
        }
    };
}
for_both_numbers!(functions);

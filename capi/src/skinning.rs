//! Meshes that follow joints: a skin checked once, posed by linear or dual quaternion blends.

use crate::memory::{Input, Output};
use crate::mesh::{Arrays, Mesh, Records, VertexFields};
use crate::status::{Done, Status};
use core::mem::MaybeUninit;
use core::ptr;
use dq8::skinning::{self, DualBlend, Linear, SkinningError, Stretched};
use dq8::{DualQuat, Scalar};

/// Where the joints of a vertex lie in an array that holds one vertex after the other, or its weights; counted in
/// elements of their own type.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct InfluenceField {
    /// From a vertex to the next.
    pub stride: usize,
    /// Where in a vertex the field begins.
    pub first: usize,
}

/// Which joints move the vertices of a mesh, and how much. It may be copied and moved; the joints and weights
/// that it was made of must stay where they are, as they are.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct Skin<R> {
    /// How many vertices it has.
    pub vertices: usize,
    /// How many influences every vertex has. 0 in a skin that has not been made, if it was zeroed.
    pub influences: usize,
    /// How many joints its palettes have.
    pub joints: usize,
    /// What it was made of.
    joint_indices: *const u16,
    joint_stride: usize,
    weights: *const R,
    weight_stride: usize,
    /// Not for you.
    // A `Known<R>`, some of whose bytes are padding and so nothing at all.
    opaque: [MaybeUninit<*const R>; 8],
}

type Known<R> = skinning::Skin<'static, u16, R>;

/// Whether what the library keeps fits the memory that C has for it.
macro_rules! fits {
    ($($R:ident)*) => {$(const _: () = {
        assert!(size_of::<Known<$R>>() <= 8 * size_of::<*const ()>());
        assert!(align_of::<Known<$R>>() <= align_of::<*const ()>());
    };)*};
}
fits! { f32 f64 }

/// The vertex that an error of a skin names.
fn vertex_of(error: &SkinningError) -> Option<usize> {
    match *error {
        SkinningError::JointOutOfRange { vertex, .. }
        | SkinningError::Weight { vertex, .. }
        | SkinningError::Total { vertex, .. } => Some(vertex),
        _ => None,
    }
}

/// What a skin is made of, as C has it.
struct Given<R> {
    joints: usize,
    influences: usize,
    joint_indices: *const u16,
    at: InfluenceField,
    weights: *const R,
    of: InfluenceField,
    vertices: usize,
}

/// What a skin is made of.
fn inputs<R: Copy>(
    vertices: usize,
    (joint_indices, joint_stride): (*const u16, usize),
    (weights, weight_stride): (*const R, usize),
) -> Result<(Input<u16>, Input<R>), Status> {
    let joints = vertices.checked_mul(joint_stride).ok_or(Status::TooLarge)?;
    let weight_count = vertices.checked_mul(weight_stride).ok_or(Status::TooLarge)?;
    Ok((Input::new(joint_indices, joints)?, Input::new(weights, weight_count)?))
}

impl<R: Scalar + skinning::Weight> Given<R> {
    /// # Safety
    /// As for [`Input::slice`] and [`Output::write`]; joints and weights stay as they are.
    unsafe fn make(self, skin: *mut Skin<R>, bad_vertex: *mut usize) -> Done {
        let Self {
            joints,
            influences,
            joint_indices: at_joints,
            at,
            weights: at_weights,
            of,
            vertices,
        } = self;
        let (joint_indices, weights) =
            inputs(vertices, (at_joints, at.stride), (at_weights, of.stride))?;
        let made = Output::<Skin<R>>::new(skin, 1)?;
        let bad_vertex = Output::<usize>::unless_null(bad_vertex)?;
        made.apart_from(&joint_indices)?;
        made.apart_from(&weights)?;
        if let Some(bad_vertex) = &bad_vertex {
            bad_vertex.apart_from(&joint_indices)?;
            bad_vertex.apart_from(&weights)?;
            bad_vertex.apart_from_output(&made)?;
        }
        // SAFETY: promised; what is made lives as long as C keeps them.
        let (joint_indices, weights) = unsafe { (joint_indices.slice(), weights.slice()) };
        let field = |InfluenceField { stride, first }| skinning::InfluenceField { stride, first };
        let (joints_at, weights_at) = ((joint_indices, field(at)), (weights, field(of)));
        let known: Known<R> =
            match skinning::Skin::interleaved(joints, influences, joints_at, weights_at) {
                Ok(known) => known,
                Err(error) => {
                    if let (Some(bad_vertex), Some(vertex)) = (bad_vertex, vertex_of(&error)) {
                        // SAFETY: promised, and apart.
                        unsafe { bad_vertex.write(vertex) };
                    }
                    return Err(error.into());
                }
            };
        let opaque = [const { MaybeUninit::uninit() }; 8];
        // SAFETY: promised, and apart; a skin of the library fits, by `fits`.
        unsafe {
            made.write(Skin {
                vertices,
                influences,
                joints,
                joint_indices: at_joints,
                joint_stride: at.stride,
                weights: at_weights,
                weight_stride: of.stride,
                opaque,
            });
            ptr::addr_of_mut!((*skin).opaque).cast::<Known<R>>().write(known);
        }
        Ok(())
    }
}

/// What poses a mesh, found where C says it is: a skin, and of the palettes what the blend needs.
pub(crate) struct Posing<R> {
    skin: *const Skin<R>,
    given: Input<Skin<R>>,
    joint_indices: Input<u16>,
    weights: Input<R>,
    motions: Input<DualQuat<R>>,
    matrices: Input<[[R; 4]; 3]>,
}

impl<R: Scalar + skinning::Weight> Posing<R> {
    /// # Safety
    /// The skin is zero, or has been made, and what it was made of is as it was.
    unsafe fn new(
        skin: *const Skin<R>,
        motions: Option<*const R>,
        matrices: Option<*const R>,
        joints: usize,
    ) -> Result<Self, Status> {
        let given = Input::<Skin<R>>::new(skin, 1)?;
        // SAFETY: neither null nor misaligned, by `Input::new`; the rest is promised.
        let Skin {
            vertices, influences, joint_indices, joint_stride, weights, weight_stride, ..
        } = unsafe { skin.read() };
        if influences == 0 {
            return Err(Status::NoSkin);
        }
        let (joint_indices, weights) =
            inputs(vertices, (joint_indices, joint_stride), (weights, weight_stride))?;
        let palette = |of: Option<*const R>| of.map_or((ptr::null(), 0), |of| (of, joints));
        let ((motions, count), (matrices, matrix_count)) = (palette(motions), palette(matrices));
        let (motions, matrices) =
            (Input::new(motions, count)?, Input::new(matrices, matrix_count)?);
        Ok(Self { skin, given, joint_indices, weights, motions, matrices })
    }

    /// Whether nothing of it lies in what is written.
    pub(crate) fn apart_from<T: Copy>(&self, to: &Output<T>) -> Done {
        to.apart_from(&self.given)?;
        to.apart_from(&self.joint_indices)?;
        to.apart_from(&self.weights)?;
        to.apart_from(&self.motions)?;
        to.apart_from(&self.matrices)
    }

    /// The skin, motions and matrices.
    ///
    /// # Safety
    /// As for [`new`](Self::new) and [`Input::slice`].
    #[expect(clippy::type_complexity, reason = "three things")]
    pub(crate) unsafe fn borrow<'p>(&self) -> (Known<R>, &'p [DualQuat<R>], &'p [[[R; 4]; 3]]) {
        // SAFETY: it has been made, so this was written; the rest is promised.
        unsafe {
            let known = ptr::addr_of!((*self.skin).opaque).cast::<Known<R>>().read();
            (known, self.motions.slice(), self.matrices.slice())
        }
    }
}

/// # Safety
/// As for [`Mesh::pose`].
unsafe fn linear<R: Scalar + skinning::Weight>(
    skin: *const Skin<R>,
    matrices: *const R,
    joints: usize,
    mesh: impl Mesh<R>,
) -> Done {
    // SAFETY: promised.
    unsafe {
        let by = Posing::new(skin, None, Some(matrices), joints)?;
        mesh.pose(&by, |_, matrices| Linear::new(matrices))
    }
}

/// # Safety
/// As for [`Mesh::pose`].
unsafe fn dual<R: Scalar + skinning::Weight>(
    skin: *const Skin<R>,
    motions: *const R,
    joints: usize,
    mesh: impl Mesh<R>,
) -> Done {
    // SAFETY: promised.
    unsafe {
        let by = Posing::new(skin, Some(motions), None, joints)?;
        mesh.pose(&by, |motions, _| DualBlend::new(motions))
    }
}

/// # Safety
/// As for [`Mesh::pose`].
unsafe fn stretched<R: Scalar + skinning::Weight>(
    skin: *const Skin<R>,
    motions: *const R,
    stretches: *const R,
    joints: usize,
    mesh: impl Mesh<R>,
) -> Done {
    // SAFETY: promised.
    unsafe {
        let by = Posing::new(skin, Some(motions), Some(stretches), joints)?;
        mesh.pose(&by, |motions, stretches| Stretched::new(motions, stretches))
    }
}

/// Functions that pose a mesh with these palettes, and the generic one of the first name in the file.
macro_rules! export_pose {
    ($R:ident $(#[doc = $about:literal])* $name:ident, $interleaved:ident($($palette:ident),*)) => {
        export_skin! { $R
            /// As without _interleaved, of vertices that are records of several fields, such as the vertex
            /// buffer of a GPU: `rest` and `posed` hold `stride` numbers per vertex, and the two `dq8_vertex_fields`
            /// say where its position is, and its normal and tangent. Both buffers have the same fields, or it is
            /// DQ8_STATUS_LENGTH; DQ8_STATUS_FIELD if a field lies beyond its vertex or in another one. Everything
            /// else in `posed` is left alone.
            $interleaved(
                skin: *const Skin<$R>, $($palette: *const $R,)* joint_count: usize,
                rest: *const $R, from: VertexFields, posed: *mut $R, to: VertexFields,
                vertices: usize,
            ) = super::$name(skin, $($palette,)* joint_count, Records { rest, from, posed, to, vertices })
        }
        export_skin! { $R
            $(#[doc = $about])*
            $name(
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
        export_skin! { $R
            /// Checks which joints move each vertex and how much, once; the functions that pose the mesh then
            /// only compute. `joint_indices` and `weights` hold `influences` numbers of the first vertex, then
            /// those of the next; fill unused influences with any joint and weight 0. The skin keeps using
            /// both: they must stay where they are, as they are.
            ///
            /// DQ8_STATUS_JOINT_OUT_OF_RANGE, _WEIGHT or _WEIGHT_SUM; `bad_vertex`, which may be null, is set to
            /// that vertex. DQ8_STATUS_NO_INFLUENCES if `influences` is 0. The skin has then not been written.
            make(
                joint_count: usize, influences: usize, joint_indices: *const u16,
                weights: *const $R, vertices: usize, skin: *mut Skin<$R>, bad_vertex: *mut usize,
            ) = {
                let packed = InfluenceField { stride: influences, first: 0 };
                let (at, of) = (packed, packed);
                Given { joints: joint_count, influences, joint_indices, at, weights, of, vertices }
                    .make(skin, bad_vertex)
            }
        }
        export_skin! { $R
            /// As dq8_skin_make, of joints and weights that lie between other fields, such as in a vertex buffer:
            /// `joint_indices` and `weights` hold `stride` elements per vertex, of which `influences` from `first`
            /// on are the field; they may be the same memory. A stride or an offset in bytes, divided by the size
            /// of an element, is one in elements. DQ8_STATUS_FIELD if the field lies beyond its vertex.
            make_interleaved(
                joint_count: usize, influences: usize, joint_indices: *const u16, at: InfluenceField,
                weights: *const $R, of: InfluenceField, vertices: usize, skin: *mut Skin<$R>,
                bad_vertex: *mut usize,
            ) = Given { joints: joint_count, influences, joint_indices, at, weights, of, vertices }
                .make(skin, bad_vertex)
        }
        export_pose! { $R
            /// Poses a mesh by linear blends: each vertex by the weighted sum of `matrices`, the palette, twelve
            /// numbers per joint, row after row. Weights must sum to 1.
            ///
            /// `positions`, and `normals` and `tangents` if not null, hold three numbers per vertex; what becomes
            /// of them goes to `posed_positions`, `posed_normals` and `posed_tangents`, which must overlap nothing.
            /// `joint_count` and `vertices` are those of the skin, or it is DQ8_STATUS_LENGTH.
            linear, linear_interleaved(matrices)
        }
        export_pose! { $R
            /// As dq8_skin_linear by dual quaternion blends: each vertex by the weighted sum of `motions`, the
            /// palette, normalized, each with the sign that turns it toward that of the greatest weight. Twists
            /// keep their volume.
            dual, dual_interleaved(motions)
        }
        export_pose! { $R
            /// As dq8_skin_dual where joints scale or shear: before the motions come the weighted sums of
            /// `stretches`, matrices of twelve numbers per joint. dq8_skin_split makes both.
            stretched, stretched_interleaved(motions, stretches)
        }
    };
}
for_both_numbers!(functions);

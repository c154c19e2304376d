//! Meshes that follow joints: a skin checked once, posed by linear or dual quaternion blends.

use crate::memory::{Input, Output};
use crate::status::{Done, Status};
use core::mem::MaybeUninit;
use core::ptr;
use dq8::skinning::{self, DualBlend, Linear, SkinningError, Stretched, Surface, SurfaceMut};
use dq8::{Backend, DualQuat, Scalar};

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
    weights: *const R,
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
    weights: *const R,
    vertices: usize,
}

impl<R: Scalar + skinning::Weight> Given<R> {
    fn inputs(&self) -> Result<(Input<u16>, Input<R>), Status> {
        let count = self.vertices.checked_mul(self.influences).ok_or(Status::TooLarge)?;
        Ok((Input::new(self.joint_indices, count)?, Input::new(self.weights, count)?))
    }

    /// # Safety
    /// As for [`Input::slice`] and [`Output::write`]; joints and weights stay as they are.
    unsafe fn make(self, skin: *mut Skin<R>, bad_vertex: *mut usize) -> Done {
        let (joint_indices, weights) = self.inputs()?;
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
        let (of, by) = unsafe { (joint_indices.slice(), weights.slice()) };
        let known: Known<R> = match skinning::Skin::new(self.joints, self.influences, of, by) {
            Ok(known) => known,
            Err(error) => {
                if let (Some(bad_vertex), Some(vertex)) = (bad_vertex, vertex_of(&error)) {
                    // SAFETY: promised, and apart.
                    unsafe { bad_vertex.write(vertex) };
                }
                return Err(error.into());
            }
        };
        let Self { joints, influences, joint_indices, weights, vertices } = self;
        let opaque = [const { MaybeUninit::uninit() }; 8];
        // SAFETY: promised, and apart; a skin of the library fits, by `fits`.
        unsafe {
            made.write(Skin { vertices, influences, joints, joint_indices, weights, opaque });
            ptr::addr_of_mut!((*skin).opaque).cast::<Known<R>>().write(known);
        }
        Ok(())
    }
}

/// A mesh at rest and where it goes when posed, as C has it: positions, normals, tangents.
struct Mesh<R> {
    rest: [*const R; 3],
    posed: [*mut R; 3],
    vertices: usize,
}

/// Vectors at rest and posed.
type Field<R> = (Input<[R; 3]>, Output<[R; 3]>);

/// What poses a mesh: of these what it needs.
struct Palette<R> {
    motions: Option<*const R>,
    matrices: Option<*const R>,
    joints: usize,
}

impl<R: Scalar + skinning::Weight> Mesh<R> {
    fn field(&self, from: *const R, to: *mut R) -> Result<Field<R>, Status> {
        Ok((Input::new(from, self.vertices)?, Output::new(to, self.vertices)?))
    }

    /// None where C passes null for both.
    fn optional(&self, from: *const R, to: *mut R) -> Result<Option<Field<R>>, Status> {
        if from.is_null() && to.is_null() {
            return Ok(None);
        }
        self.field(from, to).map(Some)
    }

    /// Poses it, if nothing that is written lies in anything that is read, or twice.
    ///
    /// # Safety
    /// The skin is zero, or has been made, and what it was made of is as it was. The rest as for
    /// [`Input::slice`] and [`Output::slice`].
    unsafe fn pose(
        self,
        skin: *const Skin<R>,
        palette: Palette<R>,
        blend: impl FnOnce(
            &Known<R>,
            &[DualQuat<R>],
            &[[[R; 4]; 3]],
            Surface<'_, [R; 3]>,
            SurfaceMut<'_, [R; 3]>,
        ) -> Result<(), SkinningError>,
    ) -> Done {
        let given = Input::<Skin<R>>::new(skin, 1)?;
        // SAFETY: neither null nor misaligned, by `Input::new`; the rest is promised.
        let Skin { vertices, influences, joints, joint_indices, weights, .. } =
            unsafe { skin.read() };
        if influences == 0 {
            return Err(Status::NoSkin);
        }
        let made = Given { joints, influences, joint_indices, weights, vertices };
        let (joint_indices, weights) = made.inputs()?;
        let motions = palette.motions.map(|of| Input::<DualQuat<R>>::new(of, palette.joints));
        let motions = motions.transpose()?;
        let matrices = palette.matrices.map(|of| Input::<[[R; 4]; 3]>::new(of, palette.joints));
        let matrices = matrices.transpose()?;
        // Only positions must be there.
        let ([from, from_normals, from_tangents], [to, to_normals, to_tangents]) =
            (self.rest, self.posed);
        let positions = self.field(from, to)?;
        let normals = self.optional(from_normals, to_normals)?;
        let tangents = self.optional(from_tangents, to_tangents)?;
        let fields = [Some(&positions), normals.as_ref(), tangents.as_ref()];
        for (kind, field) in fields.iter().enumerate() {
            let Some((_, to)) = field else { continue };
            to.apart_from(&given)?;
            to.apart_from(&joint_indices)?;
            to.apart_from(&weights)?;
            if let Some(motions) = &motions {
                to.apart_from(motions)?;
            }
            if let Some(matrices) = &matrices {
                to.apart_from(matrices)?;
            }
            for (from, _) in fields.iter().flatten() {
                to.apart_from(from)?;
            }
            for (_, other) in fields.iter().skip(kind + 1).flatten() {
                to.apart_from_output(other)?;
            }
        }
        // SAFETY: it has been made, so this was written; the rest is promised, and all that is written is apart.
        unsafe {
            let known = ptr::addr_of!((*skin).opaque).cast::<Known<R>>().read();
            let rest = Surface {
                positions: positions.0.slice(),
                normals: normals.as_ref().map(|(from, _)| from.slice()),
                tangents: tangents.as_ref().map(|(from, _)| from.slice()),
            };
            let posed = SurfaceMut {
                positions: positions.1.slice(),
                normals: normals.as_ref().map(|(_, to)| to.slice()),
                tangents: tangents.as_ref().map(|(_, to)| to.slice()),
            };
            let motions = motions.map_or(&[][..], |motions| motions.slice());
            let matrices = matrices.map_or(&[][..], |matrices| matrices.slice());
            Ok(blend(&known, motions, matrices, rest, posed)?)
        }
    }
}

/// # Safety
/// As for [`Mesh::pose`].
unsafe fn linear<R: Scalar + skinning::Weight>(
    skin: *const Skin<R>,
    matrices: *const R,
    joints: usize,
    mesh: Mesh<R>,
) -> Done {
    let palette = Palette { motions: None, matrices: Some(matrices), joints };
    // SAFETY: promised.
    unsafe {
        mesh.pose(skin, palette, |skin, _, matrices, rest, posed| {
            Backend::best().skin(skin, Linear::new(matrices), rest, posed)
        })
    }
}

/// # Safety
/// As for [`Mesh::pose`].
unsafe fn dual<R: Scalar + skinning::Weight>(
    skin: *const Skin<R>,
    motions: *const R,
    joints: usize,
    mesh: Mesh<R>,
) -> Done {
    let palette = Palette { motions: Some(motions), matrices: None, joints };
    // SAFETY: promised.
    unsafe {
        mesh.pose(skin, palette, |skin, motions, _, rest, posed| {
            Backend::best().skin(skin, DualBlend::new(motions), rest, posed)
        })
    }
}

/// # Safety
/// As for [`Mesh::pose`].
unsafe fn stretched<R: Scalar + skinning::Weight>(
    skin: *const Skin<R>,
    motions: *const R,
    stretches: *const R,
    joints: usize,
    mesh: Mesh<R>,
) -> Done {
    let palette = Palette { motions: Some(motions), matrices: Some(stretches), joints };
    // SAFETY: promised.
    unsafe {
        mesh.pose(skin, palette, |skin, motions, stretches, rest, posed| {
            Backend::best().skin(skin, Stretched::new(motions, stretches), rest, posed)
        })
    }
}

/// A function that poses a mesh with these palettes, and the generic one of that name in the file.
macro_rules! export_pose {
    ($R:ident $(#[doc = $about:literal])* $name:ident($($palette:ident),*)) => {
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
                super::$name(skin, $($palette,)* joint_count, Mesh { rest, posed, vertices })
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
            ) = Given { joints: joint_count, influences, joint_indices, weights, vertices }
                .make(skin, bad_vertex)
        }
        export_pose! { $R
            /// Poses a mesh by linear blends: each vertex by the weighted sum of `matrices`, the palette, twelve
            /// numbers per joint, row after row. Weights must sum to 1.
            ///
            /// `positions`, and `normals` and `tangents` if not null, hold three numbers per vertex; what becomes
            /// of them goes to `posed_positions`, `posed_normals` and `posed_tangents`, which must overlap nothing.
            /// `joint_count` and `vertices` are those of the skin, or it is DQ8_STATUS_LENGTH.
            linear(matrices)
        }
        export_pose! { $R
            /// As dq8_skin_linear by dual quaternion blends: each vertex by the weighted sum of `motions`, the
            /// palette, normalized, each with the sign that turns it toward that of the greatest weight. Twists
            /// keep their volume.
            dual(motions)
        }
        export_pose! { $R
            /// As dq8_skin_dual where joints scale or shear: before the motions come the weighted sums of
            /// `stretches`, matrices of twelve numbers per joint. dq8_skin_split makes both.
            stretched(motions, stretches)
        }
    };
}
for_both_numbers!(functions);

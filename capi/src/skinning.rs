//! Meshes that follow joints: a skin checked once, posed by linear or dual quaternion blends; palettes.

use crate::memory::{Input, Output};
use crate::slices::Order;
use crate::status::{Done, Status};
use core::ptr;
use dq8::skinning::{
    self, Dual, Linear, SkinningError, Stretched, Surface, SurfaceMut, matrix_palette,
    split_palette,
};
use dq8::{Backend, DualQuat, Real, Scalar};

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
    opaque: [*const R; 8],
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

/// The status of an error, and the vertex that it names.
fn fault(error: &SkinningError) -> (Status, Option<usize>) {
    match *error {
        SkinningError::NoInfluences => (Status::NoInfluences, None),
        SkinningError::JointOutOfRange { vertex, .. } => (Status::JointOutOfRange, Some(vertex)),
        SkinningError::Weight { vertex, .. } => (Status::Weight, Some(vertex)),
        SkinningError::Total { vertex, .. } => (Status::WeightSum, Some(vertex)),
        SkinningError::NotFinite { joint, .. } => (Status::NotFinite, Some(joint)),
        SkinningError::NotAffine { joint, .. } => (Status::NotAffine, Some(joint)),
        SkinningError::Shape(_) => (Status::Length, None),
        // What only a newer dq8 knows.
        _ => (Status::UnknownValue, None),
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
                let (status, vertex) = fault(&error);
                if let (Some(bad_vertex), Some(vertex)) = (bad_vertex, vertex) {
                    // SAFETY: promised, and apart.
                    unsafe { bad_vertex.write(vertex) };
                }
                return Err(status);
            }
        };
        let Self { joints, influences, joint_indices, weights, vertices } = self;
        let opaque = [ptr::null(); 8];
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

/// What poses a mesh.
struct Palette<R> {
    motions: *const R,
    /// Null for what has none.
    matrices: *const R,
    joints: usize,
}

impl<R: Scalar + skinning::Weight> Mesh<R> {
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
        let Skin { vertices, influences, joints, joint_indices, weights, opaque } =
            unsafe { skin.read() };
        if influences == 0 {
            return Err(Status::NoSkin);
        }
        let made = Given { joints, influences, joint_indices, weights, vertices };
        let (joint_indices, weights) = made.inputs()?;
        // SAFETY: it has been made, so this was written.
        let known = unsafe { ptr::addr_of!(opaque).cast::<Known<R>>().read() };
        let count = |start: *const R| if start.is_null() { 0 } else { palette.joints };
        let motions = Input::<DualQuat<R>>::new(palette.motions, count(palette.motions))?;
        let matrices = Input::<[[R; 4]; 3]>::new(palette.matrices, count(palette.matrices))?;
        let mut rest = [const { None }; 3];
        let mut posed = [const { None }; 3];
        for kind in 0..3 {
            let (from, to) = (self.rest[kind], self.posed[kind]);
            // Only positions must be there.
            if kind == 0 || !(from.is_null() && to.is_null()) {
                rest[kind] = Some(Input::<[R; 3]>::new(from, self.vertices)?);
                posed[kind] = Some(Output::<[R; 3]>::new(to, self.vertices)?);
            }
        }
        for (kind, to) in posed.iter().enumerate() {
            let Some(to) = to else { continue };
            to.apart_from(&given)?;
            to.apart_from(&joint_indices)?;
            to.apart_from(&weights)?;
            to.apart_from(&motions)?;
            to.apart_from(&matrices)?;
            for from in rest.iter().flatten() {
                to.apart_from(from)?;
            }
            for other in posed.iter().skip(kind + 1).flatten() {
                to.apart_from_output(other)?;
            }
        }
        let ([positions, normals, tangents], [to_positions, to_normals, to_tangents]) =
            (rest, posed);
        let (Some(positions), Some(to_positions)) = (positions, to_positions) else {
            return Err(Status::NullPointer);
        };
        // SAFETY: promised, and all that is written is apart.
        let (motions, matrices, rest, posed) = unsafe {
            let rest = Surface {
                positions: positions.slice(),
                normals: normals.map(|input| input.slice()),
                tangents: tangents.map(|input| input.slice()),
            };
            let posed = SurfaceMut {
                positions: to_positions.slice(),
                normals: to_normals.map(|output| output.slice()),
                tangents: to_tangents.map(|output| output.slice()),
            };
            (motions.slice(), matrices.slice(), rest, posed)
        };
        blend(&known, motions, matrices, rest, posed).map_err(|error| fault(&error).0)
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
    let palette = Palette { motions: ptr::null(), matrices, joints };
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
    let palette = Palette { motions, matrices: ptr::null(), joints };
    // SAFETY: promised.
    unsafe {
        mesh.pose(skin, palette, |skin, motions, _, rest, posed| {
            Backend::best().skin(skin, Dual::new(motions), rest, posed)
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
    let palette = Palette { motions, matrices: stretches, joints };
    // SAFETY: promised.
    unsafe {
        mesh.pose(skin, palette, |skin, motions, stretches, rest, posed| {
            Backend::best().skin(skin, Stretched::new(motions, stretches), rest, posed)
        })
    }
}

/// # Safety
/// As for [`Input::slice`] and [`Output::slice`].
unsafe fn products<R: Real>(
    models: *const R,
    inverse_binds: *const R,
    order: i32,
    matrices: *mut R,
    joints: usize,
) -> Done {
    let order = Order::known(order)?;
    let models = Input::<[[R; 4]; 4]>::new(models, joints)?;
    let inverse_binds = Input::<[[R; 4]; 4]>::new(inverse_binds, joints)?;
    let matrices = Output::<[[R; 4]; 3]>::new(matrices, joints)?;
    matrices.apart_from(&models)?;
    matrices.apart_from(&inverse_binds)?;
    // SAFETY: promised, and apart.
    unsafe {
        matrix_palette(models.slice(), inverse_binds.slice(), order, matrices.slice())
            .map_err(|error| fault(&error).0)
    }
}

/// # Safety
/// As for [`Input::slice`] and [`Output::slice`].
unsafe fn split<R: Real>(
    matrices: *const R,
    motions: *mut R,
    stretches: *mut R,
    joints: usize,
) -> Done {
    let matrices = Input::<[[R; 4]; 3]>::new(matrices, joints)?;
    let motions = Output::<DualQuat<R>>::new(motions, joints)?;
    let stretches = Output::<[[R; 4]; 3]>::new(stretches, joints)?;
    motions.apart_from(&matrices)?;
    stretches.apart_from(&matrices)?;
    stretches.apart_from_output(&motions)?;
    // SAFETY: promised, and apart.
    let split = unsafe { split_palette(matrices.slice(), motions.slice(), stretches.slice()) };
    split.map(|_| ()).map_err(|error| fault(&error).0)
}

/// A function on a skin, whose body is what it returns inside.
macro_rules! export_skin {
    (
        $R:ident
        $(#[doc = $about:literal])*
        $name:ident($($argument:ident: $type:ty),* $(,)?) = $body:expr
    ) => {
        $(#[doc = $about])*
        ///
        /// # Safety
        /// Arrays have the lengths named, and skins are zero or have been made.
        #[unsafe(export_name = concat!("dq8_skin_", stringify!($name), "_", stringify!($R)))]
        #[expect(clippy::allow_attributes, reason = "not every function has so many")]
        #[allow(clippy::too_many_arguments, reason = "one a line of the C function")]
        pub unsafe extern "C" fn $name($($argument: $type),*) -> Status {
            // SAFETY: promised.
            Status::of(unsafe { $body })
        }
    };
}

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export_skin! { $R
            /// Checks which joints move each vertex and how much, once; the functions that pose the mesh then
            /// only compute. `joint_indices` and `weights` hold `influences` numbers of the first vertex, then
            /// those of the next; influences that a vertex does not have are any joint with weight 0. The skin
            /// keeps using both: they must stay where they are, as they are.
            ///
            /// DQ8_STATUS_JOINT_OUT_OF_RANGE, _WEIGHT or _WEIGHT_SUM; `bad_vertex`, which may be null, is set to
            /// that vertex. DQ8_STATUS_NO_INFLUENCES if `influences` is 0. The skin has then not been written.
            make(
                joint_count: usize, influences: usize, joint_indices: *const u16,
                weights: *const $R, vertices: usize, skin: *mut Skin<$R>, bad_vertex: *mut usize,
            ) = Given { joints: joint_count, influences, joint_indices, weights, vertices }
                .make(skin, bad_vertex)
        }
        export_skin! { $R
            /// Poses a mesh by linear blends: each vertex by the weighted sum of `matrices`, the palette, twelve
            /// numbers a joint, row after row. Weights must sum to 1.
            ///
            /// `positions`, and `normals` and `tangents` if not null, hold three numbers a vertex; what becomes of
            /// them goes to `posed_positions`, `posed_normals` and `posed_tangents`, which must overlap nothing.
            /// `joint_count` and `vertices` are those of the skin, or it is DQ8_STATUS_LENGTH.
            linear(
                skin: *const Skin<$R>, matrices: *const $R, joint_count: usize,
                positions: *const $R, normals: *const $R, tangents: *const $R,
                posed_positions: *mut $R, posed_normals: *mut $R, posed_tangents: *mut $R,
                vertices: usize,
            ) = {
                let rest = [positions, normals, tangents];
                let posed = [posed_positions, posed_normals, posed_tangents];
                super::linear(skin, matrices, joint_count, Mesh { rest, posed, vertices })
            }
        }
        export_skin! { $R
            /// As dq8_skin_linear by dual quaternion blends: each vertex by the weighted sum of `motions`, the
            /// palette, normalized, each with the sign that turns it toward that of the greatest weight. Twists
            /// keep their volume.
            dual(
                skin: *const Skin<$R>, motions: *const $R, joint_count: usize,
                positions: *const $R, normals: *const $R, tangents: *const $R,
                posed_positions: *mut $R, posed_normals: *mut $R, posed_tangents: *mut $R,
                vertices: usize,
            ) = {
                let rest = [positions, normals, tangents];
                let posed = [posed_positions, posed_normals, posed_tangents];
                super::dual(skin, motions, joint_count, Mesh { rest, posed, vertices })
            }
        }
        export_skin! { $R
            /// As dq8_skin_dual where joints scale or shear: before the motions come the weighted sums of
            /// `stretches`, matrices of twelve numbers a joint. dq8_skin_split makes both.
            stretched(
                skin: *const Skin<$R>, motions: *const $R, stretches: *const $R, joint_count: usize,
                positions: *const $R, normals: *const $R, tangents: *const $R,
                posed_positions: *mut $R, posed_normals: *mut $R, posed_tangents: *mut $R,
                vertices: usize,
            ) = {
                let rest = [positions, normals, tangents];
                let posed = [posed_positions, posed_normals, posed_tangents];
                super::stretched(skin, motions, stretches, joint_count, Mesh { rest, posed, vertices })
            }
        }
        export_skin! { $R
            /// A palette of matrices, `matrices[j] = models[j] * inverse_binds[j]`: from 4x4 matrices in `order`, one
            /// of enum dq8_matrix_order, to twelve numbers a joint, row after row.
            ///
            /// DQ8_STATUS_NOT_FINITE or _NOT_AFFINE if a matrix is.
            products(
                models: *const $R, inverse_binds: *const $R, order: i32, matrices: *mut $R,
                joint_count: usize,
            ) = super::products(models, inverse_binds, order, matrices, joint_count)
        }
        export_skin! { $R
            /// Takes the matrices of a palette apart into stretches and, after them, unit motions: what
            /// dq8_skin_stretched takes. DQ8_STATUS_NOT_FINITE if a number is not finite.
            split(
                matrices: *const $R, motions: *mut $R, stretches: *mut $R, joint_count: usize,
            ) = super::split(matrices, motions, stretches, joint_count)
        }
    };
}
for_both_numbers!(functions);

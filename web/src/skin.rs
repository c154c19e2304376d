//! Meshes that follow joints.

use crate::Motion;
use crate::error::{made, status};
use crate::linear::{ByColumns, Packed, Row};
use crate::memory::{exports, frees, slice, slice_mut};
use dq8::hierarchy::MatrixOrder;
use dq8::skinning::{Blender, DualBlend, Linear, Mixed, Skin, SkinningError, Surface, SurfaceMut};
use dq8::{Backend, ShapeError};

/// A skin and what it was made of, which nobody else can write to: it is trusted once it has been
/// checked.
#[derive(Debug)]
struct OwnedSkin {
    _joints: Box<[u16]>,
    _weights: Box<[f32]>,
    /// What linear blends read, made of the motions.
    matrices: Vec<Row>,
    columns: Vec<Packed>,
    /// Borrows the two boxes, which stay where they are for as long as this lives.
    skin: Skin<'static, u16, f32>,
}

impl OwnedSkin {
    fn new(
        joint_count: usize,
        influences: usize,
        joints: &[u16],
        weights: &[f32],
    ) -> Result<Self, SkinningError> {
        let (joints, weights): (Box<[u16]>, Box<[f32]>) = (joints.into(), weights.into());
        // SAFETY: both live, unwritten, until `self` is dropped, and the skin is not handed out for
        // longer.
        let lasting = unsafe {
            (slice(joints.as_ptr(), joints.len()), slice(weights.as_ptr(), weights.len()))
        };
        let skin = Skin::new(joint_count, influences, lasting.0, lasting.1)?;
        let (matrices, columns) = (Vec::new(), Vec::new());
        Ok(Self { _joints: joints, _weights: weights, matrices, columns, skin })
    }
}

frees!(dq8_skin_free: OwnedSkin);
exports! {
    fn dq8_skin(
        joint_count: usize, influences: usize; joints[joint_length]: u16, weights[weight_length]: f32;
    ) -> *mut OwnedSkin {
        made(OwnedSkin::new(joint_count, influences, joints, weights))
    }

    /// Poses by dual quaternions (0), linearly (1) or by a mix of them (2).
    fn dq8_skin_pose(
        skin: &mut OwnedSkin, blend: u32, mesh: &Mesh; motions[motion_count]: Motion, shares[share_count]: f32;
    ) -> u32 {
        status(pose(skin, blend, mesh, motions, shares))
    }
}

/// Where a mesh is and where it goes.
#[repr(C)]
struct Mesh {
    rest: *const [f32; 3],
    rest_count: usize,
    posed: *mut [f32; 3],
    posed_count: usize,
    /// Null where there are none.
    normals: *const [f32; 3],
    normal_count: usize,
    posed_normals: *mut [f32; 3],
    posed_normal_count: usize,
}

impl Mesh {
    /// # Safety
    /// All that is named is there, and what is posed lies apart.
    unsafe fn pose<B: Blender<f32>>(
        &self,
        skin: &Skin<'_, u16, f32>,
        blend: B,
    ) -> Result<(), SkinningError> {
        // SAFETY: promised.
        unsafe {
            let from = Surface::positions(slice(self.rest, self.rest_count));
            let to = SurfaceMut::positions(slice_mut(self.posed, self.posed_count));
            if self.normals.is_null() {
                return skin.pose(blend, from, to);
            }
            let from = from.normals(slice(self.normals, self.normal_count));
            let to = to.normals(slice_mut(self.posed_normals, self.posed_normal_count));
            skin.pose(blend, from, to)
        }
    }
}

/// The motions of the joints as linear blends read them.
fn rows(motions: &[Motion], matrices: &mut Vec<Row>) -> Result<(), ShapeError> {
    matrices.resize(motions.len(), Row::default());
    Backend::best().matrices(motions, MatrixOrder::Rows, matrices)
}

/// Poses a mesh of positions alone, of four influences, linearly. Returns `None` for others, and
/// for what does not fit, which is an error of the other way.
fn by_columns(owned: &mut OwnedSkin, mesh: &Mesh) -> Option<()> {
    if !mesh.normals.is_null() {
        return None;
    }
    let OwnedSkin { skin, matrices, columns, .. } = owned;
    // SAFETY: what the mesh names is there, and what is posed lies apart.
    let (rest, posed) =
        unsafe { (slice(mesh.rest, mesh.rest_count), slice_mut(mesh.posed, mesh.posed_count)) };
    Backend::best().run(ByColumns::new(skin, matrices, columns, rest, posed)?);
    Some(())
}

fn pose(
    owned: &mut OwnedSkin,
    blend: u32,
    mesh: &Mesh,
    motions: &[Motion],
    shares: &[f32],
) -> Result<(), SkinningError> {
    let dual = DualBlend::new(motions);
    // SAFETY: what the mesh names is there, and what is posed lies apart, as the package promises.
    unsafe {
        if blend == 0 {
            return mesh.pose(&owned.skin, dual);
        }
        rows(motions, &mut owned.matrices)?;
        if blend == 1 && by_columns(owned, mesh).is_some() {
            return Ok(());
        }
        let rows = Linear::new(&owned.matrices);
        if blend == 1 {
            return mesh.pose(&owned.skin, rows);
        }
        mesh.pose(&owned.skin, Mixed::new(rows, dual, shares)?)
    }
}

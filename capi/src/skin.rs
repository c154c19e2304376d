//! [`Skin`]: the joints and weights of a mesh, which are checked once.

use crate::memory::{Input, Output};
use crate::span::{Span, disjoint};
use crate::status::{Done, Status};
use core::mem::MaybeUninit;
use core::ptr;
use dq8::skinning::{self, SkinningError};
use dq8::{DualQuat, Scalar};

/// The layout of the joint indices, or of the weights, in an array that holds one vertex after the
/// other. Both fields of this struct count elements of the array, not bytes.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct InfluenceField {
    /// The distance from the beginning of a vertex to the beginning of the next vertex.
    pub stride: usize,
    /// The offset of the first joint index, or of the first weight, in a vertex.
    pub first: usize,
}

/// The joints and weights that move the vertices of a mesh, made by dq8_skin_make. This struct may
/// be copied and moved. It points to the arrays of joint indices and weights, which must stay where
/// they are and must not change.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct Skin<R> {
    /// The number of vertices of the mesh.
    pub vertices: usize,
    /// The number of influences of each vertex, which are its joints with their weights. It is 0 in
    /// a zeroed struct that dq8_skin_make has not filled in.
    pub influences: usize,
    /// The number of joints, which is the number of entries of a palette.
    pub joints: usize,
    /// Private to the library.
    // The bytes of a `Known<R>`, if `influences` is not 0. Some of these bytes are padding, which
    // is uninitialised.
    opaque: [MaybeUninit<*const R>; 8],
}

pub(crate) type Known<R> = skinning::Skin<'static, u16, R>;

/// Asserts that a [`Known`] fits into the field `opaque` of a [`Skin`].
macro_rules! fits {
    ($($R:ident)*) => {$(const _: () = {
        assert!(size_of::<Known<$R>>() <= 8 * size_of::<*const ()>());
        assert!(align_of::<Known<$R>>() <= align_of::<*const ()>());
    };)*};
}
fits! { f32 f64 }

/// Returns the index of the vertex that an error names, if it names a vertex.
fn vertex_of(error: &SkinningError) -> Option<usize> {
    match *error {
        SkinningError::JointOutOfRange { vertex, .. }
        | SkinningError::Weight { vertex, .. }
        | SkinningError::Total { vertex, .. } => Some(vertex),
        _ => None,
    }
}

/// The arguments from which a skin is made, as C passes them. `joints` is the number of joints.
pub(crate) struct SkinParts<R> {
    pub(crate) joints: usize,
    pub(crate) influences: usize,
    pub(crate) joint_indices: *const u16,
    pub(crate) joint_field: InfluenceField,
    pub(crate) weights: *const R,
    pub(crate) weight_field: InfluenceField,
    pub(crate) vertices: usize,
}

impl<R: Scalar + skinning::Weight> SkinParts<R> {
    /// # Safety
    /// Both arrays must hold `stride` elements per vertex, which must not change while the skin is
    /// used. No other thread may use the outputs during the call.
    pub(crate) unsafe fn make(self, skin: *mut Skin<R>, bad_vertex: *mut usize) -> Done {
        let Self {
            joints,
            influences,
            joint_indices,
            joint_field,
            weights,
            weight_field,
            vertices,
        } = self;
        let count =
            |field: InfluenceField| vertices.checked_mul(field.stride).ok_or(Status::TooLarge);
        let joint_indices = Input::<u16>::new(joint_indices, count(joint_field)?)?;
        let weights = Input::<R>::new(weights, count(weight_field)?)?;
        let made = Output::<Skin<R>>::new(skin, 1)?;
        let bad_vertex = Output::<usize>::unless_null(bad_vertex)?;
        disjoint(&[made.span, bad_vertex.span], &[joint_indices.span, weights.span])?;
        // SAFETY: the caller guarantees that both arrays have `stride` elements per vertex, which
        // do not change while the skin is used, so they may be borrowed for `'static`.
        let (joint_indices, weights) = unsafe { (joint_indices.slice(), weights.slice()) };
        let field = |InfluenceField { stride, first }| skinning::InfluenceField { stride, first };
        let (by, how_much) = ((joint_indices, field(joint_field)), (weights, field(weight_field)));
        let known: Known<R> = match skinning::Skin::interleaved(joints, influences, by, how_much) {
            Ok(known) => known,
            Err(error) => {
                if let Some(vertex) = vertex_of(&error) {
                    // SAFETY: the caller guarantees that `bad_vertex` is null or points to a
                    // `usize`, and `disjoint` has checked that it overlaps no other array.
                    unsafe { bad_vertex.write(vertex) };
                }
                return Err(error.into());
            }
        };
        let opaque = [const { MaybeUninit::uninit() }; 8];
        // SAFETY: the caller guarantees that `skin` points to a `Skin`, and `disjoint` has checked
        // that it overlaps no other array. `opaque` has the size and alignment of a `Known`, as
        // `fits` asserts.
        unsafe {
            made.write(Skin { vertices, influences, joints, opaque });
            ptr::addr_of_mut!((*skin).opaque).cast::<Known<R>>().write(known);
        }
        Ok(())
    }
}

/// The inputs that pose a mesh: a skin and the palettes of a blend. Their pointers have been
/// checked.
pub(crate) struct Posing<R: 'static> {
    known: Known<R>,
    /// The memory of all inputs, which no output may overlap.
    pub(crate) spans: [Span; 6],
    motions: Input<DualQuat<R>>,
    matrices: Input<[[R; 4]; 3]>,
    shares: Input<R>,
}

/// The pointers to the palettes of a blend, with `None` for palettes that the blend does not need.
pub(crate) struct Pointers<R> {
    /// Motions, of eight components per joint.
    pub(crate) motions: Option<*const R>,
    /// Matrices or stretches, of twelve components per joint.
    pub(crate) matrices: Option<*const R>,
    /// Shares of a mix, one per vertex, and the number of vertices of the mesh. If the skin has
    /// another number of vertices, posing the mesh returns an error.
    pub(crate) shares: Option<(*const R, usize)>,
}

impl<R> Pointers<R> {
    pub(crate) const NOTHING: Self = Self { motions: None, matrices: None, shares: None };
}

/// The palettes of a blend, with empty slices for palettes that the blend does not need.
pub(crate) struct Palettes<'p, R> {
    pub(crate) motions: &'p [DualQuat<R>],
    pub(crate) matrices: &'p [[[R; 4]; 3]],
    pub(crate) shares: &'p [R],
}

impl<R: Scalar + skinning::Weight> Posing<R> {
    /// # Safety
    /// The skin must be zeroed, or made by dq8_skin_make, and then its arrays must be unchanged.
    pub(crate) unsafe fn new(
        skin: *const Skin<R>,
        joints: usize,
        Pointers { motions, matrices, shares }: Pointers<R>,
    ) -> Result<Self, Status> {
        let given = Span::of(skin, 1)?;
        // SAFETY: `Span::of` has checked that the pointer is neither null nor misaligned. The
        // caller guarantees that it points to a skin that is zeroed or made.
        if unsafe { ptr::addr_of!((*skin).influences).read() } == 0 {
            return Err(Status::NoSkin);
        }
        // SAFETY: `influences` is not 0, so the skin has been made, and `opaque` holds a `Known`.
        let known = unsafe { ptr::addr_of!((*skin).opaque).cast::<Known<R>>().read() };
        // The lengths come from `known`, which the kernel reads, because C may have changed the
        // public fields of the skin.
        let (indices, weights) = (known.joints(), known.weights());
        let indices = Span::of(indices.as_ptr(), indices.len())?;
        let weights = Span::of(weights.as_ptr(), weights.len())?;
        let palette = |of: Option<*const R>| of.map_or((ptr::null(), 0), |of| (of, joints));
        let ((motions, motion_count), (matrices, matrix_count)) =
            (palette(motions), palette(matrices));
        let (shares, share_count) = shares.unwrap_or((ptr::null(), 0));
        let motions = Input::<DualQuat<R>>::new(motions, motion_count)?;
        let matrices = Input::<[[R; 4]; 3]>::new(matrices, matrix_count)?;
        let shares = Input::<R>::new(shares, share_count)?;
        let spans = [given, indices, weights, motions.span, matrices.span, shares.span];
        Ok(Self { known, spans, motions, matrices, shares })
    }

    /// Returns the skin, and its palettes as slices.
    ///
    /// # Safety
    /// The arrays of the skin must be unchanged since it was made. Each palette must have as many
    /// elements as its input counts, and no other thread may write them while `'p` lasts.
    pub(crate) unsafe fn borrow<'p>(&self) -> (Known<R>, Palettes<'p, R>) {
        // SAFETY: the caller guarantees that each palette has as many elements as its input counts,
        // and that no other thread writes them.
        unsafe {
            let (motions, matrices) = (self.motions.slice(), self.matrices.slice());
            (self.known, Palettes { motions, matrices, shares: self.shares.slice() })
        }
    }
}

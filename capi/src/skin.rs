//! A skin as C keeps it, and what it is made of.

use crate::memory::{Input, Output};
use crate::span::{Span, apart};
use crate::status::{Done, Status};
use core::mem::MaybeUninit;
use core::ptr;
use dq8::skinning::{self, SkinningError};
use dq8::{DualQuat, Scalar};

/// Where the joints of a vertex lie in an array that holds one vertex after the other, or its
/// weights; counted in elements of their own type.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct InfluenceField {
    /// From a vertex to the next.
    pub stride: usize,
    /// Where in a vertex the field begins.
    pub first: usize,
}

/// Which joints move the vertices of a mesh, and how much. It may be copied and moved; the joints
/// and weights that it was made of must stay where they are, as they are.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct Skin<R> {
    /// How many vertices it has.
    pub vertices: usize,
    /// How many influences every vertex has. 0 in a skin that has not been made, if it was zeroed.
    pub influences: usize,
    /// How many joints its palettes have.
    pub joints: usize,
    /// Not for you.
    // A `Known<R>`, some of whose bytes are padding and so nothing at all.
    opaque: [MaybeUninit<*const R>; 8],
}

pub(crate) type Known<R> = skinning::Skin<'static, u16, R>;

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
pub(crate) struct Given<R> {
    pub(crate) joints: usize,
    pub(crate) influences: usize,
    pub(crate) joint_indices: *const u16,
    pub(crate) joint_field: InfluenceField,
    pub(crate) weights: *const R,
    pub(crate) weight_field: InfluenceField,
    pub(crate) vertices: usize,
}

impl<R: Scalar + skinning::Weight> Given<R> {
    /// # Safety
    /// As for [`Input::slice`] and [`Output::write`]; joints and weights stay as they are.
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
        apart(&[made.span, bad_vertex.span], &[joint_indices.span, weights.span])?;
        // SAFETY: promised; what is made lives as long as C keeps them.
        let (joint_indices, weights) = unsafe { (joint_indices.slice(), weights.slice()) };
        let field = |InfluenceField { stride, first }| skinning::InfluenceField { stride, first };
        let (by, how_much) = ((joint_indices, field(joint_field)), (weights, field(weight_field)));
        let known: Known<R> = match skinning::Skin::interleaved(joints, influences, by, how_much) {
            Ok(known) => known,
            Err(error) => {
                if let Some(vertex) = vertex_of(&error) {
                    // SAFETY: promised, and apart.
                    unsafe { bad_vertex.write(vertex) };
                }
                return Err(error.into());
            }
        };
        let opaque = [const { MaybeUninit::uninit() }; 8];
        // SAFETY: promised, and apart; a skin of the library fits, by `fits`.
        unsafe {
            made.write(Skin { vertices, influences, joints, opaque });
            ptr::addr_of_mut!((*skin).opaque).cast::<Known<R>>().write(known);
        }
        Ok(())
    }
}

/// What poses a mesh, found where C says it is: a skin, and what its blend needs.
pub(crate) struct Posing<R: 'static> {
    known: Known<R>,
    /// Nothing that is written may overlap these.
    pub(crate) spans: [Span; 6],
    motions: Input<DualQuat<R>>,
    matrices: Input<[[R; 4]; 3]>,
    shares: Input<R>,
}

/// What the blends of a mesh need, where C says it is; `None` if this one does not need it.
pub(crate) struct By<R> {
    /// Eight numbers per joint.
    pub(crate) motions: Option<*const R>,
    /// Twelve numbers per joint.
    pub(crate) matrices: Option<*const R>,
    /// A number for each of so many vertices of the mesh, which may not be those of the skin.
    pub(crate) shares: Option<(*const R, usize)>,
}

impl<R> By<R> {
    pub(crate) const NOTHING: Self = Self { motions: None, matrices: None, shares: None };
}

/// [`By`], found; empty if not needed.
pub(crate) struct Palettes<'p, R> {
    pub(crate) motions: &'p [DualQuat<R>],
    pub(crate) matrices: &'p [[[R; 4]; 3]],
    pub(crate) shares: &'p [R],
}

impl<R: Scalar + skinning::Weight> Posing<R> {
    /// # Safety
    /// The skin is zero, or has been made, and what it was made of is as it was.
    pub(crate) unsafe fn new(
        skin: *const Skin<R>,
        joints: usize,
        By { motions, matrices, shares }: By<R>,
    ) -> Result<Self, Status> {
        let given = Span::of(skin, 1)?;
        // SAFETY: neither null nor misaligned, by `Span::of`; the rest is promised.
        if unsafe { ptr::addr_of!((*skin).influences).read() } == 0 {
            return Err(Status::NoSkin);
        }
        // SAFETY: it has been made, so this was written.
        let known = unsafe { ptr::addr_of!((*skin).opaque).cast::<Known<R>>().read() };
        // What the kernel reads, whatever has become of the numbers that C sees.
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

    /// The skin and its palettes.
    ///
    /// # Safety
    /// As for [`new`](Self::new) and [`Input::slice`].
    pub(crate) unsafe fn borrow<'p>(&self) -> (Known<R>, Palettes<'p, R>) {
        // SAFETY: promised.
        unsafe {
            let (motions, matrices) = (self.motions.slice(), self.matrices.slice());
            (self.known, Palettes { motions, matrices, shares: self.shares.slice() })
        }
    }
}

//! [`Skin`], the joints and weights of each vertex, which are checked once, and the functions with
//! which the loop reads them.

use super::SkinningError;
use crate::macros::brief;
use crate::number::{Real, Scalar};
use crate::storage::shape::{same_length, whole_instances};
use core::fmt::Debug;
use core::hint::black_box;
use core::ops::RangeInclusive;
use dq8_simd::MAX_LANES;
use dq8_simd::internal::{CheckedIndices, Index, PickRows, PickedInPlace, Picks};

/// The joints that move each vertex and their weights. A skin is checked once, and then poses
/// meshes any number of times.
///
/// `joints` holds the joints of the first vertex, then the joints of the second vertex, and so on,
/// the same number for each vertex. `weights` holds the weights in the same order. Fill unused
/// influences with any joint and weight 0. Joints are `u8`, `u16` or `u32`; for the types of
/// weights see [`Weight`].
///
/// ```
/// use dq8::skinning::{Skin, SkinningError};
/// let weights = [1.0_f32, 0.0, 0.5, 0.5];
/// assert_eq!(Skin::new(3, 2, &[0_u16, 0, 1, 2], &weights)?.vertices(), 2);
/// let error = Skin::new(2, 2, &[0_u16, 0, 1, 2], &weights).unwrap_err();
/// let (vertex, influence) = (1, 1);
/// let expected = SkinningError::JointOutOfRange { vertex, influence, joint: 2, joints: 2 };
/// assert_eq!(error, expected);
/// # Ok::<(), SkinningError>(())
/// ```
#[derive(Clone, Copy)]
#[doc(alias("SkinningJob"))]
pub struct Skin<'a, J, W> {
    joints: CheckedIndices<'a, J>,
    /// The weights, from the first weight of the first vertex on.
    weights: &'a [W],
    /// The number of weights from a vertex to the next. It is less than the number of influences if
    /// the last weight is implied.
    stride: usize,
}

brief!([J: Index, W: Weight] Skin<'_, J, W>: Skin |it| {
    vertices: it.vertices(), influences: it.influences(), joints: it.joint_count(),
});

impl<'a, J: Index, W: Weight> Skin<'a, J, W> {
    /// The range that the sum of a vertex's weights must lie in. The sum should be one: dual
    /// quaternion blends divide by the sum, linear blends do not.
    pub const WEIGHT_RANGE: RangeInclusive<f64> = 1.0 / 1024.0..=1024.0;

    /// Makes a skin for a palette of `joint_count` joints, where `influences` joints move each
    /// vertex.
    ///
    /// # Errors
    /// If the slices do not fit, a joint is out of range, a weight is negative or not finite, or
    /// the weights of a vertex do not sum to [about one](Self::WEIGHT_RANGE). The error names the
    /// vertex.
    pub fn new(
        joint_count: usize,
        influences: usize,
        joints: &'a [J],
        weights: &'a [W],
    ) -> Result<Self, SkinningError> {
        same_length("weights", weights.len(), joints.len())?;
        Self::packed(joint_count, influences, joints, weights, influences)
    }

    /// Makes a skin as [`new`](Self::new) does, from one weight less for each vertex. The last
    /// weight of a vertex is one minus the sum of its other weights.
    ///
    /// # Errors
    /// The errors of [`new`](Self::new), and an error if the weights of a vertex sum to more than
    /// one.
    pub fn with_implied_weight(
        joint_count: usize,
        influences: usize,
        joints: &'a [J],
        weights: &'a [W],
    ) -> Result<Self, SkinningError> {
        let Some(given) = influences.checked_sub(1) else {
            return Err(SkinningError::NoInfluences);
        };
        same_length("weights", weights.len(), joints.len() / influences * given)?;
        Self::packed(joint_count, influences, joints, weights, given)
    }

    /// Makes a skin of joints and weights without other fields between the vertices. Each vertex
    /// has `influences` joints and `given` weights.
    fn packed(
        palette: usize,
        influences: usize,
        joints: &'a [J],
        weights: &'a [W],
        given: usize,
    ) -> Result<Self, SkinningError> {
        if influences == 0 {
            return Err(SkinningError::NoInfluences);
        }
        whole_instances("joints", influences, joints.len())?;
        Self::checked(palette, influences, (joints, influences), (weights, given))
    }

    /// Checks the joints and the weights, and makes a skin of them. Each slice comes with its
    /// stride, the number of elements from a vertex to the next.
    pub(super) fn checked(
        palette: usize,
        influences: usize,
        (joints, joint_stride): (&'a [J], usize),
        (weights, stride): (&'a [W], usize),
    ) -> Result<Self, SkinningError> {
        let found = CheckedIndices::new(joints, influences, joint_stride, palette);
        let joints = found.map_err(|(vertex, influence)| {
            let joint = joints.get(vertex * joint_stride + influence);
            let joint = joint.map_or(0, |&joint| joint.into());
            SkinningError::JointOutOfRange { vertex, influence, joint, joints: palette }
        })?;
        let skin = Self { joints, weights, stride };
        for vertex in 0..skin.vertices() {
            skin.check_weights(vertex)?;
        }
        Ok(skin)
    }

    fn check_weights(&self, vertex: usize) -> Result<(), SkinningError> {
        let mut total = 0.0;
        for influence in 0..self.given() {
            let value: f64 = self.given_weight(vertex, influence);
            if !(value >= 0.0 && value.is_finite()) {
                return Err(SkinningError::Weight { vertex, influence, value });
            }
            total += value;
        }
        // The sum of seven weights, each rounded to eight bits, exceeds one by at most 7 · ½/255.
        let right = if self.implied() {
            total <= 1.0 + 1.0 / 64.0
        } else {
            Self::WEIGHT_RANGE.contains(&total)
        };
        if right { Ok(()) } else { Err(SkinningError::Total { vertex, total }) }
    }

    /// Returns the joints of all vertices, from the first joint of the first vertex on, including
    /// other fields that lie between the joints of two vertices.
    #[must_use]
    pub fn joints(&self) -> &'a [J] {
        self.joints.indices()
    }

    /// Returns the weights of all vertices, from the first weight of the first vertex on, including
    /// other fields that lie between the weights of two vertices.
    #[must_use]
    pub fn weights(&self) -> &'a [W] {
        self.weights
    }

    /// The number of vertices.
    #[must_use]
    pub fn vertices(&self) -> usize {
        self.joints.rows()
    }

    /// The number of influences of every vertex.
    #[must_use]
    pub fn influences(&self) -> usize {
        self.joints.columns()
    }

    /// Returns `true` if the last weight of a vertex is not given but is one minus the sum of its
    /// other weights.
    fn implied(&self) -> bool {
        self.stride < self.influences()
    }

    /// The number of joints of the palette.
    #[must_use]
    pub fn joint_count(&self) -> usize {
        self.joints.bound()
    }

    /// Returns the joint and the weight of an influence of a vertex, or `None` if there is no such
    /// influence.
    #[must_use]
    pub fn influence<R: Real>(&self, vertex: usize, influence: usize) -> Option<(u32, R)> {
        let joint = *self.joints.row(vertex).get(influence)?;
        Some((joint.into(), self.weight(vertex, influence)))
    }

    /// Returns the index of the influence with the greatest weight of a vertex, or of the first
    /// such influence if several weights are equal.
    fn pivot<R: Real>(&self, vertex: usize) -> usize {
        let (mut pivot, mut greatest) = (0, self.weight::<R>(vertex, 0));
        for influence in 1..self.influences() {
            let weight = self.weight(vertex, influence);
            if weight > greatest {
                (pivot, greatest) = (influence, weight);
            }
        }
        pivot
    }

    /// Returns the number of weights that are given for each vertex.
    fn given(&self) -> usize {
        self.stride.min(self.influences())
    }

    fn given_weight<R: Real>(&self, vertex: usize, influence: usize) -> R {
        self.weights.get(vertex * self.stride + influence).map_or(R::ZERO, |w| w.value())
    }

    #[inline]
    fn weight<R: Real>(&self, vertex: usize, influence: usize) -> R {
        if influence < self.given() {
            return self.given_weight(vertex, influence);
        }
        let left = (0..influence).fold(R::ONE, |left, i| left - self.given_weight::<R>(vertex, i));
        // Rounding may make the difference negative.
        if left > R::ZERO { left } else { R::ZERO }
    }
}

/// The type of a weight in memory. `f32` and `f64` have their own value. `u8` and `u16` are
/// normalized, so that the largest integer is exactly 1 (glTF 2.0, §3.11; Vulkan's `UNORM`).
///
/// ```
/// use dq8::skinning::Weight;
/// assert_eq!([0_u8, 51, 255].map(|weight| weight.value::<f32>()), [0.0, 0.2, 1.0]);
/// ```
pub trait Weight: Copy + Debug + Send + Sync + 'static {
    /// Returns the weight as a value of type `R`.
    #[must_use]
    fn value<R: Real>(self) -> R;

    /// Returns the weights as a slice of `R` if they lie in memory as the type that kernels compute
    /// with.
    #[doc(hidden)]
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    fn as_numbers<R: Scalar>(weights: &[Self]) -> Option<&[R]> {
        let _ = weights;
        None
    }
}

impl Weight for f32 {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn value<R: Real>(self) -> R {
        R::from(self)
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn as_numbers<R: Scalar>(weights: &[Self]) -> Option<&[R]> {
        if R::SINGLE { bytemuck::try_cast_slice(weights).ok() } else { None }
    }
}

impl Weight for f64 {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn value<R: Real>(self) -> R {
        R::from_f64(self)
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn as_numbers<R: Scalar>(weights: &[Self]) -> Option<&[R]> {
        if R::SINGLE { None } else { bytemuck::try_cast_slice(weights).ok() }
    }
}

// The weight is divided by 255 and not multiplied by 1/255, because 255 · (1/255) need not be 1.
impl Weight for u8 {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn value<R: Real>(self) -> R {
        R::from(f32::from(self)) / R::from(255.0)
    }
}

impl Weight for u16 {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn value<R: Real>(self) -> R {
        R::from(f32::from(self)) / R::from(65535.0)
    }
}

/// The stride and the offset of the joints, or of the weights, in a buffer that holds one vertex
/// after the other. Both count elements of the buffer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct InfluenceField {
    /// The distance from the beginning of a vertex to the beginning of the next.
    pub stride: usize,
    /// The offset of the field in a vertex.
    pub first: usize,
}

impl InfluenceField {
    /// Returns the buffer from the field of the first vertex on, and the number of its vertices.
    fn check<'b, T>(
        self,
        what: &'static str,
        influences: usize,
        buffer: &'b [T],
    ) -> Result<(&'b [T], usize), SkinningError> {
        let Self { stride, first } = self;
        // The condition is not written as `first + influences > stride`, because the sum may wrap.
        if stride < influences || first > stride - influences {
            return Err(SkinningError::InfluenceField { what, first, stride, influences });
        }
        let vertices = whole_instances(what, stride, buffer.len())?;
        Ok((buffer.get(first..).unwrap_or_default(), vertices))
    }
}

impl<'a, J: Index, W: Weight> Skin<'a, J, W> {
    /// Makes a skin as [`new`](Self::new) does, of joints and weights that lie between other
    /// fields: the attributes of a glTF file with a `byteStride`, or the vertex buffer of a GPU.
    /// `joints` and `weights` are each a slice of elements and the place of the field in it. The
    /// slices may be two views of the same bytes (`bytemuck::cast_slice`). A stride or an offset in
    /// bytes is divided by the size of an element to count elements.
    ///
    /// The skin borrows the slices, so the posed mesh must be written to another buffer.
    ///
    /// # Errors
    /// If a field lies beyond its vertex, or the buffers do not hold whole vertices or differ in
    /// their number; and the errors of [`new`](Self::new).
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

/// The number of influences of a vertex in a group, which is read at once.
pub(super) const GROUP: usize = dq8_simd::internal::RECORDS_PER_LANE;

/// One group of influences of the vertices of one register, in the form that kernels read for all
/// types of joints and weights in memory. Influences that a vertex does not have are filled in with
/// weight 0.
#[derive(Debug)]
pub(super) struct Influences<'a, R, J> {
    /// The joints of each lane in the memory of the skin, if they adjoin there in groups of four.
    pub(super) in_place: Option<PickRows<'a, J>>,
    /// Copies of the joints of each lane, if the joints do not adjoin in the memory of the skin.
    pub(super) joints: Picks<'a, J>,
    /// The weights of each lane in the memory of the skin, if they adjoin there and have the type
    /// `R`.
    pub(super) weights_in_place: Option<&'a [[R; GROUP]; MAX_LANES]>,
    pub(super) weights: Aligned<[[R; GROUP]; MAX_LANES]>,
    /// The joint of greatest weight, as the first index of each lane, if a vertex has more than one
    /// group of influences.
    pub(super) pivots: Option<Picks<'a, J>>,
}

/// Memory that kernels use again for each register of vertices.
#[derive(Debug)]
pub struct Scratch<'a, R, J> {
    pub(super) influences: Influences<'a, R, J>,
    /// The twelve entries of the weighted sum of matrices, for each lane. An array has sixteen
    /// elements, because sixteen `f32` fill one cache line.
    pub(super) sums: Aligned<[[R; 16]; MAX_LANES]>,
}

/// A value that begins at a cache line. A load of a register that was stored across two cache lines
/// would take longer.
#[derive(Debug)]
#[repr(align(64))]
pub(super) struct Aligned<T>(pub(super) T);

impl<R: Scalar, J: Index> Influences<'_, R, J> {
    /// Returns the joints of each lane, in the memory of the skin or in the copy. [`settled`] makes
    /// the compiler choose the place once, and not again for each index.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn rows(&self) -> PickRows<'_, J> {
        *settled(&self.in_place.unwrap_or_else(
            #[cfg_attr(not(opt_level_0), inline(always))]
            || self.joints.rows(),
        ))
    }

    /// Returns the weights of each lane. [`settled`] makes the compiler choose their place once.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn weights(&self) -> &[[R; GROUP]; MAX_LANES] {
        settled(self.weights_in_place.unwrap_or(&self.weights.0))
    }
}

/// Returns `written`, and makes the compiler complete all stores to it before any load from it
/// (`docs/measured.md`, *What keeps loops in registers*). Without this the compiler moves vectors
/// one component at a time, or loads more bytes at once than a store has written, which CPUs do not
/// forward from stores to loads. Either doubles the time.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn settled<T>(written: &T) -> &T {
    black_box(written)
}

/// The four influences of each vertex in a range: the palette entries of the joints, and the
/// weights.
type InPlace<'a, 't, J, R, const C: usize> = (PickedInPlace<'a, 't, J, R, C>, &'a [[R; GROUP]]);

impl<'a, J: Index, W: Weight> Skin<'a, J, W> {
    /// Returns the number of groups that the influences of a vertex fill.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn groups(&self) -> usize {
        self.influences().div_ceil(GROUP)
    }

    /// Makes the memory in which kernels keep the influences that they have read.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn scratch<R: Scalar>(&self) -> Scratch<'a, R, J> {
        let influences = Influences {
            in_place: None,
            weights_in_place: None,
            joints: Picks::new(self.joints),
            weights: Aligned([[R::ZERO; GROUP]; MAX_LANES]),
            pivots: None,
        };
        Scratch { influences, sums: Aligned([[R::ZERO; 16]; MAX_LANES]) }
    }

    /// Returns the influences of `count` vertices from `first` on without copying them. Their
    /// joints are paired with the palette `table`. Returns `None` if a vertex does not have four
    /// influences that adjoin in memory, or its weights do not have the type `R`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn in_place<'t, R: Scalar, const C: usize>(
        &self,
        first: usize,
        count: usize,
        table: &'t [[R; C]],
    ) -> Option<InPlace<'a, 't, J, R, C>> {
        if self.stride != GROUP {
            return None;
        }
        let weights = W::as_numbers(self.weights)?.as_chunks().0.get(first..)?.get(..count)?;
        Some((self.joints.all_in_place(first, count, table)?, weights))
    }

    /// Reads a group of influences of the vertices from `first` on, one vertex for each lane, into
    /// `to`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn read<R: Scalar>(
        &self,
        first: usize,
        lanes: usize,
        group: usize,
        to: &mut Influences<'a, R, J>,
    ) {
        let weights = self.weights.as_chunks::<GROUP>().0.get(first..);
        // If the last weight is implied, the stride is less than `GROUP`, and this condition is
        // false.
        if self.stride == GROUP
            && let Some(weights) = weights.and_then(|weights| weights.get(..lanes))
            && let in_place @ Some(_) = self.joints.in_place(first)
        {
            to.in_place = in_place;
            let numbers = W::as_numbers(self.weights).map(|numbers| numbers.as_chunks::<GROUP>().0);
            to.weights_in_place = numbers.and_then(|rows| rows.get(first..)?.first_chunk());
            if to.weights_in_place.is_none() {
                let mut lane = 0;
                while lane < lanes {
                    let [a, b, c, d] = weights[lane];
                    to.weights.0[lane] = [a.value(), b.value(), c.value(), d.value()];
                    lane += 1;
                }
            }
            return;
        }
        if !(self.influences() == GROUP && !self.implied() && self.read_rows(first, lanes, to)) {
            self.read_each(first, lanes, group, to);
        }
    }

    /// Copies the influences as [`read`](Self::read) does, for four influences with other data
    /// between the vertices. Returns `false` if fewer than `lanes` vertices remain.
    #[inline(never)]
    fn read_rows<R: Scalar>(
        &self,
        first: usize,
        lanes: usize,
        to: &mut Influences<'a, R, J>,
    ) -> bool {
        if !to.joints.set_rows(lanes, first) {
            return false;
        }
        (to.in_place, to.weights_in_place) = (None, None);
        let mut rest = self.weights.get(first * self.stride..).unwrap_or_default();
        for weights in to.weights.0.iter_mut().take(lanes) {
            let Some([a, b, c, d]) = rest.first_chunk() else { break };
            *weights = [a.value(), b.value(), c.value(), d.value()];
            rest = rest.get(self.stride..).unwrap_or_default();
        }
        true
    }

    /// Copies the influences as [`read`](Self::read) does, for any number of influences, and for
    /// the last vertices. Lanes beyond the last vertex get joint 0.
    #[inline(never)]
    fn read_each<R: Scalar>(
        &self,
        first: usize,
        lanes: usize,
        group: usize,
        to: &mut Influences<'a, R, J>,
    ) {
        (to.in_place, to.weights_in_place) = (None, None);
        // A lane beyond the last vertex has all its weight on its first influence.
        let none = [if group == 0 { R::ONE } else { R::ZERO }, R::ZERO, R::ZERO, R::ZERO];
        let from = group * GROUP;
        for (lane, weights) in to.weights.0.iter_mut().enumerate().take(lanes) {
            let vertex = first + lane;
            // Influences that the vertex does not have repeat its first joint with weight 0. Any
            // other joint could bring NaN into the sum, because 0 · NaN is NaN.
            let there = to.joints.set_row(lane, vertex, from);
            *weights = if there { self.weights_from(vertex, from) } else { none };
        }
        if group == 0 && self.groups() > 1 {
            let pivots = to.pivots.get_or_insert_with(|| Picks::new(self.joints));
            let vertices = self.vertices();
            for lane in 0..lanes {
                let vertex = first + lane;
                let pivot = if vertex < vertices { self.pivot::<R>(vertex) } else { 0 };
                pivots.set_first(lane, vertex, pivot);
            }
        }
    }

    /// Returns four weights of a vertex, from influence `from` on. They are zero for influences
    /// that the vertex does not have.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn weights_from<R: Scalar>(&self, vertex: usize, from: usize) -> [R; GROUP] {
        let (start, given) = (vertex * self.stride + from, self.given().saturating_sub(from));
        let mut weights = [R::ZERO; GROUP];
        for (which, weight) in weights.iter_mut().enumerate() {
            let own = if which < given { self.weights.get(start + which) } else { None };
            *weight = own.map_or(R::ZERO, |own| own.value());
        }
        let last = self.influences() - 1;
        if self.implied()
            && let Some(weight) = weights.get_mut(last.wrapping_sub(from))
        {
            *weight = self.weight(vertex, last);
        }
        weights
    }
}

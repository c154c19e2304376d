use super::SkinningError;
use super::influences::{GROUP, Influences, Scratch};
use super::weight::Weight;
use crate::real::{Real, Scalar};
use crate::shape::{same_length, whole_instances};
use core::fmt::Debug;
use core::ops::RangeInclusive;
use dq8_simd::picks::{CheckedIndices, Index, Picks};

/// Which joints move a vertex, and how much: checked once, to be posed any number of times.
///
/// `joints` holds the influences of one vertex after those of another, the same number for each; `weights`
/// in the same order. Fill unused influences with any joint and weight 0. Joints are `u8`, `u16` or `u32`;
/// weights see [`Weight`].
///
/// ```
/// use dq8::skinning::{Skin, SkinningError};
/// let weights = [1.0_f32, 0.0, 0.5, 0.5];
/// assert_eq!(Skin::new(3, 2, &[0_u16, 0, 1, 2], &weights)?.vertices(), 2);
/// let error = Skin::new(2, 2, &[0_u16, 0, 1, 2], &weights).unwrap_err();
/// assert_eq!(error, SkinningError::JointOutOfRange { vertex: 1, influence: 1, joint: 2, joints: 2 });
/// # Ok::<(), SkinningError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Skin<'a, J, W> {
    influences: usize,
    joints: CheckedIndices<'a, J>,
    weights: &'a [W],
    implied: bool,
}

impl<'a, J: Index, W: Weight> Skin<'a, J, W> {
    /// Between these the weights of a vertex must sum. They should sum to one; dual quaternion blends
    /// divide by the sum in any case, linear blends do not.
    pub const WEIGHT_RANGE: RangeInclusive<f64> = 1.0 / 1024.0..=1024.0;

    /// A skin for a palette of `joint_count` joints, `influences` of them for every vertex.
    ///
    /// # Errors
    /// If the slices do not fit, a joint is out of range, a weight is negative or not finite, or the
    /// weights of a vertex do not sum to [about one](Self::WEIGHT_RANGE). The error names the vertex.
    pub fn new(
        joint_count: usize,
        influences: usize,
        joints: &'a [J],
        weights: &'a [W],
    ) -> Result<Self, SkinningError> {
        same_length("weights", weights.len(), joints.len())?;
        Self::checked(joint_count, influences, joints, weights, false)
    }

    /// As [`new`](Self::new), with one weight less for every vertex: the last is what the others leave
    /// of one.
    ///
    /// # Errors
    /// As [`new`](Self::new), and if the weights of a vertex exceed one.
    pub fn with_implied_weight(
        joint_count: usize,
        influences: usize,
        joints: &'a [J],
        weights: &'a [W],
    ) -> Result<Self, SkinningError> {
        if influences == 0 {
            return Err(SkinningError::NoInfluences);
        }
        same_length("weights", weights.len(), joints.len() / influences * (influences - 1))?;
        Self::checked(joint_count, influences, joints, weights, true)
    }

    fn checked(
        palette: usize,
        influences: usize,
        joints: &'a [J],
        weights: &'a [W],
        implied: bool,
    ) -> Result<Self, SkinningError> {
        if influences == 0 {
            return Err(SkinningError::NoInfluences);
        }
        whole_instances("joints", influences, joints.len())?;
        let joints = CheckedIndices::new(joints, palette).map_err(|index| {
            let (vertex, influence) = (index / influences, index % influences);
            let joint = joints.get(index).map_or(0, |&joint| joint.into());
            SkinningError::JointOutOfRange { vertex, influence, joint, joints: palette }
        })?;
        let skin = Self { influences, joints, weights, implied };
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
        // Seven weights rounded to eight bits exceed one by at most 7 · ½/255.
        let right = if self.implied {
            total <= 1.0 + 1.0 / 64.0
        } else {
            Self::WEIGHT_RANGE.contains(&total)
        };
        if right { Ok(()) } else { Err(SkinningError::Total { vertex, total }) }
    }

    /// How many vertices there are.
    #[must_use]
    pub fn vertices(&self) -> usize {
        // Never zero, which a compiler that reads it from memory does not know.
        self.joints.indices().len().checked_div(self.influences).unwrap_or(0)
    }

    /// How many influences every vertex has.
    #[must_use]
    pub fn influences(&self) -> usize {
        self.influences
    }

    /// How many joints the palette has.
    #[must_use]
    pub fn joint_count(&self) -> usize {
        self.joints.bound()
    }

    /// An influence of a vertex, its joint and its weight. `None` if there is none.
    #[must_use]
    pub fn influence<R: Real>(&self, vertex: usize, influence: usize) -> Option<(u32, R)> {
        if influence >= self.influences || vertex >= self.vertices() {
            return None;
        }
        let joint = self.joints.indices().get(vertex * self.influences + influence)?;
        Some(((*joint).into(), self.weight(vertex, influence)))
    }

    /// Which influence of a vertex has the greatest weight: the first of those.
    fn pivot<R: Real>(&self, vertex: usize) -> usize {
        let (mut pivot, mut greatest) = (0, self.weight::<R>(vertex, 0));
        for influence in 1..self.influences {
            let weight = self.weight(vertex, influence);
            if weight > greatest {
                (pivot, greatest) = (influence, weight);
            }
        }
        pivot
    }

    /// How many weights of a vertex are given.
    fn given(&self) -> usize {
        self.influences - usize::from(self.implied)
    }

    fn given_weight<R: Real>(&self, vertex: usize, influence: usize) -> R {
        self.weights.get(vertex * self.given() + influence).map_or(R::ZERO, |w| w.value())
    }

    fn weight<R: Real>(&self, vertex: usize, influence: usize) -> R {
        if influence < self.given() {
            return self.given_weight(vertex, influence);
        }
        let left = (0..influence).fold(R::ONE, |left, i| left - self.given_weight::<R>(vertex, i));
        // Rounding may leave less than nothing.
        if left > R::ZERO { left } else { R::ZERO }
    }

    /// How many groups of influences there are.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn groups(&self) -> usize {
        self.influences.div_ceil(GROUP)
    }

    /// Where kernels keep what they read.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn scratch<R: Scalar>(&self) -> Scratch<'a, R, J> {
        Scratch::new(self.joints)
    }

    /// A group of influences of the vertices from `first` on, one for each lane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn read<R: Scalar>(
        &self,
        first: usize,
        lanes: usize,
        group: usize,
        to: &mut Influences<'a, R, J>,
    ) {
        let weights = self.weights.as_chunks::<GROUP>().0.get(first..);
        if self.influences == GROUP
            && !self.implied
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
        self.read_each(first, lanes, group, to);
    }

    /// [`read`](Self::read) for any number of influences, and where the vertices end: what lies beyond is
    /// moved by joint 0.
    #[inline(never)]
    fn read_each<R: Scalar>(
        &self,
        first: usize,
        lanes: usize,
        group: usize,
        to: &mut Influences<'a, R, J>,
    ) {
        (to.in_place, to.weights_in_place) = (None, None);
        // Influences that are not there are the first one with weight 0: another joint's NaN must not get in.
        let position = |vertex, influence| {
            let there = influence < self.influences;
            vertex * self.influences + if there { influence } else { 0 }
        };
        // Not asked for at every influence, which would divide each time.
        let vertices = self.vertices();
        for lane in 0..lanes {
            let vertex = first + lane;
            for slot in 0..GROUP {
                let influence = group * GROUP + slot;
                let none = if influence == 0 { R::ONE } else { R::ZERO };
                to.joints.set(lane, slot, position(vertex, influence));
                let there = vertex < vertices && influence < self.influences;
                to.weights.0[lane][slot] =
                    if there { self.weight(vertex, influence) } else { none };
            }
        }
        if group == 0 && self.groups() > 1 {
            let pivots = to.pivots.get_or_insert_with(|| Picks::new(self.joints));
            for lane in 0..lanes {
                let vertex = first + lane;
                let pivot = if vertex < vertices { self.pivot::<R>(vertex) } else { 0 };
                pivots.set(lane, 0, position(vertex, pivot));
            }
        }
    }
}

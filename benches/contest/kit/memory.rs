//! How motions and points lie in memory: [`Packed`] for one element, [`Many`] for all of them.

mod glam;
mod nalgebra;
mod own;
mod rows;
mod ultraviolet;

pub use self::glam::QuatVec3A;
pub use self::own::Own;
pub use self::rows::Rows3x4;

use ::glam::{Affine3A, Mat4};
use ::nalgebra::{Isometry3, UnitDualQuaternion};
use ::ultraviolet::{Isometry3x8, Mat4x8};
use dq8::DualQuat;
use simba::simd::WideF32x8;

/// Three rows of [R | t], in which every representation can be compared.
pub type Rows = [[f64; 4]; 3];

/// Motions that can be multiplied, one or as many as lanes.
pub trait Product: Copy {
    /// `self` · `first`: `first` acts first.
    fn product(&self, first: &Self) -> Self;
}

/// `product!(|a, first| expression; types)`. A macro because references to some types have no
/// `Mul`, and by value nalgebra's dual quaternions take half as long again down a hierarchy.
macro_rules! product {
    (|$a:ident, $first:ident| $product:expr; $($M:ty),* $(,)?) => {$(
        impl Product for $M {
            #[inline(always)]
            fn product(&self, first: &Self) -> Self {
                let ($a, $first) = (self, first);
                $product
            }
        }
    )*};
}
product!(|a, first| *a * *first; DualQuat<f32>, Affine3A, Mat4, Isometry3x8, Mat4x8);
product!(
    |a, first| a * first;
    Isometry3<f32>, Isometry3<WideF32x8>, UnitDualQuaternion<f32>, UnitDualQuaternion<WideF32x8>,
);

/// One rigid motion.
pub trait Representation: Product + 'static {
    fn from_motion(motion: &DualQuat<f32>) -> Self;
    fn rows(&self) -> Rows;
}

/// What can be compared with `f64`.
pub trait Element: Copy + 'static {
    /// How many instances one holds.
    const LANES: usize = 1;

    /// A motion as the rows of its matrix, since σ and −σ are one motion and some peers have
    /// nothing else; anything else as it is.
    fn numbers(&self, lane: usize) -> Vec<f64>;
}

/// An element that holds a `T` of one instance, or of several in lanes.
pub trait Packed<T>: Element {
    /// Lane i from element i.
    fn gather(lanes: &[T]) -> Self;
}

impl<M: Representation> Element for M {
    fn numbers(&self, _: usize) -> Vec<f64> {
        flat(&self.rows())
    }
}

impl<M: Representation> Packed<DualQuat<f32>> for M {
    fn gather(lanes: &[DualQuat<f32>]) -> Self {
        Self::from_motion(&lanes[0])
    }
}

fn flat(rows: &Rows) -> Vec<f64> {
    rows.as_flattened().to_vec()
}

/// Some different ones, repeated until they fill what they have to fill.
pub struct Many<T> {
    /// In one instance: the joints of a skeleton, or 1.
    joints: usize,
    /// `[instance][joint]`.
    different: Vec<T>,
    instances: usize,
}

impl<T: Copy> Many<T> {
    /// Instances that differ: whole blocks of any number of lanes. No contender branches on data.
    pub const DIFFERENT: usize = 64;

    pub fn new(joints: usize, different: Vec<T>, instances: usize) -> Self {
        let given = different.len() / joints;
        assert!(instances.is_multiple_of(given) && given * joints == different.len());
        Self { joints, different, instances }
    }

    /// `[instance][joint]`.
    pub fn different(&self) -> &[T] {
        &self.different
    }

    pub fn instances(&self) -> usize {
        self.instances
    }

    #[allow(clippy::len_without_is_empty, reason = "never empty")]
    pub fn len(&self) -> usize {
        self.joints * self.instances
    }

    /// `[instance block][joint]`.
    pub fn pack<E: Packed<T>>(&self) -> Vec<E> {
        let mut packed = Vec::with_capacity(self.len() / E::LANES);
        for block in self.different.chunks_exact(self.joints * E::LANES) {
            for joint in 0..self.joints {
                let lanes: Vec<T> = block[joint..].iter().step_by(self.joints).copied().collect();
                packed.push(E::gather(&lanes));
            }
        }
        let (once, all) = (packed.len(), self.len() / E::LANES);
        assert!(once > 0 && all.is_multiple_of(once), "no whole blocks");
        while packed.len() < all {
            packed.extend_from_within(..once);
        }
        packed
    }

    /// The numbers of one of the different, out of what has been packed like this.
    pub fn numbers<E: Element>(&self, packed: &[E], index: usize) -> Vec<f64> {
        let (instance, joint) = (index / self.joints, index % self.joints);
        packed[instance / E::LANES * self.joints + joint].numbers(instance % E::LANES)
    }
}

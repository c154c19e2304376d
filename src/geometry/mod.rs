//! Types of data that motions act on or that describe motions. `T` is a float for one motion, or a
//! vector of lanes for many motions. Points and directions are arrays `[T; 3]`.

/// Implements sums, differences and negation for types that consist of two vectors. These vectors
/// are arrays, which have no operators; for parts that have operators there is
/// `contract::sums_by_part`.
macro_rules! sums_of_vectors {
    ($Pair:ident { $first:ident, $second:ident }) => {
        impl<T: Copy + Add<Output = T>> Add for $Pair<T> {
            type Output = Self;
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn add(self, other: Self) -> Self {
                let $first = vector::add(self.$first, other.$first);
                Self { $first, $second: vector::add(self.$second, other.$second) }
            }
        }
        impl<T: Copy + Sub<Output = T>> Sub for $Pair<T> {
            type Output = Self;
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn sub(self, other: Self) -> Self {
                let $first = vector::sub(self.$first, other.$first);
                Self { $first, $second: vector::sub(self.$second, other.$second) }
            }
        }
        impl<T: Copy + Neg<Output = T>> Neg for $Pair<T> {
            type Output = Self;
            #[cfg_attr(not(opt_level_0), inline(always))]
            fn neg(self) -> Self {
                let ([a, b, c], [d, e, f]) = (self.$first, self.$second);
                Self { $first: [-a, -b, -c], $second: [-d, -e, -f] }
            }
        }
    };
}

mod line;
mod screw;
mod twist;
pub(crate) mod vector;

pub use line::{Line, Plane};
pub use screw::{DualVector, Screw};
pub use twist::{Twist, Wrench};

/// A mean of motions that was found by iteration, with the state of the iteration: the result of
/// [`dib`](crate::Motion::dib).
///
/// `M` is the motion, `T` a float and `B` a `bool`, or all three are lanes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mean<M, T, B> {
    /// The mean, or the last approximation to it.
    pub motion: M,
    /// The number of steps of the iteration, a whole number. With 0 steps, `motion` is the linear
    /// blend unchanged.
    pub iterations: T,
    /// `true` if the iteration ended because its next step would have been within the tolerance.
    pub converged: B,
}

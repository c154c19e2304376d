//! What a motion acts on and what describes it: plain data, the same for one motion (`T` a float)
//! and for many (`T` a vector of lanes). Points and directions are plain `[T; 3]`.

/// Sums, differences and negatives of what is two vectors, which have no operators
/// (`contract::sums` is for parts that have).
macro_rules! sums {
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

mod dual_vector;
mod line;
mod mean;
mod plane;
mod screw;
mod twist;
pub(crate) mod vector;
mod wrench;

pub use dual_vector::DualVector;
pub use line::Line;
pub use mean::Mean;
pub use plane::Plane;
pub use screw::Screw;
pub use twist::Twist;
pub use wrench::Wrench;

use super::Line;

crate::pod::pod! {
    /// A screw: turn by θ about an axis and slide by d along it. Every rigid motion is one
    /// (Chasles).
    ///
    /// The unit dual quaternion is σ = cos(θ̂/2) + sin(θ̂/2)(l + εm) with the dual angle
    /// θ̂ = θ + εd (Jia, *Dual Quaternions*, eq. 43).
    #[derive(Clone, Copy, Debug, PartialEq)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
    #[must_use]
    pub struct Screw<T> {
        /// The screw axis l + εm, |l| = 1.
        pub axis: Line<T>,
        /// θ, radians: in [0, π] where dq8 found it, any where it is given.
        pub angle: T,
        /// d, the translation along the axis, in the user's unit of length.
        pub slide: T,
    }
}

impl<T: Copy + core::ops::Div<Output = T>> Screw<T> {
    /// The pitch d / θ, length per radian (Jia §8.2); infinite for a pure translation, NaN for
    /// the identity.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn pitch(&self) -> T {
        self.slide / self.angle
    }
}

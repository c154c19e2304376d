/// A mean of motions, found by iteration, and how it was found: the answer of
/// [`dib`](crate::Motion::dib).
///
/// `M` is one motion, `T` a float and `B` a `bool`; or all three are lanes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mean<M, T, B> {
    /// The mean, or the last approximation to it.
    pub motion: M,
    /// The number of steps, a whole number. 0 is the linear blend, untouched.
    pub iterations: T,
    /// `true` if the next step would have been within the tolerance.
    pub converged: B,
}

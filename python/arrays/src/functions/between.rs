//! Interpolation.

use super::function::*;
use super::motion;

function! {
    /// Normalized linear interpolation ``normalize((1 − t)a ± tb)`` by the shorter way.
    ///
    /// The path is that of `sclerp` up to third order, for a tenth of the work; the speed along it
    /// varies.
    fn nlerp(
        /// Unit dual quaternions, at t = 0 and t = 1.
        a, b: [8],
        /// Where between them, in [0, 1]. Leading dimensions of all three broadcast.
        t: [],
    ) -> [8]
    ///
    /// Examples
    /// --------
    /// >>> import dq8
    /// >>> dq8.translation(dq8.nlerp(dq8.identity(), dq8.from_translation([4.0, 0, 0]), 0.25))
    /// array([1., 0., 0.])
    {
        motion(a).nlerp(motion(b), t[0]).to_array()
    }
}

function! {
    /// Screw linear interpolation ``a(a*b)ᵗ`` by the shorter way: one screw motion at constant
    /// speed.
    const WIDE: bool = true;
    fn sclerp(
        /// Unit dual quaternions, at t = 0 and t = 1.
        a, b: [8],
        /// Where between them, or beyond. Leading dimensions of all three broadcast.
        t: [],
    ) -> [8]
    ///
    /// References
    /// ----------
    /// L. Kavan, S. Collins, C. O'Sullivan, J. Žára, "Dual Quaternions for Rigid Transformation
    /// Blending", Trinity College Dublin, 2006.
    ///
    /// Examples
    /// --------
    /// >>> import dq8, numpy as np
    /// >>> end = dq8.from_translation([4.0, 0.0, 0.0])
    /// >>> dq8.translation(dq8.sclerp(dq8.identity(), end, np.linspace(0, 1, 5)))[:, 0]
    /// array([0., 1., 2., 3., 4.])
    {
        motion(a).sclerp(motion(b), t[0]).to_array()
    }
}

//! Products, inverses, norms.

use super::function::*;
use super::motion;

function! {
    /// Products ``a b``: `b` acts first.
    ///
    /// ``(p + εq)(r + εs) = pr + ε(ps + qr)``
    fn mul(
        /// Dual quaternions ``[px, py, pz, pw, qx, qy, qz, qw]``; leading dimensions broadcast.
        a, b: [8];
        out ": its shape and dtype. May be an argument"
    ) -> [8]
    ///
    /// Examples
    /// --------
    /// >>> import dq8
    /// >>> step = dq8.from_translation([1.0, 0.0, 0.0])
    /// >>> dq8.translation(dq8.mul(step, step))
    /// array([2., 0., 0.])
    {
        (motion(a) * motion(b)).to_array()
    }
}

function! {
    /// Normalized products: ``normalize(mul(a, b))`` in one pass.
    ///
    /// The norm of a chain of products drifts; this keeps it at one.
    fn compose(
        /// Dual quaternions; leading dimensions broadcast.
        a, b: [8],
    ) -> [8]
    ///
    /// Examples
    /// --------
    /// >>> import dq8
    /// >>> dq8.compose(2 * dq8.identity(), dq8.identity())
    /// array([0., 0., 0., 1., 0., 0., 0., 0.])
    {
        (motion(a) * motion(b)).normalize().to_array()
    }
}

function! {
    /// Inverses ``σ⁻¹ = p⁻¹ − ε p⁻¹ q p⁻¹`` of any σ = p + εq with p ≠ 0.
    ///
    /// Of unit dual quaternions `conjugate` is the same, and faster.
    fn inverse(
        /// Dual quaternions.
        motions: [8],
    ) -> [8]
    ///     Some component is NaN or infinite where there is no inverse.
    ///
    /// Examples
    /// --------
    /// >>> import dq8
    /// >>> dq8.translation(dq8.inverse(dq8.from_translation([1.0, 2.0, 3.0])))
    /// array([-1., -2., -3.])
    {
        motion(motions).inverse().to_array()
    }
}

function! {
    /// Conjugates ``σ* = p* + εq*``, the inverses of unit dual quaternions.
    fn conjugate(
        /// Dual quaternions.
        motions: [8],
    ) -> [8]
    ///
    /// Examples
    /// --------
    /// >>> import dq8
    /// >>> dq8.translation(dq8.conjugate(dq8.from_translation([1.0, 2.0, 3.0])))
    /// array([-1., -2., -3.])
    {
        motion(motions).conjugate().to_array()
    }
}

function! {
    /// Unit dual quaternions ``σ/√(σσ*)``: p of length one, and q orthogonal to it.
    fn normalize(
        /// Dual quaternions with p ≠ 0.
        motions: [8],
    ) -> [8]
    ///     Some component is NaN where p = 0 or a component is not finite.
    ///
    /// Examples
    /// --------
    /// >>> import dq8
    /// >>> dq8.normalize(2 * dq8.identity())
    /// array([0., 0., 0., 1., 0., 0., 0., 0.])
    {
        motion(motions).normalize().to_array()
    }
}

function! {
    /// `normalize`, ``σ/√(σσ*)``, with p = 1 where p = 0: what SciPy takes dual quaternions
    /// for.
    fn unit_or_identity(
        /// Dual quaternions.
        motions as "dual_quat": [8],
    ) -> [8]
    ///
    /// Examples
    /// --------
    /// >>> import dq8, numpy as np
    /// >>> dq8._core.unit_or_identity(np.zeros(8))
    /// array([0., 0., 0., 1., 0., 0., 0., 0.])
    {
        let [x, y, z, w, ..] = motions;
        let zero = w.constant(0.0);
        let nothing = x.eq(zero) & y.eq(zero) & z.eq(zero) & w.eq(zero);
        let mut made = motions;
        made[3] = L::select(nothing, w.constant(1.0), w);
        motion(made).normalize().to_array()
    }
}

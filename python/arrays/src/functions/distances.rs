//! How far motions are apart.

use super::function::*;
use super::motion;

function! {
    /// The angle of the rotation from `a` to `b`, radians in [0, π]: ``2 atan2(|v|, |w|)`` of
    /// ``v + w = p_a* p_b``.
    fn angle_to(
        /// Unit dual quaternions; leading dimensions broadcast.
        a, b: [8],
    ) -> []
    ///
    /// Examples
    /// --------
    /// >>> import dq8
    /// >>> dq8.angle_to(dq8.identity(), dq8.from_rotation([0.0, 0, 1, 0]))
    /// np.float64(3.141592653589793)
    {
        [motion(a).angle_to(motion(b))]
    }
}

function! {
    /// The distance of the translations, ``|t_a − t_b|``, a length.
    fn distance_to(
        /// Unit dual quaternions; leading dimensions broadcast.
        a, b: [8],
    ) -> []
    ///
    /// Examples
    /// --------
    /// >>> import dq8
    /// >>> dq8.distance_to(dq8.identity(), dq8.from_translation([0.0, 3, 4]))
    /// np.float64(5.0)
    {
        [motion(a).distance_to(motion(b))]
    }
}

function! {
    /// A distance of motions, ``√((λθ)² + d²)``, of `angle_to` θ and `distance_to` d; a
    /// length.
    fn distance_weighted(
        /// Unit dual quaternions.
        a, b: [8],
        /// λ, the length that counts as much as a radian. Leading dimensions of all three
        /// broadcast.
        length_per_radian: [],
    ) -> []
    ///
    /// Examples
    /// --------
    /// >>> import dq8
    /// >>> dq8.distance_weighted(dq8.identity(), dq8.from_translation([0.0, 3, 4]), 2.0)
    /// np.float64(5.0)
    {
        [motion(a).distance_weighted(motion(b), length_per_radian[0])]
    }
}

function! {
    /// The distance of dual quaternions ``p + εq`` from unit: the larger one of ``| |p| − 1 |``
    /// and ``|p·q|/(1 + |q|)``.
    fn unit_defect(
        /// Dual quaternions.
        motions: [8],
    ) -> []
    ///
    /// Examples
    /// --------
    /// >>> import dq8
    /// >>> dq8._core.unit_defect(dq8.identity())
    /// np.float64(0.0)
    {
        let [a, b, c, d, e, f, g, h] = motions;
        let one = a.constant(1.0);
        let length = ((a * a + b * b + c * c + d * d).sqrt() - one).abs();
        let across = (a * e + b * f + c * g + d * h).abs()
            / (one + (e * e + f * f + g * g + h * h).sqrt());
        [L::select(across.le(length), length, across + length * one.constant(0.0))]
    }
}

function! {
    /// How far apart `a` and `b` move a point: ``|av − bv|``, a length.
    fn point_error(
        /// Unit dual quaternions.
        a, b: [8],
        /// The points v. Leading dimensions of all three broadcast.
        points: [3],
    ) -> []
    ///
    /// Examples
    /// --------
    /// >>> import dq8
    /// >>> dq8.point_error(dq8.identity(), dq8.from_translation([0.0, 3, 4]), [1.0, 0, 0])
    /// np.float64(5.0)
    {
        [motion(a).point_error(motion(b), points)]
    }
}

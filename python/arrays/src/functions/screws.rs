//! Logarithm, exponential, powers, twists and screws.

use super::faults::{NoAxis, refuse};
use super::function::*;
use super::{joined, motion};
use crate::argument::is_single;
use dq8::{
    Line, Twist, batch,
    geometry::{DualVector, Screw},
};

function! {
    /// Logarithms of unit dual quaternions, which are dual quaternions: ``(θ̂/2)(l + εm)``.
    ///
    /// Other libraries call the twist so, six numbers and twice as large: that is `to_twist` here.
    /// Of ±σ, which are the same motion, that of the one whose first of (p_w, p_x, p_y, p_z) that
    /// is not zero is positive.
    const WIDE: bool = true;
    fn log(
        /// Unit dual quaternions.
        motions: [8],
    ) -> [8]
    ///     Dual quaternions without scalars, ``[x, y, z, 0, dx, dy, dz, 0]``: half the rotation
    ///     vector, radians, and the dual part, lengths.
    ///
    /// Examples
    /// --------
    /// >>> import dq8
    /// >>> dq8.log(dq8.from_translation([4.0, 0.0, 0.0]))
    /// array([0., 0., 0., 0., 2., 0., 0., 0.])
    {
        let DualVector { real: [a, b, c], dual: [d, e, f] } = motion(motions).log();
        let zero = a.constant(0.0);
        [a, b, c, zero, d, e, f, zero]
    }
}

function! {
    /// Exponentials of dual quaternions without scalars, ``cos ĥ + sin ĥ (l + εm)`` of
    /// ``ĥ(l + εm)``: what `log` undoes. Of twists it is `from_twist`.
    fn exp(
        /// Dual quaternions without scalars, as `log` returns them: half the rotation vector,
        /// radians, and the dual part, lengths.
        logs: [8],
    ) -> [8]
    ///     NaN where a scalar is not 0, or the real part is beyond 2⁴⁵ radians (float32:
    ///     2¹⁶).
    ///
    /// Examples
    /// --------
    /// >>> import dq8
    /// >>> dq8.translation(dq8.exp([0.0, 0, 0, 0, 2, 0, 0, 0]))
    /// array([4., 0., 0.])
    {
        let [a, b, c, scalar, d, e, f, dual] = logs;
        let motion = batch::DualQuat::exp(DualVector { real: [a, b, c], dual: [d, e, f] });
        let zero = scalar.constant(0.0);
        let none = scalar.eq(zero) & dual.eq(zero);
        let nan = zero.constant(f64::NAN);
        motion.to_array().map(#[inline(always)] |number| L::select(none, number, nan))
    }
}

function! {
    /// The constant twists that make the motions in unit time: ``2 log σ``, the exponential
    /// coordinates.
    const WIDE: bool = true;
    fn to_twist(
        /// Unit dual quaternions.
        motions: [8],
    ) -> [6]
    ///     ``[ωx, ωy, ωz, vx, vy, vz]``: the rotation vector in radians, of at most π, and the
    ///     velocity of the point at the origin, in lengths.
    ///
    /// Examples
    /// --------
    /// >>> import dq8
    /// >>> dq8.to_twist(dq8.from_translation([4.0, 0.0, 0.0]))
    /// array([0., 0., 0., 4., 0., 0.])
    {
        let twist = motion(motions).to_twist();
        joined(twist.angular, twist.linear)
    }
}

function! {
    /// The motions that constant twists make in unit time: ``exp(½ξ)`` of exponential coordinates
    /// ξ.
    fn from_twist(
        /// ``[ωx, ωy, ωz, vx, vy, vz]``, radians and lengths.
        twists: [6],
    ) -> [8]
    ///     NaN where ω is beyond 2⁴⁶ radians (float32: 2¹⁷).
    ///
    /// Examples
    /// --------
    /// >>> import dq8, numpy as np
    /// >>> dq8.translation(dq8.from_twist([0.0, 0, np.pi, 0, np.pi, 0])).round(9) + 0.0
    /// array([-2.,  0.,  0.])
    {
        batch::DualQuat::from_twist(Twist::from_array(twists)).to_array()
    }
}

function! {
    /// Powers ``σᵗ = exp(t log σ)`` of unit dual quaternions: the part t of each screw motion.
    const WIDE: bool = true;
    fn pow(
        /// Unit dual quaternions.
        motions: [8],
        /// Exponents; leading dimensions broadcast.
        t: [],
    ) -> [8]
    ///
    /// Examples
    /// --------
    /// >>> import dq8
    /// >>> dq8.translation(dq8.pow(dq8.from_translation([4.0, 0, 0]), 0.25))
    /// array([1., 0., 0.])
    {
        motion(motions).pow(t[0]).to_array()
    }
}

function! {
    /// Screws: the axis l + εm that each motion turns about by θ and slides along by d.
    ///
    /// ``±σ = cos(θ̂/2) + sin(θ̂/2)(l + εm)`` with ``θ̂ = θ + εd``
    fn to_screw(
        /// Unit dual quaternions.
        motions: [8],
    ) -> [8]
    ///     ``[lx, ly, lz, mx, my, mz, θ, d]``: direction of length one and moment of the axis
    ///     (Plücker), the angle in [0, π] radians, the length of the slide. A pure translation
    ///     has angle and moment 0 and its own direction; the identity has the direction (1, 0, 0).
    ///
    /// References
    /// ----------
    /// Y.-B. Jia, "Dual Quaternions", Iowa State University, eq. 36–43.
    ///
    /// Examples
    /// --------
    /// >>> import dq8
    /// >>> dq8.to_screw(dq8.from_twist([0.0, 0, 0.5, 0, 0, 2])).round(9) + 0.0
    /// array([0. , 0. , 1. , 0. , 0. , 0. , 0.5, 2. ])
    {
        let Screw { axis, angle, slide } = motion(motions).to_screw();
        let [a, b, c, d, e, f] = joined(axis.direction, axis.moment);
        [a, b, c, d, e, f, angle, slide]
    }
}

function! {
    /// Motions from screws: ``σ = cos(θ̂/2) + sin(θ̂/2)(l + εm)`` with ``θ̂ = θ + εd``.
    refuse NoAxis if check;
    fn from_screw(
        /// ``[lx, ly, lz, mx, my, mz, θ, d]`` as `to_screw` returns them: radians and lengths; l
        /// has length one.
        screws: [8],
    ) -> [8]
    ///
    /// Examples
    /// --------
    /// >>> import dq8
    /// >>> dq8.translation(dq8.from_screw([0.0, 0, 1, 0, 0, 0, 0.5, 2]))
    /// array([0., 0., 2.])
    {
        let [a, b, c, d, e, f, angle, slide] = screws;
        let axis = Line { direction: [a, b, c], moment: [d, e, f] };
        batch::DualQuat::from_screw(Screw { axis, angle, slide }).to_array()
    }
}

function! {
    /// Where constant body twists ξ take motions in the time `dt`: ``σ exp(½ξ dt)``.
    ///
    /// With the screw axis of a joint as twist and its angle as time, this is the pose of a link in
    /// its parent: ``integrate_body(offset, [axis, 0], angle)`` of a hinge.
    const WIDE: bool = true;
    fn integrate_body(
        /// Unit dual quaternions at time 0.
        motions: [8],
        /// ``[ω, v]`` in the moving frame, radians and lengths per unit of time.
        twists: [6],
        /// Time, or the angle of a joint. Leading dimensions of all three broadcast.
        dt: [],
    ) -> [8]
    ///
    /// Examples
    /// --------
    /// >>> import dq8
    /// >>> moved = dq8.integrate_body(dq8.identity(), [0.0, 0, 0, 1, 0, 0], [0.5, 2.0])
    /// >>> dq8.translation(moved)[:, 0]
    /// array([0.5, 2. ])
    {
        motion(motions).integrate_body(Twist::from_array(twists), dt[0]).to_array()
    }
}

function! {
    /// Where constant spatial twists ξ take motions in the time `dt`: ``exp(½ξ dt) σ``.
    const WIDE: bool = true;
    fn integrate_spatial(
        /// Unit dual quaternions at time 0.
        motions: [8],
        /// ``[ω, v]`` in the fixed frame, radians and lengths per unit of time.
        twists: [6],
        /// Time. Leading dimensions of all three broadcast.
        dt: [],
    ) -> [8]
    ///
    /// Examples
    /// --------
    /// >>> import dq8
    /// >>> moved = dq8.integrate_spatial(dq8.identity(), [0.0, 0, 0, 1, 0, 0], [0.5, 2.0])
    /// >>> dq8.translation(moved)[:, 0]
    /// array([0.5, 2. ])
    {
        motion(motions).integrate_spatial(Twist::from_array(twists), dt[0]).to_array()
    }
}

function! {
    /// The left Jacobians of the exponential: ``exp(½(ξ + δ)) ≈ exp(½ J δ) exp(½ξ)`` for
    /// small twists δ.
    ///
    /// That of the right is the one of −ξ.
    fn left_jacobian(
        /// ``ξ = [ω, v]``, radians and lengths.
        twists: [6],
    ) -> [6, 6]
    ///     Rows and columns are angular, then linear.
    ///
    /// References
    /// ----------
    /// T. D. Barfoot, *State Estimation for Robotics*, 2017, eq. 7.85, there with the translation
    /// first.
    ///
    /// Examples
    /// --------
    /// >>> import dq8
    /// >>> dq8.left_jacobian([0.0, 0, 0, 0, 0, 2])[3]
    /// array([ 0., -1.,  0.,  1.,  0.,  0.])
    {
        flat(batch::DualQuat::left_jacobian_matrix(Twist::from_array(twists)))
    }
}

function! {
    /// The inverses of `left_jacobian`: ``2 log(exp(½δ) exp(½ξ)) ≈ ξ + J⁻¹δ`` for small
    /// twists δ.
    fn left_jacobian_inverse(
        /// ``ξ = [ω, v]``, radians and lengths, ``|ω| < 2π``: there it is infinite.
        twists: [6],
    ) -> [6, 6]
    ///     Rows and columns are angular, then linear.
    ///
    /// Examples
    /// --------
    /// >>> import dq8
    /// >>> dq8.left_jacobian_inverse([0.0, 0, 0, 0, 0, 2])[3]
    /// array([0., 1., 0., 1., 0., 0.])
    {
        flat(batch::DualQuat::left_jacobian_inverse_matrix(Twist::from_array(twists)))
    }
}

/// Row after row.
#[inline(always)]
fn flat<L: Lanes>(rows: [[L; 6]; 6]) -> [L; 36] {
    let mut all = [rows[0][0]; 36];
    let (mut row, mut column) = (0, 0);
    while row < 6 {
        all[6 * row + column] = rows[row][column];
        column += 1;
        if column == 6 {
            (row, column) = (row + 1, 0);
        }
    }
    all
}

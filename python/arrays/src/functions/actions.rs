//! What motions do to points, vectors, lines, planes, twists and wrenches.

use super::function::*;
use super::{halves, joined, motion};
use dq8::{Line, Plane, Twist, geometry::Wrench};

function! {
    /// Points moved by unit dual quaternions: ``Rv + t``.
    one motion: transform_points;
    fn transform_points(
        /// Unit dual quaternions.
        motions: [8],
        /// Points, lengths; leading dimensions broadcast. One motion of many points is a matrix
        /// once.
        points: [3],
    ) -> [3]
    ///
    /// Examples
    /// --------
    /// >>> import dq8
    /// >>> dq8.transform_points(dq8.from_translation([1.0, 0, 0]), [0.0, 2, 0])
    /// array([1., 2., 0.])
    {
        motion(motions).transform_point(points)
    }
}

function! {
    /// Directions and differences turned by unit dual quaternions: ``v′ = Rv``.
    one motion: transform_vectors;
    fn transform_vectors(
        /// Unit dual quaternions.
        motions: [8],
        /// Vectors of any unit; leading dimensions broadcast.
        vectors: [3],
    ) -> [3]
    ///
    /// Examples
    /// --------
    /// >>> import dq8
    /// >>> dq8.transform_vectors(dq8.from_translation([1.0, 0, 0]), [0.0, 2, 0])
    /// array([0., 2., 0.])
    {
        motion(motions).transform_vector(vectors)
    }
}

function! {
    /// Lines moved by unit dual quaternions: ``l′ = Rl, m′ = Rm + t × l′``, lengths in m
    /// alone.
    fn transform_lines(
        /// Unit dual quaternions.
        motions: [8],
        /// Plücker coordinates ``[l, m]``, direction and moment ``m = x × l`` of any point x of
        /// the line; leading dimensions broadcast.
        lines: [6],
    ) -> [6]
    ///
    /// Examples
    /// --------
    /// >>> import dq8
    /// >>> dq8.transform_lines(dq8.from_translation([1.0, 0, 0]), [0.0, 0, 1, 0, 0, 0]) + 0.0
    /// array([ 0.,  0.,  1.,  0., -1.,  0.])
    {
        let (direction, moment) = halves(lines);
        let line = motion(motions).transform_line(Line { direction, moment });
        joined(line.direction, line.moment)
    }
}

function! {
    /// Planes moved by unit dual quaternions: ``n′ = Rn, d′ = d + n′·t``.
    fn transform_planes(
        /// Unit dual quaternions.
        motions: [8],
        /// ``[nx, ny, nz, d]`` of the plane ``n·x = d``, d a length where n has none; leading
        /// dimensions broadcast.
        planes: [4],
    ) -> [4]
    ///
    /// Examples
    /// --------
    /// >>> import dq8
    /// >>> dq8.transform_planes(dq8.from_translation([1.0, 0, 0]), [1.0, 0, 0, 2])
    /// array([1., 0., 0., 3.])
    {
        let [x, y, z, offset] = planes;
        let plane = motion(motions).transform_plane(Plane { normal: [x, y, z], offset });
        let [x, y, z] = plane.normal;
        [x, y, z, plane.offset]
    }
}

function! {
    /// Twists in the fixed frame from twists in the moving one: ``ω′ = Rω, v′ = Rv + t ×
    /// ω′``.
    fn adjoint(
        /// Unit dual quaternions.
        motions: [8],
        /// ``[ω, v]``: radians per unit of time, and the velocity of the point at the frame's
        /// origin; leading dimensions broadcast.
        twists: [6],
    ) -> [6]
    ///
    /// Examples
    /// --------
    /// >>> import dq8
    /// >>> dq8.adjoint(dq8.from_translation([1.0, 0, 0]), [0.0, 0, 1, 0, 0, 0]) + 0.0
    /// array([ 0.,  0.,  1.,  0., -1.,  0.])
    {
        let twist = motion(motions).adjoint(Twist::from_array(twists));
        joined(twist.angular, twist.linear)
    }
}

function! {
    /// Wrenches in the fixed frame from wrenches in the moving one: ``f′ = Rf, τ′ = Rτ + t ×
    /// f′``.
    fn coadjoint(
        /// Unit dual quaternions.
        motions: [8],
        /// ``[f, τ]``: force, and torque about the frame's origin, in forces times lengths;
        /// leading dimensions broadcast.
        wrenches: [6],
    ) -> [6]
    ///
    /// Examples
    /// --------
    /// >>> import dq8
    /// >>> dq8.coadjoint(dq8.from_translation([1.0, 0, 0]), [0.0, 0, 1, 0, 0, 0]) + 0.0
    /// array([ 0.,  0.,  1.,  0., -1.,  0.])
    {
        let (force, torque) = halves(wrenches);
        let wrench = motion(motions).coadjoint(Wrench { force, torque });
        joined(wrench.force, wrench.torque)
    }
}

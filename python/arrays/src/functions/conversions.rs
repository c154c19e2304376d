//! Motions from and to rotations, translations and matrices.

use super::faults::{NotUnit, refuse};
use super::function::*;
use super::matrices::rigidity_of;
use super::motion;
use crate::argument::is_single;
use dq8::batch;

function! {
    /// Translations as unit dual quaternions: ``1 + ½εt``.
    fn from_translation(
        /// Lengths.
        translations as "translation": [3],
    ) -> [8]
    ///
    /// Examples
    /// --------
    /// >>> import dq8
    /// >>> dq8.from_translation([2.0, 0.0, 0.0])
    /// array([0., 0., 0., 1., 1., 0., 0., 0.])
    {
        batch::DualQuat::from_translation(translations).to_array()
    }
}

function! {
    /// Rotate, then translate: ``r + ½εtr``.
    refuse NotUnit if check;
    fn from_rotation_translation(
        /// Unit quaternions ``[x, y, z, w]``.
        rotations: [4],
        /// Lengths; leading dimensions broadcast.
        translations as "translation": [3],
    ) -> [8]
    ///
    /// Examples
    /// --------
    /// >>> import dq8
    /// >>> dq8.translation(dq8.from_rotation_translation([0.0, 0, 1, 0], [2.0, 0, 0]))
    /// array([2., 0., 0.])
    {
        let rotation = batch::Quat::from_array(rotations);
        batch::DualQuat::from_rotation_translation(rotation, translations).to_array()
    }
}

function! {
    /// Translations ``t = 2qp*`` of unit dual quaternions, lengths.
    fn translation(
        /// Unit dual quaternions.
        motions: [8],
    ) -> [3]
    ///
    /// Examples
    /// --------
    /// >>> import dq8
    /// >>> dq8.translation(dq8.identity())
    /// array([0., 0., 0.])
    {
        motion(motions).translation()
    }
}

function! {
    /// Matrices ``[R t; 0 1]`` of unit dual quaternions, for column vectors, t in lengths.
    fn to_matrix(
        /// Unit dual quaternions.
        motions: [8],
    ) -> [4, 4]
    ///
    /// Examples
    /// --------
    /// >>> import dq8
    /// >>> dq8.to_matrix(dq8.from_translation([1.0, 2.0, 3.0]))
    /// array([[1., 0., 0., 1.],
    ///        [0., 1., 0., 2.],
    ///        [0., 0., 1., 3.],
    ///        [0., 0., 0., 1.]])
    {
        let [[a, b, c, d], [e, f, g, h], [i, j, k, l], [m, n, o, p]] = motion(motions).to_matrix4();
        [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p]
    }
}

function! {
    /// How far matrices are from rigid ones: the largest component of ``|RRᵀ − 1|``, the
    /// determinant of R, and the largest difference of the last row from 0 0 0 1.
    fn rigidity(
        /// Matrices, of which pure numbers are read.
        matrices as "matrix": [4, 4],
    ) -> [3]
    ///
    /// Examples
    /// --------
    /// >>> import dq8, numpy as np
    /// >>> dq8._core.rigidity(np.eye(4))
    /// array([0., 1., 0.])
    {
        rigidity_of(matrices)
    }
}

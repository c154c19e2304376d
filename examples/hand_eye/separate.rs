//! Rotation first, then translation, to compare with: the two steps of Tsai and Lenz (1989), the
//! first in quaternions (Chou and Kamel 1991).

use crate::calibration::{CalibrationError, Pair, check, commutator};
use dq8::{DualQuat, Quat};
use nalgebra::{DMatrix, DVector, Matrix3, Vector3};

/// X of A X = X B: the rotation from the rotations alone, then the translation for that rotation,
/// each in least squares. NaN if the equations for the translation are singular, which the check of
/// the axes rules out.
pub(crate) fn solve(pairs: &[Pair]) -> Result<DualQuat<f64>, CalibrationError> {
    check(pairs)?;
    let rotation = rotation(pairs);
    // (R_A − 1) t = R_X t_B − t_A
    let mut equations = DMatrix::zeros(3 * pairs.len(), 3);
    let mut wanted = DVector::zeros(3 * pairs.len());
    for (i, Pair { hand, eye }) in pairs.iter().enumerate() {
        let turned = [0, 1, 2].map(|c| hand.to_matrix3x4().map(|row| row[c]));
        let turn = Matrix3::from_columns(&turned.map(Vector3::from));
        equations.view_mut((3 * i, 0), (3, 3)).copy_from(&(turn - Matrix3::identity()));
        let seen = Vector3::from(rotation.rotate(eye.translation()));
        wanted.rows_mut(3 * i, 3).copy_from(&(seen - Vector3::from(hand.translation())));
    }
    // By QR: nalgebra's SVD, whose null vectors are good to 10⁻¹⁴, solved some of these to
    // 10⁻⁸ only.
    let factors = equations.qr();
    let solved = factors.r().solve_upper_triangular(&factors.q().tr_mul(&wanted));
    let translation = solved.map_or([f64::NAN; 3], |t| [t[0], t[1], t[2]]);
    Ok(DualQuat::from_rotation_translation(rotation, translation).canonical())
}

/// The q that minimises Σ|aq − qb|², a and b being the vector parts of the rotations.
fn rotation(pairs: &[Pair]) -> Quat<f64> {
    let mut equations = DMatrix::zeros(3 * pairs.len(), 4);
    for (i, pair) in pairs.iter().enumerate() {
        let [hand, eye] = pair.canonical().map(|motion| motion.real().xyz());
        equations.view_mut((3 * i, 0), (3, 4)).copy_from(&commutator(hand, eye));
    }
    let rows = equations.svd(false, true).v_t.expect("it was asked for");
    Quat::from_wxyz([0, 1, 2, 3].map(|c| rows[(3, c)])).normalize()
}

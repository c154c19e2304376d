//! The third opinion: rigid motions as 4×4 matrices in `f64`, multiplied by plain loops. Rotations
//! come from Rodrigues' formula, so no quaternion is involved on the way in.

use dq8::{DualQuat, Quat};

pub type Matrix = [[f64; 4]; 4];

pub const IDENTITY: Matrix =
    [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];

/// A motion as the numbers that both algebras start from: turn by `angle` about the unit `axis`,
/// then shift.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    pub axis: [f64; 3],
    pub angle: f64,
    pub shift: [f64; 3],
}

impl Step {
    /// `[px, py, pz, pw, qx, qy, qz, qw]`
    pub fn motion(&self) -> [f64; 8] {
        let turn = Quat::from_axis_angle(self.axis, self.angle);
        DualQuat::from_rotation_translation(turn, self.shift).to_array()
    }

    /// Rodrigues: R = cos θ + sin θ k× + (1 − cos θ) k kᵀ.
    pub fn matrix(&self) -> Matrix {
        let ([x, y, z], (sin, cos)) = (self.axis, self.angle.sin_cos());
        let cross = [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]];
        let mut matrix = IDENTITY;
        for row in 0..3 {
            for column in 0..3 {
                let along = (1.0 - cos) * self.axis[row] * self.axis[column];
                matrix[row][column] =
                    cos * IDENTITY[row][column] + sin * cross[row][column] + along;
            }
            matrix[row][3] = self.shift[row];
        }
        matrix
    }
}

pub fn product(a: &Matrix, b: &Matrix) -> Matrix {
    let mut product = [[0.0; 4]; 4];
    for row in 0..4 {
        for column in 0..4 {
            for k in 0..4 {
                product[row][column] += a[row][k] * b[k][column];
            }
        }
    }
    product
}

/// The inverse of a rigid matrix: Rᵀ and −Rᵀt.
pub fn inverse(matrix: &Matrix) -> Matrix {
    let mut inverse = IDENTITY;
    for row in 0..3 {
        for column in 0..3 {
            inverse[row][column] = matrix[column][row];
            inverse[row][3] -= matrix[column][row] * matrix[column][3];
        }
    }
    inverse
}

/// The matrix of eight floats, written out here so that the library's own conversion is no judge in
/// its own case: columns p v p*, translation 2 q p*.
fn of_motion([x, y, z, w, a, b, c, d]: [f64; 8]) -> Matrix {
    [
        [
            w * w + x * x - y * y - z * z,
            2.0 * (x * y - w * z),
            2.0 * (x * z + w * y),
            2.0 * (a * w - d * x - b * z + c * y),
        ],
        [
            2.0 * (x * y + w * z),
            w * w - x * x + y * y - z * z,
            2.0 * (y * z - w * x),
            2.0 * (b * w - d * y - c * x + a * z),
        ],
        [
            2.0 * (x * z - w * y),
            2.0 * (y * z + w * x),
            w * w - x * x - y * y + z * z,
            2.0 * (c * w - d * z - a * y + b * x),
        ],
        [0.0, 0.0, 0.0, 1.0],
    ]
}

/// The largest difference of an element, NaN being infinite.
pub fn distance(motion: &[f64; 8], wanted: &Matrix) -> f64 {
    let got = of_motion(*motion);
    let pairs = got.as_flattened().iter().zip(wanted.as_flattened());
    pairs.fold(0.0, |worst: f64, (a, b)| {
        let error = (a - b).abs();
        if error.is_nan() { f64::INFINITY } else { worst.max(error) }
    })
}

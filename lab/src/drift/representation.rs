use crate::matrix::{self, Matrix};
use dq8::{DualQuat, Quat, Real, representation::RotationTranslation};
use nalgebra::Matrix3;

/// What holds the state of a joint and is multiplied, in its own arithmetic.
pub trait Representation: Copy {
    /// The precision.
    type Real: Real;
    /// Nothing moved.
    fn identity() -> Self;
    /// A translation.
    fn shift(translation: [Self::Real; 3]) -> Self;
    /// A turn about a unit axis, radians.
    fn turn(axis: [Self::Real; 3], angle: Self::Real) -> Self;
    /// `other` acts first.
    fn times(self, other: Self) -> Self;
    /// The same numbers in double precision, and from them what becomes of points: the rows of
    /// `[A | t]`.
    fn to_matrix(self) -> Matrix<f64, 3, 4>;
    /// By how much it fails to be what it should be: |det A − 1| of a matrix, ||p| − 1| of a
    /// quaternion, the larger of that and |p·q| of a dual quaternion.
    fn norm_error(self) -> f64;
}

/// A homogeneous matrix. Its last row stays 0 0 0 1 exactly, so 3×4 matrices would round the same.
#[derive(Clone, Copy, Debug)]
pub struct Homogeneous<R>(pub Matrix<R, 4, 4>);

impl<R: Real> Representation for Homogeneous<R> {
    type Real = R;
    fn identity() -> Self {
        Self::shift([R::ZERO; 3])
    }
    fn shift([x, y, z]: [R; 3]) -> Self {
        let (zero, one) = (R::ZERO, R::ONE);
        let rows = [[one, zero, zero, x], [zero, one, zero, y], [zero, zero, one, z]];
        Self(matrix::homogeneous(rows))
    }
    fn turn(axis: [R; 3], angle: R) -> Self {
        let rows = matrix::about(axis, angle).map(|[x, y, z]| [x, y, z, R::ZERO]);
        Self(matrix::homogeneous(rows))
    }
    fn times(self, other: Self) -> Self {
        Self(matrix::product(self.0, other.0))
    }
    fn to_matrix(self) -> Matrix<f64, 3, 4> {
        let [a, b, c, _] = self.0;
        [a, b, c].map(|row| row.map(Into::into))
    }
    fn norm_error(self) -> f64 {
        (Matrix3::from(matrix::left(self.to_matrix())).determinant() - 1.0).abs()
    }
}

impl<R: Real> Homogeneous<R> {
    /// The 3×3 part made orthonormal by Gram and Schmidt.
    pub fn gram_schmidt(self) -> Self {
        let [a, b, c, last] = self.0;
        let [x, y, z] = matrix::gram_schmidt(matrix::left([a, b, c]));
        let row = |[p, q, r]: [R; 3], t: R| [p, q, r, t];
        Self([row(x, a[3]), row(y, b[3]), row(z, c[3]), last])
    }
}

impl<R: Real> Representation for DualQuat<R> {
    type Real = R;
    fn identity() -> Self {
        Self::IDENTITY
    }
    fn shift(translation: [R; 3]) -> Self {
        Self::from_translation(translation)
    }
    fn turn(axis: [R; 3], angle: R) -> Self {
        Self::from_rotation(Quat::from_axis_angle(axis, angle))
    }
    fn times(self, other: Self) -> Self {
        self * other
    }
    fn to_matrix(self) -> Matrix<f64, 3, 4> {
        self.cast::<f64>().to_matrix3x4()
    }
    fn norm_error(self) -> f64 {
        let exact = self.cast::<f64>();
        let (p, q) = (exact.real(), exact.dual());
        (p.norm() - 1.0).abs().max(p.dot(q).abs())
    }
}

/// A dual quaternion that is read by the matrix of Kenwright §13.1, w² + x² − y² − z² and
/// so on, without his `Normalize` before it. Where |p| is not 1 it scales by |p|² and does not
/// skew.
#[derive(Clone, Copy, Debug)]
pub struct Listing<R>(pub DualQuat<R>);

impl<R: Real> Representation for Listing<R> {
    type Real = R;
    fn identity() -> Self {
        Self(DualQuat::IDENTITY)
    }
    fn shift(translation: [R; 3]) -> Self {
        Self(DualQuat::from_translation(translation))
    }
    fn turn(axis: [R; 3], angle: R) -> Self {
        Self(DualQuat::from_rotation(Quat::from_axis_angle(axis, angle)))
    }
    fn times(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
    fn to_matrix(self) -> Matrix<f64, 3, 4> {
        let motion = self.0.cast::<f64>();
        let [w, x, y, z] = motion.real().to_wxyz();
        let [tx, ty, tz] = motion.translation();
        [
            [w * w + x * x - y * y - z * z, 2.0 * (x * y - w * z), 2.0 * (x * z + w * y), tx],
            [2.0 * (x * y + w * z), w * w + y * y - x * x - z * z, 2.0 * (y * z - w * x), ty],
            [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), w * w + z * z - x * x - y * y, tz],
        ]
    }
    fn norm_error(self) -> f64 {
        self.0.norm_error()
    }
}

/// `Normalize` of Kenwright §13.1, which divides by the square of the norm and leaves p·q alone.
pub fn kenwright_normalize<R: Real>(motion: DualQuat<R>) -> DualQuat<R> {
    motion.scale(R::ONE / motion.real().dot(motion.real()))
}

/// A quaternion and a vector.
impl<R: Real> Representation for RotationTranslation<R> {
    type Real = R;
    fn identity() -> Self {
        Self::IDENTITY
    }
    fn shift(translation: [R; 3]) -> Self {
        Self { translation, ..Self::IDENTITY }
    }
    fn turn(axis: [R; 3], angle: R) -> Self {
        Self { rotation: Quat::from_axis_angle(axis, angle), ..Self::IDENTITY }
    }
    fn times(self, other: Self) -> Self {
        self * other
    }
    fn to_matrix(self) -> Matrix<f64, 3, 4> {
        let turned = self.rotation.cast::<f64>().to_matrix3();
        core::array::from_fn(|i| {
            let [x, y, z] = turned[i];
            [x, y, z, self.translation[i].into()]
        })
    }
    fn norm_error(self) -> f64 {
        (self.rotation.cast::<f64>().norm() - 1.0).abs()
    }
}

/// With a unit quaternion.
pub fn with_unit_rotation<R: Real>(pose: RotationTranslation<R>) -> RotationTranslation<R> {
    RotationTranslation { rotation: pose.rotation.normalize(), ..pose }
}

use super::{OrthonormalError, Polar};
use crate::geometry::Plane;
use crate::number::Real;
use crate::scalar::{DualQuat, vector};
use core::ops::Mul;

crate::macros::pod! {
    /// A linear map and a translation, v ↦ Lv + t: what a 3×4 matrix can hold and a dual
    /// quaternion cannot, scale, shear and reflection.
    ///
    /// # Why a dual quaternion cannot
    ///
    /// For any σ = p + εq, unit or not, σ(1 + εv)σ⋄ = pp* + ε(pvp* + qp* − pq*). The real
    /// part is the number |p|², and the only term with v is pvp*: a rotation times |p|². As a
    /// point, with the real part 1, it is that rotation and a translation, so *every* σ with p ≠
    /// 0 keeps distances and handedness. A dual part that is not divided scales uniformly, by the
    /// factor of Arends ch. 5 §6.1, but with a real part other than 1 it is not a point any more.
    /// Nor does any other single product avb of quaternions: its norm is the product of the norms,
    /// so it lengthens all vectors alike, and neither scales directions differently nor shears. A
    /// reflection is one with another sign, nvn ([`reflection`](Self::reflection)).
    ///
    /// *Sums* of products do all of it, as sums avb are all linear maps of the quaternions. Arends'
    /// own eq. 8, ½(v ∓ eve⁻¹) for what is across and along e, scales along e with a factor
    /// on the second part, and v + (a/2)(v + jvj⁻¹)k shears, though his ch. 5 §6.1 and §6.3
    /// say that quaternions cannot. But a sum is no longer a product of motions: it composes by
    /// nothing simpler than matrices.
    ///
    /// So scale is carried along with the motion: [`try_decompose`](Self::try_decompose) takes them
    /// apart.
    ///
    /// ```
    /// use dq8::{DualQuat, representation::Affine};
    /// let moved = DualQuat::from_translation([0.0, 0.0, 5.0_f64]);
    /// let thin = Affine::scale([1.0, 2.0, 0.5]);
    /// let (motion, stretch) = (Affine::from_motion(moved) * thin).try_decompose()?;
    /// assert_eq!((motion, stretch), (moved, thin.linear));
    /// # Ok::<(), dq8::representation::OrthonormalError>(())
    /// ```
    #[derive(Clone, Copy, Debug, PartialEq)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
    pub struct Affine<R> {
        /// L, rows.
        pub linear: [[R; 3]; 3],
        /// t
        pub translation: [R; 3],
    }
}

/// The identity.
impl<R: Real> Default for Affine<R> {
    fn default() -> Self {
        Self::IDENTITY
    }
}

impl<R: Real> Affine<R> {
    /// The map that leaves every point where it is.
    pub const IDENTITY: Self = Self {
        linear: [
            [R::ONE, R::ZERO, R::ZERO],
            [R::ZERO, R::ONE, R::ZERO],
            [R::ZERO, R::ZERO, R::ONE],
        ],
        translation: [R::ZERO; 3],
    };

    /// A rigid motion; σ must be unit.
    #[must_use]
    pub fn from_motion(motion: DualQuat<R>) -> Self {
        Self { linear: motion.rotation().to_matrix3(), translation: motion.translation() }
    }

    /// From the rows of [L | t].
    #[must_use]
    pub fn from_matrix3x4(rows: [[R; 4]; 3]) -> Self {
        Self { linear: rows.map(|[x, y, z, _]| [x, y, z]), translation: rows.map(|[.., t]| t) }
    }

    /// The rows of [L | t].
    #[must_use]
    pub fn to_matrix3x4(self) -> [[R; 4]; 3] {
        core::array::from_fn(|row| {
            let [x, y, z] = self.linear[row];
            [x, y, z, self.translation[row]]
        })
    }

    /// v ↦ βv (Arends ch. 2 §7.1).
    #[must_use]
    pub fn uniform_scale(factor: R) -> Self {
        Self::scale([factor; 3])
    }

    /// v ↦ (β_x x, β_y y, β_z z) (Arends ch. 2 §7.1).
    #[must_use]
    pub fn scale([x, y, z]: [R; 3]) -> Self {
        let (zero, translation) = (R::ZERO, [R::ZERO; 3]);
        Self { linear: [[x, zero, zero], [zero, y, zero], [zero, zero, z]], translation }
    }

    /// v ↦ v + (n·v)s: the plane n·v = 1 slides by s, and the others in proportion. Arends'
    /// shear along z (ch. 2 §7.3) has n = (0, 0, 1) and s = (a, b, 0). Volumes are kept if s is
    /// orthogonal to n.
    ///
    /// ```
    /// use dq8::representation::Affine;
    /// let italic = Affine::shear([0.25_f32, 0.0, 0.0], [0.0, 1.0, 0.0]);
    /// assert_eq!(italic.transform_point([1.0, 4.0, 0.0]), [2.0, 4.0, 0.0]);
    /// ```
    #[must_use]
    pub fn shear(slide: [R; 3], normal: [R; 3]) -> Self {
        let linear = core::array::from_fn(|row| {
            vector::add(Self::IDENTITY.linear[row], vector::scale(normal, slide[row]))
        });
        Self { linear, translation: [R::ZERO; 3] }
    }

    /// v ↦ v − 2(n·v − d)n, the mirror image in the plane n·v = d, whose normal must have
    /// length 1. For pure quaternions that is nvn + 2dn (Arends ch. 5 §6.2, p′ = qpq, which has
    /// d = 0).
    ///
    /// ```
    /// use dq8::{Plane, representation::Affine};
    /// let floor = Plane { normal: [0.0_f32, 0.0, 1.0], offset: 3.0 };
    /// assert_eq!(Affine::reflection(floor).transform_point([1.0, 2.0, 4.0]), [1.0, 2.0, 2.0]);
    /// ```
    #[must_use]
    pub fn reflection(plane: Plane<R>) -> Self {
        let twice = vector::scale(plane.normal, R::TWO);
        let flip = Self::shear(twice.map(|c| -c), plane.normal);
        Self { translation: vector::scale(twice, plane.offset), ..flip }
    }

    /// The point Lv + t.
    #[must_use]
    pub fn transform_point(self, point: [R; 3]) -> [R; 3] {
        vector::add(self.transform_vector(point), self.translation)
    }

    /// The direction Lv. Normals of surfaces do not move so, unless L is a rotation.
    #[must_use]
    pub fn transform_vector(self, vector: [R; 3]) -> [R; 3] {
        self.linear.map(|row| vector::dot(row, vector))
    }

    /// σ and S with Lv + t = σ applied to Sv: first a stretch along three orthogonal directions,
    /// then a rigid motion, by the polar decomposition of L ([`Polar`]; Shoemake & Duff 1992). If
    /// the map mirrors, S does: all its eigenvalues are negative.
    ///
    /// # Errors
    /// If an element is not finite, or L squeezes space into a line or a point.
    pub fn try_decompose(self) -> Result<(DualQuat<R>, [[R; 3]; 3]), OrthonormalError> {
        for (row, value) in self.translation.into_iter().enumerate() {
            if !value.is_finite() {
                let column = self.linear.len();
                return Err(OrthonormalError::NotFinite { row, column, value: value.into() });
            }
        }
        let Polar { rotation, stretch, .. } = Polar::try_from_matrix3(self.linear)?;
        Ok((DualQuat::from_rotation_translation(rotation, self.translation), stretch))
    }
}

/// `other`, then `self`.
impl<R: Real> Mul for Affine<R> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let columns: [[R; 3]; 3] = core::array::from_fn(|column| {
            self.transform_vector(other.linear.map(|row| row[column]))
        });
        Self {
            linear: core::array::from_fn(|row| columns.map(|column| column[row])),
            translation: self.transform_point(other.translation),
        }
    }
}

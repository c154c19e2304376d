use super::{OrthonormalError, Polar};
use crate::geometry::Plane;
use crate::number::Real;
use crate::scalar::{DualQuat, vector};
use core::ops::Mul;

crate::macros::pod! {
    /// A linear map and a translation, v ↦ Lv + t. It holds scale, shear and reflection, which a
    /// 3×4 matrix can hold and a dual quaternion cannot.
    ///
    /// # Why a dual quaternion cannot
    ///
    /// For any σ = p + εq, unit or not, σ(1 + εv)σ⋄ = pp* + ε(pvp* + qp* − pq*). The real
    /// part is the number |p|², and the only term with v is pvp*, a rotation times |p|². Divided
    /// by |p|² to be a point again, with the real part 1, it is a rotation and a translation. So
    /// *every* σ with p ≠ 0 keeps distances and handedness. If the dual part alone is taken as
    /// the point, without the division by |p|², the map scales uniformly, by the factor of Arends
    /// ch. 5 §6.1. But a dual quaternion with a real part other than 1 is not a point. No other
    /// single product avb of quaternions helps: its norm is the product of the norms, so it
    /// lengthens all vectors alike, and neither scales directions differently nor shears. A
    /// reflection is the product nvn, which also keeps lengths ([`reflection`](Self::reflection)).
    ///
    /// *Sums* of products can do all of this, because every linear map of the quaternions is a sum
    /// of products avb. Arends' own eq. 8, ½(v ∓ eve⁻¹) for the parts of v orthogonal to e
    /// and along e, scales along e if its second part is multiplied by a factor, and v + (a/2)(v +
    /// jvj⁻¹)k shears, although his ch. 5 §6.1 and §6.3 say that quaternions cannot. But a sum
    /// is no longer a product of motions: composing such sums is no simpler than multiplying
    /// matrices.
    ///
    /// So scale is stored beside the motion: [`try_decompose`](Self::try_decompose) splits a map
    /// into a motion and a stretch.
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
        /// The matrix L as rows.
        pub linear: [[R; 3]; 3],
        /// The translation t.
        pub translation: [R; 3],
    }
}

/// The default is the identity.
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

    /// Returns the map of a rigid motion σ = `motion`, which must be unit.
    #[must_use]
    pub fn from_motion(motion: DualQuat<R>) -> Self {
        Self { linear: motion.rotation().to_matrix3(), translation: motion.translation() }
    }

    /// Makes a map from the rows of [L | t].
    #[must_use]
    pub fn from_matrix3x4(rows: [[R; 4]; 3]) -> Self {
        Self { linear: rows.map(|[x, y, z, _]| [x, y, z]), translation: rows.map(|[.., t]| t) }
    }

    /// Returns the rows of [L | t].
    #[must_use]
    pub fn to_matrix3x4(self) -> [[R; 4]; 3] {
        core::array::from_fn(|row| {
            let [x, y, z] = self.linear[row];
            [x, y, z, self.translation[row]]
        })
    }

    /// Returns the map v ↦ βv with β = `factor` (Arends ch. 2 §7.1).
    #[must_use]
    pub fn uniform_scale(factor: R) -> Self {
        Self::scale([factor; 3])
    }

    /// Returns the map v ↦ (β_x x, β_y y, β_z z) with the factors β (Arends ch. 2 §7.1).
    #[must_use]
    pub fn scale([x, y, z]: [R; 3]) -> Self {
        let (zero, translation) = (R::ZERO, [R::ZERO; 3]);
        Self { linear: [[x, zero, zero], [zero, y, zero], [zero, zero, z]], translation }
    }

    /// Returns the map v ↦ v + (n·v)s, where s is `slide` and n is `normal`: the plane n·v = 1
    /// slides by s, and parallel planes slide in proportion. Arends' shear along z (ch. 2 §7.3)
    /// has n = (0, 0, 1) and s = (a, b, 0). Volumes are kept if s is orthogonal to n.
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

    /// Returns the map v ↦ v − 2(n·v − d)n, the mirror image in the plane n·v = d, whose
    /// normal must have length 1. With pure quaternions it is nvn + 2dn (Arends ch. 5 §6.2 has
    /// p′ = qpq, for d = 0).
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

    /// Returns the point Lv + t.
    #[must_use]
    pub fn transform_point(self, point: [R; 3]) -> [R; 3] {
        vector::add(self.transform_vector(point), self.translation)
    }

    /// Returns the direction Lv. Normals of surfaces transform differently, unless L is a rotation.
    #[must_use]
    pub fn transform_vector(self, vector: [R; 3]) -> [R; 3] {
        self.linear.map(|row| vector::dot(row, vector))
    }

    /// Returns σ and S such that Lv + t is σ applied to Sv: first the stretch S along three
    /// orthogonal directions, then the rigid motion σ. They come from the polar decomposition of L
    /// ([`Polar`]; Shoemake & Duff 1992). If the map mirrors, S mirrors: all its eigenvalues are
    /// negative.
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

/// The product applies `other` first, then `self`.
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

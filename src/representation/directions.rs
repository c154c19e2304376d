//! Rotations from an axis and an angle (Kenwright §3.4), rotations about the coordinate axes, and
//! rotations and poses made from directions.

use super::OrthonormalError;
use super::polar::gram_schmidt;
use crate::number::Real;
use crate::scalar::{DualQuat, Quat, vector};

impl<R: Real> Quat<R> {
    /// Returns the axis n, of length 1, and the angle θ in [0, π] radians of a unit quaternion,
    /// where ±q = cos(θ/2) + n sin(θ/2). Of q and −q, the
    /// [canonical](crate::DualQuat::canonical) quaternion is taken. It has w ≥ 0, and for half a
    /// turn, where both n and −n are axes, the first component of n that is not zero is positive.
    /// The identity has the axis (1, 0, 0).
    ///
    /// The angle is twice the arctangent of |n sin(θ/2)| and w, which is accurate for all angles.
    /// The alternative 2 arccos w loses half of the digits of a small angle.
    ///
    /// ```
    /// use dq8::Quat;
    /// let (axis, angle) = Quat::from_axis_angle([0.0, 0.6, 0.8], 1e-30_f64).to_axis_angle();
    /// assert_eq!((axis, angle), ([0.0, 0.6, 0.8], 1e-30));
    /// ```
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn to_axis_angle(self) -> ([R; 3], R) {
        crate::scalar::must_be_unit::rotations("Quat::to_axis_angle", [self]);
        let short = if self.points_back() { -self } else { self };
        let sine = vector::norm(short.xyz());
        if sine == R::ZERO {
            // The quaternion has no vector part, so the angle is zero, or NaN if w is NaN.
            return ([R::ONE, R::ZERO, R::ZERO], R::ZERO * short.w());
        }
        (vector::direction(short.xyz(), sine), R::TWO * sine.atan2(short.w()))
    }

    /// Returns the turn by |v| radians about the direction of v, which is the exponential of v/2.
    /// The vector v may have any length; for a large angle, the rounding error of the angle limits
    /// the accuracy.
    ///
    /// ```
    /// use dq8::Quat;
    /// assert_eq!(Quat::from_scaled_axis([0.0_f32; 3]), Quat::IDENTITY);
    /// ```
    #[doc(alias("from_rotvec", "rotvec", "rotation_vector", "exp3"))]
    pub fn from_scaled_axis(v: [R; 3]) -> Self {
        // For so small an angle, cos(θ/2) = 1 and sin(θ/2)/θ = ½ to the last place. These
        // constants also keep derivatives finite if R is a dual number.
        if vector::dot(v, v) < R::EPSILON {
            return Self::from_parts(vector::scale(v, R::HALF), R::ONE);
        }
        let angle = vector::norm(v);
        let half = angle * R::HALF;
        Self::from_parts(vector::scale(v, half.sin() / angle), half.cos())
    }

    /// Returns the axis of a unit quaternion times its angle, a vector with a length in [0, π]
    /// (radians). Axis and angle are those of [`to_axis_angle`](Self::to_axis_angle). The identity
    /// gives zero.
    ///
    /// ```
    /// use dq8::Quat;
    /// let half_turn = Quat::from_xyzw(0.0_f64, 1.0, 0.0, 0.0);
    /// assert_eq!(half_turn.to_scaled_axis(), [0.0, core::f64::consts::PI, 0.0]);
    /// ```
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    #[doc(alias("as_rotvec", "rotvec", "rotation_vector", "log3"))]
    pub fn to_scaled_axis(self) -> [R; 3] {
        crate::scalar::must_be_unit::rotations("Quat::to_scaled_axis", [self]);
        let short = if self.points_back() { -self } else { self };
        let squared = vector::dot(short.xyz(), short.xyz());
        // For so small an angle, θ/sin(θ/2) = 2/cos(θ/2) to the last place. This form also keeps
        // derivatives finite if R is a dual number.
        let scale = if squared < R::EPSILON {
            R::TWO / short.w()
        } else {
            let sine = squared.sqrt();
            R::TWO * sine.atan2(short.w()) / sine
        };
        vector::scale(short.xyz(), scale)
    }
}

impl<R: Real> Quat<R> {
    /// Returns the turn by `angle` radians about the x axis, cos(θ/2) + i sin(θ/2).
    ///
    /// ```
    /// use dq8::Quat;
    /// let [x, y, z] = Quat::from_rotation_x(core::f64::consts::FRAC_PI_2).rotate([0.0, 1.0, 0.0]);
    /// assert!(x == 0.0 && y.abs() < 1e-15 && (z - 1.0).abs() < 1e-15);
    /// ```
    pub fn from_rotation_x(angle: R) -> Self {
        Self::from_axis_angle([R::ONE, R::ZERO, R::ZERO], angle)
    }

    /// Returns the turn by `angle` radians about the y axis, cos(θ/2) + j sin(θ/2).
    pub fn from_rotation_y(angle: R) -> Self {
        Self::from_axis_angle([R::ZERO, R::ONE, R::ZERO], angle)
    }

    /// Returns the turn by `angle` radians about the z axis, cos(θ/2) + k sin(θ/2).
    pub fn from_rotation_z(angle: R) -> Self {
        Self::from_axis_angle([R::ZERO, R::ZERO, R::ONE], angle)
    }

    /// Returns the smallest turn that takes the direction of `from` to the direction of `to`, two
    /// vectors of any length. For unit vectors a and b, with n along a × b, it is |a + b|/2 + n |b
    /// − a|/2 (after Kahan 2006). Between opposite directions there are many such turns. The turn
    /// returned is about the axis orthogonal to `from` that is nearest to the coordinate axis
    /// farthest from `from`. The result is NaN for a zero vector.
    ///
    /// The lengths |a + b| and |b − a| are accurate for the smallest angles and near half a turn,
    /// where the scalar product a·b would have lost digits.
    ///
    /// ```
    /// use dq8::Quat;
    /// let turn = Quat::from_rotation_arc([1.0_f64, 0.0, 0.0], [0.0, 0.0, 2.0]);
    /// let [x, y, z] = turn.rotate([1.0, 0.0, 0.0]);
    /// assert!(x.abs() < 1e-15 && y == 0.0 && (z - 1.0).abs() < 1e-15);
    /// ```
    #[doc(alias("rotation_between", "from_two_vectors", "shortest_arc"))]
    pub fn from_rotation_arc(from: [R; 3], to: [R; 3]) -> Self {
        let (a, b) = (unit(from), unit(to));
        let (sum, difference) = (vector::add(a, b), vector::sub(b, a));
        let across = vector::cross(sum, difference);
        let length = vector::norm(across);
        let (cosine, sine) = (vector::norm(sum), vector::norm(difference));
        let axis = if length == R::ZERO {
            // The directions are opposite or equal. A turn about any axis orthogonal to a direction
            // takes it to its opposite. For equal directions the sine is zero, so the axis has no
            // effect.
            vector::any_across(a)
        } else {
            vector::direction(across, length)
        };
        Self::from_parts(vector::scale(axis, sine), cosine).normalize()
    }

    /// Returns the rotation that takes the z axis to the direction `forward`, and the y axis as
    /// near to `up` as possible. The lengths of the vectors do not matter. For cameras that look
    /// along −z (glTF, OpenGL), pass −forward.
    ///
    /// # Errors
    /// If a vector is zero (the error has column 0 for `forward` and 1 for `up`) or not finite, or
    /// if the two vectors are parallel.
    ///
    /// ```
    /// use dq8::Quat;
    /// let turn = Quat::look_to([3.0_f64, 0.0, 0.0], [0.0, 1.0, 0.0])?;
    /// let [x, y, z] = turn.rotate([0.0, 0.0, 1.0]);
    /// assert!((x - 1.0).abs() < 1e-15 && y.abs() + z.abs() < 1e-15);
    /// # Ok::<(), dq8::representation::OrthonormalError>(())
    /// ```
    #[doc(alias("face_towards", "look_rotation"))]
    pub fn look_to(forward: [R; 3], up: [R; 3]) -> Result<Self, OrthonormalError> {
        for (column, direction) in [forward, up].into_iter().enumerate() {
            if vector::largest(direction) == R::ZERO {
                return Err(OrthonormalError::Dependent { column, sine: 0.0 });
            }
        }
        let side = vector::cross(unit(forward), unit(up));
        let columns = gram_schmidt([0, 1, 2].map(|row| [forward[row], up[row], side[row]]))?;
        // The cross product forward × up has the direction −x.
        Ok(Self::from_matrix3(columns.map(|[z, y, side]| [-side, y, z])))
    }

    /// Changes signs in a sequence of quaternions: q becomes −q where −q is nearer than q to
    /// the previous quaternion. q and −q are the same rotation, but sums, differences and plots
    /// depend on the sign. The first quaternion keeps its sign.
    ///
    /// ```
    /// use dq8::Quat;
    /// let mut samples = [0.0_f32, 0.1, 0.2].map(Quat::from_rotation_x);
    /// samples[1] = -samples[1];
    /// Quat::make_continuous(&mut samples);
    /// assert!(samples.iter().all(|q| q.w() > 0.9));
    /// ```
    pub fn make_continuous(samples: &mut [Self]) {
        make_continuous(samples, Self::dot);
    }
}

impl<R: Real> DualQuat<R> {
    /// Returns the pose at `eye` whose z axis points to `target`, and whose y axis is as near to
    /// `up` as possible: [`Quat::look_to`] with a translation. Its inverse is the view transform of
    /// a camera that looks along z.
    ///
    /// # Errors
    /// If `target` equals `eye`, `up` is zero or parallel to the direction from `eye` to `target`,
    /// or a coordinate is not finite.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// let camera = DualQuat::look_at([0.0_f64, 0.0, 5.0], [0.0; 3], [0.0, 1.0, 0.0])?;
    /// let [_, _, depth] = camera.conjugate().transform_point([0.0; 3]);
    /// assert!((depth - 5.0).abs() < 1e-15);
    /// # Ok::<(), dq8::representation::OrthonormalError>(())
    /// ```
    pub fn look_at(eye: [R; 3], target: [R; 3], up: [R; 3]) -> Result<Self, OrthonormalError> {
        let rotation = Quat::look_to(vector::sub(target, eye), up)?;
        Ok(Self::from_rotation_translation(rotation, eye))
    }

    /// Changes signs like [`Quat::make_continuous`]: σ becomes −σ where −p is nearer than p
    /// to the real part of the previous motion.
    pub fn make_continuous(samples: &mut [Self]) {
        make_continuous(samples, |a, b| a.real().dot(b.real()));
    }
}

fn unit<R: Real>(v: [R; 3]) -> [R; 3] {
    vector::direction(v, vector::norm(v))
}

fn make_continuous<T: Copy + core::ops::Neg<Output = T>, R: Real>(
    samples: &mut [T],
    dot: impl Fn(T, T) -> R,
) {
    let mut before = None;
    for sample in samples {
        if before.is_some_and(|before| dot(before, *sample) < R::ZERO) {
            *sample = -*sample;
        }
        before = Some(*sample);
    }
}

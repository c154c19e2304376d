//! Rotations from an axis and an angle (Kenwright §3.4), about the coordinate axes, and rotations
//! and poses that are told by directions.

use super::OrthonormalError;
use super::polar::gram_schmidt;
use crate::number::Real;
use crate::scalar::{DualQuat, Quat, vector};

impl<R: Real> Quat<R> {
    /// The axis, of length 1, and the angle in [0, π] radians of a unit quaternion, n and θ of
    /// ±q = cos(θ/2) + n sin(θ/2). Of ±q the [canonical](crate::DualQuat::canonical) one is
    /// taken: w ≥ 0, and at half a turn, where both n and −n are axes, the first component of n
    /// that is not zero is positive. No turn has the axis (1, 0, 0).
    ///
    /// The angle is twice the arctangent of |n sin(θ/2)| and w, accurate for all angles, where
    /// 2 arccos w loses half of the digits of a small one.
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
            // The angle is zero if there is no turn, and NaN if w is NaN.
            return ([R::ONE, R::ZERO, R::ZERO], R::ZERO * short.w());
        }
        (vector::direction(short.xyz(), sine), R::TWO * sine.atan2(short.w()))
    }

    /// The turn by |v| radians about the direction of v, the exponential of v/2. Any v; the error
    /// of a large angle is that of its rounding.
    ///
    /// ```
    /// use dq8::Quat;
    /// assert_eq!(Quat::from_scaled_axis([0.0_f32; 3]), Quat::IDENTITY);
    /// ```
    #[doc(alias("from_rotvec", "rotvec", "rotation_vector", "exp3"))]
    pub fn from_scaled_axis(v: [R; 3]) -> Self {
        // cos(θ/2) and sin(θ/2)/θ are 1 and ½ to the last place, and their derivatives finite.
        if vector::dot(v, v) < R::EPSILON {
            return Self::from_parts(vector::scale(v, R::HALF), R::ONE);
        }
        let angle = vector::norm(v);
        let half = angle * R::HALF;
        Self::from_parts(vector::scale(v, half.sin() / angle), half.cos())
    }

    /// The axis of a unit quaternion times the angle, of length [0, π], as
    /// [`to_axis_angle`](Self::to_axis_angle) has them; zero for no turn.
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
        // θ/sin(θ/2) is 2/cos(θ/2) to the last place, and its derivative finite.
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
    /// The turn by `angle` radians about the x axis, cos(θ/2) + i sin(θ/2).
    ///
    /// ```
    /// use dq8::Quat;
    /// let [x, y, z] = Quat::from_rotation_x(core::f64::consts::FRAC_PI_2).rotate([0.0, 1.0, 0.0]);
    /// assert!(x == 0.0 && y.abs() < 1e-15 && (z - 1.0).abs() < 1e-15);
    /// ```
    pub fn from_rotation_x(angle: R) -> Self {
        Self::from_axis_angle([R::ONE, R::ZERO, R::ZERO], angle)
    }

    /// The turn by `angle` radians about the y axis, cos(θ/2) + j sin(θ/2).
    pub fn from_rotation_y(angle: R) -> Self {
        Self::from_axis_angle([R::ZERO, R::ONE, R::ZERO], angle)
    }

    /// The turn by `angle` radians about the z axis, cos(θ/2) + k sin(θ/2).
    pub fn from_rotation_z(angle: R) -> Self {
        Self::from_axis_angle([R::ZERO, R::ZERO, R::ONE], angle)
    }

    /// The least turn that takes the direction of `from` to that of `to`, two vectors of any
    /// length: with unit vectors a and b, and n along a × b, it is |a + b|/2 + n |b − a|/2
    /// (after Kahan 2006). Where they are opposite there are many; this takes the axis most across
    /// `from`. NaN for a zero vector.
    ///
    /// The sum and the difference keep what a·b has lost, both of the smallest angles and near
    /// half a turn.
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
            // The directions are exactly opposite or the same. The sine is then zero, and any axis
            // across will do.
            vector::any_across(a)
        } else {
            vector::direction(across, length)
        };
        Self::from_parts(vector::scale(axis, sine), cosine).normalize()
    }

    /// The rotation that takes the z axis to the direction `forward` and the y axis as near to `up`
    /// as that allows; the lengths do not matter. Cameras that look along −z (glTF, OpenGL) give
    /// −forward.
    ///
    /// # Errors
    /// If a vector is zero (column 0 of the error is `forward`, 1 is `up`), not finite, or one is
    /// along the other.
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
        // forward × up is −x.
        Ok(Self::from_matrix3(columns.map(|[z, y, side]| [-side, y, z])))
    }

    /// Turns the signs of a sequence such that each is the nearer one of ±q to the one before:
    /// both are the same rotation, but sums, differences and plots are of numbers. The first stays.
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
    /// The pose at `eye` whose z axis points to `target`, and its y axis as near to `up` as that
    /// allows: [`Quat::look_to`] and the translation. The inverse is the view transform of a camera
    /// that looks along z.
    ///
    /// # Errors
    /// If `target` is `eye`, `up` is zero or along the way from one to the other, or a number is
    /// not finite.
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

    /// [`Quat::make_continuous`] of motions: the nearer of ±σ by the real parts.
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

use super::euler_order::EulerOrder;

/// Three turns about coordinate axes, one after the other (Kenwright §3.3; Arends ch. 2 §2).
///
/// Good for typing a pose in and reading it out; compute with the quaternion. Euler angles do not
/// commute, have no short way between two of them, and lose a degree of freedom where the first and
/// the last axis meet: see [`EulerSolution`].
///
/// ```
/// use core::f64::consts::FRAC_PI_2;
/// use dq8::{representation::{EulerAngles, EulerAxes, EulerFrame, EulerOrder}};
/// let order = EulerOrder { axes: EulerAxes::XYZ, frame: EulerFrame::Extrinsic };
/// let turns = EulerAngles { angles: [FRAC_PI_2, 0.0, FRAC_PI_2], order };
/// // y to z about x, and z stays about z.
/// let [x, y, z] = turns.to_quat().rotate([0.0, 1.0, 0.0]);
/// assert!(x.abs() + y.abs() + (z - 1.0).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EulerAngles<R> {
    /// Radians, first turn first, about the axes of the order.
    pub angles: [R; 3],
    /// The axes, and whose.
    pub order: EulerOrder,
}

/// The Euler angles of a rotation, and whether they are one choice of many.
///
/// Where the first and the last axis fall together (the middle angle at ±π/2 with three different
/// axes, at 0 or π with a proper order), only the sum or the difference of the outer angles is known:
/// *gimbal lock* (Kenwright §3.3.3; Arends ch. 2 §5 writes out the products for θ = π/2 and θ = 0).
/// Within rounding of that the middle angle is exactly there, **the last angle is zero**, the first
/// one has the whole turn, and `gimbal_lock` is set: the rotation does not have the missing number.
///
/// Near the lock the angles are still those of the rotation, but an error of δ in it moves the outer
/// ones by δ over the sine of the angle between the two axes, and their sum or difference by δ only.
///
/// `R` is a number and `B` a `bool`; or both are lanes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EulerSolution<R, B = bool> {
    /// The angles, with the order they were asked for.
    pub angles: EulerAngles<R>,
    /// The first and the last axis are parallel within 4 units of the last place of 1, in radians, so
    /// the last angle was chosen to be 0.
    pub gimbal_lock: B,
}

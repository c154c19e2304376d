//! Three turns about coordinate axes, one after the other.

use crate::number::Real;
use crate::scalar::{Quat, vector};

/// Three turns about coordinate axes, one after the other (Kenwright §3.3; Arends ch. 2 §2).
///
/// Euler angles suit the input and the display of rotations; computations should use the
/// quaternion. The order of the three turns matters, interpolating the angles does not take the
/// shortest way, and where the first and the last axis coincide, a degree of freedom is lost
/// ([`EulerSolution`]).
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
    /// The three angles in radians, the angle of the first turn first. The axes of the turns are in
    /// `order`.
    pub angles: [R; 3],
    /// The axes of the turns, and whether they move with the body or stay fixed.
    pub order: EulerOrder,
}

/// The Euler angles of a rotation, and a flag that is `true` in gimbal lock, where other angles
/// give the same rotation.
///
/// If the first and the last axis coincide (the middle angle is ±π/2 with three different axes,
/// or 0 or π with a proper order), only the sum or the difference of the first and the last angle
/// is determined. This is *gimbal lock* (Kenwright §3.3.3; Arends ch. 2 §5 writes out the
/// products for θ = π/2 and θ = 0). For a rotation that is within rounding errors of gimbal
/// lock, the returned middle angle is exactly ±π/2, 0 or π, **the last angle is zero**, the
/// first angle is the whole sum or difference, and `gimbal_lock` is set.
///
/// Near gimbal lock the angles are still those of the rotation, but they are sensitive: an error δ
/// of the rotation changes the first and the last angle by δ divided by the sine of the angle
/// between their axes. The sum or the difference of both changes by δ only.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EulerSolution<R> {
    /// The angles, in the order that the caller asked for.
    pub angles: EulerAngles<R>,
    /// `true` if the first and the last axis are parallel within 4 units of the last place of 1, in
    /// radians. The last angle was then chosen to be 0.
    pub gimbal_lock: bool,
}

impl<R: Real> EulerAngles<R> {
    /// Returns the unit quaternion of the three turns in the given order. Angles of any size are
    /// allowed. `order.frame` tells whether the axes move with the body or stay fixed.
    pub fn to_quat(self) -> Quat<R> {
        let mut turns = [Quat::IDENTITY; 3];
        for (turn, (axis, angle)) in
            turns.iter_mut().zip(self.order.axes.indices().into_iter().zip(self.angles))
        {
            let mut unit = [R::ZERO; 3];
            unit[axis] = R::ONE;
            *turn = Quat::from_axis_angle(unit, angle);
        }
        let [first, second, third] = turns;
        match self.order.frame {
            EulerFrame::Intrinsic => first * second * third,
            EulerFrame::Extrinsic => third * second * first,
        }
    }
}

impl<R: Real> Quat<R> {
    /// Returns the rotation of three Euler angles, the angle of the first turn first; it calls
    /// [`EulerAngles::to_quat`].
    ///
    /// ```
    /// use dq8::{Quat, representation::{EulerAxes, EulerFrame, EulerOrder}};
    /// let order = EulerOrder { axes: EulerAxes::ZYX, frame: EulerFrame::Intrinsic };
    /// let turn = Quat::from_euler(order, 0.3_f64, 0.0, 0.0);
    /// assert!(turn.abs_diff_eq(Quat::from_rotation_z(0.3), 1e-15));
    /// ```
    pub fn from_euler(order: EulerOrder, first: R, second: R, third: R) -> Self {
        EulerAngles { angles: [first, second, third], order }.to_quat()
    }

    /// Returns the turn by `roll` radians about x, then `pitch` about y, then `yaw` about z, all
    /// about fixed axes. This is the convention of URDF's `rpy`.
    ///
    /// ```
    /// use core::f64::consts::FRAC_PI_2;
    /// use dq8::Quat;
    /// let turn = Quat::from_rpy(FRAC_PI_2, 0.0, FRAC_PI_2);
    /// // Roll takes y up, and yaw leaves it there.
    /// let [x, y, z] = turn.rotate([0.0, 1.0, 0.0]);
    /// assert!(x.abs() < 1e-15 && y.abs() < 1e-15 && (z - 1.0).abs() < 1e-15);
    /// ```
    #[doc(alias("from_euler_angles", "rpy", "roll_pitch_yaw"))]
    pub fn from_rpy(roll: R, pitch: R, yaw: R) -> Self {
        let order = EulerOrder { axes: EulerAxes::XYZ, frame: EulerFrame::Extrinsic };
        Self::from_euler(order, roll, pitch, yaw)
    }

    /// Returns the Euler angles of this unit quaternion; −q has the same angles to the last bit.
    /// The middle angle is in [−π/2, π/2] if the three axes differ, and in [0, π] if the last
    /// axis is the same as the first. The first and the last angle are in [−π, π]. The angles
    /// are NaN if a component is NaN.
    ///
    /// They are computed from the quaternion without a matrix (Bernardes & Viollet 2022). With
    /// extrinsic turns by α about i, β about j and γ about i, and k = ±i × j,
    ///
    /// ```text
    /// a + b√−1 = w + x_i√−1 = cos(β/2) exp(√−1 (α + γ)/2)
    /// c + d√−1 = x_j ± x_k√−1 = sin(β/2) exp(√−1 (γ − α)/2)
    /// ```
    ///
    /// If the three axes differ, a quarter of a turn about j first leads to the same formulas. The
    /// first and the last angle are then the arguments of products of the two complex numbers, and
    /// β is an arctangent of their lengths, so the result is as accurate near gimbal lock as
    /// elsewhere. The arcsine of a matrix element, which is widely used, keeps only half of the
    /// digits there.
    ///
    /// ```
    /// use core::f32::consts::FRAC_PI_2;
    /// use dq8::{representation::{EulerAngles, EulerAxes, EulerFrame, EulerOrder}};
    /// let order = EulerOrder { axes: EulerAxes::ZYX, frame: EulerFrame::Intrinsic };
    /// // The nose straight up: yaw and roll are one turn.
    /// let up = EulerAngles { angles: [0.75, FRAC_PI_2, 0.5], order };
    /// let solution = up.to_quat().to_euler(order);
    /// let [yaw, pitch, roll] = solution.angles.angles;
    /// assert!(solution.gimbal_lock);
    /// assert!((yaw - 0.25).abs() < 1e-6 && (pitch - FRAC_PI_2).abs() < 1e-6 && roll == 0.0);
    /// ```
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn to_euler(self, order: EulerOrder) -> EulerSolution<R> {
        crate::scalar::must_be_unit::rotations("Quat::to_euler", [self]);
        let [first, j, last] = order.axes.indices();
        // Intrinsic turns are the same as extrinsic turns in the opposite order.
        let (i, reversed) = match order.frame {
            EulerFrame::Intrinsic => (last, true),
            EulerFrame::Extrinsic => (first, false),
        };
        let k = 3 - i - j;
        let handedness = if (i + 1) % 3 == j { R::ONE } else { -R::ONE };
        // The remainder changes nothing, but tells the compiler that no index is out of bounds.
        let (w, [x_i, x_j, x_k]) = (self.w(), [i, j, k].map(|axis| self.xyz()[axis % 3]));
        let x_k = handedness * x_k;

        // The two complex numbers are a + b√−1 and c + d√−1. Where one of them nearly
        // vanishes, the differences in its real and its imaginary part are exact except for the
        // rounding of q.
        let proper = order.axes.is_proper();
        let [a, b, c, d] =
            if proper { [w, x_i, x_j, x_k] } else { [w - x_j, x_i + x_k, w + x_j, x_k - x_i] };
        let (cosine, sine) = (vector::norm([a, b]), vector::norm([c, d]));
        // A complex number that is shorter than `least` times the other complex number consists of
        // rounding errors of q, so its argument has no meaning.
        let least = R::TWO * R::EPSILON;
        let (lowest, highest) = (sine <= least * cosine, cosine <= least * sine);
        let quarter = R::PI * R::HALF;
        let [low, high] = if proper { [R::ZERO, R::PI] } else { [-quarter, quarter] };
        // Adding +0 turns −0 into +0. Otherwise the argument would depend on the sign of a zero,
        // which may depend on the sign of q.
        let argument = |sine: R, cosine: R| (sine + R::ZERO).atan2(cosine);
        let [alpha, middle, gamma] = if lowest {
            let sum = argument(R::TWO * a * b, a * a - b * b);
            if reversed { [R::ZERO, low, sum] } else { [sum, low, R::ZERO] }
        } else if highest {
            let difference = argument(R::TWO * c * d, c * c - d * d);
            if reversed { [R::ZERO, high, difference] } else { [-difference, high, R::ZERO] }
        } else {
            let middle = if proper {
                R::TWO * sine.atan2(cosine)
            } else {
                // This is 2 (atan(sine/cosine) − π/4), computed without this difference, which
                // would lose the digits of a small β.
                let sum = sine + cosine;
                R::TWO * (R::from(4.0) * (w * x_j - x_i * x_k)).atan2(sum * sum)
            };
            [argument(b * c - a * d, a * c + b * d), middle, argument(b * c + a * d, a * c - b * d)]
        };
        let gamma = if proper { gamma } else { handedness * gamma };
        let angles = if reversed { [gamma, middle, alpha] } else { [alpha, middle, gamma] };
        EulerSolution { angles: EulerAngles { angles, order }, gimbal_lock: lowest || highest }
    }
}

/// The order of the axes of Euler angles, and the frame of the axes. There are 24 orders, listed in
/// [`EulerOrder::ALL`].
///
/// Kenwright (§3.3) speaks of twelve orders and prints eleven, three of them twice. There are six
/// orders with three different axes (Tait–Bryan) and six whose last axis is the same as the first
/// (proper Euler angles). In each of the twelve orders the axes may move with the body or stay
/// fixed.
///
/// ```
/// use dq8::{representation::{EulerAxes, EulerFrame, EulerOrder}};
/// // Yaw, pitch and roll of an aircraft.
/// let aircraft = EulerOrder { axes: EulerAxes::ZYX, frame: EulerFrame::Intrinsic };
/// assert!(EulerOrder::ALL.contains(&aircraft));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct EulerOrder {
    /// The three axes, the axis of the first turn first.
    pub axes: EulerAxes,
    /// The frame about whose axes the body turns.
    pub frame: EulerFrame,
}

/// The frame about whose axes the body turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum EulerFrame {
    /// The axes of the turning body: each turn moves the axes of the later turns, R = R₁R₂R₃.
    Intrinsic,
    /// The axes of the surrounding space, which stay fixed: R = R₃R₂R₁.
    Extrinsic,
}

/// Defines [`EulerAxes`] from the names of its variants and the indices of their axes.
macro_rules! axes {
    ($($name:ident [$($index:literal)*])*) => {
        /// The axes of three turns, the axis of the first turn first. Two successive axes are never
        /// equal.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[allow(missing_docs, reason = "the names are the axes")]
        pub enum EulerAxes { $($name),* }

        impl EulerAxes {
            /// All twelve choices of axes: the six Tait–Bryan orders with three different axes,
            /// then the six orders of proper Euler angles.
            pub const ALL: [Self; 12] = [$(Self::$name),*];

            /// Returns the axes as indices into a vector: x is 0, y is 1, z is 2.
            #[must_use]
            pub const fn indices(self) -> [usize; 3] {
                match self {
                    $(Self::$name => [$($index),*]),*
                }
            }
        }
    };
}
axes! {
    XYZ [0 1 2] XZY [0 2 1] YXZ [1 0 2] YZX [1 2 0] ZXY [2 0 1] ZYX [2 1 0]
    XYX [0 1 0] XZX [0 2 0] YXY [1 0 1] YZY [1 2 1] ZXZ [2 0 2] ZYZ [2 1 2]
}

impl EulerAxes {
    /// Returns `true` if the last axis is the same as the first (proper Euler angles). The middle
    /// angle is then in [0, π], otherwise in [−π/2, π/2].
    #[must_use]
    pub const fn is_proper(self) -> bool {
        let [first, _, last] = self.indices();
        first == last
    }
}

impl EulerOrder {
    /// All 24 orders: the axes in the order of [`EulerAxes::ALL`], first intrinsic and then
    /// extrinsic.
    pub const ALL: [Self; 24] = {
        let mut all = [Self { axes: EulerAxes::XYZ, frame: EulerFrame::Intrinsic }; 24];
        let mut index = 0;
        while index < 12 {
            let axes = EulerAxes::ALL[index];
            all[index] = Self { axes, frame: EulerFrame::Intrinsic };
            all[index + 12] = Self { axes, frame: EulerFrame::Extrinsic };
            index += 1;
        }
        all
    };
}

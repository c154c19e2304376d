//! [`Spline`]: control poses, and single times.

use crate::TrajectoryError;
use alloc::vec::Vec;
use dq8::scalar::lie_bracket;
use dq8::{DualQuat, Twist};

/// The way in which a [`Spline`] goes by its control poses.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Basis {
    /// A B-spline, which goes near them: twist and acceleration are continuous.
    #[default]
    Smooth,
    /// Catmull and Rom's (1974), which goes through all but the first and the last: its twist is
    /// continuous.
    Through,
}

impl Basis {
    /// λ₁, λ₂ and λ₃ as polynomials of u, the constant first.
    pub(super) const fn shares(self) -> [[f64; 4]; 3] {
        const SIXTH: f64 = 1.0 / 6.0;
        const THIRD: f64 = 1.0 / 3.0;
        match self {
            Self::Smooth => {
                [[5.0 * SIXTH, 0.5, -0.5, SIXTH], [SIXTH, 0.5, 0.5, -THIRD], [0.0, 0.0, 0.0, SIXTH]]
            }
            Self::Through => [[1.0, 0.5, -1.0, 0.5], [0.0, 0.5, 1.5, -1.0], [0.0, 0.0, -0.5, 0.5]],
        }
    }
}

/// A cubic spline by control poses at equal intervals of time, with twists and accelerations in
/// closed form.
///
/// Control pose k is at the time `start + every · (k − 1)`: the first stands before the
/// beginning, the last after the end, as four are needed between any two knots. From one control
/// pose to the next the shorter way counts.
///
/// ```
/// use dq8::DualQuat;
/// use dq8_trajectory::{Basis, Spline};
/// let x = [0.0, 1.0, 4.0, 9.0, 16.0];
/// let control = x.map(|x| DualQuat::from_translation([x, 0.0, 0.0]));
/// let through = Spline::new(10.0, 0.5, &control, Basis::Through)?;
/// assert_eq!(through.range(), [10.0, 11.0]);
/// assert_eq!(through.at(10.5).translation(), [4.0, 0.0, 0.0]);
/// // The derivatives of k² by the interval are 2k and 2. An interval is half a second here.
/// let moving = Spline::new(10.0, 0.5, &control, Basis::Smooth)?.moving_at(10.25);
/// assert!((moving.twist.linear[0] - 2.0 * 1.5 / 0.5).abs() < 1e-12);
/// assert!((moving.acceleration.linear[0] - 2.0 / 0.25).abs() < 1e-12);
/// # Ok::<(), dq8_trajectory::TrajectoryError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Spline {
    start: f64,
    pub(super) every: f64,
    pub(super) basis: Basis,
    control: Vec<DualQuat<f64>>,
    /// `ways[k]` leads from control pose k to the next one.
    pub(super) ways: Vec<Twist<f64>>,
}

/// A pose and how it changes, in the frame of the moving body.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Moving {
    /// The pose σ.
    pub pose: DualQuat<f64>,
    /// ω with σ̇ = ½σω, for one second: angular in radians per second, linear in metres per
    /// second, of the origin of the body, in its axes.
    pub twist: Twist<f64>,
    /// The change of that twist in a second. (The acceleration of the origin of the body is
    /// its linear part plus angular × linear of the twist.)
    pub acceleration: Twist<f64>,
}

/// The derivatives of a spline's pose by its control poses: [`Spline::jacobians`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Jacobians {
    /// The number of the first of the four control poses.
    pub first: usize,
    /// A matrix for each, rows and columns in the order `[ωx, ωy, ωz, vx, vy, vz]`.
    pub matrices: [[[f64; 6]; 6]; 4],
}

/// The place of a time: the number of the first of its four control poses, and u.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub(super) first: usize,
    share: f64,
}

impl Spline {
    /// A spline that begins at the time `start` and has a knot `every` so many seconds.
    ///
    /// # Errors
    /// If there are fewer than four control poses, one is not finite, the interval is not positive
    /// or lost in the rounding of the times, or a time is not finite.
    pub fn new(
        start: f64,
        every: f64,
        control: &[DualQuat<f64>],
        basis: Basis,
    ) -> Result<Self, TrajectoryError> {
        let poses = control.len();
        if poses < 4 {
            return Err(TrajectoryError::TooFewPoses { poses });
        }
        if let Some(index) = control.iter().position(|pose| !pose.is_finite()) {
            return Err(TrajectoryError::ControlPose { index });
        }
        let end = start + every * (poses - 3) as f64;
        let clear = 4.0 * f64::EPSILON * start.abs().max(end.abs());
        if !(every > clear && end.is_finite()) {
            return Err(TrajectoryError::Interval { start, every });
        }
        let ways = control.windows(2).map(|pair| pair[0].twist_to(pair[1])).collect();
        Ok(Self { start, every, basis, control: control.to_vec(), ways })
    }

    /// The times of the first knot and of the last one, in seconds.
    #[must_use]
    pub fn range(&self) -> [f64; 2] {
        [self.start, self.knot(self.control.len() - 3)]
    }

    /// The control poses.
    #[must_use]
    pub fn control(&self) -> &[DualQuat<f64>] {
        &self.control
    }

    /// The pose at a time in seconds. Before the first knot and after the last one it is the pose
    /// there; at NaN it is NaN.
    #[must_use]
    pub fn at(&self, time: f64) -> DualQuat<f64> {
        self.moving_at(time).pose
    }

    /// The pose with its twist and acceleration at a time in seconds. Before the first knot and
    /// after the last one the body stands; at NaN all are NaN.
    #[must_use]
    pub fn moving_at(&self, time: f64) -> Moving {
        let moving = self.moving(self.place(time));
        let [first, last] = self.range();
        if time < first || time > last {
            return Moving { twist: Twist::ZERO, acceleration: Twist::ZERO, ..moving };
        }
        moving
    }

    /// At the first knot and at the last one.
    pub(super) fn ends(&self) -> [Moving; 2] {
        self.range().map(|time| self.moving(self.place(time)))
    }

    fn moving(&self, place: Place) -> Moving {
        let Place { first, share } = place;
        let mut pose = self.control[first];
        let [mut twist, mut acceleration] = [Twist::ZERO; 2];
        for (way, shares) in self.ways[first..].iter().zip(self.basis.shares()) {
            let [value, speed, change] = derivatives(shares, share, self.every);
            let step = DualQuat::from_twist(way.scale(value));
            let back = step.conjugate();
            let now = way.scale(speed);
            pose = pose * step;
            twist = back.adjoint(twist) + now;
            let turned = back.adjoint(acceleration) + lie_bracket(twist, now);
            acceleration = turned + way.scale(change);
        }
        Moving { pose, twist, acceleration }
    }

    /// The derivatives of the pose σ at a time by the control poses: where each σₖ of four
    /// changes to σₖ exp(½δₖ), it becomes σ exp(½ΣJₖδₖ), but for squares of δ. All
    /// in body frames.
    ///
    /// With Bⱼ = Ad(exp(−½λ₃ξ₃) … exp(−½λⱼ₊₁ξⱼ₊₁)) λⱼ
    /// J_r(λⱼξⱼ) they are Jₖ = Bₖ J_r⁻¹(ξₖ) − Bₖ₊₁ J_l⁻¹(ξₖ₊₁),
    /// where B₄ = 0, and the first term of J₀ is the adjoint of all three factors. Outside the
    /// knots the time is that of the nearest one; at NaN all are NaN.
    ///
    /// ```
    /// use dq8::{DualQuat, Twist};
    /// use dq8_trajectory::{Basis, Spline};
    /// let control = [0.0, 1.0, 4.0, 9.0].map(|x| DualQuat::from_translation([x, 0.0, 0.0]));
    /// let spline = Spline::new(0.0, 1.0, &control, Basis::Smooth)?;
    /// // Without rotations they are the weights of a spline through numbers.
    /// let weights = spline.jacobians(0.0).matrices.map(|matrix| matrix[3][3]);
    /// for (found, wanted) in weights.into_iter().zip([1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0, 0.0]) {
    ///     assert!((found - wanted).abs() < 1e-15);
    /// }
    /// # Ok::<(), dq8_trajectory::TrajectoryError>(())
    /// ```
    #[must_use]
    pub fn jacobians(&self, time: f64) -> Jacobians {
        let Place { first, share } = self.place(time);
        let mut columns = [[Twist::ZERO; 6]; 4];
        // From the last factor on: what is behind a factor carries its changes into the body frame.
        let mut behind = DualQuat::IDENTITY;
        for (j, shares) in self.basis.shares().into_iter().enumerate().rev() {
            let way = self.ways[first + j];
            let [value, ..] = derivatives(shares, share, self.every);
            let answer = |change: Twist<f64>| {
                let turned = DualQuat::right_jacobian(way.scale(value), change.scale(value));
                behind.adjoint(turned)
            };
            for (index, unit) in units().enumerate() {
                let before = answer(DualQuat::left_jacobian_inverse(way, unit));
                columns[j][index] = columns[j][index] - before;
                let after = answer(DualQuat::right_jacobian_inverse(way, unit));
                columns[j + 1][index] = columns[j + 1][index] + after;
            }
            behind = behind * DualQuat::from_twist(way.scale(-value));
        }
        for (column, unit) in columns[0].iter_mut().zip(units()) {
            *column = *column + behind.adjoint(unit);
        }
        let transposed = |columns: [Twist<f64>; 6]| {
            let columns = columns.map(Twist::to_array);
            core::array::from_fn(|row| columns.map(|column| column[row]))
        };
        Jacobians { first, matrices: columns.map(transposed) }
    }

    pub(super) fn knot(&self, index: usize) -> f64 {
        self.start + self.every * index as f64
    }

    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "saturates, and the segment is the last at most; NaN counts as zero"
    )]
    pub(super) fn place(&self, time: f64) -> Place {
        let [first, last] = self.range();
        // `clamp` keeps NaN.
        let time = time.clamp(first, last);
        let most = self.control.len() - 4;
        let near = ((time - first) / self.every) as usize;
        // The quotient may be rounded to beyond a knot.
        let near = near.saturating_sub(usize::from(time < self.knot(near)));
        let first = (near + usize::from(self.knot(near + 1) <= time)).min(most);
        Place { first, share: (time - self.knot(first)) / self.every }
    }
}

/// λ(u), and its first two derivatives by the time, of which `every` seconds are one of u.
fn derivatives([a, b, c, d]: [f64; 4], u: f64, every: f64) -> [f64; 3] {
    let value = a + u * (b + u * (c + u * d));
    let speed = b + u * (2.0 * c + u * (3.0 * d));
    let change = 2.0 * c + u * (6.0 * d);
    [value, speed / every, change / (every * every)]
}

fn units() -> impl Iterator<Item = Twist<f64>> {
    (0..6).map(|index| {
        let mut unit = [0.0; 6];
        unit[index] = 1.0;
        Twist::from_array(unit)
    })
}

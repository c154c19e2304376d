//! Every differential operation by name, on any implementation.

use crate::case::{Arguments, Case, length};
use dq8::Twist;
use dq8_contract::sample::Sample;

/// What an operation answers: numbers that do not grow with lengths, and numbers that do.
#[derive(Clone, Debug)]
pub(crate) struct Answer<T> {
    pub(crate) plain: Vec<T>,
    pub(crate) length: Vec<T>,
}

impl<T: Copy> Answer<T> {
    fn of(plain: &[T], length: &[T]) -> Self {
        Self { plain: plain.to_vec(), length: length.to_vec() }
    }

    fn twist(twist: Twist<T>) -> Self {
        Self::of(&twist.angular, &twist.linear)
    }

    fn motion<M: Sample<Real = T>>(motion: M) -> Self {
        let components = motion.components();
        Self::of(&components[..4], &components[4..])
    }

    /// What each lane answers.
    pub(crate) fn lanes<M: Sample<Real = T>>(&self) -> Vec<Answer<f64>> {
        let split = |numbers: &[T]| numbers.iter().map(|&n| M::lanes(n)).collect::<Vec<_>>();
        let (plain, length) = (split(&self.plain), split(&self.length));
        let lane = |rows: &[Vec<f64>], lane: usize| rows.iter().map(|row| row[lane]).collect();
        (0..M::LANES).map(|i| Answer { plain: lane(&plain, i), length: lane(&length, i) }).collect()
    }
}

impl Answer<f64> {
    pub(crate) fn is_finite(&self) -> bool {
        self.plain.iter().chain(&self.length).all(|n| n.is_finite())
    }

    /// The largest distance to `wanted` in units of `scale`; NaN counts as infinite.
    pub(crate) fn distance(&self, wanted: &Self, scale: [f64; 2]) -> f64 {
        let plain = self.plain.iter().zip(&wanted.plain).map(|pair| (pair, scale[0]));
        let length = self.length.iter().zip(&wanted.length).map(|pair| (pair, scale[1]));
        plain.chain(length).fold(0.0, |worst: f64, ((got, wanted), scale)| {
            let error = if got == wanted { 0.0 } else { (got - wanted).abs() / scale };
            if error.is_nan() { f64::INFINITY } else { worst.max(error) }
        })
    }
}

/// The answer of the operation `name`.
pub(crate) fn answer<M: Sample>(name: &str, a: &Arguments<M>) -> Answer<M::Real> {
    match name {
        "derivative_spatial" => Answer::motion(a.pose.derivative_spatial(a.x)),
        "derivative_body" => Answer::motion(a.pose.derivative_body(a.x)),
        "spatial_twist" => Answer::twist(a.pose.spatial_twist(a.derivative)),
        "body_twist" => Answer::twist(a.pose.body_twist(a.derivative)),
        "derivative_from_velocity" => {
            Answer::motion(a.pose.derivative_from_velocity(a.x.angular, a.x.linear))
        }
        "velocity" => {
            let (angular, linear) = a.pose.velocity(a.derivative);
            Answer::of(&angular, &linear)
        }
        "from_twist" => Answer::motion(M::from_twist(a.x)),
        "to_twist" => Answer::twist(a.pose.to_twist()),
        "integrate_spatial" => Answer::motion(a.pose.integrate_spatial(a.x, a.dt)),
        "integrate_body" => Answer::motion(a.pose.integrate_body(a.x, a.dt)),
        "adjoint" => Answer::twist(a.pose.adjoint(a.x)),
        "coadjoint" => {
            let wrench = a.pose.coadjoint(a.wrench);
            Answer::of(&wrench.force, &wrench.torque)
        }
        "left_jacobian" => Answer::twist(M::left_jacobian(a.x, a.y)),
        "right_jacobian" => Answer::twist(M::right_jacobian(a.x, a.y)),
        "left_jacobian_inverse" => Answer::twist(M::left_jacobian_inverse(a.x, a.y)),
        "right_jacobian_inverse" => Answer::twist(M::right_jacobian_inverse(a.x, a.y)),
        other => panic!("{other} is no differential operation"),
    }
}

/// What an error is measured against: the size that the numbers, or the terms of the sums that they
/// are, can have.
pub(crate) fn scale(name: &str, case: &Case) -> [f64; 2] {
    let (p, q) = (length(&case.pose[..4]), length(&case.pose[4..]));
    let (p_rate, q_rate) = (length(&case.derivative[..4]), length(&case.derivative[4..]));
    let (angular, linear) = (length(&case.x[..3]), length(&case.x[3..]));
    let (along, along_linear) = (length(&case.y[..3]), length(&case.y[3..]));
    let (force, torque) = (length(&case.wrench[..3]), length(&case.wrench[3..]));
    match name {
        "derivative_spatial" | "derivative_body" => [angular * p, angular * q + linear * p],
        "derivative_from_velocity" => [angular * p, angular * q + linear * p],
        "spatial_twist" | "body_twist" => [2.0 * p_rate * p, 2.0 * (p_rate * q + q_rate * p)],
        "velocity" => [2.0 * p_rate * p, 2.0 * (2.0 * p_rate * q + q_rate * p)],
        // An angle is known to its last place, and so is its sine only to that of the angle.
        "from_twist" => [1.0 + angular, (1.0 + angular) * linear],
        "to_twist" => [1.0, 1.0_f64.max(2.0 * q)],
        "integrate_spatial" | "integrate_body" => {
            let (angular, linear) = (angular * case.dt.abs(), linear * case.dt.abs());
            [1.0 + angular, (1.0 + angular) * (linear + q)]
        }
        "adjoint" => [angular, linear + 2.0 * q * angular],
        "coadjoint" => [force, torque + 2.0 * q * force],
        "left_jacobian" | "right_jacobian" => {
            let turns = 1.0 + angular;
            [turns * along, turns * (along_linear + linear * along)]
        }
        "left_jacobian_inverse" | "right_jacobian_inverse" => {
            // (θ/2)/sin(θ/2): every step from C to its derivative goes with one more.
            let half = angular / 2.0;
            let grows = if half < 1e-3 { 1.0 } else { (half / half.sin()).abs().max(1.0) };
            let plain = grows.powi(2);
            [plain * along, plain * along_linear + grows.powi(3) * linear * along]
        }
        other => panic!("{other} is no differential operation"),
    }
}

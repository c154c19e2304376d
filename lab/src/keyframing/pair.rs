use crate::LogarithmError;
use crate::keyframe::{add, interpolate, matrix, orthonormality_error};
use crate::report::{Chart, Series};
use dq8::{Dual, DualQuat, Real, Twist};
use nalgebra::{Matrix4, Vector3};
use std::error::Error;

/// Two rigid keys, by their twists.
#[derive(Clone, Copy)]
pub(super) enum Pair {
    FromRest,
    OneScrew,
    Near,
    Crossed,
    Wide,
}

/// What is measured between a pair of keys.
pub(super) struct Facts {
    pub(super) sum_from_product: f64,
    pub(super) from_sclerp: f64,
    pub(super) detour: f64,
    pub(super) evenness: f64,
    pub(super) sclerp_evenness: f64,
    pub(super) other_axes: f64,
    pub(super) other_rest: f64,
    pub(super) orthonormality: f64,
}

const STEPS: u32 = 200;

impl Pair {
    pub(super) const ALL: [Self; 5] =
        [Self::FromRest, Self::OneScrew, Self::Near, Self::Crossed, Self::Wide];

    pub(super) fn name(self) -> &'static str {
        match self {
            Self::FromRest => "from no motion",
            Self::OneScrew => "on one screw, 20° and 140°",
            Self::Near => "on two screws, 7° and 9°",
            Self::Crossed => "on two screws, 69° and 86°",
            Self::Wide => "on two screws, 138° and 172°",
        }
    }

    fn twists(self) -> [Twist<f64>; 2] {
        let x = Twist { angular: [1.2, 0.0, 0.0], linear: [0.0, 0.5, 0.0] };
        let z = Twist { angular: [0.0, 0.0, 1.5], linear: [0.3, 0.0, 0.2] };
        match self {
            Self::FromRest => [Twist::from_array([0.0; 6]), z],
            Self::OneScrew => [20.0_f64, 140.0].map(|angle| z.scale(angle.to_radians() / 1.5)),
            Self::Near => [x, z].map(|twist| twist.scale(0.1)),
            Self::Crossed => [x, z],
            Self::Wide => [x, z].map(|twist| twist.scale(2.0)),
        }
    }

    pub(super) fn keys(self) -> [DualQuat<f64>; 2] {
        self.twists().map(DualQuat::from_twist)
    }

    /// C(t): of rigid keys a sum of logarithms is one of twists, for any number type.
    fn alexa<R: Real>(self, t: R) -> DualQuat<R> {
        let [a, b] =
            self.twists().map(|twist| Twist::from_array(twist.to_array().map(R::from_f64)));
        DualQuat::from_twist(a.scale(R::ONE - t) + b.scale(t))
    }

    fn sclerp<R: Real>(self, t: R) -> DualQuat<R> {
        let [a, b] = self.keys().map(|key| DualQuat::from_array(key.to_array().map(R::from_f64)));
        a.sclerp(b, t)
    }

    /// The speeds of turning on the way, in radians per unit of t, between the ends: at t = 0 a
    /// motion from rest has no axis to differentiate.
    fn turning(path: impl Fn(Dual<f64>) -> DualQuat<Dual<f64>>) -> Vec<(f64, f64)> {
        let times = (0..STEPS).map(|step| (f64::from(step) + 0.5) / f64::from(STEPS));
        times
            .map(|t| {
                let moving = path(Dual::new(t, 1.0)).to_array();
                let sigma = DualQuat::from_array(moving.map(|c| c.real));
                let rate = DualQuat::from_array(moving.map(|c| c.dual));
                (t, Vector3::from(sigma.body_twist(rate).angular).norm())
            })
            .collect()
    }

    pub(super) fn facts(self) -> Result<Facts, LogarithmError> {
        let keys = self.keys();
        let [a, b] = keys.map(matrix);
        let other = DualQuat::from_twist(Twist::from_array([0.0, 0.9, 0.3, 1.0, 0.0, -0.5]));
        let (to, back) = (matrix(other), matrix(other.conjugate()));
        // Seen from a little elsewhere, so that no key passes half a turn.
        let little = DualQuat::from_twist(Twist::from_array([0.0, 0.1, 0.0, 0.1, 0.0, 0.0]));
        let shifted = keys.map(|key| matrix(little * key));
        let [mut from_sclerp, mut other_axes, mut other_rest, mut orthonormality] = [0.0_f64; 4];
        for step in 0..=10 {
            let t = f64::from(step) / 10.0;
            let between = interpolate(&a, &b, t)?;
            from_sclerp = from_sclerp.max_or_nan(largest(&(between - matrix(self.sclerp(t)))));
            let seen = interpolate(&(to * a * back), &(to * b * back), t)?;
            other_axes = other_axes.max_or_nan(largest(&(seen - to * between * back)));
            let moved = interpolate(&shifted[0], &shifted[1], t)?;
            other_rest = other_rest.max_or_nan(largest(&(moved - matrix(little) * between)));
            orthonormality = orthonormality.max_or_nan(orthonormality_error(&between));
        }
        let (speeds, even) = (Self::turning(|t| self.alexa(t)), Self::turning(|t| self.sclerp(t)));
        Ok(Facts {
            sum_from_product: largest(&(add(&a, &b)? - a * b)),
            from_sclerp,
            detour: total(&speeds) / total(&even),
            evenness: evenness(&speeds),
            sclerp_evenness: evenness(&even),
            other_axes,
            other_rest,
            orthonormality,
        })
    }
}

/// The largest element; unlike nalgebra's, NaN if one is.
fn largest(difference: &Matrix4<f64>) -> f64 {
    difference.fold(0.0, |most, c| most.max_or_nan(c.abs()))
}

fn total(speeds: &[(f64, f64)]) -> f64 {
    speeds.iter().map(|(_, speed)| speed).sum()
}

/// The slowest over the fastest.
fn evenness(speeds: &[(f64, f64)]) -> f64 {
    let (slowest, fastest) =
        speeds.iter().fold((f64::INFINITY, 0.0_f64), |(low, high), (_, speed)| {
            (low.min(*speed), high.max_or_nan(*speed))
        });
    slowest / fastest
}

/// Speeds of turning between the widest pair.
pub(super) fn chart() -> Result<String, Box<dyn Error>> {
    let pair = Pair::Wide;
    let series = |name: &str, points| Series { name: name.to_owned(), points };
    Chart {
        title: format!("Speed of turning, keys {}", pair.name()),
        x: "t".to_owned(),
        y: "radians per unit of t".to_owned(),
        logarithmic: false,
        series: vec![
            series("Alexa", Pair::turning(|t| pair.alexa(t))),
            series("ScLERP", Pair::turning(|t| pair.sclerp(t))),
        ],
    }
    .to_svg()
}

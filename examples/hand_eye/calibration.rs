//! What is measured, and when it is enough.

use dq8::{DualQuat, Line};
use nalgebra::{DMatrix, Matrix3x4, Vector3};
use std::fmt;

/// How the hand moved, A, and how the camera moved at the same time, B: A X = X B.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pair {
    pub(crate) hand: DualQuat<f64>,
    pub(crate) eye: DualQuat<f64>,
}

/// Pairs that do not determine X.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum CalibrationError {
    /// One motion leaves a turn and a slide along its axis open.
    TooFew { motions: usize },
    /// All axes are parallel, or there is none: a slide along them remains open.
    ParallelAxes { largest_sine: f64 },
    /// The axes are parallel but for noise, which then decides how far along them the camera sits.
    NoisyAxes { ratio: f64 },
    /// A motion that is not unit, or not finite.
    NoMotion { index: usize },
}

impl fmt::Display for CalibrationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooFew { motions } => write!(f, "two motions are needed, not {motions}"),
            Self::ParallelAxes { largest_sine } => write!(
                f,
                "all axes of rotation are parallel: the largest sine between two is {largest_sine:e}"
            ),
            Self::NoisyAxes { ratio } => write!(
                f,
                "all axes of rotation are parallel but for noise: what tells them apart is {ratio:.1} times the noise, \
                 and should be {TELLING} times at the least"
            ),
            Self::NoMotion { index } => write!(f, "pair {index} holds no unit dual quaternion"),
        }
    }
}

impl std::error::Error for CalibrationError {}

/// Radians: a smaller turn has no axis worth the name, and axes at a smaller angle are parallel.
const NEGLIGIBLE: f64 = 1e-6;

/// The sixth singular value of the equations comes from axes that are not parallel, and the seventh
/// from noise alone. In a plane they are 1.3 to 1.6 times apart, with noise of 10⁻² and turns of
/// a tenth about all axes five times or more.
const TELLING: f64 = 3.0;

impl Pair {
    /// B = X*AX has the angle and the slide of A (the screw congruence theorem: Chen 1991), and so
    /// the same dual scalar part. What is left of the differences is noise, a measure of it before
    /// anything is solved.
    pub(crate) fn mismatch(&self) -> [f64; 2] {
        let (hand, eye) = (self.hand.to_screw(), self.eye.to_screw());
        [hand.angle - eye.angle, hand.slide - eye.slide]
    }

    /// Both, with the signs for which the scalar parts agree. Motions of half a turn, of which
    /// noise may choose either, are better left out.
    pub(crate) fn canonical(&self) -> [DualQuat<f64>; 2] {
        [self.hand.canonical(), self.eye.canonical()]
    }

    /// The axis of A, if it has one.
    fn axis(&self) -> Option<Line<f64>> {
        let screw = self.hand.to_screw();
        (screw.angle > NEGLIGIBLE).then_some(screw.axis)
    }
}

/// That the pairs determine X: two rotations about axes that are not parallel.
pub(crate) fn check(pairs: &[Pair]) -> Result<(), CalibrationError> {
    let is_motion = |pair: &Pair| pair.hand.is_unit(1e-9) && pair.eye.is_unit(1e-9);
    if let Some(index) = pairs.iter().position(|pair| !is_motion(pair)) {
        return Err(CalibrationError::NoMotion { index });
    }
    if pairs.len() < 2 {
        return Err(CalibrationError::TooFew { motions: pairs.len() });
    }
    let axes: Vec<_> = pairs.iter().filter_map(Pair::axis).collect();
    let mut largest_sine = 0.0_f64;
    for (i, a) in axes.iter().enumerate() {
        for b in &axes[..i] {
            let sine = a.dual_angle(*b).map_or(0.0, |angle| angle.real.sin());
            largest_sine = largest_sine.max(sine);
        }
    }
    if largest_sine <= NEGLIGIBLE {
        return Err(CalibrationError::ParallelAxes { largest_sine });
    }
    let sizes = equations(pairs).singular_values();
    let ratio = sizes[5] / sizes[6];
    if ratio < TELLING { Err(CalibrationError::NoisyAxes { ratio }) } else { Ok(()) }
}

/// The vector parts of A X − X B of all pairs, linear in the eight components of X (Daniilidis
/// 1999, eq. 31).
pub(crate) fn equations(pairs: &[Pair]) -> DMatrix<f64> {
    let mut equations = DMatrix::zeros(6 * pairs.len(), 8);
    for (i, pair) in pairs.iter().enumerate() {
        let [hand, eye] = pair.canonical().map(DualQuat::dual_vector);
        let real = commutator(hand.real, eye.real);
        equations.view_mut((6 * i, 0), (3, 4)).copy_from(&real);
        equations.view_mut((6 * i + 3, 4), (3, 4)).copy_from(&real);
        equations.view_mut((6 * i + 3, 0), (3, 4)).copy_from(&commutator(hand.dual, eye.dual));
    }
    equations
}

/// The matrix of x ↦ ax − xb for vectors a and b and a quaternion x = (w, x, y, z), without the
/// scalar row, which follows from the others: (a − b | [a + b]×).
pub(crate) fn commutator(a: [f64; 3], b: [f64; 3]) -> Matrix3x4<f64> {
    let (a, b) = (Vector3::from(a), Vector3::from(b));
    let mut rows = Matrix3x4::zeros();
    rows.set_column(0, &(a - b));
    rows.fixed_view_mut::<3, 3>(0, 1).copy_from(&(a + b).cross_matrix());
    rows
}

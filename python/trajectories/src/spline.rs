//! `Spline`.

use crate::argument::{Argument, Input};
use crate::call::Answer;
use crate::error::{misshapen, value_error};
use crate::options::{Asked, Options};
use crate::shape::{EIGHT, SIX};
use crate::threads::whole;
use crate::trajectory::rows;
use dq8::DualQuat;
use dq8_trajectory as trajectory;
use dq8_trajectory::{Basis, TrajectoryError};
use numpy::{PyArray1, PyArray2};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// A cubic spline by control poses at equal intervals, in the cumulative form
/// ``σ₀exp(½λ₁ξ₁)exp(½λ₂ξ₂)exp(½λ₃ξ₃)`` with ``ξⱼ = 2
/// log(σⱼ₋₁*σⱼ)``.
///
/// Control pose k is at the time ``start + every·(k − 1)``: the first stands before the
/// beginning, the last after the end, as four are needed between any two knots. All is float64.
///
/// Parameters
/// ----------
/// control : array_like, shape (n, 8)
///     Unit dual quaternions, n > 3.
/// every : float
///     The interval of the knots in seconds.
/// start : float
///     The time of the first knot in seconds.
/// basis : str
///     ``'smooth'``: a B-spline, which goes near the control poses, its twist and acceleration
///     continuous; or ``'through'``: Catmull and Rom's, which goes through all but the first and
///     the last, its twist continuous.
///
/// References
/// ----------
/// C. Sommer, V. Usenko, D. Schubert, N. Demmel, D. Cremers, "Efficient derivative computation for
/// cumulative B-splines on Lie groups", CVPR 2020.
///
/// Examples
/// --------
/// >>> import dq8, numpy as np
/// >>> control = dq8.from_translation(np.outer([0.0, 1, 4, 9, 16], [1, 0, 0]))
/// >>> spline = dq8.Spline(control, 0.5, 10.0, basis="through")
/// >>> spline.range, dq8.translation(spline.sample([10.0, 10.5]))[:, 0]
/// ((10.0, 11.0), array([1., 4.]))
/// >>> spline.twists(10.5)[3:].round(9)
/// array([8., 0., 0.])
#[pyclass(frozen, module = "dq8")]
#[derive(Debug)]
pub struct Spline {
    spline: trajectory::Spline,
    basis: &'static str,
    every: f64,
}

#[pymethods]
impl Spline {
    #[new]
    #[pyo3(signature = (control, every=1.0, start=0.0, *, basis="smooth"))]
    fn new(control: &Bound<'_, PyAny>, every: f64, start: f64, basis: &str) -> PyResult<Self> {
        let (kind, basis) = match basis {
            "smooth" => (Basis::Smooth, "smooth"),
            "through" => (Basis::Through, "through"),
            _ => {
                return Err(PyValueError::new_err(format!(
                    "Expected `basis` to be 'smooth' or 'through', got '{basis}'."
                )));
            }
        };
        let control = Input::<f64>::of(&Argument::new("control", EIGHT, control)?)?;
        let [_] = control.full_leading() else {
            return Err(misshapen("control", "(n, 8)", &control.shape()));
        };
        let control = control.in_full()?;
        let poses: Vec<_> =
            { control.records::<8>().iter() }.map(|pose| DualQuat::from_array(*pose)).collect();
        let make = move || trajectory::Spline::new(start, every, &poses, kind);
        let spline = if control.leading()[0] < LARGE { make() } else { whole(control.py(), make)? };
        Ok(Self { spline: spline.map_err(|error| value_error(format!("{error}.")))?, basis, every })
    }

    /// The control poses, shape (n, 8), float64.
    #[getter]
    fn control<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        rows(py, self.spline.control())
    }

    /// The times of the first knot and of the last one, in seconds.
    #[getter]
    fn range(&self) -> (f64, f64) {
        self.spline.range().into()
    }

    fn __repr__(&self) -> String {
        let ([first, last], poses) = (self.spline.range(), self.spline.control().len());
        format!("<Spline by {poses} control poses from {first} s to {last} s>")
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>)> {
        let (py, own) = (slf.py(), slf.get());
        let [start, _] = own.spline.range();
        let make = py.import("dq8._trajectories")?.getattr("_spline")?;
        let arguments = (own.control(py)?, own.every, start, own.basis).into_pyobject(py)?;
        Ok((make, arguments.into_any()))
    }

    /// The pose at one time in seconds,
    /// ``σ₀exp(½λ₁ξ₁)exp(½λ₂ξ₂)exp(½λ₃ξ₃)``, shape (8,), float64; before
    /// the first knot and after the last one it is the pose there.
    fn at<'py>(&self, py: Python<'py>, time: f64) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, &self.spline.at(time).to_array())
    }

    /// Poses at many times, ``F⁻¹σ(t)`` in the frame F. Parameters are those of
    /// `Trajectory.sample`; knots are the stamps.
    ///
    /// Returns
    /// -------
    /// ndarray, shape (..., 8)
    ///     Unit dual quaternions, float64.
    #[pyo3(signature = (times, *, clock=(0.0, 1.0), frame=None, outside="hold", out=None))]
    fn sample<'py>(
        &self,
        times: &Bound<'py, PyAny>,
        clock: (f64, f64),
        frame: Option<&Bound<'py, PyAny>>,
        outside: &str,
        out: Option<&Bound<'py, PyAny>>,
    ) -> Answer<'py> {
        let options = Options::new(clock, frame, outside)?;
        self.asked(times, options, out).answer(EIGHT, &|at, to: &mut [[f64; 8]]| {
            let to: &mut [DualQuat<f64>] = bytemuck::must_cast_slice_mut(to);
            options.of(self.spline.job()).sample(at, to)
        })
    }

    /// Velocities at many times: the twists ω with ``dσ/dt = ½σω``, for one second in the
    /// frame of the moving body, angular first. Parameters are those of `Trajectory.twists`.
    ///
    /// Returns
    /// -------
    /// ndarray, shape (..., 6)
    ///     Radians and lengths a second, float64.
    #[pyo3(signature = (times, *, clock=(0.0, 1.0), outside="hold", out=None))]
    fn twists<'py>(
        &self,
        times: &Bound<'py, PyAny>,
        clock: (f64, f64),
        outside: &str,
        out: Option<&Bound<'py, PyAny>>,
    ) -> Answer<'py> {
        let options = Options::new(clock, None, outside)?;
        self.asked(times, options, out)
            .answer(SIX, &|at, to| self.derivatives(options, at, to, &mut vec![[0.0; 6]; at.len()]))
    }

    /// The changes of the twists, ``dω/dt``, for one second. (The acceleration of the origin of
    /// the body is the linear part plus angular × linear of the twist.) Parameters are those of
    /// `twists`.
    ///
    /// Returns
    /// -------
    /// ndarray, shape (..., 6)
    ///     Radians and lengths a second squared, float64; zero outside the knots.
    #[pyo3(signature = (times, *, clock=(0.0, 1.0), outside="hold", out=None))]
    fn accelerations<'py>(
        &self,
        times: &Bound<'py, PyAny>,
        clock: (f64, f64),
        outside: &str,
        out: Option<&Bound<'py, PyAny>>,
    ) -> Answer<'py> {
        let options = Options::new(clock, None, outside)?;
        self.asked(times, options, out)
            .answer(SIX, &|at, to| self.derivatives(options, at, &mut vec![[0.0; 6]; at.len()], to))
    }

    /// The derivatives of poses by the four control poses that count: matrices J with ``η = Jδ``,
    /// where the control pose σⱼ becomes ``σⱼexp(½δ)`` and the pose σ ``σexp(½η)``. The
    /// first of the four is control pose ``floor((t − start)/every)``, from 0 to n − 4.
    ///
    /// Returns
    /// -------
    /// ndarray, shape (..., 4, 6, 6)
    ///     Twists have their angular part first; float64.
    #[pyo3(signature = (times, *, clock=(0.0, 1.0), outside="hold", out=None))]
    fn jacobians<'py>(
        &self,
        times: &Bound<'py, PyAny>,
        clock: (f64, f64),
        outside: &str,
        out: Option<&Bound<'py, PyAny>>,
    ) -> Answer<'py> {
        let options = Options::new(clock, None, outside)?;
        self.asked(times, options, out).answer(&[4, 6, 6], &|at, to: &mut [[f64; 144]]| {
            for (to, &time) in to.iter_mut().zip(at) {
                // At NaN it is NaN.
                let found = self.spline.jacobians(options.stamp(time));
                to.copy_from_slice(found.matrices.as_flattened().as_flattened());
            }
            Ok(())
        })
    }
}

/// From so many poses on, other threads of Python run while a spline is made or a trajectory is
/// sorted, and Ctrl-C ends the call: some milliseconds of work.
pub(crate) const LARGE: usize = 1 << 14;

impl Spline {
    /// One kernel for both: another one would take forty kilobytes of the wheel.
    fn derivatives(
        &self,
        options: Options,
        at: &[f64],
        twists: &mut [[f64; 6]],
        accelerations: &mut [[f64; 6]],
    ) -> Result<(), TrajectoryError> {
        let mut poses = vec![DualQuat::IDENTITY; at.len()];
        let job = options.of(self.spline.job());
        job.sample_with_accelerations(at, &mut poses, twists, accelerations)
    }

    fn asked<'a, 'py>(
        &self,
        times: &'a Bound<'py, PyAny>,
        options: Options,
        out: Option<&'a Bound<'py, PyAny>>,
    ) -> Asked<'a, 'py> {
        let (range, stamps) = (self.spline.range(), self.spline.control().len());
        Asked { times, options, range, stamps, out }
    }
}

//! `Trajectory`.

use crate::argument::{Argument, Input, is_single};
use crate::call::Answer;
use crate::error::{misshapen, value_error};
use crate::number::Number;
use crate::options::{Asked, Options};
use crate::output::Output;
use crate::pieces::{in_pieces, size};
use crate::shape::{EIGHT, NUMBER, SIX};
use crate::spline::LARGE;
use crate::threads::{GRAIN, Threads, whole};
use dq8::{DualQuat, Twist};
use dq8_trajectory::files::{self, FileError, Format};
use dq8_trajectory::{Job, OwnedTrajectory, Trajectory as View, TrajectoryError};
use numpy::prelude::*;
use numpy::{PyArray1, PyArray2};
use pyo3::exceptions::{PyUserWarning, PyValueError};
use pyo3::prelude::*;
use std::ffi::CString;
use std::path::PathBuf;

/// Poses at rising stamps, with screw motion from one to the next by the shorter way:
/// ``σ(t) = σₖ(σₖ*σₖ₊₁)ˢ`` at the share s of the time between two stamps.
///
/// A pose carries the moving body (a scanner, a camera) into the world. Poses are relative to the
/// frame of a result before they are rounded to float32, so a map 10⁶ m away costs nothing.
///
/// Parameters
/// ----------
/// stamps : array_like, shape (n,)
///     Seconds, finite and rising, n > 0; of stamps in any order make one by `sorted`.
/// poses : array_like, shape (n, 8)
///     Unit dual quaternions.
///
/// Examples
/// --------
/// >>> import dq8, numpy as np
/// >>> poses = dq8.from_translation(np.outer([0.0, 2, 8], [1, 0, 0]))
/// >>> path = dq8.Trajectory([0.0, 1, 3], poses)
/// >>> dq8.translation(path.sample([0.5, 2, 9]))[:, 0]
/// array([1., 5., 8.])
/// >>> len(path), path.range
/// (3, (0.0, 3.0))
#[pyclass(frozen, module = "dq8")]
#[derive(Debug)]
pub struct Trajectory {
    pub(crate) path: OwnedTrajectory,
}

/// Copies of as many stamps as poses, made while other threads of Python run.
fn stamped(
    py: Python<'_>,
    stamps: &Bound<'_, PyAny>,
    poses: &Bound<'_, PyAny>,
) -> PyResult<(Vec<f64>, Vec<DualQuat<f64>>)> {
    let (stamps, poses) =
        (Argument::new("stamps", NUMBER, stamps)?, Argument::new("poses", EIGHT, poses)?);
    let stamps = Input::<f64>::of(&stamps)?;
    let &[count] = stamps.full_leading() else {
        return Err(misshapen("stamps", "(n,)", &stamps.shape()));
    };
    let poses = Input::<f64>::of(&poses)?;
    if *poses.full_leading() != [count] {
        return Err(misshapen("poses", &format!("({count}, 8)"), &poses.shape()));
    }
    let (stamps, poses) = (stamps.in_full()?, poses.in_full()?);
    let (stamps, poses) = (stamps.numbers(), poses.records::<8>());
    let threads = Threads::alone();
    threads.run(py, || {
        let mut motions = Vec::with_capacity(count);
        for piece in poses.chunks(GRAIN).take_while(|_| !threads.interrupted()) {
            motions.extend(piece.iter().map(|pose| DualQuat::from_array(*pose)));
        }
        Ok((stamps.to_vec(), motions))
    })
}

/// Poses as an array, a row for each.
pub(crate) fn rows<'py>(
    py: Python<'py>,
    poses: &[DualQuat<f64>],
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let numbers: &[f64] = bytemuck::must_cast_slice(poses);
    PyArray1::from_slice(py, numbers).reshape([poses.len(), 8])
}

/// With the name of the argument that it is about.
fn named(error: TrajectoryError) -> PyErr {
    let argument = match error {
        TrajectoryError::Empty => "`poses`: ",
        TrajectoryError::NotRising { .. } => "`stamps`: ",
        _ => "",
    };
    value_error(format!("{argument}{error}."))
}

/// The errors of files: those of the system are of its kind.
fn of_file(error: FileError) -> PyErr {
    match error {
        FileError::Read { ref source, .. } => {
            std::io::Error::new(source.kind(), error.to_string()).into()
        }
        _ => value_error(format!("{error}.")),
    }
}

fn format_of(name: &str) -> PyResult<Format> {
    match name {
        "tum" => Ok(Format::Tum),
        "euroc" => Ok(Format::Euroc),
        "kitti" => Ok(Format::Kitti),
        _ => Err(PyValueError::new_err(format!(
            "Expected `format` to be 'tum', 'euroc' or 'kitti', got '{name}'."
        ))),
    }
}

#[pymethods]
impl Trajectory {
    #[new]
    fn new(py: Python<'_>, stamps: &Bound<'_, PyAny>, poses: &Bound<'_, PyAny>) -> PyResult<Self> {
        let (stamps, poses) = stamped(py, stamps, poses)?;
        let path = py.detach(|| OwnedTrajectory::new(stamps, poses));
        Ok(Self { path: path.map_err(named)? })
    }

    /// A trajectory of stamps in any order, and the number of poses that were dropped: of equal
    /// stamps the first pose is kept.
    #[staticmethod]
    fn sorted(
        py: Python<'_>,
        stamps: &Bound<'_, PyAny>,
        poses: &Bound<'_, PyAny>,
    ) -> PyResult<(Self, usize)> {
        let (stamps, poses) = stamped(py, stamps, poses)?;
        let large = stamps.len() >= LARGE;
        let sort = move || OwnedTrajectory::sorted(&stamps, &poses);
        let (path, dropped) = if large { whole(py, sort)? } else { sort() }.map_err(named)?;
        Ok((Self { path }, dropped))
    }

    /// The motion ``exp(tξ)`` at a constant twist for one second, shape (6,), angular first, in
    /// the frame of the moving body, from the time `start` to the time `end`; the identity at 0.
    #[staticmethod]
    fn of_twist(twist: &Bound<'_, PyAny>, start: f64, end: f64) -> PyResult<Self> {
        let twist = Input::<f64>::of(&Argument::new("twist", SIX, twist)?)?;
        match twist.records::<6>() {
            [one] if twist.full_leading().is_empty() => {
                let path = OwnedTrajectory::of_twist(Twist::from_array(*one), start..end);
                Ok(Self { path: path.map_err(|error| value_error(format!("{error}.")))? })
            }
            _ => Err(misshapen("twist", "(6,)", &twist.shape())),
        }
    }

    /// The trajectory of a text file with a pose on each line: ``'tum'``, ``'euroc'`` or
    /// ``'kitti'``, by default whichever its first line with numbers is of.
    ///
    /// Faults that could be put right, such as stamps that do not rise, are warnings; anything else
    /// that is no pose is a ValueError with the line. Lines of KITTI have the stamps 0, 1, 2 …
    #[staticmethod]
    #[pyo3(signature = (path, format=None))]
    fn from_file(py: Python<'_>, path: PathBuf, format: Option<&str>) -> PyResult<Self> {
        let format = format.map(format_of).transpose()?;
        let read = || format.map_or_else(|| files::read(&path), |format| format.read(&path));
        let recording = py.detach(read).map_err(of_file)?;
        for warning in recording.warnings {
            let text = CString::new(format!("{}: {warning}", path.display()))?;
            PyErr::warn(py, &py.get_type::<PyUserWarning>(), &text, 1)?;
        }
        Ok(Self { path: recording.trajectory })
    }

    /// Writes the trajectory to a text file, with so many digits that all numbers come back. The
    /// format is ``'tum'``, ``'euroc'`` or ``'kitti'``, which has no stamps.
    #[pyo3(signature = (path, format="tum"))]
    fn to_file(&self, py: Python<'_>, path: PathBuf, format: &str) -> PyResult<()> {
        let format = format_of(format)?;
        let path_of = self.path.view();
        Ok(py.detach(|| format.write(path_of, std::fs::File::create(path)?))?)
    }

    /// The stamps in seconds, shape (n,), float64.
    #[getter]
    pub(crate) fn stamps<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, self.path.stamps())
    }

    /// The poses, shape (n, 8), float64.
    #[getter]
    pub(crate) fn poses<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        rows(py, self.path.poses())
    }

    /// The first stamp and the last, in seconds.
    #[getter]
    fn range(&self) -> (f64, f64) {
        self.path.range().into()
    }

    fn __len__(&self) -> usize {
        self.path.stamps().len()
    }

    fn __repr__(&self) -> String {
        let [first, last] = self.path.range();
        format!("<Trajectory of {} poses from {first} s to {last} s>", self.__len__())
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>)> {
        let (py, own) = (slf.py(), slf.get());
        let arguments = (own.stamps(py), own.poses(py)?).into_pyobject(py)?;
        Ok((slf.get_type().into_any(), arguments.into_any()))
    }

    /// The pose at one time in seconds, ``σₖ(σₖ*σₖ₊₁)ˢ``, shape (8,), float64; before
    /// the first stamp and after the last one it is the pose there.
    fn at<'py>(&self, py: Python<'py>, time: f64) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, &self.path.at(time).to_array())
    }

    /// Poses at many times: ``F⁻¹σ(t)`` in the frame F.
    ///
    /// Parameters
    /// ----------
    /// times : array_like, shape (...)
    ///     When, in any order; rising times are found fastest. NaN gives NaN.
    /// clock : tuple of float
    ///     ``(origin, unit)``: the time t is the stamp ``origin + unit·t`` in seconds, so
    ///     ``(start, 1e-9)`` for nanoseconds since `start`.
    /// frame : str, float or array_like, shape (8,)
    ///     The frame of the results: ``'world'``, the body at the ``'start'`` or at the ``'end'``,
    ///     or at a time in seconds; or a pose of your own.
    /// outside : str
    ///     What is before the first stamp and after the last one: the body stands (``'hold'``) or
    ///     goes on as it moved there (``'continue'``), or it is a ValueError (``'refuse'``).
    /// out : ndarray, optional
    ///     Where to write the result.
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
            options.of(self.path.job()).sample(at, to)
        })
    }

    /// Velocities at many times: ``ξ = log((σₖ*σₖ₊₁)²)/(tₖ₊₁ − tₖ)``.
    ///
    /// Parameters
    /// ----------
    /// times : array_like, shape (...)
    ///     When. `clock` and `outside` are those of `sample`.
    /// out : ndarray, optional
    ///     Where to write the result.
    ///
    /// Returns
    /// -------
    /// ndarray, shape (..., 6)
    ///     Twists for one second in the frame of the moving body, angular first, float64. At a
    ///     stamp it is that of the way to the next pose; where the body stands it is zero.
    #[pyo3(signature = (times, *, clock=(0.0, 1.0), outside="hold", out=None))]
    fn twists<'py>(
        &self,
        times: &Bound<'py, PyAny>,
        clock: (f64, f64),
        outside: &str,
        out: Option<&Bound<'py, PyAny>>,
    ) -> Answer<'py> {
        let options = Options::new(clock, None, outside)?;
        self.asked(times, options, out).answer(SIX, &|at, to| {
            let mut poses = vec![DualQuat::IDENTITY; at.len()];
            options.of(self.path.job()).sample_with_twists(at, &mut poses, to)
        })
    }

    /// Points that the body measured, each at its own time, in one frame F: ``F⁻¹σ(t)p``.
    ///
    /// Parameters
    /// ----------
    /// points : array_like, shape (..., c)
    ///     Lengths, and c − 3 ≥ 0 numbers more, which are copied. A point that is not finite
    ///     keeps that to itself.
    /// times : array_like, shape (...)
    ///     When each was measured. Dimensions broadcast, so ``times[column]`` serves all rows of a
    ///     scan ``points[row, column]``.
    /// clock, frame, outside
    ///     As in `sample`.
    /// out : ndarray, optional
    ///     Where to write the result; it may be `points`.
    ///
    /// Returns
    /// -------
    /// ndarray, shape (..., c)
    ///     float32 if `points` are float32 or float16, otherwise float64.
    ///
    /// Examples
    /// --------
    /// >>> import dq8, numpy as np
    /// >>> path = dq8.Trajectory.of_twist([0, 0, 0, 1, 0, 0], 0.0, 1.0)
    /// >>> path.deskew([[5.0, 0, 0], [4.5, 0, 0]], [0, 500_000_000], clock=(0, 1e-9), frame="end")
    /// array([[4., 0., 0.],
    ///        [4., 0., 0.]])
    #[pyo3(signature = (points, times, *, clock=(0.0, 1.0), frame=None, outside="hold", out=None))]
    fn deskew<'py>(
        &self,
        points: &Bound<'py, PyAny>,
        times: &Bound<'py, PyAny>,
        clock: (f64, f64),
        frame: Option<&Bound<'py, PyAny>>,
        outside: &str,
        out: Option<&Bound<'py, PyAny>>,
    ) -> Answer<'py> {
        self.moved::<false>([points, times], Options::new(clock, frame, outside)?, out)
    }

    /// The inverse of `deskew`: points in one frame F as the body would have measured them, each at
    /// its own time, ``σ(t)⁻¹Fp``. Parameters and result are those of `deskew`.
    #[pyo3(signature = (points, times, *, clock=(0.0, 1.0), frame=None, outside="hold", out=None))]
    fn skew<'py>(
        &self,
        points: &Bound<'py, PyAny>,
        times: &Bound<'py, PyAny>,
        clock: (f64, f64),
        frame: Option<&Bound<'py, PyAny>>,
        outside: &str,
        out: Option<&Bound<'py, PyAny>>,
    ) -> Answer<'py> {
        self.moved::<true>([points, times], Options::new(clock, frame, outside)?, out)
    }
}

impl Trajectory {
    fn asked<'a, 'py>(
        &self,
        times: &'a Bound<'py, PyAny>,
        options: Options,
        out: Option<&'a Bound<'py, PyAny>>,
    ) -> Asked<'a, 'py> {
        Asked { times, options, range: self.path.range(), stamps: self.__len__(), out }
    }

    fn moved<'py, const BACK: bool>(
        &self,
        [points, times]: [&Bound<'py, PyAny>; 2],
        options: Options,
        out: Option<&Bound<'py, PyAny>>,
    ) -> Answer<'py> {
        let points = Argument::new("points", NUMBER, points)?;
        let times = Argument::new("times", NUMBER, times)?;
        if is_single([&points]) {
            self.typed::<f32, BACK>([&points, &times], options, out)
        } else {
            self.typed::<f64, BACK>([&points, &times], options, out)
        }
    }

    fn typed<'py, R: Number, const BACK: bool>(
        &self,
        [points, times]: [&Argument<'py>; 2],
        options: Options,
        out: Option<&Bound<'py, PyAny>>,
    ) -> Answer<'py> {
        let points = Input::<R>::of(points)?;
        let shape = points.shape();
        let Some((&numbers, cloud)) = shape.split_last().filter(|&(&numbers, _)| numbers >= 3)
        else {
            return Err(misshapen("points", "(..., c) with c ≥ 3", &shape));
        };
        let times = Input::<f64>::of(times)?;
        let own = times.full_leading();
        let own = &own[own.iter().take_while(|&&size| size == 1).count()..];
        // Rows that share their times, or a time for each point.
        let share = own.len() < cloud.len() && cloud.ends_with(own) && !own.is_empty();
        let fits = own.iter().rev().zip(cloud.iter().rev()).all(|(&a, &b)| a == b || a == 1);
        if own.len() > cloud.len() || !fits {
            let expected = format!("that of `points` without the last dimension, {cloud:?}");
            return Err(misshapen("times", &expected, &times.shape()));
        }
        let times = if share { times.in_full()? } else { times.filled(cloud)? };
        let py = times.py();
        let output = Output::<R>::new(py, out, cloud, &[numbers])?;
        let points = points.in_full()?.apart_from(&output)?;
        let times = times.apart_from(&output)?;
        options.check(self.path.range(), times.numbers())?;

        let scan = Scan::<BACK> {
            path: self.path.view(),
            options,
            times: times.numbers(),
            share,
            threads: Threads::for_elements(cloud.iter().product()),
        };
        let (from, _held) = (points.numbers(), output.held());
        output.fill_attached(|to| {
            scan.threads.run(py, || {
                if numbers == 3 {
                    return scan.moved(from.as_chunks().0, to.as_chunks_mut().0);
                }
                // One kernel for all lengths of records: each takes forty kilobytes of the wheel.
                let point = |record: &[R]| [record[0], record[1], record[2]];
                let near: Vec<_> = from.chunks_exact(numbers).map(point).collect();
                let mut moved = near.clone();
                scan.moved(&near, &mut moved)?;
                to.copy_from_slice(from);
                for (record, point) in to.chunks_exact_mut(numbers).zip(moved) {
                    record[..3].copy_from_slice(&point);
                }
                Ok(())
            })
        })
    }
}

/// Points on their way.
struct Scan<'s, const BACK: bool> {
    path: View<'s>,
    options: Options,
    times: &'s [f64],
    /// The times are those of columns, which all rows share.
    share: bool,
    threads: Threads,
}

impl<const BACK: bool> Scan<'_, BACK> {
    fn moved<R: Number>(&self, from: &[[R; 3]], to: &mut [[R; 3]]) -> PyResult<()> {
        let stamps = self.path.stamps().len();
        let size = match self.times.len() {
            // Whole rows.
            columns if self.share => columns * size(stamps).div_ceil(columns.max(1)).max(16),
            _ => size(stamps),
        };
        in_pieces(&self.threads, size.max(1), to, &|first, to| {
            let from = &from[first..first + to.len()];
            let job: Job<View<'_>> = self.options.of(self.path.job());
            match (self.share, BACK) {
                (true, false) => job.columns(self.times).deskew(from, to),
                (true, true) => job.columns(self.times).skew(from, to),
                (false, false) => job.deskew(&self.times[first..first + to.len()], from, to),
                // As one row: the kernel of its own, which is quicker, would make the wheel larger.
                (false, true) => job.columns(&self.times[first..first + to.len()]).skew(from, to),
            }
        })
    }
}

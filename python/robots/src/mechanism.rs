//! Mechanisms: from the values of joints to the poses of links.

use crate::argument::{common_dtype, is_single, iterations};
use crate::call::Answer;
use crate::configurations::{Frame, Values, jacobian, poses};
use crate::error::value_error;
use crate::floating::floating;
use crate::joints::{self, Arrays};
use crate::links::{Chosen, link_of, names, parents_of};
use crate::track::Asked;
use crate::urdf::mechanism_of;
use dq8_python_ik::Precision;
use dq8_python_ik::reach::reach;
use dq8_python_ik::reach_report::ReachReport;
use dq8_robot::ik::Options;
use dq8_robot::urdf::Drive;
use dq8_robot::{Joint, MechanismError, OwnedMechanism};
use numpy::PyArray1;
use numpy::prelude::*;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyTuple, PyType};

/// A tree of joints: a robot, from a URDF file or from arrays.
///
/// Link j is what joint j carries. A configuration is one array: the values of joint 0, then those
/// of joint 1, and so on, as `values` names them. Angles are radians. Fixed joints have no value,
/// revolute and prismatic ones have one, planar ones x, y and the angle, floating ones the rotation
/// (qx, qy, qz, qw), of any length but zero, and the translation.
///
/// Parameters
/// ----------
/// parents : sequence of int, length n
///     ``parents[j]`` is the link that carries link j, or −1 for the base. Parents come before
///     their children.
/// kinds : str or sequence of str, length n
///     ``"fixed"``, ``"revolute"``, ``"prismatic"``, ``"planar"`` or ``"floating"``, for all or for
///     each.
/// axes : array_like, shape (n, 3) or (3,)
///     Unit axes in the frames of the joints; normals of planar ones. Others do not read them.
/// placements : array_like, shape (n, 8) or (8,)
///     Unit dual quaternions: the pose of each link in its parent where the joint is at zero.
/// limits : array_like, shape (n, 2) or (2,), optional
///     The least and the largest value of each joint, ``[-inf, inf]`` for none. ``reach`` keeps to
///     them; poses are computed of any values.
/// links : sequence of str, length n, optional
///     Names of the links and their joints; by default numbers.
/// velocity_limits, effort_limits : array_like, shape (n,) or (), optional
///     The greatest speed, and torque or force, of each joint; ``inf`` for none. Nothing here asks
///     for them.
///
/// Examples
/// --------
/// >>> import dq8, numpy as np
/// >>> meter = dq8.from_translation([1.0, 0.0, 0.0])
/// >>> arm = dq8.Mechanism([-1, 0, 1], ["revolute", "revolute", "fixed"], [0, 0, 1], meter)
/// >>> tools = arm.poses([[0.0, 0.0], [0.0, np.pi / 2]], 2)
/// >>> dq8.translation(tools).round(9) + 0.0
/// array([[3., 0., 0.],
///        [2., 1., 0.]])
#[pyclass(frozen, module = "dq8")]
#[derive(Debug)]
pub struct Mechanism {
    pub links: Vec<String>,
    /// The root of a URDF file hangs on no joint.
    pub joint_names: Vec<Option<String>>,
    pub joints: Vec<Joint<f64>>,
    pub drives: Vec<Drive>,
    pub double: OwnedMechanism<f64>,
    /// Lengths may be beyond `f32`.
    pub single: Result<OwnedMechanism<f32>, MechanismError>,
    /// The name of the robot and the bytes of the file.
    pub urdf: Option<(String, Vec<u8>)>,
    /// The mechanism from which [`floating`] made this one.
    pub fixed: Option<Py<Self>>,
}

#[pymethods]
impl Mechanism {
    #[new]
    #[expect(clippy::too_many_arguments, reason = "keywords of Python")]
    #[pyo3(signature = (
        parents, kinds, axes, placements, limits=None, links=None, velocity_limits=None, effort_limits=None
    ))]
    fn new(
        parents: &Bound<'_, PyAny>,
        kinds: &Bound<'_, PyAny>,
        axes: &Bound<'_, PyAny>,
        placements: &Bound<'_, PyAny>,
        limits: Option<&Bound<'_, PyAny>>,
        links: Option<Vec<String>>,
        velocity_limits: Option<&Bound<'_, PyAny>>,
        effort_limits: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let parents = parents_of(parents)?;
        let count = parents.len();
        if count == 0 {
            return Err(value_error("Expected `parents` to have an element at least."));
        }
        let links = names(links, count)?;
        let drives = joints::drives(count, velocity_limits, effort_limits)?;
        let joints = Arrays { parents: &parents, kinds, axes, placements, limits }.joints()?;
        let double = OwnedMechanism::new(&joints).map_err(value_error)?;
        let single = OwnedMechanism::new(&joints.iter().map(Joint::cast).collect::<Vec<_>>());
        let joint_names = links.iter().cloned().map(Some).collect();
        Ok(Self { links, joint_names, joints, drives, double, single, urdf: None, fixed: None })
    }

    /// A robot from a URDF file.
    ///
    /// Link 0 is the root, which has no joint and stands at the base; the others follow in the
    /// order of the file as far as parents come first. Joints that mimic have no value of their
    /// own. What says where links are and cannot be expressed is an error, never left out.
    ///
    /// Parameters
    /// ----------
    /// source : str, bytes or os.PathLike
    ///     The file, in any encoding that it declares; or its bytes; or its text, if the first
    ///     thing in it is ``<``.
    ///
    /// Returns
    /// -------
    /// Mechanism
    #[classmethod]
    fn from_urdf(_: &Bound<'_, PyType>, source: &Bound<'_, PyAny>) -> PyResult<Self> {
        mechanism_of(source)
    }

    /// The name that a URDF file gives the robot, or None.
    #[getter]
    fn name(&self) -> Option<&str> {
        let urdf = self.fixed.as_ref().map_or(&self.urdf, |fixed| &fixed.get().urdf);
        urdf.as_ref().map(|(name, _)| name.as_str())
    }

    /// The robot with a base that moves freely: a floating joint ``"root_joint"`` carries its root.
    ///
    /// Its seven values, the rotation (qx, qy, qz, qw) and the translation, and its six rates come
    /// before all others. Where they are zero, but qw one, the robot stands as it did.
    ///
    /// Returns
    /// -------
    /// Mechanism
    ///
    /// Raises
    /// ------
    /// ValueError
    ///     Unless one link alone, the first, is fixed to the base, as in robots of URDF files; or
    ///     if a joint has that name already.
    ///
    /// Examples
    /// --------
    /// >>> import dq8
    /// >>> body = dq8.Mechanism.from_urdf("<robot name='drone'><link name='body'/></robot>")
    /// >>> drone = body.floating()
    /// >>> drone.values[3:5], len(drone.rates)
    /// (['root_joint.qw', 'root_joint.x'], 6)
    /// >>> dq8.translation(drone.poses([0, 0, 0, 1, 0.5, 0, 2], "body"))
    /// array([0.5, 0. , 2. ])
    fn floating(slf: &Bound<'_, Self>) -> PyResult<Self> {
        floating(slf)
    }

    /// The names of the links.
    #[getter]
    fn links(&self) -> Vec<String> {
        self.links.clone()
    }

    /// The names of the joints: ``joints[j]`` carries ``links[j]``. The root of a URDF file has
    /// None.
    #[getter]
    fn joints(&self) -> Vec<Option<String>> {
        self.joint_names.clone()
    }

    /// A name for each value of a configuration: that of the joint, with ``.x``, ``.y``, ``.angle``
    /// for planar joints and ``.qx``, ``.qy``, ``.qz``, ``.qw``, ``.x``, ``.y``, ``.z`` for
    /// floating ones.
    #[getter]
    pub(crate) fn values(&self) -> Vec<String> {
        joints::values_and_rates(&self.joints, &self.joint_names).0
    }

    /// A name for each rate, and column of a Jacobian: that of the value, but for floating joints
    /// ``.wx``, ``.wy``, ``.wz``, ``.vx``, ``.vy``, ``.vz``, the body twist in the frame of the
    /// link.
    #[getter]
    pub(crate) fn rates(&self) -> Vec<String> {
        joints::values_and_rates(&self.joints, &self.joint_names).1
    }

    /// The least and the largest of each value, radians and lengths: float64, shape (values, 2),
    /// infinite for none.
    #[getter]
    fn limits<'py>(&self, py: Python<'py>) -> Answer<'py> {
        let limits = joints::limits(&self.double);
        let numbers = PyArray1::from_slice(py, limits.as_flattened());
        Ok(numbers.reshape([limits.len(), 2])?.into_any())
    }

    /// The greatest speed of each rate, radians or lengths in a unit of time: float64, shape
    /// (rates,), infinite for none.
    #[getter]
    fn velocity_limits<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_vec(py, joints::of_rates(&self.joints, &self.drives, |drive| drive.velocity))
    }

    /// The greatest torque or force at each rate: float64, shape (rates,), infinite for none.
    #[getter]
    fn effort_limits<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_vec(py, joints::of_rates(&self.joints, &self.drives, |drive| drive.effort))
    }

    /// Between what `sample` draws each value.
    #[getter]
    fn _spans(&self) -> Vec<[f64; 2]> {
        joints::spans(&self.joints, &self.double)
    }

    /// The link that carries each link, −1 for the base.
    #[getter]
    fn parents(&self) -> Vec<i64> {
        joints::parents(&self.joints)
    }

    /// How many links there are.
    fn __len__(&self) -> usize {
        self.links.len()
    }

    fn __repr__(&self) -> String {
        let values = self.double.view().values();
        format!("<dq8.Mechanism of {} links, {values} values>", self.links.len())
    }

    fn __reduce__<'py>(
        slf: &Bound<'py, Self>,
    ) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let (py, own) = (slf.py(), slf.get());
        if let Some(fixed) = &own.fixed {
            let of = PyTuple::new(py, [fixed])?;
            return Ok((slf.get_type().getattr("floating")?, of));
        }
        if let Some((_, urdf)) = &own.urdf {
            let bytes = PyTuple::new(py, [PyBytes::new(py, urdf)])?;
            return Ok((slf.get_type().getattr("from_urdf")?, bytes));
        }
        let arguments = joints::arrays_of(&own.joints, &own.drives, own.links.clone());
        Ok((slf.get_type().into_any(), arguments.into_pyobject(py)?))
    }

    /// The poses of links, in the frame of the base: ``pose(j) = pose(parent(j)) · placement(j) ·
    /// motion(j)``.
    ///
    /// The motion of a joint is ``exp(½ξq)`` of its axis ξ and its value q, if it has one; that
    /// of planar and floating ones is the translation and the rotation that their values are.
    ///
    /// Parameters
    /// ----------
    /// values : array_like, shape (..., values), or columns by name
    ///     Configurations: radians and lengths. Angles beyond 2¹⁷ radians (float32) or 2⁴⁶
    ///     (float64) give NaN. The columns of a dict, a data frame, a table or a record array are
    ///     put in the order of `Mechanism.values`; those names and no others must be there.
    /// links : str, int, or sequence of these, optional
    ///     Which links. What carries none of them is not computed.
    /// out : ndarray, optional
    ///     Where to write the result.
    ///
    /// Returns
    /// -------
    /// ndarray, shape (..., links, 8), or (..., 8) for one link that is no sequence
    #[doc = common_dtype!()]
    ///     Unit dual quaternions.
    #[pyo3(signature = (values, links=None, *, out=None))]
    fn poses<'py>(
        &self,
        values: &Bound<'py, PyAny>,
        links: Option<&Bound<'py, PyAny>>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> Answer<'py> {
        let chosen = links.map(|links| Chosen::of(&self.links, links)).transpose()?;
        let given = Values::of(values, &|| self.values())?;
        if given.is_single() {
            poses(values.py(), self.single()?, &given, chosen, out)
        } else {
            poses(values.py(), &self.double, &given, chosen, out)
        }
    }

    /// The Jacobian of a link: ``twist = J · rates``.
    ///
    /// Parameters
    /// ----------
    /// values : array_like, shape (..., values), or columns by name
    ///     Configurations: radians and lengths.
    /// link : str or int
    ///     Which link.
    /// frame : {'aligned', 'body', 'world'}
    ///     ``'aligned'``: the axes of the base, about the origin of the link, as MuJoCo and KDL
    ///     have it (pinocchio's LOCAL_WORLD_ALIGNED). ``'body'``: the axes of the link, about its
    ///     origin (Lynch & Park, *Modern Robotics*, 2017, eq. 5.18; pinocchio's LOCAL).
    ///     ``'world'``: the axes of the base, about its origin, the spatial twist (eq. 5.11;
    ///     pinocchio's WORLD).
    /// out : ndarray, optional
    ///     Where to write the result. ``np.empty((..., rates, 6)).swapaxes(-1, -2)`` is written
    ///     without a copy, and this is how new ones lie in memory.
    ///
    /// Returns
    /// -------
    /// ndarray, shape (..., 6, rates)
    #[doc = common_dtype!()]
    ///     Rows are ``[ωx, ωy, ωz, vx, vy, vz]``, angular first. Columns of joints that do not
    ///     carry the link are zero.
    ///
    /// Examples
    /// --------
    /// >>> import dq8
    /// >>> meter = dq8.from_translation([1.0, 0.0, 0.0])
    /// >>> arm = dq8.Mechanism([-1, 0], ["revolute", "fixed"], [0, 0, 1], meter)
    /// >>> arm.jacobian([0.0], 1)[:, 0]
    /// array([0., 0., 1., 0., 1., 0.])
    #[pyo3(signature = (values, link, frame="aligned", *, out=None))]
    fn jacobian<'py>(
        &self,
        values: &Bound<'py, PyAny>,
        link: &Bound<'py, PyAny>,
        frame: &str,
        out: Option<&Bound<'py, PyAny>>,
    ) -> Answer<'py> {
        let frame = Frame::of(frame)?;
        let link = link_of(&self.links, "link", link)?;
        let given = Values::of(values, &|| self.values())?;
        if given.is_single() {
            jacobian(values.py(), self.single()?, &given, link, frame, out)
        } else {
            jacobian(values.py(), &self.double, &given, link, frame, out)
        }
    }

    /// Inverse kinematics: values that bring links to targets, for each pair of a target and a
    /// start.
    ///
    /// Damped least squares, steps δ that make ``|Jδ − e|² + λ²|δ|²`` least of the errors
    /// e, rotations and positions, and the Jacobian J, within the limits of the joints, on SIMD
    /// lanes. Where limits or local minima stop it, a search begins again from other values, spread
    /// evenly within the limits. The values returned are the best found, also where a target is not
    /// reached; where numbers are not finite or a target is not unit, they are the start.
    /// ``reach(poses(values, links), start, links)`` is the inverse of `poses`. With threads, large
    /// calls are computed by all of them. A target out of reach takes all iterations, a hundred
    /// times as long as others; ``restarts=False`` gives up sooner. Ctrl-C waits for the
    /// configurations that are being computed.
    ///
    /// Parameters
    /// ----------
    /// targets : array_like, shape (..., 8), or (..., links, 8) for a sequence of links
    ///     Unit dual quaternions: the poses that links should have, in the frame of the base. Or
    ///     positions alone, shape (..., 3) or (..., links, 3), which leave rotations free.
    /// values : array_like, shape (..., values), or columns by name
    ///     Configurations to start from. Leading dimensions broadcast with those of `targets`.
    /// links : str, int, Goal, or sequence of these
    ///     Which links. A `Goal` also says which point of its link is meant, and has weights of its
    ///     own.
    /// weights : array_like, shape (6,), or (links, 6) for a sequence of links, optional
    ///     How much the components of the error weigh where not all vanish: rotation, then
    ///     position, in the axes of the target. Zero leaves one free: ``[0, 0, 0, 1, 1, 1]`` asks
    ///     for the position alone. By default all are 1.
    /// posture : array_like, shape (values,), or numbers by name, optional
    ///     A configuration to be near to, where the targets leave freedom.
    /// angular_tolerance, linear_tolerance : float
    ///     The errors that may be left: radians, and the robot's unit.
    /// max_iterations : int
    ///     The most steps and restarts together.
    /// length_per_radian : float, optional
    ///     The distance that weighs as much as a radian, more than 0; by default an eighth of the
    ///     robot's reach, or where something floats or slides without end, of the longer way that
    ///     it has to go.
    /// max_step : float
    ///     The most that a joint turns in one step, radians, more than 0.
    /// damping : float
    ///     λ of the least squares at the target, radians; more than 0 for machines that follow a
    ///     target.
    /// restarts : bool
    ///     False keeps to the start: to follow a target that moves.
    /// least_gain : float
    ///     The part of the squared error, from 0 to 1, by which a step must reduce it; a search
    ///     whose steps gain less ends, as those of more goals than the robot has joints do.
    /// out : ndarray, optional
    ///     Where to write the values; may be `values`.
    ///
    /// Returns
    /// -------
    /// values : ndarray, shape (..., values)
    ///     float32 if `targets` and `values` are, otherwise float64.
    /// report : ReachReport
    ///     What was reached: arrays of shape (...).
    ///
    /// Examples
    /// --------
    /// >>> import dq8
    /// >>> meter = dq8.from_translation([1.0, 0.0, 0.0])
    /// >>> arm = dq8.Mechanism([-1, 0, 1], ["revolute", "revolute", "fixed"], [0, 0, 1], meter)
    /// >>> target = dq8.from_translation([2.0, 1.0, 0.0])
    /// >>> values, report = arm.reach(target, [0.1, 0.2], 2, weights=[0, 0, 0, 1, 1, 1])
    /// >>> bool(report.converged), dq8.translation(arm.poses(values, 2)).round(4) + 0.0
    /// (True, array([2., 1., 0.]))
    #[expect(clippy::too_many_arguments, reason = "keywords of Python")]
    #[pyo3(signature = (
        targets, values, links, *, weights=None, posture=None, angular_tolerance=1e-5,
        linear_tolerance=1e-5, max_iterations=100, length_per_radian=None, max_step=1.5, damping=0.0,
        restarts=true, least_gain=0.0, out=None
    ))]
    fn reach<'py>(
        &self,
        targets: &Bound<'py, PyAny>,
        values: &Bound<'py, PyAny>,
        links: &Bound<'py, PyAny>,
        weights: Option<&Bound<'py, PyAny>>,
        posture: Option<&Bound<'py, PyAny>>,
        angular_tolerance: f64,
        linear_tolerance: f64,
        #[pyo3(from_py_with = iterations)] max_iterations: u32,
        length_per_radian: Option<f64>,
        max_step: f64,
        damping: f64,
        restarts: bool,
        least_gain: f64,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<(Bound<'py, PyAny>, ReachReport)> {
        let options = Options {
            angular_tolerance,
            linear_tolerance,
            max_iterations,
            length_per_radian,
            max_step,
            damping,
            restarts,
            least_gain,
        };
        let settings = options.into();
        let search = Asked { targets, values, links, weights, posture, settings }.of(self)?;
        reach(self.precision(is_single([&search.targets, &search.values]))?, &search, out)
    }
}

impl Mechanism {
    pub(crate) fn single(&self) -> PyResult<&OwnedMechanism<f32>> {
        let refused = |error| value_error(format!("`values` are float32, for which {error}"));
        self.single.as_ref().map_err(refused)
    }

    /// Of float32 if `single`.
    pub(crate) fn precision(&self, single: bool) -> PyResult<Precision<'_>> {
        Ok(if single { Precision::Single(self.single()?) } else { Precision::Double(&self.double) })
    }
}

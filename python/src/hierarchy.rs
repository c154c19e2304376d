//! Joint hierarchies.

use crate::argument::{Argument, Input, common_dtype, is_single};
use crate::call::Answer;
use crate::error::{misshapen, value_error};
use crate::number::Number;
use crate::output::Output;
use crate::plain::check_whole;
use crate::shape::EIGHT;
use crate::threads::{GRAIN, Threads};
use dq8::DualQuat;
use dq8::hierarchy::Root;
use dq8::simd::MAX_LANES;
use pyo3::exceptions::{PyRuntimeError, PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyList;

/// A joint hierarchy: the parent of every joint.
///
/// Parameters
/// ----------
/// parents : sequence of int, length n
///     ``parents[j]`` is the parent of joint j, or −1 for a root. Parents come before their children.
///
/// Examples
/// --------
/// >>> import dq8, numpy as np
/// >>> leg = dq8.Hierarchy([-1, 0, 1])
/// >>> down = dq8.from_translation([0.0, -1.0, 0.0])
/// >>> dq8.translation(leg.local_to_model(np.tile(down, (3, 1))))[:, 1]
/// array([-1., -2., -3.])
#[pyclass(frozen, module = "dq8")]
#[derive(Debug)]
pub(crate) struct Hierarchy {
    pub(crate) parents: Vec<u32>,
}

#[pymethods]
impl Hierarchy {
    #[new]
    #[pyo3(signature = (parents, /))]
    fn new(parents: &Bound<'_, PyAny>) -> PyResult<Self> {
        let parents = parents_of(parents)?;
        dq8::Hierarchy::new(&parents)
            .map_err(|error| PyValueError::new_err(format!("`parents`: {error}")))?;
        Ok(Self { parents })
    }

    /// The parent of every joint, −1 for a root.
    #[getter]
    fn parents<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        PyList::new(
            py,
            self.parents
                .iter()
                .map(|&parent| if parent == dq8::Hierarchy::ROOT { -1 } else { i64::from(parent) }),
        )
    }

    /// How many joints there are.
    fn __len__(&self) -> usize {
        self.parents.len()
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        Ok(format!("Hierarchy({})", self.parents(py)?.repr()?))
    }

    fn __reduce__<'py>(
        slf: &Bound<'py, Self>,
    ) -> PyResult<(Bound<'py, PyAny>, (Bound<'py, PyList>,))> {
        Ok((slf.get_type().into_any(), (slf.get().parents(slf.py())?,)))
    }

    /// Forward kinematics: ``model(j) = model(parent(j)) · local(j)``.
    ///
    /// Parameters
    /// ----------
    /// locals : array_like, shape (..., joints, 8)
    ///     Unit dual quaternions: the pose of each joint in its parent.
    /// root : array_like, shape (8,), optional
    ///     What the roots stand on, the same for all instances.
    /// out : ndarray, optional
    ///     Where to write the result; `locals` itself halves the memory that is touched.
    ///
    /// Returns
    /// -------
    /// ndarray, shape (..., joints, 8)
    #[doc = common_dtype!()]
    ///     The pose of each joint in model space.
    #[pyo3(signature = (locals, /, *, root=None, out=None))]
    fn local_to_model<'py>(
        &self,
        locals: &Bound<'py, PyAny>,
        root: Option<&Bound<'py, PyAny>>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> Answer<'py> {
        self.run(Direction::ToModel, "locals", locals, root, out)
    }

    /// Local poses from model ones: ``local(j) = model(parent(j))* · model(j)``.
    ///
    /// Parameters
    /// ----------
    /// models : array_like, shape (..., joints, 8)
    ///     Unit dual quaternions: the pose of each joint in model space.
    /// root : array_like, shape (8,), optional
    ///     What the roots stand on, the same for all instances.
    /// out : ndarray, optional
    ///     Where to write the result; may be `models`.
    ///
    /// Returns
    /// -------
    /// ndarray, shape (..., joints, 8)
    #[doc = common_dtype!()]
    ///     The pose of each joint in its parent.
    #[pyo3(signature = (models, /, *, root=None, out=None))]
    fn model_to_local<'py>(
        &self,
        models: &Bound<'py, PyAny>,
        root: Option<&Bound<'py, PyAny>>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> Answer<'py> {
        self.run(Direction::ToLocal, "models", models, root, out)
    }
}

/// Parents as numbers of joints, −1 for a root.
pub(crate) fn parents_of(parents: &Bound<'_, PyAny>) -> PyResult<Vec<u32>> {
    check_whole("parents", parents)?;
    let given: Vec<i64> = parents.extract().map_err(|_| {
        PyTypeError::new_err("Expected `parents` to be a sequence of integers, −1 for a root.")
    })?;
    let parents = given.iter().map(|&parent| match parent {
        -1 => Ok(dq8::Hierarchy::ROOT),
        _ => u32::try_from(parent)
            .ok()
            .filter(|&parent| parent != dq8::Hierarchy::ROOT)
            .ok_or(parent),
    });
    parents.collect::<Result<_, _>>().map_err(|parent| {
        PyValueError::new_err(format!("`parents`: {parent} is neither a joint nor −1."))
    })
}

#[derive(Clone, Copy)]
enum Direction {
    ToModel,
    ToLocal,
}

impl Hierarchy {
    fn run<'py>(
        &self,
        direction: Direction,
        name: &'static str,
        poses: &Bound<'py, PyAny>,
        root: Option<&Bound<'py, PyAny>>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> Answer<'py> {
        let poses = Argument::new(name, EIGHT, poses)?;
        let root = root.map(|value| Argument::new("root", EIGHT, value)).transpose()?;
        if is_single([&poses].into_iter().chain(&root)) {
            self.typed::<f32>(direction, &poses, root.as_ref(), out)
        } else {
            self.typed::<f64>(direction, &poses, root.as_ref(), out)
        }
    }

    fn typed<'py, R: Number>(
        &self,
        direction: Direction,
        poses: &Argument<'py>,
        root: Option<&Argument<'py>>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> Answer<'py> {
        let name = poses.name();
        let poses = Input::<R>::of(poses)?;
        let py = poses.py();
        let full = poses.full_leading().to_vec();
        if full.last() != Some(&self.parents.len()) {
            let expected = format!("(..., {}, 8)", self.parents.len());
            return Err(misshapen(name, &expected, &poses.shape()));
        }
        let poses = poses.in_full()?;
        let root = root.map(Input::<R>::of).transpose()?;
        let root = match &root {
            None => None,
            Some(root) => match root.records::<8>() {
                [one] if root.full_leading().is_empty() => Some(DualQuat::from_array(*one)),
                _ => return Err(misshapen("root", "(8,)", &root.shape())),
            },
        };
        let output = Output::<R>::new(py, out, &full, EIGHT)?;
        let poses = if poses.is(&output) {
            // What is read must not be borrowed while it is written.
            drop(poses);
            None
        } else {
            Some(poses.apart_from(&output)?)
        };

        let hierarchy = dq8::Hierarchy::new(&self.parents).map_err(value_error)?;
        let job = hierarchy.job().on(root.map_or(Root::None, Root::Same));
        let from = poses.as_ref().map(|poses| poses.records::<8>());
        let threads = Threads::for_elements(full.iter().product());
        output.fill(&threads, |to| {
            // Whole instances, and registers of them. Lengths fit, so it cannot fail.
            let joints = self.parents.len().max(1);
            let size = joints * GRAIN.div_ceil(joints).next_multiple_of(MAX_LANES);
            threads
                .split(size, to, &|(first, to)| {
                    let from = from.map(|from| &from[first..first + to.len()]);
                    let done = match (direction, from) {
                        (Direction::ToModel, Some(from)) => job.local_to_model(from, to),
                        (Direction::ToModel, None) => job.local_to_model_in_place(to),
                        (Direction::ToLocal, Some(from)) => job.model_to_local(from, to),
                        (Direction::ToLocal, None) => job.model_to_local_in_place(to),
                    };
                    done.is_ok()
                })
                .then_some(())
                .ok_or_else(|| PyRuntimeError::new_err("a hierarchy does not fit its poses"))
        })
    }
}

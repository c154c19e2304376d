//! Joint hierarchies.

use crate::argument::{Argument, Input, common_dtype, is_single};
use crate::broadcast::common;
use crate::call::Answer;
use crate::error::misshapen;
use crate::links::{check_names, parents_of};
use crate::number::Number;
use crate::output::Output;
use crate::shape::{EIGHT, tuple};
use crate::threads::{GRAIN, Threads};
use dq8::hierarchy::Root;
use dq8::simd::MAX_LANES;
use dq8::{DualQuat, Skeleton};
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList, PyTuple};

/// A joint hierarchy: the parent of every joint.
///
/// Parameters
/// ----------
/// parents : sequence of int, length n, or dict
///     ``parents[j]`` is the parent of joint j, or −1 or None for a root; in any order. A dict
///     has the name of each joint and that of its parent.
/// names : sequence of str, length n, optional
///     Names of the joints, where `parents` is no dict.
///
/// Examples
/// --------
/// >>> import dq8, numpy as np
/// >>> leg = dq8.Hierarchy([-1, 0, 1])
/// >>> down = dq8.from_translation([0.0, -1.0, 0.0])
/// >>> dq8.translation(leg.local_to_model(np.tile(down, (3, 1))))[:, 1]
/// array([-1., -2., -3.])
/// >>> dq8.Hierarchy({"foot": "knee", "hip": None, "knee": "hip"}).parents
/// [2, -1, 1]
#[pyclass(frozen, module = "dq8")]
#[derive(Debug)]
pub struct Hierarchy {
    parents: Vec<u32>,
    names: Option<Vec<String>>,
    /// With parents first.
    sorted: Skeleton,
    /// Where each of the sorted joints stands, if not in that order.
    order: Option<Vec<usize>>,
}

#[pymethods]
impl Hierarchy {
    #[new]
    #[pyo3(signature = (parents, names=None))]
    fn new(parents: &Bound<'_, PyAny>, mut names: Option<Vec<String>>) -> PyResult<Self> {
        let parents = match parents.cast::<PyDict>() {
            Ok(by_name) if names.is_none() => {
                let own: Vec<String> = by_name.keys().extract()?;
                let parents = parents_by_name(&own, by_name)?;
                names = Some(own);
                parents
            }
            _ => parents_of(parents)?,
        };
        names.iter().try_for_each(|names| check_names("names", names, parents.len()))?;
        let named = |error| PyValueError::new_err(format!("`parents`: {error}"));
        if let Ok(sorted) = Skeleton::new(&parents) {
            return Ok(Self { parents, names, sorted, order: None });
        }
        let (sorted, order) = Skeleton::sorted(&parents).map_err(named)?;
        Ok(Self { parents, names, sorted, order: Some(order.to_vec()) })
    }

    /// The names of the joints, or None.
    #[getter]
    fn names(&self) -> Option<Vec<String>> {
        self.names.clone()
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
    ) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let own = slf.get();
        let arguments = (own.parents(slf.py())?, own.names()).into_pyobject(slf.py())?;
        Ok((slf.get_type().into_any(), arguments))
    }

    /// Forward kinematics: ``model(j) = model(parent(j)) · local(j)``.
    ///
    /// Parameters
    /// ----------
    /// locals : array_like, shape (..., joints, 8)
    ///     Unit dual quaternions: the pose of each joint in its parent.
    /// root : array_like, shape (8,) or (..., 8), optional
    ///     What the roots stand on, the same for all instances or each its own.
    /// out : ndarray, optional
    ///     Where to write the result; `locals` itself halves the memory that is touched.
    ///
    /// Returns
    /// -------
    /// ndarray, shape (..., joints, 8)
    #[doc = common_dtype!()]
    ///     The pose of each joint in model space.
    #[pyo3(signature = (locals, *, root=None, out=None))]
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
    /// root : array_like, shape (8,) or (..., 8), optional
    ///     What the roots stand on, the same for all instances or each its own.
    /// out : ndarray, optional
    ///     Where to write the result; may be `models`.
    ///
    /// Returns
    /// -------
    /// ndarray, shape (..., joints, 8)
    #[doc = common_dtype!()]
    ///     The pose of each joint in its parent.
    #[pyo3(signature = (models, *, root=None, out=None))]
    fn model_to_local<'py>(
        &self,
        models: &Bound<'py, PyAny>,
        root: Option<&Bound<'py, PyAny>>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> Answer<'py> {
        self.run(Direction::ToLocal, "models", models, root, out)
    }
}

/// Parents as a dict says them, of joints with these names.
fn parents_by_name(names: &[String], parents: &Bound<'_, PyDict>) -> PyResult<Vec<u32>> {
    let number = |parent: Bound<'_, PyAny>| {
        let Some(name) = parent.extract::<Option<String>>()? else {
            return Ok(dq8::Hierarchy::ROOT);
        };
        let number = names.iter().position(|own| *own == name).map(|number| number as u32);
        number
            .ok_or_else(|| PyValueError::new_err(format!("`parents`: there is no joint {name:?}.")))
    };
    parents.values().iter().map(number).collect()
}

#[derive(Clone, Copy)]
enum Direction {
    ToModel,
    ToLocal,
}

impl Hierarchy {
    /// Of joints with parents first; nothing if they are in another order.
    pub fn in_order(&self) -> Option<&Skeleton> {
        self.order.is_none().then_some(&self.sorted)
    }

    /// How many; one of none, to count with.
    fn joints(&self) -> usize {
        self.parents.len().max(1)
    }

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
        let instances = full.split_last().map_or(&[][..], |(_, instances)| instances);
        let root = root.map(Input::<R>::of).transpose()?;
        let roots = match root {
            Some(root)
                if common([root.full_leading(), instances].into_iter()).as_deref()
                    != Some(instances) =>
            {
                let each = format!(" or {}", tuple(&[instances, EIGHT].concat()));
                let expected = format!("(8,){}", if instances.is_empty() { "" } else { &each });
                return Err(misshapen("root", &expected, &root.shape()));
            }
            Some(root) if root.is_one() => Some(root),
            root => root.map(|root| root.filled(instances)).transpose()?,
        };
        let output = Output::<R>::new(py, out, &full, EIGHT)?;
        let poses = if poses.is(&output) {
            // What is read must not be borrowed while it is written.
            drop(poses);
            None
        } else {
            Some(poses.apart_from(&output)?)
        };

        let roots = roots.map(|roots| roots.apart_from(&output)).transpose()?;
        let roots = roots.as_ref().map(|root| (root.records::<8>(), root.is_one()));
        let from = poses.as_ref().map(|poses| poses.records::<8>());
        let threads = Threads::for_elements(full.iter().product());
        let compute = |first: usize, from: Option<&[[R; 8]]>, to: &mut [[R; 8]]| {
            let root = match roots {
                None => Root::None,
                Some((roots, true)) => Root::Same(DualQuat::from_array(roots[0])),
                Some((roots, false)) => {
                    let own = &roots[first..first + to.len() / self.joints()];
                    Root::Each(bytemuck::must_cast_slice(own))
                }
            };
            let job = self.sorted.hierarchy().job().on(root);
            // As motions, for which packed clips and chains have the same kernels.
            let from: Option<&[DualQuat<R>]> = from.map(bytemuck::must_cast_slice);
            let to: &mut [DualQuat<R>] = bytemuck::must_cast_slice_mut(to);
            let done = match (direction, from) {
                (Direction::ToModel, Some(from)) => job.local_to_model(from, to),
                (Direction::ToModel, None) => job.local_to_model_in_place(to),
                (Direction::ToLocal, Some(from)) => job.model_to_local(from, to),
                (Direction::ToLocal, None) => job.model_to_local_in_place(to),
            };
            done.is_ok()
        };
        output.fill(&threads, |to| {
            // Whole instances, and registers of them. Lengths fit, so it cannot fail.
            let joints = self.joints();
            let size = joints * GRAIN.div_ceil(joints).next_multiple_of(MAX_LANES);
            threads
                .split(size, to, &|(first, to)| {
                    let from = from.map(|from| &from[first..first + to.len()]);
                    let Some(order) = &self.order else { return compute(first / joints, from, to) };
                    let given = from.unwrap_or(to).chunks(joints);
                    let mut sorted: Vec<_> =
                        given.flat_map(|poses| order.iter().map(|&joint| poses[joint])).collect();
                    let done = compute(first / joints, None, &mut sorted);
                    for (to, sorted) in to.chunks_mut(joints).zip(sorted.chunks(joints)) {
                        order.iter().zip(sorted).for_each(|(&joint, pose)| to[joint] = *pose);
                    }
                    done
                })
                .then_some(())
                .ok_or_else(|| PyRuntimeError::new_err("a hierarchy does not fit its poses"))
        })
    }
}

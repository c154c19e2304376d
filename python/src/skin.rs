//! Skinning: meshes that follow joints.

use crate::argument::{Argument, Input, Number, is_single, misshapen, tuple};
use crate::call::Answer;
use crate::functions::core_shape::VECTOR;
use crate::output::Output;
use crate::palette::Palette;
use crate::threads::Threads;
use dq8::skinning::{Skin, SkinningError, Surface, SurfaceMut};
use numpy::prelude::*;
use numpy::{PyArrayDyn, PyUntypedArray};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use rayon::prelude::*;

/// How the motions of joints are blended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Method {
    Dual,
    Linear,
}

/// Skinning: the vertices of a mesh follow joints, in one pose or in many.
///
/// ``'dlb'``, dual quaternion linear blending: the point v goes to ``b·v``, b = ``normalize(Σ ±wᵢσᵢ)``, each
/// sign turned toward the joint of greatest weight. Keeps the volume of twisted limbs. Matrices are taken
/// apart into a motion and a stretch before it, Mᵢ = σᵢSᵢ: v goes to ``b·(Σ wᵢSᵢ v)``, as UsdSkel's
/// ``dualQuaternion`` does; so joints may scale and shear. Normals turn by cof(Σ wᵢSᵢ), then by b.
///
/// ``'lbs'``, linear blend skinning: v goes to ``Σ wᵢMᵢv``, normals to ``cof(Σ wᵢMᵢ)n``.
///
/// Parameters
/// ----------
/// points : array_like, shape (vertices, 3)
///     Where the vertices are at rest; any unit of length, that of the palette.
/// joints : array_like of int, shape (vertices, influences)
///     Which joints move a vertex.
/// weights : array_like, shape (vertices, influences)
///     How much each does, not negative; fill unused influences with any joint and weight 0. Those of a vertex sum to
///     one; ``'dlb'`` divides by the sum, ``'lbs'`` does not.
/// palette : array_like, shape (..., joints, 8), (..., joints, 3, 4) or (..., joints, 4, 4)
///     What takes each joint from the mesh at rest to the posed mesh, pose · inverse(bind pose): unit dual
///     quaternions, or matrices for column vectors, whose last row is 0 0 0 1. Leading dimensions are poses.
/// method : {'dlb', 'lbs'}
///     The blend.
/// normals : array_like, shape (vertices, 3), optional
///     Unit normals at rest.
/// out : ndarray, or a tuple of two where there are normals, optional
///     Where to write the result: arrays that do not overlap each other. Untouched where the arguments are wrong.
///
/// Returns
/// -------
/// ndarray, shape (..., vertices, 3), or a tuple of two where there are normals
///     The posed points, and unit normals. float32 if all arrays but `joints` are, otherwise float64.
///
/// References
/// ----------
/// L. Kavan, S. Collins, J. Žára, C. O'Sullivan, "Geometric Skinning with Approximate Dual Quaternion
/// Blending", ACM Trans. Graph. 27(4), 2008. N. Magnenat-Thalmann, R. Laperrière, D. Thalmann,
/// "Joint-Dependent Local Deformations for Hand Animation and Object Grasping", Graphics Interface 1988.
///
/// Examples
/// --------
/// Halfway between a joint at rest and one that is twisted by a quarter turn:
///
/// >>> import dq8
/// >>> twisted = dq8.from_rotation_translation([0, 0, 0.5**0.5, 0.5**0.5], [0.0, 0, 0])
/// >>> palette = [dq8.identity(), twisted]
/// >>> dq8.skin([[1.0, 0, 0]], [[0, 1]], [[0.5, 0.5]], palette).round(6)
/// array([[0.707107, 0.707107, 0.      ]])
/// >>> dq8.skin([[1.0, 0, 0]], [[0, 1]], [[0.5, 0.5]], palette, method='lbs').round(6)
/// array([[0.5, 0.5, 0. ]])
#[pyfunction]
#[pyo3(signature = (points, joints, weights, palette, /, *, method="dlb", normals=None, out=None))]
pub(crate) fn skin<'py>(
    points: &Bound<'py, PyAny>,
    joints: &Bound<'py, PyAny>,
    weights: &Bound<'py, PyAny>,
    palette: &Bound<'py, PyAny>,
    method: &str,
    normals: Option<&Bound<'py, PyAny>>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    let method = match method {
        "dlb" => Method::Dual,
        "lbs" => Method::Linear,
        _ => {
            let message = format!("Expected `method` to be 'dlb' or 'lbs', got '{method}'.");
            return Err(PyValueError::new_err(message));
        }
    };
    let call = Call {
        points: Argument { name: "points", core: VECTOR, value: points },
        joints,
        weights: Argument { name: "weights", core: &[], value: weights },
        palette: Argument { name: "palette", core: &[], value: palette },
        normals: normals.map(|value| Argument { name: "normals", core: VECTOR, value }),
        method,
    };
    if is_single(&[Some(call.points), Some(call.weights), Some(call.palette), call.normals])? {
        typed::<f32>(call, out)
    } else {
        typed::<f64>(call, out)
    }
}

struct Call<'a, 'py> {
    points: Argument<'a, 'py>,
    joints: &'a Bound<'py, PyAny>,
    weights: Argument<'a, 'py>,
    palette: Argument<'a, 'py>,
    normals: Option<Argument<'a, 'py>>,
    method: Method,
}

fn typed<'py, R: Number>(call: Call<'_, 'py>, out: Option<&Bound<'py, PyAny>>) -> Answer<'py> {
    let py = call.joints.py();
    let points = Input::<R>::of(call.points)?;
    let &[vertices] = points.full_leading() else {
        return Err(misshapen("points", "(vertices, 3)", &points.shape()));
    };
    let (joints, shape) = joints_of(call.joints)?;
    if !matches!(shape[..], [count, _] if count == vertices) {
        return Err(misshapen("joints", &format!("({vertices}, influences)"), &shape));
    }
    let weights = Input::<R>::of(call.weights)?;
    if weights.full_leading() != shape {
        return Err(misshapen("weights", &tuple(&shape), &weights.shape()));
    }
    let normals = call.normals.map(Input::<R>::of).transpose()?;
    if let Some(normals) = &normals
        && normals.full_leading() != [vertices]
    {
        return Err(misshapen("normals", &tuple(&[vertices, 3]), &normals.shape()));
    }
    let palette = Palette::new(Input::<R>::of(call.palette)?, call.method)?;

    let leading = [&palette.poses[..], &[vertices]].concat();
    let [out_points, out_normals] = outputs(out, normals.is_some())?;
    let to_points = Output::<R>::new(py, out_points.as_ref(), &leading, VECTOR)?;
    let to_normals = normals
        .as_ref()
        .map(|_| Output::<R>::new(py, out_normals.as_ref(), &leading, VECTOR))
        .transpose()?;
    if let Some(to_normals) = &to_normals {
        to_points.check_apart(to_normals)?;
    }
    let ready = |input: Input<'py, R>| -> PyResult<Input<'py, R>> {
        let full = input.full_leading().to_vec();
        let input = input.filled(&full)?.apart_from(&to_points)?;
        to_normals.iter().try_fold(input, Input::apart_from)
    };
    let (points, weights) = (ready(points)?, ready(weights)?);
    let normals = normals.map(ready).transpose()?;

    let rest = Surface {
        positions: points.records(),
        normals: normals.as_ref().map(|normals| normals.records()),
        tangents: None,
    };
    let weights = weights.records::<1>().as_flattened();
    let skin = py.detach(|| Skin::new(palette.joints, shape[1], &joints, weights));
    let skin = skin.map_err(named)?;
    let mut points_memory = to_points.borrow()?;
    let mut normals_memory = to_normals.as_ref().map(Output::borrow).transpose()?;
    let failed = |error: numpy::AsSliceError| PyValueError::new_err(error.to_string());
    let to_positions = points_memory.as_slice_mut().map_err(failed)?.as_chunks_mut::<3>().0;
    let to_directions = match &mut normals_memory {
        Some(memory) => Some(memory.as_slice_mut().map_err(failed)?.as_chunks_mut::<3>().0),
        None => None,
    };
    let done = py.detach(|| poses(&palette, &skin, rest, to_positions, to_directions));
    done.map_err(named)?;
    drop(points_memory);
    drop(normals_memory);
    let points = to_points.finish()?;
    match to_normals {
        None => Ok(points),
        Some(normals) => Ok(PyTuple::new(py, [points, normals.finish()?])?.into_any()),
    }
}

/// The mesh in every pose.
fn poses<R: Number>(
    palette: &Palette<R>,
    skin: &Skin<'_, u32, R>,
    rest: Surface<'_, [R; 3]>,
    points: &mut [[R; 3]],
    normals: Option<&mut [[R; 3]]>,
) -> Result<(), SkinningError> {
    let vertices = skin.vertices();
    if vertices == 0 {
        return Ok(());
    }
    let threads = Threads::for_elements(points.len());
    let mut normals = normals.map(|normals| normals.chunks_exact_mut(vertices));
    let posed = points.chunks_exact_mut(vertices).map(|positions| SurfaceMut {
        positions,
        normals: normals.as_mut().and_then(Iterator::next),
        tangents: None,
    });
    let mut posed = posed.enumerate();
    if threads.many() {
        let posed: Vec<_> = posed.collect();
        let posed = posed.into_par_iter();
        threads.install(|| {
            posed.try_for_each(|(pose, posed)| palette.pose(&threads, skin, pose, rest, posed))
        })
    } else {
        posed.try_for_each(|(pose, posed)| palette.pose(&threads, skin, pose, rest, posed))
    }
}

/// Numbers of joints, and their shape.
fn joints_of(joints: &Bound<'_, PyAny>) -> PyResult<(Vec<u32>, Vec<usize>)> {
    let numpy = joints.py().import("numpy")?;
    let array = numpy.call_method1("asarray", (joints,));
    let array = array.map_err(|error| PyValueError::new_err(format!("`joints`: {error}")))?;
    let array = array.cast_into::<PyUntypedArray>()?;
    let (shape, dtype) = (array.shape().to_vec(), array.dtype());
    if !matches!(dtype.kind(), b'i' | b'u') && !shape.contains(&0) {
        return Err(PyTypeError::new_err(format!(
            "Expected `joints` to hold integers, got dtype {dtype}."
        )));
    }
    let wide = numpy.call_method1("ascontiguousarray", (array, "int64"))?;
    let wide = wide.cast_into::<PyArrayDyn<i64>>()?.try_readonly();
    let wide = wide.map_err(|error| PyValueError::new_err(format!("`joints`: {error}")))?;
    let wide = wide.as_slice().map_err(|error| PyValueError::new_err(error.to_string()))?;
    let joints: Result<_, i64> =
        wide.iter().map(|&joint| u32::try_from(joint).map_err(|_| joint)).collect();
    let joints = joints.map_err(|joint| {
        PyValueError::new_err(format!("`joints`: {joint} is not the number of a joint."))
    })?;
    Ok((joints, shape))
}

/// Where to write points and normals.
fn outputs<'py>(
    out: Option<&Bound<'py, PyAny>>,
    normals: bool,
) -> PyResult<[Option<Bound<'py, PyAny>>; 2]> {
    match out {
        None => Ok([None, None]),
        Some(out) if !normals => Ok([Some(out.clone()), None]),
        Some(out) => match out.extract() {
            Ok((points, normals)) if out.is_instance_of::<PyTuple>() => {
                Ok([Some(points), Some(normals)])
            }
            _ => Err(PyTypeError::new_err(format!(
                "Expected `out` to be a tuple of two arrays where there are `normals`, got {}.",
                out.get_type().name()?
            ))),
        },
    }
}

/// With the name of the argument that it is about.
pub(crate) fn named(error: SkinningError) -> PyErr {
    let argument = match error {
        SkinningError::NoInfluences | SkinningError::JointOutOfRange { .. } => "`joints`: ",
        SkinningError::Weight { .. } | SkinningError::Total { .. } => "`weights`: ",
        _ => "",
    };
    PyValueError::new_err(format!("{argument}{error}."))
}

//! Skinning: meshes that follow joints.

use crate::argument::{Argument, Input, is_single};
use crate::call::Answer;
use crate::error::{misshapen, value_error};
use crate::method::Method;
use crate::number::Number;
use crate::output::Output;
use crate::palette::{Palette, named};
use crate::shape::{NUMBER, VECTOR, tuple};
use crate::threads::Threads;
use dq8::skinning::{Skin, SkinningError, Surface, SurfaceMut};
use numpy::prelude::*;
use numpy::{PyArrayDyn, PyUntypedArray};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use rayon::prelude::*;

/// Skinning: the vertices of a mesh follow joints, in one pose or in many.
///
/// ``'dlb'``, dual quaternion linear blending: the point v goes to ``b·v``, b = ``normalize(Σ ±wᵢσᵢ)``, each
/// sign turned toward the joint of greatest weight. Keeps the volume of twisted limbs. Matrices are taken
/// apart into a motion and a stretch before it, Mᵢ = σᵢSᵢ: v goes to ``b·(Σ wᵢSᵢ v)``, as UsdSkel's
/// ``dualQuaternion`` does; so joints may scale and shear. Normals turn by ``cof(Σ wᵢSᵢ)``, tangents by ``Σ wᵢSᵢ``,
/// then both by b.
///
/// ``'lbs'``, linear blend skinning: v goes to ``Σ wᵢMᵢv``, normals to ``cof(Σ wᵢMᵢ)n``, tangents to ``Σ wᵢMᵢt``.
///
/// ``'mix'``, both by a number s for each vertex: ``(1 − s) lbs + s dlb`` of points, normals and tangents. Against
/// the bulge of ``'dlb'`` at bent joints.
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
/// method : {'dlb', 'lbs', 'mix'}
///     The blend.
/// shares : array_like, shape (vertices,), where the method is ``'mix'``
///     The share s of ``'dlb'``, in [0, 1].
/// normals, tangents : array_like, shape (vertices, 3), optional
///     Unit normals and unit tangents at rest; tangents without the sign of the bitangent.
/// out : ndarray, or a tuple of those where there are normals or tangents, optional
///     Where to write the result: arrays that do not overlap each other. Untouched where the arguments are wrong.
///
/// Returns
/// -------
/// ndarray, shape (..., vertices, 3), or a tuple of those where there are normals or tangents
///     The posed points, then unit normals, then unit tangents, of what there is. float32 if all arrays but `joints`
///     are, otherwise float64.
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
/// >>> [[1.0, 0, 0]].job().backend(dq8).pose([[0, 1]], [[0.5, 0.5]], palette).round(6)
/// array([[0.707107, 0.707107, 0.      ]])
/// >>> dq8.skin([[1.0, 0, 0]], [[0, 1]], [[0.5, 0.5]], palette, method='lbs').round(6)
/// array([[0.5, 0.5, 0. ]])
#[expect(clippy::too_many_arguments, reason = "keywords of Python")]
#[pyfunction]
#[pyo3(signature = (
    points, joints, weights, palette, /, *, method="dlb", shares=None, normals=None, tangents=None, out=None
))]
pub(crate) fn skin<'py>(
    points: &Bound<'py, PyAny>,
    joints: &Bound<'py, PyAny>,
    weights: &Bound<'py, PyAny>,
    palette: &Bound<'py, PyAny>,
    method: &str,
    shares: Option<&Bound<'py, PyAny>>,
    normals: Option<&Bound<'py, PyAny>>,
    tangents: Option<&Bound<'py, PyAny>>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    let method = Method::of(method)?;
    if (method == Method::Mixed) != shares.is_some() {
        return Err(PyTypeError::new_err(
            "Expected `shares` where `method` is 'mix', and nowhere else.",
        ));
    }
    let call = Call {
        points: Argument { name: "points", core: VECTOR, value: points },
        joints,
        weights: Argument { name: "weights", core: NUMBER, value: weights },
        palette: Argument { name: "palette", core: NUMBER, value: palette },
        method,
        shares: shares.map(|value| Argument { name: "shares", core: NUMBER, value }),
        directions: [
            normals.map(|value| Argument { name: "normals", core: VECTOR, value }),
            tangents.map(|value| Argument { name: "tangents", core: VECTOR, value }),
        ],
    };
    let optional = call.shares.into_iter().chain(call.directions.into_iter().flatten());
    if is_single([call.points, call.weights, call.palette].into_iter().chain(optional))? {
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
    method: Method,
    shares: Option<Argument<'a, 'py>>,
    /// Normals and tangents.
    directions: [Option<Argument<'a, 'py>>; 2],
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
    // One for each vertex.
    let of_vertices = |argument: Argument<'_, 'py>| -> PyResult<Input<'py, R>> {
        let input = Input::<R>::of(argument)?;
        if input.full_leading() != [vertices] {
            let expected = [&[vertices], argument.core].concat();
            return Err(misshapen(argument.name, &tuple(&expected), &input.shape()));
        }
        Ok(input)
    };
    let shares = call.shares.map(of_vertices).transpose()?;
    let [normals, tangents] = call.directions;
    let [normals, tangents] =
        [normals.map(of_vertices).transpose()?, tangents.map(of_vertices).transpose()?];
    let palette = Palette::new(Input::<R>::of(call.palette)?, call.method)?;

    let leading = [&palette.poses[..], &[vertices]].concat();
    let there = [true, normals.is_some(), tangents.is_some()];
    let mut outputs = Vec::with_capacity(there.len());
    for out in outs(out, there)? {
        let output = Output::<R>::new(py, out.as_ref(), &leading, VECTOR)?;
        outputs.iter().try_for_each(|other| output.check_apart(other))?;
        outputs.push(output);
    }
    let ready = |input: Input<'py, R>| -> PyResult<Input<'py, R>> {
        outputs.iter().try_fold(input.in_full()?, Input::apart_from)
    };
    let (points, weights) = (ready(points)?, ready(weights)?);
    let shares = shares.map(ready).transpose()?;
    let [normals, tangents] = [normals.map(ready).transpose()?, tangents.map(ready).transpose()?];

    let rest = Surface {
        positions: points.records(),
        normals: normals.as_ref().map(|normals| normals.records()),
        tangents: tangents.as_ref().map(|tangents| tangents.records()),
    };
    let weights = weights.records::<1>().as_flattened();
    let skin = py.detach(|| Skin::new(palette.joints, shape[1], &joints, weights));
    let skin = skin.map_err(named)?;
    let shares = shares.as_ref().map_or(&[][..], |shares| shares.records::<1>().as_flattened());

    let mut memory = outputs.iter().map(Output::borrow).collect::<PyResult<Vec<_>>>()?;
    let mut slices = Vec::with_capacity(memory.len());
    for memory in &mut memory {
        let numbers = memory.as_slice_mut();
        let numbers = numbers.map_err(value_error)?;
        slices.push(numbers.as_chunks_mut::<3>().0);
    }
    let mut slices = slices.into_iter();
    let mut next = |there: bool| if there { slices.next() } else { None };
    let posed = SurfaceMut {
        positions: next(true).unwrap_or_default(),
        normals: next(there[1]),
        tangents: next(there[2]),
    };
    let done = py.detach(|| poses(&palette, &skin, shares, rest, posed));
    done.map_err(named)?;
    drop(memory);
    let mut results = Vec::with_capacity(outputs.len());
    for output in outputs {
        results.push(output.finish()?);
    }
    match results.pop() {
        Some(points) if results.is_empty() => Ok(points),
        last => {
            Ok(PyTuple::new(py, results.into_iter().chain(last).collect::<Vec<_>>())?.into_any())
        }
    }
}

/// The mesh in every pose.
fn poses<R: Number>(
    palette: &Palette<R>,
    skin: &Skin<'_, u32, R>,
    shares: &[R],
    rest: Surface<'_, [R; 3]>,
    posed: SurfaceMut<'_, [R; 3]>,
) -> Result<(), SkinningError> {
    let vertices = skin.vertices();
    if vertices == 0 {
        return Ok(());
    }
    let threads = Threads::for_elements(posed.positions.len());
    let mut normals = posed.normals.map(|normals| normals.chunks_exact_mut(vertices));
    let mut tangents = posed.tangents.map(|tangents| tangents.chunks_exact_mut(vertices));
    let posed = posed.positions.chunks_exact_mut(vertices).map(|positions| SurfaceMut {
        positions,
        normals: normals.as_mut().and_then(Iterator::next),
        tangents: tangents.as_mut().and_then(Iterator::next),
    });
    let one = |(pose, posed)| palette.pose(&threads, skin, shares, pose, rest, posed);
    let mut posed = posed.enumerate();
    if threads.many() {
        let posed: Vec<_> = posed.collect();
        threads.install(|| posed.into_par_iter().try_for_each(one))
    } else {
        posed.try_for_each(one)
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
    let wide = wide.as_slice().map_err(value_error)?;
    let joints: Result<_, i64> =
        wide.iter().map(|&joint| u32::try_from(joint).map_err(|_| joint)).collect();
    let joints = joints.map_err(|joint| {
        PyValueError::new_err(format!("`joints`: {joint} is not the number of a joint."))
    })?;
    Ok((joints, shape))
}

/// Where to write what there is of points, normals and tangents.
fn outs<'py>(
    out: Option<&Bound<'py, PyAny>>,
    there: [bool; 3],
) -> PyResult<Vec<Option<Bound<'py, PyAny>>>> {
    let names = ["points", "normals", "tangents"].into_iter().zip(there);
    let names: Vec<_> = names.filter_map(|(name, there)| there.then_some(name)).collect();
    let Some(out) = out else { return Ok(vec![None; names.len()]) };
    if names.len() == 1 {
        return Ok(vec![Some(out.clone())]);
    }
    match out.cast::<PyTuple>() {
        Ok(arrays) if arrays.len() == names.len() => Ok(arrays.iter().map(Some).collect()),
        given => {
            let given = match given {
                Ok(arrays) => format!("a tuple of {}", arrays.len()),
                Err(_) => out.get_type().name()?.to_string(),
            };
            let names = names.join(", ");
            let message = format!("Expected `out` to be a tuple of arrays ({names}), got {given}.");
            Err(PyTypeError::new_err(message))
        }
    }
}

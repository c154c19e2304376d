//! Skinning: meshes that follow joints.

use crate::argument::{Argument, Input, is_single};
use crate::call::Answer;
use crate::error::{misshapen, value_error};
use crate::method::Method;
use crate::number::Number;
use crate::output::Output;
use crate::palette::{Palette, named};
use crate::plain::{plain, view};
use crate::shape::{NUMBER, VECTOR, tuple};
use crate::threads::{GRAIN, Threads};
use dq8::Real;
use dq8::skinning::{Skin, SkinningError, Surface, SurfaceMut};
use numpy::PyArrayDyn;
use numpy::prelude::*;
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use std::borrow::Cow;
use std::sync::OnceLock;

/// Skinning: the vertices of a mesh follow joints, in one pose or in many.
///
/// ``'dlb'``, dual quaternion linear blending: the point v goes to ``b·v``, b = ``normalize(Σ
/// ±wᵢσᵢ)``, each sign turned toward the joint of greatest weight. Keeps the volume of
/// twisted limbs. Matrices are taken apart into a motion and a stretch before it, Mᵢ = σᵢSᵢ:
/// v goes to ``b·(Σ wᵢSᵢ v)``, as UsdSkel's ``dualQuaternion`` does; so joints may scale and
/// shear. Normals turn by ``cof(Σ wᵢSᵢ)``, tangents by ``Σ wᵢSᵢ``, then both by b.
///
/// ``'lbs'``, linear blend skinning: v goes to ``Σ wᵢMᵢv``, normals to ``cof(Σ wᵢMᵢ)n``,
/// tangents to ``Σ wᵢMᵢt``.
///
/// ``'mix'``, both by a number s for each vertex: ``(1 − s) lbs + s dlb`` of points, normals and
/// tangents. Against the bulge of ``'dlb'`` at bent joints.
///
/// Parameters
/// ----------
/// points : array_like, shape (vertices, 3)
///     Where the vertices are at rest; any unit of length, that of the palette.
/// joints : array_like of int, shape (vertices, influences)
///     Which joints move a vertex.
/// weights : array_like, shape (vertices, influences)
///     How much each does, not negative; fill unused influences with any joint and weight 0. Those
///     of a vertex sum to one: ``'dlb'`` divides by the sum, ``'lbs'`` and ``'mix'`` refuse one
///     that is off by more than 0.001. uint8 and uint16 are divided by 255 and 65535, as glTF's
///     normalized ones; other integers are numbers as they are.
/// palette : array_like, shape (..., joints, 8), (..., joints, 3, 4) or (..., joints, 4, 4)
///     What takes each joint from the mesh at rest to the posed mesh, pose · inverse(bind pose):
///     unit dual quaternions, or matrices for column vectors, whose last row is 0 0 0 1. Leading
///     dimensions are poses.
/// method : {'dlb', 'lbs', 'mix'}
///     The blend.
/// shares : array_like, shape (vertices,), where the method is ``'mix'``
///     The share s of ``'dlb'``, in [0, 1].
/// normals, tangents : array_like, shape (vertices, 3), optional
///     Unit normals and unit tangents at rest; tangents without the sign of the bitangent.
/// out : ndarray, or a tuple of those where there are normals or tangents, optional
///     Where to write the result: arrays that do not overlap each other. Untouched where the
///     arguments are wrong.
///
/// Returns
/// -------
/// ndarray, shape (..., vertices, 3), or a tuple of those where there are normals or tangents
///     The posed points, then unit normals, then unit tangents, of what there is. float32 if all
///     arrays but `joints` are, otherwise float64.
///
/// References
/// ----------
/// L. Kavan, S. Collins, J. Žára, C. O'Sullivan, "Geometric Skinning with Approximate Dual
/// Quaternion Blending", ACM Trans. Graph. 27(4), 2008. N. Magnenat-Thalmann, R. Laperrière, D.
/// Thalmann, "Joint-Dependent Local Deformations for Hand Animation and Object Grasping", Graphics
/// Interface 1988.
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
#[expect(clippy::too_many_arguments, reason = "keywords of Python")]
#[pyfunction]
#[pyo3(signature = (
    points, joints, weights, palette, *, method="dlb", shares=None, normals=None, tangents=None, out=None
))]
pub fn skin<'py>(
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
    let optional = |name, core, value: Option<&Bound<'py, PyAny>>| {
        value.map(|value| Argument::new(name, core, value)).transpose()
    };
    let call = Call {
        points: Argument::new("points", VECTOR, points)?,
        joints: joints_of(joints)?,
        weights: Argument::new("weights", NUMBER, weights)?,
        palette: Argument::new("palette", NUMBER, palette)?,
        method,
        shares: optional("shares", NUMBER, shares)?,
        directions: [
            optional("normals", VECTOR, normals)?,
            optional("tangents", VECTOR, tangents)?,
        ],
    };
    let optional = call.shares.iter().chain(call.directions.iter().flatten());
    if is_single([&call.points, &call.weights, &call.palette].into_iter().chain(optional)) {
        typed::<f32>(&call, out)
    } else {
        typed::<f64>(&call, out)
    }
}

struct Call<'py> {
    points: Argument<'py>,
    /// With their shape.
    joints: (Vec<u32>, Vec<usize>),
    weights: Argument<'py>,
    palette: Argument<'py>,
    method: Method,
    shares: Option<Argument<'py>>,
    /// Normals and tangents.
    directions: [Option<Argument<'py>>; 2],
}

fn typed<'py, R: Number>(call: &Call<'py>, out: Option<&Bound<'py, PyAny>>) -> Answer<'py> {
    let points = Input::<R>::of(&call.points)?;
    let py = points.py();
    let &[vertices] = points.full_leading() else {
        return Err(misshapen("points", "(vertices, 3)", &points.shape()));
    };
    let (joints, shape) = &call.joints;
    if !matches!(shape[..], [count, _] if count == vertices) {
        return Err(misshapen("joints", &format!("({vertices}, influences)"), shape));
    }
    let weights = Input::<R>::of(&call.weights)?;
    if weights.full_leading() != shape {
        return Err(misshapen("weights", &tuple(shape), &weights.shape()));
    }
    // One for each vertex.
    let of_vertices = |argument: &Argument<'py>| -> PyResult<Input<'py, R>> {
        let input = Input::<R>::of(argument)?;
        if input.full_leading() != [vertices] {
            let expected = [&[vertices], argument.core()].concat();
            return Err(misshapen(argument.name(), &tuple(&expected), &input.shape()));
        }
        Ok(input)
    };
    let shares = call.shares.as_ref().map(of_vertices).transpose()?;
    let [normals, tangents] = &call.directions;
    let [normals, tangents] = [
        normals.as_ref().map(of_vertices).transpose()?,
        tangents.as_ref().map(of_vertices).transpose()?,
    ];
    let palette = Input::<R>::of(&call.palette)?;
    // At most: all dimensions but those of one joint are poses and joints.
    let threads =
        Threads::for_elements(palette.full_leading().iter().product::<usize>().max(vertices));
    let palette = Palette::new(palette, call.method, &threads)?;

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
    let given = weights.records::<1>().as_flattened();
    let weights = match call.weights.dtype() {
        // As glTF stores them: the greatest number is 1.
        (b'u', 1) => Cow::Owned(normalized(given, u8::MAX.into())),
        (b'u', 2) => Cow::Owned(normalized(given, u16::MAX.into())),
        _ => Cow::Borrowed(given),
    };
    let shares = shares.as_ref().map_or(&[][..], |shares| shares.records::<1>().as_flattened());
    let method = call.method;
    let mesh = py.detach(|| {
        let parts = parts(palette.joints, shape[1], joints, &weights, method)?;
        let wrong = shares.iter().position(|share| !(R::ZERO..=R::ONE).contains(share));
        match wrong {
            Some(vertex) => {
                Err(named(SkinningError::Share { vertex, value: shares[vertex].into() }))
            }
            None => Ok(Mesh { vertices, parts, shares, rest }),
        }
    })?;

    let _held: Vec<_> = outputs.iter().map(Output::held).collect();
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
    let threads = Threads::for_elements(leading.iter().product());
    threads.run(py, || poses(&threads, &palette, &mesh, posed).map_err(named))?;
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

/// A mesh at rest, checked.
struct Mesh<'s, R> {
    vertices: usize,
    /// The skin of each piece of its vertices.
    parts: Vec<Skin<'s, u32, R>>,
    shares: &'s [R],
    rest: Surface<'s, [R; 3]>,
}

/// How far weights may sum from one where nothing divides by their sum: as far as those of half
/// floats do.
const SUM_TOLERANCE: f64 = 1e-3;

/// A skin for each piece of the vertices.
fn parts<'s, R: Number>(
    palette: usize,
    influences: usize,
    joints: &'s [u32],
    weights: &'s [R],
    method: Method,
) -> PyResult<Vec<Skin<'s, u32, R>>> {
    // Also where there is nothing to be cut into pieces.
    Skin::new(palette, influences, &joints[..0], &weights[..0]).map_err(named)?;
    let size = GRAIN * influences;
    let pieces = joints.chunks(size).zip(weights.chunks(size));
    let parts = pieces.enumerate().map(|(piece, (joints, weights))| {
        Skin::new(palette, influences, joints, weights)
            .map_err(|error| named(of_mesh(error, piece * GRAIN)))
    });
    let parts = parts.collect::<PyResult<_>>()?;
    if method == Method::Dual {
        return Ok(parts);
    }
    for (vertex, weights) in weights.chunks(influences.max(1)).enumerate() {
        let total: f64 = weights.iter().map(|&weight| weight.into()).sum();
        if (total - 1.0).abs() > SUM_TOLERANCE {
            return Err(PyValueError::new_err(format!(
                "`weights`: vertex {vertex}: the weights sum to {total}, which must be 1 (to {SUM_TOLERANCE}) where \
                 `method` is 'lbs' or 'mix': divide them by their sum."
            )));
        }
    }
    Ok(parts)
}

/// An error about a vertex of a piece, as one about a vertex of the mesh.
fn of_mesh(mut error: SkinningError, first: usize) -> SkinningError {
    if let SkinningError::JointOutOfRange { vertex, .. }
    | SkinningError::Weight { vertex, .. }
    | SkinningError::Total { vertex, .. } = &mut error
    {
        *vertex += first;
    }
    error
}

fn normalized<R: Number>(weights: &[R], one: f64) -> Vec<R> {
    let one = <R as Real>::from_f64(one);
    weights.iter().map(|&weight| weight / one).collect()
}

/// The mesh in every pose.
fn poses<R: Number>(
    threads: &Threads,
    palette: &Palette<R>,
    mesh: &Mesh<'_, R>,
    posed: SurfaceMut<'_, [R; 3]>,
) -> Result<(), SkinningError> {
    let Mesh { vertices, parts, shares, rest } = mesh;
    if *vertices == 0 {
        return Ok(());
    }
    // The pieces of each pose, one pose after the other.
    let pieces = |to| chunks_of_chunks(to, *vertices);
    let (mut normals, mut tangents) = (posed.normals.map(pieces), posed.tangents.map(pieces));
    let posed = pieces(posed.positions).map(|positions| SurfaceMut {
        positions,
        normals: normals.as_mut().and_then(Iterator::next),
        tangents: tangents.as_mut().and_then(Iterator::next),
    });
    let failure = OnceLock::new();
    threads.each(posed.enumerate(), &|(index, posed)| {
        let (pose, part) = (index / parts.len(), index % parts.len());
        let of = part * GRAIN..part * GRAIN + posed.positions.len();
        let rest = Surface {
            positions: &rest.positions[of.clone()],
            normals: rest.normals.map(|normals| &normals[of.clone()]),
            tangents: rest.tangents.map(|tangents| &tangents[of.clone()]),
        };
        let shares = shares.get(of).unwrap_or_default();
        let done = palette.pose(&parts[part], shares, pose, rest, posed);
        done.map_err(|error| failure.set(error)).is_ok()
    });
    failure.into_inner().map_or(Ok(()), Err)
}

/// Pieces of the vertices of each pose.
fn chunks_of_chunks<T>(to: &mut [T], vertices: usize) -> impl Iterator<Item = &mut [T]> {
    to.chunks_mut(vertices).flat_map(|pose| pose.chunks_mut(GRAIN))
}

/// Numbers of joints, and their shape.
fn joints_of(joints: &Bound<'_, PyAny>) -> PyResult<(Vec<u32>, Vec<usize>)> {
    let numpy = joints.py().import("numpy")?;
    let array = view(&plain("joints", joints)?)?;
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

//! Products of motions that follow each other.

use crate::argument::{Argument, Input, common_dtype, is_single};
use crate::axis::Axis;
use crate::call::Answer;
use crate::number::Number;
use crate::output::Output;
use crate::shape::EIGHT;
use crate::threads::{GRAIN, Threads};
use dq8::{Backend, DualQuat};
use pyo3::prelude::*;

/// Running products ``σ₀σ₁…σᵢ`` of motions that follow each other: the joints of a rope,
/// the path of its steps.
///
/// Parameters
/// ----------
/// motions : array_like, shape (n, ..., 8)
///     Dual quaternions, each in the frame of the one before.
/// axis : int, optional
///     The dimension along which they follow each other: the first.
/// out : ndarray, optional
///     Where to write the result.
///
/// Returns
/// -------
/// ndarray, shape (n, ..., 8)
#[doc = common_dtype!()]
///     The last along `axis` is the product of all.
///
/// Examples
/// --------
/// >>> import dq8, numpy as np
/// >>> steps = dq8.from_translation(np.ones((4, 1)) * [1.0, 0.0, 0.0])
/// >>> dq8.translation(dq8.chain_products(steps))[:, 0]
/// array([1., 2., 3., 4.])
#[pyfunction]
#[pyo3(signature = (motions, *, axis=0, out=None))]
pub fn chain_products<'py>(
    motions: &Bound<'py, PyAny>,
    axis: isize,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    let motions = Argument::new("motions", EIGHT, motions)?;
    let axis = Axis::of(&motions, axis, "(n, ..., 8)")?;
    let motions = motions.along(axis)?;
    if is_single([&motions]) {
        typed::<f32>(&motions, axis, out)
    } else {
        typed::<f64>(&motions, axis, out)
    }
}

fn typed<'py, R: Number>(
    motions: &Argument<'py>,
    axis: Axis,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    let motions = Input::<R>::of(motions)?.in_full()?;
    let leading = motions.full_leading().to_vec();
    let length = leading.last().copied().unwrap_or_default().max(1);
    axis.written(out, &[&leading[..], EIGHT].concat(), 1, |out| {
        let output = Output::<R>::new(motions.py(), out, &leading, EIGHT)?;
        let motions = motions.apart_from(&output)?;
        let (links, threads) =
            (motions.records::<8>(), Threads::for_elements(leading.iter().product()));
        output.fill(&threads, |to: &mut [[R; 8]]| {
            threads.split(length * GRAIN.div_ceil(length), to, &|(first, to)| {
                // As motions, for which the kernel is there already.
                bytemuck::must_cast_slice_mut::<[R; 8], DualQuat<R>>(to)
                    .chunks_mut(length)
                    .zip(bytemuck::must_cast_slice(&links[first..]).chunks(length))
                    .all(|(to, links): (_, &[DualQuat<R>])| {
                        Backend::best().chain_products(links, to).is_ok()
                    })
            });
            Ok(())
        })
    })
}

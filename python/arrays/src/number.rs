//! [`Number`]: what arrays are made of.

use crate::argument::{Argument, Input};
use crate::output::Output;
use dq8::Scalar;
use dq8::skinning::Weight;
use dq8::storage::Aos;
use dq8_robot::JointValues;
use numpy::Element;
use pyo3::prelude::*;

/// A number that NumPy has too.
///
/// Its functions are those of [`Input`] and [`Output`] that all crates call: as functions of two
/// types they are compiled once, and not in each crate again.
pub trait Number: Scalar + Element + JointValues<Aos<Self>> + Weight {
    /// [`Input::attached`].
    fn attached<'py>(argument: &Argument<'py>) -> PyResult<Input<'py, Self>>;
    /// [`Input::filled`].
    fn filled<'py>(input: Input<'py, Self>, shape: &[usize]) -> PyResult<Input<'py, Self>>;
    /// [`Output::new`].
    fn output<'py>(
        py: Python<'py>,
        out: Option<&Bound<'py, PyAny>>,
        leading: &[usize],
        core: &[usize],
    ) -> PyResult<Output<'py, Self>>;
}

macro_rules! numbers {
    ($($R:ident)*) => {$(
        impl Number for $R {
            #[inline(never)]
            fn attached<'py>(argument: &Argument<'py>) -> PyResult<Input<'py, Self>> {
                Input::read(argument)
            }
            #[inline(never)]
            fn filled<'py>(input: Input<'py, Self>, shape: &[usize]) -> PyResult<Input<'py, Self>> {
                input.repeated(shape)
            }
            #[inline(never)]
            fn output<'py>(
                py: Python<'py>,
                out: Option<&Bound<'py, PyAny>>,
                leading: &[usize],
                core: &[usize],
            ) -> PyResult<Output<'py, Self>> {
                Output::made(py, out, leading, core)
            }
        }
    )*};
}
numbers! { f32 f64 }

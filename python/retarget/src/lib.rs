//! The motion of a person on a humanoid robot. What users import is in `package/dq8/retarget.py`.

pub mod humanoid;
pub mod motion;
pub mod person;

use dq8_python_arrays::error::value_error;
use dq8_python_arrays::{argument, interrupt, links, shape, threads};
use dq8_retarget::RetargetError;
use pyo3::prelude::*;

/// Returns the exception that an error becomes, with the keyword that mends it.
fn raised(error: &RetargetError) -> PyErr {
    let keyword = match error {
        RetargetError::NoRest => " (`rest=`)",
        RetargetError::NoLegs { .. } => " (`table=`)",
        RetargetError::TooLittle { .. } => " (`table=` of the robot, or of the clip)",
        _ => "",
    };
    value_error(format!("{error}{keyword}"))
}

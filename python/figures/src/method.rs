//! [`Method`]: how a mesh follows its joints.

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// How the motions of joints are blended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Method {
    Dual,
    Linear,
    Mixed,
}

impl Method {
    /// What Python calls so.
    pub(crate) fn of(name: &str) -> PyResult<Self> {
        match name {
            "dlb" => Ok(Self::Dual),
            "lbs" => Ok(Self::Linear),
            "mix" => Ok(Self::Mixed),
            _ => Err(PyValueError::new_err(format!(
                "Expected `method` to be 'dlb', 'lbs' or 'mix', got '{name}'."
            ))),
        }
    }
}

//! Parts of dq8 for dq8-robot, dq8-trajectory and dq8-capi alone. They may change in any version.

pub use crate::backend::{Choice, Outputs, Rows, options};
pub use crate::batch::even::{exponential_integrals, half_cotangent};
pub use crate::macros::{brief, errors};
pub use crate::quick::{Number, Quick};
pub use crate::scalar::blend::{dib, weighted_sum};
pub use crate::{__for_each_kernel as for_each_kernel, __record as record};

//! [`Number`]: what arrays are made of.

use dq8::Scalar;
use dq8::skinning::Weight;
use dq8::storage::Aos;
use dq8_robot::JointValues;
use numpy::Element;

/// A number that NumPy has too.
pub trait Number: Scalar + Element + JointValues<Aos<Self>> + Weight {}
impl Number for f32 {}
impl Number for f64 {}

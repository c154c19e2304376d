//! [`Precision`]: that of the numbers of a call.

use dq8_robot::OwnedMechanism;

/// A mechanism of the numbers of a call. (What takes it is no generic function, which would be
/// compiled where it is called.)
#[derive(Clone, Copy, Debug)]
pub enum Precision<'m> {
    /// Of float32.
    Single(&'m OwnedMechanism<f32>),
    /// Of float64.
    Double(&'m OwnedMechanism<f64>),
}

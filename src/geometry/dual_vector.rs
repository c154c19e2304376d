/// A dual vector a + εb (Jia, *Dual Quaternions*, §3): the vector part of a dual quaternion, and
/// the logarithm of a unit one.
///
/// The logarithm of a screw is (θ̂/2)(l + εm): `real` = l·θ/2 and `dual` = m·θ/2 + l·d/2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DualVector<T> {
    /// a
    pub real: [T; 3],
    /// b
    pub dual: [T; 3],
}

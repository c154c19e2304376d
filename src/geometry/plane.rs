/// A plane n·x = d.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane<T> {
    /// n, the normal.
    pub normal: [T; 3],
    /// d, the distance from the origin along n, in units of |n|.
    pub offset: T,
}

/// A line in Plücker coordinates l + εm: every point x of it has x × l = m.
///
/// The length of l is free; with |l| = 1, |m| is the distance from the origin and l × m the closest
/// point (Jia, *Dual Quaternions*, §8.1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line<T> {
    /// l, the direction.
    pub direction: [T; 3],
    /// m = x × l for any point x of the line, the moment about the origin.
    pub moment: [T; 3],
}

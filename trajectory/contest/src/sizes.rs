// Sizes that the peers in C++ are compiled with.

/// The points of a scan: 128 rows of 1,024 columns. Splines are sampled at as many times.
pub const POINTS: usize = 131_072;
/// The poses of a trajectory, of which there is one at each end of 100 segments.
pub const POSES: usize = 101;
/// The control poses of a spline.
pub const CONTROL: usize = 1000;

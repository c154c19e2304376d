/// A format of text files with a pose on every line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// The format of the TUM RGB-D benchmark (Sturm et al. 2012), which most programs write.
    Tum,
    /// The format of the ground truth of the EuRoC MAV dataset (Burri et al. 2016).
    Euroc,
    /// The format of the poses of the KITTI odometry benchmark (Geiger et al. 2012). Lines are
    /// stamped 0, 1, 2 … seconds; true stamps, from a file of their own, make a trajectory with
    /// the poses by [`OwnedTrajectory::new`](crate::OwnedTrajectory::new).
    Kitti,
}

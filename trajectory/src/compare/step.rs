/// The distance between the two poses of each motion that is compared. The next step
/// begins where the last one ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Step {
    /// So many pairs of poses further.
    Frames(usize),
    /// The first pair at which the estimate, as it is aligned, has gone so far since the beginning
    /// of the step: the sum of the distances from pose to pose.
    Metres(f64),
    /// The first pair whose stamp is so much later, but for rounding of the stamps.
    Seconds(f64),
}

//! What users write with nalgebra: a loop over joints whose parents come first.

use super::agree;
use dq8::DualQuat;
use dq8_fixtures::turns::Job;
use dq8_robot::{Joint, JointKind};
use nalgebra::{
    Isometry3, Quaternion, RealField, Translation3, Unit, UnitDualQuaternion, UnitQuaternion,
    UnitVector3, Vector3, convert,
};
use std::hint::black_box;
use std::ops::Mul;

/// A rigid motion in one of nalgebra's types, of numbers `N`.
trait Pose<N: RealField>: Copy + Mul<Output = Self> + Mul<UnitQuaternion<N>, Output = Self> {
    const NAME: &str;
    fn new(isometry: Isometry3<N>) -> Self;
    fn to_isometry(self) -> Isometry3<N>;
}

impl<N: RealField + Copy> Pose<N> for Isometry3<N> {
    const NAME: &str = "nalgebra Isometry3: all poses";
    fn new(isometry: Isometry3<N>) -> Self {
        isometry
    }
    fn to_isometry(self) -> Isometry3<N> {
        self
    }
}

impl<N: RealField + Copy> Pose<N> for UnitDualQuaternion<N> {
    const NAME: &str = "nalgebra UnitDualQuaternion: all poses";
    fn new(isometry: Isometry3<N>) -> Self {
        Self::from_isometry(&isometry)
    }
    fn to_isometry(self) -> Isometry3<N> {
        UnitDualQuaternion::to_isometry(self)
    }
}

/// A hinge.
struct Hinge<N, P> {
    parent: Option<usize>,
    placement: P,
    axis: UnitVector3<N>,
}

impl<N: RealField + Copy, P: Pose<N>> Hinge<N, P> {
    fn new(joint: &Joint<f64>) -> Self {
        let JointKind::Revolute { axis } = joint.kind else { panic!("no hinge") };
        let [x, y, z, w] = joint.placement.rotation().to_array().map(convert);
        let turn = UnitQuaternion::new_normalize(Quaternion::new(w, x, y, z));
        let place = Translation3::from(Vector3::from(joint.placement.translation().map(convert)));
        Self {
            parent: joint.parent,
            placement: P::new(Isometry3::from_parts(place, turn)),
            axis: Unit::new_normalize(Vector3::from(axis.map(convert))),
        }
    }
}

/// All configurations.
fn all_poses<N: RealField + Copy, P: Pose<N>>(
    hinges: &[Hinge<N, P>],
    values: &[N],
    poses: &mut [P],
) {
    let poses = poses.chunks_exact_mut(hinges.len());
    for (values, poses) in values.chunks_exact(hinges.len()).zip(poses) {
        for (link, (hinge, &value)) in hinges.iter().zip(values).enumerate() {
            let local = hinge.placement * UnitQuaternion::from_axis_angle(&hinge.axis, value);
            poses[link] = match hinge.parent {
                Some(parent) => poses[parent] * local,
                None => local,
            };
        }
    }
}

fn job<'a, N, P>(joints: &[Joint<f64>], values: &'a [N], expected: &[DualQuat<f64>]) -> Job<'a>
where
    N: RealField + Copy + Into<f64>,
    P: Pose<N> + 'a,
{
    let hinges: Vec<Hinge<N, P>> = joints.iter().map(Hinge::new).collect();
    let mut poses = vec![P::new(Isometry3::identity()); values.len()];
    all_poses(&hinges, values, &mut poses);
    let arrays = |pose: &P| -> ([f64; 3], [f64; 4]) {
        let pose = pose.to_isometry();
        let (position, turn): ([N; 3], [N; 4]) =
            (pose.translation.vector.into(), pose.rotation.coords.into());
        (position.map(Into::into), turn.map(Into::into))
    };
    let found: Vec<_> = poses.iter().map(arrays).collect();
    agree(P::NAME, 1e4 * N::default_epsilon().into(), expected, &found);
    Job::new(P::NAME, move || all_poses(&hinges, black_box(values), &mut poses))
}

pub fn jobs<'a, N: RealField + Copy + Into<f64>>(
    joints: &[Joint<f64>],
    values: &'a [N],
    expected: &[DualQuat<f64>],
) -> Vec<Job<'a>> {
    vec![
        job::<N, Isometry3<N>>(joints, values, expected),
        job::<N, UnitDualQuaternion<N>>(joints, values, expected),
    ]
}

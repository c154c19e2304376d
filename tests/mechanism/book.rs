//! One configuration by the book. Floats compute it in one lane instead; dual numbers do not.

use crate::random::mechanism;
use dq8::mechanism::{JacobianFrame, Joint, Mechanism, OwnedMechanism};
use dq8::{Dual, DualQuat, Twist};

pub(crate) struct Book(OwnedMechanism<Dual<f64>>);

impl Book {
    pub(crate) fn new(joints: &[Joint<f64>]) -> Self {
        Self(mechanism(joints))
    }

    pub(crate) fn view(&self) -> Mechanism<'_, Dual<f64>> {
        self.0.view()
    }

    pub(crate) fn link_poses(&self, values: &[f64], poses: &mut [DualQuat<f64>]) {
        let mut wanted = vec![DualQuat::IDENTITY; poses.len()];
        self.view().link_poses(&constant(values), &mut wanted).expect("lengths fit");
        for (pose, wanted) in poses.iter_mut().zip(wanted) {
            *pose = real(wanted);
        }
    }

    pub(crate) fn link_jacobian<F: JacobianFrame>(
        &self,
        frame: F,
        values: &[f64],
        link: usize,
        columns: &mut [Twist<f64>],
    ) -> DualQuat<f64> {
        let mut wanted = vec![Twist::from_array([Dual::new(0.0, 0.0); 6]); columns.len()];
        let values = constant(values);
        let pose = self.view().link_jacobian(frame, &values, link, &mut wanted);
        for (column, wanted) in columns.iter_mut().zip(wanted) {
            *column = Twist::from_array(wanted.to_array().map(|number| number.real));
        }
        real(pose.expect("lengths fit"))
    }
}

fn constant(values: &[f64]) -> Vec<Dual<f64>> {
    values.iter().map(|&value| Dual::new(value, 0.0)).collect()
}

fn real(pose: DualQuat<Dual<f64>>) -> DualQuat<f64> {
    DualQuat::from_array(pose.to_array().map(|number| number.real))
}

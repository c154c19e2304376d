//! One configuration by the book. Floats compute it in one lane instead.

use crate::tree::mechanism;
use dq8::{DualQuat, Twist};
use dq8_fixtures::textbook::Textbook;
use dq8_robot::{JacobianFrame, Joint, Mechanism, OwnedMechanism};

pub(crate) struct Book(OwnedMechanism<Textbook<f64>>);

impl Book {
    pub(crate) fn new(joints: &[Joint<f64>]) -> Self {
        Self(mechanism(joints))
    }

    pub(crate) fn view(&self) -> Mechanism<'_, Textbook<f64>> {
        self.0.view()
    }

    pub(crate) fn link_poses(&self, values: &[f64], poses: &mut [DualQuat<f64>]) {
        let mut wanted = vec![DualQuat::IDENTITY; poses.len()];
        self.view().link_poses(&wrapped(values), &mut wanted).expect("lengths fit");
        for (pose, wanted) in poses.iter_mut().zip(wanted) {
            *pose = unwrapped(wanted);
        }
    }

    pub(crate) fn link_jacobian<F: JacobianFrame>(
        &self,
        frame: F,
        values: &[f64],
        link: usize,
        columns: &mut [Twist<f64>],
    ) -> DualQuat<f64> {
        let mut wanted = vec![Twist::from_array([Textbook(0.0); 6]); columns.len()];
        let values = wrapped(values);
        let pose = self.view().link_jacobian(frame, &values, link, &mut wanted);
        for (column, wanted) in columns.iter_mut().zip(wanted) {
            *column = Twist::from_array(wanted.to_array().map(|number| number.0));
        }
        unwrapped(pose.expect("lengths fit"))
    }
}

fn wrapped(values: &[f64]) -> Vec<Textbook<f64>> {
    values.iter().copied().map(Textbook).collect()
}

fn unwrapped(pose: DualQuat<Textbook<f64>>) -> DualQuat<f64> {
    DualQuat::from_array(pose.to_array().map(|number| number.0))
}

//! Mechanisms whose base floats.

use crate::error::value_error;
use crate::mechanism::Mechanism;
use dq8_robot::urdf::Drive;
use dq8_robot::{Joint, JointKind, OwnedMechanism};
use pyo3::prelude::*;

/// The name of the joint that floats, as in `dq8_robot::urdf::Robot::floating`.
const NAME: &str = "root_joint";

/// Returns the mechanism with a floating joint in place of the joint that holds its root.
pub(crate) fn floating(fixed: &Bound<'_, Mechanism>) -> PyResult<Mechanism> {
    let own = fixed.get();
    if own.joint_names.iter().flatten().any(|name| name == NAME) {
        return Err(value_error(format!("There is a joint {NAME:?} already.")));
    }
    // The first joint is one of the base, because parents come before their children.
    let [root, others @ ..] = &own.joints[..] else { return Err(value_error("there is no link")) };
    if root.kind != JointKind::Fixed || others.iter().any(|joint| joint.parent.is_none()) {
        return Err(value_error(
            "Expected one link that is fixed to the base, and carries all others: add a link, whose kind may be \
             \"floating\" at once.",
        ));
    }
    let mut joints = own.joints.clone();
    joints[0] = Joint::floating(None, root.placement);
    let (double, single) = fixed.py().detach(|| {
        let single: Vec<_> = joints.iter().map(Joint::cast).collect();
        (OwnedMechanism::new(&joints), OwnedMechanism::new(&single))
    });
    let (mut drives, mut joint_names) = (own.drives.clone(), own.joint_names.clone());
    drives[0] = Drive::FREE;
    joint_names[0] = Some(NAME.to_owned());
    Ok(Mechanism {
        links: own.links.clone(),
        joint_names,
        double: double.map_err(value_error)?,
        single,
        drives,
        joints,
        urdf: None,
        fixed: Some(fixed.clone().unbind()),
    })
}

//! The joints of a mechanism from arrays, and their names.

use crate::argument::{Argument, Input};
use crate::error::misshapen;
use crate::shape::{EIGHT, NUMBER, tuple};
use dq8::DualQuat;
use dq8_robot::urdf::Drive;
use dq8_robot::{Joint, JointKind, OwnedMechanism};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use std::iter::repeat_n;

/// What the arrays say of each joint, before it is checked.
pub(crate) struct Arrays<'a, 'py> {
    pub(crate) parents: &'a [u32],
    pub(crate) kinds: &'a Bound<'py, PyAny>,
    pub(crate) axes: &'a Bound<'py, PyAny>,
    pub(crate) placements: &'a Bound<'py, PyAny>,
    pub(crate) limits: Option<&'a Bound<'py, PyAny>>,
}

impl Arrays<'_, '_> {
    /// The joints.
    pub(crate) fn joints(&self) -> PyResult<Vec<Joint<f64>>> {
        let count = self.parents.len();
        let kinds = kinds(self.kinds, count)?;
        let axes = rows::<3>("axes", &[3], self.axes, count)?;
        let placements = rows::<8>("placements", EIGHT, self.placements, count)?;
        let limits = match self.limits {
            Some(limits) => rows::<2>("limits", &[2], limits, count)?,
            None => vec![NO_LIMITS; count],
        };
        let mut joints = Vec::with_capacity(count);
        for (index, &parent) in self.parents.iter().enumerate() {
            let parent = (parent != dq8::Hierarchy::ROOT).then_some(parent as usize);
            let kind = kind(&kinds[index], axes[index]).ok_or_else(|| {
                PyValueError::new_err(format!(
                    "Expected `kinds` to be of \"fixed\", \"revolute\", \"prismatic\", \"planar\" and \
                     \"floating\", got {:?}.",
                    kinds[index]
                ))
            })?;
            let joint = Joint::new(parent, DualQuat::from_array(placements[index]), kind);
            let none = limits[index] == NO_LIMITS;
            joints.push(if none { joint } else { joint.with_limits(limits[index]) });
        }
        Ok(joints)
    }
}

/// Where a joint without limits may go.
pub(crate) const NO_LIMITS: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

/// The greatest speeds and efforts of joints.
pub(crate) fn drives(
    count: usize,
    velocities: Option<&Bound<'_, PyAny>>,
    efforts: Option<&Bound<'_, PyAny>>,
) -> PyResult<Vec<Drive>> {
    let greatest = |name, given: Option<&Bound<'_, PyAny>>| {
        let Some(given) = given else { return Ok(vec![[f64::INFINITY]; count]) };
        let numbers = rows::<1>(name, NUMBER, given, count)?;
        let wrong = |&(_, &[it]): &(usize, &[f64; 1])| it.is_nan() || it < 0.0;
        if let Some((joint, [wrong])) = numbers.iter().enumerate().find(wrong) {
            let message = format!("`{name}`: that of joint {joint} is {wrong}, not 0 or more.");
            return Err(PyValueError::new_err(message));
        }
        Ok(numbers)
    };
    let velocities = greatest("velocity_limits", velocities)?;
    let efforts = greatest("effort_limits", efforts)?.into_iter();
    let both = velocities.into_iter().zip(efforts);
    Ok(both.map(|([velocity], [effort])| Drive { velocity, effort }).collect())
}

/// One kind for all joints, or one for each.
fn kinds(given: &Bound<'_, PyAny>, count: usize) -> PyResult<Vec<String>> {
    if let Ok(kind) = given.extract::<String>() {
        return Ok(vec![kind; count]);
    }
    let kinds: Vec<String> = given.extract().map_err(|_| {
        PyTypeError::new_err("Expected `kinds` to be a string, or a sequence of strings.")
    })?;
    if kinds.len() == count {
        return Ok(kinds);
    }
    let message = format!("Expected `kinds` to have {count} elements, got {}.", kinds.len());
    Err(PyValueError::new_err(message))
}

/// An array with one row for each joint, or one row for all.
fn rows<const C: usize>(
    name: &'static str,
    core: &'static [usize],
    value: &Bound<'_, PyAny>,
    count: usize,
) -> PyResult<Vec<[f64; C]>> {
    let input = Input::<f64>::of(&Argument::new(name, core, value)?)?;
    match *input.full_leading() {
        [] | [1] => Ok(input.records::<C>().repeat(count)),
        [own] if own == count => Ok(input.filled(&[count])?.records::<C>().to_vec()),
        _ => {
            let each = tuple(&[&[count], core].concat());
            Err(misshapen(name, &format!("{each} or {}", tuple(core)), &input.shape()))
        }
    }
}

fn kind(name: &str, axis: [f64; 3]) -> Option<JointKind<f64>> {
    Some(match name {
        "fixed" => JointKind::Fixed,
        "revolute" => JointKind::Revolute { axis },
        "prismatic" => JointKind::Prismatic { axis },
        "planar" => JointKind::Planar { normal: axis },
        "floating" => JointKind::Floating,
        _ => return None,
    })
}

/// The kind of a joint as text, and its axis.
fn name_and_axis(kind: JointKind<f64>) -> (&'static str, [f64; 3]) {
    match kind {
        JointKind::Revolute { axis } => ("revolute", axis),
        JointKind::Prismatic { axis } => ("prismatic", axis),
        JointKind::Planar { normal } => ("planar", normal),
        JointKind::Floating => ("floating", [0.0; 3]),
        _ => ("fixed", [0.0; 3]),
    }
}

/// Names of all values and of all rates: those of the joints, with endings where a joint has
/// several.
pub(crate) fn values_and_rates(
    joints: &[Joint<f64>],
    names: &[Option<String>],
) -> (Vec<String>, Vec<String>) {
    let mut all = [Vec::new(), Vec::new()];
    for (joint, name) in joints.iter().zip(names) {
        let (Some(name), None) = (name, joint.mimic) else { continue };
        let endings: [&[&str]; 2] = match joint.kind {
            JointKind::Fixed => [&[], &[]],
            JointKind::Planar { .. } => [&[".x", ".y", ".angle"]; 2],
            JointKind::Floating => [
                &[".qx", ".qy", ".qz", ".qw", ".x", ".y", ".z"],
                &[".wx", ".wy", ".wz", ".vx", ".vy", ".vz"],
            ],
            _ => [&[""]; 2],
        };
        for (all, endings) in all.iter_mut().zip(endings) {
            all.extend(endings.iter().map(|ending| format!("{name}{ending}")));
        }
    }
    let [values, rates] = all;
    (values, rates)
}

/// Least and largest of all values.
pub(crate) fn limits(mechanism: &OwnedMechanism<f64>) -> Vec<[f64; 2]> {
    let view = mechanism.view();
    let mut all = vec![NO_LIMITS; view.values()];
    // There is one for each value.
    let _ = view.value_limits(&mut all);
    all
}

/// Between what values are drawn: limits; where there are none half a turn either way and a length
/// of one; NaN for the components of a rotation.
pub(crate) fn spans(joints: &[Joint<f64>], mechanism: &OwnedMechanism<f64>) -> Vec<[f64; 2]> {
    const TURN: [f64; 2] = [-core::f64::consts::PI, core::f64::consts::PI];
    const UNIT: [f64; 2] = [-1.0, 1.0];
    const FREE: [f64; 2] = [f64::NAN; 2];
    let mut all = limits(mechanism);
    for (index, joint) in joints.iter().enumerate() {
        let usual: &[[f64; 2]] = match joint.kind {
            JointKind::Revolute { .. } | JointKind::Screw { .. } => &[TURN],
            JointKind::Planar { .. } => &[UNIT, UNIT, TURN],
            JointKind::Floating => &[FREE, FREE, FREE, FREE, UNIT, UNIT, UNIT],
            _ => &[UNIT],
        };
        let range = joint.mimic.is_none().then(|| mechanism.view().values_of(index)).flatten();
        for (value, usual) in range.unwrap_or_default().zip(usual) {
            for (end, usual) in all[value].iter_mut().zip(usual) {
                *end = if end.is_finite() { *end } else { *usual };
            }
        }
    }
    all
}

/// What is so of a joint, for each of its rates; those of a joint that mimics are of another one.
pub(crate) fn of_rates(joints: &[Joint<f64>], drives: &[Drive], of: fn(&Drive) -> f64) -> Vec<f64> {
    let own = joints.iter().zip(drives).filter(|(joint, _)| joint.mimic.is_none());
    own.flat_map(|(joint, drive)| repeat_n(of(drive), joint.kind.rates())).collect()
}

/// What the arrays said of each joint, as `Mechanism` takes it.
pub(crate) type Given = (
    Vec<i64>,
    Vec<&'static str>,
    Vec<[f64; 3]>,
    Vec<[f64; 8]>,
    Vec<[f64; 2]>,
    Vec<String>,
    Vec<f64>,
    Vec<f64>,
);

/// The arrays that joints are made of, and the names of links.
pub(crate) fn arrays_of(joints: &[Joint<f64>], drives: &[Drive], links: Vec<String>) -> Given {
    let (kinds, axes) = joints.iter().map(|joint| name_and_axis(joint.kind)).unzip();
    let placements = joints.iter().map(|joint| joint.placement.to_array()).collect();
    let limits = joints.iter().map(|joint| joint.limits.unwrap_or(NO_LIMITS)).collect();
    let (speeds, efforts) = drives.iter().map(|drive| (drive.velocity, drive.effort)).unzip();
    (parents(joints), kinds, axes, placements, limits, links, speeds, efforts)
}

/// The parent of each, −1 for the base.
pub(crate) fn parents(joints: &[Joint<f64>]) -> Vec<i64> {
    joints.iter().map(|joint| joint.parent.map_or(-1, |it| it as i64)).collect()
}

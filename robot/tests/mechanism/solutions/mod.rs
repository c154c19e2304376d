//! All solutions of arms of six hinges: how many there are, where they are, and what they are
//! nearest to.

mod counts;
mod edges;
mod near;
mod owned;
mod refused;
mod wrist;

use dq8::{DualQuat, Quat, Scalar};
use dq8_arms::{Arm, Axis, Plan, Random, X, Y, Z, puma, rounded, turning, ur5};
use dq8_robot::ik::{Family, SixAxisArm, Solutions};
use std::f64::consts::PI;

/// Hinges that turn all around.
fn free(plan: Plan<6>) -> Plan<6> {
    plan.with_axes(|axis| Axis { limits: [-PI, PI], ..axis })
}

/// An arm with a spherical wrist whose first two axes do not meet, in the measures of an ABB IRB
/// 6640 (Elias and Wen, IK-Geo).
fn irb6640() -> Plan<6> {
    let wrist = [1.4625, 0.0, 2.055];
    let arm = [(Z, [0.0; 3]), (Y, [0.32, 0.0, 0.78]), (Y, [0.32, 0.0, 1.855])];
    let [a, b, c] = arm;
    turning([a, b, c, (X, wrist), (Y, wrist), (X, wrist)], (X, 0.0, [1.6625, 0.0, 2.055]))
}

/// A KUKA LBR iiwa R800 whose third joint is held at 30 degrees (ibid.): the second and third axis
/// are not parallel.
fn iiwa_held() -> Plan<6> {
    let turned = [-0.5, 0.75_f64.sqrt(), 0.0];
    let axes = [
        (Z, [0.0; 3]),
        (Y, [0.0, 0.0, 0.34]),
        (turned.map(|c| -c), [0.0, 0.0, 0.74]),
        (Z, [0.0; 3]),
        (turned, [0.0, 0.0, 1.14]),
        (Z, [0.0; 3]),
    ];
    turning(axes, (Z, PI / 6.0, [0.0, 0.0, 1.266]))
}

/// The same arm on a base that stands askew, so that no axis is one of the frame.
fn askew(plan: Plan<6>) -> Plan<6> {
    let base = Random(11).motion(0.5);
    let home = DualQuat::from_rotation_translation(
        Quat::from_axis_angle(plan.home.0, plan.home.1),
        plan.home.2,
    );
    let home = base * home;
    let (axis, angle) = home.rotation().to_axis_angle();
    let moved = |axis: Axis| Axis {
        direction: base.transform_vector(axis.direction),
        through: base.transform_point(axis.through),
        ..axis
    };
    Plan { axes: plan.axes.map(moved), home: (axis, angle, home.translation()) }
}

fn families() -> [(&'static str, Plan<6>, Family); 6] {
    use Family::{SphericalWrist, ThreeParallel};
    [
        ("UR5", ur5(), ThreeParallel),
        ("PUMA", puma(), SphericalWrist),
        ("IRB 6640", irb6640(), SphericalWrist),
        ("iiwa", iiwa_held(), SphericalWrist),
        ("UR5 askew", askew(ur5()), ThreeParallel),
        ("PUMA askew", askew(free(puma())), SphericalWrist),
    ]
}

/// Values, and the poses of the tool there.
struct Poses<R> {
    arm: Arm<R, 6>,
    values: Vec<[f64; 6]>,
    targets: Vec<DualQuat<R>>,
}

impl<R: Scalar> Poses<R> {
    fn at(plan: &Plan<6>, values: Vec<[f64; 6]>) -> Self {
        let arm = plan.arm();
        let targets = values.iter().map(|&values| arm.forward(&rounded(values))).collect();
        Self { arm, values, targets }
    }

    fn random(plan: &Plan<6>, count: usize) -> Self {
        let mut random = Random(37);
        Self::at(plan, (0..count).map(|_| plan.draw(&mut random)).collect())
    }

    fn six(&self) -> SixAxisArm<'_, R> {
        SixAxisArm::new(self.arm.0.view()).expect("six hinges")
    }

    /// The solutions of all, from the values that they were made of.
    fn solve(&self) -> Vec<Solutions<R>> {
        let starts: Vec<[R; 6]> = self.values.iter().map(|&values| rounded(values)).collect();
        let mut found = vec![Solutions::default(); starts.len()];
        self.six().job().solutions(&self.targets, &starts, &mut found).expect("lengths fit");
        found
    }
}

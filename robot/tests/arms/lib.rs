//! Arms to test with, the same numbers in every run, and what nalgebra says of them.

#![allow(missing_docs, reason = "made for the tests of dq8-robot, which read it")]

use dq8::geometry::Screw;
use dq8::simd::{Lanes, Portable};
use dq8::{Backend, DualQuat, Line, Quat, Real, Scalar};
pub use dq8_fixtures::random::Random;
use dq8_robot::ik::{Goal, Options, OwnedReach, Reach, ReachJob, Report, SixAxisArm, SolutionsJob};
use dq8_robot::{Joint, JointKind, MechanismError, OwnedMechanism};
use nalgebra::{Isometry3, Translation3, UnitQuaternion, Vector3};
use std::f64::consts::PI;

pub const X: [f64; 3] = [1.0, 0.0, 0.0];
pub const Y: [f64; 3] = [0.0, 1.0, 0.0];
pub const Z: [f64; 3] = [0.0, 0.0, 1.0];

/// A joint as its axis, a point on it, its limits, and the length it slides by radian.
#[derive(Clone, Copy, Debug)]
pub struct Axis {
    pub direction: [f64; 3],
    pub through: [f64; 3],
    pub limits: [f64; 2],
    /// `None` for a slide.
    pub pitch: Option<f64>,
}

/// The joints of an arm, and its tool.
#[derive(Clone, Copy, Debug)]
pub struct Plan<const N: usize> {
    pub axes: [Axis; N],
    /// Axis and angle, and translation.
    pub home: ([f64; 3], f64, [f64; 3]),
}

fn hinge(direction: [f64; 3], through: [f64; 3], limits: [f64; 2]) -> Axis {
    Axis { direction, through, limits, pitch: Some(0.0) }
}

fn down([x, y, z]: [f64; 3]) -> [f64; 3] {
    [-x, -y, -z]
}

/// Hinges that turn all around: directions, and points on them.
pub fn turning<const N: usize>(
    axes: [([f64; 3], [f64; 3]); N],
    home: ([f64; 3], f64, [f64; 3]),
) -> Plan<N> {
    Plan { axes: axes.map(|(direction, through)| hinge(direction, through, [-PI, PI])), home }
}

/// A UR5: three parallel axes after the first, stretched at zero; every joint turns all around.
pub fn ur5() -> Plan<6> {
    let axes = [
        (Z, [0.0; 3]),
        (Y, [0.0, 0.0, 0.089159]),
        (Y, [0.425, 0.0, 0.089159]),
        (Y, [0.81725, 0.0, 0.089159]),
        (down(Z), [0.81725, 0.10915, 0.0]),
        (Y, [0.81725, 0.0, -0.005491]),
    ];
    turning(axes, (X, -PI / 2.0, [0.81725, 0.19145, -0.005491]))
}

/// A PUMA 560: a shoulder, an elbow and a wrist of three crossing axes, with the limits of its
/// makers.
pub fn puma() -> Plan<6> {
    let turn = |direction, through, limits: [f64; 2]| {
        hinge(direction, through, limits.map(f64::to_radians))
    };
    let axes = [
        turn(Z, [0.0; 3], [-160.0, 160.0]),
        turn(down(Y), [0.0; 3], [-225.0, 45.0]),
        turn(down(Y), [0.4318, 0.0, 0.0], [-45.0, 225.0]),
        turn(Z, [0.4115, -0.1501, 0.0], [-110.0, 170.0]),
        turn(down(Y), [0.4115, 0.0, 0.4331], [-100.0, 100.0]),
        turn(Z, [0.4115, -0.1501, 0.0], [-266.0, 266.0]),
    ];
    Plan { axes, home: (X, 0.0, [0.4115, -0.1501, 0.4894]) }
}

/// An arm of seven axes, in the measures and limits of a KUKA iiwa 7.
pub fn seven() -> Plan<7> {
    let limits = [170.0_f64, 120.0, 170.0, 120.0, 170.0, 120.0, 175.0];
    let axes = [(Z, 0.34), (Y, 0.34), (Z, 0.34), (down(Y), 0.74), (Z, 0.74), (Y, 1.14), (Z, 1.14)];
    let axes = core::array::from_fn(|i| {
        let limit = limits[i].to_radians();
        hinge(axes[i].0, [0.0, 0.0, axes[i].1], [-limit, limit])
    });
    Plan { axes, home: (X, 0.0, [0.0, 0.0, 1.266]) }
}

/// Six hinges about axes in any direction, a third of a length apart, each turning all around.
pub fn six_of_any_kind(random: &mut Random) -> Plan<6> {
    let mut at = [0.0; 3];
    let axes = core::array::from_fn(|_| {
        at = at.map(|c| c + random.between(-0.3, 0.3));
        (random.direction(), at)
    });
    turning(axes, (random.direction(), random.signed(), at.map(|c| c + 0.1)))
}

/// Eight joints: a UR5 on a screw of pitch 0.05 on a slide.
pub fn gantry() -> Plan<8> {
    let slide = Axis { direction: X, through: [0.0; 3], limits: [-0.5, 0.7], pitch: None };
    let screw =
        Axis { direction: Z, through: [0.1, 0.2, 0.0], limits: [-2.0, 3.0], pitch: Some(0.05) };
    let [a, b, c, d, e, f] = ur5().axes;
    Plan { axes: [slide, screw, a, b, c, d, e, f], home: ur5().home }
}

impl Axis {
    /// The screw of the joint, and its limits.
    pub fn screw<R: Real>(&self) -> (Screw<R>, [R; 2]) {
        let (direction, through) = (rounded(self.direction), rounded(self.through));
        let axis = Line::from_point_direction(through, direction);
        let (angle, slide) =
            self.pitch.map_or((R::ZERO, R::ONE), |pitch| (R::ONE, R::from_f64(pitch)));
        (Screw { axis, angle, slide }, rounded(self.limits))
    }
}

/// An arm from screws, whose tool is to be somewhere.
#[derive(Clone, Debug)]
pub struct Arm<R, const N: usize>(pub OwnedReach<R>);

impl<R: Real, const N: usize> Arm<R, N> {
    pub fn new(
        screws: &[(Screw<R>, [R; 2]); N],
        tool: DualQuat<R>,
    ) -> Result<Self, MechanismError> {
        let mechanism = OwnedMechanism::from_screws(screws, tool)?;
        Ok(Self(OwnedReach::new(mechanism, [Goal::pose(N)]).expect("joints move the tool")))
    }

    /// A point, and how far from it the tool gets at most.
    pub fn bound(&self) -> ([R; 3], R) {
        self.0.view().reach_bound(0).expect("all slides have ends")
    }

    /// The pose of the tool.
    pub fn forward(&self, values: &[R; N]) -> DualQuat<R> {
        self.0.view().mechanism().link_pose(values, N).expect("a value for each joint")
    }
}

impl<R: Scalar, const N: usize> Arm<R, N> {
    /// A search for each target.
    pub fn reach_all(
        &self,
        backend: Backend,
        targets: &[DualQuat<R>],
        values: &mut [[R; N]],
        options: &Options<R>,
    ) -> Vec<Report<R>> {
        let mut reports = vec![Report::default(); targets.len()];
        let job = self.0.job().backend(backend);
        job.solve(targets, values.as_flattened_mut(), &mut reports, options).expect("lengths fit");
        reports
    }
}

impl<R: Scalar + Lanes<Real = R, Level = Portable, Mask = bool>, const N: usize> Arm<R, N> {
    /// One search.
    pub fn reach(
        &self,
        target: DualQuat<R>,
        values: &mut [R; N],
        options: &Options<R>,
    ) -> Report<R> {
        let reach = self.0.view();
        // What is in it must not matter.
        let mut scratch = vec![R::NAN; reach.scratch_len()];
        reach.solve(&[target], values, &mut scratch, options).expect("lengths fit")
    }
}

impl<const N: usize> Plan<N> {
    /// The arm from its screws.
    pub fn arm<R: Real>(&self) -> Arm<R, N> {
        let screws = self.axes.map(|axis| axis.screw());
        let (axis, angle, translation) = self.home;
        let turn = Quat::from_axis_angle(rounded(axis), R::from_f64(angle));
        Arm::new(&screws, DualQuat::from_rotation_translation(turn, rounded(translation)))
            .expect("the plan is an arm")
    }

    /// The same arm as joints, each in a frame on its axis; the end is the last link.
    pub fn links(&self) -> Vec<Joint<f64>> {
        let (mut links, mut last) = (Vec::new(), [0.0; 3]);
        let offset = |from: [f64; 3], to: [f64; 3]| {
            DualQuat::from_translation(core::array::from_fn(|i| to[i] - from[i]))
        };
        for Axis { direction: axis, through, limits, pitch } in self.axes {
            let kind = match pitch {
                None => JointKind::Prismatic { axis },
                Some(0.0) => JointKind::Revolute { axis },
                Some(pitch) => JointKind::Screw { axis, pitch },
            };
            let parent = links.len().checked_sub(1);
            let link = Joint::new(parent, offset(last, through), kind);
            links.push(link.with_limits(limits));
            last = through;
        }
        let (axis, angle, translation) = self.home;
        let turn = DualQuat::from_rotation(Quat::from_axis_angle(axis, angle));
        links.push(Joint::fixed(N.checked_sub(1), offset(last, translation) * turn));
        links
    }

    /// The pose of the end, by nalgebra.
    pub fn isometry(&self, values: &[f64; N]) -> Isometry3<f64> {
        let mut pose = Isometry3::identity();
        for (axis, &value) in self.axes.iter().zip(values) {
            let direction = Vector3::from(axis.direction);
            let at = Translation3::from(Vector3::from(axis.through));
            pose *= match axis.pitch {
                None => {
                    Isometry3::from_parts((direction * value).into(), UnitQuaternion::identity())
                }
                Some(pitch) => {
                    let turn = UnitQuaternion::from_scaled_axis(direction * value);
                    at * Isometry3::from_parts((direction * (pitch * value)).into(), turn)
                        * at.inverse()
                }
            };
        }
        let (axis, angle, translation) = self.home;
        let turn = UnitQuaternion::from_scaled_axis(Vector3::from(axis) * angle);
        pose * Isometry3::from_parts(Vector3::from(translation).into(), turn)
    }

    /// The same arm with other axes and other limits.
    pub fn with_axes(self, change: impl Fn(Axis) -> Axis) -> Self {
        Self { axes: self.axes.map(change), ..self }
    }

    /// Values within the limits.
    pub fn draw(&self, random: &mut Random) -> [f64; N] {
        self.axes.map(|axis| {
            let [low, high] = axis.limits;
            random.between(low, high)
        })
    }

    /// The turn and the distance between two sets of values.
    pub fn apart(&self, a: &[f64; N], b: &[f64; N]) -> [f64; 2] {
        let (a, b) = (self.isometry(a), self.isometry(b));
        let distance = (a.translation.vector - b.translation.vector).norm();
        [a.rotation.angle_to(&b.rotation), distance]
    }
}

pub fn exact<R: Into<f64>, const N: usize>(values: [R; N]) -> [f64; N] {
    values.map(Into::into)
}

pub fn rounded<R: Real, const N: usize>(values: [f64; N]) -> [R; N] {
    values.map(R::from_f64)
}

/// What tests run for long, compiled once for all of them, and optimised as this crate is. To name
/// it is enough.
#[must_use]
pub fn instances() -> [*const (); 8] {
    [
        ReachJob::<f32>::solve as *const (),
        ReachJob::<f64>::solve as *const (),
        Reach::<f32>::solve as *const (),
        Reach::<f64>::solve as *const (),
        SixAxisArm::<f32>::solutions as *const (),
        SixAxisArm::<f64>::solutions as *const (),
        SolutionsJob::<f32>::solutions as *const (),
        SolutionsJob::<f64>::solutions as *const (),
    ]
}

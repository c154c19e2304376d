//! Mechanisms: poses of links and Jacobians.

use crate::argument::{Of, Read, count, names, one_of, reads, writes};
use crate::element::zeroed;
use crate::function::Function;
use crate::shape::Shape;
use dq8::storage::Layout;
use dq8::{DualQuat, Real, ShapeError, Twist};
use dq8_capi::joint::{Joint as Described, JointKind as Kind};
use dq8_capi::mechanism::{Mechanism, Step};
use dq8_capi::{Status, links, mechanism};
use dq8_robot::{Body, JointKind, OwnedMechanism, World, WorldAligned};
use std::rc::Rc;

/// The joint in C. Numbers that its kind does not have are 0.
pub(super) fn described<R: Real>(joint: &dq8_robot::Joint<f64>) -> Described<R> {
    let of = R::from_f64;
    let none = [0.0; 3];
    let (kind, axis, pitch) = match joint.kind {
        JointKind::Fixed => (Kind::Fixed, none, 0.0),
        JointKind::Revolute { axis } => (Kind::Revolute, axis, 0.0),
        JointKind::Prismatic { axis } => (Kind::Prismatic, axis, 0.0),
        JointKind::Screw { axis, pitch } => (Kind::Screw, axis, pitch),
        JointKind::Planar { normal } => (Kind::Planar, normal, 0.0),
        JointKind::Floating => (Kind::Floating, none, 0.0),
        _ => unreachable!("there are no others here"),
    };
    Described {
        parent: joint.parent.map_or(-1, |parent| parent as i32),
        kind: kind as i32,
        placement: joint.placement.to_array().map(of),
        axis: axis.map(of),
        pitch: of(pitch),
        mimics: joint.mimic.is_some().into(),
        leader: joint.mimic.map_or(0, |mimic| mimic.joint as i32),
        multiplier: of(joint.mimic.map_or(0.0, |mimic| mimic.multiplier)),
        offset: of(joint.mimic.map_or(0.0, |mimic| mimic.offset)),
        limited: joint.limits.is_some().into(),
        limits: joint.limits.unwrap_or_default().map(of),
    }
}

/// A mechanism in C and in Rust.
pub(super) struct Scene<R> {
    pub(super) described: Vec<Described<R>>,
    steps: Vec<Line>,
    pub(super) made: Mechanism<R>,
    pub(super) rust: OwnedMechanism<R>,
}

/// Memory with the alignment of blocks.
#[derive(Clone)]
#[repr(align(64))]
struct Line(#[expect(dead_code, reason = "C has it")] [u8; 64]);

macro_rules! scenes {
    ($($R:ident $of:ident)*) => {$(
        impl Scene<$R> {
            pub(super) fn $of(shape: &Shape) -> Rc<Self> {
                let described: Vec<_> = shape.joints.iter().map(described::<$R>).collect();
                let joints = shape.joints.iter().map(|joint| joint.cast::<$R>());
                let rust = OwnedMechanism::new(&joints.collect::<Vec<_>>()).expect("a mechanism");
                let bytes = described.len() * size_of::<Step<$R>>();
                let (mut steps, mut made) = (vec![Line([0; 64]); bytes.div_ceil(64)], zeroed());
                // SAFETY: arrays are as long as is said.
                let status = unsafe {
                    let (from, room) = (described.as_ptr(), steps.as_mut_ptr().cast());
                    mechanism::$of::make(from, described.len(), room, &raw mut made, std::ptr::null_mut())
                };
                assert_eq!(status, Status::Ok);
                Rc::new(Self { described, steps, made, rust })
            }
        }
    )*};
}
scenes! { f32 single f64 double }

impl<R: Real + crate::element::Element> Scene<R>
where
    Mechanism<R>: crate::element::Element,
{
    pub(super) fn argument(self: &Rc<Self>) -> Of<Mechanism<R>, Read> {
        let scene = Rc::clone(self);
        let bytes = self.described.len() * size_of::<Step<R>>();
        let kept = (bytes > 0).then_some((self.steps.as_ptr().cast_mut().cast(), bytes));
        reads(1).keeps(kept.into_iter().collect()).only(move |_| scene.made).fault(
            Status::NoMechanism,
            None,
            |made| made[0] = zeroed(),
        )
    }
}

macro_rules! layout {
    ($shape:ident $list:ident $R:ident $of:ident $L:ty [$($lanes:literal)?]) => {{
        let scene = Scene::<$R>::$of($shape);
        let (each, joints) = (scene.made.values, scene.made.links);
        let configurations = if each == 0 { 0 } else { $shape.instances };
        let n = configurations.div_ceil(<$L as Layout>::THINGS) * joints;
        let [rust, jacobians] = [(); 2].map(|()| Rc::clone(&scene));
        // The first and the last link.
        let few = joints.min(2);
        let of_few = configurations.div_ceil(<$L as Layout>::THINGS) * few;
        let some = each * configurations;
        of_arrays! { $list $R $of [$($lanes)?]:
            links link_poses blocks_link_poses (
                mechanism: scene.argument(),
                values: reads::<$R>(some), value_count: count(some).wrong_if(each > 0, some + 16 * each, Status::LengthValues),
                poses: writes::<<$L as Layout>::Record<8>>(n),
                count: count(n).wrong_if(each > 0, n + 1, Status::Length).wrong_if(each > 0, n + joints, Status::LengthValues),
            ) => rust.rust.view().job().poses(values, poses);
            links link_jacobians blocks_link_jacobians (
                mechanism: scene.argument(),
                frame: one_of([0, 1, 2]).wrong(3, Status::UnknownValue).wrong(-1, Status::UnknownValue),
                values: reads::<$R>(some), value_count: count(some).wrong_if(each > 0, some + 16 * each, Status::LengthValues),
                links: reads::<usize>(few).only(move |at| (joints - 1) * at)
                    .fault(Status::NoLink, None, move |links| links[0] = joints),
                link_count: count(few), poses: writes::<<$L as Layout>::Record<8>>(of_few),
                columns: writes::<<$L as Layout>::Record<6>>(of_few * scene.made.rates),
                // Any count is a multiple of one link.
                count: count(of_few)
                    .wrong_if(each > 0, of_few + 1, if few == 1 { Status::LengthValues } else { Status::Length })
                    .wrong_if(each > 0, of_few + few, Status::LengthValues),
            ) => {
                let job = jacobians.rust.view().job();
                match frame {
                    0 => job.links(links).jacobians(World, values, poses, columns),
                    1 => job.links(links).jacobians(Body, values, poses, columns),
                    _ => job.links(links).jacobians(WorldAligned, values, poses, columns),
                }
            };
        }
    }};
}
mod layouts {
    use super::*;
    crate::table::for_all_layouts!(layout);
}

/// Takes all limits and mimics away, and lets joint `at` mimic `leader`.
fn mimic<R>(joints: &mut [Described<R>], at: usize, leader: i32) {
    joints.iter_mut().for_each(|joint| (joint.limited, joint.mimics) = (0, 0));
    (joints[at].mimics, joints[at].leader) = (1, leader);
}

/// The joints of a mechanism that are refused.
macro_rules! faults {
    ($scene:ident $R:ident: $joints:expr) => {{
        let last = $scene.described.len().saturating_sub(1);
        let joints = $joints
            .fault(Status::ParentNotBefore, Some(last), move |all| all[last].parent = last as i32)
            .fault(Status::ParentOutOfRange, Some(last), move |all| {
                all[last].parent = all.len() as i32
            })
            .fault(Status::ParentOutOfRange, Some(0), |all| all[0].parent = -2)
            .fault(Status::NotUnit, Some(last), move |all| all[last].placement[3] = 2.0)
            .fault(Status::NotFinite, Some(last), move |all| all[last].placement[4] = <$R>::NAN)
            .fault(Status::UnknownValue, Some(last), move |all| all[last].kind = 6)
            .fault(Status::UnknownValue, Some(last), move |all| all[last].limited = 2)
            .fault(Status::UnknownValue, Some(last), move |all| all[last].mimics = 2);
        let hinge = (1..=last).rev().find(|&at| matches!($scene.described[at].kind, 1..=3));
        match hinge {
            None => joints,
            Some(at) => [at as i32, -1, i32::MAX]
                .into_iter()
                .fold(joints, |joints, leader| {
                    joints.fault(Status::Mimic, Some(at), move |all| {
                        mimic(all, at, leader);
                    })
                })
                .fault(Status::Mimic, Some(at), move |all| {
                    mimic(all, at, 0);
                    all[0].kind = Kind::Fixed as i32;
                })
                .fault(Status::NotFinite, Some(at), move |all| {
                    mimic(all, at, 0);
                    (all[0].kind, all[0].axis) = (Kind::Revolute as i32, [0.0, 0.0, 1.0]);
                    all[at].multiplier = <$R>::INFINITY;
                })
                .fault(Status::Axis, Some(at), move |all| all[at].axis = [2.0, 0.0, 0.0])
                .fault(Status::Axis, Some(at), move |all| all[at].axis[2] = <$R>::NAN)
                .fault(Status::Limits, Some(at), move |all| {
                    mimic(all, 0, 0);
                    (all[0].mimics, all[at].limited, all[at].limits) = (0, 1, [1.0, -1.0]);
                }),
        }
    }};
}

/// A result for a link, or the error that there is no such link.
fn linked<T>(
    link: usize,
    links: usize,
    asked: impl FnOnce() -> Result<T, ShapeError>,
) -> Result<T, Status> {
    if link < links { Ok(asked()?) } else { Err(Status::NoLink) }
}

macro_rules! add {
    ($shape:ident $list:ident $R:ident $of:ident) => {{
        type Motion = DualQuat<$R>;
        let scene = Scene::<$R>::$of($shape);
        let Mechanism { links: joints, values, rates, .. } = scene.made;
        let [all, one, columns_of, made, volume, inverse] = [(); 6].map(|()| Rc::clone(&scene));
        let given = Rc::clone(&scene);
        let links = || one_of(0..joints.max(1)).wrong(joints.max(1), Status::NoLink).wrong(usize::MAX, Status::NoLink);
        let values_of = || count(values).wrong(values + 1, Status::LengthValues);
        let described = reads::<Described<$R>>(joints).only(move |at| given.described[at]);
        of_numbers! { $list $R $of:
            "mechanism_" mechanism make (
                joints: faults!(scene $R: described), count: count(joints),
                steps: writes::<Step<$R>>(joints).scratch(), mechanism: writes::<Mechanism<$R>>(1), bad_joint: names(),
            ) => {
                mechanism[0] = zeroed();
                let Mechanism { links, values, rates, .. } = &mut mechanism[0];
                (*links, *values, *rates) = (joints.len(), made.rust.view().values(), made.rust.view().rates());
            };
            "mechanism_" mechanism link_poses (
                mechanism: scene.argument(), values: reads::<$R>(values), value_count: values_of(),
                poses: writes::<Motion>(joints), count: count(joints).wrong(joints + 1, Status::Length),
            ) => all.rust.view().link_poses(values, poses);
            "mechanism_" mechanism link_pose (
                mechanism: scene.argument(), values: reads::<$R>(values), value_count: values_of(),
                link: links(), pose: writes::<Motion>(1),
            ) => pose[0] = linked(link, joints, || one.rust.view().link_pose(values, link))?;
            "mechanism_" mechanism link_jacobian (
                mechanism: scene.argument(),
                frame: one_of([0, 1, 2]).wrong(3, Status::UnknownValue).wrong(-1, Status::UnknownValue),
                values: reads::<$R>(values), value_count: values_of(), link: links(),
                columns: writes::<Twist<$R>>(rates), count: count(rates).wrong(rates + 1, Status::LengthColumns),
                pose: writes::<Motion>(1).unless_null(0),
            ) => {
                let known = columns_of.rust.view();
                let reached = linked(link, joints, || match frame {
                    0 => known.link_jacobian(World, values, link, columns),
                    1 => known.link_jacobian(Body, values, link, columns),
                    _ => known.link_jacobian(WorldAligned, values, link, columns),
                })?;
                pose.fill(reached);
            };
            "mechanism_" mechanism manipulability (
                mechanism: scene.argument(), values: reads::<$R>(values), value_count: values_of(), link: links(),
                columns: writes::<Twist<$R>>(rates).scratch(),
                column_count: count(rates).wrong(rates + 1, Status::LengthColumns),
                manipulability: writes::<$R>(1),
            ) => {
                let known = volume.rust.view();
                manipulability[0] = linked(link, joints, || known.manipulability(values, link, columns))?;
            };
            "mechanism_" mechanism rates_for (
                mechanism: scene.argument(),
                frame: one_of([0, 1, 2]).wrong(3, Status::UnknownValue).wrong(-1, Status::UnknownValue),
                values: reads::<$R>(values), value_count: values_of(), link: links(),
                twist: reads::<Twist<$R>>(1),
                damping: one_of([0.0, 0.25]).wrong(-0.1, Status::UnknownValue).wrong(<$R>::NAN, Status::UnknownValue),
                columns: writes::<Twist<$R>>(rates).scratch(), rates: writes::<$R>(rates),
                column_count: count(rates).wrong(rates + 1, Status::LengthColumns),
            ) => {
                let (known, twist) = (inverse.rust.view(), twist[0]);
                linked(link, joints, || match frame {
                    0 => known.rates_for(World, values, link, twist, damping, columns, rates),
                    1 => known.rates_for(Body, values, link, twist, damping, columns, rates),
                    _ => known.rates_for(WorldAligned, values, link, twist, damping, columns, rates),
                })?;
            };
        }
    }};
}

pub(super) fn add(shape: &Shape, to: &mut Vec<Function>) {
    layouts::add(shape, to);
    add!(shape to f32 single);
    add!(shape to f64 double);
}

//! Mechanisms: poses of links and Jacobians.

use crate::joint::joint as plain;
use crate::sample::{for_all_lanes, motions, same, vector, wave};
use dq8::storage::Block;
use dq8::{DualQuat, Real, Twist};
use dq8_capi::joint::{Joint as Described, JointKind as Kind};
use dq8_capi::mechanism::{Frame, Mechanism, Step};
use dq8_capi::{Status, links, mechanism};
use dq8_robot::{Body, Joint, JointKind, OwnedMechanism, World, WorldAligned};
use std::mem::MaybeUninit;
use std::ptr;

const LINKS: usize = 8;
const VALUES: usize = 14;
const RATES: usize = 13;
/// More configurations than lanes, and an odd number.
const CONFIGURATIONS: usize = 19;

fn unit<R: Real>(i: usize) -> [R; 3] {
    let [x, y, z] = vector::<R>(i, 7.0);
    let over = R::ONE / (x * x + y * y + z * z).sqrt();
    [x * over, y * over, z * over]
}

/// A joint of every kind and one that mimics, in branches.
fn joints<R: Real>() -> [Joint<R>; LINKS] {
    let placements = motions::<R>(8.0);
    let joint = |i: usize, parent, kind| Joint::new(parent, placements[i], kind);
    let pitch = R::from_f64(0.3);
    [
        joint(0, None, JointKind::Floating),
        joint(1, Some(0), JointKind::Revolute { axis: unit(1) }),
        joint(2, Some(1), JointKind::Prismatic { axis: unit(2) }),
        joint(3, Some(0), JointKind::Screw { axis: unit(3), pitch }),
        joint(4, Some(3), JointKind::Planar { normal: unit(4) }),
        joint(5, Some(2), JointKind::Fixed),
        joint(6, Some(4), JointKind::Revolute { axis: unit(6) }).mimicking(
            1,
            R::from_f64(-2.0),
            R::from_f64(0.1),
        ),
        joint(7, None, JointKind::Revolute { axis: unit(7) }),
    ]
}

/// The same as C has it; numbers that the kind does not name are 0.
fn described<R: Real>(joint: &Joint<R>) -> Described<R> {
    let none = [R::ZERO; 3];
    let (kind, axis, pitch) = match joint.kind {
        JointKind::Fixed => (Kind::Fixed, none, R::ZERO),
        JointKind::Revolute { axis } => (Kind::Revolute, axis, R::ZERO),
        JointKind::Prismatic { axis } => (Kind::Prismatic, axis, R::ZERO),
        JointKind::Screw { axis, pitch } => (Kind::Screw, axis, pitch),
        JointKind::Planar { normal } => (Kind::Planar, normal, R::ZERO),
        JointKind::Floating => (Kind::Floating, none, R::ZERO),
        _ => unreachable!("there are no others here"),
    };
    let parent = joint.parent.map_or(-1, |parent| parent as i32);
    let placement = joint.placement.to_array();
    let described = Described { placement, axis, pitch, ..plain(parent, kind) };
    let Some(mimic) = joint.mimic else { return described };
    let (multiplier, offset) = (mimic.multiplier, mimic.offset);
    Described { mimics: 1, leader: mimic.joint as i32, multiplier, offset, ..described }
}

macro_rules! agree {
    ($test:ident, $R:ident, $of:ident, $lanes:literal) => {
        mod $test {
            use super::*;

            type Motion = DualQuat<$R>;

            #[test]
            fn mechanisms() {
                use {links::$of as l, mechanism::$of as m};
                let joints = joints::<$R>();
                let wanted = OwnedMechanism::new(&joints).unwrap();
                let wanted = wanted.view();
                let described = joints.each_ref().map(described);
                // As C has it: not initialized.
                let mut steps = [const { MaybeUninit::<Step<$R>>::uninit() }; LINKS];
                let mut made = MaybeUninit::<Mechanism<$R>>::uninit();
                let values: Vec<$R> = (0..CONFIGURATIONS * VALUES).map(|i| wave(i, 0.2)).collect();
                let one = &values[..VALUES];
                let (pv, of) = (values.as_ptr(), made.as_mut_ptr());
                let (none, nowhere) = (ptr::null_mut(), ptr::null_mut());
                // SAFETY: arrays have the lengths that are said.
                unsafe {
                    let room = steps.as_mut_ptr().cast();
                    let status = m::make(described.as_ptr(), LINKS, room, of, nowhere);
                    assert_eq!(status, Status::Ok);
                    let shape = made.assume_init_ref();
                    assert_eq!((shape.links, shape.values, shape.rates), (LINKS, VALUES, RATES));
                    same! { |o|
                        &[Motion::ZERO; LINKS], m::link_poses(of, pv, VALUES, o, LINKS)
                            => wanted.link_poses(one, o).unwrap();
                    }
                    for link in 0..LINKS {
                        same! { |o|
                            &[Motion::ZERO], m::link_pose(of, pv, VALUES, link, o)
                                => o[0] = wanted.link_pose(one, link).unwrap();
                        }
                    }
                    let mut reached = Motion::ZERO;
                    let nothing = [Twist::from_array([9.0; 6]); RATES];
                    let mut jacobian = |frame: Frame, rust: &dyn Fn(&mut [Twist<$R>]) -> Motion| {
                        let pose = ptr::from_mut(&mut reached);
                        let mut other = Motion::ZERO;
                        same! { |o|
                            &nothing,
                                m::link_jacobian(of, frame as i32, pv, VALUES, 6, o, RATES, pose.cast())
                                => other = rust(o);
                        }
                        assert_eq!(reached, other);
                    };
                    jacobian(Frame::World, &|o| wanted.link_jacobian(World, one, 6, o).unwrap());
                    jacobian(Frame::Body, &|o| wanted.link_jacobian(Body, one, 6, o).unwrap());
                    jacobian(Frame::WorldAligned, &|o| {
                        wanted.link_jacobian(WorldAligned, one, 6, o).unwrap()
                    });
                    same! { |o|
                        &nothing, m::link_jacobian(of, 0, pv, VALUES, 6, o, RATES, none)
                            => _ = wanted.link_jacobian(World, one, 6, o).unwrap();
                    }

                    // A mechanism may be moved; its steps stay.
                    let moved = made.assume_init();
                    let (of, all) = (&raw const moved, values.len());
                    const ALL: usize = CONFIGURATIONS * LINKS;
                    same! { |o|
                        &[Motion::ZERO; ALL], l::link_poses(of, pv, all, o, ALL)
                            => wanted.job().poses(&values, o).unwrap();
                    }
                    // Whole blocks: a lane without a configuration has NaN where joints float.
                    const BLOCKS: usize = 16 / $lanes * LINKS;
                    let values = &values[..16 * VALUES];
                    same! { |o|
                        &[Block::<$R, $lanes>::splat([9.0; 8]); BLOCKS],
                            l::blocks_link_poses($lanes, of, pv, 16 * VALUES, o, BLOCKS)
                            => wanted.job().poses(values, o).unwrap();
                    }
                }
            }
        }
    };
}
for_all_lanes!(agree);

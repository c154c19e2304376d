//! What is wrong with a mechanism or a call of it: an error of its own, the joint named, nothing written.

#[path = "support/answers.rs"]
mod answers;
#[path = "support/joint.rs"]
mod joint;

use answers::answers;
use dq8_capi::Status;
use dq8_capi::joint::{Joint, JointKind};
use dq8_capi::links::single as l;
use dq8_capi::mechanism::{Mechanism, Step, single as m};
use joint::joint;
use std::mem::MaybeUninit;
use std::ptr;

const LINKS: usize = 3;

/// Where a mechanism may lie too, so that it is for the overlap that it is refused there.
#[repr(align(64))]
struct Aligned<T>(T);

/// A hinge, a slide on it, and a hinge that mimics the slide.
fn joints() -> [Joint<f32>; LINKS] {
    let [hinge, slide, last] = [
        joint(-1, JointKind::Revolute),
        joint(0, JointKind::Prismatic),
        joint(1, JointKind::Revolute),
    ];
    [hinge, slide, Joint { mimics: 1, leader: 1, multiplier: 2.0, ..last }]
}

fn room() -> [Step<f32>; LINKS] {
    // SAFETY: steps are numbers.
    unsafe { MaybeUninit::zeroed().assume_init() }
}

fn unmade() -> Mechanism<f32> {
    // SAFETY: a mechanism is numbers and pointers.
    unsafe { MaybeUninit::zeroed().assume_init() }
}

/// The status of making a mechanism, and the joint that it names.
fn make(joints: &[Joint<f32>; LINKS]) -> (Status, Option<usize>) {
    let (mut steps, mut made, mut bad) = (room(), unmade(), usize::MAX);
    // SAFETY: arrays have the length that is said.
    let status =
        unsafe { m::make(joints.as_ptr(), LINKS, steps.as_mut_ptr(), &mut made, &mut bad) };
    assert_eq!(made.links, if status == Status::Ok { LINKS } else { 0 }, "written: {status:?}");
    (status, (bad != usize::MAX).then_some(bad))
}

#[test]
fn a_joint_that_is_wrong_is_named() {
    let wrong = |change: fn(&mut [Joint<f32>; LINKS])| {
        let mut joints = joints();
        change(&mut joints);
        make(&joints)
    };
    assert_eq!(wrong(|_| ()), (Status::Ok, None));
    let named = |joint| Some(joint);
    answers([
        (wrong(|j| j[1].parent = 1), (Status::ParentNotBefore, named(1))),
        (wrong(|j| j[1].parent = 3), (Status::ParentOutOfRange, named(1))),
        (wrong(|j| j[0].parent = -2), (Status::ParentOutOfRange, named(0))),
        (wrong(|j| j[2].placement[3] = 2.0), (Status::NotUnit, named(2))),
        (wrong(|j| j[2].placement[4] = f32::NAN), (Status::NotFinite, named(2))),
        (wrong(|j| j[1].axis[2] = 2.0), (Status::Axis, named(1))),
        (wrong(|j| j[1].axis[2] = f32::NAN), (Status::Axis, named(1))),
        (wrong(|j| j[2].leader = 2), (Status::Mimic, named(2))),
        (wrong(|j| j[2].leader = -1), (Status::Mimic, named(2))),
        (wrong(|j| j[2].leader = i32::MAX), (Status::Mimic, named(2))),
        (wrong(|j| j[1].kind = JointKind::Planar as i32), (Status::Mimic, named(2))),
        (wrong(|j| j[2].multiplier = f32::INFINITY), (Status::NotFinite, named(2))),
        (wrong(|j| j[1].kind = 6), (Status::UnknownValue, named(1))),
        (wrong(|j| j[1].mimics = 2), (Status::UnknownValue, named(1))),
    ]);
}

#[test]
fn every_pointer_to_make_one_is_checked() {
    let (joints, mut steps, mut made) = (Aligned(joints()), Aligned(room()), unmade());
    let mut bad = 0;
    let (from, to, of) = (joints.0.as_ptr(), steps.0.as_mut_ptr(), &raw mut made);
    let named = &raw mut bad;
    let shifted = |pointer: *mut Step<f32>| pointer.wrapping_byte_add(2);
    let within = from.cast_mut();
    // SAFETY: what is dereferenced is as long as it is said to be; what is not, is refused.
    unsafe {
        answers([
            (m::make(ptr::null(), LINKS, to, of, named), Status::NullPointer),
            (m::make(from, LINKS, ptr::null_mut(), of, named), Status::NullPointer),
            (m::make(from, LINKS, to, ptr::null_mut(), named), Status::NullPointer),
            (m::make(from.wrapping_byte_add(2), LINKS, to, of, named), Status::Misaligned),
            (m::make(from, LINKS, shifted(to), of, named), Status::Misaligned),
            (m::make(from, LINKS, to, of.wrapping_byte_add(4), named), Status::Misaligned),
            (m::make(from, LINKS, to, of, named.wrapping_byte_add(4)), Status::Misaligned),
            (m::make(from, LINKS, within.cast(), of, named), Status::Overlap),
            (m::make(from, 1, to, within.cast(), named), Status::Overlap),
            (m::make(from, LINKS, to, to.cast(), named), Status::Overlap),
            (m::make(from, LINKS, to, of, within.cast()), Status::Overlap),
            (m::make(from, LINKS, to, of, to.cast()), Status::Overlap),
            (m::make(from, LINKS, to, of, of.cast()), Status::Overlap),
            (m::make(from, usize::MAX / 8, to, of, named), Status::TooLarge),
        ]);
    }
    assert_eq!((made.links, bad), (0, 0), "something was written");
}

/// As much as any argument of the calls below reads or writes.
const NUMBERS: usize = 64;

#[test]
fn every_pointer_to_use_one_is_checked() {
    let (joints, mut steps, mut made) = (joints(), Aligned(room()), unmade());
    let (to, of) = (steps.0.as_mut_ptr(), &raw mut made);
    // SAFETY: what is dereferenced is as long as it is said to be; what is not, is refused.
    unsafe {
        let values = [0.5_f32; NUMBERS];
        let mut out = [7.0_f32; NUMBERS];
        let mut pose = [7.0_f32; 8];
        let (v, o, p) = (values.as_ptr(), out.as_mut_ptr(), pose.as_mut_ptr());
        let (in_v, count) = (v.cast_mut(), LINKS);
        for got in [
            m::link_poses(of, v, 2, o, count),
            m::link_pose(of, v, 2, 0, o),
            m::link_jacobian(of, 0, v, 2, 0, o, 2, p),
            l::link_poses(of, v, 2, o, count),
        ] {
            assert_eq!(got, Status::NoMechanism);
        }
        let status = m::make(joints.as_ptr(), LINKS, to, of, ptr::null_mut());
        assert_eq!(status, Status::Ok);
        let (s, none) = (to.cast::<f32>(), ptr::null_mut::<f32>());
        let odd = ptr::null::<f32>().wrapping_byte_add(2).cast_mut();
        let lost = ptr::null();
        answers([
            (m::link_poses(lost, v, 2, o, count), Status::NullPointer),
            (m::link_poses(of.wrapping_byte_add(4), v, 2, o, count), Status::Misaligned),
            (m::link_poses(of, none, 2, o, count), Status::NullPointer),
            (m::link_poses(of, odd, 2, o, count), Status::Misaligned),
            (m::link_poses(of, v, 2, none, count), Status::NullPointer),
            (m::link_poses(of, v, 2, odd, count), Status::Misaligned),
            (m::link_poses(of, v, 2, in_v.add(1), count), Status::Overlap),
            (m::link_poses(of, v, 2, s.add(3), count), Status::Overlap),
            (m::link_poses(of, v, 2, of.cast(), count), Status::Overlap),
            (m::link_poses(of, v, 3, o, count), Status::Length),
            (m::link_poses(of, v, 2, o, 2), Status::Length),
            (m::link_poses(of, v, 2, o, usize::MAX / 16), Status::TooLarge),
            (m::link_pose(lost, v, 2, 0, o), Status::NullPointer),
            (m::link_pose(of, none, 2, 0, o), Status::NullPointer),
            (m::link_pose(of, v, 2, 0, none), Status::NullPointer),
            (m::link_pose(of, v, 2, 0, in_v.add(1)), Status::Overlap),
            (m::link_pose(of, v, 2, 0, s), Status::Overlap),
            (m::link_pose(of, v, 1, 0, o), Status::Length),
            (m::link_pose(of, v, 2, LINKS, o), Status::NoLink),
            (m::link_pose(of, v, 2, usize::MAX, o), Status::NoLink),
            (m::link_jacobian(lost, 0, v, 2, 0, o, 2, p), Status::NullPointer),
            (m::link_jacobian(of, 0, none, 2, 0, o, 2, p), Status::NullPointer),
            (m::link_jacobian(of, 0, v, 2, 0, none, 2, p), Status::NullPointer),
            (m::link_jacobian(of, 0, v, 2, 0, o, 2, odd), Status::Misaligned),
            (m::link_jacobian(of, 0, v, 2, 0, in_v.add(1), 2, p), Status::Overlap),
            (m::link_jacobian(of, 0, v, 2, 0, s, 2, p), Status::Overlap),
            (m::link_jacobian(of, 0, v, 2, 0, o, 2, in_v.add(1)), Status::Overlap),
            (m::link_jacobian(of, 0, v, 2, 0, o, 2, o.add(4)), Status::Overlap),
            (m::link_jacobian(of, 0, v, 2, 0, o, 2, s), Status::Overlap),
            (m::link_jacobian(of, 0, v, 1, 0, o, 2, p), Status::Length),
            (m::link_jacobian(of, 0, v, 2, 0, o, 3, p), Status::Length),
            (m::link_jacobian(of, 0, v, 2, LINKS, o, 2, p), Status::NoLink),
            (m::link_jacobian(of, 3, v, 2, 0, o, 2, p), Status::UnknownValue),
            (l::link_poses(lost, v, 4, o, 2 * count), Status::NullPointer),
            (l::link_poses(of, none, 4, o, 2 * count), Status::NullPointer),
            (l::link_poses(of, v, 4, odd, 2 * count), Status::Misaligned),
            (l::link_poses(of, v, 4, in_v.add(1), 2 * count), Status::Overlap),
            (l::link_poses(of, v, 4, s, 2 * count), Status::Overlap),
            (l::link_poses(of, v, 4, of.cast(), 2 * count), Status::Overlap),
            (l::link_poses(of, v, 5, o, 2 * count), Status::Length),
            (l::link_poses(of, v, 4, o, 2 * count - 1), Status::Length),
            (l::blocks_link_poses(4, of, v, 4, o, count), Status::Lanes),
        ]);
        assert_eq!((out, pose), ([7.0; NUMBERS], [7.0; 8]), "something was written");
        for got in [
            m::link_poses(of, v, 2, o, count),
            m::link_pose(of, v, 2, 2, o),
            m::link_jacobian(of, 2, v, 2, 2, o, 2, p),
            l::link_poses(of, v, 4, o, 2 * count),
        ] {
            assert_eq!(got, Status::Ok);
        }
    }
}

#[test]
fn a_mechanism_of_nothing_may_lie_nowhere() {
    let (mut made, nowhere) = (unmade(), ptr::null_mut::<f32>());
    let of = &raw mut made;
    // SAFETY: there is nothing to read or to write but the mechanism.
    unsafe {
        let status = m::make(ptr::null(), 0, ptr::null_mut(), of, ptr::null_mut());
        assert_eq!(status, Status::Ok);
        assert_eq!(m::link_poses(of, nowhere, 0, nowhere, 0), Status::Ok);
        assert_eq!(l::link_poses(of, nowhere, 0, nowhere, 0), Status::Ok);
    }
}

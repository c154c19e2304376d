//! Joints from URDF files.
#![cfg(feature = "urdf")]

use dq8_capi::Status;
use dq8_capi::joint::Joint;
use dq8_capi::urdf::{double, dq8_urdf_size, single};
use std::ffi::{CStr, c_char};
use std::ptr::null_mut;

const DOOR: &str = "<robot name='door'><link name='wall'/><link name='door'/><link name='handle'/>
    <joint name='hinge' type='revolute'><parent link='wall'/><child link='door'/>
    <axis xyz='0 0 1'/><limit lower='-0.5' upper='2' velocity='1' effort='1'/></joint>
    <joint name='latch' type='continuous'><parent link='door'/><child link='handle'/>
    <origin xyz='0.5 0 0'/><mimic joint='hinge' multiplier='-2' offset='0.25'/></joint></robot>";

fn size(text: &str, message: &mut [c_char]) -> (Status, usize, usize) {
    let (mut links, mut names) = (99, 99);
    let (to, room) = (message.as_mut_ptr(), message.len());
    // SAFETY: all arrays are as long as is said.
    let status = unsafe {
        dq8_urdf_size(text.as_ptr(), text.len(), &raw mut links, &raw mut names, to, room)
    };
    (status, links, names)
}

#[test]
fn joints_and_names_are_those_of_the_file() {
    assert_eq!(size(DOOR, &mut []), (Status::Ok, 3, "wall door handle hinge ".len()));
    macro_rules! check {
        ($($R:ident $of:ident)*) => {$({
            // SAFETY: numbers, which may be zero.
            let mut joints: [Joint<$R>; 3] = unsafe { std::mem::zeroed() };
            let mut names = [9; 23];
            let mut read = |links: usize, size: usize| {
                let (to, to_names) = (joints.as_mut_ptr(), names.as_mut_ptr());
                // SAFETY: all arrays are as long as is said, or refused.
                unsafe {
                    $of::joints(DOOR.as_ptr(), DOOR.len(), to, links, to_names, size, null_mut(), 0)
                }
            };
            assert_eq!(read(2, 23), Status::LengthJoints);
            assert_eq!(read(3, 22), Status::LengthNames);
            assert_eq!(read(3, 23), Status::Ok);
            assert_eq!(names.map(|byte| byte as u8), *b"wall\0door\0handle\0hinge\0");
            let [root, hinge, latch] = &joints;
            assert_eq!((root.parent, root.kind, hinge.parent, hinge.kind), (-1, 0, 0, 1));
            assert_eq!((hinge.axis, hinge.limited, hinge.limits), ([0.0, 0.0, 1.0], 1, [-0.5, 2.0]));
            assert_eq!((latch.mimics, latch.leader, latch.multiplier), (1, 1, -2.0));
            assert_eq!((latch.offset, latch.placement[4]), (0.25, 0.25));
        })*};
    }
    check! { f32 single f64 double }
}

#[test]
fn a_wrong_file_is_refused_with_a_message() {
    let wrong = DOOR.replace("child link='door'", "child link='window'");
    let mut message = [9; 200];
    assert_eq!(size(&wrong, &mut message), (Status::Urdf, 99, 99));
    // SAFETY: the message ends with a zero.
    let said = unsafe { CStr::from_ptr(message.as_ptr()) }.to_str().expect("text");
    assert!(said.contains("line 2") && said.contains("window"), "{said}");
    let mut short = [9; 8];
    assert_eq!(size(&wrong, &mut short).0, Status::Urdf);
    // SAFETY: as above.
    assert_eq!(unsafe { CStr::from_ptr(short.as_ptr()) }.to_str(), Ok(&said[..7]));
    assert_eq!(size(&wrong, &mut []).0, Status::Urdf);
}

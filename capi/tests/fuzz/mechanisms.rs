//! Mechanisms, and searches for their values.

use crate::random::{Fuzz, blocks_of};
use dq8_capi::Status;
use dq8_capi::joint::Joint;
use dq8_capi::links::single as k;
use dq8_capi::mechanism::{Mechanism, Step, single as c};
use dq8_capi::reach::{Goal, ReachOptions, ReachReport, single as r};
use dq8_capi::targets::single as t;
use std::mem::MaybeUninit;
use std::ptr;

/// Mechanisms of joints any of which may be wrong, with values that may be anything.
pub(crate) fn mechanisms(fuzz: &mut Fuzz) {
    let count = fuzz.below(12);
    let joints: Box<[Joint<f32>]> = (0..count)
        .map(|index| {
            let mut placement = [0.0, 0.0, 0.0, 1.0, fuzz.number(), fuzz.number(), 0.5, 0.0];
            let mut axis = [0.0; 3];
            axis[fuzz.below(3)] = 1.0;
            let wrong = fuzz.below(100);
            if wrong == 0 {
                placement[fuzz.below(8)] = fuzz.number();
            }
            if wrong == 1 {
                axis[fuzz.below(3)] = fuzz.number();
            }
            let parent = fuzz.below(index + 1) as i32 - 1;
            Joint {
                parent: if wrong == 2 { fuzz.bits() as i32 } else { parent },
                kind: if wrong == 3 { fuzz.bits() as i32 } else { fuzz.below(6) as i32 },
                placement,
                axis,
                pitch: 0.1,
                mimics: i32::from(fuzz.below(20) == 0),
                leader: fuzz.below(count) as i32 - i32::from(wrong == 4),
                multiplier: 2.0,
                offset: 0.1,
                limited: 0,
                limits: [0.0; 2],
            }
        })
        .collect();
    let mut steps = Box::<[Step<f32>]>::new_uninit_slice(count);
    let mut made = MaybeUninit::<Mechanism<f32>>::zeroed();
    let (room, of, mut bad) = (steps.as_mut_ptr().cast(), made.as_mut_ptr(), usize::MAX);
    // SAFETY: every array has the length that its function says.
    unsafe {
        let status = c::make(joints.as_ptr(), count, room, of, &mut bad);
        if status != Status::Ok {
            assert!(bad < count, "{status:?}");
            assert_eq!(made.assume_init_ref().links, 0);
            return;
        }
        let (values, rates) = (made.assume_init_ref().values, made.assume_init_ref().rates);
        let numbers = fuzz.numbers(values);
        let (mut poses, mut one) = (fuzz.numbers(8 * count), fuzz.numbers(8));
        let mut columns = fuzz.numbers(6 * rates);
        let (n, to, pose) = (numbers.as_ptr(), poses.as_mut_ptr(), one.as_mut_ptr());
        assert_eq!(c::link_poses(of, n, values, to, count), Status::Ok);
        assert!(count == 0 || c::link_poses(of, n, values, to, count - 1) == Status::Length);
        let (link, frame, columns) = (fuzz.below(14), fuzz.below(4) as i32, columns.as_mut_ptr());
        let there = if link < count { Status::Ok } else { Status::NoLink };
        assert_eq!(c::link_pose(of, n, values, link, pose), there);
        let wanted = if link < count && frame == 3 { Status::UnknownValue } else { there };
        let status = c::link_jacobian(of, frame, n, values, link, columns, rates, pose);
        assert_eq!(status, wanted);
        searches(fuzz, of, values, count);
        let configurations = fuzz.below(20);
        if values > 0 {
            let many = fuzz.numbers(configurations * values);
            let mut poses = fuzz.numbers(8 * count * configurations);
            let (from, to, all) = (many.as_ptr(), poses.as_mut_ptr(), count * configurations);
            assert_eq!(k::link_poses(of, from, many.len(), to, all), Status::Ok);
            let mut blocks = fuzz.blocks::<8, 8>(blocks_of(8, configurations) * count);
            let (to, all) = (blocks.as_mut_ptr().cast(), blocks.len());
            assert_eq!(k::blocks_link_poses(8, of, from, many.len(), to, all), Status::Ok);
        }
    }
}

/// A short search for goals any of which may be wrong.
///
/// # Safety
/// The mechanism has been made, and has so many values and links.
unsafe fn searches(fuzz: &mut Fuzz, of: *const Mechanism<f32>, values: usize, links: usize) {
    let weight = |fuzz: &mut Fuzz| if fuzz.below(60) == 0 { fuzz.number() } else { 1.0 };
    let reached = links + usize::from(fuzz.below(10) == 0);
    let goals: Box<[Goal<f32>]> = (0..fuzz.below(3))
        .map(|_| Goal {
            link: fuzz.below(reached),
            angular: [(); 3].map(|()| weight(fuzz)),
            linear: [(); 3].map(|()| weight(fuzz)),
            point: [(); 3].map(|()| weight(fuzz)),
        })
        .collect();
    let mut targets = fuzz.numbers(8 * goals.len());
    if fuzz.below(4) > 0 {
        for target in targets.chunks_exact_mut(8) {
            target[..4].copy_from_slice(&[0.0, 0.6, 0.0, 0.8]);
            target[4..].copy_from_slice(&[0.3, 0.0, 0.1, 0.0]);
        }
    }
    let mut options = MaybeUninit::<ReachOptions<f32>>::zeroed();
    let mut report = MaybeUninit::<ReachReport<f32>>::zeroed();
    let (wanted, mut needed) = (targets.as_ptr(), 0);
    let mut at = fuzz.numbers(values);
    let before: Vec<u32> = at.iter().map(|value| value.to_bits()).collect();
    let (to, posture) = (at.as_mut_ptr(), fuzz.numbers(values));
    let posture = if fuzz.below(2) == 0 { ptr::null() } else { posture.as_ptr() };
    // SAFETY: arrays are as long as is said, and so is the memory that was asked for.
    let status = unsafe {
        assert_eq!(r::reach_options(options.as_mut_ptr()), Status::Ok);
        let options = options.assume_init_mut();
        options.max_iterations = fuzz.below(6) as u32;
        options.restarts = fuzz.below(2) as u32;
        assert_eq!(r::reach_scratch(of, goals.len(), &raw mut needed), Status::Ok);
        let mut scratch = fuzz.numbers(needed);
        let room = scratch.as_mut_ptr();
        let (options, report) = (ptr::from_ref(options), report.as_mut_ptr());
        let search = |room_for| {
            let (goal, goals) = (goals.as_ptr(), goals.len());
            r::reach(of, goal, wanted, goals, posture, options, to, values, room, room_for, report)
        };
        assert!(search(needed / 2) != Status::Ok, "half of the memory");
        let status = search(needed);
        // The same for many, which are refused for the same reasons.
        let (goal, goals) = (goals.as_ptr(), goals.len());
        assert_eq!(t::scratch(of, goals, &raw mut needed), Status::Ok);
        let many = fuzz.below(20);
        let wanted: Vec<_> = (0..many).flat_map(|_| targets.iter().copied()).collect();
        let (mut from, mut scratch) = (fuzz.numbers(values * many), fuzz.numbers(needed));
        let mut reports = vec![*report; many];
        let (wanted, from, n) = (wanted.as_ptr(), from.as_mut_ptr(), values * many);
        let (room, reports) = (scratch.as_mut_ptr(), reports.as_mut_ptr());
        let search = |n, m| {
            t::reach(of, goal, goals, wanted, posture, options, from, n, room, needed, reports, m)
        };
        assert!(search(n + 1, many) != Status::Ok, "another number of values");
        let of_many = search(n, many);
        assert!(many == 0 || of_many == status, "{status:?} of one, {of_many:?} of {many}");
        status
    };
    let refused =
        [Status::NoLink, Status::Unmoved, Status::Weight, Status::NotFinite, Status::NullPointer];
    assert!(status == Status::Ok || refused.contains(&status), "{status:?}");
    assert!(status == Status::Ok || at.iter().map(|value| value.to_bits()).eq(before));
}

//! Arguments that do not fit are refused with the index and the values, and nothing is written.

use crate::subject::{Run, Task, for_every_subject};
use core::error::Error;
use core::ops::Range;
use dq8::{Hierarchy, ShapeError, hierarchy::HierarchyError};
use proptest::prelude::*;

const ROOT: u32 = Hierarchy::ROOT;

/// A root and two joints.
const ARM: [u32; 3] = [ROOT, 0, 1];

/// An error is one of `core::error::Error`, and its text says every one of `numbers`.
pub(crate) fn names(error: &dyn Error, numbers: &[usize]) {
    let text = error.to_string();
    let words: Vec<usize> =
        text.split(|c: char| !c.is_ascii_digit()).filter_map(|word| word.parse().ok()).collect();
    for number in numbers {
        assert!(words.contains(number), "no {number} in \"{text}\"");
    }
}

/// A parent array that long does not fit a test; its error can still be read.
#[test]
fn too_many_joints_are_counted() {
    names(&HierarchyError::TooManyJoints { joints: usize::MAX }, &[usize::MAX]);
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    /// The rule of `Hierarchy::new` once more: a parent is ROOT, or smaller than its child. One
    /// below the mark of a root must not be taken for one.
    #[test]
    fn the_first_joint_whose_parent_does_not_come_before_it_is_named(
        parents in prop::collection::vec(
            prop_oneof![8 => 0..12_u32, 2 => Just(ROOT), 1 => Just(ROOT - 1)], 0..12),
    ) {
        let joints = parents.len();
        let mut numbered = parents.iter().enumerate();
        let bad = numbered.find(|&(joint, &parent)| parent != ROOT && parent as usize >= joint);
        let wanted = bad.map_or(Ok(&parents[..]), |(joint, &parent)| {
            Err(if (parent as usize) < joints {
                HierarchyError::ParentNotBefore { joint, parent }
            } else {
                HierarchyError::ParentOutOfRange { joint, parent: parent.into(), joints }
            })
        });
        prop_assert_eq!(Hierarchy::new(&parents).map(|skeleton| skeleton.parents()), wanted);
        if let (Err(error), Some((joint, &parent))) = (wanted, bad) {
            names(&error, &[joint]);
            // A joint that is its own parent is one number.
            names(&error, &[parent as usize]);
            if let HierarchyError::ParentOutOfRange { joints, .. } = error {
                names(&error, &[joints]);
            }
        }
    }
}

/// The four runs of a job, each with slices of the given lengths; in place only the second counts.
/// Every one must give `wanted` of its slices' names and leave what it would write as it was.
fn all_refuse(
    parents: &[u32],
    joints: Range<usize>,
    roots: Option<usize>,
    [input, output]: [usize; 2],
    numbers: &[usize],
    wanted: impl Fn(&'static str, &'static str) -> ShapeError,
) {
    for_every_subject(|subject, backend| {
        let task = Task { joints: joints.clone(), ..Task::new(parents, backend) };
        let check = |run: Run, wanted: ShapeError| {
            let error = subject.run(&task, run, [input, output], roots).unwrap_err();
            assert_eq!(error, wanted);
            names(&error, numbers);
        };
        check(Run::LocalToModel, wanted("locals", "models"));
        check(Run::ModelToLocal, wanted("models", "locals"));
        if input == output {
            check(Run::LocalToModelInPlace, wanted("poses", "poses"));
            check(Run::ModelToLocalInPlace, wanted("poses", "poses"));
        }
    });
}

#[test]
fn slices_that_hold_no_whole_instances_are_refused() {
    for length in [1, 2, 4, 5, 7] {
        all_refuse(&ARM, 0..3, None, [length; 2], &[length, 3], |what, _| ShapeError::NotWhole {
            what,
            length,
            joints: 3,
        });
    }
}

#[test]
fn slices_of_different_lengths_are_refused() {
    for (expected, length) in [(3, 6), (6, 3), (3, 0), (0, 3), (3, 2), (6, 7)] {
        all_refuse(&ARM, 0..3, None, [expected, length], &[length, expected], |_, what| {
            ShapeError::Length { what, length, expected }
        });
    }
}

#[test]
fn poses_for_no_joints_are_refused() {
    all_refuse(&[], 0..0, None, [2, 2], &[2, 0], |what, _| ShapeError::NotWhole {
        what,
        length: 2,
        joints: 0,
    });
}

#[test]
fn a_range_that_ends_before_it_starts_or_beyond_the_joints_is_refused() {
    for (start, end) in [(2, 1), (3, 0), (0, 4), (4, 4), (5, 4), (1, usize::MAX)] {
        let range = Range { start, end };
        let wanted = ShapeError::Joints { range: range.clone(), joints: 3 };
        for length in [0, 3, 6] {
            all_refuse(&ARM, range.clone(), None, [length; 2], &[start, end, 3], |_, _| {
                wanted.clone()
            });
        }
    }
}

#[test]
fn any_number_of_roots_but_one_an_instance_is_refused() {
    for (instances, length) in [(0, 1), (1, 0), (1, 2), (2, 1), (2, 3), (2, 6)] {
        let numbers = [length, instances];
        all_refuse(&ARM, 0..3, Some(length), [3 * instances; 2], &numbers, |_, _| {
            ShapeError::Length { what: "roots", length, expected: instances }
        });
    }
}

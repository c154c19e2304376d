//! Errors read as sentences: a number agrees with its noun, and what is named is what is wrong.

use dq8::hierarchy::HierarchyError;
use dq8::skinning::{Skin, SkinningError};
use dq8::{Backend, Crowd, Dual, DualQuat, Hierarchy, Quat, ShapeError, Skeleton};

fn says<T: core::fmt::Debug, E: core::error::Error>(result: Result<T, E>, text: &str) {
    assert_eq!(result.unwrap_err().to_string(), text);
}

#[test]
fn the_norm_of_an_error_is_that_of_what_has_it() {
    says(Quat::<f64>::ZERO.try_normalize(), "cannot normalize: the norm of the quaternion is 0");
    let endless = Quat::from_xyzw(f64::INFINITY, 0.0, 0.0, 1.0);
    says(endless.try_normalize(), "cannot normalize: the norm of the quaternion is inf");
    let zero = DualQuat::<f32>::ZERO;
    says(zero.try_normalize(), "cannot normalize: the norm of the real part is 0");
    says(zero.try_inverse(), "no inverse: the norm of the real part is 0");
    says(Dual::new(0.0, 2.0).inverse(), "no inverse: the absolute value of the real part is 0");
    let nowhere = DualQuat::new(Quat::IDENTITY, Quat::from_xyzw(0.0, f64::NAN, 0.0, 0.0));
    let dual = "the norm of the real part is 1, but a component is not finite, or would not be";
    says(nowhere.try_normalize(), &format!("cannot normalize: {dual}"));
    says(nowhere.try_inverse(), &format!("no inverse: {dual}"));
}

#[test]
fn one_is_singular_and_all_other_numbers_are_plural() {
    let length = |length, expected| -> Result<(), _> {
        Err(ShapeError::Length { what: "means", length, expected })
    };
    says(length(0, 1), "means holds 0 elements where 1 is needed");
    says(length(1, 2), "means holds 1 element where 2 are needed");
    says(length(2, 0), "means holds 2 elements where 0 are needed");

    let two = [DualQuat::<f32>::IDENTITY; 2];
    let hierarchy = Hierarchy::new(&[Hierarchy::ROOT, 0, 1]).unwrap();
    let whole = hierarchy.job().local_to_model(&two[..1], &mut [two[0]; 1]);
    says(whole, "locals holds 1 element, which is not a multiple of the 3 joints");
    says(
        Crowd::<f32, 4>::from_slice(0, &two),
        "things holds 2 elements, which is not a multiple of the 0 joints",
    );
    let mut crowd = Crowd::<f32, 4>::new(1, 1);
    says(
        crowd.set(1, 0, two[0]),
        "there is no joint 0 of instance 1: the crowd has 1 instance of 1 joint",
    );
    says(
        Skeleton::new(&[-1_i32, 7]),
        "joint 1 has parent 7, which is none of 2 joints, counted from 0 (the parent of a root is −1)",
    );
    let one = Skeleton::new(&[-1_i32]).unwrap();
    says(one.clone().with_names(["hip", "knee"]), "2 names for 1 joint: each needs one");
    let none: Result<(), _> = Err(HierarchyError::NoJoint { joint: 1, joints: 1 });
    says(none, "there is no joint 1 among 1 joint, counted from 0");
    says(
        Skin::new(1, 1, &[3_u16], &[1.0_f32]),
        "vertex 0: influence 0 is joint 3, but there is only 1 joint",
    );
    let field: Result<(), _> =
        Err(SkinningError::InfluenceField { what: "weights", first: 4, stride: 1, influences: 1 });
    says(field, "weights: 1 element at 4 does not fit into a vertex of 1 element");
    says("1".parse::<Quat<f32>>(), "the list has 1 number where 4 are needed");
}

#[test]
fn poses_that_hold_no_window_say_so() {
    let (poses, mut means) = ([DualQuat::<f32>::IDENTITY; 5], [DualQuat::IDENTITY; 1]);
    let mut windows =
        |poses: &[_]| Backend::PORTABLE.dib_windows(poses, &[1.0; 7], 1e-6, 8, &mut means);
    says(windows(&poses), "a window of 7 does not fit into 5 poses");
    says(windows(&poses[..1]), "a window of 7 does not fit into 1 pose");
    says(windows(&[poses[0]; 9]), "means holds 1 element where 3 are needed");
    assert_eq!(Backend::PORTABLE.dib_windows(&poses, &[1.0; 7], 1e-6, 8, &mut []), Ok(0));
}

#[test]
fn the_backends_of_a_cpu_stand_between_commas() {
    let names: Vec<_> = Backend::available().map(|backend| backend.to_string()).collect();
    let text = format!("no such backend here; this CPU has {}", names.join(", "));
    says("AVX3".parse::<Backend>(), &text);
}

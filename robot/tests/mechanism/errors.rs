//! What makes no mechanism, and calls that do not fit one.

use dq8::{Backend, DualQuat, Quat, ShapeError, Twist};
use dq8_arms::Z;
use dq8_robot::{Joint, Mechanism, MechanismError, OwnedMechanism, Step, World};

fn hinge(parent: Option<usize>) -> Joint<f64> {
    Joint::revolute(parent, DualQuat::IDENTITY, Z)
}

fn error(joints: &[Joint<f64>]) -> MechanismError {
    OwnedMechanism::new(joints).unwrap_err()
}

#[test]
fn parents_come_before_their_joints() {
    let parent = |joint, parent| MechanismError::Parent { joint, parent };
    assert_eq!(error(&[hinge(Some(0))]), parent(0, 0));
    assert_eq!(error(&[hinge(None), hinge(Some(2)), hinge(Some(1))]), parent(1, 2));
    assert_eq!(error(&[hinge(None), hinge(Some(usize::MAX))]), parent(1, usize::MAX));
}

#[test]
fn axes_and_placements_are_unit_and_finite() {
    let bent = Joint::revolute(None, DualQuat::IDENTITY, [0.0, 3.0, 4.0]);
    assert_eq!(error(&[hinge(None), bent]), MechanismError::Axis { joint: 1, length: 5.0 });
    for length in [0.0, 0.5] {
        let short = Joint::revolute(None, DualQuat::IDENTITY, [0.0, length, 0.0]);
        assert_eq!(error(&[short]), MechanismError::Axis { joint: 0, length });
    }
    let nan = Joint::prismatic(None, DualQuat::IDENTITY, [f64::NAN, 0.0, 0.0]);
    assert!(matches!(error(&[nan]), MechanismError::Axis { joint: 0, length } if length.is_nan()));
    let large = Joint::fixed(None, DualQuat::IDENTITY.scale(1.5));
    assert_eq!(error(&[large]), MechanismError::Placement { joint: 0, norm: 1.5 });
    for along in [5.0, -5.0] {
        let skewed = DualQuat::from_array([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, along]);
        let error_of = error(&[Joint::fixed(None, skewed)]);
        assert_eq!(error_of, MechanismError::DualPart { joint: 0, along });
    }
    // Rounding beside nothing is as good as rounding beside a metre.
    let rounded = DualQuat::from_array([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1e-12]);
    assert!(OwnedMechanism::new(&[Joint::fixed(None, rounded)]).is_ok());
    let far = Joint::fixed(None, DualQuat::from_translation([0.0, f64::INFINITY, 0.0]));
    assert!(matches!(
        error(&[far]),
        MechanismError::NotFinite { joint: 0, what: "translation", .. }
    ));
    let thread = Joint::screw(None, DualQuat::IDENTITY, Z, f64::NAN);
    assert!(matches!(error(&[thread]), MechanismError::NotFinite { joint: 0, what: "pitch", .. }));
}

#[test]
fn what_is_typed_with_four_decimals_is_made_unit() {
    let turn = Quat::from_array([0.1826, 0.3651, 0.5477, 0.7303]);
    let placement = DualQuat::from_rotation_translation(turn, [0.3, 0.2, 0.1]);
    let hinge = Joint::revolute(None, placement, [0.6001, 0.7999, 0.0]);
    let owned = OwnedMechanism::new(&[hinge]).unwrap();
    let [there, turned] = [0.0, 2.0].map(|angle| owned.view().link_pose(&[angle], 0).unwrap());
    assert!(!placement.is_normalized() && turned.is_normalized());
    assert!(there.abs_diff_eq(placement.normalize(), 1e-15), "{there}");
}

#[test]
fn limits_are_in_order_and_of_one_value() {
    let limits = |joint, low, high| MechanismError::Limits { joint, low, high };
    assert_eq!(error(&[hinge(None).with_limits([1.0, 0.0])]), limits(0, 1.0, 0.0));
    let fixed = Joint::fixed(None, DualQuat::IDENTITY).with_limits([0.0, 1.0]);
    assert_eq!(error(&[fixed]), limits(0, 0.0, 1.0));
    let owned = OwnedMechanism::new(&[hinge(None).with_limits([-1.0, 1.0]), hinge(None)]).unwrap();
    assert_eq!((owned.view().limits(0), owned.view().limits(1)), (Some([-1.0, 1.0]), None));
}

#[test]
fn mimics_follow_a_joint_of_one_value_of_its_own() {
    let mimic = |joint, other| MechanismError::Mimic { joint, other };
    let two = |second: Joint<f64>| [hinge(None), second];
    assert_eq!(error(&two(hinge(None).mimicking(1, 1.0, 0.0))), mimic(1, 1));
    assert_eq!(error(&two(hinge(None).mimicking(7, 1.0, 0.0))), mimic(1, 7));
    let chain =
        [hinge(None), hinge(None).mimicking(0, 1.0, 0.0), hinge(None).mimicking(1, 1.0, 0.0)];
    assert_eq!(error(&chain), mimic(2, 1));
    let fixed = Joint::fixed(None, DualQuat::IDENTITY);
    assert_eq!(error(&two(fixed.mimicking(0, 1.0, 0.0))), mimic(1, 0));
    assert_eq!(error(&[fixed, hinge(None).mimicking(0, 1.0, 0.0)]), mimic(1, 0));
    let nan = hinge(None).mimicking(0, f64::NAN, 0.0);
    assert!(matches!(
        error(&two(nan)),
        MechanismError::NotFinite { joint: 1, what: "multiplier", .. }
    ));
}

#[test]
fn steps_are_as_many_as_joints() {
    let error = Mechanism::new(&[hinge(None); 3], &mut [Step::default(); 2]).unwrap_err();
    assert_eq!(error, MechanismError::Steps { steps: 2, joints: 3 });
    let mut more = [Step::default(); 9];
    assert_eq!(Mechanism::new(&[hinge(None); 3], &mut more).unwrap().links(), 3);
}

#[test]
fn slices_that_do_not_fit_are_left_as_they_were() {
    let owned = OwnedMechanism::new(&[hinge(None), hinge(Some(0))]).unwrap();
    let (robot, backend) = (owned.view(), Backend::best());
    let before = DualQuat::from_translation([1.0, 2.0, 3.0]);
    let mut poses = [before; 4];
    let length = |what, length, expected| Err(ShapeError::Length { what, length, expected });
    assert_eq!(robot.link_poses(&[0.0; 3], &mut poses[..2]), length("values", 3, 2));
    assert_eq!(robot.link_poses(&[0.0; 2], &mut poses), length("poses", 4, 2));
    assert_eq!(robot.job().backend(backend).poses(&[0.0; 2], &mut poses), length("values", 2, 4));
    let (column, short) = (&[0.0; 2][..], &[0.0; 1][..]);
    let of_columns =
        |columns: &[&[f64]], poses: &mut [DualQuat<f64>]| robot.job().poses(columns, poses);
    assert_eq!(of_columns(&[column], &mut poses), length("values", 1, 2));
    assert_eq!(of_columns(&[column, short], &mut poses), length("values", 1, 2));
    assert_eq!(of_columns(&[short, short], &mut poses), length("values", 1, 2));
    let whole = Err(ShapeError::NotWhole { what: "poses", length: 3, joints: 2 });
    assert_eq!(robot.job().backend(backend).poses(&[0.0; 4], &mut poses[..3]), whole);
    let no_link = ShapeError::NoLink { link: 2, links: 2 };
    let chosen = robot.job().links(&[2]).backend(backend).poses(&[0.0; 4], &mut poses[..2]);
    assert_eq!(chosen, Err(no_link.clone()));
    assert_eq!(no_link.to_string(), "there is no link 2: the mechanism has 2, counted from 0");
    let mut columns = [Twist::from_array([0.0; 6]); 2];
    let refused = robot.link_jacobian(World, &[0.0; 2], 2, &mut columns);
    assert_eq!(refused, Err(no_link));
    assert_eq!(poses, [before; 4]);
}

#[test]
fn points_on_links_that_there_are_not_are_refused_and_nothing_is_written() {
    let hinge = Joint::revolute(None, DualQuat::IDENTITY, [0.0, 0.0, 1.0]);
    let robot = OwnedMechanism::new(&[hinge, hinge]).unwrap();
    let (robot, mut places) = (robot.view(), [[5.0_f64; 3]; 2]);
    let (none, origin) = (ShapeError::NoLink { link: 2, links: 2 }, [0.0; 3]);
    let beyond = [(0, origin), (2, origin)];
    assert_eq!(robot.link_points(&[0.0; 2], &beyond, &mut places), Err(none.clone()));
    assert_eq!(robot.job().points(&beyond, &[0.0; 2], &mut places), Err(none));
    let points = [(0, origin), (1, origin)];
    assert!(robot.link_points(&[0.0; 3], &points, &mut places).is_err());
    assert!(robot.link_points(&[0.0; 2], &points, &mut places[..1]).is_err());
    assert!(robot.job().points(&points, &[0.0; 3], &mut places).is_err());
    assert!(robot.job().points(&points, &[0.0; 2], &mut places[..1]).is_err());
    assert_eq!(places, [[5.0; 3]; 2]);
}

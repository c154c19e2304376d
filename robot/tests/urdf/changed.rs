//! Robots on other bases and with tools: names, limits and poses are those of the file, and what
//! was added.

use dq8::{DualQuat, Quat};
use dq8_robot::urdf::{ChangeError, Robot};
use dq8_robot::{Joint, MechanismError};

fn arm() -> Robot {
    Robot::from_urdf(include_str!("../../robots/arm6.urdf")).unwrap()
}

fn pose() -> DualQuat<f64> {
    let turn = Quat::from_axis_angle([0.0, 0.6, 0.8], 0.7);
    DualQuat::from_rotation_translation(turn, [0.3, -0.2, 0.5])
}

const VALUES: [f64; 6] = [0.3, -0.4, 0.9, 0.2, 0.5, -0.1];

#[test]
fn a_floating_robot_is_the_same_robot_elsewhere() {
    let (fixed, floating) = (arm(), arm().floating().unwrap());
    let base = pose();
    let values = [&base.rotation().to_array()[..], &base.translation(), &VALUES].concat();
    for link in 0..fixed.link_names().len() {
        let there = base * fixed.mechanism().link_pose(&VALUES, link).unwrap();
        let found = floating.mechanism().link_pose(&values, link).unwrap();
        assert!(found.abs_diff_eq(there, 1e-14), "{link}");
    }
    assert_eq!(floating.value_names()[7..], *fixed.value_names());
    assert_eq!(floating.value("root_joint.x"), Some(4));
    assert_eq!(floating.value_limits()[7..], fixed.value_limits());
    assert_eq!(floating.joint("root_joint"), Some(0));
    let again = floating.floating().unwrap_err();
    assert_eq!(again, ChangeError::Taken { name: "root_joint".into() });
}

#[test]
fn a_rail_carries_the_robot_and_has_limits_of_its_own() {
    let rail = Joint::prismatic(None, pose(), [0.0, 1.0, 0.0]).with_limits([-1.0, 2.0]);
    let robot = arm().on("rail", rail).unwrap();
    assert_eq!(robot.value_names()[0], "rail");
    assert_eq!(robot.value_limits()[0], Some([-1.0, 2.0]));
    let values = [&[0.4][..], &VALUES].concat();
    let along = pose() * DualQuat::from_translation([0.0, 0.4, 0.0]);
    let there = along * arm().mechanism().link_pose(&VALUES, 6).unwrap();
    assert!(robot.mechanism().link_pose(&values, 6).unwrap().abs_diff_eq(there, 1e-14));
    let refused = arm().on("rail", Joint { parent: Some(2), ..rail }).unwrap_err();
    let error = MechanismError::Parent { joint: 0, parent: 2 };
    assert_eq!(refused, ChangeError::Mechanism(error));
}

#[test]
fn a_tool_is_a_link_on_the_one_that_is_named() {
    let robot = arm();
    let last = robot.link_names().last().unwrap().clone();
    let robot = robot.with_tool("pen", &last, pose()).unwrap();
    let [hand, pen] = [&last[..], "pen"]
        .map(|name| robot.mechanism().link_pose(&VALUES, robot.link(name).unwrap()).unwrap());
    assert!(pen.abs_diff_eq(hand * pose(), 1e-14));
    assert_eq!(robot.value_names(), arm().value_names());
    let unknown = arm().with_tool("pen", "hnad", pose()).unwrap_err();
    assert!(unknown.to_string().contains(&last), "{unknown}");
    assert!(matches!(robot.with_tool("pen", &last, pose()), Err(ChangeError::Taken { .. })));
}

#[test]
fn tools_are_found_by_their_names_in_whatever_order_these_come() {
    let last = arm().link_names().last().unwrap().clone();
    let names = ["pen", "a", "zoom", "pencil", "0", "pe"];
    let robot =
        names.iter().fold(arm(), |robot, name| robot.with_tool(name, &last, pose()).unwrap());
    assert_eq!(robot.link_names().len(), arm().link_names().len() + names.len());
    for (index, name) in robot.link_names().iter().enumerate() {
        assert_eq!(robot.link(name), Some(index));
    }
    for name in ["", "p", "penc", "zz"] {
        assert_eq!(robot.link(name), None, "{name}");
    }
}

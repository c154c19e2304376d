//! Lines that somebody would type who knows other robot libraries. They compile, and mean what they
//! seem to.

use dq8::DualQuat;
use dq8_robot::ik::{Goal, Options, OwnedReach};
use dq8_robot::urdf::Robot;
use dq8_robot::{Joint, OwnedMechanism};

const ELBOW: &str = r#"<robot name="arm">
  <link name="base"/><link name="upper"/><link name="lower"/><link name="tool"/>
  <joint name="shoulder" type="continuous"><parent link="base"/><child link="upper"/><axis xyz="0 0 1"/></joint>
  <joint name="elbow" type="continuous"><origin xyz="1 0 0"/><parent link="upper"/><child link="lower"/><axis xyz="0 0 1"/></joint>
  <joint name="flange" type="fixed"><origin xyz="1 0 0"/><parent link="lower"/><child link="tool"/></joint>
</robot>"#;

#[test]
fn joints_links_and_values_are_found_by_their_names() {
    let robot: Robot = ELBOW.parse().expect("a robot");
    assert_eq!(robot.link("tool"), Some(3));
    assert_eq!(robot.joint("elbow").and_then(|j| robot.link_names().get(j)).unwrap(), "lower");
    assert_eq!((robot.value("shoulder"), robot.value("elbow")), (Some(0), Some(1)));
    assert_eq!(
        (robot.joint("wrist"), robot.value("flange"), robot.link("hand")),
        (None, None, None)
    );
}

#[test]
fn joints_of_every_kind_have_a_constructor() {
    let z = [0.0, 0.0, 1.0];
    let here = DualQuat::<f64>::IDENTITY;
    let joints = [
        Joint::floating(None, here),
        Joint::planar(Some(0), here, z),
        Joint::screw(Some(1), here, z, 0.5),
        Joint::prismatic(Some(2), here, z),
        Joint::revolute(Some(3), here, z),
        Joint::fixed(Some(4), here),
    ];
    let tree = OwnedMechanism::new(&joints).expect("a mechanism");
    let mut values = [0.0; 13];
    (values[3], values[10], values[11]) = (1.0, 2.0, 3.0); // no turn of the body; the thread, the slide
    let tool = tree.link_pose(&values, 5).expect("a link");
    let mut poses = [here; 6];
    tree.link_poses(&values, &mut poses).expect("as many as links");
    assert!(tool.abs_diff_eq(poses[5], 1e-15) && (tool.translation()[2] - 4.0).abs() < 1e-15);
}

#[test]
fn a_search_with_memory_of_its_own_needs_no_scratch() {
    let robot: Robot = ELBOW.parse().expect("a robot");
    let tool = robot.link("tool").expect("a link");
    let arm = robot.cast::<f64>().expect("in range");
    let mut reach = OwnedReach::new(arm, [Goal::position(tool)]).expect("a goal");
    let mut angles = [0.3, 0.4];
    for x in [1.5, 1.2, 0.9] {
        let target = DualQuat::from_translation([x, 0.5, 0.0]);
        let report = reach.solve(&[target], &mut angles, &Options::default()).expect("it fits");
        assert!(report.is_converged());
        let there = reach.view().mechanism().link_pose(&angles, tool).expect("a link");
        assert!(there.distance_to(target) < 1e-4 || (there.translation()[0] - x).abs() < 1e-4);
    }
    let far = DualQuat::from_translation([5.0, 0.0, 0.0]);
    let report = reach.solve(&[far], &mut angles, &Options::default()).expect("it fits");
    assert!(!report.is_converged());
    assert!(reach.solve(&[far], &mut angles[..1], &Options::default()).is_err());
}

/// As a struct of a cell prints what it holds.
#[test]
fn robots_and_reaches_are_printed_on_a_line() {
    let robot: Robot = ELBOW.parse().expect("a robot");
    assert_eq!(format!("{robot:?}"), r#"Robot { name: "arm", links: 4, values: 2, warnings: 0 }"#);
    let mechanism = robot.cast::<f64>().expect("the same in f64");
    let printed = "Mechanism { links: 4, values: 2, rates: 2 }";
    assert_eq!(format!("{:?}", robot.mechanism()), printed);
    assert_eq!(format!("{mechanism:?}"), format!("Owned{printed}"));
    let reach = OwnedReach::new(mechanism, [Goal::position(3)]).expect("a goal");
    let printed = |owned| {
        format!(
            "{owned}Reach {{ mechanism: {owned}Mechanism {{ links: 4, values: 2, rates: 2 }}, goals: 1 }}"
        )
    };
    assert_eq!(
        (format!("{reach:?}"), format!("{:?}", reach.view())),
        (printed("Owned"), printed(""))
    );
}

#[test]
fn a_robot_is_printed_as_the_tree_of_its_links() {
    let robot: Robot = ELBOW.parse().expect("a robot");
    let tree = "0 base\n  1 upper (shoulder)\n    2 lower (elbow)\n      3 tool (flange)\n";
    assert_eq!(robot.to_string(), tree);
    let parents = [0, 1, 2, 3, 4].map(|link| robot.mechanism().parent(link));
    assert_eq!(parents, [None, Some(0), Some(1), Some(2), None]);
}

#[test]
fn degrees_of_freedom_speeds_and_manipulability_are_asked_of_the_robot() {
    let limited = ELBOW.replacen("<axis", "<limit velocity=\"2.5\"/><axis", 1);
    let robot: Robot = limited.parse().expect("a robot");
    assert_eq!(robot.velocity_limits(), [2.5, f64::INFINITY]);
    assert_eq!((robot.mechanism().dof(), robot.value_drives().len()), (2, 2));
    let elbow = robot.joint("elbow").expect("a joint");
    assert_eq!((robot.mechanism().values_of(elbow), robot.drives().len()), (Some(1..2), 4));
    let mut columns = [dq8::Twist::ZERO; 2];
    let planar = robot.mechanism().manipulability(&[0.3, 0.4], 3, &mut columns);
    assert_eq!(planar, Ok(0.0), "two hinges move nothing in six directions");
}

/// A floating base has seven values and six rates, and what mimics has those of its leader.
#[test]
fn what_a_robot_says_of_values_and_of_rates_is_found_by_its_joint() {
    let limited = ELBOW.replacen("<axis", "<limit velocity=\"2.5\"/><axis", 1);
    let limited = limited.replacen(
        "<axis xyz=\"0 0 1\"/></joint>\n  <joint name=\"flange",
        "<axis xyz=\"0 0 1\"/><mimic joint=\"shoulder\"/></joint>\n  <joint name=\"flange",
        1,
    );
    let robot: Robot = limited.parse().expect("a robot");
    let robot = robot.floating().expect("a robot that floats");
    let arm = robot.mechanism();
    let of = |name| robot.joint(name).expect("a joint");
    let of_shoulder = (arm.values_of(of("shoulder")), arm.rates_of(of("shoulder")));
    assert_eq!(of_shoulder, (Some(7..8), Some(6..7)));
    assert_eq!((arm.values_of(of("elbow")), arm.rates_of(of("elbow"))), of_shoulder);
    assert_eq!(arm.rates_of(of("flange")), Some(0..0));
    assert_eq!((arm.rates_of(99), arm.dof(), arm.values()), (None, 7, 8));
    let speeds = robot.velocity_limits();
    assert_eq!(speeds, [[f64::INFINITY; 6].as_slice(), &[2.5]].concat());
    let drives = robot.value_drives().into_iter().map(|drive| drive.velocity);
    assert!(drives.eq([[f64::INFINITY; 7].as_slice(), &[2.5]].concat()));
}

#[test]
fn values_are_within_limits_or_not_and_so_is_what_mimics() {
    let hinge =
        Joint::revolute(None, DualQuat::<f64>::IDENTITY, [0.0, 0.0, 1.0]).with_limits([-1.0, 2.0]);
    let other = hinge.with_limits([-1.0, 1.0]).mimicking(0, -2.0, 1.0);
    let hand = OwnedMechanism::new(&[hinge, other]).expect("a hand");
    for (value, within) in
        [(0.0, true), (1.0, true), (-0.1, false), (1.1, false), (f64::NAN, false)]
    {
        assert_eq!(hand.view().within_limits(&[value]), Ok(within), "{value}");
    }
    let free =
        OwnedMechanism::new(&[Joint::revolute(None, DualQuat::<f64>::IDENTITY, [0.0, 0.0, 1.0])]);
    assert_eq!(free.expect("a hinge").view().within_limits(&[f64::NAN]), Ok(false));
    // A fixed joint has no limits, and hides those of no other joint.
    let tool = Joint::fixed(Some(0), DualQuat::IDENTITY);
    let held = OwnedMechanism::new(&[hinge, tool]).expect("a hinge with a tool");
    for (value, within) in [(2.0, true), (2.1, false)] {
        assert_eq!(held.view().within_limits(&[value]), Ok(within), "{value}");
    }
}

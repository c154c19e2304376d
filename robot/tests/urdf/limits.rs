//! Limits: what is written, what is not, and what the format says then.

use dq8::DualQuat;
use dq8_robot::urdf::{Drive, Robot, UrdfError};

/// One joint of this type, with these elements and this version of the format.
fn robot(version: &str, kind: &str, elements: &str) -> Result<Robot, UrdfError> {
    Robot::from_urdf(&format!(
        r#"<robot name="r"{version}><link name="a"/><link name="b"/>
        <joint name="j" type="{kind}"><parent link="a"/><child link="b"/>{elements}</joint></robot>"#
    ))
}

fn limits(version: &str, kind: &str, limit: &str) -> Option<[f64; 2]> {
    robot(version, kind, &format!("<limit {limit}/>")).unwrap().value_limits()[0]
}

#[test]
fn limits_that_are_not_written_are_zero_and_none_since_version_1_2_and_zeros_lock_the_joint() {
    for kind in ["revolute", "prismatic"] {
        let locked = robot("", kind, r#"<limit lower="0" upper="0" effort="1"/>"#).unwrap();
        assert_eq!(locked.value_limits(), [Some([0.0, 0.0])], "{kind}");
        assert_eq!(locked.mechanism().limits(1), Some([0.0, 0.0]), "{kind}");
        for version in ["", r#" version="1.0""#, r#" version=" 1.1""#] {
            assert_eq!(limits(version, kind, r#"effort="1" velocity="1""#), Some([0.0, 0.0]));
            assert_eq!(limits(version, kind, r#"lower="-2""#), Some([-2.0, 0.0]));
            assert_eq!(limits(version, kind, r#"upper=" 2e-1 ""#), Some([0.0, 0.2]));
        }
        let version = r#" version="1.2""#;
        assert_eq!(limits(version, kind, r#"effort="1" velocity="1""#), None);
        assert_eq!(limits(version, kind, r#"lower="-2""#), Some([-2.0, f64::INFINITY]));
        assert_eq!(limits(version, kind, r#"lower="0" upper="0""#), Some([0.0, 0.0]));
    }
}

/// urdf-rs cannot say whether zeros are written, but has the same numbers.
#[test]
fn another_reader_has_the_same_limits() {
    for version in ["", r#" version="1.2""#] {
        for limit in [r#"lower="-1.5" upper="2""#, r#"lower="-1""#, r#"upper="0.5""#, ""] {
            let text = format!(
                r#"<robot name="r"{version}><link name="a"/><link name="b"/><joint name="j"
                type="revolute"><parent link="a"/><child link="b"/><limit velocity="1" {limit}/></joint></robot>"#
            );
            let other = urdf_rs::read_from_string(&text).unwrap();
            let wanted = [other.joints[0].limit.lower, other.joints[0].limit.upper];
            let found = Robot::from_urdf(&text).unwrap().value_limits()[0];
            assert_eq!(found.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]), wanted, "{text}");
        }
    }
}

#[test]
fn joints_of_other_types_have_no_limits() {
    for kind in ["continuous", "planar", "floating"] {
        for elements in ["", r#"<limit lower="-6.28" upper="6.28" effort="1"/>"#] {
            let robot = robot("", kind, elements).unwrap();
            assert!(robot.value_limits().iter().all(Option::is_none), "{kind}");
        }
    }
}

#[test]
fn speeds_and_efforts_are_read_and_what_is_no_number_is_no_limit() {
    for (limit, velocity, effort) in [
        (r#"velocity="3" effort=" 9 ""#, 3.0, 9.0),
        (r#"velocity="0""#, 0.0, f64::INFINITY),
        (r#"velocity="-1" effort="much""#, f64::INFINITY, f64::INFINITY),
        (r#"velocity="inf" effort="nan""#, f64::INFINITY, f64::INFINITY),
    ] {
        let limit = format!("<limit {limit}/>");
        let own = robot("", "continuous", &limit).unwrap();
        assert_eq!(own.drives(), [Drive::FREE, Drive { velocity, effort }], "{limit}");
        let carried = own.floating().unwrap().with_tool("tool", "b", DualQuat::IDENTITY).unwrap();
        assert_eq!(carried.drives(), [Drive::FREE, Drive { velocity, effort }, Drive::FREE]);
    }
}

#[test]
fn soft_limits_are_ignored() {
    let elements = r#"<limit lower="-2" upper="2"/>
        <safety_controller soft_lower_limit="-1" soft_upper_limit="1" k_velocity="1"/>"#;
    let robot = robot("", "revolute", elements).unwrap();
    assert_eq!(robot.value_limits(), [Some([-2.0, 2.0])]);
}

#[test]
fn parts_that_a_joint_has_no_use_for_are_not_looked_at() {
    for (kind, parts) in [
        ("fixed", r#"<axis/><limit lowr="x"/>"#),
        ("fixed", r#"<axis xyz="0 0 0"/>"#),
        ("floating", r#"<axis xyz="0 0 0"/>"#),
        ("floating", r#"<axis xzy="1"/><axis/>"#),
        ("continuous", r#"<limit lowr="x" upper="y"/><limit/>"#),
        ("planar", r#"<limit upper="no"/>"#),
    ] {
        let robot = robot("", kind, parts).unwrap_or_else(|error| panic!("{kind}: {error}"));
        assert!(robot.value_limits().iter().all(Option::is_none) && robot.link("b") == Some(1));
    }
}

#[test]
fn mimics_of_mimics_are_resolved() {
    let limit = r#"<limit lower="-2" upper="2"/>"#;
    let more = format!(
        r#"<mimic joint="y" multiplier="2" offset="1"/>{limit}</joint>
        <link name="c"/><joint name="y" type="prismatic"><parent link="a"/><child link="c"/>{limit}
        <mimic joint="z" multiplier="3" offset="0.5"/></joint>
        <link name="d"/><joint name="z" type="prismatic"><parent link="a"/><child link="d"/>{limit}"#
    );
    let robot = robot("", "prismatic", &more).unwrap();
    assert_eq!(robot.value_names(), ["z"]);
    let b = robot.mechanism().link_pose(&[0.25], robot.link("b").unwrap()).unwrap();
    // 2 (3 · 0.25 + 0.5) + 1, along x, which is the axis where none is given.
    assert_eq!(b.translation(), [3.5, 0.0, 0.0]);
}

/// Fingers of grippers, whose files give the follower the limits of its leader without the sign
/// between them.
#[test]
fn limits_of_what_mimics_are_those_of_the_value_where_they_leave_a_range_and_a_warning_says_so() {
    let hand = |mimic: &str, limits: &str| {
        Robot::from_urdf(&format!(
            r#"<robot name="hand"><link name="base"/><link name="knuckle"/><link name="finger"/>
            <joint name="leader" type="revolute"><parent link="base"/><child link="knuckle"/>
              <axis xyz="1 0 0"/><limit lower="0" upper="0.8"/></joint>
            <joint name="inner" type="revolute"><parent link="knuckle"/><child link="finger"/>
              <axis xyz="1 0 0"/><mimic joint="leader" {mimic}/><limit {limits}/></joint></robot>"#
        ))
        .unwrap()
    };
    let opposed = hand(r#"multiplier="-1""#, r#"lower="0" upper="0.8757""#);
    assert_eq!(opposed.value_limits(), [Some([0.0, 0.8])]);
    let [warning] = opposed.warnings() else { panic!("{:?}", opposed.warnings()) };
    assert_eq!(warning.line, 4);
    assert_eq!(
        warning.to_string(),
        "line 4: <joint name=\"inner\">: its limits leave no range to \"leader\", which it mimics, and are not read"
    );
    let narrower = hand(r#"multiplier="2""#, r#"lower="-1" upper="1""#);
    assert_eq!(narrower.value_limits(), [Some([0.0, 0.5])]);
    assert!(
        narrower.warnings()[0].text.contains("narrow those of \"leader\""),
        "{:?}",
        narrower.warnings()
    );
    let wider = hand(r#"multiplier="0.5""#, r#"lower="-1" upper="1""#);
    assert_eq!((wider.value_limits(), wider.warnings()), (vec![Some([0.0, 0.8])], &[][..]));
}

/// Joints are counted with the root, values without, and a joint that mimics has none.
#[test]
fn drives_of_values_are_those_of_their_joints() {
    let robot = Robot::from_urdf(super::FILE).unwrap();
    let drives: Vec<_> = robot.value_drives();
    assert_eq!((drives.len(), drives[0].velocity, drives[0].effort), (1, 3.0, 9.0));
    let body = robot.floating().unwrap();
    let drives = body.value_drives();
    assert_eq!((drives.len(), drives[6], drives[7].velocity), (8, Drive::FREE, 3.0));
}

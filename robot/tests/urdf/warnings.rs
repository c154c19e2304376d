//! What says nothing about places is not read and reported; what is meant to say something is an error.

use super::stands;
use dq8_robot::urdf::{Robot, UrdfWarning};

/// A hinge, as in the files of real robots, with more in it.
fn hinge(joint: &str, rest: &str) -> String {
    format!(
        r#"<?xml version="1.0"?>
<robot name="case" xmlns:v="http://vendor.example/x">
  <link name="base"/>
  <link name="tip"/>
  <joint name="hinge" type="revolute">
    <parent link="base"/>
    <child link="tip"/>
    <origin xyz="0.1 0.2 0.3" rpy="0.4 -0.5 0.6"/>
    {joint}
  </joint>
  {rest}
</robot>
"#
    )
}

const AXIS: &str = r#"<axis xyz="0 0 1"/>"#;
const LIMIT: &str = r#"<limit lower="-2" upper="2" effort="9" velocity="3"/>"#;

fn lines(warnings: &[UrdfWarning]) -> Vec<u32> {
    warnings.iter().map(|warning| warning.line).collect()
}

#[test]
fn a_file_with_nothing_else_has_no_warning() {
    let inertia = r#"<dynamics damping="0.1"/></joint><material name="m"/><link name="x">
        <visual><origin xyz="1 1 1"/></visual><collision/><inertial><mass value="1"/></inertial></link>
        <joint name="y" type="fixed"><parent link="tip"/><child link="x"/><axis xyz="0 0 0"/>"#;
    let robot = Robot::from_urdf(&hinge(&format!("{AXIS}{LIMIT}{inertia}"), "")).unwrap();
    assert_eq!(robot.warnings(), []);
    stands(&robot, "tip");
}

#[test]
fn attributes_of_other_programs_are_reported_and_the_link_stands_where_it_does() {
    let foot = r#"<link name="foot"/>
        <joint name="foot_fixed" type="fixed" dont_collapse="true">
          <parent link="tip"/> <child link="foot"/>
        </joint>"#;
    for (joint, rest, line, wanted) in [
        (
            format!("{AXIS}{LIMIT}"),
            foot,
            12,
            r#"<joint name="foot_fixed">: the attribute "dont_collapse" is not read"#,
        ),
        (
            format!(r#"<axis rpy="0 0 0" xyz="0 0 1"/>{LIMIT}"#),
            "",
            9,
            r#"<axis> of <joint name="hinge">: the attribute "rpy" is not read"#,
        ),
        (
            format!("{AXIS}{}", LIMIT.replace("effort", r#"damping="0.1" effort"#)),
            "",
            9,
            r#"<limit> of <joint name="hinge">: the attribute "damping" is not read"#,
        ),
        (
            format!("{AXIS}{}", LIMIT.replace("effort", r#"power="5" effort"#)),
            "",
            9,
            r#"<limit> of <joint name="hinge">: the attribute "power" is not read"#,
        ),
        (
            format!("{AXIS}{}", LIMIT.replace("effort", r#"v:lower="5" effort"#)),
            "",
            9,
            r#"<limit> of <joint name="hinge">: the attribute "v:lower" is not read"#,
        ),
    ] {
        let robot =
            Robot::from_urdf(&hinge(&joint, rest)).unwrap_or_else(|error| panic!("{error}"));
        stands(&robot, if rest.is_empty() { "tip" } else { "foot" });
        let [warning] = robot.warnings() else { panic!("{:?}", robot.warnings()) };
        assert_eq!(warning.to_string(), format!("line {line}: {wanted}"));
        assert_eq!((warning.line, wanted.starts_with(&warning.element)), (line, true));
        assert!(wanted.ends_with(&warning.text));
    }
}

#[test]
fn an_axis_with_rpy_is_that_of_xyz() {
    let axis = r#"<axis rpy="0 0 0" xyz="0 1 0"/>"#;
    let robot = Robot::from_urdf(&hinge(&format!("{axis}{LIMIT}"), "")).unwrap();
    let pose = robot.mechanism().link_pose(&[0.7], robot.link("tip").unwrap()).unwrap();
    // Rz(0.6) Ry(-0.5) Rx(0.4) Ry(0.7).
    let wanted = [0.12773074838228848, 0.14192948108817596, 0.3953494539363277, 0.8984651844050435];
    close(&pose.rotation().to_array(), &wanted);
    assert_eq!(lines(robot.warnings()), [9]);
}

#[test]
fn elements_of_other_programs_are_reported_wherever_they_are() {
    for name in [
        "gazebo",
        "transmission",
        "ros2_control",
        "mujoco",
        "sensor",
        "safety_controller",
        "calibration",
        "drake:acceleration",
        "v:extra",
        "v:collision",
        "joint_properties",
        "hardwareInterface",
        "physics",
        "preserveFixedJoint",
        "actuator",
        "disable_collisions",
        "self_collide",
        "plugin",
        "pose",
        "units",
    ] {
        let inside = r#"<origin xyz="7 7 7"/><u:n u:lowr="1"/><joint name="k">text</joint><limit lowr="3"/>"#;
        for element in [format!("<{name}>{inside}</{name}>"), format!("<{name} lowr='1' u:x='2'/>")]
        {
            let parts = format!("{AXIS}{LIMIT}");
            for (joint, rest, line) in [
                (&format!("{parts}{element}"), "", 9),
                (&format!("{element}{parts}"), "", 9),
                (&parts, element.as_str(), 11),
                (
                    &parts
                        .replace("/>", &format!(">{element}</v>"))
                        .replacen("</v>", "</axis>", 1)
                        .replace("</v>", "</limit>"),
                    "",
                    9,
                ),
            ] {
                let robot = Robot::from_urdf(&hinge(joint, rest));
                let robot = robot.unwrap_or_else(|error| panic!("{joint} {rest}: {error}"));
                stands(&robot, "tip");
                let warnings = robot.warnings();
                assert!(lines(warnings).iter().all(|&found| found == line), "{warnings:?}");
                assert!(!warnings.is_empty() && warnings[0].element.contains(name), "{warnings:?}");
            }
        }
        let file = hinge(&format!("{AXIS}{LIMIT}"), "").replacen(
            "<link name=\"tip\"/>",
            &format!("<link name=\"tip\"><{name}>{inside}</{name}></link>"),
            1,
        );
        let robot = Robot::from_urdf(&file).unwrap_or_else(|error| panic!("{name}: {error}"));
        stands(&robot, "tip");
        assert_eq!(lines(robot.warnings()), [4], "{name}");
    }
}

#[test]
fn text_that_is_no_number_is_reported() {
    for (joint, rest, wanted) in [
        (
            format!("{AXIS}--&gt;{LIMIT}"),
            "",
            r#"line 5: <joint name="hinge">: the text "-->" is not read"#,
        ),
        (
            format!("{AXIS}{LIMIT}"),
            "/&gt;",
            r#"line 2: <robot name="case">: the text "/>" is not read"#,
        ),
    ] {
        let robot = Robot::from_urdf(&hinge(&joint, rest)).unwrap();
        stands(&robot, "tip");
        assert_eq!(robot.warnings()[0].to_string(), wanted);
    }
}

#[test]
fn warnings_are_in_the_order_of_lines() {
    let joint = format!("{AXIS}{LIMIT}\n<physics/>\n<sensor/>");
    let robot = Robot::from_urdf(&hinge(
        &joint,
        "<gazebo/>\n<link name='x' kind='y'/>\n<joint name='z' type='fixed'>\n\
        <parent link='tip'/><child link='x'/><gazebo/></joint>",
    ))
    .unwrap();
    assert_eq!(lines(robot.warnings()), [10, 11, 13, 14, 16]);
}

#[test]
fn what_is_meant_to_say_where_something_is_stays_an_error() {
    let plain = format!("{AXIS}{LIMIT}");
    assert!(Robot::from_urdf(&hinge(&plain, "")).is_ok());
    for (from, to) in [
        ("lower", "lowr"),
        ("lower", "LOWER"),
        ("lower", "min"),
        ("upper", "uper"),
        ("upper", "uppper"),
        ("<limit", "<limt"),
        ("<limit", "<Limits"),
        ("<axis", "<axes"),
        ("<axis", "<axsi"),
        ("xyz=\"0 0 1", "xzy=\"0 0 1"),
        ("xyz=\"0 0 1", "zyx=\"0 0 1"),
        ("<origin", "<orgin"),
        ("<origin", "<Origin"),
        ("<origin", "<orign"),
        ("rpy=\"0.4", "ypr=\"0.4"),
        ("rpy=\"0.4", "RPY=\"0.4"),
        ("rpy=\"0.4", "quat=\"0.4"),
        ("rpy=\"0.4", "yaw=\"0.4"),
        ("<parent link", "<parnt link"),
        ("<child link", "<chld link"),
        ("<parent link", "<parent lnik"),
        ("type=", "typ="),
        ("<axis xyz=\"0 0 1\"", "<axis xyz=\"0 0 1\" x=\"1\""),
        ("<axis", "<mimc joint=\"x\"/><axis"),
        ("<axis", "<v:axis"),
        ("<joint", "<jiont"),
        ("<joint", "<Joint"),
        ("<link name=\"base\"", "<lnk name=\"base\""),
        ("<link name=\"base\"/>", "<link name=\"base\"><link name=\"x\"/></link>"),
        ("<robot", "<robot verson=\"1.2\""),
        ("type=\"revolute\"", "type=\"revolute\" axis=\"0 0 1\""),
        ("<axis xyz=\"0 0 1\"/>", "<axis>0 0 1</axis>"),
    ] {
        let ends =
            |name: &str| to.strip_prefix('<').map(|to| format!("</{to}>").replace("</", name));
        let file = hinge(&plain, "").replacen(from, to, 1);
        let file =
            if from == "<joint" { file.replace("</joint>", &ends("</").unwrap()) } else { file };
        let error = Robot::from_urdf(&file).expect_err(to).to_string();
        assert!(error.contains("line ") && !error.contains("line 1:"), "{to}: {error}");
    }
    let follower = r#"<link name="x"/><joint name="y" type="continuous"><parent link="tip"/><child link="x"/>
        <mimic joint="hinge" multiplier="2" offset="1"/></joint>"#;
    assert!(Robot::from_urdf(&hinge(&plain, follower)).is_ok());
    for (from, to) in [
        ("multiplier", "multiplyer"),
        ("offset", "ofset"),
        ("joint=", "jont="),
        ("<mimic", "<Mimic"),
    ] {
        let error = Robot::from_urdf(&hinge(&plain, &follower.replacen(from, to, 1)))
            .expect_err(to)
            .to_string();
        assert!(error.contains("line 12: "), "{to}: {error}");
    }
}

#[test]
fn parts_that_a_joint_has_no_use_for_are_not_looked_at() {
    for (kind, parts) in [
        ("fixed", r#"<axis/><limit lowr="x"/>"#),
        ("floating", r#"<axis xzy="1"/><axis/>"#),
        ("continuous", r#"<limit lowr="x" upper="y"/><limit/>"#),
        ("planar", r#"<limit upper="no"/>"#),
    ] {
        let file = hinge(parts, "").replace("revolute", kind);
        let robot = Robot::from_urdf(&file).unwrap_or_else(|error| panic!("{kind}: {error}"));
        assert!(robot.value_limits().iter().all(Option::is_none));
    }
}

#[test]
fn fixed_joints_that_mimic_stay_fixed() {
    for mimic in [
        r#"<mimic joint="lead" multiplier="1.6" offset="0"/>"#,
        r#"<mimic joint="nobody"/>"#,
        r#"<mimic joint="follow" offset="3" ofset="1"/>"#,
        "<mimic/>",
    ] {
        let file = format!(
            r#"<robot name="case">
  <link name="base"/> <link name="a"/> <link name="b"/>
  <joint name="lead" type="fixed">
    <parent link="base"/> <child link="a"/> <origin xyz="0.1 0 0" rpy="0.1 0.2 0.3"/>
  </joint>
  <joint name="follow" type="fixed">
    <parent link="a"/> <child link="b"/> <origin xyz="0 0.2 0" rpy="-0.3 0 0"/>
    {mimic}
  </joint>
</robot>"#
        );
        let robot = Robot::from_urdf(&file).unwrap_or_else(|error| panic!("{mimic}: {error}"));
        assert!(robot.value_names().is_empty());
        let wanted = r#"line 8: <mimic> of <joint name="follow">: a fixed joint mimics nothing"#;
        assert_eq!(robot.warnings()[0].to_string(), wanted);
        // Rz(0.3) Ry(0.2) Rx(0.1), by half angles; then (0, 0.2, 0) turned by it.
        let pose = |link| robot.mechanism().link_pose(&[], robot.link(link).unwrap()).unwrap();
        let ([sx, cx], [sy, cy], [sz, cz]) = (half(0.1), half(0.2), half(0.3));
        let (x, y) = (cz * cy * sx - sz * sy * cx, cz * sy * cx + sz * cy * sx);
        let (z, w) = (sz * cy * cx - cz * sy * sx, cz * cy * cx + sz * sy * sx);
        let turned = [2.0 * (x * y - w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + w * x)];
        close(&pose("a").rotation().to_array(), &[x, y, z, w]);
        close(&pose("a").translation(), &[0.1, 0.0, 0.0]);
        close(&pose("b").translation(), &[0.1 + 0.2 * turned[0], 0.2 * turned[1], 0.2 * turned[2]]);
        // About x by -0.3 on it.
        let [s, c] = half(-0.3);
        close(
            &pose("b").rotation().to_array(),
            &[w * s + x * c, y * c + z * s, z * c - y * s, w * c - x * s],
        );
    }
}

/// The sine and cosine of half an angle.
fn half(angle: f64) -> [f64; 2] {
    [(angle / 2.0).sin(), (angle / 2.0).cos()]
}

fn close(found: &[f64], wanted: &[f64]) {
    assert!(found.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-15), "{found:?} {wanted:?}");
}

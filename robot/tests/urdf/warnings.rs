//! What says nothing about places is not read and reported.

use super::{FILE, changed_to, rows, stands};
use dq8_robot::urdf::{Robot, UrdfWarning};

fn lines(warnings: &[UrdfWarning]) -> Vec<u32> {
    warnings.iter().map(|warning| warning.line).collect()
}

/// Attributes, elements and text of other programs, and their warning; none of what everybody
/// knows.
const REPORTED: &str = r#"
<axis | <axis rpy="1 2 3" | line 10: <axis> of <joint name="hinge">: the attribute "rpy" is not read
effort | damping="0.1" effort | line 11: <limit> of <joint name="hinge">: the attribute "damping" is not read
effort | power="5" effort | line 11: <limit> of <joint name="hinge">: the attribute "power" is not read
effort | v:lower="5" effort | line 11: <limit> of <joint name="hinge">: the attribute "v:lower" is not read
type="revolute" | type="revolute" dont_collapse="true" | line 6: <joint name="hinge">: the attribute "dont_collapse" is not read
"0 0 1"/> | "0 0 1"/>--&gt; | line 6: <joint name="hinge">: the text "-->" is not read
</robot> | /&gt;</robot> | line 2: <robot name="case">: the text "/>" is not read
<link | <link | 
<axis | <dynamics damping="0.1"/><axis | 
<link | <material name="m"/><link | 
<link name="tip"/> | <link name="tip"><visual><origin xyz="1 1 1"/></visual><collision/><inertial><mass value="1"/></inertial></link> | "#;

#[test]
fn what_others_have_for_themselves_is_reported_and_the_link_stands_where_it_does() {
    for (file, wanted) in rows(REPORTED) {
        let robot = stands(file.as_bytes(), "tip");
        let shown: Vec<_> = robot.warnings().iter().map(ToString::to_string).collect();
        assert_eq!(shown.concat(), wanted);
        for warning in robot.warnings() {
            let whole = format!("line {}: {}: {}", warning.line, warning.element, warning.text);
            assert_eq!(whole, wanted);
        }
    }
}

#[test]
fn elements_of_other_programs_are_reported_wherever_they_are_and_whatever_is_in_them() {
    let names = "gazebo transmission ros2_control mujoco sensor safety_controller calibration drake:acceleration v:extra \
                 v:collision joint_properties hardwareInterface physics preserveFixedJoint actuator disable_collisions \
                 self_collide plugin pose units contact visual collision inertial material dynamics";
    let known = ["visual", "collision", "inertial", "material", "dynamics"];
    let inside = r#"<origin xyz="7 7 7"/><u:n u:lowr="1"/><joint name="k">text</joint><limit lower="3" lowr="3"/>"#;
    for name in names.split_whitespace() {
        for element in [format!("<{name}>{inside}</{name}>"), format!("<{name} lowr='1' u:x='2'/>")]
        {
            for (place, to, line) in [
                ("<link name=\"base\"/>", format!("{element}<link name=\"base\"/>"), 3),
                ("<link name=\"tip\"/>", format!("<link name=\"tip\">{element}</link>"), 4),
                ("<parent", format!("{element}<parent"), 7),
                ("\"0 0 1\"/>", format!("\"0 0 1\">{element}</axis>"), 10),
                ("velocity=\"3\"/>", format!("velocity=\"3\">{element}</limit>"), 11),
                ("</joint>", format!("{element}</joint>"), 12),
                ("</robot>", format!("{element}</robot>"), 19),
            ] {
                let robot = stands(changed_to(place, &to).as_bytes(), "tip");
                let warnings = robot.warnings();
                assert!(lines(warnings).iter().all(|&found| found == line), "{warnings:?}");
                let is_named = warnings.first().is_some_and(|first| first.element.contains(name));
                assert!(is_named || known.contains(&name), "{place}: {name}: {warnings:?}");
            }
        }
    }
}

#[test]
fn warnings_are_in_the_order_of_lines() {
    let more = "<gazebo/>\n<link name='x' kind='y'/>\n<joint name='z' type='fixed'>\n\
                <parent link='tip'/><child link='x'/><gazebo/></joint></robot>";
    let file =
        changed_to("</robot>", more).replacen("</joint>", "<physics/>\n<sensor/></joint>", 1);
    assert_eq!(lines(stands(file.as_bytes(), "tip").warnings()), [12, 13, 20, 21, 23]);
}

#[test]
fn fixed_joints_that_mimic_stay_fixed() {
    for mimic in [
        r#"<mimic joint="hinge" multiplier="1.6" offset="0"/>"#,
        r#"<mimic joint="nobody"/>"#,
        r#"<mimic joint="slide" offset="3" ofset="1"/>"#,
        "<mimic/>",
    ] {
        let fixed = FILE.replace(r#"<mimic joint="hinge" multiplier="2" offset="1"/>"#, mimic);
        let robot = stands(fixed.replace("prismatic", "fixed").as_bytes(), "end");
        let wanted = r#"line 17: <mimic> of <joint name="slide">: a fixed joint mimics nothing, so <mimic> is not read"#;
        assert_eq!(robot.warnings()[0].to_string(), wanted);
    }
}

/// Left-overs of xacro and of other programs, elements that are there twice, and ends of a range in
/// the wrong order, which the files of real robots have: the first of the elements counts, as for
/// other readers.
#[test]
fn what_other_readers_pass_over_is_reported_and_the_links_stand_where_they_do() {
    let values = [0.7];
    let tip = |robot: &Robot| robot.mechanism().link_pose(&values, 1).unwrap();
    let sound = Robot::from_urdf(FILE).unwrap();
    for (from, to, line, words) in [
        ("<link", r#"<xacro:include filename="x"/><link"#, 3, "an element of xacro is not read"),
        (
            "<axis",
            r#"<xacro:arm xmlns:xacro="http://www.ros.org/wiki/xacro"/><axis"#,
            10,
            "an element of xacro",
        ),
        (
            "<link",
            r#"<xacro:property name="x" value="1"/><link"#,
            3,
            "an element of xacro is not read",
        ),
        (
            "<link",
            r#"<loop_joint name="l" type="revolute"><link1 link="tip"/></loop_joint><link"#,
            3,
            "is not read here",
        ),
        (
            r#"<axis xyz="0 0 1"/>"#,
            "<axis xyz=\"0 0 1\"/>\n<axis xyz=\"1 0 0\"/>",
            11,
            "only the first element of this name is read",
        ),
        (
            "<limit lower=\"-2\"",
            "<limit lower=\"-2\" upper=\"2\"/>\n<limit lower=\"-9\"",
            12,
            "only the first element of this name is read",
        ),
        (
            r#"<parent link="base"/>"#,
            "<parent link=\"base\"/>\n<parent link=\"end\"/>",
            8,
            "only the first element of this name is read",
        ),
        (r#"lower="-2" upper="2""#, r#"lower="2" upper="-2""#, 11, "the two are exchanged"),
    ] {
        let robot =
            Robot::from_urdf(&changed_to(from, to)).unwrap_or_else(|error| panic!("{to}: {error}"));
        let [warning] = robot.warnings() else { panic!("{to}: {:?}", robot.warnings()) };
        assert!(warning.line == line && warning.text.contains(words), "{to}: {warning}");
        assert_eq!(tip(&robot), tip(&sound), "{to}");
        assert_eq!(robot.value_limits(), sound.value_limits(), "{to}");
    }
    // What mimics nothing has no place.
    Robot::from_urdf(&changed_to(r#"<mimic joint="hinge""#, r#"<mimic joint="ghost""#))
        .unwrap_err();
}

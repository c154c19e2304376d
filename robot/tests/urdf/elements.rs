//! Elements, attributes and text that the format does not have: errors with line and element, but where they say nothing
//! about places.

use dq8_robot::urdf::{Robot, UrdfError};

/// A sound file, one joint element on each line.
const FILE: &str = r#"<?xml version="1.0"?>
<robot name="r">
  <link name="a"/><link name="b"/>
  <joint name="j" type="revolute">
    <parent link="a"/>
    <child link="b"/>
    <origin xyz="1 2 3" rpy="0 0 0"/>
    <axis xyz="0 0 1"/>
    <limit lower="-1" upper="1"/>
  </joint>
</robot>
"#;

/// The error of the file with one text changed into another.
fn error(from: &str, to: &str) -> UrdfError {
    assert!(FILE.contains(from), "{from}");
    Robot::from_urdf(&FILE.replacen(from, to, 1)).expect_err(to)
}

#[test]
fn what_is_misspelt_is_an_error_with_line_and_element() {
    for (from, to, wanted) in [
        (
            "<limit",
            "<limits",
            r#"line 9: <limits> of <joint name="j">: such an element is unknown here"#,
        ),
        ("<origin", "<Origin", r#"line 7: <Origin> of <joint name="j">: such"#),
        (
            "lower",
            "lowr",
            r#"line 9: <limit> of <joint name="j">: the attribute "lowr" is unknown"#,
        ),
        ("rpy", "ryp", r#"line 7: <origin> of <joint name="j">: the attribute "ryp""#),
        ("type", "typ", r#"line 4: <joint name="j">: the attribute "typ" is unknown"#),
        ("revolute", "Revolute", r#"line 4: <joint name="j">: the type "Revolute" is unknown"#),
        (
            r#"xyz="0 0 1""#,
            "",
            r#"line 8: <axis> of <joint name="j">: the attribute "xyz" is missing"#,
        ),
        (r#"<parent link="a"/>"#, "", r#"line 4: <joint name="j">: <parent> is missing"#),
        (r#"name="a""#, "", r#"line 3: <link>: the attribute "name" is missing"#),
        (r#"<link name="a"/>"#, "<loop_joint/>", "line 3: <loop_joint>: such"),
        (
            r#"<link name="a"/>"#,
            r#"<link name="a"><joint/></link>"#,
            r#"<joint> of <link name="a">: such"#,
        ),
        (
            "<axis xyz=\"0 0 1\"/>",
            "<axis xyz=\"0 0 1\">0 1 0</axis>",
            r#"line 8: <axis> of <joint name="j">: the text "0 1 0""#,
        ),
        (
            "<axis",
            "<axis xyz=\"1 0 0\"/>\n<axis",
            r#"line 9: <axis> of <joint name="j">: there is one"#,
        ),
        (
            "<child link=\"b\"/>",
            "<child link=\"b\"><origin/></child>",
            "line 6: <origin> of <child> of <joint",
        ),
    ] {
        let error = error(from, to).to_string();
        assert!(error.contains(wanted) && error.starts_with("not a URDF file: "), "{to}: {error}");
    }
}

#[test]
fn numbers_that_are_none_are_errors_and_not_left_out() {
    for (from, to, wanted) in [
        // Three numbers, if what is none were left out.
        (
            "1 2 3",
            "1 2 x 3",
            r#"line 7: <origin> of <joint name="j">: xyz="1 2 x 3" where 3 numbers must be"#,
        ),
        ("1 2 3", "1 2", "3 numbers"),
        ("1 2 3", "1,2,3", "3 numbers"),
        ("1 2 3", "1 NaN 3", "3 numbers"),
        ("-1", "${low}", r#"line 9: <limit> of <joint name="j">: lower="${low}" where 1 numbers"#),
    ] {
        let error = error(from, to);
        assert!(matches!(error, UrdfError::Numbers { .. }), "{error}");
        assert!(error.to_string().contains(wanted), "{error}");
    }
    // Infinitely far away: refused by the mechanism.
    assert!(error("1 2 3", "1 inf 3").to_string().contains(r#"<joint name="j">"#));
}

#[test]
fn errors_of_xml_name_the_line() {
    for (from, to, wanted) in [
        ("</joint>", "</join>", 10),
        (r#"rpy="0 0 0""#, r#"rpy="0 0 0"#, 8),
        (r#"rpy="0 0 0""#, r#"xyz="0 0 0""#, 7),
        ("<axis", "<<axis", 8),
    ] {
        let error = error(from, to);
        assert!(matches!(error, UrdfError::Parse { line, .. } if line == wanted), "{error}");
        assert!(error.to_string().contains(&format!("line {wanted}: ")), "{error}");
    }
    for nothing in ["", "  ", "<robot", "<!-- a comment -->", "text"] {
        assert!(matches!(Robot::from_urdf(nothing), Err(UrdfError::Parse { .. })), "{nothing}");
    }
    let error = Robot::from_urdf("\n<sdf/>").unwrap_err();
    let wanted = "not a URDF file: line 2: <sdf>: the outermost element must be <robot>";
    assert_eq!(error.to_string(), wanted);
}

#[test]
fn what_says_nothing_about_places_is_ignored_whatever_is_in_it() {
    let wanted = Robot::from_urdf(FILE).unwrap();
    let inside = r#"<origin xyz="7 7 7"/><joint name="k">text</joint><limit lower="3"/>"#;
    for name in [
        "visual",
        "collision",
        "contact",
        "inertial",
        "material",
        "dynamics",
        "calibration",
        "transmission",
        "sensor",
        "gazebo",
        "ros2_control",
        "mujoco",
        "safety_controller",
    ] {
        let element = format!("<{name}>{inside}</{name}><{name}/>");
        for place in ["<link name=\"a\"/>", "<parent", "<axis"] {
            let file = FILE.replacen(place, &format!("{element}{place}"), 1);
            let file = file.replacen(
                "<link name=\"b\"/>",
                &format!("<link name=\"b\">{element}</link>"),
                1,
            );
            let robot = Robot::from_urdf(&file).unwrap_or_else(|error| panic!("{name}: {error}"));
            assert_eq!(robot.joints(), wanted.joints(), "{name}");
        }
    }
}

#[test]
fn names_of_other_programs_are_ignored_as_attributes_and_errors_as_elements() {
    let wanted = Robot::from_urdf(FILE).unwrap();
    let file = FILE.replacen("<robot", r#"<robot xmlns="urn:urdf" xmlns:d="urn:d""#, 1);
    let noted = file.replacen("lower", r#"d:stiffness="1" lower"#, 1);
    assert_eq!(Robot::from_urdf(&noted).unwrap().joints(), wanted.joints());
    let other = file.replacen("<axis", "<d:axis", 1);
    let error = Robot::from_urdf(&other).unwrap_err().to_string();
    assert!(error.contains(r#"line 8: <d:axis> of <joint name="j">: such an element"#), "{error}");
}

#[test]
fn fixed_and_floating_joints_have_no_use_for_an_axis() {
    for kind in ["fixed", "floating"] {
        let file = FILE.replacen("revolute", kind, 1).replacen(r#""0 0 1""#, r#""0 0 0""#, 1);
        assert_eq!(Robot::from_urdf(&file).unwrap().link("b"), Some(1), "{kind}");
    }
}

//! Files that are no robots: errors name the element.

use dq8_robot::urdf::{Robot, UrdfError};

/// The message for these elements.
fn message(elements: &str) -> String {
    let text = format!(
        r#"<robot name="r"><link name="a"/><link name="b"/><link name="c"/>{elements}</robot>"#
    );
    Robot::from_urdf(&text).unwrap_err().to_string()
}

/// Joints that must have limits have some, unless `rest` says otherwise.
fn joint(name: &str, kind: &str, parent: &str, child: &str, rest: &str) -> String {
    let limited = ["revolute", "prismatic"].contains(&kind) && !rest.contains("<limit");
    let limit = if limited { r#"<limit lower="-2" upper="2"/>"# } else { "" };
    format!(
        r#"<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>{limit}{rest}</joint>"#
    )
}

#[test]
fn joints_name_links_that_are_there() {
    let text = joint("j", "fixed", "a", "nowhere", "");
    assert_eq!(message(&text), r#"line 1: <joint name="j">: there is no child link "nowhere""#);
    let text = joint("j", "fixed", "nowhere", "b", "");
    assert_eq!(message(&text), r#"line 1: <joint name="j">: there is no parent link "nowhere""#);
}

#[test]
fn links_make_one_tree() {
    assert_eq!(message(""), r#"line 1: more than one <link> is a root: ["a", "b", "c"]"#);
    let two = joint("j", "fixed", "a", "b", "") + &joint("k", "fixed", "c", "b", "");
    let already =
        r#"line 1: <joint name="k">: its child link "b" has a parent already, by <joint name="j">"#;
    assert_eq!(message(&two), already);
    let circle = joint("j", "fixed", "b", "c", "") + &joint("k", "fixed", "c", "b", "");
    assert!(message(&circle).contains("hangs on itself"), "{}", message(&circle));
    let twice = joint("j", "fixed", "a", "b", "") + &joint("j", "fixed", "b", "c", "");
    assert_eq!(message(&twice), r#"line 1: two <joint> have the name "j", the first is on line 1"#);
    assert_eq!(
        message(r#"<link name="a"/>"#),
        r#"line 1: two <link> have the name "a", the first is on line 1"#
    );
}

#[test]
fn what_cannot_be_expressed_is_an_error() {
    let chain = joint("k", "fixed", "b", "c", "");
    let ball = joint("j", "spherical", "a", "b", "") + &chain;
    assert_eq!(
        message(&ball),
        r#"cannot be expressed: line 1: <joint name="j"> of type "spherical""#
    );
    let turned =
        joint("j", "fixed", "a", "b", r#"<origin xyz="0 0 0" quat_xyzw="0 0 0 1"/>"#) + &chain;
    assert!(message(&turned).contains("quat_xyzw"));
    let noted = joint("j", "fixed", "a", "b", "<!-- quat_xyzw -->") + &chain;
    let noted = format!(
        r#"<robot name="r"><link name="a"/><link name="b"/><link name="c"/>{noted}</robot>"#
    );
    assert!(Robot::from_urdf(&noted).is_ok());
    let xacro = "cannot be expressed: line 1: an element of xacro: expand the file first";
    assert_eq!(message(r#"<xacro:include filename="x"/>"#), xacro);
    let declared = r#"<xacro:arm xmlns:xacro="http://www.ros.org/wiki/xacro"/>"#;
    assert_eq!(message(declared), xacro);
    let strange = joint("j", "spiral", "a", "b", "") + &chain;
    assert!(message(&strange).starts_with("not a URDF file"), "{}", message(&strange));
}

#[test]
fn axes_have_a_direction_and_limits_an_order() {
    let chain = joint("k", "fixed", "b", "c", "");
    let nowhere = joint("j", "revolute", "a", "b", r#"<axis xyz="0 0 0"/>"#) + &chain;
    assert_eq!(
        message(&nowhere),
        r#"line 1: <joint name="j">: the axis [0.0, 0.0, 0.0] has no direction"#
    );
    let limits = r#"<limit lower="2" upper="1" effort="1" velocity="1"/>"#;
    let disordered = joint("j", "revolute", "a", "b", limits) + &chain;
    assert!(
        message(&disordered).starts_with(r#"line 1: <joint name="j">: the lower limit 2 is above"#),
        "{}",
        message(&disordered)
    );
}

#[test]
fn mimics_end_at_a_joint_of_one_value() {
    let mimic = |joint: &str| format!(r#"<mimic joint="{joint}" multiplier="2" offset="1"/>"#);
    let circle = joint("j", "revolute", "a", "b", &mimic("k"))
        + &joint("k", "revolute", "b", "c", &mimic("j"));
    assert!(message(&circle).contains("cannot mimic"));
    let none =
        joint("j", "revolute", "a", "b", &mimic("nobody")) + &joint("k", "fixed", "b", "c", "");
    assert_eq!(message(&none), r#"line 1: <joint name="j">: there is no mimic joint "nobody""#);
    let fixed = joint("j", "revolute", "a", "b", &mimic("k")) + &joint("k", "fixed", "b", "c", "");
    assert!(
        message(&fixed).starts_with(r#"line 1: <joint name="j"> cannot mimic "k""#),
        "{}",
        message(&fixed)
    );
}

#[test]
fn mimics_of_mimics_are_resolved() {
    let text = format!(
        r#"<robot name="r"><link name="a"/><link name="b"/><link name="c"/><link name="d"/>{}{}{}</robot>"#,
        joint("x", "prismatic", "a", "b", r#"<mimic joint="y" multiplier="2" offset="1"/>"#),
        joint("y", "prismatic", "a", "c", r#"<mimic joint="z" multiplier="3" offset="0.5"/>"#),
        joint("z", "prismatic", "a", "d", ""),
    );
    let robot = Robot::from_urdf(&text).unwrap();
    assert_eq!(robot.value_names(), ["z"]);
    let b = robot.mechanism().link_pose(&[0.25], robot.link("b").unwrap()).unwrap();
    // 2 (3 · 0.25 + 0.5) + 1, along x, which is the axis where none is given.
    assert_eq!(b.translation(), [3.5, 0.0, 0.0]);
}

#[test]
fn a_file_that_is_not_there_is_named() {
    let error = Robot::from_file("no/such.urdf").unwrap_err();
    assert!(matches!(&error, UrdfError::Read { path, .. } if path == "no/such.urdf"));
}

#[test]
fn elements_deep_in_each_other_are_no_danger() {
    let text = format!("<robot name='r'>{}{}</robot>", "<x>".repeat(20_000), "</x>".repeat(20_000));
    let error = Robot::from_urdf(&text).unwrap_err();
    assert!(error.to_string().contains("line 1: <x>"), "{error}");
}

/// Errors of the tree, of mimics and of what a mechanism refuses have a line like all others.
#[test]
fn every_error_has_the_line_and_the_names() {
    const FILE: &str = r#"<robot name="r">
<link name="a"/>
<link name="b"/>
<link name="c"/>
<joint name="j" type="revolute">
<parent link="a"/>
<child link="b"/>
<origin xyz="0 0 0"/>
<axis xyz="0 0 1"/>
<limit lower="-1" upper="1"/>
</joint>
<joint name="k" type="prismatic">
<parent link="b"/>
<child link="c"/>
<limit lower="-1" upper="1"/>
<mimic joint="j" multiplier="2"/>
</joint>
</robot>"#;
    assert!(Robot::from_urdf(FILE).is_ok());
    let whole = &FILE[FILE.find("<joint name=\"k").unwrap()..FILE.find("</robot>").unwrap()];
    for (from, to, line, names) in [
        (r#"<parent link="a"/>"#, r#"<parent link="x"/>"#, 6, &["j", "x"][..]),
        (r#"<child link="b"/>"#, r#"<child link="x"/>"#, 7, &["j", "x"]),
        (r#"<child link="c"/>"#, r#"<child link="b"/>"#, 14, &["k", "b", "j"]),
        (r#"<parent link="a"/>"#, r#"<parent link="c"/>"#, 3, &["b"]),
        (r#"<link name="c"/>"#, r#"<link name="b"/>"#, 4, &["b"]),
        (r#"<joint name="k""#, r#"<joint name="j""#, 12, &["j"]),
        (whole, "", 4, &["a", "c"]),
        (r#"xyz="0 0 1""#, r#"xyz="0 0 0""#, 9, &["j"]),
        (r#"lower="-1""#, r#"lower="3""#, 10, &["j"]),
        (r#"<mimic joint="j""#, r#"<mimic joint="ghost""#, 16, &["k", "ghost"]),
        (r#"<mimic joint="j""#, r#"<mimic joint="k""#, 16, &["k"]),
        (r#"type="revolute""#, r#"type="fixed""#, 16, &["k", "j"]),
        (r#"type="revolute""#, r#"type="planar""#, 16, &["k", "j"]),
        (r#"type="prismatic""#, r#"type="floating""#, 16, &["k", "j"]),
        (r#"xyz="0 0 0""#, r#"xyz="1.7e308 1.7e308 1.7e308" rpy="1 0 2""#, 5, &["j"]),
        (r#"xyz="0 0 0""#, r#"xyz="1e999 0 0""#, 8, &["j", "1e999 0 0"]),
        (r#"multiplier="2""#, r#"multiplier="1e999""#, 16, &["k", "1e999"]),
        (r#"upper="1""#, r#"upper="1e999""#, 10, &["j", "1e999"]),
        (r#"upper="1""#, r#"upper="-inf""#, 10, &["j", "-inf"]),
    ] {
        assert!(FILE.contains(from), "{from}");
        let error = Robot::from_urdf(&FILE.replacen(from, to, 1)).expect_err(to).to_string();
        assert!(error.contains(&format!("line {line}: ")), "{to}: {error}");
        for name in names {
            assert!(error.contains(&format!("{name:?}")), "{to}: {error}");
        }
    }
    let error = Robot::from_urdf("\n<robot name='r'/>").unwrap_err();
    assert_eq!(error.to_string(), "line 2: <robot> has no <link>");
}

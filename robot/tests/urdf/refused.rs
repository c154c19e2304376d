//! Files that are no robots: what is misspelt, missing, or not supported is an error, never
//! left out, that names the line, the element and what is meant.

use super::rows;
use dq8_robot::urdf::{Robot, UrdfError};

/// Elements, attributes and text that the format does not have there.
const MISSPELT: &str = r#"
<limit | <limits | 11: <limits> of <joint name="hinge">: this element is not expected here; did you mean "limit"?
<limit | <limt | 11: <limt> of <joint name="hinge">: this element is not expected here; did you mean "limit"?
<limit | <Limits | 11: <Limits> of <joint name="hinge">: this element is not expected here; did you mean "limit"?
<origin | <Origin | 9: <Origin> of <joint name="hinge">: this element is not expected here; did you mean "origin"?
<origin | <orgin | 9: <orgin> of <joint name="hinge">: this element is not expected here; did you mean "origin"?
<origin | <orgn | 9: <orgn> of <joint name="hinge">: this element is not expected here; did you mean "origin"?
<origin | <ORIGINS | 9: <ORIGINS> of <joint name="hinge">: this element is not expected here; did you mean "origin"?
<origin | <orign | 9: <orign> of <joint name="hinge">: this element is not expected here; did you mean "origin"?
<axis | <axes | 10: <axes> of <joint name="hinge">: this element is not expected here; did you mean "axis"?
<axis | <axsi | 10: <axsi> of <joint name="hinge">: this element is not expected here; did you mean "axis"?
<axis | <v:axis | 10: <v:axis> of <joint name="hinge">: this element is not expected here
<axis | <mimc joint="x"/><axis | 10: <mimc> of <joint name="hinge">: this element is not expected here; did you mean "mimic"?
<parent link | <parnt link | 7: <parnt> of <joint name="hinge">: this element is not expected here; did you mean "parent"?
<child link | <chld link | 8: <chld> of <joint name="hinge">: this element is not expected here; did you mean "child"?
<mimic | <Mimic | 17: <Mimic> of <joint name="slide">: this element is not expected here; did you mean "mimic"?
<link | <jiont/><link | 3: <jiont>: this element is not expected here; did you mean "joint"?
<link | <Joint/><link | 3: <Joint>: this element is not expected here; did you mean "joint"?
<link | <lnk name="x"/><link | 3: <lnk name="x">: this element is not expected here; did you mean "link"?
<link name="base"/> | <link name="base"><joint/></link> | 3: <joint> of <link name="base">: this element is not expected here
<link name="base"/> | <link name="base"><link name="x"/></link> | 3: <link name="x">: this element is not expected here
<child link="tip"/> | <child link="tip"><origin/></child> | 8: <origin> of <child> of <joint name="hinge">: this element is not expected here
lower | lowr | 11: <limit> of <joint name="hinge">: the attribute "lowr" is unknown; did you mean "lower"?
lower | loewr | 11: <limit> of <joint name="hinge">: the attribute "loewr" is unknown; did you mean "lower"?
lower | kower | 11: <limit> of <joint name="hinge">: the attribute "kower" is unknown; did you mean "lower"?
lower | LOWER | 11: <limit> of <joint name="hinge">: the attribute "LOWER" is unknown; did you mean "lower"?
lower | min | 11: <limit> of <joint name="hinge">: the attribute "min" is unknown
upper | uper | 11: <limit> of <joint name="hinge">: the attribute "uper" is unknown; did you mean "upper"?
upper | uppper | 11: <limit> of <joint name="hinge">: the attribute "uppper" is unknown; did you mean "upper"?
rpy | ryp | 9: <origin> of <joint name="hinge">: the attribute "ryp" is unknown; did you mean "rpy"?
rpy | ypr | 9: <origin> of <joint name="hinge">: the attribute "ypr" is unknown; did you mean "rpy"?
rpy | RPY | 9: <origin> of <joint name="hinge">: the attribute "RPY" is unknown; did you mean "rpy"?
rpy | quat | 9: <origin> of <joint name="hinge">: the attribute "quat" is unknown
rpy | yaw | 9: <origin> of <joint name="hinge">: the attribute "yaw" is unknown
xyz="0 0 1" | xzy="0 0 1" | 10: <axis> of <joint name="hinge">: the attribute "xzy" is unknown; did you mean "xyz"?
xyz="0 0 1" | zyx="0 0 1" | 10: <axis> of <joint name="hinge">: the attribute "zyx" is unknown; did you mean "xyz"?
xyz="0 0 1" | xyzw="0 0 1" | 10: <axis> of <joint name="hinge">: the attribute "xyzw" is unknown; did you mean "xyz"?
xyz="0 0 1" | xyz="0 0 1" X="1" | 10: <axis> of <joint name="hinge">: the attribute "X" is unknown; did you mean "x"?
xyz="0 0 1" | xyz="0 0 1" x="1" | 10: <axis> of <joint name="hinge">: the attribute "x" is unknown
<parent link | <parent lnik | 7: <parent> of <joint name="hinge">: the attribute "lnik" is unknown; did you mean "link"?
type | typ | 6: <joint name="hinge">: the attribute "typ" is unknown; did you mean "type"?
<robot | <robot verson="1.2" | 2: <robot name="case">: the attribute "verson" is unknown; did you mean "version"?
multiplier | multiplyer | 17: <mimic> of <joint name="slide">: the attribute "multiplyer" is unknown; did you mean "multiplier"?
offset | ofset | 17: <mimic> of <joint name="slide">: the attribute "ofset" is unknown; did you mean "offset"?
<mimic joint | <mimic jont | 17: <mimic> of <joint name="slide">: the attribute "jont" is unknown; did you mean "joint"?
revolute | Revolute | 6: <joint name="hinge">: the type "Revolute" is unknown
"0 0 1"/> | "0 0 1">0 1 0</axis> | 10: <axis> of <joint name="hinge">: the text "0 1 0" is not expected here
 xyz="0 0 1"/> | >0 0 1</axis> | 10: <axis> of <joint name="hinge">: the text "0 0 1" is not expected here
 xyz="0 0 1" |  | 10: <axis> of <joint name="hinge">: the attribute "xyz" is missing
<parent link="base"/> |  | 6: <joint name="hinge">: <parent> is missing
 name="base" |  | 3: <link>: the attribute "name" is missing
<limit lower="-2" upper="2" effort="9" velocity="3"/> |  | 6: <joint name="hinge">: a revolute or prismatic joint must have a <limit>
<limit lower="-3" upper="5"/> |  | 13: <joint name="slide">: a revolute or prismatic joint must have a <limit>
0.1 0.2 0.3 | 1 2 x 3 | 9: <origin> of <joint name="hinge">: xyz must be 3 finite numbers, but is "1 2 x 3"
0.1 0.2 0.3 | 1 2 | 9: <origin> of <joint name="hinge">: xyz must be 3 finite numbers, but is "1 2"
0.1 0.2 0.3 | 1,2,3 | 9: <origin> of <joint name="hinge">: xyz must be 3 finite numbers, but is "1,2,3"
0.1 0.2 0.3 | 1 NaN 3 | 9: <origin> of <joint name="hinge">: xyz must be 3 finite numbers, but is "1 NaN 3"
0.1 0.2 0.3 | 1 inf 3 | 9: <origin> of <joint name="hinge">: xyz must be 3 finite numbers, but is "1 inf 3"
0.1 0.2 0.3 | 1e999 0 0 | 9: <origin> of <joint name="hinge">: xyz must be 3 finite numbers, but is "1e999 0 0"
lower="-2" | lower="${low}" | 11: <limit> of <joint name="hinge">: lower must be a finite number, but is "${low}"
upper="2" | upper="1e999" | 11: <limit> of <joint name="hinge">: upper must be a finite number, but is "1e999"
upper="2" | upper="-inf" | 11: <limit> of <joint name="hinge">: upper must be a finite number, but is "-inf"
multiplier="2" | multiplier="1e999" | 17: <mimic> of <joint name="slide">: multiplier must be a finite number, but is "1e999"
</joint> | </join> | 12: …
rpy="0.4 -0.5 0.6" | rpy="0.4 -0.5 0.6 | 10: …
rpy="0.4 -0.5 0.6" | xyz="0.4 -0.5 0.6" | 9: …
<axis | <<axis | 10: …
<axis | <axis note="<!-- -->" | 10: …
"0 0 1" | "&zero; 0 1" | 10: …"#;

/// Trees, mimics, and what a mechanism refuses.
const NO_ROBOT: &str = r#"
<parent link="base"/> | <parent link="x"/> | line 7: <joint name="hinge">: there is no parent link "x"
<child link="tip"/> | <child link="x"/> | line 8: <joint name="hinge">: there is no child link "x"
<child link="end"/> | <child link="tip"/> | line 15: <joint name="slide">: its child link "tip" is already the child of <joint name="hinge">
<parent link="base"/> | <parent link="end"/> | line 4: <link name="tip">: the joints above it form a circle
<link name="end"/> | <link name="end"/><link name="more"/> | line 5: more than one <link> is the child of no joint: ["base", "more"]
<link name="end"/> | <link name="tip"/> | line 5: two <link> have the name "tip"; the first is on line 4
<joint name="slide" | <joint name="hinge" | line 13: two <joint> have the name "hinge"; the first is on line 6
xyz="0 0 1" | xyz="0 0 0" | line 10: <joint name="hinge">: the axis [0.0, 0.0, 0.0] has no direction: its length must be positive and finite
<mimic joint="hinge" | <mimic joint="ghost" | line 17: <joint name="slide">: there is no mimic joint "ghost"
<mimic joint="hinge" | <mimic joint="slide" | line 17: <joint name="slide"> cannot mimic "slide": each must have exactly one value, and no joint may mimic itself through others
<axis | <mimic joint="slide"/><axis | line 10: <joint name="hinge"> cannot mimic "slide": each must have exactly one value, and no joint may mimic itself through others
type="revolute" | type="fixed" | line 17: <joint name="slide"> cannot mimic "hinge": each must have exactly one value, and no joint may mimic itself through others
type="revolute" | type="planar" | line 17: <joint name="slide"> cannot mimic "hinge": each must have exactly one value, and no joint may mimic itself through others
type="prismatic" | type="floating" | line 17: <joint name="slide"> cannot mimic "hinge": each must have exactly one value, and no joint may mimic itself through others
0.1 0.2 0.3 | 1.7e308 1.7e308 1.7e308 | line 6: <joint name="hinge">: the translation of joint 1 is not finite
revolute | spherical | not supported: line 6: <joint name="hinge"> has the type "spherical"
rpy="0.4 -0.5 0.6" | quat_xyzw="0 0 0 1" | not supported: line 9: the attribute quat_xyzw of <origin> of <joint name="hinge">; write rpy instead
<robot | <robot version="2.0" | not supported: line 2: version "2.0" of the format"#;

#[test]
fn errors_name_the_line_the_element_and_what_is_wrong_with_it() {
    for (file, wanted) in rows(MISSPELT) {
        let error = Robot::from_urdf(&file).expect_err(&wanted).to_string();
        let wanted = format!("not a URDF file: line {wanted}");
        // Of what is no XML its reader says more.
        match wanted.strip_suffix('…') {
            Some(beginning) => assert!(error.starts_with(beginning), "{wanted}: {error}"),
            None => assert_eq!(error, wanted),
        }
    }
    for (file, wanted) in rows(NO_ROBOT) {
        let error = Robot::from_urdf(&file).expect_err(&wanted).to_string();
        assert!(error.starts_with(&wanted), "{wanted}: {error}");
    }
    for nothing in ["", "  ", "<robot", "<!-- a comment -->", "text"] {
        assert!(matches!(Robot::from_urdf(nothing), Err(UrdfError::Parse { .. })), "{nothing}");
    }
    let error = |text| Robot::from_urdf(text).unwrap_err().to_string();
    let outermost = "not a URDF file: line 2: <sdf>: the outermost element must be <robot>";
    assert_eq!(error("\n<sdf/>"), outermost);
    assert_eq!(error("\n<robot name='r'/>"), "line 2: <robot> has no <link>");
    let error = Robot::from_file("no/such.urdf").unwrap_err();
    assert!(matches!(&error, UrdfError::Read { path, .. } if path == "no/such.urdf"));
    assert!(std::error::Error::source(&error).is_some_and(|it| it.is::<std::io::Error>()));
}

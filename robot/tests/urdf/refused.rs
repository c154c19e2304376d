//! Files that are no robots: what is misspelt, missing, or cannot be expressed is an error, never
//! left out, that names the line, the element and what is meant.

use super::rows;
use dq8_robot::urdf::{Robot, UrdfError};

/// Elements, attributes and text that the format does not have there.
const MISSPELT: &str = r#"
<limit | <limits | 11: <limits> of <joint name="hinge">: such an element is unknown here; is "limit" meant?
<limit | <limt | 11: <limt> of <joint name="hinge">: such an element is unknown here; is "limit" meant?
<limit | <Limits | 11: <Limits> of <joint name="hinge">: such an element is unknown here; is "limit" meant?
<origin | <Origin | 9: <Origin> of <joint name="hinge">: such an element is unknown here; is "origin" meant?
<origin | <orgin | 9: <orgin> of <joint name="hinge">: such an element is unknown here; is "origin" meant?
<origin | <orgn | 9: <orgn> of <joint name="hinge">: such an element is unknown here; is "origin" meant?
<origin | <ORIGINS | 9: <ORIGINS> of <joint name="hinge">: such an element is unknown here; is "origin" meant?
<origin | <orign | 9: <orign> of <joint name="hinge">: such an element is unknown here; is "origin" meant?
<axis | <axes | 10: <axes> of <joint name="hinge">: such an element is unknown here; is "axis" meant?
<axis | <axsi | 10: <axsi> of <joint name="hinge">: such an element is unknown here; is "axis" meant?
<axis | <v:axis | 10: <v:axis> of <joint name="hinge">: such an element is unknown here
<axis | <mimc joint="x"/><axis | 10: <mimc> of <joint name="hinge">: such an element is unknown here; is "mimic" meant?
<parent link | <parnt link | 7: <parnt> of <joint name="hinge">: such an element is unknown here; is "parent" meant?
<child link | <chld link | 8: <chld> of <joint name="hinge">: such an element is unknown here; is "child" meant?
<mimic | <Mimic | 17: <Mimic> of <joint name="slide">: such an element is unknown here; is "mimic" meant?
<link | <jiont/><link | 3: <jiont>: such an element is unknown here; is "joint" meant?
<link | <Joint/><link | 3: <Joint>: such an element is unknown here; is "joint" meant?
<link | <lnk name="x"/><link | 3: <lnk name="x">: such an element is unknown here; is "link" meant?
<link name="base"/> | <link name="base"><joint/></link> | 3: <joint> of <link name="base">: such an element is unknown here
<link name="base"/> | <link name="base"><link name="x"/></link> | 3: <link name="x">: such an element is unknown here
<child link="tip"/> | <child link="tip"><origin/></child> | 8: <origin> of <child> of <joint name="hinge">: such an element is unknown here
lower | lowr | 11: <limit> of <joint name="hinge">: the attribute "lowr" is unknown; is "lower" meant?
lower | loewr | 11: <limit> of <joint name="hinge">: the attribute "loewr" is unknown; is "lower" meant?
lower | kower | 11: <limit> of <joint name="hinge">: the attribute "kower" is unknown; is "lower" meant?
lower | LOWER | 11: <limit> of <joint name="hinge">: the attribute "LOWER" is unknown; is "lower" meant?
lower | min | 11: <limit> of <joint name="hinge">: the attribute "min" is unknown
upper | uper | 11: <limit> of <joint name="hinge">: the attribute "uper" is unknown; is "upper" meant?
upper | uppper | 11: <limit> of <joint name="hinge">: the attribute "uppper" is unknown; is "upper" meant?
rpy | ryp | 9: <origin> of <joint name="hinge">: the attribute "ryp" is unknown; is "rpy" meant?
rpy | ypr | 9: <origin> of <joint name="hinge">: the attribute "ypr" is unknown; is "rpy" meant?
rpy | RPY | 9: <origin> of <joint name="hinge">: the attribute "RPY" is unknown; is "rpy" meant?
rpy | quat | 9: <origin> of <joint name="hinge">: the attribute "quat" is unknown
rpy | yaw | 9: <origin> of <joint name="hinge">: the attribute "yaw" is unknown
xyz="0 0 1" | xzy="0 0 1" | 10: <axis> of <joint name="hinge">: the attribute "xzy" is unknown; is "xyz" meant?
xyz="0 0 1" | zyx="0 0 1" | 10: <axis> of <joint name="hinge">: the attribute "zyx" is unknown; is "xyz" meant?
xyz="0 0 1" | xyzw="0 0 1" | 10: <axis> of <joint name="hinge">: the attribute "xyzw" is unknown; is "xyz" meant?
xyz="0 0 1" | xyz="0 0 1" X="1" | 10: <axis> of <joint name="hinge">: the attribute "X" is unknown; is "x" meant?
xyz="0 0 1" | xyz="0 0 1" x="1" | 10: <axis> of <joint name="hinge">: the attribute "x" is unknown
<parent link | <parent lnik | 7: <parent> of <joint name="hinge">: the attribute "lnik" is unknown; is "link" meant?
type | typ | 6: <joint name="hinge">: the attribute "typ" is unknown; is "type" meant?
<robot | <robot verson="1.2" | 2: <robot name="case">: the attribute "verson" is unknown; is "version" meant?
multiplier | multiplyer | 17: <mimic> of <joint name="slide">: the attribute "multiplyer" is unknown; is "multiplier" meant?
offset | ofset | 17: <mimic> of <joint name="slide">: the attribute "ofset" is unknown; is "offset" meant?
<mimic joint | <mimic jont | 17: <mimic> of <joint name="slide">: the attribute "jont" is unknown; is "joint" meant?
revolute | Revolute | 6: <joint name="hinge">: the type "Revolute" is unknown
"0 0 1"/> | "0 0 1">0 1 0</axis> | 10: <axis> of <joint name="hinge">: the text "0 1 0" has no place here
 xyz="0 0 1"/> | >0 0 1</axis> | 10: <axis> of <joint name="hinge">: the text "0 0 1" has no place here
 xyz="0 0 1" |  | 10: <axis> of <joint name="hinge">: the attribute "xyz" is missing
<parent link="base"/> |  | 6: <joint name="hinge">: <parent> is missing
 name="base" |  | 3: <link>: the attribute "name" is missing
<limit lower="-2" upper="2" effort="9" velocity="3"/> |  | 6: <joint name="hinge">: a revolute or prismatic joint must have a <limit>
<limit lower="-3" upper="5"/> |  | 13: <joint name="slide">: a revolute or prismatic joint must have a <limit>
0.1 0.2 0.3 | 1 2 x 3 | 9: <origin> of <joint name="hinge">: xyz="1 2 x 3" where 3 numbers must be
0.1 0.2 0.3 | 1 2 | 9: <origin> of <joint name="hinge">: xyz="1 2" where 3 numbers must be
0.1 0.2 0.3 | 1,2,3 | 9: <origin> of <joint name="hinge">: xyz="1,2,3" where 3 numbers must be
0.1 0.2 0.3 | 1 NaN 3 | 9: <origin> of <joint name="hinge">: xyz="1 NaN 3" where 3 numbers must be
0.1 0.2 0.3 | 1 inf 3 | 9: <origin> of <joint name="hinge">: xyz="1 inf 3" where 3 numbers must be
0.1 0.2 0.3 | 1e999 0 0 | 9: <origin> of <joint name="hinge">: xyz="1e999 0 0" where 3 numbers must be
lower="-2" | lower="${low}" | 11: <limit> of <joint name="hinge">: lower="${low}" where 1 numbers must be
upper="2" | upper="1e999" | 11: <limit> of <joint name="hinge">: upper="1e999" where 1 numbers must be
upper="2" | upper="-inf" | 11: <limit> of <joint name="hinge">: upper="-inf" where 1 numbers must be
multiplier="2" | multiplier="1e999" | 17: <mimic> of <joint name="slide">: multiplier="1e999" where 1 numbers must be
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
<child link="end"/> | <child link="tip"/> | line 15: <joint name="slide">: its child link "tip" has a parent already, by <joint name="hinge">
<parent link="base"/> | <parent link="end"/> | line 4: <link name="tip"> hangs on itself
<link name="end"/> | <link name="end"/><link name="more"/> | line 5: more than one <link> is a root: ["base", "more"]
<link name="end"/> | <link name="tip"/> | line 5: two <link> have the name "tip", the first is on line 4
<joint name="slide" | <joint name="hinge" | line 13: two <joint> have the name "hinge", the first is on line 6
xyz="0 0 1" | xyz="0 0 0" | line 10: <joint name="hinge">: the axis [0.0, 0.0, 0.0] has no direction
<mimic joint="hinge" | <mimic joint="ghost" | line 17: <joint name="slide">: there is no mimic joint "ghost"
<mimic joint="hinge" | <mimic joint="slide" | line 17: <joint name="slide"> cannot mimic "slide": both must have one value, and no circle
<axis | <mimic joint="slide"/><axis | line 10: <joint name="hinge"> cannot mimic "slide": both must have one value, and no circle
type="revolute" | type="fixed" | line 17: <joint name="slide"> cannot mimic "hinge": both must have one value, and no circle
type="revolute" | type="planar" | line 17: <joint name="slide"> cannot mimic "hinge": both must have one value, and no circle
type="prismatic" | type="floating" | line 17: <joint name="slide"> cannot mimic "hinge": both must have one value, and no circle
0.1 0.2 0.3 | 1.7e308 1.7e308 1.7e308 | line 6: <joint name="hinge">: the translation of joint 1 is not finite
revolute | spherical | cannot be expressed: line 6: <joint name="hinge"> of type "spherical"
rpy="0.4 -0.5 0.6" | quat_xyzw="0 0 0 1" | cannot be expressed: line 9: the attribute quat_xyzw in <origin> of <joint name="hinge">: write rpy
<robot | <robot version="2.0" | cannot be expressed: line 2: version "2.0" of the format"#;

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

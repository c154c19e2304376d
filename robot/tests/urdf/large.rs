//! Files of very many links: what takes the square of the time does not end here.

use dq8_robot::urdf::Robot;
use std::fmt::Write;

const LINKS: usize = 40_000;
/// Enough for a hundred million steps of what takes the square.
const MANY: usize = 10_000;

/// One link behind the other, each with these parts in its joint.
fn chain(links: usize, mut joint: impl FnMut(usize) -> String) -> String {
    let mut text = "<robot name=\"chain\">\n<link name=\"l0\"/>\n".to_owned();
    for i in 1..links {
        let (parent, joint) = (i - 1, joint(i));
        write!(
            text,
            "<link name=\"l{i}\"/>\n<joint name=\"j{i}\" type=\"continuous\"><parent link=\"l{parent}\"/>\n\
             <child link=\"l{i}\"/><origin xyz=\"0 0 1\"/>{joint}</joint>\n"
        )
        .unwrap();
    }
    text + "</robot>"
}

#[test]
fn a_chain_is_read_in_a_time_that_grows_with_its_length() {
    let robot = Robot::from_urdf(&chain(LINKS, |_| String::new())).unwrap();
    assert_eq!((robot.link_names().len(), robot.mechanism().values()), (LINKS, LINKS - 1));
    assert!((0..LINKS).all(|i| robot.link(&format!("l{i}")) == Some(i)));
    let tip = robot.mechanism().link_pose(&vec![0.0; LINKS - 1], LINKS - 1).unwrap();
    assert_eq!(tip.translation(), [0.0, 0.0, (LINKS - 1) as f64]);
}

#[test]
fn so_are_warnings_mimics_of_mimics_prefixes_and_links_in_reverse() {
    let robot = Robot::from_urdf(&chain(MANY, |_| "\n<physics/>".into())).unwrap();
    assert_eq!(robot.warnings().len(), MANY - 1);
    assert_eq!(robot.warnings()[MANY - 2].line as usize, 2 + 4 * (MANY - 1));
    let follow = |i| if i == 1 { String::new() } else { format!("<mimic joint=\"j{}\"/>", i - 1) };
    let robot = Robot::from_urdf(&chain(MANY, follow)).unwrap();
    assert_eq!(robot.value_names(), ["j1"]);
    let lead =
        |i| if i == MANY - 1 { String::new() } else { format!("<mimic joint=\"j{}\"/>", i + 1) };
    let robot = Robot::from_urdf(&chain(MANY, lead)).unwrap();
    assert_eq!(robot.value_names(), [format!("j{}", MANY - 1)]);
    let robot = Robot::from_urdf(&chain(MANY, |i| format!("<v{}:x/>", i % 200))).unwrap();
    assert_eq!(robot.warnings().len(), MANY - 1);
}

#[test]
fn errors_at_the_end_come_as_soon() {
    let error = Robot::from_urdf(&chain(MANY, |i| {
        if i == MANY - 1 { "<orgin/>".into() } else { String::new() }
    }));
    let error = error.unwrap_err().to_string();
    assert!(error.contains(&format!("line {}: <orgin>", 2 + 3 * (MANY - 1))), "{error}");
    let circle = chain(MANY, |i| format!("<mimic joint=\"j{}\"/>", i % (MANY - 1) + 1));
    assert!(Robot::from_urdf(&circle).unwrap_err().to_string().contains("cannot mimic"));
    let unconnected: String = (0..MANY).map(|i| format!("<link name=\"l{i}\"/>\n")).collect();
    let error =
        Robot::from_urdf(&format!("<robot name=\"r\">\n{unconnected}</robot>")).unwrap_err();
    assert!(error.to_string().starts_with("line 3: more than one <link> is the child of no joint"));
}

/// A strict reader of XML compares each attribute with all others, and each prefix with all that
/// are declared.
#[test]
fn more_attributes_or_prefixes_than_a_reader_compares_in_time_are_refused_with_their_line() {
    let element = |count: usize| {
        let attributes: String = (0..count).map(|i| format!(" a{i}='='")).collect();
        format!("<robot name='r'>\n<link name='a'{attributes}/></robot>")
    };
    let error = Robot::from_urdf(&element(40_000)).unwrap_err().to_string();
    assert_eq!(error, "not a URDF file: line 2: <link>: it has more than 1000 attributes");
    assert_eq!(Robot::from_urdf(&element(900)).unwrap().warnings().len(), 900);
    let prefixes = |count: usize| {
        let names: String = (0..count).map(|i| format!("<p{i}:x/>")).collect();
        format!("\n<!-- \n --><robot name='r'>\n<link name='a'/>{names}</robot>")
    };
    let error = Robot::from_urdf(&prefixes(40_000)).unwrap_err().to_string();
    assert_eq!(error, "not a URDF file: line 3: <robot>: its names have more than 1000 prefixes");
    assert_eq!(Robot::from_urdf(&prefixes(900)).unwrap().warnings().len(), 900);
}

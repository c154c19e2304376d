//! Text that a strict reader of XML refuses and readers of URDF do not; other encodings; what is refused still.

use super::{FILE, changed_to, rows, stands};
use dq8_robot::urdf::{Robot, UrdfError};

/// The file without its declaration.
fn body() -> &'static str {
    FILE.split_once('\n').unwrap().1
}

#[test]
fn declarations_comments_and_document_types_stand_anywhere_before_the_robot() {
    let declaration = r#"<?xml version="1.0"?>"#;
    for before in [
        declaration,
        "<!-- written by a generator -->\n<?xml version=\"1.0\"?>\n",
        "\n\n  \t<?xml version='1.0' encoding='utf-8'?>",
        "\u{feff}<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\" ?>",
        "\u{feff}\n<!-- one --><!-- two -- with -- dashes --->\n<?xml version = \"1.0\" ?>",
        "<?xml version=\"1.0\"?><?xml version=\"1.0\"?>",
        "<?xml?><?xml-stylesheet href='a.xsl'?>",
        "<!DOCTYPE robot>",
        "<?xml version='1.0'?>\n<!DOCTYPE robot SYSTEM \"urdf>.dtd\">\n<!-- ------- -->\n",
        "<!DOCTYPE robot [\n<!ELEMENT robot (link)*>\n<!-- a > -->\n]\n>\n",
        "<!-- <?xml version=\"1.0\" encoding=\"utf-16\"?> <robot> -->\r\n",
    ] {
        let file = format!("{before}{}", body());
        assert!(stands(file.as_bytes(), "tip").warnings().is_empty(), "{before}");
        // Lines are still those of the file.
        let error = Robot::from_urdf(&file.replacen("lower", "lowr", 1)).unwrap_err();
        let wanted = format!("line {}: <limit>", before.matches('\n').count() + 10);
        assert!(error.to_string().contains(&wanted), "{before}: {error}");
    }
}

/// What stands as it does in the file.
const SAME: &str = r#"
<axis | <!-- a -- b --><axis | 
<axis | <!-------- <joint name="x"> --------><axis | 
<axis | <?note a?><![CDATA[ <!-- ]]><axis | 
<axis | <!-- quat_xyzw --><axis | 
</robot> | </robot>⏎<!-- the end -- --> | 
0.1 0.2 0.3 | 1e-1 .2 +0.3 | 
0.1 0.2 0.3 |   0.1⏎0.2⏎  3.E-1  | 
0.4 -0.5 0.6 | 4e-1 -.5 +.6 | 
0 0 1 | 0. -0 1. | 
0 0 1 | 0 0 1000 | 
-2 |  -2.  | 
 effort="9" velocity="3" |  | 
 upper="2" |  upper="inf" | 
<axis | <gazebo><sensor:camera sensor:a='1' xsi:b='2'><a:b/></sensor:camera></gazebo><axis | 
<axis | <drake:x y='1:2'/><axis | 
<link name="tip"/> | <link name='tip'><v:x>a:b</v:x></link> | 
<robot name="case" | <robot xmlns:xi="urn:x" name="case" xsi:schemaLocation='a b' | 
<robot name="case" | <robot xmlns="urn:a:b" name="case" xmlns:xacro='http://ros.org/wiki/xacro' | 
</robot> | <v:a xmlns:v='urn:v'/><v:b/></robot> | "#;

#[test]
fn comments_numbers_and_prefixes_are_written_in_any_way_that_others_read() {
    for (file, _) in rows(SAME) {
        stands(file.as_bytes(), "tip");
        stands(file.replace(".2 ", ".2\t\r\n").as_bytes(), "tip");
    }
    for end in ["\n\u{1a}", "\0"] {
        stands(format!("{FILE}{end}").as_bytes(), "tip");
    }
}

#[test]
fn text_is_in_the_encoding_that_is_declared() {
    // "Büro", as a comment and as the name of the robot.
    let declared = |encoding: &str| {
        let body = body();
        format!("<?xml version=\"1.0\" encoding=\"{encoding}\"?>\n<!-- B\u{fc}ro -->\n{body}")
    };
    let named = |encoding: &str| declared(encoding).replace("\"case\"", "\"B\u{fc}ro\"");
    let latin = |text: String| {
        text.chars().map(|c| u8::try_from(u32::from(c)).unwrap()).collect::<Vec<_>>()
    };
    let mut files: Vec<Vec<u8>> = ["ISO-8859-1", "iso-8859-15", "latin1", "windows-1252"]
        .map(|name| latin(named(name)))
        .into();
    files.push(named("UTF-8").into());
    files.push(named("UTF-16").into());
    files.push(format!("\u{feff}{}", named("ISO-8859-1")).into());
    let wide: Vec<u16> = format!("\u{feff}{}", named("UTF-16")).encode_utf16().collect();
    files.push(wide.iter().flat_map(|unit| unit.to_le_bytes()).collect());
    files.push(wide.iter().flat_map(|unit| unit.to_be_bytes()).collect());
    files.push(latin(format!("<!-- {} -->{}", "encoding='utf-8'", named("latin1"))));
    for file in files {
        let robot = stands(&file, "tip");
        assert_eq!((robot.name(), robot.warnings()), ("B\u{fc}ro", &[][..]));
    }
    // Cyrillic in KOI8-R.
    let mut koi = b"<?xml version='1.0' encoding='koi8-r'?>".to_vec();
    let named = body().replace("case", "\u{1}");
    koi.extend(named.bytes().map(|byte| if byte == 1 { 0xd2 } else { byte }));
    assert_eq!(stands(&koi, "tip").name(), "\u{440}");

    // Others do not look at the encoding at all.
    for (file, wanted) in [
        (
            latin(declared("UTF-8")),
            "line 2: <?xml?>: bytes that are not UTF-8 are read as \u{fffd}",
        ),
        (
            latin(format!("\n<!-- B\u{fc}ro -->{}", body())),
            "line 2: <?xml?>: bytes that are not UTF-8 are read as \u{fffd}",
        ),
        (
            declared("klingon").into(),
            "line 1: <?xml?>: the encoding \"klingon\" is unknown and read as UTF-8",
        ),
    ] {
        assert_eq!(stands(&file, "tip").warnings()[0].to_string(), wanted);
    }
}

#[test]
fn a_file_is_read_as_its_bytes_are() {
    let path = std::env::temp_dir().join(format!("dq8-urdf-{}.urdf", std::process::id()));
    let comment = b"<?xml version='1.0' encoding='latin1'?><!-- \xfc -->";
    std::fs::write(&path, [comment, body().as_bytes()].concat()).unwrap();
    let robot = Robot::from_file(&path);
    std::fs::remove_file(&path).unwrap();
    assert_eq!(robot.unwrap().value_names(), ["hinge"]);
}

#[test]
fn entities_and_deep_nesting_are_refused_with_their_line() {
    let entity = format!("\n<!DOCTYPE robot [<!ENTITY a \"1\">]>{}", body());
    let error = Robot::from_urdf(&entity).unwrap_err();
    assert!(matches!(error, UrdfError::Parse { line: 2, .. }), "{error}");
    // The robot and its link are two, and what is in them may be 498 deep.
    for (depth, read) in [(498, true), (499, false), (100_000, false)] {
        let deep =
            format!("<link name=\"tip\">\n{}{}</link>", "<x>".repeat(depth), "</x>".repeat(depth));
        let error = Robot::from_urdf(&changed_to("<link name=\"tip\"/>", &deep)).err();
        assert_eq!(error.is_none(), read, "{depth}");
        assert!(error.is_none_or(|it| it.to_string().contains("line 5: <x>")), "{depth}");
    }
}

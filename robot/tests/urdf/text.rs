//! Text that a strict reader of XML refuses and readers of URDF do not; other encodings; what is
//! refused still.

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

/// The file with "Büro" as the name of the robot and in a comment, and this declaration.
fn declared(encoding: &str) -> String {
    let body = body().replace("\"case\"", "\"B\u{fc}ro\"");
    format!("<?xml version=\"1.0\" encoding=\"{encoding}\"?>\n<!-- B\u{fc}ro -->\n{body}")
}

fn latin(text: &str) -> Vec<u8> {
    text.chars().map(|c| u8::try_from(u32::from(c)).unwrap()).collect()
}

/// In both orders of bytes.
fn wide(text: &str) -> [Vec<u8>; 2] {
    let units: Vec<u16> = format!("\u{feff}{text}").encode_utf16().collect();
    [u16::to_le_bytes, u16::to_be_bytes]
        .map(|bytes| units.iter().copied().flat_map(bytes).collect())
}

#[test]
fn unicode_is_read_by_its_byte_order_mark_or_as_it_is_declared() {
    let mut files = vec![declared("UTF-8"), declared("utf8"), declared("UTF-16")];
    files.push(format!("\u{feff}{}", declared("ISO-8859-1")));
    let mut files: Vec<_> = files.into_iter().map(String::into_bytes).collect();
    files.extend(wide(&declared("UTF-16")));
    for file in files {
        let robot = stands(&file, "tip");
        assert_eq!((robot.name(), robot.warnings()), ("B\u{fc}ro", &[][..]));
    }
    // The encoding of ASCII does not matter.
    let ascii = format!("<?xml version='1.0' encoding='latin1'?>{}", body());
    assert_eq!(stands(ascii.as_bytes(), "tip").warnings(), []);
}

#[test]
fn bytes_that_are_not_in_the_encoding_are_replaced_with_a_warning() {
    // Others do not look at the encoding at all.
    let undeclared = format!("\n<!-- B\u{fc}ro -->{}", body());
    let mut files = vec![(latin(&declared("UTF-8")), "UTF-8"), (latin(&undeclared), "UTF-8")];
    let [mut little, mut big] = wide(&declared("UTF-16"));
    // Half of a pair instead of a letter.
    for (file, letter, half) in
        [(&mut little, [0xfc, 0], [0, 0xd8]), (&mut big, [0, 0xfc], [0xd8, 0])]
    {
        let at = file.windows(2).position(|unit| unit == letter).unwrap();
        file[at..at + 2].copy_from_slice(&half);
    }
    files.extend([(little, "UTF-16LE"), (big, "UTF-16BE")]);
    for (file, encoding) in files {
        let wanted = format!("line 2: <?xml?>: bytes that are not {encoding} are read as \u{fffd}");
        assert_eq!(stands(&file, "tip").warnings()[0].to_string(), wanted);
    }
    // Half of a unit at the end is no space.
    let cut = [&wide(body())[0][..], b" "].concat();
    assert!(matches!(Robot::from_bytes(&cut), Err(UrdfError::Parse { .. })));
}

#[cfg(feature = "urdf-encodings")]
#[test]
fn text_is_in_the_encoding_that_is_declared() {
    let mut files: Vec<Vec<u8>> = ["ISO-8859-1", "iso-8859-15", "latin1", "windows-1252"]
        .map(|name| latin(&declared(name)))
        .into();
    files.push(latin(&format!("<!-- {} -->{}", "encoding='utf-8'", declared("latin1"))));
    for file in files {
        let robot = stands(&file, "tip");
        assert_eq!((robot.name(), robot.warnings()), ("B\u{fc}ro", &[][..]));
    }
    // Cyrillic in KOI8-R.
    let mut koi = b"<?xml version='1.0' encoding='koi8-r'?>".to_vec();
    let named = body().replace("case", "\u{1}");
    koi.extend(named.bytes().map(|byte| if byte == 1 { 0xd2 } else { byte }));
    assert_eq!(stands(&koi, "tip").name(), "\u{440}");
    assert_eq!(
        stands(declared("klingon").as_bytes(), "tip").warnings()[0].to_string(),
        "line 1: <?xml?>: the encoding \"klingon\" is unknown, so the file is read as UTF-8"
    );
}

/// With the feature for encodings and without.
#[test]
fn utf_8_by_another_name_is_read() {
    for (name, is_known) in [(" UTF-8 ", true), ("utf_8", false), ("ANSI_8", false)] {
        let file = format!("<?xml version='1.0' encoding='{name}'?><!-- \u{f6} -->{}", body());
        let robot = Robot::from_bytes(file.as_bytes()).unwrap();
        assert_eq!(robot.warnings().is_empty(), is_known, "{name}: {:?}", robot.warnings());
    }
}

#[cfg(not(feature = "urdf-encodings"))]
#[test]
fn other_encodings_ask_for_their_feature() {
    for name in ["ISO-8859-1", "latin1", "windows-1252", "koi8-r", "klingon"] {
        let error = Robot::from_bytes(&latin(&declared(name))).unwrap_err();
        let wanted = format!(
            "the file declares the encoding \"{name}\", which dq8-robot reads only with its feature urdf-encodings: switch it on, or save the file as UTF-8"
        );
        assert_eq!(error.to_string(), wanted);
    }
}

#[test]
fn a_file_is_read_as_its_bytes_are() {
    let path = std::env::temp_dir().join(format!("dq8-urdf-{}.urdf", std::process::id()));
    let [wide, _] = wide(&declared("UTF-16"));
    std::fs::write(&path, wide).unwrap();
    let robot = Robot::from_file(&path);
    std::fs::remove_file(&path).unwrap();
    assert_eq!(robot.unwrap().name(), "B\u{fc}ro");
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

//! Text that a strict reader of XML refuses and readers of URDF do not; other encodings; what is refused still.

use dq8_robot::urdf::{Robot, UrdfError};

const BODY: &str = r#"<robot name="case">
  <link name="base"/>
  <link name="tip"/>
  <joint name="hinge" type="revolute">
    <parent link="base"/>
    <child link="tip"/>
    <origin xyz="0.1 0.2 0.3" rpy="0.4 -0.5 0.6"/>
    <axis xyz="0 0 1"/>
    <limit lower="-2" upper="2" effort="9" velocity="3"/>
  </joint>
</robot>
"#;

fn stands(bytes: &[u8]) -> Robot {
    let robot = Robot::from_bytes(bytes);
    let robot =
        robot.unwrap_or_else(|error| panic!("{error} in {}", String::from_utf8_lossy(bytes)));
    super::stands(&robot, "tip");
    robot
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
        assert!(stands(format!("{before}{BODY}").as_bytes()).warnings().is_empty(), "{before}");
        // Lines are still those of the file.
        let error =
            Robot::from_urdf(&format!("{before}{}", BODY.replace("lower", "lowr"))).unwrap_err();
        let wanted = format!("line {}: <limit>", before.matches('\n').count() + 9);
        assert!(error.to_string().contains(&wanted), "{before}: {error}");
    }
    for (from, to) in [
        ("<axis", "<!-- a -- b --><axis"),
        ("<axis", "<!-------- <joint name=\"x\"> --------><axis"),
        ("<axis", "<?note a?><![CDATA[ <!-- ]]><axis"),
        ("xyz=\"0 0 1\"", "note=\"<!-- -->\" xyz=\"0 0 1\""),
        ("</robot>\n", "</robot>\n<!-- the end -- -->\n\u{1a}"),
        ("</robot>\n", "</robot>\0"),
    ] {
        let file = BODY.replace(from, to);
        if to.starts_with("note") {
            // Not even readers of URDF take that for a comment: XML has no such character in a value.
            assert!(matches!(Robot::from_urdf(&file), Err(UrdfError::Parse { line: 8, .. })));
        } else {
            stands(file.as_bytes());
        }
    }
}

#[test]
fn numbers_are_written_in_any_way_that_others_read() {
    for (from, to) in [
        ("0.1 0.2 0.3", "1e-1 .2 +0.3"),
        ("0.1 0.2 0.3", "  0.1\n\t0.2\r\n  3.E-1 "),
        ("0.4 -0.5 0.6", "4e-1\t-.5\t+.6"),
        ("0 0 1", "0. -0 1."),
        ("0 0 1", "0 0 1000"),
        ("-2", " -2. "),
        (" effort=\"9\" velocity=\"3\"", ""),
        (" upper=\"2\"", " upper=\"inf\""),
    ] {
        assert!(BODY.contains(from));
        stands(BODY.replacen(from, to, 1).as_bytes());
    }
}

#[test]
fn prefixes_need_no_declaration() {
    for (from, to) in [
        (
            "<axis",
            "<gazebo><sensor:camera sensor:a='1' xsi:b='2'><a:b/></sensor:camera></gazebo><axis",
        ),
        ("<axis", "<drake:x y='1:2'/><axis"),
        ("<link name=\"tip\"/>", "<link name='tip'><v:x>a:b</v:x></link>"),
        (
            "<robot name=\"case\"",
            "<robot xmlns:xi=\"urn:x\" name=\"case\" xsi:schemaLocation='a b'",
        ),
        (
            "<robot name=\"case\"",
            "<robot xmlns=\"urn:a:b\" name=\"case\" xmlns:xacro='http://ros.org/wiki/xacro'",
        ),
        ("</robot>", "<v:a xmlns:v='urn:v'/><v:b/></robot>"),
    ] {
        stands(BODY.replacen(from, to, 1).as_bytes());
    }
    for element in ["<xacro:arm/>", "<x:arm xmlns:x='http://www.ros.org/wiki/xacro'/>"] {
        let error =
            Robot::from_urdf(&BODY.replacen("<axis", &format!("{element}<axis"), 1)).unwrap_err();
        assert!(matches!(error, UrdfError::NotExpressed { line: 8, .. }), "{error}");
    }
}

#[test]
fn text_is_in_the_encoding_that_is_declared() {
    // "Büro", as a comment and as the name of the robot.
    let declared = |encoding: &str| {
        format!("<?xml version=\"1.0\" encoding=\"{encoding}\"?>\n<!-- B\u{fc}ro -->\n{BODY}")
    };
    let named = |encoding: &str| declared(encoding).replace("\"case\"", "\"B\u{fc}ro\"");
    let latin = |text: String| {
        text.chars().map(|c| u8::try_from(u32::from(c)).unwrap()).collect::<Vec<_>>()
    };
    let wide = |text: &str| text.encode_utf16().collect::<Vec<_>>();
    let mut files: Vec<Vec<u8>> = ["ISO-8859-1", "iso-8859-15", "latin1", "windows-1252"]
        .map(|name| latin(named(name)))
        .into();
    files.push(named("UTF-8").into());
    files.push(named("UTF-16").into());
    files.push(format!("\u{feff}{}", named("ISO-8859-1")).into());
    files.push(
        wide(&format!("\u{feff}{}", named("UTF-16")))
            .iter()
            .flat_map(|unit| unit.to_le_bytes())
            .collect(),
    );
    files.push(
        wide(&format!("\u{feff}{}", named("UTF-16")))
            .iter()
            .flat_map(|unit| unit.to_be_bytes())
            .collect(),
    );
    files.push(latin(format!("<!-- {} -->{}", "encoding='utf-8'", named("latin1"))));
    for file in files {
        let robot = stands(&file);
        assert_eq!((robot.name(), robot.warnings()), ("B\u{fc}ro", &[][..]));
    }
    // Cyrillic in KOI8-R.
    let mut koi = b"<?xml version='1.0' encoding='koi8-r'?>".to_vec();
    koi.extend(
        BODY.replace("case", "\u{1}").bytes().map(|byte| if byte == 1 { 0xd2 } else { byte }),
    );
    assert_eq!(stands(&koi).name(), "\u{440}");

    // Others do not look at the encoding at all.
    let robot = stands(&latin(declared("UTF-8")));
    assert_eq!(
        robot.warnings()[0].to_string(),
        "line 2: <?xml?>: bytes that are not UTF-8 are read as \u{fffd}"
    );
    let robot = stands(&latin(format!("\n<!-- B\u{fc}ro -->{BODY}")));
    assert_eq!(robot.warnings()[0].line, 2);
    let robot = stands(declared("klingon").as_bytes());
    assert_eq!(
        robot.warnings()[0].to_string(),
        "line 1: <?xml?>: the encoding \"klingon\" is unknown and read as UTF-8"
    );
}

#[test]
fn a_file_is_read_as_its_bytes_are() {
    let path = std::env::temp_dir().join(format!("dq8-urdf-{}.urdf", std::process::id()));
    std::fs::write(
        &path,
        [b"<?xml version='1.0' encoding='latin1'?><!-- \xfc -->", BODY.as_bytes()].concat(),
    )
    .unwrap();
    let robot = Robot::from_file(&path);
    std::fs::remove_file(&path).unwrap();
    assert_eq!(robot.unwrap().value_names(), ["hinge"]);
}

#[test]
fn entities_and_deep_nesting_are_refused_with_their_line() {
    let entity = format!("\n<!DOCTYPE robot [<!ENTITY a \"1\">]>{BODY}");
    let error = Robot::from_urdf(&entity).unwrap_err();
    assert!(matches!(error, UrdfError::Parse { line: 2, .. }), "{error}");
    let unknown = BODY.replace("\"0 0 1\"", "\"&zero; 0 1\"");
    assert!(matches!(Robot::from_urdf(&unknown), Err(UrdfError::Parse { line: 8, .. })));
    // The robot and its link are two, and what is in them may be 498 deep.
    for (depth, read) in [(498, true), (499, false), (100_000, false)] {
        let deep =
            format!("<link name=\"tip\">\n{}{}</link>", "<x>".repeat(depth), "</x>".repeat(depth));
        let file = BODY.replace("<link name=\"tip\"/>", &deep);
        match Robot::from_urdf(&file) {
            Ok(_) => assert!(read, "{depth}"),
            Err(error) => {
                assert!(!read && error.to_string().contains("line 4: <x>"), "{depth}: {error}")
            }
        }
    }
}

//! The shapes of a robot: which of those of collision are known, and how many ends are looked at.

mod common;

use common::{HUMANOID, person, with_shape, with_soles};
use dq8_retarget::{Humanoid, KnownShapes, Role, Settings, retarget};
use mocap::biped;

#[test]
fn self_hits_are_not_known_where_a_link_has_a_mesh() {
    let mesh = "<mesh filename='package://robot/meshes/chest.stl'/>";
    let sphere = "<sphere radius='0.06'/>";
    let read = with_shape(&with_soles(), "left_hand", "0 0 -0.03", sphere);
    // Two shapes of one link that are not read make one link.
    let meshes = with_shape(&with_shape(&read, "chest", "0 0 0", mesh), "chest", "0 0 0.1", mesh);
    let unknown = "not known: 1 of 4 links have meshes as shapes";
    for (urdf, links, unread, hits) in [
        (HUMANOID, 0, 0, "not known: there are no shapes that could meet"),
        (&read, 3, 0, "0.0 (3 links have shapes)"),
        (&meshes, 4, 1, unknown),
        // A mesh beside a sphere on one link is as unknown as a mesh alone.
        (&with_shape(&meshes, "chest", "0 0 0", sphere), 4, 1, unknown),
    ] {
        let humanoid = Humanoid::from_urdf(urdf).unwrap();
        let report =
            retarget(&person(&biped::clip()), &humanoid, &Settings::default()).unwrap().report;
        assert_eq!(humanoid.known_shapes(), KnownShapes { links, unread });
        assert_eq!(report.shapes, humanoid.known_shapes());
        assert_eq!(report.self_hits.is_none(), hits.starts_with("not known"), "{report}");
        assert!(
            report.to_string().contains(&format!("self-hits, % of frames       {hits}\n")),
            "{report}"
        );
        let told = humanoid.to_string();
        assert_eq!(told.contains("links have meshes as collision shapes"), unread > 0, "{told}");
    }
}

#[test]
fn a_robot_of_hundreds_of_ends_has_the_roles_that_names_give_and_says_so() {
    let mut parts = String::new();
    for end in 0..300 {
        parts += &format!(
            "<link name='e{end}'/><joint name='e{end}' type='continuous'><parent link='pelvis'/><child link='e{end}'/></joint>"
        );
    }
    let urdf = HUMANOID.replace("</robot>", &(parts + "</robot>"));
    let humanoid = Humanoid::from_urdf(&urdf).unwrap();
    assert!(humanoid.told().iter().any(|sentence| sentence.contains("so many links")));
    let small = Humanoid::from_urdf(HUMANOID).unwrap();
    for role in Role::ALL {
        let link = |robot: &Humanoid| {
            robot.part(role).map(|part| robot.robot().link_names()[part.link].clone())
        };
        assert_eq!(link(&humanoid), link(&small), "{role}");
    }
}

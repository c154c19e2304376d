//! The goals and their targets as text, so that other programs can search for the same.

use dq8_retarget::{Humanoid, Motion, Person, Targets};
use std::fmt::{Error, Write as _};

/// Returns JSON: the seconds from frame to frame; each goal, with the point of its link and the
/// weights of rotation and position; in each frame the target of each goal, as a place and a
/// quaternion with w last; whether each foot stands; and the values of the stance.
pub(crate) fn json(
    person: &Person,
    humanoid: &Humanoid,
    targets: &Targets,
    motion: &Motion,
) -> Result<String, Error> {
    let links = humanoid.robot().link_names();
    let mut text = format!("{{\"step\":{},\n\"start\":{:?},\n", targets.step, targets.start);
    let goals = targets.goals.iter().zip(&targets.places).map(|(goal, place)| {
        let [link, joint] = [&links[goal.link], &person.joint_names()[place.joint]]
            .map(|name| serde_json::Value::from(name.as_str()));
        format!(
            "{{\"role\":\"{}\",\"link\":{link},\"joint\":{joint},\"point\":{:?},\"rotation\":{},\"position\":{}}}",
            place.role, goal.point, goal.angular[0], goal.linear[0]
        )
    });
    writeln!(text, "\"goals\":[{}],", goals.collect::<Vec<_>>().join(",\n"))?;
    writeln!(text, "\"stands\":{:?},", motion.contacts)?;
    let frames = targets.poses.chunks_exact(targets.goals.len()).map(|poses| {
        let poses = poses.iter().map(|pose| {
            let ([x, y, z], turn) = (pose.translation(), pose.rotation().to_array());
            format!("[{x},{y},{z},{},{},{},{}]", turn[0], turn[1], turn[2], turn[3])
        });
        format!("[{}]", poses.collect::<Vec<_>>().join(","))
    });
    writeln!(text, "\"targets\":[{}]}}", frames.collect::<Vec<_>>().join(",\n"))?;
    Ok(text)
}

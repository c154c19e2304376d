//! Tables of values and poses.

use dq8::DualQuat;
use dq8_robot::urdf::Robot;
use std::error::Error;
use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::Path;

/// The values of all configurations in a table, whose heading names each value of the robot once.
pub(crate) fn read(robot: &Robot, path: &Path) -> Result<Vec<f64>, Box<dyn Error>> {
    let text = std::fs::read_to_string(path)
        .map_err(|error| format!("cannot read {}: {error}", path.display()))?;
    values(robot, &text).map_err(|error| format!("{}: {error}", path.display()).into())
}

fn values(robot: &Robot, text: &str) -> Result<Vec<f64>, String> {
    let mut lines = text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty());
    let (_, heading) = lines.next().ok_or("no heading")?;
    let headings: Vec<_> = heading.split(',').map(str::trim).collect();
    let wanted = robot.value_names();
    if let Some(unknown) = headings.iter().find(|name| !wanted.iter().any(|other| other == *name)) {
        return Err(format!("the robot has no joint {unknown:?}; it has {wanted:?}"));
    }
    let mut columns = Vec::new();
    for name in wanted {
        let mut places = (0..headings.len()).filter(|&column| headings[column] == name);
        match (places.next(), places.next()) {
            (Some(column), None) => columns.push(column),
            (None, _) => return Err(format!("no column {name:?}")),
            (Some(_), Some(_)) => return Err(format!("two columns {name:?}")),
        }
    }
    let mut values = Vec::new();
    for (line, row) in lines {
        let cells: Vec<_> = row.split(',').map(str::trim).collect();
        if cells.len() != headings.len() {
            let (found, wanted) = (cells.len(), headings.len());
            return Err(format!("line {}: {found} cells where {wanted} are needed", line + 1));
        }
        for &column in &columns {
            let cell = cells[column];
            let number = cell.parse::<f64>().ok().filter(|number| number.is_finite());
            values.push(number.ok_or(format!("line {}: not a number: {cell:?}", line + 1))?);
        }
    }
    Ok(values)
}

/// A row for each configuration, seven numbers for each link, with all their digits.
pub(crate) fn write(
    robot: &Robot,
    poses: &[DualQuat<f64>],
    path: &Path,
) -> Result<(), Box<dyn Error>> {
    let file =
        File::create(path).map_err(|error| format!("cannot write {}: {error}", path.display()))?;
    let mut out = BufWriter::new(file);
    let heading = robot
        .link_names()
        .iter()
        .map(|name| format!("{name}.x,{name}.y,{name}.z,{name}.qx,{name}.qy,{name}.qz,{name}.qw"));
    writeln!(out, "{}", heading.collect::<Vec<_>>().join(","))?;
    for poses in poses.chunks_exact(robot.link_names().len()) {
        let mut comma = "";
        for pose in poses {
            let ([x, y, z], [qx, qy, qz, qw]) = (pose.translation(), pose.rotation().to_array());
            write!(out, "{comma}{x},{y},{z},{qx},{qy},{qz},{qw}")?;
            comma = ",";
        }
        writeln!(out)?;
    }
    out.flush()?;
    Ok(())
}

/// The poses of one configuration, for people: positions, and rotations as unit quaternions, four
/// decimals each.
pub(crate) fn text(robot: &Robot, poses: &[DualQuat<f64>]) -> String {
    let names = robot.link_names();
    let width = names.iter().map(|name| name.chars().count()).max().unwrap_or(0).max(4);
    let mut text = format!("{:>width$}", "link");
    for heading in ["x", "y", "z", "qx", "qy", "qz", "qw"] {
        text += &format!(" {heading:>9}");
    }
    for (name, pose) in names.iter().zip(poses) {
        text += &format!("\n{name:>width$}");
        for number in pose.translation().into_iter().chain(pose.rotation().to_array()) {
            // Adding zero leaves no minus in front of zeros.
            let rounded = (number * 1e4).round() / 1e4 + 0.0;
            text += &format!(" {rounded:9.4}");
        }
    }
    text + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    fn arm() -> Robot {
        Robot::from_urdf(include_str!("../../robots/arm6.urdf")).unwrap()
    }

    #[test]
    fn columns_may_stand_in_any_order() {
        let text =
            "flange_roll,waist,elbow,shoulder_pitch,forearm_roll,wrist_bend\n6,1,3,2,4,5\n\n";
        assert_eq!(values(&arm(), text), Ok(vec![1.0, 2.0, 3.0, 4.0, 5.0, 6.0]));
    }

    #[test]
    fn poses_are_printed_with_their_rotations_in_columns() {
        let robot = arm();
        let mechanism = robot.mechanism();
        let mut poses = vec![DualQuat::IDENTITY; mechanism.links()];
        mechanism.link_poses(&[0.3, -0.4, 0.9, 0.2, 0.5, -0.1], &mut poses).unwrap();
        let text = text(&robot, &poses);
        let rows: Vec<Vec<&str>> =
            text.lines().map(|line| line.split_whitespace().collect()).collect();
        assert_eq!(rows[0], ["link", "x", "y", "z", "qx", "qy", "qz", "qw"]);
        assert_eq!(rows[1][1..], ["0.0000"; 6].into_iter().chain(["1.0000"]).collect::<Vec<_>>());
        assert_eq!(rows.len(), 1 + poses.len());
        for (row, (name, pose)) in rows[1..].iter().zip(robot.link_names().iter().zip(&poses)) {
            assert_eq!(row[0], name);
            let wanted = pose.translation().into_iter().chain(pose.rotation().to_array());
            for (cell, wanted) in row[1..].iter().zip(wanted) {
                assert!((cell.parse::<f64>().unwrap() - wanted).abs() <= 0.5001e-4, "{text}");
            }
        }
        let width = text.lines().next().unwrap().len();
        assert!(
            text.lines().all(|line| line.len() == width) && !text.contains("-0.0000"),
            "{text}"
        );
    }

    #[test]
    fn what_is_wrong_is_named() {
        let heading = "waist,shoulder_pitch,elbow,forearm_roll,wrist_bend,flange_roll";
        let error = |text: &str| values(&arm(), text).unwrap_err();
        assert!(error("waist,knee\n").contains("\"knee\""));
        assert!(error("waist\n").contains("no column \"shoulder_pitch\""));
        assert!(error(&format!("{heading},waist\n")).contains("two columns \"waist\""));
        assert!(error(&format!("{heading}\n1,2,3\n")).contains("line 2: 3 cells"));
        assert!(error(&format!("{heading}\n1,2,3,4,5,NaN\n")).contains("\"NaN\""));
        assert_eq!(error(""), "no heading");
    }
}

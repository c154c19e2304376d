//! Joint values that bring a link to a target.

use dq8::{DualQuat, Quat};
use dq8_robot::ik::{Goal, Options, OwnedReach, Report};
use dq8_robot::urdf::Robot;
use std::error::Error;
use std::str::FromStr;

/// Where a link should be.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Target {
    Point([f64; 3]),
    Pose(DualQuat<f64>),
}

impl FromStr for Target {
    type Err = String;

    /// Three numbers, or seven: x, y, z and a unit quaternion, its real part last.
    fn from_str(text: &str) -> Result<Self, String> {
        let number =
            |cell: &str| cell.trim().parse().ok().filter(|number: &f64| number.is_finite());
        let numbers: Option<Vec<f64>> = text.split(',').map(number).collect();
        match numbers.as_deref() {
            Some(&[x, y, z]) => Ok(Self::Point([x, y, z])),
            Some(&[x, y, z, a, b, c, d]) => {
                let rotation = Quat::from_array([a, b, c, d]);
                // What people type has few digits.
                if !rotation.is_unit(1e-3) {
                    return Err(format!("not a rotation, which has length 1: {a},{b},{c},{d}"));
                }
                let rotation = rotation.normalize();
                Ok(Self::Pose(DualQuat::from_rotation_translation(rotation, [x, y, z])))
            }
            _ => Err(format!("not X,Y,Z or X,Y,Z,QX,QY,QZ,QW: {text}")),
        }
    }
}

/// How a search from `start`, which is drawn into the limits, ended, with the values of the whole
/// robot by name.
pub(crate) fn reach(
    robot: &Robot,
    link: usize,
    target: Target,
    start: &[f64],
) -> Result<String, Box<dyn Error>> {
    let (goal, to) = match target {
        Target::Point(point) => (Goal::position(link), DualQuat::from_translation(point)),
        Target::Pose(pose) => (Goal::pose(link), pose),
    };
    let (mut reach, mut values) = (OwnedReach::new(robot.cast()?, [goal])?, start.to_vec());
    let report = reach.solve(&[to], &mut values, &Options::default())?;
    let Report { iterations, restarts, angular_error, linear_error, outcome } = report;
    let turn = match target {
        Target::Point(_) => String::new(),
        Target::Pose(_) => format!("{angular_error:.1e} rad and "),
    };
    let mut text = format!(
        "{} to the target: {outcome:?}, {turn}{linear_error:.1e} m from it \
         ({iterations} iterations, {restarts} of them restarts)\n{:>24} {:>9}\n",
        robot.link_names()[link],
        "joint",
        "value"
    );
    for (name, value) in robot.value_names().iter().zip(&values) {
        text += &format!("{name:>24} {value:9.6}\n");
    }
    Ok(text)
}

#[test]
fn the_link_is_at_the_target_at_the_values_that_are_printed() {
    let robot = Robot::from_urdf(include_str!("../../robots/arm6.urdf")).unwrap();
    let (mechanism, link) = (robot.mechanism(), crate::tool::tool(&robot));
    let wanted = mechanism.link_pose(&[0.3, -0.4, 0.9, 0.2, 0.5, -0.1], link).unwrap();
    for target in [Target::Pose(wanted), Target::Point(wanted.translation())] {
        let text = reach(&robot, link, target, &[0.1; 6]).unwrap();
        assert!(text.contains("Converged"), "{text}");
        assert_eq!(text.contains("rad"), matches!(target, Target::Pose(_)), "{text}");
        let value = |name: &String| -> f64 {
            let row = text.lines().find_map(|line| line.trim().strip_prefix(name.as_str()));
            row.unwrap_or_else(|| panic!("no {name} in {text}")).trim().parse().unwrap()
        };
        let printed: Vec<f64> = robot.value_names().iter().map(value).collect();
        let found = mechanism.link_pose(&printed, link).unwrap();
        // The tolerance of the search, and six decimals.
        assert!(found.distance_to(wanted) < 3e-5, "{text}");
        let turned = found.rotation().angle_to(wanted.rotation()) > 5e-5;
        assert_eq!(turned, matches!(target, Target::Point(_)), "{text}");
    }
    let far = reach(&robot, link, Target::Point([30.0, 0.0, 0.0]), &[0.0; 6]).unwrap();
    let metres = far.split_once("OutOfReach, ").unwrap().1.split_once(" m").unwrap().0;
    assert!(metres.parse::<f64>().unwrap() > 25.0, "{far}");
}

//! Joint values that bring a link to a target.

use dq8::{DualQuat, Quat};
use dq8_robot::ik::{Freedom, Goal, Options, Reach, Report};
use dq8_robot::urdf::Robot;
use std::error::Error;
use std::fmt;
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

/// How a search ended, with the values of the whole robot by name.
#[derive(Debug)]
pub(crate) struct Answer<'r> {
    robot: &'r Robot,
    link: usize,
    target: Target,
    values: Vec<f64>,
    report: Report<f64>,
}

impl fmt::Display for Answer<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Report { iterations, restarts, angular_error, linear_error, outcome } = self.report;
        write!(f, "{} to the target: {outcome:?}, ", self.robot.link_names()[self.link])?;
        if let Target::Pose(_) = self.target {
            write!(f, "{angular_error:.1e} rad and ")?;
        }
        writeln!(
            f,
            "{linear_error:.1e} m from it ({iterations} iterations, {restarts} of them restarts)"
        )?;
        writeln!(f, "{:>24} {:>9}", "joint", "value")?;
        for (name, value) in self.robot.value_names().iter().zip(&self.values) {
            writeln!(f, "{name:>24} {value:9.6}")?;
        }
        Ok(())
    }
}

/// Searches from `start`, which is drawn into the limits.
pub(crate) fn reach<'r>(
    robot: &'r Robot,
    link: usize,
    target: Target,
    start: &[f64],
) -> Result<Answer<'r>, Box<dyn Error>> {
    let mechanism = robot.mechanism();
    let (goal, to) = match target {
        Target::Point(point) => (Goal::position(link), DualQuat::from_translation(point)),
        Target::Pose(pose) => (Goal::pose(link), pose),
    };
    let (goals, mut freedoms) = ([goal], vec![Freedom::default(); mechanism.rates()]);
    let reach = Reach::new(mechanism, &goals, &mut freedoms)?;
    let (mut values, mut scratch) = (start.to_vec(), vec![0.0; reach.scratch_len()]);
    let report = reach.solve(&[to], &mut values, &mut scratch, &Options::default())?;
    Ok(Answer { robot, link, target, values, report })
}

#[cfg(test)]
mod tests {
    use super::*;
    use dq8_robot::ik::Outcome;

    fn arm() -> Robot {
        Robot::from_urdf(include_str!("../../robots/arm6.urdf")).unwrap()
    }

    const VALUES: [f64; 6] = [0.3, -0.4, 0.9, 0.2, 0.5, -0.1];

    #[test]
    fn the_link_is_at_the_target_at_the_values_that_are_printed() {
        let robot = arm();
        let mechanism = robot.mechanism();
        let link = crate::tool::tool(&robot);
        let wanted = mechanism.link_pose(&VALUES, link).unwrap();
        for target in [Target::Pose(wanted), Target::Point(wanted.translation())] {
            let answer = reach(&robot, link, target, &[0.1; 6]).unwrap();
            let text = answer.to_string();
            assert!(text.contains("Converged"), "{text}");
            assert_eq!(text.contains("rad"), matches!(target, Target::Pose(_)), "{text}");
            let value = |name: &String| -> f64 {
                let row = text.lines().find_map(|line| line.trim().strip_prefix(name.as_str()));
                row.unwrap_or_else(|| panic!("no {name} in {text}")).trim().parse().unwrap()
            };
            let printed: Vec<f64> = robot.value_names().iter().map(value).collect();
            let found = mechanism.link_pose(&printed, link).unwrap();
            // The tolerance of the search, and six decimals.
            let (place, to) = (found.translation(), wanted.translation());
            assert!(place.iter().zip(to).all(|(a, b)| (a - b).abs() < 3e-5), "{text}");
            let turned = found.rotation().angle_to(wanted.rotation()) > 5e-5;
            assert_eq!(turned, matches!(target, Target::Point(_)), "{text}");
        }
    }

    #[test]
    fn what_is_too_far_is_said_to_be() {
        let robot = arm();
        let link = crate::tool::tool(&robot);
        let answer = reach(&robot, link, Target::Point([30.0, 0.0, 0.0]), &[0.0; 6]).unwrap();
        assert_eq!(answer.report.outcome, Outcome::OutOfReach);
        assert!(answer.report.linear_error > 25.0);
    }
}

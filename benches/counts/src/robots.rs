//! Poses of robots, of many configurations and of one at a time.

use crate::count;
use dq8::{Backend, DualQuat};
use dq8_fixtures::random::Random;
use dq8_robot::{Joint, OwnedMechanism};
use mechanism::peers::by_hand;
use mechanism::{ours, robots};

pub(crate) const ROWS: [&str; 2] = ["arm of 7", "humanoid of 29"];

/// As many as the search in the list of jobs needs.
const CONFIGURATIONS: usize = 1000_usize.next_multiple_of(8);

pub(crate) fn count_all(row: &str) {
    let joints = if row == ROWS[0] { robots::arm() } else { robots::humanoid() };
    let mut random = Random(1);
    let values: Vec<f32> =
        (0..CONFIGURATIONS * joints.len()).map(|_| random.between(-3.0, 3.0) as f32).collect();
    let robot = OwnedMechanism::new(&joints).expect("a robot");
    let doubles: Vec<f64> = values.iter().map(|&value| value.into()).collect();
    let mut expected = vec![DualQuat::IDENTITY; doubles.len()];
    robot.job().poses(&doubles, &mut expected).expect("shape");
    let single: Vec<Joint<f32>> = joints.iter().map(Joint::cast).collect();
    let single = OwnedMechanism::new(&single).expect("a robot");
    let mut jobs = ours::singles(Backend::best(), single.view(), &values);
    // How often a search repeats depends on how numbers are rounded.
    jobs.retain(|job| !job.name().starts_with("tool to a random pose"));
    for job in &mut jobs {
        let things = job.things(CONFIGURATIONS);
        count(&format!("dq8 {}", job.name()), things, |passes| {
            (0..passes).for_each(|_| job.pass())
        });
    }
    for mut job in by_hand::jobs(&joints, &values, &expected) {
        count(job.name(), CONFIGURATIONS, |passes| (0..passes).for_each(|_| job.pass()));
    }
}

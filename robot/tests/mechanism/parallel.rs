//! All cores give what one gives.

use crate::tree::{mechanism, tree, values};
use dq8::{Backend, Block, DualQuat, ShapeError};
use dq8_fixtures::random::Random;
use dq8_robot::{Body, Job};

/// A job writes the same over `before` with one thread as with all of them.
#[track_caller]
fn on_all<'a, T: Clone + PartialEq>(
    job: Job<'a, f64>,
    before: &T,
    run: impl Fn(Job<'a, f64>, &mut T) -> Result<(), ShapeError>,
) {
    let [mut one, mut all] = [before.clone(), before.clone()];
    run(job, &mut one).unwrap();
    run(job.threads(usize::MAX), &mut all).unwrap();
    assert!(one == all);
}

#[test]
fn all_cores_give_every_bit_of_what_one_gives() {
    let mut random = Random(10);
    for count in [1, 7, 30] {
        let joints = tree(&mut random, count);
        let configurations = 5000;
        let values: Vec<f64> =
            (0..configurations).flat_map(|_| values(&mut random, &joints)).collect();
        let owned = mechanism::<f64>(&joints);
        let robot = owned.view();
        assert!(robot.values() > 0);
        let job = robot.job().backend(Backend::best());
        let (links, rates) = ([count - 1, 0], vec![0.5; configurations * robot.rates()]);
        let second: Vec<f64> =
            rates.iter().zip(values.iter().cycle()).map(|(r, v)| r * v).collect();
        let points = [(0, [0.5; 3]), (count - 1, [0.1, 0.2, 0.3])];
        let poses = vec![DualQuat::IDENTITY; configurations * count];
        let tools = vec![DualQuat::IDENTITY; configurations * links.len()];
        let twists = vec![[0.0; 6]; configurations * count];
        let columns = vec![[0.0; 6]; links.len() * configurations * robot.rates()];
        let blocks = vec![Block::<f64, 8>::splat([0.0; 8]); configurations / 8 * count];
        on_all(job, &poses, |job, to| job.poses(&values, to));
        on_all(job, &blocks, |job, to| job.poses(&values, to));
        on_all(job, &tools, |job, to| job.links(&links).poses(&values, to));
        let places = vec![[0.0; 3]; configurations * points.len()];
        on_all(job, &places, |job, to| job.points(&points, &values, to));
        on_all(job, &(tools, columns), |job, (tools, columns)| {
            job.links(&links).jacobians(Body, &values, tools, columns)
        });
        on_all(job, &(poses.clone(), twists.clone()), |job, (poses, twists)| {
            job.velocities(&values, &rates, poses, twists)
        });
        on_all(job, &(poses.clone(), twists.clone(), twists), |job, (poses, twists, more)| {
            job.accelerations(&values, &rates, &second, poses, twists, more)
        });
        let mut poses = poses;
        for (fewer, rates) in [(count, &rates[..]), (0, &rates[1..])] {
            let mut twists = vec![[7.0; 6]; configurations * count - fewer];
            let job = job.threads(usize::MAX);
            assert!(job.velocities(&values, rates, &mut poses[fewer..], &mut twists).is_err());
            assert!(twists.iter().all(|twist| *twist == [7.0; 6]), "{count}, refused");
        }
    }
}

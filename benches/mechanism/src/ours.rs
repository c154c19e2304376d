//! What dq8 does, in both precisions.

use crate::points::{COUNT, Points, spheres};
use dq8::{Backend, Block, DualQuat, Twist};
use dq8_fixtures::turns::Job;
use dq8_robot::ik::{Freedom, Goal, Options, Outcome, Reach, Report};
use dq8_robot::{Mechanism, World};
use std::hint::black_box;

/// Poses to be reached, from the values of other configurations; 998 of 1000 must be.
const TARGETS: usize = 1000;

/// The jobs of one robot in one precision, blocks as wide as a register of AVX2.
macro_rules! precision {
    ($name:ident, $real:ident, $lanes:literal) => {
        pub fn $name<'a>(
            backend: Backend,
            robot: Mechanism<'a, $real>,
            values: &'a [$real],
        ) -> Vec<Job<'a>> {
            type Motion = DualQuat<$real>;
            type Motions = Block<$real, $lanes>;
            let (links, tool) = (robot.links(), robot.links() - 1);
            let configurations = values.len() / links;
            let blocks = configurations / $lanes;
            let plain = || vec![Motion::IDENTITY; configurations * links];
            let in_blocks = || vec![Motions::splat(Motion::IDENTITY.to_array()); blocks * links];
            let columns = || vec![[0.0 as $real; 6]; configurations * links];
            let of_tools = || vec![Motion::IDENTITY; configurations];
            let job = move || robot.job().backend(backend);
            let mut packed = vec![Block::<$real, $lanes, 1>::splat([0.0]); blocks * links];
            for (configuration, values) in values.chunks_exact(links).enumerate() {
                for (value, &number) in values.iter().enumerate() {
                    let block = &mut packed[configuration / $lanes * links + value];
                    block.set(configuration % $lanes, [number]).expect("a lane");
                }
            }

            let mut jobs = Vec::new();
            let mut poses = plain();
            jobs.push(Job::new("all poses, plain", move || {
                job().poses(black_box(values), &mut poses).expect("shape");
            }));
            let mut poses = in_blocks();
            jobs.push(Job::new("all poses, blocks", {
                let packed = packed.clone();
                move || {
                    job().poses(black_box(&packed), &mut poses).expect("shape");
                }
            }));
            let mut poses = in_blocks();
            jobs.push(Job::new("all poses, plain to blocks", move || {
                job().poses(black_box(values), &mut poses).expect("shape");
            }));
            let mut tools = of_tools();
            jobs.push(Job::new("tool, plain", move || {
                job().links(&[tool]).poses(black_box(values), &mut tools).expect("shape");
            }));
            let (mut tools, mut jacobians) = (of_tools(), columns());
            jobs.push(Job::new("tool and Jacobian, plain", move || {
                let (only, values) = ([tool], black_box(values));
                let job = job().links(&only);
                job.jacobians(World, values, &mut tools, &mut jacobians).expect("shape");
            }));
            let (mut poses, mut twists) = (plain(), columns());
            jobs.push(Job::new("velocities, plain", move || {
                let (job, given) = (job(), black_box(values));
                job.velocities(given, values, &mut poses, &mut twists).expect("shape");
            }));
            let mut poses = plain();
            jobs.push(Job::new("all poses, one by one", move || {
                let poses = poses.chunks_exact_mut(links);
                for (values, poses) in black_box(values).chunks_exact(links).zip(poses) {
                    robot.link_poses(values, poses).expect("shape");
                }
            }));
            let mut tools = of_tools();
            jobs.push(Job::new("tool, one by one", move || {
                for (values, pose) in black_box(values).chunks_exact(links).zip(&mut tools) {
                    *pose = robot.link_pose(values, tool).expect("shape");
                }
            }));
            let mut columns = vec![Twist::ZERO; links];
            jobs.push(Job::new("tool and Jacobian, one by one", move || {
                for values in black_box(values).chunks_exact(links) {
                    let pose = robot.link_jacobian(World, values, tool, &mut columns);
                    black_box((pose.expect("shape"), &mut columns));
                }
            }));
            let points: [_; COUNT] = spheres(links)
                .map(|(link, [x, y, z])| (link, [x as $real, y as $real, z as $real]));
            let mut places = vec![Block::<$real, $lanes, 3>::splat([0.0; 3]); blocks * COUNT];
            jobs.push(Job::new("59 points, blocks", {
                let packed = packed.clone();
                move || {
                    job().points(&points, black_box(&packed), &mut places).expect("shape");
                }
            }));
            let mut places = vec![Block::<$real, $lanes, 3>::splat([0.0; 3]); blocks * COUNT];
            // As many configurations at a time as the first cache has room for the poses of.
            let mut some = vec![Motions::splat(Motion::IDENTITY.to_array()); 16 * links];
            jobs.push(Job::new("59 points, poses and a user's kernel", {
                let packed = packed.clone();
                move || {
                    let places = places.chunks_mut(16 * COUNT);
                    for (values, places) in black_box(&packed).chunks(16 * links).zip(places) {
                        let poses = &mut some[..values.len()];
                        job().poses(values, poses).expect("shape");
                        backend.run(Points { poses, points: &points, places, links });
                    }
                }
            }));
            let mut places = vec![[0.0; 3]; configurations * COUNT];
            jobs.push(Job::new("59 points, plain", move || {
                job().points(&points, black_box(values), &mut places).expect("shape");
            }));
            let mut places = [[0.0; 3]; COUNT];
            jobs.push(Job::new("59 points, one by one", move || {
                for values in black_box(values).chunks_exact(links) {
                    robot.link_points(values, &points, black_box(&mut places)).expect("shape");
                }
            }));
            jobs.push(Job::over(TARGETS, "tool to a random pose, plain", {
                let mut targets = of_tools();
                job().links(&[tool]).poses(values, &mut targets).expect("shape");
                let starts = &values[values.len() - TARGETS * links..];
                move || {
                    let (goals, mut freedoms) =
                        ([Goal::pose(tool)], vec![Freedom::default(); links]);
                    let reach = Reach::new(robot, &goals, &mut freedoms).expect("a goal");
                    let (mut found, targets) = (starts.to_vec(), &targets[..TARGETS]);
                    let mut reports = vec![Report::default(); TARGETS];
                    let options = Options::default();
                    let job = reach.job().backend(backend);
                    job.solve(targets, &mut found, &mut reports, &options).expect("shape");
                    let reached = |report: &&Report<_>| report.outcome == Outcome::Converged;
                    assert!(reports.iter().filter(reached).count() * 1000 >= 998 * TARGETS);
                }
            }));
            jobs
        }
    };
}
precision! { singles, f32, 8 }
precision! { doubles, f64, 4 }

//! What dq8 does, in both precisions.

use crate::job::Job;
use dq8::{Backend, Block, DualQuat};
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
                robot.job().backend(backend).poses(black_box(values), &mut poses).expect("shape");
            }));
            let mut poses = in_blocks();
            jobs.push(Job::new("all poses, blocks", move || {
                robot.job().backend(backend).poses(black_box(&packed), &mut poses).expect("shape");
            }));
            let mut poses = in_blocks();
            jobs.push(Job::new("all poses, plain to blocks", move || {
                robot.job().backend(backend).poses(black_box(values), &mut poses).expect("shape");
            }));
            let mut tools = of_tools();
            jobs.push(Job::new("tool, plain", move || {
                robot
                    .job()
                    .links(&[tool])
                    .backend(backend)
                    .poses(black_box(values), &mut tools)
                    .expect("shape");
            }));
            let (mut tools, mut jacobians) = (of_tools(), columns());
            jobs.push(Job::new("tool and Jacobian, plain", move || {
                let values = black_box(values);
                robot
                    .job()
                    .links(&[tool])
                    .backend(backend)
                    .jacobians(World, values, &mut tools, &mut jacobians)
                    .expect("shape");
            }));
            let (mut poses, mut twists) = (plain(), columns());
            jobs.push(Job::new("velocities, plain", move || {
                robot
                    .job()
                    .backend(backend)
                    .velocities(black_box(values), values, &mut poses, &mut twists)
                    .expect("shape");
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
            jobs.push(Job::over(TARGETS, "tool to a random pose, plain", {
                let mut targets = of_tools();
                robot
                    .job()
                    .links(&[tool])
                    .backend(backend)
                    .poses(values, &mut targets)
                    .expect("shape");
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

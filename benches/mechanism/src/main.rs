//! From joint values to poses of links, 10,000 random configurations, one thread: nanoseconds per configuration,
//! the least of many rounds.
//!
//! ```text
//! cargo run --release --manifest-path benches/mechanism/Cargo.toml -- [ROUNDS]
//! ```

mod peer;
mod robots;

use dq8::mechanism::{Joint, OwnedMechanism, World};
use dq8::storage::NumberBlock;
use dq8::{Backend, Block, DualQuat};
use std::hint::black_box;
use std::time::Instant;

const CONFIGURATIONS: usize = 10_000;

/// The jobs of one robot in one precision.
macro_rules! jobs {
    ($name:ident, $real:ident, $lanes:literal) => {
        fn $name(joints: &[Joint<f64>], rounds: usize) -> Vec<(&'static str, f64)> {
            let joints: Vec<Joint<$real>> = joints.iter().map(Joint::cast).collect();
            let owned = OwnedMechanism::new(&joints).expect("a robot");
            let (robot, backend) = (owned.view(), backend());
            let (links, tool) = (robot.links(), robot.links() - 1);
            let mut seed = 1_u64;
            let values: Vec<$real> = (0..CONFIGURATIONS * links)
                .map(|_| {
                    seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                    ((seed >> 33) as f64 / f64::from(1_u32 << 31) * 6.0 - 3.0) as $real
                })
                .collect();
            let blocks = CONFIGURATIONS / $lanes;
            let mut packed = vec![NumberBlock::<$real, $lanes>::splat([0.0]); blocks * links];
            for (configuration, values) in values.chunks_exact(links).enumerate() {
                for (value, &number) in values.iter().enumerate() {
                    let block = &mut packed[configuration / $lanes * links + value];
                    block.set(configuration % $lanes, [number]).expect("a lane");
                }
            }
            let mut poses = vec![DualQuat::<$real>::IDENTITY; CONFIGURATIONS * links];
            let mut pose_blocks =
                vec![Block::<$real, $lanes>::splat(DualQuat::IDENTITY.to_array()); blocks * links];
            let mut mixed_blocks = pose_blocks.clone();
            let mut tool_poses = vec![DualQuat::<$real>::IDENTITY; CONFIGURATIONS];
            let mut columns = vec![[0.0 as $real; 6]; CONFIGURATIONS * links];
            let (mut twists, mut moving_poses) = (columns.clone(), poses.clone());
            let mut one = vec![DualQuat::<$real>::IDENTITY; links];
            let mut tools = vec![DualQuat::<$real>::IDENTITY; CONFIGURATIONS];
            let mut jobs: Vec<(&'static str, Box<dyn FnMut() + '_>)> = vec![
                (
                    "all poses, plain",
                    Box::new(|| {
                        backend.link_poses(robot, black_box(&values), &mut poses).expect("shape");
                    }),
                ),
                (
                    "all poses, blocks",
                    Box::new(|| {
                        backend
                            .link_poses(robot, black_box(&packed), &mut pose_blocks)
                            .expect("shape");
                    }),
                ),
                (
                    "all poses, plain to blocks",
                    Box::new(|| {
                        backend
                            .link_poses(robot, black_box(&values), &mut mixed_blocks)
                            .expect("shape");
                    }),
                ),
                (
                    "tool, plain",
                    Box::new(|| {
                        backend
                            .chosen_link_poses(robot, &[tool], black_box(&values), &mut tools)
                            .expect("shape");
                    }),
                ),
            ];
            jobs.push((
                "tool and Jacobian, plain",
                Box::new(|| {
                    backend
                        .link_jacobians(
                            World,
                            robot,
                            tool,
                            black_box(&values),
                            &mut tool_poses,
                            &mut columns,
                        )
                        .expect("shape");
                }),
            ));
            jobs.push((
                "velocities, plain",
                Box::new(|| {
                    backend
                        .link_velocities(
                            robot,
                            black_box(&values),
                            &values,
                            &mut moving_poses,
                            &mut twists,
                        )
                        .expect("shape");
                }),
            ));
            jobs.push((
                "all poses, one by one",
                Box::new(|| {
                    for values in black_box(&values).chunks_exact(links) {
                        robot.link_poses(values, &mut one).expect("shape");
                        black_box(&mut one);
                    }
                }),
            ));
            let mut least: Vec<_> = jobs.iter().map(|(name, _)| (*name, f64::INFINITY)).collect();
            for _ in 0..rounds {
                for ((_, job), (_, least)) in jobs.iter_mut().zip(&mut least) {
                    let start = Instant::now();
                    job();
                    *least = least.min(start.elapsed().as_secs_f64() * 1e9 / CONFIGURATIONS as f64);
                }
            }
            least
        }
    };
}
jobs! { singles, f32, 8 }
jobs! { doubles, f64, 4 }

/// AVX2 unless the variable `BACKEND` is set, to the name of another.
fn backend() -> Backend {
    let name = std::env::var("BACKEND").unwrap_or_else(|_| "AVX2".into());
    let named = Backend::available().find(|backend| backend.to_string() == name);
    named.unwrap_or_else(Backend::best)
}

fn main() {
    let rounds = std::env::args().nth(1).and_then(|text| text.parse().ok()).unwrap_or(60);
    println!("{}; ns per configuration", backend());
    for (name, joints) in [("arm of 7", robots::arm()), ("humanoid of 29", robots::humanoid())] {
        for (number, jobs) in [("f64", doubles(&joints, rounds)), ("f32", singles(&joints, rounds))]
        {
            for (job, nanoseconds) in jobs {
                println!("{name:16} {number} {job:28} {nanoseconds:8.1}");
            }
        }
    }
    for file in ["arm7", "humanoid"] {
        for (job, nanoseconds) in peer::file(file, backend(), rounds) {
            println!("{file:16} f64 {job:28} {nanoseconds:8.1}");
        }
    }
}

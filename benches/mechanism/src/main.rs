//! From joint values to poses of links, 10,000 random configurations, one thread: nanoseconds per
//! configuration, the least of many rounds, in which dq8 and its peers take turns.
//!
//! ```text
//! cargo run --release --manifest-path benches/mechanism/Cargo.toml [--features peers] -- [ROUNDS]
//! ```

use dq8::{Backend, DualQuat};
use dq8_fixtures::random::Random;
use dq8_fixtures::turns::least;
use dq8_robot::{Joint, OwnedMechanism};
use mechanism::peers::by_hand;
use mechanism::{ours, robots, solutions};
#[cfg(feature = "peers")]
use mechanism::{
    peers::{dynibo, k},
    urdf,
};

const CONFIGURATIONS: usize = 10_000;

/// AVX2 unless the variable `BACKEND` is set, to the name of another.
fn backend() -> Backend {
    let name = std::env::var("BACKEND").unwrap_or_else(|_| "AVX2".into());
    let named = Backend::available().find(|backend| backend.to_string() == name);
    named.unwrap_or_else(Backend::best)
}

fn angles(count: usize) -> Vec<f64> {
    let mut random = Random(1);
    (0..count).map(|_| random.between(-3.0, 3.0)).collect()
}

fn contest(name: &str, joints: &[Joint<f64>], rounds: usize) {
    let robot = OwnedMechanism::new(joints).expect("a robot");
    let single_joints: Vec<Joint<f32>> = joints.iter().map(Joint::cast).collect();
    let single_robot = OwnedMechanism::new(&single_joints).expect("a robot");
    let values = angles(CONFIGURATIONS * joints.len());
    let single_values: Vec<f32> = values.iter().map(|&value| value as f32).collect();
    let mut expected = vec![DualQuat::IDENTITY; values.len()];
    robot.job().backend(backend()).poses(&values, &mut expected).expect("shape");
    let mut doubles = ours::doubles(backend(), robot.view(), &values);
    doubles.extend(by_hand::jobs(joints, &values, &expected));
    #[cfg(feature = "peers")]
    {
        let path = std::env::temp_dir().join(format!("dq8-mechanism-{}.urdf", std::process::id()));
        std::fs::write(&path, urdf::text(joints)).expect("a file");
        doubles.extend(k::jobs(&path, &values, &expected));
        doubles.extend(dynibo::jobs(&path, &values, &expected));
        std::fs::remove_file(&path).expect("the file");
    }
    let mut singles = ours::singles(backend(), single_robot.view(), &single_values);
    singles.extend(by_hand::jobs(joints, &single_values, &expected));

    for (number, jobs) in [("f64", doubles), ("f32", singles)] {
        for (job, nanoseconds) in least(jobs, CONFIGURATIONS, rounds) {
            println!("{name:16} {number} {job:40} {nanoseconds:8.1}");
        }
    }
}

fn main() {
    let rounds = std::env::args().nth(1).and_then(|text| text.parse().ok()).unwrap_or(60);
    println!("{}; ns per configuration", backend());
    contest("arm of 7", &robots::arm(), rounds);
    contest("humanoid of 29", &robots::humanoid(), rounds);
    for (name, is_parallel) in [("spherical wrist", false), ("three parallel", true)] {
        let (joints, values) = (robots::six(is_parallel), angles(CONFIGURATIONS * 6));
        let (double, single) = (solutions::reach::<f64>(&joints), solutions::reach::<f32>(&joints));
        let jobs = vec![
            solutions::job(backend(), &double, &values),
            solutions::job(backend(), &single, &values),
        ];
        let times = least(jobs, CONFIGURATIONS, rounds);
        for (number, (job, nanoseconds)) in ["f64", "f32"].into_iter().zip(times) {
            println!("{name:16} {number} {job:40} {nanoseconds:8.1}");
        }
    }
}

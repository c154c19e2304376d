//! Two files of poses: read, paired by their stamps, aligned and compared.

use crate::drive;
use crate::table::{Contender, Goal, Table, check};
use dq8::{DualQuat, Quat};
use dq8_fixtures::random::Random;
use dq8_trajectory::compare::{Align, Statistics, Step};
use dq8_trajectory::files;
use std::path::PathBuf;
use std::process::Command;

const POSES: usize = 20_000;

pub(crate) fn rows(table: &Table, python: &str) {
    let directory = std::env::temp_dir().join(format!("dq8-contest-{}", std::process::id()));
    std::fs::create_dir_all(&directory).expect("a directory");
    let names = ["reference.tum", "estimate.tum"].map(|name| directory.join(name));
    for (name, text) in names.iter().zip(texts()) {
        std::fs::write(name, text).expect("a file");
    }
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/figures_of_evo.py");
    let told = Command::new(python).arg(script).args(&names).output().expect("Python");
    assert!(told.status.success(), "{}", String::from_utf8_lossy(&told.stderr));
    let told = String::from_utf8(told.stdout).expect("text");
    let told: Vec<f64> =
        told.split_whitespace().map(|number| number.parse().expect("a number")).collect();

    let found = figures(&names);
    assert_eq!(found.len(), told.len() - 1);
    for (&figure, &wanted) in found.iter().zip(&told[1..]) {
        // The least error is a small difference of places a kilometre away.
        check("evo", &[wanted], &[figure], 1e-9 * figure.max(0.01));
    }
    let pass = |output: &mut Vec<f64>| *output = figures(&names);
    let own = Contender::new("dq8", Goal::None, None, Vec::new(), pass, Vec::clone);
    let job = "two files of 20,000 poses, read, paired, aligned, compared";
    let time = table.contest(job, 1, vec![own]);
    table.row(job, [time, told[0] * 1e9], "evo, CPU time", Goal::Peer(150.0));
    std::fs::remove_dir_all(&directory).expect("the directory");
}

/// The absolute errors of translations, and the relative ones of translations and rotations, after
/// alignment.
fn figures(names: &[PathBuf; 2]) -> Vec<f64> {
    let [reference, estimate] = [0, 1].map(|k| files::read(&names[k]).expect("a file").trajectory);
    let pairs = reference.pair(&estimate, 0.01).expect("pairs").align(Align::Rigid);
    let pairs = pairs.expect("no line");
    let relative = pairs.relative(Step::Frames(1)).expect("steps");
    let all = [pairs.absolute().translation(), relative.translation(), relative.rotation()];
    let numbers = |s: Statistics| [s.rmse, s.mean, s.median, s.std, s.min, s.max, s.sse];
    all.into_iter().flat_map(numbers).collect()
}

/// A drive, and what a camera on it says, which began elsewhere and is milliseconds off. In both
/// files some lines are not in order, and some stamps come twice.
fn texts() -> [String; 2] {
    let mut random = Random(9);
    let begin = random.motion(30.0);
    let [mut reference, mut estimate] = [Vec::new(), Vec::new()];
    for (index, pose) in drive(10, POSES, 0.01, 0.5).into_iter().enumerate() {
        let stamp = 1_500_000_000.0 + 0.01 * index as f64;
        reference.push(line(stamp, pose));
        let turn = Quat::from_axis_angle(random.direction(), random.between(0.001, 0.01));
        let shift = random.vector().map(|c: f64| 0.02 * c);
        let seen = begin * pose * DualQuat::from_rotation_translation(turn, shift);
        estimate.push(line(stamp + random.between(-0.003, 0.003), seen));
    }
    [reference, estimate].map(|mut lines| {
        for _ in 0..POSES / 100 {
            let place = random.below(POSES - 1);
            lines.swap(place, place + 1);
            let place = random.below(POSES - 1);
            // The stamp of its neighbour: a double.
            let stamp = lines[place].split(' ').next().expect("a stamp").to_owned();
            let (_, pose) = lines[place + 1].split_once(' ').expect("a pose");
            lines[place + 1] = format!("{stamp} {pose}");
        }
        lines.concat()
    })
}

fn line(stamp: f64, pose: DualQuat<f64>) -> String {
    let ([x, y, z], q) = (pose.translation(), pose.rotation());
    let ([a, b, c], d) = (q.xyz(), q.w());
    format!("{stamp:.6} {x:.7} {y:.7} {z:.7} {a:.9} {b:.9} {c:.9} {d:.9}\n")
}

//! Every everyday operation, one motion at a time, built as a user builds: beside nalgebra and glam
//! on the same numbers, in turns, in nanoseconds an operation.
//!
//! ```text
//! cargo run --release --manifest-path benches/everyday/Cargo.toml -- [--rounds 60] [OPERATION]...
//! ```
//!
//! Each contender runs over arrays that fit the first cache. The least time over the rounds counts:
//! whatever else a machine does only adds to it. Ratios are `dq8` over the peer.

mod job;
mod ours;
mod peer_glam;
mod peer_nalgebra;
mod poses;

use dq8_fixtures::turns::{Job, least};
use poses::Poses;
use std::process::ExitCode;

/// Rows of the table, in this order.
const OPERATIONS: [&str; 16] = [
    "product",
    "normalize",
    "nlerp",
    "sclerp",
    "point",
    "vector",
    "to matrix",
    "slerp",
    "from matrix",
    "from rigid matrix",
    "dlb of 4",
    "log",
    "exp",
    "pow",
    "inverse",
    "from rotation, translation",
];

fn main() -> ExitCode {
    let mut rounds = 60;
    let mut wanted = Vec::new();
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        if argument == "--rounds" {
            let Some(number) = arguments.next().and_then(|number| number.parse().ok()) else {
                eprintln!("--rounds needs a number");
                return ExitCode::FAILURE;
            };
            rounds = number;
        } else if OPERATIONS.contains(&argument.as_str()) {
            wanted.push(argument);
        } else {
            eprintln!("no such operation: {argument}; there are {OPERATIONS:?}");
            return ExitCode::FAILURE;
        }
    }
    println!("Built: {}.\n", env!("BUILT"));
    let poses = Poses::new();
    for (number, contenders) in [("f32", single as Lineup), ("f64", double)] {
        println!("| {number}, ns | dq8 | beside: time (ratio) |\n|---|---|---|");
        for operation in OPERATIONS {
            if wanted.is_empty() || wanted.iter().any(|name| name == operation) {
                row(operation, contenders(operation, &poses), rounds);
            }
        }
        println!();
    }
    ExitCode::SUCCESS
}

type Lineup = fn(&str, &Poses) -> Vec<Job<'static>>;

fn single(operation: &str, poses: &Poses) -> Vec<Job<'static>> {
    let mut contenders = ours::contenders::<f32>(operation, poses);
    contenders.extend(peer_nalgebra::contenders::<f32>(operation, poses));
    contenders.extend(peer_glam::single(operation, poses));
    contenders
}

fn double(operation: &str, poses: &Poses) -> Vec<Job<'static>> {
    let mut contenders = ours::contenders::<f64>(operation, poses);
    contenders.extend(peer_nalgebra::contenders::<f64>(operation, poses));
    contenders.extend(peer_glam::double(operation, poses));
    contenders
}

/// The first contender is the one that the others are beside.
fn row(operation: &str, contenders: Vec<Job<'static>>, rounds: usize) {
    let [(_, own), peers @ ..] = &least(contenders, poses::COUNT, rounds)[..] else { return };
    let peers =
        peers.iter().map(|(peer, time)| format!("{peer} {time:.2} (**{:.2}**)", own / time));
    println!("| {operation} | {own:.2} | {} |", peers.collect::<Vec<_>>().join(", "));
}

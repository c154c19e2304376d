//! dq8-trajectory beside its peers, in one run on one thread: answers are checked first, then
//! all contenders take turns, and of each the least time counts. Prints a table in Markdown.
//!
//! ```text
//! trajectory/contest/run.sh [--quick | --backend AVX2]
//! ```
//!
//! Arguments of the program: `--quick` to check answers alone; `--backend NAME` for at
//! most these lanes; `--evo PYTHON` for an interpreter that has evo.

mod lookups;
mod peers;
mod recordings;
mod scans;
mod sizes;
mod splines;
mod table;

use dq8::{Backend, DualQuat, Twist};
use dq8_fixtures::random::Random;

fn main() {
    let arguments: Vec<_> = std::env::args().skip(1).collect();
    let after = |name| arguments.iter().skip_while(move |argument| *argument != name).nth(1);
    let is_quick = arguments.iter().any(|argument| argument == "--quick");
    if let Some(name) = after("--backend") {
        let named = Backend::available().find(|backend| backend.to_string() == *name);
        Backend::limit(Some(named.expect("a backend of this machine")));
    }
    let table = table::Table::new(is_quick);
    scans::rows(&table);
    splines::rows(&table);
    lookups::rows(&table);
    if let Some(python) = after("--evo") {
        recordings::rows(&table, python);
    }
}

/// A body that goes ten metres in a second and turns by so many radians, `every` so many seconds.
fn drive(seed: u64, poses: usize, every: f64, turns: f64) -> Vec<DualQuat<f64>> {
    let mut random = Random(seed);
    let mut pose = random.motion(20.0);
    let mut next = || {
        let angular = random.direction().map(|c: f64| turns * c);
        let twist = Twist { angular, linear: [10.0, random.signed(), random.signed()] };
        pose = (pose * DualQuat::from_twist(twist.scale(every))).normalize();
        pose
    };
    (0..poses).map(|_| next()).collect()
}

/// Poses as the peers take them.
fn sevens(poses: &[DualQuat<f64>]) -> Vec<peers::Pose> {
    let seven = |pose: &DualQuat<f64>| {
        let ([x, y, z], w) = (pose.rotation().xyz(), pose.rotation().w());
        let [a, b, c] = pose.translation();
        [x, y, z, w, a, b, c]
    };
    poses.iter().map(seven).collect()
}

/// All numbers of plain records.
fn numbers<R: Copy + Into<f64>, const N: usize>(records: &[[R; N]]) -> Vec<f64> {
    records.as_flattened().iter().map(|&number| number.into()).collect()
}

/// A slice of as many things as a peer takes.
fn array<T, const N: usize>(slice: &[T]) -> &[T; N] {
    slice.try_into().expect("as many")
}

/// A slice of as many things as a peer writes.
fn array_mut<T, const N: usize>(slice: &mut [T]) -> &mut [T; N] {
    slice.try_into().expect("as many")
}

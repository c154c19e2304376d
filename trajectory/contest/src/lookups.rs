//! The question of tf2: a frame in another one, three moving edges away, at many times.

use crate::splines::{matrices, motion};
use crate::table::{Contender, Goal, Table};
use crate::{drive, sevens};
use dq8::DualQuat;
use dq8_fixtures::random::Random;
use dq8_trajectory::{Edge, Frames, OwnedTrajectory};
use transforms::Registry;
use transforms::geometry::{Quaternion, Transform, Vector3};
use transforms::time::{Stamp, Timestamp};

/// Frames, each of which moves in the one before.
const NAMES: [&str; 4] = ["map", "odometry", "base", "scanner"];
/// The poses of an edge, ten milliseconds apart.
const POSES: usize = 1000;
const LOOKUPS: usize = 10_000;

pub(crate) fn rows(table: &Table) {
    let stamps: Vec<_> = (0..POSES as u64).map(|k| 10_000_000 * k).collect();
    let paths: Vec<_> = (0..3).map(|edge| drive(5 + edge, POSES, 0.01, 1.0)).collect();
    let mut registry = Registry::new();
    let mut edges = Vec::new();
    for (names, poses) in NAMES.windows(2).zip(&paths) {
        for (&stamp, [x, y, z, w, a, b, c]) in stamps.iter().zip(sevens(poses)) {
            let (turn, shift) = (Quaternion::from_wxyz(w, x, y, z), Vector3::new(a, b, c));
            let stamp = Stamp::At(Timestamp::from_nanos(stamp));
            let transform = Transform::new(names[0], names[1], shift, turn, stamp);
            registry.add_transform(transform.expect("unit")).expect("a tree");
        }
        let seconds = stamps.iter().map(|&stamp| stamp as f64 * 1e-9).collect();
        edges.push(OwnedTrajectory::new(seconds, poses.clone()).expect("a trajectory"));
    }
    let edge = |(names, path)| -> Edge<'_> {
        let names: &[&'static str] = names;
        Edge::moving(names[1], names[0], path)
    };
    let frames = Frames::new(NAMES.windows(2).zip(&edges).map(edge)).expect("a tree");

    let mut random = Random(8);
    let last = stamps[POSES - 1] as f64;
    let mut times: Vec<_> = (0..LOOKUPS).map(|_| random.between(0.0, last) as u64).collect();
    times.sort_unstable();
    let own = Contender::new(
        "dq8",
        Goal::None,
        Some(0.0),
        vec![DualQuat::<f64>::IDENTITY; LOOKUPS],
        |poses| {
            let job = frames.job().clock(0.0, 1e-9);
            job.lookup(NAMES[0], NAMES[3], &times, poses).expect("frames");
        },
        |poses| matrices(poses.iter().copied()),
    );
    let one_at_a_time = Contender::new(
        "the crate `transforms`",
        Goal::Peer(12.0),
        // It goes along straight lines between poses.
        Some(0.02),
        vec![[f64::NAN; 7]; LOOKUPS],
        |poses| {
            for (pose, &time) in poses.iter_mut().zip(&times) {
                let time = Timestamp::from_nanos(time);
                let found = registry.get_transform(NAMES[0], NAMES[3], time).expect("frames");
                let (q, t) = (found.rotation(), found.translation());
                *pose = [q.x, q.y, q.z, q.w, t.x, t.y, t.z];
            }
        },
        |poses| matrices(poses.iter().map(|&seven| motion(seven))),
    );
    table.contest("lookups over three edges, f64", LOOKUPS, vec![own, one_at_a_time]);
}

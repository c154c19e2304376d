//! Every job over trajectories, of one precision: `super::R`. They need a heap, which boards have
//! not.

use super::R;
use super::jobs::{M, N, hash};
use crate::random::Random;
use dq8::{Backend, DualQuat, Twist};
use dq8_trajectory::covariance::carry_covariances;
use dq8_trajectory::{Basis, Edge, Frame, Frames, Outside, Spline, Trajectory};

const POSES: usize = 9;

pub(crate) fn run(k: Backend, say: &mut dyn FnMut(&str, u64)) {
    let mut random = Random::new(362_436_069);
    let poses: [DualQuat<f64>; POSES] = [(); POSES].map(|()| DualQuat::from_array(random.motion()));
    let stamps: [f64; POSES] = core::array::from_fn(|i| 0.125 * i as f64);
    // From before the first stamp until after the last one.
    let times: [R; N] = [(); N].map(|()| 0.5 + 0.75 * random.signed::<R>());
    let points: [[R; 3]; N] = [(); N].map(|()| random.numbers());
    let path = Trajectory::new(&stamps, &poses).expect("stamps rise");
    let job = path.job().backend(k).frame(Frame::At(0.3));
    let (mut to, mut twists, mut moved) = ([M::IDENTITY; N], [Twist::ZERO; N], points);
    for (outside, name) in [
        (Outside::Hold, ["sample", "sample_with_twists", "deskew", "skew"]),
        (
            Outside::Continue,
            ["sample, goes on", "sample_with_twists, goes on", "deskew, goes on", "skew, goes on"],
        ),
    ] {
        let job = job.outside(outside);
        job.sample_with_twists(&times, &mut to, &mut twists).expect("lengths fit");
        say(name[0], hash(&to));
        say(name[1], hash(&twists));
        job.deskew(&times, &points, &mut moved).expect("lengths fit");
        say(name[2], hash(&moved));
        job.skew(&times, &points, &mut moved).expect("lengths fit");
        say(name[3], hash(&moved));
    }
    job.columns(&times).deskew(&points, &mut moved).expect("one row");
    say("columns", hash(&moved));

    for (basis, names) in [
        (Basis::Smooth, ["Spline", "Spline, twists", "Spline, accelerations", "Spline, jacobians"]),
        (
            Basis::Through,
            ["Through", "Through, twists", "Through, accelerations", "Through, jacobians"],
        ),
    ] {
        let spline = Spline::new(0.0, 0.25, &poses, basis).expect("poses are finite");
        let job = spline.job().backend(k);
        let mut faster = twists;
        job.sample_with_accelerations(&times, &mut to, &mut twists, &mut faster)
            .expect("lengths fit");
        say(names[0], hash(&to));
        say(names[1], hash(&twists));
        say(names[2], hash(&faster));
        let (mut first, mut matrices) = ([0; N], [[[[0.0; 6]; 6]; 4]; N]);
        job.jacobians(&times, &mut first, &mut matrices).expect("lengths fit");
        say(names[3], hash(matrices.as_flattened().as_flattened()));
    }

    let edges = [Edge::fixed("tool", "arm", poses[1]), Edge::moving("arm", "base", path)];
    let frames = Frames::new(edges).expect("it is a tree");
    frames.job().backend(k).lookup("base", "tool", &times, &mut to).expect("they are there");
    say("lookup", hash(&to));
    let spread: [[[R; 6]; 6]; N] = core::array::from_fn(|i| {
        core::array::from_fn(|a| core::array::from_fn(|b| times[i] * (1 + a.min(b)) as R))
    });
    let mut carried = spread;
    carry_covariances(k, &to, &spread, &mut carried).expect("lengths fit");
    say("carry_covariances", hash(carried.as_flattened()));
}

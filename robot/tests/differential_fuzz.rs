//! Mechanisms and searches: the same bits for many at once, one by one, and in blocks of any width.
//!
//! `DQ8_FUZZ_SECONDS` says how long (a fifth of one by default), `DQ8_FUZZ_SEED` from where; what is found names the seed of
//! its round.

use dq8::simd::Row;
use dq8::storage::{Block, Element};
use dq8::{Backend, Crowd, DualQuat, Quat, Scalar};
use dq8_fixtures::fuzz;
use dq8_fixtures::random::{Random, bits};
use dq8_robot::ik::{Options, OwnedReach, Report};
use dq8_robot::{Goal, Joint, JointValues, OwnedMechanism};

/// Ways to compute the same numbers, and the bits of what they give.
type Entries = Vec<(&'static str, Vec<u64>)>;

/// How motions lie in memory.
type In<E> = <E as Element<8>>::Layout;

/// An ordinary number, and seldom one of any bits.
fn number<R: Scalar>(random: &mut Random) -> R {
    from(random.number(R::SINGLE, 0.01))
}

/// Unit; seldom with numbers of any bits, and half a turn from others, so that they are at right angles.
fn motion<R: Scalar>(random: &mut Random) -> DualQuat<R> {
    if random.below(8) == 0 {
        let mut axis = [R::ZERO; 3];
        axis[random.below(3)] = R::ONE;
        return DualQuat::from_rotation(Quat::from_parts(axis, R::ZERO));
    }
    let motion = random.motion(2.0).to_array();
    let hostile = random.below(16) == 0;
    DualQuat::from_array(motion.map(|of| if hostile { number(random) } else { from(of) }))
}

fn robot<R: Scalar>(random: &mut Random) -> OwnedMechanism<R> {
    let links: [_; LINKS] = core::array::from_fn(|link| {
        let (on, at) = (link.checked_sub(1), random.motion(0.5).cast());
        let axis = random.direction().map(from);
        let joint = match link {
            2 => Joint::prismatic(on, at, axis),
            _ => Joint::revolute(on, at, axis),
        };
        if link % 3 == 1 { joint.with_limits([-2.0, 2.5].map(from)) } else { joint }
    });
    OwnedMechanism::new(&links).unwrap()
}

/// As many, and as many values.
const LINKS: usize = 7;

fn link_poses<R>(random: &mut Random, backend: Backend) -> Entries
where
    [R; 4]: Row<Real = R>,
    [R; 8]: Row<Real = R>,
    R: Scalar + JointValues<In<DualQuat<R>>>,
    R: JointValues<In<Block<R, 4>>> + JointValues<In<Block<R, 8>>>,
{
    let (robot, count) = (robot::<R>(random), 1 + random.below(20));
    let values: Vec<R> = (0..count * LINKS).map(|_| number(random)).collect();
    let job = robot.job().backend(backend);
    let mut together = vec![DualQuat::IDENTITY; count * LINKS];
    job.poses(&values, &mut together).unwrap();
    let mut alone = together.clone();
    let each = values.chunks(LINKS).zip(alone.chunks_mut(LINKS));
    each.for_each(|(values, poses)| job.poses(values, poses).unwrap());
    let (mut four, mut eight) =
        (Crowd::<R, 4>::new(LINKS, count), Crowd::<R, 8>::new(LINKS, count));
    job.poses(&values, four.blocks_mut()).unwrap();
    job.poses(&values, eight.blocks_mut()).unwrap();
    vec![
        ("together", of_motions(&together)),
        ("one by one", of_motions(&alone)),
        ("blocks of 4", of_motions(&four.to_vec())),
        ("blocks of 8", of_motions(&eight.to_vec())),
    ]
}

fn reach<R: Scalar>(random: &mut Random, backend: Backend) -> Entries {
    let (robot, count) = (robot::<R>(random), 1 + random.below(20));
    let target = |_| {
        let pose = robot.link_pose(&random.vector::<LINKS>().map(|of| from(2.0 * of)), LINKS - 1);
        if random.below(8) == 0 { motion(random) } else { pose.unwrap() }
    };
    let targets: Vec<_> = (0..count).map(target).collect();
    let start: Vec<R> = (0..count * LINKS).map(|_| number(random)).collect();
    let options = Options { restarts: random.below(2) == 0, ..Options::default() };
    let reach = OwnedReach::new(robot, [Goal::pose(LINKS - 1)]).unwrap();
    let search = |targets: &[DualQuat<R>], values: &mut [R]| {
        let mut reports = vec![Report::default(); targets.len()];
        reach.job().backend(backend).solve(targets, values, &mut reports, &options).unwrap();
    };
    let (mut together, mut alone) = (start.clone(), start);
    search(&targets, &mut together);
    for (target, values) in targets.chunks(1).zip(alone.chunks_mut(LINKS)) {
        search(target, values);
    }
    vec![("together", of_numbers(&together)), ("one by one", of_numbers(&alone))]
}

/// All entries have the same bits with each of the machine's backends, and with all that fuse nothing.
fn round<R>(seed: u64) -> u64
where
    [R; 4]: Row<Real = R>,
    [R; 8]: Row<Real = R>,
    R: Scalar + JointValues<In<DualQuat<R>>>,
    R: JointValues<In<Block<R, 4>>> + JointValues<In<Block<R, 8>>>,
{
    let mut unfused: Option<Vec<Vec<u64>>> = None;
    for backend in backends() {
        // The same numbers for each.
        let mut random = fuzz::random(seed);
        let jobs = [
            ("poses", link_poses::<R>(&mut random, backend)),
            ("reach", reach::<R>(&mut random, backend)),
        ];
        for (job, entries) in &jobs {
            let (first, wanted) = &entries[0];
            for (entry, got) in &entries[1..] {
                let what = format!("seed {seed}: {job}, {backend}, {entry} and {first}");
                assert_eq!(got.len(), wanted.len(), "{what}");
                let other = got.iter().zip(wanted).position(|(got, wanted)| got != wanted);
                assert_eq!(other, None, "{what}");
            }
        }
        if !fuses(backend) {
            let all: Vec<_> = jobs.into_iter().map(|(_, mut all)| all.swap_remove(0).1).collect();
            let first = unfused.get_or_insert_with(|| all.clone());
            assert!(all == *first, "seed {seed}: {backend} has other bits than other lanes");
        }
    }
    2
}

/// With the feature `reproducible`, lanes that fuse nothing too.
fn backends() -> impl Iterator<Item = Backend> {
    #[cfg(feature = "reproducible")]
    return Backend::available().chain([Backend::reproducible()]);
    #[cfg(not(feature = "reproducible"))]
    Backend::available()
}

fn fuses(backend: Backend) -> bool {
    let portable = cfg!(any(target_arch = "aarch64", target_feature = "fma"));
    let unfused = backend.to_string().ends_with("unfused");
    !unfused && (portable || backend != Backend::PORTABLE)
}

fn from<R: Scalar>(number: f64) -> R {
    <R as dq8::Real>::from_f64(number)
}

fn of_numbers<R: Scalar>(numbers: &[R]) -> Vec<u64> {
    numbers.iter().map(|&number| bits(number.into())).collect()
}

fn of_motions<R: Scalar>(motions: &[DualQuat<R>]) -> Vec<u64> {
    motions.iter().flat_map(|motion| motion.to_array()).map(|number| bits(number.into())).collect()
}

#[test]
fn poses_and_searches_in_f32_have_the_same_bits_in_every_layout() {
    fuzz::rounds(round::<f32>);
}

#[test]
fn poses_and_searches_in_f64_have_the_same_bits_in_every_layout() {
    fuzz::rounds(round::<f64>);
}

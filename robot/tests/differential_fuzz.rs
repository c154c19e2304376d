//! Mechanisms and searches: the same bits for many at once, split, one by one, and in blocks of any
//! width.
//!
//! `DQ8_FUZZ_SECONDS` says how long (a fifth of one by default), `DQ8_FUZZ_SEED` from where; what
//! is found names the seed of its round.

use dq8::simd::Row;
use dq8::storage::{Block, Element};
use dq8::{Backend, Crowd, DualQuat, Scalar, Twist};
use dq8_fixtures::fusing::fuses;
use dq8_fixtures::fuzz;
use dq8_fixtures::random::{Random, bits};
use dq8_robot::ik::{Options, OwnedReach, Report, SixAxisArm, Solutions, Tracking};
use dq8_robot::{Goal, Joint, JointValues, OwnedMechanism, World};
use std::iter::once;
use std::ops::Range;

/// Ways to compute the same numbers, and the bits of what they give.
type Entries = Vec<(&'static str, Vec<u64>)>;

/// How motions lie in memory.
type In<E> = <E as Element<8>>::Layout;

/// An ordinary number, and seldom one of any bits.
fn number<R: Scalar>(random: &mut Random) -> R {
    from(random.number(R::SINGLE, 0.01))
}

/// Unit; seldom with numbers of any bits. One in three turns about a coordinate axis, as placements
/// do, so that motions are at right angles, and has zeros of both signs.
fn motion<R: Scalar>(random: &mut Random) -> DualQuat<R> {
    if random.below(3) == 0 {
        return random.turned();
    }
    let motion = random.motion(2.0).to_array();
    let hostile = random.below(16) == 0;
    DualQuat::from_array(motion.map(|of| if hostile { number(random) } else { from(of) }))
}

/// Where a joint is, and its axis: as drawings have it, or any.
fn place<R: Scalar>(random: &mut Random) -> (DualQuat<R>, [R; 3]) {
    if random.below(2) == 0 {
        return (random.motion(0.5).cast(), random.direction().map(from));
    }
    let (at, along) = (random.turned(), random.below(3));
    (at, core::array::from_fn(|i| if i == along { R::ONE } else { -R::ZERO }))
}

/// One value for each link.
fn robot<R: Scalar>(random: &mut Random) -> OwnedMechanism<R> {
    let links: [_; LINKS] = core::array::from_fn(|link| {
        let (on, (at, axis)) = (link.checked_sub(1), place(random));
        let joint = match link {
            2 => Joint::prismatic(on, at, axis),
            _ => Joint::revolute(on, at, axis),
        };
        if link % 3 == 1 { joint.with_limits([-2.0, 2.5].map(from)) } else { joint }
    });
    OwnedMechanism::new(&links).unwrap()
}

/// Joints of all kinds, in a tree.
fn tree<R: Scalar>(random: &mut Random) -> OwnedMechanism<R> {
    let mut links = Vec::new();
    for link in 0..1 + random.below(20) {
        let on = (link > 0 && random.below(8) > 0).then(|| random.below(link));
        let (at, axis) = place(random);
        links.push(match random.below(9) {
            0 => Joint::fixed(on, at),
            1 => Joint::screw(on, at, axis, from(0.1)),
            2 => Joint::planar(on, at, axis),
            3 => Joint::floating(on, at),
            4 | 5 => Joint::prismatic(on, at, axis),
            _ => Joint::revolute(on, at, axis),
        });
    }
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

/// Configurations of a tree, and how they move.
struct Moving<R> {
    robot: OwnedMechanism<R>,
    backend: Backend,
    count: usize,
    values: Vec<R>,
    rates: Vec<R>,
    points: [(usize, [R; 3]); 2],
    ends: [usize; 2],
}

/// Poses, velocities and accelerations of links, poses and Jacobians of two of them, and places of
/// points.
type Moved = [Vec<u64>; 6];

impl<R: Scalar> Moving<R> {
    fn new(random: &mut Random, backend: Backend) -> Self {
        let (robot, count) = (tree::<R>(random), 1 + random.below(33));
        let (links, values, rates) = {
            let view = robot.view();
            (view.links(), view.values(), view.rates())
        };
        let mut numbers = |each: usize| (0..count * each).map(|_| number(random)).collect();
        let (values, rates) = (numbers(values), numbers(rates));
        let points = [(); 2].map(|()| (random.below(links), [(); 3].map(|()| number(random))));
        let ends = [(); 2].map(|()| random.below(links));
        Self { robot, backend, count, values, rates, points, ends }
    }

    /// Configurations in plain slices, on so many threads where there are any.
    fn plain(&self, values: &[R], rates: &[R], count: usize, threads: usize) -> Moved
    where
        R: JointValues<In<DualQuat<R>>>,
    {
        let (links, each) = (self.robot.view().links(), self.robot.view().rates());
        let mut poses = vec![DualQuat::IDENTITY; count * links];
        let mut ends = vec![DualQuat::IDENTITY; count * 2];
        let mut twists = vec![[R::ZERO; 6]; count * links];
        let mut second = twists.clone();
        let mut columns = vec![[R::ZERO; 6]; count * 2 * each];
        let mut places = vec![[R::ZERO; 3]; count * 2];
        let job = self.robot.job().backend(self.backend);
        #[cfg(feature = "rayon")]
        let job = job.threads(threads);
        #[cfg(not(feature = "rayon"))]
        let _ = threads;
        job.accelerations(values, rates, rates, &mut poses, &mut twists, &mut second).unwrap();
        job.points(&self.points, values, &mut places).unwrap();
        job.links(&self.ends).jacobians(World, values, &mut ends, &mut columns).unwrap();
        [
            of_motions(&poses),
            of_numbers(twists.as_flattened()),
            of_numbers(second.as_flattened()),
            of_motions(&ends),
            of_numbers(columns.as_flattened()),
            of_numbers(places.as_flattened()),
        ]
    }

    /// Part after part.
    fn parts(&self, parts: impl IntoIterator<Item = Range<usize>>) -> Vec<u64>
    where
        R: JointValues<In<DualQuat<R>>>,
    {
        let mut all = Moved::default();
        for range in parts {
            let count = range.len();
            let of = |numbers: &[R]| {
                let each = numbers.len() / self.count;
                numbers[range.start * each..range.end * each].to_vec()
            };
            let part = self.plain(&of(&self.values), &of(&self.rates), count, 1);
            all.iter_mut().zip(part).for_each(|(all, part)| all.extend(part));
        }
        all.concat()
    }

    /// All again and again, as many as more than one thread takes; threads may part in the midst of
    /// a turn.
    #[cfg(feature = "rayon")]
    fn on_threads(&self) -> Vec<u64>
    where
        R: JointValues<In<DualQuat<R>>>,
    {
        let times = 6000_usize.div_ceil(self.count * self.robot.view().links());
        let (values, rates) = (self.values.repeat(times), self.rates.repeat(times));
        let all = self.plain(&values, &rates, times * self.count, 3);
        all.map(|all| {
            let length = all.len() / times;
            let turn = |turn: usize| &all[turn * length..(turn + 1) * length];
            // An odd one shows itself in place of the first.
            let odd = (1..times).find(|&other| turn(other) != turn(0));
            turn(odd.unwrap_or(0)).to_vec()
        })
        .concat()
    }

    fn in_blocks<const N: usize>(&self) -> Vec<u64>
    where
        [R; N]: Row<Real = R>,
        R: JointValues<In<Block<R, N>>>,
    {
        let (view, count) = (self.robot.view(), self.count);
        let (links, each) = (view.links(), view.rates());
        let mut poses = Crowd::<R, N>::new(links, count);
        let mut ends = Crowd::<R, N>::new(2, count);
        let mut twists = Crowd::<R, N, 6>::new(links, count);
        let mut second = twists.clone();
        let mut columns = Crowd::<R, N, 6>::new(2 * each, count);
        let mut places = Crowd::<R, N, 3>::new(2, count);
        let (values, rates) = (&self.values[..], &self.rates[..]);
        let job = self.robot.job().backend(self.backend);
        let (to, of, more) = (poses.blocks_mut(), twists.blocks_mut(), second.blocks_mut());
        job.accelerations(values, rates, rates, to, of, more).unwrap();
        job.points(&self.points, values, places.blocks_mut()).unwrap();
        let (to, of) = (ends.blocks_mut(), columns.blocks_mut());
        job.links(&self.ends).jacobians(World, values, to, of).unwrap();
        let six = |crowd: &Crowd<R, N, 6>| {
            let mut plain = vec![[R::ZERO; 6]; crowd.joints() * count];
            crowd.copy_to_slice(&mut plain).unwrap();
            of_numbers(plain.as_flattened())
        };
        let mut found = vec![[R::ZERO; 3]; 2 * count];
        places.copy_to_slice(&mut found).unwrap();
        [
            of_motions(&poses.to_vec()),
            six(&twists),
            six(&second),
            of_motions(&ends.to_vec()),
            six(&columns),
            of_numbers(found.as_flattened()),
        ]
        .concat()
    }
}

fn moving<R, const W: usize>(random: &mut Random, backend: Backend) -> Entries
where
    [R; 4]: Row<Real = R>,
    [R; 8]: Row<Real = R>,
    [R; W]: Row<Real = R>,
    R: Scalar + JointValues<In<DualQuat<R>>> + JointValues<In<Block<R, W>>>,
    R: JointValues<In<Block<R, 4>>> + JointValues<In<Block<R, 8>>>,
{
    let moving = Moving::<R>::new(random, backend);
    let (count, split) = (moving.count, random.below(moving.count + 1));
    let entries = vec![
        ("together", moving.parts(once(0..count))),
        ("split", moving.parts([0..split, split..count])),
        ("one by one", moving.parts((0..count).map(|i| i..i + 1))),
        ("blocks of 4", moving.in_blocks::<4>()),
        ("blocks of 8", moving.in_blocks::<8>()),
        ("blocks of another width", moving.in_blocks::<W>()),
    ];
    // Seldom: it takes many of them.
    #[cfg(feature = "rayon")]
    let entries = match random.below(8) {
        0 => [entries, vec![("three threads", moving.on_threads())]].concat(),
        _ => entries,
    };
    entries
}

/// Rates of many and of each, and two clips at once and each.
fn followed<R: Scalar>(random: &mut Random, backend: Backend) -> Entries {
    let (robot, clips) = (robot::<R>(random), [(); 2].map(|()| 1 + random.below(5)));
    let count = clips[0] + clips[1];
    let mut values: Vec<R> = (0..count * LINKS).map(|_| from(random.signed())).collect();
    let target = |values| robot.link_pose(values, LINKS - 1).unwrap();
    let targets: Vec<_> = values.chunks(LINKS).map(target).collect();
    values.iter_mut().for_each(|value| *value = from(random.one_of(&[0.0, -0.0, 0.1, -0.1])));
    let mut twist =
        || Twist { angular: [(); 3].map(|()| from(random.signed())), linear: [-R::ZERO; 3] };
    let twists: Vec<_> = (0..count).map(|_| twist()).collect();
    let reach = OwnedReach::new(robot, [Goal::pose(LINKS - 1)]).unwrap();
    let (job, options) = (reach.job().backend(backend), Tracking::default());
    let mut scratch = vec![R::ZERO; reach.view().batch_scratch_len()];
    let mut follow = |clips: &[&[usize]]| {
        let (mut values, mut rates) = (values.clone(), values.clone());
        let mut first = 0;
        for clips in clips {
            let end = first + clips.iter().sum::<usize>();
            let (targets, twists) = (&targets[first..end], &twists[first..end]);
            let all = first * LINKS..end * LINKS;
            let (values, rates) = (&mut values[all.clone()], &mut rates[all]);
            job.rates_in(&mut scratch, values, twists, from(0.1), rates).unwrap();
            let mut reports = vec![Report::default(); end - first];
            job.sequence(clips, targets, values, &mut reports, &options).unwrap();
            first = end;
        }
        [of_numbers(&values), of_numbers(&rates)].concat()
    };
    let [first, second] = [&clips[..1], &clips[1..]];
    vec![("together", follow(&[&clips])), ("one by one", follow(&[first, second]))]
}

/// Everything that six axes can do, for many targets and for each.
fn solutions<R: Scalar>(random: &mut Random, backend: Backend) -> Entries {
    let (x, y, z) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
    let axes = [z, y, y, x, y, x];
    let ways = [[0.0; 3], [0.3, 0.0, 0.7], [0.0, 0.0, 1.1], [1.2, 0.0, 0.2], [0.0; 3], [0.0; 3]];
    let joints: [_; 6] = core::array::from_fn(|link| {
        let at = DualQuat::from_translation(ways[link].map(from));
        Joint::revolute(link.checked_sub(1), at, axes[link].map(from))
    });
    let robot = OwnedMechanism::<R>::new(&joints).unwrap();
    let count = 1 + random.below(20);
    // Quarter turns and zeros of both signs, where branches meet, and any others.
    let quarter = core::f64::consts::FRAC_PI_2;
    let mut value = || match random.below(2) {
        0 => from(random.one_of(&[0.0, -0.0, quarter, -quarter])),
        _ => from(3.0 * random.signed()),
    };
    let starts: Vec<[R; 6]> = (0..count).map(|_| [(); 6].map(|()| value())).collect();
    let targets: Vec<_> = starts.iter().map(|values| robot.link_pose(values, 5).unwrap()).collect();
    let reach = OwnedReach::new(robot, [Goal::pose(5)]).unwrap();
    let six = SixAxisArm::new(reach.view()).unwrap();
    let search = |size: usize| {
        let mut found = vec![Solutions::default(); count];
        let each = targets.chunks(size).zip(starts.chunks(size)).zip(found.chunks_mut(size));
        for ((targets, starts), found) in each {
            six.job().backend(backend).solutions(targets, starts, found).unwrap();
        }
        let values = found.iter().flat_map(|found| found.iter()).flat_map(|found| found.values);
        of_numbers(&values.collect::<Vec<_>>())
    };
    vec![("together", search(count)), ("one by one", search(1)), ("three at a time", search(3))]
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

/// All entries have the same bits with each of the machine's backends, and with all that fuse
/// nothing.
fn round<R, const W: usize>(seed: u64) -> u64
where
    [R; 4]: Row<Real = R>,
    [R; 8]: Row<Real = R>,
    [R; W]: Row<Real = R>,
    R: Scalar + JointValues<In<DualQuat<R>>> + JointValues<In<Block<R, W>>>,
    R: JointValues<In<Block<R, 4>>> + JointValues<In<Block<R, 8>>>,
{
    let mut unfused: Option<Vec<Vec<u64>>> = None;
    for backend in backends() {
        // The same numbers for each.
        let mut random = fuzz::random(seed);
        let jobs = [
            ("poses", link_poses::<R>(&mut random, backend)),
            ("reach", reach::<R>(&mut random, backend)),
            ("moving", moving::<R, W>(&mut random, backend)),
            ("followed", followed::<R>(&mut random, backend)),
            ("solutions", solutions::<R>(&mut random, backend)),
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
    5
}

/// With the feature `reproducible`, each without fused instructions too.
fn backends() -> impl Iterator<Item = Backend> {
    #[cfg(feature = "reproducible")]
    return Backend::available().flat_map(|backend| [backend, backend.unfused()]);
    #[cfg(not(feature = "reproducible"))]
    Backend::available()
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
    fuzz::rounds(round::<f32, 16>);
}

#[test]
fn poses_and_searches_in_f64_have_the_same_bits_in_every_layout() {
    fuzz::rounds(round::<f64, 2>);
}

//! Everything that is asked of a mechanism: on the lanes of every backend, in every layout and
//! precision, of any number of configurations, on any number of threads, it is what one
//! configuration gives; and that, what the book does.

use crate::tree::{mechanism, tree, values};
use dq8::simd::Row;
use dq8::storage::{AoSoA, Aos, Block, Element, Layout, LinearFirst, pack};
use dq8::{Backend, DualQuat, Real, Scalar, Twist};
use dq8_fixtures::random::Random;
use dq8_fixtures::textbook::Textbook;
use dq8_robot::{Body, Job, Joint, JointValues, Mechanism, World, WorldAligned};

/// What of rounding is left in poses, relative to where they are, in numbers of twists, and in
/// places: up to 64 products one after the other, moments about links that are some lengths away,
/// points as far.
const DOUBLE: [f64; 3] = [2e-14, 1e-13, 1e-13];
const SINGLE: [f64; 3] = [1e-5, 1e-4, 1e-4];

/// A mechanism, which links of it and points on it are asked for, and of how many configurations.
pub(super) struct Scene<'a, R> {
    robot: Mechanism<'a, R>,
    links: Vec<usize>,
    points: Vec<(usize, [R; 3])>,
    count: usize,
}

impl<'a, R: Real> Scene<'a, R> {
    /// One of the links twice; points in the order of their links, or in none.
    pub(super) fn new(robot: Mechanism<'a, R>, count: usize) -> Self {
        let last = robot.links() - 1;
        let mut random = Random(last as u64);
        let mut points: Vec<_> = (0..1 + random.below(3 * last + 3))
            .map(|_| (random.below(last + 1), random.vector().map(R::from_f64)))
            .collect();
        if !count.is_multiple_of(3) {
            points.sort_by_key(|(link, _)| *link);
        }
        Self { robot, links: vec![last, last / 2, 0, last], points, count }
    }
}

/// An answer: what it is, how many numbers a thing has, and the numbers,
/// `[configuration][thing][number]`.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Answer {
    pub(super) what: &'static str,
    pub(super) width: usize,
    pub(super) numbers: Vec<f64>,
}

fn answer<E: Element<C>, const C: usize>(what: &'static str, all: &[E], count: usize) -> Answer {
    let things = E::Layout::THINGS;
    let each = all.len() / count.div_ceil(things);
    let thing = |index: usize| {
        let (configuration, thing) = (index / each, index % each);
        let at = (configuration / things * each + thing) * things + configuration % things;
        E::get(all, at).expect("a thing").map(Into::into)
    };
    Answer { what, width: C, numbers: (0..count * each).flat_map(thing).collect() }
}

/// All that a job computes.
pub(super) fn on_lanes<R, T, E, C, P>(
    scene: &Scene<'_, R>,
    job: Job<'_, R>,
    [values, rates, second]: [&[T]; 3],
    (pose, twist, place): (E, C, P),
) -> Vec<Answer>
where
    R: Scalar,
    T: JointValues<E::Layout>,
    E: Element<8, Layout: Layout<Real = R>>,
    C: Element<6, Layout = E::Layout>,
    P: Element<3, Layout = E::Layout>,
{
    let Scene { robot, links, points, count } = scene;
    let elements = count.div_ceil(E::Layout::THINGS);
    let mut poses = vec![pose; elements * robot.links()];
    let mut chosen = vec![pose; elements * links.len()];
    let mut twists = vec![twist; elements * robot.links()];
    let (mut accelerations, mut all) = (twists.clone(), Vec::new());
    job.poses(values, &mut poses).unwrap();
    all.push(answer("poses", &poses, *count));
    job.links(links).poses(values, &mut chosen).unwrap();
    all.push(answer("chosen", &chosen, *count));
    job.velocities(values, rates, &mut poses, &mut twists).unwrap();
    all.push(answer("velocities", &twists, *count));
    job.accelerations(values, rates, second, &mut poses, &mut twists, &mut accelerations).unwrap();
    all.push(answer("poses", &poses, *count));
    all.push(answer("velocities", &twists, *count));
    all.push(answer("accelerations", &accelerations, *count));
    let mut places = vec![place; elements * points.len()];
    job.points(points, values, &mut places).unwrap();
    all.push(answer("places", &places, *count));
    let mut columns = vec![twist; elements * links.len() * robot.rates()];
    macro_rules! jacobians {
        ($($what:literal $frame:expr),*) => {$(
            job.links(links).jacobians($frame, values, &mut chosen, &mut columns).unwrap();
            all.push(answer("chosen", &chosen, *count));
            all.push(answer($what, &columns, *count));
        )*};
    }
    jacobians! { "world" World, "body" Body, "aligned" WorldAligned }
    all
}

/// The same by the methods for one configuration.
pub(super) fn alone<R: Real>(
    scene: &Scene<'_, R>,
    [values, rates, second]: [&[R]; 3],
) -> Vec<Answer> {
    let Scene { robot, links, points, count } = scene;
    let mut all: Vec<Answer> = Vec::new();
    for at in 0..*count {
        let values = &values[at * robot.values()..][..robot.values()];
        let [rates, second] = [rates, second].map(|of| &of[at * robot.rates()..][..robot.rates()]);
        let mut poses = vec![DualQuat::IDENTITY; robot.links()];
        let mut twists = vec![Twist::from_array([R::ZERO; 6]); robot.links()];
        let (mut changes, mut one) = (twists.clone(), Vec::new());
        let flat = |what, width, numbers: Vec<R>| {
            let numbers = numbers.into_iter().map(Into::into).collect();
            Answer { what, width, numbers }
        };
        let motions = |what, all: &[DualQuat<R>]| {
            flat(what, 8, all.iter().flat_map(|pose| pose.to_array()).collect())
        };
        let speeds = |what, all: &[Twist<R>]| {
            flat(what, 6, all.iter().flat_map(|twist| twist.to_array()).collect())
        };
        robot.link_poses(values, &mut poses).unwrap();
        one.push(motions("poses", &poses));
        let chosen: Vec<_> =
            links.iter().map(|&link| robot.link_pose(values, link).unwrap()).collect();
        one.push(motions("chosen", &chosen));
        robot.link_velocities(values, rates, &mut poses, &mut twists).unwrap();
        one.push(speeds("velocities", &twists));
        robot
            .link_accelerations(values, rates, second, &mut poses, &mut twists, &mut changes)
            .unwrap();
        one.push(motions("poses", &poses));
        one.push(speeds("velocities", &twists));
        one.push(speeds("accelerations", &changes));
        let mut places = vec![[R::NAN; 3]; points.len()];
        robot.link_points(values, points, &mut places).unwrap();
        one.push(flat("places", 3, places.concat()));
        macro_rules! jacobians {
            ($($what:literal $frame:expr),*) => {$(
                let mut columns = vec![Twist::from_array([R::NAN; 6]); links.len() * robot.rates()];
                let each = links.iter().zip(columns.chunks_exact_mut(robot.rates().max(1)));
                let chosen: Vec<_> = each
                    .map(|(&link, columns)| {
                        robot.link_jacobian($frame, values, link, columns).unwrap()
                    })
                    .collect();
                one.push(motions("chosen", &chosen));
                one.push(speeds($what, &columns));
            )*};
        }
        jacobians! { "world" World, "body" Body, "aligned" WorldAligned }
        if all.is_empty() {
            all = one;
        } else {
            all.iter_mut().zip(one).for_each(|(all, one)| all.numbers.extend(one.numbers));
        }
    }
    all
}

/// Numbers are the same to rounding, the signs of poses too: neighbours may be blended.
#[track_caller]
fn close(found: &[Answer], wanted: &[Answer], bounds: [f64; 3], what: &str) {
    for (found, wanted) in found.iter().zip(wanted) {
        assert_eq!(found.numbers.len(), wanted.numbers.len(), "{what}");
        let things = found.numbers.chunks(found.width).zip(wanted.numbers.chunks(found.width));
        for (found_of, wanted_of) in things {
            let dual = wanted_of.iter().skip(4).map(|c| c * c).sum::<f64>().sqrt();
            for (a, b) in found_of.iter().zip(wanted_of) {
                let bound = match found.width {
                    8 => bounds[0] * (1.0 + dual),
                    6 => bounds[1] * (1.0 + b.abs()),
                    _ => bounds[2],
                };
                let name = found.what;
                assert!((a - b).abs() <= bound, "{what}: {name}: {found_of:?} {wanted_of:?}");
            }
        }
    }
}

/// The same of values and rates in columns.
fn of_columns<R, E, C, P>(
    scene: &Scene<'_, R>,
    job: Job<'_, R>,
    inputs: [&[R]; 3],
    empty: (E, C, P),
) -> Vec<Answer>
where
    R: Scalar,
    E: Element<8, Layout: Layout<Real = R>>,
    C: Element<6, Layout = E::Layout>,
    P: Element<3, Layout = E::Layout>,
{
    let robot = scene.robot;
    let columns = |(numbers, each): (&[R], usize)| -> Vec<Vec<R>> {
        (0..each).map(|index| numbers.iter().skip(index).step_by(each).copied().collect()).collect()
    };
    let [values, rates, second] = inputs;
    let all = [(values, robot.values()), (rates, robot.rates()), (second, robot.rates())];
    let columns = all.map(columns);
    let slices = columns.each_ref().map(|all| all.iter().map(|it| &it[..]).collect::<Vec<_>>());
    on_lanes(scene, job, slices.each_ref().map(|all| &all[..]), empty)
}

/// The same in blocks of `N`: with plain values, in rows and in columns, and with values in blocks.
fn in_blocks<R, const N: usize>(
    scene: &Scene<'_, R>,
    job: Job<'_, R>,
    inputs: [&[R]; 3],
) -> [Vec<Answer>; 3]
where
    R: Scalar + JointValues<AoSoA<[R; N]>> + Element<1, Layout = Aos<R>>,
    [R; N]: Row<Real = R>,
{
    let robot = scene.robot;
    let nine = <R as Real>::from_f64(9.0);
    let empty = (
        Block::<R, N, 8>::splat([nine; 8]),
        Block::<R, N, 6>::splat([nine; 6]),
        Block::<R, N, 3>::splat([nine; 3]),
    );
    let counts = [robot.values(), robot.rates(), robot.rates()];
    let packed = [0, 1, 2].map(|which| {
        let blocks = scene.count.div_ceil(N) * counts[which];
        let mut packed = vec![Block::<R, N, 1>::splat([R::ZERO]); blocks];
        pack(counts[which], inputs[which], &mut packed).unwrap();
        packed
    });
    let given = packed.each_ref().map(|packed| &packed[..]);
    [
        on_lanes(scene, job, inputs, empty),
        of_columns(scene, job, inputs, empty),
        on_lanes(scene, job, given, empty),
    ]
}

/// Values and two sets of rates of so many configurations.
pub(super) fn drawn(
    random: &mut Random,
    joints: &[Joint<f64>],
    rates: usize,
    count: usize,
) -> [Vec<f64>; 3] {
    let values = (0..count).flat_map(|_| values(random, joints)).collect();
    let mut rates = || (0..count * rates).map(|_| random.signed()).collect();
    [values, rates(), rates()]
}

pub(super) fn cast<R: Real>(numbers: &[Vec<f64>; 3]) -> [Vec<R>; 3] {
    numbers.each_ref().map(|all| all.iter().map(|&number| R::from_f64(number)).collect())
}

pub(super) fn slices<R>(numbers: &[Vec<R>; 3]) -> [&[R]; 3] {
    numbers.each_ref().map(|all| &all[..])
}

pub(super) fn plain<R: Real>() -> (DualQuat<R>, [R; 6], [R; 3]) {
    (DualQuat::IDENTITY, [R::NAN; 6], [R::NAN; 3])
}

#[test]
fn every_job_computes_what_one_configuration_does_and_that_what_the_book_does() {
    let mut random = Random(5);
    for links in (1..18).chain([23, 64]) {
        let joints = tree(&mut random, links);
        let (double, single) = (mechanism::<f64>(&joints), mechanism::<f32>(&joints));
        let by_the_book = mechanism::<Textbook<f64>>(&joints);
        let count = [1, 2, 3, 4, 7, 8, 9, 16, 33][links % 9];
        let (robot, rates) = (double.view(), double.view().rates());
        if robot.values() == 0 {
            continue;
        }
        let numbers = drawn(&mut random, &joints, rates, count);
        let (inputs, floats) = (slices(&numbers), cast::<f32>(&numbers));
        let floats = slices(&floats);
        let book = alone(&Scene::new(by_the_book.view(), count), slices(&cast(&numbers)));
        let (scene, narrow) = (Scene::new(robot, count), Scene::new(single.view(), count));
        close(&alone(&scene, inputs), &book, DOUBLE, "alone");
        close(&alone(&narrow, floats), &book, SINGLE, "alone, in f32");
        for backend in Backend::available() {
            let what = format!("{backend}, {links} joints, {count} configurations");
            let job = robot.job().backend(backend);
            let found = on_lanes(&scene, job, inputs, plain());
            close(&found, &book, DOUBLE, &what);
            // What is asked together is what is asked alone.
            for (one, other) in [(0, 3), (2, 4), (1, 7), (1, 9), (1, 11)] {
                assert_eq!(found[one], found[other], "{what}");
            }
            let of_links = |all: &[f64]| {
                scene
                    .links
                    .iter()
                    .flat_map(|&link| &all[8 * link..][..8])
                    .copied()
                    .collect::<Vec<_>>()
            };
            let chosen = found[0].numbers.chunks(8 * robot.links()).flat_map(of_links);
            assert!(chosen.eq(found[1].numbers.iter().copied()), "{what}, chosen among all");
            for (index, &link) in scene.links.iter().enumerate() {
                let own = Scene { links: vec![link], points: scene.points.clone(), ..scene };
                for (all, own) in found.iter().zip(on_lanes(&own, job, inputs, plain())) {
                    let each = own.numbers.len() / count;
                    if ["chosen", "world", "body", "aligned"].contains(&all.what) {
                        let part = all.numbers.chunks(each.max(1)).skip(index).step_by(4);
                        assert!(part.eq(own.numbers.chunks(each.max(1))), "{what}: {index}");
                    }
                }
            }
            if links > 17 {
                continue;
            }
            let (pose, _, place) = plain();
            let named = on_lanes(&scene, job, inputs, (pose, Twist::ZERO, place));
            assert_eq!(named, found, "{what}, twists");
            let turned = (pose, LinearFirst([9.0; 6]), place);
            assert_eq!(on_lanes(&scene, job, inputs, turned), found, "{what}, linear part first");
            assert_eq!(of_columns(&scene, job, inputs, plain()), found, "{what}, columns");
            let blocks = in_blocks::<f64, 8>(&scene, job, inputs).into_iter();
            let mut blocks = blocks.chain(in_blocks::<f64, 4>(&scene, job, inputs));
            assert!(blocks.all(|other| other == found), "{what}, blocks");
            let job = single.job().backend(backend);
            let rounded = on_lanes(&narrow, job, floats, plain());
            close(&rounded, &book, SINGLE, &format!("{what}, in f32"));
            assert_eq!(
                of_columns(&narrow, job, floats, plain()),
                rounded,
                "{what}, columns of f32"
            );
            let blocks = in_blocks::<f32, 16>(&narrow, job, floats).into_iter();
            let mut blocks = blocks.chain(in_blocks::<f32, 8>(&narrow, job, floats));
            assert!(blocks.all(|other| other == rounded), "{what}, blocks of f32");
        }
    }
}

#[cfg(feature = "rayon")]
#[test]
fn all_cores_give_every_bit_of_what_one_gives_and_refuse_what_one_refuses() {
    let mut random = Random(10);
    // Some tasks each; the last has some in blocks too.
    for (links, count) in [(1, 2100), (7, 350), (130, 140)] {
        let joints = tree(&mut random, links);
        let owned = mechanism::<f64>(&joints);
        let scene = Scene::new(owned.view(), count);
        let numbers = drawn(&mut random, &joints, scene.robot.rates(), count);
        let [one, all] = [1, usize::MAX].map(|threads| owned.job().threads(threads));
        let inputs = slices(&numbers);
        let wanted = on_lanes(&scene, one, inputs, plain());
        assert!(on_lanes(&scene, all, inputs, plain()) == wanted);
        assert!(of_columns(&scene, all, inputs, plain()) == wanted);
        assert!(in_blocks::<f64, 8>(&scene, all, inputs).iter().all(|found| *found == wanted));
        let mut poses = vec![DualQuat::IDENTITY; count * links];
        let [values, rates, _] = inputs;
        for (fewer, rates) in [(links, rates), (0, &rates[1..])] {
            let mut twists = vec![[7.0; 6]; count * links - fewer];
            assert!(all.velocities(values, rates, &mut poses[fewer..], &mut twists).is_err());
            assert!(twists.iter().all(|twist| *twist == [7.0; 6]), "{links}, refused");
        }
    }
}

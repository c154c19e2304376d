//! Mechanisms and searches: the same bits for many at once, one by one, and in blocks of any width.
//!
//! `DQ8_FUZZ_SECONDS` says how long (a fifth of one by default), `DQ8_FUZZ_SEED` from where; what is found names the seed of
//! its round.

use dq8::simd::Row;
use dq8::storage::{Block, Element};
use dq8::{Backend, Crowd, DualQuat, Quat, Scalar};
use dq8_fixtures::fuzz;
use dq8_fixtures::random::{Random, bits};
use dq8_robot::ik::{Freedom, Options, Report};
use dq8_robot::{Goal, Joint, JointValues, Mechanism, OwnedMechanism, Reach};
use std::marker::PhantomData;

/// Ways to compute the same numbers, and the bits of what they give.
type Entries = Vec<(&'static str, Vec<u64>)>;

/// How motions lie in memory.
type In<E> = <E as Element<8>>::Layout;

struct Scene<R> {
    random: Random,
    backend: Backend,
    real: PhantomData<R>,
}

impl<R> Scene<R>
where
    [R; 4]: Row<Real = R>,
    [R; 8]: Row<Real = R>,
    R: Scalar + JointValues<In<DualQuat<R>>>,
    R: JointValues<In<Block<R, 4>>> + JointValues<In<Block<R, 8>>>,
{
    /// An ordinary number, and seldom one of any bits.
    fn number(&mut self) -> R {
        from(self.random.number(R::SINGLE, 0.01))
    }

    /// Unit; seldom with numbers of any bits, and half a turn from others, so that they are at right angles.
    fn motion(&mut self) -> DualQuat<R> {
        if self.random.below(8) == 0 {
            let mut axis = [R::ZERO; 3];
            axis[self.random.below(3)] = R::ONE;
            return DualQuat::from_rotation(Quat::from_parts(axis, R::ZERO));
        }
        let motion = self.random.motion(2.0).to_array().map(from);
        let hostile = self.random.below(16) == 0;
        DualQuat::from_array(motion.map(|number| if hostile { self.number() } else { number }))
    }

    fn robot(&mut self) -> OwnedMechanism<R> {
        let links: Vec<_> = (0..7)
            .map(|link: usize| {
                let (on, at) = (link.checked_sub(1), self.random.motion(0.5).cast());
                let axis = self.random.direction().map(from);
                let joint = match link {
                    2 => Joint::prismatic(on, at, axis),
                    _ => Joint::revolute(on, at, axis),
                };
                let limits = [-2.0, 2.5].map(from);
                if link % 3 == 1 { joint.with_limits(limits) } else { joint }
            })
            .collect();
        OwnedMechanism::new(&links).unwrap()
    }

    /// Values of some configurations.
    fn values(&mut self, robot: Mechanism<'_, R>, count: usize) -> Vec<R> {
        (0..count * robot.values()).map(|_| self.number()).collect()
    }

    fn link_poses(&mut self) -> Entries {
        let robot = self.robot();
        let (robot, count) = (robot.view(), 1 + self.random.below(20));
        let values = self.values(robot, count);
        let backend = self.backend;
        let mut together = vec![DualQuat::IDENTITY; count * robot.links()];
        robot.job().backend(backend).poses(&values, &mut together).unwrap();
        let mut alone = together.clone();
        let each = values.chunks(robot.values()).zip(alone.chunks_mut(robot.links()));
        each.for_each(|(values, poses)| robot.job().backend(backend).poses(values, poses).unwrap());
        let mut four = Crowd::<R, 4>::new(robot.links(), count);
        let mut eight = Crowd::<R, 8>::new(robot.links(), count);
        robot.job().backend(backend).poses(&values, four.blocks_mut()).unwrap();
        robot.job().backend(backend).poses(&values, eight.blocks_mut()).unwrap();
        vec![
            ("together", of_motions(&together)),
            ("one by one", of_motions(&alone)),
            ("blocks of 4", of_motions(&four.to_vec())),
            ("blocks of 8", of_motions(&eight.to_vec())),
        ]
    }

    fn reach(&mut self) -> Entries {
        let robot = self.robot();
        let (robot, count) = (robot.view(), 1 + self.random.below(20));
        let goals = [Goal::pose(robot.links() - 1)];
        let mut freedoms = vec![Freedom::default(); robot.rates()];
        let reach = Reach::new(robot, &goals, &mut freedoms).unwrap();
        let mut poses = vec![DualQuat::IDENTITY; robot.links()];
        let targets: Vec<_> = (0..count)
            .map(|_| {
                let values: Vec<_> =
                    self.random.vector::<7>().map(|value| from(2.0 * value)).into();
                robot.link_poses(&values, &mut poses).unwrap();
                if self.random.below(8) == 0 { self.motion() } else { poses[robot.links() - 1] }
            })
            .collect();
        let start = self.values(robot, count);
        let options = Options { restarts: self.random.below(2) == 0, ..Options::default() };
        let job = reach.job().backend(self.backend);
        let search = |targets: &[DualQuat<R>], values: &mut [R]| {
            let mut reports = vec![Report::default(); targets.len()];
            job.solve(targets, values, &mut reports, &options).unwrap();
        };
        let (mut together, mut alone) = (start.clone(), start);
        search(&targets, &mut together);
        for (target, values) in targets.chunks(1).zip(alone.chunks_mut(robot.values())) {
            search(target, values);
        }
        vec![("together", of_numbers(&together)), ("one by one", of_numbers(&alone))]
    }

    /// All entries have the same bits with each of the machine's backends, and with all that fuse nothing.
    fn round(seed: u64) -> u64 {
        let mut unfused: Option<Vec<Vec<u64>>> = None;
        for backend in backends() {
            // The same numbers for each.
            let mut scene = Self { random: fuzz::random(seed), backend, real: PhantomData };
            let jobs = [("poses", scene.link_poses()), ("reach", scene.reach())];
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
                let all: Vec<_> =
                    jobs.into_iter().map(|(_, mut all)| all.swap_remove(0).1).collect();
                let first = unfused.get_or_insert_with(|| all.clone());
                assert!(all == *first, "seed {seed}: {backend} has other bits than other lanes");
            }
        }
        2
    }
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
    fuzz::rounds(Scene::<f32>::round);
}

#[test]
fn poses_and_searches_in_f64_have_the_same_bits_in_every_layout() {
    fuzz::rounds(Scene::<f64>::round);
}

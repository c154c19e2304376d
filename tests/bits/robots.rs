//! Every job over robots, of one precision: `super::R`.

use super::R;
use super::jobs::{M, N, hash};
use crate::random::Random;
use dq8::{Backend, Twist};
use dq8_robot::ik::{Freedom, Options, Report, SixAxisArm, Solutions, Tracking};
use dq8_robot::{Goal, Joint, Mechanism, Reach, Step, World};

pub(super) fn robots(
    k: Backend,
    say: &mut dyn FnMut(&str, u64),
    [a, b]: [&[M; N]; 2],
    random: &mut Random,
) {
    const LINKS: usize = 6;
    const COUNT: usize = 11;
    let joints: [Joint<R>; LINKS] = core::array::from_fn(|link| {
        let (on, at) = (link.checked_sub(1), b[link]);
        match link % 3 {
            0 => Joint::revolute(on, at, [0.0, 0.6, 0.8]),
            1 => Joint::revolute(on, at, [0.0, 0.0, 1.0]).with_limits([-2.0, 2.5]),
            _ => Joint::prismatic(on, at, [0.0, 1.0, 0.0]),
        }
    });
    let mut steps = [Step::default(); LINKS];
    let robot = Mechanism::new(&joints, &mut steps).expect("joints are sound");
    let job = robot.job().backend(k);
    let values: [R; LINKS * COUNT] = [(); LINKS * COUNT].map(|()| 3.0 * random.signed::<R>());
    let rates: [R; LINKS * COUNT] = [(); LINKS * COUNT].map(|()| random.signed());
    let mut poses = [M::IDENTITY; LINKS * COUNT];
    job.poses(&values, &mut poses).expect("lengths fit");
    say("poses", hash(&poses));
    let mut tools = [M::IDENTITY; COUNT];
    job.links(&[LINKS - 1]).poses(&values, &mut tools).expect("lengths fit");
    say("poses of one link", hash(&tools));
    for (values, poses) in values.chunks(LINKS).zip(poses.chunks_mut(LINKS)) {
        robot.link_poses(values, poses).expect("lengths fit");
    }
    say("link_poses", hash(&poses));
    let zero = [Twist { angular: [0.0; 3], linear: [0.0; 3] }; LINKS * COUNT];
    let (mut twists, mut more) = (zero, zero);
    job.accelerations(&values, &rates, &rates, &mut poses, &mut twists, &mut more)
        .expect("lengths fit");
    say("velocities", hash(&twists));
    say("accelerations", hash(&more));
    job.links(&[LINKS - 1])
        .jacobians(World, &values, &mut tools, &mut twists)
        .expect("lengths fit");
    say("jacobians", hash(&twists));
    let each = values.chunks(LINKS).zip(tools.iter_mut()).zip(more.chunks_mut(LINKS));
    for ((values, tool), columns) in each {
        *tool = robot.link_pose(values, LINKS - 1).expect("there is such a link");
        robot.link_jacobian(World, values, LINKS - 1, columns).expect("lengths fit");
    }
    say("link_pose", hash(&tools));
    say("link_jacobian", hash(&more));
    let points = [(2, [0.1, -0.2, 0.3]), (LINKS - 1, [0.0, 0.4, 0.0])];
    let mut places = [[0.0; 3]; 2 * COUNT];
    job.points(&points, &values, &mut places).expect("lengths fit");
    say("points", hash(&places));
    for (values, places) in values.chunks(LINKS).zip(places.chunks_mut(2)) {
        robot.link_points(values, &points, places).expect("lengths fit");
    }
    say("link_points", hash(&places));

    // Targets that the arm has been at, and one that it cannot reach.
    let goals = [Goal::pose(LINKS - 1)];
    let mut freedoms = [Freedom::default(); LINKS];
    let reach = Reach::new(robot, &goals, &mut freedoms).expect("goals are sound");
    let mut targets: [M; COUNT] = core::array::from_fn(|i| poses[LINKS * i + LINKS - 1]);
    targets[3] = a[0];
    let mut start: [R; LINKS * COUNT] = [(); LINKS * COUNT].map(|()| random.signed());
    let mut scratch = [0.0; 4096];
    let mut reports = [Report::default(); COUNT];
    let mut alone = start;
    reach
        .job()
        .backend(k)
        .solve_in(&mut scratch, &targets, &mut start, &mut reports, &Options::default())
        .expect("lengths fit");
    say("Reach", hash(&start));
    for (target, values) in targets.chunks(1).zip(alone.chunks_mut(LINKS)) {
        reach.solve(target, values, &mut scratch, &Options::default()).expect("lengths fit");
    }
    say("Reach, one", hash(&alone));
    let (job, mut speeds) = (reach.job().backend(k), rates);
    job.rates_in(&mut scratch, &values, &twists[..COUNT], 0.1, &mut speeds).expect("lengths fit");
    say("Reach, rates", hash(&speeds));
    job.sequence_in(
        &mut scratch,
        &[4, 7],
        &targets,
        &mut start,
        &mut reports,
        &Tracking::default(),
    )
    .expect("lengths fit");
    say("Reach, clips", hash(&start));
}

/// One arm of each family.
pub(super) fn solutions(k: Backend, say: &mut dyn FnMut(&str, u64), random: &mut Random) {
    const COUNT: usize = 11;
    let (x, y, z) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
    let wrist = (
        [z, y, y, x, y, x],
        [[0.3, 0.0, 0.7], [0.0, 0.0, 1.1], [1.2, 0.0, 0.2], [0.0; 3], [0.0; 3]],
    );
    let three = (
        [z, y, y, y, z, y],
        [[0.0, 0.1, 0.1], [0.4, -0.1, 0.0], [0.4, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, -0.1]],
    );
    for (name, (axes, ways)) in [("solutions", wrist), ("solutions, three parallel axes", three)] {
        let joints: [Joint<R>; 6] = core::array::from_fn(|link| {
            let (on, at) = match link.checked_sub(1) {
                Some(on) => (Some(on), M::from_translation(ways[on])),
                None => (None, M::IDENTITY),
            };
            Joint::revolute(on, at, axes[link]).with_limits([-6.0, 6.0])
        });
        let (mut steps, mut freedoms) = ([Step::default(); 6], [Freedom::default(); 6]);
        let robot = Mechanism::new(&joints, &mut steps).expect("joints are sound");
        let goals = [Goal::pose(5).at([0.1, 0.0, 0.2])];
        let reach = Reach::new(robot, &goals, &mut freedoms).expect("goals are sound");
        let six = SixAxisArm::new(reach).expect("six hinges");
        let starts: [[R; 6]; COUNT] =
            [(); COUNT].map(|()| [(); 6].map(|()| 3.0 * random.signed::<R>()));
        let targets =
            starts.map(|values| robot.link_pose(&values, 5).expect("there is such a link"));
        let mut found = [Solutions::default(); COUNT];
        six.job()
            .backend(k)
            .solutions_in(&mut [], &targets, &starts, &mut found)
            .expect("lengths fit");
        let mut all = [[0.0; 6]; 8 * COUNT];
        for (all, found) in all.chunks_mut(8).zip(&found) {
            for (slot, solution) in all.iter_mut().zip(found.iter()) {
                *slot = solution.values;
            }
        }
        say(name, hash(&all));
    }
}

//! Splines are what their formula says, by matrices; their derivatives and Jacobians are those of
//! differences; many times at once are one at a time.

use dq8::storage::{Block, Element, Layout, unpack};
use dq8::{Backend, DualQuat, Quat, Scalar, ShapeError, Twist};
use dq8_fixtures::random::Random;
use dq8_trajectory::{Basis, Frame, Moving, Outside, Spline, TrajectoryError};

const BASES: [Basis; 2] = [Basis::Smooth, Basis::Through];
const EVERY: f64 = 0.25;
const START: f64 = 10.0;

/// Control poses that turn by up to `turn` from one to the next, some with the other sign.
fn control(random: &mut Random, count: usize, turn: f64) -> Vec<DualQuat<f64>> {
    let mut pose = random.motion(20.0);
    let mut poses = vec![];
    for _ in 0..count {
        poses.push(if random.below(2) == 0 { pose } else { -pose });
        let axis: [f64; 3] = random.direction();
        let angle = random.between(0.0, turn);
        let linear = random.vector::<3>().map(|x| 2.0 * x);
        pose = pose * DualQuat::from_twist(Twist { angular: axis.map(|x| x * angle), linear });
        pose = pose.normalize();
    }
    poses
}

fn spline(random: &mut Random, count: usize, turn: f64, basis: Basis) -> Spline {
    Spline::new(START, EVERY, &control(random, count, turn), basis).unwrap()
}

type Matrix = [[f64; 4]; 4];

fn product(a: Matrix, b: Matrix) -> Matrix {
    core::array::from_fn(|i| core::array::from_fn(|j| (0..4).map(|k| a[i][k] * b[k][j]).sum()))
}

/// exp of a twist as a matrix, by its series after halving.
fn exponential(twist: Twist<f64>) -> Matrix {
    let [a, b, c, x, y, z] = twist.to_array().map(|number| number / 1024.0);
    let small = [[0.0, -c, b, x], [c, 0.0, -a, y], [-b, a, 0.0, z], [0.0; 4]];
    let identity: Matrix = core::array::from_fn(|i| core::array::from_fn(|j| f64::from(i == j)));
    let mut sum = identity;
    for k in (1..=8).rev() {
        let next = product(small, sum).map(|row| row.map(|number| number / f64::from(k)));
        sum = core::array::from_fn(|i| core::array::from_fn(|j| identity[i][j] + next[i][j]));
    }
    (0..10).fold(sum, |matrix, _| product(matrix, matrix))
}

/// The weights of the four numbers of a cubic spline (Catmull & Rom 1974; de Boor 1978).
fn weights(basis: Basis, u: f64) -> [f64; 4] {
    let v = 1.0 - u;
    match basis {
        Basis::Smooth => [
            v * v * v / 6.0,
            (3.0 * u * u * u - 6.0 * u * u + 4.0) / 6.0,
            (3.0 * v * v * v - 6.0 * v * v + 4.0) / 6.0,
            u * u * u / 6.0,
        ],
        Basis::Through => [
            -0.5 * u * v * v,
            0.5 * (2.0 - 5.0 * u * u + 3.0 * u * u * u),
            0.5 * (2.0 - 5.0 * v * v + 3.0 * v * v * v),
            -0.5 * v * u * u,
        ],
    }
}

#[test]
fn poses_are_those_of_matrices() {
    let mut random = Random(1);
    for (basis, turn) in
        BASES.into_iter().flat_map(|basis| [0.0, 1e-6, 0.5, 3.1].map(|t| (basis, t)))
    {
        let spline = spline(&mut random, 9, turn, basis);
        for _ in 0..100 {
            let place = random.between(0.0, 6.0);
            let (first, u) = (place as usize, place.fract());
            let control = &spline.control()[first..first + 4];
            let weights = weights(basis, u);
            let [top, middle, bottom] = control[0].to_matrix3x4();
            let mut wanted = [top, middle, bottom, [0.0, 0.0, 0.0, 1.0]];
            for j in 1..4 {
                let share: f64 = weights[j..].iter().sum();
                let way = control[j - 1].twist_to(control[j]);
                wanted = product(wanted, exponential(way.scale(share)));
            }
            let found = spline.at(START + EVERY * place).to_matrix3x4();
            for (a, b) in found.as_flattened().iter().zip(wanted.as_flattened()) {
                assert!((a - b).abs() < 3e-13, "{basis:?} {turn} {place}: {found:?} {wanted:?}");
            }
        }
    }
}

/// The twist of a short way in the frame of the body, over the time, from poses before and after.
fn difference(h: f64, at: impl Fn(f64) -> DualQuat<f64>) -> Twist<f64> {
    // Central differences of the fourth order.
    let way = |h: f64| at(-h).twist_to(at(h)).scale(0.5 / h);
    combined(way(h), way(2.0 * h))
}

fn combined(near: Twist<f64>, far: Twist<f64>) -> Twist<f64> {
    near.scale(4.0 / 3.0) - far.scale(1.0 / 3.0)
}

fn largest(twist: Twist<f64>) -> f64 {
    twist.to_array().into_iter().fold(0.0, |largest, c| c.abs().max(largest))
}

#[test]
fn twists_and_accelerations_are_those_of_differences() {
    let mut random = Random(2);
    for basis in BASES {
        for turn in [0.0, 0.5, 2.0] {
            let spline = spline(&mut random, 9, turn, basis);
            for _ in 0..60 {
                let time = START + EVERY * (random.below(6) as f64 + random.between(0.02, 0.98));
                let h = 1e-3 * EVERY;
                let Moving { twist, acceleration, .. } = spline.moving_at(time);
                // The way from −h to h is a twist in the frame of −h and of h alike, and to
                // third order in that of the middle.
                let found = difference(h, |h| spline.at(time + h));
                assert!(largest(found - twist) < 1e-5 * (1.0 + largest(twist)), "{basis:?} {turn}");
                let slope = |h: f64| {
                    let [before, after] = [-h, h].map(|h| spline.moving_at(time + h).twist);
                    (after - before).scale(0.5 / h)
                };
                let found = combined(slope(h), slope(2.0 * h));
                let scale = 1.0 + largest(acceleration) + largest(twist).powi(2);
                assert!(largest(found - acceleration) < 1e-7 * scale, "{basis:?} {turn}");
            }
        }
    }
}

#[test]
fn a_constant_twist_stays_one() {
    let way = Twist { angular: [0.3, -0.2, 0.5], linear: [1.0, 2.0, -1.0] };
    let start = Random(3).motion(5.0);
    let pose = |k: f64| start * DualQuat::from_twist(way.scale(k));
    let control: Vec<_> = (0..7).map(|k| pose(f64::from(k) - 1.0)).collect();
    for basis in BASES {
        let spline = Spline::new(START, EVERY, &control, basis).unwrap();
        for k in 0..=40 {
            let share = f64::from(k) / 10.0;
            let Moving { pose: found, twist, acceleration, .. } =
                spline.moving_at(START + EVERY * share);
            assert!(largest(pose(share).twist_to(found)) < 1e-13, "{basis:?} {share}");
            assert!(largest(twist - way.scale(1.0 / EVERY)) < 1e-13, "{basis:?} {share}");
            assert!(largest(acceleration) < 1e-11, "{basis:?} {share} {acceleration:?}");
        }
    }
}

#[test]
fn knots_join_smoothly_and_catmull_and_rom_go_through_them() {
    let mut random = Random(4);
    for basis in BASES {
        let spline = spline(&mut random, 9, 1.0, basis);
        for knot in 1..6 {
            let time = START + EVERY * f64::from(knot);
            let [before, after] = [time.next_down(), time].map(|time| spline.moving_at(time));
            assert!(largest(before.pose.twist_to(after.pose)) < 1e-12);
            assert!(largest(before.twist - after.twist) < 1e-11, "{basis:?}");
            let jump = largest(before.acceleration - after.acceleration);
            assert_eq!(jump < 1e-9, basis == Basis::Smooth, "{basis:?}: {jump}");
            let there = spline.control()[knot as usize + 1];
            let away = largest(there.twist_to(after.pose));
            assert_eq!(away < 1e-13, basis == Basis::Through, "{basis:?}: {away}");
        }
    }
}

#[test]
fn jacobians_are_those_of_differences() {
    let mut random = Random(5);
    for basis in BASES {
        for turn in [0.0, 0.5, 2.5] {
            let control = control(&mut random, 8, turn);
            let spline = Spline::new(START, EVERY, &control, basis).unwrap();
            for round in 0..6 {
                let place = if round == 0 { 5.0 } else { random.between(0.0, 5.0) };
                let time = START + EVERY * place;
                let jacobians = spline.jacobians(time);
                assert_eq!(jacobians.first, (place as usize).min(4));
                for k in 0..8 {
                    for column in 0..6 {
                        let changed = |h: f64| {
                            let mut unit = [0.0; 6];
                            unit[column] = h;
                            let mut control = control.clone();
                            let change = DualQuat::from_twist(Twist::from_array(unit));
                            control[k] = control[k] * change;
                            Spline::new(START, EVERY, &control, basis).unwrap().at(time)
                        };
                        let wanted = difference(1e-3, changed).to_array();
                        let matrix = k.checked_sub(jacobians.first);
                        let matrix = matrix.and_then(|k| jacobians.matrices.get(k));
                        for (row, wanted) in wanted.into_iter().enumerate() {
                            let found = matrix.map_or(0.0, |matrix| matrix[row][column]);
                            // Near half a turn the logarithm is steep.
                            let bound = if turn > 2.0 { 3e-5 } else { 1e-8 };
                            assert!(
                                (found - wanted).abs() < bound,
                                "{basis:?} {turn} {place}, pose {k}, [{row}][{column}]: {found} {wanted}"
                            );
                        }
                    }
                }
            }
        }
    }
}

fn times(random: &mut Random, spline: &Spline, count: usize) -> Vec<f64> {
    let [first, last] = spline.range();
    let mut times: Vec<_> = (0..count).map(|_| random.between(first - 0.1, last + 0.1)).collect();
    times.extend((0..=20).map(|k| first + (last - first) * f64::from(k) / 20.0));
    times.extend([first, last, last.next_up(), first.next_down()]);
    times
}

/// By single times, in doubles.
fn wanted(spline: &Spline, outside: Outside, time: f64) -> [Twist<f64>; 3] {
    let [first, last] = spline.range();
    let end = spline.moving_at(time.clamp(first, last));
    let goes_on = outside == Outside::Continue && !(first..=last).contains(&time);
    let Moving { pose, twist, acceleration, .. } =
        if goes_on { end } else { spline.moving_at(time) };
    let beyond = if goes_on { time - time.clamp(first, last) } else { 0.0 };
    let pose = pose * DualQuat::from_twist(twist.scale(beyond));
    let acceleration = if goes_on { Twist::ZERO } else { acceleration };
    [pose.to_twist(), twist, acceleration]
}

fn many_times_are_one_at_a_time<R: Scalar>(units: f64) {
    let mut random = Random(6);
    for (basis, count) in BASES.into_iter().flat_map(|basis| [4, 40].map(|count| (basis, count))) {
        let spline = spline(&mut random, count, 2.0, basis);
        let times = times(&mut random, &spline, 60);
        let frames = [Frame::World, Frame::Start, Frame::End, Frame::At(START - 0.05)];
        for (outside, frame) in
            [Outside::Hold, Outside::Continue].into_iter().flat_map(|o| frames.map(|f| (o, f)))
        {
            let pose = |time| DualQuat::from_twist(wanted(&spline, outside, time)[0]);
            let into = match frame {
                Frame::Start => pose(spline.range()[0]),
                Frame::End => pose(spline.range()[1]),
                Frame::At(time) => pose(time),
                _ => DualQuat::IDENTITY,
            };
            for backend in Backend::available() {
                let job = spline.job().outside(outside).frame(frame).backend(backend);
                let mut poses = vec![DualQuat::<R>::IDENTITY; times.len()];
                let mut twists = vec![Twist::<R>::ZERO; times.len()];
                let mut accelerations = twists.clone();
                job.sample_with_accelerations(&times, &mut poses, &mut twists, &mut accelerations)
                    .unwrap();
                for (i, &time) in times.iter().enumerate() {
                    let [_, twist, acceleration] = wanted(&spline, outside, time);
                    let off = (into.conjugate() * pose(time)).twist_to(poses[i].cast());
                    let off_twist = twists[i].to_array().map(Into::into);
                    let off_twist = largest(Twist::from_array(off_twist) - twist);
                    let off_acceleration = accelerations[i].to_array().map(Into::into);
                    let off_acceleration =
                        largest(Twist::from_array(off_acceleration) - acceleration);
                    let bound = units * R::EPSILON.into();
                    let what = format!("{basis:?} {count} {outside:?} {frame:?} {backend} {time}");
                    assert!(largest(off) < bound * 100.0, "{what}: {off:?}");
                    assert!(off_twist < bound * (10.0 + largest(twist)), "{what}: {off_twist}");
                    let scale = 100.0 + largest(acceleration);
                    assert!(off_acceleration < bound * scale, "{what}: {off_acceleration}");
                }
                // The same bits without accelerations, and without twists.
                let (mut fewer, mut fewer_twists) = (poses.clone(), twists.clone());
                job.sample_with_twists(&times, &mut fewer, &mut fewer_twists).unwrap();
                assert_eq!((&fewer, &fewer_twists), (&poses, &twists));
                job.sample(&times, &mut fewer).unwrap();
                assert_eq!(fewer, poses);
            }
        }
    }
}

#[test]
fn many_times_are_one_at_a_time_f32() {
    many_times_are_one_at_a_time::<f32>(16.0);
}

#[test]
fn many_times_are_one_at_a_time_f64() {
    many_times_are_one_at_a_time::<f64>(64.0);
}

/// Alone, in any order, and in blocks.
#[test]
fn bits_do_not_depend_on_neighbours() {
    fn all<R: Scalar, const N: usize>()
    where
        [R; N]: dq8::simd::Row<Real = R>,
        Block<R, N, 8>: Element<8, Layout: Layout<Real = R>>,
    {
        let mut random = Random(7);
        let spline = spline(&mut random, 20, 2.0, Basis::Smooth);
        let all = times(&mut random, &spline, 200);
        for outside in [Outside::Hold, Outside::Continue] {
            let job = spline.job().outside(outside);
            let mut poses = vec![DualQuat::<R>::IDENTITY; all.len()];
            job.sample(&all, &mut poses).unwrap();
            for (time, pose) in all.iter().zip(&poses) {
                let mut one = [DualQuat::<R>::IDENTITY];
                job.sample(&[*time], &mut one).unwrap();
                assert_eq!(one[0].to_array(), pose.to_array());
            }
            let mut blocks = vec![Block::<R, N, 8>::splat([R::ZERO; 8]); all.len().div_ceil(N)];
            job.sample(&all, &mut blocks).unwrap();
            let mut unpacked = vec![[R::ZERO; 8]; all.len()];
            unpack(1, &blocks, &mut unpacked).unwrap();
            assert!(unpacked.iter().zip(&poses).all(|(a, b)| *a == b.to_array()));
        }
    }
    all::<f32, 8>();
    all::<f64, 4>();
}

#[cfg(feature = "rayon")]
#[test]
fn bits_do_not_depend_on_threads() {
    let mut random = Random(8);
    let spline = spline(&mut random, 20, 2.0, Basis::Through);
    let times = times(&mut random, &spline, 20_000);
    let mut one = vec![DualQuat::<f32>::IDENTITY; times.len()];
    let mut many = one.clone();
    spline.job().sample(&times, &mut one).unwrap();
    spline.job().threads(3).sample(&times, &mut many).unwrap();
    assert_eq!(one, many);
}

#[test]
fn a_curve_a_million_metres_away_costs_single_floats_nothing() {
    let mut random = Random(9);
    let near = control(&mut random, 12, 0.5);
    let away = DualQuat::from_translation([4e6, -3e6, 1e5]);
    let far: Vec<_> = near.iter().map(|&pose| away * pose).collect();
    let [near, far] = [near, far].map(|c| Spline::new(1.7e9, 0.1, &c, Basis::Smooth).unwrap());
    // Counted from the beginning, in single floats.
    let times: Vec<_> = (0..=90).map(|k| 0.01 * k as f32).collect();
    let sample = |spline: &Spline| {
        let mut poses = vec![DualQuat::<f32>::IDENTITY; times.len()];
        let job = spline.job().clock(1.7e9, 1.0).frame(Frame::Start);
        job.sample(&times, &mut poses).unwrap();
        poses
    };
    for (near, far) in sample(&near).into_iter().zip(sample(&far)) {
        assert!(largest(near.cast::<f64>().twist_to(far.cast())) < 3e-6);
    }
}

#[test]
fn nan_stays_at_its_time_and_signs_say_nothing() {
    let mut random = Random(10);
    let control = control(&mut random, 9, 2.0);
    let spline = Spline::new(START, EVERY, &control, Basis::Smooth).unwrap();
    let mut times = times(&mut random, &spline, 40);
    let mut poses = vec![DualQuat::<f64>::IDENTITY; times.len()];
    spline.job().sample(&times, &mut poses).unwrap();
    times[7] = f64::NAN;
    let mut again = poses.clone();
    spline.job().sample(&times, &mut again).unwrap();
    assert!(again[7].to_array().iter().all(|c| c.is_nan()));
    assert!(spline.at(f64::NAN).to_array().iter().all(|c| c.is_nan()));
    assert!(spline.jacobians(f64::NAN).matrices[0][0][0].is_nan());
    again[7] = poses[7];
    assert_eq!(again, poses);

    let same: Vec<_> = { control.iter() }
        .enumerate()
        .map(|(k, &pose)| if k % 3 == 1 { -pose } else { pose })
        .collect();
    let same = Spline::new(START, EVERY, &same, Basis::Smooth).unwrap();
    for &time in times.iter().filter(|time| !time.is_nan()) {
        assert!(largest(same.at(time).twist_to(spline.at(time))) < 1e-13);
    }
}

#[test]
fn what_is_no_spline_is_refused() {
    let mut random = Random(11);
    let mut poses = control(&mut random, 6, 1.0);
    for count in 0..4 {
        let error = Spline::new(0.0, 1.0, &poses[..count], Basis::Smooth).unwrap_err();
        assert_eq!(error, TrajectoryError::TooFewPoses { poses: count });
    }
    for (start, every) in [
        (0.0, 0.0),
        (0.0, -1.0),
        (0.0, f64::INFINITY),
        (1e308, 1e308),
        (f64::INFINITY, 1.0),
        // Knots would be where others are.
        (1.7e9, 1e-7),
    ] {
        let error = Spline::new(start, every, &poses, Basis::Through).unwrap_err();
        assert_eq!(error, TrajectoryError::Interval { start, every });
    }
    for (start, every) in [(f64::NAN, 1.0), (0.0, f64::NAN)] {
        let error = Spline::new(start, every, &poses, Basis::Through).unwrap_err();
        assert!(matches!(error, TrajectoryError::Interval { .. }));
    }
    let spline = Spline::new(0.0, 1.0, &poses, Basis::Smooth).unwrap();
    poses[4] = poses[4].scale(f64::INFINITY);
    let error = Spline::new(0.0, 1.0, &poses, Basis::Smooth).unwrap_err();
    assert_eq!(error, TrajectoryError::ControlPose { index: 4 });

    let untouched = [DualQuat::<f64>::IDENTITY; 2];
    let (mut poses, mut twists) = (untouched, [Twist::ZERO; 2]);
    let job = spline.job();
    let length = |what, length, expected| ShapeError::Length { what, length, expected };
    let mut three = [Twist::ZERO; 3];
    let errors = [
        job.sample(&[0.0], &mut poses),
        job.sample_with_twists(&[0.0, 1.0], &mut poses, &mut three),
        job.sample_with_accelerations(&[0.0, 1.0], &mut poses, &mut twists, &mut three),
        job.outside(Outside::Refuse).sample(&[3.0, 3.5], &mut poses),
        job.outside(Outside::Refuse).frame(Frame::At(-0.5)).sample(&[3.0, 0.0], &mut poses),
        job.clock(0.0, 0.0).sample(&[3.0, 0.0], &mut poses),
    ];
    let wanted = [
        length("poses", 2, 1).into(),
        length("twists", 3, 2).into(),
        length("accelerations", 3, 2).into(),
        TrajectoryError::Outside { index: 1, value: 3.5, first: 0.0, last: 3.0 },
        TrajectoryError::NoFrame { time: -0.5 },
        TrajectoryError::Clock { value: 0.0 },
    ];
    assert_eq!(errors.map(Result::unwrap_err), wanted);
    assert_eq!((poses, twists, three), (untouched, [Twist::ZERO; 2], [Twist::ZERO; 3]));
    assert!(job.outside(Outside::Refuse).sample(&[3.0, 0.0], &mut poses).is_ok());
}

fn many_jacobians_are_one_at_a_time<R: Scalar>(bound: f64) {
    let mut random = Random(12);
    for (basis, turn) in BASES.into_iter().flat_map(|basis| [0.0, 0.5, 2.5].map(|t| (basis, t))) {
        for count in [4, 9] {
            let spline = spline(&mut random, count, turn, basis);
            let mut times = times(&mut random, &spline, 20);
            times.push(f64::NAN);
            let mut jobs: Vec<_> =
                { Backend::available() }.map(|backend| spline.job().backend(backend)).collect();
            jobs.push(spline.job().outside(Outside::Continue).frame(Frame::End));
            for job in jobs {
                let mut first = vec![0; times.len()];
                let mut found = vec![[[[R::ZERO; 6]; 6]; 4]; times.len()];
                job.jacobians(&times, &mut first, &mut found).unwrap();
                for (i, &time) in times.iter().enumerate() {
                    let wanted = spline.jacobians(time);
                    assert_eq!(first[i], wanted.first, "{time}");
                    let numbers = found[i].as_flattened().as_flattened();
                    let wanted = wanted.matrices;
                    for (found, wanted) in numbers.iter().zip(wanted.as_flattened().as_flattened())
                    {
                        let found: f64 = (*found).into();
                        let off = (found - wanted).abs() / (1.0 + wanted.abs());
                        let both = found.is_nan() && wanted.is_nan();
                        // Above the diagonal there is nothing, at any time.
                        let none = time.is_nan() && found == 0.0;
                        assert!(
                            off < bound || both || none,
                            "{basis:?} {turn} {time}: {found} {wanted}"
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn many_jacobians_are_one_at_a_time_f32() {
    many_jacobians_are_one_at_a_time::<f32>(4e-5);
}

#[test]
fn many_jacobians_are_one_at_a_time_f64() {
    many_jacobians_are_one_at_a_time::<f64>(1e-13);
}

#[test]
fn jacobians_that_do_not_fit_are_refused() {
    let spline = spline(&mut Random(13), 6, 1.0, Basis::Smooth);
    let (mut first, mut matrices) = ([9; 2], [[[[7.0_f32; 6]; 6]; 4]; 2]);
    let job = spline.job().outside(Outside::Refuse);
    let [_, last] = spline.range();
    let length = |what, length, expected| ShapeError::Length { what, length, expected };
    let error = job.jacobians(&[START], &mut first, &mut matrices).unwrap_err();
    assert_eq!(error, length("matrices", 2, 1).into());
    let error = job.jacobians(&[START; 2], &mut first[..1], &mut matrices).unwrap_err();
    assert_eq!(error, length("first", 1, 2).into());
    let error = job.jacobians(&[START, last + 1.0], &mut first, &mut matrices).unwrap_err();
    assert!(matches!(error, TrajectoryError::Outside { index: 1, .. }), "{error}");
    assert_eq!((first, matrices), ([9; 2], [[[[7.0; 6]; 6]; 4]; 2]));
}

/// The segment of a time is decided by its knots, and not by a quotient that may be rounded.
#[test]
fn knots_begin_their_segments() {
    let mut random = Random(14);
    let control = control(&mut random, 200, 0.1);
    for (start, every) in [(0.0, 0.1), (1.7e9, 0.1), (-3.3, 1.0 / 3.0), (1e-3, 0.7)] {
        let spline = Spline::new(start, every, &control, Basis::Smooth).unwrap();
        for k in 0..197 {
            let knot = start + every * k as f64;
            assert_eq!(spline.jacobians(knot).first, k, "{start} {every}");
            let before = spline.jacobians(knot.next_down()).first;
            assert_eq!(before, k.saturating_sub(1), "{start} {every}");
        }
    }
}

/// With lanes that fuse nothing every level of a CPU has the same bits.
#[cfg(feature = "reproducible")]
#[test]
fn lanes_that_fuse_nothing_have_the_same_bits_on_every_level() {
    fn all<R: Scalar>() {
        let mut random = Random(15);
        for (basis, turn) in BASES.into_iter().flat_map(|basis| [0.3, 3.1].map(|t| (basis, t))) {
            let spline = spline(&mut random, 9, turn, basis);
            let times = times(&mut random, &spline, 60);
            for outside in [Outside::Hold, Outside::Continue] {
                let mut found: Vec<Vec<u64>> = vec![];
                for backend in Backend::available().map(Backend::unfused) {
                    let job = spline.job().outside(outside).backend(backend);
                    let mut poses = vec![DualQuat::<R>::IDENTITY; times.len()];
                    let mut twists = vec![Twist::<R>::ZERO; times.len()];
                    let mut faster = twists.clone();
                    job.sample_with_accelerations(&times, &mut poses, &mut twists, &mut faster)
                        .unwrap();
                    let mut first = vec![0; times.len()];
                    let mut matrices = vec![[[[R::ZERO; 6]; 6]; 4]; times.len()];
                    job.jacobians(&times, &mut first, &mut matrices).unwrap();
                    let poses = poses.into_iter().flat_map(DualQuat::to_array);
                    let twists = twists.into_iter().chain(faster).flat_map(Twist::to_array);
                    let matrices = matrices.into_iter().flatten().flatten().flatten();
                    let numbers = poses.chain(twists).chain(matrices);
                    found.push(numbers.map(|number| number.into().to_bits()).collect());
                }
                assert!(found.iter().all(|bits| *bits == found[0]), "{basis:?} {turn} {outside:?}");
            }
        }
    }
    all::<f32>();
    all::<f64>();
}

/// From turns of a hundredth to those near half a turn, at tens of metres.
#[test]
fn splines_agree_with_answers_of_ninety_digits() {
    let rows = include_str!("spline.tsv").lines().filter(|line| !line.starts_with('#'));
    let mut count = 0;
    for line in rows {
        let fields: Vec<_> = line.split('\t').collect();
        let basis = if fields[0] == "Smooth" { Basis::Smooth } else { Basis::Through };
        let numbers: Vec<f64> = fields[1..].iter().map(|field| field.parse().unwrap()).collect();
        let (u, control, wanted) = (numbers[0], &numbers[1..29], &numbers[29..]);
        let pose = |c: &[f64]| {
            let rotation = Quat::from_xyzw(c[0], c[1], c[2], c[3]).normalize();
            DualQuat::from_rotation_translation(rotation, [c[4], c[5], c[6]])
        };
        let control: Vec<_> = control.chunks_exact(7).map(pose).collect();
        let spline = Spline::new(0.0, EVERY, &control, basis).unwrap();
        let single = spline.moving_at(EVERY * u);
        let mut found = vec![single];
        for backend in Backend::available() {
            let mut many = ([single.pose], [Twist::ZERO], [Twist::ZERO]);
            let job = spline.job().backend(backend);
            let times = [EVERY * u];
            job.sample_with_accelerations(&times, &mut many.0, &mut many.1, &mut many.2).unwrap();
            let mut lanes = single;
            (lanes.pose, lanes.twist, lanes.acceleration) = (many.0[0], many.1[0], many.2[0]);
            found.push(lanes);
        }
        for Moving { pose, twist, acceleration, .. } in found {
            let rows = pose.to_matrix3x4();
            let numbers = rows.as_flattened().iter().copied();
            let changes = twist.to_array().into_iter().chain(acceleration.to_array());
            for (i, (found, wanted)) in numbers.chain(changes).zip(wanted).enumerate() {
                // Metres, metres in a second, and in its square, of a quarter of a second.
                let bound = [1e-13, 1e-12, 2e-11][i.saturating_sub(6) / 6];
                assert!((found - wanted).abs() < bound, "{line}: number {i}, {found} for {wanted}");
            }
        }
        assert_eq!(wanted.len(), 24);
        count += 1;
    }
    assert_eq!(count, 6);
}

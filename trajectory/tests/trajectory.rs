//! Poses and points along trajectories are those of one time at a time, by the book; what does not fit is refused.

use dq8::simd::Row;
use dq8::storage::{Block, Element, Layout, pack, unpack};
use dq8::{Backend, DualQuat, Real, Scalar, ShapeError, Twist};
use dq8_fixtures::random::Random;
use dq8_trajectory::{Frame, Outside, OwnedTrajectory, Trajectory, TrajectoryError};

/// Points some hundred metres away, in units of the roundoff of that distance.
const UNITS: f64 = 4.0;

/// Poses that turn by up to a half turn from one to the next, some with the other sign.
fn path(random: &mut Random, count: usize, turn: f64) -> OwnedTrajectory {
    let mut pose = random.motion(20.0);
    let (mut stamp, mut stamps, mut poses) = (10.0, vec![], vec![]);
    for _ in 0..count {
        stamps.push(stamp);
        poses.push(if random.below(2) == 0 { pose } else { -pose });
        stamp += random.between(0.02, 0.1);
        let axis: [f64; 3] = random.direction();
        let angle = random.between(0.0, turn);
        let linear = random.vector::<3>().map(|x| 2.0 * x);
        pose = pose * DualQuat::from_twist(Twist { angular: axis.map(|x| x * angle), linear });
        pose = pose.normalize();
    }
    OwnedTrajectory::new(stamps, poses).unwrap()
}

/// Times from before the first stamp until after the last, with all stamps among them; rising, falling or in any order.
fn times(random: &mut Random, path: &OwnedTrajectory, count: usize, order: usize) -> Vec<f64> {
    let [first, last] = path.range();
    let mut times: Vec<_> = (0..count).map(|_| random.between(first - 0.05, last + 0.05)).collect();
    times.extend_from_slice(path.stamps());
    match order {
        0 => times.sort_by(f64::total_cmp),
        1 => times.sort_by(|a, b| b.total_cmp(a)),
        _ => {}
    }
    times
}

/// Where the body is, by the book: also outside, where it goes on.
fn goes_on(path: &OwnedTrajectory, time: f64) -> DualQuat<f64> {
    let ([first, last], poses, stamps) = (path.range(), path.poses(), path.stamps());
    let n = poses.len();
    let along = |k: usize, from: usize| {
        let share = (time - stamps[from]) / (stamps[k + 1] - stamps[k]);
        poses[from] * DualQuat::from_twist(poses[k].twist_to(poses[k + 1]).scale(share))
    };
    match () {
        () if time < first => along(0, 0),
        () if time > last => along(n - 2, n - 1),
        () => path.at(time),
    }
}

fn close<R: Real>(found: [R; 3], wanted: [f64; 3], scale: f64, what: &str) {
    let bound = UNITS * R::EPSILON.into() * scale;
    for (found, wanted) in found.into_iter().zip(wanted) {
        let error = (found.into() - wanted).abs();
        assert!(error <= bound, "{what}: {found} for {wanted}, {} units", error / bound * UNITS);
    }
}

fn points_are_moved_by_the_pose_at_their_time<R: Scalar>() {
    let mut random = Random(1);
    for (count, turn) in [(1, 0.0), (2, 3.1), (3, 1e-9), (40, 0.4), (200, 3.1)] {
        let path = path(&mut random, count, turn);
        for order in 0..3 {
            let times = times(&mut random, &path, 300, order);
            let points: Vec<[R; 4]> = times
                .iter()
                .map(|_| random.vector::<4>().map(|x| <R as Real>::from_f64(80.0 * x)))
                .collect();
            for outside in [Outside::Hold, Outside::Continue] {
                if count == 1 && outside == Outside::Continue {
                    continue;
                }
                for frame in [Frame::World, Frame::Start, Frame::End, Frame::At(10.02)] {
                    let at = |time| match outside {
                        Outside::Continue => goes_on(&path, time),
                        _ => path.at(time),
                    };
                    let [first, last] = path.range();
                    let into = match frame {
                        Frame::World => DualQuat::IDENTITY,
                        Frame::Start => path.at(first),
                        Frame::End => path.at(last),
                        Frame::At(time) => at(time),
                        Frame::Pose(pose) => pose,
                    };
                    for backend in Backend::available() {
                        let job = path.job().frame(frame).outside(outside).backend(backend);
                        let mut moved = points.clone();
                        job.deskew_in_place(&times, &mut moved).unwrap();
                        let scale = if outside == Outside::Continue { 2000.0 } else { 400.0 };
                        for ((&time, point), moved) in times.iter().zip(&points).zip(&moved) {
                            let [x, y, z, intensity] = point.map(Into::into);
                            let wanted = (into.conjugate() * at(time)).transform_point([x, y, z]);
                            let [x, y, z, copied] = *moved;
                            close([x, y, z], wanted, scale, &format!("{outside:?} {frame:?} {count} {turn} {time}"));
                            assert_eq!(copied.into(), intensity);
                        }
                        // And back.
                        job.skew_in_place(&times, &mut moved).unwrap();
                        for (back, point) in moved.iter().zip(&points) {
                            let [x, y, z, _] = *back;
                            let [a, b, c, _] = point.map(Into::into);
                            close([x, y, z], [a, b, c], 2.0 * scale, "and back");
                        }
                    }
                }
            }
        }
    }
}

#[test]
fn points_are_moved_by_the_pose_at_their_time_f32() {
    points_are_moved_by_the_pose_at_their_time::<f32>();
}

#[test]
fn points_are_moved_by_the_pose_at_their_time_f64() {
    points_are_moved_by_the_pose_at_their_time::<f64>();
}

fn samples_are_screw_motion<R: Scalar>() {
    let mut random = Random(2);
    for (count, turn) in [(1, 0.0), (2, 3.1), (40, 0.4), (200, 3.1)] {
        let path = path(&mut random, count, turn);
        for order in 0..3 {
            let times = times(&mut random, &path, 300, order);
            for backend in Backend::available() {
                let mut poses = vec![DualQuat::<R>::IDENTITY; times.len()];
                let mut twists = vec![Twist::<R>::ZERO; times.len()];
                let job = path.job().backend(backend);
                job.sample_with_twists(&times, &mut poses, &mut twists).unwrap();
                let stamps = path.stamps();
                for ((&time, pose), twist) in times.iter().zip(poses).zip(twists) {
                    let wanted = path.at(time);
                    let point = [1.0, 2.0, -3.0];
                    let moved = pose.transform_point(point.map(<R as Real>::from_f64));
                    close(moved, wanted.transform_point(point), 400.0, "sampled pose");
                    let k = stamps.partition_point(|&stamp| stamp <= time);
                    let velocity = if k == 0 || k == stamps.len() {
                        Twist::ZERO
                    } else {
                        let way = path.poses()[k - 1].twist_to(path.poses()[k]);
                        way.scale(1.0 / (stamps[k] - stamps[k - 1]))
                    };
                    let scale = velocity.to_array().iter().fold(1.0_f64, |most, x| most.max(x.abs()));
                    for (found, wanted) in twist.to_array().into_iter().zip(velocity.to_array()) {
                        let bound = UNITS * R::EPSILON.into() * scale;
                        assert!((found.into() - wanted).abs() <= bound, "{found} for {wanted}");
                    }
                }
            }
        }
    }
}

#[test]
fn samples_are_screw_motion_f32() {
    samples_are_screw_motion::<f32>();
}

#[test]
fn samples_are_screw_motion_f64() {
    samples_are_screw_motion::<f64>();
}

/// The backends whose bits must be the same whatever shares a register: each by itself.
fn backends() -> Vec<Backend> {
    let all = Backend::available();
    #[cfg(feature = "reproducible")]
    let all = all.chain([Backend::reproducible()]);
    all.collect()
}

fn bits_do_not_depend_on_neighbours<R: Scalar, const N: usize>()
where
    [R; N]: Row<Real = R>,
    Block<R, N, 3>: Element<3, Layout: Layout<Real = R>>,
{
    let mut random = Random(3);
    let path = path(&mut random, 30, 2.0);
    let all = times(&mut random, &path, 230, 2);
    let points: Vec<[R; 3]> =
        all.iter().map(|_| random.vector::<3>().map(<R as Real>::from_f64)).collect();
    for backend in backends() {
        for outside in [Outside::Hold, Outside::Continue] {
            let job = path.job().outside(outside).backend(backend);
            let mut whole = points.clone();
            job.deskew_in_place(&all, &mut whole).unwrap();
            for (i, moved) in whole.iter().enumerate() {
                let mut one = [points[i]];
                job.deskew_in_place(&all[i..=i], &mut one).unwrap();
                assert_eq!(one[0].map(bits), moved.map(bits), "{backend}, point {i} alone");
            }
            let mut rising: Vec<_> = (0..all.len()).collect();
            rising.sort_by(|&a, &b| all[a].total_cmp(&all[b]));
            let sorted: Vec<_> = rising.iter().map(|&i| all[i]).collect();
            let mut moved: Vec<_> = rising.iter().map(|&i| points[i]).collect();
            job.deskew_in_place(&sorted, &mut moved).unwrap();
            for (&i, moved) in rising.iter().zip(&moved) {
                assert_eq!(moved.map(bits), whole[i].map(bits), "{backend}, sorted");
            }
            let mut blocks = vec![Block::splat([R::ZERO; 3]); all.len().div_ceil(N)];
            pack(1, &points, &mut blocks).unwrap();
            job.deskew_in_place(&all, &mut blocks).unwrap();
            let mut unpacked = points.clone();
            unpack(1, &blocks, &mut unpacked).unwrap();
            assert_eq!(unpacked, whole, "{backend}, blocks of {N}");
        }
    }
}

fn bits<R: Real>(number: R) -> u64 {
    number.into().to_bits()
}

#[test]
fn a_point_has_the_same_bits_alone_sorted_and_in_blocks() {
    bits_do_not_depend_on_neighbours::<f32, 8>();
    bits_do_not_depend_on_neighbours::<f32, 16>();
    bits_do_not_depend_on_neighbours::<f32, 4>();
    bits_do_not_depend_on_neighbours::<f64, 2>();
    bits_do_not_depend_on_neighbours::<f64, 4>();
    bits_do_not_depend_on_neighbours::<f64, 8>();
}

#[cfg(feature = "rayon")]
#[test]
fn a_point_has_the_same_bits_on_any_number_of_threads() {
    let mut random = Random(4);
    let path = path(&mut random, 30, 2.0);
    let times = times(&mut random, &path, 20_000, 2);
    let mut one: Vec<[f32; 3]> = times.iter().map(|_| [1.0, 2.0, 3.0]).collect();
    let mut many = one.clone();
    path.job().deskew_in_place(&times, &mut one).unwrap();
    path.job().threads(3).deskew_in_place(&times, &mut many).unwrap();
    assert_eq!(one, many);
}

#[test]
fn a_map_a_million_metres_away_costs_single_floats_nothing() {
    let mut random = Random(5);
    let near = path(&mut random, 20, 0.3);
    let far = DualQuat::from_translation([1e6, -2e6, 5e5]);
    let poses: Vec<_> = near.poses().iter().map(|&pose| far * pose).collect();
    let far = OwnedTrajectory::new(near.stamps().to_vec(), poses).unwrap();
    let times = times(&mut random, &near, 500, 0);
    let points: Vec<[f32; 3]> = times.iter().map(|_| random.vector::<3>().map(|x| 50.0 * x as f32)).collect();
    let [mut a, mut b] = [points.clone(), points];
    near.job().frame(Frame::End).deskew_in_place(&times, &mut a).unwrap();
    far.job().frame(Frame::End).deskew_in_place(&times, &mut b).unwrap();
    for (a, b) in a.into_iter().zip(b) {
        close(a, b.map(f64::from), 400.0, "far away");
    }
}

#[test]
fn clocks_count_nanoseconds_and_seconds_since_1970_alike() {
    let start = 1_764_262_800.0;
    let forward = Twist { angular: [0.0, 0.1, 0.3], linear: [20.0, 0.0, 1.0] };
    let path = OwnedTrajectory::of_twist(forward, 0.0..0.1).unwrap();
    let stamps = path.stamps().iter().map(|stamp| stamp + start).collect();
    let epoch = OwnedTrajectory::new(stamps, path.poses().to_vec()).unwrap();
    let nanoseconds: Vec<u32> = (0..1000).map(|i| i * 100_000).collect();
    let since: Vec<i64> = nanoseconds.iter().map(|&t| 1_764_262_800_000_000_000 + i64::from(t)).collect();
    let seconds: Vec<f32> = nanoseconds.iter().map(|&t| (f64::from(t) * 1e-9) as f32).collect();
    let points = vec![[30.0_f32, 5.0, -1.0]; 1000];
    let [mut a, mut b, mut c, mut d] = [(); 4].map(|()| points.clone());
    path.job().clock(0.0, 1e-9).deskew_in_place(&nanoseconds, &mut a).unwrap();
    epoch.job().clock(start, 1e-9).deskew_in_place(&nanoseconds, &mut b).unwrap();
    epoch.job().clock(start, 1.0).deskew_in_place(&seconds, &mut c).unwrap();
    epoch.job().clock(0.0, 1e-9).deskew_in_place(&since, &mut d).unwrap();
    for (i, a) in a.into_iter().enumerate() {
        // Stamps since 1970 are good to 2.4e-7 s, in which the body goes 5e-6 m.
        for other in [b[i], c[i], d[i]] {
            for (a, other) in a.into_iter().zip(other) {
                assert!((a - other).abs() < 2e-5, "time {i}: {a} {other}");
            }
        }
    }
}

#[test]
fn columns_are_points_that_share_times() {
    let mut random = Random(6);
    let path = path(&mut random, 12, 0.5);
    for (rows, columns) in [(0, 0), (0, 3), (1, 1), (3, 7), (4, 40)] {
        let times: Vec<f64> = times(&mut random, &path, columns, 2).into_iter().take(columns).collect();
        let points: Vec<[f64; 4]> = (0..rows * columns).map(|_| random.vector()).collect();
        let each: Vec<_> = (0..rows).flat_map(|_| times.iter().copied()).collect();
        let (mut all, mut scan, mut back) = (points.clone(), points.clone(), points.clone());
        let job = path.job().frame(Frame::End);
        job.deskew(&each, &points, &mut all).unwrap();
        job.columns(&times).deskew(&points, &mut scan).unwrap();
        job.columns(&times).skew(&scan, &mut back).unwrap();
        for ((all, scan), (back, point)) in all.iter().zip(&scan).zip(back.iter().zip(&points)) {
            for i in 0..4 {
                assert!((all[i] - scan[i]).abs() < 1e-13 && (back[i] - point[i]).abs() < 1e-13);
            }
        }
    }
}

#[test]
fn nan_stays_in_its_point() {
    let path = OwnedTrajectory::of_twist(Twist { angular: [0.0, 1.0, 0.0], linear: [1.0; 3] }, 0.0..1.0).unwrap();
    for outside in [Outside::Hold, Outside::Continue] {
        for backend in Backend::available() {
            let job = path.job().outside(outside).backend(backend);
            let mut times = vec![0.25_f32; 40];
            let mut points = vec![[1.0_f32, 2.0, 3.0]; 40];
            let whole = {
                let mut points = points.clone();
                job.deskew_in_place(&times, &mut points).unwrap();
                points
            };
            (times[7], points[21][1]) = (f32::NAN, f32::NAN);
            job.deskew_in_place(&times, &mut points).unwrap();
            for (i, (point, whole)) in points.iter().zip(&whole).enumerate() {
                match i {
                    7 => assert!(point.iter().all(|x| x.is_nan())),
                    21 => assert!(point.iter().any(|x| x.is_nan())),
                    _ => assert_eq!(point, whole),
                }
            }
        }
    }
}

#[test]
fn a_body_that_stands_outside_its_stamps_does_so_for_ever() {
    let path = OwnedTrajectory::of_twist(Twist { angular: [0.0; 3], linear: [1.0, 0.0, 0.0] }, 0.0..1.0).unwrap();
    let mut poses = [DualQuat::<f64>::IDENTITY; 4];
    path.job().sample(&[f64::NEG_INFINITY, -1e300, 1e300, f64::INFINITY], &mut poses).unwrap();
    assert_eq!(poses.map(|pose| pose.translation()[0]), [0.0, 0.0, 1.0, 1.0]);
}

#[test]
fn very_uneven_stamps_are_found_as_well() {
    let mut stamps: Vec<f64> = (0..500).map(|i| f64::from(i) * 1e-9).collect();
    stamps.extend([1e3, 1e9]);
    let poses: Vec<_> = (0..stamps.len()).map(|i| DualQuat::from_translation([i as f64, 0.0, 0.0])).collect();
    let path = Trajectory::new(&stamps, &poses).unwrap();
    let mut samples = vec![DualQuat::IDENTITY; stamps.len()];
    path.job().sample(&stamps, &mut samples).unwrap();
    assert_eq!(samples, poses);
    let falling: Vec<_> = stamps.iter().rev().copied().collect();
    path.job().sample(&falling, &mut samples).unwrap();
    samples.reverse();
    assert_eq!(samples, poses);
}

#[test]
fn what_does_not_fit_is_refused_and_nothing_is_written() {
    use TrajectoryError as E;
    let pose = DualQuat::IDENTITY;
    let error = |stamps: &[f64]| Trajectory::new(stamps, &vec![pose; stamps.len()]).err();
    assert_eq!(error(&[]), Some(E::Empty));
    assert_eq!(error(&[0.0, 0.0]), Some(E::NotRising { index: 1, value: 0.0 }));
    assert!(matches!(error(&[0.0, f64::NAN]), Some(E::NotRising { index: 1, .. })));
    assert_eq!(error(&[f64::NEG_INFINITY]), Some(E::NotRising { index: 0, value: f64::NEG_INFINITY }));
    assert_eq!(error(&[-1e308, 1e308]), Some(E::NotRising { index: 1, value: 1e308 }));
    let length = |what, length, expected| Some(E::Shape(ShapeError::Length { what, length, expected }));
    assert_eq!(Trajectory::new(&[0.0], &[pose; 2]).err(), length("poses", 2, 1));

    let path = OwnedTrajectory::new(vec![0.0, 1.0], vec![pose; 2]).unwrap();
    let points = [[1.0_f32, 2.0, 3.0]; 3];
    let mut moved = [[7.0_f32; 3]; 3];
    let job = path.job();
    let mut tried = vec![
        (job.deskew(&[0.5; 2], &points, &mut moved).err(), length("points", 3, 2)),
        (job.deskew(&[0.5; 3], &points, &mut moved[..2]).err(), length("moved", 2, 3)),
        (job.clock(f64::NAN, 1.0).deskew(&[0.5; 3], &points, &mut moved).err().map(|_| E::Empty), Some(E::Empty)),
        (job.clock(0.0, 0.0).deskew(&[0.5; 3], &points, &mut moved).err(), Some(E::Clock { value: 0.0 })),
        (
            job.columns(&[0.5; 2]).deskew(&points, &mut moved).err(),
            length("points", 3, 2),
        ),
        (
            job.columns::<f64>(&[]).deskew(&points, &mut moved).err(),
            Some(E::Shape(ShapeError::Empty { what: "times" })),
        ),
    ];
    let outside = |index, value| Some(E::Outside { index, value, first: 0.0, last: 1.0 });
    let refuse = job.outside(Outside::Refuse);
    tried.push((refuse.deskew(&[0.0, 1.0, 1.5], &points, &mut moved).err(), outside(2, 1.5)));
    tried.push((refuse.skew(&[0.0, -0.5, 1.5], &points, &mut moved).err(), outside(1, -0.5)));
    tried.push((
        refuse.frame(Frame::At(2.0)).deskew(&[0.5; 3], &points, &mut moved).err(),
        Some(E::NoFrame { time: 2.0 }),
    ));
    let one = OwnedTrajectory::new(vec![0.0], vec![pose]).unwrap();
    let goes_on = one.job().outside(Outside::Continue);
    tried.push((goes_on.deskew(&[0.5; 3], &points, &mut moved).err(), Some(E::OnePose)));
    for (found, wanted) in tried {
        assert_eq!(found, wanted);
    }
    assert!(matches!(
        refuse.deskew(&[0.0, f64::NAN, 0.5], &points, &mut moved),
        Err(E::Outside { index: 1, .. })
    ));
    assert_eq!(moved, [[7.0; 3]; 3]);
    // None of them is asked for nothing.
    assert_eq!(job.deskew::<f64, [f32; 3], 3>(&[], &[], &mut []), Ok(()));

    let twist = Twist { angular: [0.0, 0.0, f64::INFINITY], linear: [0.0; 3] };
    assert!(matches!(OwnedTrajectory::of_twist(twist, 0.0..1.0), Err(E::NotFinite { .. })));
    assert!(matches!(OwnedTrajectory::of_twist(Twist::ZERO, 1.0..1.0), Err(E::NotRising { .. })));
    let (kept, dropped) = OwnedTrajectory::sorted(&[2.0, -0.0, 0.0, 2.0], &[pose; 4]).unwrap();
    assert_eq!((kept.stamps(), dropped), (&[0.0, 2.0][..], 2));
}

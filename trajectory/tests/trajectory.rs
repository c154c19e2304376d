//! Poses and points along trajectories are those of one time at a time, by the book; what does not
//! fit is refused.

use dq8::simd::Row;
use dq8::storage::{Block, Element, Layout, pack, unpack};
use dq8::{Backend, DualQuat, Real, Scalar, ShapeError, Twist};
use dq8_fixtures::random::Random;
use dq8_trajectory::{Frame, Outside, OwnedTrajectory, Time, Trajectory, TrajectoryError};

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

/// Times from before the first stamp until after the last, with all stamps among them; rising,
/// falling or in any order.
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
                            close(
                                [x, y, z],
                                wanted,
                                scale,
                                &format!("{outside:?} {frame:?} {count} {turn} {time}"),
                            );
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
                    // Of poses some 40 m from the origin the way between them loses as much as that
                    // is rounded by.
                    let lost = if velocity == Twist::ZERO {
                        1.0
                    } else {
                        40.0 / (stamps[k] - stamps[k - 1])
                    };
                    let scale = velocity.to_array().iter().fold(lost, |most, x| most.max(x.abs()));
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
    let mut blocks = vec![Block::<f32, 8, 3>::splat([1.0, 2.0, 3.0]); times.len().div_ceil(8)];
    path.job().threads(3).deskew_in_place(&times, &mut blocks).unwrap();
    unpack(1, &blocks, &mut many).unwrap();
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
    let points: Vec<[f32; 3]> =
        times.iter().map(|_| random.vector::<3>().map(|x| 50.0 * x as f32)).collect();
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
    let since: Vec<i64> =
        nanoseconds.iter().map(|&t| 1_764_262_800_000_000_000 + i64::from(t)).collect();
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
        let times: Vec<f64> =
            times(&mut random, &path, columns, 2).into_iter().take(columns).collect();
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
    let path =
        OwnedTrajectory::of_twist(Twist { angular: [0.0, 1.0, 0.0], linear: [1.0; 3] }, 0.0..1.0)
            .unwrap();
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

/// A pose that is not finite makes NaN of the times between its neighbours, and of no others.
#[test]
fn a_pose_that_is_not_finite_stays_between_its_neighbours() {
    let stamps: Vec<f64> = (0..6).map(f64::from).collect();
    for bad in [f64::NAN, f64::INFINITY] {
        let mut poses: Vec<_> =
            stamps.iter().map(|&x| DualQuat::from_translation([x, 0.0, 0.0])).collect();
        poses[3] = DualQuat::from_array([bad; 8]);
        let path = Trajectory::new(&stamps, &poses).unwrap();
        for backend in Backend::available() {
            let times = [0.5, 1.5, 2.5, 3.5, 4.5, 1.0, 4.0];
            let mut points = [[0.0; 3]; 7];
            path.job().backend(backend).deskew_in_place(&times, &mut points).unwrap();
            for (time, [x, ..]) in times.into_iter().zip(points) {
                assert_eq!(x.is_nan(), (2.0..4.0).contains(&time), "{bad} at {time}: {x}");
                assert!(x.is_nan() || (x - time).abs() < 1e-14, "{bad} at {time}: {x}");
            }
        }
    }
}

/// The logarithm of what is far from unit may be of any size.
// A build that judges unit input refuses these poses first.
#[cfg(not(dq8_debug_assert_unit))]
#[test]
fn poses_that_are_not_unit_take_no_more_memory_than_others() {
    let poses = [1.0, 1e15, -1e15].map(|x| DualQuat::from_array([x, 1.0, x, 0.0, x, 0.0, 0.0, x]));
    let path = Trajectory::new(&[0.0, 1.0, 2.0], &poses).unwrap();
    let mut samples = [DualQuat::<f64>::IDENTITY; 2];
    path.job().sample(&[0.5, 1.5], &mut samples).unwrap();
}

/// With lanes that fuse nothing every level of a CPU has the same bits.
#[cfg(feature = "reproducible")]
#[test]
fn lanes_that_fuse_nothing_have_the_same_bits_on_every_level() {
    fn all<R: Scalar>() {
        let mut random = Random(7);
        for turn in [0.0, 0.3, 3.1] {
            let path = path(&mut random, 20, turn);
            let times = times(&mut random, &path, 150, 2);
            let points: Vec<[R; 3]> =
                times.iter().map(|_| random.vector::<3>().map(<R as Real>::from_f64)).collect();
            for outside in [Outside::Hold, Outside::Continue] {
                let mut found: Vec<Vec<u64>> = vec![];
                for backend in Backend::available().map(Backend::unfused) {
                    let job = path.job().outside(outside).frame(Frame::End).backend(backend);
                    let (mut moved, mut back) = (points.clone(), points.clone());
                    job.deskew_in_place(&times, &mut moved).unwrap();
                    job.skew_in_place(&times, &mut back).unwrap();
                    let mut poses = vec![DualQuat::<R>::IDENTITY; times.len()];
                    let mut twists = vec![Twist::<R>::ZERO; times.len()];
                    job.sample_with_twists(&times, &mut poses, &mut twists).unwrap();
                    let poses = poses.into_iter().flat_map(DualQuat::to_array);
                    let twists = twists.into_iter().flat_map(Twist::to_array);
                    let points = moved.into_iter().chain(back).flatten();
                    found.push(points.chain(poses).chain(twists).map(bits).collect());
                }
                assert!(found.iter().all(|bits| *bits == found[0]), "{turn}, {outside:?}");
            }
        }
    }
    all::<f32>();
    all::<f64>();
}

#[test]
fn a_body_that_stands_outside_its_stamps_does_so_for_ever() {
    let path =
        OwnedTrajectory::of_twist(Twist { angular: [0.0; 3], linear: [1.0, 0.0, 0.0] }, 0.0..1.0)
            .unwrap();
    let mut poses = [DualQuat::<f64>::IDENTITY; 4];
    path.job().sample(&[f64::NEG_INFINITY, -1e300, 1e300, f64::INFINITY], &mut poses).unwrap();
    assert_eq!(poses.map(|pose| pose.translation()[0]), [0.0, 0.0, 1.0, 1.0]);
}

/// Where a body that stands is at these times: its x at the first stamp is −1, at the last one 1.
fn stands_at<T: Time>(path: Trajectory<'_>, [origin, unit]: [f64; 2], times: &[T]) -> Vec<f64> {
    let mut found = vec![];
    for backend in Backend::available() {
        let job = path.job().clock(origin, unit).backend(backend);
        let mut poses = vec![DualQuat::<f64>::IDENTITY; times.len()];
        let mut single = vec![DualQuat::<f32>::IDENTITY; times.len()];
        job.sample(times, &mut poses).unwrap();
        job.sample(times, &mut single).unwrap();
        found = poses.iter().map(|pose| pose.translation()[0]).collect();
        let single: Vec<_> = single.iter().map(|pose| f64::from(pose.translation()[0])).collect();
        assert_eq!(found, single, "{backend}");
        // A job that refuses such times says which is the first.
        let refused = job.outside(Outside::Refuse).sample(times, &mut poses);
        let outside = found.iter().position(|x| x.abs() == 1.0).unwrap();
        assert!(
            matches!(refused, Err(TrajectoryError::Outside { index, .. }) if index == outside),
            "{refused:?}"
        );
        // One that goes on writes something: a pose, or NaN where its angle is not known.
        job.outside(Outside::Continue).sample(times, &mut poses).unwrap();
    }
    found
}

#[test]
fn the_least_and_the_largest_numbers_are_times_as_well() {
    let poses = [-1.0, 1.0].map(|x| DualQuat::from_translation([x, 0.0, 0.0]));
    let stamps = [-1.0, 1.0];
    let path = Trajectory::new(&stamps, &poses).unwrap();
    let seconds = [0.0, 1.0];
    let ends = [0.0, -1.0, 1.0];
    assert_eq!(stands_at(path, seconds, &[0.0, f32::MIN, f32::MAX]), ends);
    assert_eq!(stands_at(path, seconds, &[0.0, f64::MIN, f64::MAX]), ends);
    assert_eq!(stands_at(path, seconds, &[0.0, f32::NEG_INFINITY, f32::INFINITY]), ends);
    assert_eq!(stands_at(path, seconds, &[0, i64::MIN, i64::MAX]), ends);
    assert_eq!(stands_at(path, [-2.0, 1.0], &[2, u32::MIN, u32::MAX]), ends);
    assert_eq!(stands_at(path, [-2.0, 1.0], &[2, u64::MIN, u64::MAX]), ends);
    // All of these numbers fill little more than the time between the stamps.
    let all = 2.5 / u64::MAX as f64;
    assert_eq!(stands_at(path, [-1.25, all], &[1 << 63, u64::MIN, u64::MAX]), ends);
    // Products and differences that overflow.
    assert_eq!(stands_at(path, [0.0, f64::MAX], &[0.0, f64::MIN, f64::MAX]), ends);
    let far = [1e308, 1.2e308];
    let path = Trajectory::new(&far, &poses).unwrap();
    let found = stands_at(path, [-1.7e308, 1e300], &[f64::MAX, f64::MIN, 0.0]);
    assert_eq!(found, [1.0, -1.0, -1.0]);
}

#[test]
fn very_uneven_stamps_are_found_as_well() {
    let mut stamps: Vec<f64> = (0..500).map(|i| f64::from(i) * 1e-9).collect();
    stamps.extend([1e3, 1e9]);
    let poses: Vec<_> =
        (0..stamps.len()).map(|i| DualQuat::from_translation([i as f64, 0.0, 0.0])).collect();
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
    assert_eq!(
        error(&[f64::NEG_INFINITY]),
        Some(E::NotRising { index: 0, value: f64::NEG_INFINITY })
    );
    assert_eq!(error(&[-1e308, 1e308]), Some(E::NotRising { index: 1, value: 1e308 }));
    let length =
        |what, length, expected| Some(E::Shape(ShapeError::Length { what, length, expected }));
    assert_eq!(Trajectory::new(&[0.0], &[pose; 2]).err(), length("poses", 2, 1));

    let path = OwnedTrajectory::new(vec![0.0, 1.0], vec![pose; 2]).unwrap();
    let points = [[1.0_f32, 2.0, 3.0]; 3];
    let mut moved = [[7.0_f32; 3]; 3];
    let job = path.job();
    let mut tried = vec![
        (job.deskew(&[0.5; 2], &points, &mut moved).err(), length("points", 3, 2)),
        (job.deskew(&[0.5; 3], &points, &mut moved[..2]).err(), length("moved", 2, 3)),
        (
            job.clock(f64::NAN, 1.0).deskew(&[0.5; 3], &points, &mut moved).err().map(|_| E::Empty),
            Some(E::Empty),
        ),
        (
            job.clock(0.0, 0.0).deskew(&[0.5; 3], &points, &mut moved).err(),
            Some(E::Clock { value: 0.0 }),
        ),
        (job.columns(&[0.5; 2]).deskew(&points, &mut moved).err(), length("points", 3, 2)),
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

/// Two poses, 1/16 s apart; a point measured at a time between them; and the same in the frame of
/// the second pose.
struct Answer {
    kind: &'static str,
    poses: [[f64; 8]; 2],
    time: f64,
    point: [f64; 3],
    moved: [f64; 3],
}

/// Computed with 60 digits from these poses, normalized, and their screw motion.
#[rustfmt::skip]
#[allow(clippy::unreadable_literal, reason = "as they were printed")]
const ANSWERS: &[Answer] = &[
    Answer { kind: "near 0", poses: [[-0.3703262354984863, 0.7401762280892634, -0.32722075652153576, -0.4559870690869908, 7.094926658239458, 4.733400959842787, 3.5673372728760255, -0.6386001554257973], [-0.3703262356513293, 0.7401762280525789, -0.32722075610767587, -0.4559870693193983, 7.902644372832059, 5.312175737759556, 3.9310506349975496, -0.6160957666092078]], time: 0.0078125, point: [53.6939640848985, 15.675109887808446, 9.959628535248882], moved: [55.126468527484235, 15.939292758897455, 8.815646106169547] },
    Answer { kind: "small", poses: [[0.10301226663623443, 0.8210066430600209, 0.33622293069590026, 0.44976739082334627, -0.6292326516122754, -3.847354283068497, 0.9588225971986352, 6.450320814344368], [0.1039609916753182, 0.819254926624417, 0.33449171292020696, 0.45401406519975945, -1.3369041189448463, -3.5930982972215983, 0.5416795230199841, 6.3906875815390585]], time: 0.0361328125, point: [16.66961627114209, -15.312294872912254, 5.729335885146938], moved: [16.612078688547474, -15.59730420788674, 6.343627212464257] },
    Answer { kind: "some", poses: [[0.20872585738807753, 0.0869014183665353, 0.2661270936483836, 0.9370475067838133, -2.494907402706018, -2.7404861611361686, 2.253509814974698, 0.16987805039821946], [-0.1731269795213698, 0.04390142776188454, 0.4792133635604275, 0.8593336172799111, -3.609547908566548, -2.738579397031434, 0.8291149636211814, -1.049657005889274]], time: 0.0556640625, point: [-18.7829172049952, -6.139897148664808, 13.075082284368435], moved: [-19.276417413180145, -6.402413775591188, 12.049112616059357] },
    Answer { kind: "quarter", poses: [[-0.7571743323145393, 0.5455042072490873, 0.27022496625180786, 0.23683466378844475, -3.4115801663661243, -9.709079267102965, 5.729697234715881, 4.918517389287744], [-0.4374048428963096, 0.825511557809787, -0.3471030366402909, 0.0820192251146173, -5.9736267722478535, -1.2872763453039924, 6.5231677141387685, 8.705026686134273]], time: 0.0224609375, point: [11.324385252602212, 9.587424513899066, -5.255360243830431], moved: [14.149069707093137, 2.685799077412788, 1.9389274235883125] },
    Answer { kind: "wide", poses: [[0.4564874253747111, -0.7196310548365024, -0.5162980072100545, 0.08477466095831299, -0.7079107322326926, -2.851632184889088, 4.733002959222047, 8.430222642254366], [0.28045013747261316, -0.6673650411152972, 0.4872127841058014, -0.4884622045692419, 7.2761228122732104, 2.8720861562566378, 3.552666541721128, 3.797150089923303]], time: 0.0107421875, point: [13.310345217969228, -0.7568406531622287, -33.81506702163847], moved: [16.686435304187857, -29.89386299422567, 12.230144620082823] },
    Answer { kind: "near pi", poses: [[0.3696230012374219, -0.14629906821251235, 0.6105297548868303, -0.6850028014499052, -4.313794889705132, 3.88636500374422, 3.8240744522663976, 0.25060020924131415], [-0.6487895378514119, 0.47335284970155705, -0.14280507780050017, -0.5784599597278619, 1.621152858880997, 4.901794211396814, -3.0079202666818965, 2.9354452346458637]], time: 0.0224609375, point: [21.926767126494184, -14.347043969275475, -32.30981902695814], moved: [-4.147141913141931, -29.387793790663082, 30.08352180650569] },
    Answer { kind: "translation", poses: [[0.8367201004644381, 0.480639809238445, -0.14269187616071072, -0.22028135584235928, 1.5441225731229362, -1.3048928805131987, 9.45926889642772, -3.1094138401968796], [0.8367201004644381, 0.480639809238445, -0.14269187616071072, -0.22028135584235928, 2.2444185546121003, -2.109688084677294, 10.222027370326316, -2.699503194161286]], time: 0.041015625, point: [21.144009893940165, -53.520852813145176, 47.943961206954256], moved: [21.658959064258195, -54.0147554933023, 47.3249032761406] },
    Answer { kind: "far", poses: [[-0.26139537573332833, 0.1788106401893308, -0.9383354156539024, 0.13865734827239398, 333995.4555238164, -184866.90611857368, -103076.99494077096, 170493.97543799956], [0.03726564602514921, 0.9017300393722523, -0.4248239948063889, -0.07084335647600157, 54490.51793260834, -9825.055054808703, -85832.73946125826, 418315.64466800867]], time: 0.00390625, point: [-47.71444827297335, 8.014032975970139, 4.394242556212276], moved: [-43.606899123200634, 19.56822026460484, 0.24000646569508985] },
];

#[test]
fn points_agree_with_answers_of_sixty_digits() {
    for Answer { kind, poses, time, point, moved } in ANSWERS {
        let poses = poses.map(DualQuat::from_array);
        let stamps = [100.0, 100.0625];
        let path = Trajectory::new(&stamps, &poses).unwrap();
        for backend in Backend::available() {
            let job = path.job().backend(backend).clock(100.0, 1.0).frame(Frame::End);
            let (mut double, mut single) = ([*point], [point.map(|x| x as f32)]);
            job.deskew_in_place(&[*time], &mut double).unwrap();
            job.deskew_in_place(&[*time], &mut single).unwrap();
            // Poses of a map 10⁶ m away are themselves rounded by 10⁻¹⁰ m.
            let far = poses[0].translation().iter().fold(0.0_f64, |far, x| far.max(x.abs()));
            for i in 0..3 {
                let error = (double[0][i] - moved[i]).abs();
                assert!(error <= 1e-13_f64.max(2e-15 * far), "{kind}, {backend}: {error}");
                // Two units of the roundoff of a hundred metres.
                let error = (f64::from(single[0][i]) - moved[i]).abs();
                assert!(error <= 2.0 * 2_f64.powi(-24) * 100.0, "{kind}, {backend}, f32: {error}");
            }
        }
    }
}

//! The poses of frames in each other are what 4×4 matrices say, multiplied one edge and one time
//! after the other.

use dq8::storage::{Block, Element, Number};
use dq8::{Backend, DualQuat, Real, Scalar, ShapeError, Twist};
use dq8_fixtures::random::Random;
use dq8_trajectory::{Edge, Frame, Frames, FramesError, Outside, OwnedTrajectory, TrajectoryError};

type Matrix = [[f64; 4]; 4];

/// A tree that the test knows by other means.
struct Tree {
    names: Vec<String>,
    parents: Vec<usize>,
    /// `None` for frames that do not move.
    paths: Vec<Option<OwnedTrajectory>>,
    fixed: Vec<DualQuat<f64>>,
}

impl Tree {
    /// The first two frames are roots.
    fn random(random: &mut Random, count: usize) -> Self {
        let names = (0..count).map(|i| format!("frame {i}")).collect();
        // Long ways, with fixed edges one after the other.
        let parents = (0..count).map(|i| if i < 2 { i } else { i - 1 - random.below(2) }).collect();
        let paths = (0..count).map(|_| (random.below(2) == 0).then(|| path(random, 6))).collect();
        let fixed = (0..count).map(|_| random.motion(5.0)).collect();
        Self { names, parents, paths, fixed }
    }

    fn frames(&self) -> Frames {
        let edges = (2..self.names.len()).map(|i| {
            let (frame, parent) = (&*self.names[i], &*self.names[self.parents[i]]);
            match &self.paths[i] {
                Some(path) => Edge::moving(frame, parent, path),
                None => Edge::fixed(frame, parent, self.fixed[i]),
            }
        });
        // The parents come after their children.
        Frames::new(edges.rev()).unwrap()
    }

    fn root(&self, mut frame: usize) -> usize {
        while frame != self.parents[frame] {
            frame = self.parents[frame];
        }
        frame
    }

    /// From a frame to its root.
    fn matrix(&self, mut frame: usize, time: f64, outside: Outside) -> Matrix {
        let mut matrix = DualQuat::<f64>::IDENTITY.to_matrix4();
        while frame != self.parents[frame] {
            let pose = match &self.paths[frame] {
                Some(path) if outside == Outside::Continue => goes_on(path, time),
                Some(path) => path.at(time),
                None => self.fixed[frame],
            };
            matrix = product(pose.to_matrix4(), matrix);
            frame = self.parents[frame];
        }
        matrix
    }
}

fn path(random: &mut Random, count: usize) -> OwnedTrajectory {
    let (mut stamp, mut pose) = (random.between(9.0, 10.0), random.motion(5.0));
    let (mut stamps, mut poses) = (vec![], vec![]);
    for _ in 0..count {
        stamps.push(stamp);
        poses.push(pose);
        stamp += random.between(0.1, 0.5);
        pose = (pose * DualQuat::from_twist(Twist::from_array(random.twist(0.8)))).normalize();
    }
    OwnedTrajectory::new(stamps, poses).unwrap()
}

fn goes_on(path: &OwnedTrajectory, time: f64) -> DualQuat<f64> {
    let ([first, last], stamps, poses) = (path.range(), path.stamps(), path.poses());
    let k = match () {
        () if time < first => 0,
        () if time > last => poses.len() - 2,
        () => return path.at(time),
    };
    let share = (time - stamps[k]) / (stamps[k + 1] - stamps[k]);
    poses[k] * DualQuat::from_twist(poses[k].twist_to(poses[k + 1]).scale(share))
}

fn product(a: Matrix, b: Matrix) -> Matrix {
    let entry = |i: usize, j: usize| (0..4).map(|k| a[i][k] * b[k][j]).sum();
    std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
}

/// [Rᵀ, −Rᵀt]
fn inverse(m: Matrix) -> Matrix {
    let back = |i: usize| -(0..3).map(|k| m[k][i] * m[k][3]).sum::<f64>();
    let row = |i: usize| [m[0][i], m[1][i], m[2][i], back(i)];
    [row(0), row(1), row(2), [0.0, 0.0, 0.0, 1.0]]
}

fn close<R: Real>(found: DualQuat<R>, wanted: Matrix, units: f64, what: &str) {
    let found = found.to_matrix4();
    for (i, j) in (0..12).map(|place| (place / 4, place % 4)) {
        let error = (found[i][j].into() - wanted[i][j]).abs();
        assert!(error <= units * R::EPSILON.into(), "{what}: {found:?} for {wanted:?}");
    }
}

fn lookups_are_products_of_matrices<R: Scalar>() {
    let mut random = Random(11);
    for count in [2, 3, 6, 14] {
        let tree = Tree::random(&mut random, count);
        let frames = tree.frames();
        for _ in 0..12 {
            let [target, source] = [random.below(count), random.below(count)];
            let [into, of] = [target, source].map(|frame| &*tree.names[frame]);
            let times: Vec<f64> = (0..300).map(|_| random.between(8.5, 12.5)).collect();
            for outside in [Outside::Hold, Outside::Continue] {
                for backend in Backend::available() {
                    let job = frames.job().outside(outside).backend(backend);
                    let mut poses = vec![DualQuat::<R>::IDENTITY; times.len()];
                    let answer = job.lookup(into, of, &times, &mut poses);
                    if count == 2 {
                        assert!(matches!(answer, Err(FramesError::Unknown { .. })));
                        continue;
                    }
                    if tree.root(target) != tree.root(source) {
                        let lost = matches!(
                            answer,
                            Err(FramesError::NotConnected { .. } | FramesError::Unknown { .. })
                        );
                        assert!(lost, "{answer:?}");
                        continue;
                    }
                    if let Err(FramesError::Unknown { frame }) = answer {
                        // A root without a child is in no edge.
                        assert!([&tree.names[0], &tree.names[1]].contains(&&frame));
                        continue;
                    }
                    answer.unwrap();
                    for (&time, &pose) in times.iter().zip(&poses) {
                        let [a, b] =
                            [target, source].map(|frame| tree.matrix(frame, time, outside));
                        // Some hundred metres, where the frames go on.
                        let what = format!("{into} from {of} at {time}, {outside:?}, {backend}");
                        close(pose, product(inverse(a), b), 2000.0, &what);
                    }
                }
            }
        }
    }
}

#[test]
fn lookups_are_products_of_matrices_f32() {
    lookups_are_products_of_matrices::<f32>();
}

#[test]
fn lookups_are_products_of_matrices_f64() {
    lookups_are_products_of_matrices::<f64>();
}

/// map ← odometry ← car ← scanner, and map ← tower; the car and the tower's platform move.
fn street(random: &mut Random) -> ([OwnedTrajectory; 3], [DualQuat<f64>; 2]) {
    let paths = [path(random, 30), path(random, 8), path(random, 12)];
    (paths, [random.motion(1.0), random.motion(1.0)])
}

fn edges<'a>(
    paths: &'a [OwnedTrajectory; 3],
    [scanner, camera]: [DualQuat<f64>; 2],
) -> [Edge<'a>; 5] {
    [
        Edge::moving("odometry", "map", &paths[0]),
        Edge::moving("car", "odometry", &paths[1]),
        Edge::fixed("scanner", "car", scanner),
        Edge::moving("platform", "map", &paths[2]),
        Edge::fixed("camera", "platform", camera),
    ]
}

#[test]
fn ways_are_joined_turned_and_closed() {
    let mut random = Random(12);
    let (paths, mounts) = street(&mut random);
    let frames = Frames::new(edges(&paths, mounts)).unwrap();
    let times: Vec<f64> = (0..200).map(|_| random.between(9.0, 14.0)).collect();
    let find = |target: &str, source: &str| {
        let mut poses = vec![DualQuat::<f64>::IDENTITY; times.len()];
        frames.job().lookup(target, source, &times, &mut poses).unwrap();
        poses
    };
    let names = ["map", "odometry", "car", "scanner", "platform", "camera"];
    for a in names {
        assert_eq!(find(a, a), vec![DualQuat::IDENTITY; times.len()]);
        for b in names {
            for (there, back) in find(a, b).iter().zip(find(b, a)) {
                close(*there * back, DualQuat::<f64>::IDENTITY.to_matrix4(), 1000.0, a);
            }
            for c in names {
                let (ab, bc) = (find(a, b), find(b, c));
                for ((ab, bc), ac) in ab.iter().zip(bc).zip(find(a, c)) {
                    close(ac, (*ab * bc).to_matrix4(), 1000.0, &format!("{a} {b} {c}"));
                }
            }
        }
    }
}

fn unpacked<M: Element<8>>(poses: &[M], count: usize) -> Vec<DualQuat<Number<M, 8>>> {
    (0..count).map(|i| DualQuat::from_array(M::get(poses, i).unwrap())).collect()
}

#[test]
fn one_edge_has_the_bits_of_its_samples_alone_and_in_any_layout() {
    let mut random = Random(13);
    let (paths, mounts) = street(&mut random);
    let frames = Frames::new(edges(&paths, mounts)).unwrap();
    let times: Vec<f64> = (0..301).map(|_| random.between(9.0, 14.0)).collect();
    for backend in Backend::available() {
        for outside in [Outside::Hold, Outside::Continue] {
            let [mut found, mut wanted] = [[DualQuat::<f64>::IDENTITY; 301]; 2];
            let job = frames.job().outside(outside).backend(backend);
            job.lookup("map", "odometry", &times, &mut found).unwrap();
            let path = paths[0].job().outside(outside).backend(backend);
            path.sample(&times, &mut wanted).unwrap();
            assert_eq!(found, wanted);

            job.lookup("camera", "scanner", &times, &mut found).unwrap();
            for (&time, pose) in times.iter().zip(found) {
                let mut alone = [DualQuat::<f64>::IDENTITY];
                job.lookup("camera", "scanner", &[time], &mut alone).unwrap();
                assert_eq!(alone, [pose]);
            }
            let mut blocks = [dq8::simd::Block([[7.0; 4]; 8]); 76];
            job.lookup("camera", "scanner", &times, &mut blocks).unwrap();
            assert_eq!(unpacked::<Block<f64, 4>>(&blocks, 301), found);
            // The lanes beyond the last time.
            assert_eq!(<Block<f64, 4> as Element<8>>::get(&blocks, 301), Some([7.0; 8]));
        }
    }
}

#[cfg(feature = "rayon")]
#[test]
fn any_number_of_threads_has_the_same_bits() {
    let mut random = Random(14);
    let (paths, mounts) = street(&mut random);
    let frames = Frames::new(edges(&paths, mounts)).unwrap();
    let times: Vec<f64> = (0..20_001).map(|_| random.between(9.0, 14.0)).collect();
    let mut wanted = vec![DualQuat::<f32>::IDENTITY; times.len()];
    frames.job().lookup("camera", "scanner", &times, &mut wanted).unwrap();
    for threads in [2, 3, usize::MAX] {
        let mut found = vec![DualQuat::IDENTITY; times.len()];
        frames.job().threads(threads).lookup("camera", "scanner", &times, &mut found).unwrap();
        assert_eq!(found, wanted);
        let mut blocks = vec![dq8::simd::Block([[0.0; 8]; 8]); times.len().div_ceil(8)];
        frames.job().threads(threads).lookup("camera", "scanner", &times, &mut blocks).unwrap();
        assert_eq!(unpacked::<Block<f32, 8>>(&blocks, times.len()), wanted);
    }
}

#[test]
fn the_frame_of_the_job_is_the_source_at_one_time() {
    let mut random = Random(15);
    let (paths, mounts) = street(&mut random);
    let frames = Frames::new(edges(&paths, mounts)).unwrap();
    let range = frames.range("camera", "scanner").unwrap();
    let ranges = paths.each_ref().map(OwnedTrajectory::range);
    let later = ranges.iter().fold(f64::NEG_INFINITY, |later, range| later.max(range[0]));
    let sooner = ranges.iter().fold(f64::INFINITY, |sooner, range| sooner.min(range[1]));
    assert_eq!(range, [later, sooner]);
    assert_eq!(frames.range("car", "scanner"), Ok([f64::NEG_INFINITY, f64::INFINITY]));

    let times = [10.5, range[0], range[1], 11.0, 30.0];
    let at = |frame| {
        let mut poses = [DualQuat::<f64>::IDENTITY; 5];
        frames.job().frame(frame).lookup("camera", "scanner", &times, &mut poses).unwrap();
        poses
    };
    let world = at(Frame::World);
    let cases = [(Frame::Start, world[1]), (Frame::End, world[2]), (Frame::At(11.0), world[3])];
    for (frame, pose) in cases.into_iter().chain([(Frame::Pose(mounts[0]), mounts[0])]) {
        for (found, world) in at(frame).into_iter().zip(world) {
            close(found, (pose.conjugate() * world).to_matrix4(), 1000.0, &format!("{frame:?}"));
        }
    }
}

/// Two cars side by side, a million metres from the origin of their map.
#[test]
fn a_map_a_million_metres_away_costs_single_floats_nothing() {
    let far = |x: f64, y: f64| DualQuat::from_translation([1e6 + x, 2e6 + y, 0.0]);
    let path = |y| OwnedTrajectory::new(vec![0.0, 1.0], vec![far(0.0, y), far(8.0, y)]).unwrap();
    let (left, right) = (path(3.0), path(0.0));
    let frames =
        Frames::new([Edge::moving("left", "map", &left), Edge::moving("right", "map", &right)])
            .unwrap();
    let mut poses = [DualQuat::<f32>::IDENTITY; 3];
    frames
        .job()
        .clock(0.0, 1e-9)
        .lookup("left", "right", &[0_u32, 1, 333_333_333], &mut poses)
        .unwrap();
    for pose in poses {
        let [x, y, z] = pose.translation();
        assert!(x.abs() < 1e-8 && (y + 3.0).abs() < 1e-6 && z == 0.0, "{pose:?}");
    }
}

#[test]
fn nan_stays_in_its_pose() {
    let mut random = Random(16);
    let (paths, mounts) = street(&mut random);
    let frames = Frames::new(edges(&paths, mounts)).unwrap();
    let mut times = [11.0; 200];
    for backend in Backend::available() {
        let job = frames.job().backend(backend);
        let [mut whole, mut found] = [[DualQuat::<f32>::IDENTITY; 200]; 2];
        times[131] = 11.0;
        job.lookup("camera", "scanner", &times, &mut whole).unwrap();
        times[131] = f64::NAN;
        job.lookup("camera", "scanner", &times, &mut found).unwrap();
        for (i, (found, whole)) in found.into_iter().zip(whole).enumerate() {
            if i == 131 {
                assert!(found.to_array().iter().all(|number| number.is_nan()));
            } else {
                assert_eq!(found, whole);
            }
        }
        // A fixed edge is so at any time.
        let mut fixed = [DualQuat::<f64>::IDENTITY; 2];
        job.lookup("car", "scanner", &[f64::NAN, f64::INFINITY], &mut fixed).unwrap();
        assert_eq!(fixed, [mounts[0]; 2]);
    }
}

#[test]
fn what_does_not_fit_is_refused_and_nothing_is_written() {
    use FramesError as E;
    let pose = DualQuat::<f64>::IDENTITY;
    let error = |edges: &[Edge<'_>]| Frames::new(edges.iter().copied()).err();
    let edge = |frame, parent| Edge::fixed(frame, parent, pose);
    let name = String::from;
    let twice = [edge("a", "map"), edge("b", "map"), edge("a", "b")];
    assert_eq!(error(&twice), Some(E::TwoParents { frame: name("a") }));
    assert_eq!(error(&[edge("a", "a")]), Some(E::Loop { frame: name("a") }));
    // The frame that is named is of the loop, not below it.
    let round = [edge("d", "e"), edge("e", "a"), edge("a", "b"), edge("b", "c"), edge("c", "a")];
    let Some(E::Loop { frame }) = error(&round) else { panic!("there is a loop") };
    assert!(["a", "b", "c"].contains(&&*frame));
    let bad = Edge::fixed("a", "map", DualQuat::from_translation([0.0, f64::NAN, 0.0]));
    assert_eq!(error(&[bad]), Some(E::NotFinite { frame: name("a") }));
    assert_eq!(error(&[]), None);

    let long = OwnedTrajectory::new(vec![0.0, 4.0], vec![pose; 2]).unwrap();
    let short = OwnedTrajectory::new(vec![1.0, 2.0], vec![pose; 2]).unwrap();
    let one = OwnedTrajectory::new(vec![0.0], vec![pose]).unwrap();
    let frames = Frames::new([
        Edge::moving("long", "map", &long),
        Edge::moving("short", "long", &short),
        Edge::moving("one", "map", &one),
        Edge::fixed("other", "elsewhere", pose),
    ])
    .unwrap();
    let mut poses = [DualQuat::from_translation([7.0_f32; 3]); 3];
    let job = frames.job();
    let refuse = job.outside(Outside::Refuse);
    let times = [1.0, 1.5, 3.0];
    let outside = |frame: &str, index, value, first, last| {
        Err(E::Outside { frame: frame.to_owned(), index, value, first, last })
    };
    let (target, source) = (name("other"), name("map"));
    let length = ShapeError::Length { what: "poses", length: 2, expected: 3 };
    let cases = [
        (job.lookup("map", "car", &times, &mut poses), Err(E::Unknown { frame: name("car") })),
        (job.lookup("", "map", &times, &mut poses), Err(E::Unknown { frame: name("") })),
        (job.lookup("other", "map", &times, &mut poses), Err(E::NotConnected { target, source })),
        (
            job.lookup("map", "short", &times, &mut poses[..2]),
            Err(E::Job(TrajectoryError::Shape(length))),
        ),
        (
            job.clock(0.0, 0.0).lookup("map", "short", &times, &mut poses),
            Err(E::Job(TrajectoryError::Clock { value: 0.0 })),
        ),
        (
            job.outside(Outside::Continue).lookup("map", "one", &times, &mut poses),
            Err(E::OnePose { frame: name("one") }),
        ),
        (refuse.lookup("map", "short", &times, &mut poses), outside("short", 2, 3.0, 1.0, 2.0)),
        (refuse.lookup("short", "map", &times, &mut poses), outside("short", 2, 3.0, 1.0, 2.0)),
        (
            refuse.clock(4.0, 1.0).lookup("map", "long", &times, &mut poses),
            outside("long", 0, 5.0, 0.0, 4.0),
        ),
        (
            refuse.frame(Frame::At(9.0)).lookup("map", "long", &times, &mut poses),
            Err(E::Job(TrajectoryError::NoFrame { time: 9.0 })),
        ),
    ];
    for (found, wanted) in cases {
        assert_eq!(found, wanted);
    }
    let nan = refuse.lookup("map", "long", &[1.0, f64::NAN, 1.0], &mut poses);
    assert!(matches!(nan, Err(E::Outside { index: 1, .. })));
    assert_eq!(poses, [DualQuat::from_translation([7.0; 3]); 3]);
    // Only the edges between the frames count.
    assert_eq!(refuse.lookup("map", "long", &times, &mut poses), Ok(()));
    assert_eq!(refuse.lookup::<f64, DualQuat<f32>>("map", "one", &[], &mut []), Ok(()));
}

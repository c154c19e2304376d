//! Two trajectories are compared as evo compares them; and what cannot be compared is refused.
#![cfg(feature = "std")]

use dq8::{DualQuat, Quat};
use dq8_fixtures::random::Random;
use dq8_trajectory::compare::{Align, CompareError, Errors, Pairs, Statistics, Step};
use dq8_trajectory::files::Format;
use dq8_trajectory::{OwnedTrajectory, Trajectory};

const ALL: [Align; 5] = [Align::None, Align::Origin, Align::Yaw, Align::Rigid, Align::Similarity];

/// Whole numbers from −n to n.
struct Noise(i64);

impl Noise {
    fn up_to(&mut self, n: i64) -> i64 {
        self.0 = (self.0 * 1_103_515_245 + 12_345) % (1 << 31);
        (self.0 >> 8) % (2 * n + 1) - n
    }
}

/// A reference and an estimate as TUM files, in whole centimetres and milliseconds, so that every
/// program reads the same numbers: a curve, and what a camera on it might say that began a quarter
/// turn away, sees a tenth too little, misses some poses and is milliseconds off. The second pair
/// has fewer poses in the estimate, the first one fewer in the reference.
fn files(kind: i64) -> [String; 2] {
    let mut noise = Noise(kind + 1);
    let [mut reference, mut estimate] = [String::new(), String::new()];
    let line = |ms: i64, v: [i64; 3], q: [i64; 4]| {
        let ([x, y, z], [qx, qy, qz, qw]) = (v, q);
        format!("15000{ms:08}e-3 {x}e-2 {y}e-2 {z}e-2 {qx} {qy} {qz} {qw}\n")
    };
    for k in 0..400_i64 {
        let z = 30 - k * k / 3000 + noise.up_to(3);
        let [x, y] = [5 * k, (k - 150) * (k - 150) / 40];
        let [qx, qy] = [noise.up_to(20), noise.up_to(20)];
        let [qz, qw] = [3 * k - 400, 500];
        if k % 2 == kind || k % 7 == 0 {
            reference += &line(50 * k, [x, y, z], [qx, qy, qz, qw]);
        }
        if k % 11 != 5 && (kind == 0 || k % 3 != 1) {
            let turned = [-y, x, z];
            let [x, y, z] = turned.map(|c| (9 * c).div_euclid(10) + noise.up_to(6));
            let turned = [qx - qy, qy + qx, qz + qw].map(|c| c + noise.up_to(9));
            let [qx, qy, qz, qw] = [turned[0], turned[1], turned[2], qw - qz + noise.up_to(9)];
            estimate += &line(50 * k + noise.up_to(9), [x + 700, y, z], [qx, qy, qz, qw]);
        }
    }
    [reference, estimate]
}

fn read(text: &str) -> OwnedTrajectory {
    let file = Format::Tum.parse(text.as_bytes()).unwrap();
    // Quaternions are far from unit, and nothing else is to be said.
    assert_eq!(file.warnings.len(), 1);
    file.trajectory
}

fn pairs(kind: i64) -> Pairs {
    let [reference, estimate] = files(kind).map(|text| read(&text));
    reference.pair(&estimate, 0.006).unwrap()
}

fn numbers(s: Statistics) -> [f64; 7] {
    [s.rmse, s.mean, s.median, s.std, s.min, s.max, s.sse]
}

#[test]
fn figures_are_those_of_evo() {
    let mut worst = 0.0_f64;
    let mut rows = 0;
    for line in include_str!("evo.tsv").lines().filter(|line| !line.starts_with('#')) {
        let fields: Vec<_> = line.split('\t').collect();
        let [kind, alignment, errors, of, count, wanted @ ..] = &fields[..] else {
            panic!("{line}")
        };
        let how = ALL.into_iter().find(|how| format!("{how:?}") == *alignment).unwrap();
        let pairs = pairs(kind.parse().unwrap()).align(how).unwrap();
        let wanted: Vec<f64> = wanted.iter().map(|number| number.parse().unwrap()).collect();
        let found = match *errors {
            "scale" => vec![pairs.alignment().scale],
            _ => {
                let errors = match *errors {
                    "absolute" => pairs.absolute(),
                    "Frames(1)" => pairs.relative(Step::Frames(1)).unwrap(),
                    "Frames(7)" => pairs.relative(Step::Frames(7)).unwrap(),
                    "Metres(1.5)" => pairs.relative(Step::Metres(1.5)).unwrap(),
                    _ => panic!("{line}"),
                };
                assert_eq!(errors.stamps().len(), count.parse().unwrap(), "{line}");
                match *of {
                    "translation" => numbers(errors.translation()),
                    _ => numbers(errors.rotation()),
                }
                .to_vec()
            }
        };
        assert_eq!(found.len(), wanted.len(), "{line}");
        for (found, wanted) in found.iter().zip(&wanted) {
            worst = worst.max((found - wanted).abs() / wanted.abs().max(0.1));
        }
        rows += 1;
    }
    assert_eq!(rows, 66);
    assert!(worst < 2e-13, "{worst}");
}

/// A path through `count` random poses within `size` metres of a place, a second apart.
fn path(seed: u64, count: usize, size: f64, place: [f64; 3]) -> OwnedTrajectory {
    let mut random = Random(seed);
    let place = DualQuat::from_translation(place);
    let poses = (0..count).map(|_| place * random.motion(size)).collect();
    OwnedTrajectory::new((0..count).map(|k| k as f64).collect(), poses).unwrap()
}

fn mapped(
    path: &OwnedTrajectory,
    map: impl FnMut(DualQuat<f64>) -> DualQuat<f64>,
) -> OwnedTrajectory {
    let poses = path.poses().iter().copied().map(map).collect();
    OwnedTrajectory::new(path.stamps().to_vec(), poses).unwrap()
}

fn scaled(pose: DualQuat<f64>, scale: f64) -> DualQuat<f64> {
    pose.with_translation(pose.translation().map(|c| c * scale))
}

fn sse(errors: &Errors) -> f64 {
    errors.translation().sse
}

#[test]
fn what_was_moved_is_laid_back_exactly() {
    let mut random = Random(5);
    for (seed, count) in (0..200).map(|seed| (seed, 3 + seed as usize % 9)) {
        let reference = path(seed, count, 10.0, [3.0, -2.0, 5.0]);
        let motion = random.motion(20.0);
        let yaw = DualQuat::from_rotation_z(random.between(-3.1, 3.1))
            .with_translation(random.vector::<3>().map(|c| 20.0 * c));
        let scale = random.between(0.1, 10.0);
        for (how, moved) in [
            (Align::Origin, mapped(&reference, |pose| motion * pose)),
            (Align::Rigid, mapped(&reference, |pose| motion * pose)),
            (Align::Yaw, mapped(&reference, |pose| yaw * pose)),
            (Align::Similarity, mapped(&reference, |pose| scaled(motion * pose, scale))),
        ] {
            let pairs = reference.pair(&moved, 0.0).unwrap().align(how).unwrap();
            let errors = pairs.absolute();
            let bound = 3e-13;
            assert!(errors.translation().max < bound, "{how:?} {:?}", errors.translation());
            assert!(errors.rotation().max < bound, "{how:?} {:?}", errors.rotation());
            let found = pairs.alignment();
            let wanted = if how == Align::Similarity { 1.0 / scale } else { 1.0 };
            assert!((found.scale - wanted).abs() < 1e-13 * wanted, "{how:?}");
            // The map is the one that the poses went through.
            let point = moved.poses()[1].translation().map(|c| c * found.scale);
            let there = found.motion.transform_point(point);
            for (a, b) in there.into_iter().zip(reference.poses()[1].translation()) {
                assert!((a - b).abs() < bound, "{how:?}");
            }
        }
    }
}

/// Nothing fits noise, and then no other rotation, shift or scale fits better. Where the noise
/// mirrors, as it does for half of the paths in a plane, the rotation is one all the same.
#[test]
fn no_other_alignment_is_better() {
    let mut random = Random(6);
    let mut mirrors = 0;
    for seed in 0..60 {
        let reference = path(seed, 7, 10.0, [0.0; 3]);
        let flat = if seed % 2 == 0 { 1.0 } else { 1e-3 };
        let estimate = mapped(&path(seed + 1000, 7, 10.0, [0.0; 3]), |pose| {
            let [x, y, z] = pose.translation();
            pose.with_translation([x, y, flat * z])
        });
        for how in [Align::Yaw, Align::Rigid, Align::Similarity] {
            let pairs = reference.pair(&estimate, 0.0).unwrap();
            let aligned = pairs.align(how).unwrap();
            let best = sse(&aligned.absolute());
            let positions: Vec<_> = aligned.estimate().iter().map(|p| p.translation).collect();
            for _ in 0..40 {
                let size = 10.0_f64.powf(random.between(-4.0, 0.5));
                let axis =
                    if how == Align::Yaw { [0.0, 0.0, 1.0] } else { random.direction::<3>() };
                let turn = Quat::from_axis_angle(axis, size);
                let shift = random.vector::<3>().map(|c| c * size);
                let scale = if how == Align::Similarity { 1.0 + 0.1 * size } else { 1.0 };
                let other = DualQuat::from_rotation_translation(turn, shift);
                let mut sum = 0.0;
                for (p, q) in positions.iter().zip(aligned.reference()) {
                    let p = other.transform_point(p.map(|c| c * scale));
                    sum += (0..3).map(|i| (p[i] - q.translation[i]).powi(2)).sum::<f64>();
                }
                assert!(sum >= best * (1.0 - 1e-13), "{how:?}: {sum} {best}");
            }
            if how == Align::Rigid {
                mirrors += usize::from(mirrored(&estimate, &reference));
            }
        }
    }
    assert!(mirrors > 10, "{mirrors} of 60");
}

/// The determinant of Σ y xᵀ is negative: the nearest orthogonal matrix mirrors.
fn mirrored(x: &OwnedTrajectory, y: &OwnedTrajectory) -> bool {
    let center = |path: &OwnedTrajectory| {
        let sum = path.poses().iter().fold([0.0; 3], |sum, pose| {
            let t = pose.translation();
            [sum[0] + t[0], sum[1] + t[1], sum[2] + t[2]]
        });
        sum.map(|c| c / path.poses().len() as f64)
    };
    let [a, b] = [center(x), center(y)];
    let mut m = [[0.0; 3]; 3];
    for (x, y) in x.poses().iter().zip(y.poses()) {
        let (x, y) = (x.translation(), y.translation());
        for i in 0..3 {
            for j in 0..3 {
                m[i][j] += (y[i] - b[i]) * (x[j] - a[j]);
            }
        }
    }
    let minor = |j: usize, k: usize| m[1][j] * m[2][k] - m[1][k] * m[2][j];
    m[0][0] * minor(1, 2) - m[0][1] * minor(0, 2) + m[0][2] * minor(0, 1) < 0.0
}

/// By the definition: of all poses of the longer one the nearest, the earlier of two.
#[test]
fn partners_are_the_nearest_in_time() {
    let mut random = Random(8);
    for round in 0..300 {
        let mut stamps = |count: usize| -> Vec<f64> {
            // Eighths of a second, so that many are as near as each other.
            let mut stamps: Vec<_> = (0..count).map(|_| random.below(80) as f64 / 8.0).collect();
            stamps.sort_by(f64::total_cmp);
            stamps.dedup();
            stamps
        };
        let [a, b] = [stamps(1 + round % 30), stamps(1 + round / 10)];
        let [a, b] = [a, b].map(|stamps| {
            let poses = stamps.iter().map(|&t| DualQuat::from_translation([t, 0.0, 0.0])).collect();
            OwnedTrajectory::new(stamps, poses).unwrap()
        });
        for tolerance in [0.0, 0.125, 0.3, f64::INFINITY] {
            let few_are_a = b.stamps().len() > a.stamps().len();
            let (few, many) = if few_are_a { (&a, &b) } else { (&b, &a) };
            let mut wanted = Vec::new();
            for &stamp in few.stamps() {
                let mut nearest = many.stamps()[0];
                for &other in many.stamps() {
                    if (other - stamp).abs() < (nearest - stamp).abs() {
                        nearest = other;
                    }
                }
                if (nearest - stamp).abs() <= tolerance {
                    wanted.push(if few_are_a { [stamp, nearest] } else { [nearest, stamp] });
                }
            }
            let found = match a.pair(&b, tolerance) {
                Ok(pairs) => {
                    let x =
                        |pose: &dq8::representation::RotationTranslation<f64>| pose.translation[0];
                    let found: Vec<_> = { pairs.reference().iter() }
                        .zip(pairs.estimate())
                        .map(|(a, b)| [x(a), x(b)])
                        .collect();
                    assert!(
                        found.iter().zip(pairs.stamps()).all(|(pair, &stamp)| pair[0] == stamp)
                    );
                    found
                }
                Err(error) => {
                    let (reference, estimate) = (a.range(), b.range());
                    assert_eq!(error, CompareError::NoPairs { reference, estimate });
                    vec![]
                }
            };
            assert_eq!(found, wanted);
        }
    }
}

/// Far away stamps differ by less than their rounding from each other, and the nearest is still
/// found.
#[test]
fn stamps_far_from_each_other_have_no_partner_and_hide_none() {
    let poses = |count| vec![DualQuat::IDENTITY; count];
    let reference = OwnedTrajectory::new(vec![0.0, 1.0, 2.0, 1e17], poses(4)).unwrap();
    let estimate = OwnedTrajectory::new(vec![1e17], poses(1)).unwrap();
    assert_eq!(reference.pair(&estimate, 1.0).unwrap().stamps(), [1e17]);
}

#[test]
fn the_estimate_is_taken_at_the_times_of_the_reference() {
    let reference = path(1, 9, 10.0, [0.0; 3]);
    let every_other = |k: usize| (reference.stamps()[2 * k + 1], reference.poses()[2 * k + 1]);
    let (stamps, poses): (Vec<_>, Vec<_>) = (0..3).map(every_other).unzip();
    let estimate = OwnedTrajectory::new(stamps, poses).unwrap();
    let pairs = reference.interpolated(&estimate).unwrap();
    // From its first stamp to its last one, both among them.
    assert_eq!(pairs.stamps(), [1.0, 2.0, 3.0, 4.0, 5.0]);
    for (stamp, pose) in pairs.stamps().iter().zip(pairs.estimate()) {
        assert_eq!(pose.translation, estimate.at(*stamp).translation());
    }
    let errors = pairs.absolute();
    assert!([0, 2, 4].iter().all(|&k| errors.translations()[k] < 1e-14));
    assert!(errors.translations()[1] > 0.1);
    let later = OwnedTrajectory::new(vec![8.5, 9.0], vec![DualQuat::IDENTITY; 2]).unwrap();
    let error = reference.interpolated(&later).unwrap_err();
    let wanted = CompareError::NoPairs { reference: [0.0, 8.0], estimate: [8.5, 9.0] };
    assert_eq!(error, wanted);
    // Between two stamps of the reference.
    let between = OwnedTrajectory::new(vec![1.1, 1.2], vec![DualQuat::IDENTITY; 2]).unwrap();
    assert!(reference.interpolated(&between).is_err());
}

#[test]
fn steps_in_seconds_do_not_suffer_from_rounded_stamps() {
    let stamps: Vec<_> = (0..101).map(|k| 1.7e9 + 0.1 * f64::from(k)).collect();
    let poses = vec![DualQuat::IDENTITY; stamps.len()];
    let path = OwnedTrajectory::new(stamps, poses).unwrap();
    let pairs = path.pair(&path, 0.0).unwrap();
    let count = |step| pairs.relative(step).unwrap().stamps().len();
    assert_eq!([0.1, 0.3, 0.5, 1.0, 10.0].map(|s| count(Step::Seconds(s))), [100, 33, 20, 10, 1]);
    // Neither of whole ones: a step ends at the first pose that is not too early.
    assert_eq!(count(Step::Seconds(0.25)), 33);
    assert_eq!([1, 3, 100].map(|n| count(Step::Frames(n))), [100, 33, 1]);
    let ends = pairs.relative(Step::Frames(40)).unwrap();
    assert_eq!(ends.stamps(), [1.7e9 + 4.0, 1.7e9 + 8.0]);
}

/// Motions far from the origin are compared by differences of positions.
#[test]
fn relative_errors_far_away_are_those_near_the_origin() {
    let (near, far) = (path(3, 50, 10.0, [0.0; 3]), path(3, 50, 10.0, [1e6, -1e6, 0.0]));
    let nudged = |path: &OwnedTrajectory| {
        mapped(path, |pose| {
            pose * DualQuat::from_rotation_z(1e-3).with_translation([0.1, 0.0, 0.0])
        })
    };
    let errors = |path: &OwnedTrajectory| {
        let pairs = path.pair(&nudged(path), 0.0).unwrap();
        pairs.relative(Step::Frames(1)).unwrap().translation().rmse
    };
    let [near, far] = [errors(&near), errors(&far)];
    // A stored translation of 10⁶ m is good to some 10⁻⁹ m.
    assert!((near - far).abs() < 1e-9, "{near} {far}");
}

#[test]
fn the_median_lies_between_two() {
    let reference = path(1, 4, 0.0, [0.0; 3]);
    let lengths = [5.0, 1.0, 3.0, 7.0];
    let mut k = 0;
    let estimate = mapped(&reference, |_| {
        k += 1;
        DualQuat::from_translation([0.0, lengths[k - 1], 0.0])
    });
    let reference = mapped(&reference, |_| DualQuat::IDENTITY);
    let errors = reference.pair(&estimate, 0.0).unwrap().absolute();
    assert_eq!(errors.translations(), lengths);
    let s = errors.translation();
    let wanted = [21.0_f64.sqrt(), 4.0, 4.0, 5.0_f64.sqrt(), 1.0, 7.0, 84.0];
    assert_eq!(numbers(s), wanted);
}

#[test]
fn what_cannot_be_compared_is_refused() {
    let reference = path(1, 5, 10.0, [0.0; 3]);
    let nan = f64::NAN;
    for value in [-1e-300, f64::NEG_INFINITY] {
        let error = reference.pair(&reference, value).unwrap_err();
        assert_eq!(error, CompareError::Tolerance { value });
    }
    assert!(matches!(reference.pair(&reference, nan), Err(CompareError::Tolerance { .. })));

    // A pose that is not finite, by its number in its own trajectory.
    let stamps = [1.5, 2.0, 3.0, 4.0];
    let mut poses = [DualQuat::IDENTITY; 4];
    poses[2] = poses[2].scale(nan);
    let broken = Trajectory::new(&stamps, &poses).unwrap();
    let error = reference.pair(broken, 0.0).unwrap_err();
    assert_eq!(error, CompareError::NotFinite { what: "estimate", index: 2 });
    let error = broken.pair(&reference, 0.0).unwrap_err();
    assert_eq!(error, CompareError::NotFinite { what: "reference", index: 2 });
    let error = reference.interpolated(broken).unwrap_err();
    assert!(matches!(error, CompareError::NotFinite { what: "estimate", index: 1 | 2 }), "{error}");

    // On a line, with rounding; in a point; of one pose; above each other.
    let line = mapped(&reference, |pose| {
        let t = pose.translation()[0];
        pose.with_translation([0.1 * t, 0.3 * t + 100.0, 0.7 * t])
    });
    let point = mapped(&reference, |pose| pose.with_translation([1e5, 0.1, 7.0]));
    let column = mapped(&reference, |pose| {
        let [_, _, z] = pose.translation();
        pose.with_translation([0.1, 1e5, z])
    });
    let far_line = mapped(&line, |pose| DualQuat::from_translation([5e6, 4e5, 0.0]) * pose);
    for (how, path) in [
        (Align::Rigid, &far_line),
        (Align::Rigid, &line),
        (Align::Similarity, &line),
        (Align::Rigid, &point),
        (Align::Yaw, &point),
        (Align::Yaw, &column),
    ] {
        let pairs = path.pair(&reference, 0.0).unwrap();
        let error = pairs.clone().align(how).unwrap_err();
        assert_eq!(error, CompareError::Ambiguous { pairs: 5 }, "{how:?}");
        // A line says where it begins, and how it is seen from above.
        assert!(pairs.align(Align::Origin).is_ok());
    }
    assert!(line.pair(&reference, 0.0).unwrap().align(Align::Yaw).is_ok());
    let far = mapped(&reference, |pose| scaled(pose, 1e160));
    for how in [Align::Yaw, Align::Rigid, Align::Similarity] {
        assert!(reference.pair(&far, 0.0).unwrap().align(how).is_err(), "{how:?}");
        assert!(far.pair(&far, 0.0).unwrap().align(how).is_err(), "{how:?}");
    }

    let pairs = reference.pair(&reference, 0.0).unwrap();
    for step in [
        Step::Frames(0),
        Step::Metres(0.0),
        Step::Metres(nan),
        Step::Metres(f64::INFINITY),
        Step::Seconds(-1.0),
        Step::Seconds(0.0),
    ] {
        let error = pairs.relative(step).unwrap_err();
        assert!(matches!(error, CompareError::Step { .. }), "{error}");
    }
    for step in [Step::Frames(5), Step::Frames(usize::MAX), Step::Metres(1e4), Step::Seconds(4.5)] {
        let error = pairs.relative(step).unwrap_err();
        assert_eq!(error, CompareError::NoSteps { step, pairs: 5 });
        assert!(error.to_string().starts_with("no two of 5 pairs are "), "{error}");
    }
    // Angles of a whole turn and of the other sign are none.
    let flipped = mapped(&reference, |pose| -pose);
    let errors = reference.pair(&flipped, 0.0).unwrap().absolute();
    assert!(errors.rotation().max < 1e-15);
}

//! Files: all digits come back, what other programs write is read, and what is no pose is an error
//! that names its line.
#![cfg(feature = "std")]

use dq8::{DualQuat, Quat};
use dq8_fixtures::random::Random;
use dq8_trajectory::files::{FileError, Format, Recording, Warning, read};
use dq8_trajectory::{OwnedTrajectory, TrajectoryError};

const FORMATS: [Format; 3] = [Format::Tum, Format::Euroc, Format::Kitti];

fn path(count: usize, stamp: impl Fn(usize) -> f64) -> OwnedTrajectory {
    let mut random = Random(7);
    let poses = (0..count).map(|_| random.motion(1e3)).collect();
    OwnedTrajectory::new((0..count).map(stamp).collect(), poses).unwrap()
}

fn written(format: Format, path: &OwnedTrajectory) -> Vec<u8> {
    let mut text = Vec::new();
    format.write(path.view(), &mut text).unwrap();
    text
}

/// The largest difference of translations, in metres, and of rotations up to their sign.
fn differences(a: &OwnedTrajectory, b: &OwnedTrajectory) -> [f64; 2] {
    let mut largest = [0.0_f64; 2];
    for (a, b) in a.poses().iter().zip(b.poses()) {
        for (x, y) in a.translation().into_iter().zip(b.translation()) {
            largest[0] = largest[0].max((x - y).abs());
        }
        let [p, q] = [a.rotation(), b.rotation()];
        largest[1] = largest[1].max((p - q).norm().min((p + q).norm()));
    }
    largest
}

#[test]
fn what_is_written_is_read_again_to_the_last_digits() {
    // Stamps since 1970 at 200 Hz, in whole nanoseconds; and from before zero.
    let since_1970 = path(500, |k| 1_403_636_579.763_555_5 + 0.005 * k as f64);
    let small = path(40, |k| (k as f64 - 20.0) / 8.0);
    for (path, format) in [&since_1970, &small].into_iter().flat_map(|p| FORMATS.map(|f| (p, f))) {
        let text = written(format, path);
        assert_eq!(Format::guess(&text).unwrap(), format);
        let Recording { trajectory, warnings, .. } = format.parse(&text).unwrap();
        assert_eq!(warnings, []);
        if format == Format::Kitti {
            let frames: Vec<_> = (0..path.stamps().len()).map(|k| k as f64).collect();
            assert_eq!(trajectory.stamps(), frames);
        } else {
            assert_eq!(trajectory.stamps(), path.stamps(), "{format:?}");
        }
        let [metres, turns] = differences(path, &trajectory);
        assert!(metres < 1e-12 && turns < 2e-15, "{format:?}: {metres} {turns}");
    }
}

#[test]
fn nanoseconds_are_written_whole_and_read_as_the_nearest_stamp() {
    let text = b"1436378608205740996,0,0,0,1,0,0,0\n-1500000001,0,0,0,1,0,0,0\n2.5e9,0,0,0,1,0,0,0";
    let file = Format::Euroc.parse(text).unwrap();
    // The literals are the nearest numbers; 1436378608205740996.0 / 1e9 is another one.
    assert_eq!(file.trajectory.stamps(), [-1.500000001, 2.5, 1_436_378_608.205_741]);
    // A third of a nanosecond is none; what rounds up to a second is one.
    let stamps = vec![-0.999_999_999_9, 3.3e-10, 0.999_999_999_7, 2.999_999_999_9, 1e12];
    let path = OwnedTrajectory::new(stamps, vec![DualQuat::IDENTITY; 5]).unwrap();
    let text = String::from_utf8(written(Format::Euroc, &path)).unwrap();
    let mut found = text.lines().skip(1).map(|line| line.split_once(',').unwrap().0);
    for wanted in ["-1000000000", "0", "1000000000", "3000000000", "1000000000000000000000"] {
        assert_eq!(found.next(), Some(wanted));
    }
}

#[test]
fn what_other_programs_write_is_read() {
    // A mark, comments in Latin-1, lines of Windows, tabs, blanks at both ends, empty lines,
    // numbers in all spellings, no end of the last line.
    let text = b"\xef\xbb\xbf# Gel\xe4nde\r\n\r\n 1.5\t1  -2. +.5e1 0 0 0 1 \r\n  # and\n2 0 0 0 -0 0 0 -1";
    let file = Format::Tum.parse(text).unwrap();
    assert_eq!(file.trajectory.stamps(), [1.5, 2.0]);
    assert_eq!(file.trajectory.at(1.5).translation(), [1.0, -2.0, 5.0]);
    assert_eq!(file.warnings, []);
    assert_eq!(Format::guess(text).unwrap(), Format::Tum);
    // EuRoC's ground truth goes on with velocities and biases, of which nothing is asked.
    let text = b"#timestamp, p_RS_R_x [m]\n1000000000, 1,2,3, 0,1,0,0, nothing,\n";
    let file = Format::Euroc.parse(text).unwrap();
    assert_eq!(file.trajectory.stamps(), [1.0]);
    assert_eq!(file.trajectory.poses()[0].rotation(), Quat::from_xyzw(1.0, 0.0, 0.0, 0.0));
}

#[test]
fn what_is_put_right_is_said_once() {
    // Lengths of 2, 10³⁰⁰ and 10⁻³¹⁰; digits of a thousandth; and unsorted twice, a
    // stamp thrice.
    let text = b"3 0 0 0 0 0 0 2\n2 0 0 0 1e300 0 0 0\n2 1 0 0 0 1e-310 0 0\n\
        1 0 0 0 0.707 0 0 -0.707\n2 2 0 0 0 0 0 1";
    let file = Format::Tum.parse(text).unwrap();
    assert_eq!(file.trajectory.stamps(), [1.0, 2.0, 3.0]);
    let poses = file.trajectory.poses();
    assert!(poses.iter().all(|pose| pose.is_unit(1e-15)));
    assert_eq!(poses[1], DualQuat::from_rotation(Quat::from_xyzw(1.0, 0.0, 0.0, 0.0)));
    let expected = [
        Warning::Unsorted { line: 2, stamp: 2.0 },
        Warning::EqualStamps { dropped: 2 },
        Warning::NotUnit { line: 1, norm: 2.0, count: 3 },
    ];
    assert_eq!(file.warnings, expected);
    assert!(file.warnings[2].to_string().contains("line 1: the quaternion has length 2, and 3"));

    // Equal stamps that follow each other are not out of order.
    let file = Format::Tum.parse(b"1 0 0 0 0 0 0 1\n1 2 0 0 0 0 0 1").unwrap();
    assert_eq!(file.warnings, [Warning::EqualStamps { dropped: 1 }]);

    // Six digits are within rounding; a matrix that scales is not, and its rotation is found.
    let text = b"0 -1.00001 0 5 1 0 0 6 0 0 1 7\n0 -2 0 5 2 0 0 6 0 0 2 7";
    let file = Format::Kitti.parse(text).unwrap();
    assert_eq!(file.warnings, [Warning::NotOrthonormal { line: 2, off: 3.0, count: 1 }]);
    let quarter = Quat::from_axis_angle([0.0, 0.0, 1.0], core::f64::consts::FRAC_PI_2);
    for pose in file.trajectory.poses() {
        assert!((pose.rotation() - quarter).norm() < 1e-15);
        let off = pose.translation().into_iter().zip([5.0, 6.0, 7.0]).map(|(a, b)| (a - b).abs());
        assert!(off.fold(0.0, f64::max) < 1e-14);
    }
}

/// The nearest rotation to a matrix with six digits is taken: that of the rows as they stand would
/// be off by as much as they are.
#[test]
fn matrices_of_few_digits_give_the_nearest_rotation() {
    let path = path(200, |k| k as f64);
    let mut text = String::new();
    for pose in path.poses() {
        let numbers = pose.to_matrix3x4();
        let numbers: Vec<_> = numbers.as_flattened().iter().map(|x| format!("{x:.6e}")).collect();
        text += &(numbers.join(" ") + "\n");
    }
    let file = Format::Kitti.parse(text.as_bytes()).unwrap();
    assert_eq!(file.warnings, []);
    assert!(differences(&path, &file.trajectory)[1] < 5e-7);
    assert!(file.trajectory.poses().iter().all(|pose| pose.is_unit(1e-12)));
}

#[test]
fn errors_name_the_line_and_what_stands_there() {
    let text =
        |format: Format, text: String| format.parse(text.as_bytes()).unwrap_err().to_string();
    let tum = |lines: &str| text(Format::Tum, lines.into());
    let good = "1 0 0 0 0 0 0 1\n";
    assert_eq!(tum(""), "a trajectory needs at least one pose");
    assert_eq!(tum("# 1 0 0 0 0 0 0 1\n\n"), "a trajectory needs at least one pose");
    assert_eq!(tum(&format!("{good}\n2 0 0")), "line 3 has 3 fields where 8 are needed");
    assert_eq!(tum("1 0 0 0 0 0 0 1 5 6"), "line 1 has 10 fields where 8 are needed");
    for bad in ["nan", "inf", "-Infinity", "1e999", "1e301", "1,5", "0x10", "1_0", "π"] {
        let found = tum(&format!("{good}# here\n2 0 0 {bad} 0 0 0 1"));
        assert_eq!(found, format!("line 3, field 4: {bad:?} is not a finite number"));
    }
    let long = tum(&format!("1 0 0 {} 0 0 0 1", "é".repeat(1000)));
    assert_eq!(long, format!("line 1, field 4: \"{}\" is not a finite number", "é".repeat(40)));
    assert_eq!(
        tum(&format!("{good}2 1 1 1 0 -0 0 0")),
        "line 2: the quaternion is zero, which is no rotation"
    );

    let euroc = |lines: &str| text(Format::Euroc, lines.into());
    // An empty field is not skipped: all behind it would be another number.
    assert_eq!(euroc("1,2,,3,1,0,0,0,9"), "line 1, field 3: \"\" is not a finite number");
    assert_eq!(euroc("timestamp,x\n"), "line 1, field 1: \"timestamp\" is not a finite number");
    assert_eq!(euroc("1,2,3"), "line 1 has 3 fields where 8 are needed");

    let kitti = |lines: &str| text(Format::Kitti, lines.into());
    let mirror = kitti("1 0 0 0 0 1 0 0 0 0 -1 0");
    assert_eq!(mirror, "line 1: the matrix is near no rotation: its determinant is -1");
    assert!(kitti("0 0 0 0 0 0 0 0 0 0 0 0").contains("determinant is 0"));
    assert!(kitti("3 0 0 0 0 0 0 0 0 0 0 0").contains("near no rotation"));

    let unknown = Format::guess(b"# x\n1 2 3").unwrap_err();
    assert!(matches!(unknown, FileError::Unknown { line: 2, fields: 3 }), "{unknown}");
    let empty = Format::guess(b"\n#");
    assert!(matches!(empty, Err(FileError::Trajectory(TrajectoryError::Empty))));
    let missing = read("no/such/file").unwrap_err();
    assert!(missing.to_string().starts_with("cannot read no/such/file: "), "{missing}");
    assert!(std::error::Error::source(&missing).is_some());
}

#[test]
fn no_text_makes_a_panic() {
    let mut random = Random(11);
    let path = path(6, |k| k as f64);
    let pieces: [&[u8]; 16] = [
        b" ",
        b"\n",
        b"\r",
        b",",
        b"#",
        b"-",
        b"e",
        b".",
        b"9",
        b"0",
        b"nan",
        b"\xff",
        b"\xef\xbb\xbf",
        b"1e300",
        b"0 0 0 0",
        b"1 ",
    ];
    let (mut read, mut refused) = (0, 0);
    for _ in 0..3000 {
        for format in FORMATS {
            let mut text = written(format, &path);
            for _ in 0..1 + random.below(4) {
                let at = random.below(text.len());
                let to = (at + random.below(40)).min(text.len());
                let piece = pieces[random.below(pieces.len())];
                text.splice(at..to, piece.iter().copied());
            }
            let _ = Format::guess(&text);
            match format.parse(&text) {
                Ok(file) => {
                    assert!(file.trajectory.poses().iter().all(|pose| pose.is_unit(1e-9)));
                    read += 1;
                }
                Err(error) => refused += usize::from(!error.to_string().is_empty()),
            }
        }
    }
    assert!(read > 200 && refused > 200, "{read} {refused}");
}

#[test]
fn files_are_read_by_name() {
    let folder = std::env::temp_dir().join(format!("dq8-trajectory-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let (name, path) = (folder.join("path.txt"), path(20, |k| k as f64));
    for format in FORMATS {
        format.write(path.view(), std::fs::File::create(&name).unwrap()).unwrap();
        for file in [read(&name).unwrap(), format.read(&name).unwrap()] {
            assert!(differences(&path, &file.trajectory)[0] < 1e-12);
        }
    }
    std::fs::remove_dir_all(&folder).unwrap();
}

//! Text into poses, line by line.

use super::error::FileError;
use super::format::Format;
use super::warning::Warning;
use crate::{OwnedTrajectory, TrajectoryError};
use alloc::borrow::Cow;
use alloc::string::String;
use alloc::vec::Vec;
use dq8::representation::Polar;
use dq8::{DualQuat, Quat};
use std::path::Path;

/// The content of a file.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Recording {
    /// The poses at their stamps.
    pub trajectory: OwnedTrajectory,
    /// The faults that were put right, each kind once.
    pub warnings: Vec<Warning>,
}

/// Larger numbers overflow in products.
const LARGEST: f64 = 1e300;

/// A number that is off by more than this was not merely rounded when it was printed.
const ROUNDED: f64 = 1e-3;

/// Reads a file of the format that its first line with numbers is of.
///
/// # Errors
/// If the file cannot be read, is of no known format, and as [`Format::parse`].
pub fn read(path: impl AsRef<Path>) -> Result<Recording, FileError> {
    let bytes = bytes(path.as_ref())?;
    let text = decoded(&bytes);
    Format::of(&text)?.poses(&text)
}

/// Bytes that are no UTF-8 may stand in comments.
fn decoded(bytes: &[u8]) -> Cow<'_, str> {
    // Quicker than the other one, which would do as well.
    core::str::from_utf8(bytes).map_or_else(|_| String::from_utf8_lossy(bytes), Cow::Borrowed)
}

fn bytes(path: &Path) -> Result<Vec<u8>, FileError> {
    std::fs::read(path)
        .map_err(|source| FileError::Read { path: path.to_string_lossy().into_owned(), source })
}

impl Format {
    /// The format of a text by its first line with numbers: commas are EuRoC's, eight fields TUM's,
    /// twelve KITTI's.
    ///
    /// # Errors
    /// If there is no such line, or it is none of these.
    pub fn guess(text: &[u8]) -> Result<Self, FileError> {
        Self::of(&decoded(text))
    }

    fn of(text: &str) -> Result<Self, FileError> {
        let (line, first) = lines(text).next().ok_or(TrajectoryError::Empty)?;
        match first.split_ascii_whitespace().count() {
            _ if first.contains(',') => Ok(Self::Euroc),
            8 => Ok(Self::Tum),
            12 => Ok(Self::Kitti),
            fields => Err(FileError::Unknown { line, fields }),
        }
    }

    /// Reads a file of this format.
    ///
    /// # Errors
    /// If the file cannot be read, and as [`parse`](Self::parse).
    pub fn read(self, path: impl AsRef<Path>) -> Result<Recording, FileError> {
        self.parse(&bytes(path.as_ref())?)
    }

    /// Poses and stamps from a text of this format, in time that grows with its length (and, where
    /// stamps do not rise, with sorting them).
    ///
    /// ```
    /// use dq8_trajectory::files::{Format, Warning};
    /// let text = b"# stamp x y z qx qy qz qw
    /// 0.2  3 0 0  0 0 0 1
    /// 0.1  1 0 0  0 0 0 1
    /// 0.2  9 9 9  0 0 0 1
    /// ";
    /// let file = Format::Tum.parse(text)?;
    /// assert_eq!(file.trajectory.stamps(), [0.1, 0.2]);
    /// assert_eq!(file.trajectory.at(0.2).translation(), [3.0, 0.0, 0.0]);
    /// let unsorted = Warning::Unsorted { line: 3, stamp: 0.1 };
    /// assert_eq!(file.warnings, [unsorted, Warning::EqualStamps { dropped: 1 }]);
    /// let error = Format::Tum.parse(b"0.1 1 0 zero 0 0 0 1").unwrap_err();
    /// assert_eq!(error.to_string(), "line 1, field 4: \"zero\" is not a finite number");
    /// # Ok::<(), dq8_trajectory::files::FileError>(())
    /// ```
    ///
    /// # Errors
    /// If no line holds a pose; a line has too few fields (or too many, but in EuRoC's format); a
    /// field is no finite number, or larger than 10³⁰⁰; a quaternion is zero; or a matrix
    /// mirrors, or has no nearest rotation.
    pub fn parse(self, text: &[u8]) -> Result<Recording, FileError> {
        self.poses(&decoded(text))
    }

    fn poses(self, text: &str) -> Result<Recording, FileError> {
        let mut found = Found::default();
        for (line, fields) in lines(text) {
            let (stamp, pose) = match self {
                Self::Tum => {
                    let [stamp, x, y, z, rotation @ ..] =
                        numbers::<8>(line, fields.split_ascii_whitespace(), false)?;
                    (stamp, found.pose(line, rotation, [x, y, z])?)
                }
                Self::Euroc => {
                    let [stamp, x, y, z, qw, qx, qy, qz] =
                        numbers::<8>(line, fields.split(',').map(str::trim), true)?;
                    let stamp = seconds(fields).unwrap_or(stamp / 1e9);
                    (stamp, found.pose(line, [qx, qy, qz, qw], [x, y, z])?)
                }
                Self::Kitti => {
                    let [a, b, c, x, d, e, f, y, g, h, i, z] =
                        numbers::<12>(line, fields.split_ascii_whitespace(), false)?;
                    let rotation = found.rotation(line, [[a, b, c], [d, e, f], [g, h, i]])?;
                    let pose = DualQuat::from_rotation_translation(rotation, [x, y, z]);
                    (found.poses.len() as f64, pose)
                }
            };
            if found.unsorted.is_none() && found.stamps.last().is_some_and(|&last| stamp < last) {
                found.unsorted = Some(Warning::Unsorted { line, stamp });
            }
            found.stamps.push(stamp);
            found.poses.push(pose);
        }
        found.recording()
    }
}

/// The lines that hold something, with their numbers.
fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let lines = text.lines().enumerate().map(|(index, line)| (index + 1, line.trim_ascii()));
    lines.filter(|(_, line)| !line.is_empty() && !line.starts_with('#'))
}

/// The fields of a line, of which there may be more if `open`.
fn numbers<'a, const N: usize>(
    line: usize,
    mut fields: impl Iterator<Item = &'a str>,
    open: bool,
) -> Result<[f64; N], FileError> {
    let mut numbers = [0.0; N];
    for (index, number) in numbers.iter_mut().enumerate() {
        let Some(text) = fields.next() else {
            return Err(FileError::Fields { line, found: index, expected: N });
        };
        *number = match text.parse::<f64>() {
            Ok(value) if value.abs() <= LARGEST => value,
            _ => {
                let text = text.chars().take(40).collect();
                return Err(FileError::NotANumber { line, field: index + 1, text });
            }
        };
    }
    let more = if open { 0 } else { fields.count() };
    if more > 0 {
        return Err(FileError::Fields { line, found: N + more, expected: N });
    }
    Ok(numbers)
}

/// The seconds of the whole nanoseconds that a line begins with, rounded once: as one number they
/// would have been rounded before the division too.
fn seconds(line: &str) -> Option<f64> {
    const SECOND: i64 = 1_000_000_000;
    let stamp: i64 = line.split(',').next()?.trim_ascii().parse().ok()?;
    Some((stamp / SECOND) as f64 + (stamp % SECOND) as f64 / 1e9)
}

#[derive(Default)]
struct Found {
    stamps: Vec<f64>,
    poses: Vec<DualQuat<f64>>,
    unsorted: Option<Warning>,
    /// The first line with a rotation that is none, by how much, and the number of them.
    off: Option<(usize, f64, usize)>,
    /// Rotations are matrices.
    matrices: bool,
}

impl Found {
    fn off(&mut self, line: usize, off: f64) {
        self.off.get_or_insert((line, off, 0)).2 += 1;
    }

    fn pose(
        &mut self,
        line: usize,
        xyzw: [f64; 4],
        translation: [f64; 3],
    ) -> Result<DualQuat<f64>, FileError> {
        let rotation = Quat::from_array(xyzw);
        let unit = rotation.try_normalize().map_err(|_| FileError::NoRotation { line })?;
        let norm = rotation.norm();
        if (norm - 1.0).abs() > ROUNDED {
            self.off(line, norm);
        }
        Ok(DualQuat::from_rotation_translation(unit, translation))
    }

    fn rotation(&mut self, line: usize, rows: [[f64; 3]; 3]) -> Result<Quat<f64>, FileError> {
        self.matrices = true;
        // Printed with all digits, as here: no other rotation is nearer.
        if let Ok(rotation) = Quat::try_from_matrix3(rows, 1e-14) {
            return Ok(rotation);
        }
        let [a, b, c] = rows;
        let determinant = a[0] * (b[1] * c[2] - b[2] * c[1])
            + a[1] * (b[2] * c[0] - b[0] * c[2])
            + a[2] * (b[0] * c[1] - b[1] * c[0]);
        let nearest = match Polar::try_from_matrix3(rows) {
            Ok(nearest) if !nearest.mirrors => nearest,
            _ => return Err(FileError::NotARotation { line, determinant }),
        };
        let mut off = 0.0_f64;
        for i in 0..3 {
            for j in i..3 {
                let product: f64 = rows.iter().map(|row| row[i] * row[j]).sum();
                off = off.max((product - f64::from(i == j)).abs());
            }
        }
        if off > ROUNDED {
            self.off(line, off);
        }
        Ok(nearest.rotation)
    }

    fn recording(self) -> Result<Recording, FileError> {
        let Self { stamps, poses, unsorted, off, matrices } = self;
        let (trajectory, dropped) = if stamps.windows(2).all(|pair| pair[0] < pair[1]) {
            (OwnedTrajectory::new(stamps, poses)?, 0)
        } else {
            OwnedTrajectory::sorted(&stamps, &poses)?
        };
        let mut warnings: Vec<_> = unsorted.into_iter().collect();
        if dropped > 0 {
            warnings.push(Warning::EqualStamps { dropped });
        }
        warnings.extend(off.map(|(line, off, count)| match matrices {
            true => Warning::NotOrthonormal { line, off, count },
            false => Warning::NotUnit { line, norm: off, count },
        }));
        Ok(Recording { trajectory, warnings })
    }
}

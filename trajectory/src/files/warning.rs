use core::fmt::{Display, Formatter, Result};

/// A fault of a file that was put right. Each kind is said once for a file, with the first line,
/// counted from one.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Warning {
    /// Stamps do not rise. The poses were sorted by their stamps.
    Unsorted {
        /// The first line whose stamp is before the one above it.
        line: usize,
        /// That stamp, in seconds.
        stamp: f64,
    },
    /// Several poses have one stamp. The first of them in the file was kept.
    EqualStamps {
        /// The number of poses that were dropped.
        dropped: usize,
    },
    /// Quaternions differ from unit length by more than 10⁻³, which is more than rounding. They
    /// were normalized.
    NotUnit {
        /// The first such line.
        line: usize,
        /// The length of its quaternion.
        norm: f64,
        /// The number of such lines.
        count: usize,
    },
    /// Matrices differ from rotations by more than 10⁻³, which is more than rounding. The
    /// nearest rotations were taken.
    NotOrthonormal {
        /// The first such line.
        line: usize,
        /// By how much a product of two of its columns differs from that of a rotation.
        off: f64,
        /// The number of such lines.
        count: usize,
    },
}

impl Display for Warning {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self {
            Self::Unsorted { line, stamp } => {
                write!(
                    f,
                    "line {line}: the stamp {stamp} s is before the one above it: poses were sorted"
                )
            }
            Self::EqualStamps { dropped } => {
                write!(
                    f,
                    "the stamps of {dropped} poses were there already: the first of each were kept"
                )
            }
            Self::NotUnit { line, norm, count } => write!(
                f,
                "line {line}: the quaternion has length {norm}, and {count} in all are not unit: they were normalized"
            ),
            Self::NotOrthonormal { line, off, count } => write!(
                f,
                "line {line}: the matrix differs from a rotation by {off}, and {count} in all do: the nearest rotations were taken"
            ),
        }
    }
}

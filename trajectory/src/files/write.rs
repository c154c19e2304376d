//! Poses into text.

use super::format::Format;
use crate::Trajectory;
use std::io::{BufWriter, Result, Write};

impl Format {
    /// Writes a trajectory in this format, with so many digits that each number comes back with the
    /// same bits.
    ///
    /// In EuRoC's format stamps are whole nanoseconds, so those that lie nearer than one
    /// become equal; and KITTI's has no stamps.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// use dq8_trajectory::{Trajectory, files::Format};
    /// let poses = [0.5, 1.5].map(|x| DualQuat::from_translation([x, 0.0, 0.0]));
    /// let path = Trajectory::new(&[1e9, 1e9 + 0.25], &poses)?;
    /// let mut text = Vec::new();
    /// Format::Euroc.write(path, &mut text)?;
    /// let text = String::from_utf8(text)?;
    /// assert_eq!(text.lines().last(), Some("1000000000250000000,1.5,0.0,0.0,1.0,0.0,0.0,0.0"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// Those of the writer.
    pub fn write(self, path: Trajectory<'_>, to: impl Write) -> Result<()> {
        let mut to = BufWriter::new(to);
        match self {
            Self::Tum => writeln!(to, "# timestamp tx ty tz qx qy qz qw")?,
            Self::Euroc => {
                writeln!(to, "#timestamp [ns],p_x [m],p_y [m],p_z [m],q_w [],q_x [],q_y [],q_z []")?
            }
            Self::Kitti => {}
        }
        for (&stamp, pose) in path.stamps().iter().zip(path.poses()) {
            let ([tx, ty, tz], [x, y, z, w]) = (pose.translation(), pose.rotation().to_array());
            // `Debug` gives the shortest text that is the same number; it takes exponents for long
            // ones.
            match self {
                Self::Tum => {
                    writeln!(to, "{stamp:?} {tx:?} {ty:?} {tz:?} {x:?} {y:?} {z:?} {w:?}")?;
                }
                Self::Euroc => {
                    nanoseconds(stamp, &mut to)?;
                    writeln!(to, ",{tx:?},{ty:?},{tz:?},{w:?},{x:?},{y:?},{z:?}")?;
                }
                Self::Kitti => {
                    let rows = pose.to_matrix3x4();
                    for (index, number) in rows.as_flattened().iter().enumerate() {
                        write!(to, "{}{number:?}", if index == 0 { "" } else { " " })?;
                    }
                    writeln!(to)?;
                }
            }
        }
        to.flush()
    }
}

/// A stamp in whole nanoseconds. Its seconds and the rest are written one after the other: the
/// product would be rounded to what an `f64` can hold.
fn nanoseconds(stamp: f64, to: &mut impl Write) -> Result<()> {
    let mut seconds = stamp.abs().trunc();
    let mut rest = ((stamp.abs() - seconds) * 1e9).round();
    if rest == 1e9 {
        (seconds, rest) = (seconds + 1.0, 0.0);
    }
    if stamp < 0.0 && seconds + rest > 0.0 {
        write!(to, "-")?;
    }
    if seconds > 0.0 { write!(to, "{seconds:.0}{rest:09.0}") } else { write!(to, "{rest:.0}") }
}

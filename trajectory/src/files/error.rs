use crate::TrajectoryError;
use alloc::string::String;
use dq8::internal::errors;

errors! {
    /// A file that holds no trajectory. Each names the line, counted from one.
    #[derive(Debug)]
    FileError {
        /// The file cannot be read.
        Read {
            /// Its name.
            path: String,
            /// Why.
            source: std::io::Error,
        } from source => "cannot read {path}: {source}";
        /// The first line with numbers is none of a known format.
        Unknown {
            /// The line.
            line: usize,
            /// How many fields it has, between blanks.
            fields: usize,
        } => "line {line} has {fields} fields: neither 8 as in TUM files, nor 12 as in KITTI's, nor commas as in EuRoC's";
        /// A line has too few fields, or too many.
        Fields {
            /// The line.
            line: usize,
            /// How many fields it has.
            found: usize,
            /// How many it must have, or at least, where more are allowed.
            expected: usize,
        } => "line {line} has {found} fields where {expected} are needed";
        /// A field is not a number, or too large for one.
        NotANumber {
            /// The line.
            line: usize,
            /// The field, counted from one.
            field: usize,
            /// What it holds; at most its first 40 characters.
            text: String,
        } => "line {line}, field {field}: {text:?} is not a finite number";
        /// A quaternion is zero: it has no direction.
        NoRotation {
            /// The line.
            line: usize,
        } => "line {line}: the quaternion is zero, which is no rotation";
        /// A matrix has no nearest rotation, or mirrors.
        NotARotation {
            /// The line.
            line: usize,
            /// Its determinant.
            determinant: f64,
        } => "line {line}: the matrix is near no rotation: its determinant is {determinant}";
        /// No line holds a pose.
        Trajectory(error: TrajectoryError) => "{error}";
    }
}

use crate::TrajectoryError;
use alloc::string::String;
use dq8::internal::errors;

errors! {
    /// A file that holds no trajectory. Each names the line, counted from one.
    #[derive(Debug)]
    FileError {
        /// The file cannot be read.
        Read { path: String = "Its name.", source: std::io::Error = "Why." } from source
            => "cannot read {path}: {source}";
        /// The first line with numbers is none of a known format.
        Unknown { line: usize = "The line.", fields: usize = "How many fields it has, between blanks." }
            => "line {line} has {fields} fields: neither 8 as in TUM files, nor 12 as in KITTI's, nor commas as in EuRoC's";
        /// A line has too few fields, or too many.
        Fields {
            line: usize = "The line.",
            found: usize = "How many fields it has.",
            expected: usize = "How many it must have, or at least, where more are allowed."
        }
            => "line {line} has {found} fields where {expected} are needed";
        /// A field is not a number, or too large for one.
        NotANumber {
            line: usize = "The line.",
            field: usize = "The field, counted from one.",
            text: String = "What it holds; at most its first 40 characters."
        }
            => "line {line}, field {field}: {text:?} is not a finite number";
        /// A quaternion is zero: it has no direction.
        NoRotation { line: usize = "The line." } => "line {line}: the quaternion is zero, which is no rotation";
        /// A matrix has no nearest rotation, or mirrors.
        NotARotation { line: usize = "The line.", determinant: f64 = "Its determinant." }
            => "line {line}: the matrix is near no rotation: its determinant is {determinant}";
        /// No line holds a pose.
        Trajectory(error: TrajectoryError) => "{error}";
    }
}

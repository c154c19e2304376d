//! What can be wrong with an argument. Every error names the value, and the index where there is
//! one; all implement [`core::error::Error`].

use core::fmt;

/// A dual quaternion that cannot be normalized: its real part is zero or some component is not finite
/// (or the quotient would not be).
///
/// Fabisch (*Normalizing Dual Quaternions*, "Edge Case") leaves this case open.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NormalizeError {
    /// The norm of the real part.
    pub real_norm: f64,
}

impl fmt::Display for NormalizeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "cannot normalize: the norm of the real part is {} and every component must be finite",
            self.real_norm
        )
    }
}

/// A dual quaternion or dual number without an inverse: its real part is zero or not finite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InverseError {
    /// The norm of the real part.
    pub real_norm: f64,
}

impl fmt::Display for InverseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "no inverse: the norm of the real part is {}", self.real_norm)
    }
}

/// A matrix that is not a rigid motion.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum MatrixError {
    /// Rows `row` and `column` of the rotation are not orthonormal: their product is `value`
    /// where the identity has 0 or 1.
    NotOrthonormal {
        /// The first of the two rows.
        row: usize,
        /// The second of the two rows.
        column: usize,
        /// Their scalar product.
        value: f64,
    },
    /// A rotation times a number: the matrix scales by the same factor in every direction.
    Scales {
        /// The factor, negative if the matrix mirrors as well.
        factor: f64,
    },
    /// The rotation mirrors: its determinant is negative.
    Mirrors {
        /// The determinant.
        determinant: f64,
    },
    /// An element of the translation is not finite.
    NotFinite {
        /// The row of the element.
        row: usize,
        /// The element.
        value: f64,
    },
    /// The last row of a 4×4 matrix is not 0 0 0 1.
    NotAffine {
        /// The column of the element that differs.
        column: usize,
        /// The element.
        value: f64,
    },
}

impl fmt::Display for MatrixError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotOrthonormal { row, column, value } => write!(
                f,
                "not a rotation: the product of rows {row} and {column} is {value} \
                 (non-uniform scale and shear are not rigid motions: Affine::try_decompose takes them apart)"
            ),
            Self::Scales { factor } => write!(
                f,
                "not a rotation: the matrix scales by {factor}, which no motion does \
                 (Affine::try_decompose takes the scale and the motion apart)"
            ),
            Self::Mirrors { determinant } => {
                write!(f, "not a rotation: the determinant is {determinant}")
            }
            Self::NotFinite { row, value } => {
                write!(f, "the translation is not finite: element {row} is {value}")
            }
            Self::NotAffine { column, value } => write!(
                f,
                "not affine: element {column} of the last row is {value}, which must be 0 0 0 1 \
                 (a matrix given by columns, as by glam, nalgebra and glTF, is for \
                 try_from_cols_array_2d)"
            ),
        }
    }
}

/// A 3×3 matrix that has no nearest rotation, or many.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum OrthonormalError {
    /// An element is not finite, or one of the stretch overflows.
    NotFinite {
        /// The row of the element.
        row: usize,
        /// Its column; 3 is the translation.
        column: usize,
        /// The element.
        value: f64,
    },
    /// A column lies in the span of those before it, or is zero.
    Dependent {
        /// The column.
        column: usize,
        /// The sine of the angle between it and that span.
        sine: f64,
    },
    /// The matrix mirrors.
    Mirrors {
        /// The determinant of its columns, each divided by its length.
        determinant: f64,
    },
    /// The matrix squeezes space into a line or a point: many rotations are as near.
    Ambiguous {
        /// (σ₂ + σ₃)/(σ₁ + σ₂ + σ₃) of the singular values σ₁ ≥ σ₂ ≥ σ₃.
        gap: f64,
    },
}

impl fmt::Display for OrthonormalError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite { row, column, value } => {
                write!(f, "not finite: the element in row {row} and column {column} is {value}")
            }
            Self::Dependent { column, sine } => write!(
                f,
                "no rotation: column {column} lies in the span of those before it \
                 (the sine of the angle is {sine})"
            ),
            Self::Mirrors { determinant } => {
                write!(f, "no rotation: the determinant of the normalized columns is {determinant}")
            }
            Self::Ambiguous { gap } => write!(
                f,
                "no nearest rotation: the two smaller singular values are {gap} of the sum of all"
            ),
        }
    }
}

/// A parent array that is not a hierarchy.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum HierarchyError {
    /// A joint's parent does not come before it: a forward reference, or a cycle.
    ParentNotBefore {
        /// The joint.
        joint: usize,
        /// Its parent.
        parent: u32,
    },
    /// A joint's parent is not a joint at all.
    ParentOutOfRange {
        /// The joint.
        joint: usize,
        /// Its parent.
        parent: u32,
        /// How many joints there are.
        joints: usize,
    },
    /// A joint is its own ancestor.
    Cycle {
        /// The joint.
        joint: usize,
    },
    /// More joints than a `u32` can number.
    TooManyJoints {
        /// How many joints there are.
        joints: usize,
    },
}

impl fmt::Display for HierarchyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::ParentNotBefore { joint, parent } if *joint == *parent as usize => {
                write!(f, "joint {joint} is its own parent")
            }
            Self::ParentNotBefore { joint, parent } => write!(
                f,
                "joint {joint} has parent {parent}, which must come before it (sort parents first; \
                 a cycle cannot be sorted)"
            ),
            Self::ParentOutOfRange { joint, parent, joints } => {
                write!(f, "joint {joint} has parent {parent}, but there are only {joints} joints")
            }
            Self::Cycle { joint } => write!(f, "joint {joint} is its own ancestor"),
            Self::TooManyJoints { joints } => {
                write!(f, "{joints} joints are more than a u32 can number")
            }
        }
    }
}

/// Points, lines and planes that do not determine the result.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum IncidenceError {
    /// A vector whose direction is needed is zero, or its length is not finite.
    NoDirection {
        /// Which vector.
        what: &'static str,
        /// Its length.
        length: f64,
    },
    /// A number given is not finite, or the one asked for would not be.
    NotFinite {
        /// Which number.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// Three points lie on one line: through it go many planes.
    Collinear {
        /// The sine of the angle at the first point.
        sine: f64,
    },
    /// A point lies on a line, within rounding: through both go many planes.
    PointOnLine {
        /// The distance of the two.
        distance: f64,
    },
    /// Two planes are parallel, or the same.
    ParallelPlanes {
        /// The sine of the angle between them.
        sine: f64,
    },
    /// A line is parallel to a plane, or lies in it.
    ParallelToPlane {
        /// The distance of the line, positive on the side of the normal.
        distance: f64,
    },
    /// Two lines are parallel, or the same.
    ParallelLines {
        /// Their distance.
        distance: f64,
    },
    /// Two lines pass each other.
    SkewLines {
        /// Their distance.
        distance: f64,
    },
}

impl fmt::Display for IncidenceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoDirection { what, length } => {
                write!(f, "{what} has no direction: its length is {length}")
            }
            Self::NotFinite { what, value } => write!(f, "{what} is {value}"),
            Self::Collinear { sine } => {
                write!(f, "three points on one line: the sine of their angle is {sine}")
            }
            Self::PointOnLine { distance } => {
                write!(f, "the point is on the line, {distance} from it")
            }
            Self::ParallelPlanes { sine } => {
                write!(f, "the planes are parallel: the sine of their angle is {sine}")
            }
            Self::ParallelToPlane { distance } => {
                write!(f, "the line is parallel to the plane, {distance} from it")
            }
            Self::ParallelLines { distance } => {
                write!(f, "the lines are parallel, {distance} apart")
            }
            Self::SkewLines { distance } => {
                write!(f, "the lines do not meet: they are {distance} apart")
            }
        }
    }
}

impl core::error::Error for NormalizeError {}
impl core::error::Error for InverseError {}
impl core::error::Error for MatrixError {}
impl core::error::Error for OrthonormalError {}
impl core::error::Error for HierarchyError {}
impl core::error::Error for IncidenceError {}

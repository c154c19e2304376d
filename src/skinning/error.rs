use crate::storage::shape::ShapeError;
use core::fmt;

/// The fault of a skin, a palette or the slices of a run. Nothing has been written.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum SkinningError {
    /// A slice has the wrong length.
    Shape(ShapeError),
    /// A vertex must have at least one influence.
    NoInfluences,
    /// There is no such joint.
    JointOutOfRange {
        /// The vertex.
        vertex: usize,
        /// The number of the influence.
        influence: usize,
        /// The joint.
        joint: u32,
        /// The number of joints.
        joints: usize,
    },
    /// A weight is negative, infinite or not a number.
    Weight {
        /// The vertex.
        vertex: usize,
        /// The number of the influence.
        influence: usize,
        /// The weight.
        value: f64,
    },
    /// The weights of a vertex should sum to one, and are farther from that than by a factor of 1024
    /// ([`Skin::WEIGHT_RANGE`](super::Skin::WEIGHT_RANGE)); or, where the last is implied, the others
    /// exceed one by more than rounding to eight bits.
    Total {
        /// The vertex.
        vertex: usize,
        /// The sum.
        total: f64,
    },
    /// A share of a mix is not in [0, 1].
    Share {
        /// The vertex.
        vertex: usize,
        /// The share.
        value: f64,
    },
    /// Three numbers from `first` on do not lie in a vertex of `stride` numbers, or lie in another field.
    Field {
        /// The buffer, `rest` or `posed`.
        what: &'static str,
        /// The begin of the field.
        first: usize,
        /// The number of numbers of a vertex.
        stride: usize,
    },
    /// The influences of a vertex do not lie in it: so many elements from `first` on, where a vertex has `stride`.
    InfluenceField {
        /// Their name, `joints` or `weights`.
        what: &'static str,
        /// Their begin.
        first: usize,
        /// The number of elements of a vertex.
        stride: usize,
        /// The number of influences it should have.
        influences: usize,
    },
    /// An element of a joint's matrix is not finite.
    NotFinite {
        /// The joint.
        joint: usize,
        /// The value.
        value: f64,
    },
    /// The last row of a joint's matrix is not 0 0 0 1. Columns given as rows look like this.
    NotAffine {
        /// The joint.
        joint: usize,
        /// The column of that row.
        column: usize,
        /// The value.
        value: f64,
    },
}

impl fmt::Display for SkinningError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Shape(error) => error.fmt(f),
            Self::NoInfluences => f.write_str("a vertex must have at least one influence"),
            Self::JointOutOfRange { vertex, influence, joint, joints } => write!(
                f,
                "vertex {vertex}: influence {influence} is joint {joint}, but there are only \
                 {joints} joints"
            ),
            Self::Weight { vertex, influence, value } => {
                write!(f, "vertex {vertex}: the weight of influence {influence} is {value}")
            }
            Self::Total { vertex, total } => {
                write!(f, "vertex {vertex}: the weights sum to {total}, which should be 1")
            }
            Self::Share { vertex, value } => {
                write!(f, "vertex {vertex}: the share is {value}, which must be from 0 to 1")
            }
            Self::Field { what, first, stride } => write!(
                f,
                "{what}: three numbers from {first} on do not lie in a vertex of {stride} numbers, or lie in \
                 another field"
            ),
            Self::InfluenceField { what, first, stride, influences } => write!(
                f,
                "{what}: {influences} elements from {first} on do not lie in a vertex of {stride} elements"
            ),
            Self::NotFinite { joint, value } => {
                write!(f, "joint {joint}: an element of its matrix is {value}")
            }
            Self::NotAffine { joint, column, value } => write!(
                f,
                "joint {joint}: element {column} of the last row is {value}, which must be 0 0 0 1 \
                 (columns given as rows?)"
            ),
        }
    }
}

impl core::error::Error for SkinningError {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        if let Self::Shape(error) = self { Some(error) } else { None }
    }
}

impl From<ShapeError> for SkinningError {
    fn from(error: ShapeError) -> Self {
        Self::Shape(error)
    }
}

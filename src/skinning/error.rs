use crate::macros::{Count, errors};
use crate::storage::shape::ShapeError;

errors! {
    /// The fault of a skin, a palette or the slices of a run. Nothing has been written.
    #[derive(Clone, Debug, PartialEq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    SkinningError {
        /// A slice has the wrong length.
        Shape(error: ShapeError) => "{error}";
        /// A vertex must have at least one influence.
        NoInfluences => "a vertex must have at least one influence";
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
        } => "vertex {vertex}: influence {influence} is joint {joint}, but there {} only {}", if *joints == 1 { "is" } else { "are" },
            Count(*joints, "joint");
        /// A weight is negative, infinite or not a number.
        Weight {
            /// The vertex.
            vertex: usize,
            /// The number of the influence.
            influence: usize,
            /// The weight.
            value: f64,
        } => "vertex {vertex}: the weight of influence {influence} is {value}, which must be finite and not negative";
        /// The weights of a vertex should sum to one, and are farther from that than by a factor of
        /// 1024 ([`Skin::WEIGHT_RANGE`](super::Skin::WEIGHT_RANGE)); or, where the last is implied,
        /// the others exceed one by more than rounding to eight bits.
        Total {
            /// The vertex.
            vertex: usize,
            /// The sum.
            total: f64,
        } => "vertex {vertex}: the weights sum to {total}, which must be about 1";
        /// A share of a mix is not in [0, 1].
        Share {
            /// The vertex.
            vertex: usize,
            /// The share.
            value: f64,
        } => "vertex {vertex}: the share is {value}, which must be from 0 to 1";
        /// A field of three numbers does not fit into a vertex of `stride` numbers, or overlaps
        /// another field.
        Field {
            /// The buffer, `rest` or `posed`.
            what: &'static str,
            /// The begin of the field.
            first: usize,
            /// The number of numbers of a vertex.
            stride: usize,
        } => "{what}: the field at {first} does not fit into a vertex of {}, or overlaps another field",
            Count(*stride, "number");
        /// The influences of a vertex do not fit into it: they begin at `first`, and a vertex has
        /// `stride` elements.
        InfluenceField {
            /// Their name, `joints` or `weights`.
            what: &'static str,
            /// Their begin.
            first: usize,
            /// The number of elements of a vertex.
            stride: usize,
            /// The number of influences it should have.
            influences: usize,
        } => "{what}: {} at {first} {} not fit into a vertex of {}", Count(*influences, "element"),
            if *influences == 1 { "does" } else { "do" }, Count(*stride, "element");
        /// An element of a joint's matrix is not finite.
        NotFinite {
            /// The joint.
            joint: usize,
            /// The value.
            value: f64,
        } => "joint {joint}: an element of its matrix is {value}, which must be finite";
        /// The last row of a joint's matrix is not 0 0 0 1. Columns given as rows look like this.
        NotAffine {
            /// The joint.
            joint: usize,
            /// The column of that row.
            column: usize,
            /// The value.
            value: f64,
        } => "joint {joint}: element {column} of the last row is {value}, which must be 0 0 0 1 (columns given as rows?)";
    }
}

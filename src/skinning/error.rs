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
        } => "vertex {vertex}: influence {influence} is joint {joint}, and there is no such one among {}, counted from 0",
            Count(*joints, "joint");
        /// A weight is negative, infinite or not a number.
        Weight {
            /// The vertex.
            vertex: usize,
            /// The number of the influence.
            influence: usize,
            /// The weight.
            value: f64,
        } => "vertex {vertex}: the weight of influence {influence} is {value}";
        /// The weights of a vertex should sum to one, and are farther from that than by a factor of
        /// 1024 ([`Skin::WEIGHT_RANGE`](super::Skin::WEIGHT_RANGE)); or, where the last is implied,
        /// the others exceed one by more than rounding to eight bits.
        Total {
            /// The vertex.
            vertex: usize,
            /// The sum.
            total: f64,
        } => "vertex {vertex}: the weights sum to {total}, which should be 1";
        /// A share of a mix is not in [0, 1].
        Share {
            /// The vertex.
            vertex: usize,
            /// The share.
            value: f64,
        } => "vertex {vertex}: the share is {value}, which must be from 0 to 1";
        /// Three numbers from `first` on do not lie in a vertex of `stride` numbers, or lie in
        /// another field.
        Field {
            /// The buffer, `rest` or `posed`.
            what: &'static str,
            /// The begin of the field.
            first: usize,
            /// The number of numbers of a vertex.
            stride: usize,
        } => "{what}: three numbers from {first} on do not lie in a vertex of {}, or lie in another field",
            Count(*stride, "number");
        /// The influences of a vertex do not lie in it: so many elements from `first` on, where a
        /// vertex has `stride`.
        InfluenceField {
            /// Their name, `joints` or `weights`.
            what: &'static str,
            /// Their begin.
            first: usize,
            /// The number of elements of a vertex.
            stride: usize,
            /// The number of influences it should have.
            influences: usize,
        } => "{what}: {} from {first} on {} not lie in a vertex of {}", Count(*influences, "element"),
            if *influences == 1 { "does" } else { "do" }, Count(*stride, "element");
        /// An element of a joint's matrix is not finite.
        NotFinite {
            /// The joint.
            joint: usize,
            /// The value.
            value: f64,
        } => "joint {joint}: an element of its matrix is {value}";
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

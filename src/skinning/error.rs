use crate::macros::{Count, errors};
use crate::storage::shape::ShapeError;

errors! {
    /// The error of a skin, of a palette, or of the slices of a mesh. No output has been written.
    #[derive(Clone, Debug, PartialEq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    SkinningError {
        /// A slice has the wrong length.
        Shape(error: ShapeError) => "{error}";
        /// A vertex must have at least one influence.
        NoInfluences => "a vertex must have at least one influence";
        /// An influence names a joint that the palette does not have.
        JointOutOfRange {
            /// The index of the vertex.
            vertex: usize,
            /// The index of the influence in its vertex.
            influence: usize,
            /// The index of the joint.
            joint: u32,
            /// The number of joints.
            joints: usize,
        } => "vertex {vertex}: influence {influence} is joint {joint}, but there {} only {}", if *joints == 1 { "is" } else { "are" },
            Count(*joints, "joint");
        /// A weight is negative, infinite or not a number.
        Weight {
            /// The index of the vertex.
            vertex: usize,
            /// The index of the influence in its vertex.
            influence: usize,
            /// The weight.
            value: f64,
        } => "vertex {vertex}: the weight of influence {influence} is {value}, which must be finite and not negative";
        /// The weights of a vertex should sum to one, and their sum is outside of
        /// [`Skin::WEIGHT_RANGE`](super::Skin::WEIGHT_RANGE), from 1/1024 to 1024. If the last
        /// weight is implied, the sum of the given weights exceeds one by more than rounding to
        /// eight bits explains.
        Total {
            /// The index of the vertex.
            vertex: usize,
            /// The sum of the weights.
            total: f64,
        } => "vertex {vertex}: the weights sum to {total}, which must be about 1";
        /// A share of a mix is not in [0, 1].
        Share {
            /// The index of the vertex.
            vertex: usize,
            /// The share.
            value: f64,
        } => "vertex {vertex}: the share is {value}, which must be from 0 to 1";
        /// A field of three components does not fit into a vertex of `stride` elements, or overlaps
        /// another field.
        Field {
            /// The name of the buffer, `rest` or `posed`.
            what: &'static str,
            /// The offset of the field in a vertex, in elements.
            first: usize,
            /// The number of elements from a vertex to the next.
            stride: usize,
        } => "{what}: the field at {first} does not fit into a vertex of {}, or overlaps another field",
            Count(*stride, "number");
        /// The joints or the weights of a vertex do not fit into it: they begin at element `first`,
        /// and a vertex has `stride` elements.
        InfluenceField {
            /// The name of the buffer, `joints` or `weights`.
            what: &'static str,
            /// The offset of the field in a vertex, in elements.
            first: usize,
            /// The number of elements from a vertex to the next.
            stride: usize,
            /// The number of influences that a vertex should have.
            influences: usize,
        } => "{what}: {} at {first} {} not fit into a vertex of {}", Count(*influences, "element"),
            if *influences == 1 { "does" } else { "do" }, Count(*stride, "element");
        /// An element of a joint's matrix is not finite.
        NotFinite {
            /// The index of the joint.
            joint: usize,
            /// The value of the element.
            value: f64,
        } => "joint {joint}: an element of its matrix is {value}, which must be finite";
        /// The last row of a joint's matrix is not 0 0 0 1. A matrix that is given by columns in
        /// place of rows looks like this.
        NotAffine {
            /// The index of the joint.
            joint: usize,
            /// The column of the element in the last row.
            column: usize,
            /// The value of the element.
            value: f64,
        } => "joint {joint}: element {column} of the last row is {value}, which must be 0 0 0 1 (columns given as rows?)";
    }
}

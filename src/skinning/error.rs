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
            vertex: usize = "The vertex.",
            influence: usize = "The number of the influence.",
            joint: u32 = "The joint.",
            joints: usize = "The number of joints."
        }
            => "vertex {vertex}: influence {influence} is joint {joint}, and there is no such one among {}, counted from 0",
            Count(*joints, "joint");
        /// A weight is negative, infinite or not a number.
        Weight {
            vertex: usize = "The vertex.",
            influence: usize = "The number of the influence.",
            value: f64 = "The weight."
        }
            => "vertex {vertex}: the weight of influence {influence} is {value}";
        /// The weights of a vertex should sum to one, and are farther from that than by a factor of
        /// 1024 ([`Skin::WEIGHT_RANGE`](super::Skin::WEIGHT_RANGE)); or, where the last is implied,
        /// the others exceed one by more than rounding to eight bits.
        Total { vertex: usize = "The vertex.", total: f64 = "The sum." }
            => "vertex {vertex}: the weights sum to {total}, which should be 1";
        /// A share of a mix is not in [0, 1].
        Share { vertex: usize = "The vertex.", value: f64 = "The share." }
            => "vertex {vertex}: the share is {value}, which must be from 0 to 1";
        /// Three numbers from `first` on do not lie in a vertex of `stride` numbers, or lie in
        /// another field.
        Field {
            what: &'static str = "The buffer, `rest` or `posed`.",
            first: usize = "The begin of the field.",
            stride: usize = "The number of numbers of a vertex."
        }
            => "{what}: three numbers from {first} on do not lie in a vertex of {}, or lie in another field",
            Count(*stride, "number");
        /// The influences of a vertex do not lie in it: so many elements from `first` on, where a
        /// vertex has `stride`.
        InfluenceField {
            what: &'static str = "Their name, `joints` or `weights`.",
            first: usize = "Their begin.",
            stride: usize = "The number of elements of a vertex.",
            influences: usize = "The number of influences it should have."
        }
            => "{what}: {} from {first} on {} not lie in a vertex of {}", Count(*influences, "element"),
            if *influences == 1 { "does" } else { "do" }, Count(*stride, "element");
        /// An element of a joint's matrix is not finite.
        NotFinite { joint: usize = "The joint.", value: f64 = "The value." }
            => "joint {joint}: an element of its matrix is {value}";
        /// The last row of a joint's matrix is not 0 0 0 1. Columns given as rows look like this.
        NotAffine { joint: usize = "The joint.", column: usize = "The column of that row.", value: f64 = "The value." }
            => "joint {joint}: element {column} of the last row is {value}, which must be 0 0 0 1 (columns given as rows?)";
    }
}

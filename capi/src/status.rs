//! [`Status`]: what became of a call.

use core::ffi::{CStr, c_char};
use dq8::{
    ShapeError,
    hierarchy::HierarchyError,
    scalar::{InverseError, MatrixError, NormalizeError},
    skinning::SkinningError,
};

/// What a function does inside: its error is the status.
pub(crate) type Done = Result<(), Status>;

/// The enum, and what each of its numbers means, in English.
macro_rules! statuses {
    (
        $(#[doc = $about:literal])*
        pub enum Status {
            $($(#[doc = $doc:literal])* $name:ident = $number:literal: $text:literal,)*
        }
    ) => {
        $(#[doc = $about])*
        #[repr(i32)]
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Status {
            $($(#[doc = $doc])* $name = $number,)*
        }

        fn text(status: i32) -> &'static CStr {
            match status {
                $($number => $text,)*
                _ => c"no status of dq8",
            }
        }
    };
}

statuses! {
    /// What became of a call. Unless it is DQ8_STATUS_OK, nothing has been written, except an index
    /// such as `bad_joint` or `bad_vertex`, the steps that were to be a mechanism, and scratch.
    pub enum Status {
        /// It is done.
        Ok = 0: c"done",
        /// A pointer is null where there is something to read or to write.
        NullPointer = 1: c"a pointer is null",
        /// A pointer is not aligned: to its number type, or to 64 bytes for blocks.
        Misaligned = 2: c"a pointer is not aligned",
        /// An output overlaps an input, be it an array or one thing, or another output, and is not
        /// exactly the array that it may be.
        Overlap = 3: c"an output overlaps another array",
        /// An array would be larger than memory.
        TooLarge = 4: c"an array would be larger than memory",
        /// Lengths do not fit each other, such as a `count` that is no multiple of the joints: it
        /// counts all poses of all instances or configurations.
        Length = 5: c"lengths do not fit each other: count is of all poses, such as links times configurations",
        /// There are no blocks of so many lanes: float has 8 and 16, double 4 and 8.
        Lanes = 6: c"there are no blocks of so many lanes",
        /// The motion, or the placement of a joint, is not unit.
        NotUnit = 7: c"a motion is not unit",
        /// There is no unit motion: the real part is zero, or a number is not finite.
        NotNormalizable = 8: c"there is no unit motion: the real part is zero or a number not finite",
        /// There is no inverse: the real part is zero, or a number is not finite.
        NoInverse = 9: c"there is no inverse: the real part is zero or a number not finite",
        /// The matrix scales or shears.
        NotOrthonormal = 10: c"the matrix is no rotation: it scales or shears",
        /// The matrix mirrors.
        Mirrors = 11: c"the matrix is no rotation: it mirrors",
        /// The translation of the matrix, or a number of a joint, is not finite.
        NotFinite = 12: c"a number that must be finite is not",
        /// The last row of the 4x4 matrix is not 0 0 0 1.
        NotAffine = 13: c"the last row of the matrix is not 0 0 0 1",
        /// There is nothing to blend.
        NoInfluences = 14: c"there is nothing to blend",
        /// A parent does not come before its child: a forward reference, or a cycle.
        ParentNotBefore = 15: c"a parent does not come before its child",
        /// A parent is no joint at all, nor -1.
        ParentOutOfRange = 16: c"a parent is no joint",
        /// There are more joints than 32 bits can number.
        TooManyJoints = 17: c"there are more joints than 32 bits can number",
        /// A number stands for nothing: no backend, no order of matrices, no kind of joint, no
        /// frame.
        UnknownValue = 18: c"a number stands for none of what it chooses from",
        /// An axis or normal is not of length 1.
        Axis = 19: c"an axis is not of length 1",
        /// A joint cannot mimic that one: there is none, it mimics too, or one of the two has not
        /// one value.
        Mimic = 20: c"a joint cannot mimic the one that it should",
        /// There is no such link.
        NoLink = 21: c"there is no such link",
        /// The mechanism has not been made.
        NoMechanism = 22: c"the mechanism has not been made",
        /// A vertex follows a joint that the palette does not have.
        JointOutOfRange = 23: c"a vertex follows a joint that there is not",
        /// A weight is negative or not finite; or a goal has none, or there is no goal.
        Weight = 24: c"a weight is negative or not finite, or there is none",
        /// The weights of a vertex, which should sum to one, sum to less than 1/1024 or more
        /// than 1024.
        WeightSum = 25: c"the weights of a vertex sum to less than 1/1024 or more than 1024",
        /// The skin has not been made.
        NoSkin = 26: c"the skin has not been made",
        /// Limits of a joint are not in order, or leave no value together with those of what mimics
        /// it, or are angles that a float does not tell apart.
        Limits = 27: c"the limits of a joint leave no value",
        /// A field lies beyond its vertex, or in another field.
        Field = 28: c"a field lies beyond its vertex, or in another field",
        /// The order of a plan is not one of these parents: it has not been made for them.
        NoPlan = 29: c"the order of the plan has not been made for these parents",
        /// A share of a mix is not in [0, 1].
        Share = 30: c"a share of a mix is not in [0, 1]",
        /// No joint moves the link of a goal: only fixed ones carry it.
        Unmoved = 31: c"no joint moves the link of a goal",
        /// The packed clips have not been made.
        NoClips = 32: c"the packed clips have not been made",
        /// Bytes are no packed clips.
        NotClips = 33: c"the bytes are no packed clips",
        /// A time is not later than the one before, or not finite.
        Times = 34: c"the times of a trajectory do not rise, or one is not finite",
        /// A time is before the first stamp of a trajectory or after the last one, where that is
        /// refused, or is the frame's and not finite.
        Outside = 35: c"a time is outside the stamps of the trajectory",
    }
}

impl Status {
    pub(crate) fn of(done: Done) -> Self {
        done.err().unwrap_or(Self::Ok)
    }
}

impl From<ShapeError> for Status {
    fn from(_: ShapeError) -> Self {
        Self::Length
    }
}

impl From<HierarchyError> for Status {
    fn from(error: HierarchyError) -> Self {
        match error {
            HierarchyError::ParentNotBefore { .. } => Self::ParentNotBefore,
            HierarchyError::ParentOutOfRange { .. } => Self::ParentOutOfRange,
            HierarchyError::TooManyJoints { .. } => Self::TooManyJoints,
            // What only a newer dq8 knows.
            _ => Self::UnknownValue,
        }
    }
}

impl From<MatrixError> for Status {
    fn from(error: MatrixError) -> Self {
        match error {
            MatrixError::NotOrthonormal { .. } | MatrixError::Scales { .. } => Self::NotOrthonormal,
            MatrixError::Mirrors { .. } => Self::Mirrors,
            MatrixError::NotFinite { .. } => Self::NotFinite,
            MatrixError::NotAffine { .. } => Self::NotAffine,
            // What only a newer dq8 knows.
            _ => Self::UnknownValue,
        }
    }
}

impl From<SkinningError> for Status {
    fn from(error: SkinningError) -> Self {
        match error {
            SkinningError::NoInfluences => Self::NoInfluences,
            SkinningError::JointOutOfRange { .. } => Self::JointOutOfRange,
            SkinningError::Weight { .. } => Self::Weight,
            SkinningError::Total { .. } => Self::WeightSum,
            SkinningError::NotFinite { .. } => Self::NotFinite,
            SkinningError::NotAffine { .. } => Self::NotAffine,
            SkinningError::Field { .. } | SkinningError::InfluenceField { .. } => Self::Field,
            SkinningError::Shape(_) => Self::Length,
            SkinningError::Share { .. } => Self::Share,
            // What only a newer dq8 knows.
            _ => Self::UnknownValue,
        }
    }
}

impl From<NormalizeError> for Status {
    fn from(_: NormalizeError) -> Self {
        Self::NotNormalizable
    }
}

impl From<InverseError> for Status {
    fn from(_: InverseError) -> Self {
        Self::NoInverse
    }
}

/// What a status means, in English: text that lives as long as the program. A number that is no
/// status has a text too, which says so.
#[unsafe(no_mangle)]
pub extern "C" fn dq8_status_text(status: i32) -> *const c_char {
    text(status).as_ptr()
}

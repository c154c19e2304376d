//! [`Status`]: the result of a call from C.

use core::ffi::{CStr, c_char};
use dq8::{
    ShapeError,
    hierarchy::HierarchyError,
    scalar::{InverseError, MatrixError, NormalizeError},
    skinning::SkinningError,
};

/// The result of a function inside the library. Its error is the status for C.
pub(crate) type Done = Result<(), Status>;

/// Defines the enum [`Status`], and the English text of each of its values.
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
                _ => c"this number is no status of dq8",
            }
        }
    };
}

statuses! {
    /// The result of a call. If it is not DQ8_STATUS_OK, the outputs are as they were. Exceptions
    /// are an index such as `bad_joint` or `bad_vertex`, the steps of a mechanism that could not be
    /// made, and scratch.
    pub enum Status {
        /// The call has succeeded.
        Ok = 0: c"success",
        /// A pointer is null, but its array has elements.
        NullPointer = 1: c"a pointer is null",
        /// A pointer is not aligned to its element type or, for blocks, to 64 bytes.
        Misaligned = 2: c"a pointer is not aligned",
        /// An output overlaps an input or another output. If a function allows an output to be one
        /// of its inputs, the two must be exactly the same array.
        Overlap = 3: c"an output overlaps another array",
        /// An array would be larger than memory.
        TooLarge = 4: c"an array would be larger than memory",
        /// The arrays of `count` elements do not hold whole instances or configurations: `count`,
        /// or `link_count`, is no multiple of the number of joints or links.
        Length = 5: c"count is no multiple of the number of joints or links",
        /// There are no blocks with this number of lanes. Blocks of float have 8 or 16 lanes, and
        /// blocks of double 4 or 8.
        Lanes = 6: c"there are no blocks with that number of lanes",
        /// The motion, or the placement of a joint, is not unit.
        NotUnit = 7: c"a motion is not unit",
        /// The dual quaternion cannot be normalized, because its real part is zero or a component
        /// is not finite.
        NotNormalizable = 8: c"the motion cannot be normalized: its real part is zero, or a number is not finite",
        /// The motion has no inverse, because its real part is zero or a component is not finite.
        NoInverse = 9: c"the motion has no inverse: its real part is zero, or a number is not finite",
        /// The matrix is no rigid motion, because it scales or shears.
        NotOrthonormal = 10: c"the matrix is no rigid motion: it scales or shears",
        /// The matrix is no rigid motion, because it mirrors.
        Mirrors = 11: c"the matrix is no rigid motion: it mirrors",
        /// An input that must be finite is not, such as the translation of a matrix or a field of a
        /// joint.
        NotFinite = 12: c"a number that must be finite is not",
        /// The last row of the 4x4 matrix is not 0 0 0 1.
        NotAffine = 13: c"the last row of the matrix is not 0 0 0 1",
        /// There is nothing to blend or to fit, because the number of motions, influences or pairs
        /// of points is 0, or all weights of pairs are 0.
        NoInfluences = 14: c"there is nothing to blend or fit: the number of motions, influences or points is 0",
        /// The parent of a joint does not come before it in the array.
        ParentNotBefore = 15: c"the parent of a joint does not come before it",
        /// The parent of a joint is neither a joint nor -1.
        ParentOutOfRange = 16: c"the parent of a joint is neither a joint nor -1",
        /// There are more joints than 32 bits can number.
        TooManyJoints = 17: c"there are more joints than 32 bits can number",
        /// An argument has no allowed value: it is no value of its enum (a backend, an order of
        /// matrices, a kind of joint, a frame), no order of Euler angles, a damping that is
        /// negative or not finite, neither 0 nor 1 where only these are allowed, or no index of a
        /// clip.
        UnknownValue = 18: c"a number is none of the allowed ones, such as the values of an enum",
        /// The length of an axis or normal is not 1.
        Axis = 19: c"the length of a joint's axis is not 1",
        /// A joint cannot mimic its leader: there is no joint with the leader's index, the leader
        /// mimics another joint, or one of the two joints does not have exactly one value.
        Mimic = 20: c"a joint cannot mimic its leader",
        /// The mechanism has no link with the given index.
        NoLink = 21: c"there is no such link",
        /// The mechanism is a zeroed struct that dq8_mechanism_make has not filled in.
        NoMechanism = 22: c"the mechanism has not been made",
        /// A vertex follows a joint that the palette does not have.
        JointOutOfRange = 23: c"a vertex follows a joint that does not exist",
        /// A weight is negative or not finite, or all weights of a goal are 0, or there is no goal.
        Weight = 24: c"a weight is negative or not finite, or a goal without any weight",
        /// The weights of a vertex, which should sum to 1, sum to less than 1/1024 or more
        /// than 1024.
        WeightSum = 25: c"the weights of a vertex sum to less than 1/1024 or more than 1024, and not to 1",
        /// The skin is a zeroed struct that dq8_skin_make has not filled in.
        NoSkin = 26: c"the skin has not been made",
        /// The limits of a joint are not in order, or they allow no value together with the limits
        /// of joints that mimic the joint, or they are angles so large that the element type cannot
        /// resolve them.
        Limits = 27: c"the limits of a joint allow no value",
        /// A field of a vertex is not inside of the vertex, or overlaps another field.
        Field = 28: c"a field is not inside of its vertex, or overlaps another field",
        /// The order of a plan was made for other parents.
        NoPlan = 29: c"the order of the plan was made for other parents",
        /// A share of a mix is not in [0, 1].
        Share = 30: c"a share of a mix is not in [0, 1]",
        /// The link of a goal cannot move, because only fixed joints carry it.
        Unmoved = 31: c"no joint moves the link of a goal",
        /// The clips are a zeroed struct that dq8_clips_make has not filled in.
        NoClips = 32: c"the packed clips have not been made",
        /// The bytes are no packed clips.
        NotClips = 33: c"the bytes are no packed clips",
        /// A stamp of a trajectory is not later than the stamp before it, or is not finite.
        Times = 34: c"a time of a trajectory is not later than the one before, or is not finite",
        /// A time is before the first stamp or after the last stamp of a trajectory, and the
        /// options refuse such times. Or the time at which `frame` is taken is not finite.
        Outside = 35: c"a time is outside the stamps of the trajectory",
        /// `value_count` is not the mechanism's number of values times the number of
        /// configurations.
        LengthValues = 36: c"value_count is not the mechanism's number of values times the number of configurations",
        /// `column_count` is not the mechanism's number of rates.
        LengthColumns = 37: c"column_count is not the mechanism's number of rates",
        /// `scratch_count` is less than the function whose name ends in `_scratch` has written.
        LengthScratch = 38: c"scratch_count is less than the function whose name ends in _scratch has written",
        /// `pose_count` is no multiple of the number of joints.
        LengthPoses = 39: c"pose_count is no multiple of the number of joints",
        /// `block_count` is not the number of blocks that the instances or links fill.
        LengthBlocks = 40: c"block_count is not the number of blocks that the instances or links fill",
        /// `joint_count` is not the number of joints of the skin or of the clips.
        LengthJoints = 41: c"joint_count is not the number of joints of the skin or of the clips",
        /// `vertices` is not the number of vertices of the skin.
        LengthVertices = 42: c"vertices is not the number of vertices of the skin",
        /// Only one of two vertex buffers has normals, or tangents.
        Fields = 43: c"only one of the two vertex buffers has normals, or tangents",
        /// There are fewer poses than are needed: one for a trajectory, two if its body is to go
        /// on, and four control poses for a spline.
        FewPoses = 44: c"there are too few poses: a trajectory needs one, or two if the body is to go on, and a spline four",
        /// A place was found in other clips.
        OtherClips = 45: c"a place was found in other clips",
        /// The joints that carry the link of the goal are not six hinges with values of their own,
        /// and fixed joints; or the goal leaves a part of the pose free.
        NotSixHinges = 46: c"not six hinges and fixed joints carry the link of the goal, or the goal is not for a whole pose",
        /// The packed clips are longer than `capacity`.
        LengthBytes = 47: c"the packed clips are longer than capacity",
        /// The text is no URDF file that a mechanism can express.
        Urdf = 48: c"the text is no URDF file that a mechanism can express",
        /// `names_size` is not the size of the names.
        LengthNames = 49: c"names_size is not what dq8_urdf_size has written",
        /// There is no clip, frame or joint to pack.
        NoFrames = 50: c"there is no clip, frame or joint to pack",
        /// Many rotations fit equally well, for instance because the points of one array are on a
        /// line.
        Ambiguous = 51: c"many rotations fit equally well, as for points on a line",
    }
}

impl Status {
    pub(crate) fn of(done: Done) -> Self {
        done.err().unwrap_or(Self::Ok)
    }
}

impl From<ShapeError> for Status {
    /// Names the argument of C that has the wrong length, by the name of the slice in Rust.
    fn from(error: ShapeError) -> Self {
        let what = match error {
            ShapeError::NotWhole { what, .. }
            | ShapeError::Empty { what }
            | ShapeError::Length { what, .. } => what,
            ShapeError::NoPlace { .. } => return Self::OtherClips,
            ShapeError::NoLink { .. } => return Self::NoLink,
            _ => return Self::Length,
        };
        match what {
            "values" => Self::LengthValues,
            "columns" | "rates" => Self::LengthColumns,
            "scratch" => Self::LengthScratch,
            "things" => Self::LengthPoses,
            "blocks" => Self::LengthBlocks,
            "palette" | "motions" | "stretches" | "each frame of the clip" => Self::LengthJoints,
            "shares" | "positions" | "weighted vertices" | "rest" | "posed" => Self::LengthVertices,
            "posed normals" | "posed tangents" => Self::Fields,
            _ => Self::Length,
        }
    }
}

impl From<HierarchyError> for Status {
    fn from(error: HierarchyError) -> Self {
        match error {
            HierarchyError::ParentNotBefore { .. } => Self::ParentNotBefore,
            HierarchyError::ParentOutOfRange { .. } => Self::ParentOutOfRange,
            HierarchyError::TooManyJoints { .. } => Self::TooManyJoints,
            // The enum is `non_exhaustive`: a newer `dq8` may have more errors.
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
            // The enum is `non_exhaustive`: a newer `dq8` may have more errors.
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
            SkinningError::Shape(error) => error.into(),
            SkinningError::Share { .. } => Self::Share,
            // The enum is `non_exhaustive`: a newer `dq8` may have more errors.
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

/// Returns the meaning of a status in English. The text lives as long as the program. If `status`
/// is no value of enum dq8_status, the text says so.
#[unsafe(no_mangle)]
pub extern "C" fn dq8_status_text(status: i32) -> *const c_char {
    text(status).as_ptr()
}

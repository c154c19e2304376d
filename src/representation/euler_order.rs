/// In which order Euler angles turn about which axes: 24 in all, [`EulerOrder::ALL`].
///
/// Kenwright (§3.3) says twelve and prints eleven, three of them twice. There are six with three
/// different axes (Tait–Bryan) and six with the first axis again at the end (proper Euler
/// angles), and each may turn about axes that move along or that stay.
///
/// ```
/// use dq8::{representation::{EulerAxes, EulerFrame, EulerOrder}};
/// // Yaw, pitch and roll of an aircraft.
/// let aircraft = EulerOrder { axes: EulerAxes::ZYX, frame: EulerFrame::Intrinsic };
/// assert!(EulerOrder::ALL.contains(&aircraft));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct EulerOrder {
    /// The axes, first turn first.
    pub axes: EulerAxes,
    /// `true` if the axes move along.
    pub frame: EulerFrame,
}

/// Whose axes the turns are about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum EulerFrame {
    /// Of the turning body: each turn moves the axes of the later ones, R = R₁R₂R₃.
    Intrinsic,
    /// Of the space around: the axes stay, R = R₃R₂R₁.
    Extrinsic,
}

/// Each by its name, and its axes as indices.
macro_rules! axes {
    ($($name:ident [$($index:literal)*])*) => {
        /// The axes of three turns, first turn first: no two neighbours are equal.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[allow(missing_docs, reason = "the names are the axes")]
        pub enum EulerAxes { $($name),* }

        impl EulerAxes {
            /// All twelve: the six of Tait and Bryan, then the six proper ones.
            pub const ALL: [Self; 12] = [$(Self::$name),*];

            /// The axes as indices into a vector: x is 0, y is 1, z is 2.
            #[must_use]
            pub const fn indices(self) -> [usize; 3] {
                match self {
                    $(Self::$name => [$($index),*]),*
                }
            }
        }
    };
}
axes! {
    XYZ [0 1 2] XZY [0 2 1] YXZ [1 0 2] YZX [1 2 0] ZXY [2 0 1] ZYX [2 1 0]
    XYX [0 1 0] XZX [0 2 0] YXY [1 0 1] YZY [1 2 1] ZXZ [2 0 2] ZYZ [2 1 2]
}

impl EulerAxes {
    /// `true` if the last axis is the first one again: then the middle angle is in [0, π], and
    /// otherwise in [−π/2, π/2].
    #[must_use]
    pub const fn is_proper(self) -> bool {
        let [first, _, last] = self.indices();
        first == last
    }
}

impl EulerOrder {
    /// All 24: the axes in the order of [`EulerAxes::ALL`], intrinsic and then extrinsic.
    pub const ALL: [Self; 24] = {
        let mut all = [Self { axes: EulerAxes::XYZ, frame: EulerFrame::Intrinsic }; 24];
        let mut index = 0;
        while index < 12 {
            let axes = EulerAxes::ALL[index];
            all[index] = Self { axes, frame: EulerFrame::Intrinsic };
            all[index + 12] = Self { axes, frame: EulerFrame::Extrinsic };
            index += 1;
        }
        all
    };
}

//! [`Role`], a part of a body that a person and a robot both have.

use std::fmt;

/// A part of a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[allow(missing_docs, reason = "the names are the parts")]
pub enum Role {
    Pelvis,
    Chest,
    Head,
    LeftShoulder,
    LeftElbow,
    LeftHand,
    LeftHip,
    LeftKnee,
    LeftFoot,
    RightShoulder,
    RightElbow,
    RightHand,
    RightHip,
    RightKnee,
    RightFoot,
}

use Role::{
    Chest, Head, LeftElbow, LeftFoot, LeftHand, LeftHip, LeftKnee, LeftShoulder, Pelvis,
    RightElbow, RightFoot, RightHand, RightHip, RightKnee, RightShoulder,
};

/// The names by which links and joints are commonly called, without their side.
pub(crate) struct Names {
    /// The links of robots.
    pub(crate) links: &'static [&'static str],
    /// The links of robots whose origins are the centre of the joint.
    pub(crate) centres: &'static [&'static str],
    /// The joints of people in files of motion capture.
    pub(crate) joints: &'static [&'static str],
}

impl Role {
    /// All roles; a role that carries others stands before them.
    pub const ALL: [Self; 15] = [
        Pelvis,
        Chest,
        Head,
        LeftShoulder,
        LeftElbow,
        LeftHand,
        LeftHip,
        LeftKnee,
        LeftFoot,
        RightShoulder,
        RightElbow,
        RightHand,
        RightHip,
        RightKnee,
        RightFoot,
    ];

    /// The number of roles.
    pub const COUNT: usize = Self::ALL.len();

    /// The roles on the left, each with its twin on the right.
    pub const PAIRS: [[Self; 2]; 6] = [
        [LeftShoulder, RightShoulder],
        [LeftElbow, RightElbow],
        [LeftHand, RightHand],
        [LeftHip, RightHip],
        [LeftKnee, RightKnee],
        [LeftFoot, RightFoot],
    ];

    /// Returns the name as tables write it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Pelvis => "pelvis",
            Chest => "chest",
            Head => "head",
            LeftShoulder => "left_shoulder",
            LeftElbow => "left_elbow",
            LeftHand => "left_hand",
            LeftHip => "left_hip",
            LeftKnee => "left_knee",
            LeftFoot => "left_foot",
            RightShoulder => "right_shoulder",
            RightElbow => "right_elbow",
            RightHand => "right_hand",
            RightHip => "right_hip",
            RightKnee => "right_knee",
            RightFoot => "right_foot",
        }
    }

    /// Returns the role that tables call so.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|role| role.name() == name)
    }

    /// Returns `true` for the feet.
    #[must_use]
    pub fn is_foot(self) -> bool {
        matches!(self, LeftFoot | RightFoot)
    }

    /// Returns `true` for the parts that are below the hips while a person stands.
    #[must_use]
    pub fn is_below_hips(self) -> bool {
        matches!(self, LeftKnee | RightKnee) || self.is_foot()
    }

    /// Returns `true` if a limb leads to this part from the part that carries it. The direction of
    /// a limb is the same on every body.
    #[must_use]
    pub fn is_limb(self) -> bool {
        matches!(self, LeftElbow | RightElbow | LeftHand | RightHand) || self.is_below_hips()
    }

    /// Returns the part that carries this one. The pelvis carries the shoulders, because the waist
    /// of a robot is lower than that of a person, and a chest between would lean for the shoulders.
    #[must_use]
    pub fn carrier(self) -> Option<Self> {
        match self {
            Pelvis => None,
            Chest | LeftShoulder | RightShoulder | LeftHip | RightHip => Some(Pelvis),
            Head => Some(Chest),
            LeftElbow => Some(LeftShoulder),
            LeftHand => Some(LeftElbow),
            LeftKnee => Some(LeftHip),
            LeftFoot => Some(LeftKnee),
            RightElbow => Some(RightShoulder),
            RightHand => Some(RightElbow),
            RightKnee => Some(RightHip),
            RightFoot => Some(RightKnee),
        }
    }

    /// Returns the side that the names of this part have, as `left` or `right`.
    pub(crate) fn side(self) -> Option<&'static str> {
        self.name().split_once('_').map(|(side, _)| side)
    }

    /// Returns the weights of rotation and position of a goal for this part.
    pub(crate) fn weights(self) -> [f64; 2] {
        match self {
            Pelvis => [1.0, 1.0],
            Chest | Head | LeftShoulder | RightShoulder | LeftHip | RightHip => [0.0, 0.5],
            // Without any weight of rotation an arm that has met a stop stays there.
            LeftElbow | RightElbow => [0.1, 0.7],
            LeftHand | RightHand => [0.0, 1.0],
            LeftKnee | RightKnee => [0.0, 0.7],
            LeftFoot | RightFoot => [0.5, 2.0],
        }
    }

    pub(crate) fn names(self) -> Names {
        let (links, centres, joints): (&[_], &[_], &[_]) = match self {
            Pelvis => (&["pelvis", "hips", "baselink", "base"], &[], &["hips", "pelvis", "root"]),
            Chest => (
                &["chest", "torso", "spine"],
                &[],
                &["spine3", "spine2", "chest", "spine1", "torso", "spine"],
            ),
            Head => (&["head", "neck"], &[], &["head"]),
            LeftShoulder | RightShoulder => (
                &["upperarm", "shoulderyaw"],
                &["shoulderroll", "shoulderpitch", "shoulder"],
                &["arm", "uparm", "upperarm", "shoulder"],
            ),
            LeftElbow | RightElbow => (
                &["elbow", "elbowpitch", "forearm", "lowerarm"],
                &[],
                &["forearm", "lowarm", "lowerarm", "elbow"],
            ),
            LeftHand | RightHand => {
                (&["hand", "wristyaw", "rubberhand", "wrist"], &[], &["hand", "wrist"])
            }
            LeftHip | RightHip => (
                &["thigh", "hipyaw", "upperleg"],
                &["hiproll", "hippitch", "hip"],
                &["upleg", "thigh", "upperleg", "hip"],
            ),
            LeftKnee | RightKnee => (
                &["shin", "knee", "calf", "lowerleg"],
                &[],
                &["leg", "shin", "lowleg", "lowerleg", "calf", "knee"],
            ),
            LeftFoot | RightFoot => (&["foot", "ankleroll", "ankle"], &[], &["foot", "ankle"]),
        };
        Names { links, centres, joints }
    }
}

impl fmt::Display for Role {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

//! [`RetargetError`], the reason why there is no motion.

use crate::Role;
use dq8::ShapeError;
use dq8_bvh::{BvhError, ClipError};
use dq8_robot::MechanismError;
use dq8_robot::ik::ReachError;
use dq8_robot::urdf::{ChangeError, UrdfError};
use std::error::Error;
use std::fmt;

/// The reason why a file is refused, or why a motion cannot be brought on a robot.
#[derive(Debug)]
#[non_exhaustive]
pub enum RetargetError {
    /// The file of the clip is not BVH.
    Bvh(BvhError),
    /// The joints of the clip have no poses.
    Clip(ClipError),
    /// The file of the robot is not understood.
    Urdf(Box<UrdfError>),
    /// The robot cannot get a floating base.
    Base(Box<ChangeError>),
    /// The robot is no mechanism in the precision of the search.
    Mechanism(MechanismError),
    /// There can be no search for the goals.
    Reach(ReachError),
    /// The slices of a call do not fit each other.
    Shape(ShapeError),
    /// A table is not TOML, or has an entry that cannot be used.
    Table {
        /// The name of the entry; empty if the table is not TOML.
        entry: String,
        /// The sentence that says what is wrong.
        reason: String,
    },
    /// The robot does not have two legs on which it stands.
    NoLegs {
        /// The name of the robot.
        robot: String,
        /// The roles of legs that no link was found for.
        missing: Vec<Role>,
        /// The names of the links.
        links: Vec<String>,
    },
    /// Too few roles are known of both, or the person's do not say where up and left are.
    TooLittle {
        /// The roles that were not found for the robot.
        robot: Vec<Role>,
        /// The roles that were not found for the person.
        person: Vec<Role>,
        /// The names of the robot's links.
        links: Vec<String>,
        /// The names of the person's joints.
        joints: Vec<String>,
    },
    /// The clip has no frame of that number.
    RestFrame {
        /// The frame that was asked for.
        asked: usize,
        /// The number of frames.
        frames: usize,
    },
    /// There is no pose in which the person stands.
    NoRest,
    /// A pose of the person is not finite, or too large for the search.
    NotFinite {
        /// The frame.
        frame: usize,
        /// The name of the joint.
        joint: String,
    },
    /// Arrays that make a person have other lengths than they should have.
    Lengths {
        /// The name of the array.
        array: &'static str,
        /// Its length.
        length: usize,
        /// The length that it should have, or of which it should be a multiple.
        expected: usize,
    },
    /// The parent of a joint does not stand before it.
    Parent {
        /// The index of the joint.
        joint: usize,
        /// The parent that it names.
        parent: usize,
    },
    /// A setting is out of its range.
    Setting {
        /// The name of the setting.
        name: &'static str,
        /// The value.
        value: f64,
    },
    /// The caller has ended the work.
    Stopped,
}

fn list<T: ToString>(names: &[T]) -> String {
    if names.is_empty() {
        return "none".to_owned();
    }
    names.iter().map(T::to_string).collect::<Vec<_>>().join(", ")
}

impl fmt::Display for RetargetError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Bvh(error) => error.fmt(f),
            Self::Clip(error) => error.fmt(f),
            Self::Urdf(error) => error.fmt(f),
            Self::Base(error) => error.fmt(f),
            Self::Mechanism(error) => error.fmt(f),
            Self::Reach(error) => error.fmt(f),
            Self::Shape(error) => error.fmt(f),
            Self::Table { entry, reason } if entry.is_empty() => write!(f, "the table: {reason}"),
            Self::Table { entry, reason } => write!(f, "the table, {entry}: {reason}"),
            Self::NoLegs { robot, missing, links } => write!(
                f,
                "no two legs were found on the robot {robot:?}, so it cannot do what a person does. Not found: {}.\n\
                 If it has legs, name them in a table, such as `[links] left_foot = \"NAME\"`. Links: {}.",
                list(missing),
                list(links),
            ),
            Self::TooLittle { robot, person, links, joints } => write!(
                f,
                "too little is known of where the bodies are: pelvis, chest or head, a pair of limbs, and six parts that both \
                 have. Not found on the robot: {}. Not found on the person: {}.\n\
                 Name them in a table (`[links]` and `[joints]`). Links: {}.\nJoints: {}.",
                list(robot),
                list(person),
                list(links),
                list(joints),
            ),
            Self::RestFrame { asked, frames } => {
                write!(f, "frame {asked} cannot be the rest pose: the clip has {frames} frames, from 0 on")
            }
            Self::NoRest => f.write_str(
                "no rest pose was found: with all channels zero, and in each frame, the head is not above the hips, \
                 the hips are not above the feet, or left and right are exchanged. Name a frame in which the person \
                 stands as the rest pose",
            ),
            Self::NotFinite { frame, joint } => {
                write!(f, "the pose of the joint {joint:?} in frame {frame} is not finite, or too large")
            }
            Self::Lengths { array, length, expected } => {
                write!(f, "the array `{array}` has {length} elements, and the other arrays ask for {expected}")
            }
            Self::Parent { joint, parent } => {
                write!(f, "joint {joint} names joint {parent} as its parent, which does not stand before it")
            }
            Self::Stopped => f.write_str("the work was ended before the motion was there"),
            Self::Setting { name, value } => write!(f, "the setting {name} cannot be {value}"),
        }
    }
}

impl Error for RetargetError {}

macro_rules! from {
    ($($variant:ident($source:ty) $make:expr;)*) => {$(
        impl From<$source> for RetargetError {
            fn from(error: $source) -> Self {
                Self::$variant($make(error))
            }
        }
    )*};
}

from! {
    Bvh(BvhError) std::convert::identity;
    Clip(ClipError) std::convert::identity;
    Urdf(UrdfError) Box::new;
    Base(ChangeError) Box::new;
    Mechanism(MechanismError) std::convert::identity;
    Reach(ReachError) std::convert::identity;
    Shape(ShapeError) std::convert::identity;
}

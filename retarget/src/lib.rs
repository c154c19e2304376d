#![doc = include_str!("../README.md")]
#![forbid(unsafe_code)]

mod body_model;
mod collide;
mod collision;
mod error;
mod feet;
mod humanoid;
mod motion;
mod names;
mod person;
mod positions;
mod report;
mod rest;
mod role;
mod settings;
mod shape;
mod smooth;
mod solid;
mod table;
mod targets;

pub use body_model::BodyModel;
pub use collision::KnownShapes;
pub use dq8_bvh::{Clip, Warning};
pub use error::RetargetError;
pub use humanoid::{Humanoid, Part, Source};
pub use motion::{Motion, retarget, retarget_while};
pub use person::Person;
pub use report::Report;
pub use role::Role;
pub use settings::{Settings, Speeds};
pub use targets::{Place, Targets};

//! Inverse kinematics: arms against other algebra, and limbs against their own geometry.

use dq8_contract::arms;

#[path = "ik/forward.rs"]
mod forward;
#[path = "ik/honest.rs"]
mod honest;
#[path = "ik/lanes.rs"]
mod lanes;
#[path = "ik/outcomes.rs"]
mod outcomes;
#[path = "ik/reference.rs"]
mod reference;
#[path = "ik/shapes.rs"]
mod shapes;
#[path = "ik/success.rs"]
mod success;
#[path = "ik/two_bone.rs"]
mod two_bone;

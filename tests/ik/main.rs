//! Inverse kinematics: arms against other algebra, and limbs against their own geometry.

use dq8_contract::arms;

mod forward;
mod honest;
mod lanes;
mod outcomes;
mod reference;
mod shapes;
mod success;
mod two_bone;

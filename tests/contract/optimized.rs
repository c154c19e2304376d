//! What tests run for long. A program takes an instance of a generic function from a crate that it
//! depends on and that has one: what is named here is compiled once for all tests, and optimised as
//! this crate is.

use crate::kinematics::after;
use crate::records::Place;
use dq8::skinning::{DualBlend, Job, Linear};
use dq8::{Backend, Block, simd};

type Block16 = Block<f32, 16>;
type Points16 = simd::Block<[f32; 16], 3>;

/// To name them is enough; nobody calls this.
pub fn instances() -> [*const (); 16] {
    [
        Job::<u16, f32>::pose::<Linear<'_, f32>, [f32; 3]> as *const (),
        Job::<u16, f32>::pose::<DualBlend<'_, f32>, [f32; 3]> as *const (),
        Backend::normalize::<Block16> as *const (),
        Backend::mul_in_place::<Block16> as *const (),
        Backend::mul_left_in_place::<Block16> as *const (),
        Backend::inverse_in_place::<Block16> as *const (),
        Backend::normalize_in_place::<Block16> as *const (),
        Backend::conjugate_in_place::<Block16> as *const (),
        Backend::transform_points_in_place::<Points16> as *const (),
        Backend::transform_vectors_in_place::<Points16> as *const (),
        after::<f32> as *const (),
        after::<f64> as *const (),
        Place::lay::<f32> as *const (),
        Place::lay::<f64> as *const (),
        Place::read::<f32> as *const (),
        Place::read::<f64> as *const (),
    ]
}

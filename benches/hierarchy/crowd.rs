//! [`Crowd`]: poses to concatenate, and what has to come out.

use crate::contender::{Contender, Peer};
use crate::representation::Rows;
use crate::rows::Rows3x4;
use crate::skeleton::{self, JOINTS};
use dq8::{DualQuat, Hierarchy};
use std::cell::LazyCell;

/// Metres, and elements of rotations. Twelve levels of single precision lose a few millionths.
const TOLERANCE: f64 = 3e-5;

/// Made when the first contender asks, so that a filter that selects none costs nothing.
pub(crate) struct Crowd {
    parents: Vec<u32>,
    poses: LazyCell<Poses, Box<dyn FnOnce() -> Poses>>,
}

struct Poses {
    locals: Vec<DualQuat<f32>>,
    /// By `f64` matrices.
    models: Vec<Rows>,
}

#[derive(Clone, Copy)]
pub(crate) enum Place {
    /// From locals into models.
    Out,
    /// Over the locals.
    In,
}

impl Crowd {
    pub(crate) fn new(instances: usize) -> Self {
        let parents = skeleton::parents();
        let hierarchy_parents = parents.clone();
        let poses = move || {
            let locals = skeleton::locals(&skeleton::bones(), instances);
            let hierarchy = hierarchy(&hierarchy_parents);
            let models = models::<Peer<Rows3x4<f64>>>(hierarchy, &locals, Place::Out);
            Poses { locals, models }
        };
        Self { parents, poses: LazyCell::new(Box::new(poses)) }
    }

    pub(crate) fn hierarchy(&self) -> Hierarchy<'_> {
        hierarchy(&self.parents)
    }

    /// The contender's locals, once it has shown that it makes the right models of them.
    pub(crate) fn checked_locals<C: Contender>(&self, name: &str, place: Place) -> Vec<C::Element> {
        let Poses { locals, models: expected } = &*self.poses;
        let models = models::<C>(self.hierarchy(), locals, place);
        // Blocks give back whole blocks: more instances than there are.
        assert!(models.len() >= expected.len(), "{name} lost joints");
        for (index, (model, expected)) in models.iter().zip(expected).enumerate() {
            let difference = largest_difference(model, expected);
            let (instance, joint) = (index / JOINTS, index % JOINTS);
            assert!(
                difference <= TOLERANCE,
                "{name}: joint {joint} of instance {instance} is off by {difference:e}"
            );
        }
        C::pack(JOINTS, locals)
    }
}

fn hierarchy(parents: &[u32]) -> Hierarchy<'_> {
    Hierarchy::new(parents).expect("parents come first")
}

fn models<C: Contender>(h: Hierarchy, locals: &[DualQuat<f32>], place: Place) -> Vec<Rows> {
    let locals = C::pack(JOINTS, locals);
    let mut models = locals.clone();
    match place {
        Place::Out => C::local_to_model(&h, &locals, &mut models),
        Place::In => C::local_to_model_in_place(&h, &mut models),
    }
    C::unpack(JOINTS, &models)
}

/// The largest difference between two elements; NaN if there is any.
fn largest_difference(a: &Rows, b: &Rows) -> f64 {
    let pairs = a.as_flattened().iter().zip(b.as_flattened());
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, |largest, difference| {
        if difference > largest || difference.is_nan() { difference } else { largest }
    })
}

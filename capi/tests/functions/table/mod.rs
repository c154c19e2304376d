//! Every C function, once: what its arguments are, and the Rust function that it stands for.

mod arrays;
mod clips;
mod fits;
mod hierarchies;
mod mechanisms;
mod motions;
mod searches;
mod skins;
mod trajectories;

use crate::function::Function;
use crate::shape::Shape;

/// All functions, with arrays of these lengths.
pub(crate) fn table(shape: &Shape) -> Vec<Function> {
    let mut all = Vec::new();
    arrays::add(shape, &mut all);
    clips::add(shape, &mut all);
    fits::add(shape, &mut all);
    hierarchies::add(shape, &mut all);
    mechanisms::add(shape, &mut all);
    motions::add(shape, &mut all);
    searches::add(shape, &mut all);
    skins::add(shape, &mut all);
    trajectories::add(shape, &mut all);
    all
}

/// The memory of an array, which something keeps a pointer to.
fn memory<T>(array: &[T]) -> (*mut u8, usize) {
    (array.as_ptr().cast_mut().cast(), size_of_val(array))
}

/// The functions of a room of the table for all layouts: plain, and blocks of either number of
/// lanes.
macro_rules! for_all_layouts {
    ($layout:ident) => {
        pub(super) fn add(shape: &$crate::shape::Shape, list: &mut Vec<$crate::function::Function>) {
            use dq8::storage::{AoSoA, Aos};
            $layout!(shape list f32 single Aos<f32> []);
            $layout!(shape list f32 single AoSoA<[f32; 8]> [8]);
            $layout!(shape list f32 single AoSoA<[f32; 16]> [16]);
            $layout!(shape list f64 double Aos<f64> []);
            $layout!(shape list f64 double AoSoA<[f64; 4]> [4]);
            $layout!(shape list f64 double AoSoA<[f64; 8]> [8]);
        }
    };
}
use for_all_layouts;

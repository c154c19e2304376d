//! Skinning palettes from the matrices of an engine. The module `hierarchy` computes palettes from
//! local poses.

use crate::memory::{Input, Output};
use crate::slices::Order;
use crate::span::disjoint;
use crate::status::{Done, Status};
use dq8::skinning::{matrix_palette, split_palette};
use dq8::{DualQuat, Real};

/// # Safety
/// Each array must have `joints` elements. No other thread may use the outputs or write the inputs
/// during the call.
unsafe fn products<R: Real>(
    models: *const R,
    inverse_binds: *const R,
    order: i32,
    matrices: *mut R,
    joints: usize,
) -> Done {
    let order = Order::known(order)?;
    let models = Input::<[[R; 4]; 4]>::new(models, joints)?;
    let inverse_binds = Input::<[[R; 4]; 4]>::new(inverse_binds, joints)?;
    let matrices = Output::<[[R; 4]; 3]>::new(matrices, joints)?;
    disjoint(&[matrices.span], &[models.span, inverse_binds.span])?;
    // SAFETY: the caller guarantees that each array has `joints` elements, and `disjoint` has
    // checked that no output overlaps another array.
    Ok(unsafe { matrix_palette(models.slice(), inverse_binds.slice(), order, matrices.slice()) }?)
}

/// # Safety
/// Each array must have `joints` elements. No other thread may use the outputs or write the inputs
/// during the call.
unsafe fn split<R: Real>(
    matrices: *const R,
    motions: *mut R,
    stretches: *mut R,
    joints: usize,
) -> Done {
    let matrices = Input::<[[R; 4]; 3]>::new(matrices, joints)?;
    let motions = Output::<DualQuat<R>>::new(motions, joints)?;
    let stretches = Output::<[[R; 4]; 3]>::new(stretches, joints)?;
    disjoint(&[motions.span, stretches.span], &[matrices.span])?;
    // SAFETY: the caller guarantees that each array has `joints` elements, and `disjoint` has
    // checked that no output overlaps another array.
    unsafe { split_palette(matrices.slice(), motions.slice(), stretches.slice()) }?;
    Ok(())
}

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export_one! { $R
            /// Computes a palette of matrices, `matrices[j] = models[j] * inverse_binds[j]`.
            /// `models` and `inverse_binds` are 4x4 matrices whose components are in `order`, one
            /// of enum dq8_matrix_order. `matrices` has twelve components per joint, row by row, in
            /// either order. Returns DQ8_STATUS_NOT_FINITE if an input is not finite, and
            /// DQ8_STATUS_NOT_AFFINE if the last row of an input is not 0 0 0 1.
            skin::products(
                models: *const $R, inverse_binds: *const $R, order: i32, matrices: *mut $R,
                joint_count: usize,
            ) = super::products(models, inverse_binds, order, matrices, joint_count)
        }
        export_one! { $R
            /// Splits the matrices of a palette into stretches and unit motions. Both are palettes
            /// for dq8_skin_stretched. A matrix is the product of the motion and the stretch, and
            /// the stretch acts first. `matrices` and `stretches` have twelve components per joint,
            /// row by row. Returns DQ8_STATUS_NOT_FINITE if a component is not finite.
            skin::split(
                matrices: *const $R, motions: *mut $R, stretches: *mut $R, joint_count: usize,
            ) = super::split(matrices, motions, stretches, joint_count)
        }
    };
}
for_both_numbers!(functions);

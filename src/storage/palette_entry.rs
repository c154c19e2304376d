//! [`PaletteEntry`], the forms in which palettes hold motions, and [`MatrixOrder`], the order of a
//! matrix in memory.

use super::element::Element;
use crate::batch;
use dq8_simd::Lanes;

/// The order in which the entries of a matrix lie in memory.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum MatrixOrder {
    /// Row after row, as in HLSL `row_major`, in C arrays, and in `[[R; 4]; 3]` everywhere in this
    /// crate.
    #[default]
    Rows,
    /// Column after column, as in GLSL, WGSL, glam and nalgebra. This order is for matrices that
    /// other programs read, because dq8 itself reads rows.
    Columns,
}

/// An element of a skinning palette: a motion (`C` = 8), a 3×4 matrix (`C` = 12), or a 4×4 matrix
/// with the last row 0 0 0 1 (`C` = 16). It is a plain thing, or a block if the models are blocks.
/// The trait is sealed, like [`Element`].
///
/// Plain matrices are `[[f32; 4]; 3]` and `[[f32; 4]; 4]` by rows. By columns a 4×4 matrix is
/// `[[f32; 4]; 4]` too; a 3×4 matrix by columns is `[f32; 12]`, so that its columns are not
/// mistaken for rows.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no entry of a palette",
    note = "motions (`DualQuat`), 3×4 matrices (`[[f32; 4]; 3]` by rows, `[f32; 12]` by columns) and 4×4 matrices \
            (`[[f32; 4]; 4]`) are, and blocks of them",
    note = "a slice of `glam::Mat4` becomes one by `dq8::interop::glam_034::mat4s_mut`, with `MatrixOrder::Columns`"
)]
pub trait PaletteEntry<const C: usize>: Element<C> {
    /// Returns a unit motion in this form.
    #[doc(hidden)]
    #[must_use]
    fn of<L: Lanes>(motion: batch::DualQuat<L>, order: MatrixOrder) -> [L; C];
}

impl<E: Element<8>> PaletteEntry<8> for E {
    #[inline(always)]
    fn of<L: Lanes>(motion: batch::DualQuat<L>, _: MatrixOrder) -> [L; 8] {
        motion.to_array()
    }
}

impl<E: Element<12>> PaletteEntry<12> for E {
    #[inline(always)]
    fn of<L: Lanes>(motion: batch::DualQuat<L>, order: MatrixOrder) -> [L; 12] {
        let [[a, b, c, d], [e, f, g, h], [i, j, k, l]] = motion.to_matrix3x4();
        match order {
            MatrixOrder::Rows => [a, b, c, d, e, f, g, h, i, j, k, l],
            MatrixOrder::Columns => [a, e, i, b, f, j, c, g, k, d, h, l],
        }
    }
}

impl<E: Element<16>> PaletteEntry<16> for E {
    #[inline(always)]
    fn of<L: Lanes>(motion: batch::DualQuat<L>, order: MatrixOrder) -> [L; 16] {
        let [[a, b, c, d], [e, f, g, h], [i, j, k, l], [m, n, o, p]] = motion.to_matrix4();
        match order {
            MatrixOrder::Rows => [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p],
            MatrixOrder::Columns => [a, e, i, m, b, f, j, n, c, g, k, o, d, h, l, p],
        }
    }
}

use super::SkinningError;
use crate::number::Real;
use crate::representation::Affine;
use crate::scalar::DualQuat;
use crate::storage::MatrixOrder;
use crate::storage::shape::same_length;

/// The result of [`split_palette`]: the distance of the stretches from the identity, and the
/// numbers of joints that mirror or squeeze.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Split {
    /// The largest difference of an element of a stretch from the identity. It is only rounding if
    /// all joints are rigid; then [`DualBlend`](super::DualBlend) suffices.
    pub stretch: f64,
    /// The joint whose stretch has the largest difference.
    pub joint: usize,
    /// The number of joints whose matrix mirrors (has a negative determinant).
    pub mirroring: usize,
    /// The number of joints whose matrix squeezes space onto a line or a point, or whose stretch
    /// would not be finite. Their motion has no rotation: all of the matrix but the translation is
    /// in the stretch.
    pub squeezing: usize,
}

impl Split {
    /// `true` if no stretch differs from the identity by more than `tolerance`.
    #[must_use]
    pub fn is_rigid(&self, tolerance: f64) -> bool {
        self.stretch <= tolerance && self.mirroring == 0 && self.squeezing == 0
    }
}

/// Computes the products model(j) · inverse bind(j) of affine 4×4 matrices as 3×4 matrices by
/// rows: a palette for [`Linear`](super::Linear). `order` is the order of components in the input
/// matrices.
///
/// # Errors
/// If the slices differ in length, an element of a matrix or of a product is not finite, or a last
/// row is not 0 0 0 1. `palette` is then untouched.
///
/// ```
/// use dq8::hierarchy::MatrixOrder;
/// use dq8::skinning::matrix_palette;
/// // Columns, as in glTF: the translation comes last.
/// let mut model = [[0.0_f32; 4]; 4];
/// (model[0][0], model[1][1], model[2][2], model[3]) = (1.0, 1.0, 1.0, [5.0, 0.0, 0.0, 1.0]);
/// let mut palette = [[[0.0; 4]; 3]];
/// matrix_palette(&[model], &[model], MatrixOrder::Columns, &mut palette)?;
/// assert_eq!(palette[0][0], [1.0, 0.0, 0.0, 10.0]);
/// # Ok::<(), dq8::skinning::SkinningError>(())
/// ```
pub fn matrix_palette<R: Real>(
    models: &[[[R; 4]; 4]],
    inverse_binds: &[[[R; 4]; 4]],
    order: MatrixOrder,
    palette: &mut [[[R; 4]; 3]],
) -> Result<(), SkinningError> {
    same_length("inverse_binds", inverse_binds.len(), models.len())?;
    same_length("palette", palette.len(), models.len())?;
    let joints = || models.iter().zip(inverse_binds).enumerate();
    let product =
        |joint, model: [[R; 4]; 4], bind: [[R; 4]; 4]| -> Result<Affine<R>, SkinningError> {
            let product = affine(model, order, joint)? * affine(bind, order, joint)?;
            match product.to_matrix3x4().into_iter().flatten().find(|value| !value.is_finite()) {
                Some(value) => Err(SkinningError::NotFinite { joint, value: value.into() }),
                None => Ok(product),
            }
        };
    for (joint, (&model, &bind)) in joints() {
        product(joint, model, bind)?;
    }
    for ((joint, (&model, &bind)), entry) in joints().zip(palette) {
        *entry = product(joint, model, bind)?.to_matrix3x4();
    }
    Ok(())
}

/// Returns the affine map of the 4×4 matrix of a joint, or an error if the matrix is not affine.
fn affine<R: Real>(
    matrix: [[R; 4]; 4],
    order: MatrixOrder,
    joint: usize,
) -> Result<Affine<R>, SkinningError> {
    let rows = match order {
        MatrixOrder::Rows => matrix,
        MatrixOrder::Columns => core::array::from_fn(|i| core::array::from_fn(|j| matrix[j][i])),
    };
    if let Some(value) = rows.into_iter().flatten().find(|value| !value.is_finite()) {
        return Err(SkinningError::NotFinite { joint, value: value.into() });
    }
    let [x, y, z, last] = rows;
    let identity = [R::ZERO, R::ZERO, R::ZERO, R::ONE];
    for (column, (value, wanted)) in last.into_iter().zip(identity).enumerate() {
        if value != wanted {
            return Err(SkinningError::NotAffine { joint, column, value: value.into() });
        }
    }
    Ok(Affine::from_matrix3x4([x, y, z]))
}

/// Splits each joint's matrix into a stretch and a motion that is applied after it (polar
/// decomposition; see [`Affine::try_decompose`]). Both are the palette of a
/// [`StretchedDualBlend`](super::StretchedDualBlend). If all joints are rigid, the motions alone
/// are the palette of a [`DualBlend`](super::DualBlend).
///
/// The result tells the distance of the stretches from the identity, and how many joints mirror or
/// squeeze; [`Split::is_rigid`] is `true` if a [`DualBlend`](super::DualBlend) suffices.
///
/// # Errors
/// If the slices differ in length or an element is not finite; `motions` and `stretches` are then
/// untouched.
///
/// ```
/// use dq8::skinning::split_palette;
/// let mut motions = [dq8::DualQuat::IDENTITY];
/// let mut stretches = [[[0.0_f64; 4]; 3]];
/// let wide = [[0.0, -3.0, 0.0, 5.0], [2.0, 0.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];
/// let split = split_palette(&[wide], &mut motions, &mut stretches)?;
/// assert!((split.stretch - 2.0).abs() < 1e-14);
/// assert!((stretches[0][0][0] - 2.0).abs() < 1e-14);
/// assert!((motions[0].translation()[0] - 5.0).abs() < 1e-14);
/// # Ok::<(), dq8::skinning::SkinningError>(())
/// ```
pub fn split_palette<R: Real>(
    matrices: &[[[R; 4]; 3]],
    motions: &mut [DualQuat<R>],
    stretches: &mut [[[R; 4]; 3]],
) -> Result<Split, SkinningError> {
    same_length("motions", motions.len(), matrices.len())?;
    same_length("stretches", stretches.len(), matrices.len())?;
    for (joint, matrix) in matrices.iter().enumerate() {
        if let Some(&value) = matrix.as_flattened().iter().find(|value| !value.is_finite()) {
            return Err(SkinningError::NotFinite { joint, value: value.into() });
        }
    }
    let mut split = Split { stretch: 0.0, joint: 0, mirroring: 0, squeezing: 0 };
    let entries = motions.iter_mut().zip(stretches.iter_mut());
    for ((joint, matrix), (motion, stretch)) in matrices.iter().enumerate().zip(entries) {
        let map = Affine::from_matrix3x4(*matrix);
        let linear = match map.try_decompose() {
            Ok((rigid, linear)) => {
                *motion = rigid;
                split.mirroring += usize::from(determinant(linear) < R::ZERO);
                linear
            }
            // A matrix that squeezes space onto a line or a point has no rotation of its own, so
            // all of its linear part becomes the stretch.
            Err(_) => {
                split.squeezing += 1;
                *motion = DualQuat::from_translation(map.translation);
                map.linear
            }
        };
        for (row, numbers) in linear.into_iter().enumerate() {
            for (column, number) in numbers.into_iter().enumerate() {
                let identity = if row == column { R::ONE } else { R::ZERO };
                let off = (number - identity).abs().into();
                if off > split.stretch {
                    (split.stretch, split.joint) = (off, joint);
                }
            }
        }
        let [x, y, z] = linear;
        *stretch = [x, y, z].map(|[a, b, c]| [a, b, c, R::ZERO]);
    }
    Ok(split)
}

fn determinant<R: Real>([[a, b, c], [d, e, f], [g, h, i]]: [[R; 3]; 3]) -> R {
    a * (e * i - f * h) + b * (f * g - d * i) + c * (d * h - e * g)
}

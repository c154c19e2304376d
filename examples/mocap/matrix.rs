//! The contender everyone knows: rigid motions as 4×4 matrices.

/// Columns first, as in glam and on GPUs: a product then multiplies whole columns of the parent,
/// which is a fifth faster here than rows first.
pub(crate) type Matrix = [[f32; 4]; 4];

pub(crate) fn from_rows(rows: [[f32; 4]; 4]) -> Matrix {
    [0, 1, 2, 3].map(|column| rows.map(|row| row[column]))
}

pub(crate) fn translation(matrix: &Matrix) -> [f32; 3] {
    let [x, y, z, _] = matrix[3];
    [x, y, z]
}

pub(crate) fn product(a: &Matrix, b: &Matrix) -> Matrix {
    // Written out like this it becomes four-wide arithmetic; with nested `map` it takes six times
    // as long.
    let column = |[x, y, z, w]: [f32; 4]| {
        let row = |i: usize| a[0][i] * x + a[1][i] * y + a[2][i] * z + a[3][i] * w;
        [row(0), row(1), row(2), row(3)]
    };
    [column(b[0]), column(b[1]), column(b[2]), column(b[3])]
}

/// As `Hierarchy::local_to_model`, `[instance][joint]`; the parent of a root is `None`.
pub(crate) fn local_to_model(parents: &[Option<usize>], locals: &[Matrix], models: &mut [Matrix]) {
    let joints = parents.len();
    for (locals, models) in locals.chunks_exact(joints).zip(models.chunks_exact_mut(joints)) {
        for (joint, local) in locals.iter().enumerate() {
            models[joint] = match parents[joint] {
                Some(parent) => product(&models[parent], local),
                None => *local,
            };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{from_rows, local_to_model, product, translation};

    #[test]
    fn the_right_factor_acts_first() {
        let turn = [[0., -1., 0., 0.], [1., 0., 0., 0.], [0., 0., 1., 0.], [0., 0., 0., 1.]];
        let shift = [[1., 0., 0., 5.], [0., 1., 0., 6.], [0., 0., 1., 7.], [0., 0., 0., 1.]];
        let both = [[0., -1., 0., -6.], [1., 0., 0., 5.], [0., 0., 1., 7.], [0., 0., 0., 1.]];
        let [turn, shift, both] = [turn, shift, both].map(from_rows);
        assert_eq!(product(&turn, &shift), both);
        assert_eq!(translation(&both), [-6., 5., 7.]);
        let mut models = [shift; 4];
        local_to_model(&[None, Some(0)], &[turn, shift, shift, turn], &mut models);
        assert_eq!(models, [turn, both, shift, product(&shift, &turn)]);
    }
}

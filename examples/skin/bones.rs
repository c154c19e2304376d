/// The columns of the identity.
pub(crate) const IDENTITY: [[f64; 4]; 4] =
    [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];

/// What moves a mesh.
#[derive(Clone, Debug)]
pub(crate) struct Bones {
    pub(crate) nodes: Vec<usize>,
    /// The columns of a matrix per node.
    pub(crate) inverse_binds: Vec<[[f64; 4]; 4]>,
}

impl Bones {
    /// One node.
    pub(crate) fn node(node: usize) -> Self {
        Self { nodes: vec![node], inverse_binds: vec![IDENTITY] }
    }
}

/// Columns whose last row is exactly 0 0 0 1. Exporters that invert matrices leave rounding there.
pub(crate) fn affine(mut columns: [[f64; 4]; 4]) -> Result<[[f64; 4]; 4], String> {
    for (column, identity) in columns.iter_mut().zip(IDENTITY) {
        let near = (column[3] - identity[3]).abs() <= 1e-5;
        if !near {
            return Err(format!("{} in its last row, which must be 0 0 0 1", column[3]));
        }
        column[3] = identity[3];
    }
    Ok(columns)
}

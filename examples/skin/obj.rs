use crate::mesh::Mesh;
use std::fmt::Write;

/// All vertices, and the triangles of all meshes.
pub(crate) fn text(time: f64, meshes: &[Mesh], posed: &[Vec<[f64; 3]>]) -> String {
    let mut text = format!("# {time} s\n");
    for [x, y, z] in posed.iter().flatten() {
        // The shortest digits that are read as the same number. Writing to a string cannot fail.
        let _ = writeln!(text, "v {x} {y} {z}");
    }
    let mut first = 1;
    for (mesh, posed) in meshes.iter().zip(posed) {
        for [a, b, c] in &mesh.triangles {
            let _ = writeln!(text, "f {} {} {}", a + first, b + first, c + first);
        }
        first += posed.len();
    }
    text
}

use crate::mesh::Mesh;
use std::fmt::Write;

const SIZE: f64 = 320.0;

/// One picture of an SVG: triangles in the world, y up, seen along −z and a little from the side and above.
#[derive(Debug)]
pub(crate) struct Panel {
    pub(crate) title: String,
    pub(crate) triangles: Vec<[[f64; 3]; 3]>,
}

impl Panel {
    pub(crate) fn of(title: String, meshes: &[Mesh], posed: &[Vec<[f64; 3]>]) -> Self {
        let mut triangles = Vec::new();
        for (mesh, posed) in meshes.iter().zip(posed) {
            triangles.extend(mesh.triangles.iter().map(|corners| corners.map(|i| posed[i])));
        }
        Self { title, triangles }
    }
}

fn turned([x, y, z]: [f64; 3]) -> [f64; 3] {
    let (sin, cos) = 0.5_f64.sin_cos();
    let (x, z) = (cos * x + sin * z, cos * z - sin * x);
    let (sin, cos) = 0.3_f64.sin_cos();
    [x, cos * y - sin * z, sin * y + cos * z]
}

/// The panels next to each other, all on one scale; the nearest triangles last.
pub(crate) fn svg(panels: &[Panel]) -> String {
    let seen: Vec<Vec<_>> = panels
        .iter()
        .map(|panel| panel.triangles.iter().map(|t| t.map(turned)).collect())
        .collect();
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for point in seen.iter().flatten().flatten() {
        for c in 0..2 {
            (low[c], high[c]) = (low[c].min(point[c]), high[c].max(point[c]));
        }
    }
    let extent = (high[0] - low[0]).max(high[1] - low[1]).max(1e-9);
    let scale = 0.85 * SIZE / extent;
    let (width, height) = (SIZE * panels.len() as f64, SIZE + 30.0);
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" \
         font-family=\"sans-serif\" font-size=\"13\">\n\
         <rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
    );
    for (index, (panel, mut triangles)) in panels.iter().zip(seen).enumerate() {
        let left = SIZE * (index as f64 + 0.5);
        let place = |[x, y, _]: [f64; 3]| {
            let x = left + scale * (x - (low[0] + high[0]) / 2.0);
            (x, SIZE / 2.0 - scale * (y - (low[1] + high[1]) / 2.0))
        };
        let depth = |t: &[[f64; 3]; 3]| t[0][2] + t[1][2] + t[2][2];
        triangles.sort_by(|a, b| depth(a).total_cmp(&depth(b)));
        let title = panel.title.replace('&', "&amp;").replace('<', "&lt;");
        let _ = writeln!(
            text,
            "<text x=\"{left}\" y=\"{}\" text-anchor=\"middle\">{title}</text>\n\
             <g stroke=\"#333\" stroke-width=\"0.2\" stroke-linejoin=\"round\">",
            SIZE + 15.0
        );
        for triangle in &triangles {
            let [a, b, c] = triangle.map(place);
            let shade = (90.0 + 150.0 * facing(triangle)) as u8;
            let _ = writeln!(
                text,
                "<path d=\"M{:.1} {:.1}L{:.1} {:.1}L{:.1} {:.1}Z\" fill=\"rgb({shade},{shade},235)\"/>",
                a.0, a.1, b.0, b.1, c.0, c.1
            );
        }
        text += "</g>\n";
    }
    text + "</svg>\n"
}

/// How much a triangle faces whoever looks, from 0 to 1.
fn facing([a, b, c]: &[[f64; 3]; 3]) -> f64 {
    let edge = |to: &[f64; 3]| [to[0] - a[0], to[1] - a[1], to[2] - a[2]];
    let ([ux, uy, uz], [vx, vy, vz]) = (edge(b), edge(c));
    let normal = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    let length = normal.iter().map(|c| c * c).sum::<f64>().sqrt();
    if length > 0.0 { (normal[2] / length).abs() } else { 0.0 }
}

use crate::mesh::{Mesh, corners};
use dq8::Quat;
use dq8::scalar::vector::{cross, norm, sub};
use dq8_fixtures::legible::wrapped;
use std::fmt::Write;

const SIZE: f64 = 320.0;
/// Panels next to each other, so that their titles can be read where the picture is as wide as a
/// page.
const COLUMNS: usize = 3;
/// Letters of titles, from one line to the next, and what is free around them.
const LETTERS: f64 = 13.0;
const LINE: f64 = 17.0;
const AROUND: f64 = 8.0;

pub(crate) type Triangle = [[f64; 3]; 3];

/// One picture of an SVG: triangles in the world, y up, seen along −z and a little from the side
/// and above.
#[derive(Debug)]
pub(crate) struct Panel {
    pub(crate) title: String,
    pub(crate) triangles: Vec<Triangle>,
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

/// The panels row by row, all on one scale; the nearest triangles last.
pub(crate) fn svg(panels: &[Panel]) -> String {
    let turn = Quat::from_rotation_x(0.3) * Quat::from_rotation_y(0.5);
    let seen = panels.iter().map(|panel| {
        panel.triangles.iter().map(|corners| corners.map(|point| turn.rotate(point))).collect()
    });
    let seen: Vec<Vec<_>> = seen.collect();
    let [low, high] = corners(seen.iter().flatten().flatten());
    let extent = (high[0] - low[0]).max(high[1] - low[1]).max(1e-9);
    let scale = 0.85 * SIZE / extent;
    let titles: Vec<_> = panels
        .iter()
        .map(|panel| wrapped(&panel.title, LETTERS, false, SIZE - 2.0 * AROUND))
        .collect();
    let lines = titles.iter().map(Vec::len).max().unwrap_or(0);
    let row = SIZE + LINE * lines as f64 + 2.0 * AROUND;
    let columns = panels.len().min(COLUMNS);
    let width = SIZE * columns as f64;
    let height = row * panels.len().div_ceil(COLUMNS) as f64;
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" \
         font-family=\"sans-serif\" font-size=\"{LETTERS}\">\n\
         <rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
    );
    for (index, (title, mut triangles)) in titles.iter().zip(seen).enumerate() {
        let middle = SIZE * ((index % COLUMNS) as f64 + 0.5);
        let top = row * (index / COLUMNS) as f64;
        let place = |[x, y, _]: [f64; 3]| {
            let x = middle + scale * (x - (low[0] + high[0]) / 2.0);
            (x, top + SIZE / 2.0 - scale * (y - (low[1] + high[1]) / 2.0))
        };
        let depth = |t: &Triangle| t[0][2] + t[1][2] + t[2][2];
        triangles.sort_by(|a, b| depth(a).total_cmp(&depth(b)));
        for (line, title) in title.iter().enumerate() {
            let title = title.replace('&', "&amp;").replace('<', "&lt;");
            let y = top + SIZE + LINE * (line + 1) as f64;
            let _ = writeln!(
                text,
                "<text x=\"{middle}\" y=\"{y}\" text-anchor=\"middle\">{title}</text>"
            );
        }
        text += "<g stroke=\"#333\" stroke-width=\"0.2\" stroke-linejoin=\"round\">\n";
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
fn facing([a, b, c]: &Triangle) -> f64 {
    let normal = cross(sub(*b, *a), sub(*c, *a));
    let length = norm(normal);
    if length > 0.0 { (normal[2] / length).abs() } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::{Panel, svg};
    use dq8_fixtures::legible::illegible;

    /// Also where there is one panel, or more than a row has, or a name of an animation of any
    /// length.
    #[test]
    fn no_two_titles_overlap_and_none_leaves_the_page() {
        let (_, tube) = crate::tube::report().unwrap();
        assert_eq!(illegible(&tube), [""; 0]);
        for count in 1..=7 {
            for words in [1, 3, 40] {
                let panels: Vec<_> = (0..count)
                    .map(|_| Panel {
                        title: format!("{} {}", "a title".repeat(words), "and more ".repeat(words)),
                        triangles: vec![[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]],
                    })
                    .collect();
                assert_eq!(illegible(&svg(&panels)), [""; 0], "{count} {words}");
            }
        }
    }
}

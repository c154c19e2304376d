//! The clip and the robot at the same moments.

use crate::scene::Scene;
use dq8::DualQuat;
use std::error::Error;
use std::fmt::Write as _;

const MOMENTS: usize = 7;
const WIDTH: f64 = 1400.0;
const MARGIN: f64 = 40.0;

/// To the right, and up, seen from in front of the left.
fn seen([x, y, z]: [f64; 3]) -> [f64; 2] {
    [0.8 * x - 0.6 * y, z - 0.12 * (0.6 * x + 0.8 * y)]
}

pub(crate) fn draw(scene: &Scene, motion: &[f64]) -> Result<String, Box<dyn Error>> {
    let (mechanism, joints) = (scene.robot.mechanism(), scene.clip.joints.len());
    let (count, last) = (mechanism.values(), scene.frames() - 1);
    let bones: Vec<_> = scene.clip.joints.iter().map(|joint| joint.parent).collect();
    let links: Vec<_> = scene.robot.joints().iter().map(|joint| joint.parent).collect();
    let mut figures = Vec::new();
    for moment in 0..MOMENTS {
        let frame = last * moment / (MOMENTS - 1);
        let mut poses = vec![DualQuat::IDENTITY; mechanism.links()];
        mechanism.link_poses(&motion[frame * count..][..count], &mut poses)?;
        let robot = poses.iter().map(|pose| pose.translation()).collect();
        figures.push((frame, [scene.skeleton[frame * joints..][..joints].to_vec(), robot]));
    }
    // Each stands by itself: as high as the highest, under the place of its root.
    let mut size = 0.0_f64;
    for [x, y] in figures.iter().flat_map(|(_, both)| both).flat_map(|points| about(points)) {
        size = size.max(x.abs() / 0.25).max(2.0 * y.abs());
    }
    let wide = (WIDTH - 2.0 * MARGIN) / MOMENTS as f64;
    // A figure, and room for a title.
    let (high, scale) = (2.0 * wide + 50.0, 2.0 * wide / size.max(1e-9));
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {:.0}\" font-family=\"sans-serif\" \
         font-size=\"18\" fill=\"#333\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
        2.0 * high + 80.0
    );
    for (row, (title, parents)) in [("The clip", &bones), ("The robot", &links)].iter().enumerate()
    {
        let top = 60.0 + high * row as f64;
        writeln!(
            svg,
            "<text x=\"{MARGIN}\" y=\"{:.0}\" font-size=\"24\">{title}</text>",
            top - 20.0
        )?;
        for (column, (_, both)) in figures.iter().enumerate() {
            let middle = [MARGIN + wide * (column as f64 + 0.5), top + wide];
            let points = about(&both[row]);
            let place = |index: usize| {
                [middle[0] + scale * points[index][0], middle[1] - scale * points[index][1]]
            };
            for (index, parent) in parents.iter().enumerate() {
                let Some(parent) = *parent else { continue };
                let ([x, y], [from_x, from_y]) = (place(index), place(parent));
                let side = side(if row == 0 {
                    &scene.clip.joints[index].name
                } else {
                    &scene.robot.link_names()[index]
                });
                writeln!(
                    svg,
                    "<path d=\"M{from_x:.1} {from_y:.1}L{x:.1} {y:.1}\" stroke=\"{side}\" stroke-width=\"5\" stroke-linecap=\"round\"/>"
                )?;
            }
        }
    }
    for (column, (frame, _)) in figures.iter().enumerate() {
        let x = MARGIN + wide * (column as f64 + 0.5);
        let (y, time) = (2.0 * high + 50.0, *frame as f64 * scene.step);
        writeln!(svg, "<text x=\"{x:.0}\" y=\"{y:.0}\" text-anchor=\"middle\">{time:.2} s</text>")?;
    }
    svg.push_str("</svg>\n");
    Ok(svg)
}

/// As seen, from the middle of the highest and the lowest, and the root.
fn about(points: &[[f64; 3]]) -> Vec<[f64; 2]> {
    let seen: Vec<_> = points.iter().map(|&point| self::seen(point)).collect();
    let heights = seen.iter().map(|point| point[1]);
    let (low, high) = (heights.clone().fold(f64::MAX, f64::min), heights.fold(f64::MIN, f64::max));
    seen.iter().map(|[x, y]| [x - seen[0][0], y - 0.5 * (low + high)]).collect()
}

fn side(name: &str) -> &'static str {
    match name.chars().next().map(|first| first.to_ascii_lowercase()) {
        Some('l') if !name.to_lowercase().starts_with("low") => "#0072b2",
        Some('r') => "#d55e00",
        _ => "#444",
    }
}

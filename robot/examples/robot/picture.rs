//! The places of the tool: how often random configurations put it into each cell, from the side
//! and from above, and the robot in front of it.

use crate::configurations;
use crate::tool::tool;
use dq8::{Backend, DualQuat};
use dq8_robot::urdf::Robot;
use std::error::Error;
use std::fmt::Write as _;
use std::path::Path;

/// The number of configurations, enough for cells that are seldom reached.
const CONFIGURATIONS: usize = 400_000;
/// Cells of a side of a view, and its size in pixels.
const CELLS: usize = 150;
const SIDE: f64 = 600.0;
/// How high letters are in the title and in the captions; and so many of the title fit, whichever
/// they are.
const TITLE: f64 = 22.0;
const CAPTION: f64 = 16.0;
const LETTERS: usize = 55;
/// Shades of a cell.
const SHADES: usize = 32;

/// The views: a title and which coordinates go right and up.
const VIEWS: [(&str, [usize; 2], [&str; 2]); 2] =
    [("from the side", [0, 2], ["x", "z"]), ("from above", [0, 1], ["x", "y"])];

pub(crate) fn write(robot: &Robot, backend: Backend, path: &Path) -> Result<(), Box<dyn Error>> {
    let mechanism = robot.mechanism();
    let tool = tool(robot);
    let values = configurations::random(robot, CONFIGURATIONS);
    let mut tools = vec![DualQuat::IDENTITY; if values.is_empty() { 1 } else { CONFIGURATIONS }];
    mechanism.job().links(&[tool]).backend(backend).poses(&values, &mut tools)?;
    let points: Vec<_> = tools.iter().map(|pose| pose.translation()).collect();
    let mut rest = vec![DualQuat::IDENTITY; mechanism.links()];
    mechanism.link_poses(&configurations::nearest_zero(robot), &mut rest)?;
    let rest: Vec<_> = rest.iter().map(|pose| pose.translation()).collect();
    let svg = draw(robot, &robot.link_names()[tool], &points, &rest);
    std::fs::write(path, svg)
        .map_err(|error| format!("cannot write {}: {error}", path.display()))?;
    Ok(())
}

/// The cube around all points: its centre and half its side.
fn cube(points: &[[f64; 3]]) -> ([f64; 3], f64) {
    let mut bounds = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
    for point in points {
        for (bound, number) in bounds.iter_mut().zip(point) {
            *bound = [bound[0].min(*number), bound[1].max(*number)];
        }
    }
    let half = bounds.iter().map(|[low, high]| 0.5 * (high - low)).fold(0.05, f64::max);
    (bounds.map(|[low, high]| 0.5 * (low + high)), 1.06 * half)
}

fn draw(robot: &Robot, tool: &str, points: &[[f64; 3]], rest: &[[f64; 3]]) -> String {
    let (centre, half) = cube(&[points, rest].concat());
    let (width, height) = (2.0 * SIDE + 90.0, SIDE + 110.0);
    let title = shortened(format!("{}: where {tool} can be", robot.name()));
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" \
         font-family=\"sans-serif\" fill=\"#e8e8f0\">\n\
         <rect width=\"{width}\" height=\"{height}\" fill=\"#10101c\"/>\n\
         <text x=\"30\" y=\"38\" font-size=\"{TITLE}\">{}</text>\n",
        escape(&title),
    );
    for (view, (title, axes, names)) in VIEWS.into_iter().enumerate() {
        let (left, top) = (30.0 + view as f64 * (SIDE + 30.0), 60.0);
        let place = |point: &[f64; 3]| {
            let along = |axis: usize| (point[axis] - centre[axis]) / half;
            [left + SIDE * 0.5 * (1.0 + along(axes[0])), top + SIDE * 0.5 * (1.0 - along(axes[1]))]
        };
        // Writing to a string cannot fail.
        let _ = writeln!(
            svg,
            "<rect x=\"{left}\" y=\"{top}\" width=\"{SIDE}\" height=\"{SIDE}\" fill=\"#181828\"/>"
        );
        cells(&mut svg, points, place, [left, top]);
        grid(&mut svg, centre, half, axes, [left, top]);
        skeleton(&mut svg, robot, rest, place);
        let _ = writeln!(
            svg,
            "<text x=\"{left}\" y=\"{}\" font-size=\"{CAPTION}\">{title}: {} to the right, {} up; a line every \
             {} m</text>",
            top + SIDE + 30.0,
            names[0],
            names[1],
            spacing(half),
        );
    }
    svg.push_str("</svg>\n");
    svg
}

/// A square for each cell that is reached, brighter the more often.
fn cells(
    svg: &mut String,
    points: &[[f64; 3]],
    place: impl Fn(&[f64; 3]) -> [f64; 2],
    [left, top]: [f64; 2],
) {
    let mut counts = vec![0_u32; CELLS * CELLS];
    let size = SIDE / CELLS as f64;
    for [x, y] in points.iter().map(place) {
        let (column, row) = (((x - left) / size) as usize, ((y - top) / size) as usize);
        counts[row.min(CELLS - 1) * CELLS + column.min(CELLS - 1)] += 1;
    }
    let most = f64::from(counts.iter().copied().max().unwrap_or(1)).ln_1p();
    // One path for each shade; cells are a little larger than they are apart, so that no seams
    // show.
    let mut paths = vec![String::new(); SHADES];
    for (cell, &count) in counts.iter().enumerate().filter(|(_, count)| **count > 0) {
        let (x, y) = ((cell % CELLS) as f64 * size + left, (cell / CELLS) as f64 * size + top);
        let shade = f64::from(count).ln_1p() / most * (SHADES - 1) as f64;
        let _ = write!(paths[shade as usize], "M{x} {y}h{w}v{w}h-{w}z", w = size + 0.2);
    }
    for (shade, path) in paths.iter().enumerate().filter(|(_, path)| !path.is_empty()) {
        let [red, green, blue] = colour(shade as f64 / (SHADES - 1) as f64);
        let _ = writeln!(svg, "<path fill=\"#{red:02x}{green:02x}{blue:02x}\" d=\"{path}\"/>");
    }
}

/// From violet over red to a light yellow, for a share between 0 and 1.
fn colour(share: f64) -> [u8; 3] {
    const STOPS: [[f64; 3]; 5] = [
        [38.0, 24.0, 74.0],
        [106.0, 23.0, 110.0],
        [188.0, 55.0, 84.0],
        [249.0, 142.0, 9.0],
        [252.0, 250.0, 164.0],
    ];
    let at = share.clamp(0.0, 1.0) * 4.0;
    let index = (at as usize).min(3);
    let between = at - index as f64;
    core::array::from_fn(|i| {
        (STOPS[index][i] + between * (STOPS[index + 1][i] - STOPS[index][i])).round() as u8
    })
}

/// Metres between lines: 1, 2 or 5 times a power of ten.
fn spacing(half: f64) -> f64 {
    let power = 10_f64.powf((half / 2.0).log10().floor());
    let steps = [5.0, 2.0, 1.0].map(|step| step * power);
    steps.into_iter().find(|step| *step <= half / 2.0).unwrap_or(power)
}

fn grid(svg: &mut String, centre: [f64; 3], half: f64, axes: [usize; 2], [left, top]: [f64; 2]) {
    let step = spacing(half);
    for (which, axis) in axes.into_iter().enumerate() {
        let (low, high) = (centre[axis] - half, centre[axis] + half);
        for line in (low / step).ceil() as i64..=(high / step).floor() as i64 {
            let share = (line as f64 * step - low) / (high - low) * SIDE;
            let [x1, y1, x2, y2] = match which {
                0 => [left + share, top, left + share, top + SIDE],
                _ => [left, top + SIDE - share, left + SIDE, top + SIDE - share],
            };
            let opacity = if line == 0 { 0.35 } else { 0.12 };
            let _ = writeln!(
                svg,
                "<line x1=\"{x1:.1}\" y1=\"{y1:.1}\" x2=\"{x2:.1}\" y2=\"{y2:.1}\" stroke=\"#fff\" stroke-opacity=\"{opacity}\"/>"
            );
        }
    }
}

/// A line from each link to the one that carries it, where the joints are at zero.
fn skeleton(
    svg: &mut String,
    robot: &Robot,
    rest: &[[f64; 3]],
    place: impl Fn(&[f64; 3]) -> [f64; 2],
) {
    for (joint, point) in robot.joints().iter().zip(rest) {
        let [x, y] = place(point);
        if let Some([from_x, from_y]) = joint.parent.and_then(|on| rest.get(on)).map(&place) {
            let _ = writeln!(
                svg,
                "<line x1=\"{from_x:.1}\" y1=\"{from_y:.1}\" x2=\"{x:.1}\" y2=\"{y:.1}\" stroke=\"#7fe3ff\" \
                 stroke-width=\"5\" stroke-linecap=\"round\"/>"
            );
        }
        if joint.kind.values() > 0 {
            let _ = writeln!(
                svg,
                "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"5\" fill=\"#10101c\" stroke=\"#7fe3ff\" stroke-width=\"2\"/>"
            );
        }
    }
}

/// As much of a title as there is room for.
fn shortened(title: String) -> String {
    if title.chars().count() <= LETTERS {
        return title;
    }
    title.chars().take(LETTERS - 1).chain(['…']).collect()
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;")
}

#[test]
fn lines_are_round_numbers_apart() {
    for (half, wanted) in [(1.0, 0.5), (0.8, 0.2), (3.0, 1.0), (0.05, 0.02)] {
        assert!((spacing(half) - wanted).abs() < 1e-12, "{half}: {}", spacing(half));
    }
}

#[test]
fn texts_keep_to_their_places_however_long_names_are() {
    let long = "W".repeat(200);
    for name in ["arm & <hand>", &long] {
        let urdf = format!("<robot name=\"{}\"><link name=\"a\"/></robot>", escape(name));
        let robot = Robot::from_urdf(&urdf).unwrap();
        let svg = draw(&robot, name, &[[0.0; 3], [1e-4; 3]], &[[0.0; 3]]);
        let texts: Vec<_> = svg.lines().filter_map(|line| line.strip_prefix("<text ")).collect();
        let letters = |text: &str| {
            let (_, said) = text.split_once('>').unwrap();
            let said = said.trim_end_matches("</text>").replace("&amp;", "&").replace("&lt;", "<");
            said.chars().count() as f64
        };
        let [title, captions @ ..] = texts.as_slice() else { panic!("{svg}") };
        // No letter is wider than it is high, and those of a sentence are 0.7 of that on the whole.
        assert!(30.0 + TITLE * letters(title) <= 2.0 * SIDE + 90.0, "{title}");
        assert_eq!(captions.len(), 2);
        assert!(
            captions.iter().all(|text| 0.7 * CAPTION * letters(text) <= SIDE + 30.0),
            "{captions:?}"
        );
    }
}

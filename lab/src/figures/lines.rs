//! Jia's figures 1 and 2: a line in Plücker coordinates, and a screw.

use super::canvas::{Canvas, Side, View, colour};
use crate::matrix::length;
use core::f64::consts::TAU;
use dq8::geometry::Screw;
use dq8::{DualQuat, Line};
use dq8_fixtures::vector::cross;

fn along(from: [f64; 3], direction: [f64; 3], far: f64) -> [f64; 3] {
    core::array::from_fn(|i| from[i] + far * direction[i])
}

/// A label beside a point, shifted by pixels.
fn label(
    canvas: &mut Canvas,
    view: View,
    at: [f64; 3],
    [dx, dy]: [f64; 2],
    fill: &str,
    text: &str,
) {
    let [x, y] = view.of(at);
    canvas.text([x + dx, y + dy], Side::Right, 15.0, fill, text);
}

/// Figure 1: direction, moment, a point, and the point nearest to the origin.
pub(super) fn plucker() -> String {
    let view = View { origin: [250.0, 235.0], scale: 165.0, turn: 0.9, height: 0.42 };
    let mut canvas = Canvas::new([820.0, 420.0], "A line in Plücker coordinates (l, m)");
    view.axes(&mut canvas, [0.0; 3], 0.45);
    let direction = [0.6, 0.48, 0.64];
    // 1.2 l from the nearest point, (0.8, 0, −0.75).
    let point = [1.52, 0.576, 0.018];
    let line = Line { direction, moment: cross(point, direction) };
    let nearest = cross(line.direction, line.moment);
    canvas.path([-0.75, 1.4].map(|far| view.of(along(nearest, direction, far))), colour::BLUE, 2.0);
    // The plane of the origin and the line, on which the moment stands.
    canvas.area([view.of([0.0; 3]), view.of(nearest), view.of(point)], colour::OCHRE, 0.25);
    canvas.arrow([view.of([0.0; 3]), view.of(point)], colour::GREEN, 2.0);
    canvas.arrow([view.of([0.0; 3]), view.of(nearest)], colour::PURPLE, 2.0);
    canvas.arrow([view.of([0.0; 3]), view.of(line.moment)], colour::RED, 2.5);
    canvas.arrow([view.of(nearest), view.of(along(nearest, direction, 1.0))], colour::BLUE, 3.5);
    for at in [point, nearest] {
        canvas.dot(view.of(at), 4.5, colour::INK);
    }
    canvas.dot(view.of([0.0; 3]), 4.5, colour::INK);
    // A right angle where l × m meets the line.
    let back = nearest.map(|c| -c / length(nearest));
    let corner = [
        along(nearest, direction, 0.14),
        along(along(nearest, direction, 0.14), back, 0.14),
        along(nearest, back, 0.14),
    ];
    canvas.path(corner.map(|at| view.of(at)), colour::INK, 1.0);
    label(&mut canvas, view, [0.0; 3], [-16.0, 20.0], colour::INK, "O");
    label(&mut canvas, view, point, [10.0, 6.0], colour::GREEN, "p");
    label(&mut canvas, view, nearest, [12.0, 8.0], colour::PURPLE, "l × m");
    label(&mut canvas, view, line.moment, [10.0, 2.0], colour::RED, "m = p × l");
    label(&mut canvas, view, along(nearest, direction, 0.75), [10.0, 4.0], colour::BLUE, "l");
    // Without a minus before nothing.
    let three = |v: [f64; 3]| {
        let v = v.map(|c| (c * 100.0).round() / 100.0 + 0.0);
        format!("({:.2}, {:.2}, {:.2})", v[0], v[1], v[2]).replace('-', "−")
    };
    canvas.legend(
        [520.0, 300.0],
        &[
            (colour::BLUE, &format!("l = {}", three(direction))),
            (colour::GREEN, &format!("p = {}", three(point))),
            (colour::RED, &format!("m = {}", three(line.moment))),
            (colour::PURPLE, &format!("l × m = {}", three(nearest))),
            (colour::INK, &format!("distance ‖m‖ = {:.2}", length(line.moment))),
        ],
    );
    canvas.to_svg()
}

/// A letter that is not its own mirror image, in its own axes.
const FLAG: [[f64; 3]; 7] = [
    [0.0, 0.0, 0.0],
    [0.0, 0.0, 0.9],
    [0.55, 0.0, 0.9],
    [0.55, 0.0, 0.72],
    [0.16, 0.0, 0.72],
    [0.16, 0.0, 0.0],
    [0.0, 0.0, 0.0],
];

/// Figure 2: a turn by θ about a line and a slide by d along it.
pub(super) fn screw() -> String {
    let view = View { origin: [230.0, 400.0], scale: 92.0, turn: 0.45, height: 0.45 };
    let mut canvas = Canvas::new(
        [820.0, 470.0],
        "A motion is a screw: a turn by θ about a line, a slide by d along it",
    );
    view.axes(&mut canvas, [0.0; 3], 0.9);
    let direction = [0.0, 0.28, 0.96];
    let through = [1.1, 0.7, 0.0];
    let screw = Screw {
        axis: Line { direction, moment: cross(through, direction) },
        angle: 0.62 * TAU,
        slide: 1.7,
    };
    let nearest = cross(direction, screw.axis.moment);
    canvas.path([-0.4, 3.0].map(|far| view.of(along(nearest, direction, far))), colour::BLUE, 1.6);
    let start = DualQuat::from_translation([2.0, 0.35, 0.1]);
    let at = |t: f64| {
        DualQuat::from_screw(Screw { angle: t * screw.angle, slide: t * screw.slide, ..screw })
            * start
    };
    let origin_way = (0..=90).map(|i| view.of(at(f64::from(i) / 90.0).translation()));
    canvas.path(origin_way, colour::GREEN, 1.8);
    let tip_way = (0..=90).map(|i| view.of(at(f64::from(i) / 90.0).transform_point(FLAG[2])));
    canvas.dashes(tip_way, colour::GREEN, 1.2);
    for step in 0..=6 {
        let pose = at(f64::from(step) / 6.0);
        let outline: Vec<_> = FLAG.iter().map(|p| view.of(pose.transform_point(*p))).collect();
        let (fill, opacity) = match step {
            0 => (colour::RED, 0.55),
            6 => (colour::PURPLE, 0.55),
            _ => (colour::FRAME, 0.18),
        };
        canvas.area(outline.clone(), fill, opacity);
        canvas.path(outline, fill, 1.2);
    }
    // Spokes from the axis to the body's origin, first and last, and d between their feet.
    let foot = |p: [f64; 3]| {
        let from: [f64; 3] = core::array::from_fn(|i| p[i] - nearest[i]);
        along(nearest, direction, (0..3).map(|i| from[i] * direction[i]).sum())
    };
    let [first, last] = [0.0, 1.0].map(|t| at(t).translation());
    for p in [first, last] {
        canvas.dashes([view.of(foot(p)), view.of(p)], colour::INK, 1.1);
    }
    canvas.arrow([view.of(foot(first)), view.of(foot(last))], colour::BLUE, 3.2);
    let middle = along(foot(first), direction, 0.5 * screw.slide);
    label(&mut canvas, view, middle, [-24.0, 8.0], colour::BLUE, "d");
    // θ, drawn about the foot of the first spoke.
    let spoke: [f64; 3] = core::array::from_fn(|i| first[i] - foot(first)[i]);
    let turned = |t: f64| {
        let turn = DualQuat::from_screw(Screw { angle: t * screw.angle, slide: 0.0, ..screw });
        let turned = turn.transform_vector(spoke);
        view.of(along(foot(first), turned, 0.35))
    };
    canvas.path((0..=60).map(|i| turned(f64::from(i) / 60.0)), colour::OCHRE, 2.0);
    canvas.arrow([turned(0.97), turned(1.0)], colour::OCHRE, 2.0);
    let [x, y] = turned(0.55);
    canvas.text([x - 18.0, y - 4.0], Side::Middle, 15.0, colour::OCHRE, "θ");
    label(&mut canvas, view, along(nearest, direction, 3.0), [8.0, 6.0], colour::BLUE, "l, m");
    canvas.legend(
        [530.0, 330.0],
        &[
            (colour::BLUE, &format!("the line (l, m), the slide d = {:.2}", screw.slide)),
            (colour::OCHRE, &format!("the turn θ = {:.0}°", screw.angle.to_degrees())),
            (colour::RED, "the body before"),
            (colour::PURPLE, "the body after"),
            (colour::GREEN, "ways of two of its points, at σᵗ"),
        ],
    );
    let pitch = format!("pitch d/θ = {:.2} a radian", screw.pitch());
    canvas.text([530.0, 435.0], Side::Right, 13.0, colour::INK, &pitch);
    canvas.to_svg()
}

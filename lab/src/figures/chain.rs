//! Kenwright's figures 2 to 4.

use super::canvas::{Canvas, Side, View, colour};
use crate::drift::{Frames, Homogeneous, LINKS, Loop, Order, Repair, against_ideal};
use crate::matrix::{Matrix, affine_apply, distance};
use crate::report::scientific;

/// By how much deviations are drawn too large.
const ENLARGED: f64 = 1000.0;
const FRAMES: usize = 20_000;
const ROUND: usize = 7000;
/// Half the width of a box around a link, in links.
const WIDTH: f64 = 0.14;
/// Left, top, right and bottom of what the chains fill.
const PLACE: [f64; 4] = [60.0, 120.0, 780.0, 420.0];

/// The drawings, and what they show in numbers.
pub(super) fn figures() -> (String, Vec<String>) {
    let run = |repair: Repair| {
        let upkeep = (repair, Homogeneous::<f32>::gram_schmidt as fn(_) -> _);
        against_ideal([FRAMES, ROUND], Order::StepState, upkeep, Loop::Open)
    };
    let (mut drawings, mut lines) = (String::new(), Vec::new());
    for (repair, name) in [
        (Repair::Never, "matrices left alone"),
        (Repair::Both, "matrices made orthonormal, states and levels"),
    ] {
        let deviation = run(repair);
        let off = distance(deviation.actual[LINKS], deviation.ideal[LINKS]);
        drawings += &figure(name, &deviation.ideal, &deviation.actual, off);
        lines.push(format!(
            "Chain, {name}: after {FRAMES} frames the end is {} links from the ideal one; at worst on the way \
             the skew was {} and the scale {}.",
            scientific(off),
            scientific(deviation.skew),
            scientific(deviation.stretch),
        ));
    }
    (drawings, lines)
}

fn figure(name: &str, ideal: &Frames, actual: &Frames, off: f64) -> String {
    let mut canvas =
        Canvas::new([820.0, 480.0], &format!("Ten links after {FRAMES} frames: {name}"));
    let drawn: Frames = core::array::from_fn(|joint| enlarged(ideal[joint], actual[joint]));
    let view = fitting(ideal.iter().chain(&drawn));
    links(&mut canvas, view, ideal, colour::RED);
    links(&mut canvas, view, &drawn, colour::GREEN);
    let ends = [ideal[LINKS], drawn[LINKS]].map(|frame| view.of(frame.map(|row| row[3])));
    canvas.dashes(ends, colour::INK, 1.2);
    for (end, stroke) in ends.into_iter().zip([colour::RED, colour::GREEN]) {
        canvas.dot(end, 5.0, stroke);
    }
    let base = view.of([0.0; 3]);
    canvas.dot(base, 6.0, colour::INK);
    canvas.text([base[0] - 4.0, base[1] + 22.0], Side::Middle, 13.0, colour::INK, "root");
    canvas.legend(
        [28.0, 48.0],
        &[
            (colour::RED, "ideal, the same steps exactly"),
            (colour::GREEN, "calculated, deviations × 1000"),
            (colour::INK, &format!("end from ideal end: {} links", scientific(off))),
        ],
    );
    view.axes(&mut canvas, view.back([70.0, 440.0]), 0.7);
    // A link for a scale.
    let bar = [[640.0, 455.0], [640.0 + view.scale, 455.0]];
    canvas.path(bar, colour::INK, 2.0);
    canvas.text([648.0 + view.scale, 460.0], Side::Right, 13.0, colour::INK, "one link");
    canvas.to_svg()
}

/// The ideal frame I with the deviation of the actual one A on it: linear part I + k(A − I).
fn enlarged(ideal: Matrix<f64, 3, 4>, actual: Matrix<f64, 3, 4>) -> Matrix<f64, 3, 4> {
    core::array::from_fn(|i| {
        core::array::from_fn(|j| ideal[i][j] + ENLARGED * (actual[i][j] - ideal[i][j]))
    })
}

/// The view in which all of the frames are in their place.
fn fitting<'a>(frames: impl Iterator<Item = &'a Matrix<f64, 3, 4>>) -> View {
    let mut view = View { origin: [0.0; 2], scale: 1.0, turn: 0.35, height: 0.5 };
    let corners = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
    let places = frames.map(|frame| view.of(frame.map(|row| row[3]))).chain([[0.0; 2]]);
    let [low, high] = places.fold(corners, |[low, high], p| {
        [[low[0].min(p[0]), low[1].min(p[1])], [high[0].max(p[0]), high[1].max(p[1])]]
    });
    let [left, top, right, bottom] = PLACE;
    view.scale = ((right - left) / (high[0] - low[0])).min((bottom - top) / (high[1] - low[1]));
    let middle = [0, 1].map(|i| 0.5 * view.scale * (low[i] + high[i]));
    view.origin = [0.5 * (left + right) - middle[0], 0.5 * (top + bottom) - middle[1]];
    view
}

/// A line from joint to joint, and a box around each link in the axes of its frame.
fn links(canvas: &mut Canvas, view: View, frames: &Frames, stroke: &str) {
    let place = |frame: &Matrix<f64, 3, 4>| frame.map(|row| row[3]);
    let joints = core::iter::once([0.0; 3]).chain(frames[..LINKS].iter().map(place));
    let joints: Vec<_> = joints.collect();
    canvas.path(joints.iter().map(|joint| view.of(*joint)), stroke, 2.5);
    for frame in &frames[..LINKS] {
        // The step carries the link, which lies before its frame, from x = −1 to 0.
        let corner = |x: f64, y: f64, z: f64| {
            view.of(affine_apply(*frame, [-x, (y - 0.5) * 2.0 * WIDTH, (z - 0.5) * 2.0 * WIDTH]))
        };
        for x in [0.08, 0.92] {
            let face = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 0.0)];
            let face: Vec<_> = face.into_iter().map(|(y, z)| corner(x, y, z)).collect();
            canvas.area(face.clone(), stroke, 0.12);
            canvas.path(face, stroke, 0.9);
        }
        for (y, z) in [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)] {
            canvas.path([corner(0.08, y, z), corner(0.92, y, z)], stroke, 0.9);
        }
    }
    for joint in &joints {
        canvas.dot(view.of(*joint), 3.0, stroke);
    }
}

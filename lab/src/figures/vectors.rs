//! Arends' appendix: four vectors that turn, as `animate` and `display` move them.

use super::canvas::{Canvas, Side, colour};
use crate::HyperDualQuat;
use crate::arends::{ANGLE_STEP, SLERP_ARC, SLERP_STEP, dual_transform, hyper_transform, slerp};
use crate::matrix;
use crate::report::{Chart, Series};
use core::f64::consts::FRAC_PI_2;
use dq8::{DualQuat, Quat};
use std::error::Error;

/// Frames of a quarter turn.
const FRAMES: usize = 90;
/// The length of his vectors.
const LENGTH: f64 = 0.9;

type Tip = fn(usize, f64) -> [f64; 2];

/// Each window with its colour and where the tip is in a frame; the number is what is added to t of
/// SLERP.
const WINDOWS: [(&str, &str, Tip); 4] = [
    ("rotation matrix", colour::RED, by_matrix),
    ("dual quaternion", colour::BLUE, by_dual_quaternion),
    ("quaternion with SLERP", colour::GREEN, by_slerp),
    ("hyper-dual quaternion", colour::OCHRE, by_hyper_dual_quaternion),
];

fn turn(frame: usize) -> Quat<f64> {
    Quat::from_axis_angle([0.0, 0.0, 1.0], (ANGLE_STEP * frame as f64).to_radians())
}

fn by_matrix(frame: usize, _: f64) -> [f64; 2] {
    let rows = matrix::about([0.0, 0.0, 1.0], (ANGLE_STEP * frame as f64).to_radians());
    let [x, y, _] = matrix::apply(rows, [0.0, LENGTH, 0.0]);
    [x, y]
}

fn by_dual_quaternion(frame: usize, _: f64) -> [f64; 2] {
    let point = DualQuat::new(Quat::IDENTITY, Quat::from_parts([0.0, LENGTH, 0.0], 0.0));
    let [x, y, _] = dual_transform(DualQuat::from_rotation(turn(frame)), point).dual().xyz();
    [x, y]
}

fn by_hyper_dual_quaternion(frame: usize, _: f64) -> [f64; 2] {
    let motion = HyperDualQuat::new(turn(frame), Quat::ZERO, Quat::ZERO, Quat::ZERO);
    let point = HyperDualQuat::point([0.0, LENGTH, 0.0]);
    let [x, y, _] = hyper_transform(motion, point).mixed.xyz();
    [x, y]
}

/// From quarter to quarter: t begins again at 0 as soon as it is above 1.
fn by_slerp(frame: usize, step: f64) -> [f64; 2] {
    let (mut t, mut quarter) = (0.0, 0);
    for _ in 0..frame {
        t += step;
        // What rounding adds to ninety steps of a ninetieth is not above 1.
        if t > 1.0 + 1e-9 {
            (t, quarter) = (0.0, quarter + 1);
        }
    }
    let corner = |quarter: u32| {
        let angle = f64::from(quarter) * FRAC_PI_2;
        Quat::from_parts([-LENGTH * angle.sin(), LENGTH * angle.cos(), 0.0], 0.0)
    };
    let [x, y, _] = slerp(corner(quarter), corner(quarter + 1), t, FRAC_PI_2).xyz();
    [x, y]
}

/// As he has it, and told what the others are told.
const SPEEDS: [(&str, f64); 2] =
    [("as printed: t += 0.0175", SLERP_STEP), ("equal speeds: t += 1/90", ANGLE_STEP / SLERP_ARC)];

/// Degrees from the y axis, against the clock.
fn degrees([x, y]: [f64; 2]) -> f64 {
    (-x).atan2(y).to_degrees().rem_euclid(360.0)
}

/// The four windows twice.
pub(super) fn windows() -> String {
    let mut canvas = Canvas::new([820.0, 500.0], "Arends' four windows after 90 frames");
    for (half, (name, step)) in SPEEDS.into_iter().enumerate() {
        let left = 410.0 * half as f64;
        canvas.text([left + 205.0, 50.0], Side::Middle, 14.0, colour::INK, name);
        for (window, (title, stroke, tip)) in WINDOWS.into_iter().enumerate() {
            let centre =
                [left + 115.0 + 190.0 * (window % 2) as f64, 165.0 + 215.0 * (window / 2) as f64];
            let place = |[x, y]: [f64; 2]| [centre[0] + 85.0 * x, centre[1] - 85.0 * y];
            let tips: Vec<_> = (0..=FRAMES).map(|frame| tip(frame, step)).collect();
            let circle = (0..=72).map(|i| {
                let (sin, cos) = (f64::from(i) * 5.0).to_radians().sin_cos();
                place([LENGTH * cos, LENGTH * sin])
            });
            canvas.path(circle, "#dddddd", 1.0);
            canvas.text([centre[0], centre[1] - 90.0], Side::Middle, 13.0, stroke, title);
            for tip in tips.iter().step_by(10) {
                canvas.dot(place(*tip), 2.5, stroke);
            }
            canvas.dashes([centre, place(tips[FRAMES])], stroke, 1.6);
            let moving: Vec<_> = tips.iter().map(|tip| place(*tip)).collect();
            canvas.swept(centre, &moving, 3.0, stroke);
            canvas.dot(centre, 3.0, colour::INK);
            let said = format!("{:.1}°", degrees(tips[FRAMES]));
            canvas.text([centre[0], centre[1] + 98.0], Side::Middle, 13.0, colour::INK, &said);
        }
    }
    canvas.path([[410.0, 40.0], [410.0, 490.0]], "#cccccc", 1.0);
    canvas.to_svg()
}

/// The angles over the frames.
pub(super) fn angles() -> Result<String, Box<dyn Error>> {
    let [(_, printed), (_, equal)] = SPEEDS;
    let way = |name: &str, tip: Tip, step: f64| {
        let points = (0..=FRAMES).map(|frame| (frame as f64, degrees(tip(frame, step))));
        Series { name: name.to_owned(), points: points.collect() }
    };
    let [matrix, dual, slerp, hyper] = WINDOWS;
    Chart {
        title: "Angles of the four vectors".to_owned(),
        x: "frame".to_owned(),
        y: "degrees".to_owned(),
        logarithmic: false,
        series: vec![
            way(matrix.0, matrix.2, printed),
            way(dual.0, dual.2, printed),
            way(hyper.0, hyper.2, printed),
            way("SLERP, t += 0.0175", slerp.2, printed),
            way("SLERP, t += 1/90", slerp.2, equal),
        ],
    }
    .to_svg()
}

/// How far each has come, in words.
pub(super) fn found() -> Vec<String> {
    let far = |step: f64| {
        let angles =
            WINDOWS.map(|(name, _, tip)| format!("{name} {:.1}°", degrees(tip(FRAMES, step))));
        angles.join(", ")
    };
    SPEEDS
        .map(|(name, step)| format!("Vectors after {FRAMES} frames, {name}: {}.", far(step)))
        .to_vec()
}

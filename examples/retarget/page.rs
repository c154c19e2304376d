//! One page that plays the person and the robot side by side, and needs no other file.

use dq8_retarget::Report;
use mocap::svg::{Figure, Side, sides};
use serde_json::{Value, json};

/// Returns the page. Places are whole millimetres.
pub(crate) fn html(title: &str, figures: &[Figure], report: &Report) -> String {
    let heights = figures.iter().flat_map(|figure| &figure.positions).map(|place| place[1]);
    let (clip, soles) = (&figures[0].clip, &figures[0].soles);
    let digits = |stands: &[bool]| -> String {
        stands.iter().map(|&stands| if stands { '1' } else { '0' }).collect()
    };
    let text = report.to_string();
    let measures = text.lines().filter_map(|line| line.trim_start().split_once("  "));
    let motion = json!({
        "title": title,
        "step": clip.frame_time,
        "frames": soles[0].stands.len(),
        "height": millimetres(heights.fold(0.001, f64::max)),
        "stands": soles.each_ref().map(|sole| digits(&sole.stands)),
        "measures": measures.map(|(name, value)| [name, value.trim_start()]).collect::<Vec<_>>(),
        "figures": figures.iter().map(figure).collect::<Vec<_>>(),
    });
    // A name of a file cannot end the element that it stands in.
    let motion = motion.to_string().replace('<', "\\u003c");
    let page = include_str!("page.html").replacen("SCRIPT", include_str!("page.js"), 1);
    page.replacen("MOTION", &motion, 1)
}

/// Each way through all frames is written once: joints of several hinges are at the same place, and
/// soles of the person have joints as corners. Numbers are what a frame adds to the frame before
/// it, which is short.
fn figure(figure: &Figure) -> Value {
    let frames = figure.soles[0].stands.len();
    let mut ways: Vec<Vec<[i64; 3]>> = Vec::new();
    let mut point = |places: &[[f64; 3]], at: usize| {
        let places = places.iter().skip(at).step_by(places.len() / frames);
        let way: Vec<_> = places.map(|place| place.map(millimetres)).collect();
        ways.iter().position(|other| *other == way).unwrap_or_else(|| {
            ways.push(way);
            ways.len() - 1
        })
    };
    let joints = &figure.clip.joints;
    let points: Vec<_> = (0..joints.len()).map(|at| point(&figure.positions, at)).collect();
    let bones = joints.iter().zip(sides(&figure.clip)).zip(&points);
    let bones = bones.filter_map(|((joint, side), &to)| {
        let side = match side {
            Side::Left => "left",
            Side::Right => "right",
            Side::Middle => "middle",
        };
        let from = points[joint.parent?];
        (from != to).then(|| json!([from, to, side]))
    });
    let bones: Vec<_> = bones.collect();
    let soles = figure.soles.each_ref().map(|sole| {
        let corners = sole.corners.len() / frames;
        (0..corners).map(|at| point(&sole.corners, at)).collect::<Vec<_>>()
    });
    let row = |frame: usize| -> Vec<i64> {
        let before = |way: &[[i64; 3]]| if frame > 0 { way[frame - 1] } else { [0; 3] };
        let steps = ways.iter().flat_map(|way| {
            let (now, before) = (way[frame], before(way));
            [0, 1, 2].map(|axis| now[axis].saturating_sub(before[axis]))
        });
        steps.collect()
    };
    let rows: Vec<_> = (0..frames).map(row).collect();
    json!({ "caption": figure.caption, "bones": bones, "soles": soles, "rows": rows })
}

fn millimetres(metres: f64) -> i64 {
    (1e3 * metres).round() as i64
}

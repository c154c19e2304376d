//! The clip as a picture: the figure at several moments, a closer look at a second and a half in
//! the middle, and the path of the root from above. [`rows`] are of figures alone, of one or more
//! clips.

mod plan;
mod scene;
mod side;
mod strip;
mod view;

use std::fmt::{self, Write};
use std::ops::Range;

use crate::positions::size;
use dq8_bvh::Clip;
use plan::Plan;
use scene::Scene;
use strip::Strip;

pub use side::{Side, sides};

const WIDTH: f64 = 1400.0;
const MARGIN: f64 = 40.0;
const FIGURES: usize = 10;
/// So many letters of a title fit, whichever they are.
const LETTERS: usize = 42;

/// A rectangle of the picture, in pixels.
#[derive(Clone, Copy)]
struct Frame {
    left: f64,
    top: f64,
    width: f64,
    height: f64,
}

impl Frame {
    fn right(&self) -> f64 {
        self.left + self.width
    }

    fn bottom(&self) -> f64 {
        self.top + self.height
    }
}

const STYLE: &str = "\
text{font-family:sans-serif;font-size:20px;fill:#333}\
.title{font-size:26px;font-weight:bold}.caption{font-size:22px;font-weight:bold}\
.time{text-anchor:middle;font-size:18px;fill:#555}.note{font-size:18px;fill:#555}\
path{fill:none;stroke-linecap:round;stroke-linejoin:round}\
.bone{stroke-width:4.5}.track{stroke-width:1.5}\
.left{stroke:#0072b2}.right{stroke:#d55e00}.middle{stroke:#444}\
.left.track,.right.track{stroke-opacity:.45}\
.root.track{stroke:#009e73;stroke-width:2}circle.root{fill:#009e73}\
.head{fill:#fff;stroke:#444;stroke-width:3.5}\
.sole{stroke-width:2.5}.stands{stroke-width:8}.left.stands{fill:#0072b2}.right.stands{fill:#d55e00}\
.contact{stroke-width:6;stroke-linecap:butt}\
.ground{stroke:#999;stroke-width:2}.scale{stroke:#555;stroke-width:1.5;stroke-linecap:butt}";

/// `positions` are in the world, `[frame][joint]`; `size` is the skeleton's.
pub(crate) fn picture(
    clip: &Clip,
    positions: &[[f64; 3]],
    size: f64,
) -> Result<String, fmt::Error> {
    let scene = Scene::new(clip, positions, size);
    let mut body = String::new();
    draw_heading(&mut body, &scene)?;
    let all = 0..clip.frames();
    let whole = format!("The whole clip, {} s", short(clip.time(all.end)));
    let strip = Strip::new(&scene, all.clone(), below(180.0, 360.0));
    let mut top = row(&mut body, &strip, &whole)?;
    if let Some(part) = closer_look(clip) {
        let [from, to] = [part.start, part.end].map(|frame| short(clip.time(frame)));
        let part = Strip::new(&scene, part, below(top + 20.0, 360.0));
        top = row(&mut body, &part, &format!("A closer look, from {from} s to {to} s"))?;
    }

    caption(&mut body, top, "The path of the root, from above")?;
    let plan = Plan::new(&scene, all, below(top + 25.0, 200.0));
    plan.draw(&mut body, &strip.moments)?;
    Ok(page(plan.area.bottom() + 50.0, &body))
}

/// A figure that moves on the ground at height zero.
#[derive(Debug)]
pub struct Figure {
    pub caption: String,
    /// Names and parents of joints, and the time of a frame.
    pub clip: Clip,
    /// Positions in the world, `[frame][joint]`.
    pub positions: Vec<[f64; 3]>,
    /// The left and the right sole.
    pub soles: [Sole; 2],
}

/// A sole, and when it stands.
#[derive(Debug)]
pub struct Sole {
    /// Corners in the world, in order around the sole, `[frame][corner]`.
    pub corners: Vec<[f64; 3]>,
    /// `true` where the sole stands, for each frame.
    pub stands: Vec<bool>,
}

impl Sole {
    /// The corners in a frame.
    pub fn corners_in(&self, frame: usize) -> &[[f64; 3]] {
        let count = self.corners.len() / self.stands.len().max(1);
        &self.corners[frame * count..][..count]
    }

    /// The runs of frames in which the sole stands.
    pub fn runs(&self) -> impl Iterator<Item = Range<usize>> {
        let runs = self.stands.chunk_by(|a, b| a == b).scan(0, |start, run| {
            *start += run.len();
            Some((run[0], *start - run.len()..*start))
        });
        runs.filter_map(|(stands, run)| stands.then_some(run))
    }
}

/// The figures, a row below the other. Bars below the ground are where soles stand.
pub fn rows(figures: &[Figure]) -> Result<String, fmt::Error> {
    let (mut body, mut top) = (String::new(), 60.0);
    for Figure { caption, clip, positions, soles } in figures {
        let scene = Scene { ground: 0.0, ..Scene::new(clip, positions, size(clip, positions)) };
        let frames = 0..positions.len() / clip.joints.len();
        let strip = Strip::new(&scene, frames, below(top + 20.0, 360.0));
        top = row(&mut body, &strip, caption)? + 20.0;
        for (sole, class) in soles.iter().zip(["left", "right"]) {
            strip.draw_sole(&mut body, sole, class)?;
        }
    }
    let y = top - 5.0;
    writeln!(
        body,
        r#"<text class="note" x="{MARGIN}" y="{y}">Thick soles stand, and bars show when: the left one blue, the right one orange.</text>"#
    )?;
    Ok(page(top + 20.0, &body))
}

fn page(height: f64, body: &str) -> String {
    let view_box = format!("0 0 {WIDTH} {height:.0}");
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{view_box}\" \
         width=\"{WIDTH}\" height=\"{height:.0}\">\n<style>{STYLE}</style>\n\
         <rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n{body}</svg>\n"
    )
}

/// As wide as there is room.
fn below(top: f64, height: f64) -> Frame {
    Frame { left: MARGIN, top, width: WIDTH - 2.0 * MARGIN, height }
}

/// A row of figures below its caption; gives back where the next caption may stand.
fn row(out: &mut String, strip: &Strip<'_>, text: &str) -> Result<f64, fmt::Error> {
    caption(out, strip.area.top - 20.0, text)?;
    strip.draw(out)?;
    Ok(strip.area.bottom() + 70.0)
}

/// Title and legend.
fn draw_heading(out: &mut String, scene: &Scene<'_>) -> fmt::Result {
    let clip = scene.clip;
    writeln!(out, r#"<text class="title" x="{MARGIN}" y="50">{}</text>"#, title(&clip.title))?;
    let (joints, end_sites, frames) = (clip.joints.len(), clip.end_sites(), clip.frames());
    let time = short(clip.frame_time * 1e3);
    let numbers =
        format!("Joints: {joints}, of them {end_sites} end sites. Frames: {frames} of {time} ms.");
    writeln!(out, r#"<text x="{MARGIN}" y="86">{numbers}</text>"#)?;
    let lines =
        "Time runs to the right, figures stand at equal times. Thin lines trace root and feet.";
    writeln!(out, r#"<text x="{MARGIN}" y="114">{lines}</text>"#)?;
    let mut legend = vec![("root track", "root")];
    if scene.sides.contains(&Side::Left) || scene.sides.contains(&Side::Right) {
        legend.extend([("middle bone", "trunk"), ("right bone", "right"), ("left bone", "left")]);
    }
    for (index, (class, meaning)) in legend.iter().enumerate() {
        let x = WIDTH - MARGIN - 110.0 * (index + 1) as f64;
        writeln!(
            out,
            r#"<path class="{class}" d="M{x} 79h30"/><text x="{}" y="86">{meaning}</text>"#,
            x + 40.0
        )?;
    }
    Ok(())
}

fn caption(out: &mut String, top: f64, text: &str) -> fmt::Result {
    writeln!(out, r#"<text class="caption" x="{MARGIN}" y="{top}">{text}</text>"#)
}

/// The middle of a longer clip, short enough to see one pose become the next.
fn closer_look(clip: &Clip) -> Option<Range<usize>> {
    const SECONDS: f64 = 1.5;
    let frames = clip.frames();
    let part = (SECONDS / clip.frame_time).round();
    if part < FIGURES as f64 || part > 0.7 * frames as f64 {
        return None;
    }
    let part = part as usize;
    let start = (frames - part) / 2;
    Some(start..start + part)
}

/// Frames enough for a smooth line, whatever their number.
fn sparse(frames: &Range<usize>) -> impl Iterator<Item = usize> + use<> {
    const POINTS: usize = 1000;
    frames.clone().step_by(frames.len().div_ceil(POINTS).max(1))
}

/// With two decimals, of which a large number has none that matter.
fn short(number: f64) -> String {
    if number < 1e5 { format!("{number:.2}") } else { format!("{number:.1e}") }
}

/// As much of a title as there is room for.
fn title(text: &str) -> String {
    // Control characters have no place in XML, not even escaped.
    let text: String = text.chars().filter(|character| !character.is_control()).collect();
    let cut = text.chars().count() > LETTERS;
    let text = text.chars().take(if cut { LETTERS - 1 } else { LETTERS });
    let text: String = text.chain(cut.then_some('…')).collect();
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::picture;
    use crate::biped;
    use crate::positions::Positions;
    use dq8_bvh::{Axis, Channel, Clip, Joint};
    use dq8_fixtures::legible::illegible;

    /// Every number of the picture's shapes.
    fn coordinates(picture: &str) -> Vec<f64> {
        let shapes =
            picture.lines().filter(|line| line.starts_with("<path") || line.starts_with("<circle"));
        let words = shapes
            .flat_map(|line| line.split(|c: char| !(c.is_ascii_digit() || c == '.' || c == '-')));
        words.filter_map(|word| word.parse().ok()).collect()
    }

    #[test]
    fn the_biped_is_drawn_inside_the_picture() {
        let clip = biped::clip();
        let positions = Positions::of(&clip).unwrap();
        let picture = picture(&clip, &positions.world, positions.size).unwrap();
        assert!(picture.matches("left bone").count() == 21, "twenty figures and the legend");
        assert!(!picture.contains("NaN") && !picture.contains("inf"));
        assert_eq!(illegible(&picture), [""; 0]);
        let coordinates = coordinates(&picture);
        assert!(coordinates.iter().all(|x| (-10.0..=1400.0).contains(x)), "{coordinates:?}");
    }

    #[test]
    fn the_picture_in_the_documentation_is_legible() {
        assert_eq!(illegible(include_str!("../../docs/walk.svg")), [""; 0]);
    }

    #[test]
    fn texts_keep_to_their_places_whatever_a_clip_says() {
        for frame_time in [1e-9, 1.0 / 60.0, 40.0, 1e9] {
            for title in ["W".repeat(300), "<&>".repeat(20), String::new()] {
                let clip = Clip { title, frame_time, ..biped::clip() };
                let positions = Positions::of(&clip).unwrap();
                let picture = picture(&clip, &positions.world, positions.size).unwrap();
                assert_eq!(illegible(&picture), [""; 0], "{frame_time}");
            }
        }
    }

    #[test]
    fn clips_without_extent_are_drawn_too() {
        let along = vec![Channel::Position(Axis::X)];
        let joint = Joint::new("a < b & \"c\"", None, [0.0; 3], along);
        for frames in [1, 2, 3000] {
            for far in [0.0, 1e-30, 7.0, 1e30] {
                let values: Vec<f64> = (0..frames).map(|frame| far * f64::from(frame)).collect();
                let positions: Vec<_> = values.iter().map(|&x| [x, 0.0, 0.0]).collect();
                let (title, joints) = ("a < b & c".to_owned(), vec![joint.clone()]);
                let clip = Clip { title, joints, frame_time: 1e-3, values };
                let picture = picture(&clip, &positions, 0.0).unwrap();
                assert!(!picture.contains("NaN") && !picture.contains("inf"), "{picture}");
                assert!(picture.contains("a &lt; b &amp; c"));
                assert_eq!(illegible(&picture), [""; 0], "{frames} {far}");
                assert!(coordinates(&picture).iter().all(|x| x.abs() < 2000.0), "{picture}");
            }
        }
    }
}

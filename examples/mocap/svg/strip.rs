//! A row of figures, seen from the side. Time runs to the right and figures stand at equal times,
//! so that they never cover each other: each keeps its shape and height, only the way between them
//! is drawn longer or shorter than it was.

use std::fmt::{self, Write};
use std::ops::Range;

use super::scene::Scene;
use super::side::Side;
use super::view::View;
use super::{FIGURES, Frame, Sole};

pub(crate) struct Strip<'a> {
    scene: &'a Scene<'a>,
    frames: Range<usize>,
    view: View,
    /// The frames that get a figure.
    pub(crate) moments: Vec<usize>,
    pub(crate) area: Frame,
    /// Pixels for a unit of the clip.
    scale: f64,
    /// Units by which figures reach farther to the left than to the right of their roots.
    balance: f64,
}

impl<'a> Strip<'a> {
    /// Takes no more of the area's height than the figures need.
    pub(crate) fn new(scene: &'a Scene<'a>, frames: Range<usize>, area: Frame) -> Self {
        let view = View::of(scene, &frames);
        let figures = FIGURES.min(frames.len());
        // In the middle of equal parts: captures like to begin with a pose that is not part of the
        // motion.
        let moments: Vec<usize> = (0..figures)
            .map(|i| frames.start + (2 * i + 1) * frames.len() / (2 * figures))
            .collect();
        let (mut left, mut right, mut top) = (0.0_f64, 0.0_f64, scene.ground);
        for &moment in &moments {
            let root = view.right(scene.root(moment));
            for &position in scene.frame(moment) {
                let along = view.right(position) - root;
                (left, right, top) = (left.max(-along), right.max(along), top.max(position[1]));
            }
        }
        let wide = area.width / (figures as f64 * 1.12 * (left + right));
        let high = area.height / (top - scene.ground);
        // A skeleton without extent has no scale; any will do.
        let scale = if wide.min(high).is_finite() { wide.min(high) } else { 1.0 };
        let height = scale * (top - scene.ground);
        let (area, balance) = (Frame { height, ..area }, (left - right) / 2.0);
        Self { scene, frames, view, moments, area, scale, balance }
    }

    /// Where the root stands in the picture at this frame, from left to right.
    fn x(&self, frame: usize) -> f64 {
        let elapsed = (frame - self.frames.start) as f64 + 0.5;
        self.area.left + self.area.width * elapsed / self.frames.len() as f64
    }

    fn point(&self, frame: usize, joint: usize) -> [f64; 2] {
        self.place(frame, self.scene.frame(frame)[joint])
    }

    fn place(&self, frame: usize, position: [f64; 3]) -> [f64; 2] {
        let root = self.scene.root(frame);
        let along = self.view.right(position) - self.view.right(root) + self.balance;
        [self.x(frame) + self.scale * along, self.y(position[1])]
    }

    fn y(&self, height: f64) -> f64 {
        self.area.bottom() - self.scale * (height - self.scene.ground)
    }

    pub(crate) fn draw(&self, out: &mut String) -> fmt::Result {
        let (left, right, bottom) = (self.area.left, self.area.right(), self.area.bottom());
        writeln!(out, r#"<path class="ground" d="M{left:.1} {bottom:.1}H{right:.1}"/>"#)?;
        for (side, class) in [(Side::Left, "left track"), (Side::Right, "right track")] {
            if let Some(foot) = self.scene.foot(side) {
                self.draw_track(out, foot, class)?;
            }
        }
        for &moment in &self.moments {
            self.draw_figure(out, moment)?;
        }
        self.draw_track(out, 0, "root track")?;
        for &moment in &self.moments {
            let [x, y] = self.point(moment, 0);
            writeln!(out, r#"<circle class="root" cx="{x:.1}" cy="{y:.1}" r="4"/>"#)?;
            let (x, y) = (self.x(moment), bottom + 24.0);
            let time = super::short(self.scene.clip.time(moment));
            writeln!(out, r#"<text class="time" x="{x:.1}" y="{y:.1}">{time} s</text>"#)?;
        }
        Ok(())
    }

    /// The way of one joint through all frames, as far as it lies in the area.
    fn draw_track(&self, out: &mut String, joint: usize, class: &str) -> fmt::Result {
        write!(out, r#"<path class="{class}" d=""#)?;
        let mut pen_is_down = false;
        for frame in super::sparse(&self.frames) {
            let [x, y] = self.point(frame, joint);
            let inside = (self.area.left..=self.area.right()).contains(&x);
            if inside {
                write!(out, "{}{x:.1} {y:.1}", if pen_is_down { 'L' } else { 'M' })?;
            }
            pen_is_down = inside;
        }
        writeln!(out, r#""/>"#)
    }

    fn draw_figure(&self, out: &mut String, moment: usize) -> fmt::Result {
        for (side, class) in self.far_to_near(moment) {
            write!(out, r#"<path class="{class} bone" d=""#)?;
            for (joint, described) in self.scene.clip.joints.iter().enumerate() {
                let Some(parent) = described.parent.filter(|_| self.scene.sides[joint] == side)
                else {
                    continue;
                };
                let ([x0, y0], [x1, y1]) = (self.point(moment, parent), self.point(moment, joint));
                write!(out, "M{x0:.1} {y0:.1}L{x1:.1} {y1:.1}")?;
            }
            writeln!(out, r#""/>"#)?;
        }
        self.draw_heads(out, moment)
    }

    /// The sole at each moment, and below the times of the moments bars where it stands.
    pub(crate) fn draw_sole(&self, out: &mut String, sole: &Sole, class: &str) -> fmt::Result {
        for &moment in &self.moments {
            let stands = if sole.stands[moment] { " stands" } else { "" };
            write!(out, r#"<path class="{class} sole{stands}" d=""#)?;
            for (index, &corner) in sole.corners_in(moment).iter().enumerate() {
                let [x, y] = self.place(moment, corner);
                write!(out, "{}{x:.1} {y:.1}", if index == 0 { 'M' } else { 'L' })?;
            }
            writeln!(out, r#"Z"/>"#)?;
        }
        let y = self.area.bottom() + if class == "left" { 36.0 } else { 46.0 };
        write!(out, r#"<path class="{class} contact" d=""#)?;
        for run in sole.runs() {
            // Half a frame before the first to half a frame after the last.
            let half = self.area.width / (2.0 * self.frames.len() as f64);
            let (from, to) = (self.x(run.start) - half, self.x(run.end - 1) + half);
            write!(out, "M{from:.1} {y:.1}H{to:.1}")?;
        }
        writeln!(out, r#""/>"#)
    }

    /// The limbs that the spectator sees first cover the others.
    fn far_to_near(&self, moment: usize) -> [(Side, &'static str); 3] {
        let nearness = |side| {
            let of_side =
                self.scene.frame(moment).iter().zip(&self.scene.sides).filter(|(_, s)| **s == side);
            of_side.map(|(&position, _)| self.view.near(position)).fold(f64::NEG_INFINITY, f64::max)
        };
        let (left, right) = ((Side::Left, "left"), (Side::Right, "right"));
        let middle = (Side::Middle, "middle");
        if nearness(Side::Left) > nearness(Side::Right) {
            [right, middle, left]
        } else {
            [left, middle, right]
        }
    }

    /// A disc over the last bone of each head.
    fn draw_heads(&self, out: &mut String, moment: usize) -> fmt::Result {
        let joints = &self.scene.clip.joints;
        for (tip, described) in joints.iter().enumerate().filter(|(_, joint)| joint.end_site) {
            let Some(head) = described.parent else {
                continue;
            };
            if joints[head].name.to_lowercase().contains("head") {
                let ([x0, y0], [x1, y1]) = (self.point(moment, head), self.point(moment, tip));
                let (x, y) = ((x0 + x1) / 2.0, (y0 + y1) / 2.0);
                let radius = (x1 - x0).hypot(y1 - y0) / 2.0;
                writeln!(out, r#"<circle class="head" cx="{x:.1}" cy="{y:.1}" r="{radius:.1}"/>"#)?;
            }
        }
        Ok(())
    }
}

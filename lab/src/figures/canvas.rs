//! Line drawings as SVG: a picture of the plane, or of space seen along a diagonal.

use crate::report::escape;
use core::fmt::Write;

/// The colours of drawings, none like another, also for those who do not see red and green (Okabe,
/// Ito 2008).
pub mod colour {
    /// Lines that are only there to hold on to.
    pub const FRAME: &str = "#999999";
    /// Text and what stands still.
    pub const INK: &str = "#222222";
    /// The first of two.
    pub const BLUE: &str = "#0072b2";
    /// The second of two.
    pub const RED: &str = "#d55e00";
    /// A third.
    pub const GREEN: &str = "#009e73";
    /// A fourth.
    pub const PURPLE: &str = "#aa4499";
    /// A fifth.
    pub const OCHRE: &str = "#b8860b";
}

/// Which side of the point a text stands on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// It begins there.
    Right,
    /// It ends there.
    Left,
    /// It is centred there.
    Middle,
}

/// A picture of width × height pixels, y down.
#[derive(Clone, Debug)]
pub struct Canvas {
    size: [f64; 2],
    body: String,
}

impl Canvas {
    /// With a title above.
    pub fn new(size: [f64; 2], title: &str) -> Self {
        let mut canvas = Self { size, body: String::new() };
        canvas.text([size[0] / 2.0, 22.0], Side::Middle, 17.0, colour::INK, title);
        canvas
    }

    /// Straight lines through points.
    pub fn path(&mut self, points: impl IntoIterator<Item = [f64; 2]>, stroke: &str, width: f64) {
        let points = list(points);
        let _ = writeln!(
            self.body,
            "<polyline points=\"{points}\" fill=\"none\" stroke=\"{stroke}\" stroke-width=\"{width}\" \
             stroke-linejoin=\"round\" stroke-linecap=\"round\"/>"
        );
    }

    /// As [`path`](Self::path), in dashes.
    pub fn dashes(&mut self, points: impl IntoIterator<Item = [f64; 2]>, stroke: &str, width: f64) {
        let points = list(points);
        let _ = writeln!(
            self.body,
            "<polyline points=\"{points}\" fill=\"none\" stroke=\"{stroke}\" stroke-width=\"{width}\" \
             stroke-dasharray=\"5 4\"/>"
        );
    }

    /// An area within points, see-through.
    pub fn area(&mut self, points: impl IntoIterator<Item = [f64; 2]>, fill: &str, opacity: f64) {
        let points = list(points);
        let _ = writeln!(
            self.body,
            "<polygon points=\"{points}\" fill=\"{fill}\" fill-opacity=\"{opacity}\"/>"
        );
    }

    /// A line with a head at its end.
    pub fn arrow(&mut self, [from, to]: [[f64; 2]; 2], stroke: &str, width: f64) {
        let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
        let length = dx.hypot(dy).max(1e-9);
        let [ux, uy] = [dx / length, dy / length];
        let head = (4.0 + 2.5 * width).min(length);
        let base = [to[0] - head * ux, to[1] - head * uy];
        let side = 0.4 * head;
        self.path([from, base], stroke, width);
        self.area(
            [
                to,
                [base[0] - side * uy, base[1] + side * ux],
                [base[0] + side * uy, base[1] - side * ux],
            ],
            stroke,
            1.0,
        );
    }

    /// A filled circle.
    pub fn dot(&mut self, [x, y]: [f64; 2], radius: f64, fill: &str) {
        let _ = writeln!(
            self.body,
            "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius}\" fill=\"{fill}\"/>"
        );
    }

    /// Plain text, `size` pixels high, on a white ground where it crosses lines.
    pub fn text(&mut self, [x, y]: [f64; 2], side: Side, size: f64, fill: &str, text: &str) {
        let anchor = match side {
            Side::Right => "start",
            Side::Left => "end",
            Side::Middle => "middle",
        };
        let _ = writeln!(
            self.body,
            "<text x=\"{x:.1}\" y=\"{y:.1}\" font-family=\"sans-serif\" font-size=\"{size}\" fill=\"{fill}\" \
             text-anchor=\"{anchor}\" paint-order=\"stroke\" stroke=\"white\" stroke-width=\"3\">{}</text>",
            escape(text)
        );
    }

    /// A legend: a line of each colour and its name, from a corner down.
    pub fn legend(&mut self, [x, y]: [f64; 2], entries: &[(&str, &str)]) {
        for (row, (stroke, name)) in entries.iter().enumerate() {
            let y = y + 19.0 * row as f64;
            self.path([[x, y], [x + 22.0, y]], stroke, 3.0);
            self.text([x + 29.0, y + 4.5], Side::Right, 13.0, colour::INK, name);
        }
    }

    /// What moves: a line from a point that stands still to one of a path, once through it in so
    /// many seconds.
    pub fn swept(&mut self, from: [f64; 2], path: &[[f64; 2]], seconds: f64, stroke: &str) {
        let values = |i: usize| {
            let values: Vec<_> = path.iter().map(|point| format!("{:.1}", point[i])).collect();
            values.join(";")
        };
        let Some(first) = path.first() else { return };
        let _ = writeln!(
            self.body,
            "<line x1=\"{:.1}\" y1=\"{:.1}\" x2=\"{:.1}\" y2=\"{:.1}\" stroke=\"{stroke}\" stroke-width=\"3\">\
             <animate attributeName=\"x2\" dur=\"{seconds}s\" repeatCount=\"indefinite\" values=\"{}\"/>\
             <animate attributeName=\"y2\" dur=\"{seconds}s\" repeatCount=\"indefinite\" values=\"{}\"/></line>",
            from[0],
            from[1],
            first[0],
            first[1],
            values(0),
            values(1)
        );
    }

    /// The SVG element.
    pub fn to_svg(&self) -> String {
        let [width, height] = self.size;
        format!(
            "<svg width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" \
             xmlns=\"http://www.w3.org/2000/svg\">\n{}</svg>\n",
            self.body
        )
    }
}

fn list(points: impl IntoIterator<Item = [f64; 2]>) -> String {
    let points = points.into_iter().map(|[x, y]| format!("{x:.1},{y:.1}"));
    points.collect::<Vec<_>>().join(" ")
}

/// How space is seen: parallel rays, from a turn about the vertical and a height; z is up.
#[derive(Clone, Copy, Debug)]
pub struct View {
    /// Where the origin is on the canvas.
    pub origin: [f64; 2],
    /// Pixels for a unit of length.
    pub scale: f64,
    /// How far space is turned about the vertical, radians.
    pub turn: f64,
    /// How far the eye is above the horizontal, radians.
    pub height: f64,
}

impl View {
    /// Where a point is on the canvas.
    pub fn of(&self, [x, y, z]: [f64; 3]) -> [f64; 2] {
        let (sin, cos) = self.turn.sin_cos();
        let (across, deep) = (cos * x - sin * y, sin * x + cos * y);
        let up = z * self.height.cos() + deep * self.height.sin();
        [self.origin[0] + self.scale * across, self.origin[1] - self.scale * up]
    }

    /// The point at the height of the eye's own plane, y = 0 before the turn, that is seen there.
    pub fn back(&self, [x, y]: [f64; 2]) -> [f64; 3] {
        let across = (x - self.origin[0]) / self.scale;
        let up = (self.origin[1] - y) / self.scale;
        let (sin, cos) = self.turn.sin_cos();
        [cos * across, -sin * across, up / self.height.cos()]
    }

    /// The three axes, so long, with their names.
    pub fn axes(&self, canvas: &mut Canvas, at: [f64; 3], length: f64) {
        for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
            let mut tip = at;
            tip[axis] += length;
            let mut label = at;
            label[axis] += 1.18 * length;
            canvas.arrow([self.of(at), self.of(tip)], colour::FRAME, 1.2);
            let [x, y] = self.of(label);
            canvas.text([x, y + 4.0], Side::Middle, 12.0, colour::FRAME, name);
        }
    }
}

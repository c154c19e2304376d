//! The path of the root, seen from above.

use std::fmt::{self, Write};
use std::ops::Range;

use super::Frame;
use super::scene::Scene;
use super::view::View;

pub(crate) struct Plan<'a> {
    scene: &'a Scene<'a>,
    frames: Range<usize>,
    view: View,
    pub(crate) area: Frame,
    /// Pixels for a unit of the clip, the same in both directions.
    scale: f64,
    /// The middle of the path: to the right, and near to the spectator.
    middle: [f64; 2],
}

impl<'a> Plan<'a> {
    /// Takes no more of the area's height than the path needs.
    pub(crate) fn new(scene: &'a Scene<'a>, frames: Range<usize>, area: Frame) -> Self {
        let view = View::of(scene, &frames);
        let mut low = [f64::INFINITY; 2];
        let mut high = [f64::NEG_INFINITY; 2];
        for frame in frames.clone() {
            let place = place(view, scene.root(frame));
            for axis in 0..2 {
                low[axis] = low[axis].min(place[axis]);
                high[axis] = high[axis].max(place[axis]);
            }
        }
        // One who stays in place gets a dot, not a magnified tremor.
        let least = [4.0 * scene.size, 0.1 * scene.size];
        let extent = |axis: usize| (high[axis] - low[axis]).max(least[axis]);
        let scale = (area.width / extent(0)).min(area.height / extent(1));
        let scale = if scale.is_finite() { scale } else { 1.0 };
        let middle = [0, 1].map(|axis| (low[axis] + high[axis]) / 2.0);
        let area = Frame { height: scale * extent(1), ..area };
        Self { scene, frames, view, area, scale, middle }
    }

    fn point(&self, frame: usize) -> [f64; 2] {
        let [right, near] = place(self.view, self.scene.root(frame));
        let x = self.area.left + self.area.width / 2.0 + self.scale * (right - self.middle[0]);
        let y = self.area.top + self.area.height / 2.0 + self.scale * (near - self.middle[1]);
        [x, y]
    }

    /// With a dot at each moment.
    pub(crate) fn draw(&self, out: &mut String, moments: &[usize]) -> fmt::Result {
        write!(out, r#"<path class="root track" d=""#)?;
        for (index, frame) in super::sparse(&self.frames).enumerate() {
            let [x, y] = self.point(frame);
            write!(out, "{}{x:.1} {y:.1}", if index == 0 { 'M' } else { 'L' })?;
        }
        writeln!(out, r#""/>"#)?;
        for &moment in moments {
            let [x, y] = self.point(moment);
            writeln!(out, r#"<circle class="root" cx="{x:.1}" cy="{y:.1}" r="4"/>"#)?;
        }
        self.draw_scale(out)
    }

    /// A bar of a round length.
    fn draw_scale(&self, out: &mut String) -> fmt::Result {
        let longest = 160.0 / self.scale;
        let power = 10.0_f64.powf(longest.log10().floor());
        let rounds = [5.0, 2.0, 1.0].map(|factor| factor * power);
        let length = rounds.into_iter().find(|length| *length <= longest).unwrap_or(power);
        let (x, y, width) = (self.area.left, self.area.bottom() + 30.0, self.scale * length);
        writeln!(out, r#"<path class="scale" d="M{x:.1} {:.1}v8h{width:.1}v-8"/>"#, y - 8.0)?;
        let length = if (1e-3..1e6).contains(&length) {
            length.to_string()
        } else {
            format!("{length:.0e}")
        };
        let x = x + width + 10.0;
        writeln!(
            out,
            r#"<text class="note" x="{x:.1}" y="{y:.1}">{length} in the clip's unit</text>"#
        )
    }
}

/// To the right in the picture, and near to the spectator.
fn place(view: View, root: [f64; 3]) -> [f64; 2] {
    [view.right(root), view.near(root)]
}
